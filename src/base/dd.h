/* dd.h - double-double numbers: an unevaluated sum hi + lo of two doubles, about 32 digits.
 *
 * Source: T. J. Dekker, "A floating-point technique for extending the available precision", Numer. Math. 18 (1971); D.
 * E. Knuth, The Art of Computer Programming 2, 4.2.2 (the exact sum). The arithmetic must not be contracted or
 * reordered (-ffp-contract=off, no -ffast-math). Overflow is not handled: callers first scale to about 1. */
#ifndef ROBERTS_BASE_DD_H
#define ROBERTS_BASE_DD_H

#include <math.h>

#include "base/vec.h"

typedef struct dd {
    double hi, lo;
} dd;

typedef struct dd3 {
    dd x, y, z;
} dd3;

/* Returns a + b without error. */
static inline dd dd_two_sum(double a, double b)
{
    double s = a + b, t = s - a;
    return (dd){s, (a - (s - t)) + (b - t)};
}

/* Returns a - b without error. */
static inline dd dd_two_diff(double a, double b)
{
    return dd_two_sum(a, -b);
}

static inline dd dd_neg(dd a)
{
    return (dd){-a.hi, -a.lo};
}

static inline dd dd_add(dd a, dd b)
{
    dd s = dd_two_sum(a.hi, b.hi), t = dd_two_sum(a.lo, b.lo);
    s = dd_two_sum(s.hi, s.lo + t.hi);
    return dd_two_sum(s.hi, s.lo + t.lo);
}

static inline dd dd_sub(dd a, dd b)
{
    return dd_add(a, dd_neg(b));
}

static inline dd dd_mul(dd a, dd b)
{
    double p = a.hi * b.hi, e = fma(a.hi, b.hi, -p);
    return dd_two_sum(p, e + (a.hi * b.lo + a.lo * b.hi));
}

/* Long division with three doubles as digits. */
static inline dd dd_div(dd a, dd b)
{
    double first = a.hi / b.hi;
    dd rest = dd_sub(a, dd_mul((dd){first, 0.0}, b));
    double second = rest.hi / b.hi;
    rest = dd_sub(rest, dd_mul((dd){second, 0.0}, b));
    return dd_add(dd_two_sum(first, second), (dd){rest.hi / b.hi, 0.0});
}

static inline dd3 dd3_from(roberts_vec3 a)
{
    return (dd3){{a.x, 0.0}, {a.y, 0.0}, {a.z, 0.0}};
}

/* Returns a - b of points with double coordinates, without error. */
static inline dd3 dd3_between(roberts_vec3 a, roberts_vec3 b)
{
    return (dd3){dd_two_diff(a.x, b.x), dd_two_diff(a.y, b.y), dd_two_diff(a.z, b.z)};
}

static inline dd3 dd3_add(dd3 a, dd3 b)
{
    return (dd3){dd_add(a.x, b.x), dd_add(a.y, b.y), dd_add(a.z, b.z)};
}

static inline dd dd3_dot(dd3 a, dd3 b)
{
    return dd_add(dd_add(dd_mul(a.x, b.x), dd_mul(a.y, b.y)), dd_mul(a.z, b.z));
}

static inline dd3 dd3_cross(dd3 a, dd3 b)
{
    return (dd3){dd_sub(dd_mul(a.y, b.z), dd_mul(a.z, b.y)), dd_sub(dd_mul(a.z, b.x), dd_mul(a.x, b.z)),
                 dd_sub(dd_mul(a.x, b.y), dd_mul(a.y, b.x))};
}

/* Returns a / (a - b) as a double: the zero of the linear function that is a at 0 and b at 1. */
static inline double dd_zero_of(dd a, dd b)
{
    dd difference = dd_sub(a, b);
    double t = a.hi / difference.hi;
    dd rest = dd_sub(a, dd_mul((dd){t, 0.0}, difference)); /* one Newton step: then t is correct to the last place */
    return t + (rest.hi + rest.lo) / difference.hi;
}

#endif
