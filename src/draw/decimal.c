/* decimal.c - doubles as decimal text of 17 significant digits.
 *
 * printf takes 0.3 us a number, a row has six of them, and the point is a comma in some locales. A double is m 2^e with
 * m < 2^53, so x 10^k = m 5^k 2^(e+k), and for k <= 27 the product m 5^k is below 2^116: held in two words it is exact,
 * and the 17 digits are one shift, rounded half to even as printf does. That serves 1e-11 <= |x| < 1e17; the rest goes
 * through printf. */
#include "draw/decimal.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { DIGITS = 17, POWER_MAX = 27 /* 5^27 < 2^63 */ };

static const uint64_t power_of_5[POWER_MAX + 1] = {
    1u,
    5u,
    25u,
    125u,
    625u,
    3125u,
    15625u,
    78125u,
    390625u,
    1953125u,
    9765625u,
    48828125u,
    244140625u,
    1220703125u,
    6103515625u,
    30517578125u,
    152587890625u,
    762939453125u,
    3814697265625u,
    19073486328125u,
    95367431640625u,
    476837158203125u,
    2384185791015625u,
    11920928955078125u,
    59604644775390625u,
    298023223876953125u,
    1490116119384765625u,
    7450580596923828125u,
};

static const uint64_t ten_to_16 = 10000000000000000u, ten_to_17 = 100000000000000000u;

typedef struct wide {
    uint64_t high, low;
} wide;

static wide multiply(uint64_t a, uint64_t b)
{
    uint64_t a0 = a & 0xffffffffu, a1 = a >> 32, b0 = b & 0xffffffffu, b1 = b >> 32;
    uint64_t middle = a1 * b0 + (a0 * b0 >> 32);
    uint64_t upper = (middle & 0xffffffffu) + a0 * b1;
    return (wide){a1 * b1 + (middle >> 32) + (upper >> 32), a * b};
}

/* n / 2^shift, rounded half to even; 0 < shift < 128, and the result fits. */
static uint64_t shift_right(wide n, int shift)
{
    wide rest, half;
    uint64_t quotient;
    if (shift < 64) {
        quotient = n.high << (64 - shift) | n.low >> shift;
        rest = (wide){0, n.low & ((UINT64_C(1) << shift) - 1)};
        half = (wide){0, UINT64_C(1) << (shift - 1)};
    } else {
        quotient = shift == 64 ? n.high : n.high >> (shift - 64);
        rest = (wide){shift == 64 ? 0 : n.high & ((UINT64_C(1) << (shift - 64)) - 1), n.low};
        half = shift == 64 ? (wide){0, UINT64_C(1) << 63} : (wide){UINT64_C(1) << (shift - 65), 0};
    }
    bool above = rest.high > half.high || (rest.high == half.high && rest.low > half.low);
    bool tie = rest.high == half.high && rest.low == half.low;
    return quotient + (above || (tie && (quotient & 1)));
}

/* m 2^e times 10^k to the nearest integer. m < 2^53, 0 <= k <= POWER_MAX, and the result is below 10^18. */
static uint64_t scaled(uint64_t m, int e, int k)
{
    wide n = multiply(m, power_of_5[k]);
    int shift = -(e + k);
    return shift > 0 ? shift_right(n, shift) : n.low << -shift;
}

/* The 17 digits of x > 0 as one integer, and the exponent of ten of the first. False: out of the exact range. */
static bool exact_digits(double x, uint64_t *digits, int *exponent)
{
    if (!(x >= 1e-11 && x < 1e17))
        return false;
    int e;
    uint64_t m = (uint64_t)ldexp(frexp(x, &e), 53);
    int p = (int)floor((e - 1) * 0.30102999566398120); /* log10(2): right or 1 too small, as 2^(e-1) <= x < 2^e */
    if (p < DIGITS - 1 - POWER_MAX)
        p = DIGITS - 1 - POWER_MAX;
    e -= 53;
    *digits = scaled(m, e, DIGITS - 1 - p);
    if (*digits >= ten_to_17)
        *digits = scaled(m, e, DIGITS - 1 - ++p);
    *exponent = p;
    return *digits >= ten_to_16; /* not so just below 10^-11 */
}

/* Lays digits out as %g does: exponents from -4 to 16 without e, no trailing zeros. */
static size_t lay_out(char *out, uint64_t digits, int exponent)
{
    char text[DIGITS];
    char *at = out;
    int count = DIGITS;
    for (int i = DIGITS - 1; i >= 0; i--, digits /= 10)
        text[i] = (char)('0' + digits % 10);
    while (count > 1 && text[count - 1] == '0')
        count--;
    bool plain = exponent >= -4;
    int whole = plain ? exponent + 1 : 1; /* digits before the point */
    if (whole <= 0) {
        *at++ = '0';
        *at++ = '.';
        for (int i = whole; i < 0; i++)
            *at++ = '0';
    }
    for (int i = 0; i < count || i < whole; i++) {
        if (i == whole && i > 0)
            *at++ = '.';
        *at++ = i < count ? text[i] : '0';
    }
    if (!plain) {
        *at++ = 'e';
        *at++ = '-';
        *at++ = (char)('0' + -exponent / 10);
        *at++ = (char)('0' + -exponent % 10);
    }
    *at = '\0';
    return (size_t)(at - out);
}

size_t decimal_unlocalise(char *out, const char *text)
{
    char *at = out;
    for (; *text; text++) {
        if (strchr("0123456789+-e", *text))
            *at++ = *text;
        else if (at == out || at[-1] != '.')
            *at++ = '.';
    }
    *at = '\0';
    return (size_t)(at - out);
}

size_t decimal_format(char out[DECIMAL_ROOM], double x)
{
    uint64_t digits;
    int exponent;
    size_t sign = x < 0.0;
    if (x == 0.0) {
        out[0] = '0';
        out[1] = '\0';
        return 1;
    }
    if (exact_digits(fabs(x), &digits, &exponent)) {
        out[0] = '-';
        return sign + lay_out(out + sign, digits, exponent);
    }
    char text[DECIMAL_ROOM * 2]; /* a point of several bytes */
    snprintf(text, sizeof text, "%.17g", x);
    return decimal_unlocalise(out, text);
}
