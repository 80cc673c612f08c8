/* face_pieces.c - cuts a face of any shape into convex pieces. See face_pieces.h. */
#include "model/face_pieces.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/dd.h"
#include "base/orient.h"
#include "base/sort.h"

/* If the signed areas of a border cancel to less than this fraction of its size squared, its Newell normal is
 * meaningless. */
#define CANCELLED 1e-6

/* Fraction: lengths that differ by less are equal, so that rounding, and with it the corner with which a face begins,
 * decides nothing. */
#define ALIKE 1e-9

bool face_pieces_add_side(face_pieces *f, piece_side side)
{
    if (!array_reserve(&f->side, &f->side_room, f->side_count + 1, sizeof *f->side))
        return false;
    f->side[f->side_count++] = side;
    return true;
}

/* Up to this many corners are compared in pairs. */
enum { FEW_CORNERS = 32 };

/* Gives repeated corners the same node, by sorting. False: no memory. */
static bool join_corners(face_pieces *f)
{
    uint64_t *key = alloc_array(f->node_count, sizeof *key);
    if (!key)
        return false;
    for (size_t i = 0; i < f->node_count; i++)
        key[i] = (uint64_t)f->node[i].vertex << 32 | i;
    qsort(key, f->node_count, sizeof *key, compare_u64);
    uint32_t first = 0;
    for (size_t i = 0; i < f->node_count; i++) {
        first = i > 0 && key[i] >> 32 == key[i - 1] >> 32 ? first : (uint32_t)key[i];
        f->ring[(uint32_t)key[i]] = first;
    }
    free(key);
    return true;
}

/* Lists the corners in order, without those that repeat the one before. A corner that is repeated elsewhere gets the
 * same node. False: no memory. */
static bool take_ring(face_pieces *f, const roberts_vec3 *point, const uint32_t *corner, uint32_t count)
{
    f->ring_count = f->node_count = f->piece_count = f->side_count = 0;
    f->whole_sides = f->bent = f->uncut = false;
    if (!array_reserve(&f->ring, &f->ring_room, count, sizeof *f->ring) ||
        !array_reserve(&f->side_of, &f->side_of_room, count, sizeof *f->side_of) ||
        !array_reserve(&f->node, &f->node_room, count, sizeof *f->node) ||
        !array_reserve(&f->relative, &f->relative_room, count, sizeof *f->relative))
        return false;
    for (uint32_t i = 0; i < count; i++) {
        if (corner[i] == corner[i + 1 < count ? i + 1 : 0])
            continue;
        uint32_t n = 0;
        while (n < f->node_count && count <= FEW_CORNERS && f->node[n].vertex != corner[i])
            n++;
        if (count > FEW_CORNERS)
            n = (uint32_t)f->node_count;
        if (n == f->node_count)
            f->node[f->node_count++] = (piece_node){.vertex = corner[i], .point = point[corner[i]]};
        f->side_of[f->ring_count] = i;
        f->ring[f->ring_count++] = n;
    }
    return count <= FEW_CORNERS || join_corners(f);
}

/* Returns the normal of the largest triangle at the first corner; zero if all corners are collinear. */
static roberts_vec3 largest_normal(const roberts_vec3 *relative, size_t count)
{
    roberts_vec3 far = {0, 0, 0}, best = {0, 0, 0};
    for (size_t i = 1; i < count; i++)
        if (vec3_dot(relative[i], relative[i]) > vec3_dot(far, far))
            far = relative[i];
    for (size_t i = 1; i < count; i++) {
        roberts_vec3 n = vec3_cross(far, relative[i]);
        if (vec3_dot(n, n) > vec3_dot(best, best))
            best = n;
    }
    return best;
}

/* Fits the plane of a border whose areas cancel, completely or so far that the corners' distances from the plane
 * dominate their sum. */
static fitted_plane fit_crossed(const roberts_vec3 *relative, size_t count)
{
    roberts_vec3 n = largest_normal(relative, count);
    double length = vec3_length(n), sum = 0.0, least = 0.0, most = 0.0, far = 0.0;
    if (!(length > 0.0))
        return (fitted_plane){0};
    n = (roberts_vec3){n.x / length, n.y / length, n.z / length};
    for (size_t i = 0; i < count; i++) {
        double height = vec3_dot(n, relative[i]);
        sum += height;
        least = lesser(least, height);
        most = greater(most, height);
        far = greater(far, vec3_length(relative[i]));
    }
    sum /= (double)count;
    return (fitted_plane){.n = n,
                          .mean = sum,
                          .deviation = greater(most - sum, sum - least),
                          .area = 0.5 * length,
                          .width = 0.5 * length / (2.0 * far)};
}

/* Smaller coordinates are set to 0, in units of the scene. Then no product of differences underflows. */
#define LEAST_COORDINATE 0x1p-200

static double whole_part(double x)
{
    return fabs(x) < LEAST_COORDINATE ? 0.0 : x;
}

/* Returns the position of a point in the coordinate plane. */
static roberts_vec2 frame_place(const face_pieces *f, roberts_vec3 point)
{
    double x = whole_part(point.x / f->unit), y = whole_part(point.y / f->unit), z = whole_part(point.z / f->unit);
    return f->axis == 0   ? (roberts_vec2){f->turned * y, z}
           : f->axis == 1 ? (roberts_vec2){f->turned * z, x}
                          : (roberts_vec2){f->turned * x, y};
}

static double interpolate(dd a, dd b, double t, double *low)
{
    dd p = dd_add(a, dd_mul((dd){t, 0.0}, dd_sub(b, a)));
    *low = p.lo;
    return p.hi;
}

uint32_t face_pieces_add_crossing(face_pieces *f, uint32_t a, uint32_t b, double t)
{
    const piece_node A = f->node[a], B = f->node[b];
    piece_node X = {.vertex = ROBERTS_NONE};
    X.point.x = interpolate((dd){A.point.x, A.low.x}, (dd){B.point.x, B.low.x}, t, &X.low.x);
    X.point.y = interpolate((dd){A.point.y, A.low.y}, (dd){B.point.y, B.low.y}, t, &X.low.y);
    X.point.z = interpolate((dd){A.point.z, A.low.z}, (dd){B.point.z, B.low.z}, t, &X.low.z);
    X.at = frame_place(f, X.point);
    if (f->node_count >= ROBERTS_NONE - 1 ||
        !array_reserve(&f->node, &f->node_room, f->node_count + 1, sizeof *f->node))
        return ROBERTS_NONE;
    f->node[f->node_count] = X;
    return (uint32_t)f->node_count++;
}

/* Fits the plane, and projects the nodes to the coordinate plane nearest to it. */
static void fit(face_pieces *f, const face_rules *rules)
{
    roberts_vec3 origin = f->node[f->ring[0]].point, low = {0, 0, 0}, high = {0, 0, 0};
    for (size_t i = 0; i < f->ring_count; i++) {
        roberts_vec3 p = vec3_scale(1.0 / rules->unit, vec3_sub(f->node[f->ring[i]].point, origin));
        f->relative[i] = p;
        low = (roberts_vec3){lesser(low.x, p.x), lesser(low.y, p.y), lesser(low.z, p.z)};
        high = (roberts_vec3){greater(high.x, p.x), greater(high.y, p.y), greater(high.z, p.z)};
    }
    f->chord = greater(high.x - low.x, greater(high.y - low.y, high.z - low.z));
    f->fit = f->chord > 0.0 ? face_plane_fit(f->relative, (uint32_t)f->ring_count) : (fitted_plane){0};
    double planar = greater(rules->tolerance * f->chord, rules->touching / rules->unit);
    if (f->ring_count > 3 && (f->fit.deviation > planar || f->fit.area < CANCELLED * f->chord * f->chord)) {
        fitted_plane crossed = fit_crossed(f->relative, f->ring_count);
        if (crossed.deviation <= planar || f->fit.area < CANCELLED * f->chord * f->chord)
            f->fit = crossed;
    }
    f->fit.mean *= rules->unit;
    f->fit.deviation *= rules->unit;
    f->fit.width *= rules->unit;
    f->chord *= rules->unit;
    roberts_vec3 n = f->fit.n;
    double x = fabs(n.x), y = fabs(n.y), z = fabs(n.z), most = (1.0 - ALIKE) * greater(x, greater(y, z));
    f->axis = z >= most ? 2 : y >= most ? 1 : 0;
    f->turned = (f->axis == 0 ? n.x : f->axis == 1 ? n.y : n.z) < 0.0 ? -1.0 : 1.0;
    f->unit = rules->unit;
    for (size_t i = 0; i < f->node_count; i++)
        f->node[i].at = frame_place(f, f->node[i].point);
}

/* Does the ring turn left or go straight at every corner, and go round once? */
static bool is_convex(const face_pieces *f)
{
    size_t n = f->ring_count;
    unsigned starts = 0;
    roberts_vec2 a = f->node[f->ring[n - 2]].at, b = f->node[f->ring[n - 1]].at;
    bool rising = b.y > a.y || (b.y == a.y && b.x > a.x);
    for (size_t i = 0; i < n; i++) {
        roberts_vec2 c = f->node[f->ring[i]].at;
        bool up = c.y > b.y || (c.y == b.y && c.x > b.x);
        double turn = orient2d(a, b, c);
        if (turn < 0.0 || (turn == 0.0 && (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) <= 0.0))
            return false;
        starts += up && !rising;
        rising = up;
        a = b;
        b = c;
    }
    return starts == 1;
}

/* Makes the whole face one piece. */
static bool take_whole(face_pieces *f)
{
    if (!array_reserve(&f->piece, &f->piece_room, 1, sizeof *f->piece))
        return false;
    face_piece *only = &f->piece[f->piece_count++];
    only->count = (uint32_t)f->ring_count;
    only->winding = 1;
    for (uint32_t i = 0; i < only->count; i++) {
        only->node[i] = f->ring[i];
        only->label[i] = i;
        if (!face_pieces_add_side(f,
                                  (piece_side){f->ring[i], f->ring[i + 1 < only->count ? i + 1 : 0], 0, f->side_of[i]}))
            return false;
    }
    return true;
}

/* Cuts a convex face with very many corners into a fan of pieces. */
static bool take_fan(face_pieces *f)
{
    uint32_t count = (uint32_t)f->ring_count, cut = count;
    for (uint32_t k = 1; k + 1 < count;) {
        uint32_t last = k + PIECE_CORNERS - 2 < count - 1 ? k + PIECE_CORNERS - 2 : count - 1, n = 0;
        if (!array_reserve(&f->piece, &f->piece_room, f->piece_count + 1, sizeof *f->piece))
            return false;
        face_piece *p = &f->piece[f->piece_count++];
        p->node[n] = f->ring[0];
        p->label[n++] = k == 1 ? 0 : cut++;
        for (uint32_t i = k; i <= last; i++) {
            p->node[n] = f->ring[i];
            p->label[n++] = i < last ? i : last == count - 1 ? last : cut;
        }
        p->count = n;
        p->winding = 1;
        k = last;
    }
    return true;
}

/* Lists each side of the ring with its piece, and both sides of each cut if cuts matter. False: no memory. */
static bool add_sides(face_pieces *f)
{
    uint32_t count = (uint32_t)f->ring_count;
    for (uint32_t p = 0; p < f->piece_count; p++)
        for (uint32_t i = 0; i < f->piece[p].count; i++) {
            const face_piece *piece = &f->piece[p];
            uint32_t to = piece->node[i + 1 < piece->count ? i + 1 : 0], label = piece->label[i];
            if (label >= count && f->planar)
                continue;
            if (!face_pieces_add_side(
                    f, (piece_side){piece->node[i], to, p, label < count ? f->side_of[label] : ROBERTS_NONE}))
                return false;
        }
    return true;
}

/* Is the ring a quadrilateral that turns left at every corner, as seen along the normal of its plane? */
static bool is_quadrilateral(const face_pieces *f)
{
    const roberts_vec3 *P = f->relative;
    bool left = f->ring_count == 4;
    for (uint32_t i = 0; left && i < 4; i++) {
        const roberts_vec3 a = vec3_sub(P[(i + 1) % 4], P[i]), b = vec3_sub(P[(i + 2) % 4], P[(i + 1) % 4]);
        left = vec3_dot(vec3_cross(a, b), f->fit.n) > 0.0;
    }
    return left;
}

static bool is_before(roberts_vec3 p, roberts_vec3 q)
{
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
}

/* Cuts a quadrilateral that is not planar along its shorter diagonal; if they are equally long, along that of the
 * corner with the least x (then y, then z). */
static bool take_quadrilateral(face_pieces *f)
{
    const roberts_vec3 *P = f->relative;
    uint32_t least = 0;
    if (!array_reserve(&f->piece, &f->piece_room, 2, sizeof *f->piece))
        return false;
    for (uint32_t i = 1; i < 4; i++)
        least = is_before(f->node[f->ring[i]].point, f->node[f->ring[least]].point) ? i : least;
    const double a = vec3_length(vec3_sub(P[2], P[0])), b = vec3_length(vec3_sub(P[3], P[1]));
    const bool alike = fabs(a - b) <= ALIKE * greater(a, b);
    const uint32_t first = alike ? least % 2 : b < a;
    for (uint32_t p = 0; p < 2; p++) {
        uint32_t at[3] = {first + 2 * p, (first + 2 * p + 1) % 4, (first + 2 * p + 2) % 4};
        f->piece[p] = (face_piece){3, 1, {f->ring[at[0]], f->ring[at[1]], f->ring[at[2]]}, {at[0], at[1], 4}};
    }
    f->piece_count = 2;
    return true;
}

bool face_pieces_cut(face_pieces *f, const face_rules *rules, const uint32_t *corner, uint32_t count)
{
    if (!take_ring(f, rules->point, corner, count))
        return false;
    if (f->ring_count < 3)
        return true;
    fit(f, rules);
    f->planar = f->ring_count == 3 || f->fit.deviation <= greater(rules->tolerance * f->chord, rules->touching);
    /* The least height of a triangle is twice its width. */
    if (!(f->fit.width > (f->ring_count == 3 ? 0.5 * rules->narrow : rules->touching)))
        return true;
    if (!f->planar && is_quadrilateral(f))
        return take_quadrilateral(f) && add_sides(f);
    if (f->ring_count > 3 && !(f->planar && is_convex(f)))
        return face_pieces_arrange(f, rules);
    return f->ring_count <= PIECE_CORNERS ? take_whole(f) : take_fan(f) && add_sides(f);
}

void face_pieces_free(face_pieces *f)
{
    free(f->ring);
    free(f->side_of);
    free(f->node);
    free(f->piece);
    free(f->side);
    free(f->relative);
    *f = (face_pieces){0};
}
