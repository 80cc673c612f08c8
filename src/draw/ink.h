/* ink.h - strokes onto a Cairo surface, and Cairo's failures as ours. */
#ifndef ROBERTS_DRAW_INK_H
#define ROBERTS_DRAW_INK_H

#include <cairo.h>

#include "draw/output.h"
#include "draw/strokes.h"

enum { INK_SEGMENTS_PER_STROKE = 1000 };

/* Width, dashes, caps and colour for a class of lines. `cairo` has mm as its units, here and below. */
void ink_pen(cairo_t *cairo, const roberts_draw_options *options, roberts_line line);

/* Draws polylines from `*at` on, up to `end` or until there are `most` segments; `*at` moves on. As few paths as hold
 * INK_SEGMENTS_PER_STROKE each; returns how many. */
size_t ink_strokes(cairo_t *cairo, const strokes *s, size_t *at, size_t end, size_t most);

/* A writer for Cairo's streams; the closure is an output. Failures are kept there. */
cairo_status_t ink_stream(void *out, const unsigned char *bytes, unsigned size);

/* Finishes and releases both, and says how it went. `out` has been told of failed writes. */
roberts_status ink_finish(cairo_t *cairo, cairo_surface_t *surface, roberts_error *error);

#endif
