/* tests.c - the four tests. See tests.h for their rules. */
#include "hide/tests.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"
#include "hide/refine.h"

/* A computed distance is trusted for its sign where its error is at most this part of epsilon. */
#define TRUSTED 0.125

bool hide_sides_reserve(hide_sides *sides, size_t count)
{
    return array_reserve(&sides->H, &sides->room, count, sizeof *sides->H);
}

static inline int sign_within(double value, double tolerance)
{
    return value > tolerance ? 1 : value < -tolerance ? -1 : 0;
}

/* Bound of the error of a point's distance from the line through two others that are `length` apart: both ends of the
 * line and the point are off by the rounding of their coordinates, the line's ends by as much more as the point lies
 * beyond them. */
static double line_error(const hide_space *space, double reach, double length)
{
    return 2.0 * space->rounding * (1.0 + reach / length);
}

/* TEST 1. Both ends in front of the face's plane or on it. `limit` is smaller than epsilon for a face so small that its
 * plane is uncertain at A and B; such a face is left to the later tests, which look at its plane near it only. */
bool hide_test1(const hide_face *F, const hide_edge *e)
{
    return plane_at(F->F, e->A) <= F->limit && plane_at(F->F, e->B) <= F->limit;
}

/* TEST 2. Q(X) = 0 is the sight plane through AB, Q(X) the distance from it. A corner whose distance is uncertain counts
 * as near; one near corner decides only where it is certainly on the plane. An edge seen end-on has no such plane. */
bool hide_test2(const hide_space *space, const hide_face *F, const hide_edge *e)
{
    double dx = e->B.x - e->A.x, dy = e->B.y - e->A.y;
    unsigned left = 0, right = 0, near = 0;
    bool certain = true;
    if (e->length <= space->epsilon)
        return false;
    for (uint32_t i = 0; i < F->count; i++) {
        roberts_vec3 P = space->P[F->corner[i]];
        double px = P.x - e->A.x, py = P.y - e->A.y;
        double Q = (dx * py - dy * px) / e->length;
        double error = line_error(space, fabs(px) + fabs(py), e->length);
        switch (sign_within(Q, space->epsilon + error)) {
        case 1:
            left++;
            break;
        case -1:
            right++;
            break;
        default:
            near++;
            certain = certain && error <= TRUSTED * space->epsilon;
        }
        if (left && right)
            return false;
    }
    return near == 0 || (near == 1 && certain);
}

/* One end of an edge against a side of direction (dx, dy) and `length`, where its sign is not plain: the distance, again
 * as a multiple of the length, and its sign. h: as computed from view points, off by no more than `error`. */
static int sign_closely(const hide_space *space, uint32_t p, uint32_t q, uint32_t x, double length, double error,
                        double *h, uint64_t *refined)
{
    if (error > TRUSTED * space->epsilon * length && fabs(*h) <= space->epsilon * length + error && space->scene) {
        *h = refine_side(space, p, q, x) * length;
        ++*refined;
    }
    return sign_within(*h, space->epsilon * length);
}

/* H_i at A and B: the one predicate for inside, on and outside of a side. Computed in the direction from the smaller
 * vertex number to the larger, so that the two faces of a side agree to the last bit. */
static void measure_side(const hide_space *space, uint32_t p, uint32_t q, const hide_edge *e, hide_side *H,
                         uint64_t *refined)
{
    uint32_t from = p < q ? p : q, to = p < q ? q : p;
    roberts_vec3 P = space->P[from], Q = space->P[to];
    double dx = Q.x - P.x, dy = Q.y - P.y, ax = e->A.x - P.x, ay = e->A.y - P.y, bx = e->B.x - P.x, by = e->B.y - P.y;
    double a = dx * ay - dy * ax, b = dx * by - dy * bx;
    /* not less than the side's length, and not more than its double */
    double around = fabs(dx) + fabs(dy);
    double error_a = 2.0 * space->rounding * (around + fabs(ax) + fabs(ay));
    double error_b = 2.0 * space->rounding * (around + fabs(bx) + fabs(by));
    H->error = error_a + error_b;
    H->length2 = dx * dx + dy * dy;
    if (around > 2.0 * space->epsilon && fabs(a) > space->epsilon * around + error_a &&
        fabs(b) > space->epsilon * around + error_b) {
        H->sign_a = a > 0.0 ? 1 : -1;
        H->sign_b = b > 0.0 ? 1 : -1;
    } else {
        double length = sqrt(H->length2);
        H->sign_a = H->sign_b = 0;
        /* A side no longer than epsilon bounds nothing that its neighbours do not bound to within epsilon. */
        if (length > space->epsilon) {
            H->sign_a = (signed char)sign_closely(space, from, to, e->a, length, error_a, &a, refined);
            H->sign_b = (signed char)sign_closely(space, from, to, e->b, length, error_b, &b, refined);
        }
    }
    H->a = p < q ? a : -a;
    H->b = p < q ? b : -b;
    if (p > q) {
        H->sign_a = (signed char)-H->sign_a;
        H->sign_b = (signed char)-H->sign_b;
    }
}

/* TEST 3. */
hide_verdict hide_test3(const hide_space *space, const hide_face *F, const hide_edge *e, hide_sides *sides)
{
    bool inside = true;
    for (uint32_t i = 0; i < F->count; i++) {
        hide_side *H = &sides->H[i];
        measure_side(space, F->corner[i], F->corner[i + 1 < F->count ? i + 1 : 0], e, H, &sides->refined);
        if ((H->sign_a < 0 && H->sign_b <= 0) || (H->sign_b < 0 && H->sign_a <= 0))
            return HIDE_VISIBLE;
        inside = inside && H->sign_a >= 0 && H->sign_b >= 0;
    }
    return inside ? HIDE_INVISIBLE : HIDE_UNDECIDED;
}

/* Is a parameter with this error good enough, along the edge and as a length? */
static bool accurate(const hide_space *space, const hide_edge *e, double error)
{
    return error <= HIDE_T_ACCURACY && error * e->length3 <= TRUSTED * space->epsilon;
}

static double crossing(const hide_space *space, const hide_face *F, const hide_edge *e, hide_sides *sides, uint32_t i)
{
    double a = sides->H[i].a, b = sides->H[i].b;
    if (accurate(space, e, sides->H[i].error / fabs(a - b)) || !space->scene)
        return a / (a - b);
    uint32_t p = F->corner[i], q = F->corner[i + 1 < F->count ? i + 1 : 0];
    sides->refined++;
    return p < q ? refine_crossing(space, p, q, e) : refine_crossing(space, q, p, e);
}

/* TEST 4. t_i is the crossing of AB with side plane H_i. Of those by which AB comes in, the last lies on the side itself
 * (0 <= s_i <= 1), and so does the first by which it goes out, unless AB misses the face: then they come in the wrong
 * order. So the s_i need not be computed. */
bool hide_test4(const hide_space *space, const hide_face *F, const hide_edge *e, hide_sides *sides, hide_part *part)
{
    const hide_side *in = NULL, *out = NULL;
    *part = (hide_part){0.0, 1.0, 0.0, 0.0};
    for (uint32_t i = 0; i < F->count; i++) {
        const hide_side *H = &sides->H[i];
        if (H->sign_a >= 0 && H->sign_b >= 0)
            continue;
        double t = crossing(space, F, e, sides, i);
        if (H->sign_a < 0 && t > part->t0) {
            part->t0 = t;
            in = H;
        }
        if (H->sign_b < 0 && t < part->t1) {
            part->t1 = t;
            out = H;
        }
        if (part->t0 >= part->t1)
            return false;
    }
    if (in)
        part->e0 = space->epsilon * sqrt(in->length2) / fabs(in->a - in->b);
    if (out)
        part->e1 = space->epsilon * sqrt(out->length2) / fabs(out->a - out->b);
    return (part->t1 - part->t0) * e->length3 > space->epsilon;
}

bool hide_pierce(const hide_space *space, const hide_face *F, const hide_edge *e, hide_sides *sides, hide_part *part)
{
    double f0 = plane_at(F->F, hide_edge_at(e, part->t0)), f1 = plane_at(F->F, hide_edge_at(e, part->t1));
    int sign0 = sign_within(f0, F->touch), sign1 = sign_within(f1, F->touch);
    if (sign0 <= 0 && sign1 <= 0)
        return false;
    if (sign0 >= 0 && sign1 >= 0)
        return true;
    double width = part->t1 - part->t0, slope = fabs(f0 - f1);
    double t = part->t0 + width * (f0 / (f0 - f1));
    if (!accurate(space, e, width * 4.0 * space->rounding / slope) && space->scene) {
        t = fmin(fmax(refine_pierce(space, F, e), part->t0), part->t1);
        sides->refined++;
    }
    if (sign0 < 0) {
        part->t0 = t;
        part->e0 = width * F->touch / slope;
    } else {
        part->t1 = t;
        part->e1 = width * F->touch / slope;
    }
    return (part->t1 - part->t0) * e->length3 > space->epsilon;
}

bool hide_by_face(const hide_space *space, const hide_face *F, const hide_edge *e, hide_sides *sides,
                  roberts_tally *tally, hide_part *part)
{
    tally->pairs++;
    if (hide_test1(F, e)) {
        tally->test1_visible++;
        return false;
    }
    if (hide_test2(space, F, e)) {
        tally->test2_visible++;
        return false;
    }
    switch (hide_test3(space, F, e, sides)) {
    case HIDE_VISIBLE:
        tally->test3_visible++;
        return false;
    case HIDE_INVISIBLE:
        tally->test3_invisible++;
        *part = (hide_part){0.0, 1.0, 0.0, 0.0};
        break;
    default:
        tally->test4++;
        if (!hide_test4(space, F, e, sides, part))
            return false;
    }
    return hide_pierce(space, F, e, sides, part);
}
