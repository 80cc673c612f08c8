/* point_grid.c - a grid of cells that finds the points near a segment. The segment is divided into short parts, and the
 * cells round each part are searched row by row. The cells of a row follow one another along z, and so do their
 * points. */
#include "model/point_grid.h"

#include <float.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/box.h"

/* A bound for where a point lies beside a segment, in roundings of a coordinate to float. */
#define FLOAT_ROUNDINGS 32.0
/* The greatest length of a part along the axis of the segment's greatest extent, in cells. */
#define PART_CELLS 2.0
/* Points in a cell, if they are spread evenly. With fewer, a segment meets more rows; with more, more points. */
#define POINTS_PER_CELL 6.0

static roberts_vec3 in_cells(const point_grid *grid, roberts_vec3 P)
{
    return vec3_scale(grid->per, vec3_sub(P, grid->low));
}

/* Returns the cell that holds a coordinate, given in cells. */
static uint32_t cell_along(const point_grid *grid, double x, int axis)
{
    return !(x > 0.0) ? 0 : x >= grid->count[axis] ? grid->count[axis] - 1 : (uint32_t)x;
}

static size_t grid_row(const point_grid *grid, uint32_t i, uint32_t j)
{
    return ((size_t)i * grid->count[1] + j) * grid->count[2];
}

/* Chooses the cell size by the number of points. */
static void choose_cells(point_grid *grid, roberts_vec3 size, size_t count)
{
    double extent[3] = {size.x, size.y, size.z}, most = greater(size.x, greater(size.y, size.z)), cells = 0.0;
    double side = most > 0.0 ? most : 1.0;
    for (int tries = 0; tries < 200; tries++) {
        cells = 1.0;
        for (int a = 0; a < 3; a++)
            cells *= floor(extent[a] / side) + 1.0;
        if (cells > (double)count / POINTS_PER_CELL || !(most > 0.0))
            break;
        side *= 0.8;
    }
    grid->per = 1.0 / side;
    for (int a = 0; a < 3; a++) {
        grid->count[a] = (uint32_t)floor(extent[a] / side) + 1;
        grid->rounding = greater(grid->rounding, FLOAT_ROUNDINGS * 0.5 * (double)FLT_EPSILON * grid->count[a]);
    }
}

bool point_grid_build(point_grid *grid, const roberts_vec3 *point, const uint32_t *listed, size_t count)
{
    roberts_vec3 low = {INFINITY, INFINITY, INFINITY}, high = {-INFINITY, -INFINITY, -INFINITY};
    *grid = (point_grid){.per = 1.0};
    for (size_t i = 0; i < count; i++)
        box_add(&low, &high, point[listed[i]]);
    grid->low = low;
    choose_cells(grid, vec3_sub(high, low), count);
    size_t cells = (size_t)grid->count[0] * grid->count[1] * grid->count[2];
    grid->start = alloc_zeroed(cells + 1, sizeof *grid->start);
    grid->item = alloc_array(count, sizeof *grid->item);
    uint32_t *cell = alloc_array(count, sizeof *cell);
    bool enough = grid->start && grid->item && cell;
    for (size_t i = 0; enough && i < count; i++) {
        roberts_vec3 P = in_cells(grid, point[listed[i]]);
        cell[i] =
            (uint32_t)(grid_row(grid, cell_along(grid, P.x, 0), cell_along(grid, P.y, 1)) + cell_along(grid, P.z, 2));
        grid->start[cell[i] + 1]++;
    }
    for (size_t c = 0; enough && c < cells; c++)
        grid->start[c + 1] += grid->start[c];
    for (size_t i = count; enough && i-- > 0;) { /* backward, so that each cell's points ascend */
        roberts_vec3 P = in_cells(grid, point[listed[i]]);
        grid->item[--grid->start[cell[i] + 1]] = (grid_point){{(float)P.x, (float)P.y, (float)P.z}, listed[i]};
    }
    for (size_t c = 0; enough && c < cells; c++)
        grid->start[c] = grid->start[c + 1];
    if (enough)
        grid->start[cells] = (uint32_t)count;
    free(cell);
    return enough;
}

/* A segment among the cells, in floats. The coordinates aside[0] and aside[1] of a point on its line are from[k] +
 * slope[k] * (the third one). */
typedef struct grid_line {
    int axis, aside[2]; /* axis: of the segment's greatest extent */
    float from[2], slope[2];
    float margin; /* a point farther beside the line, along `aside`, is too far from it */
} grid_line;

static grid_line line_of(const double a[3], const double b[3], double margin)
{
    double x = fabs(b[0] - a[0]), y = fabs(b[1] - a[1]), z = fabs(b[2] - a[2]);
    int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    grid_line l = {.axis = axis, .aside = {axis == 0 ? 1 : 0, axis == 2 ? 1 : 2}, .margin = (float)margin};
    double per = b[axis] != a[axis] ? 1.0 / (b[axis] - a[axis]) : 0.0;
    for (int k = 0; k < 2; k++) {
        double slope = (b[l.aside[k]] - a[l.aside[k]]) * per;
        l.slope[k] = (float)slope;
        l.from[k] = (float)(a[l.aside[k]] - slope * a[axis]);
    }
    return l;
}

static inline bool is_near(const grid_line *l, const grid_point *p)
{
    float t = p->at[l->axis];
    return fabsf(p->at[l->aside[0]] - (l->from[0] + l->slope[0] * t)) <= l->margin &&
           fabsf(p->at[l->aside[1]] - (l->from[1] + l->slope[1] * t)) <= l->margin;
}

/* Appends the points near the line in the cells first..last. from, to: they are those of one part of the segment if
 * they lie there along its axis, `to` excluded. */
static bool take_cells(const point_grid *grid, const grid_line *l, const uint32_t first[3], const uint32_t last[3],
                       const float part[2], point_list *found)
{
    for (uint32_t i = first[0]; i <= last[0]; i++)
        for (uint32_t j = first[1]; j <= last[1]; j++) {
            const uint32_t *start = grid->start + grid_row(grid, i, j);
            const grid_point *end = grid->item + start[last[2] + 1];
            for (const grid_point *p = grid->item + start[first[2]]; p < end; p++) {
                if (!is_near(l, p) || !(p->at[l->axis] >= part[0] && p->at[l->axis] < part[1]))
                    continue;
                if (!array_reserve(&found->item, &found->room, found->count + 1, sizeof *found->item))
                    return false;
                found->item[found->count++] = p->number;
            }
        }
    return true;
}

bool point_grid_near(const point_grid *grid, roberts_vec3 A, roberts_vec3 B, double margin, point_list *found)
{
    const roberts_vec3 P = in_cells(grid, A), Q = in_cells(grid, B);
    const double a[3] = {P.x, P.y, P.z}, b[3] = {Q.x, Q.y, Q.z};
    double most = 2.0 * margin * grid->per + grid->rounding;
    const grid_line l = line_of(a, b, most);
    const uint32_t more = (uint32_t)(fabs(b[l.axis] - a[l.axis]) / PART_CELLS); /* both are points of the grid */
    double t0 = 0.0;
    bool back = b[l.axis] < a[l.axis];
    for (uint32_t k = 0; k <= more; k++) {
        double t1 = k < more ? (k + 1.0) / (more + 1.0) : 1.0;
        double low = a[l.axis] + t0 * (b[l.axis] - a[l.axis]), high = a[l.axis] + t1 * (b[l.axis] - a[l.axis]);
        uint32_t first[3], last[3];
        float part[2] = {-INFINITY, INFINITY};
        if (k > 0)
            part[back] = (float)low;
        if (t1 < 1.0)
            part[!back] = (float)high;
        for (int i = 0; i < 3; i++) {
            double p = a[i] + t0 * (b[i] - a[i]), q = a[i] + t1 * (b[i] - a[i]);
            first[i] = cell_along(grid, lesser(p, q) - most, i);
            last[i] = cell_along(grid, greater(p, q) + most, i);
        }
        if (!take_cells(grid, &l, first, last, part, found))
            return false;
        t0 = t1;
    }
    return true;
}

void point_grid_free(point_grid *grid)
{
    free(grid->start);
    free(grid->item);
}
