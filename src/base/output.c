/* output.c - a buffered stream to the caller's function, and doubles as decimal text.
 *
 * printf takes 0.3 us a number, and some locales have a comma for the point. A double is m 2^e with m < 2^53, and 10^k
 * for k <= 27 is one word times a power of two. Their product is exact in two words. Shifted once, and rounded half to
 * even as printf does, it is the 17 digits. This serves 1e-11 <= |x| < 1e17; other numbers go through printf. */
#include "base/output.h"

#include <errno.h>
#include <math.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/bits.h"
#include "base/error.h"
#include "base/number.h"

/* ---- numbers ---- */

enum { DIGITS = 17, EXACT_POWER = 27 /* 5^27 < 2^63 */ };

static const uint64_t ten_to_16 = 10000000000000000u, ten_to_17 = 100000000000000000u;

typedef struct wide {
    uint64_t high, low;
} wide;

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

/* m 2^e times 10^k to the nearest integer. m < 2^53, 0 <= k <= EXACT_POWER, and the result is below 10^18. */
static uint64_t scaled(uint64_t m, int e, int k)
{
    const int log2_power = k * 217706 >> 16; /* floor(log2(10^k)) */
    wide n;
    n.high = bits_multiply(m, power_table[k - POWER_MIN].high, &n.low);
    return shift_right(n, 63 - log2_power - e); /* above 0: the upper half of the power alone has 64 bits */
}

/* Finds the 17 digits of x > 0 as one integer, and the first one's power of ten. False: out of the exact range. */
static bool exact_digits(double x, uint64_t *digits, int *exponent)
{
    if (!(x >= 1e-11 && x < 1e17))
        return false;
    uint64_t m;
    memcpy(&m, &x, sizeof m);
    int e = (int)(m >> 52) - 1022; /* 2^(e-1) <= x < 2^e */
    m = (m & ((UINT64_C(1) << 52) - 1)) | UINT64_C(1) << 52;
    int p = (int)((e - 1) * 0.30102999566398120 + 64.0) - 64; /* log10(2), rounded down: right or 1 too small */
    if (p < DIGITS - 1 - EXACT_POWER)
        p = DIGITS - 1 - EXACT_POWER;
    e -= 53;
    *digits = scaled(m, e, DIGITS - 1 - p);
    if (*digits >= ten_to_17)
        *digits = scaled(m, e, DIGITS - 1 - ++p);
    *exponent = p;
    return *digits >= ten_to_16; /* fewer digits just below 10^-11 */
}

/* The decimal text of 0 to 99, two bytes each. */
static const char pairs[] = "00010203040506070809101112131415161718192021222324252627282930313233343536373839"
                            "40414243444546474849505152535455565758596061626364656667686970717273747576777879"
                            "8081828384858687888990919293949596979899";

/* Writes n < 10^8 as eight digits. */
static void write_eight(char *out, uint32_t n)
{
    const uint32_t upper = n / 10000, lower = n % 10000;
    memcpy(out, pairs + 2 * (upper / 100), 2);
    memcpy(out + 2, pairs + 2 * (upper % 100), 2);
    memcpy(out + 4, pairs + 2 * (lower / 100), 2);
    memcpy(out + 6, pairs + 2 * (lower % 100), 2);
}

/* Writes digits as %g does: without `e` for exponents from -4 to 16, and without trailing zeros. Copies of a fixed size
 * are a few instructions; excess bytes lie beyond the end. */
static size_t write_digits(char *out, uint64_t digits, int exponent)
{
    char text[2 * DIGITS]; /* the digits, and zeros */
    char *at = out;
    const uint64_t upper = digits / 100000000;
    text[0] = (char)('0' + upper / 100000000);
    write_eight(text + 1, (uint32_t)(upper % 100000000));
    write_eight(text + 9, (uint32_t)(digits % 100000000));
    memset(text + DIGITS, '0', DIGITS);
    int count = DIGITS;
    while (count > 1 && text[count - 1] == '0')
        count--;
    const bool plain = exponent >= -4;
    const int whole = plain ? exponent + 1 : 1; /* digits before the point */
    if (whole > 0) {
        memcpy(at, text, DIGITS);
        at += whole;
    } else {
        memcpy(at, "0.000", 5);
        at += 2 - whole;
    }
    const int before = whole > 0 ? whole : 0;
    if (count > before) {
        if (before > 0)
            *at++ = '.';
        memcpy(at, text + before, DIGITS);
        at += count - before;
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
        return sign + write_digits(out + sign, digits, exponent);
    }
    char text[DECIMAL_ROOM * 2]; /* the locale's point may have several bytes */
    snprintf(text, sizeof text, "%.17g", x);
    return decimal_unlocalise(out, text);
}

/* ---- the stream ---- */

void output_start(output *out, roberts_write_fn *write, void *context)
{
    out->write = write;
    out->context = context;
    out->used = 0;
    out->failed = false;
    out->reason = 0;
    out->written = 0;
}

static void pass_on(output *out, const void *bytes, size_t size)
{
    if (out->failed || size == 0)
        return;
    errno = 0;
    out->written += size;
    if (!out->write(out->context, bytes, size)) {
        out->failed = true;
        out->reason = errno ? errno : EIO; /* not every function sets errno */
    }
}

static void flush(output *out)
{
    pass_on(out, out->bytes, out->used);
    out->used = 0;
}

void output_bytes(output *out, const void *bytes, size_t size)
{
    if (size > sizeof out->bytes - out->used)
        flush(out);
    if (size > sizeof out->bytes) {
        pass_on(out, bytes, size);
        return;
    }
    memcpy(out->bytes + out->used, bytes, size);
    out->used += size;
}

void output_text(output *out, const char *text)
{
    output_bytes(out, text, strlen(text));
}

void output_number(output *out, double x)
{
    if (DECIMAL_ROOM > sizeof out->bytes - out->used)
        flush(out);
    out->used += decimal_format(out->bytes + out->used, x);
}

void output_integer(output *out, uint32_t n)
{
    char text[10];
    size_t at = sizeof text;
    do {
        text[--at] = (char)('0' + n % 10);
        n /= 10;
    } while (n);
    output_bytes(out, text + at, sizeof text - at);
}

void output_signed(output *out, int32_t n)
{
    if (n < 0)
        output_bytes(out, "-", 1);
    output_integer(out, n < 0 ? -(uint32_t)n : (uint32_t)n);
}

void output_digits(output *out, uint64_t n, int digits)
{
    char text[20];
    for (int i = digits; i-- > 0; n /= 10)
        text[i] = (char)('0' + n % 10);
    output_bytes(out, text, (size_t)digits);
}

void output_thousandths(output *out, int32_t n)
{
    if (n < 0)
        output_bytes(out, "-", 1);
    uint32_t whole = (uint32_t)abs(n) / 1000, rest = (uint32_t)abs(n) % 1000;
    output_integer(out, whole);
    if (rest == 0)
        return;
    const char digits[] = {'.', (char)('0' + rest / 100), (char)('0' + rest / 10 % 10), (char)('0' + rest % 10)};
    output_bytes(out, digits, rest % 10 ? 4 : rest % 100 ? 3 : 2);
}

void output_mm(output *out, double mm)
{
    output_thousandths(out, (int32_t)floor(mm * 1000.0 + 0.5));
}

size_t output_character(const char *string)
{
    const unsigned char *text = (const unsigned char *)string;
    static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    uint32_t code = text[0];
    size_t length = code < 0x80 ? 1 : code < 0xc0 ? 0 : code < 0xe0 ? 2 : code < 0xf0 ? 3 : code < 0xf8 ? 4 : 0;
    if (length > 1)
        code &= 0x7fu >> length;
    for (size_t i = 1; i < length; i++) {
        if ((text[i] & 0xc0) != 0x80) /* the end of the text as well */
            return 0;
        code = code << 6 | (text[i] & 0x3f);
    }
    bool control = code < 0x20 && code != '\t' && code != '\n';
    bool none = (code >= 0xd800 && code < 0xe000) || code == 0xfffe || code == 0xffff || code > 0x10ffff;
    return length == 0 || code < least[length] || control || none ? 0 : length;
}

roberts_status output_finish(output *out, roberts_error *error)
{
    flush(out);
    return out->failed ? output_error(error, "cannot write", out->reason) : ROBERTS_OK;
}

roberts_status output_error(roberts_error *error, const char *what, int reason)
{
    char text[128];
    if (strerror_r(reason, text, sizeof text) != 0)
        return error_set(error, ROBERTS_IO, 0, "%s: error %d", what, reason);
    return error_set(error, ROBERTS_IO, 0, "%s: %s", what, text);
}

/* ---- descriptors ---- */

/* Waits until a non-blocking descriptor accepts bytes again. */
static bool wait_writable(int descriptor)
{
    struct pollfd one = {.fd = descriptor, .events = POLLOUT};
    return poll(&one, 1, -1) >= 0 || errno == EINTR;
}

bool output_descriptor(void *context, const void *bytes, size_t size)
{
    int descriptor = *(int *)context;
    const char *at = bytes;
    while (size) {
        ssize_t done = write(descriptor, at, size);
        if (done < 0 && (errno == EAGAIN || errno == EWOULDBLOCK) && wait_writable(descriptor))
            continue;
        if (done < 0 && errno == EINTR)
            continue;
        if (done < 0)
            return false;
        at += done;
        size -= (size_t)done;
    }
    return true;
}
