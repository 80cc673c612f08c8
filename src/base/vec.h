/* vec.h - vectors and planes, passed by value, so that expressions read like formulas. */
#ifndef ROBERTS_BASE_VEC_H
#define ROBERTS_BASE_VEC_H

#include <math.h>

#include "roberts.h"

static inline roberts_vec3 vec3_add(roberts_vec3 a, roberts_vec3 b)
{
    return (roberts_vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline roberts_vec3 vec3_sub(roberts_vec3 a, roberts_vec3 b)
{
    return (roberts_vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline roberts_vec3 vec3_scale(double k, roberts_vec3 a)
{
    return (roberts_vec3){k * a.x, k * a.y, k * a.z};
}

static inline double vec3_dot(roberts_vec3 a, roberts_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline roberts_vec3 vec3_cross(roberts_vec3 a, roberts_vec3 b)
{
    return (roberts_vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline bool vec3_is_finite(roberts_vec3 a)
{
    return isfinite(a.x) && isfinite(a.y) && isfinite(a.z);
}

static inline double vec3_length(roberts_vec3 a)
{
    return sqrt(vec3_dot(a, a));
}

/* The sum of the sizes of the parts. */
static inline double vec3_sum(roberts_vec3 d)
{
    return fabs(d.x) + fabs(d.y) + fabs(d.z);
}

/* Bounds the rounding error of vec3_dot(a, d) for a difference d of two points: part of the product of their sums, and
 * what underflow adds. */
static inline double vec3_dot_error(roberts_vec3 a, roberts_vec3 d)
{
    return vec3_sum(a) * (0x1p-50 * vec3_sum(d)) + 0x1p-1070;
}

/* The length of (x, y), if that is far from overflow: with the same bits everywhere, unlike hypot(). */
static inline double vec2_length(double x, double y)
{
    return sqrt(x * x + y * y);
}

/* Are two points the same? -0 equals +0. */
static inline bool vec2_same(roberts_vec2 a, roberts_vec2 b)
{
    return a.x == b.x && a.y == b.y;
}

static inline bool vec3_same(roberts_vec3 a, roberts_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* Orders points by x, then y: -1, 0 or 1; -0 equals +0. */
static inline int vec2_compare(roberts_vec2 a, roberts_vec2 b)
{
    return a.x != b.x ? (a.x < b.x ? -1 : 1) : (a.y > b.y) - (a.y < b.y);
}

/* Orders points by x, then y, then z: -1, 0 or 1; -0 equals +0. */
static inline int vec3_compare(roberts_vec3 a, roberts_vec3 b)
{
    if (a.x != b.x)
        return a.x < b.x ? -1 : 1;
    if (a.y != b.y)
        return a.y < b.y ? -1 : 1;
    return (a.z > b.z) - (a.z < b.z);
}

/* The lesser and the greater of two numbers, neither of them NaN. fmin() and fmax() are function calls, because they
 * handle NaN. */
static inline double lesser(double a, double b)
{
    return a < b ? a : b;
}

static inline double greater(double a, double b)
{
    return a > b ? a : b;
}

/* The size of the largest coordinate; none of them is NaN. */
static inline double vec3_largest(roberts_vec3 a)
{
    return greater(fabs(a.x), greater(fabs(a.y), fabs(a.z)));
}

/* The part of d that p is, by d's greatest coordinate; p lies along d, which is not 0. */
static inline double vec3_part_along(roberts_vec3 p, roberts_vec3 d)
{
    double x = fabs(d.x), y = fabs(d.y), z = fabs(d.z);
    return x >= y && x >= z ? p.x / d.x : y >= z ? p.y / d.y : p.z / d.z;
}

/* Does the ray from p toward greater x cross the side a..b? For the parity of crossings: each height belongs to one
 * side of two that meet. */
static inline bool vec2_ray_crosses(roberts_vec2 p, roberts_vec2 a, roberts_vec2 b)
{
    return (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
}

/* F(P) = a x + b y + c z + d with (a, b, c) of length 1: the signed distance of P from the plane, in model units. A
 * face's (a, b, c) points into its solid: F(P) < 0 outside, F(P) > 0 inside. */
typedef roberts_plane plane;

static inline double plane_at(plane F, roberts_vec3 P)
{
    return F.a * P.x + F.b * P.y + F.c * P.z + F.d;
}

#endif
