/* refine.h - signs and crossings from the coordinates as read, in doubles or in double-double numbers.
 *
 * View coordinates carry the rounding of the map to view space, about 1e-15 of the scene. This matters if a crossing is
 * very oblique, an edge very short, or a side very far from the point. Then the same quantities are computed from the
 * model's own coordinates, with the viewpoint V as a homogeneous point. The sight plane through P and Q is det(Q - P, X
 * - P, V) = 0 for a direction V, and det(P - V, Q - V, X - V) = 0 for an eye V.
 *
 * Differences of coordinates as read are nearly exact. So doubles nearly always suffice: their error is a part of the
 * distances between these points, and not of the scene. Double-double numbers decide the rest. */
#ifndef ROBERTS_HIDE_REFINE_H
#define ROBERTS_HIDE_REFINE_H

#include "hide/types.h"

/* A point with double-double coordinates: a vertex, or a computed end of an edge. */
typedef struct refine_point {
    uint32_t vertex;         /* ROBERTS_NONE: a computed point, at `place` */
    const seen_point *place; /* position in the model */
    double z;                /* depth in view space */
} refine_point;

static inline refine_point refine_vertex(const hide_space *space, uint32_t v)
{
    return (refine_point){v, NULL, space->P[v].z};
}

static inline refine_point refine_start(const hide_edge *e)
{
    return (refine_point){e->a, e->end, e->A.z};
}

static inline refine_point refine_end(const hide_edge *e)
{
    return (refine_point){e->b, e->end ? e->end + 1 : NULL, e->B.z};
}

/* In doubles: finds what refine_side() returns, with a bound of its error. Both are NaN if p and q have one picture. */
typedef struct refine_near {
    double value, error;
} refine_near;

refine_near refine_side_nearly(const hide_space *space, uint32_t p, uint32_t q, refine_point x);

/* In doubles: finds what refine_crossing() returns. False: that is not accurate. */
bool refine_crossing_nearly(const hide_space *space, uint32_t p, uint32_t q, const hide_edge *e, double *t);

/* Returns the distance, in view units, of x from the sight plane through vertices p and q; > 0 left of p -> q in the
 * picture. */
double refine_side(const hide_space *space, uint32_t p, uint32_t q, refine_point x);

/* Finds where edge e crosses the sight plane through p and q: a parameter along the edge's picture. */
double refine_crossing(const hide_space *space, uint32_t p, uint32_t q, const hide_edge *e);

/* Finds where edge e crosses the plane of face F: a parameter along the edge's picture. */
double refine_pierce(const hide_space *space, const hide_face *F, const hide_edge *e);

#endif
