/* region_faces.h - what regions take from their faces: colours, directions, depths, and which neighbours lie in one
 * plane. */
#ifndef ROBERTS_HIDE_REGION_FACES_H
#define ROBERTS_HIDE_REGION_FACES_H

#include "base/search.h"
#include "hide/fronts.h"
#include "hide/hide.h"
#include "view/seen.h"

/* Faces are those of job->fronts.scene; of several pieces, the first. */

/* The colour of a face in the input. If it has none, the mean colour of its corners, provided that all of them have
 * one. */
roberts_color region_color(const hide_job *job, uint32_t piece);

/* Can the regions of two neighbours become one? The faces must lie in one plane, as far as both are planar, have the
 * same colour, and belong to one body or to bodies drawn as one. */
bool region_can_join(const hide_job *job, uint32_t f, uint32_t g);

/* ---- directions ---- */

/* What points up in the model: +z, or the axis along which the camera's `up` lies. A camera that looks along z has any
 * such `up`, so there it is +z. */
roberts_vec3 slope_upright(const roberts_camera *camera);

/* The unit normal of scene face `face`, as in roberts_region. F: its scene_whole_plane(). */
roberts_vec3 region_normal(const seen *s, uint32_t face, plane F);

/* Finds directions in the plane of scene face `face`, which is F. upright: a unit vector. Faces in one plane that are
 * seen from the same side get the same values, except for rounding. */
roberts_slope slope_find(const seen *s, uint32_t face, plane F, roberts_vec3 upright);

/* ---- depths of faces of several pieces ---- */

/* How near the viewer the pieces of a face are along a side of a cell of the picture.
 *
 * A face that is not convex, or not planar, is made of convex pieces, each with its own plane. No line separates them
 * in the picture, so a cell may show several. Depth is linear within a piece, so its extremes along a side are at the
 * ends of the parts that lie in one piece each. Corners of pieces are corners of the face or points where its sides
 * cross, so none is inside a cell. */

/* The part t0 .. t1 of a side in one piece, and the depths of its ends. */
typedef struct depth_part {
    double t0, t1, z0, z1;
} depth_part;

/* Faces of several pieces. */
typedef struct region_depths {
    const hide_fronts *fronts;
    box_tree tree; /* the pictures of the pieces, one tree for each face */
    /* [face_count of scene] of the first piece of such a face; else ROBERTS_NONE. NULL: there is none */
    uint32_t *root;
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
