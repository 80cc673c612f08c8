/* face_pairs.h - pairs of faces that may cross, whichever way they look: for drawings with hidden lines.
 *
 * Faces are found in space, through a tree of boxes (base/search.h), and not by the cells of the picture: most of
 * them are no fronts. Faces that are edge-on are left out. A convex solid is first tested as a whole. */
#ifndef ROBERTS_HIDE_FACE_PAIRS_H
#define ROBERTS_HIDE_FACE_PAIRS_H

#include "hide/fronts.h"

/* A face with its box. */
typedef struct boxed_face {
    hide_box box;
    uint32_t piece;
} boxed_face;

typedef struct face_list {
    boxed_face *item;
    size_t count, room;
} face_list;

/* Two bodies, and a face of each. */
typedef struct face_pair {
    uint32_t body[2], piece[2];
} face_pair;

/* Receives a pair of faces whose boxes meet; `thread` is the caller's number, from 0 on. False: no memory. */
typedef bool face_pairs_fn(void *context, int thread, const face_pair *pair);

typedef struct face_taker {
    face_pairs_fn *take;
    void *context;
    int thread;
} face_taker;

/* Gives all pairs of a face of each list whose boxes meet. It may sort the lists. False: no memory. */
bool face_lists_meet(face_list list[2], const uint32_t body[2], const face_taker *to);

/* Gives all pairs of faces, except those of one convex body. All bodies must be mapped. threads: exactly this many.
 * False: no memory. */
bool face_pairs_find(const hide_fronts *fronts, int threads, face_pairs_fn *take, void *context);

/* Does a body lie outside the plane of some face of a convex solid? Then none of their faces cross. False: it is not
 * known. */
bool bodies_are_apart(const hide_fronts *fronts, uint32_t solid, uint32_t body);

/* ---- boxes ----------------------------------------------------------------------------------------------------- */

static inline bool boxes_meet(const hide_box *a, const hide_box *b)
{
    return a->x0 <= b->x1 && b->x0 <= a->x1 && a->y0 <= b->y1 && b->y0 <= a->y1 && a->z0 <= b->z1 && b->z0 <= a->z1;
}

static inline hide_box box_of_face(const hide_fronts *fronts, uint32_t piece)
{
    const roberts_scene *scene = fronts->scene;
    hide_bounds own = hide_no_bounds;
    for (uint32_t k = scene->face_start[piece]; k < scene->face_start[piece + 1]; k++)
        box_add(&own.low, &own.high, fronts->P[scene->corner[k]]);
    return hide_box_around(&own);
}

#endif
