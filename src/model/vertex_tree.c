/* vertex_tree.c - boxes round boxes round points, for the question which point lies farthest out of a plane.
 *
 * Idea: the points are sorted along the Z-order curve and cut into leaves of eight; a complete binary tree of boxes
 * stands over the leaves. A box whose nearest possible F is no better than the best so far is passed over.
 * Source: G. M. Morton, "A computer oriented geodetic data base and a new technique in file sequencing", IBM 1966. */
#include "model/vertex_tree.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/box.h"
#include "base/sort.h"

enum { LEAF = 8 }; /* points */

/* Spreads ten bits so that two free bits follow each. */
static uint32_t spread(uint32_t x)
{
    x = (x | x << 16) & 0x030000ff;
    x = (x | x << 8) & 0x0300f00f;
    x = (x | x << 4) & 0x030c30c3;
    return (x | x << 2) & 0x09249249;
}

static uint32_t cell(double x, double lo, double hi)
{
    return hi > lo ? (uint32_t)fmin(1023.0, (x - lo) / (hi - lo) * 1024.0) : 0;
}

/* Fills tree->order along the curve. */
static bool sort_points(vertex_tree *tree)
{
    roberts_vec3 lo = tree->point[0], hi = lo;
    uint64_t *key = alloc_array(tree->count, sizeof *key);
    if (!key)
        return false;
    box_add_all(&lo, &hi, tree->point, tree->count);
    for (uint32_t v = 0; v < tree->count; v++) {
        roberts_vec3 p = tree->point[v];
        uint32_t code =
            spread(cell(p.x, lo.x, hi.x)) | spread(cell(p.y, lo.y, hi.y)) << 1 | spread(cell(p.z, lo.z, hi.z)) << 2;
        key[v] = (uint64_t)code << 32 | v;
    }
    qsort(key, tree->count, sizeof *key, compare_u64);
    for (uint32_t v = 0; v < tree->count; v++)
        tree->order[v] = (uint32_t)key[v];
    free(key);
    return true;
}

bool vertex_tree_build(vertex_tree *tree, const roberts_vec3 *point, uint32_t count)
{
    const vertex_box empty = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    *tree = (vertex_tree){.point = point, .count = count, .leaves = 1};
    while ((uint64_t)tree->leaves * LEAF < count)
        tree->leaves *= 2;
    tree->order = alloc_array(count, sizeof *tree->order);
    tree->box = alloc_array(2 * (size_t)tree->leaves, sizeof *tree->box);
    if (!tree->order || !tree->box || !sort_points(tree)) {
        vertex_tree_free(tree);
        return false;
    }
    for (uint32_t i = 0; i < 2 * tree->leaves; i++)
        tree->box[i] = empty;
    for (uint32_t i = 0; i < count; i++) {
        vertex_box *box = &tree->box[tree->leaves + i / LEAF];
        box_add(&box->lo, &box->hi, point[tree->order[i]]);
    }
    for (uint32_t i = tree->leaves - 1; i > 0; i--)
        for (uint32_t child = 2 * i; child <= 2 * i + 1; child++)
            if (tree->box[child].lo.x <= tree->box[child].hi.x) {
                box_add(&tree->box[i].lo, &tree->box[i].hi, tree->box[child].lo);
                box_add(&tree->box[i].lo, &tree->box[i].hi, tree->box[child].hi);
            }
    return true;
}

/* The least F in a box; INFINITY in an empty one. */
static double least_in_box(const vertex_box *box, plane F)
{
    roberts_vec3 corner = {F.a > 0.0 ? box->lo.x : box->hi.x, F.b > 0.0 ? box->lo.y : box->hi.y,
                           F.c > 0.0 ? box->lo.z : box->hi.z};
    return box->lo.x <= box->hi.x ? plane_at(F, corner) : INFINITY;
}

uint32_t vertex_tree_outermost(const vertex_tree *tree, plane F, double bound)
{
    uint32_t stack[34], depth = 0, found = ROBERTS_NONE; /* at most one box a level waits */
    stack[depth++] = 1;
    while (depth > 0) {
        uint32_t i = stack[--depth];
        if (!(least_in_box(&tree->box[i], F) < bound))
            continue;
        if (i < tree->leaves) {
            bool left = least_in_box(&tree->box[2 * i], F) < least_in_box(&tree->box[2 * i + 1], F);
            stack[depth++] = 2 * i + left; /* the better one goes first */
            stack[depth++] = 2 * i + !left;
            continue;
        }
        for (uint32_t k = (i - tree->leaves) * LEAF; k < tree->count && k / LEAF == i - tree->leaves; k++) {
            double value = plane_at(F, tree->point[tree->order[k]]);
            if (value < bound) {
                bound = value;
                found = tree->order[k];
            }
        }
    }
    return found;
}

void vertex_tree_free(vertex_tree *tree)
{
    free(tree->order);
    free(tree->box);
    *tree = (vertex_tree){0};
}
