/* hatch.c - strokes on visible regions, by shade.
 *
 * The lines of a hatching are parallel on the paper and equally far apart. They are clipped to a region by even-odd
 * filling: where a line crosses the rings, sorted along it, strokes go from each first crossing to the second (W. M.
 * Newman, R. F. Sproull, "Principles of Interactive Computer Graphics", 2nd edition, McGraw-Hill 1979, chapter 16). A
 * side of a ring holds its lower end but not its upper one. So a line through a corner crosses the rings there as often
 * as it passes from side to side, and sides along the line do not count.
 *
 * Lines are counted from one point, which is the corner of the page, or the foot of the face's plane. A border between
 * two regions is cut at the same points from both sides. So strokes continue across borders within one tone, and are
 * joined there like all pieces. */
#include "draw/hatch.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/angle.h"
#include "base/array.h"
#include "base/error.h"
#include "draw/page.h"
#include "draw/shade.h"

/* mm: from farther feet, lines could not be counted. Only faces that are nearly edge-on have such feet. */
static const double farthest_foot = 1e6;

/* Where a line crosses a ring. */
typedef struct hatch_crossing {
    int64_t line;
    double t; /* along the line, units of the page */
} hatch_crossing;

/* Parallel lines: number i is where across . (p - origin) = (i + 1/2) step. Only a `part` of each is drawn. */
typedef struct hatch_lines {
    roberts_vec2 origin, along, across; /* units of the page; along and across of length 1 */
    double step, part;
} hatch_lines;

typedef struct hatch_work {
    const strokes *s;
    pieces *p;
    size_t *room, first; /* first: pieces that are not hatching */
    hatch_crossing *crossing;
    size_t crossing_count, crossing_room;
    const page_view *view; /* of the region before */
    uint32_t number;       /* of the region */
    bool too_many, no_slopes;
} hatch_work;

/* ---- tone ---- */

/* The ambient light (SHADE_AMBIENT) leaves the paper white. */
double hatch_darkness(const roberts_draw_options *options, const roberts_region *region)
{
    const double levels = options->hatching.levels;
    if (options->hatching.sections)
        return region->section ? 1.0 : 0.0;
    const double dark = (1.0 - shade(region->normal, options->light)) / (1.0 - SHADE_AMBIENT);
    return levels > 0.0 ? floor(dark * levels + 0.5) / levels : dark;
}

/* ---- directions ---- */

/* The direction of strokes on paper, turned by `degrees` more than the options say; of any length. */
static roberts_vec2 direction(const roberts_hatching *h, const roberts_slope *slope, double degrees)
{
    const roberts_vec2 turn = angle_unit(h->degrees + degrees);
    roberts_vec2 right = {1.0, 0.0}, up = {0.0, 1.0};
    if (h->along == ROBERTS_HATCH_ACROSS) {
        right = slope->level;
        up = slope->steep;
    } else if (h->along == ROBERTS_HATCH_STEEP) {
        right = slope->steep;
        up = (roberts_vec2){-slope->level.x, -slope->level.y};
    }
    return (roberts_vec2){turn.x * right.x + turn.y * up.x, -(turn.x * right.y + turn.y * up.y)}; /* y down */
}

/* Lines for a tone. On a face that is nearly edge-on they are level. */
static hatch_lines lines_for(const strokes *s, const page_region *on, double degrees, double tone)
{
    const roberts_hatching *h = &s->options->hatching;
    const roberts_vec2 d = direction(h, on->slope, degrees);
    const double length = hypot(d.x, d.y);
    const double step = h->spacing_mm * s->units_per_mm;
    hatch_lines lines = {.along = {1.0, 0.0}, .step = h->nested ? step : step / tone, .part = h->nested ? tone : 1.0};
    if (isnormal(length))
        lines.along = (roberts_vec2){d.x / length, d.y / length};
    lines.across = (roberts_vec2){-lines.along.y, lines.along.x};
    if (h->along != ROBERTS_HATCH_PICTURE) {
        const roberts_vec2 mm = page_place(&on->view->map, on->slope->foot);
        if (fabs(mm.x) < farthest_foot && fabs(mm.y) < farthest_foot)
            lines.origin = (roberts_vec2){mm.x * s->units_per_mm, mm.y * s->units_per_mm};
    }
    return lines;
}

/* ---- clipping ---- */

/* A corner of a ring: `across` counts lines. */
typedef struct hatch_corner {
    double across, along;
} hatch_corner;

static hatch_corner hatch_corner_at(const hatch_lines *lines, roberts_vec2 p)
{
    const roberts_vec2 q = {p.x - lines->origin.x, p.y - lines->origin.y};
    return (hatch_corner){(lines->across.x * q.x + lines->across.y * q.y) / lines->step - 0.5,
                          lines->along.x * q.x + lines->along.y * q.y};
}

/* Whether a line is drawn if only a fraction of the lines is. The lines of a fraction are also drawn for each larger
 * one, and are spread as evenly as that allows: the order is that of the radical inverse (J. G. van der Corput,
 * "Verteilungsfunktionen", Proceedings of the Royal Academy of Amsterdam 38, 1935), which reverses the bits of a
 * number. So a half has every second line, a quarter every fourth. */
static bool is_drawn(double line, double part)
{
    const unsigned n = (unsigned)((uint64_t)(int64_t)line & 0xffff);
    unsigned turned = 0;
    for (int bit = 0; bit < 16; bit++)
        turned |= (n >> bit & 1) << (15 - bit);
    return turned < part * 65536.0;
}

/* Adds the crossings of a side. The result is the same for both directions of the side. False: no memory, or too many.
 */
static bool add_side_crossings(hatch_work *w, const hatch_lines *lines, hatch_corner a, hatch_corner b)
{
    if (a.across > b.across || (a.across == b.across && a.along > b.along)) {
        const hatch_corner swap = a;
        a = b;
        b = swap;
    }
    const double first = ceil(a.across), end = ceil(b.across); /* lines first .. end - 1 */
    if (!(end - first <= 2.0 * HATCH_MOST)) {
        w->too_many = true;
        return false;
    }
    const size_t count = (size_t)(end - first);
    if (!array_reserve(&w->crossing, &w->crossing_room, w->crossing_count + count, sizeof *w->crossing))
        return false;
    for (size_t i = 0; i < count; i++) {
        const double line = first + (double)i, t = (line - a.across) / (b.across - a.across);
        if (lines->part == 1.0 || is_drawn(line, lines->part))
            w->crossing[w->crossing_count++] = (hatch_crossing){(int64_t)line, a.along + t * (b.along - a.along)};
    }
    return true;
}

static int by_line(const void *pa, const void *pb)
{
    const hatch_crossing *a = pa, *b = pb;
    if (a->line != b->line)
        return a->line < b->line ? -1 : 1;
    return (a->t > b->t) - (a->t < b->t);
}

static roberts_vec2 hatch_point(const hatch_lines *lines, const hatch_crossing *c)
{
    const double across = ((double)c->line + 0.5) * lines->step;
    return (roberts_vec2){lines->origin.x + c->t * lines->along.x + across * lines->across.x,
                          lines->origin.y + c->t * lines->along.y + across * lines->across.y};
}

/* Adds the strokes between crossings. Each line crosses the rings an even number of times. */
static bool add_hatch_strokes(hatch_work *w, const hatch_lines *lines)
{
    pieces *p = w->p;
    if (p->count - w->first + w->crossing_count / 2 > HATCH_MOST) {
        w->too_many = true;
        return false;
    }
    if (!array_reserve(&p->item, w->room, p->count + w->crossing_count / 2, sizeof *p->item))
        return false;
    for (size_t i = 0; i + 1 < w->crossing_count; i += 2) {
        const roberts_vec2 a = hatch_point(lines, &w->crossing[i]), b = hatch_point(lines, &w->crossing[i + 1]);
        if (!page_is_same(page_rounded(a), page_rounded(b)))
            p->item[p->count++] = (piece){.a = a, .b = b, .number = w->number, .line = LINE_HATCH};
    }
    return true;
}

static bool draw_lines(hatch_work *w, const page_region *on, const hatch_lines *lines)
{
    w->crossing_count = 0;
    for (size_t r = 0; r < on->ring_count; r++) {
        const size_t first = on->ring_start[r], end = on->ring_start[r + 1];
        hatch_corner before = hatch_corner_at(lines, on->point[end - 1]);
        for (size_t k = first; k < end; k++) {
            const hatch_corner own = hatch_corner_at(lines, on->point[k]);
            if (!add_side_crossings(w, lines, before, own))
                return false;
            before = own;
        }
    }
    if (w->crossing_count > 1)
        qsort(w->crossing, w->crossing_count, sizeof *w->crossing, by_line);
    return add_hatch_strokes(w, lines);
}

/* Hatches one region: if it is darker than options->cross, its further strokes run across the others. */
static bool hatch_region(void *context, const page_region *on)
{
    hatch_work *w = context;
    const roberts_hatching *h = &w->s->options->hatching;
    const double dark = hatch_darkness(w->s->options, on->region), plain = fmin(dark, h->cross);
    w->no_slopes = h->along != ROBERTS_HATCH_PICTURE && !on->slope;
    const bool turned = h->sections && on->region->solid % 2 && !on->view->drawing->regions->united;
    bool done = !w->no_slopes;
    w->number = on->view == w->view ? w->number + 1 : on->view->first_region;
    w->view = on->view;
    for (int k = 0; k < 2 && done; k++) {
        const double tone = k == 0 ? plain : dark - plain;
        if (tone > 0.0) {
            const hatch_lines lines = lines_for(w->s, on, (k == 1) != turned ? 90.0 : 0.0, tone);
            done = draw_lines(w, on, &lines);
        }
    }
    return done;
}

roberts_status hatch_add(const strokes *s, pieces *p, size_t *room, roberts_error *error)
{
    hatch_work w = {.s = s, .p = p, .room = room, .first = p->count};
    const bool done = page_regions_walk(s, hatch_region, &w);
    free(w.crossing);
    if (w.too_many)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0,
                         "the drawing takes more than %d strokes of hatching; make their spacing wider", HATCH_MOST);
    if (w.no_slopes)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "hatching that follows the faces needs the regions' slopes");
    return done ? ROBERTS_OK : error_no_memory(error);
}

/* ---- text ---- */

/* mm, kept free round text besides half of the pen. */
static const double round_text = 0.2;

/* The boxes of text. NULL: no memory. */
static free_space *text_boxes(const strokes *s)
{
    const roberts_page *page = &s->page;
    const space_box all = {{0.0, 0.0}, {page->width_mm, page->height_mm}};
    free_space *r = space_new(page->width_mm, page->height_mm, 2.0 * strokes_text_height(s->options), &all);
    if (r && space_add_boxes(r, s->taken, s->taken_count, round_text + s->options->hatch.width_mm / 2.0))
        return r;
    space_free(r);
    return NULL;
}

/* Adds the part of a stroke from t = from to `to`. */
static void add_part(const piece *of, double from, double to, pieces *out)
{
    piece part = *of;
    const roberts_vec2 d = {of->b.x - of->a.x, of->b.y - of->a.y};
    if (from > 0.0)
        part.a = (roberts_vec2){of->a.x + from * d.x, of->a.y + from * d.y};
    if (to < 1.0)
        part.b = (roberts_vec2){of->a.x + to * d.x, of->a.y + to * d.y};
    if (!page_is_same(page_rounded(part.a), page_rounded(part.b)))
        out->item[out->count++] = part;
}

/* Adds what the boxes leave of a stroke. False: no memory. */
static bool add_free_parts(const strokes *s, const free_space *r, const piece *of, space_parts *covered, pieces *out,
                           size_t *room)
{
    double from = 0.0;
    if (!space_find_covered(r, page_in_mm(of->a, s->units_per_mm), page_in_mm(of->b, s->units_per_mm), covered) ||
        !array_reserve(&out->item, room, out->count + covered->count + 1, sizeof *out->item))
        return false;
    for (size_t i = 0; i < covered->count; i++) {
        add_part(of, from, covered->item[i].from, out);
        from = covered->item[i].to;
    }
    add_part(of, from, 1.0, out);
    return true;
}

bool hatch_spare_text(const strokes *s, pieces *p)
{
    size_t first = 0, room = 0;
    pieces cut = {0}; /* the hatching, which comes behind all other pieces */
    space_parts covered = {0};
    while (first < p->count && p->item[first].line != LINE_HATCH)
        first++;
    if (s->taken_count == 0 || first == p->count)
        return true;
    free_space *r = text_boxes(s);
    bool done = r != NULL;
    for (size_t i = first; i < p->count && done; i++)
        if (p->item[i].line == LINE_HATCH)
            done = add_free_parts(s, r, &p->item[i], &covered, &cut, &room);
    space_free(r);
    free(covered.item);
    if (done && first + cut.count > p->count) {
        piece *larger = realloc(p->item, (first + cut.count) * sizeof *larger);
        done = larger != NULL;
        p->item = larger ? larger : p->item;
    }
    if (done && cut.count > 0)
        memcpy(p->item + first, cut.item, cut.count * sizeof *cut.item);
    p->count = done ? first + cut.count : p->count;
    free(cut.item);
    return done;
}
