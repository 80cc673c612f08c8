/* mesh_families.h - families of scenes of any bodies for the mesh oracle. Coordinates are small integers, so contacts
 * and planes are exact. A family and a seed give the same scene on every machine. */
#ifndef ROBERTS_TESTS_MESH_FAMILIES_H
#define ROBERTS_TESTS_MESH_FAMILIES_H

#include "mesh_judge.h"

size_t mesh_family_count(void);
const char *mesh_family_name(size_t index);

/* Makes scene `seed` of a family; false: no memory. Release with mesh_scene_free(). */
bool mesh_family_make(size_t index, uint64_t seed, mesh_scene *scene);
void mesh_scene_free(mesh_scene *scene);

#endif
