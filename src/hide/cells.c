/* cells.c - the cells of the picture: how many, and which ones a convex polygon touches. See cells.h. */
#include "hide/cells.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/sort.h"
#include "base/threads.h"

/* ---- the scan of a polygon --------------------------------------------------------------------------------------- */

scan_frame scan_frame_over(roberts_vec2 low, roberts_vec2 high, uint32_t nx, uint32_t ny, double margin)
{
    scan_frame f = {.nx = nx, .ny = ny, .x0 = low.x - margin, .y0 = low.y - margin, .margin = margin};
    f.dx = greater((high.x - low.x + 2.0 * margin) / nx, 4.0 * margin);
    f.dy = greater((high.y - low.y + 2.0 * margin) / ny, 4.0 * margin);
    f.per_dx = 1.0 / f.dx;
    f.per_dy = 1.0 / f.dy;
    f.last_x = nx - 1.0;
    f.last_y = ny - 1.0;
    return f;
}

bool scan_init(scan *s, uint32_t nx)
{
    *s = (scan){.bas = alloc_array((size_t)nx * 4 + 2, sizeof *s->bas)};
    if (!s->bas)
        return false;
    s->haut = s->bas + nx;
    s->under = s->haut + nx;
    s->over = s->under + nx + 1;
    return true;
}

void scan_free(scan *s)
{
    free(s->bas);
    *s = (scan){0};
}

/* Adds one side. In each column, the side is extended by a margin at both borders. This also covers the rounding of a
 * steep line's ordinate. The ordinates are clamped to those of the side's ends. */
static void scan_side(scan *s, const scan_frame *f, roberts_vec3 P, roberts_vec3 Q)
{
    double m = f->margin, run = Q.x - P.x;
    double least = lesser(P.x, Q.x), greatest = greater(P.x, Q.x), low = lesser(P.y, Q.y), high = greater(P.y, Q.y);
    uint32_t first = scan_column(f, least - m), last = scan_column(f, greatest + m);
    bool steep = first == last || greatest - least <= 4.0 * m;
    double slope = steep ? 0.0 : (Q.y - P.y) / run;
    for (uint32_t i = first; i <= last; i++) {
        double y0 = low, y1 = high;
        if (!steep) {
            double from = greater(least, scan_left(f, i) - m), to = lesser(greatest, scan_left(f, i + 1.0) + m);
            double ya = P.y + (from - P.x) * slope, yb = P.y + (to - P.x) * slope;
            y0 = greater(low, lesser(lesser(ya, yb), high));
            y1 = lesser(high, greater(greater(ya, yb), low));
        }
        s->bas[i] = lesser(s->bas[i], y0);
        s->haut[i] = greater(s->haut[i], y1);
    }
}

/* Finds the least and the greatest abscissa. */
static void find_width(const roberts_vec3 *P, const uint32_t *corner, uint32_t count, double *least, double *greatest)
{
    *least = INFINITY;
    *greatest = -INFINITY;
    for (uint32_t k = 0; k < count; k++) {
        *least = lesser(*least, P[corner[k]].x);
        *greatest = greater(*greatest, P[corner[k]].x);
    }
}

void scan_polygon(scan *s, const scan_frame *f, const roberts_vec3 *P, const uint32_t *corner, uint32_t count)
{
    double least, greatest;
    find_width(P, corner, count, &least, &greatest);
    s->first = scan_column(f, least - f->margin);
    s->last = scan_column(f, greatest + f->margin);
    for (uint32_t i = s->first; i <= s->last; i++) {
        s->bas[i] = INFINITY;
        s->haut[i] = -INFINITY;
    }
    for (uint32_t k = 0; k < count; k++)
        scan_side(s, f, P[corner[k]], P[corner[k + 1 < count ? k + 1 : 0]]);
}

/* Finds the borders of inner columns between two abscissas: *first .. *last. False: there are none. */
static inline bool borders_between(const scan *s, const scan_frame *f, double from, double to, uint32_t *first,
                                   uint32_t *last)
{
    double low = scan_place_x(f, from), high = scan_place_x(f, to);
    *first = s->inner_first;
    *last = s->inner_last + 1;
    if (!(low <= *last) || !(high >= *first))
        return false;
    if (low > *first) {
        *first = (uint32_t)low;
        *first += *first < low;
    }
    if (high < *last)
        *last = (uint32_t)high;
    return *first <= *last;
}

/* Bounds a side at the borders near one of its ends, (x, y). `rise` is the side's rise over three margins. */
static inline void scan_end(const scan *s, const scan_frame *f, double *bound, double x, double y, double rise)
{
    uint32_t first, last;
    if (!borders_between(s, f, x - 2.0 * f->margin, x + 2.0 * f->margin, &first, &last))
        return;
    for (uint32_t i = first; i <= last; i++)
        bound[i] = greater(bound[i], greater(y, y + rise));
}

/* Bounds a side's ordinates at the borders of columns. The lower sides of the polygon form a convex function of x, the
 * upper sides a concave one. So within a column, the lower sides are highest at a border, and the upper ones lowest.
 * Upper sides are stored negated.
 *
 * Each border counts as two margins wide, which also covers rounding. If a corner is within that distance, both its
 * sides count. A vertical side is ignored: its neighbours bound the polygon. */
static void scan_borders(scan *s, const scan_frame *f, roberts_vec3 P, roberts_vec3 Q)
{
    bool below = Q.x > P.x;
    double m = f->margin, *bound = below ? s->under : s->over;
    double left = below ? P.x : Q.x, right = below ? Q.x : P.x, from = below ? P.y : -Q.y, to = below ? Q.y : -P.y;
    double slope = (to - from) / (right - left), lift = fabs(slope) * m;
    double rise = slope > 0.0 ? lesser(3.0 * lift, to - from) : greater(-3.0 * lift, to - from);
    uint32_t first, last;
    if (Q.x == P.x)
        return;
    scan_end(s, f, bound, left, from, rise);
    scan_end(s, f, bound, right, to, -rise);
    if (!borders_between(s, f, left + m, right - m, &first, &last))
        return;
    for (uint32_t i = first; i <= last; i++)
        bound[i] = greater(bound[i], from + (scan_left(f, i) - left) * slope + lift);
}

/* Bounds one side whose ends lie in columns `column` and `next`, away from the borders. Returns the number of borders
 * it crosses if it is a lower side, otherwise 0. */
static inline uint32_t scan_side_borders(const scan *s, const scan_frame *f, const roberts_vec3 *P,
                                         const roberts_vec3 *Q, uint32_t column, uint32_t next)
{
    bool below = column < next;
    double *bound = below ? s->under : s->over;
    double left = below ? P->x : Q->x, from = below ? P->y : -Q->y, to = below ? Q->y : -P->y;
    double slope = (to - from) / fabs(Q->x - P->x), lift = fabs(slope) * f->margin;
    uint32_t first = below ? column : next, last = below ? next : column;
    for (uint32_t i = first + 1; i <= last; i++)
        bound[i] = from + (f->x0 + i * f->dx - left) * slope + lift;
    return below ? last - first : 0;
}

/* A faster scan_inner() with the same result to the last bit, for frames without warps and polygons with no corner near
 * a border. Then one lower and one upper side cross each border. False: a corner is near a border, or more sides cross
 * one because the polygon is not quite convex. */
static bool scan_apart(scan *s, const scan_frame *f, const roberts_vec3 *P, const uint32_t *corner, uint32_t count)
{
    double near = 4.0 * f->margin * f->per_dx, inside = 1.0 - near;
    uint32_t first = f->nx, last = 0, column = 0, crossed = 0;
    for (uint32_t k = 0; k < count; k++) {
        double at = (P[corner[k]].x - f->x0) * f->per_dx;
        if (!(at > 0.0) || !(at < f->nx))
            return false;
        column = (uint32_t)at;
        at -= column;
        if (at < near || at > inside)
            return false;
        first = column < first ? column : first;
        last = column > last ? column : last;
    }
    s->inner_first = first + 1;
    s->inner_last = last - 1; /* inner columns lie between the borders first + 1 .. last */
    if (last == first)
        s->inner_last = 0;
    const roberts_vec3 *A = &P[corner[count - 1]];
    for (uint32_t k = 0; k < count && last > first; k++) {
        const roberts_vec3 *B = &P[corner[k]];
        uint32_t next = (uint32_t)((B->x - f->x0) * f->per_dx);
        if (next != column)
            crossed += scan_side_borders(s, f, A, B, column, next);
        column = next;
        A = B;
    }
    return crossed == last - first;
}

void scan_inner(scan *s, const scan_frame *f, const roberts_vec3 *P, const uint32_t *corner, uint32_t count)
{
    double least, greatest;
    if (!f->warps && scan_apart(s, f, P, corner, count))
        return;
    find_width(P, corner, count, &least, &greatest);
    double low = scan_place_x(f, least + f->margin), high = scan_place_x(f, greatest - f->margin);
    s->inner_first = 1;
    s->inner_last = 0;
    if (!(low < f->nx) || !(high >= 1.0))
        return;
    uint32_t first = low > 0.0 ? (uint32_t)low : 0, last = (high < f->nx ? (uint32_t)high : f->nx) - 1;
    first += first < low; /* rounded up */
    if (first > last)
        return;
    s->inner_first = first;
    s->inner_last = last;
    for (uint32_t i = first; i <= last + 1; i++)
        s->under[i] = s->over[i] = -INFINITY;
    for (uint32_t k = 0; k < count; k++)
        scan_borders(s, f, P[corner[k]], P[corner[k + 1 < count ? k + 1 : 0]]);
}

/* ---- how many cells ---------------------------------------------------------------------------------------------- */

/* The numbers below were found by counting instructions on lattices and cities. Each is near a flat optimum: a factor
 * of two costs a tenth, a factor of ten costs a factor of three. */

/* Width of a list's cell in mean boxes. With smaller cells an edge crosses more of them; with larger ones lists are
 * longer. */
#define BOXES_PER_CELL 2.0
/* The same where the axes are warped. 2 is a little better, but slower by half for hidden lines seen along a street. */
#define BOXES_PER_WARPED_CELL 1.4
/* The axes are warped after a sample of at most WARP_MOST boxes. A sample of fewer than WARP_LEAST says too little. */
#define WARP_MOST 512
#define WARP_LEAST 256
/* The axes are warped if that makes the surroundings of a box this many times larger, on average. For boxes that lie at
 * random it is about 1. */
#define WARP_STRETCH 6.0
/* Margins: the length of the shortest piece of a warped axis. So no cell is narrower than four margins. */
#define WARP_MARGINS (4.0 * SIDE_MOST / WARP_PIECES)
/* If the lists would have more entries per box than this, on average, the cells are made larger. ENTRIES_FREE entries
 * do not count. */
#define ENTRIES_PER_BOX 12.0
#define ENTRIES_FREE 4096.0
/* Width of a cover's cell in mean boxes. It is small because a cell that an outline crosses is not covered. */
#define BOXES_PER_COVER_CELL 0.11
/* The same for bodies of more than MANY_VERTICES vertices, on average. Most of these are not convex; fewer of their
 * cells are covered, and their lines cost more. And for loose triangles, which fill half of their boxes. */
#define BOXES_PER_SMALL_COVER_CELL 0.055
#define MANY_VERTICES 16.0
#define LOOSE_VERTICES 3.0
/* The more boxes lie over one another, the more smaller cells gain. So cells shrink from this depth on. */
#define COVER_DEPTH_OF_SMALLER 40.0
#define COVER_SHRINKING 0.3
#define COVER_SMALLEST 0.3
/* Mean number of boxes over a point of the picture from which covers pay. In flat scenes they cost a little. */
#define COVER_DEPTH 2.5
/* The same for the faces of one body. (A triangle takes half of its box.) */
#define OWN_COVER_DEPTH 6.0
/* The most cells per box; and per vertex for covers, where CELLS_FREE more cells cost next to nothing. The most per
 * face for covers of one body. */
#define CELLS_PER_BOX 4.0
#define COVER_CELLS_PER_VERTEX 6.0
#define OWN_COVER_CELLS_PER_FACE 6.0
#define CELLS_FREE 65536.0
/* The most cells and entries per box, together, if the number of cells is asked for; ASKED_FREE do not count. At some
 * ten bytes each they take less than the scene. Where the lists have trees it is a hundred bytes, and they take several
 * times as much. */
#define ASKED_PER_BOX 24.0
#define ASKED_FREE 65536.0
/* Cells per side at the most, so that their numbers stay in 32 bits. */
#define SIDE_MOST 16384.0

/* Boxes are measured in this many pieces. Up to this many boxes are measured by one thread. */
#define PIECES 64
#define MEASURED_BY_ONE 50000

/* Sums over all boxes, each cut to the window, as fractions of it; and the size of the window. */
typedef struct sizes {
    double w, h, area, width, height;
} sizes;

typedef struct measuring {
    const cells_boxes *b;
    const warp *warps; /* [2], or NULL */
    double per_width, per_height;
    sizes *some; /* [PIECES] */
} measuring;

/* Is the box that of a solid that the near plane has removed? */
static inline bool is_removed(const hide_box *box)
{
    return box->x1 < box->x0;
}

/* Returns the length of low..high along an axis. axis: its warp, or NULL. */
static inline double warped_length(const warp *axis, float low, float high)
{
    return axis ? warp_at(axis, (double)high) - warp_at(axis, (double)low) : (double)(high - low);
}

static sizes measure_some(const hide_box *box, uint32_t count, const measuring *m)
{
    sizes s = {0};
    for (uint32_t i = 0; i < count; i++) {
        if (is_removed(&box[i]))
            continue;
        double w = warped_length(m->warps, box[i].x0, box[i].x1),
               h = warped_length(m->warps ? m->warps + 1 : NULL, box[i].y0, box[i].y1);
        w = m->per_width > 0.0 ? lesser(1.0, w * m->per_width) : 1.0;
        h = m->per_height > 0.0 ? lesser(1.0, h * m->per_height) : 1.0;
        s.w += w;
        s.h += h;
        s.area += w * h;
    }
    return s;
}

static bool measure_pieces(void *context, size_t first, size_t end)
{
    const measuring *m = context;
    for (size_t i = first; i < end; i++) {
        uint32_t from = (uint32_t)((uint64_t)m->b->count * i / PIECES);
        uint32_t to = (uint32_t)((uint64_t)m->b->count * (i + 1) / PIECES);
        m->some[i] = measure_some(m->b->box + from, to - from, m);
    }
    return true;
}

/* Sums up the boxes, along axes that may be warped. The pieces do not depend on the threads. If the window has no width
 * (height), all boxes count as wide (high) as the window. */
static sizes measure_boxes(const cells_boxes *b, const warp *warps, int threads)
{
    uint32_t count = b->count;
    sizes all = {.width = b->high.x - b->low.x, .height = b->high.y - b->low.y}, some[PIECES];
    double per_width = all.width >= DBL_MIN ? 1.0 / all.width : 0.0;
    double per_height = all.height >= DBL_MIN ? 1.0 / all.height : 0.0;
    threads_each(count > MEASURED_BY_ONE ? threads : 1, PIECES, 0, measure_pieces,
                 &(measuring){b, warps, per_width, per_height, some});
    for (uint32_t i = 0; i < PIECES; i++) {
        all.w += some[i].w;
        all.h += some[i].h;
        all.area += some[i].area;
    }
    return all;
}

/* Finds columns and rows for cells that are `boxes` mean boxes wide and high, with `most` cells at the most. */
static void divide_window(const sizes *s, uint32_t count, double boxes, double most, double *nx, double *ny)
{
    *nx = lesser(SIDE_MOST, count / greater(s->w * boxes, 1e-9));
    *ny = lesser(SIDE_MOST, count / greater(s->h * boxes, 1e-9));
    if (*nx * *ny > most) {
        double k = sqrt(most / (*nx * *ny));
        *nx *= k;
        *ny *= k;
    }
}

/* Estimates the entries of the lists of nx * ny cells. A polygon has as many as its border and its area have cells. */
static double entries(const sizes *s, uint32_t count, double nx, double ny)
{
    return count + nx * s->w + ny * s->h + nx * ny * s->area;
}

static uint32_t whole(double n)
{
    return n < 1.0 ? 1 : n > SIDE_MOST ? (uint32_t)SIDE_MOST : (uint32_t)n;
}

/* Makes the cells larger until they and their entries, each cell counted as `cell` entries, are no more than `most`. */
static void enlarge_cells(const sizes *s, uint32_t count, double cell, double most, double *nx, double *ny)
{
    while (*nx * *ny > 1.0 && entries(s, count, *nx, *ny) + cell * *nx * *ny > most) {
        *nx = greater(1.0, 0.9 * *nx);
        *ny = greater(1.0, 0.9 * *ny);
    }
}

static bool make_warp(warp *axis, double low, double high, const double *middle, uint32_t count, double margin)
{
    double sorted[WARP_MOST];
    memcpy(sorted, middle, count * sizeof *sorted);
    qsort(sorted, count, sizeof *sorted, compare_doubles);
    return warp_make(axis, low - margin, high + margin, sorted, count, WARP_MARGINS * margin);
}

/* Makes warps by the middles of a sample: one box of each row of equally many in the file, at random, since boxes at
 * equal distances may all lie in one column of a pattern. Middles outside the window count as on its border. Returns
 * how many times larger the warps make the surroundings of a middle, on average; 0: there are too few boxes. */
static double warp_axes(const cells_boxes *b, warp warps[2])
{
    double x[WARP_MOST], y[WARP_MOST], sum = 0.0;
    uint32_t count = 0, step = b->count / WARP_MOST + 1, chance = 1;
    for (uint32_t i = 0; i + step <= b->count; i += step) {
        chance = chance * 1664525u + 1013904223u; /* a linear congruential generator: the same sample in each run */
        const hide_box *box = &b->box[i + (chance >> 8) % step];
        if (is_removed(box))
            continue;
        x[count] = lesser(greater(0.5 * ((double)box->x0 + (double)box->x1), b->low.x), b->high.x);
        y[count++] = lesser(greater(0.5 * ((double)box->y0 + (double)box->y1), b->low.y), b->high.y);
    }
    if (count < WARP_LEAST || !make_warp(&warps[0], b->low.x, b->high.x, x, count, b->margin) ||
        !make_warp(&warps[1], b->low.y, b->high.y, y, count, b->margin))
        return 0.0;
    for (uint32_t i = 0; i < count; i++)
        sum += warp_stretch(&warps[0], x[i]) * warp_stretch(&warps[1], y[i]);
    return sum / count;
}

/* Gives the frame these warps: [2], or NULL. Without memory for them, it has none, which costs only time. */
static scan_frame with_warps(scan_frame frame, const warp *warps)
{
    if (warps && (frame.warps = malloc(2 * sizeof *warps)))
        memcpy(frame.warps, warps, 2 * sizeof *warps);
    return frame;
}

scan_frame cells_for_lists(const cells_boxes *b, uint32_t n, double *depth)
{
    double nx = 1.0, ny = 1.0;
    uint32_t count = b->count;
    warp warps[2];
    bool warped = !n && warp_axes(b, warps) > WARP_STRETCH;
    sizes s = measure_boxes(b, NULL, 1);
    *depth = s.area;
    if (warped)
        s = measure_boxes(b, warps, 1);
    if (n) {
        nx = ny = n;
        enlarge_cells(&s, count, 1.0, ASKED_PER_BOX * count + ASKED_FREE, &nx, &ny);
    } else if (count) {
        double boxes = warped ? BOXES_PER_WARPED_CELL : BOXES_PER_CELL;
        divide_window(&s, count, boxes, CELLS_PER_BOX * count + 1.0, &nx, &ny);
        enlarge_cells(&s, count, 0.0, ENTRIES_PER_BOX * count + ENTRIES_FREE, &nx, &ny);
    }
    return with_warps(scan_frame_over(b->low, b->high, whole(nx), whole(ny), b->margin), warped ? warps : NULL);
}

static double most_cover_cells(size_t vertices)
{
    return COVER_CELLS_PER_VERTEX * (double)vertices + CELLS_FREE;
}

scan_frame cells_for_covers(const cells_boxes *b, size_t vertices, int threads)
{
    double nx, ny;
    uint32_t count = b->count;
    warp warps[2];
    const bool warped = warp_axes(b, warps) > WARP_STRETCH;
    sizes s = measure_boxes(b, warped ? warps : NULL, threads);
    if (!(s.area > COVER_DEPTH) || !(s.width > 0.0) || !(s.height > 0.0))
        return (scan_frame){0};
    double smaller = s.area > COVER_DEPTH_OF_SMALLER ? pow(COVER_DEPTH_OF_SMALLER / s.area, COVER_SHRINKING) : 1.0;
    smaller = greater(smaller, COVER_SMALLEST); /* each front writes all cells that it covers */
    const bool small = (double)vertices > MANY_VERTICES * count || (double)vertices <= LOOSE_VERTICES * count;
    const double boxes = small ? BOXES_PER_SMALL_COVER_CELL : BOXES_PER_COVER_CELL;
    divide_window(&s, count, boxes * smaller, most_cover_cells(vertices), &nx, &ny);
    return with_warps(scan_frame_over(b->low, b->high, whole(nx), whole(ny), b->margin), warped ? warps : NULL);
}

scan_frame cells_for_own_covers(const cells_boxes *b)
{
    double nx, ny;
    const sizes s = measure_boxes(b, NULL, 1);
    if (!(s.area > OWN_COVER_DEPTH))
        return (scan_frame){0};
    divide_window(&s, b->count, BOXES_PER_COVER_CELL, OWN_COVER_CELLS_PER_FACE * b->count, &nx, &ny);
    return scan_frame_over(b->low, b->high, whole(nx), whole(ny), b->margin);
}

scan_frame cells_of_whole(const scene_whole *w, double margin)
{
    if (!w->columns)
        return (scan_frame){0};
    return with_warps(scan_frame_over(w->low, w->high, w->columns, w->rows, margin), w->warped ? w->warps : NULL);
}

bool cells_may_cover(uint32_t nx, uint32_t ny, size_t vertices)
{
    return (nx == 0) == (ny == 0) && nx <= SIDE_MOST && ny <= SIDE_MOST &&
           (double)nx * ny <= most_cover_cells(vertices);
}
