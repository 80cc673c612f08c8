/* svg.h - the page as SVG. */
#ifndef ROBERTS_DRAW_SVG_H
#define ROBERTS_DRAW_SVG_H

#include "draw/output.h"
#include "draw/strokes.h"

/* Writes the page. The caller finishes `out`, which knows of failed writes. Returns ROBERTS_OK, _NO_MEMORY or _IO. */
roberts_status svg_write(const strokes *s, output *out, roberts_error *error);

#endif
