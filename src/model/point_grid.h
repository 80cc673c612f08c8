/* point_grid.h - a grid of cells that finds the points near a segment. */
#ifndef ROBERTS_MODEL_POINT_GRID_H
#define ROBERTS_MODEL_POINT_GRID_H

#include "base/vec.h"

typedef struct point_grid {
    const roberts_vec3 *point;
    roberts_vec3 low;
    double size;       /* edge length of a cell */
    uint32_t count[3]; /* number of cells along each axis */
    uint32_t *start;   /* [cells + 1] into item */
    uint32_t *item;    /* point numbers */
} point_grid;

/* Builds the grid of the listed points. `point` belongs to the caller. False: no memory; point_grid_free() is still
 * needed. */
bool point_grid_build(point_grid *grid, const roberts_vec3 *point, const uint32_t *listed, size_t count);

/* The number of the cell that holds P. */
uint32_t point_grid_cell(const point_grid *grid, roberts_vec3 P);

/* The points found by a query. */
typedef struct point_list {
    uint32_t *item; /* [count] */
    size_t count, room;
} point_list;

/* Appends all points within `margin` of AB, each once, and perhaps others nearby. False: no memory. */
bool point_grid_near(const point_grid *grid, roberts_vec3 A, roberts_vec3 B, double margin, point_list *found);

void point_grid_free(point_grid *grid);

#endif
