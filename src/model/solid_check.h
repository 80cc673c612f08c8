/* solid_check.h - whether a closed component is a convex solid, within the tolerance. */
#ifndef ROBERTS_MODEL_SOLID_CHECK_H
#define ROBERTS_MODEL_SOLID_CHECK_H

#include "model/solid_frame.h"

/* Checks a solid whose edges are paired. Returns ROBERTS_OK, _NOT_PLANAR, _NOT_CONVEX, _FLAT or _NO_MEMORY; `error` then
 * says which solid, face or vertex and how much, in the numbers of its file. Marks faces that have to lean on their neighbours. */
roberts_status solid_check(const roberts_scene *scene, solid_frame *frame, roberts_error *error);

#endif
