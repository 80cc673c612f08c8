/* front.h - one body: mapped, its faces classified, and its fronts entered. A convex solid is one front, or one for
 * each of its front faces. Of another body each piece of a face is a front of its own, which hides from both sides. */
#ifndef ROBERTS_HIDE_FRONT_H
#define ROBERTS_HIDE_FRONT_H

#include "base/threads.h"
#include "hide/schedule.h"

/* What a thread needs for itself. */
typedef struct front_scratch {
    scan scan;
    uint32_t *next; /* [vertices of a solid] the outline's next corner */
    char apart[THREADS_APART];
} front_scratch;

/* Maps a body of the tile and enters its fronts. False: no memory. */
bool front_add(hide_fronts *fronts, front_scratch *scratch, front_tile *tile, uint32_t solid);

#endif
