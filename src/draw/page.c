/* page.c - fits the drawing's box on the page, or lays it there at a true scale. */
#include "draw/page.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/error.h"

/* mm. Cairo's fixed point holds the longest at units of 0.01 mm (see strokes.c); no roll of paper is as long. */
static const double shortest_side = 1.0, longest_side = 40000.0;

static bool side_is_valid(double side)
{
    return side >= shortest_side && side <= longest_side;
}

bool page_is_valid(const roberts_page *page, roberts_error *error)
{
    if (!side_is_valid(page->width_mm) || !side_is_valid(page->height_mm)) {
        error_set(error, ROBERTS_BAD_ARGUMENT, 0, "page: each side must have 1 to 40000 mm");
        return false;
    }
    if (!(page->margin_mm >= 0.0 && 2.0 * page->margin_mm < fmin(page->width_mm, page->height_mm))) {
        error_set(error, ROBERTS_BAD_ARGUMENT, 0, "page: the margins leave no room");
        return false;
    }
    return true;
}

void roberts_page_shape(const roberts_page *page, roberts_vec2 *min, roberts_vec2 *max)
{
    double room_x = page->width_mm / 2.0 - page->margin_mm, room_y = page->height_mm / 2.0 - page->margin_mm;
    const roberts_vec2 half = {max->x / 2.0 - min->x / 2.0, max->y / 2.0 - min->y / 2.0};
    const double x = half.y / room_y * room_x, y = half.x / room_x * room_y; /* as the other side requires */
    if (x > half.x) {
        min->x -= x - half.x;
        max->x += x - half.x;
    } else if (y > half.y) {
        min->y -= y - half.y;
        max->y += y - half.y;
    }
}

page_map page_fit(const roberts_page *page, roberts_vec2 min, roberts_vec2 max)
{
    double room_x = page->width_mm / 2.0 - page->margin_mm, room_y = page->height_mm / 2.0 - page->margin_mm;
    double half_x = max.x / 2.0 - min.x / 2.0, half_y = max.y / 2.0 - min.y / 2.0;
    page_map map = {
        .centre = {min.x / 2.0 + max.x / 2.0, min.y / 2.0 + max.y / 2.0},
        .half = 1.0,
        .half_mm = 1.0,
        .page_mm = {page->width_mm / 2.0, page->height_mm / 2.0},
    };
    if (half_x <= 0.0 && half_y <= 0.0)
        return map;
    /* The side that is longer in proportion to its room decides. Both are divided by the longer one, so that nothing
     * overflows. */
    double larger = fmax(half_x, half_y);
    bool by_width = half_x / larger * room_y >= half_y / larger * room_x;
    map.half = by_width ? half_x : half_y;
    map.half_mm = by_width ? room_x : room_y;
    return map;
}

double page_scale(const page_map *map)
{
    return map->half_mm / map->half;
}

/* The largest scale up to `scale` that is 1, 2 or 5 times a power of ten. ISO 5455 has them from 50:1 to 1:10000, and
 * allows further powers of ten. */
static double standard_scale(double scale)
{
    static const double steps[] = {1.0, 2.0, 5.0, 10.0};
    const double slack = 1e-9; /* so that 1:20 stays 1:20 */
    int exponent = (int)floor(log10(scale)), i = 3;
    double power = pow(10.0, abs(exponent));
    while (i > 0 && (exponent < 0 ? steps[i] / power : steps[i] * power) > scale * (1.0 + slack))
        i--;
    return exponent < 0 ? steps[i] / power : steps[i] * power; /* a quotient: 0.05, and not 5 times a rounded 0.01 */
}

double page_wanted_scale(const roberts_placement *placement, double fitting)
{
    double unit_mm = placement->unit_mm > 0.0 ? placement->unit_mm : 1.0;
    if (placement->standard && placement->scale == 0.0 && isnormal(fitting / unit_mm))
        return standard_scale(fitting / unit_mm) * unit_mm;
    return placement->scale * unit_mm;
}

/* Writes the largest scale of three digits that is at most `scale`: "1:42", "2.5:1". */
static void scale_name(double scale, char *text, size_t size)
{
    double ratio = scale < 1.0 ? 1.0 / scale : scale, digit = pow(10.0, floor(log10(ratio)) - 2.0);
    double slack = 1e-9; /* so that 20 stays 20 */
    ratio = scale < 1.0 ? ceil(ratio / digit - slack) * digit : floor(ratio / digit + slack) * digit;
    snprintf(text, size, scale < 1.0 ? "1:%.13g" : "%.13g:1", ratio); /* up to 1:1000000000000 */
    for (char *c = text; *c; c++)
        if (*c == ',')
            *c = '.'; /* the point of some locales is a comma */
}

/* Writes a length in whole mm, rounded up. A very long one has one digit, so that it needs no decimal point. */
static void length_name(double mm, char *text, size_t size)
{
    snprintf(text, size, mm < 1e9 ? "%.0f" : "%.0e", ceil(mm));
}

void page_refuse(const roberts_page *page, const roberts_placement *placement, double fitting, roberts_vec2 drawn_mm,
                 roberts_error *error)
{
    char asked[40], fits[40], x_mm[40], y_mm[40];
    double unit_mm = placement->unit_mm > 0.0 ? placement->unit_mm : 1.0;
    scale_name(placement->scale, asked, sizeof asked);
    scale_name(fitting / unit_mm, fits, sizeof fits);
    length_name(drawn_mm.x, x_mm, sizeof x_mm);
    length_name(drawn_mm.y, y_mm, sizeof y_mm);
    error_set(error, ROBERTS_BAD_ARGUMENT, 0,
              "at %s the drawing is %s x %s mm and would leave the page, whose margins leave %.0f x %.0f; %s would fit",
              asked, x_mm, y_mm, floor(page->width_mm - 2.0 * page->margin_mm),
              floor(page->height_mm - 2.0 * page->margin_mm), fits);
}

bool page_placement_is_valid(const roberts_placement *p, roberts_error *error)
{
    const double least = 1e-12, most = 1e12;
    bool scale = p->scale == 0.0 || (p->scale >= least && p->scale <= most);
    bool unit = p->unit_mm == 0.0 || (p->unit_mm >= least && p->unit_mm <= most);
    if (scale && unit && abs(p->align_x) <= 1 && abs(p->align_y) <= 1)
        return true;
    error_set(error, ROBERTS_BAD_ARGUMENT, 0, "placement: scale and unit must be 1e-12 to 1e12, alignments -1, 0 or 1");
    return false;
}

bool page_lay(const roberts_page *page, const roberts_placement *placement, roberts_vec2 min, roberts_vec2 max,
              page_map *map, roberts_error *error)
{
    if (!page_placement_is_valid(placement, error))
        return false;
    const page_map fitted = page_fit(page, min, max);
    const roberts_vec2 half = {max.x / 2.0 - min.x / 2.0, max.y / 2.0 - min.y / 2.0};
    double room_x = page->width_mm / 2.0 - page->margin_mm, room_y = page->height_mm / 2.0 - page->margin_mm;
    const double wanted = page_wanted_scale(placement, page_scale(&fitted));
    *map = fitted;
    if (wanted > 0.0) {
        map->half = 1.0;
        map->half_mm = wanted;
    }
    /* half of the drawing, mm */
    double x = half.x / map->half * map->half_mm, y = half.y / map->half * map->half_mm;
    const double slack = 0.0005; /* mm, half of what coordinates are rounded to: a drawing may fill the page */
    if (placement->scale > 0.0 && !(x <= room_x + slack && y <= room_y + slack)) {
        page_refuse(page, placement, page_scale(&fitted), (roberts_vec2){2.0 * x, 2.0 * y}, error);
        return false;
    }
    map->page_mm.x += placement->align_x * fmax(room_x - x, 0.0);
    map->page_mm.y -= placement->align_y * fmax(room_y - y, 0.0);
    return true;
}
