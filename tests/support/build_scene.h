/* build_scene.h - the scene of a mesh that must not be refused. Include it after the headers of cmocka. */
#ifndef ROBERTS_TESTS_BUILD_SCENE_H
#define ROBERTS_TESTS_BUILD_SCENE_H

#include "roberts.h"

/* Builds the scene of a mesh, and frees the mesh. Fails the test if the mesh is refused. */
static inline roberts_scene *build_scene(roberts_mesh *mesh)
{
    roberts_scene *scene = NULL;
    roberts_error error = {0};
    if (roberts_scene_build(mesh, NULL, &scene, &error) != ROBERTS_OK)
        fail_msg("scene refused: %s", error.message);
    roberts_mesh_free(mesh);
    return scene;
}

#endif
