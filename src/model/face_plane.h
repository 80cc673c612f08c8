/* face_plane.h - the plane of a face, fitted to all its corners. */
#ifndef ROBERTS_MODEL_FACE_PLANE_H
#define ROBERTS_MODEL_FACE_PLANE_H

#include "base/bits.h"
#include "base/lanes.h"
#include "base/vec.h"

typedef struct fitted_plane {
    roberts_vec3 n; /* unit normal; seen from its end, the corners turn counter-clockwise. 0,0,0 if there is no area */
    double mean;    /* the plane is n.(P - first corner) = mean: it passes through the mean of the corners */
    double deviation; /* greatest distance of a corner from the plane */
    double area;
    double width; /* area divided by greatest chord: between half the least width and all of it */
    bool strict;  /* the face is strictly convex, decided without a tolerance */
} fitted_plane;

/* Fits a plane to `count` >= 3 corners in order round a face. They are relative to the first one, which is 0,0,0.
 * Lengths must be small and large enough that their fourth powers stay in range. */
fitted_plane face_plane_fit(const roberts_vec3 *corner, uint32_t count);

/* ---- two faces of three or four corners at a time (nearly all faces) -------------------------------------------- */

typedef struct two_vec3 {
    two x, y, z;
} two_vec3;

/* As in fitted_plane, lane by lane. */
typedef struct two_planes {
    two_vec3 n;
    two mean, deviation, area, width;
    unsigned strict; /* bit i is for lane i */
    unsigned empty;  /* bit i: lane i has no area and is otherwise undefined */
} two_planes;

static inline two_vec3 two_vec3_of(const roberts_vec3 *p, const roberts_vec3 *q)
{
    return (two_vec3){two_of(p->x, q->x), two_of(p->y, q->y), two_of(p->z, q->z)};
}

static inline two_vec3 two_vec3_all(roberts_vec3 p)
{
    return (two_vec3){two_all(p.x), two_all(p.y), two_all(p.z)};
}

static inline two_vec3 two_vec3_sub(two_vec3 a, two_vec3 b)
{
    return (two_vec3){two_sub(a.x, b.x), two_sub(a.y, b.y), two_sub(a.z, b.z)};
}

static inline two_vec3 two_vec3_add(two_vec3 a, two_vec3 b)
{
    return (two_vec3){two_add(a.x, b.x), two_add(a.y, b.y), two_add(a.z, b.z)};
}

static inline two two_vec3_dot(two_vec3 a, two_vec3 b)
{
    return two_add(two_add(two_mul(a.x, b.x), two_mul(a.y, b.y)), two_mul(a.z, b.z));
}

static inline two_vec3 two_vec3_cross(two_vec3 a, two_vec3 b)
{
    return (two_vec3){two_sub(two_mul(a.y, b.z), two_mul(a.z, b.y)), two_sub(two_mul(a.z, b.x), two_mul(a.x, b.z)),
                      two_sub(two_mul(a.x, b.y), two_mul(a.y, b.x))};
}

static inline two two_square(two_vec3 a)
{
    return two_vec3_dot(a, a);
}

/* Normalizes to length 1. Divides rather than multiplying by 1 / length, so that an axis stays exact. */
static inline two_vec3 two_vec3_unit(two_vec3 sum, two length)
{
    return (two_vec3){two_div(sum.x, length), two_div(sum.y, length), two_div(sum.z, length)};
}

/* Computes the planes from the sum of the cross products, its length, the square of the greatest chord, and the
 * corners' heights: their least and greatest, including the origin's 0, and their mean. */
static inline two_planes two_planes_of(two_vec3 n, two length, two chord_squared, two least, two most, two mean)
{
    two area = two_mul(two_all(0.5), length), zero = two_all(0.0);
    least = two_lesser(least, zero);
    most = two_greater(most, zero);
    return (two_planes){n,
                        mean,
                        two_greater(two_sub(most, mean), two_sub(mean, least)),
                        area,
                        two_div(area, two_sqrt(chord_squared)),
                        3,
                        two_at_most(length, zero)};
}

/* Triangles 0, a, b. */
BITS_INLINE two_planes two_planes_of_triangles(two_vec3 a, two_vec3 b)
{
    two_vec3 sum = two_vec3_cross(a, b), n;
    two length = two_sqrt(two_square(sum)), ha, hb;
    n = two_vec3_unit(sum, length);
    ha = two_vec3_dot(n, a); /* rounding errors only */
    hb = two_vec3_dot(n, b);
    return two_planes_of(n, length,
                         two_greater(two_greater(two_square(a), two_square(b)), two_square(two_vec3_sub(b, a))),
                         two_lesser(ha, hb), two_greater(ha, hb), two_div(two_add(ha, hb), two_all(3.0)));
}

/* Quadrilaterals 0, a, b, c. */
BITS_INLINE two_planes two_planes_of_quadrilaterals(two_vec3 a, two_vec3 b, two_vec3 c)
{
    two_vec3 ab = two_vec3_cross(a, b), bc = two_vec3_cross(b, c), sum = two_vec3_add(ab, bc), n;
    two length = two_sqrt(two_square(sum)), ha, hb, hc, at_a, at_c, at_origin, at_b, zero = two_all(0.0);
    two from_origin = two_greater(two_greater(two_square(a), two_square(b)), two_square(c));
    two others = two_greater(two_greater(two_square(two_vec3_sub(b, a)), two_square(two_vec3_sub(c, b))),
                             two_square(two_vec3_sub(c, a)));
    two_planes faces;
    n = two_vec3_unit(sum, length);
    ha = two_vec3_dot(n, a);
    hb = two_vec3_dot(n, b);
    hc = two_vec3_dot(n, c);
    faces = two_planes_of(n, length, two_greater(from_origin, others), two_lesser(two_lesser(ha, hb), hc),
                          two_greater(two_greater(ha, hb), hc), two_div(two_add(two_add(ha, hb), hc), two_all(4.0)));
    at_a = two_vec3_dot(n, ab); /* areas of the triangles at the four corners: four left turns are one full turn */
    at_c = two_vec3_dot(n, bc);
    at_origin = two_vec3_dot(n, two_vec3_cross(a, c));
    at_b = two_sub(two_add(at_a, at_c), at_origin);
    faces.strict =
        ~(two_at_most(at_a, zero) | two_at_most(at_c, zero) | two_at_most(at_origin, zero) | two_at_most(at_b, zero));
    return faces;
}

#endif
