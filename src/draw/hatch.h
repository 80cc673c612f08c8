/* hatch.h - strokes on visible regions, by shade. */
#ifndef ROBERTS_DRAW_HATCH_H
#define ROBERTS_DRAW_HATCH_H

#include "draw/strokes.h"

/* More strokes are refused. */
enum { HATCH_MOST = 20000000 };

/* Appends the strokes of all regions to `p`, which has room for `*room` pieces. Each has the number of its region, from
 * s->view[i].first_region on, and lies behind everything. Returns ROBERTS_OK, _NO_MEMORY or _BAD_ARGUMENT (too many
 * strokes). */
roberts_status hatch_add(const strokes *s, pieces *p, size_t *room, roberts_error *error);

/* Cuts the strokes of hatching where they run through a box of s->taken. `p` may get another array. False: no memory.
 */
bool hatch_spare_text(const strokes *s, pieces *p);

/* How dark a region is: 0 where the light falls straight on it, 1 where none does; rounded to a level. */
double hatch_darkness(const roberts_draw_options *options, const roberts_region *region);

#endif
