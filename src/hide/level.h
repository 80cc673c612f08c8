/* level.h - the number of layers in front of a hidden point. */
#ifndef ROBERTS_HIDE_LEVEL_H
#define ROBERTS_HIDE_LEVEL_H

#include "hide/edge.h"

/* Counts the layers in front of X, a hidden point of the line; at least 1. A convex or closed body counts once each
 * time the line of sight enters it; an open body counts once for each face that the line of sight meets. Requires a
 * grid that lists every front, as it does when hidden lines are wanted. False: no memory. */
bool hide_level_at(hide_worker *w, const seen_line *line, roberts_vec3 X, uint32_t *level);

#endif
