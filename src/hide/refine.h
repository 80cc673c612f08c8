/* refine.h - signs and crossings in twice the precision, from the coordinates as read.
 *
 * View coordinates carry the rounding of the map to view space, about 1e-15 of the scene. Where a crossing is so
 * oblique, an edge so short or a side so far from the point that this would show, the same quantities are computed
 * from the model's own coordinates, with the viewpoint V as a homogeneous point: a sight plane through P and Q is
 * det(Q - P, X - P, V) = 0 for a direction V, det(P - V, Q - V, X - V) = 0 for an eye. */
#ifndef ROBERTS_HIDE_REFINE_H
#define ROBERTS_HIDE_REFINE_H

#include "hide/types.h"

/* Distance, view units, of vertex x from the sight plane through vertices p and q; > 0 left of p -> q in the
 * picture. */
double refine_side(const hide_space *space, uint32_t p, uint32_t q, uint32_t x);

/* Where edge e crosses the sight plane through p and q: parameter along the edge's picture. */
double refine_crossing(const hide_space *space, uint32_t p, uint32_t q, const hide_edge *e);

/* Where edge e crosses the plane of face F. */
double refine_pierce(const hide_space *space, const hide_face *F, const hide_edge *e);

#endif
