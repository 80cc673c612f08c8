/* cross_judge.h - holds a table's rows of intersection lines against the oracle. */
#ifndef ROBERTS_TESTS_CROSS_JUDGE_H
#define ROBERTS_TESTS_CROSS_JUDGE_H

#include <stdio.h>

#include "cross_oracle.h"
#include "mesh_judge.h"

/* A row of an intersection line, or one that claims to be. */
typedef struct cross_row {
    uint32_t body, f0, f1;
    bool intersection; /* its class says so */
    bool visible;
    double t0, t1;
    roberts_vec3 p, q; /* its ends in the model */
} cross_row;

/* What the rows are held against. */
typedef struct cross_case {
    const mesh_scene *scene;
    const cross_truth *truth;
    const uint32_t *position;  /* of mesh_truth */
    const uint32_t *face_body; /* [face_count] bodies of the faces, ROBERTS_NONE where unknown; NULL: not compared */
    const char *name;
    bool all_edges; /* are drawn: then no line is on an edge */
} cross_case;

/* Compares all rows, which are in the table's order, and adds to `total`. The first few lines that fail are told on
 * `out`. Returns how many lines and rows were wrong. */
size_t cross_judge_rows(const cross_case *c, const cross_row *row, size_t count, mesh_total *total, FILE *out);

/* The same for the rows of a drawing, with their pictures and with the ends that the drawing gives each line. `built`
 * is the library's scene. */
size_t cross_judge_drawing(const cross_case *c, const roberts_scene *built, const roberts_drawing *drawing,
                           mesh_total *total, FILE *out);

/* Where things are not exact: makes one of lines of the same faces that meet within the slack, and turns lines round
 * that the drawing has the other way about if either end may be the smaller one, since their x is the same within it.
 */
void cross_settle(const mesh_scene *scene, cross_truth *truth, const roberts_drawing *drawing);

/* The rows that are right where flat edges are left out; *count is filled. NULL: no memory. The caller frees them. */
cross_row *cross_rows_of_truth(const cross_truth *truth, const uint32_t *face_body, size_t *count);

#endif
