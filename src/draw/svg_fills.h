/* svg_fills.h - fills in SVG. */
#ifndef ROBERTS_DRAW_SVG_FILLS_H
#define ROBERTS_DRAW_SVG_FILLS_H

#include "draw/output.h"
#include "draw/strokes.h"

/* Writes a layer with a path for each colour, and below them, in a group, one for the seams of each colour. Nothing if
 * nothing is filled. */
void svg_write_fills(const strokes *s, output *out);

#endif
