/* check.c - compares what a page shows with the segments that it was drawn from.
 *
 * The points within a distance of a line form a convex set, so a straight row meets it in one interval. The intervals
 * of all lines nearby have to cover the row, and those of all rows nearby have to cover a line. Nothing is sampled. */
#include "check.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/box.h"
#include "draw/sheet.h"

static const double near_mm = 0.01; /* how far what is drawn may lie from where it has to be */
static const double left_out_mm =
    0.002;                            /* what may be left out, alone or where classes meet: rounded twice by 0.0007 */
static const double point_mm = 0.4;   /* Cairo gives some sharp corners of closed lines a point */
static const double symbol_mm = 24.0; /* more than its width and its height */

enum { TOLD_MOST = 5 };

static const uint32_t white = 0xffffff;

size_t findings_total(const findings *f)
{
    return f->missing + f->unfounded + f->twice + f->pixels;
}

static bool tell(const findings *f)
{
    return f->out && findings_total(f) < TOLD_MOST;
}

/* ---- rows ------------------------------------------------------------------------------------------------------ */

static int class_of(const roberts_segment *s)
{
    return s->state == ROBERTS_HIDDEN ? ROBERTS_BACK : s->line == ROBERTS_BACK ? ROBERTS_OUTLINE : s->line;
}

static const roberts_pen *pen_of(const roberts_draw_options *options, int line)
{
    const roberts_pen *const pen[] = {
        [ROBERTS_OUTLINE] = &options->outline, [ROBERTS_CREASE] = &options->crease,
        [ROBERTS_BACK] = &options->back,       [ROBERTS_BORDER] = &options->border,
        [ROBERTS_WIRE] = &options->wire,       [ROBERTS_INTERSECTION] = &options->intersection,
    };
    return pen[line];
}

static bool is_drawn(const roberts_segment *s, const roberts_draw_options *options)
{
    if (s->state == ROBERTS_CLIPPED || (s->state == ROBERTS_HIDDEN && options->hidden == ROBERTS_HIDDEN_NONE))
        return false;
    return !pen_of(options, class_of(s))->off;
}

static bool add_rows(row_list *r, const roberts_drawing *d, const roberts_draw_options *options, const page_map *map,
                     roberts_vec2 low, roberts_vec2 high)
{
    r->epsilon = fmax(r->epsilon, d->epsilon);
    for (size_t i = 0; i < d->count + d->cut_count; i++) {
        const roberts_segment *s = &d->segment[i];
        double t0 = 0.0, t1 = 1.0, x = s->p1.x - s->p0.x, y = s->p1.y - s->p0.y, z = s->z1 - s->z0;
        if (!is_drawn(s, options) || (d->framed && !(box_clip(s->p0.x, s->p1.x, low.x, high.x, &t0, &t1) &&
                                                     box_clip(s->p0.y, s->p1.y, low.y, high.y, &t0, &t1))))
            continue;
        if (!array_reserve(&r->item, &r->room, r->count + 1, sizeof *r->item))
            return false;
        r->item[r->count++] = (row){.a = page_place(map, (roberts_vec2){s->p0.x + t0 * x, s->p0.y + t0 * y}),
                                    .b = page_place(map, (roberts_vec2){s->p0.x + t1 * x, s->p0.y + t1 * y}),
                                    .za = s->z0 + t0 * z,
                                    .zb = s->z0 + t1 * z,
                                    .line = class_of(s),
                                    .segment = (uint32_t)i};
    }
    return true;
}

/* The box of what is drawn. */
static void find_box(const roberts_drawing *d, const roberts_draw_options *options, roberts_vec2 *low,
                     roberts_vec2 *high)
{
    *low = (roberts_vec2){INFINITY, INFINITY};
    *high = (roberts_vec2){-INFINITY, -INFINITY};
    for (size_t i = 0; i < d->count + d->cut_count; i++)
        for (int k = 0; k < 2 && is_drawn(&d->segment[i], options); k++) {
            roberts_vec2 p = k ? d->segment[i].p1 : d->segment[i].p0;
            *low = (roberts_vec2){fmin(low->x, p.x), fmin(low->y, p.y)};
            *high = (roberts_vec2){fmax(high->x, p.x), fmax(high->y, p.y)};
        }
    if (low->x > high->x)
        *low = *high = (roberts_vec2){0.0, 0.0};
}

bool rows_place(row_list *r, const roberts_drawing *drawing, const roberts_draw_options *options)
{
    const double from_frame = 5.0;
    roberts_page page = options->page;
    roberts_vec2 low = drawing->window_min, high = drawing->window_max;
    *r = (row_list){.frame_mm = {{page.margin_mm, page.margin_mm},
                                 {page.width_mm - page.margin_mm, page.height_mm - page.margin_mm}}};
    double room = fmin(page.width_mm, page.height_mm) - 2.0 * page.margin_mm;
    if (!options->frame.off && !drawing->framed)
        page.margin_mm += fmin(from_frame, room / 10.0);
    if (drawing->framed)
        roberts_page_shape(&page, &low, &high);
    else if (!drawing->windowed)
        find_box(drawing, options, &low, &high);
    double wide = high.x - low.x, tall = high.y - low.y, x = page.width_mm - 2.0 * page.margin_mm,
           y = page.height_mm - 2.0 * page.margin_mm;
    double scale = wide * y > tall * x ? x / wide : tall > 0.0 ? y / tall : 1.0;
    page_map map = {.centre = {(low.x + high.x) / 2.0, (low.y + high.y) / 2.0},
                    .half = 1.0,
                    .half_mm = scale,
                    .page_mm = {page.width_mm / 2.0, page.height_mm / 2.0}};
    if (drawing->framed) {
        r->frame_mm[0] = page_place(&map, (roberts_vec2){low.x, high.y});
        r->frame_mm[1] = page_place(&map, (roberts_vec2){high.x, low.y});
    }
    return add_rows(r, drawing, options, &map, low, high);
}

/* Where the views lie is taken from src/draw: what a sheet looks like has tests of its own. */
bool rows_place_sheet(row_list *r, const roberts_sheet *sheet, const roberts_draw_options *options)
{
    const roberts_page *page = &options->page;
    sheet_map map;
    *r = (row_list){.frame_mm = {{page->margin_mm, page->margin_mm},
                                 {page->width_mm - page->margin_mm, page->height_mm - page->margin_mm}}};
    bool done = sheet_lay(sheet, options, &(sheet_reach){0}, &map, NULL);
    for (int i = 0; i < ROBERTS_SHEET_VIEWS && done; i++)
        if (sheet->view[i])
            done = add_rows(r, sheet->view[i], options, &map.view[i], (roberts_vec2){0}, (roberts_vec2){0});
    return done;
}

void rows_free(row_list *r)
{
    free(r->item);
    *r = (row_list){0};
}

/* ---- straight lines -------------------------------------------------------------------------------------------- */

static double length_of(roberts_vec2 a, roberts_vec2 b)
{
    return hypot(b.x - a.x, b.y - a.y);
}

/* A part of a line, in mm from its beginning. */
typedef struct interval {
    double from, to;
} interval;

/* The part of the straight line through `a` along `u` within `reach` of point c; empty if from > to. */
static interval in_disc(roberts_vec2 a, roberts_vec2 u, roberts_vec2 c, double reach)
{
    double x = c.x - a.x, y = c.y - a.y, along = x * u.x + y * u.y, beside = x * u.y - y * u.x;
    double half = reach * reach - beside * beside;
    return half < 0.0 ? (interval){INFINITY, -INFINITY} : (interval){along - sqrt(half), along + sqrt(half)};
}

/* Narrows t so that start + t slope lies between low and high. */
static void narrow(interval *t, double start, double slope, double low, double high)
{
    if (slope == 0.0) {
        if (start < low || start > high)
            *t = (interval){INFINITY, -INFINITY};
        return;
    }
    double p = (low - start) / slope, q = (high - start) / slope;
    t->from = fmax(t->from, fmin(p, q));
    t->to = fmin(t->to, fmax(p, q));
}

/* The part of line ab within `reach` of line pq; empty if from > to. */
static interval within(roberts_vec2 a, roberts_vec2 b, roberts_vec2 p, roberts_vec2 q, double reach)
{
    double length = length_of(a, b), other = length_of(p, q);
    roberts_vec2 u = length > 0.0 ? (roberts_vec2){(b.x - a.x) / length, (b.y - a.y) / length} : (roberts_vec2){1, 0};
    interval first = in_disc(a, u, p, reach), last = in_disc(a, u, q, reach), middle = {INFINITY, -INFINITY};
    if (other > 0.0) {
        roberts_vec2 v = {(q.x - p.x) / other, (q.y - p.y) / other};
        double x = a.x - p.x, y = a.y - p.y;
        middle = (interval){-INFINITY, INFINITY};
        narrow(&middle, x * v.x + y * v.y, u.x * v.x + u.y * v.y, 0.0, other);
        narrow(&middle, x * v.y - y * v.x, u.x * v.y - u.y * v.x, -reach, reach);
        if (middle.from > middle.to)
            middle = (interval){INFINITY, -INFINITY};
    }
    interval all = {fmin(middle.from, fmin(first.from, last.from)), fmax(middle.to, fmax(first.to, last.to))};
    return (interval){fmax(all.from, 0.0), fmin(all.to, length)};
}

/* ---- covering -------------------------------------------------------------------------------------------------- */

typedef struct intervals {
    interval *item;
    size_t count, room;
    bool failed;
} intervals;

static void add_interval(intervals *list, interval t)
{
    if (t.from > t.to)
        return;
    list->failed = list->failed || !array_reserve(&list->item, &list->room, list->count + 1, sizeof *list->item);
    if (!list->failed)
        list->item[list->count++] = t;
}

static int by_from(const void *a, const void *b)
{
    const interval *p = a, *q = b;
    return p->from < q->from ? -1 : p->from > q->from;
}

/* The first part of 0 .. length, from `*at` on, that the intervals leave open; `*at` becomes its end. False: none. */
static bool next_open(intervals *list, double length, double *at, interval *open)
{
    if (list->count)
        qsort(list->item, list->count, sizeof *list->item, by_from);
    double reached = *at;
    for (size_t i = 0; i < list->count && list->item[i].from <= reached; i++)
        reached = fmax(reached, list->item[i].to);
    if (reached >= length)
        return false;
    *open = (interval){reached, length};
    for (size_t i = 0; i < list->count; i++)
        if (list->item[i].from > reached) {
            open->to = fmin(list->item[i].from, length);
            break;
        }
    *at = open->to;
    return true;
}

static bool boxes_meet(roberts_vec2 a, roberts_vec2 b, roberts_vec2 p, roberts_vec2 q, double reach)
{
    return lesser(a.x, b.x) <= greater(p.x, q.x) + reach && greater(a.x, b.x) >= lesser(p.x, q.x) - reach &&
           lesser(a.y, b.y) <= greater(p.y, q.y) + reach && greater(a.y, b.y) >= lesser(p.y, q.y) - reach;
}

static roberts_vec2 point_at(roberts_vec2 a, roberts_vec2 b, double t)
{
    double length = length_of(a, b);
    double k = length > 0.0 ? t / length : 0.0;
    return (roberts_vec2){a.x + k * (b.x - a.x), a.y + k * (b.y - a.y)};
}

/* How much the depth of a row changes per mm. */
static double steepness(const row *r)
{
    double length = length_of(r->a, r->b);
    return length > 0.0 ? fabs(r->zb - r->za) / length : 0.0;
}

static double depth_near(const row *r, roberts_vec2 p)
{
    double length = length_of(r->a, r->b);
    double t = length > 0.0
                   ? ((p.x - r->a.x) * (r->b.x - r->a.x) + (p.y - r->a.y) * (r->b.y - r->a.y)) / (length * length)
                   : 0.0;
    return r->za + fmin(fmax(t, 0.0), 1.0) * (r->zb - r->za);
}

static bool is_near(roberts_vec2 p, roberts_vec2 a, roberts_vec2 b)
{
    interval t = within(p, p, a, b, near_mm);
    return t.from <= t.to;
}

static bool has_line(const paper *p, roberts_vec2 at, int line)
{
    for (size_t i = 0; i < p->count; i++)
        if (p->item[i].line == line && boxes_meet(at, at, p->item[i].a, p->item[i].b, near_mm) &&
            is_near(at, p->item[i].a, p->item[i].b))
            return true;
    return false;
}

/* Whether at this point a row of another class is drawn instead of `own`: a visible row that is not farther away or, if
 * `own` is hidden, any visible row. */
static bool is_replaced(const row_list *r, const paper *p, const row *own, roberts_vec2 at)
{
    for (size_t i = 0; i < r->count; i++) {
        const row *other = &r->item[i];
        if (other->line == own->line || other->line == ROBERTS_BACK ||
            !boxes_meet(at, at, other->a, other->b, near_mm) || !is_near(at, other->a, other->b))
            continue;
        double slack = 2.0 * r->epsilon + 2.0 * near_mm * (steepness(own) + steepness(other));
        if ((own->line == ROBERTS_BACK || depth_near(other, at) >= depth_near(own, at) - slack) &&
            has_line(p, at, other->line))
            return true;
    }
    return false;
}

/* How far a point of a row of that class may lie from its drawn line. Gaps of real dashes are stretched by less than a
 * half or, on a closed line without corners, by less than two thirds. */
static double reach_of(const roberts_draw_options *options, int line)
{
    bool gaps = line == ROBERTS_BACK && options->real_dashes && options->hidden == ROBERTS_HIDDEN_DASHED;
    return near_mm + (gaps ? 0.5 * (5.0 / 3.0 * options->back.gap_mm + options->back.width_mm) : 0.0);
}

static void check_row(const row_list *r, const paper *p, const roberts_draw_options *options, const row *own,
                      findings *f)
{
    intervals list = {0};
    double length = length_of(own->a, own->b), at = 0.0, reach = reach_of(options, own->line);
    interval open;
    for (size_t i = 0; i < p->count; i++)
        if (p->item[i].line == own->line && boxes_meet(own->a, own->b, p->item[i].a, p->item[i].b, reach))
            add_interval(&list, within(own->a, own->b, p->item[i].a, p->item[i].b, reach));
    while (!list.failed && next_open(&list, length, &at, &open)) {
        roberts_vec2 middle = point_at(own->a, own->b, (open.from + open.to) / 2.0);
        if (open.to - open.from <= left_out_mm || is_replaced(r, p, own, middle))
            continue;
        if (tell(f))
            fprintf(f->out, "  segment %u, class %d, %.6f,%.6f to %.6f,%.6f: not drawn from %.6f to %.6f mm\n",
                    own->segment, own->line, own->a.x, own->a.y, own->b.x, own->b.y, open.from, open.to);
        f->missing++;
        break;
    }
    f->missing += list.failed;
    free(list.item);
}

/* The sides of the frame as rows of its class. */
static void frame_rows(const row_list *r, row side[4])
{
    roberts_vec2 p = r->frame_mm[0], q = r->frame_mm[1];
    const roberts_vec2 corner[5] = {p, {q.x, p.y}, q, {p.x, q.y}, p};
    for (int i = 0; i < 4; i++)
        side[i] = (row){.a = corner[i], .b = corner[i + 1], .line = PAPER_FRAME};
}

static void check_line(const row_list *r, const paper *p, size_t i, findings *f)
{
    const paper_line *own = &p->item[i];
    intervals list = {0};
    double length = length_of(own->a, own->b), at = 0.0;
    interval open;
    row side[4];
    frame_rows(r, side);
    for (size_t k = 0; k < r->count + 4; k++) {
        const row *other = k < r->count ? &r->item[k] : &side[k - r->count];
        if (other->line == own->line && boxes_meet(own->a, own->b, other->a, other->b, near_mm))
            add_interval(&list, within(own->a, own->b, other->a, other->b, near_mm));
    }
    if (own->line == PAPER_SYMBOL && own->a.x > r->frame_mm[1].x - symbol_mm - 5.0 && own->a.x < r->frame_mm[1].x &&
        own->a.y > r->frame_mm[1].y - symbol_mm && own->a.y < r->frame_mm[1].y)
        add_interval(&list, (interval){0.0, length});
    if (list.failed || (next_open(&list, length, &at, &open) && open.to - open.from > left_out_mm)) {
        if (tell(f))
            fprintf(f->out, "  line %zu, class %d, %.6f,%.6f to %.6f,%.6f: no row from %.6f to %.6f mm\n", i, own->line,
                    own->a.x, own->a.y, own->b.x, own->b.y, open.from, open.to);
        f->unfounded++;
    }
    free(list.item);
}

/* ---- nothing twice --------------------------------------------------------------------------------------------- */

static bool is_same_place(roberts_vec2 p, roberts_vec2 q)
{
    const double rounding = 1e-9;
    return fabs(p.x - q.x) < rounding && fabs(p.y - q.y) < rounding;
}

/* Whether the shorter of two lines lies nearer to the longer than half a unit of rounding, on a length that rounding
 * does not explain. */
static bool is_beside(const paper_line *p, const paper_line *q)
{
    const double beside = 0.0005, along = 0.02;
    const paper_line *longer = length_of(p->a, p->b) >= length_of(q->a, q->b) ? p : q, *other = longer == p ? q : p;
    double length = length_of(longer->a, longer->b);
    if (length <= along)
        return false;
    roberts_vec2 u = {(longer->b.x - longer->a.x) / length, (longer->b.y - longer->a.y) / length};
    double t[2], h[2];
    for (int i = 0; i < 2; i++) {
        roberts_vec2 at = i ? other->b : other->a;
        double x = at.x - longer->a.x, y = at.y - longer->a.y;
        t[i] = x * u.x + y * u.y;
        h[i] = x * u.y - y * u.x;
    }
    double from = fmax(0.0, fmin(t[0], t[1])), to = fmin(length, fmax(t[0], t[1]));
    return to - from > along && fabs(h[0]) < beside && fabs(h[1]) < beside;
}

/* Whether a row runs along a line at its middle. */
static bool runs_along(const row *r, const paper_line *p)
{
    const double beside = 0.0015, aslant = 0.2;
    roberts_vec2 middle = {(p->a.x + p->b.x) / 2.0, (p->a.y + p->b.y) / 2.0};
    interval t = within(middle, middle, r->a, r->b, beside);
    double x = p->b.x - p->a.x, y = p->b.y - p->a.y, u = r->b.x - r->a.x, v = r->b.y - r->a.y;
    return t.from <= t.to && fabs(x * v - y * u) <= aslant * hypot(x, y) * hypot(u, v);
}

/* Whether two rows count as lying on one line: the ends of the shorter are within 0.001 mm of the longer, and their
 * directions differ by 1e-5 radians at most; or both have the same two ends. The bounds here are a little smaller, so
 * that rounding does not decide. */
static bool is_one_line(const row *p, const row *q)
{
    const double touch = 0.0009, same_direction = 0.9e-5;
    const row *longer = length_of(p->a, p->b) >= length_of(q->a, q->b) ? p : q, *other = longer == p ? q : p;
    if ((length_of(p->a, q->a) <= touch && length_of(p->b, q->b) <= touch) ||
        (length_of(p->a, q->b) <= touch && length_of(p->b, q->a) <= touch))
        return true;
    double length = length_of(longer->a, longer->b), shorter = length_of(other->a, other->b);
    double x = (longer->b.x - longer->a.x) / length, y = (longer->b.y - longer->a.y) / length;
    double from = x * (other->a.y - longer->a.y) - y * (other->a.x - longer->a.x);
    double to = x * (other->b.y - longer->a.y) - y * (other->b.x - longer->a.x);
    return fabs(from) <= touch && fabs(to) <= touch && fabs(to - from) <= same_direction * shorter;
}

/* Whether a row lies on the endless line through a drawn one, wherever on the page. */
static bool is_in_line(const row *r, const paper_line *p)
{
    const double beside = 0.0015, length = length_of(p->a, p->b);
    double x = (p->b.x - p->a.x) / length, y = (p->b.y - p->a.y) / length;
    return fabs(x * (r->a.y - p->a.y) - y * (r->a.x - p->a.x)) <= beside &&
           fabs(x * (r->b.y - p->a.y) - y * (r->b.x - p->a.x)) <= beside;
}

static bool belongs_to(const row *r, const paper_line *p)
{
    return runs_along(r, p) || is_in_line(r, p);
}

/* Whether all rows along two lines count as lying on one line. They may not: edges may meet at a very small angle, or
 * only some of them may be within 0.001 mm of one another. Then there is no single right grouping. */
static bool are_one_line(const row_list *r, const paper_line *p, const paper_line *q)
{
    for (size_t i = 0; i < r->count; i++) {
        bool first = belongs_to(&r->item[i], p) || belongs_to(&r->item[i], q);
        for (size_t k = 0; k < i && first; k++)
            if ((belongs_to(&r->item[k], p) || belongs_to(&r->item[k], q)) && !is_one_line(&r->item[i], &r->item[k]))
                return false;
    }
    return true;
}

static bool is_same_line(const paper_line *p, const paper_line *q)
{
    return (is_same_place(p->a, q->a) && is_same_place(p->b, q->b)) ||
           (is_same_place(p->a, q->b) && is_same_place(p->b, q->a));
}

static void check_twice(const row_list *r, const paper *p, findings *f)
{
    for (size_t i = 0; i < p->count; i++)
        for (size_t k = 0; k < i; k++) {
            const paper_line *own = &p->item[i], *other = &p->item[k];
            if (own->line >= PAPER_FRAME || other->line >= PAPER_FRAME ||
                !boxes_meet(own->a, own->b, other->a, other->b, 0.0))
                continue;
            if ((!is_same_line(own, other) && !is_beside(own, other)) || !are_one_line(r, own, other))
                continue;
            if (tell(f))
                fprintf(f->out, "  lines %zu and %zu, classes %d and %d, are one: %.6f,%.6f to %.6f,%.6f\n", k, i,
                        other->line, own->line, own->a.x, own->a.y, own->b.x, own->b.y);
            f->twice++;
        }
}

void check_lines(const row_list *r, const paper *p, const roberts_draw_options *options, findings *f)
{
    row side[4];
    for (size_t i = 0; i < r->count; i++)
        check_row(r, p, options, &r->item[i], f);
    frame_rows(r, side);
    for (int i = 0; i < 4 && !options->frame.off; i++)
        check_row(r, p, options, &side[i], f);
    for (size_t i = 0; i < p->count; i++)
        check_line(r, p, i, f);
    if (options->format == ROBERTS_SVG) /* a PDF's coordinates are rounded more coarsely */
        check_twice(r, p, f);
}

bool check_same(const paper *p, const paper *q)
{
    const double rounding = 0.003; /* mm of a line: a PDF has 1/256 of a point and three digits of it */
    double length = 0.0;
    for (size_t i = 0; i < p->count; i++)
        length += length_of(p->item[i].a, p->item[i].b);
    for (size_t i = 0; i < q->count; i++)
        length -= length_of(q->item[i].a, q->item[i].b);
    return fabs(length) <= rounding * (double)p->count;
}

/* ---- pixels ---------------------------------------------------------------------------------------------------- */

/* The channel of a class, 0 to 255. Only hidden lines have blue; further classes have as much
 * red as green, so that they show none of the three. */
static int part(uint32_t pixel, int line)
{
    static const int shift[] = {[ROBERTS_OUTLINE] = 16, [ROBERTS_CREASE] = 8, [ROBERTS_BACK] = 0};
    return (int)(pixel >> shift[line] & 255);
}

/* Whether a pixel shows a class alone: its channel is strong and the other two are weak. */
static bool shows(uint32_t pixel, int line)
{
    int other = part(pixel, (line + 1) % 3), third = part(pixel, (line + 2) % 3);
    return part(pixel, line) >= 128 && other < 128 && third < 128;
}

/* Whether the pixel at a point of a row has the right colour. Depth decides which of two visible classes is drawn;
 * check_lines() checks that. Visible lines cover hidden ones. */
static bool is_drawn_at(const picture *p, const roberts_draw_options *options, int line, roberts_vec2 at, double scale)
{
    int x = (int)(at.x * scale), y = (int)(at.y * scale);
    uint32_t pixel = p->pixel[(size_t)y * (size_t)p->width + (size_t)x];
    int visible = part(pixel, ROBERTS_OUTLINE) + part(pixel, ROBERTS_CREASE), hidden = part(pixel, ROBERTS_BACK);
    if (line != ROBERTS_BACK)
        return visible >= 200 && hidden < 100;
    return options->hidden == ROBERTS_HIDDEN_DASHED || (visible + hidden >= 200 && visible + hidden < 600);
}

/* Sets the class's bit of all pixels within `reach` of a point. */
static void mark(unsigned char *near, const picture *p, int line, roberts_vec2 at, double reach)
{
    int x0 = (int)floor(at.x - reach), x1 = (int)ceil(at.x + reach), y0 = (int)floor(at.y - reach),
        y1 = (int)ceil(at.y + reach);
    for (int y = y0 < 0 ? 0 : y0; y <= y1 && y < p->height; y++)
        for (int x = x0 < 0 ? 0 : x0; x <= x1 && x < p->width; x++)
            near[(size_t)y * (size_t)p->width + (size_t)x] |= (unsigned char)(1 << line);
}

void check_pixels(const row_list *r, const picture *p, const roberts_draw_options *options, findings *f)
{
    const double scale = options->dpi / 25.4, step = 0.5; /* pixels per mm; pixels */
    size_t pixels = (size_t)p->width * (size_t)p->height;
    unsigned char *near = alloc_zeroed(pixels, 1);
    if (!near) {
        f->pixels++;
        return;
    }
    for (size_t i = 0; i < r->count; i++) {
        const row *own = &r->item[i];
        double length = length_of(own->a, own->b),
               reach = scale * (0.5 * pen_of(options, own->line)->width_mm + point_mm);
        bool missed = false;
        int steps = (int)ceil(length * scale / step);
        for (int k = 0; k <= steps; k++) {
            roberts_vec2 at = point_at(own->a, own->b, fmin(k * step / scale, length));
            missed = missed || !is_drawn_at(p, options, own->line, at, scale);
            mark(near, p, own->line, (roberts_vec2){at.x * scale, at.y * scale}, reach);
        }
        if (missed && length > left_out_mm) {
            if (tell(f))
                fprintf(f->out, "  segment %u, class %d, %.6f,%.6f to %.6f,%.6f: pixels without it\n", own->segment,
                        own->line, own->a.x, own->a.y, own->b.x, own->b.y);
            f->pixels++;
        }
    }
    for (size_t i = 0; i < pixels; i++)
        for (int line = ROBERTS_OUTLINE; line <= ROBERTS_BACK && (p->pixel[i] & white) != white; line++)
            if (shows(p->pixel[i], line) && !(near[i] & 1 << line)) {
                if (tell(f))
                    fprintf(f->out, "  pixel %zu,%zu shows class %d, and no row is near\n", i % (size_t)p->width,
                            i / (size_t)p->width, line);
                f->pixels++;
            }
    free(near);
}
