/* plain_bodies.h - bodies that are not convex, but need no cutting.
 *
 * A body is *plain* if it is as simple as most meshes are: each face is a triangle, or another convex polygon in one
 * plane; each edge has one face or two; the faces are connected by edges; and no
 * vertex touches a border but at its ends. Such a body is built where its component lies in the scene: nothing is
 * copied, sorted or numbered anew. All others go through bodies.c, which makes the same of a plain body. */
#ifndef ROBERTS_MODEL_PLAIN_BODIES_H
#define ROBERTS_MODEL_PLAIN_BODIES_H

#include "model/plain_edges.h"

/* Is it certain, after a look at a few faces and vertices, that solid s is not convex? The scene is laid out, its
 * planes are not fitted. False for small solids: they are quickly checked in full. */
bool plain_not_convex(const roberts_scene *scene, uint32_t s, double tolerance);

/* Makes bodies of the components that are not convex solids, mark[s] != 0, if all of these are plain. The others are
 * built already. The scene is laid out and has no vertices or faces that a component lacks; edges of repeated solids
 * are stored. If the answer is not PLAIN_YES, the scene can only be cleared. */
plain_answer plain_bodies_build(roberts_scene *scene, const uint8_t *mark, const roberts_scene_options *options,
                                double touching);

#endif
