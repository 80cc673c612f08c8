/* blocks.h - components that follow one another in the file, one behind the other. */
#ifndef ROBERTS_MODEL_BLOCKS_H
#define ROBERTS_MODEL_BLOCKS_H

#include "model/patterns.h"
#include "model/polygons.h"

/* Where every vertex is used and the components' vertices and faces follow one another without a gap, each component one
 * like a sphere and no corner repeating another of its face: fills in scene->solid, the counts, and the solids' patterns, and
 * sets *found. Else nothing is changed. False: no memory. */
bool blocks_find(roberts_scene *scene, const polygons *faces, patterns *list, bool *found);

#endif
