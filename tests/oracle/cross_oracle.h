/* cross_oracle.h - where faces of any mesh cross, and how far those lines are visible, decided with exact numbers. It
 * applies the definition directly:
 *
 *   Two faces cross at a point X if each has points on both sides of the other's plane, however near to X. They do not
 *   cross where a bounding side of one of them runs along the other's plane: there, that edge is the line.
 *   An intersection line is a maximal segment of such points of two faces. It runs from its end of smaller (x, y, z).
 *   A face hides a point of the line as it would hide a point of an edge (mesh_oracle.h). Its own two faces do not.
 *
 * Faces, vertices and planes are those of mesh_oracle.h. A face with the same corners as an earlier one, from any start
 * and in either direction, does not exist. */
#ifndef ROBERTS_TESTS_CROSS_ORACLE_H
#define ROBERTS_TESTS_CROSS_ORACLE_H

#include "oracle.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct cross_line {
    uint32_t f0, f1;     /* faces of the mesh, f0 < f1 */
    roberts_vec3 a, b;   /* ends; each coordinate is the nearest double */
    bool edge_on;        /* a face is edge-on: in the picture, the line lies on the whole face */
    size_t first, count; /* hidden intervals, in cross_truth.interval; they ascend and do not touch */
} cross_line;

typedef struct cross_truth {
    size_t line_count, interval_count;
    cross_line *line; /* [line_count] sorted by f0, f1, a */
    oracle_interval *interval;
    uint32_t *same;      /* [face_count of the mesh] the first face with the same corners; ROBERTS_NONE: not a face */
    size_t pairs, exact; /* pairs of faces whose boxes meet; pairs of line and face that needed rational numbers */
    char error[160];     /* empty: no error */
} cross_truth;

/* Finds all lines. The viewer is at infinity, or an eye with the whole scene in front of it. False: *truth contains
 * only an error. Release with cross_truth_free(). */
bool cross_truth_find(const roberts_mesh *mesh, const oracle_view *view, bool even_odd, cross_truth *truth);
void cross_truth_free(cross_truth *truth);

/* Finds where a flat edge, which is not drawn, lies in a face that continues on both sides of the edge's faces. There
 * those faces end on it, and the line is an intersection. f0 is the face, f1 the smallest of the edge's. Faces with
 * more than four corners are not examined for flat edges. Release as above. */
bool cross_seams_find(const roberts_mesh *mesh, const oracle_view *view, bool even_odd, cross_truth *truth);

/* Returns how certain it is, in doubles, whether two faces cross at X. ORACLE_YES: they do, even if everything moves by
 * `slack` (model units). ORACLE_NO: they do not, even then. Otherwise ORACLE_UNSURE. */
oracle_answer cross_truth_at(const roberts_mesh *mesh, bool even_odd, uint32_t f0, uint32_t f1, roberts_vec3 X,
                             double slack);

#ifdef __cplusplus
}
#endif

#endif
