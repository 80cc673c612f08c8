/* point_grid.h - a grid of cells that finds the points near a segment. */
#ifndef ROBERTS_MODEL_POINT_GRID_H
#define ROBERTS_MODEL_POINT_GRID_H

#include "base/vec.h"

/* A point as stored in the grid: this alone excludes most points of a cell. */
typedef struct grid_point {
    float at[3]; /* rounded, in cells from the grid's lowest corner */
    uint32_t number;
} grid_point;

typedef struct point_grid {
    roberts_vec3 low;
    double per;        /* cells in a unit of length */
    double rounding;   /* bound of the error of grid_point.at, and of what is computed from it */
    uint32_t count[3]; /* number of cells along each axis */
    uint32_t *start;   /* [cells + 1] into item */
    grid_point *item;  /* cell by cell */
} point_grid;

/* Builds the grid of the listed points. False: no memory; point_grid_free() is still needed. */
bool point_grid_build(point_grid *grid, const roberts_vec3 *point, const uint32_t *listed, size_t count);

/* The points found by a query. */
typedef struct point_list {
    uint32_t *item; /* [count] */
    size_t count, room;
} point_list;

/* Appends all points within `margin` of AB, each once, and perhaps others nearby. False: no memory. */
bool point_grid_near(const point_grid *grid, roberts_vec3 A, roberts_vec3 B, double margin, point_list *found);

void point_grid_free(point_grid *grid);

#endif
