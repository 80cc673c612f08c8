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
static const double text_off = 1.2;

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

/* The extension line from the corner that belongs to `start`, across the end of the dimension line. */
static bool add_extension(strokes *s, const page_view *view, roberts_vec2 start, roberts_vec2 off)
{
    const roberts_vec2 corner = find_corner(s, view, start, off);
    return notes_add_line(&s->notes, along(corner, off, extension_gap), along(start, off, line_off + extension_over),
                          s->units_per_mm);
}

/* A dimension between `ends`, corners of the box of a view. Its line is off by `line_off` toward `off`; it is level or
 * upright. */
static bool add_dimension(strokes *s, const page_view *view, const roberts_vec2 ends[2], roberts_vec2 off, double value)
{
    const roberts_vec2 a = ends[0], b = ends[1];
    const double length = hypot(b.x - a.x, b.y - a.y), units = s->units_per_mm;
    if (!(length > 0.0))
        return true;
    const roberts_vec2 d = {(b.x - a.x) / length, (b.y - a.y) / length};
    const roberts_vec2 from = along(a, off, line_off), to = along(b, off, line_off);
    const bool is_upright = fabs(d.y) > fabs(d.x), is_narrow = length < 4.0 * arrow_length;
    const double outside = is_narrow ? 2.0 * arrow_length : 0.0, height = strokes_text_height(s->options);
    char text[100];
    dimension_text(value, s->options->lettering.unit, text, sizeof text);
    const roberts_vec2 middle = {(from.x + to.x) / 2.0, (from.y + to.y) / 2.0};
    const text_line line = {text,
                            is_upright ? (roberts_vec2){middle.x - text_off, middle.y}
                                       : (roberts_vec2){middle.x, middle.y - text_off},
                            height, 0.5, is_upright};
    const double half = letters_width(text, height) / 2.0;
    if (s->taken_count < TAKEN_MOST)
        s->taken[s->taken_count++] =
            is_upright ? (room_box){{line.at.x - height, line.at.y - half}, {line.at.x, line.at.y + half}}
                       : (room_box){{line.at.x - half, line.at.y - height}, {line.at.x + half, line.at.y}};
    return add_extension(s, view, a, off) && add_extension(s, view, b, off) &&
           notes_add_line(&s->notes, along(from, d, -outside), along(to, d, outside), units) &&
           add_arrow(s, from, is_narrow ? d : (roberts_vec2){-d.x, -d.y}) &&
           add_arrow(s, to, is_narrow ? (roberts_vec2){-d.x, -d.y} : d) && notes_add_text(&s->notes, &line, false);
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
        if (!add_dimension(s, view, level, outward, high.x - low.x))
            return false;
        if (view->place == ROBERTS_SHEET_FRONT && !add_dimension(s, view, upright, leftward, high.y - low.y))
            return false;
    }
    return true;
}
