/* test_memory_covers.c - hiding bodies over one another, and a sheet folded many times, with each allocation of ours
 * failing in turn: a status, no crash, no leak. */
#include "memory.h"
#include "patches.h"
#include "roberts.h"

/* Sheets over one another, of which the lower ones are hidden. */
static void add_pile(sheet *s, rng *r)
{
    for (int k = 0; k < 6; k++)
        add_patch(s, &(patch){.z = -2.0 * k, .step = 1 - 0.1 * k, .rough = 0.1, .nx = 8, .ny = 8}, r);
}

static void hiding_survives(sheet *s, const roberts_camera *camera)
{
    roberts_scene *scene = scene_of_mesh(&s->mesh, NULL);
    roberts_hide_options options = roberts_hide_options_default();
    options.threads = 1;
    options.grid = 16; /* no warped cells, which are given up without a word if there is no memory for them */
    roberts_mesh_free(&s->mesh);
    size_t before = memory_blocks, failures = 0;
    for (size_t n = 1;; n++, failures++) {
        roberts_error error = {0};
        roberts_drawing drawing = {0};
        memory_fail(n);
        roberts_status status = roberts_hide(scene, camera, &options, &drawing, &error);
        roberts_drawing_free(&drawing);
        if (!memory_try_failed(status, &error, before))
            break;
    }
    assert_true(failures > 30);
    roberts_scene_free(scene);
}

static void hiding(void **state)
{
    const roberts_camera cameras[] = {{.dir = {0.1, 0.2, 1}},
                                      {.projection = ROBERTS_PERSPECTIVE, .eye = {1, 2, 3}, .near_distance = 3.1}};
    (void)state;
    for (int i = 0; i < 2; i++) {
        rng r = {7};
        sheet pile = {0}, pleats = {0};
        add_pile(&pile, &r);
        hiding_survives(&pile, &cameras[i]);
        add_pleats(&pleats, 9, 6, &r);
        hiding_survives(&pleats, &cameras[i]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(hiding)};
    return cmocka_run_group_tests_name("memory of covers", tests, NULL, NULL);
}
