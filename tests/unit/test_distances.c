/* Dimensions between vertices: their views, lengths and ends; nothing collides on pages from A4 to A0. */
#include <math.h>
#include <stdio.h>

#include "base/orient.h"
#include "draw/dimensions.h"
#include "sheet_views.h"
#include "testing.h"

enum { LINES = 7 /* of a dimension: two extensions, then itself and two arrows of two */ };

static char warning[256]; /* the last one since with() */

static void keep(void *context, const char *file, size_t line, const char *message)
{
    (void)context;
    (void)file;
    (void)line;
    snprintf(warning, sizeof warning, "%s", message);
}

static roberts_draw_options with(const views *v, const roberts_distance *distance, size_t count)
{
    roberts_draw_options options = roberts_draw_options_default();
    options.page = (roberts_page){420, 297, 10};
    options.scene = v->scene;
    options.lettering.distance = distance;
    options.lettering.distance_count = count;
    options.lettering.warnings = (roberts_warnings){keep, NULL};
    warning[0] = '\0';
    return options;
}

static roberts_vec2 line_end(const strokes *s, size_t line, int end)
{
    const page_point p = s->notes.lines.point[s->notes.lines.item[line].first + (size_t)end];
    return (roberts_vec2){p.x / 1000.0, p.y / 1000.0};
}

/* Where the drawing of a view has a vertex, mm. */
static roberts_vec2 find_vertex(const strokes *s, int place, uint32_t number)
{
    for (size_t i = 0; i < s->views; i++)
        for (size_t k = 0; s->view[i].place == place && k < s->view[i].drawing->count; k++) {
            const roberts_segment *g = &s->view[i].drawing->segment[k];
            if (g->v0 == number && g->t0 == 0.0)
                return page_place(&s->view[i].map, g->p0);
            if (g->v1 == number && g->t1 == 1.0)
                return page_place(&s->view[i].map, g->p1);
        }
    fail_msg("view %d does not show vertex %u", place, (unsigned)number);
    return (roberts_vec2){0.0, 0.0};
}

static double apart(roberts_vec2 a, roberts_vec2 b)
{
    return hypot(b.x - a.x, b.y - a.y);
}

/* One distance: its view, its text, and lines as in ISO 129-1. */
static void check_one(const char *model, roberts_distance of, int place, const char *wanted, double length)
{
    views v;
    strokes s;
    hide_views(&v, model, ROBERTS_THIRD_ANGLE);
    const roberts_draw_options options = with(&v, &of, 1);
    assert_int_equal(strokes_make_sheet(&s, &v.sheet, &options, NULL), ROBERTS_OK);
    assert_string_equal(warning, "");
    assert_int_equal(s.notes.count, 1);
    assert_int_equal(s.notes.lines.count, LINES);
    const text_line text = notes_line(&s.notes, 0);
    assert_string_equal(text.text, wanted);
    const double on_page = length * page_scale(&s.map);
    const roberts_vec2 from = line_end(&s, 2, 0), to = line_end(&s, 2, 1);
    const roberts_vec2 d = {(to.x - from.x) / apart(from, to), (to.y - from.y) / apart(from, to)};
    for (int i = 0; i < 2; i++) {
        const roberts_vec2 at = find_vertex(&s, place, i ? of.v1 : of.v0), start = line_end(&s, (size_t)i, 0),
                           end = line_end(&s, (size_t)i, 1);
        assert_true(fabs(apart(at, start) - 1.0) < 0.002);
        assert_true(fabs((end.x - start.x) * d.x + (end.y - start.y) * d.y) < 0.002); /* square to the line */
    }
    /* the tips of the arrows are as far apart as the vertices */
    assert_true(fabs(apart(line_end(&s, 3, 1), line_end(&s, 5, 1)) - on_page) < 0.003);
    assert_true(fabs(text.along.x * d.y - text.along.y * d.x) < 1e-3);
    assert_true(text.along.x > 1e-9 || text.along.y < 0.0); /* read from below or from the right */
    strokes_free(&s);
    free_views(&v);
}

/* The bracket is 12 wide, 10 deep and 15 high. */
static void lengths_and_views(void **state)
{
    (void)state;
    check_one("shapes/bracket", (roberts_distance){1, 2}, ROBERTS_SHEET_FRONT, "9", 9.0);
    check_one("shapes/bracket", (roberts_distance){129, 128}, ROBERTS_SHEET_TOP, "12", 12.0);
    check_one("shapes/bracket", (roberts_distance){126, 129}, ROBERTS_SHEET_SIDE, "2", 2.0);
    check_one("shapes/bracket", (roberts_distance){129, 1}, ROBERTS_SHEET_SIDE, "10,198", sqrt(104.0));
    check_one("shapes/bracket", (roberts_distance){0, 2}, ROBERTS_SHEET_FRONT, "15", 15.0); /* 12, 9 */
    check_one("platonic/tetrahedron", (roberts_distance){0, 1}, ROBERTS_SHEET_TOP, "2,8284", sqrt(8.0));
}

/* ---- collisions ---- */

static bool cross(const roberts_vec2 p[2], const roberts_vec2 q[2])
{
    return orient2d(p[0], p[1], q[0]) * orient2d(p[0], p[1], q[1]) < 0.0 &&
           orient2d(q[0], q[1], p[0]) * orient2d(q[0], q[1], p[1]) < 0.0;
}

static void piece_of(const polylines *of, const polyline *line, uint32_t i, roberts_vec2 ends[2])
{
    for (uint32_t k = 0; k < 2; k++) {
        const page_point p = of->point[line->first + (i + k) % line->count];
        ends[k] = (roberts_vec2){p.x / 1000.0, p.y / 1000.0};
    }
}

static void check_crossings(const polylines *letters, const polylines *of, size_t end, const char *what)
{
    for (size_t l = 0; l < letters->count; l++)
        for (uint32_t i = 0; i + 1 < letters->item[l].count; i++)
            for (size_t k = 0; k < end; k++)
                for (uint32_t j = 0; j + 1 < of->item[k].count + of->item[k].closed; j++) {
                    roberts_vec2 p[2], q[2];
                    piece_of(letters, &letters->item[l], i, p);
                    piece_of(of, &of->item[k], j, q);
                    if (cross(p, q))
                        fail_msg("a line crosses %s at %g, %g", what, p[0].x, p[0].y);
                }
}

/* No line crosses a letter: none of the views, the frame or the symbol, no dimension line, no other letter. */
static void check_collisions(const strokes *s)
{
    for (size_t i = 0; i < s->notes.count; i++) {
        polylines letters = {0};
        const text_line text = notes_line(&s->notes, i);
        assert_true(letters_draw(&text, 1000.0, &letters));
        check_crossings(&letters, &s->lines, s->start[LINE_CLASSES - 2], text.text);
        check_crossings(&letters, &s->notes.lines, s->notes.lines.count, text.text);
        for (size_t k = 0; k < i; k++) {
            polylines others = {0};
            const text_line other = notes_line(&s->notes, k);
            assert_true(letters_draw(&other, 1000.0, &others));
            check_crossings(&letters, &others, others.count, text.text);
            polylines_free(&others);
        }
        polylines_free(&letters);
    }
}

static void nothing_collides(void **state)
{
    (void)state;
    static const roberts_distance bracket[] = {{1, 2}, {129, 126}, {42, 30}, {1, 129}, {2, 5}, {5, 14}, {128, 129}};
    static const roberts_distance chair[] = {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {4, 7}, {8, 15}};
    static const struct {
        const char *model;
        const roberts_distance *distance;
        size_t count;
    } cases[] = {{"shapes/bracket", bracket, sizeof bracket / sizeof *bracket},
                 {"chair", chair, sizeof chair / sizeof *chair}};
    for (size_t c = 0; c < sizeof cases / sizeof cases[0]; c++)
        for (int angle = ROBERTS_FIRST_ANGLE; angle <= ROBERTS_THIRD_ANGLE; angle++) {
            views v;
            hide_views(&v, cases[c].model, (roberts_sheet_angle)angle);
            for (size_t page = 0; page < sizeof pages / sizeof pages[0]; page++) {
                roberts_draw_options options = with(&v, cases[c].distance, cases[c].count);
                roberts_error error = {0};
                strokes s;
                options.page = (roberts_page){pages[page][0], pages[page][1], 10};
                options.lettering.overall = page % 2 == 0;
                options.lettering.title = "Title";
                if (strokes_make_sheet(&s, &v.sheet, &options, &error) != ROBERTS_OK)
                    fail_msg("%s: %s", cases[c].model, error.message);
                assert_true(s.notes.lines.count >= LINES);
                check_collisions(&s);
                strokes_free(&s);
            }
            free_views(&v);
        }
}

/* A fitted sheet leaves room for distances: beside this top view that reaches the margins there was none, so that
 * dimension lines went through it. */
static void room_on_a_fitted_sheet(void **state)
{
    static const roberts_distance distance[] = {{0, 1}, {1, 2}};
    (void)state;
    for (int angle = ROBERTS_FIRST_ANGLE; angle <= ROBERTS_THIRD_ANGLE; angle++)
        for (int overall = 0; overall < 2; overall++) {
            views v;
            strokes s;
            hide_views(&v, "platonic/dodecahedron", (roberts_sheet_angle)angle);
            roberts_draw_options options = with(&v, distance, 2);
            options.page = (roberts_page){297, 210, 10};
            options.lettering.overall = overall;
            assert_int_equal(strokes_make_sheet(&s, &v.sheet, &options, NULL), ROBERTS_OK);
            assert_string_equal(warning, "");
            assert_int_equal(s.notes.count, overall ? 5 : 2);
            assert_int_equal(s.notes.lines.count, LINES * s.notes.count);
            for (size_t i = LINES * (s.notes.count - 2); i < s.notes.lines.count; i += LINES) {
                polylines one = {.item = &s.notes.lines.item[i + 2], .count = 1, .point = s.notes.lines.point};
                check_crossings(&one, &s.lines, s.start[LINE_CLASSES - 2], "a dimension line");
            }
            check_collisions(&s);
            strokes_free(&s);
            free_views(&v);
        }
}

/* The width, height or depth of the whole scene is drawn once, also where it is the distance of two vertices, too. */
static void overall_once(void **state)
{
    static const roberts_distance distance[] = {{0, 1}, {0, 4}, {0, 2}, {0, 3}}; /* three edges and a diagonal */
    (void)state;
    for (int angle = ROBERTS_FIRST_ANGLE; angle <= ROBERTS_THIRD_ANGLE; angle++) {
        views v;
        strokes s;
        hide_views(&v, "platonic/cube", (roberts_sheet_angle)angle);
        roberts_draw_options options = with(&v, distance, 4);
        assert_int_equal(strokes_make_sheet(&s, &v.sheet, &options, NULL), ROBERTS_OK);
        assert_int_equal(s.notes.count, 4);
        strokes_free(&s);
        options.lettering.overall = true;
        assert_int_equal(strokes_make_sheet(&s, &v.sheet, &options, NULL), ROBERTS_OK);
        assert_int_equal(s.notes.count, 3 + 1);
        assert_string_equal(warning, "");
        strokes_free(&s);
        free_views(&v);
    }
}

/* ---- what cannot be drawn ---- */

static void refused(views *v, roberts_distance of, bool has_scene, const char *wanted)
{
    strokes s;
    roberts_error error = {0};
    roberts_draw_options options = with(v, &of, 1);
    if (!has_scene)
        options.scene = NULL;
    assert_int_equal(strokes_make_sheet(&s, &v->sheet, &options, &error), ROBERTS_BAD_ARGUMENT);
    assert_string_equal(error.message, wanted);
    strokes_free(&s);
}

static void left_out(views *v, const roberts_draw_options *options, const char *wanted)
{
    strokes s;
    warning[0] = '\0';
    assert_int_equal(strokes_make_sheet(&s, &v->sheet, options, NULL), ROBERTS_OK);
    assert_int_equal(s.notes.count, 0);
    assert_string_equal(warning, wanted);
    strokes_free(&s);
}

static void errors_and_warnings(void **state)
{
    (void)state;
    views v;
    hide_views(&v, "platonic/cube", ROBERTS_FIRST_ANGLE);
    refused(&v, (roberts_distance){0, 1}, false, "dimensions: distances between vertices need the scene");
    refused(&v, (roberts_distance){0, 8}, true,
            "dimensions: no face has vertex 8 (of vertices at one place the smallest number counts)");
    refused(&v, (roberts_distance){3, 3}, true, "dimensions: vertices 3 and 3 are at one place");
    const roberts_distance diagonal = {0, 7};
    roberts_draw_options options = with(&v, &diagonal, 1);
    left_out(&v, &options, "the distance v0-v7 is left out: no view shows it in true length");
    const roberts_distance side = {0, 1};
    options = with(&v, &side, 1);
    options.page = (roberts_page){60, 60, 5};
    options.lettering.height_mm = 40.0;
    left_out(&v, &options,
             "the distance v0-v1 is left out: there is no room; choose smaller letters, a smaller scale or a larger "
             "page");
    free_views(&v);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(lengths_and_views), cmocka_unit_test(nothing_collides),
                                       cmocka_unit_test(room_on_a_fitted_sheet), cmocka_unit_test(overall_once),
                                       cmocka_unit_test(errors_and_warnings)};
    return cmocka_run_group_tests_name("distances", tests, NULL, NULL);
}
