/* schedule.h - which solids a thread takes and in what order, and how the threads' results are put into the order of
 * the file. Nothing here changes the results.
 *
 * 1. Tiles: fronts are built tile by tile. If covers are kept, the picture is divided into squares of TILE_CELLS cells,
 *    and a tile holds the solids whose middle lies in its square. So the covers that a tile touches stay in the cache.
 *    Tiles are taken in rounds. The tiles of a round are not neighbours, and a solid reaches out of its tile by less
 *    than half a tile. So solids of different tiles of a round never read or write the same cover, and the number of
 *    threads does not change what is culled. The few solids that reach farther form a tile of their own, the first
 *    round. Without covers, a tile holds consecutive solids of the file, and there is one round.
 *
 * 2. The order of the picture: lines are written in the order of the file. But consecutive solids of the file may lie
 *    anywhere in the picture. If there are more solids than the cache holds, each edge would fetch the fronts around it
 *    from memory. Then all solids are hidden beforehand, in the order in which they lie in the picture. The parameters
 *    of the hidden parts are kept until the solid's turn comes, and if hidden lines are wanted, also the solid seen.
 *
 * 3. Chunks: segments are found in chunks of solids. A thread takes a run of a few consecutive chunks, since neighbours
 *    meet the same fronts. A finished chunk waits with its thread until its turn comes. After each chunk the thread
 *    looks again, and passes on the segments whose turn has come while they are still in its cache. A thread waits for
 *    others only when its queue is full. */
#ifndef ROBERTS_HIDE_SCHEDULE_H
#define ROBERTS_HIDE_SCHEDULE_H

#include <stdatomic.h>
#include <stdbool.h>

#include "base/threads.h"
#include "hide/edge.h"
#include "hide/fronts.h"
#include "roberts.h"

/* ---- tiles ---- */

/* The first round has one tile, for the solids that reach far. The other four rounds take the tiles in even or odd
 * columns and even or odd rows. */
enum { TILE_ROUNDS = 5 };

/* The number of solids, faces and vertices bounds what a tile may write to the arrays of hide_fronts: a convex solid
 * has at most one whole front, no more front faces than faces, and no more corners in its outline than vertices;
 * another body has no more fronts than faces. So each tile has its own part of the arrays from the beginning. Unused
 * entries are never touched. */
typedef struct front_tile {
    uint32_t first, end;                 /* of tiles.solid */
    uint32_t first_whole, first_surface; /* where its parts of hide_fronts.front begin: whole fronts, and faces of
                                            bodies that are not convex */
    uint32_t whole, surface;             /* the next entries to be written there ... */
    uint32_t face, outline;              /* ... and in the arrays of faces and outlines */
    uint32_t expected_face, end_face;    /* the faces before this one have memory; where the tile's faces end */
    hide_front *single;                  /* [single_count] faces of convex solids, as fronts of their own */
    hide_box *single_box;
    size_t single_count, single_room, single_box_room;
    size_t faces, back, edge_on, culled;
    uint32_t most_corners;
    double hull_gap;
    char apart[THREADS_APART];
} front_tile;

typedef struct tiles {
    front_tile *tile;
    uint32_t count, round[TILE_ROUNDS + 1]; /* the first tile of each round, and the end of the last round */
    uint32_t *solid;                        /* tile by tile; NULL: in the order of their numbers */
} tiles;

/* Makes the tiles. `fronts` has the boxes of its solids and the frame of its covers. threads: upper bound. False: no
 * memory; call tiles_free() in any case. */
bool tiles_make(tiles *t, const hide_fronts *fronts, int threads);
void tiles_free(tiles *t);

/* Sorts the solids of a tile, nearest first, ties by number. False: no memory. */
bool tiles_order(tiles *t, const front_tile *of, const hide_fronts *fronts);

/* ---- the order of the picture ---- */

#define KEPT_SOLIDS 64 /* solids whose lines are kept together */

/* A line that may be visible somewhere, or of which hidden parts are wanted. */
typedef struct kept_line {
    uint32_t edge, parts;
} kept_line;

typedef struct kept_chunk {
    kept_line *line; /* [line_count] */
    double *t;       /* [2 part_count] t0, t1 of each line's parts */
    uint32_t *by;    /* [part_count] the solid seen there; NULL: not wanted */
    size_t line_count, line_room, part_count, t_room, by_room;
    uint32_t first_line[KEPT_SOLIDS + 1], first_part[KEPT_SOLIDS + 1]; /* of each solid, and the end of the last one */
} kept_chunk;

typedef struct picture_order {
    uint32_t solids;        /* of the scene */
    uint32_t count, chunks; /* of `solid`; of `chunk` */
    uint32_t *solid; /* [count] those with lines, in this order; NULL: the order of the file is as good, and nothing is
                        kept */
    uint32_t *place; /* [solids] the place of each in `solid`; ROBERTS_NONE: it has no lines */
    kept_chunk *chunk; /* [chunks] each has KEPT_SOLIDS solids */
} picture_order;

/* Finds the order. depth: mean number of fronts' boxes over a point of the picture. False: no memory;
 * call picture_order_free() in any case. */
bool picture_order_init(picture_order *o, const hide_fronts *fronts, double depth);
void picture_order_free(picture_order *o);

/* Stores the worker's lines, those of the solid at `place`, as hide_worker_run() has left them. The solids of a chunk
 * come one after the other. A solid that is culled has no lines. False: no memory. */
bool picture_order_keep(picture_order *o, uint32_t place, const hide_worker *w);

/* Prefetches the lines of solids that will be recalled soon after this one. They may lie anywhere in memory. */
void picture_order_fetch(const picture_order *o, uint32_t solid);

/* Gives the solid's lines back to the worker. Lines that are wholly hidden are given back only if hidden parts are
 * kept. False: no memory. */
bool picture_order_recall(const picture_order *o, uint32_t solid, hide_worker *w);

/* ---- chunks ---- */

/* The state of a visible segment that the drawing leaves out. Only a receiver for regions gets such segments. */
#define SEGMENT_LEFT_OUT (ROBERTS_CLIPPED + 1)

/* The segments of one chunk. */
typedef struct hide_chunk {
    roberts_segment *segment; /* [count] */
    size_t count, room;
    uint32_t number;
    const roberts_receiver *to; /* takes the segments while a single thread fills the chunk; NULL: they stay */
    size_t given;               /* segments that the receiver has taken */
    bool stopped;               /* the receiver stops the work */
} hide_chunk;

/* Gives the segments of a chunk to a receiver, so that the chunk is empty. False: it stops the work. */
bool chunk_give(hide_chunk *chunk, const roberts_receiver *to);

/* CHUNKS_RUN: the most chunks in a run. CHUNKS_WAITING: the most chunks of a thread that may wait for their turn. It is
 * more than a run, so that a thread that the system delays does not stop the others. */
enum { CHUNKS_RUN = 16, CHUNKS_WAITING = 3 * CHUNKS_RUN };

/* The chunks of one thread: those that wait, as a ring in the order of their numbers, and those that are free. */
typedef struct chunk_queue {
    hide_chunk chunk[CHUNKS_WAITING];
    hide_chunk *waiting[CHUNKS_WAITING], *spare[CHUNKS_WAITING]; /* spare: the one used last is the last one */
    uint32_t first, count;                                       /* of those that wait */
    uint32_t next, end;                                          /* of the current run */
    char apart[THREADS_APART];
} chunk_queue;

typedef struct chunks {
    chunk_queue *queue; /* [threads] */
    int threads;
    uint32_t total, run;        /* chunks in all, and in a run */
    const roberts_receiver *to; /* receives the segments; NULL: the drawing keeps them */
    _Atomic uint32_t taken;     /* runs that threads have taken */
    atomic_int status;          /* roberts_status; anything but ROBERTS_OK ends the work */
    _Atomic uint32_t turn;      /* the chunk whose turn it is. Only its thread may change `drawing` and `room` */
    roberts_drawing *drawing;   /* (threads that had their turn may still write segments) */
    size_t room;                /* of drawing->segment */
    _Atomic uint32_t copying;   /* threads that still write segments: the array must not move meanwhile */
} chunks;

/* Prepares for `total` chunks and `threads` threads. False: no memory; call chunks_free() in any case. */
bool chunks_init(chunks *c, uint32_t total, int threads, roberts_drawing *drawing, const roberts_receiver *to);
void chunks_free(chunks *c);

/* Returns the next chunk that thread `self`, counted from 0, has to fill. NULL: there is none, or `status` has ended
 * the work. When all threads have got NULL, or have failed, all segments are where they belong. */
hide_chunk *chunks_take(chunks *c, int self);

/* Reports that the thread has filled the chunk. */
void chunks_done(chunks *c, int self, hide_chunk *chunk);

/* Ends the work, unless it has ended already. */
void chunks_fail(chunks *c, roberts_status status);

#endif
