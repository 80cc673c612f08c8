/* plain_bodies.h - bodies that are not convex, but need no cutting.
 *
 * A body is *plain* if it is as simple as most meshes are: each face is a triangle, or another convex polygon in one
 * plane; nearly all edges have two faces, and no vertex touches another one but at its ends; the faces are connected by
 * edges. Such a body is built where its component lies in the scene: nothing is copied, sorted or numbered anew. All
 * others go through bodies.c, which makes the same of a plain body. */
#ifndef ROBERTS_MODEL_PLAIN_BODIES_H
#define ROBERTS_MODEL_PLAIN_BODIES_H

#include "model/plain_edges.h"

enum { PLAIN_LARGE = 1000 }; /* faces */

/* Is it certain, after a look at a few faces and vertices, that solid s is not convex? The scene is laid out, its
 * planes are not fitted. */
bool plain_large_not_convex(const roberts_scene *scene, uint32_t s, double tolerance);

/* The same; false for small solids, which are quickly checked in full. */
static inline bool plain_not_convex(const roberts_scene *scene, uint32_t s, double tolerance)
{
    return scene->solid[s + 1].face - scene->solid[s].face >= PLAIN_LARGE &&
           plain_large_not_convex(scene, s, tolerance);
}

/* Makes bodies of the components that are not convex solids, mark[s] != 0, if all of these are plain. The others are
 * built already. The scene is laid out and has no vertices or faces that a component lacks; edges of repeated solids
 * are stored. If the answer is not PLAIN_YES, the scene can only be cleared. */
plain_answer plain_bodies_build(roberts_scene *scene, const uint8_t *mark, const roberts_scene_options *options,
                                double touching);

#endif
