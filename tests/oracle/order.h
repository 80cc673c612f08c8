/* order.h - the same scene written in another order. */
#ifndef ROBERTS_TESTS_ORDER_H
#define ROBERTS_TESTS_ORDER_H

#include "families.h"

/* A copy of the mesh with its vertices and faces in another order, and with corners from another first one on and the
 * other way round. The same seed gives the same order. number  [vertex_count] new numbers by old ones. False: no
 * memory. */
bool order_shuffle(const roberts_mesh *mesh, uint64_t seed, roberts_mesh *other, uint32_t *number);

/* Gives the segments of a shuffled scene their old names and their old order: by solid, v0, v1 and t. `number` is that
 * of order_shuffle(). What is `by` keeps its number, which is another solid's. False: no memory. */
bool order_restore(roberts_drawing *drawing, const uint32_t *number, size_t vertex_count, const uint32_t *vertex_solid);

#endif
