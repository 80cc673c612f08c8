/* split.h - which faces form one solid, if more than two faces meet at an edge. */
#ifndef ROBERTS_MODEL_SPLIT_H
#define ROBERTS_MODEL_SPLIT_H

#include "model/solid.h"

/* Groups of faces. closed[g]: each edge of group g has two of its faces. Any other group is a connected piece that
 * could not be split completely. Some groups may be empty. */
typedef struct split_groups {
    uint32_t count;
    uint32_t *of;    /* [face_count] */
    uint8_t *closed; /* [count] */
} split_groups;

/* Groups the faces of solid 0 of `loose`, which is laid out. `edges` holds the result of edges_sort(). False: no
 * memory. */
bool split_faces(split_groups *groups, const roberts_scene *loose, const edge_scratch *edges);

void split_groups_free(split_groups *groups);

#endif
