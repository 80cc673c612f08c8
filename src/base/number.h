/* number.h - decimal text to numbers, in no locale.
 *
 * The text must be followed by at least NUMBER_PADDING readable bytes of which the first is '\0': the scanners look at
 * eight characters at once and stop at what is no part of a number. */
#ifndef ROBERTS_BASE_NUMBER_H
#define ROBERTS_BASE_NUMBER_H

#include "base/bits.h"

#define NUMBER_PADDING 8

/* Longest number that is read, characters. A double written out in full has at most 1,079, and most fewer than 30. */
#define NUMBER_LENGTH_MAX 4096

/* Reads [+-] digits [. digits] [e [+-] digits] (digits on one side of the point are enough) to the nearest double,
 * ties to even: what strtod() gives in the "C" locale, bit for bit, infinity and zero beyond the range included.
 * Hexadecimal numbers, "inf" and "nan" are no numbers here. Returns the first character that is not part of it, NULL
 * where the text does not begin with a number or where that is longer than NUMBER_LENGTH_MAX. */
const char *number_parse(const char *text, double *value);

/* Eight characters XOR this: a digit becomes its value, anything else 10 or more. */
#define NUMBER_DIGITS 0x3030303030303030u

/* How many of eight characters (first in the lowest byte, each XOR '0') are digits before the first other one. */
static inline int number_digit_count(uint64_t chunk)
{
    /* 0..9 + 0x76 stays below 0x80, 10..127 does not; a carry out of a byte only reaches characters after it */
    uint64_t other = ((chunk + 0x7676767676767676u) | chunk) & 0x8080808080808080u;
    return other ? bits_trailing_zeros(other) >> 3 : 8;
}

/* The number that eight digit values make, the first digit in the lowest byte: pairs, then fours and eight at once. */
static inline uint64_t number_eight_digits(uint64_t chunk)
{
    chunk = chunk * 10 + (chunk >> 8); /* bytes 0, 2, 4, 6 hold pairs */
    uint64_t pairs = chunk & 0x000000ff000000ffu, others = (chunk >> 16) & 0x000000ff000000ffu;
    return (uint32_t)((pairs * (100 + (UINT64_C(1000000) << 32)) + others * (1 + (UINT64_C(10000) << 32))) >> 32);
}

/* Reads an unsigned integer of at most seven digits, the usual case; returns its digits, 0 where there is no digit or
 * where there are more than seven. */
static inline int number_short_integer(const char *text, uint32_t *value)
{
    uint64_t chunk = bits_load(text) ^ NUMBER_DIGITS;
    int count = number_digit_count(chunk);
    if (count == 0 || count == 8)
        return 0;
    *value = (uint32_t)number_eight_digits(chunk << (64 - 8 * count)); /* leading zeros come in */
    return count;
}

/* Reads an unsigned integer of any length; returns the first character after its digits, NULL where there is none.
 * What does not fit becomes UINT64_MAX. */
const char *number_integer(const char *text, uint64_t *value);

#endif
