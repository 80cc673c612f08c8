/* cover.h - the nearest cover of each cell.
 *
 * Source: the lecture's "la face la plus proche qui recouvre le pave". Here the whole front of a solid may cover a
 * cell, not only one face: its outline covers the cell. A face of a body that is not convex covers cells by itself.
 * Each cell keeps the nearest of its covers. Covers are compared by their farthest depth over the cell, because
 * everything that is nowhere nearer than this depth lies behind the cover.
 *
 * The cells have a frame of their own, finer than that of Objet[i][j] (see cells.h): a front does not cover the cells
 * that it only crosses. */
#ifndef ROBERTS_HIDE_COVER_H
#define ROBERTS_HIDE_COVER_H

#include "hide/scan.h"
#include "hide/types.h"

typedef struct cover {
    scan_frame frame;
    float *depth; /* [nx * ny] -infinity without cover; NULL: no covers are kept, nothing is ever behind one */
    uint32_t *by; /* [nx * ny] what covers the cell: cover_front.by */
} cover;

/* Begins without covers, over the cells of a frame. A frame without columns keeps no covers. False: no memory. */
bool cover_init(cover *c, scan_frame frame, int threads);
void cover_free(cover *c);

/* A front that covers cells. */
typedef struct cover_front {
    const uint32_t *corner; /* [count] of its outline, convex, counter-clockwise */
    uint32_t count;
    uint32_t by;           /* kept with the cells that it covers */
    const hide_face *face; /* [face_count] the front is the nearer side of all of them, cell by cell; without faces */
    uint32_t face_count;   /* only `depth` counts */
    double depth;          /* the front is nowhere farther away than this */
    double slack;          /* what is nearer than the cover by this does not touch it */
    double loose;          /* the front may fail to fill its outline by this */
} cover_front;

/* Enters the front. P: view points of the scene; s: scratch for as many columns as the frame has. */
void cover_add(cover *c, scan *s, const roberts_vec3 *P, const cover_front *front);

/* Do covers certainly hide all of the box? */
bool cover_hides(const cover *c, const hide_box *box);

struct hide_fronts;

/* Do the fronts entered so far certainly hide the solid, which has this box? Its vertices need not be mapped. */
bool cover_hides_solid(const struct hide_fronts *fronts, const hide_box *box, uint32_t solid);

/* Is the cover of the cell of picture point (x, y) certainly nearer than z? */
static inline bool cover_nearer(const cover *c, double x, double y, float z)
{
    return c->depth[scan_cell(&c->frame, x, y)] > z;
}

/* The `by` of the cover of the cell of picture point (x, y), if it is certainly nearer than z; else ROBERTS_NONE. */
uint32_t cover_at(const cover *c, double x, double y, float z);

/* Do covers certainly hide all of AB? */
bool cover_hides_edge(const cover *c, roberts_vec3 A, roberts_vec3 B);

#endif
