/* front.h - the fronts of one body. The body is mapped, and the facing of its faces is found. A convex solid becomes
 * one front, or one for each of its front faces. In any other body each piece of a face is a front, which hides from
 * both sides. */
#ifndef ROBERTS_HIDE_FRONT_H
#define ROBERTS_HIDE_FRONT_H

#include "hide/schedule.h"

/* Memory of one thread. */
typedef struct front_scratch {
    uint32_t *next; /* [vertices of a solid] the next corner of the outline */
    cover_scratch cover;
} front_scratch;

/* Maps a body of the tile and adds its fronts. False: no memory. */
bool front_add(hide_fronts *fronts, front_scratch *scratch, front_tile *tile, uint32_t solid);

/* Makes a face of a body that is not convex front number `to`. */
void front_set_face(hide_fronts *fronts, uint32_t to, uint32_t body, uint32_t face);

/* Returns the box of a face. */
hide_box front_box_of_face(const hide_fronts *fronts, uint32_t face);

#endif
