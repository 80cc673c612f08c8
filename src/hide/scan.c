/* scan.c - the scan of a convex polygon over a grid of cells. See scan.h. */
#include "hide/scan.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"

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
