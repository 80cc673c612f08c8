/* tree.h - a tree of boxes, which finds those over a point or over a segment.
 *
 * Boxes are in a picture: x and y perpendicular to the sight lines, z toward the viewer. Every sight line runs along
 * +z, so it meets a box if the box lies over (x, y) and reaches higher than z.
 *
 * The tree is a bounding volume hierarchy. Boxes are divided at the best of a few planes for each axis (I. Wald, "On
 * fast construction of SAH-based bounding volume hierarchies", 2007). The volume of the shadow that a box casts away
 * from the viewer replaces the surface area, since the chance that a ray meets the box is proportional to it. A node
 * has up to four children, so there are few nodes to fetch (H. Dammertz, J. Hanika, A. Keller, "Shallow bounding volume
 * hierarchies for fast SIMD ray tracing of incoherent rays", 2008). Many points go down the tree together, and each
 * child gets those under its box (I. Wald, C. Gribble, S. Boulos, A. Kensler, "SIMD ray stream tracing", 2007). So a
 * node is fetched once for all of them, and a box is compared with four points at a time.
 *
 * Invariants: a child's box contains the boxes of all items below it; node 0 is the root; children that reach farther
 * toward the viewer come first; the depth is at most TREE_DEPTH. The tree is a function of the boxes alone. */
#ifndef ROBERTS_RAY_TREE_H
#define ROBERTS_RAY_TREE_H

#include "base/bits.h"
#include "base/box.h"
#include "base/vec.h"

enum {
    TREE_DEPTH = 96,
    TREE_WIDTH = 4,
    TREE_POINTS = 128, /* most points that walk together; a multiple of 64 */
    TREE_KEPT = 4,     /* most leaves that a walk visits before all others */
};

/* Returns the volume of a box's shadow down to z = `floor`; 0 for an empty box. */
double tree_box_shadow(box3 a, double floor);

/* The result of a search: the caller's things `first` to `first + count - 1`. */
typedef struct tree_item {
    uint32_t first, count;
} tree_item;

/* An item to be put into the tree: its owner, and its box in single precision, rounded outward (by up to two ulps). */
typedef struct tree_entry {
    float lo[3], hi[3];
    uint32_t owner; /* not ROBERTS_NONE */
    tree_item item;
} tree_entry;

tree_entry tree_entry_of(box3 box, uint32_t owner, tree_item item);

/* A node takes two cache lines. Its boxes have no lower bound, which does not matter. A missing child is a leaf whose
 * box lies over nothing. */
typedef struct tree_node {
    float lo_x[TREE_WIDTH], hi_x[TREE_WIDTH], lo_y[TREE_WIDTH], hi_y[TREE_WIDTH], hi_z[TREE_WIDTH];
    uint32_t owner[TREE_WIDTH]; /* common owner of all items below, or ROBERTS_NONE */
    uint32_t first[TREE_WIDTH]; /* leaf: its first item; otherwise a node */
    uint32_t count[TREE_WIDTH]; /* leaf: its items; otherwise 0 */
} tree_node;

typedef struct tree {
    tree_node *node;
    tree_item *item; /* the items, leaf after leaf */
    uint32_t node_count;
} tree;

/* Builds `t` over `count` entries, at most UINT32_MAX / TREE_WIDTH, and changes their order. False: no memory, and `t`
 * is empty. */
bool tree_build(tree *t, tree_entry *entry, uint32_t count);
void tree_free(tree *t);

/* A set of the points that walk together: point i is bit i % 64 of word i / 64. */
typedef struct tree_set {
    uint64_t word[TREE_POINTS / 64];
} tree_set;

static inline bool tree_set_is_empty(const tree_set *s)
{
    uint64_t any = 0;
    for (int k = 0; k < TREE_POINTS / 64; k++)
        any |= s->word[k];
    return any == 0;
}

/* Removes the least point from the set, which must not be empty. */
static inline uint32_t tree_set_take(tree_set *s)
{
    uint32_t k = 0;
    while (!s->word[k])
        k++;
    uint32_t i = 64 * k + (uint32_t)bits_trailing_zeros(s->word[k]);
    s->word[k] &= s->word[k] - 1;
    return i;
}

/* Points that walk together. Zeroed: none yet. Single precision loses no box: boxes are rounded outward, and rounding
 * to nearest preserves order. */
typedef struct tree_points {
    uint32_t count;
    tree_set live; /* points not yet dropped */
    float x[TREE_POINTS], y[TREE_POINTS], z[TREE_POINTS];
    uint32_t skip[TREE_POINTS]; /* the owner whose items need not be found, or a number that is no owner */
} tree_points;

static inline void tree_points_add(tree_points *p, roberts_vec3 point, uint32_t skip)
{
    p->live.word[p->count / 64] |= (uint64_t)1 << p->count % 64;
    p->x[p->count] = (float)point.x;
    p->y[p->count] = (float)point.y;
    p->z[p->count] = (float)point.z;
    p->skip[p->count++] = skip;
}

/* Drops point i: from now on nothing is over it. */
static inline void tree_points_drop(tree_points *p, uint32_t i)
{
    p->live.word[i / 64] &= ~((uint64_t)1 << i % 64);
}

/* Raises point i: from now on boxes are over it only if they reach up to z. */
static inline void tree_points_raise(tree_points *p, uint32_t i, double z)
{
    p->z[i] = (float)z;
}

/* Returns those points of `of` that lie under the entry's box and do not skip its owner. */
tree_set tree_points_under(const tree_points *p, const tree_entry *e, const tree_set *of);

/* A child of a node, and the points under its box. */
typedef struct tree_visit {
    uint32_t child; /* TREE_WIDTH times the parent's number, plus the child's index in it */
    tree_set points;
} tree_visit;

/* A walk through the leaves over some points. A point does not find leaves whose items all belong to the owner that it
 * skips. Leaves nearer to the viewer come first, roughly. */
typedef struct tree_walk {
    const tree *t;
    const tree_points *points;
    float lo_x, hi_x, lo_y, hi_y, lo_z;     /* box of all points */
    uint32_t kept[TREE_KEPT], kept_count;   /* useful leaves, numbered as in tree_visit */
    uint32_t first[TREE_KEPT], first_count; /* leaves that were kept when the walk began and are still to come */
    uint32_t leaf;                          /* the last leaf found */
    bool root_done;                         /* the root's children have been pushed */
    uint32_t depth;
    tree_visit stack[(TREE_WIDTH - 1) * TREE_DEPTH + 1];
} tree_walk;

/* A leaf, and the points under it. */
typedef struct tree_leaf {
    const tree_item *item;
    uint32_t item_count;
    tree_set points;
} tree_leaf;

/* Prepares `w` for any number of walks through the same tree. */
void tree_walk_init(tree_walk *w, const tree *t);

/* Starts a walk. Points may be dropped on the way, and must not change otherwise. */
void tree_walk_start(tree_walk *w, const tree_points *points);

/* Finds the next leaf with a point under its box, the kept leaves first; false at the end. A near miss may count as a
 * hit. */
bool tree_walk_next(tree_walk *w, tree_leaf *leaf);

/* Keeps the leaf just found because it was useful. Later walks find it first, and once more in its normal order. */
void tree_walk_keep(tree_walk *w);

/* A search for the leaves whose boxes may lie over some point of a segment. */
typedef struct tree_search {
    const tree *t;
    roberts_vec2 middle, half; /* of the segment: its middle, and half the vector from end to end */
    double low_z;              /* depth of its lower end */
    uint32_t skip;             /* as in tree_points */
    uint32_t depth;
    uint32_t stack[(TREE_WIDTH - 1) * TREE_DEPTH + 1]; /* children, numbered as in tree_visit */
} tree_search;

/* Starts a search for boxes over the segment from `a` to `b`, skipping leaves whose items all belong to `skip`. */
void tree_search_start(tree_search *s, const tree *t, roberts_vec3 a, roberts_vec3 b, uint32_t skip);

/* Finds the next leaf; false at the end. Does not set leaf->points. */
bool tree_search_next(tree_search *s, tree_leaf *leaf);

#endif
