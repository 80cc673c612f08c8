/* edge_crossings.h - lines in which a face ends on another one along an edge that is not drawn.
 *
 * An edge whose faces are flat to one another, or nearly so, is left out. As far as it lies inside of a face that it is
 * no side of, and that does not lie in one plane with its own faces, it is a line all the same: there its faces end on
 * that face. So does an edge of which a part lies on another edge that is left out, of faces in other planes: two tiled
 * surfaces pass through one another there. */
#ifndef ROBERTS_HIDE_EDGE_CROSSINGS_H
#define ROBERTS_HIDE_EDGE_CROSSINGS_H

#include "hide/fronts.h"
#include "model/crossing.h"

/* Appends these lines to found->item. Of found->touch, which it sorts, all pairs of faces are asked. False: no memory.
 */
bool edge_crossings_find(const hide_fronts *fronts, const crossing_rules *rules, crossing_list *found);

/* Is all of a body outside of the plane of some face of a convex solid, so that no faces of theirs cross? If it touches
 * that plane with more than a corner, neither has an edge there that is left out. False: it is not known. */
bool edge_crossings_apart(const hide_fronts *fronts, uint32_t solid, uint32_t body);

#endif
