/* stretch.h - one visible or hidden stretch of an edge, checked by rays. */
#ifndef ROBERTS_RAY_STRETCH_H
#define ROBERTS_RAY_STRETCH_H

#include "ray/occluders.h"

/* Which of an edge's faces are front. */
typedef enum stretch_edge {
    STRETCH_FRONT,  /* one face at least is front */
    STRETCH_BACK,   /* no face is front: its own solid hides it */
    STRETCH_UNSURE, /* a face is front or edge-on, and none is surely front */
    STRETCH_BETWEEN /* of a body that is not convex: all its faces may hide it but those that it lies in */
} stretch_edge;

/* A stretch of an edge that the drawing shows in one state. */
typedef struct stretch {
    roberts_vec3 A, B; /* ends of the whole edge; t runs from A to B */
    uint32_t solid, edge;
    seen_own own; /* faces that do not hide it */
    stretch_edge faces;
    double t0, t1;
    roberts_state drawn;
    bool named;        /* the drawing names a solid that hides it */
    uint32_t drawn_by; /* if named: that solid */
} stretch;

typedef struct stretch_finding {
    roberts_contradiction what; /* without v0, v1 */
    uint32_t edge;
} stretch_finding;

/* What was found in many stretches. Zeroed: nothing yet. */
typedef struct stretch_result {
    size_t segments, points, undecided;
    stretch_finding *found; /* [count] in no order */
    size_t count, room;
    bool lost; /* no memory */
} stretch_result;

/* A checker casts the rays of many stretches together. */
typedef struct stretch_checker stretch_checker;

/* A checker that casts rays against `o`, `rays` of them evenly spaced on each stretch. NULL: no memory. */
stretch_checker *stretch_checker_new(const occluders *o, uint32_t rays, stretch_result *result);

/* Puts the points of a stretch in the queue, and casts their rays when it is full. */
void stretch_check(stretch_checker *c, const stretch *s);

/* Notes a contradiction at t: the near plane cuts off the edge there. */
void stretch_is_clipped(stretch_checker *c, const stretch *s, double t);

/* Casts all rays that wait, and frees the checker. */
void stretch_checker_finish(stretch_checker *c);

#endif
