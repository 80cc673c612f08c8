/* sort.h - sorting: a few items in place, many by counting, and an order for the library's qsort().
 *
 * Few and nearly sorted: SORT_FEW(). Many with a key of 32 bits: radix_order(). Many short lists with a key of 64 bits:
 * sort_keyed(). All others: qsort(). */
#ifndef ROBERTS_BASE_SORT_H
#define ROBERTS_BASE_SORT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* Sorts items[0 .. count-1], each a `type`, by insertion: stable, and the fastest way for some ten items and for those
 * of which few are far from their places. `behind` is an expression about `const type *a` and `const type *b`: whether
 * *a, which comes before *b, belongs behind it. */
#define SORT_FEW(type, items, count, behind)                                                                           \
    for (size_t sort_i = 1; sort_i < (size_t)(count); sort_i++) {                                                      \
        const type sort_moved = (items)[sort_i], *const b = &sort_moved;                                               \
        size_t sort_k = sort_i;                                                                                        \
        for (; sort_k > 0; sort_k--) {                                                                                 \
            const type *const a = &(items)[sort_k - 1];                                                                \
            if (!(behind))                                                                                             \
                break;                                                                                                 \
            (items)[sort_k] = *a;                                                                                      \
        }                                                                                                              \
        (items)[sort_k] = sort_moved;                                                                                  \
    }

/* An item with its key. */
typedef struct sort_item {
    uint64_t key;
    uint32_t value;
} sort_item;

/* Sorts by keys, which are all different. room: for as many items. Five times as fast as qsort() for lists of some
 * thirty, since no function is called to compare. */
void sort_keyed(sort_item *item, size_t count, sort_item *room);

/* A key that ascends where `x` descends; +0 and -0 alike. x: not NaN. */
uint32_t radix_key_descending(float x);

/* Fills order[0 .. count-1] with 0 .. count-1 so that their keys ascend, ties by number, in time proportional to
 * `count`. False: no memory. */
bool radix_order(const uint32_t *key, uint32_t count, uint32_t *order);

/* The first of `count` items of `size` bytes, each of which begins with a uint32_t, ascending, that has `number` or a
 * greater one; `count`: there is none. */
static inline size_t find_numbered(const void *items, size_t count, size_t size, uint32_t number)
{
    size_t low = 0;
    while (low < count) {
        size_t middle = low + (count - low) / 2;
        uint32_t here;
        memcpy(&here, (const char *)items + middle * size, sizeof here);
        if (here < number)
            low = middle + 1;
        else
            count = middle;
    }
    return low;
}

/* For qsort(): of two uint64_t, the lesser first. */
static inline int compare_u64(const void *a, const void *b)
{
    uint64_t x, y;
    memcpy(&x, a, sizeof x);
    memcpy(&y, b, sizeof y);
    return (x > y) - (x < y);
}

/* Compares two uint32_t, for qsort() and bsearch(). */
static inline int sort_compare_numbers(const void *a, const void *b)
{
    uint32_t x, y;
    memcpy(&x, a, sizeof x);
    memcpy(&y, b, sizeof y);
    return (x > y) - (x < y);
}

#endif
