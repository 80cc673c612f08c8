/* sort.c - see sort.h. Many keys: radix sort, least significant digit first, 11 bits at a time. Short lists: merging of
 * runs. */
#include "base/sort.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"

#define DIGIT_BITS 11
#define DIGITS (1u << DIGIT_BITS)

/* Items that are sorted by insertion before runs are merged. */
enum { SORT_RUN = 8 };

/* Merges two runs, of which the second begins at `middle`. */
static void merge(const sort_item *from, size_t middle, size_t count, sort_item *to)
{
    const sort_item *a = from, *b = from + middle, *a_end = b, *b_end = from + count;
    while (a < a_end && b < b_end) {
        bool second = b->key < a->key; /* no branch: it would be guessed wrongly half of the time */
        *to++ = second ? *b : *a;
        a += !second;
        b += second;
    }
    memcpy(to, a, (size_t)(a_end - a) * sizeof *a);
    memcpy(to + (a_end - a), b, (size_t)(b_end - b) * sizeof *b);
}

void sort_keyed(sort_item *item, size_t count, sort_item *room)
{
    sort_item *from = item, *to = room;
    for (size_t first = 0; first < count; first += SORT_RUN) {
        size_t run = count - first < SORT_RUN ? count - first : SORT_RUN;
        SORT_FEW(sort_item, item + first, run, a->key > b->key)
    }
    for (size_t run = SORT_RUN; run < count; run *= 2) {
        for (size_t first = 0; first < count; first += 2 * run) {
            size_t left = count - first;
            merge(from + first, left < run ? left : run, left < 2 * run ? left : 2 * run, to + first);
        }
        sort_item *sorted = to;
        to = from;
        from = sorted;
    }
    if (from != item && count > 0)
        memcpy(item, from, count * sizeof *item);
}

uint32_t radix_key_descending(float x)
{
    uint32_t bits;
    x += 0.0f; /* -0 becomes +0 */
    memcpy(&bits, &x, sizeof bits);
    return bits & 0x80000000u ? bits : ~(bits | 0x80000000u);
}

static void pass(const uint32_t *key, const uint32_t *from, uint32_t *to, uint32_t count, unsigned shift)
{
    uint32_t place[DIGITS] = {0};
    for (uint32_t i = 0; i < count; i++)
        place[key[i] >> shift & (DIGITS - 1)]++;
    sort_starts(place, DIGITS);
    for (uint32_t i = 0; i < count; i++)
        to[place[key[from[i]] >> shift & (DIGITS - 1)]++] = from[i];
}

bool radix_order(const uint32_t *key, uint32_t count, uint32_t *order)
{
    uint32_t *other = alloc_array(count, sizeof *other);
    if (!other)
        return false;
    for (uint32_t i = 0; i < count; i++)
        order[i] = i;
    pass(key, order, other, count, 0);
    pass(key, other, order, count, DIGIT_BITS);
    pass(key, order, other, count, 2 * DIGIT_BITS);
    memcpy(order, other, count * sizeof *order);
    free(other);
    return true;
}

bool sort_buckets(const uint32_t *key, size_t count, size_t keys, uint32_t **start, uint32_t **order)
{
    uint32_t *first = *start = alloc_zeroed(keys + 2, sizeof *first), *item = *order = alloc_array(count, sizeof *item);
    if (!first || !item)
        return false;
    for (size_t i = 0; i < count; i++)
        first[key[i] + 2]++;
    for (size_t k = 0; k < keys; k++)
        first[k + 2] += first[k + 1];
    for (size_t i = 0; i < count; i++)
        item[first[key[i] + 1]++] = (uint32_t)i;
    return true;
}
