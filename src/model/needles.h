/* needles.h - faces so narrow that the rounding of their coordinates has turned their planes. */
#ifndef ROBERTS_MODEL_NEEDLES_H
#define ROBERTS_MODEL_NEEDLES_H

#include "model/scene.h"

/* Finds the needles of the bodies that are not convex, and the faces that stand in for them: scene_surface.needle.
 * Marks their edges as EDGE_NEEDLE. Needs planes or bends, and edges. False: no memory. */
bool needles_find(roberts_scene *scene);

#endif
