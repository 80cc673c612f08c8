/* power.h - powers of ten to 128 bits, cut off: 10^q = (high * 2^64 + low + d) * 2^(floor(log2(10^q)) - 127) with
 * 0 <= d < 1, and d = 0 for 0 <= q <= 55. The highest bit of `high` is set. */
#ifndef ROBERTS_BASE_POWER_H
#define ROBERTS_BASE_POWER_H

#include <stdint.h>

#include "base/bits.h"

#define POWER_MIN (-326) /* 19 digits times 10^-326 can just reach the least normal double, 2.2e-308 */
#define POWER_MAX 308    /* 1 times 10^309 is beyond the greatest double */

typedef struct power_ten {
    uint64_t high, low;
} power_ten;

extern BITS_HIDDEN const power_ten power_table[POWER_MAX - POWER_MIN + 1]; /* [q - POWER_MIN] */

#endif
