/* cairo.h - strokes, pens and failures of Cairo's surfaces. */
#ifndef ROBERTS_WRITE_CAIRO_H
#define ROBERTS_WRITE_CAIRO_H

#include <cairo.h>

#include "draw/strokes.h"

/* Sets width, dashes, caps and colour for a class of lines. The unit of `cairo` is the mm. */
void surface_set_pen(cairo_t *cairo, const roberts_draw_options *options, roberts_line line);

/* Draws the polylines first .. end - 1, which are of the class whose pen is set. */
void surface_draw(cairo_t *cairo, const strokes *s, size_t first, size_t end);

/* Turns a failure in Cairo into ours. After a failed write it returns ROBERTS_OK: the output stores the reason. */
roberts_status surface_failure(cairo_status_t status, roberts_error *error);

/* Paints all fills, translucent ones as they look on the page's background. */
void surface_paint_fills(cairo_t *cairo, const strokes *s);

#endif
