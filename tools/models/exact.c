/* exact.c - numbers that are the same on every machine. See exact.h. */
#include "exact.h"

/* cos and sin of x in [0, pi/4] by their series; the first omitted term is below 2^-64. */
static roberts_vec2 cos_sin_series(double x)
{
    double xx = x * x, c = 1, s = 1;
    for (int k = 18; k > 0; k -= 2) {
        c = 1 - xx / (k * (k - 1)) * c;
        s = 1 - xx / (k * (k + 1)) * s;
    }
    return (roberts_vec2){c, x * s};
}

/* The first eighth of the turn, 8 k <= n. */
static roberts_vec2 first_octant(uint64_t k, uint64_t n)
{
    const double two_pi = 6.283185307179586476925;
    if (8 * k == n)
        return (roberts_vec2){sqrt(0.5), sqrt(0.5)};
    if (12 * k == n)
        return (roberts_vec2){sqrt(0.75), 0.5};
    return cos_sin_series(two_pi * (double)k / (double)n);
}

roberts_vec2 circle_point(uint64_t k, uint64_t n)
{
    roberts_vec2 p;
    k %= n;
    if (2 * k > n) { /* lower half: mirror image of the upper half */
        p = circle_point(n - k, n);
        return (roberts_vec2){p.x, -p.y};
    }
    if (4 * k > n) { /* second quarter: mirror image of the first; k/n -> 1/2 - k/n */
        p = circle_point(n - 2 * k, 2 * n);
        return (roberts_vec2){-p.x, p.y};
    }
    if (8 * k > n) { /* second eighth: mirror image of the first; k/n -> 1/4 - k/n */
        p = first_octant(n - 4 * k, 4 * n);
        return (roberts_vec2){p.y, p.x};
    }
    return first_octant(k, n);
}

motion turn(int w, int x, int y, int z, double scale, roberts_vec3 shift)
{
    int ww = w * w, xx = x * x, yy = y * y, zz = z * z;
    int m[3][3] = {{ww + xx - yy - zz, 2 * (x * y - w * z), 2 * (x * z + w * y)},
                   {2 * (x * y + w * z), ww - xx + yy - zz, 2 * (y * z - w * x)},
                   {2 * (x * z - w * y), 2 * (y * z + w * x), ww - xx - yy + zz}};
    motion result = {.shift = shift};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            result.m[i][j] = scale * m[i][j] / (ww + xx + yy + zz);
    return result;
}

roberts_vec2 half_angle(double t)
{
    return (roberts_vec2){(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)};
}

static uint64_t rng_next(rng *r)
{
    uint64_t z = r->state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

rng rng_of(uint64_t seed, uint64_t index)
{
    rng outer = {seed};
    rng inner = {rng_next(&outer) + index};
    return (rng){rng_next(&inner)};
}

int64_t rng_between(rng *r, int64_t lo, int64_t hi)
{
    uint64_t count = (uint64_t)(hi - lo) + 1;
    return lo + (int64_t)((rng_next(r) >> 32) * count >> 32);
}

double rng_unit(rng *r)
{
    return (double)(rng_next(r) >> 44) / 1048576.0;
}

motion rng_turn(rng *r, double scale, roberts_vec3 shift)
{
    int q[4], square;
    do { /* from a ball, so that no direction is favoured */
        square = 0;
        for (int i = 0; i < 4; i++) {
            q[i] = (int)rng_between(r, -16, 16);
            square += q[i] * q[i];
        }
    } while (square < 64 || square > 256);
    return turn(q[0], q[1], q[2], q[3], scale, shift);
}
