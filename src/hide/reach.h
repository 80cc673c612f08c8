/* reach.h - how far along an edge the solid that hides it is within epsilon.
 *
 * Two hidden parts of an edge join if every point of the gap between them is within epsilon of one of the two solids.
 * So each part has a reach: how far beyond its ends its solid is that near. Within the reach, the edge is at most
 * epsilon outside any side, at most epsilon beyond the farthest corner, and at most `touch` in front of any plane. If
 * the edge leaves a border at a small angle, the reach is much longer than epsilon. But it never goes past the end of
 * the border, so the nearest point of the solid is always within two epsilons.
 *
 * Corners also end hidden parts. An edge that runs within epsilon outside one side counts as on it. If the corner
 * between this side and the next is sharp, the edge may cross the line of the next side far beyond the corner. Then the
 * hidden part ends at the corner. */
#ifndef ROBERTS_HIDE_REACH_H
#define ROBERTS_HIDE_REACH_H

#include "hide/tolerance.h"

/* Where an edge crosses the border of polygon F, outward or inward: the side from corner `first` to corner `last`, or
 * the chord of collinear sides between them. */
typedef struct reach_border {
    const hide_face *F;
    uint32_t first, last;
    bool out;
} reach_border;

/* Returns how far the edge stays within epsilon of the border: beyond *t, where it crosses the border, or before *t if
 * it enters there. touch: how far it stays within epsilon of the side's line, in edge parameters. If *t is beyond all
 * corners, it is replaced by the farthest corner. */
double reach_along(const hide_space *space, const hide_edge *e, const reach_border *border, double touch, double *t);

/* Ends the part at the first and the last corner of F along the edge, if it extends more than epsilon past them. */
void reach_corners(const hide_space *space, const hide_edge *e, const hide_face *F, hide_interval *part);

/* Is the reach so short that reach_along() is not needed? */
static inline bool reach_is_plain(const hide_space *space, const hide_edge *e, double touch)
{
    return touch * e->length3 <= REACH_PLAIN * space->epsilon;
}

#endif
