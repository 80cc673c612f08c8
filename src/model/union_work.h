/* union_work.h - shared by union.c and union_angles.c: a line and the bodies that it meets. See union.h. */
#ifndef ROBERTS_MODEL_UNION_WORK_H
#define ROBERTS_MODEL_UNION_WORK_H

#include "model/union.h"

/* The part of a line that something concerns, as parameters. */
typedef struct union_span {
    double t0, t1;
    size_t order; /* in which it was found */
} union_span;

/* A line lies in a face. */
struct union_contact {
    union_span span;
    uint32_t body, face, plane;
    bool own;           /* the line is one of the face's own */
    roberts_vec3 n, w;  /* unit vectors: the plane's normal; the direction in the plane across the line */
    double plus, minus; /* how far the face extends from the line toward w and -w; 0: not at all */
};

/* A face leaves the line in one direction. */
struct union_ray {
    union_side side;
    double angle;
    uint32_t plane, cluster;
    bool own;
    bool cut; /* not of a face: in the near plane, opposite to a face of the line's own */
};

/* A body near the line. */
struct union_fill {
    union_span span;
    uint32_t body;
    double touch;
    bool convex;
    bool active;   /* it touches the line at the current piece */
    bool wound;    /* winding numbers decide, not parity: see union_bodies */
    bool broken;   /* not convex: the region it fills there is undefined */
    int32_t first; /* not convex: the winding number in the first sector, or the parity */
};

/* Things along a line, each of which begins with its union_span. */
typedef struct span_list {
    char *all;   /* [count] sorted by by_start() */
    char *near;  /* [near_count] those at the current piece, in the order in which they were found */
    size_t size; /* of one */
    size_t count, near_count, next;
} span_list;

typedef struct union_cutter {
    const union_bodies *all;
    const union_line *line;
    union_work *work;
    roberts_vec3 A, U, u, e1, e2; /* A + t U: the line; u: unit vector of U; e1, e2: a frame across the line */
    double length, departure, touch;
    uint32_t in_near; /* one of the line's own faces that lies in the near plane; ROBERTS_NONE: there is none */
    bool on_near;     /* the line lies in the near plane */
    span_list contacts, fills; /* of `work` */
} union_cutter;

/* The point of a piece at which it is judged. */
static inline double union_middle(const union_piece *piece)
{
    return 0.5 * (piece->t0 + piece->t1);
}

/* Is this the line's body, or one of the two whose faces cross in it? */
static inline bool union_is_own(const union_cutter *c, uint32_t body)
{
    const union_line *line = c->line;
    return line->body == body || (line->body == ROBERTS_NONE && (line->crossed[0] == body || line->crossed[1] == body));
}

static inline roberts_vec3 union_place(const roberts_scene *scene, roberts_vec3 P)
{
    return vec3_scale(1.0 / scene->unit, vec3_sub(P, scene->centre));
}

static inline plane union_plane(const roberts_scene *scene, uint32_t face)
{
    plane F = scene_plane(scene, face);
    F.d /= scene->unit;
    return F;
}

static inline uint32_t union_plane_number(const roberts_scene *scene, uint32_t face)
{
    return scene->surface ? scene_plane_number(scene, face) : face;
}

/* Do two rays leave the line in the same direction (way 1) or in opposite ones (way -1)? Each face may be off by the
 * touching distance at the line and at its far end. */
bool union_agree(const union_cutter *c, const union_side *a, const union_side *b, double way);

/* Decides what becomes of the piece from piece->t0 to piece->t1. False: no memory. */
bool union_judge(union_cutter *c, union_piece *piece);

#endif
