/* ahead.h - what is hidden of the edges, found in the order of the picture and kept until it is their solid's turn.
 *
 * Edges come out in the order of the file. Where solids that follow one another in it lie anywhere in the picture, or
 * those behind one another anywhere in the file, and they are more than a cache holds, each edge would fetch the fronts
 * around it from memory; so there solids are taken as they lie beside one another first, and of their edges no more is kept
 * than the parameters of what is hidden; where hidden segments are wanted, with the solids seen there. */
#ifndef ROBERTS_HIDE_AHEAD_H
#define ROBERTS_HIDE_AHEAD_H

#include "hide/edge.h"

#define AHEAD_CHUNK 64 /* solids: their edges are kept together */

/* An edge of which something may be visible, or is wanted though it is hidden. */
typedef struct ahead_line {
    uint32_t edge, parts;
} ahead_line;

typedef struct ahead_chunk {
    ahead_line *line; /* [line_count] */
    double *t;        /* [2 part_count] t0, t1 of each line's parts */
    uint32_t *by;     /* [part_count] who is seen there; NULL: not wanted */
    size_t line_count, line_room, part_count, t_room, by_room;
    uint32_t first_line[AHEAD_CHUNK + 1], first_part[AHEAD_CHUNK + 1]; /* of each solid; the next one's is the end */
} ahead_chunk;

typedef struct ahead {
    uint32_t count, chunks; /* of solids; of chunks, if any are kept */
    uint32_t *order;        /* [count] solids; NULL: the order of the file serves as well, nothing is kept */
    uint32_t *place;        /* [count] where in `order` a solid is */
    ahead_chunk *chunk;     /* [chunks] one for every AHEAD_CHUNK solids of `order` */
} ahead;

/* Finds the order; depth: mean number of fronts' boxes over a point of the picture. False: no memory; ahead_free() is due in any case. */
bool ahead_init(ahead *a, const hide_picture *picture, double depth);
void ahead_free(ahead *a);

/* Keeps the worker's lines, of the solid order[place], as hide_worker_run() has left them; within a chunk solids come one
 * after the other. Of a solid that is culled the lines are none. False: no memory. */
bool ahead_keep(ahead *a, uint32_t place, const hide_worker *w);

/* Asks for what will be wanted at the recalling of the solids soon after this one: their lines lie anywhere. */
void ahead_fetch(const ahead *a, uint32_t solid);

/* Gives the worker the solid's lines back; those that are wholly hidden only where it keeps hidden parts. False: no memory. */
bool ahead_recall(const ahead *a, uint32_t solid, hide_worker *w);

#endif
