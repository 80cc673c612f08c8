/* union_judge.h - holds a table of a drawing with --union against the oracle. */
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

/* Compares as sets of points what is drawn, what of it is visible, and its classes: of lines in one place it does not
 * matter which ones have the rows. Adds to `total`, tells the first few faults on `out` and returns how many there
 * were. */
size_t union_judge_rows(const union_case *c, const union_row *row, size_t count, mesh_total *total, FILE *out);

/* The same for a drawing. */
size_t union_judge_drawing(const union_case *c, const roberts_drawing *drawing, mesh_total *total, FILE *out);

/* Only asks whether what should be visible is. */
size_t union_judge_lines(const union_case *c, const roberts_drawing *drawing, mesh_total *total, FILE *out);

/* The rows that are right; *count is filled. NULL: no memory. The caller frees them. */
union_row *union_rows_of_truth(const union_truth *truth, size_t *count);

#endif
