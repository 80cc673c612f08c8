/* test_verify_time.c - checking a drawing by rays takes at most ten times as long as hiding its lines, also beside a solid
 * of very many long faces. Processor time of one thread, the least of three runs. */
#include <stdio.h>
#include <time.h>

#include "scenes.h"

enum { MOST = 10, RUNS = 3 };

static void lattice(model *m)
{
    model_lattice(m, 7, 0.7, 91);
}

static void wall(model *m)
{
    model_wall(m, 20, 20);
}

static void balls(model *m)
{
    model_balls(m, 5, 0.8, 92);
}

/* A double pyramid on 20,000 corners, and a box beside its tip. */
static void fan(model *m)
{
    enum { CORNERS = 20000 };
    for (uint32_t i = 0; i < CORNERS; i++) {
        double angle = 2 * 3.14159265358979323846 * i / CORNERS;
        model_vertex(m, (roberts_vec3){cos(angle), sin(angle), 0});
    }
    model_vertex(m, (roberts_vec3){0, 0, -1});
    model_vertex(m, (roberts_vec3){0, 0, 1});
    for (uint32_t i = 0; i < CORNERS; i++)
        for (uint32_t tip = 0; tip < 2; tip++)
            model_face(m, (uint32_t[]){i, (i + 1) % CORNERS, CORNERS + tip}, 3);
    model_close_solid(m);
    model_box(m, (roberts_vec3){0.5, 0.5, 0.5}, (roberts_vec3){0.75, 0.75, 0.75});
}

static double seconds(clock_t from)
{
    return (double)(clock() - from) / CLOCKS_PER_SEC;
}

static void verify_takes_ten_times_at_most(void **state)
{
    static const struct {
        const char *name;
        void (*make)(model *);
    } scenes[] = {{"lattice", lattice}, {"wall", wall}, {"balls", balls}, {"fan", fan}};
    (void)state;
    for (size_t i = 0; i < sizeof scenes / sizeof scenes[0]; i++)
        for (int perspective = 0; perspective < 2; perspective++) {
            model m = {0};
            roberts_camera camera = {.dir = {0.3, -0.4, 0.8}};
            roberts_hide_options hide = roberts_hide_options_default();
            roberts_verify_options verify = roberts_verify_options_default();
            double hiding = INFINITY, checking = INFINITY;
            scenes[i].make(&m);
            roberts_scene *scene = model_build(&m);
            if (perspective) {
                camera.projection = ROBERTS_PERSPECTIVE;
                camera.eye = (roberts_vec3){30, -40, 80};
            }
            hide.threads = verify.threads = 1;
            for (int run = 0; run < RUNS; run++) {
                roberts_drawing drawing;
                roberts_verification result;
                clock_t start = clock();
                assert_int_equal(roberts_hide(scene, &camera, &hide, &drawing, NULL), ROBERTS_OK);
                hiding = fmin(hiding, seconds(start));
                start = clock();
                assert_int_equal(roberts_verify(scene, &camera, &drawing, &verify, &result, NULL), ROBERTS_OK);
                checking = fmin(checking, seconds(start));
                assert_int_equal(result.contradictions, 0);
                assert_true(result.points > 1000);
                roberts_drawing_free(&drawing);
            }
            print_message("note: %s%s: hiding %.1f ms, checking %.1f times that\n", scenes[i].name,
                          perspective ? " in perspective" : "", 1e3 * hiding, checking / hiding);
            if (checking > MOST * hiding)
                fail_msg("%s: %g s to hide, %g s to check", scenes[i].name, hiding, checking);
            roberts_scene_free(scene);
            model_free(&m);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(verify_takes_ten_times_at_most)};
    return cmocka_run_group_tests_name("time of verify", tests, NULL, NULL);
}
