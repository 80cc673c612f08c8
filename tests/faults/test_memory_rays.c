/* test_memory_rays.c - checking and picking with each allocation failing in turn: a status, no crash, no leak. */

#include "build_scene.h"
#include "memory.h"
#include "roberts.h"
#include "testing.h"

/* Twelve overlapping octahedra; from the near eye some are cut. `open`: each lacks one face. */
static roberts_scene *make_scene(bool open)
{
    static const unsigned char faces[] = {3, 0, 2, 4, 3, 2, 1, 4, 3, 1, 3, 4, 3, 3, 0, 4, 3,
                                          2, 0, 5, 3, 1, 2, 5, 3, 3, 1, 5, 3, 0, 3, 5, 0};
    static const unsigned char open_faces[] = {3, 0, 2, 4, 3, 2, 1, 4, 3, 1, 3, 4, 3, 3, 0,
                                               4, 3, 2, 0, 5, 3, 1, 2, 5, 3, 3, 1, 5, 0};
    roberts_mesh mesh = {0};
    for (uint32_t i = 0; i < 12; i++) {
        double x = 0.7 * (i % 4), y = 0.6 * (i / 4), z = 0.3 * i;
        const roberts_vec3 point[6] = {{x + 1, y, z}, {x - 1, y, z}, {x, y + 1, z},
                                       {x, y - 1, z}, {x, y, z + 1}, {x, y, z - 1}};
        mesh_solid(&mesh, point, 6, open ? open_faces : faces);
    }
    return build_scene(&mesh);
}

static const roberts_camera cameras[] = {
    {.dir = {3, -6, 4}},
    {.projection = ROBERTS_PERSPECTIVE, .eye = {1, -2, 2}, .near_distance = 1.5},
};

static void verifying(void **state)
{
    (void)state;
    for (size_t i = 0; i < 4; i++) {
        roberts_scene *scene = make_scene(i >= 2);
        const roberts_camera *camera = &cameras[i % 2];
        size_t failures = 0;
        roberts_drawing drawing = drawing_of(scene, camera, NULL);
        for (size_t k = 0; k < drawing.count; k++)
            drawing.segment[k].state = ROBERTS_HIDDEN; /* wrong everywhere: the contradictions take memory too */
        size_t before = memory_blocks;
        for (size_t n = 1;; n++) {
            roberts_verify_options options = roberts_verify_options_default();
            roberts_verification found;
            roberts_error error = {0};
            options.threads = 1;
            memory_fail(n);
            roberts_status status = roberts_verify(scene, camera, &drawing, &options, &found, &error);
            if (!memory_try_failed(status, &error, before)) {
                assert_true(found.contradictions > 50);
                break;
            }
            assert_true(found.contradictions == 0);
            failures++;
        }
        assert_true(failures > 10);
        roberts_drawing_free(&drawing);
        roberts_scene_free(scene);
    }
}

static void picking(void **state)
{
    (void)state;
    for (size_t i = 0; i < 4; i++) {
        roberts_scene *scene = make_scene(i >= 2);
        size_t before = memory_blocks, failures = 0;
        for (size_t n = 1;; n++) {
            roberts_picked picked;
            roberts_error error = {0};
            memory_fail(n);
            roberts_status status = roberts_pick(scene, &cameras[i % 2], 0.1, 0.1, &picked, &error);
            size_t count = picked.count;
            roberts_picked_free(&picked);
            bool failed = memory_try_failed(status, &error, before);
            assert_int_equal(count > 0, !failed);
            if (!failed)
                break;
            failures++;
        }
        assert_true(failures >= 3);
        roberts_scene_free(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(verifying), cmocka_unit_test(picking)};
    return cmocka_run_group_tests_name("memory_rays", tests, NULL, NULL);
}
