/* page.h - where a drawing lies on the paper, and its visible regions there. */
#ifndef ROBERTS_DRAW_PAGE_H
#define ROBERTS_DRAW_PAGE_H

#include "roberts.h"

/* mm: half of what coordinates are rounded to. What is no larger does not show. */
#define PAGE_SLACK_MM 0.0005

struct page_view;
struct strokes;

/* The map from the picture (model units, y up) to paper (mm from the upper left corner, y down). Lengths are fractions
 * of `half`, half of the side of the drawing's box that determines the scale, so neither a box of 1e300 nor one of
 * 1e-300 causes an overflow. */
typedef struct page_map {
    roberts_vec2 centre;  /* of the drawing's box, model units */
    double half;          /* model units, > 0 */
    double half_mm;       /* what `half` is on paper */
    roberts_vec2 page_mm; /* where the centre lies on paper */
} page_map;

/* Whether the page's size is valid and its margins leave room; fills `error` if not. */
bool page_is_valid(const roberts_page *page, roberts_error *error);

/* Whether scale, unit and alignment are valid; fills `error` if not. */
bool page_placement_is_valid(const roberts_placement *placement, roberts_error *error);

enum { PAGE_INSTEAD = 32 };

/* Writes what would do in place of `page`, as options: the page turned, or the smallest of A4 to A0 that has this width
 * and height, lying as `page` does if it can. */
void page_instead(const roberts_page *page, double width_mm, double height_mm, char text[PAGE_INSTEAD]);

/* Fills `error`: the drawing, `drawn_mm` large at the placement's scale, does not fit on the page. The message names
 * the scale that would fit, `fitting` mm per model unit, and `instead` unless that is empty. */
void page_refuse(const roberts_page *page, const roberts_placement *placement, double fitting, roberts_vec2 drawn_mm,
                 const char *instead, roberts_error *error);

/* Fits the box from `min` to `max`, finite, into the page's margins, as large as possible and centred. A box without
 * width or height is fitted by its other side. A point lies in the middle, at one mm per model unit; the box of an
 * empty drawing is a point. */
page_map page_fit(const roberts_page *page, roberts_vec2 min, roberts_vec2 max);

/* Lays the box on the page as `placement` says: fitted or at a scale, and aligned with the margins. False: the
 * placement is invalid, or the drawing leaves the margins at its scale; fills `error`, which names a scale
 * that fits. */
bool page_lay(const roberts_page *page, const roberts_placement *placement, roberts_vec2 min, roberts_vec2 max,
              page_map *map, roberts_error *error);

/* A model unit in mm. */
static inline double page_unit_mm(const roberts_placement *placement)
{
    return placement->unit_mm > 0.0 ? placement->unit_mm : 1.0;
}

/* The placement's scale in mm per model unit, if `fitting` is the largest that fits. 0 stands for `fitting`. */
double page_wanted_scale(const roberts_placement *placement, double fitting);

/* mm on paper per model unit. */
double page_scale(const page_map *map);

static inline roberts_vec2 page_place(const page_map *map, roberts_vec2 p)
{
    return (roberts_vec2){map->page_mm.x + (p.x - map->centre.x) / map->half * map->half_mm,
                          map->page_mm.y - (p.y - map->centre.y) / map->half * map->half_mm};
}

/* The point of the picture that page_place() puts there. */
static inline roberts_vec2 page_picture(const page_map *map, roberts_vec2 mm)
{
    return (roberts_vec2){map->centre.x + (mm.x - map->page_mm.x) / map->half_mm * map->half,
                          map->centre.y - (mm.y - map->page_mm.y) / map->half_mm * map->half};
}

/* ---- visible regions --------------------------------------------------------------------------------------------- */

/* The visible regions of all views of a page, one after another, as polygons on the paper. Fills, hatching and labels
 * use them. */

/* The visible part of a face, on the page. Rings are cut off at the frame of a field of view, like lines. On the paper,
 * where y is down, rings round pieces run clockwise, and those round holes counter-clockwise. A cut may leave parts
 * that run along the frame and back. */
typedef struct page_region {
    const roberts_region *region;
    const roberts_slope *slope; /* NULL: not known */
    const struct page_view *view;
    size_t ring_count;         /* 0: nothing of it is within the frame */
    const size_t *ring_start;  /* [ring_count + 1] */
    const roberts_vec2 *point; /* ring r has point[ring_start[r]] .. [ring_start[r + 1] - 1]; units of the page, not
                                  rounded */
} page_region;

/* Is a point within rings, as in page_region and roberts_region_list? By the parity of crossings. */
bool page_rings_hold(size_t ring_count, const size_t *ring_start, const roberts_vec2 *point, roberts_vec2 at);

/* Receives a region, valid during the call only. False: no memory; the walk ends. */
typedef bool page_region_fn(void *context, const page_region *region);

/* Passes all regions to `each`: view by view, each in the order of its list. Two regions that share a border have the
 * same points there, those of a cut included. False: no memory. */
bool page_regions_walk(const struct strokes *s, page_region_fn *each, void *context);

#endif
