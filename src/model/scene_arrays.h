/* scene_arrays.h - the scene's arrays: memory, and the compact numbering solid by solid. */
#ifndef ROBERTS_MODEL_SCENE_ARRAYS_H
#define ROBERTS_MODEL_SCENE_ARRAYS_H

#include "model/components.h"
#include "model/scene.h"

/* What the vertices and faces of a scene keep of the mesh's numbering. */
typedef struct kept_numbers {
    bool vertices, faces;
} kept_numbers;

/* Allocates those arrays that there are not yet, for the scene's counts of solids, vertices, faces and corners; none for
 * numbers that are kept, and none for edges. False: no memory; roberts_scene_free() releases what there is. */
bool scene_alloc_arrays(roberts_scene *scene, kept_numbers kept);

/* Sets the scene's box, and what follows from it. */
void scene_set_box(roberts_scene *scene, roberts_vec3 lo, roberts_vec3 hi);

/* Turns the corners of face f round, the first one keeping its place. */
void scene_turn_face(roberts_scene *scene, uint32_t f);

/* Corners that are lent run as in the mesh again. */
void scene_turn_back(roberts_scene *scene);

/* Releases all arrays but those lent, which are left as the mesh had them, and leaves an empty scene. */
void scene_clear(roberts_scene *scene);

/* Copies the corners of all faces, of which scene->face_number tells the numbers; they stay vertex numbers of the mesh. */
void scene_copy_corners(roberts_scene *scene, const polygons *faces);

/* Allocates the scene's arrays and lays out solids 0 .. solid_count - 1, face f belonging to solid of[f] (ROBERTS_NONE:
 * to none). A vertex that several solids use is copied for each. As components_lay_out() leaves it: no planes, no edges,
 * corners in the order of the file. False: no memory, or more vertices than 32 bits count. */
bool scene_lay_out(roberts_scene *scene, const polygons *faces, const uint32_t *of, uint32_t solid_count,
                   const roberts_vec3 *point);

#endif
