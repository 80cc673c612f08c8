/* mesh_oracle.h - which parts of the edges of any mesh are hidden, decided with exact numbers: faces of any shape,
 * bodies of any kind. It applies the definition directly, and knows no bodies:
 *
 *   A point X of an edge is hidden if some face that is not edge-on contains a point strictly nearer to the viewer on
 *   X's sight line. A face is closed in projection: it contains its border, and the points round which the border winds
 *   (with a winding number other than 0, or an odd one). A side, or a part of one, that its face's border runs along
 *   equally often both ways (with the odd rule: an even number of times) bounds nothing and is not an edge. If all
 *   corners of a face are collinear, all its sides are edges.
 *
 * The doubles of the mesh are taken as exact rational numbers. Positions that are exactly equal are one vertex. A face
 * has the plane through the mean of its corners with Newell's normal; its own edges, and its own corners, lie on it
 * exactly. A mesh with a face that is off its plane by more than 1e-5 of its size is refused, because the library cuts
 * such faces into triangles. Only the library's mesh is used, as plain data. */
#ifndef ROBERTS_TESTS_MESH_ORACLE_H
#define ROBERTS_TESTS_MESH_ORACLE_H

#include "oracle.h"

#ifdef __cplusplus
extern "C" {
#endif

/* An edge: a side of one or several faces. Its vertices are the smallest numbers at their positions. */
typedef struct mesh_edge {
    uint32_t v0, v1;     /* v0 < v1 */
    uint32_t faces;      /* number of distinct faces that have it */
    size_t first, count; /* hidden intervals, in mesh_truth.interval; they ascend and do not touch */
    size_t part, parts;  /* where it bounds a face, in mesh_truth.part, likewise; at least one */
} mesh_edge;

typedef struct mesh_truth {
    size_t edge_count, interval_count, part_count;
    mesh_edge *edge; /* [edge_count] sorted by v0, v1 */
    oracle_interval *interval, *part;
    uint32_t *position;  /* [vertex_count of the mesh] the smallest vertex at the same position */
    size_t pairs, exact; /* pairs of edge and face; those that needed rational numbers */
    char error[160];     /* empty: no error */
} mesh_truth;

/* Finds the hidden intervals of all edges. The viewer is at infinity, or an eye with the whole scene in front of it;
 * there is no near plane. even_odd: the fill rule. False: *truth contains only an error. Release with
 * mesh_truth_free(). */
bool mesh_truth_find(const roberts_mesh *mesh, const oracle_view *view, bool even_odd, mesh_truth *truth);
void mesh_truth_free(mesh_truth *truth);

/* A point of an edge or of an intersection line; members that do not apply are ROBERTS_NONE. */
typedef struct mesh_point {
    roberts_vec3 at;
    uint32_t v0, v1; /* faces with both vertices do not hide it */
    uint32_t f0, f1; /* these faces do not hide it */
} mesh_point;

/* Returns how certain the answer is at a point, in doubles. ORACLE_YES: some face hides it, even if everything moves by
 * `slack` (model units). ORACLE_NO: none does, even then. Otherwise ORACLE_UNSURE. */
oracle_answer mesh_truth_at(const roberts_mesh *mesh, const oracle_view *view, bool even_odd, const uint32_t *position,
                            const mesh_point *point, double slack);

#ifdef __cplusplus
}
#endif

#endif
