/* point_grid.h - a grid of cells that finds the points near a segment. */
#ifndef ROBERTS_MODEL_POINT_GRID_H
#define ROBERTS_MODEL_POINT_GRID_H

#include "base/vec.h"

typedef struct point_grid {
    const roberts_vec3 *point;
    roberts_vec3 low;
    double size;       /* of a cell, along each axis */
    uint32_t count[3]; /* of cells along each */
    uint32_t *start;   /* [cells + 1] into item */
    uint32_t *item;    /* point numbers */
} point_grid;

/* Builds the grid of the listed points. `point` belongs to the caller. False: no memory; point_grid_free() is still
 * needed. */
bool point_grid_build(point_grid *grid, const roberts_vec3 *point, const uint32_t *listed, size_t count);

/* Points that were found. */
typedef struct point_list {
    uint32_t *item; /* [count] */
    size_t count, room;
} point_list;

/* Appends all points within `margin` of AB, and perhaps others near it, each once. False: no memory. */
bool point_grid_near(const point_grid *grid, roberts_vec3 A, roberts_vec3 B, double margin, point_list *found);

void point_grid_free(point_grid *grid);

#endif
