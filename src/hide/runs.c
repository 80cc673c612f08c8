/* runs.c - see runs.h. */
#include "hide/runs.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"

/* How far inside of the sides counts as well inside, in epsilons: sides that rise no steeper than the run's chord runs are at
 * 2.1 then. What is on a side, as the tests see it, is no farther from it than 1.125 (epsilon, and the HIDE_TRUSTED part of it
 * that the error of a distance may reach); half of one is for many.c; the rest is to spare. */
#define CLEAR 3.0
/* And for the rounding of corners, of the frame and of the point asked, in roundings: each coordinate of a corner and of the
 * point is off by one, in the frame by a root of two; turning to the frame adds less than one each. */
#define CLEAR_ROUNDINGS 16.0
/* A side of two corners that are off by that, in the direction of the chord and across it, has a slope off by no more than
 * this times rounding over its run, if that is large beside rounding. */
#define SLOPE_ROUNDINGS 12.0
#define SIDE_ROUNDINGS 32.0
/* By how much of epsilon the corners of a run may lie beside its chord that is to stand for it. */
#define STRAIGHT 0.1

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

static roberts_vec3 corner_at(const hide_space *space, const uint32_t *corner, uint32_t count, uint32_t i)
{
    return space->P[corner[i < count ? i : i - count]];
}

/* The frame, and the box of the corners first .. end in it. */
static runs_node frame_run(const hide_space *space, const uint32_t *corner, uint32_t count, uint32_t first,
                           uint32_t end)
{
    roberts_vec3 P = corner_at(space, corner, count, first), Q = corner_at(space, corner, count, end);
    double dx = Q.x - P.x, dy = Q.y - P.y, length = sqrt(dx * dx + dy * dy);
    runs_node n = {.x = P.x, .y = P.y, .ux = 1.0};
    if (length > 0.0) {
        n.ux = dx / length;
        n.uy = dy / length;
    }
    for (uint32_t i = first + 1; i <= end; i++) {
        Q = corner_at(space, corner, count, i);
        dx = Q.x - P.x;
        dy = Q.y - P.y;
        double x = n.ux * dx + n.uy * dy, y = n.ux * dy - n.uy * dx;
        n.x0 = lesser(n.x0, x);
        n.x1 = greater(n.x1, x);
        n.y0 = lesser(n.y0, y);
        n.y1 = greater(n.y1, y);
    }
    double beside = STRAIGHT * space->epsilon;
    n.straight =
        length > space->epsilon && n.y0 >= -beside && n.y1 <= beside && n.x0 >= -beside && n.x1 <= length + beside;
    return n;
}

/* Lifts the three lines over the side PQ; false where that is no graph of a line, or too steep or uncertain a one. A side no
 * longer than epsilon, which bounds nothing in the tests, is one of these. */
static bool lift_over(const hide_space *space, runs_node *n, roberts_vec3 P, roberts_vec3 Q)
{
    double dx = Q.x - P.x, dy = Q.y - P.y, run = n->ux * dx + n->uy * dy, rise = n->ux * dy - n->uy * dx;
    if (!(run > SIDE_ROUNDINGS * space->rounding) || !(run > space->epsilon))
        return false;
    double slope = rise / run, error = SLOPE_ROUNDINGS * space->rounding / run, low = slope - error;
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
        if (!lift_over(space, &n, corner_at(space, corner, count, i), corner_at(space, corner, count, i + 1)))
            n.over = INFINITY;
    n.over += CLEAR * space->epsilon + CLEAR_ROUNDINGS * space->rounding;
    return n;
}

runs *runs_make(const hide_space *space, const uint32_t *corner, uint32_t count)
{
    ranks over = ranks_over(count); /* a run of all sides would turn too much */
    runs *r = malloc(sizeof *r + over.start[over.count] * sizeof *r->node);
    if (!r)
        return NULL;
    r->ranks = over;
    for (int rank = 0; rank < (int)over.count; rank++)
        for (uint32_t side = 0, end; side < count; side = end) {
            end = ranks_end(&over, rank, side);
            r->node[ranks_node(&over, rank, side)] = make_run(space, corner, count, side, end);
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

bool runs_next(const runs *r, roberts_vec3 A, roberts_vec3 B, uint32_t *side, uint32_t *end, bool *straight)
{
    for (; *side < r->ranks.items; *side = *end) {
        int rank = ranks_highest(&r->ranks, *side);
        bool held = false;
        for (*straight = false; rank >= 0; rank--) {
            const runs_node *n = &r->node[ranks_node(&r->ranks, rank, *side)];
            held = runs_hold(n, A.x, A.y) && runs_hold(n, B.x, B.y);
            *straight = n->straight;
            if (held || *straight)
                break;
        }
        *end = ranks_end(&r->ranks, rank < 0 ? 0 : rank, *side);
        if (!held)
            return true;
    }
    return false;
}

bool runs_hold_point(const hide_space *space, const runs *r, const uint32_t *corner, double x, double y, double slack)
{
    roberts_vec3 X = {x, y, 0.0};
    bool straight;
    for (uint32_t i = 0, end; runs_next(r, X, X, &i, &end, &straight);)
        for (uint32_t next; i < end; i = next) {
            next = straight ? end : i + 1;
            if (!hide_side_holds(corner_at(space, corner, r->ranks.items, i),
                                 corner_at(space, corner, r->ranks.items, next), x, y, slack))
                return false;
        }
    return true;
}
