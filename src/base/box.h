/* box.h - axis-aligned boxes, given by their least and greatest corners. */
#ifndef ROBERTS_BASE_BOX_H
#define ROBERTS_BASE_BOX_H

#include <stddef.h>

#include "base/bits.h"
#include "base/lanes.h"
#include "base/vec.h"

typedef struct box3 {
    roberts_vec3 lo, hi;
} box3;

/* The box of no points. */
static const box3 box3_none = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

static inline bool box3_meet(const box3 *a, const box3 *b)
{
    return a->lo.x <= b->hi.x && b->lo.x <= a->hi.x && a->lo.y <= b->hi.y && b->lo.y <= a->hi.y && a->lo.z <= b->hi.z &&
           b->lo.z <= a->hi.z;
}

/* Extends the box lo..hi to contain p. */
static inline void box_add(roberts_vec3 *lo, roberts_vec3 *hi, roberts_vec3 p)
{
    *lo = (roberts_vec3){lesser(lo->x, p.x), lesser(lo->y, p.y), lesser(lo->z, p.z)};
    *hi = (roberts_vec3){greater(hi->x, p.x), greater(hi->y, p.y), greater(hi->z, p.z)};
}

static inline void box3_add(box3 *box, roberts_vec3 p)
{
    box_add(&box->lo, &box->hi, p);
}

/* The box of the points P[number[i]]. */
BITS_INLINE box3 box3_of(const roberts_vec3 *P, const uint32_t *number, uint32_t count)
{
    box3 own = box3_none;
    for (uint32_t i = 0; i < count; i++)
        box3_add(&own, P[number[i]]);
    return own;
}

/* Extends the box to contain `count` points. x and y are handled in parallel; the result is that of box_add(), bit for
 * bit. */
static inline void box_add_all(roberts_vec3 *lo, roberts_vec3 *hi, const roberts_vec3 *P, size_t count)
{
    two low = two_of(lo->x, lo->y), high = two_of(hi->x, hi->y);
    double low_z = lo->z, high_z = hi->z;
    for (size_t i = 0; i < count; i++) {
        two xy = two_of(P[i].x, P[i].y);
        low = two_lesser(low, xy);
        high = two_greater(high, xy);
        low_z = lesser(low_z, P[i].z);
        high_z = greater(high_z, P[i].z);
    }
    two_part(&lo->x, &lo->y, low);
    two_part(&hi->x, &hi->y, high);
    lo->z = low_z;
    hi->z = high_z;
}

/* Clips [*t0, *t1] to the parameters at which a + t (b - a) lies in [low, high]. False: nothing is left. If a = b, the
 * interval does not change. */
static inline bool box_clip(double a, double b, double low, double high, double *t0, double *t1)
{
    double d = b - a;
    if (d == 0.0)
        return a >= low && a <= high;
    double ta = (low - a) / d, tb = (high - a) / d;
    *t0 = greater(*t0, lesser(ta, tb));
    *t1 = lesser(*t1, greater(ta, tb));
    return *t0 <= *t1;
}

#endif
