/* tests.h - the lecture's tests 1 to 4: what one front face F of a solid hides of one edge AB of another.
 *
 * Specification ("Elimination des lignes cachees", with its corrections): the hidden part is the interval of those t
 * for which R(t) = A + t AB is inside or on every side plane of F and F(R(t)) > 0. The tests are the cheap way to it,
 * and each stops the procedure where it decides.
 *
 *   1. F(A) <= 0 and F(B) <= 0: visible.
 *   2. All corners of F on one side of the sight plane Q through AB, at most one on it: visible.
 *   3. A and B inside or on every side plane: invisible (up to where AB pierces F). Outside one side plane, or one
 *      end outside and the other on it: visible.
 *   4. What remains crosses the sides: the part between the last crossing inward and the first one outward.
 *
 * Ties. F is closed in projection (an edge behind F and along its border is hidden; one that only touches a corner has
 * no hidden part) and strict in depth (an edge in F's plane is visible). A distance of at most epsilon is zero, in
 * depth also the face's own departure from its plane. Epsilon decides signs only: parameters come from the values as
 * they are. */
#ifndef ROBERTS_HIDE_TESTS_H
#define ROBERTS_HIDE_TESTS_H

#include "hide/tests_fast.h"
#include "hide/reach.h"
#include "hide/tolerance.h"

typedef enum hide_verdict { HIDE_UNDECIDED, HIDE_VISIBLE, HIDE_INVISIBLE } hide_verdict;

/* Signs of A and B against one side plane H_i: -1 outside, 0 on, 1 inside. */
typedef struct hide_side {
    signed char a, b;
} hide_side;

/* Scratch memory of the tests, and what they count. */
typedef struct hide_sides {
    hide_side *H; /* [room] */
    size_t room;
    roberts_tally tally;
    uint64_t refined; /* signs and crossings computed in twice the precision */
    /* The outline that was asked last. (A table of 64 is right a third of the time, and saves nothing.) */
    fast_outline outline;
} hide_sides;

/* A side of F, or the chord of several that are straight: from corner `first` of F to corner `last`. */
typedef struct hide_chord {
    uint32_t first, last;
} hide_chord;

static inline hide_chord hide_side_of(const hide_face *F, uint32_t i)
{
    return (hide_chord){i, i + 1 < F->count ? i + 1 : 0};
}

/* t_i, and how far along the edge from there it is epsilon away from the side's line. */
typedef struct hide_crossing {
    double t, touch;
    double error; /* bound of t's error; 0: t is accurate */
    hide_chord side;
} hide_crossing;

/* The last crossing inward and the first one outward; touch is 0 where there is none. */
typedef struct hide_cut {
    hide_crossing in, out;
} hide_cut;

/* Room for faces of up to `count` corners; false: no memory. Start from a zeroed struct; free(sides->H) ends it. */
bool hide_sides_reserve(hide_sides *sides, size_t count);

bool hide_test1(const hide_face *F, const hide_edge *e);
bool hide_test2(const hide_space *space, const hide_face *F, const hide_edge *e);

/* Fills `sides` unless it returns HIDE_VISIBLE. */
hide_verdict hide_test3(const hide_space *space, const hide_face *F, const hide_edge *e, hide_sides *sides);

/* The part of e inside all sides; false where it is empty or a point. */
bool hide_test4(const hide_space *space, const hide_face *F, const hide_edge *e, hide_sides *sides,
                hide_interval *part);

/* ---- the same corner by corner and side by side ---- */

/* Corners that are near the sight plane through AB. */
typedef struct hide_near {
    uint32_t count;
    bool doubtful; /* one of them may be farther from it than epsilon */
    int side; /* the last one is a little to the left (1) of it, to the right (-1), or cannot be told from it (0) */
} hide_near;

/* Test 2: is P left of the sight plane through AB (1), right of it (-1), or near to it (0)? */
int hide_corner_side(const hide_space *space, roberts_vec3 P, const hide_edge *e, hide_near *near);

/* Does the sight plane miss a polygon whose other corners are all on its left (or all on its right)? If a near corner
 * is on the other side, the plane cuts off a sliver up to epsilon wide. The sliver is much longer if the edge runs
 * nearly along a side. It must not be missed, or one would see through solids that fill a place without a gap. */
static inline bool hide_near_misses(const hide_near *near, bool left)
{
    return near->count == 0 || (near->count == 1 && !near->doubtful && near->side != (left ? -1 : 1));
}

/* Test 3: the signs of A and B against side i. */
hide_side hide_side_signs(const hide_space *space, const hide_face *F, hide_chord side, const hide_edge *e,
                          uint64_t *refined);

static inline bool hide_side_outside(hide_side H)
{
    return (H.a < 0 && H.b <= 0) || (H.b < 0 && H.a <= 0);
}

/* Test 4: where AB crosses side i. */
hide_crossing hide_cross_side(const hide_space *space, const hide_face *F, hide_chord side, const hide_edge *e);

/* An edge that the sides of F cut; `refined` counts. */
typedef struct hide_cutting {
    const hide_space *space;
    const hide_face *F;
    const hide_edge *e;
    uint64_t *refined;
} hide_cutting;

/* Finds the same crossing and takes it into account. False: nothing is left between the crossings. Begin with
 * hide_uncut. */
bool hide_cut_by(const hide_cutting *c, hide_chord side, hide_side H, hide_cut *cut);
bool hide_cut_end(const hide_cutting *c, hide_cut *cut, hide_interval *part);

static const hide_cut hide_uncut = {.out = {.t = 1.0}};

/* ---- all tests ---- */

/* Cuts `part` where e pierces F's plane, and its reach where e is more than `touch` before it; false where nothing of
 * `inside` lies behind. `inside` is what all sides leave of e: what one plane cuts off has no say in what another
 * does. */
bool hide_pierce(const hide_space *space, const hide_face *F, const hide_edge *e, const hide_interval *inside,
                 hide_sides *sides, hide_interval *part);

/* Is so much left that it counts? */
static inline bool hide_is_left(const hide_space *space, const hide_edge *e, const hide_interval *part)
{
    return (part->t1 - part->t0) * e->length3 > space->epsilon;
}

/* Tests 3 and 4, counted in `sides`: the part of e inside all sides; false where there is none. */
bool hide_by_sides(const hide_space *space, const hide_face *F, const hide_edge *e, hide_sides *sides,
                   hide_interval *part);

#endif
