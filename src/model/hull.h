/* hull.h - convex hulls in place of what is no convex solid. */
#ifndef ROBERTS_MODEL_HULL_H
#define ROBERTS_MODEL_HULL_H

#include "model/components.h"
#include "model/scene.h"

/* ---- inputs ------------------------------------------------------------------------------------------------------ */

/* The inputs of a mesh, and those that have points without faces. */

/* Fewer points have no convex hull. */
enum { HULL_POINTS = 4 };

/* The vertices and faces of an input; all of the mesh where it was not read from inputs. */
typedef struct hull_input {
    size_t vertex, vertex_end, face, face_end;
} hull_input;

size_t hull_input_count(const roberts_mesh *mesh);
hull_input hull_input_at(const roberts_mesh *mesh, size_t i);

/* Whether some input has points and no face with three or more corners. */
bool hull_bare_input(const roberts_mesh *mesh);

/* The points of input i where it has no such face, else 0. */
size_t hull_bare_points(const roberts_mesh *mesh, size_t i);

/* Adds to `faces` one face for each bare input of four points and more, which has all its points as corners: so it is
 * laid out as a component. These faces have numbers from mesh->face_count on. Returns ROBERTS_OK, _NO_MEMORY or _FLAT
 * (there are none but inputs of fewer points). */
roberts_status hull_add_inputs(polygons *faces, const roberts_mesh *mesh, roberts_error *error);

/* ---- hulls ------------------------------------------------------------------------------------------------------- */

/* Lays out the scene anew, whose components may be open: solids that solid_build() refuses get the faces of their hulls
 * in place of their own, numbered ROBERTS_NONE. Solids keep their order; flat ones are left out. Each input is
 * warned of: how many of its solids have been replaced, and why, and how many were flat.
 * options   tolerance, warnings, threads; the result does not depend on the last
 * Returns ROBERTS_OK, _NO_MEMORY, _BAD_NUMBER, _FLAT (there is nothing else) or _NOT_CONVEX (rounding was too much for
 * Qhull). */
roberts_status hull_solids(roberts_scene *scene, const roberts_mesh *mesh, const roberts_scene_options *options,
                           roberts_error *error);

#endif
