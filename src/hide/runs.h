/* runs.h - tests 2 to 4 against a polygon of very many corners. They give the results of tests.c, without testing every
 * side.
 *
 * The sides are grouped into runs, and into runs of runs. A run is described in a frame of its own: the origin is its
 * first corner, x goes along its chord, and y to the left, which is inward. Every side of a run must advance along the
 * chord by more than it rises. Then each side is the graph of a line. Over the run, the highest of these lines is at
 * most `over`. Left and right of the run, they fall no faster than the least and the greatest slope allow. So a point
 * above three lines,
 *
 *     y >= over,    y >= over + low (x - x0),    y >= over + high (x - x1),
 *
 * is inside all sides of the run. This assumes nothing about the polygon: dents and uncertain corners only raise `over`
 * and widen the slopes. A run that turns too far, or has too short a side, has an infinite `over` and holds no point.
 * Then its parts are tested.
 *
 * A run that is straight to within a small part of epsilon counts as one side, its chord. Otherwise every piece of a
 * finely divided straight border would have to be tested.
 *
 * Test 2 skips runs whose box lies plainly on one side of the sight plane. Tests 3 and 4 need the sides that cut
 * something off. They first guess the part s0 .. s1 of the edge inside the polygon: the border crosses the sight plane
 * at two places, which bisection finds. If the edge's points at s0 and s1 are well inside a run, no side of that run
 * has A and B both outside or on it. If A is outside one of its sides, the edge enters across that side before s0. If B
 * is, the edge leaves across that side after s1. So if the sides of all other runs leave no more than s0 .. s1, that
 * run changes nothing. If they leave more, the guess was wrong, and what they leave is the next guess. */
#ifndef ROBERTS_HIDE_RUNS_H
#define ROBERTS_HIDE_RUNS_H

#include <stdbool.h>
#include <stdint.h>

#include "base/list_tree.h"
#include "hide/tests.h"
#include "hide/tolerance.h"

typedef struct runs_node {
    double x, y;           /* first corner, in the picture */
    double ux, uy;         /* unit vector along the chord */
    double x0, x1, y0, y1; /* box of the corners, in the run's frame */
    double over;           /* includes the touching distance and rounding; INFINITY: the run holds no point */
    double low, high;      /* slopes of the sides: low <= 0, high >= 0 */
    bool straight;
} runs_node;

typedef struct runs {
    list_tree tree; /* the items are sides */
    runs_node node[];
} runs;

/* The runs of all polygons whose corners are in one array. */
typedef struct runs_table {
    const uint32_t *corner;
    runs **at; /* [count] indexed by the polygon's first corner / RUNS_CORNERS; an entry or `at` itself may be NULL */
    size_t count;
} runs_table;

/* Makes an empty table for `count` corners. False: no memory; runs_table_free() accepts a zeroed table. */
bool runs_table_init(runs_table *table, const uint32_t *corner, size_t count);
void runs_table_free(runs_table *table);

/* Adds a polygon of the table's corners, if it has more than RUNS_CORNERS. Threads may add different polygons at the
 * same time. False: no memory. */
bool runs_enter(runs_table *table, const hide_space *space, const uint32_t *corner, uint32_t count);

/* Makes the runs of one polygon; release them with free(). NULL: no memory. */
runs *runs_make(const hide_space *space, const uint32_t *corner, uint32_t count);

/* Returns the runs of a polygon, or NULL if it has none. */
static inline const runs *runs_of(const runs_table *table, const uint32_t *corner, uint32_t count)
{
    return count > RUNS_CORNERS && table->at ? table->at[(size_t)(corner - table->corner) / RUNS_CORNERS] : NULL;
}

/* Is X inside the polygon of these corners, or no farther outside than `slack`? `r` has the polygon's runs. */
bool runs_hold_point(const hide_space *space, const runs *r, const uint32_t *corner, roberts_vec2 X, double slack);

/* Gives the results of hide_test2() and hide_by_sides() for F, with the same counts: `part` is the part of e inside all
 * sides; false if there is none. `r` has the runs of F. The results agree to the last bit, unless a run of several
 * sides is straight. */
bool hide_by_runs(const hide_space *space, const runs *r, const hide_face *F, const hide_edge *e, hide_sides *sides,
                  hide_interval *part);

#endif
