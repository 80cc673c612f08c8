/* exact.h - numbers that are the same on every machine: circles, rotations, random numbers.
 *
 * Only +, -, *, / and sqrt are used, which IEEE 754 rounds correctly; sin, cos and cbrt of the C library may differ in
 * the last bit between versions. Rotations are rational: an integer quaternion, or a Pythagorean triple. */
#ifndef MODELS_EXACT_H
#define MODELS_EXACT_H

#include <stdint.h>

#include "body.h"

/* Returns (cos, sin) of k/n of a full turn, n >= 1. Multiples of 1/8 and 1/12 turn give the nearest doubles to their
 * closed forms, and mirror images of a point are exact. */
roberts_vec2 circle_point(uint64_t k, uint64_t n);

/* Returns the rotation by the quaternion w + xi + yj + zk, not 0, with integer components; scaled by `scale`, then
 * shifted. */
motion turn(int w, int x, int y, int z, double scale, roberts_vec3 shift);

/* Returns the rotation about +z by the angle of (1 + i t)^2, which is 2 atan t: rational in t. */
roberts_vec2 half_angle(double t);

/* A stream of random numbers: splitmix64 (Steele, Lea, Flood, "Fast splittable pseudorandom number generators", OOPSLA
 * 2014). */
typedef struct rng {
    uint64_t state;
} rng;

/* Returns the stream of item `index`: items can be made in any order and more than once. */
rng rng_of(uint64_t seed, uint64_t index);

/* Returns an integer in lo .. hi, hi - lo < 2^32; biased by less than 2^-32 per value. */
int64_t rng_between(rng *r, int64_t lo, int64_t hi);

/* Returns a multiple of 2^-20 in [0, 1). */
double rng_unit(rng *r);

/* Returns a random rotation, uniformly distributed except for its granularity: integer quaternions of length up to
 * 16. */
motion rng_turn(rng *r, double scale, roberts_vec3 shift);

#endif
