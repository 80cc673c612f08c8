/* polygons.h - the faces of a mesh, every corner once. */
#ifndef ROBERTS_MODEL_POLYGONS_H
#define ROBERTS_MODEL_POLYGONS_H

#include "roberts.h"

/* Faces numbered as in the mesh. Until cleaned, the arrays are the mesh's own. */
typedef struct polygons {
    uint32_t face_count, vertex_count;
    const uint32_t *start;            /* [face_count + 1] into corner */
    const uint32_t *corner;           /* vertex numbers of the mesh */
    uint32_t *own_start, *own_corner; /* what polygons_free() releases */
    size_t repeated;                  /* corners that cleaning has left out */
} polygons;

/* The faces as they are in the mesh. Returns ROBERTS_OK or _NO_MEMORY (more than 32 bits can count). */
roberts_status polygons_of_mesh(polygons *faces, const roberts_mesh *mesh, roberts_error *error);

/* Replaces each vertex number v by name[v] (NULL: leaves it) and leaves out the corners that then repeat an earlier one
 * of their face. False: no memory, and nothing has changed. */
bool polygons_clean(polygons *faces, const uint32_t *name);

void polygons_free(polygons *faces);

static inline uint32_t polygon_size(const polygons *faces, uint32_t f)
{
    return faces->start[f + 1] - faces->start[f];
}

#endif
