/* point_grid.c - a grid of cells that finds the points near a segment. It follows the segment slab by slab, along the
 * axis of its greatest extent. */
#include "model/point_grid.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/box.h"

static double part(roberts_vec3 p, int axis)
{
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

static uint32_t cell_along(const point_grid *grid, double x, int axis)
{
    double i = (x - part(grid->low, axis)) / grid->size;
    return !(i > 0.0) ? 0 : i >= grid->count[axis] ? grid->count[axis] - 1 : (uint32_t)i;
}

static size_t cell_of(const point_grid *grid, uint32_t i, uint32_t j, uint32_t k)
{
    return ((size_t)i * grid->count[1] + j) * grid->count[2] + k;
}

uint32_t point_grid_cell(const point_grid *grid, roberts_vec3 P)
{
    return (uint32_t)cell_of(grid, cell_along(grid, P.x, 0), cell_along(grid, P.y, 1), cell_along(grid, P.z, 2));
}

/* Chooses the cell size so that there are about as many cells as points. */
static void choose_cells(point_grid *grid, roberts_vec3 size, size_t count)
{
    double extent[3] = {size.x, size.y, size.z}, most = greater(size.x, greater(size.y, size.z)), cells = 0.0;
    grid->size = most > 0.0 ? most : 1.0;
    for (int tries = 0; tries < 200; tries++) {
        cells = 1.0;
        for (int a = 0; a < 3; a++)
            cells *= floor(extent[a] / grid->size) + 1.0;
        if (cells > (double)count || !(most > 0.0))
            break;
        grid->size *= 0.8;
    }
    for (int a = 0; a < 3; a++)
        grid->count[a] = (uint32_t)floor(extent[a] / grid->size) + 1;
}

bool point_grid_build(point_grid *grid, const roberts_vec3 *point, const uint32_t *listed, size_t count)
{
    roberts_vec3 low = {INFINITY, INFINITY, INFINITY}, high = {-INFINITY, -INFINITY, -INFINITY};
    *grid = (point_grid){.point = point};
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
        cell[i] = point_grid_cell(grid, point[listed[i]]);
        grid->start[cell[i] + 1]++;
    }
    for (size_t c = 0; enough && c < cells; c++)
        grid->start[c + 1] += grid->start[c];
    for (size_t i = count; enough && i-- > 0;) /* backward, so that each cell's points ascend */
        grid->item[--grid->start[cell[i] + 1]] = listed[i];
    for (size_t c = 0; enough && c < cells; c++)
        grid->start[c] = grid->start[c + 1];
    if (enough)
        grid->start[cells] = (uint32_t)count;
    free(cell);
    return enough;
}

static bool take_cell(const point_grid *grid, size_t cell, point_list *found)
{
    size_t own = grid->start[cell + 1] - grid->start[cell];
    if (!array_reserve(&found->item, &found->room, found->count + own, sizeof *found->item))
        return false;
    for (uint32_t i = grid->start[cell]; i < grid->start[cell + 1]; i++)
        found->item[found->count++] = grid->item[i];
    return true;
}

bool point_grid_near(const point_grid *grid, roberts_vec3 A, roberts_vec3 B, double margin, point_list *found)
{
    roberts_vec3 d = vec3_sub(B, A);
    double x = fabs(d.x), y = fabs(d.y), z = fabs(d.z);
    int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    uint32_t first[3], last[3];
    uint32_t from = cell_along(grid, lesser(part(A, axis), part(B, axis)) - margin, axis);
    uint32_t end = cell_along(grid, greater(part(A, axis), part(B, axis)) + margin, axis);
    for (uint32_t slab = from; slab <= end; slab++) {
        double t0 = 0.0, t1 = 1.0, low = part(grid->low, axis) + slab * grid->size, high = low + grid->size;
        if (slab > from || slab < end) /* the outer cells also hold what is beyond them */
            box_clip(part(A, axis), part(B, axis), (slab > from ? low : -INFINITY) - 2.0 * margin - 1e-9 * grid->size,
                     (slab < end ? high : INFINITY) + 2.0 * margin + 1e-9 * grid->size, &t0, &t1);
        for (int a = 0; a < 3; a++) {
            double p = part(A, a) + t0 * part(d, a), q = part(A, a) + t1 * part(d, a),
                   slack = 2.0 * margin + 1e-9 * grid->size;
            first[a] = a == axis ? slab : cell_along(grid, lesser(p, q) - slack, a);
            last[a] = a == axis ? slab : cell_along(grid, greater(p, q) + slack, a);
        }
        for (uint32_t i = first[0]; i <= last[0]; i++)
            for (uint32_t j = first[1]; j <= last[1]; j++)
                for (uint32_t k = first[2]; k <= last[2]; k++)
                    if (!take_cell(grid, cell_of(grid, i, j, k), found))
                        return false;
    }
    return true;
}

void point_grid_free(point_grid *grid)
{
    free(grid->start);
    free(grid->item);
}
