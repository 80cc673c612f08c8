/* golden.h - visible segments of a model kept as text, and believed only as far as the exact oracle agrees.
 *
 * A golden is made of lines `solid v0 v1 t0 t1 class` (class: outline or crease), in the order of the drawing, for the
 * program's default options. Its comments hold what it is about:
 *   # model models/table.off
 *   # view iso
 *   # slack 0        or, as a part of the largest coordinate, what oracle_options.slack was: rounding of the model
 * Below 30 edges it also lists every edge with its ends in space, to be checked by hand. */
#ifndef ROBERTS_TESTS_GOLDEN_H
#define ROBERTS_TESTS_GOLDEN_H

#include <stdio.h>

#include "oracle.h"

typedef struct golden_total {
    size_t models, segments, edges;
    double unjudged; /* edge lengths; see judge_total */
} golden_total;

/* Program against golden and golden against oracle. What is wrong goes to `out`, with the golden's line. */
bool golden_check(const char *golden, golden_total *total, FILE *out);

/* Writes the golden of a model seen from a preset, after the oracle has agreed with every edge of it. */
bool golden_write(const char *model, const char *view, const char *golden, FILE *out);

#endif
