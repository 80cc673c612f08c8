/* dashes.h - dashes as strokes of their own, fitted to each line. */
#ifndef ROBERTS_DRAW_DASHES_H
#define ROBERTS_DRAW_DASHES_H

#include "draw/chain.h"

/* More dashes are refused: no plotter would finish them. */
enum { DASHES_MAX = 20000000 };

/* Lengths as seen, in units of the page. A round cap adds half of the width to each end of a dash. */
typedef struct dash_pattern {
    double dash, gap, width;
} dash_pattern;

/* Cuts item[first ..] of `p` into dashes, in their order, as a draughtsman does (ISO 128-2). From corner to corner a
 * line begins and ends with a dash, so that dashes meet at corners. It has at least one gap, unless it is too short and
 * is drawn whole. Dashes and gaps are stretched to fit. Returns ROBERTS_OK,
 * _NO_MEMORY or _BAD_ARGUMENT (more than DASHES_MAX). */
roberts_status dashes_cut(polylines *p, size_t first, const dash_pattern *pattern, roberts_error *error);

#endif
