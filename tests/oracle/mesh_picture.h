/* mesh_picture.h - the program's picture of a scene, as the manual describes it. */
#ifndef ROBERTS_TESTS_MESH_PICTURE_H
#define ROBERTS_TESTS_MESH_PICTURE_H

#include <math.h>
#include <stdlib.h>

#include "mesh_judge.h"

/* The picture's axes, and the point in its middle. */
typedef struct picture {
    roberts_vec3 right, up, toward, middle, eye;
    double far; /* from the eye to the middle; 0: no eye */
} picture;

static inline roberts_vec3 picture_minus(roberts_vec3 p, roberts_vec3 q)
{
    return (roberts_vec3){p.x - q.x, p.y - q.y, p.z - q.z};
}

static inline roberts_vec3 picture_unit_cross(roberts_vec3 a, roberts_vec3 b)
{
    roberts_vec3 c = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    double l = hypot(hypot(c.x, c.y), c.z);
    return (roberts_vec3){c.x / l, c.y / l, c.z / l};
}

static inline double picture_dot(roberts_vec3 a, roberts_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* Is b the tip of a spike: does its side to c run back along its side to a? */
static inline bool picture_is_tip(roberts_vec3 a, roberts_vec3 b, roberts_vec3 c)
{
    const roberts_vec3 p = picture_minus(a, b), q = picture_minus(c, b);
    const double x = p.y * q.z - p.z * q.y, y = p.z * q.x - p.x * q.z, z = p.x * q.y - p.y * q.x;
    return picture_dot(p, q) > 0 && x * x + y * y + z * z <= 1e-24 * picture_dot(p, p) * picture_dot(q, q);
}

/* The corners of a face without the tips of spikes, which bound nothing: a mark for each corner that counts. If nothing
 * else is left, all count. */
static inline void picture_find_corners(const roberts_mesh *m, uint32_t face, bool *counts)
{
    const uint32_t first = m->face_start[face], n = m->face_start[face + 1] - first;
    uint32_t left = n;
    for (uint32_t i = 0; i < n; i++)
        counts[i] = true;
    for (uint32_t i = 0, since = 0; left > 2 && since < n; i = (i + 1) % n, since++) {
        uint32_t before = (i + n - 1) % n, after = (i + 1) % n;
        while (!counts[before])
            before = (before + n - 1) % n;
        while (!counts[after])
            after = (after + 1) % n;
        const roberts_vec3 a = m->vertex[m->corner[first + before]], b = m->vertex[m->corner[first + i]],
                           c = m->vertex[m->corner[first + after]];
        const bool twice = a.x == b.x && a.y == b.y && a.z == b.z;
        if (!counts[i] || !(twice || picture_is_tip(a, b, c)))
            continue;
        counts[i] = false;
        left--;
        since = 0;
    }
    for (uint32_t i = 0; i < n; i++)
        counts[i] = counts[i] || left < 3;
}

/* As the manual says: the origin is the middle of the box round all faces, and z points up, or y where z is seen as a
 * point. */
static inline picture picture_of(const mesh_scene *scene)
{
    const roberts_mesh *m = &scene->mesh;
    const oracle_view *v = &scene->view;
    roberts_vec3 low = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    bool *counts = malloc(m->face_start[m->face_count] + 1);
    for (uint32_t f = 0; counts && f < m->face_count; f++)
        picture_find_corners(m, f, counts + m->face_start[f]);
    for (uint32_t i = 0; counts && i < m->face_start[m->face_count]; i++) {
        roberts_vec3 p = m->vertex[m->corner[i]];
        if (!counts[i])
            continue;
        low = (roberts_vec3){fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z)};
        high = (roberts_vec3){fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z)};
    }
    free(counts);
    picture out = {.middle = {(low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2}};
    roberts_vec3 d = {v->x, v->y, v->z};
    if (v->w) {
        out.eye = d;
        d = picture_minus(d, out.middle);
        out.far = sqrt(picture_dot(d, d));
    }
    double l = sqrt(picture_dot(d, d));
    out.toward = (roberts_vec3){d.x / l, d.y / l, d.z / l};
    bool upright = hypot(out.toward.x, out.toward.y) < 1e-9;
    out.right = picture_unit_cross(upright ? (roberts_vec3){0, 1, 0} : (roberts_vec3){0, 0, 1}, out.toward);
    out.up = picture_unit_cross(out.toward, out.right);
    return out;
}

#endif
