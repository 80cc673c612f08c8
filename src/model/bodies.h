/* bodies.h - scenes whose bodies are not all convex. */
#ifndef ROBERTS_MODEL_BODIES_H
#define ROBERTS_MODEL_BODIES_H

#include "model/face_pieces.h"
#include "model/scene.h"

/* What was left out or cannot be right, for warnings. */
typedef struct bodies_notes {
    size_t repeated;    /* corners that repeat another of their face: in convex solids any, elsewhere adjacent ones */
    noted_faces bent;   /* cross or touch themselves and are not planar; they count as planar */
    noted_faces uncut;  /* cross themselves too often to be cut; their sides become wires */
    noted_faces copies; /* have the same corners as an earlier one; left out */
} bodies_notes;

/* Builds `scene`, which is empty: convex solids as usual, all other faces as closed and open bodies in convex pieces.
 * The caller adds the colours. known: some component is known not to be a convex solid. Returns ROBERTS_OK, _NO_MEMORY,
 * _BAD_NUMBER or _NOT_CLOSED (there is nothing to draw). */
roberts_status bodies_build(roberts_scene *scene, const roberts_mesh *mesh, const roberts_scene_options *options,
                            bool known, bodies_notes *notes, roberts_error *error);

/* Returns how faces of bodies that are not convex are cut into pieces; `point` is not set.
 *
 * The touching distance is that of the view: a fraction of the scene's diameter, or ulps of its largest coordinate. Of
 * 32-bit floats, and of rounded decimals, it is at least two units of their last place.
 *
 * `narrow` is the same without this rounding. In a closed body, a triangle of greater height is a face: its sides are
 * edges anyway. In an open one, where T-junctions may be closed within the touching distance, it has to be higher than
 * that, so that no side is divided at the corner opposite. */
face_rules bodies_rules(const roberts_scene *scene, const roberts_mesh *mesh, const roberts_scene_options *options);

#endif
