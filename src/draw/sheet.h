/* sheet.h - where the views of a sheet lie on the paper, and the symbol of the projection method (ISO 5456-2). */
#ifndef ROBERTS_DRAW_SHEET_H
#define ROBERTS_DRAW_SHEET_H

#include "draw/strokes.h"

/* Where each view and the symbol lie. */
typedef struct sheet_map {
    page_map view[ROBERTS_SHEET_VIEWS];
    double symbol_size;     /* of the symbol, as a part of full size; 0: there is none */
    roberts_vec2 symbol_mm; /* its lower right corner */
} sheet_map;

/* How far text and its lines reach beyond the window of each view, mm >= 0. Zeroed: nothing does. */
typedef struct sheet_reach {
    struct {
        double left, right, above, below;
    } view[ROBERTS_SHEET_VIEWS];
} sheet_reach;

/* Enlarges `reach` so that it includes `more`. */
void sheet_add_reach(sheet_reach *reach, const sheet_reach *more);

/* Enlarges `reach` by a box on the paper: where it lies beyond the window of `view`, `more` mm are added. */
void sheet_add_box(sheet_reach *reach, const page_view *view, const space_box *box, double more);

/* Lays the views on the page by their windows, as options->placement says. The top view has exactly the x of the front
 * view, the side view exactly its y. `reach` has room beside the views, between them unless sheet->gap_mm is given.
 * `options` have been checked. False: the sheet leaves the page at its scale, or margins and gaps leave no room; fills
 * `error`. */
bool sheet_lay(const roberts_sheet *sheet, const roberts_draw_options *options, const sheet_reach *reach,
               sheet_map *map, roberts_error *error);

/* Full size of the symbol with its centre lines, in mm. */
#define SYMBOL_WIDTH 22.75
#define SYMBOL_HEIGHT 10.5

/* Appends the symbol's lines. `size` is a part of full size; `corner` is its lower right corner, in mm from the upper
 * left corner of the page. False: no memory. */
bool symbol_draw(roberts_sheet_angle angle, roberts_vec2 corner, double size, double units_per_mm, polylines *out);

#endif
