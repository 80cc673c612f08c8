/* Tables: every number is exact to the last bit, and every row is as the interface promises. */
#include <float.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/output.h"
#include "drawing.h"
#include "rng.h"
#include "testing.h"

/* ---- numbers ---- */

static const double number_cases[] = {
    1.0,
    0.1,
    0.5,
    1.0 / 3,
    2.0 / 3,
    0.3,
    100.0,
    1e-4,
    0.0001234,
    9.9999e-5,
    1e-5,
    1e-11,
    1.00001e-11,
    9.9999e-12,
    1e-12,
    5e-324,
    DBL_MIN,
    DBL_MAX,
    1e15,
    1e16,
    9999999999999998.0,
    1e17,
    1.5e17,
    99999999999999984.0,
    123456789012345678.0,
    1e22,
    4503599627370496.5,
    2.98023223876953125e-08 /* 18 digits ending in 5: a tie */,
    8.9406967163085938e-08,
    0.99999999999999989,
    9.9999999999999982,
    1e-300,
    3.0000000000000004,
    12345.678901234567,
    1e150,
};

static void check_number(double x)
{
    char ours[DECIMAL_ROOM], theirs[64];
    snprintf(theirs, sizeof theirs, "%.17g", x);
    size_t length = decimal_format(ours, x);
    assert_string_equal(ours, theirs);
    assert_int_equal(length, strlen(ours));
}

static void numbers_are_as_printf_has_them(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof number_cases / sizeof number_cases[0]; i++) {
        check_number(number_cases[i]);
        check_number(-number_cases[i]);
        check_number(nextafter(number_cases[i], 0.0));
        if (number_cases[i] < DBL_MAX)
            check_number(nextafter(number_cases[i], INFINITY));
    }
    for (int e = -40; e <= 40; e++) {
        check_number(pow(10.0, e));
        check_number(nextafter(pow(10.0, e), 0.0));
        check_number(ldexp(1.0, 2 * e));
        check_number(ldexp(3.0, 3 * e));
    }
}

static void random_numbers_are_as_printf_has_them(void **state)
{
    rng r = {1};
    (void)state;
    for (int i = 0; i < 300000; i++) {
        uint64_t bits = rng_next(&r);
        double any, usual = ldexp((double)(bits >> 11), -(int)(bits % 97)), few = (double)(bits >> 44) / 1024.0;
        memcpy(&any, &bits, sizeof any);
        if (isfinite(any))
            check_number(any);
        check_number(usual); /* 2^-97 to 2^53: the exact way and both its ends */
        check_number(few);   /* short binary fractions: ties */
    }
}

static void zero_has_no_sign(void **state)
{
    char text[DECIMAL_ROOM];
    (void)state;
    assert_int_equal(decimal_format(text, -0.0), 1);
    assert_string_equal(text, "0");
}

static const struct {
    const char *printed, *wanted;
} locale_cases[] = {
    {"1,5", "1.5"},
    {"1.5", "1.5"},
    {"-1\xd9\xab"
     "5e+30",
     "-1.5e+30"},
    {"17", "17"},
    {"2,5e-300", "2.5e-300"},
};

static void commas_become_points(void **state)
{
    char text[DECIMAL_ROOM];
    (void)state;
    for (size_t i = 0; i < sizeof locale_cases / sizeof locale_cases[0]; i++) {
        size_t length = decimal_unlocalise(text, locale_cases[i].printed);
        assert_string_equal(text, locale_cases[i].wanted);
        assert_int_equal(length, strlen(text));
    }
}

/* ---- rows ---- */

#define HEAD "body,v0,v1,t0,t1,state,x0,y0,x1,y1,by,class,f0,f1\n"

static roberts_crossing crossing = {{3, 8}, {{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}};

static roberts_segment some[] = {
    {.v1 = 1, .by = ROBERTS_NONE, .t1 = 0.5, .p0 = {0.0, -1.5}, .p1 = {1e-7, 2e20}, .line = ROBERTS_OUTLINE},
    {.v1 = 1,
     .by = 7,
     .t0 = 0.5,
     .t1 = 1.0,
     .p0 = {1e-7, 2e20},
     .p1 = {0.1, 3.0},
     .state = ROBERTS_HIDDEN,
     .line = ROBERTS_OUTLINE,
     .level = 3},
    {.solid = 4294967294u,
     .v0 = 9,
     .v1 = 10,
     .by = ROBERTS_NONE,
     .t0 = 0.25,
     .t1 = 1.0,
     .p0 = {-0.0, 1.0},
     .p1 = {1.0, 1.0},
     .state = ROBERTS_CLIPPED,
     .line = ROBERTS_CREASE},
    {.solid = 2,
     .v0 = ROBERTS_NONE,
     .v1 = ROBERTS_NONE,
     .by = ROBERTS_NONE,
     .t1 = 0.25,
     .p0 = {1.0, 2.0},
     .p1 = {3.0, 4.0},
     .z0 = 5.0,
     .z1 = 6.0,
     .line = ROBERTS_INTERSECTION},
};

static const struct {
    const char *name;
    roberts_format format;
    roberts_hidden hidden;
    size_t first, count;
    const char *wanted;
} row_cases[] = {
    {"empty", ROBERTS_CSV, ROBERTS_HIDDEN_DASHED, 0, 0, HEAD},
    {"visible rows alone", ROBERTS_CSV, ROBERTS_HIDDEN_NONE, 0, 3,
     HEAD "0,0,1,0,0.5,visible,0,-1.5,9.9999999999999995e-08,2e+20,,outline,,\n"},
    {"all rows", ROBERTS_CSV, ROBERTS_HIDDEN_DASHED, 0, 3,
     HEAD "0,0,1,0,0.5,visible,0,-1.5,9.9999999999999995e-08,2e+20,,outline,,\n"
          "0,0,1,0.5,1,hidden,9.9999999999999995e-08,2e+20,0.10000000000000001,3,7,outline,,\n"
          "4294967294,9,10,0.25,1,clipped,0,1,1,1,,crease,,\n"},
    {"solid lines are in the table too", ROBERTS_CSV, ROBERTS_HIDDEN_SOLID, 1, 1,
     HEAD "0,0,1,0.5,1,hidden,9.9999999999999995e-08,2e+20,0.10000000000000001,3,7,outline,,\n"},
    {"empty JSON", ROBERTS_JSON, ROBERTS_HIDDEN_NONE, 0, 0, "[]\n"},
    {"JSON", ROBERTS_JSON, ROBERTS_HIDDEN_DASHED, 1, 2,
     "[\n{\"body\":0,\"v0\":0,\"v1\":1,\"t0\":0.5,\"t1\":1,\"state\":\"hidden\",\"x0\":9.9999999999999995e-08,"
     "\"y0\":2e+20,\"x1\":0.10000000000000001,\"y1\":3,\"by\":7,\"class\":\"outline\",\"f0\":null,\"f1\":null},\n"
     "{\"body\":4294967294,\"v0\":9,\"v1\":10,\"t0\":0.25,\"t1\":1,\"state\":\"clipped\",\"x0\":0,\"y0\":1,"
     "\"x1\":1,\"y1\":1,\"by\":null,\"class\":\"crease\",\"f0\":null,\"f1\":null}\n]\n"},
    {"JSON, visible rows alone", ROBERTS_JSON, ROBERTS_HIDDEN_NONE, 1, 2, "[]\n"},
    {"an intersection has no vertices, but faces", ROBERTS_CSV, ROBERTS_HIDDEN_NONE, 3, 1,
     HEAD "2,,,0,0.25,visible,1,2,3,4,,intersection,3,8\n"},
    {"the same in JSON", ROBERTS_JSON, ROBERTS_HIDDEN_NONE, 3, 1,
     "[\n{\"body\":2,\"v0\":null,\"v1\":null,\"t0\":0,\"t1\":0.25,\"state\":\"visible\",\"x0\":1,\"y0\":2,"
     "\"x1\":3,\"y1\":4,\"by\":null,\"class\":\"intersection\",\"f0\":3,\"f1\":8}\n]\n"},
    {"null", ROBERTS_NULL, ROBERTS_HIDDEN_NONE, 0, 3, ""},
};

/* Additional columns, in the given order. A drawing made by hand has no scene: only an intersection has ends. */
static const struct {
    const char *name;
    roberts_format format;
    size_t first, column_count;
    roberts_column column[ROBERTS_COLUMNS + 1];
    const char *wanted; /* NULL: refused */
} column_cases[] = {
    {"depth",
     ROBERTS_CSV,
     3,
     1,
     {ROBERTS_COLUMN_DEPTH},
     ",f1,z0,z1\n2,,,0,0.25,visible,1,2,3,4,,intersection,3,8,5,6\n"},
    {"depth, name, ends",
     ROBERTS_CSV,
     3,
     3,
     {ROBERTS_COLUMN_DEPTH, ROBERTS_COLUMN_NAME, ROBERTS_COLUMN_ENDS},
     ",f1,z0,z1,name,X0,Y0,Z0,X1,Y1,Z1\n2,,,0,0.25,visible,1,2,3,4,,intersection,3,8,5,6,,0,0,0,0,0,0.25\n"},
    {"level", ROBERTS_CSV, 1, 1, {ROBERTS_COLUMN_LEVEL}, ",outline,,,3\n"},
    {"no ends", ROBERTS_CSV, 0, 1, {ROBERTS_COLUMN_ENDS}, "outline,,,,,,,,\n"},
    {"no ends, no name, in JSON",
     ROBERTS_JSON,
     0,
     2,
     {ROBERTS_COLUMN_NAME, ROBERTS_COLUMN_ENDS},
     "\"f1\":null,\"name\":null,\"X0\":null,\"Y0\":null,\"Z0\":null,\"X1\":null,\"Y1\":null,\"Z1\":null}\n"},
    {"ends in JSON",
     ROBERTS_JSON,
     3,
     1,
     {ROBERTS_COLUMN_ENDS},
     "\"f1\":8,\"X0\":0,\"Y0\":0,\"Z0\":0,\"X1\":0,\"Y1\":0,\"Z1\":0.25}\n"},
    {"twice", ROBERTS_CSV, 0, 2, {ROBERTS_COLUMN_ENDS, ROBERTS_COLUMN_ENDS}, NULL},
    {"unknown", ROBERTS_CSV, 0, 1, {ROBERTS_COLUMNS}, NULL},
    {"too many", ROBERTS_CSV, 0, ROBERTS_COLUMNS + 1, {ROBERTS_COLUMN_ENDS}, NULL},
};

static void further_columns(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof column_cases / sizeof column_cases[0]; i++) {
        roberts_draw_options options = roberts_draw_options_default();
        roberts_drawing drawing = {
            .count = 1, .segment = some + column_cases[i].first, .crossing_count = 1, .crossing = &crossing};
        roberts_error error = {0};
        sink to = {0};
        options.format = column_cases[i].format;
        options.hidden = ROBERTS_HIDDEN_DASHED;
        options.column_count = column_cases[i].column_count;
        memcpy(options.column, column_cases[i].column, sizeof options.column);
        print_message("%s\n", column_cases[i].name);
        roberts_status status = roberts_drawing_write(&drawing, &options, sink_write, &to, &error);
        assert_int_equal(status, column_cases[i].wanted ? ROBERTS_OK : ROBERTS_BAD_ARGUMENT);
        if (!column_cases[i].wanted)
            assert_string_equal(error.message, "an unknown column of tables, or one that is wanted twice");
        else if (!strstr(to.bytes, column_cases[i].wanted))
            fail_msg("%s", to.bytes);
        free(to.bytes);
    }
}

/* A named body, its ends in the model, and a name that needs quotes. */
static void columns_of_a_scene(void **state)
{
    static const char *const wanted[] = {
        "0,0,1,0,1,visible,-0.5,-1,-0.5,1,,border,0,,0,0,5,0,2,5,0.5,0.5,0,\"a, \"\"b\"\"\",\n",
        "\"X1\":0,\"Y1\":2,\"Z1\":5,\"z0\":0.5,\"z1\":0.5,\"level\":0,\"name\":\"a, \\\"b\\\"\",\"by_name\":null}",
    };
    static const char text[] = "o a, \"b\"\nv 0 0 5\nv 0 2 5\nv 1 0 4\nf 1 3 2\n";
    roberts_draw_options options = roberts_draw_options_default();
    (void)state;
    roberts_camera camera = preset_camera("top");
    roberts_scene *scene = scene_of_text(text);
    roberts_drawing drawing = drawing_of(scene, &camera, NULL);
    options.scene = scene;
    options.column_count = ROBERTS_COLUMNS;
    for (int i = 0; i < ROBERTS_COLUMNS; i++)
        options.column[i] = (roberts_column)i;
    for (size_t i = 0; i < 2; i++) {
        options.format = i ? ROBERTS_JSON : ROBERTS_CSV;
        sink to = drawing_written(&drawing, &options);
        if (!strstr(to.bytes, wanted[i]))
            fail_msg("%s", to.bytes);
        free(to.bytes);
    }
    roberts_drawing_free(&drawing);
    roberts_scene_free(scene);
}

/* Seen from the top, ends in the model and in the picture differ by one shift. The second scene has an edge that is cut
 * where a vertex lies on it: the row of the rest names the vertices of the whole edge. */
static void ends_lie_where_the_picture_has_them(void **state)
{
    static const char *const text[] = {
        "OFF\n8 2 0\n0 0 0\n3 0 0\n3 1 0\n0 1 0\n1 -1 2\n2 -1 2\n2 2 1\n1 2 1\n4 0 1 2 3\n4 4 5 6 7\n",
        "OFF\n5 2 0\n0 0 0\n7 1 0\n0 5 0\n2.8 0.4 0\n1 -4 1\n3 0 1 2\n3 3 4 0\n",
    };
    (void)state;
    for (size_t i = 0; i < sizeof text / sizeof text[0]; i++) {
        roberts_hide_options hide = roberts_hide_options_default();
        roberts_vec3 end[2];
        size_t parts = 0;
        hide.keep_hidden = hide.all_edges = true;
        roberts_camera camera = preset_camera("top");
        roberts_scene *scene = scene_of_text(text[i]);
        roberts_drawing drawing = drawing_of(scene, &camera, &hide);
        for (size_t k = 0; k < drawing.count; k++) {
            const roberts_segment *s = &drawing.segment[k];
            const double cx = 0.5 * (drawing.window_max.x - drawing.window_min.x);
            assert_true(roberts_segment_ends(scene, &drawing, s, end));
            for (int e = 0; e < 2; e++) {
                roberts_vec2 p = e ? s->p1 : s->p0;
                assert_true(fabs(end[e].x - p.x - cx) < 1e-12);
                assert_true(fabs(end[e].y - p.y - 0.5) < 1e-12);
            }
            parts += s->state == ROBERTS_VISIBLE && s->v0 == 0 && s->v1 == 1;
            assert_int_equal(roberts_segment_ends(scene, NULL, s, end), s->line != ROBERTS_INTERSECTION);
        }
        assert_int_equal(parts, i ? 1 : 2);
        roberts_segment none = drawing.segment[0];
        none.edge = UINT32_MAX - 1;
        assert_false(roberts_segment_ends(scene, &drawing, &none, end));
        roberts_drawing_free(&drawing);
        roberts_scene_free(scene);
    }
}

static void check_rows(void)
{
    for (size_t i = 0; i < sizeof row_cases / sizeof row_cases[0]; i++) {
        roberts_draw_options options = roberts_draw_options_default();
        roberts_drawing drawing = {.count = row_cases[i].count,
                                   .segment = some + row_cases[i].first,
                                   .crossing_count = 1,
                                   .crossing = &crossing};
        sink to = {0};
        options.format = row_cases[i].format;
        options.hidden = row_cases[i].hidden;
        print_message("%s\n", row_cases[i].name);
        assert_int_equal(roberts_drawing_write(&drawing, &options, sink_write, &to, NULL), ROBERTS_OK);
        assert_string_equal(to.bytes ? to.bytes : "", row_cases[i].wanted);
        free(to.bytes);
    }
}

static void rows(void **state)
{
    (void)state;
    check_rows();
}

static void rows_in_a_locale_with_commas(void **state)
{
    (void)state;
    if (!setlocale(LC_ALL, "de_DE.UTF-8")) {
        SKIP_BECAUSE("no locale de_DE.UTF-8");
    }
    char text[16];
    snprintf(text, sizeof text, "%g", 0.5);
    assert_string_equal(text, "0,5");
    check_rows();
    setlocale(LC_ALL, "C");
}

/* Wherever the output stops accepting bytes, the reason is returned. */
static void full_output(void **state)
{
    (void)state;
    size_t count = 5000;
    roberts_drawing drawing = {.count = count, .segment = malloc(count * sizeof(roberts_segment))};
    roberts_draw_options options = roberts_draw_options_default();
    options.format = ROBERTS_CSV;
    assert_non_null(drawing.segment);
    for (size_t i = 0; i < count; i++)
        drawing.segment[i] = line_at(ROBERTS_OUTLINE, (double)i, 1.0 / 3, 0.7, 1.0);
    sink all = {0};
    assert_int_equal(roberts_drawing_write(&drawing, &options, sink_write, &all, NULL), ROBERTS_OK);
    for (size_t room = 1; room < 2 * all.size; room = room * 3 + 1) {
        sink to = {.room = room};
        roberts_error error = {0};
        roberts_status status = roberts_drawing_write(&drawing, &options, sink_write, &to, &error);
        assert_int_equal(status, room < all.size ? ROBERTS_IO : ROBERTS_OK);
        if (status != ROBERTS_OK)
            assert_string_equal(error.message, "cannot write: No space left on device");
        free(to.bytes);
    }
    free(all.bytes);
    free(drawing.segment);
}

static void what_is_not_finite_is_refused(void **state)
{
    (void)state;
    for (int format = ROBERTS_SVG; format <= ROBERTS_NULL; format++)
        for (int i = 0; i < 6; i++) {
            roberts_segment bad = line_at(ROBERTS_OUTLINE, 0, 0, 1, 1);
            double *part[] = {&bad.t0, &bad.t1, &bad.p0.x, &bad.p0.y, &bad.p1.x, &bad.p1.y};
            roberts_draw_options options = roberts_draw_options_default();
            roberts_drawing drawing = {.count = 1, .segment = &bad};
            roberts_error error = {0};
            sink to = {0};
            *part[i] = i % 2 ? NAN : -INFINITY;
            options.format = (roberts_format)format;
            assert_int_equal(roberts_drawing_write(&drawing, &options, sink_write, &to, &error), ROBERTS_BAD_NUMBER);
            assert_string_equal(error.message, "segment 0 is not finite");
            assert_null(to.bytes);
        }
}

static const struct {
    const char *path;
    int format; /* -1: none */
} path_cases[] = {
    {"a.svg", ROBERTS_SVG},
    {"a.SVG", ROBERTS_SVG},
    {"b/c.d/a.csv", ROBERTS_CSV},
    {"a.b.json", ROBERTS_JSON},
    {"a.eps", ROBERTS_EPS},
    {"a.tikz", ROBERTS_TIKZ},
    {"a.tex", ROBERTS_TIKZ},
    {"a.dxf", ROBERTS_DXF},
    {"a.hpgl", ROBERTS_HPGL},
    {"a.plt", ROBERTS_HPGL},
    {"a.ps", ROBERTS_PS},
    {"a.pdf", ROBERTS_PDF},
    {"a.png", ROBERTS_PNG},
    {"svg", -1},
    {".svg", -1},
    {"x/.svg", -1},
    {"a.svg/b", -1},
    {"a.", -1},
    {"", -1},
    {"-", -1},
    {"a.svgz", -1},
};

static void formats_by_ending(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof path_cases / sizeof path_cases[0]; i++) {
        roberts_format format = (roberts_format)99;
        bool found = roberts_format_by_path(path_cases[i].path, &format);
        print_message("%s\n", path_cases[i].path);
        assert_int_equal(found, path_cases[i].format >= 0);
        assert_int_equal((int)format, found ? path_cases[i].format : 99);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_are_as_printf_has_them),
        cmocka_unit_test(random_numbers_are_as_printf_has_them),
        cmocka_unit_test(zero_has_no_sign),
        cmocka_unit_test(commas_become_points),
        cmocka_unit_test(rows),
        cmocka_unit_test(rows_in_a_locale_with_commas),
        cmocka_unit_test(further_columns),
        cmocka_unit_test(columns_of_a_scene),
        cmocka_unit_test(ends_lie_where_the_picture_has_them),
        cmocka_unit_test(full_output),
        cmocka_unit_test(what_is_not_finite_is_refused),
        cmocka_unit_test(formats_by_ending),
    };
    return cmocka_run_group_tests_name("csv", tests, NULL, NULL);
}
