/* sweep_order.h - the lines that a sweep line meets, from the lowest to the highest: a list with a search tree over it.
 *
 * The tree is a treap (C. R. Aragon, R. Seidel, "Randomized search trees", Algorithmica 16, 1996) whose priorities come
 * from the numbers of the lines, so that every run is the same. */
#ifndef ROBERTS_MODEL_SWEEP_ORDER_H
#define ROBERTS_MODEL_SWEEP_ORDER_H

#include "roberts.h"

/* A line in the order; ROBERTS_NONE: there is none. */
typedef struct sweep_place {
    uint32_t parent, child[2]; /* in the tree: 0 below, 1 above */
    uint32_t near[2];          /* in the list */
} sweep_place;

typedef struct sweep_order {
    sweep_place *place; /* by line */
    uint32_t root;      /* ROBERTS_NONE: no line */
} sweep_order;

/* Room for lines 0 .. count-1, none in the order. False: no memory. */
bool sweep_order_start(sweep_order *order, size_t count);

/* Puts a line right above another, or lowest of all if that is ROBERTS_NONE. */
void sweep_order_insert(sweep_order *order, uint32_t line, uint32_t below);

/* The line right above another, or the lowest of all if that is ROBERTS_NONE. */
uint32_t sweep_order_above(const sweep_order *order, uint32_t below);

void sweep_order_remove(sweep_order *order, uint32_t line);

void sweep_order_free(sweep_order *order);

#endif
