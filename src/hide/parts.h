/* parts.h - hidden parts of one edge, solid by solid, and their union.
 *
 * What one convex solid hides of an edge is one interval, because the volume behind it is convex: the parts by its faces
 * only add up to it, and their hull leaves no gap between two faces. Parts of different solids are joined where they
 * overlap or touch. */
#ifndef ROBERTS_HIDE_PARTS_H
#define ROBERTS_HIDE_PARTS_H

#include "hide/space.h"

typedef struct hide_solid_part {
    hide_part part;
    uint32_t solid;
} hide_solid_part;

typedef struct hide_parts {
    hide_solid_part *item; /* [count]; one per solid */
    size_t count, room;
} hide_parts;

/* Adds what a face of `solid` hides; `*slot` is that solid's place in the list, or SIZE_MAX while it has none. False: no
 * memory. */
bool hide_parts_add(hide_parts *parts, uint32_t solid, hide_part part, size_t *slot);

/* Unites the parts in place: afterwards they ascend and are disjoint, with more than `epsilon` between them and between
 * them and the ends of the edge, `length` long (in space, the unit of epsilon). `solid` of a union is that of one of
 * its members. */
void hide_parts_unite(hide_parts *parts, double epsilon, double length);

#endif
