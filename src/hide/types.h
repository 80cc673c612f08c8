/* types.h - points in view space, boxes, a face, an edge, a hidden interval. */
#ifndef ROBERTS_HIDE_TYPES_H
#define ROBERTS_HIDE_TYPES_H

#include "base/box.h"
#include "base/search.h"
#include "view/seen.h"

typedef struct hide_space {
    const roberts_vec3 *P;                     /* view points of all vertices, by compact number */
    double epsilon, rounding, across_rounding; /* as in `view` */
    double plain; /* any cross product of two picture vectors has a plain sign if it is larger: hide_plain() */
    const roberts_scene *scene; /* the model as read, for double-double numbers; */
    const view *view;           /* NULL both: never refine (tests on bare points) */
} hide_space;

/* A box in view space, rounded outward. z points toward the viewer. */
typedef struct hide_box {
    float x0, x1, y0, y1, z0, z1;
} hide_box;

static const hide_box hide_no_box = {INFINITY, -INFINITY, INFINITY, -INFINITY, INFINITY, -INFINITY};

static inline box3 hide_box3(const hide_box *box)
{
    return (box3){{(double)box->x0, (double)box->y0, (double)box->z0},
                  {(double)box->x1, (double)box->y1, (double)box->z1}};
}

/* Is (x, y) inside the box in the picture, or no farther outside than m? */
static inline bool hide_box_holds(const hide_box *box, double x, double y, double m)
{
    return x >= (double)box->x0 - m && x <= (double)box->x1 + m && y >= (double)box->y0 - m && y <= (double)box->y1 + m;
}

static inline bool hide_boxes_meet(const hide_box *a, const hide_box *b)
{
    return a->x0 <= b->x1 && b->x0 <= a->x1 && a->y0 <= b->y1 && b->y0 <= a->y1 && a->z0 <= b->z1 && b->z0 <= a->z1;
}

/* A front face, or the outline of several (F is not used then). Its sides run counter-clockwise in the picture. */
typedef struct hide_face {
    plane F;                /* view space, inward: F(P) < 0 in front of it */
    const uint32_t *corner; /* [count] compact vertex numbers */
    double touch;           /* F within +-touch is on the plane: epsilon plus the face's own departure from it */
    uint32_t count;
    float departure; /* for an eye: `touch` less epsilon, at the depth of the look-at point. It grows toward the eye;
                        `touch` has its value at the solid's nearest corner. Otherwise 0 */
    float limit; /* F(A) <= limit is in front of the plane or on it, even at the far end of the scene, where the plane
                    of a small face is less certain than `touch`; see test 1 */
} hide_face;

/* The edge AB under test. */
typedef struct hide_edge {
    roberts_vec3 A, B;     /* view points of the ends */
    uint32_t a, b;         /* vertices of the scene; ROBERTS_NONE: a computed point */
    const seen_point *end; /* [2] model positions of A and B if one is computed; NULL: both are vertices */
    double length;         /* of AB in the picture */
    double length3;        /* of AB in view space */
} hide_edge;

/* The part t0 .. t1 of an edge hidden by one face or solid: parameters along the edge's picture. From r0 to r1 the edge
 * is within epsilon of what hides it (see intervals.h); r0 <= t0 and r1 >= t1. */
typedef struct hide_interval {
    double t0, t1;
    double r0, r1;
} hide_interval;

static const hide_interval hide_whole = {0.0, 1.0, 0.0, 1.0};

static inline roberts_vec3 hide_edge_at(const hide_edge *e, double t)
{
    if (t == 1.0)
        return e->B;
    return (roberts_vec3){e->A.x + t * (e->B.x - e->A.x), e->A.y + t * (e->B.y - e->A.y),
                          e->A.z + t * (e->B.z - e->A.z)};
}

/* Returns a float certainly not greater (not less) than x. Rounding to float moves x by at most |x| / 2^24. */
static inline float hide_float_below(double x)
{
    return (float)(x - fabs(x) * 0x1p-23);
}

static inline float hide_float_above(double x)
{
    return (float)(x + fabs(x) * 0x1p-23);
}

/* Is X inside the side from P to Q, whose inside is on the left, or at most `slack` outside? A negative slack asks for
 * that much inside. A side no longer than `shortest` is ignored. */
static inline bool hide_side_holds(roberts_vec3 P, roberts_vec3 Q, roberts_vec2 X, double slack, double shortest)
{
    double dx = Q.x - P.x, dy = Q.y - P.y, H = dx * (X.y - P.y) - dy * (X.x - P.x);
    if (H >= 0.0 && slack >= 0.0)
        return true;
    const double length = sqrt(dx * dx + dy * dy);
    return !(H < -slack * length) || length <= shortest;
}

static inline hide_box hide_box_around(const box3 *all)
{
    if (all->lo.x > all->hi.x)
        return hide_no_box;
    return (hide_box){hide_float_below(all->lo.x), hide_float_above(all->hi.x), hide_float_below(all->lo.y),
                      hide_float_above(all->hi.y), hide_float_below(all->lo.z), hide_float_above(all->hi.z)};
}

#endif
