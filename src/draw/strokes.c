/* strokes.c - which segments are drawn with which pen, and from where to where on the page. */
#include "draw/strokes.h"

#include <math.h>

/* Cairo keeps coordinates in 32 bits, 8 of them behind the point, and lets larger ones wrap without a word: a page has
 * less than half of 2^23 units, so that wide pens on its border are safe too. */
static const double finest_longest_mm = 4000.0, fine_units_per_mm = 1000.0, coarse_units_per_mm = 100.0;

const roberts_pen *strokes_pen(const roberts_draw_options *options, roberts_line line)
{
    switch (line) {
    case ROBERTS_OUTLINE:
        return &options->outline;
    case ROBERTS_CREASE:
        return &options->crease;
    default:
        return &options->back;
    }
}

bool strokes_dash(const roberts_draw_options *options, roberts_line line, double dash[2])
{
    const roberts_pen *pen = strokes_pen(options, line);
    dash[0] = fmax(pen->dash_mm - pen->width_mm, 0.0);
    dash[1] = pen->gap_mm + pen->width_mm;
    return pen->dash_mm > 0.0 && !(line == ROBERTS_BACK && options->hidden == ROBERTS_HIDDEN_SOLID);
}

static bool is_drawn(const roberts_draw_options *options, const roberts_segment *segment, roberts_line *line)
{
    if (segment->state == ROBERTS_CLIPPED)
        return false;
    if (segment->state == ROBERTS_HIDDEN) {
        *line = ROBERTS_BACK;
        return options->hidden != ROBERTS_HIDDEN_NONE && !options->back.off;
    }
    *line = segment->line == ROBERTS_CREASE ? ROBERTS_CREASE : ROBERTS_OUTLINE;
    return !strokes_pen(options, *line)->off;
}

static void enlarge(roberts_vec2 *min, roberts_vec2 *max, roberts_vec2 p)
{
    min->x = fmin(min->x, p.x);
    min->y = fmin(min->y, p.y);
    max->x = fmax(max->x, p.x);
    max->y = fmax(max->y, p.y);
}

/* Cuts the part of p..q that lies in the drawing's frame; false where there is none. Liang, Barsky, "A new concept and
 * method for line clipping", ACM TOG 3(1), 1984. */
static bool frame_cut(const roberts_drawing *drawing, roberts_vec2 *p, roberts_vec2 *q)
{
    const roberts_vec2 low = drawing->window_min, high = drawing->window_max, d = {q->x - p->x, q->y - p->y};
    const double along[4] = {-d.x, d.x, -d.y, d.y};
    const double room[4] = {p->x - low.x, high.x - p->x, p->y - low.y, high.y - p->y};
    double t0 = 0.0, t1 = 1.0;
    for (int i = 0; drawing->framed && i < 4; i++) {
        if (along[i] == 0.0 && room[i] < 0.0)
            return false;
        if (along[i] < 0.0)
            t0 = fmax(t0, room[i] / along[i]);
        else if (along[i] > 0.0)
            t1 = fmin(t1, room[i] / along[i]);
    }
    if (t0 > t1)
        return false;
    if (t1 < 1.0)
        *q = (roberts_vec2){p->x + t1 * d.x, p->y + t1 * d.y};
    if (t0 > 0.0)
        *p = (roberts_vec2){p->x + t0 * d.x, p->y + t0 * d.y};
    return true;
}

strokes strokes_prepare(const roberts_drawing *drawing, const roberts_draw_options *options)
{
    roberts_vec2 min = {INFINITY, INFINITY}, max = {-INFINITY, -INFINITY};
    const roberts_page *page = &options->page;
    roberts_line line;
    if (drawing->framed) {
        min = drawing->window_min;
        max = drawing->window_max;
    }
    for (size_t i = 0; i < drawing->count && !drawing->framed; i++) {
        const roberts_segment *segment = &drawing->segment[i];
        if (is_drawn(options, segment, &line)) {
            enlarge(&min, &max, segment->p0);
            enlarge(&min, &max, segment->p1);
        }
    }
    if (min.x > max.x)
        min = max = (roberts_vec2){0.0, 0.0}; /* nothing is drawn */
    bool fine = fmax(page->width_mm, page->height_mm) <= finest_longest_mm;
    return (strokes){drawing, options, page_fit(page, min, max), fine ? fine_units_per_mm : coarse_units_per_mm};
}

static roberts_vec2 place(const strokes *s, roberts_vec2 p)
{
    roberts_vec2 mm = page_place(&s->map, p);
    return (roberts_vec2){floor(mm.x * s->units_per_mm + 0.5), floor(mm.y * s->units_per_mm + 0.5)};
}

bool strokes_next(const strokes *s, roberts_line line, size_t *at, stroke *out)
{
    while (*at < s->drawing->count) {
        const roberts_segment *segment = &s->drawing->segment[(*at)++];
        roberts_line own;
        if (!is_drawn(s->options, segment, &own) || own != line)
            continue;
        roberts_vec2 p = segment->p0, q = segment->p1;
        if (!frame_cut(s->drawing, &p, &q))
            continue;
        *out = (stroke){place(s, p), place(s, q)};
        if (out->a.x != out->b.x || out->a.y != out->b.y)
            return true;
    }
    return false;
}
