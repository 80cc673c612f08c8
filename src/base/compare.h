/* compare.h - orders for the library's sort. */
#ifndef ROBERTS_BASE_COMPARE_H
#define ROBERTS_BASE_COMPARE_H

#include <stdint.h>
#include <string.h>

/* Of two uint64_t, the lesser first. */
static inline int compare_u64(const void *a, const void *b)
{
    uint64_t x, y;
    memcpy(&x, a, sizeof x);
    memcpy(&y, b, sizeof y);
    return (x > y) - (x < y);
}

#endif
