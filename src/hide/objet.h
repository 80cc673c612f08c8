/* objet.h - the grid Objet[i][j]: which fronts touch which cell of the picture.
 *
 * Source: the lecture's last section. A front is what one solid shows: all its front faces, listed once under their
 * common outline; a solid of many faces is listed face by face (see picture.h). A cell lists its fronts nearest corner
 * first, so that one that begins behind an edge ends the search. What covers a cell is kept apart (see cover.h). */
#ifndef ROBERTS_HIDE_OBJET_H
#define ROBERTS_HIDE_OBJET_H

#include "hide/picture.h"
#include "hide/scan.h"

typedef struct objet {
    scan_frame frame;
    uint32_t *start; /* [nx * ny + 1] cell c lists front[start[c]] .. front[start[c + 1] - 1] */
    uint32_t *front; /* fronts of the picture */
    /* [as front] where a cell's list goes on with another solid, or ends: so a solid need not pass its own faces one by
     * one, all of which a fan of very many triangles has in the cell of its tip. NULL where no solid is listed face by face. */
    uint32_t *next;
} objet;

/* A cell that an edge meets, and between which of the edge's parameters. */
typedef struct objet_stretch {
    uint32_t cell;
    double t0, t1;
} objet_stretch;

typedef struct objet_walk {
    objet_stretch *item;
    size_t count, room;
} objet_walk;

/* Fills the cells of `frame`, by so many threads at the most (0: what there is), on which the result does not depend.
 * Returns ROBERTS_OK or _NO_MEMORY. */
roberts_status objet_build(objet *grid, const hide_picture *picture, scan_frame frame, uint32_t threads);
void objet_free(objet *grid);

/* The cells that AB touches, column by column; false: no memory. */
bool objet_cells(const objet *grid, roberts_vec3 A, roberts_vec3 B, objet_walk *walk);

#endif
