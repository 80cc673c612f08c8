/* reach.h - how far along an edge the solid that hides it is within epsilon.
 *
 * Two hidden parts of an edge join if every point of the gap between them is within epsilon of one of the two solids
 * that hide them. So each part keeps its reach: how far beyond its ends its own solid is that near. There the edge is
 * no farther than epsilon outside of any side, no farther than epsilon beyond the farthest corner, and no more than
 * `touch` before any plane. If the edge leaves a border at a flat angle, this is far more than epsilon along the edge.
 * But it is no farther than the border goes on: the nearest point of the solid is within two epsilons.
 *
 * Corners also end hidden parts. An edge that runs within epsilon outside of one side counts as on it. If the corner of
 * this side and the next is sharp, the edge may cross the line of the next side far beyond the corner. Then the hidden
 * part ends at the corner. */
#ifndef ROBERTS_HIDE_REACH_H
#define ROBERTS_HIDE_REACH_H

#include "hide/tolerance.h"

/* Where an edge crosses a border, out of the polygon F or into it: the side from corner `first` of F to corner `last`,
 * or the chord of the sides between them where these are straight. */
typedef struct reach_border {
    const hide_face *F;
    uint32_t first, last;
    bool out;
} reach_border;

/* Finds how far the edge is within epsilon of the border: beyond *t, where it crosses the border, or before *t, if it
 * comes in there. touch: how far the edge is within epsilon of the side's line, as a part of the edge. If *t is beyond
 * all corners, the farthest corner takes its place. */
double reach_along(const hide_space *space, const hide_edge *e, const reach_border *border, double touch, double *t);

/* Ends the part at the last and the first corner of F along the edge, if it goes on from there by more than epsilon. */
void reach_corners(const hide_space *space, const hide_edge *e, const hide_face *F, hide_interval *part);

/* Is reach_along() needed? */
static inline bool reach_is_plain(const hide_space *space, const hide_edge *e, double touch)
{
    return touch * e->length3 <= REACH_PLAIN * space->epsilon;
}

#endif
