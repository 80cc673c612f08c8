/* page_regions.h - the visible regions of all views of a page, one after another, as polygons on the paper. Fills,
 * hatching and labels use them. */
#ifndef ROBERTS_DRAW_PAGE_REGIONS_H
#define ROBERTS_DRAW_PAGE_REGIONS_H

#include "draw/strokes.h"

/* The visible part of a face, on the page. Rings are cut off at the frame of a field of view, like lines. On the paper,
 * where y is down, rings round pieces run clockwise, and those round holes counter-clockwise. A cut may leave parts
 * that run along the frame and back. */
typedef struct page_region {
    const roberts_region *region;
    const page_view *view;
    size_t ring_count;         /* 0: nothing of it is within the frame */
    const size_t *ring_start;  /* [ring_count + 1] */
    const roberts_vec2 *point; /* ring r has point[ring_start[r]] .. [ring_start[r + 1] - 1]; units of the page, not
                                  rounded */
} page_region;

/* Receives a region, valid during the call only. False: no memory; the walk ends. */
typedef bool page_region_fn(void *context, const page_region *region);

/* Passes all regions to `each`: view by view, each in the order of its list. Two regions that share a border have the
 * same points there, those of a cut included. False: no memory. */
bool page_regions_walk(const strokes *s, page_region_fn *each, void *context);

#endif
