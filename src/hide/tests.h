/* tests.h - the lecture's tests 1 to 4: what one front face F of a solid hides of one edge AB of another.
 *
 * Specification ("Elimination des lignes cachees", with its corrections): the hidden part is the interval of t where
 * R(t) = A + t AB is inside or on every side plane of F and F(R(t)) > 0. The tests find it cheaply; each stops the
 * procedure if it decides.
 *
 *   1. F(A) <= 0 and F(B) <= 0: visible.
 *   2. All corners of F on one side of the sight plane Q through AB, at most one on it: visible.
 *   3. A and B inside or on every side plane: invisible (up to where AB pierces F). Outside one side plane, or one end
 *      outside and the other on it: visible.
 *   4. Otherwise AB crosses the sides: the part between the last crossing inward and the first one outward is
 *      invisible.
 *
 * Ties. F is closed in projection: an edge behind F and along its border is hidden, and an edge that only touches a
 * corner has no hidden part. F is strict in depth: an edge in F's plane is visible. Distances of at most epsilon are
 * zero; in depth, the face's own departure from its plane is added. Epsilon decides signs only. Parameters come from
 * unsnapped values. */
#ifndef ROBERTS_HIDE_TESTS_H
#define ROBERTS_HIDE_TESTS_H

#include "hide/intervals.h"
#include "hide/tests_fast.h"
#include "hide/types.h"

typedef enum hide_verdict { HIDE_UNDECIDED, HIDE_VISIBLE, HIDE_INVISIBLE } hide_verdict;

/* Signs of A and B relative to one side plane H_i: -1 outside, 0 on, 1 inside. */
typedef struct hide_side {
    signed char a, b;
} hide_side;

/* Scratch memory and counters of the tests. */
typedef struct hide_sides {
    hide_side *H; /* [room] */
    size_t room;
    roberts_tally tally;
    uint64_t refined; /* signs and crossings computed in double-double numbers */
    /* The outline tested last. (A cache of 64 outlines hits a third of the time and saves nothing.) */
    fast_outline outline;
} hide_sides;

/* A side of F, or the chord of several collinear sides: from corner `first` of F to corner `last`. */
typedef struct hide_chord {
    uint32_t first, last;
} hide_chord;

static inline hide_chord hide_side_of(const hide_face *F, uint32_t i)
{
    return (hide_chord){i, i + 1 < F->count ? i + 1 : 0};
}

/* The crossing t_i, and `touch`: how far along the edge from t_i the edge is epsilon away from the side's line. */
typedef struct hide_crossing {
    double t, touch;
    double error; /* bound of t's error; 0: t is accurate */
    hide_chord side;
} hide_crossing;

/* The last crossing inward and the first one outward; touch is 0 if there is none. */
typedef struct hide_cut {
    hide_crossing in, out;
} hide_cut;

/* Makes room for faces of up to `count` corners. Start from a zeroed struct; release with free(sides->H). False: no
 * memory. */
bool hide_sides_reserve(hide_sides *sides, size_t count);

/* HIDE_INVISIBLE (by depth): AB is behind F's plane and does not pierce it. */
hide_verdict hide_test1(const hide_face *F, const hide_edge *e);
bool hide_test2(const hide_space *space, const hide_face *F, const hide_edge *e);

/* Fills `sides` unless it returns HIDE_VISIBLE. */
hide_verdict hide_test3(const hide_space *space, const hide_face *F, const hide_edge *e, hide_sides *sides);

/* Finds the part of e inside all sides. False if it is empty or a point. */
bool hide_test4(const hide_space *space, const hide_face *F, const hide_edge *e, hide_sides *sides,
                hide_interval *part);

/* ---- the same tests for one corner or one side ---- */

/* Corners that are near the sight plane through AB. */
typedef struct hide_near {
    uint32_t count;
    bool doubtful; /* one of them may be farther from the sight plane than epsilon */
    int side;      /* the last one found is slightly left (1) or right (-1) of the sight plane, or undecided (0) */
} hide_near;

/* Test 2: is P left of the sight plane through AB (1), right of it (-1), or near it (0)? */
int hide_corner_side(const hide_space *space, roberts_vec3 P, const hide_edge *e, hide_near *near);

/* Does the sight plane miss a polygon whose other corners are all on its left (or all on its right)? If a near corner
 * is on the other side, the plane cuts off a sliver up to epsilon wide. The sliver is much longer if the edge runs
 * nearly along a side. It must be found; otherwise one could see between solids that fill space without a gap. */
static inline bool hide_near_misses(const hide_near *near, bool left)
{
    return near->count == 0 || (near->count == 1 && !near->doubtful && near->side != (left ? -1 : 1));
}

/* Test 3: returns the signs of A and B relative to one side. */
hide_side hide_side_signs(const hide_space *space, const hide_face *F, hide_chord side, const hide_edge *e,
                          uint64_t *refined);

static inline bool hide_side_outside(hide_side H)
{
    return (H.a < 0 && H.b <= 0) || (H.b < 0 && H.a <= 0);
}

/* Test 4: finds where AB crosses the line of one side. */
hide_crossing hide_cross_side(const hide_space *space, const hide_face *F, hide_chord side, const hide_edge *e);

/* An edge and the face whose sides cut it. `refined` is a counter. */
typedef struct hide_cutting {
    const hide_space *space;
    const hide_face *F;
    const hide_edge *e;
    uint64_t *refined;
} hide_cutting;

/* Finds the crossing with one side and updates `cut`. Start from hide_uncut. False: nothing is left between the
 * crossings. */
bool hide_cut_by(const hide_cutting *c, hide_chord side, hide_side H, hide_cut *cut);
bool hide_cut_end(const hide_cutting *c, hide_cut *cut, hide_interval *part);

static const hide_cut hide_uncut = {.out = {.t = 1.0}};

/* ---- all tests ---- */

/* Cuts `part` where e pierces F's plane, and its reach where e is more than `touch` in front of it. False if nothing of
 * `inside` is behind F. `inside` is the part of e inside all sides. It is the same for all planes, so that one plane's
 * cut does not affect another's. */
bool hide_pierce(const hide_space *space, const hide_face *F, const hide_edge *e, const hide_interval *inside,
                 hide_sides *sides, hide_interval *part);

/* Tests 3 and 4, counted in `sides`. Finds the part of e inside all sides; false if there is none. */
bool hide_by_sides(const hide_space *space, const hide_face *F, const hide_edge *e, hide_sides *sides,
                   hide_interval *part);

/* ---- signs and crossings from the coordinates as read ---- */

/* Signs and crossings are computed in doubles or in double-double numbers.
 *
 * View coordinates carry the rounding of the map to view space, about 1e-15 of the scene. This matters if a crossing is
 * very oblique, an edge very short, or a side very far from the point. Then the same quantities are computed from the
 * model's own coordinates, with the viewpoint V as a homogeneous point. The sight plane through P and Q is det(Q - P, X
 * - P, V) = 0 for a direction V, and det(P - V, Q - V, X - V) = 0 for an eye V.
 *
 * Differences of coordinates as read are nearly exact. So doubles nearly always suffice: their error is a part of the
 * distances between these points, and not of the scene. Double-double numbers decide the rest. */

/* A point with double-double coordinates: a vertex, or a computed end of an edge. */
typedef struct refine_point {
    uint32_t vertex;         /* ROBERTS_NONE: a computed point, at `place` */
    const seen_point *place; /* position in the model */
    double z;                /* depth in view space */
} refine_point;

static inline refine_point refine_vertex(const hide_space *space, uint32_t v)
{
    return (refine_point){v, NULL, space->P[v].z};
}

static inline refine_point refine_start(const hide_edge *e)
{
    return (refine_point){e->a, e->end, e->A.z};
}

static inline refine_point refine_end(const hide_edge *e)
{
    return (refine_point){e->b, e->end ? e->end + 1 : NULL, e->B.z};
}

/* In doubles: finds what refine_side() returns, with a bound of its error. Both are NaN if p and q have one picture. */
typedef struct refine_near {
    double value, error;
} refine_near;

refine_near refine_side_nearly(const hide_space *space, uint32_t p, uint32_t q, refine_point x);

/* In doubles: finds what refine_crossing() returns. False: that is not accurate. */
bool refine_crossing_nearly(const hide_space *space, uint32_t p, uint32_t q, const hide_edge *e, double *t);

/* Returns the distance, in view units, of x from the sight plane through vertices p and q; > 0 left of p -> q in the
 * picture. */
double refine_side(const hide_space *space, uint32_t p, uint32_t q, refine_point x);

/* Finds where edge e crosses the sight plane through p and q: a parameter along the edge's picture. */
double refine_crossing(const hide_space *space, uint32_t p, uint32_t q, const hide_edge *e);

/* Finds where edge e crosses the plane of face F: a parameter along the edge's picture. */
double refine_pierce(const hide_space *space, const hide_face *F, const hide_edge *e);

#endif
