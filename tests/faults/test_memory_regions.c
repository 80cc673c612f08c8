/* test_memory_regions.c - finding and saving visible regions with each allocation of ours failing in turn: a status, no
 * crash, no leak. */

#include "build_scene.h"
#include "memory.h"
#include "roberts.h"
#include "testing.h"

/* Pyramids side by side and over one another, so that all steps have something to do: lines that cross, several groups
 * of lines, holes. */
static roberts_scene *make_scene(void)
{
    static const unsigned char faces[] = {4, 3, 2, 1, 0, 3, 0, 1, 4, 3, 1, 2, 4, 3, 2, 3, 4, 3, 3, 0, 4, 0};
    static const double place[4][4] = {{0, 0, 0, 4}, {0, 0, 5, 1}, {20, 3, 0, 2}, {2, 2, 0, 4}}; /* x, y, z, size */
    roberts_mesh mesh = {0};
    for (uint32_t i = 0; i < 4; i++) {
        const double *p = place[i], s = p[3];
        const roberts_vec3 corner[5] = {{p[0] - s, p[1] - s, p[2]},
                                        {p[0] + s, p[1] - s, p[2]},
                                        {p[0] + s, p[1] + s, p[2]},
                                        {p[0] - s, p[1] + s, p[2]},
                                        {p[0], p[1], p[2] + s}};
        mesh_solid(&mesh, corner, 5, faces);
    }
    return build_scene(&mesh);
}

static bool merges; /* are neighbours in one plane merged? */
static bool lines;  /* are lines found too, so few that the edges that are left out are hidden afterwards? */

static void survives(const roberts_camera *camera, size_t least)
{
    roberts_scene *scene = make_scene();
    roberts_hide_options options = roberts_hide_options_default();
    options.threads = 1;
    options.merge_regions = merges;
    options.crease_degrees = lines ? 100 : options.crease_degrees;
    size_t before = memory_blocks, failures = 0;
    for (size_t n = 1;; n++) {
        roberts_error error = {0};
        roberts_region_list regions;
        roberts_drawing drawing = {0};
        memory_fail(n);
        roberts_status status = lines ? roberts_hide_with_regions(scene, camera, &options, &drawing, &regions, &error)
                                      : roberts_regions(scene, camera, &options, &regions, &error);
        if (status == ROBERTS_OK)
            status = roberts_regions_save(&regions, NULL, "/dev/null", &error);
        roberts_regions_free(&regions);
        roberts_drawing_free(&drawing);
        if (!memory_try_failed(status, &error, before))
            break;
        failures++;
    }
    assert_true(failures >= least);
    roberts_scene_free(scene);
}

/* A drawing with fills in each format that has them. */
static void test_fills(void **state)
{
    static const roberts_format formats[] = {ROBERTS_SVG, ROBERTS_PDF, ROBERTS_PNG, ROBERTS_TIKZ};
    roberts_scene *scene = make_scene();
    roberts_camera camera = {.projection = ROBERTS_PERSPECTIVE,
                             .eye = {-30, 9, 24.5},
                             .look_at = {20, 3, 0},
                             .has_look_at = true,
                             .fov_degrees = 20};
    roberts_region_list regions;
    roberts_draw_options options = roberts_draw_options_default();
    (void)state;
    roberts_drawing drawing = drawing_of(scene, &camera, NULL);
    assert_int_equal(roberts_regions(scene, &camera, NULL, &regions, NULL), ROBERTS_OK);
    assert_true(drawing.framed && regions.count > 3);
    drawing.regions = &regions;
    options.fill = ROBERTS_FILL_BODY;
    options.shaded = true;
    options.dpi = 20;
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++) {
        size_t before = memory_blocks, failures = 0;
        options.format = formats[i];
        for (size_t n = 1;; n++) {
            roberts_error error = {0};
            memory_fail(n);
            roberts_status status = roberts_drawing_save(&drawing, &options, "/dev/null", &error);
            if (!memory_try_failed(status, &error, before))
                break;
            failures++;
        }
        assert_true(failures >= 20);
    }
    roberts_drawing_free(&drawing);
    roberts_regions_free(&regions);
    roberts_scene_free(scene);
}

static void test_merged(void **state)
{
    (void)state;
    merges = true;
    survives(&(roberts_camera){.dir = {0.1, 0.2, 1}}, 60);
    merges = false;
}

static void test_from_above(void **state)
{
    (void)state;
    survives(&(roberts_camera){.dir = {0.1, 0.2, 1}}, 60);
}

static void test_with_lines(void **state)
{
    (void)state;
    lines = true;
    survives(&(roberts_camera){.dir = {0.1, 0.2, 1}}, 60);
    survives(&(roberts_camera){.projection = ROBERTS_PERSPECTIVE,
                               .eye = {-3, 0, 4.5},
                               .look_at = {20, 3, 0},
                               .has_look_at = true,
                               .near_distance = 4},
             60);
    lines = false;
}

static void test_near_plane(void **state)
{
    (void)state;
    survives(&(roberts_camera){.projection = ROBERTS_PERSPECTIVE,
                               .eye = {-3, 0, 4.5},
                               .look_at = {20, 3, 0},
                               .has_look_at = true,
                               .near_distance = 4},
             60);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_from_above), cmocka_unit_test(test_fills),
                                       cmocka_unit_test(test_merged), cmocka_unit_test(test_with_lines),
                                       cmocka_unit_test(test_near_plane)};
    return cmocka_run_group_tests_name("memory, regions", tests, NULL, NULL);
}
