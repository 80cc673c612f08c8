/* edge_crossings.h - lines in which a face ends on another one along an edge that is not drawn.
 *
 * An edge is left out if its faces are flat to one another, or nearly so. As far as it lies inside a face, and its own
 * faces lie on both sides of that face, it is a line all the same: its faces end there. The same holds where two edges
 * that are left out lie on one another, and the faces of each lie on both sides of those of the other: two tiled
 * surfaces pass through one another there. */
#ifndef ROBERTS_HIDE_EDGE_CROSSINGS_H
#define ROBERTS_HIDE_EDGE_CROSSINGS_H

#include "hide/fronts.h"
#include "model/crossing.h"

/* Appends these lines to found->item. Of found->touch, which it sorts, all pairs of faces are asked. False: no memory.
 */
bool edge_crossings_find(const hide_fronts *fronts, const crossing_rules *rules, crossing_list *found);

#endif
