/* bundle.h - the front faces of a solid that lie across one another's boxes many times over, as those of a fan do, or
 * of a round column: a tree over them.
 *
 * In the cells such faces would be listed everywhere, and an edge would meet most of them, though what they hide of
 * it is one interval: only the faces at its ends matter. So the solid is one front, and its faces are asked by a tree
 * whose nodes know two things of theirs: a box in the picture, turned as they lie; and how far behind a plane of
 * theirs a point can be at the most. A face that meets the edge where it is found hidden already, or only where it
 * lies in front, is not asked. */
#ifndef ROBERTS_HIDE_BUNDLE_H
#define ROBERTS_HIDE_BUNDLE_H

#include "hide/list_tree.h"
#include "hide/tolerance.h"

typedef struct bundle_node {
    roberts_vec3 M;           /* a point amid the faces' corners */
    double ux, uy;            /* along them, 1 long */
    double x0, x1, y0, y1;    /* box of the corners in the picture, from M, along and across; widened by the margin */
    roberts_vec3 least, most; /* of the planes' normals */
    double behind;            /* the most of F(M), with what counts as on the plane and rounding added */
} bundle_node;

typedef struct bundle {
    list_tree tree;  /* the items are `order` */
    uint32_t *order; /* faces, counted from the solid's first front face, those beside one another together */
    bundle_node node[];
} bundle;

/* The bundles of a picture, by their first face / BUNDLE_FACES, or NULL; NULL: there is none. */
typedef struct bundle_table {
    bundle **at;
    size_t count;
} bundle_table;

/* For so many faces. False: no memory; bundle_table_free() takes a zeroed table. */
bool bundle_table_init(bundle_table *table, size_t count);
void bundle_table_free(bundle_table *table);

/* Enters a bundle; `face`: all of its faces, of which the first has this number. Threads may enter different ones at
 * the same time. False: no memory. */
bool bundle_enter(bundle_table *table, const hide_space *space, const hide_face *face, uint32_t count, uint32_t first);

static inline const bundle *bundle_of(const bundle_table *table, uint32_t first, uint32_t count)
{
    return count > BUNDLE_FACES && table->at ? table->at[first / BUNDLE_FACES] : NULL;
}

/* Where the edge may lie before or behind the node's faces: *t0 .. *t1 of it; false: nowhere. */
bool bundle_meets(const bundle_node *n, const hide_edge *e, double *t0, double *t1);

/* Can X be behind the plane of one of the node's faces? Between two points that cannot, none is. */
static inline bool bundle_behind(const bundle_node *n, roberts_vec3 X)
{
    roberts_vec3 D = vec3_sub(X, n->M);
    double x = greater(n->least.x * D.x, n->most.x * D.x), y = greater(n->least.y * D.y, n->most.y * D.y);
    return n->behind + x + y + greater(n->least.z * D.z, n->most.z * D.z) >= 0.0;
}

/* The first items from *item on whose node holds (x, y) in its box, which become *item .. *end - 1; false: none. */
bool bundle_next(const bundle *b, double x, double y, uint32_t *item, uint32_t *end);

#endif
