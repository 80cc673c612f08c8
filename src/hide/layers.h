/* layers.h - cells that surfaces fill.
 *
 * Let no outline, border or other fold of a surface meet a cell of Objet[i][j]: each edge there has one face on its
 * left in the picture and one on its right. Let no vertex there be wound about more than once. Then what the surface
 * has in the cell is a number of sheets. Each of them fills the cell, and no two points of it lie over one another (it
 * is a covering without branches, and a cell is simply connected). Faces that are joined overlap in depth. So where a
 * gap in depth parts the faces of a cell, it parts sheets, and the sheets of a part are as many as its faces over any
 * one point. Where every part is one sheet, no faces cross in the cell. The nearest sheet hides all that lies behind
 * it, and nothing hides the edges that lie in it. */
#ifndef ROBERTS_HIDE_LAYERS_H
#define ROBERTS_HIDE_LAYERS_H

#include <stdatomic.h>

#include "hide/objet.h"

/* The finding of sheets. */
typedef struct layers {
    objet *grid;
    const hide_fronts *fronts;
    atomic_uint *fold;    /* [cells] a rank for the nearest depth of what is no sheet; NULL: no sheets are sought */
    unsigned char *wound; /* [vertices] how often the faces of a surface go round the vertex in the picture: 0, 1, 2 or
                             more */
    objet_walk *walk;     /* [threads] */
    int threads;
} layers;

/* Finds the depth from which on each cell of a grid may hold sheets; the lists may be empty. False: no memory;
 * layers_end() is due in any case. */
bool layers_begin(layers *l, objet *grid, const hide_fronts *fronts, uint32_t threads);
void layers_end(layers *l);

/* Finds the sheets of a cell whose list is complete and in order. */
void layers_find(const layers *l, uint32_t column, uint32_t row);

#endif
