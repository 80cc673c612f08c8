/* sheet.h - where the views of a sheet come to lie on the paper; geometry alone. */
#ifndef ROBERTS_DRAW_SHEET_H
#define ROBERTS_DRAW_SHEET_H

#include "draw/page.h"

/* The place of each view and of the symbol. */
typedef struct sheet_map {
    page_map view[ROBERTS_SHEET_VIEWS];
    double symbol;          /* its size, as a part of the full one; 0: there is none */
    roberts_vec2 symbol_mm; /* its lower right corner */
} sheet_map;

/* Lays the views on the page by their windows, as options->placement says; those on a line with the front view share its
 * coordinate there, exactly. `options` have been checked. False: at its scale the sheet leaves the page, or margins
 * and gaps leave no room; fills `error`. */
bool sheet_lay(const roberts_sheet *sheet, const roberts_draw_options *options, sheet_map *map, roberts_error *error);

#endif
