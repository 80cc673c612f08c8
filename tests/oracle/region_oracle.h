/* region_oracle.h - what is seen of each face of any mesh, decided with exact numbers. It applies the definition
 * directly:
 *
 *   A point of the picture belongs to the face that is nearest to the viewer there; of several that touch there, to the
 *   first one. Faces are those of mesh_oracle.h, without those that are edge-on.
 *
 * What is seen changes only at sides of faces and where faces cross. All of these lines are cut where they meet in the
 * picture. On each piece, the faces seen immediately to its left and to its right are determined. Pieces with the same
 * face on both sides bound nothing; the others are the borders of the visible regions. */
#ifndef ROBERTS_TESTS_REGION_ORACLE_H
#define ROBERTS_TESTS_REGION_ORACLE_H

#include "oracle.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A piece of a border, from p to q, in the oracle's own picture: see below. */
typedef struct region_piece {
    roberts_vec2 p, q;
    uint32_t left, right; /* faces of the mesh; ROBERTS_NONE: nothing is seen */
} region_piece;

typedef struct region_truth {
    size_t piece_count;
    region_piece *piece;
    /* A point X is at (X u, X w); from an eye E, at ((X - E) u, (X - E) w) / (X - E) d. The axes u and w are at right
     * angles to the direction of view, but otherwise of any length and direction. */
    roberts_vec3 u, w, d;
    size_t lines, questions, exact; /* which face is seen beside a piece; those that needed rational numbers */
    char error[160];                /* empty: no error */
} region_truth;

/* Finds all borders. The viewer is at infinity, or an eye with the whole scene in front of it. rank: [face_count of the
 * mesh] of faces that touch, the one of the smallest rank is seen. False: *truth contains only an error. Release with
 * region_truth_free(). */
bool region_truth_find(const roberts_mesh *mesh, const oracle_view *view, bool even_odd, const uint32_t *rank,
                       region_truth *truth);
void region_truth_free(region_truth *truth);

#ifdef __cplusplus
}
#endif

#endif
