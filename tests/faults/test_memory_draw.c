/* test_memory_draw.c - saving with each allocation of ours failing in turn: a status, no crash, no leak, the old file
 * unchanged and nothing beside it. (Cairo's own allocations are not reached from here.) */
#include <stdio.h>
#include <unistd.h>

#include "build_scene.h"
#include "drawing.h"
#include "memory.h"
#include "temporary.h"
#include "testing.h"

/* A scene with vertices whose distance is seen in true length. */
static roberts_scene *tetrahedron(void)
{
    static const char text[] = "OFF 4 4 6  0 0 0  9 0 0  0 9 0  0 0 9\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3";
    return scene_of_text(text);
}

static void saving_survives(roberts_format format, bool sheet, roberts_grouping grouping)
{
    /* some that coincide, in all classes: every step from segments to strokes has something to do */
    roberts_segment some[] = {line_at(ROBERTS_OUTLINE, 0, 0, 9, 9), line_at(ROBERTS_CREASE, 3, 3, 6, 6),
                              line_at(ROBERTS_OUTLINE, 9, 9, 0, 9), line_at(ROBERTS_CREASE, 5, 0, 9, 0),
                              line_at(ROBERTS_BACK, 1, 5, 8, 5),    line_at(ROBERTS_BACK, 1, 6, 8, 6)};
    roberts_region region = {.ring_count = 1, .normal = {0.6, 0.0, 0.8}};
    size_t start[2] = {0, 4};
    roberts_vec2 corner[4] = {{0, 0}, {9, 0}, {9, 9}, {0, 9}};
    const roberts_region_list regions = {1, 1, 4, &region, start, corner, NULL, false};
    roberts_drawing drawing = {.count = 6, .segment = some, .regions = &regions};
    roberts_draw_options options = roberts_draw_options_default();
    some[1].z0 = some[1].z1 = 1.0;
    some[4].state = some[5].state = ROBERTS_HIDDEN;
    options.hidden = ROBERTS_HIDDEN_DASHED;
    options.real_dashes = true;
    options.frame.off = false;
    options.lettering.labels = ROBERTS_LABEL_VERTICES | ROBERTS_LABEL_EDGES;
    options.lettering.native = format == ROBERTS_PDF;
    options.lettering.title = "A title that does not fit into one line";
    options.lettering.overall = true;
    const roberts_distance distance = {0, 1};
    roberts_scene *scene = sheet && grouping == ROBERTS_GROUP_CLASS ? tetrahedron() : NULL;
    options.scene = scene;
    options.lettering.distance = &distance;
    options.lettering.distance_count = scene ? 1 : 0;
    options.hatching.on = true;
    options.hatching.spacing_mm = 10.0;
    roberts_sheet both = {.view = {&drawing, &drawing}};
    drawing.window_max = (roberts_vec2){9, 9};
    size_t before = memory_blocks, failures = 0;
    options.format = format;
    options.grouping = grouping;
    for (size_t n = 1;; n++) {
        roberts_error error = {0};
        memory_fail(n);
        roberts_status status = sheet ? roberts_sheet_save(&both, &options, "link", &error)
                                      : roberts_drawing_save(&drawing, &options, "link", &error);
        assert_int_equal(entries(".", false), 2);
        if (!memory_try_failed(status, &error, before))
            break;
        failures++;
        assert_string_equal(error.file, "link");
    }
    assert_true(failures >= 4); /* the name, the link's target, the temporary name, the buffer */
    roberts_scene_free(scene);
}

static void saving(void **state)
{
    (void)state;
    assert_int_equal(chdir(temporary), 0);
    assert_int_equal(symlink("file", "link"), 0);
    FILE *file = fopen("file", "w");
    assert_non_null(file);
    fclose(file);
    for (int format = ROBERTS_SVG; format < ROBERTS_NULL; format++)
        saving_survives((roberts_format)format, false, ROBERTS_GROUP_CLASS);
    for (int format = ROBERTS_SVG; format < ROBERTS_CSV; format++)
        saving_survives((roberts_format)format, true, ROBERTS_GROUP_CLASS);
    for (int grouping = ROBERTS_GROUP_BODY; grouping <= ROBERTS_GROUP_ELEMENT; grouping++) {
        saving_survives(ROBERTS_SVG, false, (roberts_grouping)grouping);
        saving_survives(ROBERTS_SVG, true, (roberts_grouping)grouping);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test_setup_teardown(saving, temporary_make, temporary_remove)};
    return cmocka_run_group_tests_name("memory, draw", tests, NULL, NULL);
}
