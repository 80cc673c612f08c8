/* regions.h - what is seen of each face, as polygons with holes. */
#ifndef ROBERTS_HIDE_REGIONS_H
#define ROBERTS_HIDE_REGIONS_H

#include "hide/hide.h"
#include "hide/planar_map.h"

/* The lines between regions, taken from the segments of a drawing and of the edges that it leaves out. */
typedef struct region_lines {
    planar_map map;
    const roberts_drawing *drawing;
    size_t taken;    /* segments of the drawing */
    double per_unit; /* as in `view` */
} region_lines;

/* A roberts_segment_fn: takes a segment that the drawing leaves out, and those of the drawing before it. context:
 * region_lines. False: no memory. */
bool region_lines_take(void *context, const roberts_segment *rest);

/* Finds the visible regions. The rest of the drawing's segments is taken first. False: no memory. */
bool regions_find(const hide_job *job, region_lines *lines);

#endif
