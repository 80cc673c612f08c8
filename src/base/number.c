/* number.c - converts decimal text to the nearest double.
 *
 * A number is w * 10^q with w < 2^64 for up to 19 digits. A double keeps 53 bits of w * 10^q. To round, one must know
 * on which side of the midpoint between two doubles the remaining bits lie. First w is multiplied by the upper half of
 * the 128 bits of 10^q. The result is low by less than one unit of its own upper half, which decides all but about one
 * number in a hundred. The product with the lower half decides those, except exact midpoints. If the midpoint is still
 * possible, or if the result is not a normal double, strtod() reads the digits again.
 *
 * If there are more than 19 digits, the first 19 form w, and the number lies between w and w + 1. If both give the same
 * double, that is the result.
 *
 * The locale does not matter: strtod() gets the digits without a point.
 *
 * Source: D. Lemire, "Number parsing at a gigabyte per second", Software: Practice and Experience 51(8), 2021, after M.
 * Eisel. Here every decision follows from the stated bounds, without their proof by continued fractions. */
#include "base/number.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    MANTISSA_BITS = 52,     /* stored bits; a 53rd bit is implied */
    LEAST_EXPONENT = -1022, /* of a normal double */
    EXPONENTS = 2045,       /* number of exponents from there on, except the greatest, which rounding may exceed */
    EXACT_POWER = 27,       /* 5^27 < 2^64: for 0 <= q <= 27, the upper half of 10^q is exact */
    MIDDLE_DIGITS = 768,    /* the midpoint between two doubles has at most 767 significant digits */
    EXPONENT_CLAMP = 100000 /* so large that NUMBER_LENGTH_MAX digits cannot bring it back into range */
};

const double number_power[NUMBER_MOST_FRACTION + 1] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8, 1e9,
                                                       1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18};

const uint64_t number_short_power[8] = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000};

const number_scale number_scales[NUMBER_MOST_FRACTION + 1] = {
    {0x8000000000000000u, 1085}, {0xccccccccccccccccu, 1081}, {0xa3d70a3d70a3d70au, 1078}, {0x83126e978d4fdf3bu, 1075},
    {0xd1b71758e219652bu, 1071}, {0xa7c5ac471b478423u, 1068}, {0x8637bd05af6c69b5u, 1065}, {0xd6bf94d5e57a42bcu, 1061},
    {0xabcc77118461cefcu, 1058}, {0x89705f4136b4a597u, 1055}, {0xdbe6fecebdedd5beu, 1051}, {0xafebff0bcb24aafeu, 1048},
    {0x8cbccc096f5088cbu, 1045}, {0xe12e13424bb40e13u, 1041}, {0xb424dc35095cd80fu, 1038}, {0x901d7cf73ab0acd9u, 1035},
    {0xe69594bec44de15bu, 1031}, {0xb877aa3236a4b449u, 1028}, {0x9392ee8e921d5d07u, 1025}};

/* Returns floor(log2(10^q)) for |q| <= 350: 217706 / 65536 is log2(10) truncated, and never crosses an integer in this
 * range. The offset keeps the shifted value nonnegative. */
static inline int floor_log2_power(int q)
{
    return (int)((uint32_t)(q * 217706 + (1 << 30)) >> 16) - (1 << 14);
}

/* rest_of() returns the bits of `high`, which has 63 or 64, beyond the 53 of a double. middle_of() returns the midpoint
 * between two doubles at the same position. */
static inline uint64_t middle_of(uint64_t high)
{
    return UINT64_C(512) << (high >> 63);
}

static inline uint64_t rest_of(uint64_t high)
{
    return high & (2 * middle_of(high) - 1);
}

/* Returns the bits of w * 10^q, given its 63 or 64 highest ones, on the correct side of the midpoint; 0 if it is not a
 * normal double. zeros: how far w was shifted. */
static uint64_t round_product(uint64_t high, int q, int zeros)
{
    int upper = (int)(high >> 63);
    unsigned exponent = (unsigned)(floor_log2_power(q) + 63 - zeros + upper - LEAST_EXPONENT);
    if (exponent >= EXPONENTS)
        return 0;
    /* the highest bit is the implied one and adds 1 to the exponent field, as a carry from rounding should */
    return ((uint64_t)exponent << MANTISSA_BITS) + (((high >> (9 + upper)) + 1) >> 1);
}

/* Returns the bits of the double nearest to w * 10^q, w > 0, from both products; 0 if the midpoint is still possible,
 * or if the result is not a normal double. */
static uint64_t nearest(uint64_t w, int q)
{
    if (q < POWER_MIN || q > POWER_MAX)
        return 0;
    const power_ten *power = &power_table[q - POWER_MIN];
    int zeros = bits_leading_zeros(w);
    uint64_t low, unused, high = bits_multiply(w << zeros, power->high, &low);
    uint64_t more = bits_multiply(w << zeros, power->low, &unused);
    if (q >= 0 && q <= EXACT_POWER) { /* the product is exact */
        if (rest_of(high) == middle_of(high) && low == 0 && !(high & 2 * middle_of(high)))
            high--; /* a true tie above an even double: round down */
        return round_product(high, q, zeros);
    }
    low += more;
    high += low < more;
    /* now less than two units of `low` are missing: one for `unused`, one for the part of 10^q beyond 128 bits */
    if ((rest_of(high) == middle_of(high) && low == 0) || (rest_of(high) == middle_of(high) - 1 && low == UINT64_MAX))
        return 0;
    return round_product(high, q, zeros);
}

/* Does the same as nearest() for a number of more than 19 digits. w has the first 19, and q is the exponent for
 * these. */
static uint64_t nearest_long(uint64_t w, int q)
{
    uint64_t below = nearest(w, q), above = nearest(w + 1, q);
    return below == above ? below : 0;
}

/* Calls strtod() for the digits from `text` to `end` (possibly with a point) times 10^q, where q is the exponent of the
 * last digit. */
static double read_again(const char *text, const char *end, int q)
{
    char plain[MIDDLE_DIGITS + 24];
    size_t count = 0;
    bool more = false;
    for (; text < end; text++) {
        if (*text == '.' || (count == 0 && *text == '0'))
            continue;
        if (count < MIDDLE_DIGITS) {
            plain[count++] = *text;
        } else {
            more |= *text != '0';
            q++;
        }
    }
    if (more) { /* any digit will do: it only matters that something follows */
        plain[count++] = '1';
        q--;
    }
    snprintf(plain + count, sizeof plain - count, "e%d", q);
    return strtod(plain, NULL);
}

/* Appends digits to w, which wraps after 19 of them. After sixteen digits, read eight at a time, seldom more than one
 * follows. */
static inline const char *digits(const char *text, uint64_t *w)
{
    for (int i = 0; i < 2; i++, text += 8) {
        uint64_t chunk = bits_load(text) ^ NUMBER_DIGITS;
        int count = number_digit_count(chunk);
        if (count < 8) {
            *w = *w * number_short_power[count] + number_eight_digits(chunk << 8 * (7 - count) << 8);
            return text + count;
        }
        *w = *w * 100000000 + number_eight_digits(chunk);
    }
    for (; *text >= '0' && *text <= '9'; text++)
        *w = 10 * *w + (uint64_t)(*text - '0');
    return text;
}

/* Reads the exponent after the 'e' at `text`. If no digit follows, reads nothing, like strtod(). */
static const char *exponent_part(const char *text, int *exponent)
{
    const char *c = text + 1;
    bool negative = *c == '-';
    int n = 0;
    if (*c == '-' || *c == '+')
        c++;
    if (*c < '0' || *c > '9')
        return text;
    for (; *c >= '0' && *c <= '9'; c++)
        n = n < EXPONENT_CLAMP / 10 ? 10 * n + (*c - '0') : EXPONENT_CLAMP;
    *exponent = negative ? -n : n;
    return c;
}

/* Returns the double for the digits from `text` to `end` times 10^q, if w cannot hold them or does not decide; w > 0 is
 * their value modulo 2^64. */
static double many_digits(const char *text, const char *end, int q)
{
    uint64_t w = 0, bits;
    int taken = 0, left = 0;
    double value;
    for (const char *c = text; c < end; c++) {
        if (*c == '.' || (w == 0 && *c == '0'))
            continue;
        if (taken < NUMBER_MOST_DIGITS) {
            w = 10 * w + (uint64_t)(*c - '0');
            taken++;
        } else {
            left++;
        }
    }
    if (w == 0)
        return 0.0;
    bits = left ? nearest_long(w, q + left) : nearest(w, q);
    if (!bits)
        return read_again(text, end, q);
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* Parses the numbers that number_usual() rejects. */
BITS_RARE static const char *parse_any(const char *text, double *value)
{
    const char *first = text + (*text == '-' || *text == '+'), *c = first, *end;
    uint64_t w = 0, bits = 0;
    ptrdiff_t count, fraction = 0;
    int q = 0;
    for (; *c >= '0' && *c <= '9'; c++)
        w = 10 * w + (uint64_t)(*c - '0');
    count = c - first;
    if (*c == '.') {
        const char *point = c + 1;
        c = digits(point, &w);
        fraction = c - point;
        count += fraction;
    }
    end = c;
    if (count == 0)
        return NULL;
    if ((*c | 0x20) == 'e')
        c = exponent_part(c, &q);
    if (c - text > NUMBER_LENGTH_MAX)
        return NULL;
    q -= (int)fraction;
    if (count <= NUMBER_MOST_DIGITS && w)
        bits = nearest(w, q);
    if (bits)
        memcpy(value, &bits, sizeof bits);
    else
        *value = many_digits(first, end, q);
    if (*text == '-')
        *value = -*value;
    return c;
}

const char *number_parse(const char *text, double *value)
{
    number_guess guess = number_guess_digits(8);
    const char *end = number_usual(text, &guess, value);
    return end && (*end | 0x20) != 'e' ? end : parse_any(text, value);
}

const char *number_integer(const char *text, uint64_t *value)
{
    const char *c = text;
    uint64_t n = 0;
    for (; *c >= '0' && *c <= '9'; c++) {
        uint64_t digit = (uint64_t)(*c - '0');
        n = n > (UINT64_MAX - digit) / 10 ? UINT64_MAX : 10 * n + digit;
    }
    *value = n;
    return c == text ? NULL : c;
}
