/* box_tree.h - a tree of boxes that finds the things near a box or a segment.
 *
 * Several trees share one pair of arrays. A tree is identified by its root. Nodes are in depth-first order, and each
 * stores the node that follows its subtree, so a search needs no stack:
 *
 *     for (uint32_t i = root, end = tree->node[root].skip; i < end;)
 *         if (the box of node i is missed)
 *             i = tree->node[i].skip;
 *         else {
 *             look at the items of node i; // inner nodes have none
 *             i++;
 *         } */
#ifndef ROBERTS_MODEL_BOX_TREE_H
#define ROBERTS_MODEL_BOX_TREE_H

#include <stdbool.h>
#include <stdint.h>

#include "base/vec.h"

typedef struct box3 {
    roberts_vec3 lo, hi;
} box3;

typedef struct box_tree_node {
    box3 box;
    uint32_t skip;         /* the node after this one's subtree */
    uint32_t first, count; /* items of a leaf, in box_tree.item; count 0: an inner node */
} box_tree_node;

typedef struct box_tree {
    box_tree_node *node;
    uint32_t *item;
    size_t node_count, node_room, item_count, item_room;
} box_tree;

/* Adds a tree over box[0 .. count - 1]. Its items are the boxes' numbers, starting at `base`. `count` is at least 1.
 * Sets *root. False: no memory. */
bool box_tree_add(box_tree *tree, const box3 *box, uint32_t count, uint32_t base, uint32_t *root);

void box_tree_free(box_tree *tree);

/* Moves the numbers of `half` boxes to the front of item[0 .. count - 1]: those with the smallest centres, along the
 * axis on which the centres are spread farthest. */
void box_tree_halve(const box3 *box, uint32_t *item, uint32_t count, uint32_t half);

static inline bool box3_meet(const box3 *a, const box3 *b)
{
    return a->lo.x <= b->hi.x && b->lo.x <= a->hi.x && a->lo.y <= b->hi.y && b->lo.y <= a->hi.y && a->lo.z <= b->hi.z &&
           b->lo.z <= a->hi.z;
}

#endif
