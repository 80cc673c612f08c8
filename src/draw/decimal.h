/* decimal.h - doubles as decimal text of 17 significant digits, the same in every locale. */
#ifndef ROBERTS_DRAW_DECIMAL_H
#define ROBERTS_DRAW_DECIMAL_H

#include <stddef.h>

enum { DECIMAL_ROOM = 32 }; /* the longest is -1.2345678901234567e-308 and its NUL */

/* Writes what printf("%.17g", x) does in the C locale, but "0" for -0, and returns its length. Reading it back gives x
 * itself. x is finite. */
size_t decimal_format(char out[DECIMAL_ROOM], double x);

/* Copies what printf made of a number in some locale: whatever is no digit, sign or exponent becomes one point. */
size_t decimal_unlocalise(char *out, const char *text);

#endif
