/* The report of --verify on a wrong drawing. The program never makes one, so its function is called with a spoiled
 * drawing. */
#include <stdio.h>
#include <string.h>

#include "build_scene.h"
#include "cli/report.h"
#include "testing.h"

/* A cube of side 2 under a plate that hides all of it from above. */
static roberts_scene *make_scene(void)
{
    static const char off[] = "OFF\n16 12 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 2\n2 0 2\n2 2 2\n0 2 2\n"
                              "-1 -1 3\n3 -1 3\n3 3 3\n-1 3 3\n-1 -1 4\n3 -1 4\n3 3 4\n-1 3 4\n"
                              "4 0 1 2 3\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n"
                              "4 8 9 10 11\n4 12 13 14 15\n4 8 9 13 12\n4 9 10 14 13\n4 10 11 15 14\n4 11 8 12 15\n";
    return scene_of_text(off);
}

/* Verifies, and stores the messages in `text`. */
static bool report(const cli_options *options, const roberts_drawing *drawing, char *text, size_t size)
{
    roberts_verification found = {0};
    roberts_scene *scene = make_scene();
    FILE *file = tmpfile();
    assert_non_null(file);
    cli_options own = *options;
    own.log = file;
    roberts_status status = report_verify(&own, scene, drawing, &found, NULL);
    rewind(file);
    text[fread(text, 1, size - 1, file)] = '\0';
    fclose(file);
    roberts_scene_free(scene);
    assert_int_equal(status, ROBERTS_OK);
    assert_true(found.segments >= drawing->count && found.points >= found.segments);
    return found.contradictions > 0;
}

static roberts_segment row(uint32_t solid, uint32_t v0, uint32_t v1)
{
    return (roberts_segment){.solid = solid, .v0 = v0, .v1 = v1, .t1 = 1.0, .by = ROBERTS_NONE};
}

static void test_report(void **state)
{
    char text[8192];
    cli_options options = {.verify_rays = 1, .quiet = true};
    roberts_camera_preset("top", &options.camera);
    roberts_segment rows[] = {row(1, 12, 13), row(1, 12, 15), row(1, 13, 14), row(1, 14, 15), row(0, 4, 5)};
    roberts_drawing drawing = {.segment = rows, .count = 4};
    (void)state;
    assert_false(report(&options, &drawing, text, sizeof text));
    assert_string_equal(text, "roberts: verify: 12 points of 8 segments checked, visible and hidden, drawn "
                              "or not; contradictions: 0, undecided: 0\n");
    drawing.count = 5;
    assert_true(report(&options, &drawing, text, sizeof text));
    assert_string_equal(text, "roberts: verify: body 0, edge 4-5, t = 0.5: drawn visible, but body 1 hides it\n"
                              "roberts: verify: 12 points of 8 segments checked, visible and hidden, drawn "
                              "or not; contradictions: 1, undecided: 0\n");
    rows[4].state = ROBERTS_HIDDEN; /* behind the plate, but it is drawn as hidden by the cube */
    rows[4].by = 0;
    assert_true(report(&options, &drawing, text, sizeof text));
    assert_string_equal(text,
                        "roberts: verify: body 0, edge 4-5, t = 0.5: drawn hidden, but it is body 1 that hides it, "
                        "not body 0\n"
                        "roberts: verify: 13 points of 8 segments checked, visible and hidden, drawn or not; "
                        "contradictions: 1, undecided: 0\n");
    rows[0].state = ROBERTS_HIDDEN;
    drawing.count = 4;
    assert_true(report(&options, &drawing, text, sizeof text));
    assert_int_equal(strncmp(text, "roberts: verify: body 1, edge 12-13, t = ", 41), 0);
    assert_non_null(strstr(text, ": drawn hidden, but nothing hides it\n"
                                 "roberts: verify: body 1, edge 12-13, t = 0.5: drawn hidden, but nothing hides it\n"
                                 "roberts: verify: 14 points of 8 segments checked, visible and hidden, drawn or not; "
                                 "contradictions: 2, undecided: 0\n"));
    options.label = "turn-3.svg"; /* one of several pictures */
    assert_true(report(&options, &drawing, text, sizeof text));
    assert_int_equal(strncmp(text, "roberts: turn-3.svg: verify: body 1, edge 12-13, t = ", 53), 0);
    assert_non_null(strstr(text, "\nroberts: turn-3.svg: verify: 14 points of 8 segments checked, "));
    options.label = NULL;
    options.verify_rays = 40;
    assert_true(report(&options, &drawing, text, sizeof text));
    assert_non_null(strstr(text, "roberts: verify: ... and 19 more\n")); /* 38 rays amid the edge, and one that walks */
    options.camera = (roberts_camera){.projection = ROBERTS_PERSPECTIVE, .eye = {1, 1, 20}, .near_distance = 16.5};
    options.verify_rays = 1; /* the near plane cuts the plate in the middle of its sides, and removes everything else */
    rows[0] = row(1, 8, 12);
    drawing.count = 1;
    assert_true(report(&options, &drawing, text, sizeof text));
    assert_non_null(strstr(text, ", edge 8-12, t = 1: drawn visible, but the near plane cuts it off\n"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_report)};
    return cmocka_run_group_tests_name("verify_report", tests, NULL, NULL);
}
