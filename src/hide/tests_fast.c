/* tests_fast.c - tests 2 to 4 in one pass: the parts that are rarely needed. See tests_fast.h. */
#include "hide/tests_fast.h"

#include "base/lanes.h"
#include "hide/refine.h"

/* Stores side i, which runs from p to q. `forward`: p has the smaller vertex number. */
BITS_INLINE void take_side(fast_outline *o, uint32_t i, two p, two q, bool forward)
{
    two_part(&o->x[i], &o->y[i], p);
    if (forward)
        two_part(&o->ox[i], &o->oy[i], p);
    else
        two_part(&o->ox[i], &o->oy[i], q);
    two_part(&o->dx[i], &o->dy[i], two_sub(q, p));
}

BITS_PER_PROCESSOR void fast_take(fast_outline *o, const roberts_vec3 *P, const uint32_t *corner, uint32_t count)
{
    uint32_t first = corner[0];
    two p = two_of(P[first].x, P[first].y), begin = p;
    o->corner = corner;
    o->sides = count;
    o->count = count + count % 2;
    for (uint32_t i = 0; i + 1 < count; i++) {
        uint32_t second = corner[i + 1];
        two q = two_of(P[second].x, P[second].y);
        take_side(o, i, p, q, first < second);
        first = second;
        p = q;
    }
    take_side(o, count - 1, p, begin, first < corner[0]);
    if (count % 2) {
        o->x[count] = o->x[0];
        o->y[count] = o->y[0];
        o->ox[count] = o->ox[count - 1];
        o->oy[count] = o->oy[count - 1];
        o->dx[count] = o->dx[count - 1];
        o->dy[count] = o->dy[count - 1];
    }
}

static bool all_above(const double *h, size_t count, double least)
{
    for (size_t i = 0; i < count; i++)
        if (!(h[i] > least))
            return false;
    return true;
}

static bool outside_one(const fast_sides *H, size_t count, double plain)
{
    for (size_t i = 0; i < count; i++)
        if (H->a[i] < -plain && H->b[i] < -plain)
            return true;
    return false;
}

/* Decides signs that are not plain as look_closely() in tests.c does. */
fast_verdict fast_settle(const fast_outline *o, const hide_space *space, const hide_edge *e, double plain,
                         fast_sides *H)
{
    bool a_inside = all_above(H->a, o->count, plain);
    const double *h = a_inside ? H->b : H->a;
    roberts_vec3 X = a_inside ? e->B : e->A;
    uint32_t out = 0, touched = 0;
    if (!a_inside && !all_above(H->b, o->count, plain))
        return outside_one(H, o->count, plain) ? FAST_OUTSIDE : FAST_UNCLEAR;
    for (size_t i = 0; i < o->count; i++) {
        if (fabs(h[i]) > plain) {
            out |= (h[i] < 0.0 ? 1u : 0u) << i;
            continue;
        }
        double length = sqrt(o->dx[i] * o->dx[i] + o->dy[i] * o->dy[i]), on = space->epsilon * length;
        double error = 2.0 * space->rounding * (length + fabs(X.x - o->ox[i]) + fabs(X.y - o->oy[i]));
        if (length <= space->epsilon)
            continue;
        if (error > HIDE_TRUSTED * on && fabs(h[i]) <= on + error)
            return FAST_UNCLEAR;
        out |= (h[i] < -on ? 1u : 0u) << i;
        touched += h[i] < 0.0 && h[i] >= -on && i < o->sides;
    }
    if (touched > 1)
        return FAST_UNCLEAR; /* perhaps beyond a sharp corner: see hide_by_sides() */
    H->out_a = a_inside ? 0 : out;
    H->out_b = a_inside ? out : 0;
    return FAST_CUT;
}

/* An odd last side is stored twice. */
static inline uint32_t side_of(const fast_outline *o, int i)
{
    return (uint32_t)i < o->sides ? (uint32_t)i : o->sides - 1;
}

double fast_reach_along(const fast_outline *o, const hide_space *space, const hide_edge *e, int i, double touch,
                        double *t)
{
    hide_face F = {.corner = o->corner, .count = o->sides};
    const uint32_t first = side_of(o, i);
    reach_border border = {&F, first, first + 1 < o->sides ? first + 1 : 0, touch > 0.0};
    return reach_along(space, e, &border, fabs(touch), t);
}

/* Finds the crossing with side i as refine_if_needed() in tests.c does. False: it needs double-double numbers. */
static bool crossing_as_read(const fast_outline *o, const hide_space *space, const hide_edge *e, int i, double *t)
{
    const uint32_t first = side_of(o, i), p = o->corner[first], q = o->corner[first + 1 < o->sides ? first + 1 : 0];
    return space->scene && refine_crossing_nearly(space, p < q ? p : q, p < q ? q : p, e, t);
}

fast_verdict fast_cut_closely(const fast_outline *o, const hide_space *space, const hide_edge *e, const fast_sides *H,
                              hide_interval *part)
{
    int inward = -1, outward = -1; /* sides of the last entry and the first exit */
    *part = hide_whole;
    for (uint32_t out = H->out_a | H->out_b; out; out &= out - 1) {
        int i = bits_trailing_zeros(out);
        double a = H->a[i], b = H->b[i], dx = o->dx[i], dy = o->dy[i], ox = o->ox[i], oy = o->oy[i];
        double length = sqrt(dx * dx + dy * dy), apart = fabs(a - b);
        double error_a = 2.0 * space->rounding * (length + fabs(e->A.x - ox) + fabs(e->A.y - oy));
        double error_b = 2.0 * space->rounding * (length + fabs(e->B.x - ox) + fabs(e->B.y - oy));
        double t = a / (a - b), error = (error_a + error_b) / apart;
        if (!hide_accurate(space, e, error)) {
            error =
                lesser(hide_crossing_error(space, e, t, (roberts_vec2){ox, oy}, (roberts_vec2){dx, dy}, apart), error);
            if (a < 0.0 ? t + error <= part->t0 : t - error >= part->t1)
                continue;
            if (!hide_accurate(space, e, error) && !crossing_as_read(o, space, e, i, &t))
                return FAST_UNCLEAR;
        }
        if (a < 0.0) {
            if (t > part->t0) {
                part->t0 = t;
                inward = i;
            }
        } else if (t < part->t1) {
            part->t1 = t;
            outward = i;
        }
        if (part->t0 >= part->t1)
            return FAST_EMPTY;
    }
    if (!((part->t1 - part->t0) * e->length3 > space->epsilon))
        return FAST_EMPTY;
    part->r0 = fast_reach(o, space, e, H, inward, &part->t0);
    part->r1 = fast_reach(o, space, e, H, outward, &part->t1);
    return (part->t1 - part->t0) * e->length3 > space->epsilon ? FAST_CUT : FAST_EMPTY;
}
