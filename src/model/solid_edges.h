/* solid_edges.h - the edges of one solid and the two faces of each. */
#ifndef ROBERTS_MODEL_SOLID_EDGES_H
#define ROBERTS_MODEL_SOLID_EDGES_H

#include "model/scene.h"

enum { EDGES_SMALL = 32 }; /* vertices; up to this many, a solid's half-edges are looked up in a table */

/* Scratch memory, reused for solid after solid; zeroed = empty. */
typedef struct edge_scratch {
    scene_edge *edge;  /* [corners / 2] the result of edges_pair() */
    uint32_t *end;     /* [vertices] where the half-edges of each smaller vertex end in `half` */
    uint64_t *half;    /* [corners] sorted half-edges: larger vertex << 32 | corner where it starts */
    uint32_t *face_of; /* [corners] */
    uint8_t *alike;    /* [corners / 2] whether the two faces of each edge pass it in the same direction */
    size_t edge_room, end_room, half_room, face_of_room, alike_room;
    uint32_t passing[EDGES_SMALL][EDGES_SMALL]; /* the face that passes from the first vertex to the second */
} edge_scratch;

typedef enum edge_pairing {
    EDGES_PAIRED, /* each edge has two faces, which pass it in opposite directions */
    EDGES_MIXED,  /* each edge has two faces, but some pairs pass it in the same direction: see scratch->alike */
    EDGES_EVEN,   /* each edge has an even number of faces, and some have more than two */
    EDGES_OPEN,   /* some edge has an odd number of faces */
    EDGES_NO_MEMORY,
} edge_pairing;

/* Euler's V - E + F, if each edge of solid s has two faces. It is 2 for a closed surface like a sphere, less if the
 * surface has holes, and more if parts share vertices. */
static inline int64_t edges_euler(const roberts_scene *scene, uint32_t s)
{
    const scene_solid *first = scene->solid + s;
    int64_t vertices = first[1].vertex - first->vertex, faces = first[1].face - first->face;
    return vertices - (int64_t)(scene_corners(scene, s) / 2) + faces;
}

/* Writes the edges of solid s to scratch->edge, sorted, in the form that a scene stores. Their number is half the
 * number of corners. If some edge does not have two faces, scratch->edge is undefined. */
edge_pairing edges_pair(const roberts_scene *scene, uint32_t s, edge_scratch *scratch);

/* Sorts the half-edges of solid s into scratch->half by (smaller vertex, larger vertex, corner). Vertices and corners
 * count from the solid's first. Also fills scratch->end and ->face_of. False: no memory. */
bool edges_sort(const roberts_scene *scene, uint32_t s, edge_scratch *scratch);

void edge_scratch_free(edge_scratch *scratch);

#endif
