/* free_space.h - where there is room on the page: lines and boxes that text must keep away from, in a grid; and which
 * point of a region has most room round it. */
#ifndef ROBERTS_DRAW_FREE_SPACE_H
#define ROBERTS_DRAW_FREE_SPACE_H

#include "draw/chain.h"
#include "roberts.h"

/* A rectangle with sides along those of the page; mm. */
typedef struct space_box {
    roberts_vec2 min, max;
} space_box;

/* The least box that holds both points. */
static inline space_box space_box_around(roberts_vec2 a, roberts_vec2 b)
{
    return (space_box){{fmin(a.x, b.x), fmin(a.y, b.y)}, {fmax(a.x, b.x), fmax(a.y, b.y)}};
}

typedef struct free_space free_space;

/* An empty page of this size. within: what text must not leave. NULL: no memory. */
free_space *space_new(double width_mm, double height_mm, double cell_mm, const space_box *within);
void space_free(free_space *r);

/* Each returns false where there is no memory. A box may be moved later, under the number that it got. */
bool space_add_line(free_space *r, roberts_vec2 a, roberts_vec2 b);
bool space_add_polyline(free_space *r, const polylines *lines, size_t i, double units_per_mm);
bool space_add_box(free_space *r, const space_box *box, uint32_t *number);
/* Adds boxes, widened by `more` on all sides. */
bool space_add_boxes(free_space *r, const space_box *box, size_t count, double more);
bool space_move_box(free_space *r, uint32_t number, const space_box *box);
void space_drop_box(free_space *r, uint32_t number);

/* What lies in a box. */
typedef struct space_load {
    double mm; /* lengths of lines, and the shorter sides of overlaps with other boxes. 0: it is free. Infinite: the
                  box leaves `within` */
    uint32_t boxes; /* other boxes that it overlaps by more than a line */
} space_load;

/* What lies in `box`. The box of number `own` does not count. Does not go on where more than `most_boxes` boxes, or at
 * least `enough` mm, have been found. */
space_load space_load_of(const free_space *r, const space_box *box, uint32_t own, uint32_t most_boxes, double enough);

/* How far the nearest box is from `box`, at most `most` mm; 0: it overlaps. The box of number `own` does not count. */
double space_to_next_box(const free_space *r, const space_box *box, uint32_t own, double most);

/* Has a line a part within `box`? Here the box may leave `within`. */
bool space_meets_line(const free_space *r, const space_box *box);

/* How many lines cross the one from a to b. One that ends on it does not. */
size_t space_count_crossings(const free_space *r, roberts_vec2 a, roberts_vec2 b);

/* Do the lines from a to b and from c to d cross, not just touch? */
bool space_lines_cross(roberts_vec2 a, roberts_vec2 b, roberts_vec2 c, roberts_vec2 d);

/* Does the line from a to b have a part within a box; within any box of the page but `own`? */
bool space_line_meets_box(roberts_vec2 a, roberts_vec2 b, const space_box *box);
bool space_line_meets_boxes(const free_space *r, roberts_vec2 a, roberts_vec2 b, uint32_t own);

/* Parts of a line, as parameters along it. Zeroed = empty; release with free(item). */
typedef struct space_part {
    double from, to;
} space_part;

typedef struct space_parts {
    space_part *item;
    size_t count, room;
} space_parts;

/* Finds the parts of the line from a to b that lie in boxes. They ascend and are disjoint. False: no memory. */
bool space_find_covered(const free_space *r, roberts_vec2 a, roberts_vec2 b, space_parts *out);

/* ---- the middle of a region -------------------------------------------------------------------------------------- */

/* A point within a region, and how far the nearest line is; model units of the picture. */
typedef struct pole {
    roberts_vec2 at;
    double distance;
} pole;

/* A line in the picture. */
typedef struct pole_line {
    roberts_vec2 a, b;
} pole_line;

/* The point of a region that is farthest from some lines, to about a hundredth of the region's size. line: [count], of
 * which the first `border` go round the region, in any order. within: only this box of the picture counts; NULL: all of
 * it. A distance of 0: no point has been found. */
pole pole_find(const pole_line *line, size_t count, size_t border, const space_box *within);

#endif
