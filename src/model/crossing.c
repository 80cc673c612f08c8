/* crossing.c - see crossing.h.
 *
 * The two planes meet in a line, and each face contains spans of this line. A convex piece with corners on both sides
 * of the other plane contains one span. A piece may also have a side in the other plane. If that side is a cut between
 * two pieces of the face, one above the plane and one below, the face goes through the plane there. The faces cross
 * where their spans overlap. Points on the line are compared by the coordinate in which the line is longest. */
#include "model/crossing.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/box.h"
#include "base/sort.h"

/* ---- planes and signs -------------------------------------------------------------------------------------------- */

/* The largest error of a decision, as a fraction of the touching distance. */
#define TRUSTED 0.125

/* Vertex v as seen from a point, in the scene's unit. */
static roberts_vec3 seen_from(const crossing_rules *rules, uint32_t v, roberts_vec3 point, roberts_vec3 low)
{
    const roberts_scene *scene = rules->scene;
    roberts_vec3 d = vec3_sub(scene->point[v], point);
    if (scene->low)
        d = vec3_add(d, vec3_sub(scene->low[v], low));
    return vec3_scale(1.0 / scene->unit, d);
}

/* The same in double-double numbers. */
static dd3 exactly_seen_from(const crossing_rules *rules, uint32_t v, roberts_vec3 point, roberts_vec3 low)
{
    const roberts_scene *scene = rules->scene;
    double k = 1.0 / scene->unit; /* a power of two: scaling is exact */
    dd3 d = dd3_between(vec3_scale(k, scene->point[v]), vec3_scale(k, point));
    if (!scene->low)
        return d;
    return dd3_add(d, dd3_between(vec3_scale(k, scene->low[v]), vec3_scale(k, low)));
}

/* Adds one piece's part of the normal, of the sum of the corners, and of the error. */
static void add_piece_normal(const crossing_rules *rules, crossing_face *f, uint32_t piece, roberts_vec3 *sum)
{
    const roberts_scene *scene = rules->scene;
    uint32_t first = scene->face_start[piece], end = scene->face_start[piece + 1];
    roberts_vec3 P = seen_from(rules, scene->corner[end - 1], f->origin, f->low);
    for (uint32_t k = first; k < end; k++) {
        roberts_vec3 Q = seen_from(rules, scene->corner[k], f->origin, f->low);
        f->n = vec3_add(f->n, vec3_cross(P, Q));
        f->error += vec3_largest(P) * vec3_largest(Q);
        f->chord = greater(f->chord, vec3_largest(Q));
        *sum = vec3_add(*sum, Q);
        P = Q;
    }
}

static uint32_t corners_of(const crossing_rules *rules, const crossing_face *f)
{
    return rules->scene->face_start[f->end] - rules->scene->face_start[f->first];
}

/* Finds how far rounding may have turned the plane. */
static void find_turn(const crossing_rules *rules, crossing_face *f)
{
    const roberts_scene *scene = rules->scene;
    roberts_vec3 far = {0.0, 0.0, 0.0};
    for (uint32_t k = scene->face_start[f->first]; k < scene->face_start[f->end]; k++) {
        const roberts_vec3 d = seen_from(rules, scene->corner[k], f->origin, f->low);
        far = vec3_dot(d, d) > vec3_dot(far, far) ? d : far;
    }
    f->axis = vec3_scale(1.0 / vec3_length(far), far);
    f->turn = f->length * lesser(scene_turn(scene, f->first), SCENE_ROUNDED_BEND);
}

crossing_face crossing_face_of(const crossing_rules *rules, uint32_t body, uint32_t piece)
{
    const roberts_scene *scene = rules->scene;
    crossing_face f = {
        .body = body, .first = scene_first_piece(scene, body, piece), .end = scene_end_of_pieces(scene, body, piece)};
    roberts_vec3 sum = {0.0, 0.0, 0.0};
    uint32_t origin = scene->corner[scene->face_start[f.first]], count = corners_of(rules, &f);
    f.origin = scene->point[origin];
    if (scene->low)
        f.low = scene->low[origin];
    for (uint32_t k = f.first; k < f.end; k++)
        add_piece_normal(rules, &f, k, &sum);
    /* A coordinate of n is off by 6 + count halves of an ulp of the sum of its terms, at most twice f.error. A height
     * adds three such products and their sum. */
    f.error *= 2.0 * (40.0 + 3.0 * count) * 0x1p-53;
    f.mean = count > 3 ? vec3_dot(f.n, sum) / count : 0.0;
    f.length = vec3_length(f.n);
    const double deviation = scene_deviation(scene, f.first);
    f.bent = deviation > rules->touching;
    f.touch = f.length * (rules->touching + deviation) / scene->unit;
    if (scene_step(scene) > 0.0 && f.length > 0.0)
        find_turn(rules, &f);
    return f;
}

/* Fills in the normal in double-double numbers, once. */
static void refine_face(const crossing_rules *rules, crossing_face *f)
{
    const roberts_scene *scene = rules->scene;
    dd3 n = {{0, 0}, {0, 0}, {0, 0}}, sum = n;
    uint32_t count = corners_of(rules, f);
    for (uint32_t piece = f->first; piece < f->end; piece++) {
        uint32_t first = scene->face_start[piece], end = scene->face_start[piece + 1];
        dd3 P = exactly_seen_from(rules, scene->corner[end - 1], f->origin, f->low);
        for (uint32_t k = first; k < end; k++) {
            dd3 Q = exactly_seen_from(rules, scene->corner[k], f->origin, f->low);
            if (k > first || piece > f->first) /* else Q is the origin; P is handled likewise */
                n = dd3_add(n, dd3_cross(P, Q));
            if (count > 3)
                sum = dd3_add(sum, Q);
            P = Q;
        }
    }
    f->exact_n = n;
    f->exact_mean = count > 3 ? dd_div(dd3_dot(n, sum), (dd){count, 0.0}) : (dd){0.0, 0.0};
    f->refined = true;
}

/* Vertex v over the plane of f, in lengths of its n. */
static dd exact_height(const crossing_rules *rules, crossing_face *f, uint32_t v)
{
    if (!f->refined)
        refine_face(rules, f);
    return dd_sub(dd3_dot(f->exact_n, exactly_seen_from(rules, v, f->origin, f->low)), f->exact_mean);
}

/* The pieces of a face that are looked at: all, or those of crossing_limit(). */
static uint32_t piece_count(const crossing_face *f)
{
    return f->near ? f->near_count : f->end - f->first;
}

static uint32_t piece_at(const crossing_face *f, uint32_t k)
{
    return f->near ? f->near[k] : f->first + k;
}

static bool has_corner(const crossing_rules *rules, const crossing_face *f, uint32_t v)
{
    const uint32_t *start = rules->scene->face_start, *corner = rules->scene->corner;
    for (uint32_t n = 0; n < piece_count(f); n++)
        for (uint32_t k = start[piece_at(f, n)]; k < start[piece_at(f, n) + 1]; k++)
            if (corner[k] == v)
                return true;
    return false;
}

/* A corner's height over a plane. */
typedef struct corner_height {
    double h, error; /* in lengths of the plane's n */
    int sign;        /* 0: on it */
} corner_height;

/* How far the plane of f may have turned away at d, seen from its origin; in lengths of its n. */
static double turned_by(const crossing_face *f, roberts_vec3 d)
{
    return f->turn * vec3_length(vec3_sub(d, vec3_scale(vec3_dot(d, f->axis), f->axis)));
}

/* Vertex v, of `body`, over the plane of f. Whether it is a corner of f is asked only where that may matter, since f
 * may have thousands: if f is plane, none is farther off than f.touch and the error. */
static corner_height height_of(const crossing_rules *rules, crossing_face *f, uint32_t body, uint32_t v)
{
    roberts_vec3 d = seen_from(rules, v, f->origin, f->low);
    corner_height at = {.h = vec3_dot(f->n, d) - f->mean, .error = f->error * (vec3_largest(d) + f->chord)};
    const double touch = f->turn > 0.0 ? f->touch + turned_by(f, d) : f->touch;
    const bool clear = fabs(at.h) > at.error + touch;
    if (body == f->body && (!clear || f->bent) && has_corner(rules, f, v))
        return (corner_height){0.0, 0.0, 0};
    if (at.error > TRUSTED * f->touch && !clear) {
        at.h = exact_height(rules, f, v).hi;
        at.error = 0x1p-52 * fabs(at.h);
    }
    at.sign = (at.h > touch) - (at.h < -touch);
    return at;
}

/* The heights of a face's first corners. They are computed in order, once. */
#define KEPT_HEIGHTS 8
typedef struct kept_heights {
    corner_height at[KEPT_HEIGHTS];
    uint32_t count;
} kept_heights;

/* The height of v, corner k of a piece of `body`, over the plane of f. keep: NULL, or the heights of the piece. */
static inline corner_height kept_height(const crossing_rules *rules, crossing_face *f, uint32_t body, uint32_t v,
                                        uint32_t k, kept_heights *keep)
{
    if (!keep || k > keep->count || k >= KEPT_HEIGHTS)
        return height_of(rules, f, body, v);
    if (k == keep->count)
        keep->at[keep->count++] = height_of(rules, f, body, v);
    return keep->at[k];
}

/* Is pq, of `body`, a side of g, and no cut between its pieces? Both pieces at a cut have it as a side. */
static bool is_side_of(const crossing_rules *rules, const crossing_face *g, uint32_t body, uint32_t p, uint32_t q)
{
    const roberts_scene *scene = rules->scene;
    uint32_t count = 0;
    for (uint32_t n = 0; body == g->body && n < piece_count(g); n++) {
        const uint32_t first = scene->face_start[piece_at(g, n)], end = scene->face_start[piece_at(g, n) + 1];
        for (uint32_t k = first; k < end; k++)
            count += scene->corner[k] == p && (scene->corner[k == first ? end - 1 : k - 1] == q ||
                                               scene->corner[k + 1 == end ? first : k + 1] == q);
    }
    return count == 1;
}

/* Adds the position of one piece of f. keep: NULL, or the piece's heights over g. */
static void add_lie(const crossing_rules *rules, const crossing_face *f, uint32_t piece, crossing_face *g,
                    kept_heights *keep, crossing_lie *to)
{
    const roberts_scene *scene = rules->scene;
    uint32_t first = scene->face_start[piece], count = scene->face_start[piece + 1] - first;
    const uint32_t *corner = scene->corner + first;
    bool whole = !crossing_in_pieces(f), begins = false, before = false; /* the first and the last corner are on it */
    for (uint32_t k = 0; k < count && !(whole && to->over && to->under); k++) {
        int sign = kept_height(rules, g, f->body, corner[k], k, keep).sign;
        bool ends = begins && k + 1 == count && sign == 0; /* the side back to the first corner, too */
        to->over = to->over || sign > 0;
        to->under = to->under || sign < 0;
        if (sign == 0 && !to->side)
            to->side = (before && !is_side_of(rules, g, f->body, corner[k - 1], corner[k])) ||
                       (ends && !is_side_of(rules, g, f->body, corner[k], corner[0]));
        before = sign == 0;
        begins = k == 0 ? before : begins;
    }
}

static crossing_lie lie_of(const crossing_rules *rules, const crossing_face *f, crossing_face *g, kept_heights *keep)
{
    crossing_lie lie = {false, false, false};
    for (uint32_t k = 0; k < piece_count(f); k++)
        add_lie(rules, f, piece_at(f, k), g, crossing_in_pieces(f) ? NULL : keep, &lie);
    return lie;
}

crossing_lie crossing_lie_of(const crossing_rules *rules, const crossing_face *f, crossing_face *g)
{
    return lie_of(rules, f, g, NULL);
}

/* ---- places on the line ---------------------------------------------------------------------------------------- */

/* Two faces under test. */
typedef struct pair {
    const crossing_rules *rules;
    crossing_face *face[2];
    int axis;     /* in which their line is longest */
    double slack; /* the touching distance, as measured along the axis; in the scene's unit */
} pair;

/* A point where the border of one face meets the other plane. */
typedef struct cut {
    uint32_t p, q;   /* a corner, q: ROBERTS_NONE; or on the side from p to q */
    double t, off;   /* where on the side, in doubles, and the error of that */
    double s, error; /* the coordinate along the axis, from the first face's origin on */
    bool exact;      /* s is that of exact_place() */
} cut;

typedef struct span {
    cut low, high;
} span;

static double along(roberts_vec3 d, int axis)
{
    return axis == 0 ? d.x : axis == 1 ? d.y : d.z;
}

static dd exactly_along(dd3 d, int axis)
{
    return axis == 0 ? d.x : axis == 1 ? d.y : d.z;
}

static pair pair_of(const crossing_rules *rules, crossing_face *f, crossing_face *g)
{
    pair p = {rules, {f, g}, 0, 0.0};
    roberts_vec3 d = vec3_cross(f->n, g->n);
    double length = vec3_length(d);
    if (!(length > 1e-6 * f->length * g->length)) {
        if (!f->refined)
            refine_face(rules, f);
        if (!g->refined)
            refine_face(rules, g);
        dd3 e = dd3_cross(f->exact_n, g->exact_n);
        d = (roberts_vec3){e.x.hi, e.y.hi, e.z.hi};
        length = vec3_length(d);
    }
    p.axis = fabs(d.x) >= fabs(d.y) && fabs(d.x) >= fabs(d.z) ? 0 : fabs(d.y) >= fabs(d.z) ? 1 : 2;
    p.slack = rules->touching / rules->scene->unit * (length > 0.0 ? fabs(along(d, p.axis)) / length : 1.0);
    return p;
}

/* Does vertex p come before q in the order of x, y, z? */
static bool is_before(const roberts_scene *scene, uint32_t p, uint32_t q)
{
    int order = vec3_compare(scene->point[p], scene->point[q]);
    if (order == 0 && scene->low)
        order = vec3_compare(scene->low[p], scene->low[q]);
    return order != 0 ? order < 0 : p < q;
}

static cut corner_cut(const pair *w, uint32_t v)
{
    double s = along(seen_from(w->rules, v, w->face[0]->origin, w->face[0]->low), w->axis);
    return (cut){.p = v, .q = ROBERTS_NONE, .s = s, .error = 0x1p-50 * fabs(s)};
}

/* Where the side between p and q, at heights a and b of different signs, pierces the plane. */
static cut side_cut(const pair *w, uint32_t p, uint32_t q, corner_height a, corner_height b)
{
    if (!is_before(w->rules->scene, p, q)) {
        uint32_t v = p;
        corner_height h = a;
        p = q;
        q = v;
        a = b;
        b = h;
    }
    const crossing_face *base = w->face[0];
    double from = along(seen_from(w->rules, p, base->origin, base->low), w->axis);
    double to = along(seen_from(w->rules, q, base->origin, base->low), w->axis);
    double t = a.h / (a.h - b.h), off = 4.0 * ((a.error + b.error) / fabs(a.h - b.h) + 0x1p-50);
    return (cut){.p = p,
                 .q = q,
                 .t = t,
                 .off = off,
                 .s = from + t * (to - from),
                 .error = off * fabs(to - from) + 0x1p-50 * (fabs(from) + fabs(to))};
}

/* Where it is, in the scene's unit. other: the face in whose plane it lies. */
static dd3 exact_place(const crossing_rules *rules, const cut *c, crossing_face *other)
{
    const roberts_vec3 none = {0.0, 0.0, 0.0};
    dd3 at = exactly_seen_from(rules, c->p, none, none);
    if (c->q == ROBERTS_NONE)
        return at;
    dd a = exact_height(rules, other, c->p), t = dd_div(a, dd_sub(a, exact_height(rules, other, c->q)));
    roberts_vec3 low = rules->scene->low ? rules->scene->low[c->p] : none;
    dd3 way = exactly_seen_from(rules, c->q, rules->scene->point[c->p], low);
    return dd3_add(at, (dd3){dd_mul(t, way.x), dd_mul(t, way.y), dd_mul(t, way.z)});
}

/* other: as above */
static void refine_cut(const pair *w, cut *c, crossing_face *other)
{
    const crossing_face *base = w->face[0];
    double k = 1.0 / w->rules->scene->unit;
    if (c->exact)
        return;
    dd s = exactly_along(exact_place(w->rules, c, other), w->axis);
    s = dd_sub(s, (dd){k * along(base->origin, w->axis), 0.0});
    s = dd_sub(s, (dd){k * along(base->low, w->axis), 0.0});
    c->s = s.hi;
    c->error = 0x1p-52 * fabs(s.hi);
    c->exact = true;
}

/* How far a, on the border of face[i], lies after b, on the border of face[j]. If rounding could change whether they
 * touch, the answer is computed again in double-double numbers. */
static double after(const pair *w, cut *a, int i, cut *b, int j)
{
    double error = a->error + b->error;
    if (error > TRUSTED * w->slack && !(fabs(a->s - b->s) > w->slack + error)) {
        refine_cut(w, a, w->face[1 - i]);
        refine_cut(w, b, w->face[1 - j]);
    }
    return a->s - b->s;
}

/* The later or the earlier of two cuts: `a` on the border of face[0], `b` on the border of face[1]. If they touch, a
 * corner is preferred to a side. *of: the face whose border it is on. */
static cut chosen(const pair *w, cut *a, cut *b, bool later, int *of)
{
    double d = after(w, a, 0, b, 1);
    bool corners = (a->q == ROBERTS_NONE) != (b->q == ROBERTS_NONE) && fabs(d) <= w->slack;
    bool first = corners ? a->q == ROBERTS_NONE : later ? d >= 0.0 : d <= 0.0;
    *of = first ? 0 : 1;
    return first ? *a : *b;
}

/* On which sides of the other plane a piece lies. */
typedef struct contact {
    span on;
    uint32_t corners; /* on the plane */
    bool over, under;
    bool met; /* `on` is set */
} contact;

static void add_cut(const pair *w, int i, contact *c, cut at)
{
    if (!c->met || after(w, &at, i, &c->on.low, i) < 0.0)
        c->on.low = at;
    if (!c->met || after(w, &at, i, &c->on.high, i) > 0.0)
        c->on.high = at;
    c->met = true;
}

/* A piece of face[i]. keep: NULL, or its heights over the other face. */
static contact contact_of(const pair *w, int i, uint32_t piece, kept_heights *keep)
{
    const roberts_scene *scene = w->rules->scene;
    crossing_face *other = w->face[1 - i];
    uint32_t first = scene->face_start[piece], end = scene->face_start[piece + 1], p = scene->corner[end - 1];
    contact c = {0};
    const uint32_t body = w->face[i]->body;
    corner_height a = kept_height(w->rules, other, body, p, end - 1 - first, keep);
    for (uint32_t k = first; k < end; k++) {
        uint32_t q = scene->corner[k];
        corner_height b = kept_height(w->rules, other, body, q, k - first, keep);
        c.over = c.over || b.sign > 0;
        c.under = c.under || b.sign < 0;
        c.corners += b.sign == 0;
        if (b.sign == 0)
            add_cut(w, i, &c, corner_cut(w, q));
        else if (a.sign * b.sign < 0)
            add_cut(w, i, &c, side_cut(w, p, q, a, b));
        p = q;
        a = b;
    }
    return c;
}

/* ---- segments -------------------------------------------------------------------------------------------------- */

static crossing_point point_of(const pair *w, const cut *c, int of)
{
    const roberts_scene *scene = w->rules->scene;
    const roberts_vec3 none = {0.0, 0.0, 0.0};
    if (c->q == ROBERTS_NONE)
        return (crossing_point){scene->point[c->p], scene->low ? scene->low[c->p] : none, c->p};
    dd3 at = exact_place(w->rules, c, w->face[1 - of]);
    return (crossing_point){vec3_scale(scene->unit, (roberts_vec3){at.x.hi, at.y.hi, at.z.hi}),
                            vec3_scale(scene->unit, (roberts_vec3){at.x.lo, at.y.lo, at.z.lo}), ROBERTS_NONE};
}

/* Does P come after Q in the order of x, y, z? Coordinates within the touching distance count as equal, so that
 * rounding of the model does not reverse a line. */
static bool is_behind(const crossing_rules *rules, const crossing_point *P, const crossing_point *Q)
{
    roberts_vec3 d = vec3_add(vec3_sub(P->point, Q->point), vec3_sub(P->low, Q->low));
    double same = rules->touching;
    return fabs(d.x) > same ? d.x > 0.0 : fabs(d.y) > same ? d.y > 0.0 : d.z > 0.0;
}

/* Where a cut is, in model units, from doubles. False: the rounding may be large. An eighth of the touching distance is
 * for the error of t. The rest is for the low parts of the coordinates and for rounding, of at most 2 units of the last
 * place; the touching distance is no less than 16 of these. */
static bool find_place(const pair *w, const cut *c, roberts_vec3 *at)
{
    const roberts_scene *scene = w->rules->scene;
    *at = scene->point[c->p];
    if (c->q == ROBERTS_NONE)
        return true;
    roberts_vec3 side = vec3_sub(scene->point[c->q], *at);
    *at = vec3_add(*at, vec3_scale(c->t, side));
    return c->off * vec3_length(side) <= 0.5 * CROSSING_NEAR * w->rules->touching;
}

static bool is_unseen(const pair *w, const cut *low, const cut *high)
{
    roberts_vec3 A, B;
    return w->rules->unseen && find_place(w, low, &A) && find_place(w, high, &B) &&
           w->rules->unseen(w->rules->context, A, B);
}

/* Adds the overlap of two spans, one of each face, unless they only touch. False: no memory. */
static bool add_common(const pair *w, span *f, span *g, crossing_list *out)
{
    int of[2];
    cut low = chosen(w, &f->low, &g->low, true, &of[0]), high = chosen(w, &f->high, &g->high, false, &of[1]);
    if (!(after(w, &high, of[1], &low, of[0]) > w->slack) || is_unseen(w, &low, &high))
        return true;
    if (!array_reserve(&out->item, &out->room, out->count + 1, sizeof *out->item))
        return false;
    crossing_segment *s = &out->item[out->count++];
    *s = (crossing_segment){.body = {w->face[0]->body, w->face[1]->body},
                            .face = {w->face[0]->first, w->face[1]->first},
                            .edge = {ROBERTS_NONE, ROBERTS_NONE},
                            .end = {point_of(w, &low, of[0]), point_of(w, &high, of[1])}};
    if (is_behind(w->rules, &s->end[0], &s->end[1])) {
        crossing_point first = s->end[0];
        s->end[0] = s->end[1];
        s->end[1] = first;
    }
    return true;
}

/* ---- faces of several pieces ----------------------------------------------------------------------------------- */

typedef struct span_list {
    span *item;
    size_t count, room;
} span_list;

/* The spans of one face: inside its pieces, along sides of pieces that lie above or below the other plane, and along
 * edges of the file. */
typedef struct face_spans {
    span_list inside, over, under, edge;
} face_spans;

static bool add_span(const pair *w, int i, span_list *to, span on)
{
    if (!array_reserve(&to->item, &to->room, to->count + 1, sizeof *to->item))
        return false;
    refine_cut(w, &on.low, w->face[1 - i]);
    refine_cut(w, &on.high, w->face[1 - i]);
    to->item[to->count++] = on;
    return true;
}

static int compare_spans(const void *pa, const void *pb)
{
    const span *a = pa, *b = pb;
    if (a->low.s != b->low.s)
        return a->low.s < b->low.s ? -1 : 1;
    return (a->high.s > b->high.s) - (a->high.s < b->high.s);
}

/* Sorts spans and joins those that touch. */
static void unite(const pair *w, span_list *all)
{
    size_t to = 0;
    if (all->count > 1)
        qsort(all->item, all->count, sizeof *all->item, compare_spans);
    for (size_t k = 0; k < all->count; k++) {
        span s = all->item[k];
        if (to == 0 || s.low.s > all->item[to - 1].high.s + w->slack)
            all->item[to++] = s;
        else if (s.high.s > all->item[to - 1].high.s)
            all->item[to - 1].high = s.high;
    }
    all->count = to;
}

/* Adds to `inside` the parts that are in `over` and in `under`, but not in `edge`. All lists ascend. */
static bool add_cuts(const pair *w, int i, face_spans *s)
{
    for (size_t a = 0, b = 0; a < s->over.count && b < s->under.count;) {
        const span *f = &s->over.item[a], *g = &s->under.item[b];
        span both = {f->low.s > g->low.s ? f->low : g->low, f->high.s < g->high.s ? f->high : g->high};
        for (size_t e = 0; e < s->edge.count && both.high.s > both.low.s + w->slack; e++) {
            const span *edge = &s->edge.item[e];
            if (edge->high.s <= both.low.s || edge->low.s >= both.high.s)
                continue;
            if (edge->low.s > both.low.s + w->slack && !add_span(w, i, &s->inside, (span){both.low, edge->low}))
                return false;
            both.low = edge->high;
        }
        if (both.high.s > both.low.s + w->slack && !add_span(w, i, &s->inside, both))
            return false;
        if (f->high.s < g->high.s)
            a++;
        else
            b++;
    }
    return true;
}

/* An edge of face[i] as a span. */
static span edge_span(const pair *w, const uint32_t v[2])
{
    cut at[2] = {corner_cut(w, v[0]), corner_cut(w, v[1])};
    bool back = at[0].s > at[1].s;
    return (span){at[back], at[!back]};
}

static bool is_edge_in_plane(const crossing_rules *rules, uint32_t body, const uint32_t v[2], crossing_face *g)
{
    return height_of(rules, g, body, v[0]).sign == 0 && height_of(rules, g, body, v[1]).sign == 0;
}

/* Is the edge one of face f? */
static bool is_edge_of(const roberts_scene *scene, uint32_t e, const crossing_face *f)
{
    uint32_t room[2];
    const uint32_t *face;
    const uint32_t count = scene_faces_at(scene, f->body, e, room, &face);
    for (uint32_t k = 0; k < count; k++) {
        const uint32_t own = face[k] & ~MANY_TURNED;
        if (own >= f->first && own < f->end)
            return true;
    }
    return false;
}

/* Adds the edges of face[i] that lie in the other plane. They are few and seldom needed. */
static bool add_edges(const pair *w, int i, span_list *to)
{
    const roberts_scene *scene = w->rules->scene;
    const crossing_face *f = w->face[i];
    const scene_solid *own = &scene->solid[f->body];
    for (uint32_t e = own->edge; e < own[1].edge; e++) {
        const scene_edge edge = scene_edge_at(scene, f->body, e);
        if (scene->surface->edge_is[e] & EDGE_CUT || !is_edge_of(scene, e, f) ||
            !is_edge_in_plane(w->rules, f->body, edge.v, w->face[1 - i]))
            continue;
        if (!add_span(w, i, to, edge_span(w, edge.v)))
            return false;
    }
    unite(w, to);
    return true;
}

/* The spans of the line that face[i] contains. */
static bool find_spans(const pair *w, int i, face_spans *s)
{
    const crossing_face *f = w->face[i];
    for (uint32_t k = 0; k < piece_count(f); k++) {
        contact c = contact_of(w, i, piece_at(f, k), NULL);
        bool flat = !c.over && !c.under;
        if (c.over && c.under) {
            if (!add_span(w, i, &s->inside, c.on))
                return false;
        } else if (c.corners > 1 && crossing_in_pieces(f)) {
            if (((c.over || flat) && !add_span(w, i, &s->over, c.on)) ||
                ((c.under || flat) && !add_span(w, i, &s->under, c.on)))
                return false;
        }
    }
    unite(w, &s->over);
    unite(w, &s->under);
    if (s->over.count > 0 && s->under.count > 0 && !(add_edges(w, i, &s->edge) && add_cuts(w, i, s)))
        return false;
    unite(w, &s->inside);
    return true;
}

static void free_spans(face_spans *s)
{
    free(s->inside.item);
    free(s->over.item);
    free(s->under.item);
    free(s->edge.item);
}

static int compare_segments(const void *pa, const void *pb)
{
    const crossing_segment *a = pa, *b = pb;
    return vec3_compare(a->end[0].point, b->end[0].point);
}

static bool find_in_pieces(const pair *w, crossing_list *out)
{
    face_spans of[2] = {{{0}, {0}, {0}, {0}}, {{0}, {0}, {0}, {0}}};
    size_t first = out->count;
    bool enough = find_spans(w, 0, &of[0]) && find_spans(w, 1, &of[1]);
    span_list *f = &of[0].inside, *g = &of[1].inside;
    for (size_t a = 0, b = 0; enough && a < f->count && b < g->count;) {
        enough = add_common(w, &f->item[a], &g->item[b], out);
        if (f->item[a].high.s < g->item[b].high.s)
            a++;
        else
            b++;
    }
    if (out->count > first + 1)
        qsort(out->item + first, out->count - first, sizeof *out->item, compare_segments);
    free_spans(&of[0]);
    free_spans(&of[1]);
    return enough;
}

/* ---- many pieces ----------------------------------------------------------------------------------------------- */

/* A face of fewer pieces is looked at as a whole. */
#define MANY_PIECES 8
/* Planes count as parallel if the sine of their angle is less than this. */
#define PARALLEL 1e-6

/* Model units: how far apart points of two faces may be where the faces cross or touch. INFINITY: there is no bound.
 *
 * Such a point is in one plane, and within both touching distances of the other. So it is no farther from the line of
 * both planes than their sum over the sine of their angle. Two points belong together if they agree in the coordinate
 * in which that line is longest, which is at least 1 / sqrt(3) of its length. So they are less than 2 (1 + sqrt(3))
 * times as far apart. The rest is for rounding. */
static double near_margin(const crossing_rules *rules, const crossing_face *f, const crossing_face *g)
{
    const double sine = vec3_length(vec3_cross(f->n, g->n)) / (f->length * g->length);
    const double touch = ((f->touch + f->turn * f->chord) / f->length + (g->touch + g->turn * g->chord) / g->length) *
                         rules->scene->unit;
    return sine > PARALLEL ? 8.0 * touch / sine : INFINITY;
}

/* The box of vertices, wider by m. */
static box3 box_around(const roberts_scene *scene, const uint32_t *vertex, uint32_t count, double m)
{
    box3 box = box3_none;
    for (uint32_t k = 0; k < count; k++)
        box3_add(&box, scene->point[vertex[k]]);
    const roberts_vec3 margin = {m, m, m};
    return (box3){vec3_sub(box.lo, margin), vec3_add(box.hi, margin)};
}

/* The box of pieces first .. end - 1, wider by m. */
static box3 box_of_pieces(const roberts_scene *scene, uint32_t first, uint32_t end, double m)
{
    const uint32_t *start = scene->face_start;
    return box_around(scene, scene->corner + start[first], start[end] - start[first], m);
}

crossing_face *crossing_keep(crossing_kept *kept, const crossing_rules *rules, uint32_t body, uint32_t piece)
{
    if (kept->face.end == 0 || kept->face.first != scene_first_piece(rules->scene, body, piece)) {
        kept->face = crossing_face_of(rules, body, piece);
        kept->tree.node_count = kept->tree.item_count = 0;
    }
    kept->face.near = NULL;
    return &kept->face;
}

/* Makes the tree over the pieces of the face. False: no memory. */
static bool add_tree(crossing_kept *kept, const roberts_scene *scene)
{
    const crossing_face *f = &kept->face;
    uint32_t root;
    box3 *box = alloc_array(f->end - f->first, sizeof *box);
    for (uint32_t piece = f->first; box && piece < f->end; piece++)
        box[piece - f->first] = box_of_pieces(scene, piece, piece + 1, 0.0);
    const bool enough = box && box_tree_add(&kept->tree, box, f->end - f->first, f->first, &root) &&
                        array_reserve(&kept->near, &kept->near_room, f->end - f->first, sizeof *kept->near);
    free(box);
    return enough;
}

bool crossing_limit(crossing_kept *kept, const crossing_rules *rules, const crossing_face *other)
{
    const roberts_scene *scene = rules->scene;
    crossing_face *f = &kept->face;
    if (f->end - f->first < MANY_PIECES)
        return true;
    if (kept->tree.node_count == 0 && !add_tree(kept, scene))
        return false;
    const box3 box = box_of_pieces(scene, other->first, other->end, near_margin(rules, f, other));
    f->near_count = 0;
    box_search near = box_search_begin(&kept->tree, 0, &box);
    for (uint32_t piece; box_search_next(&near, &piece);) {
        const box3 own = box_of_pieces(scene, piece, piece + 1, 0.0);
        if (box3_meet(&own, &box))
            kept->near[f->near_count++] = piece;
    }
    if (f->near_count > 1)
        qsort(kept->near, f->near_count, sizeof *kept->near, compare_u32);
    f->near = kept->near;
    return true;
}

void crossing_kept_free(crossing_kept *kept)
{
    box_tree_free(&kept->tree);
    free(kept->near);
    *kept = (crossing_kept){0};
}

/* ---- two faces ------------------------------------------------------------------------------------------------- */

/* A side of f lies in the plane of g. False: no memory. */
static bool add_touch(const crossing_face *f, const crossing_face *g, crossing_list *out)
{
    if (!array_reserve(&out->touch, &out->touch_room, out->touch_count + 1, sizeof *out->touch))
        return false;
    out->touch[out->touch_count++] = (crossing_touch){{f->body, g->body}, {f->first, g->first}};
    return true;
}

/* The face with fewer corners is looked at first: it often decides, and the other may have thousands. */
bool crossing_find(const crossing_rules *rules, crossing_face *f, crossing_face *g, crossing_list *out)
{
    kept_heights over[2]; /* of f over g, and of g over f; not set, since the count says which are known */
    crossing_face *face[2] = {f, g};
    crossing_lie lie[2];
    over[0].count = over[1].count = 0;
    for (int k = 0, small = corners_of(rules, g) < corners_of(rules, f); k < 2; k++) {
        int i = k == 0 ? small : !small;
        lie[i] = lie_of(rules, face[i], face[1 - i], &over[i]);
        if (!(lie[i].over && lie[i].under) && !crossing_ends_on(lie[i]))
            return true; /* it lies in the other plane, or has at most a point or a common side there: nothing ends */
    }
    for (int i = 0; i < 2; i++)
        if (crossing_ends_on(lie[i]) && !add_touch(face[i], face[1 - i], out))
            return false;
    if (!(lie[0].over && lie[0].under && lie[1].over && lie[1].under))
        return true;
    pair w = pair_of(rules, f, g);
    if (crossing_in_pieces(f) || crossing_in_pieces(g))
        return find_in_pieces(&w, out);
    contact c = contact_of(&w, 0, f->first, &over[0]), d = contact_of(&w, 1, g->first, &over[1]);
    return add_common(&w, &c.on, &d.on, out);
}

/* ---- along edges ----------------------------------------------------------------------------------------------- */

bool crossing_find_in(const crossing_rules *rules, crossing_face *f, const uint32_t v[2], crossing_face *g,
                      crossing_list *out)
{
    if (!is_edge_in_plane(rules, f->body, v, g))
        return true;
    pair w = pair_of(rules, f, g);
    span edge = edge_span(&w, v);
    face_spans of = {{0}, {0}, {0}, {0}};
    bool enough = true;
    if (!crossing_in_pieces(g)) {
        contact c = contact_of(&w, 1, g->first, NULL);
        return !(c.over && c.under) || add_common(&w, &edge, &c.on, out);
    }
    enough = find_spans(&w, 1, &of);
    for (size_t k = 0; enough && k < of.inside.count; k++)
        enough = add_common(&w, &edge, &of.inside.item[k], out);
    free_spans(&of);
    return enough;
}

bool crossing_may_have_common(const crossing_rules *rules, const crossing_face *f, const uint32_t v[2],
                              const crossing_face *g, const uint32_t u[2])
{
    const box3 a = box_around(rules->scene, v, 2, near_margin(rules, f, g)), b = box_around(rules->scene, u, 2, 0.0);
    return box3_meet(&a, &b);
}

bool crossing_find_common(const crossing_rules *rules, crossing_face *f, const uint32_t v[2], crossing_face *g,
                          const uint32_t u[2], crossing_list *out)
{
    if (!is_edge_in_plane(rules, f->body, v, g) || !is_edge_in_plane(rules, g->body, u, f))
        return true;
    pair w = pair_of(rules, f, g);
    span a = edge_span(&w, v), b = edge_span(&w, u);
    return add_common(&w, &a, &b, out);
}

void crossing_list_free(crossing_list *list)
{
    free(list->item);
    free(list->touch);
    *list = (crossing_list){0};
}
