/* page_regions.c - see page_regions.h. Rings are cut by one side of the frame after another: I. E. Sutherland, G. W.
 * Hodgman, "Reentrant polygon clipping", Communications of the ACM 17(1), 1974. */
#include "draw/page_regions.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/vec.h"

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
        enough = enough && each(context, &(page_region){region, w->view, rings, w->start, w->point.item});
    }
    return enough;
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
