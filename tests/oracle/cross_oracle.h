/* cross_oracle.h - where faces of any mesh cross, and how far those lines are visible, decided with exact numbers. It
 * applies the definition directly:
 *
 *   Two faces cross at a point X if each has points on both sides of the other's plane, however near to X. They do not
 *   cross where a bounding side of one of them runs along the other's plane: there, that edge is the line.
 *   An intersection line is a maximal segment of such points of two faces. It runs from its end of smaller (x, y, z).
 *   An edge is left out if the angle between its faces is less than a tenth of a degree, and they lie on both sides of
 *   it in the picture. So is a side that lies inside its own face, whose border winds once on one side of it and twice
 *   on the other. But where such an edge lies inside another face, and its own faces lie on both sides of that face, it
 *   is an intersection line. So is the overlap of two edges that are left out, if the faces of each lie on both sides
 *   of the faces of the other. The faces of such a line are the other face, or the first one of the other edge, and the
 *   first of its own faces that is not in one plane with that. Faces hide points of these lines as they hide points of
 *   edges (mesh_oracle.h), but a line's own faces do not hide it.
 *
 * Faces, vertices and planes are those of mesh_oracle.h. A face with the same corners as an earlier one, from any start
 * and in either direction, does not exist. Bodies that are closed as they are in the file (an even number of faces at
 * each edge) have vertices of their own, even where these are at the positions of others; so their edges and faces are
 * their own. */
#ifndef ROBERTS_TESTS_CROSS_ORACLE_H
#define ROBERTS_TESTS_CROSS_ORACLE_H

#include "oracle.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct cross_line {
    uint32_t f0, f1;     /* faces of the mesh, f0 < f1 */
    roberts_vec3 a, b;   /* its ends, each coordinate the nearest double */
    bool edge_on;        /* a face is edge-on: the line lies in the picture where the whole face does */
    bool on_edge;        /* one face ends on the other along an edge that is left out; no line where all edges are */
    size_t first, count; /* hidden intervals, into cross_truth.interval; they ascend and do not touch */
} cross_line;

typedef struct cross_truth {
    size_t line_count, interval_count;
    cross_line *line; /* [line_count] sorted by f0, f1, a */
    oracle_interval *interval;
    uint32_t *same;  /* [face_count of the mesh] the first face with the same corners; ROBERTS_NONE: not a face */
    char error[160]; /* empty: no error */
} cross_truth;

/* Finds all lines. The viewer is at infinity, or an eye with the whole scene in front of it. False: *truth contains
 * only an error. Release with cross_truth_free(). */
bool cross_truth_find(const roberts_mesh *mesh, const oracle_view *view, bool even_odd, cross_truth *truth);
void cross_truth_free(cross_truth *truth);

/* How clear it is, in doubles, whether two faces cross at X: ORACLE_YES where they do and would do so if everything
 * moved by `slack` (model units), ORACLE_NO where they would not; else ORACLE_UNSURE. */
oracle_answer cross_truth_at(const roberts_mesh *mesh, bool even_odd, uint32_t f0, uint32_t f1, roberts_vec3 X,
                             double slack);

#ifdef __cplusplus
}
#endif

#endif
