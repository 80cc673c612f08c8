/* scan.c - see scan.h. */
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
    return f;
}

bool scan_init(scan *s, uint32_t nx)
{
    *s = (scan){.bas = alloc_array((size_t)nx * 4, sizeof *s->bas)};
    if (!s->bas)
        return false;
    s->haut = s->bas + nx;
    s->under = s->haut + nx;
    s->over = s->under + nx;
    return true;
}

void scan_free(scan *s)
{
    free(s->bas);
    *s = (scan){0};
}

/* Column i, in which a side that runs to the right (which bounds the polygon from below) or to the left (from above)
 * has the ordinates y0..y1; a vertical side bounds nothing that its neighbours do not bound. */
static void note(scan *s, uint32_t i, double y0, double y1, double to_right)
{
    s->bas[i] = lesser(s->bas[i], y0);
    s->haut[i] = greater(s->haut[i], y1);
    if (to_right > 0.0)
        s->under[i] = greater(s->under[i], y1);
    else if (to_right < 0.0)
        s->over[i] = lesser(s->over[i], y0);
}

/* One side. At the borders of a column its line is taken a margin further out, which also makes up for the rounding of
 * a steep line's ordinate; its ordinates never leave those of its ends. */
static void scan_side(scan *s, const scan_frame *f, roberts_vec3 P, roberts_vec3 Q)
{
    double m = f->margin, run = Q.x - P.x;
    double least = lesser(P.x, Q.x), greatest = greater(P.x, Q.x), low = lesser(P.y, Q.y), high = greater(P.y, Q.y);
    uint32_t first = scan_column(f, least - m), last = scan_column(f, greatest + m);
    if (first == last || greatest - least <= 4.0 * m) {
        for (uint32_t i = first; i <= last; i++)
            note(s, i, low, high, run);
        return;
    }
    double slope = (Q.y - P.y) / run;
    for (uint32_t i = first; i <= last; i++) {
        double from = greater(least, f->x0 + i * f->dx - m), to = lesser(greatest, f->x0 + (i + 1) * f->dx + m);
        double ya = P.y + (from - P.x) * slope, yb = P.y + (to - P.x) * slope;
        note(s, i, greater(low, lesser(lesser(ya, yb), high)), lesser(high, greater(greater(ya, yb), low)), run);
    }
}

void scan_polygon(scan *s, const scan_frame *f, const roberts_vec3 *P, const uint32_t *corner, uint32_t count)
{
    double least = INFINITY, greatest = -INFINITY;
    for (uint32_t k = 0; k < count; k++) {
        least = lesser(least, P[corner[k]].x);
        greatest = greater(greatest, P[corner[k]].x);
    }
    s->first = scan_column(f, least - f->margin);
    s->last = scan_column(f, greatest + f->margin);
    for (uint32_t i = s->first; i <= s->last; i++) {
        s->bas[i] = s->over[i] = INFINITY;
        s->haut[i] = s->under[i] = -INFINITY;
    }
    for (uint32_t k = 0; k < count; k++)
        scan_side(s, f, P[corner[k]], P[corner[k + 1 < count ? k + 1 : 0]]);
    double inner_first = ceil((least + f->margin - f->x0) * f->per_dx);
    double inner_last = floor((greatest - f->margin - f->x0) * f->per_dx) - 1.0;
    s->inner_first = 1;
    s->inner_last = 0;
    if (inner_first <= inner_last && inner_last >= 0.0) {
        s->inner_first = scan_clamp(inner_first, f->nx);
        s->inner_last = scan_clamp(inner_last, f->nx);
    }
}

bool scan_inside(const scan *s, const scan_frame *f, uint32_t i, uint32_t *first, uint32_t *last)
{
    double low = ceil((s->under[i] + f->margin - f->y0) * f->per_dy);
    double high = floor((s->over[i] - f->margin - f->y0) * f->per_dy) - 1.0;
    if (!(low <= high) || high < 0.0)
        return false;
    *first = scan_clamp(low, f->ny);
    *last = scan_clamp(high, f->ny);
    return true;
}
