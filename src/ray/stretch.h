/* stretch.h - one visible or hidden stretch of an edge, checked by rays. */
#ifndef ROBERTS_RAY_STRETCH_H
#define ROBERTS_RAY_STRETCH_H

#include "ray/occluders.h"

/* Facing of an edge's faces. */
typedef enum stretch_edge {
    STRETCH_FRONT,  /* at least one face is front */
    STRETCH_BACK,   /* no face is front: its own solid hides it */
    STRETCH_UNSURE, /* a face is front or edge-on, and none is certainly front */
    STRETCH_BETWEEN /* of a body that is not convex: all its faces may hide the edge, except those in which it lies */
} stretch_edge;

/* A stretch of an edge that the drawing shows in one state. */
typedef struct stretch {
    roberts_vec3 A, B; /* ends of the whole edge; t runs from A to B */
    uint32_t solid, edge;
    seen_own own; /* faces that do not hide it */
    stretch_edge faces;
    double t0, t1;
    roberts_state drawn;
    bool named;        /* the drawing names the solid that hides it */
    uint32_t drawn_by; /* that solid, if `named` */
} stretch;

typedef struct stretch_finding {
    roberts_contradiction what; /* without v0, v1 */
    uint32_t edge;
} stretch_finding;

/* The findings of many stretches. Zeroed: nothing yet. */
typedef struct stretch_result {
    size_t segments, points, undecided;
    stretch_finding *found; /* [count] in arbitrary order */
    size_t count, room;
    bool lost; /* no memory */
} stretch_result;

/* A checker casts the rays of many stretches together. */
typedef struct stretch_checker stretch_checker;

/* Makes a checker that casts rays against `o`, `rays` of them evenly spaced on each stretch. NULL: no memory. */
stretch_checker *stretch_checker_new(const occluders *o, uint32_t rays, stretch_result *result);

/* Queues the points of a stretch, and casts their rays when the queue is full. */
void stretch_check(stretch_checker *c, const stretch *s);

/* Records a contradiction at t: the near plane removes the edge there. */
void stretch_is_clipped(stretch_checker *c, const stretch *s, double t);

/* Casts all waiting rays, and frees the checker. */
void stretch_checker_finish(stretch_checker *c);

#endif
