/* sets.h - disjoint sets of numbers, each identified by its root: R. E. Tarjan, J. van Leeuwen, "Worst-case analysis of
 * set union algorithms", Journal of the ACM 31(2), 1984. */
#ifndef ROBERTS_BASE_SETS_H
#define ROBERTS_BASE_SETS_H

#include <stdint.h>

/* Returns the root of i's set, which is its own parent. Halves the path on the way. */
static inline uint32_t sets_root(uint32_t *parent, uint32_t i)
{
    while (parent[i] != i) {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    return i;
}

/* Joins the sets of a and b. The smaller root becomes the root of both. */
static inline void sets_join(uint32_t *parent, uint32_t a, uint32_t b)
{
    a = sets_root(parent, a);
    b = sets_root(parent, b);
    if (a < b)
        parent[b] = a;
    else
        parent[a] = b;
}

#endif
