/* test_unite.c - solids that several others hide only together: culled where nothing of them shows, and nowhere else. */
#include <stdio.h>

#include "hide/unite.h"
#include "scenes.h"

static const roberts_camera top = {.dir = {0, 0, 1}, .up = {0, 1, 0}};

enum { BEHIND = 160 };

/* Boxes above; below them a heap of plates from (0, 0) to (4, 4), of which all are culled, or none but those behind the
 * first. */
static const struct cover_case {
    const char *name;
    double box[3][4]; /* x0, y0, x1, y1 */
    unsigned boxes;
    bool hidden;
} cases[] = {
    {"one box", {{0, 0, 4, 4}}, 1, true},
    {"two that overlap", {{0, 0, 2.1, 4}, {1.9, 0, 4, 4}}, 2, true},
    {"two that overlap and stick out", {{-1, -1, 2.1, 5}, {1.9, -1, 5, 5}}, 2, true},
    {"two side by side", {{0, 0, 2, 4}, {2, 0, 4, 4}}, 2, true},
    {"two with less than epsilon between them", {{0, 0, 2, 4}, {2 + 1e-13, 0, 4, 4}}, 2, true},
    {"two with a gap", {{0, 0, 2, 4}, {2.001, 0, 4, 4}}, 2, false},
    {"two with a narrow gap", {{0, 0, 2, 4}, {2 + 1e-7, 0, 4, 4}}, 2, false},
    {"two that leave a narrow border", {{0, 0, 2.1, 4}, {1.9, 0, 4, 4 - 1e-7}}, 2, false},
    {"two that leave a corner", {{0, 0, 4, 3}, {0, 2.9, 3.999, 4}}, 2, false},
    {"three in a row", {{0, 0, 1.5, 4}, {1.4, 0, 3, 4}, {2.9, 0, 4, 4}}, 3, true},
    {"three that leave a hole in the middle", {{0, 0, 2, 4}, {2.001, 0, 4, 1.9}, {2.001, 2.1, 4, 4}}, 3, false},
};

static void covers_together(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        model m = {0};
        hide_picture picture;
        for (unsigned k = 0; k < cases[i].boxes; k++) {
            const double *b = cases[i].box[k];
            model_box(&m, (roberts_vec3){b[0], b[1], 0}, (roberts_vec3){b[2], b[3], 1 + k});
        }
        for (int k = 1; k <= BEHIND; k++)
            model_box(&m, (roberts_vec3){0, 0, -k - 0.5}, (roberts_vec3){4, 4, -k});
        roberts_scene *scene = model_build(&m);
        assert_int_equal(hide_picture_build(&picture, scene, &top, 0.0, true, 1, NULL), ROBERTS_OK);
        assert_non_null(picture.cover.rest);
        if (picture.culled_count != (cases[i].hidden ? BEHIND : BEHIND - 1))
            fail_msg("%s: %zu culled", cases[i].name, picture.culled_count);
        hide_picture_free(&picture);
        roberts_scene_free(scene);
        model_free(&m);
    }
}

/* Turned boxes over one another, bars across one another, and solids with integer corners, most of them hidden. */
static void fill(model *m, int kind, uint64_t seed)
{
    rng r = {seed};
    if (kind == 2) {
        model_crowd(m, 600, 3, seed);
        return;
    }
    for (int i = 0; i < 300; i++) {
        double turn = rng_between(&r, 0, 7), c = cos(turn), s = sin(turn);
        double u = kind ? 4 : rng_between(&r, 0.5, 1), v = kind ? 1 : rng_between(&r, 0.5, 1);
        mat3 map = {{u * c, u * s, 0}, {-v * s, v * c, 0}, {0, 0, 0.2}};
        roberts_vec3 at = {kind ? rng_between(&r, -2, 2) : 0, kind ? rng_between(&r, -2, 2) : 0, 0.5 * i};
        model_add(m, &shapes[0], map, at);
    }
}

static void same_as_without(void **state)
{
    static const struct {
        roberts_camera camera;
        bool together;
    } cameras[] = {{{.dir = {0, 0, 1}, .up = {0, 1, 0}}, true},
                   {{.dir = {0.02, 0.01, 1}}, true},
                   {{ROBERTS_PERSPECTIVE, .eye = {1, -2, 900}}, true},
                   {{.dir = {1, 2, 3}}, false}};
    size_t scenes = 0;
    (void)state;
    for (int kind = 0; kind < 3; kind++)
        for (size_t k = 0; k < sizeof cameras / sizeof cameras[0]; k++)
            for (uint64_t seed = 1; seed <= 3; seed++) {
                model m = {0};
                fill(&m, kind, seed);
                hide_picture picture;
                roberts_scene *scene = model_build(&m);
                assert_int_equal(hide_picture_build(&picture, scene, &cameras[k].camera, 0.0, true, 1, NULL),
                                 ROBERTS_OK);
                if (kind < 2 && cameras[k].together && picture.culled_count < 50)
                    fail_msg("kind %d, camera %zu: only %zu culled", kind, k, picture.culled_count);
                scenes += picture.cover.rest != NULL;
                hide_picture_free(&picture);
                roberts_scene_free(scene);

                roberts_hide_options options = roberts_hide_options_default();
                roberts_drawing with = model_draw(&m, &cameras[k].camera, &options);
                options.keep_hidden = true;
                roberts_drawing all = model_draw(&m, &cameras[k].camera, &options);
                size_t at = 0;
                for (size_t i = 0; i < all.count; i++) {
                    const roberts_segment *a = &all.segment[i], *b = &with.segment[at];
                    if (a->state != ROBERTS_VISIBLE)
                        continue;
                    if (at++ == with.count || a->solid != b->solid || a->v0 != b->v0 || a->v1 != b->v1 ||
                        a->t0 != b->t0 || a->t1 != b->t1)
                        fail_msg("kind %d, camera %zu, seed %d: edge %u-%u of solid %u, from %.17g to %.17g", kind, k,
                                 (int)seed, a->v0, a->v1, a->solid, a->t0, a->t1);
                }
                assert_int_equal(at, with.count);
                roberts_drawing_free(&with);
                roberts_drawing_free(&all);
                model_free(&m);
            }
    assert_true(scenes > 20);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(covers_together), cmocka_unit_test(same_as_without)};
    return cmocka_run_group_tests_name("unite", tests, NULL, NULL);
}
