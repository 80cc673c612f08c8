/* stretch.c - checks one stretch of an edge by rays.
 *
 * These rays are cast:
 *
 * - from each stretch: `rays` of them near its ends and evenly between;
 * - from a visible stretch: one in the middle of the longest part that a face hides. A search along the stretch finds
 *   this part by the clipping of Cyrus and Beck, so nothing hidden is missed between two rays. The search may miss
 *   parts behind faces of very many corners; if there are any, up to three more rays are cast close to each end that
 *   lies within the edge;
 * - from a hidden stretch: a walk. A ray finds a face that hides the point. The next ray starts just beyond the part
 *   that this face hides, and so on to the end of the stretch. So the walk meets anything visible on the way;
 * - from the middle of a hidden stretch that names a solid: one that finds the face nearest to the viewer.
 *
 * Searches only choose where rays are cast; rays decide. A point that is certainly hidden but drawn visible contradicts
 * the drawing, and so does a point drawn hidden that is not even possibly hidden. Both are checked again by stricter
 * rules, with a neighbour on each side, and two of the three must agree: an edge that passes behind a mere corner is
 * hidden in a single point, which a drawing does not show. All other points are undecided. */
#include "ray/stretch.h"

#include <stdlib.h>

#include "base/array.h"

/* Fraction of the stretch: the distance of the first and the last of the even rays from its ends. */
#define END_MARGIN 0x1p-10
/* Fraction of the stretch: the distance of a ray's neighbours. */
#define NEIGHBOUR 0x1p-12
/* Touching distances: how close to an end, or to a change on a walk, a ray is cast ... */
#define CLOSE 64.0
/* ... and the least such distance as a fraction of the edge, ten times the error of a parameter t. */
#define CLOSE_PART 1e-9
/* Fraction of that distance: the distance of the neighbours of close rays. */
#define CLOSE_NEIGHBOUR 0.25
/* If a hider has at most this many faces, its other faces are tested too. */
#define FEW_FACES 12
/* After this many consecutive points behind one solid, a walk leaps. */
#define LEAP_AFTER 4
/* Fractions of the edge: further rays close to the ends of visible stretches. */
static const double end_parts[] = {1e-6, 1e-4};

typedef enum probe_kind {
    PROBE_POINT,  /* is the point drawn correctly? */
    PROBE_WALK,   /* the same, then continue along a hidden stretch */
    PROBE_NEAREST /* which solid is seen instead? */
} probe_kind;

/* A point of an edge to be checked. */
typedef struct stretch_probe {
    roberts_vec3 ends[2]; /* of the edge */
    uint32_t edge, drawn_by;
    roberts_state drawn;
    probe_kind kind;
    double t, step; /* its parameter, and the distance of its neighbours */
    double close;   /* rays are cast no closer to a change than this, in t */
    double end;     /* walk: where it ends */
    double stride;  /* walk: length of the next step if no face determines it */
    uint32_t solid; /* walk: the solid that hid the last point, */
    uint32_t same;  /* ... and the number of consecutive points before that */
    double leap;    /* walk: length of the next leap behind one solid, */
    double back;    /* ... and where to return if this leap fails; INFINITY: not a leap */
} stretch_probe;

struct stretch_checker {
    const occluders *o;
    uint32_t rays;
    stretch_result *result;
    uint32_t count;
    stretch_probe probe[TREE_POINTS]; /* [count] probes that wait for their rays */
    sight_question question[TREE_POINTS];
    tree_walk walk;
};

stretch_checker *stretch_checker_new(const occluders *o, uint32_t rays, stretch_result *result)
{
    stretch_checker *c = alloc_array(1, sizeof *c);
    if (!c)
        return NULL;
    c->o = o;
    c->rays = rays;
    c->result = result;
    c->count = 0;
    tree_walk_init(&c->walk, &o->t);
    return c;
}

static roberts_vec3 stretch_point(const roberts_vec3 ends[2], double t)
{
    return vec3_add(ends[0], vec3_scale(t, vec3_sub(ends[1], ends[0])));
}

/* ---- contradictions -------------------------------------------------------------------------------------------- */

/* Does the answer certainly contradict the drawing? */
static bool contradicts(const stretch_probe *p, const sight_question *q)
{
    return q->answer == (p->drawn == ROBERTS_HIDDEN ? SIGHT_NO : SIGHT_SURELY);
}

/* Do two of three points still contradict the drawing by the strict rules: the point and its neighbours on both
 * sides? */
static bool contradicts_strictly(stretch_checker *c, const stretch_probe *p, const sight_question *q)
{
    sight_question again[3] = {*q, *q, *q};
    again[1].X = stretch_point(p->ends, p->t - p->step);
    again[2].X = stretch_point(p->ends, p->t + p->step);
    for (int i = 0; i < 3; i++)
        again[i].ends = p->ends;
    occluders_cast(c->o, &c->walk, again, 3);
    return contradicts(p, &again[0]) + contradicts(p, &again[1]) + contradicts(p, &again[2]) >= 2;
}

/* Records a contradiction. by: a solid that hides the point; ROBERTS_NONE: the point is not hidden. */
static void contradict(stretch_result *out, const stretch_probe *p, uint32_t solid, roberts_state as, uint32_t by)
{
    roberts_contradiction what = {
        .solid = solid, .t = p->t, .drawn = p->drawn, .cast = as, .by = by, .drawn_by = p->drawn_by};
    if (array_reserve(&out->found, &out->room, out->count + 1, sizeof *out->found))
        out->found[out->count++] = (stretch_finding){what, p->edge};
    else
        out->lost = true;
}

/* Is the drawing right, as far as the ray shows? Counts undecided points, and records contradictions. */
static bool judge_point(stretch_checker *c, const stretch_probe *p, const sight_question *q)
{
    if (!contradicts(p, q)) {
        c->result->undecided += q->answer == SIGHT_POSSIBLY;
    } else if (contradicts_strictly(c, p, q)) {
        if (p->drawn == ROBERTS_VISIBLE)
            contradict(c->result, p, q->of.solid, ROBERTS_HIDDEN, c->o->face_solid[q->hider]);
        else
            contradict(c->result, p, q->of.solid, ROBERTS_VISIBLE, ROBERTS_NONE);
        return false;
    } else {
        c->result->undecided++;
    }
    return true;
}

/* ---- which solid is seen --------------------------------------------------------------------------------------- */

/* May a front face of `solid` lie on the sight line of X, no farther from the viewer than Y, which is on that line? A
 * face that touches Y counts. */
static bool may_be_seen(const occluders *o, uint32_t solid, const sight_question *q, roberts_vec3 Y)
{
    const roberts_scene *scene = o->s.scene;
    if (solid >= scene->solid_count)
        return false;
    roberts_vec3 v = sight_from(&o->s, q->X);
    double touch = sight_touch(&o->s, q->hider);
    double slack = solid == q->of.solid && scene_is_convex(scene, solid) ? o->slack[solid] : 0.0;
    for (uint32_t face = scene->solid[solid].face; face < scene->solid[solid + 1].face; face++)
        if (o->s.facing[face] != SIGHT_NOT_FRONT &&
            sight_behind(&o->s, face, Y) >= -SIGHT_MARGIN * (touch + sight_touch(&o->s, face)) &&
            sight_through(&o->s, face, q->X, v, slack) != SIGHT_NO)
            return true;
    return false;
}

/* Compares the named solid with the nearest one found. Near the border of the nearest face, another one may be seen. */
static void judge_nearest(stretch_checker *c, const stretch_probe *p, const sight_question *q)
{
    const occluders *o = c->o;
    if (q->answer != SIGHT_SURELY) {
        c->result->undecided += q->answer == SIGHT_POSSIBLY; /* other rays check whether it is hidden at all */
        return;
    }
    roberts_vec3 v = sight_from(&o->s, q->X), Y = sight_meet(&o->s, q->hider, q->X, v);
    if (o->face_solid[q->hider] == p->drawn_by || may_be_seen(o, p->drawn_by, q, Y))
        return;
    if (sight_well_through(&o->s, q->hider, q->X, v))
        contradict(c->result, p, q->of.solid, ROBERTS_HIDDEN, o->face_solid[q->hider]);
    else
        c->result->undecided++;
}

/* ---- walks ----------------------------------------------------------------------------------------------------- */

/* Returns the t up to which the face that hides the walk's point hides the edge; p->end: all the rest. If its solid has
 * few faces, the others are tested too, in the order of the file, which saves rays. */
static double hidden_until(const occluders *o, const stretch_probe *p, const sight_question *q)
{
    const scene_solid *solid = &o->s.scene->solid[o->face_solid[q->hider]];
    const roberts_vec3 end = stretch_point(p->ends, p->end);
    double touching = p->close / (p->end - p->t);
    sight_part all, part;
    if (!sight_hidden_part(&o->s, q->hider, q->X, end, &all))
        return p->t;
    if (all.t1 < 1.0 && solid[1].face - solid->face <= FEW_FACES)
        for (uint32_t face = solid->face; face < solid[1].face; face++)
            if (face != q->hider && occluders_take_part(o, &q->of, face) &&
                sight_hidden_part(&o->s, face, q->X, end, &part) && part.t0 <= all.t1 + touching)
                all.t1 = greater(all.t1, part.t1);
    return all.t1 >= 1.0 ? p->end : p->t + all.t1 * (p->end - p->t);
}

/* Leaps behind a solid of many faces, farther each time. The volume behind a convex solid is convex: if the solid hides
 * both ends of a leap, it hides everything between. */
static void leap(stretch_probe *p, double next)
{
    p->leap = greater(p->leap, 2.0 * (next - p->t));
    p->back = next;
    p->t = lesser(next + p->leap, p->end);
    p->leap *= 2.0;
}

/* Moves the walk to its next point; false at its end. Steps double in length while no face determines them. The last
 * step stops at the end itself. */
static bool walk_on(const occluders *o, stretch_probe *p, const sight_question *q)
{
    uint32_t solid = q->answer == SIGHT_SURELY ? o->face_solid[q->hider] : ROBERTS_NONE;
    bool leapt = p->back < INFINITY;
    if (leapt && solid != p->solid) {
        p->t = p->back;
        p->back = INFINITY;
        p->leap /= 8.0;
        p->same = 0;
        return true;
    }
    p->same = solid != ROBERTS_NONE && solid == p->solid ? p->same + 1 : 0;
    p->solid = solid;
    p->back = INFINITY;
    double until = solid != ROBERTS_NONE ? hidden_until(o, p, q) : p->t;
    if (p->t >= p->end || until >= p->end)
        return false;
    if (until > p->t + p->close) {
        p->stride = p->close;
        if (p->same >= LEAP_AFTER && scene_is_convex(o->s.scene, solid))
            leap(p, until + p->close);
        else
            p->t = until + p->close;
        return p->t < p->end || p->back < p->end;
    }
    p->t = lesser(p->t + p->stride, p->end);
    p->stride *= 2.0;
    return true;
}

/* ---- the queue ------------------------------------------------------------------------------------------------- */

/* Casts the rays of all waiting probes, and judges them. Walks that continue wait again. */
static void cast(stretch_checker *c)
{
    uint32_t count = c->count;
    c->count = 0;
    c->result->points += count;
    occluders_cast(c->o, &c->walk, c->question, count);
    for (uint32_t i = 0; i < count; i++) {
        stretch_probe *p = &c->probe[i];
        sight_question *q = &c->question[i];
        if (p->kind == PROBE_NEAREST) {
            judge_nearest(c, p, q);
        } else if (judge_point(c, p, q) && p->kind == PROBE_WALK && walk_on(c->o, p, q)) {
            q->X = stretch_point(p->ends, p->t);
            c->question[c->count] = *q;
            c->probe[c->count++] = *p;
        }
    }
}

void stretch_checker_finish(stretch_checker *c)
{
    while (c->count)
        cast(c);
    free(c);
}

static occluders_asker asker_of(const stretch *s)
{
    return (occluders_asker){s->solid, s->faces == STRETCH_BETWEEN || s->faces == STRETCH_BACK, s->own};
}

static void ask(stretch_checker *c, const stretch *s, const stretch_probe *p)
{
    while (c->count == TREE_POINTS)
        cast(c);
    c->probe[c->count] = *p;
    c->question[c->count++] =
        (sight_question){.X = stretch_point(p->ends, p->t), .of = asker_of(s), .nearest = p->kind == PROBE_NEAREST};
}

static void probe_point(stretch_checker *c, const stretch *s, stretch_probe *p, double t, double step)
{
    p->t = t;
    p->step = step;
    ask(c, s, p);
}

/* ---- a stretch ------------------------------------------------------------------------------------------------- */

/* Returns the position of point k of n within a stretch, 0 < position < 1. */
static double position(uint32_t k, uint32_t n)
{
    if (n == 1)
        return 0.5;
    if (k == 0 || k == n - 1)
        return k == 0 ? END_MARGIN : 1.0 - END_MARGIN;
    return (double)k / (n - 1);
}

/* Adds probes close to the ends that lie within the edge, to find a change that the drawing shows too early or too
 * late. */
static void probe_ends(stretch_checker *c, const stretch *s, stretch_probe *p)
{
    double at = p->close;
    for (size_t i = 0; 4.0 * at < s->t1 - s->t0; i++) {
        if (s->t0 > 0.0)
            probe_point(c, s, p, s->t0 + at, CLOSE_NEIGHBOUR * at);
        if (s->t1 < 1.0)
            probe_point(c, s, p, s->t1 - at, CLOSE_NEIGHBOUR * at);
        if (i == sizeof end_parts / sizeof end_parts[0])
            return;
        at = greater(at, end_parts[i]);
    }
}

/* Adds a probe in the middle of the longest part of a visible stretch that a face hides, if there is one. */
static void probe_hidden_part(stretch_checker *c, const stretch *s, stretch_probe *p)
{
    occluders_search search;
    sight_part part;
    uint32_t face;
    double width = s->t1 - s->t0, longest = 2.0 * p->close / width, middle = 0.0;
    roberts_vec3 A = stretch_point(p->ends, s->t0), B = stretch_point(p->ends, s->t1);
    occluders_search_start(&search, c->o, A, B, asker_of(s));
    while (occluders_search_next(&search, &face, &part))
        if (part.t1 - part.t0 > longest) {
            longest = part.t1 - part.t0;
            middle = 0.5 * (part.t0 + part.t1);
        }
    if (middle > 0.0)
        probe_point(c, s, p, s->t0 + middle * width, CLOSE_NEIGHBOUR * longest * width);
}

/* Adds evenly spaced probes. A walk goes from close to one end to close to the other, so it replaces the first and the
 * last. */
static void probe_evenly(stretch_checker *c, const stretch *s, stretch_probe *p, bool walk)
{
    double width = s->t1 - s->t0;
    for (uint32_t k = 0; k < c->rays; k++)
        if (!walk || c->rays == 1 || (k > 0 && k < c->rays - 1))
            probe_point(c, s, p, s->t0 + width * position(k, c->rays), NEIGHBOUR * width);
}

void stretch_check(stretch_checker *c, const stretch *s)
{
    stretch_probe p = {.ends = {s->A, s->B}, .edge = s->edge, .drawn_by = s->drawn_by, .drawn = s->drawn};
    double width = s->t1 - s->t0, touching = CLOSE * (c->o->s.loose + c->o->s.rounding);
    c->result->segments++;
    if (s->faces == STRETCH_UNSURE) {
        c->result->points += c->rays;
        c->result->undecided += c->rays;
        return;
    }
    p.close = greater(CLOSE_PART, touching / vec3_length(vec3_sub(s->B, s->A)));
    bool wide = 4.0 * p.close < width, walk = wide && s->drawn == ROBERTS_HIDDEN;
    probe_evenly(c, s, &p, walk);
    if (wide && !walk) {
        if (c->o->s.sampled)
            probe_ends(c, s, &p);
        probe_hidden_part(c, s, &p);
    }
    if (s->named) {
        p.kind = PROBE_NEAREST;
        probe_point(c, s, &p, s->t0 + 0.5 * width, 0.0);
    }
    if (walk) {
        p.kind = PROBE_WALK;
        p.stride = p.close;
        p.solid = ROBERTS_NONE;
        p.back = INFINITY;
        p.end = s->t1 - p.close;
        probe_point(c, s, &p, s->t0 + p.close, CLOSE_NEIGHBOUR * p.close);
    }
}

void stretch_is_clipped(stretch_checker *c, const stretch *s, double t)
{
    stretch_probe p = {.edge = s->edge, .drawn_by = s->drawn_by, .drawn = s->drawn, .t = t};
    contradict(c->result, &p, s->solid, ROBERTS_CLIPPED, ROBERTS_NONE);
}
