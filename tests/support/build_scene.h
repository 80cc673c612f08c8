/* build_scene.h - scenes of meshes, files and texts, and drawings of scenes. The test fails if anything is refused. */
#ifndef ROBERTS_TESTS_BUILD_SCENE_H
#define ROBERTS_TESTS_BUILD_SCENE_H

#include "make_mesh.h"

static inline roberts_scene *scene_of_mesh(const roberts_mesh *mesh, const roberts_scene_options *options)
{
    roberts_scene *scene = NULL;
    roberts_error error = {0};
    if (roberts_scene_build(mesh, options, &scene, &error) != ROBERTS_OK)
        fail_msg("scene refused: %s", error.message);
    return scene;
}

/* Builds the scene of a mesh, and frees the mesh. */
static inline roberts_scene *build_scene(roberts_mesh *mesh)
{
    roberts_scene *scene = scene_of_mesh(mesh, NULL);
    roberts_mesh_free(mesh);
    return scene;
}

static inline roberts_scene *scene_of_file(const char *path)
{
    roberts_mesh mesh = mesh_of_file(path);
    return build_scene(&mesh);
}

static inline roberts_scene *scene_of_text(const char *text)
{
    roberts_mesh mesh = mesh_of_text(text);
    return build_scene(&mesh);
}

static inline roberts_camera preset_camera(const char *name)
{
    roberts_camera camera = {0};
    assert_true(roberts_camera_preset(name, &camera));
    return camera;
}

static inline roberts_drawing drawing_of(const roberts_scene *scene, const roberts_camera *camera,
                                         const roberts_hide_options *options)
{
    roberts_drawing drawing = {0};
    roberts_error error = {0};
    if (roberts_hide(scene, camera, options, &drawing, &error) != ROBERTS_OK)
        fail_msg("drawing refused: %s", error.message);
    return drawing;
}

#endif
