/* cells.h - how many cells the picture is divided into: for the lists of Objet[i][j], and for covers. */
#ifndef ROBERTS_HIDE_CELLS_H
#define ROBERTS_HIDE_CELLS_H

#include "hide/scan.h"
#include "hide/space.h"

/* Cells for lists over the window low..high: some one and a half mean boxes wide, but no more than lets the lists grow in
 * proportion to the number of boxes. n: given number per side, 0 = choose. */
scan_frame cells_for_lists(const hide_box *box, uint32_t count, roberts_vec2 low, roberts_vec2 high, uint32_t n,
                           double margin);

/* Cells for covers: much smaller than a mean box. Without columns where covers would not pay: where few boxes lie over
 * one another. */
scan_frame cells_for_covers(const hide_box *box, uint32_t count, roberts_vec2 low, roberts_vec2 high, double margin);

/* Do so many boxes lie over one another that covers of two fronts together pay? */
bool cells_worth_uniting(const hide_box *box, uint32_t count, roberts_vec2 low, roberts_vec2 high);

#endif
