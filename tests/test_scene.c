/* Solids from polygons: components, planes, edges, checks. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "model/scene.h"

static const roberts_vec3 cube_point[8] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0},
                                           {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}};
static const uint32_t cube_corner[24] = {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
static const uint32_t cube_start[7] = {0, 4, 8, 12, 16, 20, 24};

static void cube_builds(void **state)
{
    roberts_mesh mesh = {0};
    roberts_scene *scene;
    roberts_error error = {0};
    (void)state;
    mesh.vertex_count = 8;
    mesh.face_count = 6;
    mesh.corner_count = 24;
    mesh.vertex = (roberts_vec3 *)(uintptr_t)cube_point;
    mesh.face_start = (uint32_t *)(uintptr_t)cube_start;
    mesh.corner = (uint32_t *)(uintptr_t)cube_corner;
    assert_int_equal(roberts_scene_build(&mesh, NULL, &scene, &error), ROBERTS_OK);
    assert_int_equal(roberts_scene_solid_count(scene), 1);
    assert_int_equal(roberts_scene_edge_count(scene), 12);
    for (uint32_t f = 0; f < 6; f++) {
        plane F = scene->face_plane[f];
        assert_true(fabs(F.a) + fabs(F.b) + fabs(F.c) == 1.0 && F.d == 1.0);
        assert_true(scene->face_deviation[f] == 0.0);
    }
    roberts_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(cube_builds)};
    return cmocka_run_group_tests_name("scene", tests, NULL, NULL);
}
