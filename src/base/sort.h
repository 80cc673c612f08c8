/* sort.h - sorting: insertion sort, radix sort, and comparison functions for qsort(); searches in what is sorted.
 *
 * For few or nearly sorted items: SORT_FEW(). For many short lists: SORT_LIST(), sort_short_list() if they are of
 * 64-bit numbers, or sort_keyed() if items have 64-bit keys. For many items with 32-bit keys: radix_order(). For all
 * others: qsort(). */
#ifndef ROBERTS_BASE_SORT_H
#define ROBERTS_BASE_SORT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Sorts items[0 .. count-1], each a `type`, by insertion. It is stable, and the fastest method for about ten items, or
 * for items that are nearly sorted. `behind` is an expression in `const type *a` and `const type *b`: true if *a, which
 * precedes *b, belongs after it. */
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

enum { SORT_SHORT = 24 }; /* up to this many items, insertion sort beats qsort() */

/* Sorts one of many lists of which nearly all are short: as SORT_FEW(), or by qsort() with `compare`. */
#define SORT_LIST(type, items, count, behind, compare)                                                                 \
    if ((count) > SORT_SHORT) {                                                                                        \
        qsort(items, count, sizeof(type), compare);                                                                    \
    } else {                                                                                                           \
        SORT_FEW(type, items, count, behind)                                                                           \
    }

/* An item with its key. */
typedef struct sort_item {
    uint64_t key;
    uint32_t value;
} sort_item;

/* Sorts items by their keys, which must all differ. room: for `count` items. Five times as fast as qsort() for lists of
 * about thirty items, since it calls no function to compare. */
void sort_keyed(sort_item *item, size_t count, sort_item *room);

/* Returns a key that ascends as `x` descends; +0 and -0 give the same key. x: not NaN. */
uint32_t radix_key_descending(float x);

/* Fills order[0 .. count-1] with 0 .. count-1 sorted by ascending keys, ties by number. Takes linear time. False: no
 * memory. */
bool radix_order(const uint32_t *key, uint32_t count, uint32_t *order);

/* Turns the numbers of items with each key into the place where they begin, key after key. Returns how many there are.
 */
static inline uint32_t sort_starts(uint32_t *number, size_t keys)
{
    uint32_t sum = 0;
    for (size_t k = 0; k < keys; k++) {
        uint32_t here = number[k];
        number[k] = sum;
        sum += here;
    }
    return sum;
}

/* Lists 0 .. count-1 by their keys, which are less than `keys`, ties by number: (*order)[(*start)[k]] and so on have
 * the key k. Takes linear time. False: no memory. Free *start, [keys + 2], and *order, [count], in any case. */
bool sort_buckets(const uint32_t *key, size_t count, size_t keys, uint32_t **start, uint32_t **order);

/* Compares two uint64_t, for qsort(). */
static inline int compare_u64(const void *a, const void *b)
{
    uint64_t x, y;
    memcpy(&x, a, sizeof x);
    memcpy(&y, b, sizeof y);
    return (x > y) - (x < y);
}

/* Sorts one of many lists of which nearly all are short. */
static inline void sort_short_list(uint64_t *item, size_t count)
{
    SORT_LIST(uint64_t, item, count, *a > *b, compare_u64)
}

/* Compares two doubles that are not NaN, for qsort(). */
static inline int compare_doubles(const void *a, const void *b)
{
    double x, y;
    memcpy(&x, a, sizeof x);
    memcpy(&y, b, sizeof y);
    return (x > y) - (x < y);
}

/* Compares two uint32_t, for qsort() and bsearch(). */
static inline int compare_u32(const void *a, const void *b)
{
    uint32_t x, y;
    memcpy(&x, a, sizeof x);
    memcpy(&y, b, sizeof y);
    return (x > y) - (x < y);
}

/* Finds the first of `count` items of `size` bytes that does not come before *key; `count`: none. The items are sorted
 * by `compare`. */
static inline size_t find_first(const void *key, const void *items, size_t count, size_t size,
                                int (*compare)(const void *, const void *))
{
    size_t low = 0;
    while (low < count) {
        const size_t middle = low + (count - low) / 2;
        if (compare((const char *)items + middle * size, key) < 0)
            low = middle + 1;
        else
            count = middle;
    }
    return low;
}

/* The same for items that begin with their key, a uint32_t. */
static inline size_t find_numbered(const void *items, size_t count, size_t size, uint32_t number)
{
    return find_first(&number, items, count, size, compare_u32);
}

/* Compares two pairs of numbers: by the first ones, then by the second ones. */
static inline int compare_pairs(const uint32_t a[2], const uint32_t b[2])
{
    const int i = a[0] == b[0];
    return (a[i] > b[i]) - (a[i] < b[i]);
}

#endif
