/* union_oracle.h - which lines the union of bodies has, and how far they are visible, decided with exact numbers. It
 * applies the definition directly: around a point of a line, in the plane across it, every closed body fills an angle.
 * The line is drawn there unless the bodies together fill half of that plane, all of it or nothing. The union is never
 * built. What hides a point is as in mesh_oracle.h: faces inside the union hide nothing that the union's own faces
 * would not hide.
 *
 * Bodies are the components of faces by shared edges, as the mesh numbers its vertices. All must be closed, with two
 * faces at each edge, and no body may cross itself. */
#ifndef ROBERTS_TESTS_UNION_ORACLE_H
#define ROBERTS_TESTS_UNION_ORACLE_H

#include "oracle.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The class of a line in the picture of the union. */
typedef enum union_class {
    UNION_OUTLINE, /* both sides of the filled region lie on one side of the line, or one is edge-on */
    UNION_CREASE,
    UNION_OPEN, /* not compared: the filled region has more than two sides */
} union_class;

/* A part of a line that is drawn. */
typedef struct union_part {
    double t0, t1;
    union_class class_;
} union_part;

/* An edge of a body, or a segment in which faces of two bodies cross. */
typedef struct union_line {
    roberts_vec3 a, b;
    bool crossing, edge_on; /* not an edge; one of its faces is edge-on */
    size_t part, parts;     /* the drawn parts, in union_truth.part; they ascend */
    size_t first, count;    /* hidden intervals, in union_truth.interval; they ascend and do not touch */
} union_line;

typedef struct union_truth {
    size_t line_count, part_count, interval_count;
    union_line *line;
    union_part *part;
    oracle_interval *interval;
    size_t asked;    /* number of points of lines at which the angles were added up */
    char error[160]; /* empty: no error */
} union_truth;

/* Finds all lines. False: *truth contains only an error. Release with union_truth_free(). */
bool union_truth_find(const roberts_mesh *mesh, const oracle_view *view, union_truth *truth);
void union_truth_free(union_truth *truth);

#ifdef __cplusplus
}
#endif

#endif
