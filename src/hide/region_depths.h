/* region_depths.h - how near the viewer the pieces of a face are along a side of a cell of the picture.
 *
 * A face that is not convex, or not planar, is made of convex pieces, each with its own plane. No line separates them
 * in the picture, so a cell may show several. Depth is linear within a piece, so its extremes along a side are at the
 * ends of the parts that lie in one piece each. Corners of pieces are corners of the face or points where its sides
 * cross, so none is inside a cell. */
#ifndef ROBERTS_HIDE_REGION_DEPTHS_H
#define ROBERTS_HIDE_REGION_DEPTHS_H

#include "hide/fronts.h"
#include "model/box_tree.h"

/* The part t0 .. t1 of a side in one piece, and the depths of its ends. */
typedef struct depth_part {
    double t0, t1, z0, z1;
} depth_part;

/* Faces of several pieces. */
typedef struct region_depths {
    const hide_fronts *fronts;
    box_tree tree; /* the pictures of the pieces, one tree for each face */
    uint32_t
        *root; /* [face_count of scene] of the first piece of such a face; else ROBERTS_NONE. NULL: there is none */
    double touching; /* pieces nearer to a side than this hold it, view units */
} region_depths;

/* A list of parts. One for each thread; the caller frees `part`. */
typedef struct depth_parts {
    depth_part *part; /* [count] */
    size_t count, room;
} depth_parts;

/* Depths from the farthest to the nearest, view units; low > high: none. */
typedef struct depth_range {
    double low, high;
} depth_range;

/* False: no memory. Call region_depths_free() in any case. */
bool region_depths_build(region_depths *depths, const hide_fronts *fronts, double touching);
void region_depths_free(region_depths *depths);

/* Does a face have several pieces? first: its first piece. */
static inline bool region_depths_has(const region_depths *depths, uint32_t first)
{
    return depths->root && depths->root[first] != ROBERTS_NONE;
}

/* Widens a range by the depths of the visible surface of such a face along the side PQ of a cell that shows it. If no
 * piece is there, it does not change. False: no memory. */
bool region_depths_along(const region_depths *depths, uint32_t first, const roberts_vec2 side[2], depth_parts *parts,
                         depth_range *range);

/* Returns the depth of a face's plane at (x, y), limited to the depths of its corners. */
double region_depth_at(const hide_fronts *fronts, const uint32_t *corner, uint32_t count, plane F, roberts_vec2 at);

#endif
