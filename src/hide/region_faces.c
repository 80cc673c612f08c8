/* region_faces.c - what regions take from their faces. See region_faces.h. */
#include "hide/region_faces.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/vec.h"
#include "hide/front.h"
#include "hide/tolerance.h"

/* ---- colours ----------------------------------------------------------------------------------------------------- */

/* The first piece of a face of the input, in the scene before the near plane cuts it; ROBERTS_NONE: there is none. */
static uint32_t source_face(const roberts_scene *source, uint32_t solid, uint32_t number)
{
    uint32_t low = source->solid[solid].face, end = source->solid[solid + 1].face, high = end;
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        if (scene_face_number(source, middle) < number)
            low = middle + 1;
        else
            high = middle;
    }
    return low < end && scene_face_number(source, low) == number ? low : ROBERTS_NONE;
}

/* The mean of the colours of the corners of a face's pieces; none if a corner has none, or only an index. */
static roberts_color corners_color(const roberts_scene *source, uint32_t solid, uint32_t face)
{
    const uint32_t number = scene_face_number(source, face), end = source->solid[solid + 1].face;
    double sum[4] = {0.0}, count = 0.0;
    unsigned char parts = 3;
    for (; face < end && scene_face_number(source, face) == number; face++)
        for (uint32_t k = source->face_start[face]; k < source->face_start[face + 1]; k++) {
            const roberts_color *own = &source->vertex_color[source->corner[k]];
            if (own->count < 3)
                return (roberts_color){0};
            parts = own->count > parts ? own->count : parts;
            for (int i = 0; i < 4; i++)
                sum[i] += i < own->count ? (double)own->value[i] : 1.0; /* without alpha it is opaque */
            count += 1.0;
        }
    roberts_color mean = {.count = parts};
    for (int i = 0; i < parts; i++)
        mean.value[i] = (float)(sum[i] / count);
    return mean;
}

roberts_color region_color(const hide_job *job, uint32_t piece)
{
    const roberts_scene *source = job->seen.source;
    const uint32_t number = scene_face_number(job->fronts.scene, piece);
    const roberts_color none = {0};
    if (number == ROBERTS_NONE || (!source->face_color && !source->vertex_color))
        return none;
    const uint32_t solid = scene_body_of_face(job->fronts.scene, piece);
    uint32_t face = source_face(source, solid, number);
    if (face == ROBERTS_NONE)
        return none;
    if (source->face_color && source->face_color[face].count > 0)
        return source->face_color[face];
    return source->vertex_color ? corners_color(source, solid, face) : none;
}

/* ---- neighbours in one plane ------------------------------------------------------------------------------------- */

/* The end of the pieces of the face that begins with `first`: of one in the input all pieces, whether or not they lie
 * in one plane. */
static uint32_t face_end(const roberts_scene *scene, uint32_t body, uint32_t first)
{
    const uint32_t number = scene_face_number(scene, first);
    uint32_t end = first + 1;
    if (number == ROBERTS_NONE)
        return scene_end_of_pieces(scene, body, first);
    while (end < scene->solid[body + 1].face && scene_face_number(scene, end) == number)
        end++;
    return end;
}

/* Whether the corners of a face, given by its first piece, lie in the plane of a piece of another, as far as both are
 * planar. */
static bool lies_in_plane_of(const hide_job *job, uint32_t face, uint32_t other)
{
    const roberts_scene *scene = job->fronts.scene;
    const uint32_t end = face_end(scene, scene_body_of_face(scene, face), face);
    const plane F = scene_plane(scene, other);
    for (uint32_t piece = face; piece < end; piece++) {
        const double far = scene_deviation(scene, piece) + scene_deviation(scene, other) +
                           REGION_TOUCHING * job->seen.view.epsilon * job->seen.view.unit;
        for (uint32_t k = scene->face_start[piece]; k < scene->face_start[piece + 1]; k++)
            if (fabs(plane_at(F, vec3_sub(scene->point[scene->corner[k]], scene->centre))) > far)
                return false;
    }
    return true;
}

static bool is_one_color(const roberts_color *a, const roberts_color *b)
{
    return a->count == b->count && !memcmp(a->value, b->value, a->count * sizeof *a->value);
}

bool region_can_join(const hide_job *job, uint32_t f, uint32_t g)
{
    const roberts_scene *scene = job->fronts.scene;
    if ((!job->merge_bodies && scene_body_of_face(scene, f) != scene_body_of_face(scene, g)) ||
        !lies_in_plane_of(job, f, g) || !lies_in_plane_of(job, g, f))
        return false;
    const roberts_color a = region_color(job, f);
    const roberts_color b = region_color(job, g);
    return is_one_color(&a, &b);
}

/* ---- directions -------------------------------------------------------------------------------------------------- */

/* The steepest line and the level line go through the foot: the point of the face's plane that is nearest to the middle
 * of the scene. So they depend on the plane alone, and strokes along them continue from face to face. */

/* Sine of the least angle from the horizontal at which a plane is steep anywhere. */
static const double least_slope = 1e-6;
/* In perspective, a foot is not used if it is behind the eye, or nearer to the eye than this fraction of the look-at
 * point's distance. */
static const double nearest_foot = 0.01;

/* Along the axes of the viewer. */
static roberts_vec3 to_viewer(const view *v, roberts_vec3 u)
{
    return (roberts_vec3){vec3_dot(u, v->right), vec3_dot(u, v->up), vec3_dot(u, v->dir)};
}

/* How far the eye is in front of P, as a fraction of its distance from the look-at point; 1 in the orthographic
 * view. */
static double weight(const view *v, roberts_vec3 P)
{
    return 1.0 - vec3_dot(v->dir, vec3_sub(P, v->origin)) * v->per_unit * v->inverse_distance;
}

/* The derivative by h of the picture of P + h u. p: the view point of P; w: the weight of P, by which p is divided. */
static roberts_vec2 moves(const view *v, roberts_vec3 p, double w, roberts_vec3 u)
{
    const roberts_vec3 q = to_viewer(v, u);
    const double toward = q.z * v->inverse_distance;
    return (roberts_vec2){(q.x - v->oblique.x * q.z + p.x * toward) / w, (q.y - v->oblique.y * q.z + p.y * toward) / w};
}

/* The steepest direction in a plane with unit normal n. In a level plane it is +y if +z is upright. */
static roberts_vec3 steepest(roberts_vec3 n, roberts_vec3 upright)
{
    const roberts_vec3 choices[] = {upright, {0, 1, 0}, {1, 0, 0}};
    roberts_vec3 best = {0, 0, 0};
    for (int i = 0; i < 3; i++) {
        const roberts_vec3 own = vec3_sub(choices[i], vec3_scale(vec3_dot(choices[i], n), n));
        const double length = vec3_length(own);
        if (length > least_slope)
            return vec3_scale(1.0 / length, own);
        best = own;
    }
    return best;
}

static int sign(double x)
{
    return (x > 0.0) - (x < 0.0);
}

roberts_vec3 slope_upright(const roberts_camera *camera)
{
    const roberts_vec3 up = {sign(camera->up.x), sign(camera->up.y), sign(camera->up.z)};
    const bool from_above = camera->dir.x == 0.0 && camera->dir.y == 0.0 && camera->dir.z != 0.0;
    const bool along_axis = vec3_sum(up) == 1.0;
    return along_axis && !from_above ? up : (roberts_vec3){0, 0, 1};
}

/* The unit normal of a face on the side that is seen, in the model. */
static roberts_vec3 seen_normal(const seen *s, uint32_t face, plane F)
{
    const roberts_vec3 inward = {F.a, F.b, F.c};
    return vec3_scale((s->facing[face] == VIEW_BACK ? 1.0 : -1.0) / vec3_length(inward), inward);
}

roberts_vec3 region_normal(const seen *s, uint32_t face, plane F)
{
    return to_viewer(&s->view, seen_normal(s, face, F));
}

roberts_slope slope_find(const seen *s, uint32_t face, plane F, roberts_vec3 upright)
{
    const view *v = &s->view;
    const roberts_vec3 inward = {F.a, F.b, F.c}, n = seen_normal(s, face, F);
    roberts_vec3 foot = vec3_add(s->scene->centre, vec3_scale(-F.d / vec3_dot(inward, inward), inward));
    double w = weight(v, foot);
    if (w < nearest_foot) {
        foot = s->scene->point[s->scene->corner[s->scene->face_start[face]]];
        w = weight(v, foot);
    }
    const roberts_vec3 steep = steepest(n, upright), p = view_point(v, foot);
    return (roberts_slope){.steep = moves(v, p, w, steep),
                           .level = moves(v, p, w, vec3_cross(steep, n)),
                           .foot = {p.x * v->unit, p.y * v->unit}};
}

/* ---- depths of faces of several pieces --------------------------------------------------------------------------- */

/* Adds the tree of pieces first .. end - 1. False: no memory. */
static bool add_tree(region_depths *d, uint32_t first, uint32_t end)
{
    box3 *box = alloc_array(end - first, sizeof *box);
    for (uint32_t f = first; box && f < end; f++) {
        const hide_box own = front_box_of_face(d->fronts, f);
        box[f - first] = (box3){{(double)own.x0 - d->touching, (double)own.y0 - d->touching, 0.0},
                                {(double)own.x1 + d->touching, (double)own.y1 + d->touching, 0.0}};
    }
    bool enough = box && box_tree_add(&d->tree, box, end - first, first, &d->root[first]);
    free(box);
    return enough;
}

bool region_depths_build(region_depths *d, const hide_fronts *fronts, double touching)
{
    const roberts_scene *scene = fronts->scene;
    *d = (region_depths){.fronts = fronts, .touching = touching};
    for (uint32_t body = 0; scene->face_number && body < scene->solid_count; body++) {
        const uint32_t all = scene->solid[body + 1].face;
        for (uint32_t f = scene->solid[body].face, end; !fronts->culled[body] && f < all; f = end) {
            end = face_end(scene, body, f);
            if (end - f < 2)
                continue;
            if (!d->root) {
                d->root = alloc_array(scene->face_count, sizeof *d->root);
                for (uint32_t k = 0; d->root && k < scene->face_count; k++)
                    d->root[k] = ROBERTS_NONE;
            }
            if (!d->root || !add_tree(d, f, end))
                return false;
        }
    }
    return true;
}

void region_depths_free(region_depths *d)
{
    box_tree_free(&d->tree);
    free(d->root);
    *d = (region_depths){0};
}

double region_depth_at(const hide_fronts *fronts, const uint32_t *corner, uint32_t count, plane F, roberts_vec2 at)
{
    const double z = (F.a * at.x + F.b * at.y + F.d) / -F.c;
    double low = INFINITY, high = -INFINITY;
    for (uint32_t k = 0; k < count; k++) {
        low = lesser(low, fronts->P[corner[k]].z);
        high = greater(high, fronts->P[corner[k]].z);
    }
    return z < low ? low : z > high ? high : z;
}

static roberts_vec2 side_point(const roberts_vec2 side[2], double t)
{
    return (roberts_vec2){side[0].x + t * (side[1].x - side[0].x), side[0].y + t * (side[1].y - side[0].y)};
}

/* Finds the part of a side within `touching` of a piece. False: there is none. */
static bool cut_side(const region_depths *d, const roberts_vec2 side[2], uint32_t piece, depth_part *part)
{
    const hide_fronts *fronts = d->fronts;
    uint32_t turned[SEEN_TURNED], count;
    *part = (depth_part){.t0 = 0.0, .t1 = 1.0};
    if (fronts->seen->facing[piece] == VIEW_EDGE_ON)
        return false;
    const uint32_t *corner = seen_corners(fronts->seen, piece, &count, turned);
    for (uint32_t k = 0; k < count; k++) {
        const roberts_vec3 C = fronts->P[corner[k]], D = fronts->P[corner[k + 1 < count ? k + 1 : 0]];
        const double x = D.x - C.x, y = D.y - C.y, more = d->touching * (fabs(x) + fabs(y)); /* than `far` */
        double p = x * (side[0].y - C.y) - y * (side[0].x - C.x), q = x * (side[1].y - C.y) - y * (side[1].x - C.x);
        if (p < -more && q < -more)
            return false;
        if (p >= 0.0 && q >= 0.0)
            continue;
        const double far = d->touching * hypot(x, y);
        p += far;
        q += far;
        if (p < 0.0 && q < 0.0)
            return false;
        if (p < 0.0)
            part->t0 = greater(part->t0, p / (p - q));
        if (q < 0.0)
            part->t1 = lesser(part->t1, p / (p - q));
    }
    if (part->t0 > part->t1)
        return false;
    seen_face look;
    seen_face_again(fronts->seen, piece, &look, turned);
    part->z0 = region_depth_at(fronts, look.corner, look.count, look.F, side_point(side, part->t0));
    part->z1 = region_depth_at(fronts, look.corner, look.count, look.F, side_point(side, part->t1));
    return true;
}

static int compare_parts(const void *pa, const void *pb)
{
    const depth_part *a = pa, *b = pb;
    return (a->t0 > b->t0) - (a->t0 < b->t0);
}

static double part_depth(const depth_part *part, double t)
{
    return t < part->t1 ? part->z0 + (t - part->t0) / (part->t1 - part->t0) * (part->z1 - part->z0) : part->z1;
}

/* Is part a nearer the viewer than part b, both of which continue after t? */
static bool is_nearer(const depth_part *a, const depth_part *b, double t)
{
    const double middle = 0.5 * (t + lesser(a->t1, b->t1));
    return part_depth(a, middle) > part_depth(b, middle);
}

/* Goes along a side from part to part. A face that is not planar may lie before itself: then its nearest part is seen.
 * Another begins only where the seen one ends, since folds bound cells. slack: parts end within it of where they
 * should, as a fraction of the side. */
static void follow(const depth_parts *parts, double slack, depth_range *range)
{
    size_t first = 0;
    for (double t = 0.0; t + slack < 1.0;) {
        const depth_part *shown = NULL;
        double next = 1.0; /* where the next part begins */
        while (first < parts->count && parts->part[first].t1 <= t + slack)
            first++;
        for (size_t i = first; i < parts->count; i++) {
            const depth_part *p = &parts->part[i];
            if (p->t0 > t + slack) {
                next = p->t0;
                break;
            }
            if (p->t1 > t + slack && (!shown || is_nearer(p, shown, t)))
                shown = p;
        }
        if (shown) {
            const double z = part_depth(shown, greater(t, shown->t0));
            range->low = lesser(range->low, lesser(z, shown->z1));
            range->high = greater(range->high, greater(z, shown->z1));
        }
        t = shown ? shown->t1 : next;
    }
}

bool region_depths_along(const region_depths *d, uint32_t first, const roberts_vec2 side[2], depth_parts *parts,
                         depth_range *range)
{
    const roberts_vec2 P = side[0], Q = side[1];
    const box3 box = {{lesser(P.x, Q.x), lesser(P.y, Q.y), 0.0}, {greater(P.x, Q.x), greater(P.y, Q.y), 0.0}};
    const double length = hypot(Q.x - P.x, Q.y - P.y);
    box_search near = box_search_begin(&d->tree, d->root[first], &box);
    parts->count = 0;
    for (uint32_t piece; box_search_next(&near, &piece);) {
        if (!array_reserve(&parts->part, &parts->room, parts->count + 1, sizeof *parts->part))
            return false;
        parts->count += cut_side(d, side, piece, &parts->part[parts->count]);
    }
    if (parts->count > 1)
        qsort(parts->part, parts->count, sizeof *parts->part, compare_parts);
    follow(parts, 2.0 * d->touching / length, range);
    return true;
}
