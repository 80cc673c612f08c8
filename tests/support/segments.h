/* segments.h - compares segments by what they are parts of. */
#ifndef ROBERTS_TESTS_SEGMENTS_H
#define ROBERTS_TESTS_SEGMENTS_H

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

#endif
