/* crossing_filter.h - what decides quickly that two fronts do not cross: where they lie, and vertices about which all
 * faces are one sheet in the picture. */
#ifndef ROBERTS_HIDE_CROSSING_FILTER_H
#define ROBERTS_HIDE_CROSSING_FILTER_H

#include <stdatomic.h>

#include "hide/objet.h"

/* The box of a whole solid along the axes of the model. Many solids are such boxes themselves. */
typedef struct model_box {
    hide_bounds is;
    atomic_uchar flat; /* flatness */
} model_box;

/* Does a solid have an edge that is not drawn because it is flat? */
typedef enum flatness { FLAT_UNKNOWN, FLAT_NOWHERE, FLAT_SOMEWHERE } flatness;

typedef struct crossing_filter {
    const hide_fronts *fronts;
    model_box *model;   /* [whole] */
    hide_bounds *body;  /* [solid_count] boxes of bodies along the axes of the model; NULL: not known */
    uint32_t whole;     /* number of whole solids, which come before single faces */
    double touching;    /* model units; bodies farther apart do not touch */
    atomic_uchar *star; /* that of the grid. Now STAR_ONCE means that all faces about the vertex are one sheet */
    bool alone;         /* there is one thread */
} crossing_filter;

/* False: no memory; call filter_end() in any case. */
bool filter_begin(crossing_filter *p, const hide_fronts *fronts, const objet *grid, int threads);
void filter_end(crossing_filter *p);

/* Finds model[front].flat. */
bool filter_find_flat(const crossing_filter *p, uint32_t front);

/* Are two faces plainly apart, in the picture or in space? */
bool filter_faces(const hide_fronts *fronts, uint32_t a, uint32_t b);

/* Two triangles share corner f[i], and no other. Does a side at that corner separate them in the picture? So it is with
 * nearly all neighbours. */
bool filter_fan(const hide_fronts *fronts, const uint32_t f[3], int i, const uint32_t g[3]);

static inline bool filter_flat(const crossing_filter *p, uint32_t front)
{
    unsigned char known = atomic_load_explicit(&p->model[front].flat, memory_order_relaxed);
    return known == FLAT_UNKNOWN ? filter_find_flat(p, front) : known == FLAT_SOMEWHERE;
}

/* Returns how far two boxes are apart along one of the axes; negative if they overlap. */
static inline double filter_gap(const hide_bounds *f, const hide_bounds *g)
{
    double x = greater(f->low.x - g->high.x, g->low.x - f->high.x);
    double y = greater(f->low.y - g->high.y, g->low.y - f->high.y);
    double z = greater(f->low.z - g->high.z, g->low.z - f->high.z);
    return greater(greater(x, y), z);
}

/* The same as filter_apart() for two fronts of which one at least is no whole solid. In perspective, the boxes of faces
 * count too: the pictures of faces beside the eye are large, and overlap. */
bool filter_singles_apart(const crossing_filter *p, uint32_t a, uint32_t b);

/* Do boxes in the model keep two fronts apart? Boxes of whole solids that touch do, unless a flat edge of one solid may
 * lie in a face of the other. */
static inline bool filter_apart(const crossing_filter *p, uint32_t a, uint32_t b)
{
    if (a >= p->whole || b >= p->whole)
        return filter_singles_apart(p, a, b);
    const double gap = filter_gap(&p->model[a].is, &p->model[b].is);
    return gap > p->touching || (gap >= 0.0 && !filter_flat(p, a) && !filter_flat(p, b));
}

#endif
