/* united.h - the lines of all bodies taken together as one (`--union`): which parts of each line remain.
 *
 * The pieces of a line depend on the camera only through the touching distance. They are found once for a drawing
 * (model/union.h), for all edges and for all lines in which faces cross. Only the class of a piece depends on how its
 * sides are seen. */
#ifndef ROBERTS_VIEW_UNITED_H
#define ROBERTS_VIEW_UNITED_H

#include "model/union.h"

/* The pieces of many lines. Zeroed: bodies are not taken together. */
typedef struct united {
    uint32_t *first;    /* [lines] the first piece of each line; ROBERTS_NONE: the union does not change it */
    union_piece *piece; /* [piece_count] the last piece of each line has t1 == 1 */
    union_side *side;   /* [side_count] */
    size_t piece_count, side_count;
} united;

/* Gives the place of line `index`. own: room for the faces that meet in it. False: the union does not change it. */
typedef bool united_line_fn(const void *context, uint32_t index, union_line *line, uint32_t own[2]);

/* Finds the pieces of `count` lines. threads: upper bound, 0 = one per processor; the result does not depend on it.
 * False: no memory, and `u` is zeroed. */
bool united_find(united *u, const union_bodies *all, united_line_fn *line_of, const void *context, uint32_t count,
                 uint32_t threads);
void united_free(united *u);

/* The same for the edges of closed bodies for which `asked` is true; it is called with `context`. The others get no
 * pieces. */
typedef bool united_asked_fn(const void *context, uint32_t body, uint32_t edge);
bool united_find_edges(united *u, const union_bodies *all, united_asked_fn *asked, const void *context,
                       uint32_t threads);

/* The pieces of a line; NULL: the union does not change it. */
static inline const union_piece *united_pieces(const united *u, uint32_t index)
{
    return u->first && u->first[index] != ROBERTS_NONE ? u->piece + u->first[index] : NULL;
}

/* The number of lines that are not drawn, or only in part, because bodies are flush there or contain them. */
size_t united_seams(const united *u, uint32_t count);

#endif
