/* front.h - one solid: mapped, its faces classified, and its front entered. */
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

/* Maps a solid of the tile and enters its front. False: no memory. */
bool front_add(hide_picture *picture, front_scratch *scratch, picture_tile *tile, uint32_t solid);

#endif
