/* page.c - fits the drawing's box on the page, or lays it there at a true scale; and lays visible regions there. Their
 * rings are cut by one side of the frame after another: I. E. Sutherland, G. W. Hodgman, "Reentrant polygon clipping",
 * Communications of the ACM 17(1), 1974. */
#include "draw/page.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/error.h"
#include "base/vec.h"
#include "draw/strokes.h"

/* ---- the place of a drawing -------------------------------------------------------------------------------------- */

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
    double unit_mm = page_unit_mm(placement);
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

void page_instead(const roberts_page *page, double width_mm, double height_mm, char text[PAGE_INSTEAD])
{
    static const struct {
        const char *name;
        double narrow, wide;
    } sizes[] = {{"--page a4", 210, 297},
                 {"--page a3", 297, 420},
                 {"--page a2", 420, 594},
                 {"--page a1", 594, 841},
                 {"--page a0", 841, 1189}};
    const bool is_wide = page->width_mm > page->height_mm;
    const size_t count = sizeof sizes / sizeof sizes[0];
    if (page->height_mm >= width_mm && page->width_mm >= height_mm) {
        snprintf(text, PAGE_INSTEAD, is_wide ? "the same page upright" : "--landscape");
        return;
    }
    for (size_t i = 0; i < 2 * count; i++) { /* each size as the page lies, then turned */
        const bool lies = is_wide != (i % 2 == 1);
        const double narrow = sizes[i / 2].narrow, wide = sizes[i / 2].wide;
        if ((lies ? wide : narrow) >= width_mm && (lies ? narrow : wide) >= height_mm) {
            snprintf(text, PAGE_INSTEAD, "%s%s%s", is_wide && !lies ? "an upright " : "", sizes[i / 2].name,
                     lies ? " --landscape" : "");
            return;
        }
    }
    snprintf(text, PAGE_INSTEAD, "a larger page");
}

void page_refuse(const roberts_page *page, const roberts_placement *placement, double fitting, roberts_vec2 drawn_mm,
                 const char *instead, roberts_error *error)
{
    char asked[40], fits[40], x_mm[40], y_mm[40];
    scale_name(placement->scale, asked, sizeof asked);
    scale_name(fitting / page_unit_mm(placement), fits, sizeof fits);
    length_name(drawn_mm.x, x_mm, sizeof x_mm);
    length_name(drawn_mm.y, y_mm, sizeof y_mm);
    error_set(
        error, ROBERTS_BAD_ARGUMENT, 0,
        "at %s the drawing is %s x %s mm and would leave the page, whose margins leave %.0f x %.0f; %s would fit%s%s",
        asked, x_mm, y_mm, floor(page->width_mm - 2.0 * page->margin_mm),
        floor(page->height_mm - 2.0 * page->margin_mm), fits, *instead ? ", or " : "", instead);
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
    if (placement->scale > 0.0 && !(x <= room_x + PAGE_SLACK_MM && y <= room_y + PAGE_SLACK_MM)) {
        const double margins = 2.0 * page->margin_mm;
        char instead[PAGE_INSTEAD];
        page_instead(page, 2.0 * x + margins, 2.0 * y + margins, instead);
        page_refuse(page, placement, page_scale(&fitted), (roberts_vec2){2.0 * x, 2.0 * y}, instead, error);
        return false;
    }
    map->page_mm.x += placement->align_x * fmax(room_x - x, 0.0);
    map->page_mm.y -= placement->align_y * fmax(room_y - y, 0.0);
    return true;
}

/* ---- visible regions --------------------------------------------------------------------------------------------- */

/* A list of points that grows. */
typedef struct point_list {
    roberts_vec2 *item;
    size_t count, room;
} point_list;

typedef struct region_walk {
    const strokes *s;
    const page_view *view;
    point_list point;  /* of the region's rings */
    point_list cut[2]; /* a ring before and after a cut */
    size_t *start, start_room;
} region_walk;

static bool add_ring_point(point_list *to, roberts_vec2 p)
{
    if (!array_reserve(&to->item, &to->room, to->count + 1, sizeof *to->item))
        return false;
    to->item[to->count++] = p;
    return true;
}

/* One side of the frame. */
typedef struct frame_side {
    bool upright; /* it bounds x, and not y */
    bool upper;   /* smaller coordinates are inside, greater ones outside */
    double at;
} frame_side;

static bool is_within(const frame_side *side, roberts_vec2 p)
{
    double value = side->upright ? p.x : p.y;
    return side->upper ? value <= side->at : value >= side->at;
}

/* Where a line crosses the side. It is the same for both directions of the line. */
static roberts_vec2 crossing(const frame_side *side, roberts_vec2 p, roberts_vec2 q)
{
    if (vec2_compare(p, q) > 0) {
        roberts_vec2 swapped = p;
        p = q;
        q = swapped;
    }
    if (side->upright)
        return (roberts_vec2){side->at, p.y + (side->at - p.x) / (q.x - p.x) * (q.y - p.y)};
    return (roberts_vec2){p.x + (side->at - p.y) / (q.y - p.y) * (q.x - p.x), side->at};
}

/* False: no memory. */
static bool cut_by(const frame_side *side, const point_list *ring, point_list *to)
{
    bool enough = true;
    to->count = 0;
    for (size_t i = 0; enough && i < ring->count; i++) {
        roberts_vec2 p = ring->item[i], q = ring->item[i + 1 < ring->count ? i + 1 : 0];
        if (is_within(side, p))
            enough = add_ring_point(to, p);
        if (enough && is_within(side, p) != is_within(side, q))
            enough = add_ring_point(to, crossing(side, p, q));
    }
    return enough;
}

/* Copies a ring of the list to cut[0], cut off at the frame if there is one. False: no memory. */
static bool take_ring(region_walk *w, const roberts_region_list *list, size_t ring)
{
    const frame_side side[] = {{true, false, w->view->low.x},
                               {true, true, w->view->high.x},
                               {false, false, w->view->low.y},
                               {false, true, w->view->high.y}};
    bool enough = true;
    w->cut[0].count = 0;
    for (size_t k = list->ring_start[ring]; enough && k < list->ring_start[ring + 1]; k++)
        enough = add_ring_point(&w->cut[0], list->corner[k]);
    for (size_t i = 0; enough && w->view->drawing->framed && i < sizeof side / sizeof side[0]; i++) {
        point_list before = w->cut[0];
        w->cut[0] = w->cut[1];
        w->cut[1] = before;
        enough = cut_by(&side[i], &w->cut[1], &w->cut[0]);
    }
    return enough;
}

/* Appends what is in cut[0] as a ring on the page; nothing if it has no area. False: no memory. */
static bool place_ring(region_walk *w, size_t *rings)
{
    const double units = w->s->units_per_mm;
    bool enough = true;
    if (w->cut[0].count < 3)
        return true;
    if (!array_reserve(&w->start, &w->start_room, *rings + 2, sizeof *w->start))
        return false;
    w->start[(*rings)++] = w->point.count;
    for (size_t k = 0; enough && k < w->cut[0].count; k++) {
        roberts_vec2 mm = page_place(&w->view->map, w->cut[0].item[k]);
        enough = add_ring_point(&w->point, (roberts_vec2){mm.x * units, mm.y * units});
    }
    w->start[*rings] = w->point.count;
    return enough;
}

static bool walk_view(region_walk *w, page_region_fn *each, void *context)
{
    const roberts_region_list *list = w->view->drawing->regions;
    bool enough = true;
    for (size_t i = 0; enough && list && i < list->count; i++) {
        const roberts_region *region = &list->region[i];
        size_t rings = 0;
        w->point.count = 0;
        for (size_t r = region->first_ring; enough && r < region->first_ring + region->ring_count; r++)
            enough = take_ring(w, list, r) && place_ring(w, &rings);
        const roberts_slope *slope = list->slope ? &list->slope[i] : NULL;
        enough = enough && each(context, &(page_region){region, slope, w->view, rings, w->start, w->point.item});
    }
    return enough;
}

bool page_rings_hold(size_t ring_count, const size_t *ring_start, const roberts_vec2 *point, roberts_vec2 at)
{
    bool inside = false;
    for (size_t r = 0; r < ring_count; r++) {
        roberts_vec2 p = point[ring_start[r + 1] - 1];
        for (size_t k = ring_start[r]; k < ring_start[r + 1]; k++) {
            const roberts_vec2 q = point[k];
            inside ^= vec2_ray_crosses(at, p, q);
            p = q;
        }
    }
    return inside;
}

bool page_regions_walk(const strokes *s, page_region_fn *each, void *context)
{
    region_walk w = {.s = s};
    bool enough = true;
    for (size_t i = 0; enough && i < s->views; i++) {
        w.view = &s->view[i];
        enough = walk_view(&w, each, context);
    }
    free(w.point.item);
    free(w.cut[0].item);
    free(w.cut[1].item);
    free(w.start);
    return enough;
}
