/* objet.h - the grid Objet[i][j]: which front faces touch which cell of the picture, and which covers it.
 *
 * Source: the lecture's last section, with its corrections: the scan is conservative (every cell that the closed polygon
 * touches receives it), Bas[i] and Haut[i] being the least and greatest row touched in column i; a cell's cover is the
 * nearest face that covers it wholly, compared by the farthest depth that it has over the cell.
 *
 * A cell lists its faces nearest corner first, and none that lies wholly behind the cover. */
#ifndef ROBERTS_HIDE_OBJET_H
#define ROBERTS_HIDE_OBJET_H

#include "hide/space.h"

typedef struct objet {
    uint32_t n;          /* columns, and rows */
    double x0, y0;       /* lower left corner of cell (0, 0), view units */
    double dx, dy;       /* size of a cell */
    double margin;       /* cells are taken to be larger by this on all sides */
    uint32_t *start;     /* [n * n + 1] cell (i, j) lists face[start[i * n + j]] .. */
    uint32_t *face;      /* front faces */
    uint32_t *cover;     /* [n * n] front face, or ROBERTS_NONE */
    double *cover_depth; /* [n * n] what is nowhere nearer than this over the cell lies certainly behind the cover;
                            -infinity without cover */
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

/* Cells per side for `count` faces in the window: about as many as mean faces lie side by side, but no more than lets
 * the lists grow in proportion to the number of faces. */
uint32_t objet_choose(const hide_face *face, uint32_t count, double width, double height);

/* Fills the grid over the window. order: the faces, nearest corner first. Returns ROBERTS_OK or _NO_MEMORY. */
roberts_status objet_build(objet *grid, const hide_space *space, const hide_face *face, const uint32_t *order,
                           uint32_t count, uint32_t n, roberts_vec2 low, roberts_vec2 high);
void objet_free(objet *grid);

/* The cells that AB touches; false: no memory. */
bool objet_cells(const objet *grid, roberts_vec3 A, roberts_vec3 B, objet_walk *walk);

/* The cell that holds a point of the window. */
uint32_t objet_cell_at(const objet *grid, double x, double y);

#endif
