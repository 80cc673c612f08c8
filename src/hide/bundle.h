/* bundle.h - a tree over the front faces of one solid whose boxes overlap many times, as in a fan or a round column.
 *
 * Such faces would be listed in all cells, and an edge would be compared with most of them. But together they hide one
 * interval of the edge, and only the faces at its ends matter. So the solid is one front with a tree over its faces. A
 * node stores a box of its faces in the picture, turned to lie along them, and a bound on how far a point can be behind
 * one of their planes. An edge skips a node if, wherever it meets the box, it is already hidden or in front of all
 * planes. */
#ifndef ROBERTS_HIDE_BUNDLE_H
#define ROBERTS_HIDE_BUNDLE_H

#include <stdbool.h>
#include <stdint.h>

#include "base/list_tree.h"
#include "hide/tests.h"
#include "hide/tolerance.h"

typedef struct bundle_node {
    roberts_vec3 M;           /* a point among the faces' corners */
    double ux, uy;            /* unit vector along the faces */
    double x0, x1, y0, y1;    /* box of the corners in the picture, relative to M, along and across; with margin */
    roberts_vec3 least, most; /* bounds of the planes' normals */
    double behind;            /* the greatest F(M), plus the touching distance and rounding */
} bundle_node;

typedef struct bundle {
    list_tree tree;  /* its items are the entries of `order` */
    uint32_t *order; /* faces, counted from the solid's first front face; neighbours are adjacent */
    bundle_node node[];
} bundle;

/* The bundles of a picture. A bundle whose first face is f is at[f / BUNDLE_FACES]; other entries are NULL. */
typedef struct bundle_table {
    bundle **at;
    size_t count;
} bundle_table;

/* Makes an empty table for `count` faces. False: no memory; bundle_table_free() accepts a zeroed table. */
bool bundle_table_init(bundle_table *table, size_t count);
void bundle_table_free(bundle_table *table);

/* Adds a bundle of face[0 .. count-1]. first: the number of face[0]. Threads may add different bundles at the same
 * time. False: no memory. */
bool bundle_enter(bundle_table *table, const hide_space *space, const hide_face *face, uint32_t count, uint32_t first);

static inline const bundle *bundle_of(const bundle_table *table, uint32_t first, uint32_t count)
{
    return count > BUNDLE_FACES && table->at ? table->at[first / BUNDLE_FACES] : NULL;
}

/* Finds the part *t0 .. *t1 of the edge inside the node's box. False: there is none. */
bool bundle_meets(const bundle_node *n, const hide_edge *e, double *t0, double *t1);

/* Can X be behind the plane of one of the node's faces? If neither end of a line can, no point of the line can. */
static inline bool bundle_behind(const bundle_node *n, roberts_vec3 X)
{
    roberts_vec3 D = vec3_sub(X, n->M);
    double x = greater(n->least.x * D.x, n->most.x * D.x), y = greater(n->least.y * D.y, n->most.y * D.y);
    return n->behind + x + y + greater(n->least.z * D.z, n->most.z * D.z) >= 0.0;
}

/* Finds the next items, from *item on, whose node has (x, y) in its box: *item .. *end - 1. False: there are none. */
bool bundle_next(const bundle *b, double x, double y, uint32_t *item, uint32_t *end);

#endif
