/* solid.c - one solid: its frame, the planes of its faces, its winding and its edges. */
#include "model/solid.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/bits.h"
#include "base/box.h"
#include "base/error.h"
#include "base/sort.h"
#include "base/vec.h"
#include "model/convex.h"
#include "model/face_plane.h"
#include "model/scene.h"
#include "read/mesh.h"

/* ---- edges, and the two faces of each ---------------------------------------------------------------------------- */

/* Every side of a face is a half-edge. For a small solid, a table gives the face that passes from one vertex to
 * another, and the edges are read from it in order. All other half-edges, and those of small solids that are open or
 * inconsistently wound, are sorted: first into buckets by their smaller vertex, then by the larger one. For solids with
 * up to a dozen edges, the table takes a third of the instructions. */

/* Fills the table; bit b of row[a] tells whether a face passes from a to b. False if two do. */
static bool fill_table(const roberts_scene *scene, uint32_t s, uint32_t passing[][EDGES_SMALL], uint32_t *row)
{
    const uint32_t *start = scene->face_start + scene->solid[s].face, base = scene->solid[s].vertex;
    const uint32_t count = scene->solid[s + 1].face - scene->solid[s].face;
    for (uint32_t f = 0; f < count; f++) {
        const uint32_t *corner = scene->corner + start[f], *last = scene->corner + start[f + 1] - 1;
        for (uint32_t from = *last - base, to; corner <= last; corner++, from = to) {
            to = *corner - base;
            if (row[from] >> to & 1)
                return false;
            row[from] |= (uint32_t)1 << to;
            passing[from][to] = f;
        }
    }
    return true;
}

/* Pairs the half-edges of a small solid. False if they are not all pairs of opposite ones. */
static bool pair_by_table(const roberts_scene *scene, uint32_t s, edge_scratch *scratch)
{
    uint32_t row[EDGES_SMALL], count = scene->solid[s + 1].vertex - scene->solid[s].vertex;
    uint32_t(*passing)[EDGES_SMALL] = scratch->passing;
    scene_edge *edge = scratch->edge, *end = edge + scene_corners(scene, s) / 2;
    for (uint32_t v = 0; v < count; v++)
        row[v] = 0;
    if (!fill_table(scene, s, passing, row))
        return false;
    for (uint32_t v = 0; v < count; v++) {
        uint32_t w = v + 1;
        for (uint32_t up = row[v] >> v >> 1; up; up >>= 1, w++) {
            if (!(up & 1))
                continue;
            if (edge == end || !(row[w] >> v & 1))
                return false;
            edge->v[0] = v;
            edge->v[1] = w;
            edge->f[0] = passing[v][w];
            edge->f[1] = passing[w][v];
            edge++;
        }
    }
    return edge == end; /* half of the half-edges go upward, each with its opposite: none is left over */
}

/* Counts the half-edges of each smaller vertex, and sets end[v] to the start of v's bucket. */
static void count_half_edges(const roberts_scene *scene, uint32_t s, uint32_t *end)
{
    const scene_solid *first = scene->solid + s;
    uint32_t count = first[1].vertex - first->vertex;
    memset(end, 0, count * sizeof *end);
    for (uint32_t f = first->face; f < first[1].face; f++) {
        const uint32_t *corner = scene->corner + scene->face_start[f];
        uint32_t n = scene->face_start[f + 1] - scene->face_start[f], from = corner[n - 1];
        for (uint32_t i = 0; i < n; from = corner[i++])
            end[(from < corner[i] ? from : corner[i]) - first->vertex]++;
    }
    sort_starts(end, count);
}

bool edges_sort(const roberts_scene *scene, uint32_t s, edge_scratch *scratch)
{
    const scene_solid *first = scene->solid + s;
    uint32_t vertices = first[1].vertex - first->vertex, corners = scene_corners(scene, s), start = 0;
    uint32_t base = scene->face_start[first->face];
    if (!array_reserve(&scratch->end, &scratch->end_room, vertices, sizeof *scratch->end) ||
        !array_reserve(&scratch->half, &scratch->half_room, corners, sizeof *scratch->half) ||
        !array_reserve(&scratch->face_of, &scratch->face_of_room, corners, sizeof *scratch->face_of))
        return false;
    count_half_edges(scene, s, scratch->end);
    for (uint32_t f = first->face; f < first[1].face; f++) {
        uint32_t begin = scene->face_start[f], n = scene->face_start[f + 1] - begin;
        for (uint32_t i = 0; i < n; i++) {
            uint32_t a = scene->corner[begin + i] - first->vertex;
            uint32_t b = scene->corner[begin + (i + 1 == n ? 0 : i + 1)] - first->vertex;
            scratch->half[scratch->end[a < b ? a : b]++] = (uint64_t)(a < b ? b : a) << 32 | (begin + i - base);
            scratch->face_of[begin + i - base] = f - first->face;
        }
    }
    for (uint32_t v = 0; v < vertices; start = scratch->end[v++])
        sort_short_list(scratch->half + start, scratch->end[v] - start);
    return true;
}

/* Some edge does not have two faces: does each have an even number of them? */
static edge_pairing count_sorted(const edge_scratch *scratch, uint32_t vertices)
{
    for (uint32_t v = 0, i = 0; v < vertices; v++)
        for (uint32_t first = i; i < scratch->end[v]; first = i) {
            while (i < scratch->end[v] && scratch->half[i] >> 32 == scratch->half[first] >> 32)
                i++;
            if ((i - first) % 2)
                return EDGES_OPEN;
        }
    return EDGES_EVEN;
}

/* Makes edges from the sorted half-edges: each must have exactly one partner. */
static edge_pairing edges_from_sorted(const roberts_scene *scene, uint32_t s, edge_scratch *scratch)
{
    const scene_solid *first = scene->solid + s;
    uint32_t vertices = first[1].vertex - first->vertex, start = 0, base = scene->face_start[first->face], made = 0;
    scene_edge *edge = scratch->edge;
    bool mixed = false;
    for (uint32_t v = 0; v < vertices; start = scratch->end[v++])
        for (uint32_t i = start; i < scratch->end[v]; i += 2) {
            uint64_t a = scratch->half[i], b = i + 1 < scratch->end[v] ? scratch->half[i + 1] : 0;
            if (a >> 32 != b >> 32 || (i + 2 < scratch->end[v] && scratch->half[i + 2] >> 32 == a >> 32))
                return count_sorted(scratch, vertices);
            bool up_a = scene->corner[base + (uint32_t)a] - first->vertex == v;
            bool up_b = scene->corner[base + (uint32_t)b] - first->vertex == v;
            uint32_t fa = scratch->face_of[(uint32_t)a], fb = scratch->face_of[(uint32_t)b];
            edge[made] = (scene_edge){{v, (uint32_t)(a >> 32)}, {up_a ? fa : fb, up_a ? fb : fa}};
            scratch->alike[made++] = up_a == up_b;
            mixed |= up_a == up_b;
        }
    return mixed ? EDGES_MIXED : EDGES_PAIRED;
}

edge_pairing edges_pair(const roberts_scene *scene, uint32_t s, edge_scratch *scratch)
{
    uint32_t vertices = scene->solid[s + 1].vertex - scene->solid[s].vertex, corners = scene_corners(scene, s);
    if (corners % 2)
        return EDGES_OPEN;
    if (!array_reserve(&scratch->edge, &scratch->edge_room, corners / 2, sizeof *scratch->edge))
        return EDGES_NO_MEMORY;
    if (vertices <= EDGES_SMALL && pair_by_table(scene, s, scratch))
        return EDGES_PAIRED;
    if (!edges_sort(scene, s, scratch) ||
        !array_reserve(&scratch->alike, &scratch->alike_room, corners / 2, sizeof *scratch->alike))
        return EDGES_NO_MEMORY;
    return edges_from_sorted(scene, s, scratch);
}

void edge_scratch_free(edge_scratch *scratch)
{
    free(scratch->edge);
    free(scratch->end);
    free(scratch->half);
    free(scratch->face_of);
    free(scratch->alike);
    *scratch = (edge_scratch){0};
}

/* ---- a frame of its own ---------------------------------------------------------------------------------------- */

/* Differences from a vertex of the solid are exact or nearly so, wherever the solid is. Scaling by a power of two
 * changes no digit, so a solid times 2^k gets the same planes. */

/* Solids outside these sizes are scaled. Then fourth powers of their lengths (squared areas), and of lengths 1e-9 times
 * as large, stay well within the range of doubles. */
static const double LARGE = 0x1p200, SMALL = 0x1p-200;

/* Fraction of the size: a thinner solid is flat. This is far more than rounding leaves of a plate without thickness
 * (about 1e-16), and far less than any plate that somebody would draw. */
static const double FLAT_PART = 1e-9;

static bool make_frame_room(solid_frame *frame)
{
    return array_reserve(&frame->point, &frame->point_room, frame->vertex_count, sizeof *frame->point) &&
           array_reserve(&frame->face, &frame->face_room, frame->face_count, sizeof *frame->face) &&
           array_reserve(&frame->ring, &frame->ring_room, frame->vertex_count, sizeof *frame->ring);
}

/* Returns the power of two that scales a size outside the limits to about 1; otherwise 1. */
static double scale_for(double size)
{
    int exponent;
    if ((size <= LARGE && size >= SMALL) || size == 0.0)
        return 1.0;
    frexp(size, &exponent);
    return ldexp(1.0, exponent < -1000 ? 1000 : -exponent); /* for denormal sizes, 2^1074 would overflow */
}

/* Moves `count` points so that the first is at the origin, and scales them; returns their sum. */
static roberts_vec3 move_points(roberts_vec3 *to, const roberts_vec3 *point, uint32_t count, double scale)
{
    two origin = two_of(point[0].x, point[0].y), by = two_all(scale), sum = two_all(0.0);
    double origin_z = point[0].z;
    roberts_vec3 all = {0, 0, 0};
    for (uint32_t v = 0; v < count; v++) {
        two xy = two_mul(by, two_sub(two_of(point[v].x, point[v].y), origin));
        double z = scale * (point[v].z - origin_z);
        two_part(&to[v].x, &to[v].y, xy);
        to[v].z = z;
        sum = two_add(sum, xy);
        all.z += z;
    }
    two_part(&all.x, &all.y, sum);
    return all;
}

static void name_parts(solid_frame *frame, const roberts_scene *scene, uint32_t s)
{
    const scene_solid *first = scene->solid + s;
    frame->solid = s;
    frame->vertex_first = first->vertex;
    frame->vertex_count = first[1].vertex - first->vertex;
    frame->face_first = first->face;
    frame->face_count = first[1].face - first->face;
    frame->edge_count = scene_corners(scene, s) / 2;
}

roberts_status frame_enter(solid_frame *frame, const roberts_scene *scene, uint32_t s, double tolerance)
{
    const roberts_vec3 *point = scene->point + scene->solid[s].vertex;
    roberts_vec3 lo = point[0], hi = point[0], sum, diagonal;
    double largest, scale;
    name_parts(frame, scene, s);
    const uint32_t count = frame->vertex_count;
    if (!make_frame_room(frame))
        return ROBERTS_NO_MEMORY;
    box_add_all(&lo, &hi, point + 1, count - 1);
    diagonal = vec3_sub(hi, lo);
    scale = scale_for(diagonal.x > diagonal.y ? (diagonal.x > diagonal.z ? diagonal.x : diagonal.z)
                                              : (diagonal.y > diagonal.z ? diagonal.y : diagonal.z));
    sum = move_points(frame->point, point, count, scale);
    largest = -lo.x;
    largest = hi.x > largest ? hi.x : largest;
    largest = -lo.y > largest ? -lo.y : largest;
    largest = hi.y > largest ? hi.y : largest;
    largest = -lo.z > largest ? -lo.z : largest;
    largest = hi.z > largest ? hi.z : largest;
    frame->barycentre = vec3_scale(1.0 / frame->vertex_count, sum);
    frame->unit = 1.0 / scale;
    frame->scene_units = frame->unit / scene->unit;
    frame->size = vec3_length(vec3_scale(scale, diagonal));
    frame->allowed = tolerance * frame->size;
    frame->loose = frame_loose(tolerance, largest * scale, frame->size);
    frame->loose32 = frame->allowed + lesser((double)FLT_EPSILON * largest * scale, FRAME_FAR * frame->allowed);
    frame->flat = FLAT_PART * frame->size;
    /* if any number is not finite, neither is the sum */
    return largest <= MESH_COORDINATE_MAX && isfinite(sum.x + sum.y + sum.z) ? ROBERTS_OK : ROBERTS_BAD_NUMBER;
}

/* Of the sixth digit: a coordinate nearer than this to a number of six digits was given to six. */
static const double SIX_DIGITS = 1e-8;

/* Does a number have six digits at most? */
static bool has_six_digits(double x)
{
    const double six = x == 0.0 ? 0.0 : fabs(x) * pow(10.0, 5.0 - floor(log10(fabs(x))));
    return fabs(six - rint(six)) <= SIX_DIGITS;
}

static bool is_float32(double x)
{
    return fabs(x) <= (double)FLT_MAX && (double)(float)x == x;
}

bool frame_loosen(solid_frame *frame, const roberts_scene *scene)
{
    bool six = true, float32 = true;
    if (!(frame->loose > frame->allowed)) /* its coordinates are not larger than the solid */
        return false;
    for (uint32_t v = frame->vertex_first; v < frame->vertex_first + frame->vertex_count && (six || float32); v++) {
        const roberts_vec3 P = scene->point[v];
        six = six && has_six_digits(P.x) && has_six_digits(P.y) && has_six_digits(P.z);
        float32 = float32 && is_float32(P.x) && is_float32(P.y) && is_float32(P.z);
    }
    frame->allowed = six ? frame->loose : float32 ? frame->loose32 : frame->allowed;
    return six || float32;
}

uint32_t frame_ring(const solid_frame *frame, const roberts_scene *scene, uint32_t f)
{
    const uint32_t *start = scene->face_start + frame->face_first + f, base = frame->vertex_first;
    const uint32_t *corner = scene->corner + start[0];
    const roberts_vec3 *point = frame->point, origin = point[corner[0] - base];
    uint32_t n = start[1] - start[0];
    roberts_vec3 *ring = frame->ring;
    for (uint32_t i = 0; i < n; i++)
        ring[i] = vec3_sub(point[corner[i] - base], origin);
    return n;
}

/* Writes face f's plane, deviation and width to the scene, in model units and relative to the scene's centre; `mean`:
 * the plane is n.(P - first corner) = mean. */
static void frame_store(const solid_frame *frame, roberts_scene *scene, uint32_t f, double mean)
{
    const local_face *face = &frame->face[f];
    uint32_t to = frame->face_first + f;
    double unit = frame->unit;
    plane F = face->F, *G = &scene->face_plane[to];
    roberts_vec3 p = vec3_sub(scene->point[scene->corner[scene->face_start[to]]], scene->centre);
    G->a = F.a;
    G->b = F.b;
    G->c = F.c;
    G->d = -(F.a * p.x + F.b * p.y + F.c * p.z) - mean * unit;
    scene_set_bounds(scene, to, face->deviation * unit, face->width * unit);
}

void frame_free(solid_frame *frame)
{
    free(frame->point);
    free(frame->face);
    free(frame->ring);
    *frame = (solid_frame){0};
}

/* ---- planes of faces ------------------------------------------------------------------------------------------- */

/* The planes of a solid's faces, and the direction of their corners.
 *
 * Nearly all faces have three or four corners. They are fitted two at a time, each with the next of its kind. */

/* A face that is counter-clockwise about its inward normal is clockwise seen from outside. */
static void turn(solid_frame *frame, roberts_scene *scene, uint32_t f)
{
    scene_turn_face(scene, frame->face_first + f);
    frame->turned++;
}

/* Updates what the checks need to know about all faces together. */
static void note(solid_frame *frame, const local_face *face)
{
    frame->any_lean |= face->lean;
    frame->any_doubt |= face->deviation > frame->allowed || !face->strict;
    frame->any_shallow |= face->depth < frame->flat;
}

/* Fits face f, which has five corners or more. */
static void fit_face(solid_frame *frame, roberts_scene *scene, uint32_t f)
{
    local_face *face = &frame->face[f];
    roberts_vec3 origin = frame_origin(frame, scene, f), b = vec3_sub(frame->barycentre, origin);
    fitted_plane fit = face_plane_fit(frame->ring, frame_ring(frame, scene, f));
    double depth = vec3_dot(fit.n, b) - fit.mean, side = depth < 0.0 ? -1.0 : 1.0;
    face->F.a = side * fit.n.x;
    face->F.b = side * fit.n.y;
    face->F.c = side * fit.n.z;
    face->F.d = side * (-vec3_dot(fit.n, origin) - fit.mean);
    face->depth = side * depth;
    face->deviation = fit.deviation;
    face->area = fit.area;
    face->width = fit.width;
    face->strict = fit.strict;
    face->lean = !(fit.area > 0.0);
    note(frame, face);
    if (side > 0.0)
        turn(frame, scene, f);
    frame_store(frame, scene, f, side * fit.mean);
}

/* Two faces of three or four corners each, one per lane; they may be the same. */
typedef struct two_faces {
    uint32_t f, g;         /* relative to the solid's first */
    const uint32_t *c, *d; /* their corners */
    two_vec3 origin;       /* their first corners */
    two_planes fit;
    two side; /* -1 if the fitted normal points outward */
} two_faces;

/* Returns corner k of both. */
static inline two_vec3 corners_at(const solid_frame *frame, const two_faces *t, uint32_t k)
{
    const roberts_vec3 *point = frame->point;
    return two_vec3_of(&point[t->c[k] - frame->vertex_first], &point[t->d[k] - frame->vertex_first]);
}

BITS_INLINE two_faces take_two(const solid_frame *frame, const roberts_scene *scene, uint32_t f, uint32_t g,
                               uint32_t corners)
{
    two_faces t = {.f = f, .g = g};
    t.c = scene->corner + scene->face_start[frame->face_first + f];
    t.d = scene->corner + scene->face_start[frame->face_first + g];
    t.origin = corners_at(frame, &t, 0);
    two_vec3 a = two_vec3_sub(corners_at(frame, &t, 1), t.origin), b = two_vec3_sub(corners_at(frame, &t, 2), t.origin);
    if (corners == 3)
        t.fit = two_planes_of_triangles(a, b);
    else
        t.fit = two_planes_of_quadrilaterals(a, b, two_vec3_sub(corners_at(frame, &t, 3), t.origin));
    return t;
}

/* Stores the planes in the frame and in the scene. */
static inline void store_planes(const solid_frame *frame, roberts_scene *scene, const two_faces *t)
{
    local_face *p = &frame->face[t->f], *q = &frame->face[t->g];
    plane *G = &scene->face_plane[frame->face_first + t->f], *H = &scene->face_plane[frame->face_first + t->g];
    two_vec3 first =
        two_vec3_sub(two_vec3_of(&scene->point[t->c[0]], &scene->point[t->d[0]]), two_vec3_all(scene->centre));
    two zero = two_all(0.0), mean = t->fit.mean;
    two_vec3 n = t->fit.n, F = {two_mul(t->side, n.x), two_mul(t->side, n.y), two_mul(t->side, n.z)};
    two_part(&p->F.a, &q->F.a, F.x);
    two_part(&p->F.b, &q->F.b, F.y);
    two_part(&p->F.c, &q->F.c, F.z);
    two_part(&p->F.d, &q->F.d, two_mul(t->side, two_sub(two_sub(zero, two_vec3_dot(n, t->origin)), mean)));
    two_part(&G->a, &H->a, F.x);
    two_part(&G->b, &H->b, F.y);
    two_part(&G->c, &H->c, F.z);
    two_part(&G->d, &H->d,
             two_sub(two_sub(zero, two_vec3_dot(F, first)), two_mul(two_mul(t->side, mean), two_all(frame->unit))));
}

static inline void store_sizes(const solid_frame *frame, roberts_scene *scene, const two_faces *t, two depth)
{
    local_face *p = &frame->face[t->f], *q = &frame->face[t->g];
    uint32_t f = frame->face_first + t->f, g = frame->face_first + t->g;
    two_part(&p->depth, &q->depth, depth);
    two_part(&p->deviation, &q->deviation, t->fit.deviation);
    two_part(&p->area, &q->area, t->fit.area);
    two_part(&p->width, &q->width, t->fit.width);
    two_part_floats(&scene->face_deviation[f], &scene->face_deviation[g],
                    two_mul(t->fit.deviation, two_all(frame->scene_units * SCENE_UPWARD)));
    two_part_floats(&scene->face_width[f], &scene->face_width[g],
                    two_mul(t->fit.width, two_all(frame->scene_units * SCENE_DOWNWARD)));
    p->strict = t->fit.strict & 1;
    q->strict = t->fit.strict >> 1 & 1;
    p->lean = q->lean = false;
}

/* Stores a face without area, as fitted_plane defines it. */
static void store_empty(solid_frame *frame, roberts_scene *scene, uint32_t f)
{
    frame->face[f] = (local_face){.lean = true};
    note(frame, &frame->face[f]);
    frame_store(frame, scene, f, 0.0);
}

/* Fits faces f and g, which both have `corners` corners, 3 or 4; f and g may be the same. */
static BITS_PER_PROCESSOR void fit_two(solid_frame *frame, roberts_scene *scene, uint32_t f, uint32_t g,
                                       uint32_t corners)
{
    two_faces t = take_two(frame, scene, f, g, corners);
    two depth = two_sub(two_vec3_dot(t.fit.n, two_vec3_sub(two_vec3_all(frame->barycentre), t.origin)), t.fit.mean);
    t.side = two_side(depth);
    depth = two_mul(t.side, depth);
    store_planes(frame, scene, &t);
    store_sizes(frame, scene, &t, depth);
    unsigned full = 3 & ~t.fit.empty, outward = two_at_most(t.side, two_all(0.0));
    frame->any_doubt |= (two_at_most(t.fit.deviation, two_all(frame->allowed)) & t.fit.strict & full) != full;
    frame->any_shallow |= (two_at_most(two_all(frame->flat), depth) & full) != full;
    if (!(outward & 1))
        turn(frame, scene, f);
    if (!(outward & 2) && f != g)
        turn(frame, scene, g);
    if (t.fit.empty & 1)
        store_empty(frame, scene, f);
    if (t.fit.empty & 2 && f != g)
        store_empty(frame, scene, g);
}

/* Fits faces two at a time. Adjacent faces with the same number of corners go together; others wait for the next of
 * their kind. */
static void fit_all(solid_frame *frame, roberts_scene *scene)
{
    uint32_t waiting[2] = {ROBERTS_NONE, ROBERTS_NONE};
    const uint32_t *start = scene->face_start + frame->face_first, count = frame->face_count;
    for (uint32_t f = 0; f < count; f++) {
        uint32_t n = start[f + 1] - start[f], *other = &waiting[n == 4];
        if (n > 4) {
            fit_face(frame, scene, f);
        } else if (f + 1 < count && start[f + 2] - start[f + 1] == n) {
            fit_two(frame, scene, f, f + 1, n);
            f++;
        } else if (*other == ROBERTS_NONE) {
            *other = f;
        } else {
            fit_two(frame, scene, *other, f, n);
            *other = ROBERTS_NONE;
        }
    }
    for (uint32_t i = 0; i < 2; i++)
        if (waiting[i] != ROBERTS_NONE)
            fit_two(frame, scene, waiting[i], waiting[i], 3 + i);
}

/* Fits the plane of each face, and orients plane and corners so that the barycentre is inside. */
static void frame_fit_faces(solid_frame *frame, roberts_scene *scene)
{
    double greatest;
    frame->turned = frame->widest = 0;
    frame->any_lean = frame->any_doubt = frame->any_shallow = false;
    fit_all(frame, scene);
    greatest = frame->face[0].width;
    for (uint32_t f = 1; f < frame->face_count; f++)
        if (frame->face[f].width > greatest) {
            greatest = frame->face[f].width;
            frame->widest = f;
        }
}

/* ---- faces that are too narrow --------------------------------------------------------------------------------- */

/* Some faces are too narrow to determine their own plane and inner side.
 *
 * If coordinates are given to six digits, a face may be narrower than the rounding. Its plane then points anywhere, and
 * may cut the solid. There are also triangles without area, where a corner of one face lies on a side of another. Such
 * faces are kept, since the surface is closed only with them. They take winding and plane from their neighbours. The
 * mean of two adjacent planes touches the solid along their common edge, so it hides nothing that its neighbours do not
 * hide. */

enum { UNSEEN, KEEP, TURN };

/* The edges of each face: edge[start[f]] .. edge[start[f + 1] - 1]. */
typedef struct face_edges {
    uint32_t *start, *edge;
} face_edges;

static bool collect_edges(face_edges *of, const solid_frame *frame)
{
    uint32_t count = 2 * frame->edge_count;
    of->start = alloc_zeroed((size_t)frame->face_count + 2, sizeof *of->start);
    of->edge = alloc_array(count, sizeof *of->edge);
    if (!of->start || !of->edge)
        return false;
    for (uint32_t e = 0; e < count; e++)
        of->start[frame->edge[e / 2].f[e % 2] + 2]++;
    for (uint32_t f = 0; f < frame->face_count; f++)
        of->start[f + 2] += of->start[f + 1];
    for (uint32_t e = 0; e < count; e++)
        of->edge[of->start[frame->edge[e / 2].f[e % 2] + 1]++] = e / 2;
    return true;
}

/* Decides for all faces connected with `seed` by edges whether to keep or turn them. */
static void flood(const solid_frame *frame, const face_edges *of, const uint8_t *alike, uint32_t seed,
                  uint8_t *decision, uint32_t *queue)
{
    uint32_t head = 0, tail = 0;
    decision[seed] = KEEP;
    queue[tail++] = seed;
    while (head < tail) {
        uint32_t f = queue[head++];
        for (uint32_t i = of->start[f]; i < of->start[f + 1]; i++) {
            const scene_edge *e = frame->edge + of->edge[i];
            uint32_t other = e->f[0] == f ? e->f[1] : e->f[0];
            if (decision[other] != UNSEEN)
                continue;
            decision[other] = alike[of->edge[i]] == (decision[f] == KEEP) ? TURN : KEEP;
            queue[tail++] = other;
        }
    }
}

static void turn_face(roberts_scene *scene, solid_frame *frame, uint32_t f)
{
    plane *global = &scene->face_plane[frame->face_first + f], *F = &frame->face[f].F;
    scene_turn_face(scene, frame->face_first + f);
    *F = (plane){-F->a, -F->b, -F->c, -F->d};
    frame->face[f].depth = -frame->face[f].depth;
    *global = (plane){-global->a, -global->b, -global->c, -global->d};
}

/* Would the two faces of each edge pass it in opposite directions after these decisions? */
static bool agree(const solid_frame *frame, const uint8_t *alike, const uint8_t *decision)
{
    for (uint32_t e = 0; e < frame->edge_count; e++) {
        const scene_edge *edge = &frame->edge[e];
        bool turned = decision[edge->f[0]] != decision[edge->f[1]];
        if (turned != (alike[e] != 0))
            return false;
    }
    return true;
}

/* Winds the faces of a solid consistently, starting from the widest, if the barycentre did not achieve it
 * (EDGES_MIXED). Turning a face reverses its corners and its plane. Edges must be paired again afterwards. Returns
 * ROBERTS_OK, _NO_MEMORY or _NOT_CONVEX (the surface is one-sided). */
static roberts_status narrow_wind(roberts_scene *scene, solid_frame *frame, const edge_scratch *edges)
{
    face_edges of = {0};
    uint8_t *decision = alloc_zeroed(frame->face_count, sizeof *decision);
    uint32_t *queue = alloc_array(frame->face_count, sizeof *queue);
    roberts_status status = ROBERTS_NO_MEMORY;
    if (!decision || !queue || !collect_edges(&of, frame))
        goto done;
    flood(frame, &of, edges->alike, frame->widest, decision, queue);
    for (uint32_t f = 0; f < frame->face_count; f++)
        if (decision[f] == UNSEEN)
            flood(frame, &of, edges->alike, f, decision, queue);
    status = agree(frame, edges->alike, decision) ? ROBERTS_OK : ROBERTS_NOT_CONVEX;
    for (uint32_t f = 0; f < frame->face_count && status == ROBERTS_OK; f++)
        if (decision[f] == TURN)
            turn_face(scene, frame, f);
done:
    free(decision);
    free(queue);
    free(of.start);
    free(of.edge);
    return status;
}

/* Adds the neighbour's normal to `sum`, weighted by the length of the edge, unless the neighbour itself needs a
 * plane. */
static void add_neighbour(const solid_frame *frame, const scene_edge *edge, uint32_t neighbour, roberts_vec3 *sum)
{
    const local_face *face = &frame->face[neighbour];
    roberts_vec3 a = frame->point[edge->v[0]], b = frame->point[edge->v[1]];
    if (!face->lean)
        *sum = vec3_add(*sum, vec3_scale(vec3_length(vec3_sub(b, a)), (roberts_vec3){face->F.a, face->F.b, face->F.c}));
}

/* Returns an inward normal for a face without area or usable neighbours: from its line toward the barycentre. */
static roberts_vec3 toward_barycentre(const solid_frame *frame, roberts_vec3 origin, uint32_t count)
{
    roberts_vec3 inward = vec3_sub(frame->barycentre, origin), chord = {0, 0, 0};
    for (uint32_t i = 1; i < count; i++) {
        roberts_vec3 d = frame->ring[i];
        chord = vec3_dot(d, d) > vec3_dot(chord, chord) ? d : chord;
    }
    if (vec3_dot(chord, chord) > 0.0)
        inward = vec3_sub(inward, vec3_scale(vec3_dot(inward, chord) / vec3_dot(chord, chord), chord));
    return inward;
}

/* Gives face f the normal n (of any length), through the mean of its corners. */
static void replace_plane(roberts_scene *scene, solid_frame *frame, uint32_t f, roberts_vec3 n)
{
    local_face *face = &frame->face[f];
    uint32_t count = frame_ring(frame, scene, f);
    double sum = 0.0, mean, deviation = 0.0;
    if (face->area == 0.0 && vec3_length(n) == 0.0)
        n = toward_barycentre(frame, frame_origin(frame, scene, f), count);
    if (vec3_length(n) == 0.0)
        return;
    n = vec3_scale(1.0 / vec3_length(n), n);
    for (uint32_t i = 1; i < count; i++)
        sum += vec3_dot(n, frame->ring[i]);
    mean = sum / count;
    for (uint32_t i = 0; i < count; i++)
        deviation = fmax(deviation, fabs(vec3_dot(n, frame->ring[i]) - mean));
    if (face->area > 0.0 && deviation > frame->allowed)
        return;
    face->F = (plane){n.x, n.y, n.z, -vec3_dot(n, frame_origin(frame, scene, f)) - mean};
    face->deviation = deviation;
    frame_store(frame, scene, f, mean);
}

/* Gives each face marked `lean`, or turned by rounding, the mean plane of its neighbours, if its corners are within the
 * tolerance of that plane. Returns ROBERTS_OK or _NO_MEMORY. */
static roberts_status narrow_planes(roberts_scene *scene, solid_frame *frame)
{
    roberts_vec3 *sum;
    for (uint32_t f = 0; scene_step(scene) > 0.0 && f < frame->face_count; f++)
        if (scene_turn(scene, frame->face_first + f) > SCENE_ROUNDED_BEND)
            frame->any_lean = frame->face[f].lean = true;
    if (!frame->any_lean)
        return ROBERTS_OK;
    sum = alloc_zeroed(frame->face_count, sizeof *sum); /* all bits zero are 0.0 */
    if (!sum)
        return ROBERTS_NO_MEMORY;
    for (const scene_edge *edge = frame->edge; edge < frame->edge + frame->edge_count; edge++) {
        add_neighbour(frame, edge, edge->f[0], &sum[edge->f[1]]);
        add_neighbour(frame, edge, edge->f[1], &sum[edge->f[0]]);
    }
    for (uint32_t f = 0; f < frame->face_count; f++)
        if (frame->face[f].lean)
            replace_plane(scene, frame, f, sum[f]);
    free(sum);
    return ROBERTS_OK;
}

/* ---- one solid ------------------------------------------------------------------------------------------------- */

/* The barycentre, the mean of the vertices, lies inside a convex solid. So it decides the inner side of each face,
 * whatever the winding in the file. The two faces of each edge then pass it in opposite directions. If not, faces too
 * narrow to decide are wound like their neighbours. */

/* Are the solid's edges stored with a pattern? Such a solid is closed. */
static bool is_stored(const roberts_scene *scene, uint32_t s)
{
    return scene->solid[s].stored < scene->shared;
}

static opening find_opening(const roberts_scene *scene, uint32_t s, edge_pairing pairing)
{
    const int64_t euler = edges_euler(scene, s);
    if (pairing == EDGES_OPEN)
        return OPENING_EDGES;
    if (pairing == EDGES_EVEN)
        return OPENING_PARTS;
    return euler == 2 ? OPENING_NONE : euler < 2 ? OPENING_HOLES : OPENING_PARTS;
}

build_result solid_is_closed(const roberts_scene *scene, builder *work, uint32_t s, roberts_error *error)
{
    work->opening = OPENING_NONE;
    if (is_stored(scene, s))
        return BUILD_OK;
    edge_pairing pairing = edges_pair(scene, s, &work->edges);
    if (pairing == EDGES_NO_MEMORY)
        return error_no_memory(error), BUILD_REFUSED;
    work->opening = find_opening(scene, s, pairing);
    return work->opening == OPENING_NONE ? BUILD_OK : BUILD_OPEN;
}

/* Finds the edges of solid s after its faces have been wound. If all or none of its faces were turned, these are its
 * pattern's edges. */
static edge_pairing pair(const roberts_scene *scene, builder *work, uint32_t s)
{
    solid_frame *frame = &work->frame;
    if (!is_stored(scene, s) || frame->turned % frame->face_count != 0) {
        edge_pairing pairing = edges_pair(scene, s, &work->edges);
        frame->edge = work->edges.edge;
        return pairing;
    }
    frame->edge = scene->edge + scene->solid[s].stored + (frame->turned > 0 ? frame->edge_count : 0);
    return EDGES_PAIRED;
}

static roberts_status wind(roberts_scene *scene, builder *work, uint32_t s, roberts_error *error)
{
    roberts_status status = narrow_wind(scene, &work->frame, &work->edges);
    if (status == ROBERTS_NO_MEMORY)
        return error_no_memory(error);
    if (status != ROBERTS_OK)
        return error_set(error, status, 0, "solid %u is not convex: its surface has one side only",
                         s - source_of_solid(scene, s, work->frame.mesh).solid);
    return edges_pair(scene, s, &work->edges) == EDGES_PAIRED ? ROBERTS_OK : error_no_memory(error);
}

/* Refuses a solid with a vertex that is not a finite number. An open solid is refused later, when it is welded, so the
 * message is the same whether the solid was built or only checked. */
static build_result refuse_numbers(roberts_scene *scene, builder *work, uint32_t s, bool must_close,
                                   roberts_error *error)
{
    build_result result = must_close ? BUILD_OK : solid_is_closed(scene, work, s, error);
    if (result != BUILD_OK)
        return result;
    error_set(error, ROBERTS_BAD_NUMBER, 0, "a vertex of solid %u is not a finite number up to 1e150",
              s - source_of_solid(scene, s, work->frame.mesh).solid);
    return BUILD_REFUSED;
}

/* Refuses a solid in which some face has F < 0 inside. A face that was turned to match its neighbours may be within a
 * wide tolerance and still face the wrong way. */
static roberts_status refuse_turned(const roberts_scene *scene, const solid_frame *frame, roberts_error *error)
{
    for (uint32_t f = 0; f < frame->face_count; f++)
        if (plane_at(frame->face[f].F, frame->barycentre) < 0.0) {
            solid_source at = source_of_solid(scene, frame->solid, frame->mesh);
            return error_set(error, ROBERTS_NOT_CONVEX, 0,
                             "solid %u is not convex: its middle lies %.6g outside face %u", frame->solid - at.solid,
                             -plane_at(frame->face[f].F, frame->barycentre) * frame->unit,
                             scene_face_number(scene, frame->face_first + f) - at.face);
        }
    return ROBERTS_OK;
}

build_result solid_build(roberts_scene *scene, builder *work, uint32_t s, const solid_rules *rules,
                         roberts_error *error)
{
    edge_pairing pairing;
    roberts_status status = frame_enter(&work->frame, scene, s, rules->tolerance);
    work->frame.mesh = rules->mesh;
    work->opening = OPENING_NONE;
    if (status == ROBERTS_NO_MEMORY)
        return error_no_memory(error), BUILD_REFUSED;
    if (status != ROBERTS_OK)
        return refuse_numbers(scene, work, s, rules->must_close, error);
    frame_fit_faces(&work->frame, scene);
    pairing = pair(scene, work, s);
    if (pairing == EDGES_NO_MEMORY)
        return error_no_memory(error), BUILD_REFUSED;
    work->opening = find_opening(scene, s, pairing);
    if (pairing == EDGES_OPEN || pairing == EDGES_EVEN || (!rules->must_close && work->opening != OPENING_NONE))
        return BUILD_OPEN;
    if (pairing == EDGES_MIXED && wind(scene, work, s, error) != ROBERTS_OK)
        return BUILD_REFUSED;
    status = solid_check(scene, &work->frame, error);
    if (status != ROBERTS_OK && frame_loosen(&work->frame, scene))
        status = solid_check(scene, &work->frame, error);
    if (status != ROBERTS_OK)
        return BUILD_REFUSED;
    if (work->opening != OPENING_NONE)
        return error_set(error, ROBERTS_NOT_CONVEX, 0, "solid %u is not convex: its surface has holes",
                         s - source_of_solid(scene, s, rules->mesh).solid),
               BUILD_REFUSED;
    if (narrow_planes(scene, &work->frame) != ROBERTS_OK)
        return error_no_memory(error), BUILD_REFUSED;
    if (pairing == EDGES_MIXED && refuse_turned(scene, &work->frame, error) != ROBERTS_OK)
        return BUILD_REFUSED;
    return BUILD_OK;
}

void builder_free(builder *work)
{
    frame_free(&work->frame);
    edge_scratch_free(&work->edges);
}
