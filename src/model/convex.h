/* convex.h - whether faces and solids are convex. */
#ifndef ROBERTS_MODEL_CONVEX_H
#define ROBERTS_MODEL_CONVEX_H

#include "base/vec.h"
#include "model/solid.h"

/* ---- is a face convex? ----------------------------------------------------------------------------------------- */

/* Does the polygon, counter-clockwise seen from the end of its normal n, turn left at every corner and once in all?
 * Such a polygon is strictly convex, decided without a tolerance. A polygon for which this is false may still be
 * accepted. */
bool polygon_strictly_convex(const roberts_vec3 *corner, uint32_t count, roberts_vec3 n);

/* Returns how far the polygon is from convex: the greatest depth of a corner inside the hull of all corners, and which
 * corner. INFINITY: the corners do not go round the hull once, even if steps back of length `allowed` are ignored.
 * Negative: no memory. */
double polygon_dent(const roberts_vec3 *corner, uint32_t count, roberts_vec3 n, double allowed, uint32_t *deepest);

/* Returns how far a face without area, which has no normal, is from straight: the greatest distance of a corner from
 * the line through the first corner and the one farthest from it. */
double polygon_spread(const roberts_vec3 *corner, uint32_t count);

/* ---- is a solid convex? ---------------------------------------------------------------------------------------- */

/* Checks a solid whose edges are paired. Returns ROBERTS_OK, _NOT_PLANAR, _NOT_CONVEX, _FLAT or _NO_MEMORY; `error`
 * then names the solid, the face or vertex, and the amount, in the numbers of its file. Marks faces that must take
 * their planes from their neighbours. */
roberts_status solid_check(const roberts_scene *scene, solid_frame *frame, roberts_error *error);

#endif
