/* A scene built in memory, drawn to an SVG file: two blocks, one on the other.
 *   cc draw_scene.c $(pkg-config --cflags --libs roberts) -o draw_scene && ./draw_scene blocks.svg */
#include <roberts.h>
#include <stdio.h>

static roberts_status add_block(roberts_mesh *mesh, roberts_vec3 low, roberts_vec3 high, roberts_error *error)
{
    static const uint32_t face[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                        {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    uint32_t first = 0;
    roberts_status status = ROBERTS_OK;
    for (int i = 0; status == ROBERTS_OK && i < 8; i++) {
        roberts_vec3 corner = {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z};
        status = roberts_mesh_add_vertex(mesh, corner, i == 0 ? &first : NULL, error);
    }
    for (int f = 0; status == ROBERTS_OK && f < 6; f++) {
        uint32_t corner[4];
        for (int k = 0; k < 4; k++)
            corner[k] = first + face[f][k];
        status = roberts_mesh_add_face(mesh, corner, 4, error);
    }
    return status;
}

int main(int argc, char **argv)
{
    roberts_mesh mesh = {0};
    roberts_scene *scene = NULL;
    roberts_drawing drawing = {0};
    roberts_error error = {0};
    roberts_camera camera;
    roberts_draw_options options = roberts_draw_options_default();
    roberts_camera_preset("iso", &camera);
    roberts_status status = add_block(&mesh, (roberts_vec3){0, 0, 0}, (roberts_vec3){4, 3, 1}, &error);
    if (status == ROBERTS_OK)
        status = add_block(&mesh, (roberts_vec3){1, 1, 1}, (roberts_vec3){2, 2, 3}, &error);
    if (status == ROBERTS_OK)
        status = roberts_scene_build(&mesh, NULL, &scene, &error);
    if (status == ROBERTS_OK)
        status = roberts_hide(scene, &camera, NULL, &drawing, &error);
    if (status == ROBERTS_OK)
        status = roberts_drawing_save(&drawing, &options, argc > 1 ? argv[1] : "blocks.svg", &error);
    if (status != ROBERTS_OK)
        fprintf(stderr, "%s\n", error.message);
    roberts_drawing_free(&drawing);
    roberts_scene_free(scene);
    roberts_mesh_free(&mesh);
    return status == ROBERTS_OK ? 0 : 1;
}
