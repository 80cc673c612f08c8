/* bodies.h - scenes in which not all bodies are convex solids. */
#ifndef ROBERTS_MODEL_BODIES_H
#define ROBERTS_MODEL_BODIES_H

#include "model/scene.h"

/* Builds `scene`, which is empty: convex solids as ever, all else as closed and open bodies of faces in convex
 * pieces. Colours are left to the caller. known: some component is closed and no convex solid. Returns ROBERTS_OK,
 * _NO_MEMORY, _BAD_NUMBER or _NOT_CLOSED (there is nothing to draw). */
roberts_status bodies_build(roberts_scene *scene, const roberts_mesh *mesh, const roberts_scene_options *options,
                            bool known, roberts_error *error);

/* Has the mesh, of which `scene` has the convex solids and nothing else is left but elements of one and two corners,
 * elements of two that are no edges? False: no memory. */
bool bodies_wires(const roberts_scene *scene, const roberts_mesh *mesh, bool *found);

#endif
