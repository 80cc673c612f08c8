/* quick.h - tests 2 to 4 at a stroke, for an edge and an outline between which all signs are plain.
 *
 * A sign is plain where its cross product is larger than hide_space.plain: then it is the one that tests.c would find,
 * without looking at lengths and errors. The sides' functions H_i(A), H_i(B) are computed two at a time, in the form
 * that test 4 needs for t_i, so that the part found is the same to the last bit. Where a sign is not plain (but for those of
 * an edge that ends well inside), or a crossing not accurate, the verdict is left to tests.c. */
#ifndef ROBERTS_HIDE_QUICK_H
#define ROBERTS_HIDE_QUICK_H

#include "base/bits.h"
#include "base/lanes.h"
#include "hide/space.h"

/* Corners of the outlines that are taken up; those of more are left to tests.c. Even. */
#define QUICK_CORNERS 16

/* An outline at hand, drawn together from the picture. An odd number of sides is made even: the last stands twice. */
typedef struct quick_outline {
    const uint32_t *corner; /* whose; NULL: nobody's */
    uint32_t count;
    double x[QUICK_CORNERS + 2], y[QUICK_CORNERS + 2]; /* corners, the first once more at the end */
    double ox[QUICK_CORNERS], oy[QUICK_CORNERS];       /* of side i the end of smaller number */
    double dx[QUICK_CORNERS], dy[QUICK_CORNERS];       /* ... and from its first corner to the next */
} quick_outline;

typedef enum quick_verdict {
    QUICK_UNCLEAR, /* ask tests 2 to 4 themselves */
    QUICK_MISSED,  /* test 2: the sight plane through AB misses the outline */
    QUICK_OUTSIDE, /* test 3: outside one side */
    QUICK_INSIDE,  /* test 3: inside all sides */
    QUICK_CUT,     /* test 4: a part is inside */
    QUICK_EMPTY,   /* test 4: none is */
} quick_verdict;

/* Takes up the outline P[corner[0]], P[corner[1]], ... of at most QUICK_CORNERS corners. */
void quick_take(quick_outline *o, const roberts_vec3 *P, const uint32_t *corner, uint32_t count);

/* H_i(A) and H_i(B), times the lengths of the sides; > 0 inside. */
typedef struct quick_sides {
    double a[QUICK_CORNERS], b[QUICK_CORNERS];
    uint32_t out_a, out_b; /* bit i: A, B is outside of side i */
} quick_sides;

/* Test 3. The signs count as found only where it returns true. */
BITS_INLINE bool quick_signs(const quick_outline *o, double plain, const hide_edge *e, quick_sides *H, bool *outside)
{
    two ax = two_all(e->A.x), ay = two_all(e->A.y), bx = two_all(e->B.x), by = two_all(e->B.y);
    two nearest = two_all(INFINITY), outmost = nearest;
    uint32_t out_a = 0, out_b = 0;
    for (uint32_t i = 0; i < o->count; i += 2) {
        two ox = two_load(o->ox + i), oy = two_load(o->oy + i), dx = two_load(o->dx + i), dy = two_load(o->dy + i);
        two a = two_sub(two_mul(dx, two_sub(ay, oy)), two_mul(dy, two_sub(ax, ox)));
        two b = two_sub(two_mul(dx, two_sub(by, oy)), two_mul(dy, two_sub(bx, ox)));
        two_store(H->a + i, a);
        two_store(H->b + i, b);
        out_a |= two_signs(a) << i;
        out_b |= two_signs(b) << i;
        outmost = two_lesser(outmost, two_greater(a, b));
        nearest = two_lesser(nearest, two_lesser(two_abs(a), two_abs(b)));
    }
    uint32_t all = (1u << o->count) - 1; /* and not the side that stands twice */
    H->out_a = out_a & all;
    H->out_b = out_b & all;
    *outside = two_least(outmost) < -plain;
    return two_least(nearest) > plain;
}

/* Test 2: how the corners lie about the sight plane through AB. */
BITS_INLINE quick_verdict quick_corners(const quick_outline *o, double plain, const hide_edge *e)
{
    two ax = two_all(e->A.x), ay = two_all(e->A.y), dx = two_all(e->B.x - e->A.x), dy = two_all(e->B.y - e->A.y);
    two nearest = two_all(INFINITY);
    uint32_t right = 0, all = (1u << o->count) - 1;
    for (uint32_t i = 0; i < o->count; i += 2) {
        two Q = two_sub(two_mul(dx, two_sub(two_load(o->y + i), ay)), two_mul(dy, two_sub(two_load(o->x + i), ax)));
        nearest = two_lesser(nearest, two_abs(Q));
        right |= two_signs(Q) << i;
    }
    if (!(two_least(nearest) > plain))
        return QUICK_UNCLEAR;
    right &= all;
    return right == 0 || right == all ? QUICK_MISSED : QUICK_CUT;
}

/* Test 4, as hide_test4() has it. */
BITS_INLINE quick_verdict quick_cut(const quick_outline *o, const hide_space *space, const hide_edge *e,
                                    const quick_sides *H, hide_part *part)
{
    *part = (hide_part){0.0, 1.0, 0.0, 0.0};
    for (uint32_t out = H->out_a | H->out_b; out; out &= out - 1) {
        int i = bits_trailing_zeros(out);
        double a = H->a[i], b = H->b[i], dx = o->dx[i], dy = o->dy[i], ox = o->ox[i], oy = o->oy[i];
        double length = sqrt(dx * dx + dy * dy), apart = fabs(a - b);
        double error_a = 2.0 * space->rounding * (length + fabs(e->A.x - ox) + fabs(e->A.y - oy));
        double error_b = 2.0 * space->rounding * (length + fabs(e->B.x - ox) + fabs(e->B.y - oy));
        double t = a / (a - b), error = (error_a + error_b) / apart;
        if (!hide_accurate(space, e, error)) {
            error = lesser(hide_crossing_error(space, e, t, ox, oy, dx, dy, apart), error);
            if (a < 0.0 ? t + error <= part->t0 : t - error >= part->t1)
                continue;
            if (!hide_accurate(space, e, error))
                return QUICK_UNCLEAR;
        }
        if (a < 0.0) {
            if (t > part->t0) {
                part->t0 = t;
                part->e0 = space->epsilon * length / apart;
            }
        } else if (t < part->t1) {
            part->t1 = t;
            part->e1 = space->epsilon * length / apart;
        }
        if (part->t0 >= part->t1)
            return QUICK_EMPTY;
    }
    return (part->t1 - part->t0) * e->length3 > space->epsilon ? QUICK_CUT : QUICK_EMPTY;
}

/* Where one end is plainly inside, and the other near to some side: the signs that tests.c would find. False where that
 * takes twice the precision, and where no end is plainly inside. */
bool quick_settle(const quick_outline *o, const hide_space *space, const hide_edge *e, quick_sides *H);

/* Fills `part` where the verdict is QUICK_INSIDE or QUICK_CUT. */
BITS_INLINE quick_verdict quick_test(const quick_outline *o, const hide_space *space, const hide_edge *e,
                                     hide_part *part)
{
    quick_sides H;
    bool outside, plain = quick_signs(o, space->plain, e, &H, &outside);
    if (outside)
        return QUICK_OUTSIDE; /* of one side plainly, whatever the others say */
    if (!plain && !quick_settle(o, space, e, &H))
        return QUICK_UNCLEAR;
    if (!(H.out_a | H.out_b)) {
        *part = (hide_part){0.0, 1.0, 0.0, 0.0};
        return QUICK_INSIDE;
    }
    if (H.out_a && H.out_b) { /* with an end inside there are corners on both sides */
        quick_verdict verdict = quick_corners(o, space->plain, e);
        if (verdict != QUICK_CUT)
            return verdict;
    }
    return quick_cut(o, space, e, &H, part);
}

#endif
