/* runs.c - runs of sides, and the tests with them. See runs.h. */
#include "hide/runs.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"

/* Room for sides that may cut something off. If more turn up, all sides are tested. Usually there are two and their
 * neighbours; on a straight border that is not one run, two times seven on each rank. */
#define CUTS 320
/* Guesses to try before all sides are tested. The second guess is what the first leaves; it is right except for
 * rounding. */
#define GUESSES 3

bool runs_table_init(runs_table *table, const uint32_t *corner, size_t count)
{
    *table = (runs_table){.corner = corner, .count = count / RUNS_CORNERS + 1};
    table->at = alloc_zeroed(table->count, sizeof(runs *));
    return table->at != NULL;
}

void runs_table_free(runs_table *table)
{
    for (size_t i = 0; table->at && i < table->count; i++)
        free(table->at[i]);
    free(table->at);
    *table = (runs_table){0};
}

static roberts_vec3 run_corner(const hide_space *space, const uint32_t *corner, uint32_t count, uint32_t i)
{
    return space->P[corner[i < count ? i : i - count]];
}

/* Sets the run's frame, and the box of corners first .. end in that frame. */
static runs_node frame_run(const hide_space *space, const uint32_t *corner, uint32_t count, uint32_t first,
                           uint32_t end)
{
    roberts_vec3 P = run_corner(space, corner, count, first), Q = run_corner(space, corner, count, end);
    double dx = Q.x - P.x, dy = Q.y - P.y, length = sqrt(dx * dx + dy * dy);
    runs_node n = {.x = P.x, .y = P.y, .ux = 1.0};
    if (length > 0.0) {
        n.ux = dx / length;
        n.uy = dy / length;
    }
    for (uint32_t i = first + 1; i <= end; i++) {
        Q = run_corner(space, corner, count, i);
        dx = Q.x - P.x;
        dy = Q.y - P.y;
        double x = n.ux * dx + n.uy * dy, y = n.ux * dy - n.uy * dx;
        n.x0 = lesser(n.x0, x);
        n.x1 = greater(n.x1, x);
        n.y0 = lesser(n.y0, y);
        n.y1 = greater(n.y1, y);
    }
    double beside = RUNS_STRAIGHT * space->epsilon;
    n.straight =
        length > space->epsilon && n.y0 >= -beside && n.y1 <= beside && n.x0 >= -beside && n.x1 <= length + beside;
    return n;
}

/* Raises the three bounding lines above the side PQ. False if PQ is not the graph of a line over the chord, if it is
 * too steep, or if its slope is too uncertain. Sides no longer than epsilon fail too; the tests ignore them. */
static bool lift_over(const hide_space *space, runs_node *n, roberts_vec3 P, roberts_vec3 Q)
{
    double dx = Q.x - P.x, dy = Q.y - P.y, run = n->ux * dx + n->uy * dy, rise = n->ux * dy - n->uy * dx;
    if (!(run > RUNS_SIDE_ROUNDINGS * space->across_rounding) || !(run > space->epsilon))
        return false;
    double slope = rise / run, error = RUNS_SLOPE_ROUNDINGS * space->across_rounding / run, low = slope - error;
    double high = slope + error, px = P.x - n->x, py = P.y - n->y;
    double x = n->ux * px + n->uy * py, y = n->ux * py - n->uy * px;
    if (low < -1.0 || high > 1.0)
        return false;
    n->low = lesser(n->low, low);
    n->high = greater(n->high, high);
    n->over = greater(n->over, greater(y - low * (x - n->x0), y - high * (x - n->x0)));
    n->over = greater(n->over, greater(y + low * (n->x1 - x), y + high * (n->x1 - x)));
    return true;
}

static runs_node make_run(const hide_space *space, const uint32_t *corner, uint32_t count, uint32_t first, uint32_t end)
{
    runs_node n = frame_run(space, corner, count, first, end);
    n.over = -INFINITY;
    for (uint32_t i = first; i < end && n.over < INFINITY; i++)
        if (!lift_over(space, &n, run_corner(space, corner, count, i), run_corner(space, corner, count, i + 1)))
            n.over = INFINITY;
    n.over += RUNS_CLEAR * space->epsilon + RUNS_CLEAR_ROUNDINGS * space->across_rounding;
    return n;
}

runs *runs_make(const hide_space *space, const uint32_t *corner, uint32_t count)
{
    list_tree over = list_tree_over(count); /* no run of all sides: it would turn too far */
    runs *r = malloc(sizeof *r + over.start[over.ranks] * sizeof *r->node);
    if (!r)
        return NULL;
    r->tree = over;
    for (int rank = 0; rank < (int)over.ranks; rank++)
        for (uint32_t side = 0, end; side < count; side = end) {
            end = list_tree_end(&over, rank, side);
            r->node[list_tree_node(&over, rank, side)] = make_run(space, corner, count, side, end);
        }
    return r;
}

bool runs_enter(runs_table *table, const hide_space *space, const uint32_t *corner, uint32_t count)
{
    if (count <= RUNS_CORNERS || !table->at)
        return true;
    runs **at = &table->at[(size_t)(corner - table->corner) / RUNS_CORNERS];
    *at = runs_make(space, corner, count);
    return *at != NULL;
}

/* Is the point inside all sides of the run by more than the touching distance? */
static inline bool runs_hold(const runs_node *n, double px, double py)
{
    double dx = px - n->x, dy = py - n->y, x = n->ux * dx + n->uy * dy, y = n->ux * dy - n->uy * dx;
    return y >= n->over && y >= n->over + n->low * (x - n->x0) && y >= n->over + n->high * (x - n->x1);
}

/* Finds the next run, from *side on, that does not hold both points. It is a straight run or one of the shortest, and
 * becomes *side .. *end - 1. False: the rest hold both. */
static bool runs_next(const runs *r, roberts_vec3 A, roberts_vec3 B, uint32_t *side, uint32_t *end, bool *straight)
{
    for (; *side < r->tree.items; *side = *end) {
        int rank = list_tree_highest(&r->tree, *side);
        bool held = false;
        for (*straight = false; rank >= 0; rank--) {
            const runs_node *n = &r->node[list_tree_node(&r->tree, rank, *side)];
            held = runs_hold(n, A.x, A.y) && runs_hold(n, B.x, B.y);
            *straight = n->straight;
            if (held || *straight)
                break;
        }
        *end = list_tree_end(&r->tree, rank < 0 ? 0 : rank, *side);
        if (!held)
            return true;
    }
    return false;
}

bool runs_hold_point(const hide_space *space, const runs *r, const uint32_t *corner, roberts_vec2 X, double slack)
{
    const roberts_vec3 at = {X.x, X.y, 0.0};
    bool straight;
    for (uint32_t i = 0, end; runs_next(r, at, at, &i, &end, &straight);)
        for (uint32_t next; i < end; i = next) {
            next = straight ? end : i + 1;
            if (!hide_side_holds(run_corner(space, corner, r->tree.items, i),
                                 run_corner(space, corner, r->tree.items, next), X, slack, space->epsilon))
                return false;
        }
    return true;
}

/* ---- tests 2 to 4 ------------------------------------------------------------------------------------------------ */

/* An edge against a polygon. */
typedef struct sight {
    const hide_space *space;
    const runs *r;
    const hide_face *F;
    const hide_edge *e;
    uint32_t left, right; /* a corner on that side of the sight plane; ROBERTS_NONE: none found */
    hide_near near;       /* corners that count as near the sight plane */
} sight;

/* Finds the side of the sight plane on which the box of a run's corners lies: 1 left, -1 right, 0 uncertain. A result
 * of 1 or -1 means that no corner of the run counts as near (see hide_corner_side()). The bound has four times the
 * rounding used there, far more than the error of the box and of the corners. */
static int run_side(const hide_space *space, const runs_node *n, const hide_edge *e)
{
    double dx = e->B.x - e->A.x, dy = e->B.y - e->A.y, px = n->x - e->A.x, py = n->y - e->A.y, Q = dx * py - dy * px;
    double along = dx * n->uy - dy * n->ux, across = dx * n->ux + dy * n->uy;
    double a0 = along * n->x0, a1 = along * n->x1, b0 = across * n->y0, b1 = across * n->y1;
    double reach = fabs(px) + fabs(py) + 2.0 * (n->x1 - n->x0 + n->y1 - n->y0);
    double near = space->epsilon * e->length + 8.0 * space->across_rounding * (e->length + reach);
    if (Q + lesser(a0, a1) + lesser(b0, b1) > near)
        return 1;
    return Q + greater(a0, a1) + greater(b0, b1) < -near ? -1 : 0;
}

static int corner_side(const sight *s, uint32_t i, hide_near *near)
{
    return hide_corner_side(s->space, s->space->P[s->F->corner[i]], s->e, near);
}

static void record_side(sight *s, uint32_t corner, int side)
{
    if (side > 0)
        s->left = corner;
    else if (side < 0)
        s->right = corner;
}

/* Test 2. */
static bool misses(sight *s)
{
    const list_tree *over = &s->r->tree;
    if (s->e->length <= s->space->epsilon)
        return false;
    for (uint32_t i = 0; i < over->items && (s->left == ROBERTS_NONE || s->right == ROBERTS_NONE);) {
        int rank = list_tree_highest(over, i), side = 0;
        bool passed = false; /* once two corners are near the sight plane, the rest of a straight run adds nothing */
        for (; rank >= 0 && !side && !passed; rank--) {
            const runs_node *n = &s->r->node[list_tree_node(over, rank, i)];
            side = run_side(s->space, n, s->e);
            passed = s->near.count > 1 && n->straight;
        }
        uint32_t end = list_tree_end(over, side || passed ? rank + 1 : 0, i);
        if (side)
            record_side(s, i, side);
        for (; !side && !passed && i < end; i++)
            record_side(s, i, corner_side(s, i, &s->near));
        i = end;
    }
    if (s->left != ROBERTS_NONE && s->right != ROBERTS_NONE)
        return false;
    return hide_near_misses(&s->near, s->left != ROBERTS_NONE);
}

/* Finds a side between corner `from` and corner `to`, which lie on different sides of the sight plane, that crosses the
 * plane. `side` is the side on which `from` lies. */
static uint32_t side_between(const sight *s, uint32_t from, uint32_t to, int side)
{
    uint32_t count = s->r->tree.items, low = 0, high = to > from ? to - from : count - from + to;
    hide_near near = {0}; /* not used here */
    while (high - low > 1) {
        uint32_t middle = low + (high - low) / 2, i = middle < count - from ? from + middle : middle - (count - from);
        if (corner_side(s, i, &near) == side)
            low = middle;
        else
            high = middle;
    }
    return low < count - from ? from + low : low - (count - from);
}

/* Returns the parameter where the edge crosses side i if the side cuts something off (`outside`), clamped to the edge;
 * otherwise the edge's `end`. */
static double guess(const sight *s, uint32_t i, bool outside, double end)
{
    double t = outside ? hide_cross_side(s->space, s->F, hide_side_of(s->F, i), s->e).t : end;
    return t > 0.0 ? lesser(t, 1.0) : 0.0;
}

/* Makes the first guess. False if A and B are both outside or on one of the two sides that the guess uses. The polygon
 * runs counter-clockwise, so its border passes from left to right where the edge enters. */
static bool first_guess(const sight *s, hide_sides *sides, double *s0, double *s1)
{
    *s0 = 0.0;
    *s1 = 1.0;
    if (s->left == ROBERTS_NONE || s->right == ROBERTS_NONE)
        return true;
    uint32_t in = side_between(s, s->left, s->right, 1), out = side_between(s, s->right, s->left, -1);
    hide_side I = hide_side_signs(s->space, s->F, hide_side_of(s->F, in), s->e, &sides->refined);
    hide_side O = hide_side_signs(s->space, s->F, hide_side_of(s->F, out), s->e, &sides->refined);
    *s0 = guess(s, in, I.a < 0, 0.0);
    *s1 = guess(s, out, O.b < 0, 1.0);
    return !hide_side_outside(I) && !hide_side_outside(O);
}

/* Sides that cut something off; a straight run is represented by its chord. */
typedef struct cuts {
    hide_chord side[CUTS];
    uint32_t count;
    hide_side H[CUTS];
} cuts;

/* Test 3 for the sides that the guess does not rule out. Returns HIDE_INVISIBLE if none of them cuts anything off. If
 * there are more than CUTS, c->count exceeds CUTS. */
static hide_verdict test_sides(const sight *s, hide_sides *sides, double s0, double s1, cuts *c)
{
    roberts_vec3 from = hide_edge_at(s->e, s0), to = hide_edge_at(s->e, s1);
    bool straight;
    c->count = 0;
    for (uint32_t i = 0, end; runs_next(s->r, from, to, &i, &end, &straight);)
        for (uint32_t next; i < end; i = next) {
            next = straight ? end : i + 1;
            hide_chord side = {i, next < s->F->count ? next : 0};
            hide_side H = hide_side_signs(s->space, s->F, side, s->e, &sides->refined);
            if (hide_side_outside(H))
                return HIDE_VISIBLE;
            if (H.a >= 0 && H.b >= 0)
                continue;
            if (c->count++ == CUTS)
                return HIDE_UNDECIDED;
            c->side[c->count - 1] = side;
            c->H[c->count - 1] = H;
        }
    return c->count ? HIDE_UNDECIDED : HIDE_INVISIBLE;
}

/* Test 4 for these sides. */
static bool cut_by(const sight *s, hide_sides *sides, const cuts *c, hide_interval *part)
{
    hide_cutting cutting = {s->space, s->F, s->e, &sides->refined};
    hide_cut cut = hide_uncut;
    for (uint32_t k = 0; k < c->count; k++)
        if (!hide_cut_by(&cutting, c->side[k], c->H[k], &cut))
            return false;
    return hide_cut_end(&cutting, &cut, part);
}

/* Tests 3 and 4 by guesses. False: all sides must be tested. If `*verdict` is HIDE_UNDECIDED, test 4 has found `part`,
 * which is empty if nothing is left. */
static bool by_guesses(const sight *s, hide_sides *sides, hide_verdict *verdict, hide_interval *part)
{
    double s0, s1, accuracy = RUNS_GUESS_ACCURACY * s->space->epsilon / s->e->length;
    cuts c;
    *verdict = HIDE_VISIBLE;
    if (!first_guess(s, sides, &s0, &s1))
        return true;
    for (int k = 0; k < GUESSES; k++) {
        *verdict = test_sides(s, sides, s0, s1, &c);
        if (*verdict == HIDE_VISIBLE)
            return true;
        if (c.count > CUTS)
            return false;
        *part = hide_whole;
        if (*verdict == HIDE_UNDECIDED && !cut_by(s, sides, &c, part)) {
            part->t0 = part->t1;
            return true;
        }
        if (part->t0 >= s0 - accuracy && part->t1 <= s1 + accuracy)
            return true;
        s0 = part->t0;
        s1 = part->t1;
    }
    return false;
}

bool hide_by_runs(const hide_space *space, const runs *r, const hide_face *F, const hide_edge *e, hide_sides *sides,
                  hide_interval *part)
{
    sight s = {.space = space, .r = r, .F = F, .e = e, .left = ROBERTS_NONE, .right = ROBERTS_NONE};
    hide_verdict verdict;
    if (misses(&s)) {
        sides->tally.test2_visible++;
        return false;
    }
    if (!by_guesses(&s, sides, &verdict, part))
        return hide_by_sides(space, F, e, sides, part);
    sides->tally.test3_visible += verdict == HIDE_VISIBLE;
    sides->tally.test3_invisible += verdict == HIDE_INVISIBLE;
    sides->tally.test4 += verdict == HIDE_UNDECIDED;
    return verdict != HIDE_VISIBLE && part->t0 < part->t1;
}
