/* order.h - the same scene in another order. */
#ifndef ROBERTS_TESTS_ORDER_H
#define ROBERTS_TESTS_ORDER_H

#include "families.h"

/* Copies the mesh with vertices and faces in another order, and with each face's corners starting elsewhere and
 * possibly reversed. The same seed gives the same order.
 * number  [vertex_count] new numbers, indexed by old ones.
 * False: no memory. */
bool order_shuffle(const roberts_mesh *mesh, uint64_t seed, roberts_mesh *other, uint32_t *number);

/* Gives the segments of a shuffled scene their old names and their old order: by solid, v0, v1 and t. `number` is from
 * order_shuffle(). `by` is not translated. False: no memory. */
bool order_restore(roberts_drawing *drawing, const uint32_t *number, size_t vertex_count, const uint32_t *vertex_solid);

#endif
