/* front.c - see front.h. */
#include "hide/front.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/error.h"
#include "base/radix.h"

/* x as a float that is not greater (not smaller) than it. */
static float float_below(double x)
{
    float f = (float)x;
    return (double)f > x ? nextafterf(f, -INFINITY) : f;
}

static float float_above(double x)
{
    float f = (float)x;
    return (double)f < x ? nextafterf(f, INFINITY) : f;
}

static void set_box(hide_face *f, const roberts_vec3 *P)
{
    double x0 = INFINITY, x1 = -INFINITY, y0 = INFINITY, y1 = -INFINITY, z1 = -INFINITY;
    for (uint32_t k = 0; k < f->count; k++) {
        roberts_vec3 p = P[f->corner[k]];
        x0 = fmin(x0, p.x);
        x1 = fmax(x1, p.x);
        y0 = fmin(y0, p.y);
        y1 = fmax(y1, p.y);
        z1 = fmax(z1, p.z);
    }
    f->x0 = float_below(x0);
    f->x1 = float_above(x1);
    f->y0 = float_below(y0);
    f->y1 = float_above(y1);
    f->z1 = float_above(z1);
}

/* How far a distance from the face's plane can be trusted: `touch` near the face, `limit` anywhere in the scene. The
 * plane of a face of width w is known to about its rounding (and the face's own departure from it) at the face, and
 * to that times r / w at a distance r. */
static void set_trust(const hide_front *front, const roberts_scene *scene, double stretch, hide_face *f)
{
    const view *v = &front->view;
    double grown = v->perspective ? 1.0 + (double)f->z1 * v->inverse_distance : 1.0; /* D / w at the nearest corner */
    double departure = scene->face_deviation[f->face] / v->unit * stretch * grown;
    double width = scene->face_width[f->face] / v->unit * fmin(1.0, grown * grown);
    double far_error = (4.0 * v->rounding + departure) * (1.0 + 2.0 * fmax(v->extent, v->diameter) / width);
    f->touch = v->epsilon + departure;
    f->limit = far_error > 0.5 * f->touch ? f->touch - far_error : f->touch;
}

static void add_face(hide_front *front, const roberts_scene *scene, uint32_t solid, uint32_t face, plane F,
                     double stretch)
{
    hide_face *f = &front->face[front->count++];
    *f = (hide_face){.F = F,
                     .corner = scene->corner + scene->face_start[face],
                     .count = scene->face_start[face + 1] - scene->face_start[face],
                     .solid = solid,
                     .face = face};
    set_box(f, front->P);
    set_trust(front, scene, stretch, f);
    if (f->count > front->most_corners)
        front->most_corners = f->count;
}

static void map_points(hide_front *front, const roberts_scene *scene)
{
    front->low = (roberts_vec2){INFINITY, INFINITY};
    front->high = (roberts_vec2){-INFINITY, -INFINITY};
    for (uint32_t i = 0; i < scene->vertex_count; i++) {
        roberts_vec3 p = front->P[i] = view_point(&front->view, scene->point[i]);
        front->low = (roberts_vec2){fmin(front->low.x, p.x), fmin(front->low.y, p.y)};
        front->high = (roberts_vec2){fmax(front->high.x, p.x), fmax(front->high.y, p.y)};
    }
}

static void sort_faces(hide_front *front, const roberts_scene *scene)
{
    for (uint32_t s = 0; s < scene->solid_count; s++) {
        for (uint32_t face = scene->solid[s].face; face < scene->solid[s + 1].face; face++) {
            double stretch;
            plane F = view_plane(&front->view, scene, face, &stretch);
            front->facing[face] = (unsigned char)view_facing(&front->view, scene, face, F, front->P);
            if (front->facing[face] == VIEW_FRONT)
                add_face(front, scene, s, face, F, stretch);
            front->back += front->facing[face] == VIEW_BACK;
            front->edge_on += front->facing[face] == VIEW_EDGE_ON;
        }
    }
}

/* Nearest corner first, ties by number. */
static bool order_faces(hide_front *front)
{
    uint32_t *key = alloc_array(front->count, sizeof *key);
    bool done = false;
    if (key) {
        for (uint32_t i = 0; i < front->count; i++)
            key[i] = radix_key_descending(front->face[i].z1);
        done = radix_order(key, front->count, front->order);
    }
    free(key);
    return done;
}

roberts_status hide_front_build(hide_front *front, const roberts_scene *scene, const roberts_camera *camera,
                                double epsilon, roberts_error *error)
{
    *front = (hide_front){0};
    roberts_status status = view_prepare(&front->view, scene, camera, epsilon, error);
    if (status != ROBERTS_OK)
        return status;
    front->P = alloc_array(scene->vertex_count, sizeof *front->P);
    front->facing = alloc_array(scene->face_count, sizeof *front->facing);
    front->face = alloc_array(scene->face_count, sizeof *front->face);
    front->order = alloc_array(scene->face_count, sizeof *front->order);
    if (!front->P || !front->facing || !front->face || !front->order)
        goto no_memory;
    map_points(front, scene);
    sort_faces(front, scene);
    if (!order_faces(front))
        goto no_memory;
    front->space = (hide_space){front->P, front->view.epsilon, front->view.rounding, scene, &front->view};
    return ROBERTS_OK;
no_memory:
    hide_front_free(front);
    return error_no_memory(error);
}

void hide_front_free(hide_front *front)
{
    free(front->P);
    free(front->facing);
    free(front->face);
    free(front->order);
    *front = (hide_front){0};
}
