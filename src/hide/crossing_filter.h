/* crossing_filter.h - what decides quickly that two fronts do not cross: where they lie, and vertices about which all
 * faces are one sheet in the picture. */
#ifndef ROBERTS_HIDE_CROSSING_FILTER_H
#define ROBERTS_HIDE_CROSSING_FILTER_H

#include <stdatomic.h>

#include "hide/objet.h"

/* No cell. Grids have fewer columns. */
#define NO_CELL UINT16_MAX

/* The first of the cells that list a front, if its box touches no other cells than these; else NO_CELL. */
typedef struct first_cell {
    uint16_t column, row;
} first_cell;

/* The box of a whole solid along the axes of the model. Many solids are such boxes themselves. */
typedef struct model_box {
    hide_bounds is;
    atomic_uchar flat; /* flatness */
} model_box;

/* Does a solid have an edge that is not drawn because it is flat? */
typedef enum flatness { FLAT_UNKNOWN, FLAT_NOWHERE, FLAT_SOMEWHERE } flatness;

typedef struct crossing_filter {
    const hide_fronts *fronts;
    first_cell *first;    /* [front_count] */
    model_box *model;     /* [whole] */
    uint32_t whole;       /* number of whole solids, which come before single faces */
    double touching;      /* model units; whole solids farther apart do not touch */
    unsigned char *sheet; /* [vertices] all faces about it are one sheet; NULL: nothing is known */
} crossing_filter;

/* False: no memory; call filter_end() in any case. */
bool filter_begin(crossing_filter *p, const hide_fronts *fronts, const objet *grid, int threads);
void filter_end(crossing_filter *p);

/* Finds model[front].flat. */
bool filter_find_flat(const crossing_filter *p, uint32_t front);

static inline bool filter_flat(const crossing_filter *p, uint32_t front)
{
    unsigned char known = atomic_load_explicit(&p->model[front].flat, memory_order_relaxed);
    return known == FLAT_UNKNOWN ? filter_find_flat(p, front) : known == FLAT_SOMEWHERE;
}

/* Do the boxes of two whole solids in the model keep them apart? Boxes that touch do, unless a flat edge of one solid
 * may lie in a face of the other. */
static inline bool filter_apart(const crossing_filter *p, uint32_t a, uint32_t b)
{
    if (a >= p->whole || b >= p->whole)
        return false;
    const hide_bounds *f = &p->model[a].is, *g = &p->model[b].is;
    double x = greater(f->low.x - g->high.x, g->low.x - f->high.x);
    double y = greater(f->low.y - g->high.y, g->low.y - f->high.y);
    double z = greater(f->low.z - g->high.z, g->low.z - f->high.z), gap = greater(greater(x, y), z);
    return gap > p->touching || (gap >= 0.0 && !filter_flat(p, a) && !filter_flat(p, b));
}

#endif
