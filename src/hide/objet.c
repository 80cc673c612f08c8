/* objet.c - filling and walking the grid. See objet.h. */
#include "hide/objet.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"

/* List entries per face that the grid may come to, on average, before it is made coarser. */
#define ENTRIES_PER_FACE 12.0
#define ENTRIES_FREE 4096.0
#define CELLS_MOST 4096.0

/* What the scan of one polygon found, column by column. */
typedef struct scan {
    uint32_t first, last; /* columns touched */
    double *bas, *haut;   /* [n] least and greatest ordinate touched */
    double *under, *over; /* [n] above `under` and below `over` a whole column is inside; only between the columns */
    uint32_t inner_first, inner_last; /* that are inside the polygon's width; none where first > last */
} scan;

uint32_t objet_choose(const hide_face *face, uint32_t count, double width, double height)
{
    double w = 0.0, h = 0.0, wh = 0.0, n;
    if (count == 0 || (width <= 0.0 && height <= 0.0))
        return 1;
    for (uint32_t i = 0; i < count; i++) {
        double fw = width > 0.0 ? (double)(face[i].x1 - face[i].x0) / width : 0.0;
        double fh = height > 0.0 ? (double)(face[i].y1 - face[i].y0) / height : 0.0;
        w += fw;
        h += fh;
        wh += fw * fh;
    }
    n = fmin(CELLS_MOST, fmin(2.0 * sqrt((double)count) + 1.0, 2.0 * count / fmax(w + h, 1e-9)));
    while (n > 1.0 && n * n * wh + n * (w + h) + count > ENTRIES_PER_FACE * count + ENTRIES_FREE)
        n *= 0.9;
    return n < 1.0 ? 1 : (uint32_t)n;
}

/* Column of abscissa x, kept inside the grid. */
static uint32_t clamp_cell(double position, uint32_t n)
{
    if (!(position > 0.0))
        return 0;
    return position >= n ? n - 1 : (uint32_t)position;
}

static uint32_t column_of(const objet *grid, double x)
{
    return clamp_cell((x - grid->x0) / grid->dx, grid->n);
}

static uint32_t row_of(const objet *grid, double y)
{
    return clamp_cell((y - grid->y0) / grid->dy, grid->n);
}

/* One side P -> Q of a polygon that runs counter-clockwise: the ordinates that it has over each column it touches, the
 * columns widened by the margin. A side that runs to the right bounds the polygon from below (the lecture's walk from
 * S1,g to S1,d), one that runs to the left from above. */
static void scan_side(const objet *grid, roberts_vec3 P, roberts_vec3 Q, scan *s)
{
    double m = grid->margin, slope = (Q.y - P.y) / (Q.x - P.x);
    double least = fmin(P.x, Q.x), greatest = fmax(P.x, Q.x), low = fmin(P.y, Q.y), high = fmax(P.y, Q.y);
    uint32_t last = column_of(grid, greatest + m);
    for (uint32_t i = column_of(grid, least - m); i <= last; i++) {
        double from = fmax(least, grid->x0 + i * grid->dx - m), to = fmin(greatest, grid->x0 + (i + 1) * grid->dx + m);
        double y0 = low, y1 = high; /* a vertical side, or one that the column touches in its margin only */
        if (Q.x != P.x && from <= to) {
            double ya = P.y + (from - P.x) * slope, yb = P.y + (to - P.x) * slope;
            y0 = fmax(low, fmin(ya, yb));
            y1 = fmin(high, fmax(ya, yb));
        }
        s->bas[i] = fmin(s->bas[i], y0);
        s->haut[i] = fmax(s->haut[i], y1);
        if (Q.x >= P.x)
            s->under[i] = fmax(s->under[i], y1);
        if (Q.x <= P.x)
            s->over[i] = fmin(s->over[i], y0);
    }
}

static void scan_face(const objet *grid, const hide_space *space, const hide_face *face, scan *s)
{
    double m = grid->margin, inner_first, inner_last;
    s->first = column_of(grid, (double)face->x0 - m);
    s->last = column_of(grid, (double)face->x1 + m);
    for (uint32_t i = s->first; i <= s->last; i++) {
        s->bas[i] = s->over[i] = INFINITY;
        s->haut[i] = s->under[i] = -INFINITY;
    }
    double least = INFINITY, greatest = -INFINITY;
    for (uint32_t k = 0; k < face->count; k++) {
        roberts_vec3 P = space->P[face->corner[k]], Q = space->P[face->corner[k + 1 < face->count ? k + 1 : 0]];
        scan_side(grid, P, Q, s);
        least = fmin(least, P.x);
        greatest = fmax(greatest, P.x);
    }
    inner_first = ceil((least + m - grid->x0) / grid->dx);
    inner_last = floor((greatest - m - grid->x0) / grid->dx) - 1.0;
    s->inner_first = clamp_cell(inner_first, grid->n);
    s->inner_last = clamp_cell(inner_last, grid->n);
    if (inner_first > inner_last || inner_last < 0.0) {
        s->inner_first = 1;
        s->inner_last = 0;
    }
}

/* Least depth of a front face's plane over the cell, less what its touching distance is worth in depth. */
static double covered_depth(const objet *grid, const hide_face *face, uint32_t i, uint32_t j)
{
    plane F = face->F; /* c < 0, so that z = (a x + b y + d) / -c grows with x where a > 0 */
    double x = grid->x0 + (F.a > 0.0 ? i : i + 1) * grid->dx;
    double y = grid->y0 + (F.b > 0.0 ? j : j + 1) * grid->dy;
    double slack = 2.0 * (face->touch + grid->margin);
    return (F.a * x + F.b * y + F.d - slack) / -F.c;
}

static void cover_cells(objet *grid, const hide_face *face, uint32_t index, const scan *s)
{
    for (uint32_t i = s->inner_first; i <= s->inner_last; i++) {
        double first = ceil((s->under[i] + grid->margin - grid->y0) / grid->dy);
        double last = floor((s->over[i] - grid->margin - grid->y0) / grid->dy) - 1.0;
        if (!(first <= last) || last < 0.0)
            continue;
        for (uint32_t j = clamp_cell(first, grid->n), end = clamp_cell(last, grid->n); j <= end; j++) {
            double depth = covered_depth(grid, face, i, j);
            size_t cell = (size_t)i * grid->n + j;
            if (depth > grid->cover_depth[cell]) {
                grid->cover_depth[cell] = depth;
                grid->cover[cell] = index;
            }
        }
    }
}

/* Puts the face into every cell that it touches, or with face == NULL counts it there. Faces come nearest corner first:
 * a cover that hides this one's nearest corner has come before it, so that counting and filling drop the same. */
static void list_cells(objet *grid, const hide_face *face, uint32_t index, const scan *s, bool fill)
{
    for (uint32_t i = s->first; i <= s->last; i++) {
        uint32_t last = row_of(grid, s->haut[i] + grid->margin);
        if (s->bas[i] > s->haut[i])
            continue;
        for (uint32_t j = row_of(grid, s->bas[i] - grid->margin); j <= last; j++) {
            size_t cell = (size_t)i * grid->n + j;
            if ((double)face->z1 < grid->cover_depth[cell])
                continue;
            if (fill)
                grid->face[grid->start[cell]++] = index;
            else
                grid->start[cell]++;
        }
    }
}

/* Counts become places: start[cell] the first of the cell's list. */
static bool sum_counts(objet *grid)
{
    size_t total = 0, cells = (size_t)grid->n * grid->n;
    for (size_t c = 0; c <= cells; c++) {
        size_t count = c < cells ? grid->start[c] : 0;
        if (total > UINT32_MAX)
            return false;
        grid->start[c] = (uint32_t)total;
        total += count;
    }
    grid->face = alloc_array(grid->start[cells], sizeof *grid->face);
    return grid->face != NULL;
}

/* Filling has moved each start to its list's end, which is the next one's start. */
static void restore_starts(objet *grid)
{
    size_t cells = (size_t)grid->n * grid->n;
    for (size_t c = cells; c > 0; c--)
        grid->start[c] = grid->start[c - 1];
    grid->start[0] = 0;
}

static bool objet_alloc(objet *grid, scan *s)
{
    size_t cells = (size_t)grid->n * grid->n;
    double *columns = alloc_array((size_t)grid->n * 4, sizeof *columns);
    grid->start = alloc_zeroed(cells + 1, sizeof *grid->start);
    grid->cover = alloc_array(cells, sizeof *grid->cover);
    grid->cover_depth = alloc_array(cells, sizeof *grid->cover_depth);
    *s = (scan){.bas = columns};
    if (!columns || !grid->start || !grid->cover || !grid->cover_depth)
        return false;
    s->haut = columns + grid->n;
    s->under = columns + (size_t)2 * grid->n;
    s->over = columns + (size_t)3 * grid->n;
    for (size_t c = 0; c < cells; c++) {
        grid->cover[c] = ROBERTS_NONE;
        grid->cover_depth[c] = -INFINITY;
    }
    return true;
}

roberts_status objet_build(objet *grid, const hide_space *space, const hide_face *face, const uint32_t *order,
                           uint32_t count, uint32_t n, roberts_vec2 low, roberts_vec2 high)
{
    roberts_status status = ROBERTS_NO_MEMORY;
    scan s;
    double margin = 4.0 * (space->epsilon + space->rounding); /* so that faces and edges that touch share a cell */
    *grid = (objet){.n = n, .x0 = low.x - margin, .y0 = low.y - margin, .margin = margin};
    /* a window without width or height gets cells of some size, all but one column or row of which stay empty */
    grid->dx = fmax((high.x - low.x + 2.0 * margin) / n, 4.0 * margin);
    grid->dy = fmax((high.y - low.y + 2.0 * margin) / n, 4.0 * margin);
    if (!objet_alloc(grid, &s))
        goto done;
    for (uint32_t k = 0; k < count; k++) {
        scan_face(grid, space, &face[order[k]], &s);
        list_cells(grid, &face[order[k]], order[k], &s, false);
        cover_cells(grid, &face[order[k]], order[k], &s);
    }
    if (!sum_counts(grid))
        goto done;
    for (uint32_t k = 0; k < count; k++) {
        scan_face(grid, space, &face[order[k]], &s);
        list_cells(grid, &face[order[k]], order[k], &s, true);
    }
    restore_starts(grid);
    status = ROBERTS_OK;
done:
    free(s.bas);
    if (status != ROBERTS_OK)
        objet_free(grid);
    return status;
}

void objet_free(objet *grid)
{
    free(grid->start);
    free(grid->face);
    free(grid->cover);
    free(grid->cover_depth);
    *grid = (objet){0};
}

/* Parameters at which a + t (b - a) lies in [low, high], kept in [t0, t1]; the whole of it where a and b hardly differ. */
static void clip_slab(double a, double b, double low, double high, double *t0, double *t1)
{
    double d = b - a;
    if (fabs(d) <= high - low && fmin(a, b) >= low && fmax(a, b) <= high)
        return;
    if (d == 0.0)
        return;
    double ta = (low - a) / d, tb = (high - a) / d;
    *t0 = fmax(*t0, fmin(ta, tb));
    *t1 = fmin(*t1, fmax(ta, tb));
}

bool objet_cells(const objet *grid, roberts_vec3 A, roberts_vec3 B, objet_walk *walk)
{
    double m = grid->margin;
    uint32_t last = column_of(grid, fmax(A.x, B.x) + m);
    walk->count = 0;
    for (uint32_t i = column_of(grid, fmin(A.x, B.x) - m); i <= last; i++) {
        double t0 = 0.0, t1 = 1.0;
        clip_slab(A.x, B.x, grid->x0 + i * grid->dx - m, grid->x0 + (i + 1) * grid->dx + m, &t0, &t1);
        if (t0 > t1)
            continue;
        double ya = A.y + t0 * (B.y - A.y), yb = A.y + t1 * (B.y - A.y);
        uint32_t end = row_of(grid, fmax(ya, yb) + m);
        for (uint32_t j = row_of(grid, fmin(ya, yb) - m); j <= end; j++) {
            objet_stretch stretch = {(uint32_t)((size_t)i * grid->n + j), t0, t1};
            clip_slab(A.y, B.y, grid->y0 + j * grid->dy - m, grid->y0 + (j + 1) * grid->dy + m, &stretch.t0,
                      &stretch.t1);
            if (stretch.t0 > stretch.t1)
                continue;
            if (!array_reserve(&walk->item, &walk->room, walk->count + 1, sizeof *walk->item))
                return false;
            walk->item[walk->count++] = stretch;
        }
    }
    return true;
}

uint32_t objet_cell_at(const objet *grid, double x, double y)
{
    return (uint32_t)((size_t)column_of(grid, x) * grid->n + row_of(grid, y));
}
