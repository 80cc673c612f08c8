/* cells.h - how many cells the picture is divided into: for the lists of Objet[i][j], and for covers. */
#ifndef ROBERTS_HIDE_CELLS_H
#define ROBERTS_HIDE_CELLS_H

#include "hide/scan.h"
#include "hide/types.h"
#include "model/scene.h"

/* Boxes over a window of the picture. */
typedef struct cells_boxes {
    const hide_box *box; /* [count] */
    uint32_t count;
    roberts_vec2 low, high; /* the window */
    double margin;          /* hide_margin() */
} cells_boxes;

/* Returns the cells for lists. They are about two mean boxes wide, but larger if the lists would otherwise grow faster
 * than the number of boxes. n: number of cells per side, fewer if their lists would take several times the scene's
 * memory; 0: choose. *depth: mean number of boxes over a point of the window. Where the boxes crowd, the frame has
 * warps; the caller frees them (objet_build() takes them). */
scan_frame cells_for_lists(const cells_boxes *b, uint32_t n, double *depth);

/* Returns the cells for covers, which are much smaller than a mean box, and smaller still for bodies of many vertices
 * and for loose triangles. If few boxes lie over one another, covers do not pay, and the frame has no columns.
 * vertices: of all bodies. Warps as above; cover_init() takes them. The threads do not change the result. */
scan_frame cells_for_covers(const cells_boxes *b, size_t vertices, int threads);

/* Returns the cells for covers that hide faces of one body: the boxes are those of its faces. If few of them lie over
 * one another, the frame has no columns. */
scan_frame cells_for_own_covers(const cells_boxes *b);

/* Returns the cells for covers of the scene to which a part belongs, as its plan keeps them. */
scan_frame cells_of_whole(const scene_whole *w, double margin);

/* Can cells_for_covers() return so many columns and rows, for so many vertices? */
bool cells_may_cover(uint32_t nx, uint32_t ny, size_t vertices);

#endif
