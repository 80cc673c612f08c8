/* plain_edges.h - the edges of a body of whole faces. */
#ifndef ROBERTS_MODEL_PLAIN_EDGES_H
#define ROBERTS_MODEL_PLAIN_EDGES_H

#include "model/scene.h"

typedef enum plain_answer { PLAIN_NO, PLAIN_YES, PLAIN_NO_MEMORY } plain_answer;

/* The edges of some bodies, body by body, as the scene has them. Zeroed except for `scene`, it is empty. */
typedef struct plain_edges {
    const roberts_scene *scene;
    scene_edge *edge; /* [count] with two faces, or with one and f[1] == ROBERTS_NONE */
    uint8_t *is;      /* [count] EDGE_TURNED_..., EDGE_MANY */
    scene_many *many; /* [many_count] edges with more than two faces, by their places in `edge` */
    uint32_t *many_face;
    size_t count, many_count, many_faces;
    bool paired; /* all edges that were found last have two faces */
    /* scratch */
    uint32_t *start;    /* [vertices of a body] where the edges end of which this is the smaller vertex */
    uint32_t *parent;   /* [faces of a body] sets of faces that edges connect */
    uint64_t *half;     /* [sides of a body] larger vertex << 32 | face << 1 | turned */
    scene_edge *border; /* [border_count] edges with one face, f[1], on their right */
    size_t edge_room, is_room, start_room, parent_room, half_room, border_count, border_room, many_room, many_face_room;
} plain_edges;

/* Adds the edges of solid s. The answer is PLAIN_NO if edges do not connect all faces, or if a face may repeat another.
 * It is also PLAIN_NO if all edges have an even number of faces, and some more than two: these may be several solids
 * that touch. */
plain_answer plain_edges_find(plain_edges *p, uint32_t s);

/* Frees the scratch memory, or everything. */
void plain_edges_free_scratch(plain_edges *p);
void plain_edges_free(plain_edges *p);

#endif
