/* stroke_groups.h - strokes in groups, for SVG: by body, or by class and body, with each piece of an edge by itself. */
#ifndef ROBERTS_DRAW_STROKE_GROUPS_H
#define ROBERTS_DRAW_STROKE_GROUPS_H

#include "draw/strokes.h"

/* Returns, for each of `count` numbers of pieces, the part that it belongs to: a body in one view, or an edge or a
 * region.
 * The views of `s` are set. The caller frees the result; NULL: no memory. */
uint32_t *groups_parts(const strokes *s, size_t count);

/* Makes the polylines of all groups, and the groups: by view, then by body and class, or by class and body. Frame,
 * symbol and text come last. Changes the order of the pieces. Returns ROBERTS_OK, _NO_MEMORY or _BAD_ARGUMENT. */
roberts_status groups_make(strokes *s, pieces *p, roberts_error *error);

/* What the number of a piece stands for. */
typedef struct piece_source {
    uint32_t view, body;
    const roberts_segment *segment; /* NULL: a stroke of hatching */
    const roberts_region *region;   /* on which that stroke lies; otherwise NULL */
} piece_source;

piece_source groups_source(const strokes *s, uint32_t number);

#endif
