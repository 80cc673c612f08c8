/* body_edges.h - the edges of bodies that are not convex: from the surface to the scene, body by body. */
#ifndef ROBERTS_MODEL_BODY_EDGES_H
#define ROBERTS_MODEL_BODY_EDGES_H

#include "model/surface.h"

/* The edges of a surface, body by body, sorted by their names in the file. Zeroed = empty. */
typedef struct body_edges {
    const surface *surface;
    uint32_t *order;  /* [surface.edge_count] */
    uint32_t *first;  /* [bodies + 1] into order */
    uint32_t *face;   /* [pieces] the scene's number of each; the caller fills it in before edges are stored */
    uint32_t *vertex; /* [vertices of the surface] numbers in the body at hand */
    size_t many_room, many_face_room, many_faces, part_room; /* of the scene's arrays */
} body_edges;

/* Lists the edges. of[p]: the body of piece p; from of[pieces] on, those of the odd edges in their order. False: no
 * memory; body_edges_free() is still needed. */
bool body_edges_list(body_edges *list, const surface *s, const uint32_t *of, uint32_t bodies);

/* How many edges body b has. */
static inline uint32_t body_edges_count(const body_edges *list, uint32_t b)
{
    return list->first[b + 1] - list->first[b];
}

/* Stores the edges of body b, and whether it is closed. The scene is laid out; `number` of its vertices is that of the
 * surface. False: no memory. */
bool body_edges_store(body_edges *list, roberts_scene *scene, uint32_t b);

void body_edges_free(body_edges *list);

/* Is body b, which has its planes and edges, a curved surface? It has more than 500 faces then, and at least half of
 * its bent edges are bent little. */
bool body_smooth(const roberts_scene *scene, uint32_t b);

/* Has the mesh wires: elements of two corners that are not edges of the scene? `scene` holds the convex solids of the
 * mesh, and only elements of one and two corners are left. False: no memory. */
bool body_edges_wires(const roberts_scene *scene, const roberts_mesh *mesh, bool *found);

#endif
