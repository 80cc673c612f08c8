/* number.c - decimal text to the nearest double.
 *
 * A number is w * 10^q with w < 2^64 for up to 19 digits. Its double needs 53 bits of w * 10^q and, to round, to know
 * on which side of the middle between two doubles the rest lies. One product of w with the upper half of 10^q's 128
 * bits bounds w * 10^q within one unit of 2^-63 of itself, which decides all but one number in a thousand; the product
 * with the lower half decides those, but for exact middles. Where even that leaves the middle possible, and where the
 * result is no normal double, strtod() reads the text again in the "C" locale.
 *
 * More than 19 digits: w is cut off, so the number lies between w and w + 1; where both give one double, that is it.
 *
 * Source: D. Lemire, "Number parsing at a gigabyte per second", Software: Practice and Experience 51(8), 2021, after
 * M. Eisel; here every decision follows from explicit bounds, without their proof about continued fractions. */
#include "base/number.h"

#include <locale.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "base/power.h"

enum {
    MAX_DIGITS = 19,        /* every integer of 19 digits is below 2^64 */
    MANTISSA_BITS = 52,     /* stored; a 53rd bit is implied */
    LEAST_EXPONENT = -1022, /* of a normal double */
    EXACT_POWER = 27,       /* 5^27 < 2^64: the upper half of 10^q is all of it for 0 <= q <= 27 */
    EXPONENT_CLAMP = 100000 /* further away than any number of digits that a token may have can bring back */
};

/* floor(log2(10^q)) for |q| <= 400: 217706 / 65536 is log2(10) cut off, and never crosses an integer in this range.
 * The offset 2^14 keeps the shifted value positive. */
static int floor_log2_power(int q)
{
    return (int)(((uint32_t)(q * 217706 + (1 << 30))) >> 16) - (1 << 14);
}

/* The double nearest to w * 10^q, w > 0. False where it takes more than this to decide. */
static bool nearest(uint64_t w, int q, double *value)
{
    if (q < POWER_MIN || q > POWER_MAX)
        return false;
    power_ten p = power_table[q - POWER_MIN];
    int zeros = bits_leading_zeros(w);
    w <<= zeros;
    uint64_t low, high = bits_multiply(w, p.high, &low);
    int upper = (int)(high >> 63); /* high has 63 or 64 bits */
    int cut = 10 + upper;          /* of which these are beyond the double's 53 */
    uint64_t middle = UINT64_C(1) << (cut - 1), rest = high & ((UINT64_C(1) << cut) - 1);
    bool tie = false;
    if (rest == middle - 1 || (rest == middle && low == 0)) {
        /* the true product may lie up to one unit of `high` above: the middle is within reach */
        if (q >= 0 && q <= EXACT_POWER) {
            tie = rest == middle;
        } else {
            uint64_t unused, more = bits_multiply(w, p.low, &unused);
            low += more;
            high += low < more;
            rest = high & ((UINT64_C(1) << cut) - 1);
            /* now less than two units of `low` are missing: one for `unused`, one for what 10^q has beyond 128 bits */
            if ((rest == middle && low == 0) || (rest == middle - 1 && low == UINT64_MAX))
                return false;
        }
    }
    int exponent = floor_log2_power(q) + 63 - zeros + upper;
    if (exponent < LEAST_EXPONENT || exponent >= 1023)
        return false;
    uint64_t bits = high >> cut; /* its highest bit is the implied one, which adds 1 to the exponent field */
    bool up = tie ? bits & 1 : rest >= middle;
    bits += ((uint64_t)(exponent - LEAST_EXPONENT) << MANTISSA_BITS) + up; /* a carry rightly goes into the exponent */
    memcpy(value, &bits, sizeof *value);
    return true;
}

static number_result read_in_c_locale(const char *text, double *value)
{
    locale_t c = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (!c)
        return NUMBER_NO_MEMORY;
    locale_t before = uselocale(c); /* of this thread alone */
    *value = strtod(text, NULL);
    uselocale(before);
    freelocale(c);
    return NUMBER_OK;
}

/* Adds digits to w, wrapping after 19 of them. */
static const char *digits(const char *text, uint64_t *w)
{
    static const uint64_t power[8] = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000};
    for (;;) {
        uint64_t chunk = bits_load(text) ^ NUMBER_DIGITS;
        int count = number_digit_count(chunk);
        if (count == 0)
            return text;
        if (count < 8) {
            *w = *w * power[count] + number_eight_digits(chunk << (64 - 8 * count));
            return text + count;
        }
        *w = *w * 100000000 + number_eight_digits(chunk);
        text += 8;
    }
}

/* Adds the exponent that `text` (at its 'e') gives to *q; where no digit follows, nothing is read, as in strtod(). */
static const char *exponent_part(const char *text, ptrdiff_t *q)
{
    const char *c = text + 1;
    bool negative = *c == '-';
    int exponent = 0;
    if (*c == '-' || *c == '+')
        c++;
    if (*c < '0' || *c > '9')
        return text;
    for (; *c >= '0' && *c <= '9'; c++) {
        if (exponent < EXPONENT_CLAMP)
            exponent = 10 * exponent + (*c - '0');
    }
    *q += negative ? -exponent : exponent;
    return c;
}

/* The same as nearest() for a number of more than 19 digits, which begin at `text`; q belongs to the last one. */
static bool nearest_long(const char *text, ptrdiff_t count, ptrdiff_t q, double *value)
{
    double above;
    uint64_t w = 0;
    int taken = 0;
    for (; count && (*text == '0' || *text == '.'); text++)
        count -= *text == '0'; /* leading zeros are no digits that count */
    for (; count && taken < MAX_DIGITS; text++) {
        if (*text == '.')
            continue;
        w = 10 * w + (uint64_t)(*text - '0');
        taken++;
        count--;
    }
    q += count;
    if (w == 0) {
        *value = 0.0;
        return true;
    }
    if (q < POWER_MIN || q > POWER_MAX || !nearest(w, (int)q, value))
        return false;
    if (count == 0)
        return true;
    return w < UINT64_MAX && nearest(w + 1, (int)q, &above) && above == *value;
}

number_result number_parse(const char *text, const char **end, double *value)
{
    bool negative = *text == '-';
    const char *first = text + (negative || *text == '+'), *c = first;
    uint64_t w = 0;
    ptrdiff_t q = 0, count;
    bool done;
    /* most coordinates have one to three digits before the point: not worth eight at once */
    for (; *c >= '0' && *c <= '9'; c++)
        w = 10 * w + (uint64_t)(*c - '0');
    count = c - first;
    if (*c == '.') {
        const char *fraction = ++c;
        c = digits(c, &w);
        q = fraction - c;
        count -= q;
    }
    if (count == 0)
        return NUMBER_NONE;
    if ((*c | 0x20) == 'e')
        c = exponent_part(c, &q);
    *end = c;
    if (count > MAX_DIGITS) {
        done = nearest_long(first, count, q, value);
    } else if (w == 0) {
        *value = 0.0;
        done = true;
    } else {
        done = q >= POWER_MIN && q <= POWER_MAX && nearest(w, (int)q, value);
    }
    if (!done)
        return read_in_c_locale(text, value); /* sign included */
    if (negative)
        *value = -*value;
    return NUMBER_OK;
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
