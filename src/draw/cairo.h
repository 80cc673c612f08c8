/* cairo.h - the page as PDF, PostScript, EPS and PNG, by Cairo's surfaces. */
#ifndef ROBERTS_DRAW_CAIRO_H
#define ROBERTS_DRAW_CAIRO_H

#include <cairo.h>

#include "draw/output.h"
#include "draw/strokes.h"

/* Adds a polyline to the current path of `cairo`, whose unit is `units` units of the page. */
void surface_add_line(cairo_t *cairo, const strokes *s, const polyline *line, double units);

/* Writes the page. The caller finishes `out`, which knows of failed writes. Returns ROBERTS_OK, _NO_MEMORY, _IO or
 * _BAD_ARGUMENT. */
roberts_status surface_write(const strokes *s, output *out, roberts_error *error);

/* Turns a failure in Cairo into ours. After a failed write it returns ROBERTS_OK: `out` knows the reason. */
roberts_status surface_failure(cairo_status_t status, roberts_error *error);

#endif
