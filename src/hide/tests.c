/* tests.c - the four tests of one edge against one face, and signs and crossings from the coordinates as read. See
 * tests.h for their rules. */
#include "hide/tests.h"

#include <math.h>

#include "base/array.h"
#include "base/dd.h"
#include "base/lanes.h"

/* ---- signs and crossings from the coordinates as read ------------------------------------------------------------ */

/* Returns the position of a vertex. */
static seen_point vertex_point(const hide_space *space, uint32_t a)
{
    const roberts_scene *scene = space->scene;
    return (seen_point){scene->point[a], scene->low ? scene->low[a] : (roberts_vec3){0.0, 0.0, 0.0}};
}

static seen_point refine_place(const hide_space *space, refine_point x)
{
    return x.vertex == ROBERTS_NONE ? *x.place : vertex_point(space, x.vertex);
}

/* Returns b - a in view units. */
static dd3 between(const hide_space *space, seen_point b, seen_point a)
{
    double k = 1.0 / space->view->unit; /* a power of two: scaling is exact, and products stay in range */
    dd3 p = dd3_between(vec3_scale(k, b.point), vec3_scale(k, a.point));
    return dd3_add(p, dd3_from(vec3_scale(k, vec3_sub(b.low, a.low))));
}

static dd3 from_eye(const hide_space *space, seen_point a)
{
    return between(space, a, (seen_point){.point = space->view->viewpoint});
}

/* The sight plane through p and q. */
typedef struct sight_plane {
    seen_point P, Q;
    dd3 normal; /* perspective: (P - V) x (Q - V), the same for every X */
} sight_plane;

static sight_plane sight_plane_through(const hide_space *space, uint32_t p, uint32_t q)
{
    sight_plane s = {.P = vertex_point(space, p), .Q = vertex_point(space, q)};
    if (space->view->perspective)
        s.normal = dd3_cross(from_eye(space, s.P), from_eye(space, s.Q));
    return s;
}

/* Returns a multiple of the distance of X from the sight plane. The factor is positive and the same for every X. */
static dd side_determinant(const hide_space *space, const sight_plane *s, seen_point X)
{
    if (space->view->perspective)
        return dd_neg(dd3_dot(s->normal, from_eye(space, X)));
    return dd3_dot(dd3_cross(between(space, s->Q, s->P), between(space, X, s->P)), dd3_from(space->view->viewpoint));
}

/* The distance of x from the line through p and q in the picture, divided by the determinant. */
static double per_determinant(const hide_space *space, uint32_t p, uint32_t q, refine_point x)
{
    const view *v = space->view;
    double length = hypot(space->P[q].x - space->P[p].x, space->P[q].y - space->P[p].y);
    if (!v->perspective)
        return 1.0 / (v->viewpoint_depth * length);
    /* the picture's determinant of rows (x, y, 1) is that of rows (x, y, w), divided by the three w / D */
    const double z[] = {space->P[p].z, space->P[q].z, x.z};
    double scale = v->inverse_distance / length;
    for (int i = 0; i < 3; i++)
        scale *= 1.0 + z[i] * v->inverse_distance;
    return scale;
}

double refine_side(const hide_space *space, uint32_t p, uint32_t q, refine_point x)
{
    const sight_plane sight = sight_plane_through(space, p, q);
    return side_determinant(space, &sight, refine_place(space, x)).hi * per_determinant(space, p, q, x);
}

/* ---- the same in doubles ---- */

/* A vector in doubles, and the sizes of its components. Errors are fractions of these sizes. */
typedef struct near3 {
    roberts_vec3 is, size;
} near3;

/* Returns b - a in view units. Each component is off by at most two half epsilons of its size. */
static inline near3 gap(const hide_space *space, const seen_point *b, const seen_point *a)
{
    const double k = space->view->per_unit;
    roberts_vec3 high = vec3_scale(k, vec3_sub(b->point, a->point)), low = vec3_scale(k, vec3_sub(b->low, a->low));
    return (near3){vec3_add(high, low),
                   {fabs(high.x) + fabs(low.x), fabs(high.y) + fabs(low.y), fabs(high.z) + fabs(low.z)}};
}

/* The sight plane through P and Q: its normal is the ray through P times PQ. */
typedef struct near_plane {
    seen_point P;
    near3 normal;
} near_plane;

static near_plane plane_nearly(const hide_space *space, uint32_t p, uint32_t q)
{
    near_plane s = {.P = vertex_point(space, p)};
    const seen_point Q = vertex_point(space, q), eye = {.point = space->view->viewpoint};
    const near3 along = gap(space, &Q, &s.P);
    near3 ray = {eye.point, {fabs(eye.point.x), fabs(eye.point.y), fabs(eye.point.z)}};
    if (space->view->perspective)
        ray = gap(space, &eye, &s.P);
    s.normal.is = vec3_cross(ray.is, along.is);
    s.normal.size = (roberts_vec3){ray.size.y * along.size.z + ray.size.z * along.size.y,
                                   ray.size.z * along.size.x + ray.size.x * along.size.z,
                                   ray.size.x * along.size.y + ray.size.y * along.size.x};
    return s;
}

/* The same determinant as side_determinant() finds. */
static refine_near determinant_nearly(const hide_space *space, const near_plane *s, const seen_point *X)
{
    const near3 to = gap(space, X, &s->P);
    return (refine_near){vec3_dot(s->normal.is, to.is), REFINE_ROUNDINGS * vec3_dot(s->normal.size, to.size)};
}

refine_near refine_side_nearly(const hide_space *space, uint32_t p, uint32_t q, refine_point x)
{
    const near_plane s = plane_nearly(space, p, q);
    const seen_point X = refine_place(space, x);
    const refine_near d = determinant_nearly(space, &s, &X);
    const double scale = per_determinant(space, p, q, x);
    return (refine_near){d.value * scale, d.error * fabs(scale)};
}

/* In the picture, the distances of A and B from the line are these determinants times 1 / w, up to a common factor. */
bool refine_crossing_nearly(const hide_space *space, uint32_t p, uint32_t q, const hide_edge *e, double *t)
{
    const near_plane s = plane_nearly(space, p, q);
    const seen_point A = refine_place(space, refine_start(e)), B = refine_place(space, refine_end(e));
    const refine_near a = determinant_nearly(space, &s, &A), b = determinant_nearly(space, &s, &B);
    const double near_a = 1.0 + e->A.z * space->view->inverse_distance;
    const double near_b = 1.0 + e->B.z * space->view->inverse_distance;
    const double from = a.value * near_a, apart = from - b.value * near_b;
    *t = from / apart;
    return hide_accurate(space, e, (a.error * near_a + b.error * near_b) / fabs(apart));
}

static double to_picture(const hide_space *space, const hide_edge *e, double t)
{
    return view_from_space(space->view, e->A.z, e->B.z, t);
}

double refine_crossing(const hide_space *space, uint32_t p, uint32_t q, const hide_edge *e)
{
    const sight_plane sight = sight_plane_through(space, p, q);
    const dd a = side_determinant(space, &sight, refine_place(space, refine_start(e)));
    const dd b = side_determinant(space, &sight, refine_place(space, refine_end(e)));
    return to_picture(space, e, dd_zero_of(a, b));
}

double refine_pierce(const hide_space *space, const hide_face *F, const hide_edge *e)
{
    seen_point origin = vertex_point(space, F->corner[0]);
    seen_point A = refine_place(space, refine_start(e)), B = refine_place(space, refine_end(e));
    dd3 n = {{0, 0}, {0, 0}, {0, 0}}, sum = n; /* Newell's normal as a sum of triangles; the sum of the corners */
    for (uint32_t i = 0; i < F->count; i++) {
        dd3 p = between(space, vertex_point(space, F->corner[i]), origin);
        dd3 q = between(space, vertex_point(space, F->corner[(i + 1) % F->count]), origin);
        n = dd3_add(n, dd3_cross(p, q));
        sum = dd3_add(sum, p);
    }
    /* n . (X - mean of the corners), times the number of corners */
    dd count = {F->count, 0.0}, offset = dd3_dot(n, sum);
    dd a = dd_sub(dd_mul(count, dd3_dot(n, between(space, A, origin))), offset);
    dd b = dd_sub(dd_mul(count, dd3_dot(n, between(space, B, origin))), offset);
    return to_picture(space, e, dd_zero_of(a, b));
}

/* ---- the tests one by one ---------------------------------------------------------------------------------------- */

bool hide_sides_reserve(hide_sides *sides, size_t count)
{
    return array_reserve(&sides->H, &sides->room, count, sizeof *sides->H);
}

static inline int sign_within(double value, double tolerance)
{
    return value > tolerance ? 1 : value < -tolerance ? -1 : 0;
}

/* Bounds the error of a point's distance from the line through two others that are `length` apart. The point and both
 * ends of the line are off by the rounding of their coordinates. The error of the ends grows with the distance of the
 * point from them. */
static double line_error(const hide_space *space, double reach, double length)
{
    return 2.0 * space->across_rounding * (1.0 + reach / length);
}

/* TEST 1. Visible: both ends are in front of the face's plane or on it. `limit` is smaller than epsilon for a face so
 * small that its plane is uncertain at A and B. Such a face is left to the later tests, which use its plane only near
 * the face. Invisible: both ends clear the plane by twice the touching distance and that uncertainty. */
hide_verdict hide_test1(const hide_face *F, const hide_edge *e)
{
    double a = plane_at(F->F, e->A), b = plane_at(F->F, e->B), limit = (double)F->limit;
    double clear = 2.0 * F->touch + (F->touch - limit);
    if (a <= limit && b <= limit)
        return HIDE_VISIBLE;
    return a > clear && b > clear ? HIDE_INVISIBLE : HIDE_UNDECIDED;
}

/* Q(X) = 0 is the sight plane through AB. Q(X) is the distance from it, here times the length of AB. A corner whose
 * distance is uncertain counts as near. */
static inline int corner_side(const hide_space *space, roberts_vec3 P, const hide_edge *e, hide_near *near)
{
    double dx = e->B.x - e->A.x, dy = e->B.y - e->A.y, px = P.x - e->A.x, py = P.y - e->A.y, Q = dx * py - dy * px;
    if (!(fabs(Q) > space->plain)) {
        double error = line_error(space, fabs(px) + fabs(py), e->length);
        if (fabs(Q) <= (space->epsilon + error) * e->length) {
            near->doubtful = near->doubtful || error > HIDE_TRUSTED * space->epsilon;
            near->side = fabs(Q) <= error * e->length ? 0 : Q > 0.0 ? 1 : -1;
            near->count++;
            return 0;
        }
    }
    return Q > 0.0 ? 1 : -1;
}

int hide_corner_side(const hide_space *space, roberts_vec3 P, const hide_edge *e, hide_near *near)
{
    return corner_side(space, P, e, near);
}

/* TEST 2. An edge seen end-on has no sight plane. */
bool hide_test2(const hide_space *space, const hide_face *F, const hide_edge *e)
{
    hide_near near = {0};
    bool left = false, right = false;
    if (e->length <= space->epsilon)
        return false;
    for (uint32_t i = 0; i < F->count; i++) {
        int side = corner_side(space, space->P[F->corner[i]], e, &near);
        left = left || side > 0;
        right = right || side < 0;
        if (left && right)
            return false;
    }
    return hide_near_misses(&near, left);
}

/* A side, taken from its smaller vertex number to the larger, so that its two faces agree to the last bit: the
 * distances of A and B times its length, and bounds of their errors. */
typedef struct side_line {
    uint32_t p, q;
    double a, b, error_a, error_b, length;
    int direction; /* 1, or -1 if the face runs the other way */
} side_line;

static side_line measure_chord(const hide_space *space, const hide_face *F, hide_chord side, const hide_edge *e)
{
    uint32_t p = F->corner[side.first], q = F->corner[side.last];
    side_line s = {.p = p < q ? p : q, .q = p < q ? q : p, .direction = p < q ? 1 : -1};
    roberts_vec3 P = space->P[s.p], Q = space->P[s.q];
    double dx = Q.x - P.x, dy = Q.y - P.y, ax = e->A.x - P.x, ay = e->A.y - P.y, bx = e->B.x - P.x, by = e->B.y - P.y;
    s.length = sqrt(dx * dx + dy * dy);
    s.a = dx * ay - dy * ax;
    s.b = dx * by - dy * bx;
    s.error_a = hide_product_error(space, s.length, ax, ay);
    s.error_b = hide_product_error(space, s.length, bx, by);
    return s;
}

/* Returns the sign of an edge end's distance from a side. `h` is the distance times the side's length, with an error of
 * at most `error`. */
static int sign_closely(const hide_space *space, const side_line *s, refine_point x, double h, double error,
                        uint64_t *refined)
{
    if (error > HIDE_TRUSTED * space->epsilon * s->length && fabs(h) <= space->epsilon * s->length + error &&
        space->scene) {
        refine_near from = refine_side_nearly(space, s->p, s->q, x);
        if (!(from.error <= HIDE_TRUSTED * space->epsilon)) {
            from.value = refine_side(space, s->p, s->q, x);
            ++*refined;
        }
        h = from.value * s->length;
    }
    return s->direction * sign_within(h, space->epsilon * s->length);
}

/* Decides inside, on and outside of a side where the signs are not plain. All such signs are decided here. */
static hide_side look_closely(const hide_space *space, const hide_face *F, hide_chord side, const hide_edge *e,
                              uint64_t *refined)
{
    side_line s = measure_chord(space, F, side, e);
    /* A side no longer than epsilon is ignored: its neighbours bound the face to within epsilon. */
    if (s.length <= space->epsilon)
        return (hide_side){0, 0};
    hide_side H = {(signed char)sign_closely(space, &s, refine_start(e), s.a, s.error_a, refined),
                   (signed char)sign_closely(space, &s, refine_end(e), s.b, s.error_b, refined)};
    /* If one end is outside, the other counts as on the side only if it is not certainly inside, even by less than
     * epsilon: see hide_near_misses(). */
    if (H.a < 0 && H.b == 0 && s.direction * s.b > s.error_b)
        H.b = 1;
    if (H.b < 0 && H.a == 0 && s.direction * s.a > s.error_a)
        H.a = 1;
    return H;
}

/* TEST 3. A is left of the side from P to Q if AP x AQ > 0. */
hide_verdict hide_test3(const hide_space *space, const hide_face *F, const hide_edge *e, hide_sides *sides)
{
    bool inside = true;
    roberts_vec3 P = space->P[F->corner[0]];
    double apx = P.x - e->A.x, apy = P.y - e->A.y, bpx = P.x - e->B.x, bpy = P.y - e->B.y;
    for (uint32_t i = 0; i < F->count; i++) {
        roberts_vec3 Q = space->P[F->corner[i + 1 < F->count ? i + 1 : 0]];
        double aqx = Q.x - e->A.x, aqy = Q.y - e->A.y, bqx = Q.x - e->B.x, bqy = Q.y - e->B.y;
        double a = apx * aqy - apy * aqx, b = bpx * bqy - bpy * bqx;
        hide_side H;
        if (fabs(a) > space->plain && fabs(b) > space->plain)
            H = (hide_side){a > 0.0 ? 1 : -1, b > 0.0 ? 1 : -1};
        else
            H = look_closely(space, F, hide_side_of(F, i), e, &sides->refined);
        if (hide_side_outside(H))
            return HIDE_VISIBLE;
        inside = inside && H.a >= 0 && H.b >= 0;
        sides->H[i] = H;
        apx = aqx;
        apy = aqy;
        bpx = bqx;
        bpy = bqy;
    }
    return inside ? HIDE_INVISIBLE : HIDE_UNDECIDED;
}

/* Test 3 for one side. */
hide_side hide_side_signs(const hide_space *space, const hide_face *F, hide_chord side, const hide_edge *e,
                          uint64_t *refined)
{
    roberts_vec3 P = space->P[F->corner[side.first]], Q = space->P[F->corner[side.last]];
    double a = (P.x - e->A.x) * (Q.y - e->A.y) - (P.y - e->A.y) * (Q.x - e->A.x);
    double b = (P.x - e->B.x) * (Q.y - e->B.y) - (P.y - e->B.y) * (Q.x - e->B.x);
    if (fabs(a) > space->plain && fabs(b) > space->plain)
        return (hide_side){a > 0.0 ? 1 : -1, b > 0.0 ? 1 : -1};
    return look_closely(space, F, side, e, refined);
}

hide_crossing hide_cross_side(const hide_space *space, const hide_face *F, hide_chord side, const hide_edge *e)
{
    side_line s = measure_chord(space, F, side, e);
    double apart = fabs(s.a - s.b), error = (s.error_a + s.error_b) / apart;
    hide_crossing c = {.t = s.a / (s.a - s.b), .touch = space->epsilon * s.length / apart, .side = side};
    if (hide_accurate(space, e, error) || !space->scene)
        return c;
    roberts_vec3 P = space->P[s.p], Q = space->P[s.q];
    error = lesser(
        hide_crossing_error(space, e, c.t, (roberts_vec2){P.x, P.y}, (roberts_vec2){Q.x - P.x, Q.y - P.y}, apart),
        error);
    c.error = hide_accurate(space, e, error) ? 0.0 : error;
    return c;
}

/* Computes the crossing from the coordinates as read if its error is too large. */
static void refine_if_needed(const hide_cutting *c, hide_crossing *at)
{
    if (at->error == 0.0)
        return;
    uint32_t p = c->F->corner[at->side.first], q = c->F->corner[at->side.last];
    const uint32_t least = p < q ? p : q, most = p < q ? q : p;
    at->error = 0.0;
    if (refine_crossing_nearly(c->space, least, most, c->e, &at->t))
        return;
    at->t = refine_crossing(c->space, least, most, c->e);
    ++*c->refined;
}

/* Replaces *last by `at` if `at` comes later along the edge (direction 1) or earlier (-1). Crossings are refined only
 * if their order is uncertain. (A side parallel to AB gives NaN, which is uncertain.) */
static void keep_later(const hide_cutting *c, double direction, hide_crossing *last, hide_crossing at)
{
    double ahead = direction * (at.t - last->t), error = at.error + last->error;
    if (ahead <= -error)
        return;
    if (!(ahead > error)) {
        refine_if_needed(c, last);
        refine_if_needed(c, &at);
        ahead = direction * (at.t - last->t);
    }
    if (ahead > 0.0)
        *last = at;
}

bool hide_cut_by(const hide_cutting *c, hide_chord side, hide_side H, hide_cut *cut)
{
    hide_crossing at = hide_cross_side(c->space, c->F, side, c->e);
    if (H.a < 0)
        keep_later(c, 1.0, &cut->in, at);
    if (H.b < 0)
        keep_later(c, -1.0, &cut->out, at);
    return cut->in.t - cut->in.error < cut->out.t + cut->out.error;
}

/* Returns the parameter up to which the edge stays within epsilon of the border, from a crossing on. If there is no
 * crossing, that is the edge's end. */
static double reach_of(const hide_cutting *c, hide_crossing *at, bool out)
{
    if (reach_is_plain(c->space, c->e, at->touch))
        return out ? at->t + at->touch : at->t - at->touch;
    reach_border border = {c->F, at->side.first, at->side.last, out};
    return reach_along(c->space, c->e, &border, at->touch, &at->t);
}

bool hide_cut_end(const hide_cutting *c, hide_cut *cut, hide_interval *part)
{
    refine_if_needed(c, &cut->in);
    refine_if_needed(c, &cut->out);
    *part = (hide_interval){.t0 = cut->in.t, .t1 = cut->out.t};
    if (!hide_is_left(c->space, c->e, part))
        return false;
    double r0 = reach_of(c, &cut->in, false), r1 = reach_of(c, &cut->out, true);
    *part = (hide_interval){cut->in.t, cut->out.t, r0, r1};
    return hide_is_left(c->space, c->e, part);
}

/* TEST 4. t_i is the crossing of AB with side plane H_i. The last crossing inward and the first one outward lie on the
 * sides themselves (0 <= s_i <= 1), unless AB misses the face; then they come in the wrong order. So the s_i are not
 * needed, and at most two crossings need to be refined. */
bool hide_test4(const hide_space *space, const hide_face *F, const hide_edge *e, hide_sides *sides, hide_interval *part)
{
    hide_cutting c = {space, F, e, &sides->refined};
    hide_cut cut = hide_uncut;
    for (uint32_t i = 0; i < F->count; i++) {
        hide_side H = sides->H[i];
        if ((H.a < 0 || H.b < 0) && !hide_cut_by(&c, hide_side_of(F, i), H, &cut))
            return false;
    }
    return hide_cut_end(&c, &cut, part);
}

/* Returns the distance that counts as on the plane at X. It grows toward the eye: the nearest corner of a solid cut by
 * the near plane may be a thousand times as near as the rest. */
static double touch_at(const hide_space *space, const hide_face *F, roberts_vec3 X)
{
    if (F->departure <= 0.0f)
        return F->touch;
    return lesser(F->touch, space->epsilon + (double)F->departure * (1.0 + X.z * space->view->inverse_distance));
}

/* Returns where the reach must end: where F falls to -touch between t and r. F is `f` at t, and r is the end of the
 * reach so far. */
static double reach_behind(const hide_space *space, const hide_face *F, const hide_edge *e, double t, double f,
                           double r)
{
    double touch = touch_at(space, F, hide_edge_at(e, t)), end = plane_at(F->F, hide_edge_at(e, r));
    return end < -touch && f > end ? t + (r - t) * lesser((f + touch) / (f - end), 1.0) : r;
}

bool hide_pierce(const hide_space *space, const hide_face *F, const hide_edge *e, const hide_interval *inside,
                 hide_sides *sides, hide_interval *part)
{
    roberts_vec3 X0 = hide_edge_at(e, inside->t0), X1 = hide_edge_at(e, inside->t1);
    double f0 = plane_at(F->F, X0), f1 = plane_at(F->F, X1);
    double touch0 = touch_at(space, F, X0), touch1 = touch_at(space, F, X1);
    int sign0 = sign_within(f0, touch0), sign1 = sign_within(f1, touch1);
    if (sign0 <= 0 && sign1 <= 0)
        return false;
    double width = inside->t1 - inside->t0, slope = fabs(f0 - f1);
    if (sign0 >= 0)
        part->r0 = greater(part->r0, reach_behind(space, F, e, inside->t0, f0, inside->r0));
    if (sign1 >= 0)
        part->r1 = lesser(part->r1, reach_behind(space, F, e, inside->t1, f1, inside->r1));
    if (sign0 >= 0 && sign1 >= 0)
        return true;
    double t = inside->t0 + width * (f0 / (f0 - f1));
    if (!hide_accurate(space, e, width * PLANE_ROUNDINGS * space->rounding / slope) && space->scene) {
        t = fmin(fmax(refine_pierce(space, F, e), inside->t0), inside->t1);
        sides->refined++;
    }
    if (sign0 < 0) {
        part->t0 = greater(part->t0, t);
        part->r0 = greater(part->r0, t - width * touch0 / slope);
    } else {
        part->t1 = lesser(part->t1, t);
        part->r1 = lesser(part->r1, t + width * touch1 / slope);
    }
    return true;
}

/* Does an end of the edge count as on two sides? */
static bool is_on_two(const hide_face *F, const hide_sides *sides)
{
    unsigned a = 0, b = 0;
    for (uint32_t i = 0; i < F->count; i++) {
        a += sides->H[i].a == 0;
        b += sides->H[i].b == 0;
    }
    return a > 1 || b > 1;
}

/* Ends the part at the face's corners. Beyond a corner so sharp that the edge is within epsilon of both its sides,
 * nothing is inside. */
static bool end_at_corners(const hide_space *space, const hide_face *F, const hide_edge *e, const hide_sides *sides,
                           hide_interval *part)
{
    if (e->length <= space->epsilon || !is_on_two(F, sides))
        return true;
    reach_corners(space, e, F, part);
    return hide_is_left(space, e, part);
}

bool hide_by_sides(const hide_space *space, const hide_face *F, const hide_edge *e, hide_sides *sides,
                   hide_interval *part)
{
    switch (hide_test3(space, F, e, sides)) {
    case HIDE_VISIBLE:
        sides->tally.test3_visible++;
        return false;
    case HIDE_INVISIBLE:
        sides->tally.test3_invisible++;
        *part = hide_whole;
        return end_at_corners(space, F, e, sides, part);
    default:
        sides->tally.test4++;
        return hide_test4(space, F, e, sides, part) && end_at_corners(space, F, e, sides, part);
    }
}

/* ---- tests 2 to 4 in one pass: the parts that are rarely needed -------------------------------------------------- */

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

/* Decides signs that are not plain as look_closely() does. */
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
        double error = hide_product_error(space, length, X.x - o->ox[i], X.y - o->oy[i]);
        if (length <= space->epsilon)
            continue;
        if (error > HIDE_TRUSTED * on && fabs(h[i]) <= on + error)
            return FAST_UNCLEAR;
        out |= (h[i] < -on ? 1u : 0u) << i;
        touched += i < o->sides && fabs(h[i]) <= on;
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

/* Finds the crossing with side i as refine_if_needed() does. False: it needs double-double numbers. */
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
        double error_a = hide_product_error(space, length, e->A.x - ox, e->A.y - oy);
        double error_b = hide_product_error(space, length, e->B.x - ox, e->B.y - oy);
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
    if (!hide_is_left(space, e, part))
        return FAST_EMPTY;
    part->r0 = fast_reach(o, space, e, H, inward, &part->t0);
    part->r1 = fast_reach(o, space, e, H, outward, &part->t1);
    return hide_is_left(space, e, part) ? FAST_CUT : FAST_EMPTY;
}
