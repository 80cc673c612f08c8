/* quick.c - see quick.h. */
#include "hide/quick.h"

#include "base/bits.h"
#include "base/lanes.h"
#include "hide/tests.h"

void quick_take(quick_outline *o, const roberts_vec3 *P, const uint32_t *corner, uint32_t count)
{
    uint32_t last = count - 1;
    o->corner = corner;
    o->count = count;
    for (uint32_t i = 0; i < count; i++) {
        o->x[i] = P[corner[i]].x;
        o->y[i] = P[corner[i]].y;
    }
    o->x[count] = o->x[0];
    o->y[count] = o->y[0];
    for (uint32_t i = 0; i < last; i++) {
        bool second = corner[i] > corner[i + 1];
        o->ox[i] = o->x[i + second];
        o->oy[i] = o->y[i + second];
    }
    o->ox[last] = corner[last] < corner[0] ? o->x[last] : o->x[0];
    o->oy[last] = corner[last] < corner[0] ? o->y[last] : o->y[0];
    for (uint32_t i = 0; i < count; i += 2) {
        two_store(o->dx + i, two_sub(two_load(o->x + i + 1), two_load(o->x + i)));
        two_store(o->dy + i, two_sub(two_load(o->y + i + 1), two_load(o->y + i)));
    }
    if (count % 2) {
        o->ox[count] = o->ox[last];
        o->oy[count] = o->oy[last];
        o->dx[count] = o->dx[last];
        o->dy[count] = o->dy[last];
    }
}

/* H_i(A) and H_i(B), times the lengths of the sides; > 0 inside. */
typedef struct side_signs {
    double a[QUICK_CORNERS], b[QUICK_CORNERS];
    uint32_t out_a, out_b; /* bit i: A, B is outside of side i */
} side_signs;

/* Test 3. The signs count as found only where it returns true. */
static bool find_signs(const quick_outline *o, double plain, const hide_edge *e, side_signs *H, bool *outside)
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
    uint32_t all = (2u << (o->count - 1)) - 1; /* and not the side that stands twice */
    H->out_a = out_a & all;
    H->out_b = out_b & all;
    *outside = two_least(outmost) < -plain;
    return two_least(nearest) > plain;
}

/* Test 2: how the corners lie about the sight plane through AB. */
static quick_verdict ask_corners(const quick_outline *o, double plain, const hide_edge *e)
{
    two ax = two_all(e->A.x), ay = two_all(e->A.y), dx = two_all(e->B.x - e->A.x), dy = two_all(e->B.y - e->A.y);
    two nearest = two_all(INFINITY);
    uint32_t right = 0, all = (2u << (o->count - 1)) - 1;
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
static quick_verdict cut(const quick_outline *o, const hide_space *space, const hide_edge *e, const side_signs *H,
                         hide_part *part)
{
    *part = (hide_part){0.0, 1.0, 0.0, 0.0};
    for (uint32_t out = H->out_a | H->out_b; out; out &= out - 1) {
        int i = bits_trailing_zeros(out);
        double a = H->a[i], b = H->b[i], dx = o->dx[i], dy = o->dy[i], ox = o->ox[i], oy = o->oy[i];
        double length = sqrt(dx * dx + dy * dy), apart = fabs(a - b);
        double error_a = 2.0 * space->rounding * (length + fabs(e->A.x - ox) + fabs(e->A.y - oy));
        double error_b = 2.0 * space->rounding * (length + fabs(e->B.x - ox) + fabs(e->B.y - oy));
        if (!hide_accurate(space, e, (error_a + error_b) / apart))
            return QUICK_UNCLEAR;
        double t = a / (a - b);
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

quick_verdict quick_test(const quick_outline *o, const hide_space *space, const hide_edge *e, hide_part *part)
{
    side_signs H;
    bool outside, plain = find_signs(o, space->plain, e, &H, &outside);
    if (outside)
        return QUICK_OUTSIDE; /* of one side plainly, whatever the others say */
    if (!plain)
        return QUICK_UNCLEAR;
    if (!(H.out_a | H.out_b)) {
        *part = (hide_part){0.0, 1.0, 0.0, 0.0};
        return QUICK_INSIDE;
    }
    if (H.out_a && H.out_b) { /* with an end inside there are corners on both sides */
        quick_verdict verdict = ask_corners(o, space->plain, e);
        if (verdict != QUICK_CUT)
            return verdict;
    }
    return cut(o, space, e, &H, part);
}
