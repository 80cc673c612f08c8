/* segments.h - compares segments by what they are parts of. */
#ifndef ROBERTS_TESTS_SEGMENTS_H
#define ROBERTS_TESTS_SEGMENTS_H

#include <math.h>
#include <stdbool.h>

#include "roberts.h"

/* Are both parts of one edge, or of one intersection line? */
static inline bool same_edge(const roberts_segment *a, const roberts_segment *b)
{
    bool crossing = a->line == ROBERTS_INTERSECTION || a->v0 == ROBERTS_NONE;
    return a->solid == b->solid && a->v0 == b->v0 && a->v1 == b->v1 && (!crossing || a->edge == b->edge);
}

/* Compares for qsort() by solid, v0, v1 and t. */
static inline int compare_segments(const void *pa, const void *pb)
{
    const roberts_segment *a = pa, *b = pb;
    if (a->solid != b->solid)
        return a->solid < b->solid ? -1 : 1;
    if (a->v0 != b->v0)
        return a->v0 < b->v0 ? -1 : 1;
    if (a->v1 != b->v1)
        return a->v1 < b->v1 ? -1 : 1;
    return (a->t0 > b->t0) - (a->t0 < b->t0);
}

/* Returns the distance of a point of the picture from the segment. */
static inline double distance_to(const roberts_segment *s, double x, double y)
{
    double dx = s->p1.x - s->p0.x, dy = s->p1.y - s->p0.y, length2 = dx * dx + dy * dy;
    double t = length2 > 0 ? ((x - s->p0.x) * dx + (y - s->p0.y) * dy) / length2 : 0;
    t = fmin(fmax(t, 0), 1);
    return hypot(s->p0.x + t * dx - x, s->p0.y + t * dy - y);
}

#endif
