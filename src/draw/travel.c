/* travel.c - the order in which polylines are drawn.
 *
 * First, the pen always goes to the nearest remaining end. Ends lie in a grid. Coarser grids over it count the
 * remaining ends, so that searching empty parts takes no longer: if the nine cells around the pen are empty, the nine
 * of the next coarser grid are searched, and so on. Then the search goes down again, each time to the cell nearest to
 * the pen. It finds a near end, though not always the nearest.
 *
 * Then 2-opt (G. A. Croes, "A method for solving traveling-salesman problems", Operations Research 6(6), 1958): all
 * polylines between two moves of the lifted pen are drawn backward if that shortens these moves. All searches are
 * bounded by counts, so that the result is the same on any machine. */
#include "draw/travel.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/vec.h"

enum {
    ENDS_PER_CELL = 2,
    LEVELS_MAX = 34,     /* a grid has fewer than 2^33 columns */
    LOOK_IN_CELL = 64,   /* most ends of a cell that are examined; if there are more, they are all close together */
    PASSES_MAX = 20,     /* of 2-opt */
    BACKWARD_MAX = 1000, /* most polylines turned at once, in a tour of more than SMALL */
    SMALL = 20000
};

/* Bounds of 2-opt as a whole: on the ends compared and on the polylines turned. */
static const uint64_t compared_most = 12000000, turned_most = 50000000;

#define NO_END UINT32_MAX

/* Ends are numbered 2 i and 2 i + 1: where polyline i starts and where it ends. */
typedef struct tour {
    uint32_t count; /* polylines */
    page_point *at; /* [2 count] the ends */
    /* the grid */
    double cell, x0, y0;
    uint32_t nx[LEVELS_MAX], ny[LEVELS_MAX], levels;
    uint32_t *left[LEVELS_MAX]; /* how many ends remain in each cell; each level has half the columns and rows */
    uint32_t *start;            /* [cells of level 0 + 1] into `end` */
    uint32_t *end;              /* [2 count] ends by cell, in each cell those left first */
    uint32_t *slot;             /* [2 count] where in `end` an end is */
    page_point *spot;           /* [2 count] the points of `end`: a cell's lie side by side in memory */
    /* the result */
    uint32_t *entry;           /* [count] the end at which the k-th polyline begins; its other end is entry ^ 1 */
    uint32_t *position;        /* [count] of a polyline in `entry` */
    uint64_t compared, turned; /* by 2-opt so far */
} tour;

/* ---- the grid ---- */

static uint32_t column_of(const tour *t, page_point p)
{
    double c = (p.x - t->x0) / t->cell; /* the cast rounds downward */
    return c < 0.0 ? 0 : c >= t->nx[0] ? t->nx[0] - 1 : (uint32_t)c;
}

static uint32_t tour_row(const tour *t, page_point p)
{
    double r = (p.y - t->y0) / t->cell;
    return r < 0.0 ? 0 : r >= t->ny[0] ? t->ny[0] - 1 : (uint32_t)r;
}

static size_t tour_cell(const tour *t, page_point p)
{
    return (size_t)tour_row(t, p) * t->nx[0] + column_of(t, p);
}

/* Chooses the size of the square cells: ENDS_PER_CELL ends to each if they are spread evenly. In a narrow box there
 * are no more cells than that. */
static void set_grid(tour *t)
{
    double x1 = -INFINITY, y1 = -INFINITY;
    t->x0 = t->y0 = INFINITY;
    for (uint32_t i = 0; i < 2 * t->count; i++) {
        t->x0 = lesser(t->x0, t->at[i].x);
        t->y0 = lesser(t->y0, t->at[i].y);
        x1 = greater(x1, t->at[i].x);
        y1 = greater(y1, t->at[i].y);
    }
    double w = x1 - t->x0 + 1.0, h = y1 - t->y0 + 1.0, cells = 1.0 + 2.0 * t->count / ENDS_PER_CELL;
    t->cell = greater(sqrt(w * h / cells), greater(w, h) / cells);
    t->nx[0] = 1 + (uint32_t)(w / t->cell);
    t->ny[0] = 1 + (uint32_t)(h / t->cell);
    t->levels = 1;
    while (t->levels < LEVELS_MAX && (t->nx[t->levels - 1] > 1 || t->ny[t->levels - 1] > 1)) {
        t->nx[t->levels] = (t->nx[t->levels - 1] + 1) / 2;
        t->ny[t->levels] = (t->ny[t->levels - 1] + 1) / 2;
        t->levels++;
    }
}

static bool fill_grid(tour *t)
{
    size_t cells = (size_t)t->nx[0] * t->ny[0];
    for (uint32_t l = 0; l < t->levels; l++)
        if (!(t->left[l] = alloc_zeroed((size_t)t->nx[l] * t->ny[l], sizeof **t->left)))
            return false;
    t->start = alloc_zeroed(cells + 1, sizeof *t->start);
    t->end = alloc_array(t->count, 2 * sizeof *t->end);
    t->slot = alloc_array(t->count, 2 * sizeof *t->slot);
    t->spot = alloc_array(t->count, 2 * sizeof *t->spot);
    if (!t->start || !t->end || !t->slot || !t->spot)
        return false;
    for (uint32_t i = 0; i < 2 * t->count; i++) {
        uint32_t x = column_of(t, t->at[i]), y = tour_row(t, t->at[i]);
        t->start[tour_cell(t, t->at[i]) + 1]++;
        for (uint32_t l = 0; l < t->levels; l++)
            t->left[l][(size_t)(y >> l) * t->nx[l] + (x >> l)]++;
    }
    for (size_t c = 0; c < cells; c++)
        t->start[c + 1] += t->start[c];
    for (uint32_t i = 0; i < 2 * t->count; i++) { /* meanwhile `start` moves on to the end of the cell */
        size_t c = tour_cell(t, t->at[i]);
        t->slot[i] = t->start[c]++;
        t->end[t->slot[i]] = i;
        t->spot[t->slot[i]] = t->at[i];
    }
    for (size_t c = cells; c > 0; c--)
        t->start[c] = t->start[c - 1];
    t->start[0] = 0;
    return true;
}

/* Moves an end behind the remaining ones of its cell. */
static void take_out(tour *t, uint32_t e)
{
    uint32_t x = column_of(t, t->at[e]), y = tour_row(t, t->at[e]);
    size_t cell = (size_t)y * t->nx[0] + x;
    uint32_t last = t->start[cell] + t->left[0][cell] - 1, other = t->end[last];
    t->end[t->slot[e]] = other;
    t->spot[t->slot[e]] = t->spot[last];
    t->slot[other] = t->slot[e];
    t->end[last] = e;
    t->spot[last] = t->at[e];
    t->slot[e] = last;
    for (uint32_t l = 0; l < t->levels; l++)
        t->left[l][(size_t)(y >> l) * t->nx[l] + (x >> l)]--;
}

/* ---- the nearest ---- */

typedef struct found {
    uint32_t end;
    double square; /* of its distance */
} found;

/* Examines the ends left in cell (x, y). Of ends at equal distances the one with the smallest number is kept. */
static void look_in(const tour *t, page_point p, uint32_t x, uint32_t y, found *best)
{
    size_t cell = (size_t)y * t->nx[0] + x;
    const uint32_t *end = t->end + t->start[cell];
    const page_point *spot = t->spot + t->start[cell];
    uint32_t count = t->left[0][cell] < LOOK_IN_CELL ? t->left[0][cell] : LOOK_IN_CELL;
    for (uint32_t i = 0; i < count; i++) {
        double d = page_square(p, spot[i]);
        if (d < best->square || (d == best->square && end[i] < best->end))
            *best = (found){end[i], d};
    }
}

/* The square of the distance of p from a cell of level l. */
static double cell_distance_square(const tour *t, page_point p, uint32_t l, uint32_t x, uint32_t y)
{
    double size = ldexp(t->cell, (int)l), dx = p.x - (t->x0 + size * x), dy = p.y - (t->y0 + size * y);
    dx = greater(0.0, greater(-dx, dx - size));
    dy = greater(0.0, greater(-dy, dy - size));
    return dx * dx + dy * dy;
}

/* Finds the nearest cell of level l with an end left, in columns box[0] .. box[1] and rows box[2] .. box[3], cut to the
 * grid. False: there is none. */
static bool nearest_cell(const tour *t, page_point p, uint32_t l, const int64_t box[4], uint32_t *x, uint32_t *y)
{
    double best = INFINITY;
    for (int64_t j = box[2] < 0 ? 0 : box[2]; j <= box[3] && j < t->ny[l]; j++)
        for (int64_t i = box[0] < 0 ? 0 : box[0]; i <= box[1] && i < t->nx[l]; i++) {
            if (!t->left[l][(size_t)j * t->nx[l] + (size_t)i])
                continue;
            double d = cell_distance_square(t, p, l, (uint32_t)i, (uint32_t)j);
            if (d < best) {
                best = d;
                *x = (uint32_t)i;
                *y = (uint32_t)j;
            }
        }
    return best < INFINITY;
}

/* Finds an end near p among those left. There is at least one. */
static uint32_t nearest(const tour *t, page_point p)
{
    uint32_t x = column_of(t, p), y = tour_row(t, p), cx = 0, cy = 0, l = 0;
    found best = {NO_END, INFINITY};
    for (uint32_t j = y ? y - 1 : 0; j <= y + 1 && j < t->ny[0]; j++)
        for (uint32_t i = x ? x - 1 : 0; i <= x + 1 && i < t->nx[0]; i++)
            look_in(t, p, i, j, &best);
    if (best.end != NO_END)
        return best.end;
    for (l = 1; l < t->levels; l++) {
        int64_t i = x >> l, j = y >> l;
        if (nearest_cell(t, p, l, (const int64_t[]){i - 1, i + 1, j - 1, j + 1}, &cx, &cy))
            break;
    }
    while (l-- > 0)
        nearest_cell(t, p, l,
                     (const int64_t[]){2 * (int64_t)cx, 2 * (int64_t)cx + 1, 2 * (int64_t)cy, 2 * (int64_t)cy + 1}, &cx,
                     &cy);
    look_in(t, p, cx, cy, &best);
    return best.end;
}

static void greedy(tour *t, page_point pen)
{
    for (uint32_t k = 0; k < t->count; k++) {
        uint32_t e = nearest(t, pen);
        take_out(t, e);
        take_out(t, e ^ 1);
        t->entry[k] = e;
        t->position[e / 2] = k;
        pen = t->at[e ^ 1];
    }
}

/* ---- 2-opt ---- */

static page_point entry_at(const tour *t, uint32_t k)
{
    return t->at[t->entry[k]];
}

static page_point exit_at(const tour *t, uint32_t k)
{
    return t->at[t->entry[k] ^ 1];
}

/* Draws polylines i..j backward. */
static void turn_tour(tour *t, uint32_t i, uint32_t j)
{
    t->turned += j - i + 1;
    for (;; i++, j--) {
        uint32_t front = t->entry[i], back = t->entry[j];
        t->entry[i] = back ^ 1;
        t->entry[j] = front ^ 1;
        t->position[back / 2] = i;
        t->position[front / 2] = j;
        if (i + 1 >= j)
            break;
    }
}

/* In units; more than rounding, so that 2-opt terminates. */
static const double least_gain = 1e-3;

/* Draws polylines i + 1 .. j backward if that shortens the pen's moves. */
static bool try_turn(tour *t, uint32_t i, uint32_t j)
{
    if (i >= j || (t->count > SMALL && j - i > BACKWARD_MAX))
        return false;
    double now = page_distance(exit_at(t, i), entry_at(t, i + 1)), then = page_distance(exit_at(t, i), exit_at(t, j));
    if (j + 1 < t->count) {
        now += page_distance(exit_at(t, j), entry_at(t, j + 1));
        then += page_distance(entry_at(t, i + 1), entry_at(t, j + 1));
    }
    if (then >= now - least_gain)
        return false;
    turn_tour(t, i + 1, j);
    return true;
}

/* How many ends of a cell are examined. */
static uint32_t look_count(const tour *t, size_t cell)
{
    uint32_t count = t->start[cell + 1] - t->start[cell];
    return count < LOOK_IN_CELL ? count : LOOK_IN_CELL;
}

/* Tries the ends in a cell that could follow polyline k (from its exit) or precede k + 1 (from its entry). Only ends
 * nearer to p than the length of the pen's move after polyline k can help; `way_square` is its square. */
static bool try_cell(tour *t, uint32_t k, bool from_exit, page_point p, double way_square, size_t cell)
{
    uint32_t first = t->start[cell], end = first + look_count(t, cell);
    t->compared += end - first;
    for (uint32_t i = first; i < end; i++) {
        if (page_square(p, t->spot[i]) >= way_square)
            continue;
        uint32_t e = t->end[i], q = t->position[e / 2];
        bool is_exit = t->entry[q] != e;
        uint32_t other = from_exit ? q : q - 1; /* the ways after k and after `other` change */
        if (is_exit == from_exit && (from_exit || q > 0) &&
            (other < k ? try_turn(t, other, k) : try_turn(t, k, other))) {
            t->compared -= end - 1 - i; /* not looked at */
            return true;
        }
    }
    return false;
}

/* A lower bound of the distance between a coordinate and those in column or row `i` of the grid. */
static double gap(double at, double start, double cell, uint32_t i)
{
    const double rounding = 1.0; /* units; of a column's border */
    double low = start + cell * i;
    return greater(0.0, greater(low - at, at - low - cell) - rounding);
}

/* Tries to shorten the pen's way after polyline k. Cells that are too far away count as searched. */
static bool improve(tour *t, uint32_t k, bool from_exit)
{
    page_point p = from_exit ? exit_at(t, k) : entry_at(t, k + 1);
    double way_square = page_square(exit_at(t, k), entry_at(t, k + 1)), way = sqrt(way_square);
    uint32_t most = t->count > SMALL ? 2 : 8, x = column_of(t, p), y = tour_row(t, p);
    uint32_t reach = way < (most - 1) * t->cell ? 1 + (uint32_t)(way / t->cell) : most;
    for (uint32_t j = y > reach ? y - reach : 0; j <= y + reach && j < t->ny[0]; j++) {
        double dy = gap(p.y, t->y0, t->cell, j);
        for (uint32_t i = x > reach ? x - reach : 0; i <= x + reach && i < t->nx[0]; i++) {
            double dx = gap(p.x, t->x0, t->cell, i);
            size_t cell = (size_t)j * t->nx[0] + i;
            if (dx * dx + dy * dy >= way_square)
                t->compared += look_count(t, cell);
            else if (try_cell(t, k, from_exit, p, way_square, cell))
                return true;
        }
    }
    return false;
}

/* Draws polylines 0 .. k backward if that shortens the way after them. */
static bool try_head(tour *t, uint32_t k)
{
    double now = page_distance(exit_at(t, k), entry_at(t, k + 1)),
           then = page_distance(entry_at(t, 0), entry_at(t, k + 1));
    if ((t->count > SMALL && k > BACKWARD_MAX) || then >= now - least_gain)
        return false;
    turn_tour(t, 0, k);
    return true;
}

static void two_opt(tour *t)
{
    bool shorter = true;
    for (int pass = 0; pass < PASSES_MAX && shorter; pass++) {
        shorter = false;
        for (uint32_t k = 0; k + 1 < t->count; k++) {
            if (t->compared > compared_most || t->turned > turned_most)
                return;
            if (page_distance(exit_at(t, k), entry_at(t, k + 1)) < 1.0)
                continue;
            shorter |= try_head(t, k) || improve(t, k, true) || improve(t, k, false);
        }
    }
}

/* ---- all together ---- */

static void turn_points(page_point *p, uint32_t count)
{
    for (uint32_t i = 0, j = count - 1; i < j; i++, j--) {
        page_point swap = p[i];
        p[i] = p[j];
        p[j] = swap;
    }
}

/* Puts the polylines in the tour's order. The points of a polyline stay in their place; if it is reversed, so are
 * they. */
static bool apply(const tour *t, polylines *p, size_t first)
{
    polyline *sorted = alloc_array(t->count, sizeof *sorted);
    if (!sorted)
        return false;
    for (uint32_t k = 0; k < t->count; k++) {
        sorted[k] = p->item[first + t->entry[k] / 2];
        if (t->entry[k] % 2 == 1 && !sorted[k].closed)
            turn_points(p->point + sorted[k].first, sorted[k].count);
    }
    memcpy(p->item + first, sorted, t->count * sizeof *sorted);
    free(sorted);
    return true;
}

static void tour_free(tour *t)
{
    for (uint32_t l = 0; l < LEVELS_MAX; l++)
        free(t->left[l]);
    free(t->at);
    free(t->start);
    free(t->end);
    free(t->slot);
    free(t->spot);
    free(t->entry);
    free(t->position);
}

static bool tour_init(tour *t, const polylines *p, size_t first)
{
    *t = (tour){.count = (uint32_t)(p->count - first)};
    t->at = alloc_array(t->count, 2 * sizeof *t->at);
    t->entry = alloc_array(t->count, sizeof *t->entry);
    t->position = alloc_array(t->count, sizeof *t->position);
    if (!t->at || !t->entry || !t->position)
        return false;
    for (uint32_t i = 0; i < t->count; i++) {
        t->at[2 * i] = polyline_start(p, &p->item[first + i]);
        t->at[2 * i + 1] = polyline_end(p, &p->item[first + i]);
    }
    set_grid(t);
    return fill_grid(t);
}

bool travel_order(polylines *p, size_t first, page_point *pen)
{
    tour t;
    if (p->count == first)
        return true;
    bool done = tour_init(&t, p, first);
    if (done) {
        greedy(&t, *pen);
        two_opt(&t);
        done = apply(&t, p, first);
    }
    tour_free(&t);
    if (done)
        *pen = polyline_end(p, &p->item[p->count - 1]);
    return done;
}
