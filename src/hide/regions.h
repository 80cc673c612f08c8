/* regions.h - what is seen of each face, as polygons with holes. */
#ifndef ROBERTS_HIDE_REGIONS_H
#define ROBERTS_HIDE_REGIONS_H

#include "hide/hide.h"
#include "hide/planar_map.h"

/* The lines between regions, and those of them that the drawing has. */
typedef struct region_lines {
    planar_map map;
    roberts_segment *segment; /* [count] of the drawing */
    size_t count, room;
    double per_unit; /* as in `view` */
} region_lines;

/* A roberts_segment_fn: takes a visible segment. context: region_lines. False: no memory. */
bool region_lines_take(void *context, const roberts_segment *s);

/* Finds the visible regions. map: of all lines between them. False: no memory. */
bool regions_find(const hide_job *job, planar_map *map);

#endif
