/* plain_bodies.h - bodies that are not convex, but need no cutting.
 *
 * A body is *plain* if it is as simple as most meshes are. Each face is a triangle, or another planar convex polygon.
 * Edges connect all faces, and no vertex touches an edge except at its ends. Such a body is built in place: nothing is
 * copied, sorted or renumbered. All other bodies go through bodies.c, which would give the same result for a plain
 * body. */
#ifndef ROBERTS_MODEL_PLAIN_BODIES_H
#define ROBERTS_MODEL_PLAIN_BODIES_H

#include "model/face_pieces.h"
#include "model/repeated_solids.h"

/* PLAIN_NO: some component is not plain. */
typedef enum plain_answer { PLAIN_NO, PLAIN_YES, PLAIN_NO_MEMORY } plain_answer;

/* Makes bodies of the components with mark[s] != 0, which are not convex solids, if all of these are plain. The other
 * components are built already. The scene is laid out, every vertex and face belongs to a component, and the edges of
 * repeated solids are stored, if these are closed. list: the patterns of the components. rules: see bodies_rules().
 * If the answer is not PLAIN_YES, the scene can only be cleared. */
plain_answer plain_bodies_build(roberts_scene *scene, const uint8_t *mark, const repeated_solids *list,
                                const face_rules *rules);

#endif
