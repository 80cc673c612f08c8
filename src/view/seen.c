/* seen.c - a scene as one camera sees it. See seen.h. */
#include "view/seen.h"

#include <math.h>
#include <stdlib.h>

#include "base/angle.h"
#include "base/array.h"

/* Degrees: the crease angle of bodies that count as curved. */
#define SMOOTH_CREASE 30.0

roberts_status seen_begin(seen *s, const roberts_scene *scene, const roberts_camera *camera, double epsilon,
                          roberts_error *error)
{
    *s = (seen){.source = scene, .scene = scene};
    roberts_status status = view_clip_scene(&s->clip, scene, camera, epsilon, error);
    if (status != ROBERTS_OK)
        return status;
    if (s->clip.clipped)
        s->scene = &s->clip.scene;
    status = view_prepare(&s->view, s->scene, camera, epsilon, error);
    if (status != ROBERTS_OK)
        seen_end(s);
    return status;
}

bool seen_begin_points(seen *s)
{
    s->P = alloc_array(s->scene->vertex_count, sizeof *s->P);
    s->facing = alloc_zeroed(s->scene->face_count, sizeof *s->facing);
    if (s->scene->surface)
        s->turned = alloc_sparse(s->scene->face_start[s->scene->face_count], sizeof *s->turned);
    return s->P && s->facing && (s->turned || !s->scene->surface);
}

void seen_map_cuts(seen *s, uint32_t first, uint32_t end)
{
    const double touching = s->view.epsilon * s->view.unit;
    for (uint32_t v = first; v < end; v++)
        if (scene_vertex_number(s->scene, v) == ROBERTS_NONE &&
            fabs(view_clip_depth(&s->clip, s->scene->point[v]) - s->clip.near) <= touching)
            s->P[v] = view_point_at(&s->view, s->scene->point[v], s->clip.near);
}

void seen_end(seen *s)
{
    free(s->P);
    free(s->facing);
    free(s->turned);
    free(s->sight);
    united_free(&s->edges);
    union_free(&s->bodies);
    view_clip_free(&s->clip);
    *s = (seen){0};
}

/* Returns the squared distance of two unit normals at this angle, and a little more, so that rounding does not decide:
 * an edge that bends by exactly the crease angle is left out, if that is not 0. */
static double square_chord(double degrees)
{
    double chord = 2.0 * angle_unit(degrees / 2.0).y;
    return chord * chord * (1.0 + 0x1p-40);
}

void seen_set_rules(seen *s, const roberts_hide_options *options)
{
    double chord = square_chord(options->crease_degrees);
    s->rules = (seen_rules){
        .crease_chord = chord, .smooth_chord = chord, .all_edges = options->all_edges, .hidden = options->keep_hidden};
    if (options->crease_auto)
        s->rules.smooth_chord = greater(chord, square_chord(SMOOTH_CREASE));
}

typedef struct walked {
    const seen *seen;
    const unsigned char *culled;
} walked;

/* Will a walk visit the edge? Not if its body is culled, and not if its own convex body hides it and hidden lines are
 * not wanted. */
static bool is_walked(const void *context, uint32_t body, uint32_t edge)
{
    const walked *w = context;
    const seen *s = w->seen;
    if (s->rules.hidden)
        return true;
    if (s->clip.clipped || !scene_is_convex(s->scene, body))
        return !w->culled[body];
    return !w->culled[body] &&
           seen_fronts(s->facing + s->scene->solid[body].face, scene_edge_stored(s->scene, body, edge));
}

bool seen_unite(seen *s, const unsigned char *culled, uint32_t threads)
{
    const walked w = {s, culled};
    if (!union_prepare(&s->bodies, s->source, s->scene, s->view.epsilon * s->view.unit))
        return false;
    if (s->clip.clipped && !union_set_near(&s->bodies, view_clip_plane(&s->clip, s->source->centre)))
        return false;
    return united_find_edges(&s->edges, &s->bodies, is_walked, &w, threads);
}

scene_shape seen_face_again(const seen *s, uint32_t face, seen_face *out, uint32_t turned[SEEN_TURNED])
{
    scene_shape shape = scene_shape_of(s->scene, face);
    out->F = view_plane_of(&s->view, s->scene->centre, shape.F, &out->stretch);
    out->corner = seen_corners(s, face, &out->count, turned);
    if (s->facing[face] == VIEW_BACK)
        out->F = (plane){-out->F.a, -out->F.b, -out->F.c, -out->F.d};
    return shape;
}

int seen_any_face(seen *s, uint32_t face)
{
    const roberts_scene *scene = s->scene;
    uint32_t first = scene->face_start[face], end = scene->face_start[face + 1];
    int facing = view_facing(&s->view, scene, face, view_plane(&s->view, scene, face, NULL), s->P);
    s->facing[face] = (unsigned char)facing;
    for (uint32_t i = 0; facing == VIEW_BACK && end - first > SEEN_TURNED && i < end - first; i++)
        s->turned[first + i] = scene->corner[end - 1 - i];
    return facing;
}
