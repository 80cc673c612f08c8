/* parse.h - numbers, lengths and words in text: strict, and the same in every locale. */
#ifndef ROBERTS_CLI_PARSE_H
#define ROBERTS_CLI_PARSE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* ---- the whole text; false where it is anything else ---- */

/* One decimal number, finite. */
bool parse_number(const char *text, double *number);

/* One whole number in decimal digits, below 2^32. */
bool parse_integer(const char *text, uint32_t *number);

/* `count` numbers with commas between them. */
bool parse_numbers(const char *text, double *number, size_t count);

/* Two numbers with a colon between them. */
bool parse_ratio(const char *text, double *a, double *b);

/* A number of mm, or one followed by mm, cm, in or pt (1/72 inch). */
bool parse_length(const char *text, double *mm);

/* Two lengths with `sign` between them. A unit after one of them holds for both, as in 8.5x11in. */
bool parse_lengths(const char *text, char sign, double *a_mm, double *b_mm);

/* ---- words ---- */

/* Copies the text before the first `end` (or all of it) to `word`. Returns the text after `end`; NULL: there is no
 * `end`. `*fits` is false if `word` is too small. */
const char *parse_word(const char *text, char end, char *word, size_t size, bool *fits);

/* Index of `word` in a list that ends with NULL; that of the NULL if the list lacks it. */
size_t parse_find(const char *word, const char *const *words);

/* Does the name of a file end in `ending`, from its last point on, in capitals or not? */
bool parse_has_ending(const char *name, const char *ending);

/* Puts `number` in its place in `pattern`: %d, or %03d (at least that many digits, up to 9, with leading zeros). False
 * if there is no such place, more than one, another %, or the name does not fit. */
bool parse_numbered(const char *pattern, uint32_t number, char *name, size_t size);

/* Puts `word` in its place in `pattern`: %s. False if there is no such place, another %, or the name does not fit. */
bool parse_named(const char *pattern, const char *word, char *name, size_t size);

#endif
