/* radix.h - sorting numbers of things by a key, stable, in time proportional to their count. */
#ifndef ROBERTS_BASE_RADIX_H
#define ROBERTS_BASE_RADIX_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A key that ascends where `x` descends; +0 and -0 alike. x: not NaN. */
uint32_t radix_key_descending(float x);

/* Fills order[0 .. count-1] with 0 .. count-1 so that their keys ascend, ties by number. False: no memory. */
bool radix_order(const uint32_t *key, uint32_t count, uint32_t *order);

#endif
