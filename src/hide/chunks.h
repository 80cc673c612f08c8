/* chunks.h - segments that threads find in any order, given in the order of their solids.
 *
 * Solids are worked on in chunks. Any thread takes the next few, one run: what neighbours ask for lies together, and is best
 * asked for by one core. No thread waits for another: chunks that are found and whose turn has not come stay with their
 * thread, which looks after every chunk whether it has, and then gives them away itself or lays them down: they are still
 * in its cache. Only a thread with a whole queue of them has to wait. */
#ifndef ROBERTS_HIDE_CHUNKS_H
#define ROBERTS_HIDE_CHUNKS_H

#include <stdatomic.h>
#include <stdbool.h>

#include "base/threads.h"
#include "roberts.h"

/* What is found of one chunk. */
typedef struct hide_chunk {
    roberts_segment *segment; /* [count] */
    size_t count, room;
    uint32_t number;
} hide_chunk;

/* A run has at most so many chunks; and so many of a thread may wait for their turn: its run, while those before it are at
 * work, and more, so that a thread that is slow or put aside by the system does not stop the others. */
enum { CHUNKS_RUN = 16, CHUNKS_WAITING = 3 * CHUNKS_RUN };

/* The chunks of one thread: those waiting in the order of their numbers, a ring, and those that are free. */
typedef struct chunk_queue {
    hide_chunk chunk[CHUNKS_WAITING];
    hide_chunk *waiting[CHUNKS_WAITING], *spare[CHUNKS_WAITING]; /* spare: last the one used last */
    uint32_t first, count;                                       /* of those waiting */
    uint32_t next, end;                                          /* of the run at work */
    char apart[THREADS_APART];
} chunk_queue;

typedef struct chunks {
    chunk_queue *queue; /* [threads] */
    int threads;
    uint32_t total, run;      /* run: chunks of one */
    roberts_segment_fn *each; /* takes the segments; NULL: the drawing keeps them */
    void *context;
    _Atomic uint32_t taken;   /* runs */
    atomic_int status;        /* roberts_status; what is not ROBERTS_OK ends the work */
    _Atomic uint32_t turn;    /* of the chunk that is given away or placed next; its thread alone may touch: */
    roberts_drawing *drawing; /* (whose segments may be written by those whose turn it was) */
    size_t room;              /* of drawing->segment */
    _Atomic uint32_t copying; /* threads that write to the drawing, which must stay where it is */
} chunks;

/* For `total` chunks found by `threads` threads. False: no memory; chunks_free() is due in any case. */
bool chunks_init(chunks *c, uint32_t total, int threads, roberts_drawing *drawing, roberts_segment_fn *each,
                 void *context);
void chunks_free(chunks *c);

/* The next chunk for thread `self`, counted from 0, to be filled; NULL: there is no more, or the work is over for what
 * `status` says. When all threads have got NULL, or have failed, all segments are where they belong. */
hide_chunk *chunks_take(chunks *c, int self);

/* The chunk that the thread has taken is full. */
void chunks_done(chunks *c, int self, hide_chunk *chunk);

/* Ends the work, unless it has ended already. */
void chunks_fail(chunks *c, roberts_status status);

#endif
