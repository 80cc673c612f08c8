/* cairo.h - the page as PDF, PostScript, EPS and PNG, by Cairo's surfaces. */
#ifndef ROBERTS_DRAW_CAIRO_H
#define ROBERTS_DRAW_CAIRO_H

#include <cairo.h>

#include "draw/output.h"
#include "draw/strokes.h"

/* The caller finishes `out`, which knows of failed writes. Returns ROBERTS_OK, _NO_MEMORY, _IO or _BAD_ARGUMENT. */
roberts_status surface_write(const strokes *s, output *out, roberts_error *error);

/* A failure of Cairo's as ours. ROBERTS_OK where a write failed: the output knows why. */
roberts_status surface_failure(cairo_status_t status, roberts_error *error);

#endif
