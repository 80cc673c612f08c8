/* symbol.c - the symbol of the projection method (ISO 5456-2): a truncated cone, its narrow end to the left, and beside it
 * the two circles that are seen from there, both because the narrow end is nearer. The view from the left stands on the
 * right in first angle projection, on the left in third angle projection.
 *
 * Its full size goes with lettering of 3.5 mm: the narrow end is as wide as that is high, the other end twice. Centre lines
 * are long, dot, long (ISO 128-2), made so that the circles' cross in a long one. */
#include "draw/symbol.h"

#include <math.h>

#include "base/vec.h"

/* mm */
static const double narrow = 1.75, wide = 3.5; /* radii; `wide` is also half of the cone's length */
static const double overhang = 1.75;           /* of centre lines */
static const double apart = 12.25;             /* between the middles of cone and circles */

enum { CIRCLE_CORNERS = 48 /* within 0.008 mm of the circle */ };

typedef struct symbol {
    polylines *out;
    roberts_vec2 origin; /* what the following are counted from, mm on the page */
    double size;
    double units_per_mm;
    bool failed;
} symbol;

static void add_point(symbol *s, double x, double y)
{
    page_point p = {(int32_t)floor((s->origin.x + s->size * x) * s->units_per_mm + 0.5),
                    (int32_t)floor((s->origin.y + s->size * y) * s->units_per_mm + 0.5)};
    s->failed = s->failed || !polylines_append(s->out, p);
}

static void start(symbol *s, bool closed)
{
    s->failed = s->failed || !polylines_start(s->out);
    if (!s->failed)
        s->out->item[s->out->count - 1].closed = closed;
}

static void add_cone(symbol *s)
{
    start(s, true);
    add_point(s, -wide, -narrow);
    add_point(s, wide, -wide);
    add_point(s, wide, wide);
    add_point(s, -wide, narrow);
}

static void add_circle(symbol *s, double radius)
{
    start(s, true);
    for (int i = 0; i < CIRCLE_CORNERS; i++) {
        roberts_vec2 p = angle_unit(360.0 * i / CIRCLE_CORNERS);
        add_point(s, radius * p.x, radius * p.y);
    }
}

/* Through the origin; upright or level. */
static void add_centre_line(symbol *s, bool upright)
{
    const double ends[][2] = {
        {-wide - overhang, -3.6}, {-2.65, -2.45}, {-1.5, 1.5}, {2.45, 2.65}, {3.6, wide + overhang}};
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++) {
        start(s, false);
        for (int k = 0; k < 2; k++)
            add_point(s, upright ? 0.0 : ends[i][k], upright ? ends[i][k] : 0.0);
    }
}

bool symbol_draw(roberts_sheet_angle angle, roberts_vec2 corner, double size, double units_per_mm, polylines *out)
{
    const double reach = size * wide, more = size * overhang;
    const roberts_vec2 right = {corner.x - reach - more, corner.y - reach - more},
                       left = {right.x - size * apart, right.y};
    const bool first = angle == ROBERTS_FIRST_ANGLE;
    symbol s = {.out = out, .origin = first ? left : right, .size = size, .units_per_mm = units_per_mm};
    add_cone(&s);
    add_centre_line(&s, false);
    s.origin = first ? right : left;
    add_circle(&s, narrow);
    add_circle(&s, wide);
    add_centre_line(&s, false);
    add_centre_line(&s, true);
    return !s.failed;
}
