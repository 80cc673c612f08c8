/* crossing_face.h - the plane of a face, and how corners lie about it: for crossing.c alone. */
#ifndef ROBERTS_MODEL_CROSSING_FACE_H
#define ROBERTS_MODEL_CROSSING_FACE_H

#include "model/crossing.h"

/* The largest error of a decision, as a part of the touching distance. */
#define CROSSING_TRUSTED 0.125

static inline double crossing_greatest(roberts_vec3 d)
{
    return greater(fabs(d.x), greater(fabs(d.y), fabs(d.z)));
}

/* Vertex v as seen from a point, in the scene's unit. */
static inline roberts_vec3 crossing_from(const crossing_rules *rules, uint32_t v, roberts_vec3 point, roberts_vec3 low)
{
    const roberts_scene *scene = rules->scene;
    roberts_vec3 d = vec3_sub(scene->point[v], point);
    if (scene->low)
        d = vec3_add(d, vec3_sub(scene->low[v], low));
    return vec3_scale(1.0 / scene->unit, d);
}

/* The same in double-double numbers. */
dd3 crossing_exactly_from(const crossing_rules *rules, uint32_t v, roberts_vec3 point, roberts_vec3 low);

/* Fills in the normal in double-double numbers, once. */
void crossing_refine(const crossing_rules *rules, crossing_face *f);

/* Vertex v over the plane of f, in lengths of its n. */
dd crossing_exact_height(const crossing_rules *rules, crossing_face *f, uint32_t v);

static inline bool crossing_has_corner(const crossing_rules *rules, const crossing_face *f, uint32_t v)
{
    const roberts_scene *scene = rules->scene;
    for (uint32_t k = scene->face_start[f->first]; k < scene->face_start[f->end]; k++)
        if (scene->corner[k] == v)
            return true;
    return false;
}

/* A corner's height over a plane. */
typedef struct crossing_height {
    double h, error; /* in lengths of the plane's n */
    int sign;        /* 0: on it */
} crossing_height;

/* Vertex v, of `body`, over the plane of f. */
static inline crossing_height crossing_height_of(const crossing_rules *rules, crossing_face *f, uint32_t body,
                                                 uint32_t v)
{
    crossing_height at = {0.0, 0.0, 0};
    if (body == f->body && crossing_has_corner(rules, f, v))
        return at;
    roberts_vec3 d = crossing_from(rules, v, f->origin, f->low);
    at.h = vec3_dot(f->n, d) - f->mean;
    at.error = f->error * (crossing_greatest(d) + f->chord);
    if (at.error > CROSSING_TRUSTED * f->touch && !(fabs(at.h) > at.error + f->touch)) {
        at.h = crossing_exact_height(rules, f, v).hi;
        at.error = 0x1p-52 * fabs(at.h);
    }
    at.sign = (at.h > f->touch) - (at.h < -f->touch);
    return at;
}

#endif
