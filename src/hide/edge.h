/* edge.h - lines through the grid: what hides them, and whom the viewer sees there instead. */
#ifndef ROBERTS_HIDE_EDGE_H
#define ROBERTS_HIDE_EDGE_H

#include "base/threads.h"
#include "hide/objet.h"
#include "hide/front_test.h"
#include "hide/intervals.h"

/* Of more lines than this each is taken alone. A multiple of 4. */
#define HIDE_GROUP 64

/* A line at work. */
typedef struct hide_line {
    hide_edge e;
    hide_intervals intervals; /* hidden so far */
    hide_intervals hulls;     /* ... by solids entered face by face: one interval for each of them */
    bool hidden;              /* wholly: nothing more need be asked */
    seen_line is;
} hide_line;

/* Boxes of a group's lines, rounded outward, side by side; one that is wholly hidden begins at infinity, and so do
 * those that fill up the last four. */
typedef struct hide_lanes {
    float x0[HIDE_GROUP], x1[HIDE_GROUP], y0[HIDE_GROUP], y1[HIDE_GROUP], z0[HIDE_GROUP], z1[HIDE_GROUP];
} hide_lanes;

/* A face before a point: see level.c. */
typedef struct level_hit {
    uint32_t body;
    unsigned ways; /* in which the point can be moved into the face */
} level_hit;

typedef struct level_hits {
    level_hit *item;
    size_t count, room;
} level_hits;

/* Scratch memory of one thread, serving solid after solid. */
typedef struct hide_worker {
    const hide_fronts *fronts;
    const objet *grid;
    hide_sides sides;
    objet_walk walk;
    double margin;   /* hide_margin() */
    hide_line *line; /* [line_count] the lines at work; those beyond keep their memory */
    size_t line_count, line_room;
    hide_box box;            /* of all of them, if they are no more than a group */
    hide_lanes lanes;        /* of the first of them; they shrink with what is hidden of a line */
    hide_lanes whole;        /* ... and as they were, where some solids are entered face by face */
    float least[4], most[4]; /* of x0, x1, y0, y1 of a front that meets the box of the edges at work */
    float place[4];          /* objet_place() of it */
    bool all;                /* who hides a part is asked too */
    bool shrinks;            /* the boxes of the lines at work shrink with what is hidden of them */
    uint32_t met;            /* fronts that met the group at work, where lines shrink */
    size_t live;             /* lines of the group at work that are not wholly hidden */
    uint32_t own;            /* the one key of own faces of all lines, where it is that of a convex body; ROBERTS_NONE:
                                each line is asked for its own */
    /* [front_count] the last group of edges that met the front, by its stamp. Short, so that more of it stays in the
     * cache. */
    uint16_t *seen;
    uint16_t stamp;          /* of the group at work */
    size_t surviving, drawn; /* edges, as counted in a roberts_drawing */
    level_hits level;        /* scratch memory of hide_level_at() */
    char apart[THREADS_APART];
} hide_worker;

/* False: no memory; hide_worker_free() is due in any case. */
bool hide_worker_init(hide_worker *w, const hide_fronts *fronts, const objet *grid, bool all);
void hide_worker_free(hide_worker *w);

/* Room for so many lines. False: no memory. */
bool hide_worker_reserve(hide_worker *w, size_t lines);

/* Begins with no lines. own: see hide_worker. */
static inline void hide_worker_begin(hide_worker *w, uint32_t own)
{
    w->line_count = 0;
    w->own = own;
}

/* The edge's box, rounded outward. */
BITS_INLINE hide_box hide_edge_box(const hide_edge *e, double margin)
{
    two a = two_of(e->A.x, e->A.y), b = two_of(e->B.x, e->B.y), m = two_all(margin), ulp = two_all(0x1p-23);
    two from = two_sub(two_lesser(a, b), m), to = two_add(two_greater(a, b), m);
    hide_box box = {.z0 = hide_float_below(lesser(e->A.z, e->B.z) - margin),
                    .z1 = hide_float_above(greater(e->A.z, e->B.z) + margin)};
    /* as hide_float_below(), hide_float_above() */
    two_part_floats(&box.x0, &box.y0, two_sub(from, two_mul(two_abs(from), ulp)));
    two_part_floats(&box.x1, &box.y1, two_add(to, two_mul(two_abs(to), ulp)));
    return box;
}

/* Sets the view points of a line with a computed end. */
void hide_set_ends(const hide_fronts *fronts, const seen_line *line, hide_edge *e);

/* Takes up a line, which is w->line + w->line_count and has its `is`. */
BITS_INLINE void hide_worker_add(hide_worker *w, hide_line *line)
{
    size_t n = w->line_count++;
    const seen_line *is = &line->is;
    hide_edge *e = &line->e;
    e->a = is->v[0];
    e->b = is->v[1];
    e->end = is->end;
    if (is->end) {
        hide_set_ends(w->fronts, is, e);
    } else {
        e->A = w->fronts->P[e->a];
        e->B = w->fronts->P[e->b];
    }
    roberts_vec3 AB = vec3_sub(e->B, e->A);
    e->length = sqrt(AB.x * AB.x + AB.y * AB.y);
    e->length3 = vec3_length(AB);
    if (n < HIDE_GROUP) {
        hide_box box = hide_edge_box(e, w->margin);
        w->lanes.x0[n] = box.x0;
        w->lanes.x1[n] = box.x1;
        w->lanes.y0[n] = box.y0;
        w->lanes.y1[n] = box.y1;
        w->lanes.z0[n] = box.z0;
        w->lanes.z1[n] = box.z1;
    }
    line->intervals.count = line->hulls.count = 0;
    line->hidden = false;
}

/* The same of a line that the near plane has taken: it has no ends, and nothing is asked of it. */
void hide_worker_add_taken(hide_worker *w, hide_line *line);

/* Finds what hides the lines taken up: all fronts but those of their own faces. Hidden parts ascend and are disjoint.
 * False: no memory. */
bool hide_worker_run(hide_worker *w);

/* The solid seen at picture point (x, y), the one of smallest number where several touch there; ROBERTS_NONE where no
 * front face is. */
uint32_t hide_seen_at(const hide_worker *w, double x, double y);

/* The face seen there, as numbered in the scene: of the solid of smallest number that touches there, the smallest one;
 * *F: its plane. ROBERTS_NONE: there is none. */
uint32_t hide_face_seen_at(const hide_fronts *fronts, const objet *grid, double x, double y, plane *F);

#endif
