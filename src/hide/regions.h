/* regions.h - what is seen of each face, as polygons with holes. */
#ifndef ROBERTS_HIDE_REGIONS_H
#define ROBERTS_HIDE_REGIONS_H

#include "hide/hide.h"
#include "hide/planar_map.h"

/* How far apart things may be that should meet, view units. */
typedef struct region_near {
    double touching; /* in a model that is not rounded */
    double joined;   /* ends of lines */
    double reach;    /* a loose end, and what it should meet */
} region_near;

/* The lines between regions, and those of them that the drawing has. */
typedef struct region_lines {
    planar_map map;
    roberts_segment *segment; /* [count] of the drawing */
    size_t count, room;
    region_near near;
    const seen *seen; /* what they are lines of */
} region_lines;

/* A roberts_segment_fn: takes a visible segment. context: region_lines. False: no memory. */
bool region_lines_take(void *context, const roberts_segment *s);

region_near regions_near(const hide_fronts *fronts);

/* Finds the visible regions. lines: all lines between them, but for bare faces. False: no memory. */
bool regions_find(const hide_job *job, region_lines *lines);

#endif
