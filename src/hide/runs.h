/* runs.h - a polygon of very many corners, its sides in runs, and runs of runs: what lies well inside all sides of a run is
 * not asked about each of them.
 *
 * A run of sides is described in a frame of its own: from its first corner, x along its chord, y to the left, that is
 * inward. Let every side of it advance along the chord by more than it rises. Then each is the graph of a line, and over
 * the run the greatest of these lines is at most `over`; left and right of it they leave that no faster than the least and
 * the greatest slope. So what lies above three lines,
 *
 *     y >= over,    y >= over + low (x - x0),    y >= over + high (x - x1),
 *
 * is inside of all sides. This asks nothing of the polygon: where it is dented, or its corners are uncertain, `over` and the
 * slopes say so; a run that turns too much, or has too short a side, holds nothing, and its parts are asked.
 *
 * A run that is straight, but for a small part of epsilon, is one side: its chord. Else of a straight border in very many parts
 * each would have a say at every point of it. */
#ifndef ROBERTS_HIDE_RUNS_H
#define ROBERTS_HIDE_RUNS_H

#include "hide/ranks.h"
#include "hide/space.h"

/* Polygons of more corners are taken in runs. Below, that gains nothing. */
#define RUNS_CORNERS 64

typedef struct runs_node {
    double x, y;           /* first corner, in the picture */
    double ux, uy;         /* along the chord, 1 long */
    double x0, x1, y0, y1; /* box of the corners, in the run's frame */
    double over;           /* with what touches the sides, and rounding, added; INFINITY: the run holds nothing */
    double low, high;      /* <= 0, >= 0 */
    bool straight;
} runs_node;

typedef struct runs {
    ranks ranks; /* the items are sides */
    runs_node node[];
} runs;

/* The runs of those polygons that are part of one array of corners. */
typedef struct runs_table {
    const uint32_t *corner;
    runs **at; /* by the polygon's place / RUNS_CORNERS, or NULL; NULL: of no polygon */
    size_t count;
} runs_table;

/* For so many corners. False: no memory; runs_table_free() takes a zeroed table. */
bool runs_table_init(runs_table *table, const uint32_t *corner, size_t count);
void runs_table_free(runs_table *table);

/* Enters a polygon of the table's corners, if it has more than RUNS_CORNERS. Threads may enter different ones at the same
 * time. False: no memory. */
bool runs_enter(runs_table *table, const hide_space *space, const uint32_t *corner, uint32_t count);

/* A polygon's runs by themselves; release with free(). NULL: no memory. */
runs *runs_make(const hide_space *space, const uint32_t *corner, uint32_t count);

/* The runs of a polygon, NULL where it has none. */
static inline const runs *runs_of(const runs_table *table, const uint32_t *corner, uint32_t count)
{
    return count > RUNS_CORNERS && table->at ? table->at[(size_t)(corner - table->corner) / RUNS_CORNERS] : NULL;
}

/* Is a point inside of all sides of the run, farther than what touches them? */
static inline bool runs_hold(const runs_node *n, double px, double py)
{
    double dx = px - n->x, dy = py - n->y, x = n->ux * dx + n->uy * dy, y = n->ux * dy - n->uy * dx;
    return y >= n->over && y >= n->over + n->low * (x - n->x0) && y >= n->over + n->high * (x - n->x1);
}

/* The first run from *side on that does not hold both points, a straight one or one of the shortest; it becomes *side .. *end
 * - 1. False: all do. */
bool runs_next(const runs *r, roberts_vec3 A, roberts_vec3 B, uint32_t *side, uint32_t *end, bool *straight);

/* Is (x, y) inside the polygon of these corners, whose runs these are, or no farther outside than `slack`? */
bool runs_hold_point(const hide_space *space, const runs *r, const uint32_t *corner, double x, double y, double slack);

#endif
