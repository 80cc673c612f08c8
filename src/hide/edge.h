/* edge.h - one edge through the grid: what hides it, and whom the viewer sees there instead. */
#ifndef ROBERTS_HIDE_EDGE_H
#define ROBERTS_HIDE_EDGE_H

#include "hide/front.h"
#include "hide/objet.h"
#include "hide/parts.h"
#include "hide/tests.h"

/* Scratch memory of one thread, serving edge after edge. */
typedef struct hide_worker {
    const hide_front *front;
    const objet *grid;
    hide_sides sides;
    hide_parts parts;
    objet_walk walk;
    uint32_t *seen;       /* [front->count] last edge that met the face, + 1 */
    uint32_t *solid_seen; /* [solid_count] last edge that the solid hides a part of, + 1 */
    uint32_t *solid_slot; /* [solid_count] where in parts */
    uint32_t stamp;       /* of the edge at work */
    roberts_tally tally;
} hide_worker;

/* False: no memory; hide_worker_free() is due in any case. */
bool hide_worker_init(hide_worker *w, const hide_front *front, const objet *grid, uint32_t solid_count);
void hide_worker_free(hide_worker *w);

/* Leaves in w->parts what the other solids hide of `e`, an edge of `solid`, united. False: no memory. */
bool hide_edge_parts(hide_worker *w, const hide_edge *e, uint32_t solid);

/* The solid seen at picture point (x, y), the one of smallest number where several touch there; ROBERTS_NONE where no
 * front face is. */
uint32_t hide_seen_at(const hide_worker *w, double x, double y);

#endif
