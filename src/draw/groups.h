/* groups.h - strokes in groups, for SVG: by body, or by class and body, with each piece of an edge by itself. */
#ifndef ROBERTS_DRAW_GROUPS_H
#define ROBERTS_DRAW_GROUPS_H

#include "draw/strokes.h"

/* Tells for each of `count` numbers of pieces which part it belongs to: a body in one view, or an edge in one view.
 * The views of `s` are set. The caller frees the result; NULL: no memory. */
uint32_t *groups_parts(const strokes *s, size_t count);

/* Makes the polylines of all groups, and the groups: by view, then by body and class, or by class and body. Frame and
 * symbol come last. Changes the order of the pieces. Returns ROBERTS_OK, _NO_MEMORY or _BAD_ARGUMENT. */
roberts_status groups_make(strokes *s, pieces *p, roberts_error *error);

/* The view that a piece with this number is in. */
uint32_t groups_view(const strokes *s, uint32_t number);

#endif
