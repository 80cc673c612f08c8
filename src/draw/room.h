/* room.h - where there is room on the page: lines and boxes that text must keep away from, in a
 * grid; and which point of a region has most room round it. */
#ifndef ROBERTS_DRAW_ROOM_H
#define ROBERTS_DRAW_ROOM_H

#include "draw/chain.h"
#include "roberts.h"

/* A rectangle with sides along those of the page; mm. */
typedef struct room_box {
    roberts_vec2 min, max;
} room_box;

typedef struct page_room page_room;

/* An empty page of this size. NULL: no memory. */
page_room *room_new(double width_mm, double height_mm, double cell_mm);
void room_free(page_room *r);

/* Each returns false where there is no memory. A box may be moved later, under the number that it got. */
bool room_add_line(page_room *r, roberts_vec2 a, roberts_vec2 b);
bool room_add_polyline(page_room *r, const polylines *lines, size_t i, double units_per_mm);
bool room_add_box(page_room *r, const room_box *box, uint32_t *number);
bool room_move_box(page_room *r, uint32_t number, const room_box *box);
void room_drop_box(page_room *r, uint32_t number);

/* How much lies in `box`, in mm: lengths of lines, and the shorter sides of overlaps with other boxes. 0: it is free.
 * The box of number `own` does not count. Infinite if the box leaves the page. */
double room_taken(const page_room *r, const room_box *box, uint32_t own);

/* Whether it overlaps another box by more than a line. */
bool room_is_on_box(const page_room *r, const room_box *box, uint32_t own);

/* ---- the middle of a region -------------------------------------------------------------------------------------- */

/* A point within a region, and how far its border is; model units of the picture. */
typedef struct pole {
    roberts_vec2 at;
    double distance;
} pole;

/* The pole of inaccessibility, to about a hundredth of the region's size. */
pole pole_find(const roberts_region_list *list, const roberts_region *region);

#endif
