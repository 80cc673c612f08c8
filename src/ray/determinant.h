/* determinant.h - when a determinant counts as 0. */
#ifndef ROBERTS_RAY_DETERMINANT_H
#define ROBERTS_RAY_DETERMINANT_H

#include <float.h>

#include "base/vec.h"

/* A determinant below this part of the sum of its terms' sizes is rounding. Each term carries at most two rounded
 * differences, two products and the sums: together under 8 half-ulps, so that 8 ulps leave a factor of two. The number
 * has no unit and does not depend on lengths or scale. */
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

#endif
