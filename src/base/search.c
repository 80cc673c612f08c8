/* search.c - what is near what: boxes in a tree, points in a grid, lines on a sweep line. See search.h. */
#include "base/search.h"

#include <float.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/bits.h"
#include "base/box.h"

/* ---- a tree of boxes --------------------------------------------------------------------------------------------- */

/* Boxes are split at the median of their centres along the longest extent, until at most four are left. */

enum { LEAF = 4 };

static double box_middle(const box3 *box, int axis)
{
    return axis == 0 ? box->lo.x + box->hi.x : axis == 1 ? box->lo.y + box->hi.y : box->lo.z + box->hi.z;
}

int box_longest_axis(const box3 *box, const uint32_t *item, uint32_t count)
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (uint32_t i = 0; i < count; i++)
        for (int k = 0; k < 3; k++) {
            low[k] = lesser(low[k], box_middle(&box[item[i]], k));
            high[k] = greater(high[k], box_middle(&box[item[i]], k));
        }
    int axis = high[1] - low[1] > high[0] - low[0];
    return high[2] - low[2] > high[axis] - low[axis] ? 2 : axis;
}

/* C. A. R. Hoare, "Algorithm 65: Find", CACM 4(7), 1961. Ties are broken by number, so the order of equal boxes is the
 * same in every run. */
void box_tree_halve(const box3 *box, uint32_t *item, uint32_t count, uint32_t half)
{
    const int axis = box_longest_axis(box, item, count);
    uint32_t from = 0, to = count > 0 ? count - 1 : 0;
    while (from < to) {
        uint32_t pivot = item[from + (to - from) / 2], i = from, j = to;
        double at = box_middle(&box[pivot], axis);
        for (;;) {
            while (box_middle(&box[item[i]], axis) < at || (box_middle(&box[item[i]], axis) == at && item[i] < pivot))
                i++;
            while (box_middle(&box[item[j]], axis) > at || (box_middle(&box[item[j]], axis) == at && item[j] > pivot))
                j--;
            if (i >= j)
                break;
            uint32_t swapped = item[i];
            item[i++] = item[j];
            item[j--] = swapped;
        }
        if (half <= j)
            to = j;
        else
            from = j + 1;
    }
}

/* Builds the subtree over the items from `first` on. Numbers in `item` start at 0 until the tree is complete. False: no
 * memory. */
static bool build_box_node(box_tree *tree, const box3 *box, uint32_t first, uint32_t count)
{
    if (!array_reserve(&tree->node, &tree->node_room, tree->node_count + 1, sizeof *tree->node))
        return false;
    size_t at = tree->node_count++;
    uint32_t *item = tree->item + first;
    box3 all = box[item[0]];
    for (uint32_t i = 1; i < count; i++) {
        box3_add(&all, box[item[i]].lo);
        box3_add(&all, box[item[i]].hi);
    }
    bool leaf = count <= LEAF;
    tree->node[at] = (box_tree_node){.box = all, .first = first, .count = leaf ? count : 0};
    if (!leaf) {
        box_tree_halve(box, item, count, count / 2);
        if (!build_box_node(tree, box, first, count / 2) ||
            !build_box_node(tree, box, first + count / 2, count - count / 2))
            return false;
    }
    tree->node[at].skip = (uint32_t)tree->node_count;
    return true;
}

bool box_tree_add(box_tree *tree, const box3 *box, uint32_t count, uint32_t base, uint32_t *root)
{
    size_t first = tree->item_count;
    if (!array_reserve(&tree->item, &tree->item_room, first + count, sizeof *tree->item))
        return false;
    for (uint32_t i = 0; i < count; i++)
        tree->item[first + i] = i;
    tree->item_count += count;
    *root = (uint32_t)tree->node_count;
    if (!build_box_node(tree, box, (uint32_t)first, count))
        return false;
    for (uint32_t i = 0; i < count; i++)
        tree->item[first + i] += base;
    return true;
}

void box_tree_free(box_tree *tree)
{
    free(tree->node);
    free(tree->item);
    *tree = (box_tree){0};
}

/* ---- a grid of points -------------------------------------------------------------------------------------------- */

/* The segment is divided into short parts, and the cells round each part are searched row by row. The cells of a row
 * follow one another along z, and so do their points. */

/* A bound for where a point lies beside a segment or a plane, in roundings of a coordinate to float. */
#define FLOAT_ROUNDINGS 32.0
/* The greatest length of a part along the axis of the segment's greatest extent, in cells. */
#define PART_CELLS 2.0
/* For a triangle in more cells, its sides are asked for. */
#define TRIANGLE_CELLS 64
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

static size_t cell_of(const point_grid *grid, roberts_vec3 P)
{
    return grid_row(grid, cell_along(grid, P.x, 0), cell_along(grid, P.y, 1)) + cell_along(grid, P.z, 2);
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
    bool enough = grid->start && grid->item;
    for (size_t i = 0; enough && i < count; i++)
        grid->start[cell_of(grid, in_cells(grid, point[listed[i]])) + 1]++;
    for (size_t c = 0; enough && c < cells; c++)
        grid->start[c + 1] += grid->start[c];
    for (size_t i = count; enough && i-- > 0;) { /* backward, so that each cell's points ascend */
        roberts_vec3 P = in_cells(grid, point[listed[i]]);
        grid->item[--grid->start[cell_of(grid, P) + 1]] = (grid_point){{(float)P.x, (float)P.y, (float)P.z}, listed[i]};
    }
    for (size_t c = 0; enough && c < cells; c++)
        grid->start[c] = grid->start[c + 1];
    if (enough)
        grid->start[cells] = (uint32_t)count;
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

/* A part of a line: from along[0] to along[1] on its axis, without the end. */
typedef struct line_part {
    const grid_line *line;
    float along[2];
} line_part;

BITS_INLINE bool is_near_line(const void *of, const grid_point *p)
{
    const line_part *part = of;
    const grid_line *l = part->line;
    float t = p->at[l->axis];
    return t >= part->along[0] && t < part->along[1] &&
           fabsf(p->at[l->aside[0]] - (l->from[0] + l->slope[0] * t)) <= l->margin &&
           fabsf(p->at[l->aside[1]] - (l->from[1] + l->slope[1] * t)) <= l->margin;
}

/* What a search asks of a point. */
typedef bool grid_test(const void *of, const grid_point *p);

/* Appends the points in the cells first..last that pass a test. */
BITS_INLINE bool take_cells(const point_grid *grid, grid_test *test, const void *of, const uint32_t first[3],
                            const uint32_t last[3], point_list *found)
{
    for (uint32_t i = first[0]; i <= last[0]; i++)
        for (uint32_t j = first[1]; j <= last[1]; j++) {
            const uint32_t *start = grid->start + grid_row(grid, i, j);
            const grid_point *end = grid->item + start[last[2] + 1];
            for (const grid_point *p = grid->item + start[first[2]]; p < end; p++) {
                if (!test(of, p))
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
        line_part part = {&l, {-INFINITY, INFINITY}};
        if (k > 0)
            part.along[back] = (float)low;
        if (t1 < 1.0)
            part.along[!back] = (float)high;
        for (int i = 0; i < 3; i++) {
            double p = a[i] + t0 * (b[i] - a[i]), q = a[i] + t1 * (b[i] - a[i]);
            first[i] = cell_along(grid, lesser(p, q) - most, i);
            last[i] = cell_along(grid, greater(p, q) + most, i);
        }
        if (!take_cells(grid, is_near_line, &part, first, last, found))
            return false;
        t0 = t1;
    }
    return true;
}

/* A plane among the cells, in floats: the points at d along n, whose length is 1 or 0. */
typedef struct grid_plane {
    float n[3], d;
    float margin; /* a point farther from the plane is too far from the triangle */
} grid_plane;

/* The plane through P. However n is rounded, no point of the triangle is farther from it than Q or R. */
static grid_plane plane_of(roberts_vec3 P, roberts_vec3 Q, roberts_vec3 R, double margin)
{
    const roberts_vec3 PQ = vec3_sub(Q, P), PR = vec3_sub(R, P), cross = vec3_cross(PQ, PR);
    const double length = vec3_length(cross);
    const roberts_vec3 n = length > 0.0 ? vec3_scale(1.0 / length, cross) : (roberts_vec3){0.0, 0.0, 0.0};
    margin += greater(fabs(vec3_dot(n, PQ)), fabs(vec3_dot(n, PR)));
    return (grid_plane){{(float)n.x, (float)n.y, (float)n.z}, (float)vec3_dot(n, P), (float)margin};
}

BITS_INLINE bool is_near_plane(const void *of, const grid_point *p)
{
    const grid_plane *F = of;
    return !(fabsf(F->n[0] * p->at[0] + F->n[1] * p->at[1] + F->n[2] * p->at[2] - F->d) > F->margin);
}

bool point_grid_near_triangle(const point_grid *grid, roberts_vec3 A, roberts_vec3 B, roberts_vec3 C, double margin,
                              point_list *found)
{
    const roberts_vec3 P = in_cells(grid, A), Q = in_cells(grid, B), R = in_cells(grid, C);
    const double p[3] = {P.x, P.y, P.z}, q[3] = {Q.x, Q.y, Q.z}, r[3] = {R.x, R.y, R.z};
    const double most = 2.0 * margin * grid->per + grid->rounding;
    uint32_t first[3], last[3];
    uint64_t cells = 1;
    for (int i = 0; i < 3; i++) {
        first[i] = cell_along(grid, lesser(p[i], lesser(q[i], r[i])) - most, i);
        last[i] = cell_along(grid, greater(p[i], greater(q[i], r[i])) + most, i);
        cells *= last[i] - first[i] + 1;
        if (cells > TRIANGLE_CELLS)
            return point_grid_near(grid, A, B, margin, found) && point_grid_near(grid, B, C, margin, found) &&
                   point_grid_near(grid, C, A, margin, found);
    }
    const grid_plane F = plane_of(P, Q, R, most);
    return take_cells(grid, is_near_plane, &F, first, last, found);
}

void point_grid_free(point_grid *grid)
{
    free(grid->start);
    free(grid->item);
}

/* ---- the lines on a sweep line, in order ------------------------------------------------------------------------- */

bool sweep_order_start(sweep_order *order, size_t count)
{
    order->root = ROBERTS_NONE;
    order->place = alloc_array(count, sizeof *order->place);
    return order->place != NULL;
}

static uint32_t priority_of(uint32_t line)
{
    uint32_t h = (line + 1) * 0x9e3779b1u;
    h = (h ^ h >> 15) * 0x85ebca77u;
    return h ^ h >> 13;
}

/* Makes `line` take the place of `old` as a child or the root. */
static void replace_child(sweep_order *order, uint32_t old, uint32_t line)
{
    uint32_t parent = order->place[old].parent;
    if (parent == ROBERTS_NONE)
        order->root = line;
    else
        order->place[parent].child[order->place[parent].child[1] == old] = line;
    if (line != ROBERTS_NONE)
        order->place[line].parent = parent;
}

/* Rotates a line above its parent in the tree. */
static void rotate_up(sweep_order *order, uint32_t line)
{
    sweep_place *place = order->place;
    uint32_t parent = place[line].parent;
    int side = place[parent].child[1] == line;
    uint32_t inner = place[line].child[1 - side];
    replace_child(order, parent, line);
    place[parent].child[side] = inner;
    if (inner != ROBERTS_NONE)
        place[inner].parent = parent;
    place[line].child[1 - side] = parent;
    place[parent].parent = line;
}

uint32_t sweep_order_above(const sweep_order *order, uint32_t below)
{
    uint32_t line = order->root;
    if (below != ROBERTS_NONE)
        return order->place[below].near[1];
    while (line != ROBERTS_NONE && order->place[line].child[0] != ROBERTS_NONE)
        line = order->place[line].child[0];
    return line;
}

void sweep_order_insert(sweep_order *order, uint32_t line, uint32_t below)
{
    sweep_place *place = order->place, *own = &place[line];
    *own = (sweep_place){ROBERTS_NONE, {ROBERTS_NONE, ROBERTS_NONE}, {ROBERTS_NONE, ROBERTS_NONE}, priority_of(line)};
    if (order->root == ROBERTS_NONE) {
        order->root = line;
        return;
    }
    uint32_t above = sweep_order_above(order, below);
    own->near[0] = below;
    own->near[1] = above;
    if (below != ROBERTS_NONE)
        place[below].near[1] = line;
    if (above != ROBERTS_NONE)
        place[above].near[0] = line;
    /* of two neighbours in the list, one has no child on the side of the other */
    bool under = below == ROBERTS_NONE || place[below].child[1] != ROBERTS_NONE;
    own->parent = under ? above : below;
    place[own->parent].child[!under] = line;
    while (own->parent != ROBERTS_NONE && place[own->parent].priority < own->priority)
        rotate_up(order, line);
}

void sweep_order_remove(sweep_order *order, uint32_t line)
{
    sweep_place *place = order->place, *own = &place[line];
    while (own->child[0] != ROBERTS_NONE && own->child[1] != ROBERTS_NONE)
        rotate_up(order, own->child[place[own->child[1]].priority > place[own->child[0]].priority]);
    replace_child(order, line, own->child[own->child[0] == ROBERTS_NONE]);
    for (int k = 0; k < 2; k++)
        if (own->near[k] != ROBERTS_NONE)
            place[own->near[k]].near[1 - k] = own->near[1 - k];
}

void sweep_order_free(sweep_order *order)
{
    free(order->place);
    *order = (sweep_order){.root = ROBERTS_NONE};
}
