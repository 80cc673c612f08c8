/* parse.h - values of options: strict, and the same in every locale. */
#ifndef ROBERTS_CLI_PARSE_H
#define ROBERTS_CLI_PARSE_H

#include "roberts.h"

/* The whole of `text` is one decimal number, finite. */
bool parse_number(const char *text, double *number);

/* The whole of `text` is one decimal number, finite, with mm, cm, in or pt (1/72 inch) behind it; `*unit_mm` is 0 where
 * nothing is. */
bool parse_measure(const char *text, double *number, double *unit_mm);

/* The same in mm, which a number alone is taken for. */
bool parse_length(const char *text, double *mm);

/* The whole of `text` is one whole number in decimal digits, below 2^32. */
bool parse_integer(const char *text, uint32_t *number);

/* The whole of `text` is X,Y. */
bool parse_point(const char *text, roberts_vec2 *point);

/* The whole of `text` is X,Y,Z. */
bool parse_vector(const char *text, roberts_vec3 *vector);

/* Puts `number` in the one place that `pattern` has for it, %d or %03d (digits at the least, up to 9, filled up by
 * zeros); false where there is none, more than one, another %, or the name does not fit. */
bool parse_numbered(const char *pattern, uint32_t number, char *name, size_t size);

#endif
