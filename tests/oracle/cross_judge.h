/* cross_judge.h - compares a table's rows of intersection lines with the oracle. */
#ifndef ROBERTS_TESTS_CROSS_JUDGE_H
#define ROBERTS_TESTS_CROSS_JUDGE_H

#include <stdio.h>

#include "cross_oracle.h"
#include "mesh_judge.h"

/* A row of an intersection line, or one that claims to be. */
typedef struct cross_row {
    uint32_t body, f0, f1;
    bool intersection; /* according to its class */
    bool visible;
    double t0, t1;
    roberts_vec3 p, q; /* its ends in the model */
} cross_row;

/* What the rows are compared with. */
typedef struct cross_case {
    const mesh_scene *scene;
    const cross_truth *truth;
    const uint32_t *position;  /* of mesh_truth */
    const uint32_t *face_body; /* [face_count] bodies of the faces, ROBERTS_NONE where unknown; NULL: not compared */
    const char *name;
    bool all_edges; /* are drawn: then no line is on an edge */
} cross_case;

/* Compares all rows, which are in the table's order, and adds to `total`. Reports the first few failures to `out`.
 * Returns the number of wrong lines and rows. */
size_t cross_judge_rows(const cross_case *c, const cross_row *row, size_t count, mesh_total *total, FILE *out);

/* Does the same for the rows of a drawing, including their picture coordinates and the ends that the drawing gives each
 * line. `built` is the library's scene. */
size_t cross_judge_drawing(const cross_case *c, const roberts_scene *built, const roberts_drawing *drawing,
                           mesh_total *total, FILE *out);

/* Adapts the truth of an inexact scene. Joins lines of the same faces that meet within the slack. Reverses lines that
 * the drawing has the other way round, if either end may be the smaller one because their x is equal within the
 * slack. Marks lines in faces that may be edge-on within the slack. */
void cross_settle(const mesh_scene *scene, cross_truth *truth, const roberts_drawing *drawing);

/* The rows that are right where flat edges are left out; *count is filled. NULL: no memory. The caller frees them. */
cross_row *cross_rows_of_truth(const cross_truth *truth, const uint32_t *face_body, size_t *count);

/* Learns the bodies of faces from the rows of edges; body[f] stays as it is where no row names face f. */
void cross_take_bodies(const roberts_scene *built, const roberts_drawing *drawing, uint32_t *body);

#endif
