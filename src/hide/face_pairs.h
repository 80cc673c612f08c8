/* face_pairs.h - pairs of faces whose boxes meet: of two bodies, or of all bodies in space.
 *
 * If hidden lines are kept, most faces are no fronts. Then face_pairs_find() finds the pairs that may cross in space,
 * whichever way the faces look, through a tree of boxes along the axes of the model (base/search.h). Faces that are
 * edge-on are left out. A convex solid is first tested as a whole; a large one has a tree over its faces. */
#ifndef ROBERTS_HIDE_FACE_PAIRS_H
#define ROBERTS_HIDE_FACE_PAIRS_H

#include "hide/fronts.h"

/* The boxes of a body, and of pieces first .. end - 1, along the axes of the model. */
box3 face_pairs_body_box(const roberts_scene *scene, uint32_t body);
box3 face_pairs_box(const roberts_scene *scene, uint32_t first, uint32_t end);

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

/* Does a body lie outside the plane of some face of a convex solid? Then none of their faces cross. False: it is not
 * known. In a union, a sheet is never apart: where it only touches the solid, it may meet this and another one, flush
 * with it. */
bool bodies_are_apart(const hide_fronts *fronts, uint32_t solid, uint32_t body);

/* Gives all pairs of faces, by their first pieces, except those of one convex body. All bodies must be mapped.
 * touching: model units; what is farther apart is left out. threads: exactly this many. False: no memory. */
bool face_pairs_find(const hide_fronts *fronts, double touching, int threads, face_pairs_fn *take, void *context);

#endif
