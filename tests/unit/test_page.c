/* The page: a fitted drawing lies within the margins, fills them in one direction, is centred and upright. */
#include <float.h>
#include <math.h>

#include "draw/page.h"
#include "draw/strokes.h"
#include "build_scene.h"
#include "drawing.h"
#include "rng.h"
#include "testing.h"

static const roberts_page a4 = {210.0, 297.0, 10.0};

static const struct {
    const char *name;
    roberts_page page;
    roberts_vec2 min, max;
    roberts_vec2 p, on_page; /* a point and its place on the page */
} fit_cases[] = {
    {"wide: left edge on the margin", {210, 297, 10}, {0, 0}, {19, 1}, {0, 0.5}, {10, 148.5}},
    {"wide: right edge on the margin", {210, 297, 10}, {0, 0}, {19, 1}, {19, 0.5}, {200, 148.5}},
    {"y up becomes y down", {210, 297, 10}, {0, 0}, {19, 1}, {9.5, 1}, {105, 143.5}},
    {"tall: top on the margin", {210, 297, 10}, {-1, -100}, {1, 177}, {0, 177}, {105, 10}},
    {"tall: bottom on the margin", {210, 297, 10}, {-1, -100}, {1, 177}, {-1, -100}, {104, 287}},
    {"exactly in proportion", {210, 297, 10}, {0, 0}, {1.9, 2.77}, {1.9, 2.77}, {200, 10}},
    {"no margin", {100, 100, 0}, {0, 0}, {1, 1}, {1, 1}, {100, 0}},
    {"lying page", {297, 210, 10}, {0, 0}, {2, 1}, {2, 1}, {287, 35.75}},
    {"no height", {210, 297, 10}, {3, 7}, {5, 7}, {3, 7}, {10, 148.5}},
    {"no width", {210, 297, 10}, {7, 3}, {7, 5}, {7, 5}, {105, 10}},
    {"a point", {210, 297, 10}, {7, 3}, {7, 3}, {7, 3}, {105, 148.5}},
    {"a point: one mm per unit", {210, 297, 10}, {7, 3}, {7, 3}, {8, 3}, {106, 148.5}},
    {"huge", {210, 297, 10}, {-1e300, -1e299}, {1e300, 1e299}, {1e300, 0}, {200, 148.5}},
    {"as large as can be", {210, 297, 10}, {-DBL_MAX, 0}, {DBL_MAX, 1}, {-DBL_MAX, 0.5}, {10, 148.5}},
    {"tiny", {210, 297, 10}, {0, 0}, {1e-300, 1e-301}, {1e-300, 0}, {200, 158}},
    {"denormal", {210, 297, 10}, {0, 0}, {64 * 4.9406564584124654e-324, 0}, {0, 0}, {10, 148.5}},
    {"narrow beyond measure", {210, 297, 10}, {0, 0}, {1e-320, 1e300}, {0, 1e300}, {105, 10}},
};

static void fitted(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof fit_cases / sizeof fit_cases[0]; i++) {
        page_map map = page_fit(&fit_cases[i].page, fit_cases[i].min, fit_cases[i].max);
        roberts_vec2 q = page_place(&map, fit_cases[i].p);
        print_message("%s: %.17g, %.17g\n", fit_cases[i].name, q.x, q.y);
        assert_true(fabs(q.x - fit_cases[i].on_page.x) < 1e-9);
        assert_true(fabs(q.y - fit_cases[i].on_page.y) < 1e-9);
    }
}

/* For any box: corners lie within the margins, one pair of sides on them; the middle stays in the middle, and angles
 * are kept. */
static void any_box_fits(void **state)
{
    rng random = {1};
    (void)state;
    for (int i = 0; i < 20000; i++) {
        double r[4];
        for (int k = 0; k < 4; k++)
            r[k] = rng_between(&random, 0, 1);
        double size = exp((r[0] - 0.5) * 600.0), ratio = exp((r[1] - 0.5) * 20.0);
        roberts_vec2 min = {(r[2] - 0.5) * size, (r[3] - 0.5) * size}, max = {min.x + size, min.y + size * ratio};
        page_map map = page_fit(&a4, min, max);
        roberts_vec2 a = page_place(&map, min), b = page_place(&map, max);
        double slack = 1e-9; /* mm; 2^-52 of a box no farther from the origin than its size, on 300 mm */
        assert_true(a.x >= 10 - slack && b.x <= 200 + slack && b.y >= 10 - slack && a.y <= 287 + slack);
        assert_true(fmin(fabs(a.x - 10), fabs(b.y - 10)) < slack && fmin(fabs(b.x - 200), fabs(a.y - 287)) < slack);
        assert_true(fabs(a.x + b.x - 210) < slack && fabs(a.y + b.y - 297) < slack);
        double drawn = (a.y - b.y) / (b.x - a.x), wanted = (max.y - min.y) / (max.x - min.x);
        if (b.x - a.x > 1e-2 && a.y - b.y > 1e-2)
            assert_true(fabs(drawn / wanted - 1) < 1e-6);
    }
}

/* The box 0,0 .. 40,20 on A4. */
static const struct {
    const char *name;
    roberts_placement placement;
    roberts_vec2 corner; /* where 0,0 comes to lie */
    double scale;        /* mm by model unit */
    const char *refused; /* part of the message */
} lay_cases[] = {
    {"fitted", {0, 0, 0, 0, false}, {10, 196}, 4.75, NULL},
    {"fitted, the unit changes nothing", {0, 1000, 0, 0, false}, {10, 196}, 4.75, NULL},
    {"fitted, at the top", {0, 0, 0, 1, false}, {10, 105}, 4.75, NULL},
    {"fitted, at the bottom", {0, 0, 0, -1, false}, {10, 287}, 4.75, NULL},
    {"fitted, no room to move aside", {0, 0, 1, 0, false}, {10, 196}, 4.75, NULL},
    {"1:1", {1, 0, 0, 0, false}, {85, 158.5}, 1, NULL},
    {"1:1, lower left", {1, 0, -1, -1, false}, {10, 287}, 1, NULL},
    {"1:1, upper right", {1, 0, 1, 1, false}, {160, 30}, 1, NULL},
    {"1:20 of metres", {0.05, 1000, -1, -1, false}, {0, 0}, 50, "1:20 the drawing is 2000 x 1000 mm"},
    {"1:20 of metres: what would fit", {0.05, 1000, 0, 0, false}, {0, 0}, 50, "190 x 277; 1:211 would fit"},
    {"1:211 of metres",
     {1 / 211.0, 1000, 0, 0, false},
     {105 - 20000 / 211.0, 148.5 + 10000 / 211.0},
     1000 / 211.0,
     NULL},
    {"1:210 of metres", {1 / 210.0, 1000, 0, 0, false}, {0, 0}, 0, "1:211 would fit"},
    {"1:1000000", {1e-6, 1e9, 0, 0, false}, {0, 0}, 0, "at 1:1000000 the drawing is 40000 x 20000 mm"},
    {"1:1000000: what would fit", {1e-6, 1e9, 0, 0, false}, {0, 0}, 0, "; 1:211000000 would fit"},
    {"inches", {0.1, 25.4, -1, 1, false}, {10, 60.8}, 2.54, NULL},
    {"fills the page", {4.75, 1, 0, 0, false}, {10, 196}, 4.75, NULL},
    {"5:1", {5, 1, 0, 0, false}, {0, 0}, 0, "at 5:1 the drawing is 200 x 100 mm and would leave the page"},
    {"kilometres", {1e6, 1, 0, 0, false}, {0, 0}, 0, "at 1000000:1 the drawing is 40000000 x 20000000 mm"},
    {"beyond the sun",
     {1e12, 1e12, 0, 0, false},
     {0, 0},
     0,
     "1000000000000:1 the drawing is 4e+25 x 2e+25 mm and would"},
    {"5:1: what would fit", {5, 1, 0, 0, false}, {0, 0}, 0, "; 4.75:1 would fit, or --landscape"},
    {"10:1: what would fit", {10, 1, 0, 0, false}, {0, 0}, 0, "; 4.75:1 would fit, or --page a3 --landscape"},
    {"12:1: what would fit", {12, 1, 0, 0, false}, {0, 0}, 0, "; 4.75:1 would fit, or --page a2 --landscape"},
    {"100:1: what would fit", {100, 1, 0, 0, false}, {0, 0}, 0, "; 4.75:1 would fit, or a larger page"},
    {"standard: 2:1 of 4.75:1", {.standard = true}, {105 - 40, 148.5 + 20}, 2, NULL},
    {"standard: 1:500 of metres, of 1:211", {0, 1000, 0, 0, true}, {105 - 40, 148.5 + 20}, 2, NULL},
    {"standard: 5:1 fills the page", {0, 0.95, 0, 0, true}, {10, 196}, 4.75, NULL},
    {"standard: 1:2 fills the page", {0, 9.5, 0, 0, true}, {10, 196}, 4.75, NULL},
    {"standard, aligned", {0, 1e-3, -1, -1, true}, {10, 287}, 2, NULL},
    {"standard, but a scale is given", {3, 1, 0, 0, true}, {105 - 60, 148.5 + 30}, 3, NULL},
    {"negative", {-1, 1, 0, 0, false}, {0, 0}, 0, "placement"},
    {"not a number", {NAN, 1, 0, 0, false}, {0, 0}, 0, "placement"},
    {"infinite unit", {1, INFINITY, 0, 0, false}, {0, 0}, 0, "placement"},
    {"aligned beyond", {1, 1, 2, 0, false}, {0, 0}, 0, "placement"},
};

static void laid(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof lay_cases / sizeof lay_cases[0]; i++) {
        page_map map;
        roberts_error error = {0};
        bool done = page_lay(&a4, &lay_cases[i].placement, (roberts_vec2){0, 0}, (roberts_vec2){40, 20}, &map, &error);
        print_message("%s: %s\n", lay_cases[i].name, error.message);
        assert_int_equal(done, lay_cases[i].refused == NULL);
        if (done) {
            roberts_vec2 q = page_place(&map, (roberts_vec2){0, 0});
            print_message("%.17g, %.17g\n", q.x, q.y);
            assert_true(fabs(q.x - lay_cases[i].corner.x) < 1e-9 && fabs(q.y - lay_cases[i].corner.y) < 1e-9);
            assert_true(fabs(page_scale(&map) - lay_cases[i].scale) < 1e-9);
        } else {
            assert_int_equal(error.status, ROBERTS_BAD_ARGUMENT);
            assert_non_null(strstr(error.message, lay_cases[i].refused));
        }
    }
}

/* The smallest sheet that would do, as the page lies if it can. */
static void pages_instead(void **state)
{
    static const struct {
        roberts_page page;
        double width_mm, height_mm;
        const char *instead;
    } cases[] = {
        {{210, 297, 10}, 425, 362, "--page a2 --landscape"}, {{210, 297, 10}, 362, 425, "--page a2"},
        {{297, 210, 10}, 425, 362, "--page a2 --landscape"}, {{297, 210, 10}, 362, 425, "an upright --page a2"},
        {{297, 210, 10}, 210, 297, "the same page upright"}, {{210, 297, 10}, 250, 260, "--page a3"},
        {{210, 297, 10}, 900, 900, "a larger page"}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[PAGE_INSTEAD];
        page_instead(&cases[i].page, cases[i].width_mm, cases[i].height_mm, text);
        assert_string_equal(text, cases[i].instead);
    }
}

static const struct {
    const char *name;
    roberts_page page;
    bool valid;
} page_cases[] = {
    {"A4", {210, 297, 10}, true},
    {"no margin", {210, 297, 0}, true},
    {"margins leave nothing", {210, 297, 105}, false},
    {"margins leave little", {210, 297, 104.9}, true},
    {"negative margin", {210, 297, -1}, false},
    {"no width", {0, 297, 0}, false},
    {"smallest", {1, 1, 0}, true},
    {"largest", {40000, 40000, 10}, true},
    {"too large", {40001, 10, 0}, false},
    {"not a number", {NAN, 297, 10}, false},
    {"margin not a number", {210, 297, NAN}, false},
    {"infinite", {210, INFINITY, 10}, false},
};

static void pages_are_checked(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof page_cases / sizeof page_cases[0]; i++) {
        roberts_error error = {0};
        print_message("%s\n", page_cases[i].name);
        assert_int_equal(page_is_valid(&page_cases[i].page, &error), page_cases[i].valid);
        assert_int_equal(error.status, page_cases[i].valid ? ROBERTS_OK : ROBERTS_BAD_ARGUMENT);
    }
}

/* ---- strokes ---- */

static strokes made(const roberts_drawing *drawing, const roberts_draw_options *options)
{
    strokes s;
    assert_int_equal(strokes_make(&s, drawing, options, NULL), ROBERTS_OK);
    return s;
}

static size_t count_strokes(const roberts_drawing *drawing, const roberts_draw_options *options, roberts_line line)
{
    strokes s = made(drawing, options);
    size_t count = 0;
    for (int i = 0; i < LINE_CLASSES; i++)
        count += line_order[i] == line ? s.start[i + 1] - s.start[i] : 0;
    strokes_free(&s);
    return count;
}

static const struct {
    const char *name;
    roberts_state state;
    roberts_line line;
    roberts_hidden hidden;
    int drawn_as; /* -1: not */
} class_cases[] = {
    {"outline", ROBERTS_VISIBLE, ROBERTS_OUTLINE, ROBERTS_HIDDEN_NONE, ROBERTS_OUTLINE},
    {"crease", ROBERTS_VISIBLE, ROBERTS_CREASE, ROBERTS_HIDDEN_NONE, ROBERTS_CREASE},
    {"border", ROBERTS_VISIBLE, ROBERTS_BORDER, ROBERTS_HIDDEN_NONE, ROBERTS_BORDER},
    {"wire", ROBERTS_VISIBLE, ROBERTS_WIRE, ROBERTS_HIDDEN_NONE, ROBERTS_WIRE},
    {"intersection", ROBERTS_VISIBLE, ROBERTS_INTERSECTION, ROBERTS_HIDDEN_NONE, ROBERTS_INTERSECTION},
    {"hidden intersection", ROBERTS_HIDDEN, ROBERTS_INTERSECTION, ROBERTS_HIDDEN_DASHED, ROBERTS_BACK},
    {"hidden border", ROBERTS_HIDDEN, ROBERTS_BORDER, ROBERTS_HIDDEN_DASHED, ROBERTS_BACK},
    {"hidden outline, not wanted", ROBERTS_HIDDEN, ROBERTS_OUTLINE, ROBERTS_HIDDEN_NONE, -1},
    {"hidden outline, dashed", ROBERTS_HIDDEN, ROBERTS_OUTLINE, ROBERTS_HIDDEN_DASHED, ROBERTS_BACK},
    {"hidden crease, solid", ROBERTS_HIDDEN, ROBERTS_CREASE, ROBERTS_HIDDEN_SOLID, ROBERTS_BACK},
    {"back edge", ROBERTS_HIDDEN, ROBERTS_BACK, ROBERTS_HIDDEN_DASHED, ROBERTS_BACK},
    {"clipped", ROBERTS_CLIPPED, ROBERTS_OUTLINE, ROBERTS_HIDDEN_DASHED, -1},
};

static void each_class_has_its_pen(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof class_cases / sizeof class_cases[0]; i++) {
        roberts_segment segment = line_at(class_cases[i].line, 0, 0, 1, 1);
        roberts_drawing drawing = {.count = 1, .segment = &segment};
        roberts_draw_options options = roberts_draw_options_default();
        segment.state = (uint8_t)class_cases[i].state;
        options.hidden = class_cases[i].hidden;
        print_message("%s\n", class_cases[i].name);
        for (int line = ROBERTS_OUTLINE; line <= ROBERTS_INTERSECTION; line++)
            assert_int_equal(count_strokes(&drawing, &options, (roberts_line)line), line == class_cases[i].drawn_as);
        options.outline.off = options.crease.off = options.back.off = options.border.off = options.wire.off = true;
        options.intersection.off = true;
        for (int line = ROBERTS_OUTLINE; line <= ROBERTS_INTERSECTION; line++)
            assert_int_equal(count_strokes(&drawing, &options, (roberts_line)line), 0);
    }
}

/* Only lines that are drawn are fitted: the hidden line here would double the box. */
static void what_is_not_drawn_takes_no_room(void **state)
{
    roberts_segment two[] = {line_at(ROBERTS_OUTLINE, 0, 0, 1, 0), line_at(ROBERTS_BACK, 1, 0, 2, 0)};
    roberts_drawing drawing = {.count = 2, .segment = two};
    roberts_draw_options options = roberts_draw_options_default();
    (void)state;
    two[1].state = ROBERTS_HIDDEN;
    strokes without = made(&drawing, &options);
    options.hidden = ROBERTS_HIDDEN_DASHED;
    strokes with = made(&drawing, &options);
    assert_true(page_place(&without.map, (roberts_vec2){1, 0}).x == 200.0);
    assert_true(page_place(&with.map, (roberts_vec2){1, 0}).x == 105.0);
    strokes_free(&without);
    strokes_free(&with);
}

/* Edges seen end-on, and those whose ends are one place. */
static void strokes_have_length(void **state)
{
    roberts_segment some[] = {line_at(ROBERTS_OUTLINE, 0, 0, 190, 0), line_at(ROBERTS_OUTLINE, 5, 1, 5, 1),
                              line_at(ROBERTS_OUTLINE, 6, 2, 6.0001, 2), line_at(ROBERTS_OUTLINE, 7, 3, 7.003, 3)};
    roberts_drawing drawing = {.count = 4, .segment = some};
    roberts_draw_options options = roberts_draw_options_default();
    (void)state;
    assert_int_equal(count_strokes(&drawing, &options, ROBERTS_OUTLINE), 2);
    drawing = (roberts_drawing){.count = 1, .segment = some + 1};
    assert_int_equal(count_strokes(&drawing, &options, ROBERTS_OUTLINE), 0);
}

/* A cube seen from above is a square. On a cropped page of 60 x 90 mm it is drawn as on one of 60 x 60; and at 20 mm
 * for its side and with margins of 5 as on one of 30 x 30. All formats, with fills, a frame and labels in it. */
static void cropped_pages(void **state)
{
    static const struct {
        double scale, margin_mm, side_mm;
        bool frame;
    } table[] = {{0, 10, 60, false}, {0, 10, 60, true}, {0, 0, 60, false}, {10, 5, 30, false}};
    roberts_scene *scene = scene_of_file("models/platonic/cube.off");
    const roberts_camera above = preset_camera("top");
    roberts_drawing drawing = drawing_of(scene, &above, NULL);
    roberts_region_list regions;
    assert_int_equal(roberts_regions(scene, &above, NULL, &regions, NULL), ROBERTS_OK);
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++)
        for (int format = ROBERTS_SVG; format < ROBERTS_NULL; format++) {
            roberts_draw_options options = roberts_draw_options_default();
            drawing.regions = &regions;
            options.format = (roberts_format)format;
            options.frame.off = !table[i].frame;
            options.fill = ROBERTS_FILL_COLOR;
            options.lettering.labels = ROBERTS_LABEL_FACES;
            options.background.on = true;
            options.placement.scale = table[i].scale;
            options.crop = true;
            options.page = (roberts_page){60, 90, table[i].margin_mm};
            sink cropped = drawing_written(&drawing, &options);
            options.crop = false;
            options.page = (roberts_page){table[i].side_mm, table[i].side_mm, table[i].margin_mm};
            sink whole = drawing_written(&drawing, &options);
            print_message("format %d, row %zu\n", format, i);
            assert_int_equal(cropped.size, whole.size);
            assert_memory_equal(cropped.bytes, whole.bytes, whole.size);
            free(cropped.bytes);
            free(whole.bytes);
        }
    roberts_regions_free(&regions);
    roberts_drawing_free(&drawing);
    roberts_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fitted),
        cmocka_unit_test(any_box_fits),
        cmocka_unit_test(laid),
        cmocka_unit_test(pages_instead),
        cmocka_unit_test(pages_are_checked),
        cmocka_unit_test(each_class_has_its_pen),
        cmocka_unit_test(what_is_not_drawn_takes_no_room),
        cmocka_unit_test(strokes_have_length),
        cmocka_unit_test(cropped_pages),
    };
    return cmocka_run_group_tests_name("page", tests, NULL, NULL);
}
