/* level.h - how many layers lie before a hidden point. */
#ifndef ROBERTS_HIDE_LEVEL_H
#define ROBERTS_HIDE_LEVEL_H

#include "hide/edge.h"

/* Counts the layers before X, a hidden point of the line: of a convex or closed body how often the line of sight enters
 * it, of an open one the faces that it meets. At least 1. Every front has to be listed, so hidden lines have to be
 * wanted. False: no memory. */
bool hide_level_at(hide_worker *w, const seen_line *line, roberts_vec3 X, uint32_t *level);

#endif
