/* components.h - which faces of a mesh belong together: connected components of the face-vertex incidence. */
#ifndef ROBERTS_MODEL_COMPONENTS_H
#define ROBERTS_MODEL_COMPONENTS_H

#include "roberts.h"

#include "model/repeated_solids.h"

/* ---- faces with every corner once -------------------------------------------------------------------------------- */

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

/* ---- components that follow one another in the file -------------------------------------------------------------- */

/* Where every vertex is used and the components' vertices and faces follow one another without a gap, each component one
 * like a sphere and no corner repeating another of its face: fills in scene->solid, the counts, and the solids' patterns, and
 * sets *found. Else nothing is changed. False: no memory. */
bool components_in_a_row(roberts_scene *scene, const polygons *faces, repeated_solids *list, bool *found);

/* ---- components -------------------------------------------------------------------------------------------------- */

/* Allocates the scene's arrays, but for the edges, and lays out all components of `faces` in it, by their smallest vertex:
 * vertices, faces and corners in compact numbers, corners in the order of the file, and the box round them. No planes and no
 * edges yet. Components need not be closed.
 * Where that tells the solids' patterns, they are in `list`, which is empty before.
 * `faces` is cleaned first if some corner repeats an earlier one of its face.
 * Where the mesh may `lend` its arrays and the scene's would be equal, the scene points to them: scene->lent tells which.
 * False: no memory. */
bool components_lay_out(roberts_scene *scene, polygons *faces, const roberts_mesh *mesh, bool lend,
                        repeated_solids *list);

#endif
