/* sheet.c - where the views of a sheet lie on the paper.
 *
 * Two columns and two rows: the front view stands in the first column, the top view above or below it, the side view
 * beside it, and the isometric view in the middle of the remaining cell. All views have the centre of the scene at 0,
 * 0, so that front and top view have one x, front and side view one y. A strip below all views is reserved for the
 * symbol, if there is one.
 *
 * Lengths of the model are divided by the largest one, so nothing overflows. */
#include "draw/sheet.h"

#include <math.h>

#include "base/angle.h"
#include "base/error.h"
#include "draw/dimensions.h"
#include "draw/title_block.h"

/* mm */
static const double default_gap = 15.0, gap_for_distances = 25.0;
static const double views_from_frame = 10.0;
static const double symbol_from_frame = 5.0, symbol_from_views = 5.0;
static const double between_texts = 5.0; /* of two views: so that each is seen to belong to its view */

enum { FRONT = ROBERTS_SHEET_FRONT, TOP = ROBERTS_SHEET_TOP, SIDE = ROBERTS_SHEET_SIDE, ISO = ROBERTS_SHEET_ISO };

/* A range along one axis of the picture; empty if low > high. */
typedef struct range {
    double low, high;
} range;

/* The two columns of a sheet, or its two rows: that of the front view and that of the isometric view. */
typedef struct cells {
    double front, iso;       /* widths, parts of layout.half */
    double gap_mm;           /* between them */
    double front_mm, iso_mm; /* where they begin, from the left or upper border of the page */
} cells;

typedef struct layout {
    double half;                                          /* the largest coordinate, model units */
    range x[ROBERTS_SHEET_VIEWS], y[ROBERTS_SHEET_VIEWS]; /* of each view, parts of `half` */
    cells columns, rows;
    double half_mm;         /* what `half` is on paper */
    double symbol_size;     /* as in sheet_map */
    double left_mm, top_mm; /* of the room for the views */
    /* What text needs beside all views, mm. */
    double left, right, above, below;
} layout;

static range join_ranges(range a, range b)
{
    return (range){fmin(a.low, b.low), fmax(a.high, b.high)};
}

static bool is_empty(range a)
{
    return !(a.low <= a.high);
}

static double length(range a)
{
    return is_empty(a) ? 0.0 : a.high - a.low;
}

static double range_middle(range a)
{
    return is_empty(a) ? 0.0 : (a.low + a.high) / 2.0;
}

static void take_windows(const roberts_sheet *sheet, layout *l)
{
    double most = 0.0;
    for (int i = 0; i < ROBERTS_SHEET_VIEWS; i++) {
        const roberts_drawing *d = sheet->view[i];
        if (d)
            most = fmax(most, fmax(fmax(fabs(d->window_min.x), fabs(d->window_max.x)),
                                   fmax(fabs(d->window_min.y), fabs(d->window_max.y))));
    }
    l->half = most > 0.0 ? most : 1.0;
    for (int i = 0; i < ROBERTS_SHEET_VIEWS; i++) {
        const roberts_drawing *d = sheet->view[i];
        l->x[i] = l->y[i] = (range){INFINITY, -INFINITY};
        if (d) {
            l->x[i] = (range){d->window_min.x / l->half, d->window_max.x / l->half};
            l->y[i] = (range){d->window_min.y / l->half, d->window_max.y / l->half};
        }
    }
}

/* Views that are left out need no gap; those of a flat scene that are mere lines do. */
static cells widths(range front, range beside, range iso, double gap_mm)
{
    const bool is_divided = !is_empty(front) && !(is_empty(beside) && is_empty(iso));
    return (cells){
        .front = length(front),
        .iso = fmax(length(beside), length(iso)),
        .gap_mm = is_divided ? gap_mm : 0.0,
    };
}

/* A gap with room for what reaches into it from both sides. */
static double widened(double gap_mm, double from_one, double from_other)
{
    const double apart = from_one > 0.0 && from_other > 0.0 ? between_texts : 0.0;
    return fmax(gap_mm, from_one + apart + from_other);
}

/* Front and top view share their x, front and side view their y. */
static void divide_sheet(const roberts_sheet *sheet, const roberts_draw_options *options, const sheet_reach *reach,
                         layout *l)
{
    const double usual = options->lettering.distance_count > 0 ? gap_for_distances : default_gap;
    const int upper = sheet->angle == ROBERTS_THIRD_ANGLE ? TOP : FRONT, lower = upper == TOP ? FRONT : TOP;
    const int upper_right = upper == TOP ? ISO : SIDE, lower_right = upper == TOP ? SIDE : ISO;
    double wide = sheet->gap_mm, high = sheet->gap_mm;
    if (sheet->gap_mm <= 0.0) {
        wide = widened(usual, fmax(reach->view[FRONT].right, reach->view[TOP].right),
                       fmax(reach->view[SIDE].left, reach->view[ISO].left));
        high = widened(usual, fmax(reach->view[upper].below, reach->view[upper_right].below),
                       fmax(reach->view[lower].above, reach->view[lower_right].above));
    }
    l->left = fmax(reach->view[FRONT].left, reach->view[TOP].left);
    l->right = fmax(reach->view[SIDE].right, reach->view[ISO].right);
    l->above = fmax(reach->view[upper].above, reach->view[upper_right].above);
    l->below = fmax(reach->view[lower].below, reach->view[lower_right].below);
    l->x[FRONT] = l->x[TOP] = join_ranges(l->x[FRONT], l->x[TOP]);
    l->y[FRONT] = l->y[SIDE] = join_ranges(l->y[FRONT], l->y[SIDE]);
    l->columns = widths(l->x[FRONT], l->x[SIDE], l->x[ISO], wide);
    l->rows = widths(l->y[FRONT], l->y[TOP], l->y[ISO], high);
}

/* The size of the symbol if margins and frame leave this width and height. It is no wider and no higher than one of
 * four equal cells for the views, with gaps between them. It suits lettering of at least 1.8 mm, the smallest of ISO
 * 3098; otherwise the size is 0. */
static double fit_symbol(const layout *l, double width_mm, double height_mm)
{
    const double least = 1.8 / 3.5;
    double size = fmin((width_mm - l->columns.gap_mm) / (2.0 * SYMBOL_WIDTH),
                       (height_mm - symbol_from_views - l->rows.gap_mm) / (3.0 * SYMBOL_HEIGHT));
    return size < least ? 0.0 : fmin(size, 1.0);
}

/* Subtracts the strip of the title block from the room. Each view must have at least 20 mm. */
static bool fit_block(layout *l, const roberts_draw_options *options, roberts_page *room, roberts_error *error)
{
    const double views_least = 20.0;
    const roberts_page *page = &options->page;
    const double bottom = page->margin_mm + BLOCK_HEIGHT + symbol_from_views;
    room->height_mm -= bottom;
    l->symbol_size = 0.0;
    if (!options->symbol.off)
        title_block_symbol(&l->symbol_size);
    const double width = fmax(BLOCK_WIDTH + 2.0 * page->margin_mm,
                              page->width_mm - room->width_mm + l->columns.gap_mm + 2.0 * views_least);
    const double height = page->height_mm - room->height_mm + l->rows.gap_mm + 2.0 * views_least;
    if (page->width_mm >= width && page->height_mm >= height)
        return true;
    char instead[PAGE_INSTEAD];
    page_instead(page, width, height, instead);
    error_set(error, ROBERTS_BAD_ARGUMENT, 0,
              "page: title block and views need %.0f x %.0f mm with these margins, and the page has %.0f x %.0f: %s "
              "would do",
              ceil(width), ceil(height), page->width_mm, page->height_mm, instead);
    return false;
}

/* Finds the room for the views and their gaps, as a page. Fills l->symbol_size. */
static bool find_room(layout *l, const roberts_draw_options *options, bool third, roberts_page *room,
                      roberts_error *error)
{
    const roberts_page *page = &options->page;
    double edge = page->margin_mm + (options->frame.off ? 0.0 : views_from_frame);
    double below = options->frame.off ? page->margin_mm : page->margin_mm + symbol_from_frame;
    double left = l->left, above = l->above, below_views = l->below;
    if (options->lettering.overall || options->lettering.distance_count > 0) {
        const double beside = dimensions_room(options);
        left = fmax(left, beside);
        above = third ? above : fmax(above, beside);
        below_views = third ? fmax(below_views, beside) : below_views;
    }
    *room = (roberts_page){page->width_mm - 2.0 * edge - left - l->right, page->height_mm - edge - above - below_views,
                           0.0};
    l->left_mm = edge + left;
    l->top_mm = edge + above;
    if (title_block_is_wanted(options))
        return fit_block(l, options, room, error);
    l->symbol_size = options->symbol.off ? 0.0 : fit_symbol(l, room->width_mm, room->height_mm - below);
    below += l->symbol_size * SYMBOL_HEIGHT + symbol_from_views;
    room->height_mm -= l->symbol_size > 0.0 ? fmax(edge, below) : edge;
    if (room->width_mm > l->columns.gap_mm && room->height_mm > l->rows.gap_mm)
        return true;
    error_set(error, ROBERTS_BAD_ARGUMENT, 0, "page: margins and gaps leave no room for the views of a sheet");
    return false;
}

/* Fills l->half_mm. */
static bool find_scale(layout *l, const roberts_placement *placement, const roberts_page *room, roberts_error *error)
{
    const roberts_vec2 gap = {l->columns.gap_mm, l->rows.gap_mm};
    const roberts_vec2 views = {l->columns.front + l->columns.iso, l->rows.front + l->rows.iso};
    double fitted = fmin((room->width_mm - gap.x) / views.x, (room->height_mm - gap.y) / views.y);
    l->half_mm = isfinite(fitted) ? fitted : 1.0;
    const double wanted = page_wanted_scale(placement, l->half_mm / l->half);
    if (wanted == 0.0)
        return true;
    l->half_mm = wanted * l->half;
    roberts_vec2 drawn = {views.x * l->half_mm + gap.x, views.y * l->half_mm + gap.y};
    if (drawn.x <= room->width_mm + PAGE_SLACK_MM && drawn.y <= room->height_mm + PAGE_SLACK_MM)
        return true;
    page_refuse(room, placement, fitted / l->half, drawn, "", error);
    return false;
}

/* Places a column or row of cells in `room_mm` from `start_mm` on. align: -1 at the start, 1 at the end. */
static void place_cells(cells *c, double half_mm, double start_mm, double room_mm, int align, bool iso_first)
{
    double front = c->front * half_mm, iso = c->iso * half_mm, free_mm = room_mm - front - c->gap_mm - iso;
    start_mm += (1 + align) / 2.0 * fmax(free_mm, 0.0);
    c->front_mm = iso_first ? start_mm + iso + c->gap_mm : start_mm;
    c->iso_mm = iso_first ? start_mm : start_mm + front + c->gap_mm;
}

/* Where 0, 0 of a view lies on paper. */
static roberts_vec2 origin(const layout *l, int view, bool top_is_above)
{
    const double k = l->half_mm, column = l->columns.iso_mm, row = l->rows.iso_mm;
    roberts_vec2 at = {l->columns.front_mm - l->x[FRONT].low * k, l->rows.front_mm + l->y[FRONT].high * k};
    if (view == SIDE)
        at.x = column - l->x[SIDE].low * k;
    if (view == TOP) /* next to the front view, a gap away */
        at.y = top_is_above ? row + (l->rows.iso + l->y[TOP].low) * k : row + l->y[TOP].high * k;
    if (view == ISO) {
        at.x = column + (l->columns.iso / 2.0 - range_middle(l->x[ISO])) * k;
        at.y = row + (l->rows.iso / 2.0 + range_middle(l->y[ISO])) * k;
    }
    return at;
}

void sheet_add_reach(sheet_reach *reach, const sheet_reach *more)
{
    for (int i = 0; i < ROBERTS_SHEET_VIEWS; i++) {
        reach->view[i].left = fmax(reach->view[i].left, more->view[i].left);
        reach->view[i].right = fmax(reach->view[i].right, more->view[i].right);
        reach->view[i].above = fmax(reach->view[i].above, more->view[i].above);
        reach->view[i].below = fmax(reach->view[i].below, more->view[i].below);
    }
}

void sheet_add_box(sheet_reach *reach, const page_view *view, const space_box *box, double more)
{
    const roberts_vec2 low = page_place(&view->map, view->drawing->window_min);
    const roberts_vec2 high = page_place(&view->map, view->drawing->window_max);
    const double beyond[4] = {low.x - box->min.x, box->max.x - high.x, high.y - box->min.y, box->max.y - low.y};
    double *own[4] = {&reach->view[view->place].left, &reach->view[view->place].right, &reach->view[view->place].above,
                      &reach->view[view->place].below};
    for (int i = 0; i < 4; i++)
        if (beyond[i] > 0.0)
            *own[i] = fmax(*own[i], beyond[i] + more);
}

bool sheet_lay(const roberts_sheet *sheet, const roberts_draw_options *options, const sheet_reach *reach,
               sheet_map *map, roberts_error *error)
{
    const roberts_page *page = &options->page;
    const roberts_placement *placement = &options->placement;
    const bool third = sheet->angle == ROBERTS_THIRD_ANGLE;
    roberts_page room;
    layout l;
    if (!page_placement_is_valid(placement, error))
        return false;
    take_windows(sheet, &l);
    divide_sheet(sheet, options, reach, &l);
    if (!find_room(&l, options, third, &room, error) || !find_scale(&l, placement, &room, error))
        return false;
    place_cells(&l.columns, l.half_mm, l.left_mm, room.width_mm, placement->align_x, false);
    place_cells(&l.rows, l.half_mm, l.top_mm, room.height_mm, -placement->align_y, third);
    for (int i = 0; i < ROBERTS_SHEET_VIEWS; i++)
        map->view[i] = (page_map){.half = l.half, .half_mm = l.half_mm, .page_mm = origin(&l, i, third)};
    const double edge = page->margin_mm + (options->frame.off ? 0.0 : symbol_from_frame);
    map->symbol_size = l.symbol_size;
    map->symbol_mm = (roberts_vec2){page->width_mm - edge, page->height_mm - edge};
    if (title_block_is_wanted(options)) {
        double size;
        const roberts_vec2 in_block = title_block_symbol(&size);
        map->symbol_mm.x = page->width_mm - page->margin_mm - in_block.x;
        map->symbol_mm.y = page->height_mm - page->margin_mm - in_block.y;
    }
    return true;
}

const char *roberts_sheet_view_name(roberts_sheet_angle angle, int view)
{
    static const char *const name[ROBERTS_SHEET_VIEWS] = {
        [FRONT] = "front", [TOP] = "top", [SIDE] = "right", [ISO] = "iso"};
    if (view < 0 || view >= ROBERTS_SHEET_VIEWS)
        return NULL;
    return view == SIDE && angle == ROBERTS_FIRST_ANGLE ? "left" : name[view];
}

/* The isometric view shows the same side as the side view. */
bool roberts_sheet_camera(roberts_sheet_angle angle, int view, roberts_camera *camera)
{
    const char *name = roberts_sheet_view_name(angle, view);
    if (!name || !roberts_camera_preset(name, camera))
        return false;
    if (view == ISO && angle == ROBERTS_FIRST_ANGLE)
        camera->dir.x = -camera->dir.x;
    return true;
}

/* ---- the symbol of the projection method (ISO 5456-2) ----
 *
 * A truncated cone has its narrow end on the left. Beside it stands the view of it from the left, two circles: on the
 * right in first angle projection, on the left in third angle projection. In full size the narrow end is as wide as
 * lettering of 3.5 mm is high. Centre lines are dashes and dots (ISO 128-2), arranged so that those of the circles
 * cross in a dash. */

/* mm */
static const double narrow = 1.75, wide = 3.5; /* radii; `wide` is also half of the cone's length */
static const double overhang = 1.75;           /* of centre lines */
static const double apart = 12.25;             /* between the middles of cone and circles */

enum { CIRCLE_CORNERS = 48 /* within 0.008 mm of the circle */ };

typedef struct symbol {
    polylines *out;
    roberts_vec2 origin; /* of the coordinates that are added, mm on the page */
    double size;
    double units_per_mm;
    bool failed;
} symbol;

static void add_symbol_point(symbol *s, double x, double y)
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
    add_symbol_point(s, -wide, -narrow);
    add_symbol_point(s, wide, -wide);
    add_symbol_point(s, wide, wide);
    add_symbol_point(s, -wide, narrow);
}

static void add_circle(symbol *s, double radius)
{
    start(s, true);
    for (int i = 0; i < CIRCLE_CORNERS; i++) {
        roberts_vec2 p = angle_unit(360.0 * i / CIRCLE_CORNERS);
        add_symbol_point(s, radius * p.x, radius * p.y);
    }
}

/* A centre line through the origin, upright or level. */
static void add_centre_line(symbol *s, bool upright)
{
    const double ends[][2] = {
        {-wide - overhang, -3.6}, {-2.65, -2.45}, {-1.5, 1.5}, {2.45, 2.65}, {3.6, wide + overhang}};
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++) {
        start(s, false);
        for (int k = 0; k < 2; k++)
            add_symbol_point(s, upright ? 0.0 : ends[i][k], upright ? ends[i][k] : 0.0);
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
