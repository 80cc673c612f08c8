/* split.h - faces that meet in edges, two or more at each: which of them make up one solid. */
#ifndef ROBERTS_MODEL_SPLIT_H
#define ROBERTS_MODEL_SPLIT_H

#include "model/edges.h"

/* Groups of faces. Group g is closed, each of its edges having two of its faces, where closed[g] is set; each of the
 * other groups is a whole piece that hangs together by edges and does not come apart without a rest. Some may be
 * empty. */
typedef struct split_groups {
    uint32_t count;
    uint32_t *of;    /* [face_count] */
    uint8_t *closed; /* [count] */
} split_groups;

/* Groups the faces of solid 0 of `loose`, which is laid out, with edges_sort() done in `edges`. False: no memory. */
bool split_faces(split_groups *groups, const roberts_scene *loose, const edge_scratch *edges);

void split_groups_free(split_groups *groups);

#endif
