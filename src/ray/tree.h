/* tree.h - a tree of boxes over boxes, to find those that lie over points without asking them all.
 *
 * Boxes live in a picture: x and y across the sight lines, z toward the viewer, so that every sight line runs along +z
 * and a box is met where it lies over (x, y) and reaches higher than z.
 *
 * Idea: a bounding volume hierarchy. Each node is split at the best of a few planes across each axis (Wald, "On fast
 * construction of SAH-based bounding volume hierarchies", 2007). In place of the surface stands what is in proportion
 * here to the chance of being met: the volume of the shadow that the box throws away from the viewer. Points go down the
 * tree many at a time, each node with those that its parent's box is over (I. Wald, C. Gribble, S. Boulos, A. Kensler,
 * "SIMD ray stream tracing", 2007): a node is fetched once for all of them.
 * Invariants: a node's box holds the boxes of all items below it; node 0 is the root; the first child of an inner node
 * follows it directly, and reaches no less far toward the viewer than the second; depth is at most TREE_DEPTH. The tree is a
 * function of the boxes alone. */
#ifndef ROBERTS_RAY_TREE_H
#define ROBERTS_RAY_TREE_H

#include <float.h>

#include "base/vec.h"

enum {
    TREE_DEPTH = 96,
    TREE_POINTS = 128, /* that walk together at the most; their numbers fit a byte */
    TREE_KEPT = 4,     /* leaves that come first */
};

typedef struct tree_box {
    roberts_vec3 lo, hi;
} tree_box;

static const tree_box tree_no_box = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

/* The box round both. */
static inline tree_box tree_box_union(tree_box a, tree_box b)
{
    return (tree_box){{lesser(a.lo.x, b.lo.x), lesser(a.lo.y, b.lo.y), lesser(a.lo.z, b.lo.z)},
                      {greater(a.hi.x, b.hi.x), greater(a.hi.y, b.hi.y), greater(a.hi.z, b.hi.z)}};
}

/* Volume of a box's shadow down to z = `floor`; 0 for an empty one. */
double tree_box_shadow(tree_box a, double floor);

/* What is found: `count` things of the caller's from `first` on. */
typedef struct tree_item {
    uint32_t first, count;
} tree_item;

/* An item on its way into the tree: its box in single precision, rounded outward (by up to two of its last places), and
 * whose it is. */
typedef struct tree_entry {
    float lo[3], hi[3];
    uint32_t owner; /* not ROBERTS_NONE */
    tree_item item;
} tree_entry;

tree_entry tree_entry_of(tree_box box, uint32_t owner, tree_item item);

/* Half a cache line; how deep a box reaches does not matter. */
typedef struct tree_node {
    float lo_x, lo_y, hi_x, hi_y, hi_z;
    uint32_t first; /* leaf: its first item; inner node: its second child */
    uint32_t count; /* leaf: its items; inner node: 0 */
    uint32_t owner; /* of all items below, or ROBERTS_NONE where they have several */
} tree_node;

typedef struct tree {
    tree_node *node;
    tree_item *item; /* the items of leaf after leaf */
    uint32_t node_count;
} tree;

/* Builds `t` over `count` entries, whose order changes. False: no memory, and `t` is empty. */
bool tree_build(tree *t, tree_entry *entry, uint32_t count);
void tree_free(tree *t);

/* Points that walk together. Single precision takes no box from a point: rounding to the nearest keeps order, and boxes
 * are rounded outward. */
typedef struct tree_points {
    uint32_t count, dropped;
    float x[TREE_POINTS], y[TREE_POINTS], z[TREE_POINTS];
    uint32_t skip[TREE_POINTS]; /* an owner whose items need not be found, or any number that is no owner's */
} tree_points;

static inline void tree_points_add(tree_points *p, roberts_vec3 point, uint32_t skip)
{
    p->x[p->count] = (float)point.x;
    p->y[p->count] = (float)point.y;
    p->z[p->count] = (float)lesser(point.z, FLT_MAX); /* finite: it is taken from what may be infinite */
    p->skip[p->count++] = skip;
}

/* From now on nothing is over point i. */
static inline void tree_points_drop(tree_points *p, uint32_t i)
{
    p->z[i] = NAN;
    p->dropped++;
}

/* Writes those of the points on `list` that lie under the entry's box, and do not skip its owner, to `under`; returns how
 * many. */
uint32_t tree_points_under(const tree_points *p, const tree_entry *e, const unsigned char *list, uint32_t count,
                           unsigned char *under);

/* Points on their way down: `count` of the walk's list from `start` on, in a box; so many had been dropped by then. */
typedef struct tree_crowd {
    uint32_t start, count, dropped;
    float lo_x, lo_y, hi_x, hi_y, lo_z, hi_z;
} tree_crowd;

/* Walks through the leaves over points, for each without those that are all of the owner it skips; leaves nearer to
 * the viewer come first, about. */
typedef struct tree_walk {
    const tree *t;
    const tree_points *points;
    uint32_t kept[TREE_KEPT], kept_count;
    uint32_t leaf, depth; /* the leaf last found */
    struct {
        uint32_t node;
        tree_crowd crowd; /* those that the parent's box is over */
    } stack[TREE_DEPTH + 2 + TREE_KEPT];
    unsigned char list[(TREE_DEPTH + 2) * TREE_POINTS];
} tree_walk;

/* A leaf, and the points that it is over. */
typedef struct tree_leaf {
    const tree_item *item;
    const unsigned char *point;
    uint32_t item_count, point_count;
} tree_leaf;

/* A walker, for walk after walk through the same tree. */
void tree_walk_init(tree_walk *w, const tree *t);

/* The points may be dropped on the way, and must stay otherwise. */
void tree_walk_start(tree_walk *w, const tree_points *points);

/* The next leaf with a point under its box, first the kept ones; false at the end. A box that is only just missed may be
 * taken for met. */
bool tree_walk_next(tree_walk *w, tree_leaf *leaf);

/* The leaf just found was of use, and is to come first on the next walks, and once more in its turn. */
void tree_walk_keep(tree_walk *w);

#endif
