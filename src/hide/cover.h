/* cover.h - the nearest cover of each cell.
 *
 * Source: the lecture's "la face la plus proche qui recouvre le pave". Here a cell may be covered by the whole front of
 * a solid, not only by one face: the front's outline covers it. Of several covers the nearest counts, compared by the
 * farthest depth that it has over the cell: what is nowhere nearer than that lies behind it. The cells are finer than
 * those of Objet[i][j], and others (see cells.h), since a cell that a front only crosses is not covered. */
#ifndef ROBERTS_HIDE_COVER_H
#define ROBERTS_HIDE_COVER_H

#include "hide/scan.h"
#include "hide/types.h"

typedef struct cover {
    scan_frame frame;
    float *depth; /* [nx * ny] -infinity without cover; NULL: no covers are kept, nothing is ever behind one */
    uint32_t *by; /* [nx * ny] what covers the cell, as cover_add() was told */
} cover;

/* Takes a frame of the cells; one without columns keeps no covers. By so many threads. No memory: false. */
bool cover_init(cover *c, scan_frame frame, int threads);
void cover_free(cover *c);

/* Enters a convex outline of corners P[corner[..]], counter-clockwise, whose front is nowhere over it farther away than
 * `depth`; where faces are given the front is the nearer side of them all, and its depth in each cell is taken. s:
 * scratch for as many columns. slack: how much nearer than the cover a thing must be to count as touching it, in depth.
 * by: kept with the cells. loose: by how much the front may fail to fill its outline. */
void cover_add(cover *c, scan *s, const roberts_vec3 *P, const uint32_t *corner, uint32_t count, double depth,
               const hide_face *face, uint32_t face_count, double slack, uint32_t by, double loose);

/* Lies all of the box certainly behind covers? */
bool cover_hides(const cover *c, const hide_box *box);

struct hide_fronts;

/* Is the solid, which has this box, certainly hidden by what is entered so far? Its vertices need not be mapped. */
bool cover_hides_solid(const struct hide_fronts *fronts, const hide_box *box, uint32_t solid);

/* Is what covers the cell of picture point (x, y) certainly nearer than z? */
static inline bool cover_nearer(const cover *c, double x, double y, float z)
{
    return c->depth[scan_cell(&c->frame, x, y)] > z;
}

/* What covers the cell of picture point (x, y), if that is certainly nearer than z; else ROBERTS_NONE. */
uint32_t cover_at(const cover *c, double x, double y, float z);

/* Lies all of AB certainly behind covers? */
bool cover_hides_edge(const cover *c, roberts_vec3 A, roberts_vec3 B);

#endif
