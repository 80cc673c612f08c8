/* mesh_oracle.h - which parts of the edges of any mesh are hidden, decided with exact numbers: faces of any shape,
 * bodies of any kind. It is the definition itself, as plainly as possible, and knows no bodies:
 *
 *   A point X of an edge is hidden where some face that is not edge-on holds a point strictly nearer to the viewer
 *   on X's sight line. A face is closed in projection: it has its border, and what the border winds round (a winding
 *   number other than 0, or an odd one). A side, or a part of one, that its face's border runs along as often one
 *   way as the other (with the odd rule: an even number of times) bounds nothing: it is no edge. All sides of a face
 *   whose corners are in a line are edges.
 *
 * The doubles of the mesh are taken as the rational numbers that they are. Positions that are exactly equal are one
 * vertex. A face has the plane through the mean of its corners with Newell's normal; its own edges, and its own
 * corners, lie on it exactly. A mesh with a face that is not planar, by more than 1e-5 of its size, is refused: the
 * library cuts such faces into triangles. Of the library only the mesh is used, as plain data. */
#ifndef ROBERTS_TESTS_MESH_ORACLE_H
#define ROBERTS_TESTS_MESH_ORACLE_H

#include "oracle.h"

#ifdef __cplusplus
extern "C" {
#endif

/* An edge: a side of one face or several; its vertices are the smallest numbers of their positions. */
typedef struct mesh_edge {
    uint32_t v0, v1;     /* v0 < v1 */
    uint32_t faces;      /* how many distinct faces have it */
    size_t first, count; /* hidden intervals, into mesh_truth.interval; they ascend and do not touch */
    size_t part, parts;  /* where it bounds something, into mesh_truth.part, likewise; at least one */
} mesh_edge;

typedef struct mesh_truth {
    size_t edge_count, interval_count, part_count;
    mesh_edge *edge; /* [edge_count] by v0, v1 */
    oracle_interval *interval, *part;
    uint32_t *position;  /* [vertex_count of the mesh] the smallest vertex at the same place */
    size_t pairs, exact; /* pairs of edge and face; those that took rational numbers */
    char error[160];     /* empty if nothing went wrong */
} mesh_truth;

/* Finds the hidden intervals of all edges. The viewer is at infinity or an eye that has the scene wholly in front of
 * it; there is no near plane. even_odd: the fill rule. False: *truth holds an error alone. Release with
 * mesh_truth_free(). */
bool mesh_truth_find(const roberts_mesh *mesh, const oracle_view *view, bool even_odd, mesh_truth *truth);
void mesh_truth_free(mesh_truth *truth);

/* A point of an edge or of an intersection line; what there is none of is ROBERTS_NONE. */
typedef struct mesh_point {
    roberts_vec3 at;
    uint32_t v0, v1; /* faces that have both do not hide it */
    uint32_t f0, f1; /* nor do these */
} mesh_point;

/* How clear the answer is at a point, in doubles: ORACLE_YES where some face hides it and would do so if everything
 * moved by `slack` (model units), ORACLE_NO where none would; else ORACLE_UNSURE. */
oracle_answer mesh_truth_at(const roberts_mesh *mesh, const oracle_view *view, bool even_odd, const uint32_t *position,
                            const mesh_point *point, double slack);

#ifdef __cplusplus
}
#endif

#endif
