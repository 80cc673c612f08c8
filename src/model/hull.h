/* hull.h - convex hulls in place of what is no convex solid. */
#ifndef ROBERTS_MODEL_HULL_H
#define ROBERTS_MODEL_HULL_H

#include "model/polygons.h"
#include "model/scene.h"
#include "model/solid_build.h"

/* Whether some input has points and no face with three or more corners. */
bool hull_bare_input(const roberts_mesh *mesh);

/* Adds to `faces` one face for each bare input, which has all its points as corners: so it is laid out as a component.
 * These faces have numbers from mesh->face_count on. Returns ROBERTS_OK, _NO_MEMORY or _FLAT (fewer than four points). */
roberts_status hull_add_inputs(polygons *faces, const roberts_mesh *mesh, roberts_error *error);

/* Lays out the scene anew, whose components may be open: solids that solid_build() refuses get the faces of their hulls in
 * place of their own, numbered ROBERTS_NONE. Solids keep their order; flat ones are left out with a warning for each input.
 * options   tolerance, warnings, threads; the result does not depend on the last
 * Returns ROBERTS_OK, _NO_MEMORY, _BAD_NUMBER, _FLAT (an input has nothing else) or _NOT_CONVEX (rounding was too much for
 * Qhull). */
roberts_status hull_solids(roberts_scene *scene, const roberts_mesh *mesh, const roberts_scene_options *options,
                           roberts_error *error);

#endif
