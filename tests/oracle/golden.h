/* golden.h - visible segments of a model stored as text, and accepted only as far as the exact oracle agrees.
 *
 * A golden file has lines `solid v0 v1 t0 t1 class` (class: outline or crease), in the order of the drawing, for the
 * program's default options. Its comments describe it:
 *   # model models/table.off
 *   # view iso
 *   # slack 0        or oracle_options.slack as a fraction of the largest coordinate: rounding of the model
 *
 * The file of a model with fewer than 30 edges also lists every edge with its ends in space, to be checked by hand. */
#ifndef ROBERTS_TESTS_GOLDEN_H
#define ROBERTS_TESTS_GOLDEN_H

#include <stdio.h>

#include "oracle.h"

typedef struct golden_total {
    size_t models, segments, edges;
    double unjudged; /* edge lengths; see judge_total */
} golden_total;

/* Compares the program with the golden file, and that file with the oracle. Reports errors to `out`, with the file's
 * line. */
bool golden_check(const char *golden, golden_total *total, FILE *out);

/* Writes the golden file of a model seen from a preset, if the oracle agrees with every edge of it. */
bool golden_write(const char *model, const char *view, const char *golden, FILE *out);

#endif
