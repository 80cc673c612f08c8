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

/* ---- is a solid convex? ---------------------------------------------------------------------------------------- */

/* Checks a solid whose edges are paired. Returns ROBERTS_OK, _NOT_PLANAR, _NOT_CONVEX, _FLAT or _NO_MEMORY; `error`
 * then names the solid, the face or vertex, and the amount, in the numbers of its file. Marks faces that must take
 * their planes from their neighbours. */
roberts_status solid_check(const roberts_scene *scene, solid_frame *frame, roberts_error *error);

/* ---- not convex at a glance ------------------------------------------------------------------------------------ */

enum { WORTH_A_GLANCE = 1000 }; /* faces */

/* Do a few faces and vertices show that solid s is certainly not convex? The scene is laid out, and its planes are not
 * yet fitted. */
bool solid_large_surely_not_convex(const roberts_scene *scene, uint32_t s, double tolerance);

/* The same, but false for small solids: checking these in full is fast. */
static inline bool solid_surely_not_convex(const roberts_scene *scene, uint32_t s, double tolerance)
{
    return scene->solid[s + 1].face - scene->solid[s].face >= WORTH_A_GLANCE &&
           solid_large_surely_not_convex(scene, s, tolerance);
}

#endif
