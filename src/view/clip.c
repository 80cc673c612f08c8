/* clip.c - clipping by the near plane. See clip.h. Each face is clipped separately (I. E. Sutherland, G. W. Hodgman,
 * "Reentrant polygon clipping", CACM 17(1), 1974). The cuts of a solid's faces form the outline of its cap. */
#include "view/clip.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/dd.h"
#include "base/error.h"
#include "model/face_plane.h"
#include "view/cutter.h"

/* The default distance of the near plane: this fraction of the look-at point's distance, and at least this fraction of
 * the scene's diameter. Nearer things would appear a thousand times as large as at the look-at point. */
#define NEAR_OF_DISTANCE 1e-3
#define NEAR_OF_DIAMETER 1e-5
/* The least distance of the near plane, even if a smaller one is given, as a fraction of the scene's diameter.
 * Coordinates in the picture grow in inverse proportion to it, and so does the touching distance. */
#define NEAR_LEAST 1e-6
/* In ulps of the largest coordinate, the eye's included. A point nearer to the near plane than this lies in it; an eye
 * nearer to a face than this lies on it. */
#define TOUCHING_ULPS 16.0

bool cutter_add_vertex(cutter *c, roberts_vec3 point, roberts_vec3 low, uint32_t number)
{
    roberts_scene *to = &c->clip->scene;
    size_t need = (size_t)to->vertex_count + 1;
    if (!array_reserve(&to->point, &c->vertex_room, need, sizeof *to->point) ||
        !array_reserve(&to->low, &c->low_room, need, sizeof *to->low) ||
        !array_reserve(&to->number, &c->number_room, need, sizeof *to->number))
        return false;
    to->point[to->vertex_count] = point;
    to->low[to->vertex_count] = low;
    to->number[to->vertex_count++] = number;
    return true;
}

bool cutter_add_corner(cutter *c, uint32_t vertex)
{
    roberts_scene *to = &c->clip->scene;
    if (!array_reserve(&to->corner, &c->corner_room, to->corner_count + 1, sizeof *to->corner))
        return false;
    to->corner[to->corner_count++] = vertex;
    return true;
}

bool cutter_add_face(cutter *c, plane F, double deviation, double width, uint32_t number)
{
    roberts_scene *to = &c->clip->scene;
    size_t f = to->face_count, need = f + 1;
    if (to->corner_count > UINT32_MAX ||
        !array_reserve(&to->face_start, &c->start_room, need + 1, sizeof *to->face_start) ||
        !array_reserve(&to->face_plane, &c->plane_room, need, sizeof *to->face_plane) ||
        !array_reserve(&to->face_deviation, &c->deviation_room, need, sizeof *to->face_deviation) ||
        !array_reserve(&to->face_width, &c->width_room, need, sizeof *to->face_width) ||
        !array_reserve(&to->face_number, &c->face_room, need, sizeof *to->face_number))
        return false;
    if (scene_has_bent_faces(c->from)) {
        if (!array_reserve(&to->surface->whole, &c->whole_room, need, sizeof *to->surface->whole))
            return false;
        to->surface->whole[f] = F;
    }
    to->face_plane[f] = F;
    scene_set_bounds(to, (uint32_t)f, deviation, width);
    to->face_number[f] = number;
    to->face_start[++to->face_count] = (uint32_t)to->corner_count;
    return true;
}

bool cutter_add_edge(cutter *c, uint32_t v0, uint32_t v1, uint32_t f0, uint32_t f1, bool cap)
{
    roberts_scene *to = &c->clip->scene;
    size_t need = (size_t)to->edge_count + 1;
    if (!array_reserve(&to->edge, &c->edge_room, need, sizeof *to->edge) ||
        !array_reserve(&c->clip->cap, &c->cap_room, need, sizeof *c->clip->cap))
        return false;
    c->clip->cap[to->edge_count] = cap;
    to->edge[to->edge_count++] =
        (scene_edge){{v0 - c->first.vertex, v1 - c->first.vertex}, {f0 - c->first.face, f1 - c->first.face}};
    return true;
}

/* Returns the edge of the solid between two of its vertices. Edges ascend by (v[0], v[1]). */
static uint32_t find_edge_between(const cutter *c, uint32_t solid, uint32_t a, uint32_t b)
{
    uint32_t low = c->from->solid[solid].edge, high = c->from->solid[solid + 1].edge;
    uint32_t v0 = a < b ? a : b, v1 = a < b ? b : a;
    while (high - low > 1) {
        uint32_t middle = low + (high - low) / 2;
        const scene_edge e = scene_edge_at(c->from, solid, middle);
        if (e.v[0] < v0 || (e.v[0] == v0 && e.v[1] <= v1))
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Returns a + t (b - a). The rounding error of a double is a wide angle near the eye; `low` receives that error. */
static double divide(double a, double b, double t, double *low)
{
    dd p = dd_add((dd){a, 0.0}, dd_mul((dd){t, 0.0}, dd_two_diff(b, a)));
    *low = p.lo;
    return p.hi;
}

bool cutter_add_cut(cutter *c, roberts_vec3 A, roberts_vec3 B, double t)
{
    roberts_vec3 low, point = {divide(A.x, B.x, t, &low.x), divide(A.y, B.y, t, &low.y), divide(A.z, B.z, t, &low.z)};
    return cutter_add_vertex(c, point, low, ROBERTS_NONE);
}

/* Adds the vertices that are kept, and a new vertex on each edge that the plane cuts. False: no memory. */
static bool cut_vertices(cutter *c, uint32_t solid)
{
    const roberts_scene *from = c->from;
    for (uint32_t v = from->solid[solid].vertex; v < from->solid[solid + 1].vertex; v++) {
        c->vertex[v] = cutter_keeps(c, v) ? c->clip->scene.vertex_count : ROBERTS_NONE;
        if (cutter_keeps(c, v) &&
            !cutter_add_vertex(c, from->point[v], (roberts_vec3){0.0, 0.0, 0.0}, scene_vertex_number(from, v)))
            return false;
    }
    for (uint32_t i = from->solid[solid].edge; i < from->solid[solid + 1].edge; i++) {
        const scene_edge edge = scene_edge_at(from, solid, i);
        uint32_t a = edge.v[0], b = edge.v[1];
        clip_edge *origin = &c->clip->origin[i];
        *origin = (clip_edge){ROBERTS_NONE, 0.0, 1.0};
        c->cut[i] = ROBERTS_NONE;
        if (cutter_keeps(c, a) == cutter_keeps(c, b))
            continue;
        double t = (c->near - c->depth[a]) / (c->depth[b] - c->depth[a]);
        c->cut[i] = c->clip->scene.vertex_count;
        if (cutter_keeps(c, a))
            origin->t1 = t;
        else
            origin->t0 = t;
        if (!cutter_add_cut(c, from->point[a], from->point[b], t))
            return false;
    }
    return true;
}

/* Measures the width of the last face of the clipped scene, whose corners begin at `first`. */
static bool cutter_measure_width(cutter *c, uint32_t first, double *width)
{
    const roberts_scene *to = &c->clip->scene;
    size_t count = to->corner_count - first;
    double scale = 0.0;
    if (!array_reserve(&c->ring, &c->ring_room, count, sizeof *c->ring))
        return false;
    for (size_t k = 0; k < count; k++) {
        c->ring[k] = vec3_sub(to->point[to->corner[first + k]], to->point[to->corner[first]]);
        scale = greater(scale, vec3_largest(c->ring[k]));
    }
    *width = 0.0;
    if (count < 3 || scale == 0.0)
        return true;
    for (size_t k = 0; k < count; k++)
        c->ring[k] = (roberts_vec3){c->ring[k].x / scale, c->ring[k].y / scale, c->ring[k].z / scale};
    *width = face_plane_fit(c->ring, (uint32_t)count).width * scale;
    return true;
}

/* Clips one face. The cap runs along the cut in the opposite direction. If a side is straight only within the
 * tolerance, the border may weave through the plane. Then each entry is joined to the exit before it. False: no
 * memory. */
static bool cut_face(cutter *c, uint32_t solid, uint32_t face, uint32_t *to_face)
{
    const roberts_scene *from = c->from;
    uint32_t first = from->face_start[face], end = from->face_start[face + 1], leave = ROBERTS_NONE;
    uint32_t early = ROBERTS_NONE, begin = (uint32_t)c->clip->scene.corner_count; /* an entry before any exit */
    double width = scene_width(from, face);
    for (uint32_t k = first; k < end; k++) {
        uint32_t a = from->corner[k], b = from->corner[k + 1 < end ? k + 1 : first];
        if (cutter_keeps(c, a) && !cutter_add_corner(c, c->vertex[a]))
            return false;
        if (cutter_keeps(c, a) == cutter_keeps(c, b))
            continue;
        uint32_t edge = find_edge_between(c, solid, a, b);
        if (cutter_keeps(c, a))
            leave = edge;
        else if (leave != ROBERTS_NONE)
            c->next[edge] = leave;
        else
            early = edge;
        if (!cutter_add_corner(c, c->cut[edge]))
            return false;
    }
    *to_face = ROBERTS_NONE;
    if (c->clip->scene.corner_count == begin)
        return true;
    if (early != ROBERTS_NONE)
        c->next[early] = leave;
    if (leave != ROBERTS_NONE && !cutter_measure_width(c, begin, &width))
        return false;
    *to_face = c->clip->scene.face_count;
    return cutter_add_face(c, scene_plane(from, face), scene_deviation(from, face), width,
                           scene_face_number(from, face));
}

/* Adds the cap. `start` is one of the cut edges. If a border weaves through the plane, there are several rings, and the
 * cap has one of them. Then the outline is not a single cycle, and the faces hide one by one (see hide/front.c). False:
 * no memory. */
static bool add_cap(cutter *c, uint32_t start)
{
    const roberts_scene *from = c->from;
    uint32_t begin = (uint32_t)c->clip->scene.corner_count, e = start;
    plane F = {-c->dir.x, -c->dir.y, -c->dir.z, 0.0}; /* inward: away from the eye */
    double width;
    do {
        if (!cutter_add_corner(c, c->cut[e]))
            return false;
        e = c->next[e];
    } while (e != start);
    F.d = vec3_dot(c->dir, vec3_sub(c->eye, from->centre)) - c->near;
    return cutter_measure_width(c, begin, &width) && cutter_add_face(c, F, c->touching, width, ROBERTS_NONE);
}

/* Adds the edges that are kept, completely or in part, in order, followed by those of the cap. map: numbers of the
 * faces in the clipped scene. False: no memory. */
static bool cut_edges(cutter *c, uint32_t solid, const uint32_t *map, uint32_t cap)
{
    const roberts_scene *from = c->from;
    uint32_t first = from->solid[solid].edge, end = from->solid[solid + 1].edge;
    for (uint32_t i = first; i < end; i++) {
        const scene_edge edge = scene_edge_at(from, solid, i);
        uint32_t v[2];
        for (int k = 0; k < 2; k++)
            v[k] = cutter_keeps(c, edge.v[k]) ? c->vertex[edge.v[k]] : c->cut[i];
        if (v[0] == ROBERTS_NONE || v[1] == ROBERTS_NONE)
            continue;
        c->clip->origin[i].edge = c->clip->scene.edge_count;
        if (!cutter_add_edge(c, v[0], v[1], map[edge.f[0]], map[edge.f[1]], false))
            return false;
    }
    for (uint32_t i = first; i < end && cap != ROBERTS_NONE; i++) {
        if (c->cut[i] == ROBERTS_NONE)
            continue;
        /* between cut i and the next, the cap meets the face into which edge i leads: v[0] -> v[1] runs round f[0] */
        const scene_edge edge = scene_edge_at(from, solid, i);
        uint32_t face = edge.f[cutter_keeps(c, edge.v[1]) ? 0 : 1];
        if (!cutter_add_edge(c, c->cut[i], c->cut[c->next[i]], cap, map[face], true))
            return false;
    }
    return true;
}

/* Is the eye inside a solid? An eye on a face, within rounding, is outside. The face's departure from its plane does
 * not matter. */
static bool holds_eye(const cutter *c, uint32_t solid)
{
    roberts_vec3 P = vec3_sub(c->eye, c->from->centre);
    for (uint32_t f = c->from->solid[solid].face; f < c->from->solid[solid + 1].face; f++)
        if (!(plane_at(scene_plane(c->from, f), P) > c->touching))
            return false;
    return true;
}

/* Clips one solid. `map` is scratch, [face_count of from]. */
static roberts_status cut_solid(cutter *c, uint32_t solid, uint32_t *map, roberts_error *error)
{
    if (!scene_is_convex(c->from, solid))
        return cutter_cut_surface(c, solid, map) ? ROBERTS_OK : error_no_memory(error);
    const roberts_scene *from = c->from;
    roberts_scene *to = &c->clip->scene;
    uint32_t start = ROBERTS_NONE, cap = ROBERTS_NONE;
    c->first = (scene_solid){to->vertex_count, to->face_count, to->edge_count, to->edge_count};
    to->solid[solid] = c->first;
    if (holds_eye(c, solid))
        return error_set(error, ROBERTS_BAD_VIEW, 0, "the eye is inside solid %u; move it out of all solids",
                         (unsigned)solid);
    c->whole = true;
    for (uint32_t v = from->solid[solid].vertex; v < from->solid[solid + 1].vertex; v++)
        c->whole = c->whole && c->depth[v] >= c->near;
    if (!cut_vertices(c, solid))
        return error_no_memory(error);
    for (uint32_t f = from->solid[solid].face; f < from->solid[solid + 1].face; f++)
        if (!cut_face(c, solid, f, &map[f]))
            return error_no_memory(error);
    for (uint32_t i = from->solid[solid].edge; i < from->solid[solid + 1].edge && start == ROBERTS_NONE; i++)
        start = c->cut[i] != ROBERTS_NONE ? i : ROBERTS_NONE;
    if (start != ROBERTS_NONE) {
        cap = to->face_count;
        if (!add_cap(c, start))
            return error_no_memory(error);
    }
    return cut_edges(c, solid, map, cap) ? ROBERTS_OK : error_no_memory(error);
}

/* Returns the distance of a point from the eye's plane. A point within the touching distance of the near plane counts
 * as on it. */
static double distance_from_eye_plane(const cutter *c, roberts_vec3 P)
{
    double depth = vec3_dot(c->dir, vec3_sub(c->eye, P));
    return fabs(depth - c->near) <= c->touching ? c->near : depth;
}

/* Measures distances from the eye's plane, and returns the least. */
static double measure_depths(cutter *c)
{
    double least = INFINITY;
    for (uint32_t v = 0; v < c->from->vertex_count; v++) {
        c->depth[v] = distance_from_eye_plane(c, c->from->point[v]);
        least = lesser(least, c->depth[v]);
    }
    return least;
}

/* Allocates the arrays that are read even if they stay empty. False: no memory. */
static bool begin_arrays(cutter *c)
{
    roberts_scene *to = &c->clip->scene;
    if (!(to->solid = alloc_array((size_t)c->from->solid_count + 1, sizeof *to->solid)) ||
        !array_reserve(&to->face_start, &c->start_room, 1, sizeof *to->face_start) ||
        !array_reserve(&to->face_plane, &c->plane_room, 1, sizeof *to->face_plane) ||
        !array_reserve(&to->corner, &c->corner_room, 1, sizeof *to->corner) ||
        !array_reserve(&to->edge, &c->edge_room, 1, sizeof *to->edge))
        return false;
    to->face_start[0] = 0;
    return true;
}

static roberts_status cut_solids(cutter *c, roberts_error *error)
{
    const roberts_scene *from = c->from;
    roberts_scene *to = &c->clip->scene;
    roberts_status status = ROBERTS_OK;
    uint32_t *map = alloc_array(from->face_count, sizeof *map);
    to->solid_count = from->solid_count;
    to->box_min = from->box_min;
    to->box_max = from->box_max;
    to->centre = from->centre;
    to->unit = from->unit;
    to->float32_step = from->float32_step;
    if (!map || !begin_arrays(c) || (from->surface && !cutter_begin_surface(c))) {
        free(map);
        return error_no_memory(error);
    }
    for (uint32_t s = 0; status == ROBERTS_OK && s < from->solid_count; s++)
        status = cut_solid(c, s, map, error);
    to->solid[to->solid_count] = (scene_solid){to->vertex_count, to->face_count, to->edge_count, to->edge_count};
    if (status == ROBERTS_OK && to->vertex_count == 0)
        status =
            error_set(error, ROBERTS_BAD_VIEW, 0,
                      "nothing of the scene lies in front of the eye, beyond the near plane at a distance of %.6g; "
                      "move the eye, the look-at point or the near plane",
                      c->near);
    free(map);
    return status;
}

static void set_touching(cutter *c)
{
    const roberts_vec3 corners[] = {c->from->box_min, c->from->box_max, c->eye};
    for (size_t i = 0; i < sizeof corners / sizeof corners[0]; i++)
        c->touching = greater(c->touching, vec3_largest(corners[i]));
    c->touching *= TOUCHING_ULPS * DBL_EPSILON;
}

/* Sets the line of sight and the near plane. False: the camera is invalid; view_prepare() will refuse it. */
static bool set_near(cutter *c, const roberts_camera *camera)
{
    roberts_vec3 centre = c->from->centre, back = vec3_sub(camera->eye, camera->has_look_at ? camera->look_at : centre);
    double largest = vec3_largest(back);
    double diameter = vec3_length(vec3_sub(c->from->box_max, c->from->box_min));
    if (!isfinite(back.x) || !isfinite(back.y) || !isfinite(back.z) || !(largest > 0.0) ||
        !isfinite(camera->near_distance))
        return false;
    back = (roberts_vec3){back.x / largest, back.y / largest, back.z / largest};
    c->eye = camera->eye;
    c->dir = vec3_scale(1.0 / vec3_length(back), back);
    c->near = camera->near_distance;
    if (c->near <= 0.0)
        c->near = fmax(NEAR_OF_DISTANCE * vec3_length(back) * largest, NEAR_OF_DIAMETER * diameter);
    set_touching(c);
    c->near = fmax(c->near, NEAR_LEAST * diameter + c->touching);
    return true;
}

bool view_is_cut(const roberts_scene *scene, const roberts_camera *camera, const roberts_vec3 *P, size_t count)
{
    cutter c = {.from = scene};
    bool cut = false;
    if (camera->projection != ROBERTS_PERSPECTIVE || !set_near(&c, camera))
        return false;
    for (size_t i = 0; i < count && !cut; i++)
        cut = distance_from_eye_plane(&c, P[i]) < c.near;
    return cut;
}

roberts_status view_clip_scene(view_clip *clip, const roberts_scene *scene, const roberts_camera *camera,
                               roberts_error *error)
{
    roberts_status status = ROBERTS_NO_MEMORY;
    cutter c = {.clip = clip, .from = scene};
    *clip = (view_clip){0};
    if (camera->projection != ROBERTS_PERSPECTIVE || !set_near(&c, camera))
        return ROBERTS_OK;
    c.depth = alloc_array(scene->vertex_count, sizeof *c.depth);
    if (!c.depth)
        return error_no_memory(error);
    if (measure_depths(&c) >= c.near) {
        free(c.depth);
        return ROBERTS_OK;
    }
    clip->clipped = true;
    clip->pieces = scene->surface && scene->surface->plane_of;
    clip->origin = alloc_array(scene->edge_count, sizeof *clip->origin);
    c.vertex = alloc_array(scene->vertex_count, sizeof *c.vertex);
    c.cut = alloc_array(scene->edge_count, sizeof *c.cut);
    c.next = alloc_array(scene->edge_count, sizeof *c.next);
    if (clip->origin && c.vertex && c.cut && c.next)
        status = cut_solids(&c, error);
    else
        error_no_memory(error);
    free(c.depth);
    free(c.vertex);
    free(c.cut);
    free(c.next);
    free(c.ring);
    free(c.side);
    if (status != ROBERTS_OK)
        view_clip_free(clip);
    return status;
}

void view_clip_free(view_clip *clip)
{
    free(clip->scene.solid);
    free(clip->scene.point);
    free(clip->scene.low);
    free(clip->scene.number);
    free(clip->scene.face_start);
    free(clip->scene.corner);
    free(clip->scene.face_plane);
    free(clip->scene.face_deviation);
    free(clip->scene.face_width);
    free(clip->scene.face_number);
    free(clip->scene.edge);
    scene_surface_free(clip->scene.surface);
    free(clip->origin);
    free(clip->cap);
    *clip = (view_clip){0};
}
