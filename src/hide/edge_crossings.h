/* edge_crossings.h - lines in which a face ends on another one along an edge that is not drawn.
 *
 * An edge is left out if its faces lie in one plane, or nearly so. But where it lies inside another face, and its own
 * faces lie on both sides of that face, it is drawn after all: its faces end there. The same holds where two edges that
 * are left out coincide, and the faces of each lie on both sides of the faces of the other: two tiled surfaces pass
 * through one another there.
 *
 * A union leaves out edges as well: the seams of flush bodies. A sheet in the plane of a seam meets the walls on both
 * sides of it, as if they were one. The sides there belong to several bodies. So each edge that may be a seam gives a
 * line wherever it touches a sheet, and the union decides what is drawn of it (model/union.h). */
#ifndef ROBERTS_HIDE_EDGE_CROSSINGS_H
#define ROBERTS_HIDE_EDGE_CROSSINGS_H

#include "hide/fronts.h"
#include "model/crossing.h"

/* Appends these lines to found->item. Sorts found->touch, and tests all its pairs of faces. False: no memory. */
bool edge_crossings_find(const hide_fronts *fronts, const crossing_rules *rules, crossing_list *found);

#endif
