/* tests_wide.h - tests 2 to 4 against a polygon of very many corners. They find what tests.c finds, without asking
 * all sides.
 *
 * The sides are taken in runs, and runs of runs (list_tree.h). A run is described in a frame of its own: the origin
 * is its first corner, x goes along its chord, y to the left, which is inward. Every side of a run must advance along
 * the chord by more than it rises. Then each side is the graph of a line. Over the run the greatest of these lines is
 * at most `over`; left and right of the run they fall no faster than the least and the greatest slope say. So what
 * lies above three lines,
 *
 *     y >= over,    y >= over + low (x - x0),    y >= over + high (x - x1),
 *
 * is inside of all sides of the run. This assumes nothing of the polygon. Where it is dented, or its corners are
 * uncertain, `over` and the slopes say so. A run that turns too much, or has too short a side, holds nothing; then
 * its parts are asked.
 *
 * A run that is straight, but for a small part of epsilon, counts as one side, its chord. Otherwise every piece of a
 * finely divided straight border would have to be tested.
 *
 * Test 2 passes over runs whose box lies plainly on one side of the sight plane. Tests 3 and 4 need the sides that
 * cut something off. The part s0 .. s1 of the edge inside the polygon is guessed first: the corners change from one
 * side of the sight plane to the other at two places, which halving finds. A run that holds the edge's points at s0
 * and s1, well inside, has no side that A and B are both outside of or on. Where A is outside of one of its sides,
 * the edge comes in across it before s0; where B is, the edge goes out across it after s1. So if the sides of all
 * other runs leave no more than s0 .. s1, the sides of that run change nothing. If they leave more, the guess was
 * wrong, and what they leave is the next guess. */
#ifndef ROBERTS_HIDE_TESTS_WIDE_H
#define ROBERTS_HIDE_TESTS_WIDE_H

#include "hide/list_tree.h"
#include "hide/tests.h"

typedef struct runs_node {
    double x, y;           /* first corner, in the picture */
    double ux, uy;         /* along the chord, 1 long */
    double x0, x1, y0, y1; /* box of the corners, in the run's frame */
    double over;           /* with what touches the sides, and rounding, added; INFINITY: the run holds nothing */
    double low, high;      /* <= 0, >= 0 */
    bool straight;
} runs_node;

typedef struct runs {
    list_tree tree; /* the items are sides */
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

/* Enters a polygon of the table's corners, if it has more than RUNS_CORNERS. Threads may enter different ones at the
 * same time. False: no memory. */
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

/* The first run from *side on that does not hold both points, a straight one or one of the shortest; it becomes *side
 * .. *end - 1. False: all do. */
bool runs_next(const runs *r, roberts_vec3 A, roberts_vec3 B, uint32_t *side, uint32_t *end, bool *straight);

/* Is (x, y) inside the polygon of these corners, whose runs these are, or no farther outside than `slack`? */
bool runs_hold_point(const hide_space *space, const runs *r, const uint32_t *corner, double x, double y, double slack);

/* What hide_test2() and hide_by_sides() say of F, whose runs these are, counted: the part of e inside all sides; false
 * where there is none. To the last bit, unless a run of several sides is straight. */
bool hide_by_runs(const hide_space *space, const runs *r, const hide_face *F, const hide_edge *e, hide_sides *sides,
                  hide_interval *part);

#endif
