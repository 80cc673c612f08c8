/* solid_check.c - whether a closed component is a convex solid, within the tolerance.
 *
 * A closed surface bounds a convex solid where every face is a convex polygon, every vertex lies behind every face's
 * plane, and the faces, seen from the barycentre, cover all directions once. A vertex may lie outside a plane by the
 * tolerance; where the face is small compared with the solid, its plane cannot be trusted far from it, and distances
 * count in proportion.
 *
 * Mostly it is enough that no edge bends inward: the angles by which edges do, summed over all of them, bound how far (as a
 * part of the size) anything can lie outside. Where that sum is not far below the tolerance, because coordinates are
 * rounded or the solid is not convex, each plane is compared with the vertices: with all of them in a small solid, with
 * a tree of boxes round them in a large one. */
#include "model/solid_check.h"

#include "base/error.h"
#include "model/face_plane.h"
#include "model/face_polygon.h"
#include "model/place.h"
#include "model/vertex_tree.h"

enum { ALL_PAIRS = 2048 }; /* pairs of vertex and face; up to so many, comparing them all is quicker than a tree */

/* The edges' inward bends may add up to this part of the tolerance without a closer look. */
static const double BEND_PART = 0.1;

/* Numbers as messages give them, within the solid's file. */
static uint32_t input_solid(const roberts_scene *scene, const solid_frame *frame)
{
    return frame->solid - place_of_solid(scene, frame->solid, frame->mesh).solid;
}

static uint32_t input_face(const roberts_scene *scene, const solid_frame *frame, uint32_t f)
{
    return scene_face_number(scene, frame->face_first + f) - place_of_solid(scene, frame->solid, frame->mesh).face;
}

static uint32_t input_vertex(const roberts_scene *scene, const solid_frame *frame, uint32_t v)
{
    return scene_vertex_number(scene, frame->vertex_first + v) -
           place_of_solid(scene, frame->solid, frame->mesh).vertex;
}

/* The face by itself: corners in one plane, a convex simple polygon. */
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

/* How far a vertex may lie outside this face's plane. */
static double allowance(const solid_frame *frame, const local_face *face)
{
    return face->width < frame->size ? frame->allowed * (frame->size / face->width) : frame->allowed;
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

/* The least F of the solid's vertices. */
static double least_distance(const solid_frame *frame, plane F)
{
    double least = INFINITY;
    for (uint32_t v = 0; v < frame->vertex_count; v++) {
        double value = plane_at(F, frame->point[v]);
        least = value < least ? value : least;
    }
    return least;
}

/* How thick the solid is across this face. */
static double thickness(const solid_frame *frame, plane F)
{
    return 0.0 - least_distance(frame, (plane){-F.a, -F.b, -F.c, -F.d}) - least_distance(frame, F);
}

/* The vertex with the least F. */
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

/* How thick the solid is where that may be little: of a small one across each face that is near the barycentre, of a large
 * one across the widest and across the one of greatest area. */
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

/* The angle by which an edge bends inward (its sine; 1 for more than a right one), 0 for outward. */
static double bend_of(const solid_frame *frame, const scene_edge *edge)
{
    plane F = frame->face[edge->f[0]].F, G = frame->face[edge->f[1]].F;
    roberts_vec3 along = vec3_sub(frame->point[edge->v[1]], frame->point[edge->v[0]]);
    roberts_vec3 m = {F.a, F.b, F.c}, n = {G.a, G.b, G.c};
    double bend = vec3_dot(vec3_cross(m, n), along); /* > 0: outward */
    if (vec3_dot(m, n) <= 0.0 && bend <= 0.0)
        return 1.0; /* folded, or an edge or a face without extent, which tells nothing */
    return bend < 0.0 ? -bend / vec3_length(along) : 0.0;
}

static inline two_vec3 normals_of(const solid_frame *frame, uint32_t f, uint32_t g)
{
    const plane *F = &frame->face[f].F, *G = &frame->face[g].F;
    return (two_vec3){two_of(F->a, G->a), two_of(F->b, G->b), two_of(F->c, G->c)};
}

/* Whether both of two edges bend outward, as bend_of() has it. */
static inline bool both_outward(const solid_frame *frame, const scene_edge *a, const scene_edge *b)
{
    const roberts_vec3 *point = frame->point;
    two_vec3 along =
        two_vec3_sub(two_vec3_of(&point[a->v[1]], &point[b->v[1]]), two_vec3_of(&point[a->v[0]], &point[b->v[0]]));
    two_vec3 m = normals_of(frame, a->f[0], b->f[0]), n = normals_of(frame, a->f[1], b->f[1]);
    return two_at_most(two_vec3_dot(two_vec3_cross(m, n), along), two_all(0.0)) == 0;
}

/* Sum of the angles by which edges bend inward. */
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

/* Every vertex against every plane. */
static roberts_status check_pairs(const roberts_scene *scene, solid_frame *frame, roberts_error *error)
{
    for (uint32_t f = 0; f < frame->face_count; f++) {
        local_face *face = &frame->face[f];
        double outside = -least_distance(frame, face->F);
        if (outside <= frame->allowed)
            continue;
        if (outside > allowance(frame, face))
            return refuse_vertex(scene, frame, f, outermost(frame, face->F), error);
        frame->any_lean = face->lean = true;
    }
    return ROBERTS_OK;
}

/* Every plane against the tree of vertices. */
static roberts_status check_by_tree(const roberts_scene *scene, solid_frame *frame, roberts_error *error)
{
    roberts_status status = ROBERTS_OK;
    vertex_tree tree;
    if (!vertex_tree_build(&tree, frame->point, frame->vertex_count))
        return error_no_memory(error);
    for (uint32_t f = 0; f < frame->face_count && status == ROBERTS_OK; f++) {
        local_face *face = &frame->face[f];
        double bound = face->width > frame->allowed ? allowance(frame, face) : frame->allowed;
        uint32_t v = face->area > 0.0 ? vertex_tree_outermost(&tree, face->F, -bound) : ROBERTS_NONE;
        if (v == ROBERTS_NONE)
            continue;
        frame->any_lean = face->lean = true;
        if (-plane_at(face->F, frame->point[v]) > allowance(frame, face))
            status = refuse_vertex(scene, frame, f, v, error);
    }
    vertex_tree_free(&tree);
    return status;
}

/* The faces by themselves, then together. Four points cannot lie but convexly. */
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

/* Whether the ray from the barycentre passes through the face: it lies on or inside every plane through the barycentre
 * and a side. A side's two faces see exactly opposite signs. */
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

/* How many faces the barycentre sees in one direction: that of the middle of the widest face, well inside it. Only faces that
 * look that way are asked. */
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

/* Whether the faces cannot but cover each direction once. To cover them k times, a sphere's surface has to go round some two
 * vertices twice or more (2 k - 2 times too often in all, by Riemann and Hurwitz). Seen from the barycentre a face takes less
 * than a half turn round its corner, so that these two vertices have five edges at least, and all others three. */
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
