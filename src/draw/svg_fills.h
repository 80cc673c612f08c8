/* svg_fills.h - fills in SVG. */
#ifndef ROBERTS_DRAW_SVG_FILLS_H
#define ROBERTS_DRAW_SVG_FILLS_H

#include "draw/output.h"
#include "draw/strokes.h"

/* Writes a layer with a path for each colour, and below them, in a group, one for the seams of each colour. Where lines
 * are grouped, it has a path for each region instead of one for each colour, in groups of bodies, on sheets within
 * those of views. Nothing if nothing is filled. False: no memory. */
bool svg_write_fills(const strokes *s, output *out);

#endif
