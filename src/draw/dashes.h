/* dashes.h - dashes as strokes of their own, fitted to what is drawn with them. */
#ifndef ROBERTS_DRAW_DASHES_H
#define ROBERTS_DRAW_DASHES_H

#include "draw/chain.h"

/* More of them are refused: no plotter would come to an end. */
enum { DASHES_MAX = 20000000 };

/* Lengths as seen, in units of the page. A round cap adds half of the width to both ends of a dash. */
typedef struct dash_pattern {
    double dash, gap, width;
} dash_pattern;

/* Cuts item[first ..] of `p` into dashes, in their sequence, as a draughtsman does (ISO 128-2): from corner to corner
 * each line begins and ends with a dash, so that dashes meet at corners, and has a gap at least (or is too short for
 * one, and drawn whole). Pen up and down differ from the pattern by the factor that this takes. Returns ROBERTS_OK,
 * _NO_MEMORY or _BAD_ARGUMENT (more than DASHES_MAX). */
roberts_status dashes_cut(polylines *p, size_t first, const dash_pattern *pattern, roberts_error *error);

#endif
