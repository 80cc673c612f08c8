/* reach.h - how far the place where an edge is hidden reaches, within epsilon of what hides it.
 *
 * Two hidden parts of an edge join where no point of the gap between them is farther than epsilon from both solids
 * that hide them. So a part keeps how far along the edge its own solid is that near: beyond its end as long as the
 * edge is no farther than epsilon outside of any side, no farther than epsilon beyond the farthest corner, and no more
 * than `touch` before any plane. Where the edge runs away from a border at a flat angle this is far more than epsilon
 * along the edge, but no farther than the border goes on: the nearest point of the solid is within two epsilons.
 *
 * The same holds for what is hidden. An edge that runs within epsilon outside of one side counts as on it, and may
 * cross the line of the next side far beyond the corner of both, if that corner is sharp. There the hidden part ends
 * at the corner. */
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

/* How far the edge is within epsilon of the border, beyond *t, where it crosses it (before *t, where it comes in);
 * `touch`: how far it is within epsilon of the side's line, as a part of the edge. Where *t is beyond all corners, the
 * farthest takes its place. */
double reach_along(const hide_space *space, const hide_edge *e, const reach_border *border, double touch, double *t);

/* Ends the part at the last and the first corner of F, as the edge goes, where it goes on by more than epsilon. */
void reach_corners(const hide_space *space, const hide_edge *e, const hide_face *F, hide_interval *part);

/* Is reach_along() needed? */
static inline bool reach_is_plain(const hide_space *space, const hide_edge *e, double touch)
{
    return touch * e->length3 <= REACH_PLAIN * space->epsilon;
}

#endif
