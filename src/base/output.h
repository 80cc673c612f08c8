/* output.h - a buffered stream to the caller's function, and doubles as decimal text. */
#ifndef ROBERTS_BASE_OUTPUT_H
#define ROBERTS_BASE_OUTPUT_H

#include <stddef.h>
#include <stdint.h>

#include "roberts.h"

/* After a failure all further output is dropped, and the first reason is kept: only output_finish() needs to be
 * checked. */
typedef struct output {
    roberts_write_fn *write;
    void *context;
    size_t used;
    bool failed;
    int reason;       /* errno of the first failure */
    uint64_t written; /* bytes passed on so far */
    char bytes[16384];
} output;

void output_start(output *out, roberts_write_fn *write, void *context);
void output_bytes(output *out, const void *bytes, size_t size);
void output_text(output *out, const char *text);
void output_number(output *out, double x); /* as decimal_format() */
void output_integer(output *out, uint32_t n);
void output_signed(output *out, int32_t n);

/* Writes n with leading zeros, `digits` digits in all. */
void output_digits(output *out, uint64_t n, int digits);

/* Writes n / 1000 with at most three decimals: 0.35, 12, -1189.5. */
void output_thousandths(output *out, int32_t n);

/* Writes a length, rounded to three decimals. */
void output_mm(output *out, double mm);

/* Bytes so far. */
static inline uint64_t output_position(const output *out)
{
    return out->written + out->used;
}

/* The length of the character of UTF-8 at the start of `string`, in its shortest form (RFC 3629); 0 if it is none, or
 * one that XML 1.0 does not allow. A file's name may hold any bytes. */
size_t output_character(const char *string);

/* Writes the rest of the buffer. Returns ROBERTS_OK, or ROBERTS_IO with the reason. */
roberts_status output_finish(output *out, roberts_error *error);

/* Sets ROBERTS_IO with the message "what: reason", in the system's words for this errno. */
roberts_status output_error(roberts_error *error, const char *what, int reason);

/* A roberts_write_fn that writes to a descriptor, an int to which `context` points. False: errno says why. */
bool output_descriptor(void *context, const void *bytes, size_t size);

enum { DECIMAL_ROOM = 40 }; /* the longest text has 24 bytes and its NUL; copies of a fixed size write beyond it */

/* Writes what printf("%.17g", x) writes in the C locale, but "0" for -0, and returns its length. It reads back as x
 * itself. x is finite. */
size_t decimal_format(char out[DECIMAL_ROOM], double x);

/* Copies what printf made of a number in some locale: a run of anything but digits, signs and `e` becomes one point. */
size_t decimal_unlocalise(char *out, const char *text);

#endif
