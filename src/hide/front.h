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
bool front_add(hide_fronts *fronts, front_scratch *scratch, front_tile *tile, uint32_t solid);

/* How far a distance from the face's plane can be trusted: `touch` within the reach that is returned, `limit` anywhere.
 * The plane of a face of width w is known to about its rounding (and the face's own departure from it) at the face, and
 * to that times r / w at a distance r. */
double front_set_trust(const hide_fronts *fronts, uint32_t solid, uint32_t face, double stretch, hide_face *f);

/* Room for `more` fronts of one face. False: no memory. */
bool front_more_singles(front_tile *tile, size_t more);

/* Enters the faces of a body of the tile that is not convex, whose points are mapped: each piece that is not edge-on by
 * itself. False: no memory. (surface_fronts.c) */
bool surface_add_fronts(hide_fronts *fronts, front_tile *tile, uint32_t body);

#endif
