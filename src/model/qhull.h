/* qhull.h - the facets of a convex hull, by libqhull. Only qhull.c includes libqhull. */
#ifndef ROBERTS_MODEL_QHULL_H
#define ROBERTS_MODEL_QHULL_H

#include "roberts.h"

/* Facets as polygons whose corners are point numbers. The arrays are reused for hull after hull; zeroed = empty. */
typedef struct hull_facets {
    uint32_t count;
    uint32_t *start;  /* [count + 1] into corner */
    uint32_t *corner; /* in order round the facet */
    uint32_t *next;   /* [points] scratch: the next corner */
    double outside;   /* the greatest distance of a point outside a facet, according to Qhull */
    size_t start_room, corner_room, next_room;
} hull_facets;

typedef enum hull_result {
    HULL_OK,
    HULL_FLAT, /* the points lie in one plane, as far as Qhull can tell */
    HULL_NO_MEMORY,
    HULL_FAILED, /* rounding was too much for Qhull */
} hull_result;

/* Computes the convex hull of `count` points, which are finite and of a size of about 1. `width`: points nearer to a
 * facet than this lie in it, and facets that are coplanar within it are merged; 0: only as far as rounding requires. */
hull_result hull_take(hull_facets *facets, const roberts_vec3 *point, uint32_t count, double width);

void hull_facets_free(hull_facets *facets);

#endif
