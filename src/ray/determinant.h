/* determinant.h - when a determinant counts as 0. */
#ifndef ROBERTS_RAY_DETERMINANT_H
#define ROBERTS_RAY_DETERMINANT_H

#include <float.h>

#include "base/vec.h"

/* Fraction of the sum of a determinant's absolute terms: a smaller determinant is rounding. Each term has at most two
 * rounded differences, two products and the sums: together under 8 half-ulps, so 8 ulps leave a factor of two. The
 * number has no unit and does not depend on lengths or scale. */
#define RAY_PARALLEL (8 * DBL_EPSILON)

static inline bool ray_parallel(double determinant, double size)
{
    return !(fabs(determinant) > RAY_PARALLEL * size);
}

/* Returns |a| . |b|, component by component: the sum of the absolute terms of a . b. */
static inline double vec3_dot_size(roberts_vec3 a, roberts_vec3 b)
{
    return fabs(a.x * b.x) + fabs(a.y * b.y) + fabs(a.z * b.z);
}

/* Returns the sum of the absolute terms of (a x b) . c. */
static inline double vec3_triple_size(roberts_vec3 a, roberts_vec3 b, roberts_vec3 c)
{
    return (fabs(a.y * b.z) + fabs(a.z * b.y)) * fabs(c.x) + (fabs(a.z * b.x) + fabs(a.x * b.z)) * fabs(c.y) +
           (fabs(a.x * b.y) + fabs(a.y * b.x)) * fabs(c.z);
}

#endif
