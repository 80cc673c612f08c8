/* intervals.h - hidden parts of one edge and their union.
 *
 * A convex solid hides one interval of an edge, because the volume behind it is convex (see front_test.h). Parts that
 * overlap or touch are joined, whether they come from different solids or from the faces of one solid with many
 * faces.
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
#ifndef ROBERTS_HIDE_INTERVALS_H
#define ROBERTS_HIDE_INTERVALS_H

#include "hide/tolerance.h"
#include "hide/types.h"

typedef struct hide_solid_interval {
    hide_interval part;
    uint32_t solid;
} hide_solid_interval;

typedef struct hide_intervals {
    hide_solid_interval *item; /* [count] */
    size_t count, room;
} hide_intervals;

/* Is every point between the two parts within the reach of one of them? */
static inline bool hide_intervals_touch(const hide_interval *a, const hide_interval *b)
{
    return a->r0 <= b->r1 && b->r0 <= a->r1;
}

/* Returns the union of two parts. Its reach is the larger one, even if that belongs to the shorter part. */
static inline hide_interval hide_intervals_joined(const hide_interval *a, const hide_interval *b)
{
    return (hide_interval){lesser(a->t0, b->t0), greater(a->t1, b->t1), lesser(a->r0, b->r0), greater(a->r1, b->r1)};
}

bool hide_intervals_add_closely(hide_intervals *intervals, uint32_t solid, hide_interval *part);

/* Adds a part that a front of `solid` hides. The part is joined with the parts it overlaps or touches, as long as these
 * are few, and `*part` becomes the union. Usually there is one part, or none. False: no memory. */
static inline bool hide_intervals_add(hide_intervals *intervals, uint32_t solid, hide_interval *part)
{
    hide_solid_interval *only = intervals->item;
    if (intervals->count == 1 && hide_intervals_touch(&only->part, part)) {
        only->part = *part = hide_intervals_joined(&only->part, part);
        only->solid = solid < only->solid ? solid : only->solid;
        return true;
    }
    if (intervals->count > 0 || intervals->room == 0)
        return hide_intervals_add_closely(intervals, solid, part);
    intervals->item[intervals->count++] = (hide_solid_interval){*part, solid};
    return true;
}

/* Adds a part that one face of `solid` hides to the hull of the parts of its other faces; `*part` becomes the hull.
 * Faces given to few digits, or cut by the near plane, leave gaps between them, but the solid has none. With very many
 * solids, one solid may have several hulls until hide_intervals_hulls_done(). False: no memory. */
bool hide_intervals_hull(hide_intervals *hulls, uint32_t solid, hide_interval *part);

/* Joins the hulls of each solid into one. */
void hide_intervals_hulls_done(hide_intervals *hulls);

/* Extends parts that come nearer than `epsilon` to an end of the edge to that end. */
static inline void hide_intervals_reach_ends(hide_intervals *intervals, double epsilon, double length)
{
    hide_interval *first = &intervals->item[0].part, *last = &intervals->item[intervals->count - 1].part;
    if (first->t0 * length <= epsilon)
        first->t0 = 0.0;
    if ((1.0 - last->t1) * length <= epsilon)
        last->t1 = 1.0;
}

/* Sorts several parts and joins those that touch. */
void hide_intervals_join(hide_intervals *intervals, double epsilon, double length);

/* Unites the parts in place. Afterwards they ascend and are disjoint, with more than `epsilon` between them and between
 * them and the ends of the edge. `length` is the edge's length in space, in the unit of epsilon. The `solid` of a union
 * is the smallest of its members'. */
static inline void hide_intervals_unite(hide_intervals *intervals, double epsilon, double length)
{
    if (intervals->count > 1)
        hide_intervals_join(intervals, epsilon, length);
    if (intervals->count)
        hide_intervals_reach_ends(intervals, epsilon, length);
}

/* Returns the number of the first part that ends after t; their count if none does. The parts are sorted and apart. */
size_t hide_intervals_first(const hide_intervals *intervals, double t);

/* Splits the part that contains t, if there is one, in two. False: no memory. */
bool hide_intervals_split(hide_intervals *intervals, double t);

/* ---- the reach of a part ----------------------------------------------------------------------------------------- */

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
