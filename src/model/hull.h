/* hull.h - convex hulls in place of solids that are not convex. */
#ifndef ROBERTS_MODEL_HULL_H
#define ROBERTS_MODEL_HULL_H

#include "model/components.h"
#include "model/scene.h"

/* ---- inputs ---------------------------------------------------------------------------------------------------- */

/* The inputs (files) of a mesh. A bare input has points, but no face of three or more corners. */

/* The least number of points with a convex hull. */
enum { HULL_POINTS = 4 };

/* Is there a bare input? */
bool hull_bare_input(const roberts_mesh *mesh);

/* Adds one face for each bare input with at least four points. All its points are corners, so each input becomes a
 * component. These faces are numbered from mesh->face_count on. Returns ROBERTS_OK, _NO_MEMORY or _FLAT (the mesh has
 * only inputs of fewer points). */
roberts_status hull_add_inputs(polygons *faces, const roberts_mesh *mesh, roberts_error *error);

/* ---- hulls ----------------------------------------------------------------------------------------------------- */

/* Lays out the scene again: a solid that solid_build() refuses gets the faces of its hull, which have no number
 * (ROBERTS_NONE). Components may be open. Solids keep their order; flat ones are left out. For each input, a warning
 * says how many solids were replaced and why, and how many were flat.
 * options   tolerance, warnings, threads; the number of threads does not change the result
 * Returns ROBERTS_OK, _NO_MEMORY, _BAD_NUMBER, _FLAT (nothing else is left) or _NOT_CONVEX (rounding was too much for
 * Qhull). */
roberts_status hull_solids(roberts_scene *scene, const roberts_mesh *mesh, const roberts_scene_options *options,
                           roberts_error *error);

#endif
