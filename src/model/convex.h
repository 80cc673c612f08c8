/* convex.h - whether faces and solids are convex. */
#ifndef ROBERTS_MODEL_CONVEX_H
#define ROBERTS_MODEL_CONVEX_H

#include "base/vec.h"
#include "model/solid.h"

/* ---- is a face convex? ----------------------------------------------------------------------------------------- */

/* Whether the polygon, which turns counter-clockwise seen from the end of its normal n, turns left at every corner and
 * once in all: strictly convex, decided without a tolerance. False does not yet mean that it is refused. */
bool polygon_strictly_convex(const roberts_vec3 *corner, uint32_t count, roberts_vec3 n);

/* How far the polygon is from convex: the greatest depth of a corner inside the hull of all corners (and which corner),
 * INFINITY where the corners do not go round that hull once, up to steps back of length `allowed`. Negative: no
 * memory. */
double polygon_dent(const roberts_vec3 *corner, uint32_t count, roberts_vec3 n, double allowed, uint32_t *deepest);

/* The same for a face without area, which has no normal: the greatest distance of a corner from the line through the
 * first corner and the one farthest from it. */
double polygon_spread(const roberts_vec3 *corner, uint32_t count);

/* ---- is a solid convex? ---------------------------------------------------------------------------------------- */

/* Checks a solid whose edges are paired. Returns ROBERTS_OK, _NOT_PLANAR, _NOT_CONVEX, _FLAT or _NO_MEMORY; `error`
 * then says which solid, face or vertex and how much, in the numbers of its file. Marks faces that have to lean on
 * their neighbours. */
roberts_status solid_check(const roberts_scene *scene, solid_frame *frame, roberts_error *error);

#endif
