/* tests_wide.h - what helps to test fronts of very many corners or faces: trees over the sides of a polygon (runs), and
 * over the faces of a solid (bundles). */
#ifndef ROBERTS_HIDE_TESTS_WIDE_H
#define ROBERTS_HIDE_TESTS_WIDE_H

#include <stdbool.h>
#include <stdint.h>

#include "hide/tests.h"
#include "hide/tolerance.h"

/* ---- a tree over a list ------------------------------------------------------------------------------------------ */

/* The shape of a tree over a list. Each node covers eight items; on the next level, each node covers eight of these
 * nodes, until at most eight are left. The levels are called ranks, the lowest first. The caller stores the nodes'
 * contents. */

/* A node has 2^LIST_TREE_BITS items or nodes below it. */
#define LIST_TREE_BITS 3
/* Most ranks: those of a tree over 2^32 items. */
#define LIST_TREE_RANKS 10

typedef struct list_tree {
    uint32_t items, ranks;
    uint32_t start[LIST_TREE_RANKS + 1]; /* first node of each rank; start[ranks] is the number of nodes */
} list_tree;

/* Returns the node of this rank that covers the item. */
static inline uint32_t list_tree_node(const list_tree *t, int rank, uint32_t item)
{
    return t->start[rank] + (item >> (LIST_TREE_BITS * (rank + 1)));
}

/* Returns the end of the items that the node of this rank covers. The node begins at `item`. */
static inline uint32_t list_tree_end(const list_tree *t, int rank, uint32_t item)
{
    uint64_t end = (uint64_t)item + (UINT64_C(1) << (LIST_TREE_BITS * (rank + 1)));
    return end < t->items ? (uint32_t)end : t->items;
}

/* ---- polygons of very many corners ------------------------------------------------------------------------------- */

/* Tests 2 to 4 against a polygon of very many corners. They give the results of tests.c, without testing every side.
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

/* ---- bundles of very many faces ---------------------------------------------------------------------------------- */

/* A tree over the front faces of one solid whose boxes overlap many times, as in a fan or a round column.
 *
 * Such faces would be listed in all cells, and an edge would be compared with most of them. But together they hide one
 * interval of the edge, and only the faces at its ends matter. So the solid is one front with a tree over its faces. A
 * node stores a box of its faces in the picture, turned to lie along them, and a bound on how far a point can be behind
 * one of their planes. An edge skips a node if, wherever it meets the box, it is already hidden or in front of all
 * planes. */

typedef struct bundle_node {
    roberts_vec3 M;           /* a point among the faces' corners */
    double ux, uy;            /* unit vector along the faces */
    double x0, x1, y0, y1;    /* box of the corners in the picture, relative to M, along and across; with margin */
    roberts_vec3 least, most; /* bounds of the planes' normals */
    double behind;            /* the greatest F(M), plus the touching distance and rounding */
} bundle_node;

typedef struct bundle {
    list_tree tree;  /* its items are the entries of `order` */
    uint32_t *order; /* faces, counted from the solid's first front face; neighbours are adjacent */
    bundle_node node[];
} bundle;

/* The bundles of a picture. A bundle whose first face is f is at[f / BUNDLE_FACES]; other entries are NULL. */
typedef struct bundle_table {
    bundle **at;
    size_t count;
} bundle_table;

/* Makes an empty table for `count` faces. False: no memory; bundle_table_free() accepts a zeroed table. */
bool bundle_table_init(bundle_table *table, size_t count);
void bundle_table_free(bundle_table *table);

/* Adds a bundle of face[0 .. count-1]. first: the number of face[0]. Threads may add different bundles at the same
 * time. False: no memory. */
bool bundle_enter(bundle_table *table, const hide_space *space, const hide_face *face, uint32_t count, uint32_t first);

static inline const bundle *bundle_of(const bundle_table *table, uint32_t first, uint32_t count)
{
    return count > BUNDLE_FACES && table->at ? table->at[first / BUNDLE_FACES] : NULL;
}

/* Finds the part *t0 .. *t1 of the edge inside the node's box. False: there is none. */
bool bundle_meets(const bundle_node *n, const hide_edge *e, double *t0, double *t1);

/* Can X be behind the plane of one of the node's faces? If neither end of a line can, no point of the line can. */
static inline bool bundle_behind(const bundle_node *n, roberts_vec3 X)
{
    roberts_vec3 D = vec3_sub(X, n->M);
    double x = greater(n->least.x * D.x, n->most.x * D.x), y = greater(n->least.y * D.y, n->most.y * D.y);
    return n->behind + x + y + greater(n->least.z * D.z, n->most.z * D.z) >= 0.0;
}

/* Finds the next items, from *item on, whose node has (x, y) in its box: *item .. *end - 1. False: there are none. */
bool bundle_next(const bundle *b, double x, double y, uint32_t *item, uint32_t *end);

#endif
