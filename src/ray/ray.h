/* ray.h - what the ray tests share: when a determinant counts as 0, and which end of a span is met.
 *
 * Invariant: NaN in, miss out. Every comparison that accepts is written so that it fails for NaN. */
#ifndef ROBERTS_RAY_RAY_H
#define ROBERTS_RAY_RAY_H

#include <float.h>

#include "base/vec.h"

/* A determinant below this part of the sum of its terms' sizes is rounding: each term carries at most two rounded
 * differences, two products and the sums, together under 8 half-ulps, so 8 ulps leave a factor of two. It has no unit,
 * and does not depend on the lengths or the scale of what is compared. */
#define RAY_PARALLEL (8 * DBL_EPSILON)

static inline bool ray_parallel(double determinant, double size)
{
    return !(fabs(determinant) > RAY_PARALLEL * size);
}

/* |a| . |b|, component by component: the size of the terms of a . b. */
static inline double vec3_dot_size(roberts_vec3 a, roberts_vec3 b)
{
    return fabs(a.x * b.x) + fabs(a.y * b.y) + fabs(a.z * b.z);
}

/* The size of the terms of (a x b) . c. */
static inline double vec3_triple_size(roberts_vec3 a, roberts_vec3 b, roberts_vec3 c)
{
    return (fabs(a.y * b.z) + fabs(a.z * b.y)) * fabs(c.x) + (fabs(a.z * b.x) + fabs(a.x * b.z)) * fabs(c.y) +
           (fabs(a.x * b.y) + fabs(a.y * b.x)) * fabs(c.z);
}

static inline roberts_vec3 ray_at(roberts_ray ray, double t)
{
    return vec3_add(ray.origin, vec3_scale(t, ray.direction));
}

/* A direction that leads somewhere: finite and not 0. */
static inline bool ray_has_direction(roberts_vec3 v)
{
    return isfinite(v.x) && isfinite(v.y) && isfinite(v.z) && (v.x != 0.0 || v.y != 0.0 || v.z != 0.0);
}

/* The line is inside from t_in (through face_in) to t_out (through face_out): fills `span` with what the ray meets
 * first. A span that lies behind S, or beyond all numbers, is not met. */
static inline bool ray_span(double t_in, uint32_t face_in, double t_out, uint32_t face_out, roberts_span *span)
{
    if (!(t_in <= t_out) || !(t_out >= 0.0) || !(t_in < INFINITY))
        return false;
    if (t_in >= 0.0)
        *span = (roberts_span){t_in, t_out, t_in, ROBERTS_FACING_FRONT, face_in};
    else
        *span = (roberts_span){t_in, t_out, t_out, ROBERTS_FACING_BACK, face_out};
    return true;
}

#endif
