/* united.h - the lines of all bodies taken together as one (`--union`): what becomes of each edge.
 *
 * The pieces of edges do not depend on the camera, but for the touching distance. They are found once for a drawing
 * (model/union.h); only the class of a piece depends on how its sides are seen. */
#ifndef ROBERTS_VIEW_UNITED_H
#define ROBERTS_VIEW_UNITED_H

#include "model/union.h"

/* Zeroed: bodies are not taken together. */
typedef struct united {
    uint32_t *first; /* [edge_count] the first piece of each edge; ROBERTS_NONE: the edge is what it is without union */
    union_piece *piece; /* those of an edge end with t1 == 1 */
    union_side *side;
    size_t piece_count, side_count;
    size_t seams; /* edges of which a part, or all, is not drawn because bodies touch or hold it */
} united;

/* Finds the pieces of all edges of closed bodies. touch: model units. threads: upper bound, 0 = one per processor; the
 * result does not depend on it. False: no memory, and `u` is zeroed. */
bool united_find(united *u, const roberts_scene *scene, double touch, uint32_t threads);
void united_free(united *u);

/* The pieces of an edge; NULL: it is what it is without the union. */
static inline const union_piece *united_pieces(const united *u, uint32_t edge)
{
    return u->first && u->first[edge] != ROBERTS_NONE ? u->piece + u->first[edge] : NULL;
}

#endif
