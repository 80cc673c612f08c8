/* front_tree.h - a tree over the fronts of a cell, for cells that list very many.
 *
 * Each node has up to four children: nodes, or fronts. A child is bounded by half-spaces: the box of its fronts; two
 * strips of the picture, along the longest sides of their outlines; and a plane in front of them, parallel to the
 * largest of their faces. So the tree separates oblique thin solids, and piles of sheets seen nearly edge-on, as well
 * as cubes. A line is clipped to the half-spaces. The fronts neither hide nor touch the rest of the line.
 *
 * Fronts are divided at the median of their middles, along the axis of their greatest spread. */
#ifndef ROBERTS_HIDE_FRONT_TREE_H
#define ROBERTS_HIDE_FRONT_TREE_H

#include "base/lanes.h"
#include "hide/fronts.h"

/* Fronts with more corners or faces than this are bounded by their boxes alone. */
#define FRONT_TREE_CORNERS 24

/* The most pending children while a line goes through a tree. */
#define FRONT_TREE_WAITING 64

/* Of a child: this bit says that it is a single front; without it, the child is a node. */
#define FRONT_TREE_LEAF 0x80000000u

/* Bounds of the children, one lane each. Unused children have no points. */
typedef struct front_node {
    float x0[4], x1[4], y0[4], y1[4], z0[4], z1[4];
    struct {
        float x[4], y[4], low[4], high[4]; /* low <= x X.x + y X.y <= high */
    } strip[2];
    struct {
        float x[4], y[4], z[4], low[4], high[4]; /* low <= x X.x + y X.y + z X.z <= high */
    } plane;
    uint32_t last[4];  /* the last place in the list below the child */
    uint32_t child[4]; /* a node, or the place of a front in the list and FRONT_TREE_LEAF */
} front_node;

typedef struct front_tree {
    front_node *node; /* the root first; NULL: there is no tree */
    uint32_t count;
} front_tree;

/* Builds the tree over a list of at least one front. False: no memory. */
bool front_tree_build(front_tree *tree, const hide_fronts *fronts, const uint32_t *front, uint32_t count);
void front_tree_free(front_tree *tree);

/* A line for the tree: AB, and margins that cover the rounding of floats. */
typedef struct front_line {
    four Ax, Ay, Az, dx, dy, dz; /* d: B - A */
    four per_dx, per_dy;         /* 1 / dx, 1 / dy */
    four margin, margin_z, margin_plane;
} front_line;

front_line front_line_of(roberts_vec3 A, roberts_vec3 B, double margin);

/* What a line may meet in a tree: a child, and the part of the line that it may hide or touch. */
typedef struct front_visit {
    uint32_t child;
    float t0, t1;
    float z1; /* the nearest depth of the child */
} front_visit;

/* Finds the children of a node that may hide or touch anything of the part t0 .. t1 of the line, and which part.
 * Returns their number. The longest part comes last; of equal ones, that of the child farther from the viewer, which is
 * mostly the nearest one in front of the line. */
uint32_t front_node_meets(const front_node *n, const front_line *line, float t0, float t1, front_visit found[4]);

/* Finds the children of a node that may hide anything of the lines in a box: their numbers, the farthest child from the
 * viewer last. Returns how many they are. */
uint32_t front_node_meets_box(const front_node *n, const hide_box *lines, uint32_t found[4]);

/* A front for the tree. */
typedef struct front_shape {
    const hide_box *box;
    uint32_t count; /* of the corners of its faces, or of its box */
    float x[FRONT_TREE_CORNERS], y[FRONT_TREE_CORNERS], z[FRONT_TREE_CORNERS];
    float margin, margin_plane;
} front_shape;

void front_shape_of(front_shape *shape, const hide_fronts *fronts, uint32_t front);

/* Which children may have a point in common with the front, and come after `place` in the list? Bit i is child i. */
unsigned front_node_touches(const front_node *n, const front_shape *shape, uint32_t place);

#endif
