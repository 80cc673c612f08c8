/* list_tree.h - the shape of a tree over a list. Each node covers eight items; on the next level, each node covers
 * eight of these nodes, until at most eight are left. The levels are called ranks, the lowest first. The caller stores
 * the nodes' contents. */
#ifndef ROBERTS_BASE_LIST_TREE_H
#define ROBERTS_BASE_LIST_TREE_H

#include <stdint.h>

#include "base/bits.h"

/* A node has 2^LIST_TREE_BITS items or nodes below it. */
#define LIST_TREE_BITS 3
/* Most ranks: those of a tree over 2^32 items. */
#define LIST_TREE_RANKS 10

typedef struct list_tree {
    uint32_t items, ranks;
    uint32_t start[LIST_TREE_RANKS + 1]; /* first node of each rank; start[ranks] is the number of nodes */
} list_tree;

/* Returns the node of this rank that covers the item. */
static inline uint32_t list_tree_node(const list_tree *t, int rank, uint32_t item)
{
    return t->start[rank] + (item >> (LIST_TREE_BITS * (rank + 1)));
}

/* Returns the end of the items that the node of this rank covers. The node begins at `item`. */
static inline uint32_t list_tree_end(const list_tree *t, int rank, uint32_t item)
{
    uint64_t end = (uint64_t)item + (UINT64_C(1) << (LIST_TREE_BITS * (rank + 1)));
    return end < t->items ? (uint32_t)end : t->items;
}

/* Makes the tree over `items` items. Even a single item has a node. */
static inline list_tree list_tree_over(uint32_t items)
{
    list_tree t = {.items = items};
    for (uint32_t n = items; t.ranks == 0 || n > 1u << LIST_TREE_BITS;) {
        n = (n >> LIST_TREE_BITS) + (n % (1u << LIST_TREE_BITS) > 0);
        t.start[t.ranks + 1] = t.start[t.ranks] + n;
        t.ranks++;
    }
    return t;
}

/* Returns the highest rank with a node that begins at `item`, a multiple of eight. */
static inline int list_tree_highest(const list_tree *t, uint32_t item)
{
    int most = (int)t->ranks - 1, rank = item ? bits_trailing_zeros(item) / LIST_TREE_BITS - 1 : most;
    return rank < most ? rank : most;
}

#endif
