/* fills.c - see fills.h.
 *
 * The sides of all regions are sorted by their ends. Where two regions of one colour share a side, it is dropped; where
 * the colours differ, or regions are elements of their own, it gets a seam. The remaining sides of a colour are joined
 * to rings. Two regions have the same corners along a border, which are rounded to the same points of the page, so only
 * whole numbers are compared. */
#include "draw/fills.h"

#include <math.h>
#include <stdlib.h>

#include "base/angle.h"
#include "base/array.h"
#include "base/sort.h"
#include "base/vec.h"
#include "draw/shade.h"
#include "draw/strokes.h"

/* mm. The widest seam is wider than a pixel of a screen (96 dpi), so that it covers the gaps that smoothing leaves.
 * Where lines bound the picture, it is no wider than these, so that it does not stick out of thin parts. */
static const double widest_seam = 0.4, narrowest_seam = 0.15;

/* ---- colours --------------------------------------------------------------------------------------------------- */

/* Colours for neighbouring areas below black lines, which the colour-blind can distinguish too: the scheme "light" of
 * P. Tol, "Colour schemes", SRON technical note 09-002, 2021. */
static const fill_color palette[] = {{119, 170, 221, 255}, {238, 136, 102, 255}, {238, 221, 136, 255},
                                     {255, 170, 187, 255}, {153, 221, 255, 255}, {68, 187, 153, 255},
                                     {187, 204, 51, 255},  {170, 170, 0, 255},   {221, 221, 221, 255}};

enum { PALETTE = sizeof palette / sizeof palette[0] };

static const fill_color clear = {0, 0, 0, 0}, unpainted = {235, 235, 235, 255};

static unsigned char part_of(float value)
{
    double part = 255.0 * fmin(fmax((double)value, 0.0), 1.0);
    return (unsigned char)(part + 0.5);
}

/* An index into a colour map, which files do not have, chooses from the palette. */
static fill_color model_color(const roberts_color *color)
{
    const float *v = color->value;
    if (color->count == 0)
        return clear;
    if (color->count < 3) {
        double index = fmod(fabs(floor((double)v[0])), PALETTE);
        return palette[(size_t)index];
    }
    return (fill_color){part_of(v[0]), part_of(v[1]), part_of(v[2]), color->count > 3 ? part_of(v[3]) : 255};
}

static unsigned char darker(unsigned char part, double brightness)
{
    return (unsigned char)(part * brightness + 0.5);
}

fill_color fills_color(const roberts_draw_options *options, const roberts_region *region)
{
    fill_color color = clear;
    if (options->fill == ROBERTS_FILL_COLOR)
        color = (fill_color){options->fill_color[0], options->fill_color[1], options->fill_color[2], 255};
    else if (options->fill == ROBERTS_FILL_BODY)
        color = palette[region->solid % PALETTE];
    else if (options->fill == ROBERTS_FILL_MODEL)
        color = model_color(&region->color);
    if (!options->shaded)
        return color;
    double brightness = shade(region->normal, options->light);
    if (options->fill == ROBERTS_FILL_MODEL && region->color.count == 0)
        color = unpainted;
    return (fill_color){darker(color.red, brightness), darker(color.green, brightness), darker(color.blue, brightness),
                        color.alpha};
}

static unsigned char mix(unsigned char above, unsigned char below, unsigned char alpha)
{
    return (unsigned char)((above * alpha + below * (255 - alpha) + 127) / 255);
}

fill_color fills_on_paper(const roberts_draw_options *options, fill_color color)
{
    const roberts_background white = {true, 255, 255, 255};
    const roberts_background *paper = options->background.on ? &options->background : &white;
    return (fill_color){mix(color.red, paper->red, color.alpha), mix(color.green, paper->green, color.alpha),
                        mix(color.blue, paper->blue, color.alpha), 255};
}

/* ---- sides ----------------------------------------------------------------------------------------------------- */

/* A side of an area of one key, or one direction of a seam. */
typedef struct fill_side {
    page_point a, b;
    uint64_t key; /* its colour, and above it the body, where lines are grouped */
    uint32_t done;
} fill_side;

typedef struct side_list {
    fill_side *item;
    size_t count, room;
} side_list;

typedef struct fill_work {
    const strokes *s;
    side_list side, seam;
    page_point *rim; /* [rim_count] ends of sides with nothing behind them, sorted */
    size_t rim_count, rim_room;
} fill_work;

static uint64_t key_of(fill_color c, uint32_t body)
{
    return (uint64_t)body << 32 | (uint32_t)c.red << 24 | (uint32_t)c.green << 16 | (uint32_t)c.blue << 8 | c.alpha;
}

static fill_color color_of(uint64_t key)
{
    return (fill_color){(unsigned char)(key >> 24), (unsigned char)(key >> 16), (unsigned char)(key >> 8),
                        (unsigned char)key};
}

static bool is_opaque(uint64_t key)
{
    return (key & 255) == 255;
}

static int compare_points(page_point p, page_point q)
{
    return p.x != q.x ? (p.x < q.x ? -1 : 1) : (p.y > q.y) - (p.y < q.y);
}

static bool add_fill_side(side_list *to, page_point a, page_point b, uint64_t key)
{
    if (!array_reserve(&to->item, &to->room, to->count + 1, sizeof *to->item))
        return false;
    to->item[to->count++] = (fill_side){a, b, key, 0};
    return true;
}

static bool take_region(void *context, const page_region *region)
{
    fill_work *w = context;
    const fill_color color = fills_color(w->s->options, region->region);
    const uint64_t key = key_of(color, strokes_are_grouped(w->s->options) ? region->region->solid : ROBERTS_NONE);
    bool enough = true;
    for (size_t r = 0; color.alpha > 0 && enough && r < region->ring_count; r++) {
        size_t first = region->ring_start[r], end = region->ring_start[r + 1];
        page_point a = page_rounded(region->point[end - 1]);
        for (size_t k = first; enough && k < end; k++) {
            page_point b = page_rounded(region->point[k]);
            if (!page_is_same(a, b))
                enough = add_fill_side(&w->side, a, b, key);
            a = b;
        }
    }
    return enough;
}

/* Sides between the same two points follow one another, by key. */
static int compare_places(const void *pa, const void *pb)
{
    const fill_side *s = pa, *t = pb;
    bool s_up = compare_points(s->a, s->b) < 0, t_up = compare_points(t->a, t->b) < 0;
    int order = compare_points(s_up ? s->a : s->b, t_up ? t->a : t->b);
    if (order == 0)
        order = compare_points(s_up ? s->b : s->a, t_up ? t->b : t->a);
    return order != 0 ? order : (s->key > t->key) - (s->key < t->key);
}

static bool is_same_place(const fill_side *s, const fill_side *t)
{
    return (page_is_same(s->a, t->a) && page_is_same(s->b, t->b)) ||
           (page_is_same(s->a, t->b) && page_is_same(s->b, t->a));
}

/* Adds a seam along a side, in its colour. False: no memory. */
static bool add_seam_along(fill_work *w, const fill_side *side)
{
    return add_fill_side(&w->seam, side->a, side->b, side->key) && add_fill_side(&w->seam, side->b, side->a, side->key);
}

/* Adds a seam if colours lie on both sides of a place, whose sides are item[from] .. item[to - 1]. False: no memory. */
static bool add_seam(fill_work *w, size_t from, size_t to)
{
    const fill_side *first = &w->side.item[from];
    bool both = false;
    for (size_t i = from + 1; i < to && is_opaque(w->side.item[i].key); i++)
        both = both || (w->side.item[i].key != first->key && !page_is_same(w->side.item[i].a, first->a));
    return !both || !is_opaque(first->key) || add_seam_along(w, first);
}

/* Records the ends of sides with nothing filled on their other side. False: no memory. */
static bool add_rim(fill_work *w, size_t from, size_t to)
{
    const fill_side *first = &w->side.item[from];
    for (size_t i = from + 1; i < to; i++)
        if (!page_is_same(w->side.item[i].a, first->a))
            return true;
    if (from == to)
        return true;
    if (!array_reserve(&w->rim, &w->rim_room, w->rim_count + 2, sizeof *w->rim))
        return false;
    w->rim[w->rim_count++] = first->a;
    w->rim[w->rim_count++] = first->b;
    return true;
}

static int compare_rims(const void *pa, const void *pb)
{
    return compare_points(*(const page_point *)pa, *(const page_point *)pb);
}

static bool is_rim(const fill_work *w, page_point p)
{
    return w->rim_count > 0 && bsearch(&p, w->rim, w->rim_count, sizeof *w->rim, compare_rims);
}

/* Drops sides with one colour on both sides, and finds the seams. False: no memory. */
static bool join_regions(fill_work *w)
{
    fill_side *item = w->side.item;
    const bool apart = strokes_are_grouped(w->s->options); /* each region is painted by itself */
    size_t kept = 0, count = w->side.count;
    bool enough = true;
    if (count > 1)
        qsort(item, count, sizeof *item, compare_places);
    for (size_t i = 0, next; enough && i < count; i = next) {
        size_t place = kept;
        for (next = i; enough && next < count && is_same_place(&item[next], &item[i]); next++)
            if (kept > place && item[kept - 1].key == item[next].key && !page_is_same(item[kept - 1].a, item[next].a)) {
                kept--; /* they run against one another */
                enough = !apart || !is_opaque(item[next].key) || add_seam_along(w, &item[next]);
            } else {
                item[kept++] = item[next];
            }
        enough = enough && add_rim(w, place, kept) && add_seam(w, place, kept);
    }
    w->side.count = kept;
    if (w->rim_count > 1)
        qsort(w->rim, w->rim_count, sizeof *w->rim, compare_rims);
    return enough;
}

/* ---- lines ----------------------------------------------------------------------------------------------------- */

static int compare_starts(const void *pa, const void *pb)
{
    const fill_side *s = pa, *t = pb;
    if (s->key != t->key)
        return s->key < t->key ? -1 : 1;
    int order = compare_points(s->a, t->a);
    return order != 0 ? order : compare_points(s->b, t->b);
}

/* The first side of a key that begins at a point or behind it. */
static size_t first_from(const side_list *sides, page_point a, uint64_t key)
{
    const fill_side least = {.a = a, .b = {INT32_MIN, INT32_MIN}, .key = key};
    return find_first(&least, sides->item, sides->count, sizeof *sides->item, compare_starts);
}

/* Whether d comes before e, turning clockwise on the paper from the direction back along the line. */
static bool turns_sooner(page_point from, page_point at, page_point d, page_point e)
{
    const double back = atan2((double)from.y - at.y, (double)from.x - at.x), turn = 2.0 * PI;
    double to_d = atan2((double)d.y - at.y, (double)d.x - at.x) - back;
    double to_e = atan2((double)e.y - at.y, (double)e.x - at.x) - back;
    to_d += to_d <= 0.0 ? turn : 0.0;
    to_e += to_e <= 0.0 ? turn : 0.0;
    return to_d < to_e;
}

/* The side that continues where another one ends; of several, the one that goes round the filled area. SIZE_MAX: there
 * is none. */
static size_t next_side(const side_list *sides, const fill_side *from)
{
    size_t found = SIZE_MAX;
    for (size_t i = first_from(sides, from->b, from->key);
         i < sides->count && sides->item[i].key == from->key && page_is_same(sides->item[i].a, from->b); i++)
        if (!sides->item[i].done &&
            (found == SIZE_MAX || turns_sooner(from->a, from->b, sides->item[i].b, sides->item[found].b)))
            found = i;
    return found;
}

/* Where the other direction of a seam is in the list. */
static size_t reverse_of(const side_list *sides, const fill_side *side)
{
    size_t i = first_from(sides, side->b, side->key);
    while (sides->item[i].done || !page_is_same(sides->item[i].b, side->a))
        i++;
    return i;
}

/* Closes the last line. Drops its end and its start if they lie straight between their neighbours. */
static void close_ring(polylines *out)
{
    polyline *line = &out->item[out->count - 1];
    page_point *p = out->point + line->first;
    line->closed = true;
    if (line->count > 3 && page_is_between(p[line->count - 2], p[line->count - 1], p[0])) {
        line->count--;
        out->point_count--;
    }
    if (line->count > 3 && page_is_between(p[line->count - 1], p[0], p[1])) {
        p[0] = p[--line->count];
        out->point_count--;
    }
}

/* Draws the ring that begins with side `first`. False: no memory. */
static bool draw_ring(side_list *sides, size_t first, polylines *out)
{
    const page_point start = sides->item[first].a;
    bool enough = polylines_start(out) && polylines_extend(out, start);
    for (size_t i = first; enough && i != SIZE_MAX;) {
        fill_side *side = &sides->item[i];
        side->done = 1;
        bool back = page_is_same(side->b, start);
        enough = back || polylines_extend(out, side->b);
        i = back ? SIZE_MAX : next_side(sides, side);
    }
    if (enough)
        close_ring(out);
    return enough;
}

/* Moves p toward q by `units`, but no farther than to the middle. */
static page_point moved(page_point p, page_point q, double units)
{
    double part = fmin(units / page_distance(p, q), 0.5);
    return page_rounded((roberts_vec2){p.x + part * (q.x - p.x), p.y + part * (q.y - p.y)});
}

/* Draws the seam that begins with side `first`, up to its end. Seams have round ends. Where the filled area ends, a
 * seam is cut short by its width, so that its end does not stick out unless the angle there is less than 30 degrees.
 * False: no memory. */
static bool draw_seam(fill_work *w, size_t first, fills *out)
{
    polylines *lines = &out->lines;
    const double trim = out->seam_mm * w->s->units_per_mm;
    bool enough = polylines_start(lines) && polylines_extend(lines, w->seam.item[first].a), ends = false;
    for (size_t i = first; enough && i != SIZE_MAX;) {
        fill_side *side = &w->seam.item[i];
        w->seam.item[reverse_of(&w->seam, side)].done = 1;
        side->done = 1;
        enough = polylines_extend(lines, side->b);
        ends = is_rim(w, side->b);
        i = ends ? SIZE_MAX : next_side(&w->seam, side);
    }
    if (!enough)
        return false;
    page_point *start = lines->point + lines->item[lines->count - 1].first;
    page_point *end = lines->point + lines->point_count - 1;
    if (is_rim(w, *start))
        *start = moved(*start, start[1], trim);
    if (ends)
        *end = moved(*end, end[-1], trim);
    return true;
}

/* Appends all lines of the sides, key by key. False: no memory. */
static bool paint(fill_work *w, bool seam, fills *out)
{
    side_list *sides = seam ? &w->seam : &w->side;
    bool enough = true;
    if (sides->count > 1)
        qsort(sides->item, sides->count, sizeof *sides->item, compare_starts);
    for (size_t i = 0; enough && i < sides->count; i++) {
        if (i == 0 || sides->item[i].key != sides->item[i - 1].key) {
            enough = array_reserve(&out->paint, &out->room, out->count + 1, sizeof *out->paint);
            if (enough)
                out->paint[out->count++] = (fill_paint){color_of(sides->item[i].key), seam, out->lines.count,
                                                        out->lines.count, (uint32_t)(sides->item[i].key >> 32)};
        }
        if (enough && !sides->item[i].done)
            enough = seam ? draw_seam(w, i, out) : draw_ring(sides, i, &out->lines);
        if (enough)
            out->paint[out->count - 1].end = out->lines.count;
    }
    return enough;
}

/* ---- plates ---------------------------------------------------------------------------------------------------- */

/* Letters can be read if they have this contrast with what lies below them (WCAG 2, level AA). Paler letters, as those
 * of what is hidden, need not have it: a large part of their contrast with the paper is enough. */
static const double least_contrast = 4.5, pale_part = 0.75;
/* How far a plate reaches beyond its letters, in their heights. */
static const double plate_rim = 0.25;

typedef struct plate {
    roberts_vec2 corner[4]; /* counter-clockwise on the paper from where the text begins; units of the page */
    bool is_back, is_wanted;
} plate;

enum { PLATE_POINTS = 5 };

/* The middle of a plate, and four points halfway to its corners: letters lie there. */
static roberts_vec2 plate_point(const plate *p, int i)
{
    const roberts_vec2 a = p->corner[0], c = p->corner[2], middle = {0.5 * (a.x + c.x), 0.5 * (a.y + c.y)};
    if (i == 0)
        return middle;
    return (roberts_vec2){0.5 * (middle.x + p->corner[i - 1].x), 0.5 * (middle.y + p->corner[i - 1].y)};
}

typedef struct plate_work {
    const strokes *s;
    plate *item; /* [count] of the page's notes */
    size_t count;
} plate_work;

static plate plate_of(const strokes *s, size_t i)
{
    const text_line line = notes_line(&s->notes, i);
    const roberts_vec2 along = line.along, up = text_upward(along);
    const double width = strokes_text_width(s->options, line.text, line.height_mm), rim = plate_rim * line.height_mm;
    const double x[2] = {-line.align * width - rim, (1.0 - line.align) * width + rim};
    const double y[2] = {-rim, line.height_mm + rim};
    plate p = {.is_back = s->notes.item[i].is_back};
    for (int k = 0; k < 4; k++) {
        const double right = x[k == 1 || k == 2], high = y[k >= 2];
        p.corner[k] = (roberts_vec2){s->units_per_mm * (line.at.x + right * along.x + high * up.x),
                                     s->units_per_mm * (line.at.y + right * along.y + high * up.y)};
    }
    return p;
}

/* The light that a channel of sRGB (IEC 61966-2-1) gives, from 0 to 1. */
static double light_of(unsigned char value)
{
    const double part = value / 255.0;
    return part <= 0.04045 ? part / 12.92 : pow((part + 0.055) / 1.055, 2.4);
}

/* The luminance that contrasts compare (WCAG 2): 0.05 stands for the light of the room. */
static double luminance_of(unsigned char red, unsigned char green, unsigned char blue)
{
    return 0.2126 * light_of(red) + 0.7152 * light_of(green) + 0.0722 * light_of(blue) + 0.05;
}

/* From 1 to 21. */
static double contrast_of(const roberts_pen *pen, fill_color on)
{
    const double text = luminance_of(pen->red, pen->green, pen->blue), below = luminance_of(on.red, on.green, on.blue);
    return text > below ? text / below : below / text;
}

/* Are letters of this pen hard to read on a fill, but not on the paper? */
static bool need_plate(const roberts_draw_options *options, const roberts_pen *pen, fill_color fill)
{
    const double on_paper = contrast_of(pen, fills_on_paper(options, clear));
    return !pen->off && contrast_of(pen, fills_on_paper(options, fill)) < fmin(least_contrast, pale_part * on_paper);
}

/* Finds letters that need a plate on a region. */
static bool ask_region(void *context, const page_region *region)
{
    const plate_work *w = context;
    const roberts_draw_options *options = w->s->options;
    const fill_color color = fills_color(options, region->region);
    const bool needed[2] = {need_plate(options, &options->text, color),
                            need_plate(options, &options->hidden_text, color)};
    const size_t end = region->ring_count ? region->ring_start[region->ring_count] : 0;
    if (color.alpha == 0 || !(needed[0] || needed[1]))
        return true;
    roberts_vec2 low = {INFINITY, INFINITY}, high = {-INFINITY, -INFINITY};
    for (const roberts_vec2 *p = region->point; p < region->point + end; p++) {
        low = (roberts_vec2){fmin(low.x, p->x), fmin(low.y, p->y)};
        high = (roberts_vec2){fmax(high.x, p->x), fmax(high.y, p->y)};
    }
    for (plate *p = w->item; p < w->item + w->count; p++)
        for (int i = 0; i < PLATE_POINTS && needed[p->is_back] && !p->is_wanted; i++) {
            const roberts_vec2 at = plate_point(p, i);
            p->is_wanted = at.x >= low.x && at.x <= high.x && at.y >= low.y && at.y <= high.y &&
                           page_rings_hold(region->ring_count, region->ring_start, region->point, at);
        }
    return true;
}

static bool draw_plate(const plate *p, polylines *out)
{
    bool enough = polylines_start(out);
    for (int i = 0; enough && i < 4; i++)
        enough = polylines_extend(out, page_rounded(p->corner[i]));
    if (enough)
        close_ring(out);
    return enough;
}

/* Appends the plates. False: no memory. */
static bool add_plates(const strokes *s, fills *out)
{
    plate_work w = {.s = s, .item = alloc_array(s->notes.count, sizeof *w.item), .count = s->notes.count};
    const size_t first = out->lines.count;
    for (size_t i = 0; w.item && i < w.count; i++)
        w.item[i] = plate_of(s, i);
    bool enough = w.item && page_regions_walk(s, ask_region, &w);
    for (size_t i = 0; enough && i < w.count; i++)
        enough = !w.item[i].is_wanted || draw_plate(&w.item[i], &out->lines);
    free(w.item);
    if (!enough || out->lines.count == first)
        return enough;
    if (!array_reserve(&out->paint, &out->room, out->count + 1, sizeof *out->paint))
        return false;
    out->paint[out->count++] =
        (fill_paint){fills_on_paper(s->options, clear), false, first, out->lines.count, ROBERTS_NONE};
    return true;
}

/* ---- all of it ------------------------------------------------------------------------------------------------- */

static double seam_width(const roberts_draw_options *options)
{
    return options->outline.off ? widest_seam : fmax(fmin(options->outline.width_mm, widest_seam), narrowest_seam);
}

bool fills_make(const strokes *s, fills *out)
{
    fill_work w = {.s = s};
    *out = (fills){.seam_mm = seam_width(s->options)};
    if (s->options->fill == ROBERTS_FILL_NONE)
        return true;
    bool enough =
        page_regions_walk(s, take_region, &w) && join_regions(&w) && paint(&w, true, out) && paint(&w, false, out);
    out->plates = out->count;
    enough = enough && (s->notes.count == 0 || out->count == 0 || add_plates(s, out));
    free(w.side.item);
    free(w.seam.item);
    free(w.rim);
    return enough;
}

void fills_free(fills *f)
{
    polylines_free(&f->lines);
    free(f->paint);
    *f = (fills){0};
}
