/* parse.h - values of options: strict, and the same in every locale. */
#ifndef ROBERTS_CLI_PARSE_H
#define ROBERTS_CLI_PARSE_H

#include "roberts.h"

/* The whole of `text` is one decimal number, finite. */
bool parse_number(const char *text, double *number);

/* The whole of `text` is one whole number in decimal digits, below 2^32. */
bool parse_integer(const char *text, uint32_t *number);

/* The whole of `text` is X,Y. */
bool parse_point(const char *text, roberts_vec2 *point);

/* The whole of `text` is X,Y,Z. */
bool parse_vector(const char *text, roberts_vec3 *vector);

#endif
