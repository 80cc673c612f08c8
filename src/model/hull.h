/* hull.h - convex hulls in place of solids that are not convex. */
#ifndef ROBERTS_MODEL_HULL_H
#define ROBERTS_MODEL_HULL_H

#include "model/scene.h"

/* ---- inputs ---------------------------------------------------------------------------------------------------- */

/* The inputs (files) of a mesh. A bare input has points, but no face of three or more corners. */

/* The least number of points with a convex hull. */
enum { HULL_POINTS = 4 };

/* Is there a bare input? */
bool hull_bare_input(const roberts_mesh *mesh);

/* Adds one face for each bare input with at least four points. All its points are corners, so each input becomes a
 * component. These faces are numbered from mesh->face_count on. Returns ROBERTS_OK, _NO_MEMORY or _FLAT (the mesh has
 * only inputs of fewer points). */
roberts_status hull_add_inputs(polygons *faces, const roberts_mesh *mesh, roberts_error *error);

/* ---- hulls ----------------------------------------------------------------------------------------------------- */

/* Lays out the scene again: a solid that solid_build() refuses gets the faces of its hull, which have no number
 * (ROBERTS_NONE). Components may be open. Solids keep their order; flat ones are left out. For each input, a warning
 * says how many solids were replaced and why, and how many were flat.
 * options   tolerance, warnings, threads; the number of threads does not change the result
 * Returns ROBERTS_OK, _NO_MEMORY, _BAD_NUMBER, _FLAT (nothing else is left) or _NOT_CONVEX (rounding was too much for
 * Qhull). */
roberts_status hull_solids(roberts_scene *scene, const roberts_mesh *mesh, const roberts_scene_options *options,
                           roberts_error *error);

/* ---- the facets of one hull, computed by Qhull ------------------------------------------------------------------- */

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
