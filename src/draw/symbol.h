/* symbol.h - the symbol of the projection method (ISO 5456-2). */
#ifndef ROBERTS_DRAW_SYMBOL_H
#define ROBERTS_DRAW_SYMBOL_H

#include "draw/chain.h"

/* In full size, mm, centre lines included */
#define SYMBOL_WIDTH 22.75
#define SYMBOL_HEIGHT 10.5

/* Appends the symbol's lines, in `size` of the full size; its lower right corner is `corner`, mm from the upper left of the
 * page. False: no memory. */
bool symbol_draw(roberts_sheet_angle angle, roberts_vec2 corner, double size, double units_per_mm, polylines *out);

#endif
