/* segments.h - the lines of one body, or lines in which faces cross, and their segments. */
#ifndef ROBERTS_HIDE_SEGMENTS_H
#define ROBERTS_HIDE_SEGMENTS_H

#include "hide/crossings.h"
#include "hide/planar_map.h"
#include "hide/schedule.h"

/* One scene seen by one camera: everything that determines its segments. */
typedef struct hide_job {
    const roberts_hide_options *options;
    const roberts_receiver *to;          /* receives the segments; NULL: the drawing keeps them */
    struct roberts_region_list *regions; /* NULL: not wanted */
    bool merge_bodies;                   /* regions of several bodies may be merged */
    roberts_vec3 upright;                /* of regions: what points up in the model */
    seen seen;
    hide_fronts fronts;
    objet grid;
    picture_order order; /* what was found before its turn, if anything */
    crossings crossings; /* lines that are no edges */
} hide_job;

/* Are all lines of the body taken together? Yes for a convex body, whose lines share their own faces, and for any body
 * with few edges. */
bool segments_at_once(const hide_job *job, uint32_t body);

/* Adds the lines of such a body that are not covered, and finds their hidden parts; if hidden segments are kept, also
 * the bodies seen there. A body without segments has no such lines. False: no memory. */
bool segments_hide(const hide_job *job, hide_worker *w, uint32_t body);

/* Adds the segments of the bodies first .. end - 1, using what was found before their turn. False: no memory, or
 * out->stopped. */
bool segments_find(const hide_job *job, hide_worker *w, hide_chunk *out, uint32_t first, uint32_t end);

/* The same for the lines first .. end - 1 in which faces cross. */
bool segments_cross(const hide_job *job, hide_worker *w, hide_chunk *out, size_t first, size_t end);

/* Hides a scene. Without options (NULL) the defaults hold. (hide.c) */
roberts_status hide_scene(hide_job *job, const roberts_scene *scene, const roberts_camera *camera,
                          roberts_drawing *drawing, roberts_error *error);

/* The lines between regions, taken from the segments of a drawing and of the edges that it leaves out. (regions.c) */
typedef struct region_lines {
    planar_map map;
    const roberts_drawing *drawing;
    size_t taken;    /* segments of the drawing */
    double per_unit; /* as in `view` */
} region_lines;

/* A roberts_segment_fn: takes a segment that the drawing leaves out, and those of the drawing before it. context:
 * region_lines. False: no memory. */
bool region_lines_take(void *context, const roberts_segment *rest);
void region_lines_free(region_lines *lines);

/* Finds the visible regions. The rest of the drawing's segments is taken first. False: no memory. (regions.c) */
bool regions_find(const hide_job *job, region_lines *lines);

#endif
