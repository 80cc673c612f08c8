/* dimensions.c - dimensions on a sheet after ISO 129-1: how one is drawn; width, height and depth of the scene;
 * distances between two vertices.
 *
 * The dimension lines of the whole scene are on the outer sides of the views: width and depth in one line beyond front
 * and side view, height at the left of the front view. sheet_lay() has kept room for them. */
#include "draw/dimensions.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/box.h"
#include "base/error.h"
#include "base/output.h"
#include "base/vec.h"

/* mm */
static const double nearest_mm = 10.0, ring_mm = 7.0; /* dimension lines from what they measure, and farther ones */
static const double extension_gap = 1.0, extension_over = 2.0;
static const double arrow_length = 3.0, arrow_half = 0.8;
static const double text_off = 1.2, text_apart = 1.0; /* from the dimension line, from extension lines */

void dimension_text(double value, const char *unit, char *text, size_t size)
{
    char digits[64];
    const double exponent = value > 0.0 ? floor(log10(value)) : 0.0;
    const bool tiny = exponent < -9.0;
    int decimals = tiny ? 0 : (int)fmax(4.0 - exponent, 0.0);
    double scaled = tiny ? value : floor(value * pow(10.0, decimals) + 0.5);
    for (; decimals > 0 && fmod(scaled, 10.0) == 0.0; decimals--)
        scaled /= 10.0;
    snprintf(digits, sizeof digits, tiny || scaled >= 1e15 ? "%.4e" : "%.0f", scaled);
    size_t length = strlen(digits), whole = length > (size_t)decimals ? length - (size_t)decimals : 0;
    char number[80];
    if (decimals == 0) {
        decimal_unlocalise(number, digits);
        for (char *c = number; *c; c++)
            if (*c == '.')
                *c = ',';
    } else if (whole > 0)
        snprintf(number, sizeof number, "%.*s,%s", (int)whole, digits, digits + whole);
    else
        snprintf(number, sizeof number, "0,%0*d%s", (int)((size_t)decimals - length), 0, digits);
    if (decimals > 0 && whole == 0 && (size_t)decimals == length) /* "%0*d" writes at least one zero */
        snprintf(number, sizeof number, "0,%s", digits);
    snprintf(text, size, unit && *unit ? "%s %s" : "%s%s", number, unit ? unit : "");
}

/* A dimension while it is laid out; mm. */
typedef struct dimension {
    roberts_vec2 corner[2]; /* what is measured; an extension line runs from each to its end of the dimension line */
    roberts_vec2 end[2];    /* of the dimension line */
    roberts_vec2 off;       /* direction of extension lines, a unit vector */
    const char *text;
    double shift; /* of the text toward end[1], from the middle of the dimension line */
} dimension;

/* Its lines, and its text as a line that is read from below or from the right. */
typedef struct dimension_lines {
    roberts_vec2 extension[2][2], line[2];
    roberts_vec2 along; /* from end[0] to end[1] */
    bool is_narrow;     /* the arrows stand outside */
    text_line text;
} dimension_lines;

/* How many boxes hold a text together, at most. */
enum { DIMENSION_BOXES = 32, DIMENSION_TEXT = 100 };

static roberts_vec2 moved_along(roberts_vec2 p, roberts_vec2 d, double mm)
{
    return (roberts_vec2){p.x + mm * d.x, p.y + mm * d.y};
}

/* An arrow whose tip is at `tip` and points toward `d`. */
static bool add_arrow(strokes *s, roberts_vec2 tip, roberts_vec2 d)
{
    const roberts_vec2 back = moved_along(tip, d, -arrow_length), side = {-d.y, d.x};
    return notes_add_line(&s->notes, moved_along(back, side, arrow_half), tip, s->units_per_mm) &&
           notes_add_line(&s->notes, tip, moved_along(back, side, -arrow_half), s->units_per_mm);
}

/* The corner that an extension line measures. `start` is a corner of the view's box, and the line runs through it along
 * `off`. The end of a segment on that line that is nearest to `start` is measured; if there is none, `start` itself. */
static roberts_vec2 find_corner(const strokes *s, const page_view *view, roberts_vec2 start, roberts_vec2 off)
{
    double least = INFINITY;
    for (size_t i = 0; i < view->drawing->count; i++) {
        const roberts_segment *segment = &view->drawing->segment[i];
        roberts_line line;
        if (!strokes_has_place(s->options, segment, &line))
            continue;
        for (int end = 0; end < 2; end++) {
            const roberts_vec2 p = page_place(&view->map, end ? segment->p1 : segment->p0);
            const roberts_vec2 d = {start.x - p.x, start.y - p.y};
            if (fabs(d.x * off.y - d.y * off.x) <= PAGE_SLACK_MM)
                least = fmin(least, fmax(d.x * off.x + d.y * off.y, 0.0));
        }
    }
    return least < INFINITY ? moved_along(start, off, -least) : start;
}

/* The direction in which text along `d` is read: from below or, where it is upright, from the right. */
static roberts_vec2 reading(roberts_vec2 d)
{
    const bool backward = d.x < -1e-9 || (d.x <= 1e-9 && d.y > 0.0);
    return backward ? (roberts_vec2){-d.x, -d.y} : d;
}

/* Finds the lines of a dimension. False: it has no length. */
static bool dimension_lay(const strokes *s, const dimension *d, dimension_lines *l)
{
    const roberts_vec2 from = d->end[0], to = d->end[1];
    const double length = hypot(to.x - from.x, to.y - from.y), height = strokes_text_height(s->options);
    if (!(length > 0.0))
        return false;
    l->along = (roberts_vec2){(to.x - from.x) / length, (to.y - from.y) / length};
    l->is_narrow = length < 4.0 * arrow_length;
    const double half = letters_width(d->text, height) / 2.0, outside = l->is_narrow ? 2.0 * arrow_length : 0.0;
    const double before = d->shift < 0.0 ? fmax(outside, half - d->shift - length / 2.0) : outside;
    const double behind = d->shift > 0.0 ? fmax(outside, half + d->shift - length / 2.0) : outside;
    const roberts_vec2 middle = {(from.x + to.x) / 2.0, (from.y + to.y) / 2.0}, read = reading(l->along);
    l->line[0] = moved_along(from, l->along, -before);
    l->line[1] = moved_along(to, l->along, behind);
    for (int i = 0; i < 2; i++) {
        l->extension[i][0] = moved_along(d->corner[i], d->off, extension_gap);
        l->extension[i][1] = moved_along(d->end[i], d->off, extension_over);
    }
    const roberts_vec2 up = text_upward(read);
    const double beyond = extension_over + text_apart; /* no extension line is beside the text there */
    const bool is_outward = up.x * d->off.x + up.y * d->off.y > 0.0;
    const bool fits = d->shift != 0.0 || 2.0 * (half + text_apart) < length;
    const double base = fits ? text_off : is_outward ? beyond : -beyond - height;
    l->text = (text_line){d->text, moved_along(moved_along(middle, l->along, d->shift), up, base), height, 0.5, read};
    return true;
}

/* Boxes that hold the text together, along its base line if it is turned. Returns how many. */
static size_t dimension_text_boxes(const text_line *line, space_box box[DIMENSION_BOXES])
{
    const roberts_vec2 d = line->along, up = text_upward(d);
    const double width = letters_width(line->text, line->height_mm), h = line->height_mm;
    const bool is_straight = d.x == 0.0 || d.y == 0.0;
    const size_t count = is_straight ? 1 : (size_t)fmin(fmax(ceil(width / h), 1.0), DIMENSION_BOXES);
    for (size_t i = 0; i < count; i++) {
        const double low = width * ((double)i / (double)count - 0.5), high = low + width / (double)count;
        const roberts_vec2 a = moved_along(line->at, d, low), b = moved_along(line->at, d, high),
                           c = moved_along(a, up, h), e = moved_along(b, up, h);
        box[i] = (space_box){{fmin(fmin(a.x, b.x), fmin(c.x, e.x)), fmin(fmin(a.y, b.y), fmin(c.y, e.y))},
                             {fmax(fmax(a.x, b.x), fmax(c.x, e.x)), fmax(fmax(a.y, b.y), fmax(c.y, e.y))}};
    }
    return count;
}

/* Adds a dimension to s->notes, and its text to s->taken. False: no memory. */
static bool dimension_draw(strokes *s, const dimension *d)
{
    const double units = s->units_per_mm;
    dimension_lines l;
    space_box box[DIMENSION_BOXES];
    if (!dimension_lay(s, d, &l))
        return true;
    for (size_t i = 0, count = dimension_text_boxes(&l.text, box); i < count; i++)
        if (!strokes_take(s, &box[i]))
            return false;
    const roberts_vec2 inward = l.along, outward = {-inward.x, -inward.y};
    return notes_add_line(&s->notes, l.extension[0][0], l.extension[0][1], units) &&
           notes_add_line(&s->notes, l.extension[1][0], l.extension[1][1], units) &&
           notes_add_line(&s->notes, l.line[0], l.line[1], units) &&
           add_arrow(s, d->end[0], l.is_narrow ? inward : outward) &&
           add_arrow(s, d->end[1], l.is_narrow ? outward : inward) && notes_add_text(&s->notes, &l.text);
}

/* How far the dimension lines of the whole scene are from a view: large letters must not reach it, and distances stand
 * nearer, since a shorter dimension does not lie beyond a longer one. */
static double overall_off(const roberts_draw_options *options)
{
    const double nearest = fmax(nearest_mm, strokes_text_height(options) + 2.0 * text_off);
    return options->lettering.distance_count > 0 ? nearest + ring_mm : nearest;
}

double dimensions_room(const roberts_draw_options *options)
{
    const double text =
        extension_over + text_apart + strokes_text_height(options) + text_off; /* beyond the last line */
    return options->lettering.overall ? overall_off(options) + fmax(8.0, text) : nearest_mm + 8.0;
}

/* A dimension between `ends`, corners of the box of a view, off toward `off`; its line is level or upright. */
static bool add_overall(strokes *s, const page_view *view, const roberts_vec2 ends[2], roberts_vec2 off, double value)
{
    char text[DIMENSION_TEXT];
    const double line_off = overall_off(s->options);
    dimension_text(value, s->options->lettering.unit, text, sizeof text);
    const dimension d = {{find_corner(s, view, ends[0], off), find_corner(s, view, ends[1], off)},
                         {moved_along(ends[0], off, line_off), moved_along(ends[1], off, line_off)},
                         off,
                         text,
                         0.0};
    return dimension_draw(s, &d);
}

bool dimensions_add(strokes *s)
{
    if (!s->options->lettering.overall)
        return true;
    const bool first = s->sheet->angle == ROBERTS_FIRST_ANGLE;
    const roberts_vec2 outward = {0.0, first ? -1.0 : 1.0}, leftward = {-1.0, 0.0};
    for (size_t i = 0; i < s->views; i++) {
        const page_view *view = &s->view[i];
        const roberts_vec2 low = view->drawing->window_min, high = view->drawing->window_max;
        const roberts_vec2 a = page_place(&view->map, low),
                           b = page_place(&view->map, high); /* lower left, upper right */
        const double y = first ? b.y : a.y;
        if (view->place != ROBERTS_SHEET_FRONT && view->place != ROBERTS_SHEET_SIDE)
            continue;
        const roberts_vec2 level[2] = {{a.x, y}, {b.x, y}}, upright[2] = {a, {a.x, b.y}};
        if (!add_overall(s, view, level, outward, high.x - low.x))
            return false;
        if (view->place == ROBERTS_SHEET_FRONT && !add_overall(s, view, upright, leftward, high.y - low.y))
            return false;
    }
    return true;
}

/* ---- distances between two vertices ------------------------------------------------------------------------------ */

/* A distance is seen in true length if both vertices are equally deep. It is drawn once, in one such view: if there are
 * several, in the first one that shows both vertices. The dimension line may stand on either side, nearer or farther,
 * with its text in the middle or beyond an end. Each place has a cost: the lines that lie there already, and its
 * distance. The cheapest place with room for the text is taken. */

enum { RINGS = 14, SHIFTS = 3, PARTS_MOST = 4096 /* of a line; longer parts on pages of more than 8 m */ };

/* mm */
static const double beyond_mm = 8.0; /* text beyond an end, from that end */
static const double margin_mm = 0.6; /* kept free round text and lines */
static const double step_mm = 2.0;   /* parts in which a line is examined */

/* Greatest depth of a distance seen in true length, as a fraction of it: the effect of rounding to five digits. */
static const double level_part = 1e-5;

/* Costs, in mm of lines that a dimension line lies on. */
static const double per_ring = 1.0, inward = 3.0, text_beyond = 1.5, extension_part = 0.3;

/* A distance in one view. */
typedef struct seen_distance {
    const page_view *view;
    roberts_vec2 at[2]; /* mm on the page */
} seen_distance;

/* Whether an end of a drawn line, not hidden, is this vertex. */
static bool shows(const strokes *s, const page_view *view, uint32_t number)
{
    for (size_t i = 0; i < view->drawing->count; i++) {
        const roberts_segment *segment = &view->drawing->segment[i];
        roberts_line line;
        if (segment->state == ROBERTS_VISIBLE && strokes_has_place(s->options, segment, &line) &&
            ((segment->v0 == number && segment->t0 == 0.0) || (segment->v1 == number && segment->t1 == 1.0)))
            return true;
    }
    return false;
}

/* Finds the view that shows a distance best. `best->view` is NULL if none shows it in true length. */
static roberts_status find_view(const strokes *s, const roberts_distance *of, const roberts_vec3 end[2],
                                seen_distance *best, roberts_error *error)
{
    bool best_shows = false;
    *best = (seen_distance){0};
    for (size_t i = 0; i < s->views; i++) {
        roberts_camera camera;
        roberts_vec3 p[2];
        roberts_sheet_camera(s->sheet->angle, s->view[i].place, &camera);
        roberts_status status = roberts_project(s->options->scene, &camera, end, 2, p, error);
        if (status != ROBERTS_OK)
            return status;
        const roberts_vec3 a = p[0], b = p[1];
        if (!(fabs(b.z - a.z) <= level_part * hypot(b.x - a.x, b.y - a.y)))
            continue;
        const bool both = shows(s, &s->view[i], of->v0) && shows(s, &s->view[i], of->v1);
        if (best->view && (best_shows || !both))
            continue;
        best_shows = both;
        best->view = &s->view[i];
        best->at[0] = page_place(&s->view[i].map, (roberts_vec2){a.x, a.y});
        best->at[1] = page_place(&s->view[i].map, (roberts_vec2){b.x, b.y});
    }
    return ROBERTS_OK;
}

/* ---- where it goes ---- */

/* The cost of a box with `margin_mm` round it; infinite on other text, or beyond the frame. */
static double box_cost(const strokes *s, const free_space *r, space_box box)
{
    box = (space_box){{box.min.x - margin_mm, box.min.y - margin_mm}, {box.max.x + margin_mm, box.max.y + margin_mm}};
    if (box.min.x < s->frame_mm[0].x || box.min.y < s->frame_mm[0].y || box.max.x > s->frame_mm[1].x ||
        box.max.y > s->frame_mm[1].y)
        return INFINITY;
    const space_load load = space_load_of(r, &box, UINT32_MAX, 0, INFINITY);
    return load.boxes > 0 ? INFINITY : load.mm;
}

static double line_cost(const strokes *s, const free_space *r, roberts_vec2 a, roberts_vec2 b)
{
    const double length = hypot(b.x - a.x, b.y - a.y);
    const uint32_t parts = (uint32_t)fmin(fmax(ceil(length / step_mm), 1.0), PARTS_MOST);
    double cost = 0.0;
    for (uint32_t i = 0; i < parts; i++) {
        const double t = (double)i / parts, u = (i + 1.0) / parts;
        const roberts_vec2 p = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
        const roberts_vec2 q = {a.x + u * (b.x - a.x), a.y + u * (b.y - a.y)};
        cost += box_cost(s, r, space_box_around(p, q));
    }
    return cost;
}

/* Does the line from a to b run into the box of another view? */
static bool is_in_other_view(const strokes *s, const page_view *own, roberts_vec2 a, roberts_vec2 b)
{
    for (const page_view *view = s->view; view < s->view + s->views; view++) {
        const roberts_vec2 p = page_place(&view->map, view->drawing->window_min);
        const roberts_vec2 q = page_place(&view->map, view->drawing->window_max);
        double t0 = 0.0, t1 = 1.0;
        if (view != own && box_clip(a.x, b.x, p.x, q.x, &t0, &t1) && box_clip(a.y, b.y, q.y, p.y, &t0, &t1) && t0 < t1)
            return true;
    }
    return false;
}

/* The cost of the lines already there; infinite if there is no room for the text, or another view is in the way. */
static double drawn_cost(const strokes *s, const free_space *r, const page_view *own, const dimension *d)
{
    dimension_lines l;
    space_box box[DIMENSION_BOXES];
    double cost = 0.0;
    if (!dimension_lay(s, d, &l) || is_in_other_view(s, own, l.line[0], l.line[1]) ||
        is_in_other_view(s, own, l.extension[0][0], l.extension[0][1]) ||
        is_in_other_view(s, own, l.extension[1][0], l.extension[1][1]))
        return INFINITY;
    for (size_t i = 0, count = dimension_text_boxes(&l.text, box); i < count; i++)
        if (box_cost(s, r, box[i]) > 0.0)
            return INFINITY;
    cost += line_cost(s, r, l.line[0], l.line[1]);
    for (int i = 0; i < 2; i++) { /* other lines end at the vertex, too */
        const double from = 2.0 * margin_mm;
        cost += extension_part * line_cost(s, r, moved_along(l.extension[i][0], d->off, from), l.extension[i][1]);
    }
    return cost;
}

/* Place number `i` of a distance; false: the text has no room between its ends. `*cost` receives the cost of its
 * distance. */
static bool nth_place(const strokes *s, const seen_distance *seen, size_t i, dimension *d, double *cost)
{
    const roberts_vec2 a = seen->at[0], b = seen->at[1];
    const double length = hypot(b.x - a.x, b.y - a.y), side = i % 2 ? -1.0 : 1.0;
    const size_t shift = i / 2 % SHIFTS;
    const double ring = (double)(i / 2 / SHIFTS), off_mm = nearest_mm + ring * ring_mm;
    const double half = letters_width(d->text, strokes_text_height(s->options)) / 2.0;
    const roberts_vec2 middle = {(a.x + b.x) / 2.0, (a.y + b.y) / 2.0};
    const roberts_vec2 low = page_place(&seen->view->map, seen->view->drawing->window_min);
    const roberts_vec2 high = page_place(&seen->view->map, seen->view->drawing->window_max);
    d->off = (roberts_vec2){side * -(b.y - a.y) / length, side * (b.x - a.x) / length};
    d->shift = shift == 0 ? 0.0 : (shift == 1 ? 1.0 : -1.0) * (length / 2.0 + beyond_mm + half);
    for (int k = 0; k < 2; k++) {
        d->corner[k] = seen->at[k];
        d->end[k] = moved_along(seen->at[k], d->off, off_mm);
    }
    const roberts_vec2 centre = {(low.x + high.x) / 2.0 - middle.x, (low.y + high.y) / 2.0 - middle.y};
    *cost = per_ring * ring + (shift ? text_beyond : 0.0) +
            (d->off.x * centre.x + d->off.y * centre.y > 1e-6 ? inward : 0.0);
    return shift != 0 || 2.0 * (half + 2.0 * margin_mm) < length;
}

/* Finds the cheapest place, the first of several. False: there is none. */
static bool find_place(const strokes *s, const free_space *r, const seen_distance *seen, dimension *best)
{
    double least = INFINITY;
    for (size_t i = 0; i < 2 * SHIFTS * RINGS; i++) {
        dimension d = {.text = best->text};
        double cost;
        if (!nth_place(s, seen, i, &d, &cost) || cost >= least)
            continue;
        cost += drawn_cost(s, r, seen->view, &d);
        if (cost < least) {
            least = cost;
            *best = d;
        }
    }
    return least < INFINITY;
}

/* Draws a dimension, and reserves its place. */
static bool add_to_page(strokes *s, free_space *r, const dimension *d)
{
    const size_t lines = s->notes.lines.count, boxes = s->taken_count;
    uint32_t number;
    bool done = dimension_draw(s, d);
    for (size_t i = lines; done && i < s->notes.lines.count; i++)
        done = space_add_polyline(r, &s->notes.lines, i, s->units_per_mm);
    for (size_t i = boxes; done && i < s->taken_count; i++)
        done = space_add_box(r, &s->taken[i], &number);
    return done;
}

/* ---- all of them ---- */

static void enlarge_box(space_box *box, roberts_vec2 p)
{
    box->min = (roberts_vec2){fmin(box->min.x, p.x), fmin(box->min.y, p.y)};
    box->max = (roberts_vec2){fmax(box->max.x, p.x), fmax(box->max.y, p.y)};
}

/* Records how far a dimension reaches beyond its view, and whether it lies across lines. */
static void record_outcome(const strokes *s, const free_space *r, const page_view *view, const dimension *d,
                           distances_outcome *outcome)
{
    space_box box[DIMENSION_BOXES];
    dimension_lines l;
    if (!dimension_lay(s, d, &l))
        return;
    if (line_cost(s, r, l.line[0], l.line[1]) > 0.0)
        outcome->poor++;
    space_box all = {l.line[0], l.line[0]};
    for (int i = 0; i < 2; i++) {
        enlarge_box(&all, l.line[i]);
        enlarge_box(&all, l.extension[i][1]);
    }
    for (size_t i = 0, count = dimension_text_boxes(&l.text, box); i < count; i++) {
        enlarge_box(&all, box[i].min);
        enlarge_box(&all, box[i].max);
    }
    sheet_add_box(&outcome->reach, view, &all, margin_mm);
}

/* Is the distance the width, height or depth of the scene, which the sheet has already? */
static roberts_status is_overall(const strokes *s, const roberts_vec3 end[2], bool *found, roberts_error *error)
{
    *found = false;
    if (!s->options->lettering.overall)
        return ROBERTS_OK;
    for (size_t i = 0; i < s->views; i++) {
        const page_view *view = &s->view[i];
        const roberts_vec2 low = view->drawing->window_min, high = view->drawing->window_max;
        roberts_camera camera;
        roberts_vec3 p[2];
        if (view->place != ROBERTS_SHEET_FRONT && view->place != ROBERTS_SHEET_SIDE)
            continue;
        roberts_sheet_camera(s->sheet->angle, view->place, &camera);
        roberts_status status = roberts_project(s->options->scene, &camera, end, 2, p, error);
        if (status != ROBERTS_OK)
            return status;
        const roberts_vec3 d = vec3_sub(p[1], p[0]);
        const double slack = level_part * vec3_length(d);
        const bool is_level = fabs(d.y) <= slack && fabs(d.z) <= slack && high.x - low.x - fabs(d.x) <= slack;
        const bool is_upright = fabs(d.x) <= slack && fabs(d.z) <= slack && high.y - low.y - fabs(d.y) <= slack;
        *found = *found || is_level || (is_upright && view->place == ROBERTS_SHEET_FRONT);
    }
    return ROBERTS_OK;
}

static void warn_left_out(const strokes *s, const roberts_distance *of, const char *why)
{
    const roberts_warnings *to = &s->options->lettering.warnings;
    char text[200];
    if (!to->warn)
        return;
    snprintf(text, sizeof text, "the distance v%u-v%u is left out: %s", (unsigned)of->v0, (unsigned)of->v1, why);
    to->warn(to->context, "", 0, text);
}

static roberts_status add_distance(strokes *s, free_space *r, const roberts_distance *of, distances_outcome *outcome,
                                   roberts_error *error)
{
    bool is_there;
    roberts_vec3 end[2];
    char text[DIMENSION_TEXT];
    seen_distance seen;
    for (int i = 0; i < 2; i++)
        if (!roberts_scene_vertex(s->options->scene, i ? of->v1 : of->v0, &end[i]))
            return error_set(error, ROBERTS_BAD_ARGUMENT, 0,
                             "dimensions: no face has vertex %u (of vertices at one place the smallest number counts)",
                             (unsigned)(i ? of->v1 : of->v0));
    const double length = vec3_length(vec3_sub(end[1], end[0]));
    if (!(length > 0.0))
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "dimensions: vertices %u and %u are at one place",
                         (unsigned)of->v0, (unsigned)of->v1);
    roberts_status status = is_overall(s, end, &is_there, error);
    if (status != ROBERTS_OK || is_there)
        return status;
    status = find_view(s, of, end, &seen, error);
    if (status != ROBERTS_OK)
        return status;
    if (!seen.view) {
        warn_left_out(s, of, "no view shows it in true length");
        return ROBERTS_OK;
    }
    dimension_text(length, s->options->lettering.unit, text, sizeof text);
    dimension best = {.text = text};
    if (!find_place(s, r, &seen, &best)) {
        outcome->poor++;
        warn_left_out(s, of, "there is no room; choose smaller letters, a smaller scale or a larger page");
        return ROBERTS_OK;
    }
    record_outcome(s, r, seen.view, &best, outcome);
    return add_to_page(s, r, &best) ? ROBERTS_OK : error_no_memory(error);
}

bool distances_wanted(const strokes *s)
{
    return s->sheet && s->options->lettering.distance_count > 0;
}

roberts_status distances_add(strokes *s, free_space *r, distances_outcome *outcome, roberts_error *error)
{
    const roberts_lettering *lettering = &s->options->lettering;
    if (!s->options->scene)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "dimensions: distances between vertices need the scene");
    roberts_status status = ROBERTS_OK;
    *outcome = (distances_outcome){0};
    for (size_t i = 0; i < lettering->distance_count && status == ROBERTS_OK; i++)
        status = add_distance(s, r, &lettering->distance[i], outcome, error);
    return status;
}
