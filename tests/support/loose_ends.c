/* loose_ends.c - finds loose ends. See loose_ends.h. A grid over the picture lists the segments of each cell. */
#include "loose_ends.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

typedef struct page_grid {
    const roberts_drawing *d;
    double x, y, cell, near;
    long columns, rows;
    size_t *start;     /* [columns * rows + 1] */
    uint32_t *segment; /* segments, sorted by cell */
} page_grid;

static bool is_line(const roberts_segment *s)
{
    return s->state == ROBERTS_VISIBLE && s->line != ROBERTS_WIRE;
}

static long column(const page_grid *g, double x)
{
    return (long)fmin(fmax(floor((x - g->x) / g->cell), 0), (double)(g->columns - 1));
}

static long row(const page_grid *g, double y)
{
    return (long)fmin(fmax(floor((y - g->y) / g->cell), 0), (double)(g->rows - 1));
}

/* Lists a segment in all cells near it; without a list it only counts. */
static void list_segment(page_grid *g, uint32_t number, size_t *at)
{
    const roberts_segment *s = &g->d->segment[number];
    roberts_vec2 p = s->p0, q = s->p1;
    long low = column(g, fmin(p.x, q.x) - g->near), high = column(g, fmax(p.x, q.x) + g->near);
    for (long c = low; c <= high; c++) {
        /* the part of the segment in this column, with a margin */
        double left = c == 0 ? -HUGE_VAL : g->x + (double)c * g->cell - g->near;
        double right = c == g->columns - 1 ? HUGE_VAL : g->x + (double)(c + 1) * g->cell + g->near;
        double y0 = fmin(p.y, q.y), y1 = fmax(p.y, q.y);
        if (fabs(q.x - p.x) > g->near) {
            double from = fmin(fmax(left, fmin(p.x, q.x)), fmax(p.x, q.x));
            double to = fmin(fmax(right, fmin(p.x, q.x)), fmax(p.x, q.x));
            double yf = p.y + (from - p.x) / (q.x - p.x) * (q.y - p.y);
            double yt = p.y + (to - p.x) / (q.x - p.x) * (q.y - p.y);
            y0 = fmin(yf, yt);
            y1 = fmax(yf, yt);
        }
        for (long r = row(g, y0 - g->near); r <= row(g, y1 + g->near); r++) {
            size_t cell = (size_t)(r * g->columns + c);
            if (at)
                g->segment[at[cell]++] = number;
            else
                g->start[cell + 1]++;
        }
    }
}

static bool build(page_grid *g)
{
    size_t cells = (size_t)(g->columns * g->rows), *at = NULL;
    g->start = calloc(cells + 1, sizeof *g->start);
    if (!g->start)
        return false;
    for (size_t i = 0; i < g->d->count; i++)
        if (is_line(&g->d->segment[i]))
            list_segment(g, (uint32_t)i, NULL);
    for (size_t c = 0; c < cells; c++)
        g->start[c + 1] += g->start[c];
    g->segment = malloc((g->start[cells] + 1) * sizeof *g->segment);
    at = malloc((cells + 1) * sizeof *at);
    for (size_t c = 0; at && c < cells; c++)
        at[c] = g->start[c];
    for (size_t i = 0; at && g->segment && i < g->d->count; i++)
        if (is_line(&g->d->segment[i]))
            list_segment(g, (uint32_t)i, at);
    free(at);
    return at && g->segment;
}

/* A direction in which lines leave a point; 0, 0: none yet. */
typedef struct heading {
    double x, y;
} heading;

/* Is this a second direction? Directions that differ by less than `near` over the segment's length count as one. */
static bool another(heading *first, double dx, double dy, double near)
{
    double l = hypot(dx, dy);
    if (l <= 4 * near)
        return false;
    heading h = {dx / l, dy / l};
    if (first->x == 0 && first->y == 0) {
        *first = h;
        return false;
    }
    return hypot(h.x - first->x, h.y - first->y) > 4 * near / l;
}

/* Do lines continue at P? */
static bool leads_on(const page_grid *g, roberts_vec2 P, heading first, size_t self)
{
    size_t cell = (size_t)(row(g, P.y) * g->columns + column(g, P.x));
    for (size_t i = g->start[cell]; i < g->start[cell + 1]; i++) {
        if (g->segment[i] == self)
            continue;
        const roberts_segment *s = &g->d->segment[g->segment[i]];
        double dx = s->p1.x - s->p0.x, dy = s->p1.y - s->p0.y, l = dx * dx + dy * dy;
        double t = l > 0 ? fmin(fmax(((P.x - s->p0.x) * dx + (P.y - s->p0.y) * dy) / l, 0), 1) : 0;
        if (hypot(s->p0.x + t * dx - P.x, s->p0.y + t * dy - P.y) > g->near)
            continue;
        if (sqrt(l) <= 4 * g->near)
            return true; /* too short to have a direction */
        if (another(&first, s->p0.x - P.x, s->p0.y - P.y, g->near) ||
            another(&first, s->p1.x - P.x, s->p1.y - P.y, g->near))
            return true;
    }
    return false;
}

size_t loose_ends_find(const roberts_drawing *drawing, loose_end *found, size_t most, size_t *asked)
{
    double x0 = HUGE_VAL, y0 = HUGE_VAL, x1 = -HUGE_VAL, y1 = -HUGE_VAL;
    size_t lines = 0, loose = 0;
    *asked = 0;
    for (size_t i = 0; i < drawing->count; i++) {
        const roberts_segment *s = &drawing->segment[i];
        if (!is_line(s))
            continue;
        lines++;
        x0 = fmin(x0, fmin(s->p0.x, s->p1.x));
        y0 = fmin(y0, fmin(s->p0.y, s->p1.y));
        x1 = fmax(x1, fmax(s->p0.x, s->p1.x));
        y1 = fmax(y1, fmax(s->p0.y, s->p1.y));
    }
    if (lines == 0)
        return 0;
    page_grid g = {.d = drawing, .x = x0, .y = y0, .near = LOOSE_END_NEAR * hypot(x1 - x0, y1 - y0)};
    g.cell = fmax(hypot(x1 - x0, y1 - y0) / sqrt((double)lines), 4 * g.near) + 1e-300;
    g.columns = 1 + (long)((x1 - x0) / g.cell);
    g.rows = 1 + (long)((y1 - y0) / g.cell);
    bool built = build(&g);
    for (size_t i = 0; built && i < drawing->count; i++) {
        const roberts_segment *s = &drawing->segment[i];
        double dx = s->p1.x - s->p0.x, dy = s->p1.y - s->p0.y, l = hypot(dx, dy);
        if (!is_line(s) || l <= 4 * g.near)
            continue;
        for (int end = 0; end < 2; end++) {
            const heading away = end ? (heading){-dx / l, -dy / l} : (heading){dx / l, dy / l};
            ++*asked;
            if (leads_on(&g, end ? s->p1 : s->p0, away, i))
                continue;
            if (loose < most)
                found[loose] = (loose_end){i, end};
            loose++;
        }
    }
    free(g.start);
    free(g.segment);
    return built ? loose : SIZE_MAX;
}
