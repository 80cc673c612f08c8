/* plain_edges.h - the edges of a body of whole faces. */
#ifndef ROBERTS_MODEL_PLAIN_EDGES_H
#define ROBERTS_MODEL_PLAIN_EDGES_H

#include "model/scene.h"

typedef enum plain_answer { PLAIN_NO, PLAIN_YES, PLAIN_NO_MEMORY } plain_answer;

/* The edges of some bodies, one after the other, each body's as in the scene; zeroed but for `scene` = empty. */
typedef struct plain_edges {
    const roberts_scene *scene;
    scene_edge *edge; /* [count] of two faces or, f[1] == ROBERTS_NONE, of one */
    uint8_t *is;      /* [count] EDGE_TURNED_..., EDGE_MANY */
    scene_many *many; /* [many_count] edges of more than two faces, by their places here */
    uint32_t *many_face;
    size_t count, many_count, many_faces;
    /* scratch */
    uint32_t *start;    /* [vertices of a body] where the edges of each smaller vertex end */
    uint32_t *parent;   /* [faces of a body] sets of faces connected by edges */
    uint64_t *half;     /* [sides of a body] larger vertex << 32 | face << 1 | turned */
    scene_edge *border; /* [border_count] edges of one face on their right, which is f[1] */
    size_t edge_room, is_room, start_room, parent_room, half_room, border_count, border_room, many_room, many_face_room;
} plain_edges;

/* Appends the edges of solid s. The answer is PLAIN_NO if edges do not connect all faces, if a face may repeat another,
 * or if each edge has an even number of faces and some have more than two: these may be solids that touch. */
plain_answer plain_edges_find(plain_edges *p, uint32_t s);

/* Frees the scratch memory, or everything. */
void plain_edges_free_scratch(plain_edges *p);
void plain_edges_free(plain_edges *p);

#endif
