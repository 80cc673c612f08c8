/* number.h - converts decimal text to numbers, independent of the locale.
 *
 * The text must be followed by at least NUMBER_PADDING readable bytes, of which the first is '\0': the scanners load
 * eight characters at once and stop at anything that is not part of a number. */
#ifndef ROBERTS_BASE_NUMBER_H
#define ROBERTS_BASE_NUMBER_H

#include <float.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#include "base/bits.h"

#define NUMBER_PADDING 8

/* Characters: the longest number that is read. A double written out in full has at most 1,079, and most have fewer than
 * 30. */
#define NUMBER_LENGTH_MAX 4096

/* Reads [+-] digits [. digits] [e [+-] digits] (digits on one side of the point suffice) to the nearest double, ties to
 * even. The result is what strtod() gives in the "C" locale, bit for bit, including infinity and zero out of range.
 * Hexadecimal numbers, "inf" and "nan" are not accepted. Returns the first character after the number. NULL: the text
 * does not begin with a number, or the number is longer than NUMBER_LENGTH_MAX. */
const char *number_parse(const char *text, double *value);

/* XOR with eight characters: a digit becomes its value, anything else 10 or more. */
#define NUMBER_DIGITS 0x3030303030303030u

/* See number_not_digits(). */
#define NUMBER_CARRY 0x7676767676767676u
#define NUMBER_MARKS 0x8080808080808080u

/* Sets the highest bit of each of eight characters (the first in the lowest byte, each XOR '0') that is not a digit.
 * Only the first mark is reliable. */
static inline uint64_t number_not_digits(uint64_t chunk)
{
    /* 0..9 + 0x76 stays below 0x80, 10..127 does not; a carry out of a byte affects only later characters */
    return ((chunk + NUMBER_CARRY) | chunk) & NUMBER_MARKS;
}

/* Returns the number of leading digits. */
static inline int number_digit_count(uint64_t chunk)
{
    uint64_t other = number_not_digits(chunk);
    return other ? bits_trailing_zeros(other) >> 3 : 8;
}

/* A guess of the number of digits: as many as last time. Checking the guess, instead of counting, lets the processor
 * continue without waiting for the result. */
typedef struct number_guess {
    uint64_t digits;     /* 0..8 */
    uint64_t mark, upto; /* the mark of number_not_digits() after that many digits, and all marks up to it */
} number_guess;

BITS_INLINE number_guess number_guess_digits(int digits)
{
    uint64_t mark = UINT64_C(0x80) << 4 * digits << 4 * digits; /* none after eight digits */
    return (number_guess){(uint64_t)digits, mark, (2 * mark - 1) & NUMBER_MARKS};
}

/* Are exactly that many of eight characters (each XOR '0') leading digits? */
BITS_INLINE bool number_guess_right(uint64_t chunk, const number_guess *guess)
{
    return (((chunk + NUMBER_CARRY) | chunk) & guess->upto) == guess->mark;
}

/* Returns the number of leading digits of eight characters, and updates the guess. */
BITS_INLINE uint64_t number_guessed_count(uint64_t chunk, number_guess *guess)
{
    if (!number_guess_right(chunk, guess))
        *guess = number_guess_digits(number_digit_count(chunk));
    return guess->digits;
}

/* Returns the number formed by eight digit values, the first digit in the lowest byte: combines pairs, fours, all
 * eight. (Two parallel products in place of the last two have a shorter dependency chain but more instructions, and
 * measured no faster.) */
static inline uint64_t number_eight_digits(uint64_t chunk)
{
    chunk = (chunk * (10 * 256 + 1) >> 8) & 0x00ff00ff00ff00ffu;
    chunk = (chunk * (UINT64_C(100) * 65536 + 1) >> 16) & 0x0000ffff0000ffffu;
    return chunk * ((UINT64_C(10000) << 32) + 1) >> 32;
}

/* Reads an unsigned integer of at most seven digits, the usual case. Returns the number of digits; 0 if there are none
 * or more than seven. */
static inline int number_short_integer(const char *text, uint32_t *value)
{
    uint64_t chunk = bits_load(text) ^ NUMBER_DIGITS;
    int count = number_digit_count(chunk);
    if (count == 0 || count == 8)
        return 0;
    *value = (uint32_t)number_eight_digits(chunk << (64 - 8 * count)); /* shifts in leading zeros */
    return count;
}

/* ---- the usual number ------------------------------------------------------------------------------------------ */

/* Limits on digits in w * 10^-fraction: every integer of 19 digits is below 2^64, and at least one digit precedes the
 * point. */
#define NUMBER_MOST_DIGITS 19
#define NUMBER_MOST_WHOLE 11
#define NUMBER_MOST_FRACTION (NUMBER_MOST_DIGITS - 1)

/* Is a quotient of doubles rounded directly to double? */
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD == 0
#define NUMBER_EXACT_QUOTIENT 1
#else
#define NUMBER_EXACT_QUOTIENT 0
#endif

/* The power 10^-fraction. `high` is the upper half of its 128 bits, as in power_table. `exponent` is the exponent
 * field, less the implied bit, of w * 10^-fraction if the highest bit of w is 63 and that of the product 126:
 * floor(log2(10^-fraction)) + 63 + 1022. */
typedef struct number_scale {
    uint64_t high, exponent;
} number_scale;

extern BITS_HIDDEN const number_scale number_scales[NUMBER_MOST_FRACTION + 1]; /* [fraction] */
extern BITS_HIDDEN const uint64_t number_short_power[8];                       /* 10^0 .. 10^7 */
extern BITS_HIDDEN const double number_power[NUMBER_MOST_FRACTION + 1];        /* 10^fraction, exact */

/* Returns the bits of the double nearest to w * 10^-fraction, w > 0, from one product with the upper half of the power.
 * Returns 0 if the midpoint between two doubles is so near that the lower half matters (see number.c). */
BITS_INLINE uint64_t number_nearest(uint64_t w, ptrdiff_t fraction)
{
    const number_scale *scale = &number_scales[fraction];
    int zeros = bits_leading_zeros(w);
    uint64_t low, high = bits_multiply(w << zeros, scale->high, &low), upper = high >> 63; /* 1: 64 bits, 0: 63 */
    /* the midpoint is 2^9 or 2^10, so one unit more or less does not reach it unless the last nine bits are all 0 or
     * all 1; this rejects slightly too many, but takes only two instructions */
    if (((high + 1) & 0x1ff) <= 1)
        return 0;
    /* the highest bit is the implied one and adds 1 to the exponent field, as a carry from rounding should */
    return ((scale->exponent - (unsigned)zeros + upper) << 52) + (((high >> (9 + upper)) + 1) >> 1);
}

/* Returns the bits of w / 10^fraction for w < 2^53: both are exact then, and the quotient is rounded once. */
BITS_INLINE uint64_t number_quotient(uint64_t w, ptrdiff_t fraction)
{
    double value = (double)(int64_t)w / number_power[fraction];
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

/* Appends the digits after the eighth after the point to *w, which wraps if there are too many; returns the first other
 * character. (Of 17 significant digits, sometimes 15 and sometimes 18 follow the point. Code without branches must wait
 * for the count, and measured slower than mispredicted branches.) */
BITS_INLINE const char *number_far_digits(const char *text, uint64_t *w)
{
    uint64_t chunk = bits_load(text) ^ NUMBER_DIGITS, value = *w, others = number_not_digits(chunk);
    if (others) {
        unsigned mark = (unsigned)bits_trailing_zeros(others), count = mark >> 3;
        *w = value * number_short_power[count] + number_eight_digits(chunk << 1 << (70 - mark)); /* perhaps 0 digits */
        return text + count;
    }
    value = value * 100000000 + number_eight_digits(chunk);
    unsigned digit;
    for (text += 8; (digit = (unsigned char)*text - (unsigned)'0') < 10; text++)
        value = 10 * value + digit;
    *w = value;
    return text;
}

/* Reads [-] digits [. digits] with 1 to NUMBER_MOST_WHOLE digits before the point and at most 19 in all, which covers
 * nearly every coordinate. Returns the first character after them, which may be an 'e'. NULL: number_parse() must
 * decide. */
BITS_INLINE const char *number_usual(const char *text, number_guess *guess, double *value)
{
    bool negative = *text == '-';
    const char *first = text + negative, *c = first;
    uint64_t w = 0, bits;
    unsigned digit;
    /* digit by digit: usually there are one to three, and the processor can predict where they end; counting them would
     * make it wait for the result */
    for (; (digit = (unsigned char)*c - (unsigned)'0') < 10; c++)
        w = 10 * w + digit;
    if ((size_t)(c - first) - 1 >= NUMBER_MOST_WHOLE)
        return NULL;
    if (*c != '.') {
        double whole = (double)(int64_t)w;
        memcpy(&bits, &whole, sizeof bits);
    } else {
        uint64_t chunk = bits_load(c + 1) ^ NUMBER_DIGITS;
        uint64_t fraction = number_guessed_count(chunk, guess);
        if (fraction < 8) {
            w = w * number_short_power[fraction] + number_eight_digits(chunk << 8 * (7 - fraction) << 8);
            c += 1 + fraction;
            if (w >> DBL_MANT_DIG || !NUMBER_EXACT_QUOTIENT)
                return NULL;
            bits = number_quotient(w, (ptrdiff_t)fraction);
        } else {
            const char *point = c;
            w = w * 100000000 + number_eight_digits(chunk);
            c = number_far_digits(c + 9, &w);
            if (c - first - 1 > NUMBER_MOST_DIGITS)
                return NULL;
            bits = w ? number_nearest(w, c - point - 1) : 0;
            if (!bits) {
                if (w >> DBL_MANT_DIG || !NUMBER_EXACT_QUOTIENT || c - point - 1 > NUMBER_MOST_FRACTION)
                    return NULL; /* the second case never happens, but static analyzers cannot see that */
                bits = number_quotient(w, c - point - 1);
            }
        }
    }
    bits |= (uint64_t)negative << 63;
    memcpy(value, &bits, sizeof bits);
    return c;
}

/* Reads an unsigned integer of any length; returns the first character after its digits, or NULL if there are none. A
 * value that does not fit becomes UINT64_MAX. */
const char *number_integer(const char *text, uint64_t *value);

/* ---- powers of ten --------------------------------------------------------------------------------------------- */

/* 10^q truncated to 128 bits: 10^q = (high * 2^64 + low + d) * 2^(floor(log2(10^q)) - 127) with 0 <= d < 1, and d = 0
 * for 0 <= q <= 55. The highest bit of `high` is set. */
typedef struct power_ten {
    uint64_t high, low;
} power_ten;

#define POWER_MIN (-326) /* 19 digits times 10^-326 just reach the least normal double, 2.2e-308 */
#define POWER_MAX 308    /* 1 times 10^309 exceeds the greatest double */

extern BITS_HIDDEN const power_ten power_table[POWER_MAX - POWER_MIN + 1]; /* [q - POWER_MIN] */

#endif
