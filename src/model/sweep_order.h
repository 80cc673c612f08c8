/* sweep_order.h - the lines that a sweep line meets, from the lowest to the highest: a list with a search tree over it.
 *
 * The tree is a treap (C. R. Aragon, R. Seidel, "Randomized search trees", Algorithmica 16, 1996) whose priorities are
 * computed from the numbers of the lines, so every run is the same. */
#ifndef ROBERTS_MODEL_SWEEP_ORDER_H
#define ROBERTS_MODEL_SWEEP_ORDER_H

#include "roberts.h"

/* A line in the order. ROBERTS_NONE: no such neighbour. */
typedef struct sweep_place {
    uint32_t parent, child[2]; /* in the tree: child 0 below, child 1 above */
    uint32_t near[2];          /* in the list: the lines below and above */
    uint32_t priority;         /* no child has a greater one */
} sweep_place;

typedef struct sweep_order {
    sweep_place *place; /* indexed by line */
    uint32_t root;      /* ROBERTS_NONE: no line */
} sweep_order;

/* Makes room for lines 0 .. count-1; none is in the order yet. False: no memory. */
bool sweep_order_start(sweep_order *order, size_t count);

/* Inserts a line directly above another, or as the lowest if `below` is ROBERTS_NONE. */
void sweep_order_insert(sweep_order *order, uint32_t line, uint32_t below);

/* Returns the line directly above another, or the lowest if `below` is ROBERTS_NONE. */
uint32_t sweep_order_above(const sweep_order *order, uint32_t below);

void sweep_order_remove(sweep_order *order, uint32_t line);

void sweep_order_free(sweep_order *order);

#endif
