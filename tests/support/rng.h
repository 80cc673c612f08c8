/* rng.h - random numbers for tests: splitmix64, the same on every machine (Steele, Lea, Flood, "Fast splittable
 * pseudorandom number generators", 2014). */
#ifndef ROBERTS_TESTS_RNG_H
#define ROBERTS_TESTS_RNG_H

#include <stdint.h>

#include "roberts.h"

typedef struct rng {
    uint64_t state;
} rng;

static inline uint64_t rng_next(rng *r)
{
    uint64_t z = r->state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static inline double rng_between(rng *r, double low, double high)
{
    return low + (high - low) * ((double)(rng_next(r) >> 11) * 0x1p-53);
}

/* Returns a number from -1 to 1. */
static inline double rng_real(rng *r)
{
    return (double)(int64_t)rng_next(r) * 0x1p-63;
}

/* Returns an integer from low to high, both included. */
static inline int rng_int(rng *r, int low, int high)
{
    return low + (int)(rng_next(r) % (uint64_t)(high - low + 1));
}

/* Returns an integer from 0 to count - 1. */
static inline uint32_t rng_below(rng *r, uint32_t count)
{
    return (uint32_t)(rng_next(r) % count);
}

/* Sets order[0 .. count - 1] to a random permutation of 0 .. count - 1. */
static inline void rng_permutation(rng *r, uint32_t *order, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        uint32_t j = (uint32_t)rng_int(r, 0, (int)i);
        order[i] = order[j];
        order[j] = i;
    }
}

/* Returns a point with coordinates from -size to size. */
static inline roberts_vec3 rng_vec3(rng *r, double size)
{
    double x = rng_between(r, -size, size), y = rng_between(r, -size, size), z = rng_between(r, -size, size);
    return (roberts_vec3){x, y, z};
}

#endif
