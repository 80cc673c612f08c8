/* planar_map.h - segments of the picture as a planar map: nodes, and straight lines between them that meet in nodes
 * only.
 *
 * Ends that lie within the touching distance of one another become one node, the one of smallest number, which keeps
 * its coordinates. A node that lies within that distance of a line divides it. Where lines cross, both are divided at a
 * new node. Lines between the same two nodes are one. Divided lines bend a little, which may make new crossings; so all
 * this is repeated until nothing is left to do. Whether lines cross is decided by exact signs. So the result is planar,
 * whatever the rounding was. */
#ifndef ROBERTS_HIDE_PLANAR_MAP_H
#define ROBERTS_HIDE_PLANAR_MAP_H

#include "base/vec.h"

typedef struct planar_map {
    roberts_vec2 *node;  /* [node_count] some may be on no line */
    uint32_t (*line)[2]; /* [line_count] by their nodes, the smaller node first; each once */
    size_t node_count, line_count, node_room, line_room;
} planar_map;

/* Adds a segment; what has no length is left out. False: no memory. */
bool planar_map_add(planar_map *m, roberts_vec2 a, roberts_vec2 b);

/* Makes the map planar. False: no memory. */
bool planar_map_divide(planar_map *m, double touching);

void planar_map_free(planar_map *m);

#endif
