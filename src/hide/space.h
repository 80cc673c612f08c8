/* space.h - what the tests work on: the scene in view space, its front faces and the edge under test. */
#ifndef ROBERTS_HIDE_SPACE_H
#define ROBERTS_HIDE_SPACE_H

#include "view/view.h"

/* Accuracy to which parameters t along an edge are wanted: under the 1e-9 that drawings are checked to. A crossing
 * whose rounding could exceed it is computed again in twice the precision. No unit. */
#define HIDE_T_ACCURACY 1e-10

/* A computed distance is trusted for its sign where its error is at most this part of epsilon. */
#define HIDE_TRUSTED 0.125

typedef struct hide_space {
    const roberts_vec3 *P;      /* view points of all vertices, by compact number */
    double epsilon;             /* touching distance, view units */
    double rounding;            /* bound of the error of an x or y of P, view units */
    double depth_rounding;      /* ... of any coordinate of P, z too; at least that */
    double plain;               /* a cross product of two vectors of the picture that is larger than this has a plain
                                   sign: hide_plain(); INFINITY: never */
    const roberts_scene *scene; /* as read, for signs and crossings in twice the precision; */
    const view *view;           /* NULL both: never refine (tests on bare points) */
} hide_space;

/* |u x v| is the distance of one point from the line through two others, times their distance l. It is more than
 * epsilon, with certainty, where |u x v| > epsilon l + 2 rounding (l + reach), and l is no more than 3 and the
 * reach no more than 6 extents (of the picture: x and y), and the products' own rounding adds no more than 4 extents times
 * rounding. (One bound for the whole scene: where it says nothing, the numbers are looked at closely.) */
static inline double hide_plain(double extent, double epsilon, double rounding)
{
    return 4.0 * extent * (epsilon + 8.0 * rounding);
}

/* A box in view space, rounded outward: x and y of the picture, z toward the viewer. */
typedef struct hide_box {
    float x0, x1, y0, y1, z0, z1;
} hide_box;

/* A front face, or with F not used the outline of several. Its sides run counter-clockwise in the picture. */
typedef struct hide_face {
    plane F;                /* view space, inward: F(P) < 0 in front of it */
    const uint32_t *corner; /* [count] compact vertex numbers */
    double touch;           /* F within +-touch is on the plane: epsilon and the face's own departure from it */
    uint32_t count;
    float departure; /* from an eye: what `touch` has beside epsilon, at the look-at point's depth; it grows toward the
                        eye, and `touch` has it at the solid's nearest corner. Else 0 */
    float limit; /* F(A) <= limit is in front or on even at the far end of the scene, where the plane of a small face
                    cannot be trusted to `touch`; see test 1 */
} hide_face;

/* The edge AB under test. */
typedef struct hide_edge {
    roberts_vec3 A, B; /* view points */
    uint32_t a, b;     /* their compact numbers */
    double length;     /* of AB in the picture */
    double length3;    /* of AB in view space */
} hide_edge;

/* The hidden part t0 .. t1 of an edge by one face or solid: parameters along its picture. From r0 to r1 the edge is
 * within epsilon of what hides it (see reach.h); r0 <= t0 and r1 >= t1. */
typedef struct hide_part {
    double t0, t1;
    double r0, r1;
} hide_part;

static const hide_part hide_whole = {0.0, 1.0, 0.0, 1.0};

static inline roberts_vec3 hide_edge_at(const hide_edge *e, double t)
{
    if (t == 1.0)
        return e->B;
    return (roberts_vec3){e->A.x + t * (e->B.x - e->A.x), e->A.y + t * (e->B.y - e->A.y),
                          e->A.z + t * (e->B.z - e->A.z)};
}

/* Is a parameter with this error good enough, along the edge and as a length? */
static inline bool hide_accurate(const hide_space *space, const hide_edge *e, double error)
{
    return error <= HIDE_T_ACCURACY && error * e->length3 <= HIDE_TRUSTED * space->epsilon;
}

/* Bound of the error of the parameter t at which AB crosses the line through P along (dx, dy), a side from corner to corner;
 * apart: |a - b| for its signed distances a, b of A and B, times the side's length. It is sharper than the errors of a
 * and b where the crossing lies near a side that is short, or far from the ends of AB: with a and b off by da and db,
 * t is off by ((1 - t) da + t db) / (a - b), by the error that the distance of the crossing X itself would have. Moved
 * by `rounding` in each coordinate, P, Q and X change the cross product by no more than 2 rounding (|PQ| + |PX|), both
 * norms sums of coordinates, and the products' own rounding adds less than 2 rounding |PQ|. X is taken where it was
 * found: it may be off by t's error times |AB|, which at most doubles the bound as long as 4 rounding |AB| <= apart. */
static inline double hide_crossing_error(const hide_space *space, const hide_edge *e, double t, double px, double py,
                                         double dx, double dy, double apart)
{
    roberts_vec3 X = hide_edge_at(e, t);
    double side = fabs(dx) + fabs(dy), reach = fabs(X.x - px) + fabs(X.y - py);
    double run = fabs(e->B.x - e->A.x) + fabs(e->B.y - e->A.y);
    return 4.0 * space->rounding * run <= apart ? 4.0 * space->rounding * (2.0 * side + reach) / apart : INFINITY;
}

/* A float certainly not greater (not less) than x: rounding moves x by half of 2^-23 of it at the most. */
static inline float hide_float_below(double x)
{
    return (float)(x - fabs(x) * 0x1p-23);
}

static inline float hide_float_above(double x)
{
    return (float)(x + fabs(x) * 0x1p-23);
}

/* Is (x, y) inside of the side from P to Q, left of which the inside is, or no farther outside than `slack`? Where that is
 * negative: so far inside. */
static inline bool hide_side_holds(roberts_vec3 P, roberts_vec3 Q, double x, double y, double slack)
{
    double dx = Q.x - P.x, dy = Q.y - P.y, H = dx * (y - P.y) - dy * (x - P.x);
    return !((H < 0.0 || slack < 0.0) && H < -slack * sqrt(dx * dx + dy * dy));
}

/* By how much cells and boxes are widened, so that an edge and a face that touch are never kept apart. */
static inline double hide_margin(const hide_space *space)
{
    return 4.0 * (space->epsilon + space->depth_rounding);
}

#endif
