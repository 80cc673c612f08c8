/* components.h - which faces belong together. */
#ifndef ROBERTS_MODEL_COMPONENTS_H
#define ROBERTS_MODEL_COMPONENTS_H

#include "roberts.h"

/* The faces of a mesh with every corner once: a corner that repeats an earlier one of its face is left out. Faces are
 * numbered as in the mesh. Where nothing is left out, the arrays are the mesh's own. */
typedef struct polygons {
    uint32_t face_count, vertex_count;
    const uint32_t *start;            /* [face_count + 1] into corner */
    const uint32_t *corner;           /* vertex numbers of the mesh */
    uint32_t *own_start, *own_corner; /* what polygons_free() releases */
    size_t repeated;                  /* corners left out */
} polygons;

/* Faces by solid: solid s has the faces face[start[s]] .. face[start[s + 1] - 1], ascending. Faces with fewer than
 * three corners are in none. */
typedef struct grouping {
    uint32_t solid_count;
    uint32_t *start;               /* [solid_count + 1] */
    uint32_t *face;                /* [start[solid_count]] */
    size_t corner_count;           /* corners of all these faces */
    size_t vertex_count;           /* sum over the solids of the vertices they use */
    roberts_vec3 box_min, box_max; /* box round these vertices */
} grouping;

/* Returns ROBERTS_OK, _NO_MEMORY, _BAD_INDEX or _BAD_ARGUMENT (more vertices, faces or corners than 32 bits count). */
roberts_status polygons_clean(polygons *clean, const roberts_mesh *mesh, roberts_error *error);
void polygons_free(polygons *clean);

/* Connected components of the face-vertex incidence, numbered by their smallest vertex. */
roberts_status components_find(grouping *found, const polygons *faces, const roberts_vec3 *point, roberts_error *error);
void grouping_free(grouping *found);

static inline uint32_t polygon_size(const polygons *faces, uint32_t f)
{
    return faces->start[f + 1] - faces->start[f];
}

#endif
