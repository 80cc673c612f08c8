/* cut_lines.h - the lines along which the near plane cuts faces, as lines that are no edges.
 *
 * They are not drawn, but what is seen of a face ends there. */
#ifndef ROBERTS_HIDE_CUT_LINES_H
#define ROBERTS_HIDE_CUT_LINES_H

#include "hide/fronts.h"

/* Sets the further lines of what is seen; cut_lines_free() is due in any case. False: no memory. */
bool cut_lines_find(const hide_fronts *fronts, seen_further *lines);
void cut_lines_free(seen_further *lines);

#endif
