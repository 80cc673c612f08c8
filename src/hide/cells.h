/* cells.h - how many cells the picture is divided into: for the lists of Objet[i][j], and for covers. */
#ifndef ROBERTS_HIDE_CELLS_H
#define ROBERTS_HIDE_CELLS_H

#include "hide/scan.h"
#include "hide/types.h"

/* Cells for lists over the window low..high: some two mean boxes wide, but no more than lets the lists grow in
 * proportion to the number of boxes. n: given number per side, 0 = choose. *depth: mean number of boxes over a point of
 * the window. */
scan_frame cells_for_lists(const hide_box *box, uint32_t count, roberts_vec2 low, roberts_vec2 high, uint32_t n,
                           double margin, double *depth);

/* Cells for covers: much smaller than a mean box. Without columns where covers would not pay: where few boxes lie over
 * one another. By so many threads; what comes out is
 * the same. */
scan_frame cells_for_covers(const hide_box *box, uint32_t count, roberts_vec2 low, roberts_vec2 high, double margin,
                            int threads);

#endif
