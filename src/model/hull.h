/* hull.h - convex hulls in place of what is no convex solid. */
#ifndef ROBERTS_MODEL_HULL_H
#define ROBERTS_MODEL_HULL_H

#include "model/scene.h"

/* Lays out the scene anew, whose components may be open: solids that solid_build() refuses get the faces of their hulls in
 * place of their own, numbered ROBERTS_NONE. Solids keep their order; flat ones are left out. Each input is
 * warned of: how many of its solids have been replaced, and why, and how many were flat.
 * options   tolerance, warnings, threads; the result does not depend on the last
 * Returns ROBERTS_OK, _NO_MEMORY, _BAD_NUMBER, _FLAT (there is nothing else) or _NOT_CONVEX (rounding was too much for
 * Qhull). */
roberts_status hull_solids(roberts_scene *scene, const roberts_mesh *mesh, const roberts_scene_options *options,
                           roberts_error *error);

#endif
