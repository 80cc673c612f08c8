/* ranks.h - nodes over a list: of eight items each, then of eight nodes each, until no more than eight are left. Items and
 * nodes are numbered from 0 on each rank; what a node is, others say. */
#ifndef ROBERTS_HIDE_RANKS_H
#define ROBERTS_HIDE_RANKS_H

#include <stdbool.h>
#include <stdint.h>

#include "base/bits.h"

/* Items of a node: two to this power. */
#define RANKS_BITS 3
/* Enough for as many items as can be counted. */
#define RANKS_MOST 10

typedef struct ranks {
    uint32_t items, count;
    uint32_t start[RANKS_MOST + 1]; /* of each rank's nodes, the lowest rank first; and their end */
} ranks;

/* Over so many items; of one at least there is a node. */
static inline ranks ranks_over(uint32_t items)
{
    ranks r = {.items = items};
    for (uint32_t n = items; r.count == 0 || n > 1u << RANKS_BITS;) {
        n = (n >> RANKS_BITS) + (n % (1u << RANKS_BITS) > 0);
        r.start[r.count + 1] = r.start[r.count] + n;
        r.count++;
    }
    return r;
}

/* The highest rank of which a node begins with this item, a multiple of eight. */
static inline int ranks_highest(const ranks *r, uint32_t item)
{
    int most = (int)r->count - 1, rank = item ? bits_trailing_zeros(item) / RANKS_BITS - 1 : most;
    return rank < most ? rank : most;
}

/* That node. */
static inline uint32_t ranks_node(const ranks *r, int rank, uint32_t item)
{
    return r->start[rank] + (item >> (RANKS_BITS * (rank + 1)));
}

/* The item after a node's last one. */
static inline uint32_t ranks_end(const ranks *r, int rank, uint32_t item)
{
    uint64_t end = (uint64_t)item + (UINT64_C(1) << (RANKS_BITS * (rank + 1)));
    return end < r->items ? (uint32_t)end : r->items;
}

#endif
