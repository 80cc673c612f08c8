/* segments.h - the lines of one body, or lines in which faces cross, and their segments. */
#ifndef ROBERTS_HIDE_SEGMENTS_H
#define ROBERTS_HIDE_SEGMENTS_H

#include "hide/hide.h"

/* Are all lines of the body taken together? Yes for a convex body, whose lines share their own faces, and for any body
 * with few edges. */
bool segments_at_once(const hide_job *job, uint32_t body);

/* Adds the lines of such a body that are not covered, and finds their hidden parts; if hidden segments are kept, also
 * the bodies seen there. A body without segments has no such lines. False: no memory. */
bool segments_hide(const hide_job *job, hide_worker *w, uint32_t body);

/* Adds the segments of the bodies first .. end - 1, using what was found before their turn. False: no memory, or
 * out->stopped. */
bool segments_find(const hide_job *job, hide_worker *w, hide_chunk *out, uint32_t first, uint32_t end);

/* The same for the lines first .. end - 1 in which faces cross. */
bool segments_cross(const hide_job *job, hide_worker *w, hide_chunk *out, size_t first, size_t end);

#endif
