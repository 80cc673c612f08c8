/* cells.h - how many cells the picture is divided into: for the lists of Objet[i][j], and for covers. */
#ifndef ROBERTS_HIDE_CELLS_H
#define ROBERTS_HIDE_CELLS_H

#include "hide/scan.h"
#include "hide/types.h"

/* Boxes over a window of the picture. */
typedef struct cells_boxes {
    const hide_box *box; /* [count] */
    uint32_t count;
    roberts_vec2 low, high; /* the window */
    double margin;          /* hide_margin() */
} cells_boxes;

/* Cells for lists: some two mean boxes wide. There are no more of them than lets the lists grow in proportion to the
 * number of boxes. Where polygons are long, thin and aslant, cells are smaller than their boxes. n: given number per
 * side, 0 = choose. filled: what part of the boxes their polygons fill, about. *depth: mean number of boxes over a
 * point of the window. */
scan_frame cells_for_lists(const cells_boxes *b, double filled, uint32_t n, double *depth);

/* Cells for covers: much smaller than a mean box. The frame has no columns where few boxes lie over one another, and
 * covers would not pay. The number of threads does not change the result. */
scan_frame cells_for_covers(const cells_boxes *b, int threads);

#endif
