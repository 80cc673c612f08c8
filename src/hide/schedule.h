/* schedule.h - says which solids a thread takes and in what order, and brings what the threads find into the order of
 * the file. Nothing here changes what is found.
 *
 * 1. Tiles: fronts are built tile by tile. If covers are kept, a tile holds the solids whose middle is in a square of
 *    TILE_CELLS cells, so that the covers that the tile touches stay in a cache. Tiles are taken in rounds. No two
 * tiles of a round lie beside one another, and a solid reaches out of its tile by less than half of one. So solids of
 *    different tiles of a round never ask or enter the same cover, and the threads do not change what is culled. The
 * few solids that reach farther are a tile by themselves, and the first round. Without covers, a tile holds solids that
 *    follow one another in the file, and there is one round.
 *
 * 2. The order of the picture: lines come out in the order of the file. But solids that follow one another in the file
 *    may lie anywhere in the picture. If they are more than a cache holds, each edge would fetch the fronts around it
 *    from memory. So these solids are hidden beforehand, in the order in which they lie in the picture. The parameters
 *    of the hidden parts are kept until it is the solid's turn. If hidden segments are wanted, the solid seen there is
 *    kept too.
 *
 * 3. Chunks: segments are found in chunks of solids. A thread takes a run of a few chunks that follow one another,
 * since neighbours ask for the same fronts. If the turn of a chunk has not come, the chunk stays with its thread. The
 *    thread looks again after every further chunk, and gives the segments away or lays them down itself, while they are
 *    still in its cache. No thread waits for another unless its queue is full. */
#ifndef ROBERTS_HIDE_SCHEDULE_H
#define ROBERTS_HIDE_SCHEDULE_H

#include <stdatomic.h>
#include <stdbool.h>

#include "base/threads.h"
#include "hide/edge.h"
#include "hide/fronts.h"
#include "roberts.h"

/* ---- tiles ---- */

/* The first round has one tile, for solids that reach far. Four rounds follow, by odd and even columns and rows of
 * tiles. */
enum { TILE_ROUNDS = 5 };

/* A convex solid has at most one whole front, no more front faces than faces, and no more corners in its outline than
 * vertices. Another body has no more fronts than faces. So it is known beforehand where in the arrays of hide_fronts a
 * tile may begin to write. Room that is not used is never touched. */
typedef struct front_tile {
    uint32_t first, end;                 /* of tiles.solid */
    uint32_t first_whole, first_surface; /* of hide_fronts.front, behind which other tiles' are: whole fronts; fronts
                                            of bodies that are not convex */
    uint32_t whole, surface;             /* the next of these to be written ... */
    uint32_t face, outline;              /* ... and of other arrays of hide_fronts */
    hide_front *single;                  /* fronts of one face each, of solids that are entered face by face */
    hide_box *single_box;
    size_t single_count, single_room, single_box_room;
    size_t faces, back, edge_on, culled;
    uint32_t most_corners;
    char apart[THREADS_APART];
} front_tile;

typedef struct tiles {
    front_tile *tile;
    uint32_t count, round[TILE_ROUNDS + 1]; /* first tile of each round, and the last one's end */
    uint32_t *solid;                        /* tile by tile; NULL: as they are numbered */
} tiles;

/* Makes the tiles of fronts that have their boxes and the frame of their covers. threads: upper bound. False: no
 * memory; tiles_free() is due in any case. */
bool tiles_make(tiles *t, const hide_fronts *fronts, int threads);
void tiles_free(tiles *t);

/* Puts a tile's solids in order, nearest first, ties by number. False: no memory. */
bool tiles_order(tiles *t, const front_tile *of, const hide_fronts *fronts);

/* ---- the order of the picture ---- */

#define KEPT_SOLIDS 64 /* solids: their edges are kept together */

/* A line of which something may be visible, or is wanted though it is hidden. */
typedef struct kept_line {
    uint32_t edge, parts;
} kept_line;

typedef struct kept_chunk {
    kept_line *line; /* [line_count] */
    double *t;       /* [2 part_count] t0, t1 of each line's parts */
    uint32_t *by;    /* [part_count] who is seen there; NULL: not wanted */
    size_t line_count, line_room, part_count, t_room, by_room;
    uint32_t first_line[KEPT_SOLIDS + 1], first_part[KEPT_SOLIDS + 1]; /* of each solid; the next one's is the end */
} kept_chunk;

typedef struct picture_order {
    uint32_t count, chunks; /* of solids; of chunks, if any are kept */
    uint32_t *solid;        /* [count] in this order; NULL: the order of the file is as good, and nothing is kept */
    uint32_t *place;        /* [count] where in `order` a solid is */
    kept_chunk *chunk;      /* [chunks] one for every KEPT_SOLIDS solids of them */
} picture_order;

/* Finds the order; depth: mean number of fronts' boxes over a point of the picture. False: no memory;
 * picture_order_free() is due in any case. */
bool picture_order_init(picture_order *o, const hide_fronts *fronts, double depth);
void picture_order_free(picture_order *o);

/* Keeps the worker's lines, those of order[place], as hide_worker_run() has left them. The solids of a chunk come one
 * after the other. A solid that is culled comes without lines. False: no memory. */
bool picture_order_keep(picture_order *o, uint32_t place, const hide_worker *w);

/* Prefetches the lines of solids that will be recalled soon after this one: they lie anywhere. */
void picture_order_fetch(const picture_order *o, uint32_t solid);

/* Gives the worker the solid's lines back. Those that are wholly hidden come back only if hidden parts are kept. False:
 * no memory. */
bool picture_order_recall(const picture_order *o, uint32_t solid, hide_worker *w);

/* ---- chunks ---- */

/* What is found of one chunk. */
typedef struct hide_chunk {
    roberts_segment *segment; /* [count] */
    size_t count, room;
    uint32_t number;
} hide_chunk;

/* CHUNKS_RUN: most chunks in a run. CHUNKS_WAITING: most chunks of a thread that wait for their turn. That is more than
 * a run, so that a thread that the system makes wait does not stop the others. */
enum { CHUNKS_RUN = 16, CHUNKS_WAITING = 3 * CHUNKS_RUN };

/* The chunks of one thread: those that wait, a ring in the order of their numbers, and those that are free. */
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
    _Atomic uint32_t turn;    /* the chunk that is given away or laid down next. Its thread alone may change: */
    roberts_drawing *drawing; /* (threads that had their turn may still write its segments) */
    size_t room;              /* of drawing->segment */
    _Atomic uint32_t copying; /* threads that write to the drawing: until they have done, it must not be moved */
} chunks;

/* For `total` chunks found by `threads` threads. False: no memory; chunks_free() is due in any case. */
bool chunks_init(chunks *c, uint32_t total, int threads, roberts_drawing *drawing, roberts_segment_fn *each,
                 void *context);
void chunks_free(chunks *c);

/* The next chunk that thread `self`, counted from 0, is to fill. NULL: there is none, or `status` has ended the work.
 * When all threads have got NULL, or have failed, all segments are where they belong. */
hide_chunk *chunks_take(chunks *c, int self);

/* The chunk that the thread has taken is full. */
void chunks_done(chunks *c, int self, hide_chunk *chunk);

/* Ends the work, unless it has ended already. */
void chunks_fail(chunks *c, roberts_status status);

#endif
