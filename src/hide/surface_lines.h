/* surface_lines.h - bodies that are not convex: which of their edges are lines, of what class, and what is left of
 * them.
 *
 * An edge is hidden by all faces but its own, those of its own body among them. */
#ifndef ROBERTS_HIDE_SURFACE_LINES_H
#define ROBERTS_HIDE_SURFACE_LINES_H

#include "hide/segments.h"

/* Adds the segments of a body's lines. False: no memory. */
bool surface_find(const hide_job *job, hide_worker *w, hide_chunk *out, uint32_t body);

#endif
