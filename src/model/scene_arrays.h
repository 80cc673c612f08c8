/* scene_arrays.h - the scene's arrays: allocated, filled solid by solid, freed. */
#ifndef ROBERTS_MODEL_SCENE_ARRAYS_H
#define ROBERTS_MODEL_SCENE_ARRAYS_H

#include "model/scene.h"

/* ---- faces with every corner once ------------------------------------------------------------------------------ */

/* Faces, numbered as in the mesh. The arrays belong to the mesh until the faces are cleaned. */
typedef struct polygons {
    uint32_t face_count, vertex_count;
    const uint32_t *start;            /* [face_count + 1] into corner */
    const uint32_t *corner;           /* vertex numbers of the mesh */
    uint32_t *own_start, *own_corner; /* arrays that polygons_free() releases */
    size_t repeated;                  /* number of corners left out by cleaning */
} polygons;

/* Takes the faces unchanged from the mesh. Returns ROBERTS_OK or _NO_MEMORY (more than 32 bits can count). */
roberts_status polygons_of_mesh(polygons *faces, const roberts_mesh *mesh, roberts_error *error);

/* Replaces each vertex number v by name[v] (NULL: no change) and leaves out the corners that then repeat an earlier one
 * of their face. False: no memory; nothing has changed. */
bool polygons_clean(polygons *faces, const uint32_t *name);

void polygons_free(polygons *faces);

static inline uint32_t polygon_size(const polygons *faces, uint32_t f)
{
    return faces->start[f + 1] - faces->start[f];
}

/* ---- the arrays ------------------------------------------------------------------------------------------------ */

/* Which of a scene's vertices and faces have the same numbers as in the mesh. */
typedef struct kept_numbers {
    bool vertices, faces;
} kept_numbers;

/* Allocates the arrays that the scene does not have yet, by its counts of solids, vertices, faces and corners. Numbers
 * that are kept need no array; edges come later. False: no memory; then call roberts_scene_free(). */
bool scene_alloc_arrays(roberts_scene *scene, kept_numbers kept);

/* Sets the scene's box, its centre and its unit. */
void scene_set_box(roberts_scene *scene, roberts_vec3 lo, roberts_vec3 hi);

/* Reverses the corners of face f; the first one keeps its place. */
void scene_turn_face(roberts_scene *scene, uint32_t f);

/* Restores the order of corners in an array that the mesh has lent. */
void scene_turn_back(roberts_scene *scene);

/* Frees all arrays and leaves an empty scene. Lent arrays are not freed, but left as the mesh had them. */
void scene_clear(roberts_scene *scene);

/* Copies the corners of all faces listed in scene->face_number. They remain vertex numbers of the mesh. */
void scene_copy_corners(roberts_scene *scene, const polygons *faces);

/* Allocates the scene's arrays and fills them with solids 0 .. solid_count - 1. Face f belongs to solid of[f]
 * (ROBERTS_NONE: to none). A vertex used by several solids is copied for each. As after components_lay_out(), there are
 * no planes and no edges, and corners are in the order of the file. False: no memory, or too many vertices for 32
 * bits. */
bool scene_lay_out(roberts_scene *scene, const polygons *faces, const uint32_t *of, uint32_t solid_count,
                   const roberts_vec3 *point);

#endif
