/* edge.h - lines through the grid: what hides them. */
#ifndef ROBERTS_HIDE_EDGE_H
#define ROBERTS_HIDE_EDGE_H

#include "base/threads.h"
#include "hide/front_test.h"
#include "hide/intervals.h"
#include "hide/objet.h"
#include "hide/point.h"

/* The largest group of lines that goes through the cells together. */
#define HIDE_GROUP 64
_Static_assert(HIDE_GROUP % 4 == 0 && HIDE_GROUP <= 64, "four lines are compared at a time, and each has a bit");

/* A line, and what is known to hide it. */
typedef struct hide_line {
    hide_edge e;
    hide_intervals intervals; /* the hidden parts so far */
    hide_intervals hulls;     /* the parts hidden by solids entered face by face: one interval for each solid */
    bool hidden;              /* completely: no more tests are needed */
    seen_line is;
} hide_line;

/* Boxes of a group's lines in SIMD layout, rounded outward. A line that is completely hidden begins at infinity, and so
 * do the unused ones of the last four lanes. */
typedef struct hide_lanes {
    float x0[HIDE_GROUP], x1[HIDE_GROUP], y0[HIDE_GROUP], y1[HIDE_GROUP], z0[HIDE_GROUP], z1[HIDE_GROUP];
} hide_lanes;

/* Scratch memory of one thread, reused for solid after solid. */
typedef struct hide_worker {
    const hide_fronts *fronts;
    const objet *grid;
    hide_sides sides;
    objet_walk walk;
    double margin;   /* hide_margin() */
    hide_line *line; /* [line_count] the current lines; lines beyond keep their memory */
    size_t line_count, line_room;
    hide_box box;            /* of all lines, if they fit into one group */
    hide_lanes lanes;        /* boxes of the lines; they shrink as lines are hidden */
    hide_lanes whole;        /* the same before shrinking, needed if some solids are entered face by face */
    float least[4], most[4]; /* limits on x0, x1, y0, y1 of a front that meets the box of the current lines */
    float place[4];          /* objet_place() of the box */
    bool all;                /* hidden parts are wanted too: some lines may be hidden by their own body */
    bool named;              /* also find which solid hides each part */
    bool shrinks;            /* the boxes of the current lines shrink as lines are hidden */
    uint32_t met;            /* fronts met by the current group, if boxes shrink */
    size_t live;             /* lines of the current group that are not completely hidden */
    uint32_t own; /* the lines' common key of own faces, if they belong to a convex body; ROBERTS_NONE: each line has
                     its own keys */
    /* [front_count] Stamp of the last group of edges that met the front. It is short so that more stamps fit into the
     * cache. */
    uint16_t *stamped;
    hide_single *single; /* [single_mask + 1] faces of fronts, each at its number & single_mask */
    uint32_t single_mask;
    uint16_t stamp;          /* of the current group */
    size_t surviving, drawn; /* edges, as counted in a roberts_drawing */
    level_hits level;        /* scratch memory of point_level() */
    char apart[THREADS_APART];
} hide_worker;

/* Prepares a worker. Call hide_worker_free() in any case. all: hidden parts are wanted too; named: also which solid
 * hides each. False: no memory. */
bool hide_worker_init(hide_worker *w, const hide_fronts *fronts, const objet *grid, bool all, bool named);
void hide_worker_free(hide_worker *w);

/* Makes room for this many lines. False: no memory. */
bool hide_worker_reserve(hide_worker *w, size_t lines);

/* Starts a new set of lines. own: see hide_worker. */
static inline void hide_worker_begin(hide_worker *w, uint32_t own)
{
    w->line_count = 0;
    w->own = own;
}

/* Returns the edge's box, rounded outward. */
BITS_INLINE hide_box hide_edge_box(const hide_edge *e, double margin)
{
    two a = two_of(e->A.x, e->A.y), b = two_of(e->B.x, e->B.y), m = two_all(margin), ulp = two_all(0x1p-23);
    two from = two_sub(two_lesser(a, b), m), to = two_add(two_greater(a, b), m);
    hide_box box = {.z0 = hide_float_below(lesser(e->A.z, e->B.z) - margin),
                    .z1 = hide_float_above(greater(e->A.z, e->B.z) + margin)};
    /* rounds as hide_float_below() and hide_float_above() do */
    two_part_floats(&box.x0, &box.y0, two_sub(from, two_mul(two_abs(from), ulp)));
    two_part_floats(&box.x1, &box.y1, two_add(to, two_mul(two_abs(to), ulp)));
    return box;
}

/* Sets the view points of a line that has a computed end. */
void hide_set_ends(const hide_fronts *fronts, const seen_line *line, hide_edge *e);

/* Adds a line: w->line + w->line_count, with its `is` set. */
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

/* Adds a line that the near plane has removed. It has no ends and is not tested. */
void hide_worker_add_taken(hide_worker *w, hide_line *line);

/* Finds what hides the added lines: all fronts except those of their own faces. The hidden parts ascend and are
 * disjoint. False: no memory. */
bool hide_worker_run(hide_worker *w);

#endif
