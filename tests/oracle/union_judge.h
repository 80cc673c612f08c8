/* union_judge.h - compares a table of a drawing with --union with the oracle. */
#ifndef ROBERTS_TESTS_UNION_JUDGE_H
#define ROBERTS_TESTS_UNION_JUDGE_H

#include <stdio.h>

#include "mesh_judge.h"
#include "union_oracle.h"

/* A row of any line. */
typedef struct union_row {
    roberts_vec3 p, q; /* its ends in the model */
    bool visible;
    uint8_t line; /* roberts_line */
} union_row;

typedef struct union_case {
    const mesh_scene *scene;
    const union_truth *truth;
    const char *name;
} union_case;

/* Compares, as sets of points, what is drawn, what of it is visible, and its classes. Of lines in one place, it does
 * not matter which ones have the rows. Adds to `total`, reports the first few errors to `out` and returns their
 * number. */
size_t union_judge_rows(const union_case *c, const union_row *row, size_t count, mesh_total *total, FILE *out);

/* Does the same for a drawing. */
size_t union_judge_drawing(const union_case *c, const roberts_drawing *drawing, mesh_total *total, FILE *out);

/* Returns the correct rows and sets *count. NULL: no memory. The caller frees them. */
union_row *union_rows_of_truth(const union_truth *truth, size_t *count);

#endif
