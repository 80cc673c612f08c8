/* search.h - what is near what: a tree of boxes, a grid of points, the lines on a sweep line in order. */
#ifndef ROBERTS_BASE_SEARCH_H
#define ROBERTS_BASE_SEARCH_H

#include <stdbool.h>
#include <stdint.h>

#include "base/box.h"
#include "roberts.h"

/* ---- a tree of boxes --------------------------------------------------------------------------------------------- */

/* Finds the things near a box or a segment.
 *
 * Several trees share one pair of arrays. A tree is identified by its root. Nodes are in depth-first order, and each
 * stores the node that follows its subtree, so a search needs no stack: after a node whose box is missed, it goes on
 * with that one, and otherwise with the next one. */

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

/* A search in one tree for what is near a box. */
typedef struct box_search {
    const box_tree *tree;
    const box3 *box;
    uint32_t node, nodes_end; /* the next node */
    uint32_t item, items_end; /* the next item of the last node */
} box_search;

/* Begins a search. A tree without nodes has no items. */
static inline box_search box_search_begin(const box_tree *of, uint32_t root, const box3 *box)
{
    return (box_search){
        .tree = of, .box = box, .node = root, .nodes_end = of->node_count > 0 ? of->node[root].skip : root};
}

/* Finds the next item of a leaf whose box meets the box of the search; the item's own box may miss it. False: there is
 * none. */
static inline bool box_search_next(box_search *s, uint32_t *item)
{
    while (s->item == s->items_end) {
        if (s->node == s->nodes_end)
            return false;
        const box_tree_node *node = &s->tree->node[s->node];
        const bool met = box3_meet(&node->box, s->box);
        s->node = met ? s->node + 1 : node->skip;
        s->item = node->first;
        s->items_end = met ? node->first + node->count : node->first;
    }
    *item = s->tree->item[s->item++];
    return true;
}

/* Returns the axis on which the centres of the boxes item[0 .. count - 1] are spread farthest: 0, 1 or 2. */
int box_longest_axis(const box3 *box, const uint32_t *item, uint32_t count);

/* Moves the numbers of `half` boxes to the front of item[0 .. count - 1]: those with the smallest centres, along that
 * axis. */
void box_tree_halve(const box3 *box, uint32_t *item, uint32_t count, uint32_t half);

/* ---- a grid of points -------------------------------------------------------------------------------------------- */

/* A grid of cells that finds the points near a segment. */

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

/* Appends all points within `margin` of a side of the triangle ABC, some perhaps twice, and others near its plane. For
 * a small triangle, this takes less time than asking for its sides one by one. False: no memory. */
bool point_grid_near_triangle(const point_grid *grid, roberts_vec3 A, roberts_vec3 B, roberts_vec3 C, double margin,
                              point_list *found);

void point_grid_free(point_grid *grid);

/* ---- the lines on a sweep line, in order ------------------------------------------------------------------------- */

/* From the lowest to the highest: a list with a search tree over it.
 *
 * The tree is a treap (C. R. Aragon, R. Seidel, "Randomized search trees", Algorithmica 16, 1996) whose priorities are
 * computed from the numbers of the lines, so every run is the same. */

/* A line in the order. ROBERTS_NONE: no such neighbour. */
typedef struct sweep_place {
    uint32_t parent, child[2]; /* in the tree: child 0 below, child 1 above */
    uint32_t near[2];          /* in the list: the lines below and above */
    uint32_t priority;         /* no child has a greater one */
} sweep_place;

typedef struct sweep_order {
    sweep_place *place; /* indexed by line */
    uint32_t root;      /* ROBERTS_NONE: no line */
} sweep_order;

/* Makes room for lines 0 .. count-1; none is in the order yet. False: no memory. */
bool sweep_order_start(sweep_order *order, size_t count);

/* Inserts a line directly above another, or as the lowest if `below` is ROBERTS_NONE. */
void sweep_order_insert(sweep_order *order, uint32_t line, uint32_t below);

/* Returns the line directly above another, or the lowest if `below` is ROBERTS_NONE. */
uint32_t sweep_order_above(const sweep_order *order, uint32_t below);

void sweep_order_remove(sweep_order *order, uint32_t line);

void sweep_order_free(sweep_order *order);

#endif
