/* cut_ring.h - the cuts of a body's faces, joined into one ring: the border of its cap. */
#ifndef ROBERTS_VIEW_CUT_RING_H
#define ROBERTS_VIEW_CUT_RING_H

#include "roberts.h"

/* A stretch of the cut, where a clipped face ends in the plane. */
typedef struct cut_line {
    uint32_t from, to;
    int32_t winding; /* how often it counts from `from` to `to`; 0: parity decides what the body fills */
    uint32_t left;   /* private */
} cut_line;

typedef struct cut_lines {
    cut_line *item;
    size_t count, room;
} cut_lines;

/* Joins all lines, of which there is at least one. point: of the vertices; touching: ends no farther apart are one,
 * model units. Lines may be added and get other ends. *ring: [*length] vertices; the last repeats the first; freed by
 * the caller in any case. *length is 0 if no line has two ends. False: no memory. */
bool cut_ring(cut_lines *lines, const roberts_vec3 *point, double touching, uint32_t **ring, size_t *length);

#endif
