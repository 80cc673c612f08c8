/* dashes.h - dashes as strokes of their own. */
#ifndef ROBERTS_DRAW_DASHES_H
#define ROBERTS_DRAW_DASHES_H

#include "draw/chain.h"

/* More of them are refused: no plotter would come to an end. */
enum { DASHES_MAX = 20000000 };

/* Cuts item[first ..] of `p` into pieces `down` long, each followed by a gap `up`, in units of the page: from the start
 * of each polyline, as a pattern of the line would be. A dash shorter than a unit is one unit long, a dot. Returns
 * ROBERTS_OK, _NO_MEMORY or _BAD_ARGUMENT (more than DASHES_MAX). */
roberts_status dashes_cut(polylines *p, size_t first, double down, double up, roberts_error *error);

#endif
