/* whole.h - vectors of integers, which are exact. */
#ifndef ROBERTS_TESTS_WHOLE_H
#define ROBERTS_TESTS_WHOLE_H

#include <stdint.h>

typedef struct whole {
    int64_t x, y, z;
} whole;

static inline whole whole_sub(whole a, whole b)
{
    return (whole){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline whole whole_cross(whole a, whole b)
{
    return (whole){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline int64_t whole_dot(whole a, whole b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

#endif
