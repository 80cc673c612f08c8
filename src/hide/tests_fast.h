/* tests_fast.h - tests 2 to 4 in one pass, for an edge and an outline whose signs are all plain.
 *
 * A sign is plain if its cross product is larger than hide_plain() of this edge and outline. Then tests.c would find
 * the same sign, and lengths and errors do not matter. H_i(A) and H_i(B) are computed for two sides at a time, in the
 * form that test 4 uses for t_i, so the part found is the same to the last bit. tests.c decides if a crossing is not
 * accurate, or if a sign is not plain (unless one end of the edge is well inside). The parts that are rarely needed are
 * in tests.c, too. */
#ifndef ROBERTS_HIDE_TESTS_FAST_H
#define ROBERTS_HIDE_TESTS_FAST_H

#include "base/bits.h"
#include "base/lanes.h"
#include "hide/intervals.h"

/* A copy of an outline, laid out for SIMD. An odd number of sides is made even by repeating the last side and the first
 * corner. */
typedef struct fast_outline {
    const uint32_t *corner;                               /* identifies the outline; NULL: empty */
    uint32_t sides;                                       /* the true number */
    size_t count;                                         /* the number rounded up to even */
    _Alignas(16) double x[FAST_CORNERS], y[FAST_CORNERS]; /* corners */
    double ox[FAST_CORNERS], oy[FAST_CORNERS];            /* of side i: its corner with the smaller vertex number */
    double dx[FAST_CORNERS], dy[FAST_CORNERS];            /* of side i: from its first corner to the next */
} fast_outline;

typedef enum fast_verdict {
    FAST_UNCLEAR, /* undecided: use the tests one by one */
    FAST_MISSED,  /* test 2: the sight plane through AB misses the outline */
    FAST_OUTSIDE, /* test 3: outside one side */
    FAST_INSIDE,  /* test 3: inside all sides */
    FAST_CUT,     /* test 4: a part is inside */
    FAST_EMPTY,   /* test 4: no part is inside, or the part is already known to be hidden */
} fast_verdict;

/* Copies the outline P[corner[0]], P[corner[1]], ... of at most FAST_CORNERS corners. */
void fast_take(fast_outline *o, const roberts_vec3 *P, const uint32_t *corner, uint32_t count);

/* H_i(A) and H_i(B), times the lengths of the sides; > 0 is inside. */
typedef struct fast_sides {
    _Alignas(16) double a[FAST_CORNERS], b[FAST_CORNERS];
    uint32_t out_a, out_b; /* bit i: A, B is outside of side i */
} fast_sides;

/* Finds the signs of test 3. True: all of them are plain. */
BITS_INLINE bool fast_signs(const fast_outline *o, double plain, const hide_edge *e, fast_sides *H)
{
    two ax = two_all(e->A.x), ay = two_all(e->A.y), bx = two_all(e->B.x), by = two_all(e->B.y);
    two nearest = two_all(INFINITY);
    unsigned out_a = 0, out_b = 0;
    for (size_t i = o->count; i > 0;) { /* backward: each pair of bits is added at the low end */
        i -= 2;
        two ox = two_load_aligned(o->ox + i), oy = two_load_aligned(o->oy + i);
        two dx = two_load_aligned(o->dx + i), dy = two_load_aligned(o->dy + i);
        two a = two_sub(two_mul(dx, two_sub(ay, oy)), two_mul(dy, two_sub(ax, ox)));
        two b = two_sub(two_mul(dx, two_sub(by, oy)), two_mul(dy, two_sub(bx, ox)));
        two_store(H->a + i, a);
        two_store(H->b + i, b);
        out_a = 4 * out_a + two_signs(a);
        out_b = 4 * out_b + two_signs(b);
        nearest = two_lesser(nearest, two_lesser(two_abs(a), two_abs(b)));
    }
    H->out_a = out_a;
    H->out_b = out_b;
    return two_least(nearest) > plain;
}

/* Test 2: on which sides of the sight plane through AB do the corners lie? */
BITS_INLINE fast_verdict fast_corners(const fast_outline *o, double plain, const hide_edge *e)
{
    two ax = two_all(e->A.x), ay = two_all(e->A.y), dx = two_all(e->B.x - e->A.x), dy = two_all(e->B.y - e->A.y);
    two nearest = two_all(INFINITY);
    unsigned right = 0, all = (1u << o->count) - 1;
    for (size_t i = o->count; i > 0;) {
        i -= 2;
        two px = two_sub(two_load_aligned(o->x + i), ax), py = two_sub(two_load_aligned(o->y + i), ay);
        two Q = two_sub(two_mul(dx, py), two_mul(dy, px));
        nearest = two_lesser(nearest, two_abs(Q));
        right = 4 * right + two_signs(Q);
    }
    if (!(two_least(nearest) > plain))
        return FAST_UNCLEAR;
    return right == 0 || right == all ? FAST_MISSED : FAST_CUT;
}

/* Test 4 with a bound for each crossing, as in hide_test4(), for edges whose crossings the common bound does not prove
 * accurate. */
fast_verdict fast_cut_closely(const fast_outline *o, const hide_space *space, const hide_edge *e, const fast_sides *H,
                              hide_interval *part);

/* Calls reach_along() for side i, which the edge crosses at *t. `touch` is negative if the edge enters there. */
double fast_reach_along(const fast_outline *o, const hide_space *space, const hide_edge *e, int i, double touch,
                        double *t);

/* Returns the t up to which the edge, crossing side i at *t, stays within epsilon of the border. i < 0: no crossing. */
BITS_INLINE double fast_reach(const fast_outline *o, const hide_space *space, const hide_edge *e, const fast_sides *H,
                              int i, double *t)
{
    if (i < 0)
        return *t;
    double length = sqrt(o->dx[i] * o->dx[i] + o->dy[i] * o->dy[i]), apart = H->a[i] - H->b[i];
    double touch = space->epsilon * length / apart; /* negative if the edge enters */
    return reach_is_plain(space, e, fabs(touch)) ? *t + touch : fast_reach_along(o, space, e, i, touch, t);
}

/* Test 4. The error of t_i is the error of the two distances, 2 rounding (side + reach) each, divided by their
 * difference. Side and reach are at most `span`. */
BITS_INLINE fast_verdict fast_cut(const fast_outline *o, const hide_space *space, const hide_edge *e, double span,
                                  const fast_sides *H, hide_interval *part)
{
    int in = -1, out = -1;
    double t0 = 0.0, t1 = 1.0, apart = INFINITY;
    for (uint32_t crossed = H->out_a | H->out_b; crossed; crossed &= crossed - 1) {
        int i = bits_trailing_zeros(crossed);
        double a = H->a[i], difference = a - H->b[i], t = a / difference;
        apart = lesser(apart, fabs(difference));
        if (a < 0.0) {
            if (t > t0) {
                t0 = t;
                in = i;
            }
        } else if (t < t1) {
            t1 = t;
            out = i;
        }
    }
    if (!hide_accurate(space, e, 8.0 * space->across_rounding * span / apart))
        return fast_cut_closely(o, space, e, H, part);
    if (t0 >= t1 || !((t1 - t0) * e->length3 > space->epsilon))
        return FAST_EMPTY;
    double r0 = fast_reach(o, space, e, H, in, &t0), r1 = fast_reach(o, space, e, H, out, &t1);
    *part = (hide_interval){t0, t1, r0, r1};
    return hide_is_left(space, e, part) ? FAST_CUT : FAST_EMPTY;
}

/* Does the part inside, with everything it touches, lie plainly within the part known to be hidden? It does under three
 * conditions. The hidden part begins at the edge's start, or outside a side that A is outside of. It ends at the edge's
 * end, or outside a side that B is outside of. Neither of its ends is near any side. */
BITS_INLINE bool fast_within(const fast_outline *o, double plain, const fast_sides *H, const hide_interval *hidden)
{
    two t0 = two_all(hidden->t0), t1 = two_all(hidden->t1), nearest = two_all(INFINITY);
    unsigned before = 0, after = 0;
    for (size_t i = o->count; i > 0;) {
        i -= 2;
        two a = two_load_aligned(H->a + i), ab = two_sub(two_load_aligned(H->b + i), a);
        two h0 = two_add(a, two_mul(ab, t0)), h1 = two_add(a, two_mul(ab, t1));
        before = 4 * before + two_signs(h0);
        after = 4 * after + two_signs(h1);
        nearest = two_lesser(nearest, two_lesser(two_abs(h0), two_abs(h1)));
    }
    return (hidden->t0 == 0.0 || (before & H->out_a)) && (hidden->t1 == 1.0 || (after & H->out_b)) &&
           two_least(nearest) > plain;
}

/* Handles an edge whose signs are not all plain. FAST_OUTSIDE: the edge is plainly outside one side, so the other signs
 * do not matter. FAST_CUT: one end is plainly inside, the other is near some side, and H has the signs that tests.c
 * would find. FAST_UNCLEAR: a sign needs double-double numbers, or no end is plainly inside. */
fast_verdict fast_settle(const fast_outline *o, const hide_space *space, const hide_edge *e, double plain,
                         fast_sides *H);

/* Tests 2 to 4. `span` bounds the distance of any two points of outline and edge, |dx| + |dy|. `hidden` is a part of
 * the edge that is known to be hidden, in which nothing new needs to be found; NULL: none. Fills `part` if the verdict
 * is FAST_INSIDE or FAST_CUT. */
BITS_INLINE fast_verdict fast_test(const fast_outline *o, const hide_space *space, const hide_edge *e, double span,
                                   const hide_interval *hidden, hide_interval *part)
{
    const double plain = hide_plain(span, space->epsilon, space->across_rounding);
    fast_sides H;
    if (!fast_signs(o, plain, e, &H)) {
        fast_verdict verdict = fast_settle(o, space, e, plain, &H);
        if (verdict != FAST_CUT)
            return verdict == FAST_OUTSIDE ? FAST_OUTSIDE : FAST_UNCLEAR;
    }
    if (H.out_a & H.out_b)
        return FAST_OUTSIDE;
    if (!(H.out_a | H.out_b)) {
        *part = hide_whole;
        return FAST_INSIDE;
    }
    if (hidden && fast_within(o, plain, &H, hidden))
        return FAST_EMPTY;
    if (H.out_a && H.out_b) { /* if one end is inside, corners lie on both sides */
        fast_verdict verdict = fast_corners(o, plain, e);
        if (verdict != FAST_CUT)
            return verdict == FAST_MISSED ? FAST_MISSED : FAST_UNCLEAR;
    }
    return fast_cut(o, space, e, span, &H, part);
}

#endif
