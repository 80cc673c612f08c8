/* sort.c - radix sort: least significant digit first, 11 bits at a time. */
#include "base/sort.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"

#define DIGIT_BITS 11
#define DIGITS (1u << DIGIT_BITS)

uint32_t radix_key_descending(float x)
{
    uint32_t bits;
    x += 0.0f; /* -0 becomes +0 */
    memcpy(&bits, &x, sizeof bits);
    return bits & 0x80000000u ? bits : ~(bits | 0x80000000u);
}

static void pass(const uint32_t *key, const uint32_t *from, uint32_t *to, uint32_t count, unsigned shift)
{
    uint32_t place[DIGITS] = {0}, next = 0;
    for (uint32_t i = 0; i < count; i++)
        place[key[i] >> shift & (DIGITS - 1)]++;
    for (uint32_t d = 0; d < DIGITS; d++) {
        uint32_t c = place[d];
        place[d] = next;
        next += c;
    }
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
