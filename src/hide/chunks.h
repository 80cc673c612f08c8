/* chunks.h - segments that threads find in any order, given in the order of their solids.
 *
 * Solids are worked on in chunks. Any thread takes the next one, and no thread waits for another: what it has found it
 * leaves in the chunk's slot, and goes on. Whichever thread then sees the chunk whose turn it is lays it down, and all
 * that follow and are there. Only a thread that is a whole round of slots ahead has to wait. */
#ifndef ROBERTS_HIDE_CHUNKS_H
#define ROBERTS_HIDE_CHUNKS_H

#include <stdatomic.h>
#include <stdbool.h>

#include "roberts.h"

/* What is found of one chunk. */
typedef struct hide_chunk {
    roberts_segment *segment; /* [count] */
    size_t count, room;
    size_t place;           /* of its first segment in the drawing */
    _Atomic uint32_t stage; /* 2 k: free for chunk k, or at work on it; 2 k + 1: chunk k is found */
} hide_chunk;

typedef struct chunks {
    hide_chunk *slot; /* [slots] chunk k is found in slot k % slots */
    uint32_t slots, total;
    roberts_segment_fn *each; /* takes the segments; NULL: the drawing keeps them */
    void *context;
    roberts_drawing *drawing;
    size_t room;              /* of drawing->segment */
    _Atomic uint32_t taken;   /* the next to be worked on */
    _Atomic uint32_t placed;  /* the next to be given away, or to get its place in the drawing */
    _Atomic uint32_t copying; /* threads that write to the drawing, which must stay where it is */
    atomic_bool placing;      /* some thread gives away or gives places */
    atomic_int status;        /* roberts_status; what is not ROBERTS_OK ends the work */
} chunks;

/* For `total` chunks found by `threads` threads. False: no memory; chunks_free() is due in any case. */
bool chunks_init(chunks *c, uint32_t total, int threads, roberts_drawing *drawing, roberts_segment_fn *each,
                 void *context);
void chunks_free(chunks *c);

/* The next chunk, its number in `*k`, to be filled; NULL: there is no more, or the work is over for what `status` says. */
hide_chunk *chunks_take(chunks *c, uint32_t *k);

/* The chunk is full. When the last thread has returned from its last call, all segments are where they belong. */
void chunks_done(chunks *c, uint32_t k);

/* Ends the work, unless it has ended already. */
void chunks_fail(chunks *c, roberts_status status);

#endif
