/* page.c - fits the drawing's box on the page. */
#include "draw/page.h"

#include <math.h>

#include "base/error.h"

/* mm. The largest is what Cairo's fixed point holds at 0.01 mm a unit (see svg.c), far beyond any roll of paper. */
static const double shortest_side = 1.0, longest_side = 40000.0;

static bool side_is_valid(double side)
{
    return side >= shortest_side && side <= longest_side;
}

bool page_is_valid(const roberts_page *page, roberts_error *error)
{
    if (!side_is_valid(page->width_mm) || !side_is_valid(page->height_mm)) {
        error_set(error, ROBERTS_BAD_ARGUMENT, 0, "page: each side has 1 to 40000 mm");
        return false;
    }
    if (!(page->margin_mm >= 0.0 && 2.0 * page->margin_mm < fmin(page->width_mm, page->height_mm))) {
        error_set(error, ROBERTS_BAD_ARGUMENT, 0, "page: its margins leave no room");
        return false;
    }
    return true;
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
    /* The side that is wider in proportion to its room decides; as parts of the larger, so that nothing overflows. */
    double larger = fmax(half_x, half_y);
    bool by_width = half_x / larger * room_y >= half_y / larger * room_x;
    map.half = by_width ? half_x : half_y;
    map.half_mm = by_width ? room_x : room_y;
    return map;
}
