/* convex.c - whether faces and solids are convex, within the tolerance; large solids that surely are not; the
 * tolerance that would accept a refused model. */
#include "model/convex.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/box.h"
#include "base/error.h"
#include "base/orient.h"
#include "base/sort.h"
#include "base/vec.h"
#include "model/face_plane.h"
#include "model/scene.h"
#include "read/mesh.h"

/* ---- is a face convex? ----------------------------------------------------------------------------------------- */

/* Is a face a convex simple polygon?
 *
 * Nearly all faces are strictly convex, which signs alone decide. The others (collinear corners, coordinates rounded to
 * few digits, pentagrams, concave faces) are compared with the convex hull of their corners, found by the monotone
 * chain. Source: A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", Information Processing
 * Letters 9(5), 1979. */

/* Projects a point along a coordinate axis. */
static roberts_vec2 drop(roberts_vec3 p, int axis)
{
    return axis == 0 ? (roberts_vec2){p.y, p.z} : axis == 1 ? (roberts_vec2){p.z, p.x} : (roberts_vec2){p.x, p.y};
}

bool polygon_strictly_convex(const roberts_vec3 *corner, uint32_t count, roberts_vec3 n)
{
    double x = fabs(n.x), y = fabs(n.y), z = fabs(n.z);
    int axis = x > y && x > z ? 0 : y > z ? 1 : 2;
    double sign = (axis == 0 ? n.x : axis == 1 ? n.y : n.z) < 0.0 ? -1.0 : 1.0;
    roberts_vec2 b = drop(corner[count - 1], axis), a = drop(corner[count - 2], axis);
    double ex = b.x - a.x, ey = b.y - a.y;
    bool rising = ey > 0.0 || (ey == 0.0 && ex > 0.0);
    unsigned starts = 0; /* sides at which the direction enters the upper half-plane: one for each full turn */
    for (uint32_t i = 0; i < count; i++) {
        roberts_vec2 c = drop(corner[i], axis);
        double fx = c.x - b.x, fy = c.y - b.y;
        bool up = fy > 0.0 || (fy == 0.0 && fx > 0.0);
        if (!(sign * (ex * fy - ey * fx) > 0.0))
            return false;
        starts += up && !rising;
        rising = up;
        ex = fx;
        ey = fy;
        b = c;
    }
    return starts == 1;
}

typedef struct spot {
    double x, y;
    uint32_t at; /* corner */
} spot;

static int compare_spots(const void *a, const void *b)
{
    const spot *p = a, *q = b;
    if (p->x != q->x)
        return p->x < q->x ? -1 : 1;
    if (p->y != q->y)
        return p->y < q->y ? -1 : 1;
    return (p->at > q->at) - (p->at < q->at);
}

/* > 0 if a, b, c turn left. */
static double turn_of_spots(spot a, spot b, spot c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/* Do a, b, c turn left? Decided exactly: signs that contradict one another would put a spot into both chains. */
static bool turn_left(spot a, spot b, spot c)
{
    return orient2d((roberts_vec2){a.x, a.y}, (roberts_vec2){b.x, b.y}, (roberts_vec2){c.x, c.y}) > 0.0;
}

/* Finds the convex hull of the sorted spots, counter-clockwise, without collinear corners. `hull` has room for count +
 * 1. */
static uint32_t monotone_chain(const spot *sorted, uint32_t count, spot *hull)
{
    uint32_t size = 0, lower;
    for (uint32_t i = 0; i < count; i++) {
        while (size >= 2 && !turn_left(hull[size - 2], hull[size - 1], sorted[i]))
            size--;
        hull[size++] = sorted[i];
    }
    lower = size + 1;
    for (uint32_t i = count - 1; i-- > 0;) {
        while (size >= lower && !turn_left(hull[size - 2], hull[size - 1], sorted[i]))
            size--;
        hull[size++] = sorted[i];
    }
    return size - 1; /* the last one repeats the first */
}

static double distance(spot a, spot b)
{
    return hypot(b.x - a.x, b.y - a.y);
}

/* The hull of a polygon's corners: hull[size] is hull[0] again. */
typedef struct corner_hull {
    const spot *hull;
    uint32_t size;
    const uint32_t *rank; /* [corners] index in the hull, or ROBERTS_NONE */
} corner_hull;

/* Walks the corners, starting at hull[0], and returns the greatest depth of a corner inside the hull. Each corner must
 * be the hull's next vertex (or a later one, if those skipped are within `allowed` of it). Otherwise it must lie beside
 * the current side of the hull and not behind where the walk has been. Returns INFINITY if a corner does neither. */
static double walk(const spot *polygon, uint32_t count, const corner_hull *h, double allowed, uint32_t *deepest)
{
    const spot *hull = h->hull;
    const uint32_t *rank = h->rank, size = h->size;
    double dent = 0.0, reached = 0.0;
    uint32_t side = 0;
    for (uint32_t k = 1; k < count; k++) {
        spot c = polygon[(hull[0].at + (size_t)k) % count], a = hull[side], b = hull[side + 1];
        if (rank[c.at] != ROBERTS_NONE && rank[c.at] > side) {
            for (side++; side < rank[c.at]; side++)
                if (distance(hull[side], c) > allowed)
                    return INFINITY;
            reached = 0.0;
            continue;
        }
        double length = distance(a, b), depth = turn_of_spots(a, b, c) / length;
        double along = ((c.x - a.x) * (b.x - a.x) + (c.y - a.y) * (b.y - a.y)) / length;
        if (depth > dent) {
            dent = depth;
            *deepest = c.at;
        }
        if (depth > allowed)
            continue; /* within this depth, the walk may turn back */
        if (along < reached - allowed)
            return INFINITY;
        reached = fmax(reached, along);
    }
    for (side++; side < size; side++)
        if (distance(hull[side], hull[0]) > allowed)
            return INFINITY;
    return dent;
}

/* Returns how far the polygon is from convex: the greatest depth of a corner inside the hull of all corners, and which
 * corner. INFINITY: the corners do not go round the hull once, even if steps back of length `allowed` are ignored.
 * Negative: no memory. */
static double polygon_dent(const roberts_vec3 *corner, uint32_t count, roberts_vec3 n, double allowed,
                           uint32_t *deepest)
{
    spot *polygon = alloc_array(count, sizeof *polygon), *sorted = alloc_array(count, sizeof *sorted);
    spot *hull = alloc_array((size_t)count + 1, sizeof *hull);
    uint32_t *rank = alloc_array(count, sizeof *rank), size;
    double dent = -1.0;
    if (polygon && sorted && hull && rank) {
        roberts_vec3 u = vec3_cross(fabs(n.x) < 0.6 ? (roberts_vec3){1, 0, 0} : (roberts_vec3){0, 1, 0}, n), v;
        u = vec3_scale(1.0 / vec3_length(u), u);
        v = vec3_cross(n, u);
        for (uint32_t i = 0; i < count; i++) {
            roberts_vec3 p = vec3_sub(corner[i], corner[0]);
            polygon[i] = sorted[i] = (spot){vec3_dot(u, p), vec3_dot(v, p), i};
            rank[i] = ROBERTS_NONE;
        }
        qsort(sorted, count, sizeof *sorted, compare_spots);
        size = monotone_chain(sorted, count, hull);
        for (uint32_t i = 0; i < size; i++)
            rank[hull[i].at] = i;
        dent = size < 3 ? 0.0 : walk(polygon, count, &(corner_hull){hull, size, rank}, allowed, deepest);
    }
    free(polygon);
    free(sorted);
    free(hull);
    free(rank);
    return dent;
}

/* Returns how far a face without area, which has no normal, is from straight: the greatest distance of a corner from
 * the line through the first corner and the one farthest from it. */
static double polygon_spread(const roberts_vec3 *corner, uint32_t count)
{
    roberts_vec3 chord = {0, 0, 0};
    double squared = 0.0, greatest = 0.0;
    for (uint32_t i = 1; i < count; i++) {
        roberts_vec3 d = vec3_sub(corner[i], corner[0]);
        if (vec3_dot(d, d) > squared) {
            squared = vec3_dot(d, d);
            chord = d;
        }
    }
    for (uint32_t i = 1; i < count && squared > 0.0; i++)
        greatest = fmax(greatest, vec3_length(vec3_cross(chord, vec3_sub(corner[i], corner[0]))) / sqrt(squared));
    return greatest;
}

/* ---- vertices outside a plane ---------------------------------------------------------------------------------- */

/* A tree of boxes that finds points outside a plane.
 *
 * The points are sorted along the Z-order curve and cut into leaves of eight. A complete binary tree of boxes is built
 * over the leaves. A box is skipped if its least possible F is allowed. Source: G. M. Morton, "A computer oriented
 * geodetic data base and a new technique in file sequencing", IBM 1966. */

typedef struct vertex_tree {
    const roberts_vec3 *point;
    uint32_t count, leaves; /* leaves: number of leaves, a power of two */
    uint32_t *order;        /* [count] points along a space-filling curve */
    box3 *box; /* [2 * leaves] a heap: box i holds boxes 2 i and 2 i + 1; the last `leaves` boxes hold points */
} vertex_tree;

enum { LEAF = 8 }; /* points in a leaf */

/* Spreads ten bits, leaving two zero bits between them. */
static uint32_t spread(uint32_t x)
{
    x = (x | x << 16) & 0x030000ff;
    x = (x | x << 8) & 0x0300f00f;
    x = (x | x << 4) & 0x030c30c3;
    return (x | x << 2) & 0x09249249;
}

static uint32_t cell(double x, double lo, double hi)
{
    return hi > lo ? (uint32_t)fmin(1023.0, (x - lo) / (hi - lo) * 1024.0) : 0;
}

/* Fills tree->order along the curve. */
static bool sort_points(vertex_tree *tree)
{
    roberts_vec3 lo = tree->point[0], hi = lo;
    uint64_t *key = alloc_array(tree->count, sizeof *key);
    if (!key)
        return false;
    box_add_all(&lo, &hi, tree->point, tree->count);
    for (uint32_t v = 0; v < tree->count; v++) {
        roberts_vec3 p = tree->point[v];
        uint32_t code =
            spread(cell(p.x, lo.x, hi.x)) | spread(cell(p.y, lo.y, hi.y)) << 1 | spread(cell(p.z, lo.z, hi.z)) << 2;
        key[v] = (uint64_t)code << 32 | v;
    }
    qsort(key, tree->count, sizeof *key, compare_u64);
    for (uint32_t v = 0; v < tree->count; v++)
        tree->order[v] = (uint32_t)key[v];
    free(key);
    return true;
}

static void vertex_tree_free(vertex_tree *tree)
{
    free(tree->order);
    free(tree->box);
    *tree = (vertex_tree){0};
}

/* `point` stays the caller's and must outlive the tree. False: no memory. */
static bool vertex_tree_build(vertex_tree *tree, const roberts_vec3 *point, uint32_t count)
{
    *tree = (vertex_tree){.point = point, .count = count, .leaves = 1};
    while ((uint64_t)tree->leaves * LEAF < count)
        tree->leaves *= 2;
    tree->order = alloc_array(count, sizeof *tree->order);
    tree->box = alloc_array(2 * (size_t)tree->leaves, sizeof *tree->box);
    if (!tree->order || !tree->box || !sort_points(tree)) {
        vertex_tree_free(tree);
        return false;
    }
    for (uint32_t i = 0; i < 2 * tree->leaves; i++)
        tree->box[i] = box3_none;
    for (uint32_t i = 0; i < count; i++)
        box3_add(&tree->box[tree->leaves + i / LEAF], point[tree->order[i]]);
    for (uint32_t i = tree->leaves - 1; i > 0; i--)
        for (uint32_t child = 2 * i; child <= 2 * i + 1; child++)
            if (tree->box[child].lo.x <= tree->box[child].hi.x) {
                box3_add(&tree->box[i], tree->box[child].lo);
                box3_add(&tree->box[i], tree->box[child].hi);
            }
    return true;
}

/* Returns the least F in a box; INFINITY if the box is empty. */
static double least_in_box(const box3 *box, plane F)
{
    roberts_vec3 corner = {F.a > 0.0 ? box->lo.x : box->hi.x, F.b > 0.0 ? box->lo.y : box->hi.y,
                           F.c > 0.0 ? box->lo.z : box->hi.z};
    return box->lo.x <= box->hi.x ? plane_at(F, corner) : INFINITY;
}

/* ---- is a solid convex? ---------------------------------------------------------------------------------------- */

/* Is a closed component a convex solid, within the tolerance?
 *
 * A closed surface bounds a convex solid if every face is a convex polygon, every vertex lies behind every face's
 * plane, and the faces, seen from the barycentre, cover each direction once. A vertex may lie outside a plane by the
 * tolerance. The plane of a small face cannot be trusted far away from it; there the limit grows in proportion to the
 * distance. Near the face it does not, so that the dent of a rebate along a thin plank is found.
 *
 * Usually it is enough that no edge bends inward. The sum of the inward bends bounds how far anything can lie outside,
 * as a fraction of the size. If this sum is not far below the tolerance, because coordinates are rounded or the solid
 * is not convex, each plane is compared with the vertices: all of them in a small solid, by a tree of boxes in a large
 * one. */

enum { ALL_PAIRS = 2048 }; /* pairs of vertex and face; up to this many, comparing all is faster than a tree */

/* Fraction of the tolerance: if the inward bends of the edges add up to less, no closer look is needed. */
static const double BEND_PART = 0.1;

/* Returns the solid's number within its file, for messages. */
static uint32_t input_solid(const roberts_scene *scene, const solid_frame *frame)
{
    return frame->solid - source_of_solid(scene, frame->solid, frame->mesh).solid;
}

static uint32_t input_face(const roberts_scene *scene, const solid_frame *frame, uint32_t f)
{
    return scene_face_number(scene, frame->face_first + f) - source_of_solid(scene, frame->solid, frame->mesh).face;
}

static uint32_t input_vertex(const roberts_scene *scene, const solid_frame *frame, uint32_t v)
{
    return scene_vertex_number(scene, frame->vertex_first + v) -
           source_of_solid(scene, frame->solid, frame->mesh).vertex;
}

/* Checks one face: its corners must lie in one plane and form a convex simple polygon. */
static roberts_status check_face(const roberts_scene *scene, const solid_frame *frame, uint32_t f, roberts_error *error)
{
    const local_face *face = &frame->face[f];
    uint32_t n, deepest = 0, start = scene->face_start[frame->face_first + f];
    double dent;
    if (face->deviation > frame->allowed)
        return error_set(error, ROBERTS_NOT_PLANAR, 0,
                         "face %u of solid %u is not planar: its corners lie up to %.6g beside their plane",
                         input_face(scene, frame, f), input_solid(scene, frame), face->deviation * frame->unit);
    if (face->strict)
        return ROBERTS_OK;
    n = frame_ring(frame, scene, f);
    if (face->area > 0.0)
        dent =
            polygon_dent(frame->ring, n, (roberts_vec3){-face->F.a, -face->F.b, -face->F.c}, frame->allowed, &deepest);
    else
        dent = polygon_spread(frame->ring, n) > frame->allowed ? INFINITY : 0.0;
    if (dent < 0.0)
        return error_no_memory(error);
    if (dent == INFINITY)
        return error_set(error, ROBERTS_NOT_CONVEX, 0, "face %u of solid %u is not a convex polygon: it crosses itself",
                         input_face(scene, frame, f), input_solid(scene, frame));
    if (dent > frame->allowed)
        return error_set(error, ROBERTS_NOT_CONVEX, 0,
                         "face %u of solid %u is not a convex polygon: vertex %u lies %.6g inside its outline",
                         input_face(scene, frame, f), input_solid(scene, frame),
                         input_vertex(scene, frame, scene->corner[start + deepest] - frame->vertex_first),
                         dent * frame->unit);
    return ROBERTS_OK;
}

/* Returns the distance of a point from the sides of a polygon of n corners. */
static double distance_from_ring(const roberts_vec3 *ring, uint32_t n, roberts_vec3 P)
{
    double least = INFINITY;
    for (uint32_t i = 0; i < n; i++) {
        const roberts_vec3 A = ring[i ? i - 1 : n - 1], AB = vec3_sub(ring[i], A), AP = vec3_sub(P, A);
        const double squared = vec3_dot(AB, AB), t = squared > 0.0 ? vec3_dot(AP, AB) / squared : 0.0;
        least = lesser(least, vec3_length(vec3_sub(AP, vec3_scale(greater(0.0, lesser(1.0, t)), AB))));
    }
    return least;
}

/* A face whose plane is compared with vertices, and how far outside these may lie: by `far` everywhere, and by `near`
 * where they touch the face. */
typedef struct judged_face {
    const local_face *face;
    const roberts_vec3 *ring; /* [corners] relative to `origin` */
    roberts_vec3 origin;
    uint32_t corners;
    double near, far;
} judged_face;

static judged_face judge(const roberts_scene *scene, const solid_frame *frame, uint32_t f)
{
    const local_face *face = &frame->face[f];
    return (judged_face){
        .face = face,
        .ring = frame->ring,
        .origin = frame_origin(frame, scene, f),
        .corners = frame_ring(frame, scene, f),
        .near = 2.0 * frame->allowed,
        .far = face->width < frame->size ? frame->allowed * (frame->size / face->width) : frame->allowed,
    };
}

/* Returns how far a vertex may lie outside, given its distance from the face. Moving it and the corners of the face by
 * the tolerance turns the plane by two tolerances over the width of the face. */
static double allowance(const judged_face *j, double distance)
{
    return lesser(j->far, j->near * (1.0 + distance / j->face->width));
}

/* Does a point lie too far outside? */
static bool is_outside(const judged_face *j, roberts_vec3 P)
{
    const double outside = -plane_at(j->face->F, P);
    return outside > lesser(j->near, j->far) &&
           outside > allowance(j, distance_from_ring(j->ring, j->corners, vec3_sub(P, j->origin)));
}

static roberts_status refuse_vertex(const roberts_scene *scene, const solid_frame *frame, uint32_t f, uint32_t v,
                                    roberts_error *error)
{
    double outside = -plane_at(frame->face[f].F, frame->point[v]);
    return error_set(error, ROBERTS_NOT_CONVEX, 0, "solid %u is not convex: vertex %u lies %.6g outside face %u",
                     input_solid(scene, frame), input_vertex(scene, frame, v), outside * frame->unit,
                     input_face(scene, frame, f));
}

static roberts_status refuse_flat(const roberts_scene *scene, const solid_frame *frame, double thickness,
                                  roberts_error *error)
{
    return error_set(error, ROBERTS_FLAT, 0, "solid %u is flat: %.6g thick where it is %.6g across",
                     input_solid(scene, frame), thickness * frame->unit, frame->size * frame->unit);
}

/* Returns the least F of the solid's vertices. */
static double least_distance(const solid_frame *frame, plane F)
{
    double least = INFINITY;
    for (uint32_t v = 0; v < frame->vertex_count; v++) {
        double value = plane_at(F, frame->point[v]);
        least = value < least ? value : least;
    }
    return least;
}

/* Returns the thickness of the solid across this face. */
static double thickness(const solid_frame *frame, plane F)
{
    return 0.0 - least_distance(frame, (plane){-F.a, -F.b, -F.c, -F.d}) - least_distance(frame, F);
}

/* Returns the vertex with the least F. */
static uint32_t outermost(const solid_frame *frame, plane F)
{
    uint32_t found = 0;
    for (uint32_t v = 1; v < frame->vertex_count; v++)
        found = plane_at(F, frame->point[v]) < plane_at(F, frame->point[found]) ? v : found;
    return found;
}

static bool is_large(const solid_frame *frame)
{
    return (uint64_t)frame->vertex_count * frame->face_count > ALL_PAIRS;
}

/* Returns the least thickness of the solid where it may be thin: for a small solid, across each face near the
 * barycentre; for a large one, across the widest face and the face of greatest area. */
static double least_thickness(const solid_frame *frame)
{
    double least = INFINITY;
    uint32_t greatest = 0;
    for (uint32_t f = 0; f < frame->face_count; f++) {
        const local_face *face = &frame->face[f];
        greatest = face->area > frame->face[greatest].area ? f : greatest;
        if (!is_large(frame) && face->depth < frame->flat && face->area > 0.0)
            least = fmin(least, thickness(frame, face->F));
    }
    if (is_large(frame))
        least = fmin(thickness(frame, frame->face[frame->widest].F), thickness(frame, frame->face[greatest].F));
    return least;
}

/* Returns the sine of the angle by which an edge bends inward, 1 for more than a right angle, 0 for outward. */
static double bend_of(const solid_frame *frame, const scene_edge *edge)
{
    plane F = frame->face[edge->f[0]].F, G = frame->face[edge->f[1]].F;
    roberts_vec3 along = vec3_sub(frame->point[edge->v[1]], frame->point[edge->v[0]]);
    roberts_vec3 m = {F.a, F.b, F.c}, n = {G.a, G.b, G.c};
    double bend = vec3_dot(vec3_cross(m, n), along); /* > 0: outward */
    if (vec3_dot(m, n) <= 0.0 && bend <= 0.0)
        return 1.0; /* folded, or an edge or a face without extent, which is inconclusive */
    return bend < 0.0 ? -bend / vec3_length(along) : 0.0;
}

static inline two_vec3 normals_of(const solid_frame *frame, uint32_t f, uint32_t g)
{
    const plane *F = &frame->face[f].F, *G = &frame->face[g].F;
    return (two_vec3){two_of(F->a, G->a), two_of(F->b, G->b), two_of(F->c, G->c)};
}

/* Do both edges bend outward, as bend_of() defines it? */
static inline bool both_outward(const solid_frame *frame, const scene_edge *a, const scene_edge *b)
{
    const roberts_vec3 *point = frame->point;
    two_vec3 along =
        two_vec3_sub(two_vec3_of(&point[a->v[1]], &point[b->v[1]]), two_vec3_of(&point[a->v[0]], &point[b->v[0]]));
    two_vec3 m = normals_of(frame, a->f[0], b->f[0]), n = normals_of(frame, a->f[1], b->f[1]);
    return two_at_most(two_vec3_dot(two_vec3_cross(m, n), along), two_all(0.0)) == 0;
}

/* Returns the sum of the inward bends of all edges. */
static double inward_bend(const solid_frame *frame)
{
    const scene_edge *edge = frame->edge, *end = edge + frame->edge_count;
    double sum = 0.0;
    for (; end - edge >= 2; edge += 2)
        if (!both_outward(frame, edge, edge + 1)) {
            sum += bend_of(frame, edge);
            sum += bend_of(frame, edge + 1);
        }
    return edge < end ? sum + bend_of(frame, edge) : sum;
}

/* Compares every vertex with every plane. */
static roberts_status check_pairs(const roberts_scene *scene, solid_frame *frame, roberts_error *error)
{
    for (uint32_t f = 0; f < frame->face_count; f++) {
        local_face *face = &frame->face[f];
        if (-least_distance(frame, face->F) <= frame->allowed)
            continue;
        const judged_face j = judge(scene, frame, f);
        for (uint32_t v = 0; v < frame->vertex_count; v++)
            if (is_outside(&j, frame->point[v]))
                return refuse_vertex(scene, frame, f, outermost(frame, face->F), error);
        frame->any_lean = face->lean = true;
    }
    return ROBERTS_OK;
}

/* How far any point of a box may lie outside; `own` is the box of the face. */
static double least_allowance(const judged_face *j, const box3 *own, const box3 *box)
{
    if (j->near == INFINITY)
        return j->far;
    const roberts_vec3 gap = {greater(0.0, greater(box->lo.x - own->hi.x, own->lo.x - box->hi.x)),
                              greater(0.0, greater(box->lo.y - own->hi.y, own->lo.y - box->hi.y)),
                              greater(0.0, greater(box->lo.z - own->hi.z, own->lo.z - box->hi.z))};
    return allowance(j, vec3_length(gap));
}

/* Does any point of the tree lie too far outside? */
static bool any_outside(const vertex_tree *tree, const judged_face *j)
{
    uint32_t stack[34], depth = 0; /* at most one pending box per level */
    box3 own = box3_none;
    for (uint32_t i = 0; i < j->corners && j->near < INFINITY; i++)
        box3_add(&own, vec3_add(j->origin, j->ring[i]));
    stack[depth++] = 1;
    while (depth > 0) {
        const uint32_t i = stack[--depth];
        if (!(-least_in_box(&tree->box[i], j->face->F) > least_allowance(j, &own, &tree->box[i])))
            continue;
        if (i < tree->leaves) {
            stack[depth++] = 2 * i;
            stack[depth++] = 2 * i + 1;
            continue;
        }
        for (uint32_t k = (i - tree->leaves) * LEAF; k < tree->count && k / LEAF == i - tree->leaves; k++)
            if (is_outside(j, tree->point[tree->order[k]]))
                return true;
    }
    return false;
}

/* Does a corner of face g lie outside face f by no small part of the tolerance? */
static bool dents(const roberts_scene *scene, const solid_frame *frame, uint32_t g, uint32_t f)
{
    const uint32_t *start = scene->face_start + frame->face_first + g;
    for (uint32_t i = start[0]; i < start[1]; i++)
        if (-plane_at(frame->face[f].F, frame->point[scene->corner[i] - frame->vertex_first]) >
            BEND_PART * frame->allowed)
            return true;
    return false;
}

/* Marks faces with a neighbour that dents the solid there. NULL: no memory. */
static uint8_t *mark_dents(const roberts_scene *scene, const solid_frame *frame)
{
    uint8_t *dent = alloc_zeroed(frame->face_count, 1);
    for (uint32_t e = 0; dent && e < frame->edge_count; e++) {
        const scene_edge *edge = &frame->edge[e];
        if (!(bend_of(frame, edge) > 0.0))
            continue;
        for (int k = 0; k < 2; k++)
            dent[edge->f[k]] |= dents(scene, frame, edge->f[!k], edge->f[k]);
    }
    return dent;
}

/* Compares every plane with the tree of vertices; near their faces only those that a neighbour dents, since it takes
 * long. */
static roberts_status check_by_tree(const roberts_scene *scene, solid_frame *frame, roberts_error *error)
{
    roberts_status status = ROBERTS_OK;
    vertex_tree tree;
    if (!vertex_tree_build(&tree, frame->point, frame->vertex_count))
        return error_no_memory(error);
    uint8_t *dent = mark_dents(scene, frame);
    if (!dent)
        status = error_no_memory(error);
    for (uint32_t f = 0; f < frame->face_count && status == ROBERTS_OK; f++) {
        local_face *face = &frame->face[f];
        if (!(face->area > 0.0))
            continue;
        const bool narrow = !(face->width > frame->allowed);
        judged_face j = judge(scene, frame, f);
        j.far = narrow ? frame->allowed : j.far;
        j.near = dent[f] ? j.near : INFINITY;
        if (!any_outside(&tree, &j))
            continue;
        frame->any_lean = face->lean = true;
        if (!narrow)
            status = refuse_vertex(scene, frame, f, outermost(frame, face->F), error);
    }
    free(dent);
    vertex_tree_free(&tree);
    return status;
}

/* Checks each face, then the whole solid. Four points are always convex. */
static roberts_status check_faces(const roberts_scene *scene, solid_frame *frame, roberts_error *error)
{
    for (uint32_t f = 0; frame->any_doubt && f < frame->face_count; f++) {
        roberts_status status;
        if ((frame->face[f].deviation > frame->allowed || !frame->face[f].strict) &&
            (status = check_face(scene, frame, f, error)) != ROBERTS_OK)
            return status;
    }
    if (frame->vertex_count == 4 || inward_bend(frame) * frame->size <= BEND_PART * frame->allowed)
        return ROBERTS_OK;
    return is_large(frame) ? check_by_tree(scene, frame, error) : check_pairs(scene, frame, error);
}

/* Does the ray from the barycentre pass through the face? It does if it lies on or inside every plane through the
 * barycentre and a side. The two faces of a side get exactly opposite signs. */
static bool covers(const roberts_scene *scene, const solid_frame *frame, uint32_t f, roberts_vec3 ray)
{
    uint32_t start = scene->face_start[frame->face_first + f], end = scene->face_start[frame->face_first + f + 1];
    roberts_vec3 a = vec3_sub(frame->point[scene->corner[end - 1] - frame->vertex_first], frame->barycentre);
    for (uint32_t i = start; i < end; i++) {
        roberts_vec3 b = vec3_sub(frame->point[scene->corner[i] - frame->vertex_first], frame->barycentre);
        if (vec3_dot(vec3_cross(a, b), ray) < 0.0)
            return false;
        a = b;
    }
    return true;
}

/* Counts the faces that the barycentre sees in one direction, toward the middle of the widest face, well inside it.
 * Only faces whose planes the ray approaches are tested. */
static uint32_t count_covers(const roberts_scene *scene, const solid_frame *frame)
{
    uint32_t n = frame_ring(frame, scene, frame->widest), count = 1;
    roberts_vec3 X = {0, 0, 0}, ray;
    for (uint32_t i = 1; i < n; i++)
        X = vec3_add(X, frame->ring[i]);
    X = vec3_add(vec3_scale(1.0 / n, X), frame_origin(frame, scene, frame->widest));
    ray = vec3_sub(X, frame->barycentre);
    for (uint32_t f = 0; f < frame->face_count; f++) {
        const plane *F = &frame->face[f].F;
        if (F->a * ray.x + F->b * ray.y + F->c * ray.z < 0.0 && f != frame->widest)
            count += covers(scene, frame, f, ray);
    }
    return count;
}

/* Is it certain, without a ray, that the faces cover each direction once? A surface like a sphere that covers
 * directions k times must go round some two vertices twice or more (2 k - 2 extra turns in all, by Riemann and
 * Hurwitz). Seen from the barycentre, a face takes less than a half turn round its corner. So these two vertices have
 * at least five edges each, and all others at least three. */
static bool too_few_to_wind(const solid_frame *frame)
{
    return !frame->any_doubt && !frame->any_lean &&
           2 * (uint64_t)frame->edge_count < 3 * (uint64_t)frame->vertex_count + 4;
}

roberts_status solid_check(const roberts_scene *scene, solid_frame *frame, roberts_error *error)
{
    uint32_t count;
    roberts_status status;
    if (frame->size == 0.0)
        status = error_set(error, ROBERTS_FLAT, 0, "solid %u is flat: all its vertices lie in one point",
                           input_solid(scene, frame));
    else if (!(frame->face[frame->widest].area > 0.0))
        status = error_set(error, ROBERTS_FLAT, 0, "solid %u is flat: none of its faces has an area",
                           input_solid(scene, frame));
    else if (frame->any_shallow && least_thickness(frame) < frame->flat)
        status = refuse_flat(scene, frame, least_thickness(frame), error);
    else
        status = check_faces(scene, frame, error);
    if (status == ROBERTS_OK && !too_few_to_wind(frame) && (count = count_covers(scene, frame)) != 1)
        status = error_set(error, ROBERTS_NOT_CONVEX, 0, "solid %u is not convex: its faces go round it %u times",
                           input_solid(scene, frame), count);
    return status;
}

/* ---- not convex at a glance ------------------------------------------------------------------------------------ */

enum { GLANCE_FACES = 8, GLANCE_VERTICES = 16 };

/* A factor that exceeds what rounding can add to a bound. */
#define GLANCE_MARGIN 1.01

/* A solid beyond these sizes needs a frame of its own, and a quick test cannot decide it. */
#define GLANCE_LARGE 0x1p200
#define GLANCE_SMALL 0x1p-200

/* Returns how far a vertex may lie outside the plane of a face of unit width, see solid_check(). 0: the numbers are too
 * large or too small. */
static double allowance_of(const roberts_scene *scene, uint32_t s, double tolerance, double *size)
{
    const roberts_vec3 *point = scene->point + scene->solid[s].vertex;
    uint32_t count = scene->solid[s + 1].vertex - scene->solid[s].vertex;
    roberts_vec3 low = point[0], high = point[0], sum = {0, 0, 0};
    box_add_all(&low, &high, point, count);
    for (uint32_t v = 0; v < count; v++)
        sum = vec3_add(sum, point[v]);
    double largest = greater(greater(greater(-low.x, high.x), greater(-low.y, high.y)), greater(-low.z, high.z));
    *size = vec3_length(vec3_sub(high, low));
    if (!isfinite(sum.x + sum.y + sum.z) || largest > MESH_COORDINATE_MAX ||
        !(*size > GLANCE_SMALL && *size < GLANCE_LARGE))
        return 0.0;
    return GLANCE_MARGIN * frame_loose(tolerance, largest, *size);
}

/* Finds how far the sampled vertices of solid s lie on either side of the plane, and returns the smaller distance. If
 * this is more than allowed, the solid is not convex, whichever way the face is wound. */
static double crossed_by(const roberts_scene *scene, uint32_t s, const fitted_plane *fit, roberts_vec3 origin)
{
    uint32_t first = scene->solid[s].vertex, count = scene->solid[s + 1].vertex - first;
    double least = 0.0, most = 0.0;
    for (uint32_t i = 0; i < GLANCE_VERTICES; i++) {
        uint32_t v = first + (uint32_t)((uint64_t)i * count / GLANCE_VERTICES);
        double height = vec3_dot(fit->n, vec3_sub(scene->point[v], origin)) - fit->mean;
        least = lesser(least, height);
        most = greater(most, height);
    }
    return lesser(most, -least);
}

bool solid_large_surely_not_convex(const roberts_scene *scene, uint32_t s, double tolerance)
{
    uint32_t first = scene->solid[s].face, count = scene->solid[s + 1].face - first;
    double size = 0.0, allowed = -1.0;
    for (uint32_t i = 0; i < GLANCE_FACES && allowed != 0.0; i++) {
        uint32_t f = first + (uint32_t)((uint64_t)i * count / GLANCE_FACES);
        const uint32_t *corner = scene->corner + scene->face_start[f];
        if (scene->face_start[f + 1] - scene->face_start[f] != 3)
            continue;
        roberts_vec3 A = scene->point[corner[0]];
        roberts_vec3 ring[3] = {{0, 0, 0}, vec3_sub(scene->point[corner[1]], A), vec3_sub(scene->point[corner[2]], A)};
        fitted_plane fit = face_plane_fit(ring, 3);
        double crossed = crossed_by(scene, s, &fit, A);
        if (!(fit.width > 0.0) || !(crossed > tolerance * fit.width))
            continue;
        if (allowed < 0.0)
            allowed = allowance_of(scene, s, tolerance, &size);
        if (allowed > 0.0 && crossed > allowed * greater(1.0, size / fit.width))
            return true;
    }
    return false;
}

/* ---- the tolerance that would accept a refused model ------------------------------------------------------------- */

/* It is found by trial: the whole model passes with any tolerance that is suggested. The amount by which the first
 * solid failed would not be enough. Others may fail by more, or for reasons that no tolerance cures. */

/* Steps of 1, 2 or 5 times a power of ten, up to a hundredth of the size: coordinates rounded to two digits may be off
 * by that much. A model farther from convex has another shape, and its drawing would look wrong; its hull is at least a
 * solid. */
static const double steps[] = {1e-10, 2e-10, 5e-10, 1e-9, 2e-9, 5e-9, 1e-8, 2e-8, 5e-8, 1e-7, 2e-7, 5e-7, 1e-6,
                               2e-6,  5e-6,  1e-5,  2e-5, 5e-5, 1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3, 1e-2};

enum { STEPS = sizeof steps / sizeof steps[0] };

/* A model with more faces is not tried, because a refusal must not take seconds. */
enum { FACES_TRIED = 200000 };

/* In a solid of n faces, each is about 1 / sqrt(n) of the size wide, and a vertex may lie outside its plane by sqrt(n)
 * tolerances (see above). That must not exceed this fraction of the size; a cube reaches it at a hundredth. A larger
 * tolerance would accept any surface of many small faces, or any solid far from the origin. */
static const double OUTSIDE_MOST = 0.025;

/* Returns the size of solid s as a fraction of what the tolerance may be relative to, see frame_loose(): at most 1. */
static double part_of_coordinates(const roberts_scene *scene, uint32_t s)
{
    const uint32_t first = scene->solid[s].vertex;
    roberts_vec3 low = scene->point[first], high = low;
    box_add_all(&low, &high, scene->point + first, scene->solid[s + 1].vertex - first);
    const double size = fmax(high.x - low.x, fmax(high.y - low.y, high.z - low.z));
    const double largest = fmax(fmax(fmax(high.x, -low.x), fmax(high.y, -low.y)), fmax(high.z, -low.z));
    return size < largest ? fmax(size / largest, 1.0 / FRAME_FAR) : 1.0;
}

/* Returns the greatest tolerance with which the shape of all solids still matters. */
static double greatest_tolerance(const roberts_scene *scene)
{
    double most = OUTSIDE_MOST;
    for (uint32_t s = 0; s < scene->solid_count; s++) {
        const uint32_t faces = scene->solid[s + 1].face - scene->solid[s].face;
        most = fmin(most, OUTSIDE_MOST / sqrt(faces) * part_of_coordinates(scene, s));
    }
    return most;
}

/* Does the mesh pass? If so, sets *most to the greatest tolerance that may be suggested. */
static bool passes(const roberts_mesh *mesh, uint32_t threads, double tolerance, double *most)
{
    const roberts_scene_options options = {.solids = true, .tolerance = tolerance, .threads = threads};
    roberts_scene *scene = NULL;
    const bool passed = roberts_scene_build(mesh, &options, &scene, NULL) == ROBERTS_OK;
    if (passed)
        *most = greatest_tolerance(scene);
    roberts_scene_free(scene);
    return passed;
}

/* Rounds down to one digit: 0.0072 to 0.007. */
static double round_down(double x)
{
    const double power = pow(10.0, -floor(log10(x)));
    return floor(x * power) / power;
}

/* Finds the first of the steps up to `most` that passes, by bisection. If none does, returns `most` itself, which
 * passes. */
static double first_step(const roberts_mesh *mesh, uint32_t threads, double tried, double most)
{
    size_t fails = 0, does = 0;
    double ignored;
    while (does < STEPS && steps[does] <= most)
        does++;
    while (fails < does) {
        const size_t middle = fails + (does - fails) / 2;
        if (steps[middle] > tried && passes(mesh, threads, steps[middle], &ignored))
            does = middle;
        else
            fails = middle + 1;
    }
    return does < STEPS && steps[does] <= most ? steps[does] : most;
}

double roberts_scene_tolerance(const roberts_mesh *mesh, const roberts_scene_options *options)
{
    const double tried = options && options->tolerance > 0.0 ? options->tolerance : SCENE_TOLERANCE;
    const uint32_t threads = options ? options->threads : 0;
    double most = steps[STEPS - 1], bound;
    if (mesh->face_count > FACES_TRIED || most <= tried || !passes(mesh, threads, most, &bound))
        return 0.0;
    if (bound < most) {
        most = round_down(bound);
        if (most <= tried || !passes(mesh, threads, most, &bound))
            return 0.0;
    }
    return first_step(mesh, threads, tried, most);
}
