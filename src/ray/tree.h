/* tree.h - a tree of boxes over boxes, to find those that a ray meets without asking them all.
 *
 * Idea: a bounding volume hierarchy. Each node is split by the surface area heuristic, tried at a few planes across its
 * longest side (Wald, "On fast construction of SAH-based bounding volume hierarchies", 2007).
 * Invariants: a node's box holds the boxes of all items below it; node 0 is the root, the first child of an inner node
 * follows it directly; depth is at most TREE_DEPTH. The tree is a function of the boxes alone. */
#ifndef ROBERTS_RAY_TREE_H
#define ROBERTS_RAY_TREE_H

#include "base/vec.h"

enum { TREE_DEPTH = 96 };

typedef struct tree_box {
    roberts_vec3 lo, hi;
} tree_box;

/* Half the surface: in proportion to the chance that a ray meets the box. 0 for an empty one. */
double tree_box_area(tree_box a);

/* x, y or z: axis 0, 1 or 2. */
static inline double tree_component(roberts_vec3 a, int axis)
{
    return axis == 0 ? a.x : axis == 1 ? a.y : a.z;
}

int tree_longest_axis(tree_box a);

typedef struct tree_node {
    tree_box box;
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

/* A walk through the leaves that the ray S + t v, 0 <= t <= reach, meets, without those that are all `skip`'s. */
typedef struct tree_walk {
    const tree *t;
    roberts_vec3 origin, inverse; /* inverse: 1 / v, large and finite where v is 0 */
    double reach;
    uint32_t skip;
    uint32_t depth;
    uint32_t stack[TREE_DEPTH + 1];
} tree_walk;

void tree_walk_start(tree_walk *w, const tree *t, roberts_ray ray, double reach, uint32_t skip);

/* The items of the next leaf whose box is met; their number is returned, 0 at the end. A box that the ray only just
 * misses may be taken for met. */
uint32_t tree_walk_next(tree_walk *w, const uint32_t **item);

#endif
