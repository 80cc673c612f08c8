/* dimensions.c - width, height and depth of a sheet's scene after ISO 129-1.
 *
 * The dimension lines are on the outer sides of the views: width and depth in one line beyond front and side view,
 * height at the left of the front view. sheet_lay() has kept room for them. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "draw/output.h"
#include "draw/title_block.h"

/* mm */
static const double line_off = 10.0; /* dimension line from the view */
static const double extension_gap = 1.0, extension_over = 2.0;
static const double arrow_length = 3.0, arrow_half = 0.8;
static const double text_off = 1.2, text_apart = 1.0; /* from the dimension line, from extension lines */

void dimension_text(double value, const char *unit, char *text, size_t size)
{
    char digits[64];
    const double exponent = value > 0.0 ? floor(log10(value)) : 0.0;
    int decimals = (int)fmin(fmax(4.0 - exponent, 0.0), 9.0);
    double scaled = floor(value * pow(10.0, decimals) + 0.5);
    for (; decimals > 0 && fmod(scaled, 10.0) == 0.0; decimals--)
        scaled /= 10.0;
    snprintf(digits, sizeof digits, scaled < 1e15 ? "%.0f" : "%.4e", scaled);
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

static roberts_vec2 along(roberts_vec2 p, roberts_vec2 d, double mm)
{
    return (roberts_vec2){p.x + mm * d.x, p.y + mm * d.y};
}

/* An arrow whose tip is at `tip` and points toward `d`. */
static bool add_arrow(strokes *s, roberts_vec2 tip, roberts_vec2 d)
{
    const roberts_vec2 back = along(tip, d, -arrow_length), side = {-d.y, d.x};
    return notes_add_line(&s->notes, along(back, side, arrow_half), tip, s->units_per_mm) &&
           notes_add_line(&s->notes, tip, along(back, side, -arrow_half), s->units_per_mm);
}

/* The corner that an extension line measures. `start` is a corner of the view's box, and the line runs through it along
 * `off`. Of the ends of segments on that line, the nearest to `start` is measured; if there is none, `start` itself. */
static roberts_vec2 find_corner(const strokes *s, const page_view *view, roberts_vec2 start, roberts_vec2 off)
{
    const double slack = 0.0005; /* mm, half of what coordinates are rounded to */
    double least = INFINITY;
    for (size_t i = 0; i < view->drawing->count; i++) {
        const roberts_segment *segment = &view->drawing->segment[i];
        roberts_line line;
        if (!strokes_is_drawn(s->options, segment, &line))
            continue;
        for (int end = 0; end < 2; end++) {
            const roberts_vec2 p = page_place(&view->map, end ? segment->p1 : segment->p0);
            const roberts_vec2 d = {start.x - p.x, start.y - p.y};
            if (fabs(d.x * off.y - d.y * off.x) <= slack)
                least = fmin(least, fmax(d.x * off.x + d.y * off.y, 0.0));
        }
    }
    return least < INFINITY ? along(start, off, -least) : start;
}

/* The direction in which text along `d` is read: from below or, where it is upright, from the right. */
static roberts_vec2 reading(roberts_vec2 d)
{
    const bool backward = d.x < -1e-9 || (d.x <= 1e-9 && d.y > 0.0);
    return backward ? (roberts_vec2){-d.x, -d.y} : d;
}

bool dimension_lay(const strokes *s, const dimension *d, dimension_lines *l)
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
    l->line[0] = along(from, l->along, -before);
    l->line[1] = along(to, l->along, behind);
    for (int i = 0; i < 2; i++) {
        l->extension[i][0] = along(d->corner[i], d->off, extension_gap);
        l->extension[i][1] = along(d->end[i], d->off, extension_over);
    }
    const roberts_vec2 up = text_upward(read);
    const double beyond = extension_over + text_apart; /* no extension line is beside the text there */
    const bool is_outward = up.x * d->off.x + up.y * d->off.y > 0.0;
    const bool fits = d->shift != 0.0 || 2.0 * (half + text_apart) < length;
    const double base = fits ? text_off : is_outward ? beyond : -beyond - height;
    l->text = (text_line){d->text, along(along(middle, l->along, d->shift), up, base), height, 0.5, read};
    return true;
}

size_t dimension_text_boxes(const text_line *line, room_box box[DIMENSION_BOXES])
{
    const roberts_vec2 d = line->along, up = text_upward(d);
    const double width = letters_width(line->text, line->height_mm), h = line->height_mm;
    const bool is_straight = d.x == 0.0 || d.y == 0.0;
    const size_t count = is_straight ? 1 : (size_t)fmin(fmax(ceil(width / h), 1.0), DIMENSION_BOXES);
    for (size_t i = 0; i < count; i++) {
        const double low = width * ((double)i / (double)count - 0.5), high = low + width / (double)count;
        const roberts_vec2 a = along(line->at, d, low), b = along(line->at, d, high), c = along(a, up, h),
                           e = along(b, up, h);
        box[i] = (room_box){{fmin(fmin(a.x, b.x), fmin(c.x, e.x)), fmin(fmin(a.y, b.y), fmin(c.y, e.y))},
                            {fmax(fmax(a.x, b.x), fmax(c.x, e.x)), fmax(fmax(a.y, b.y), fmax(c.y, e.y))}};
    }
    return count;
}

bool dimension_draw(strokes *s, const dimension *d)
{
    const double units = s->units_per_mm;
    dimension_lines l;
    room_box box[DIMENSION_BOXES];
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
           add_arrow(s, d->end[1], l.is_narrow ? outward : inward) && notes_add_text(&s->notes, &l.text, false);
}

/* A dimension between `ends`, corners of the box of a view, off toward `off`; its line is level or upright. */
static bool add_overall(strokes *s, const page_view *view, const roberts_vec2 ends[2], roberts_vec2 off, double value)
{
    char text[DIMENSION_TEXT];
    dimension_text(value, s->options->lettering.unit, text, sizeof text);
    const dimension d = {{find_corner(s, view, ends[0], off), find_corner(s, view, ends[1], off)},
                         {along(ends[0], off, line_off), along(ends[1], off, line_off)},
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
