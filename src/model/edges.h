/* edges.h - the edges of one solid and the two faces of each. */
#ifndef ROBERTS_MODEL_EDGES_H
#define ROBERTS_MODEL_EDGES_H

#include "model/scene.h"

/* Scratch memory that serves solid after solid; zeroed = empty. */
typedef struct edge_scratch {
    uint32_t *first; /* where each vertex's half-edges start */
    uint64_t *half;  /* half-edges by smaller end */
    size_t first_room, half_room;
} edge_scratch;

typedef enum edge_pairing {
    EDGES_PAIRED, /* each edge has two faces, which pass it in opposite directions */
    EDGES_MIXED,  /* each edge has two faces, but some pairs pass it in the same direction */
    EDGES_OPEN,   /* some edge has another number of faces */
    EDGES_NO_MEMORY,
} edge_pairing;

/* Faces face_first .. face_first + face_count - 1 of the scene, over the vertices vertex_first .. vertex_first +
 * vertex_count - 1, have their edges written to scene->edge from edge_first on: half as many as the faces have
 * corners. Where the faces are not closed, these edges are left undefined. */
edge_pairing edges_pair(roberts_scene *scene, const scene_solid *first, const scene_solid *end, edge_scratch *scratch);

void edge_scratch_free(edge_scratch *scratch);

#endif
