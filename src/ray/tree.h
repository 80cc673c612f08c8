/* tree.h - a tree of boxes over boxes, to find those that lie over a point without asking them all.
 *
 * Boxes live in a picture: x and y across the sight lines, z toward the viewer, so that every sight line runs along +z
 * and a box is met where it lies over (x, y) and reaches higher than z.
 *
 * Idea: a bounding volume hierarchy. Each node is split at the best of a few planes across each axis (Wald, "On fast
 * construction of SAH-based bounding volume hierarchies", 2007). In place of the surface stands what is in proportion
 * here to the chance of being met: the volume of the shadow that the box throws away from the viewer.
 * Invariants: a node's box holds the boxes of all items below it; node 0 is the root, the first child of an inner node
 * follows it directly; depth is at most TREE_DEPTH. The tree is a function of the boxes alone. */
#ifndef ROBERTS_RAY_TREE_H
#define ROBERTS_RAY_TREE_H

#include "base/vec.h"

enum { TREE_DEPTH = 96 };

typedef struct tree_box {
    roberts_vec3 lo, hi;
} tree_box;

/* Volume of a box's shadow down to z = `floor`; 0 for an empty one. */
double tree_box_shadow(tree_box a, double floor);

/* Half a cache line: single precision, rounded outward; how deep a box reaches does not matter. */
typedef struct tree_node {
    float lo_x, lo_y, hi_x, hi_y, hi_z;
    uint32_t first; /* leaf: its first item; inner node: its second child */
    uint32_t count; /* leaf: its items; inner node: 0 */
    uint32_t owner; /* of all items below, or ROBERTS_NONE where they have several */
} tree_node;

typedef struct tree {
    tree_node *node;
    uint32_t *item; /* the items of leaf after leaf */
    uint32_t node_count;
} tree;

/* Builds `t` over `count` boxes, each with an owner; items are their numbers. False: no memory, and `t` is empty. */
bool tree_build(tree *t, const tree_box *box, const uint32_t *owner, uint32_t count);
void tree_free(tree *t);

/* A walk through the leaves over a point, without those that are all `skip`'s. */
typedef struct tree_walk {
    const tree *t;
    roberts_vec3 point;
    uint32_t skip; /* an owner, or ROBERTS_NONE */
    uint32_t depth;
    uint32_t stack[TREE_DEPTH + 1];
} tree_walk;

void tree_walk_start(tree_walk *w, const tree *t, roberts_vec3 point, uint32_t skip);

/* The items of the next leaf whose box is met; their number is returned, 0 at the end. A box that is only just missed
 * may be taken for met. */
uint32_t tree_walk_next(tree_walk *w, const uint32_t **item);

#endif
