/* bodies.h - scenes whose bodies are not all convex. */
#ifndef ROBERTS_MODEL_BODIES_H
#define ROBERTS_MODEL_BODIES_H

#include "model/scene.h"

/* What is left out, for warnings. */
typedef struct bodies_notes {
    size_t repeated; /* corners that repeat another of their face: of convex solids all, of others neighbours */
    size_t uncut;    /* faces that cross themselves too often to be cut; their sides are wires */
} bodies_notes;

/* Builds `scene`, which is empty: convex solids as usual, all other faces as closed and open bodies in convex pieces.
 * The caller adds the colours. known: it is certain that some component is not a convex solid.
 * Returns ROBERTS_OK, _NO_MEMORY, _BAD_NUMBER or _NOT_CLOSED (there is nothing to draw). */
roberts_status bodies_build(roberts_scene *scene, const roberts_mesh *mesh, const roberts_scene_options *options,
                            bool known, bodies_notes *notes, roberts_error *error);

/* The touching distance, as in the view: a part of the scene's diameter, or ulps of its largest coordinate; where
 * coordinates are 32-bit floats, at least the step between two of them. */
double bodies_touching(const roberts_scene *scene, const roberts_mesh *mesh);

#endif
