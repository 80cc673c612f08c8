/* sheet.h - where the views of a sheet lie on the paper, and the symbol of the projection method (ISO 5456-2). */
#ifndef ROBERTS_DRAW_SHEET_H
#define ROBERTS_DRAW_SHEET_H

#include "draw/chain.h"
#include "draw/page.h"

/* The place of each view and of the symbol. */
typedef struct sheet_map {
    page_map view[ROBERTS_SHEET_VIEWS];
    double symbol;          /* its size, as a part of the full one; 0: there is none */
    roberts_vec2 symbol_mm; /* its lower right corner */
} sheet_map;

/* Lays the views on the page by their windows, as options->placement says; those on a line with the front view share
 * its coordinate there, exactly. `options` have been checked. False: at its scale the sheet leaves the page, or
 * margins and gaps leave no room; fills `error`. */
bool sheet_lay(const roberts_sheet *sheet, const roberts_draw_options *options, sheet_map *map, roberts_error *error);

/* In full size, mm, centre lines included */
#define SYMBOL_WIDTH 22.75
#define SYMBOL_HEIGHT 10.5

/* Appends the symbol's lines, in `size` of the full size; its lower right corner is `corner`, mm from the upper left
 * of the page. False: no memory. */
bool symbol_draw(roberts_sheet_angle angle, roberts_vec2 corner, double size, double units_per_mm, polylines *out);

#endif
