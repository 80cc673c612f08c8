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

strokes strokes_prepare(const roberts_drawing *drawing, const roberts_draw_options *options)
{
    roberts_vec2 min = {INFINITY, INFINITY}, max = {-INFINITY, -INFINITY};
    const roberts_page *page = &options->page;
    roberts_line line;
    for (size_t i = 0; i < drawing->count; i++) {
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
        *out = (stroke){place(s, segment->p0), place(s, segment->p1)};
        if (out->a.x != out->b.x || out->a.y != out->b.y)
            return true;
    }
    return false;
}
