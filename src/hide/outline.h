/* outline.h - the outline of a solid in the picture: the polygon used by tests 2 to 4.
 *
 * The outline of a convex solid is the cycle of its edges with exactly one front face, and it is convex. But a solid
 * given to few digits is convex only within its tolerance, and a face that is edge-on within epsilon is left out. Then
 * the cycle may turn inward, run out along a sliver and back, or fall apart. In these cases the convex hull of all
 * vertices replaces it. */
#ifndef ROBERTS_HIDE_OUTLINE_H
#define ROBERTS_HIDE_OUTLINE_H

#include "hide/fronts.h"

/* Joins the solid's edges with exactly one front face to a counter-clockwise cycle. Returns its number of corners, or 0
 * if the edges do not form one cycle. next, outline: room for all vertices of the solid. */
uint32_t outline_cycle(const hide_fronts *fronts, uint32_t solid, uint32_t *next, uint32_t *outline);

/* Is the outline a convex polygon? size: its width plus its height. */
bool outline_is_convex(const hide_fronts *fronts, const uint32_t *outline, uint32_t corners, double size);

/* Finds the convex hull of the solid's vertices in the picture, counter-clockwise. Returns its number of corners, or 0
 * if it has no area. order, outline: room for all vertices of the solid. */
uint32_t outline_hull(const hide_fronts *fronts, uint32_t solid, uint32_t *order, uint32_t *outline);

#endif
