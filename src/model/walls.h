/* walls.h - solids that touch, told apart by the angles between their faces: the second of the ways of split.c. */
#ifndef ROBERTS_MODEL_WALLS_H
#define ROBERTS_MODEL_WALLS_H

#include "model/solid_frame.h"
#include "model/split.h"

/* What both ways work on. */
typedef struct splitter {
    const roberts_scene *loose;
    const edge_scratch *edges;
    split_groups *groups;
    uint32_t face_count, corner_count, edge_count;
    uint32_t *edge_of;    /* [corner_count] edge that starts at the corner */
    uint32_t *edge_start; /* [edge_count + 1] into edges->half */
    uint32_t *parent;     /* [face_count] union-find over edges */
    uint32_t *order;      /* [face_count] faces by piece */
    uint32_t *count;      /* [edge_count] faces taken, 0 between uses */
    uint32_t *last;       /* [edge_count] a face taken */
} splitter;

/* The face of half-edge i. */
static inline uint32_t splitter_face(const splitter *s, uint32_t i)
{
    return s->edges->face_of[(uint32_t)s->edges->half[i]];
}

/* The number of a new group. */
static inline uint32_t splitter_group(splitter *s, bool closed)
{
    s->groups->closed[s->groups->count] = closed;
    return s->groups->count++;
}

/* Splits the piece order[from] .. order[to - 1], in the frame of all points; what does not close stays without a
 * group. False: no memory. */
bool walls_split(splitter *s, const solid_frame *frame, uint32_t from, uint32_t to);

#endif
