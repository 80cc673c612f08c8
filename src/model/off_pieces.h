/* off_pieces.h - plain lines (off_plain.h) by several threads, where any place of the input can be read at any time.
 *
 * The input is cut at line ends into pieces, each of which a thread reads as if a vertex or a face began with its first
 * line: into memory of its own, since how many come before it is not known yet. Pieces are joined in order, as far as each
 * begins where the one before it was read to: so they hold what one thread would have found there. Where something else
 * than plain lines stands, the rest is dropped and the reader goes on by itself from there, with its line number: what it
 * then says does not depend on threads. */
#ifndef ROBERTS_MODEL_OFF_PIECES_H
#define ROBERTS_MODEL_OFF_PIECES_H

#include "model/off.h"

/* What each of the threads, numbered from 0, does. */
typedef void off_work_fn(void *job, uint32_t thread);

/* Has it done by so many threads, or fewer, and waits for them. */
typedef void off_run_fn(off_work_fn *work, void *job, uint32_t threads);

/* How the work is divided: tests have values of their own. */
typedef struct off_division {
    uint32_t threads; /* 1: no pieces */
    size_t piece;     /* bytes of a piece */
    size_t overhang;  /* bytes by which a piece's last line may be longer; where it is longer still, the pieces end */
    size_t least;     /* bytes left for each thread that make it worth while */
    off_run_fn *run;
} off_division;

/* The division by so many threads (0: what there is), one inside a parallel region. */
off_division off_divide(uint32_t threads);

/* Reads one input; see roberts_mesh_read(). */
roberts_status off_read(roberts_mesh *mesh, const char *name, const off_source *source, const off_division *division,
                        const roberts_warnings *warnings, roberts_error *error);

/* Reads on from the end of a vertex or face as far as pieces go, into the mesh, with lines counted; `in` is then at the end
 * of a vertex or face again. Cheap where there is nothing to do. */
void off_read_pieces(off_reader *r);

#endif
