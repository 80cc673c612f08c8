/* vertex_tree.h - boxes round boxes round points: which point lies farthest out of a plane. */
#ifndef ROBERTS_MODEL_VERTEX_TREE_H
#define ROBERTS_MODEL_VERTEX_TREE_H

#include "base/vec.h"

typedef struct vertex_box {
    roberts_vec3 lo, hi;
} vertex_box;

typedef struct vertex_tree {
    const roberts_vec3 *point;
    uint32_t count, leaves; /* leaves: a power of two */
    uint32_t *order;        /* [count] points along a space-filling curve */
    vertex_box *box;        /* [2 * leaves] a heap: box i holds boxes 2 i and 2 i + 1; the last `leaves` hold points */
} vertex_tree;

/* `point` stays the caller's and must outlive the tree. False: no memory. */
bool vertex_tree_build(vertex_tree *tree, const roberts_vec3 *point, uint32_t count);

/* The point with the least F, if that is below `bound`; else ROBERTS_NONE. */
uint32_t vertex_tree_outermost(const vertex_tree *tree, plane F, double bound);

void vertex_tree_free(vertex_tree *tree);

#endif
