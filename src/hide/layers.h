/* layers.h - cells that sheets of a surface fill.
 *
 * A fold is an outline, a border, or any edge that does not have one face on its left in the picture and one on its
 * right. Suppose that no fold of a surface meets a cell of Objet[i][j]. Then equally many faces lie over all points of
 * the cell, since that number changes only at folds.
 *
 * Faces that share an edge overlap in depth. So the faces of a cell can be divided into parts where there is a gap in
 * depth, and equally many faces of each part lie over all points. A part with one face over a point is a sheet: it
 * fills the cell, and none of its points lie over one another. If all parts are sheets, no faces cross in the cell. The
 * nearest sheet hides everything behind it, and nothing hides the edges in it. */
#ifndef ROBERTS_HIDE_LAYERS_H
#define ROBERTS_HIDE_LAYERS_H

#include <stdatomic.h>

#include "hide/objet.h"

/* Faces that become fronts late. */
typedef struct late_faces {
    hide_front *item;
    size_t count, room;
} late_faces;

/* The search for sheets. */
typedef struct layers {
    objet *grid;
    const hide_fronts *fronts;
    atomic_uint *fold; /* [cells] rank of the nearest depth of anything that is no sheet; NULL: no sheets are sought */
    objet_walk *walk;  /* [threads] */
    late_faces *late;  /* [threads] */
    int threads;
} layers;

/* Finds the depth up to which the cells of a grid may have sheets. The grid's lists are not read. False: no memory;
 * call layers_end() in any case. */
bool layers_begin(layers *l, objet *grid, const hide_fronts *fronts, uint32_t threads);
void layers_end(layers *l);

/* Finds the sheets of a cell whose list is complete and in order. */
void layers_find(const layers *l, uint32_t column, uint32_t row);

/* Makes fronts of the faces that wait (hide_fronts.waits), unless sheets hide them in all cells that they may touch.
 * They come after the other fronts. No cell may list them if the sheet that it has so far hides them. False: no
 * memory. */
bool layers_add_late(layers *l, hide_fronts *fronts);

/* Finds the sheets of a cell again, after such fronts have been added to its list. */
void layers_find_again(const layers *l, uint32_t column, uint32_t row);

/* Takes into account the faces that sheets have kept out of the lists. */
void layers_end_late(const layers *l);

#endif
