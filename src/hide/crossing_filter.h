/* crossing_filter.h - which pairs of faces may cross at all. model/crossing.h decides whether they do.
 *
 * If only visible crossings are sought, crossings.c finds pairs of fronts by the cells of the picture. Nearly all of
 * them are neighbours on one surface, or solids side by side. A crossing_filter decides quickly that two fronts do not
 * cross: their boxes along the axes of the model are apart, or they share a vertex about which all faces are one sheet
 * in the picture, or a side or the plane of one of them separates them, or both belong to a body that does not cross
 * itself. If hidden lines are kept, face_pairs.c finds pairs of faces in space instead.
 *
 * Two faces that are left out never cross; two that are not may still be apart. */
#ifndef ROBERTS_HIDE_CROSSING_FILTER_H
#define ROBERTS_HIDE_CROSSING_FILTER_H

#include <stdatomic.h>

#include "hide/flat_patches.h"
#include "hide/objet.h"

/* The box of a whole solid along the axes of the model. Many solids are such boxes themselves. */
typedef struct model_box {
    box3 is;
    atomic_uchar flat; /* flatness */
} model_box;

/* Does a solid have an edge that is not drawn because it is flat? */
typedef enum flatness { FLAT_UNKNOWN, FLAT_NOWHERE, FLAT_SOMEWHERE } flatness;

typedef struct crossing_filter {
    const hide_fronts *fronts;
    model_box *model;   /* [whole] */
    box3 *body;         /* boxes of bodies along the axes of the model: [front_count] of each front's body, if that is
                           less than [solid_count]; NULL: not known */
    bool by_front;      /* `body` has a box for each front */
    uint32_t whole;     /* number of whole solids, which come before single faces */
    double touching;    /* model units; what is farther apart does not touch */
    atomic_uchar *star; /* that of the grid. Now STAR_ONCE means that all faces about the vertex are one sheet */
    bool alone;         /* there is one thread */
    flat_patches flat;  /* looked for if many faces are near one another */
} crossing_filter;

/* If hidden lines are kept, only finds the touching distance and flat patches. False: no memory; call filter_end() in
 * any case. */
bool filter_begin(crossing_filter *p, const hide_fronts *fronts, const objet *grid, int threads);
void filter_end(crossing_filter *p);

/* Finds model[front].flat. */
bool filter_find_flat(const crossing_filter *p, uint32_t front);

/* Is it certain that no two faces of a body cross? */
static inline bool filter_is_simple(const crossing_filter *p, uint32_t body)
{
    return hide_rear_facing(p->fronts, body) != VIEW_UNKNOWN;
}

/* Is it certain that no two fronts of a cell's list cross? Then they belong to few bodies, which do not cross
 * themselves, and whose boxes in the model are apart. */
bool filter_apart_in_cell(const crossing_filter *p, const objet_entry *list, uint32_t count);

/* Have two convex faces of few corners a side in common? Then they do not cross: both lie on one side of that line,
 * each in its plane. */
bool filter_share_side(const roberts_scene *scene, uint32_t f, uint32_t g);

/* Does the plane of one of two faces of few corners, or a plane through a side of one, keep them apart in space? Call
 * it only if they have no side in common. */
bool filter_apart_in_space(const crossing_filter *p, uint32_t f, uint32_t g);

/* Does a side of one of two faces of few corners keep them apart in the picture? */
bool filter_apart_in_picture(const hide_fronts *fronts, uint32_t a, uint32_t b);

/* Two triangles share corner f[i], and no other. Does a side at that corner separate them in the picture? For
 * nearly all neighbours, one does. */
bool filter_apart_at_corner(const hide_fronts *fronts, const uint32_t f[3], int i, const uint32_t g[3]);

static inline bool filter_flat(const crossing_filter *p, uint32_t front)
{
    unsigned char known = atomic_load_explicit(&p->model[front].flat, memory_order_relaxed);
    return known == FLAT_UNKNOWN ? filter_find_flat(p, front) : known == FLAT_SOMEWHERE;
}

/* Returns how far two boxes are apart along one of the axes; negative if they overlap. */
static inline double filter_gap(const box3 *f, const box3 *g)
{
    double x = greater(f->lo.x - g->hi.x, g->lo.x - f->hi.x);
    double y = greater(f->lo.y - g->hi.y, g->lo.y - f->hi.y);
    double z = greater(f->lo.z - g->hi.z, g->lo.z - f->hi.z);
    return greater(greater(x, y), z);
}

/* The same as filter_boxes_apart() for two fronts of which one at least is no whole solid. In perspective, the boxes of
 * faces count too: the pictures of faces beside the eye are large, and overlap. */
bool filter_single_boxes_apart(const crossing_filter *p, uint32_t a, uint32_t b);

/* Do boxes in the model keep two fronts apart? Boxes of whole solids that touch do, unless a flat edge of one solid may
 * lie in a face of the other. */
static inline bool filter_boxes_apart(const crossing_filter *p, uint32_t a, uint32_t b)
{
    if (a >= p->whole || b >= p->whole)
        return filter_single_boxes_apart(p, a, b);
    const double gap = filter_gap(&p->model[a].is, &p->model[b].is);
    return gap > p->touching || (gap >= 0.0 && !filter_flat(p, a) && !filter_flat(p, b));
}

#endif
