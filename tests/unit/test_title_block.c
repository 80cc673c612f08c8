/* Title blocks and dimensions: their texts; nothing collides on pages from A4 to A0. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "draw/dimensions.h"
#include "letters_box.h"
#include "drawing.h"
#include "sheet_views.h"
#include "testing.h"

static const roberts_field fields[] = {{"author", "É. Dvořák"},
                                       {"number", "R-17"},
                                       {"date", "2026-11-23"},
                                       {"sheet", "1/1"},
                                       {"owner", "A workshop with a name that is far too long"}};

static roberts_draw_options lettered(size_t page)
{
    roberts_draw_options options = roberts_draw_options_default();
    options.page.width_mm = pages[page][0];
    options.page.height_mm = pages[page][1];
    options.frame.off = page % 2 == 0;
    options.lettering.title = "Title";
    options.lettering.field = fields;
    options.lettering.field_count = sizeof fields / sizeof fields[0];
    options.lettering.overall = true;
    options.lettering.zones = true; /* drawn if there is a frame */
    return options;
}

/* The boxes of straight pieces: lines here are level, upright, or have all of their box near a view. */
static space_box piece_box(page_point p, page_point q)
{
    return (space_box){{fmin(p.x, q.x) / 1000.0, fmin(p.y, q.y) / 1000.0},
                       {fmax(p.x, q.x) / 1000.0, fmax(p.y, q.y) / 1000.0}};
}

/* No text lies on another one, on a line of the views, the frame or the symbol, or on a line of its own. */
static void check_collisions(const strokes *s, const char *what)
{
    const polylines *sets[] = {&s->lines, &s->notes.lines};
    for (size_t i = 0; i < s->notes.count; i++) {
        const text_line text = notes_line(&s->notes, i);
        const space_box box = letters_box(text);
        if (!*text.text)
            continue;
        assert_true(box.min.x > 0.0 && box.min.y > 0.0 && box.max.x < s->options->page.width_mm &&
                    box.max.y < s->options->page.height_mm);
        for (size_t k = 0; k < i; k++) {
            const text_line other = notes_line(&s->notes, k);
            if (!is_apart(box, letters_box(other)))
                fail_msg("%s: \"%s\" lies on \"%s\"", what, text.text, other.text);
        }
        for (int set = 0; set < 2; set++)
            for (size_t k = 0; k < sets[set]->count; k++) {
                const polyline *line = &sets[set]->item[k];
                const page_point *p = sets[set]->point + line->first;
                const size_t text_start = s->start[LINE_CLASSES - 2]; /* the letters themselves come after it */
                for (uint32_t j = 0; (set == 1 || k < text_start) && j + 1 < line->count + line->closed; j++)
                    if (!is_apart(box, piece_box(p[j], p[(j + 1) % line->count])))
                        fail_msg("%s: \"%s\" lies on a line", what, text.text);
            }
    }
}

static void nothing_collides(void **state)
{
    (void)state;
    static const char *const models[] = {"chair", "temple", "table"};
    for (size_t m = 0; m < sizeof models / sizeof models[0]; m++)
        for (int angle = ROBERTS_FIRST_ANGLE; angle <= ROBERTS_THIRD_ANGLE; angle++) {
            views v;
            hide_views(&v, models[m], (roberts_sheet_angle)angle);
            for (size_t page = 0; page < sizeof pages / sizeof pages[0]; page++) {
                const roberts_draw_options options = lettered(page);
                roberts_error error = {0};
                strokes s;
                if (strokes_make_sheet(&s, &v.sheet, &options, &error) != ROBERTS_OK)
                    fail_msg("%s: %s", models[m], error.message);
                check_collisions(&s, models[m]);
                strokes_free(&s);
            }
            free_views(&v);
        }
}

/* On upright A4 the lower centring mark would run into the title block. It ends at the frame there, and only there. */
static void mark_ends_at_block(void **state)
{
    (void)state;
    views v;
    hide_views(&v, "chair", ROBERTS_FIRST_ANGLE);
    for (int with_block = 0; with_block < 2; with_block++) {
        strokes s;
        roberts_draw_options options = roberts_draw_options_default();
        int upper = 0, lower = 0;
        options.page.width_mm = 210.0;
        options.page.height_mm = 297.0;
        options.frame.off = false;
        options.lettering.zones = true;
        options.lettering.title = with_block ? "Chair" : NULL;
        assert_int_equal(strokes_make_sheet(&s, &v.sheet, &options, NULL), ROBERTS_OK);
        for (size_t k = 0; k < s.notes.lines.count; k++) {
            const page_point *p = s.notes.lines.point + s.notes.lines.item[k].first;
            const double x = p[0].x / s.units_per_mm, y0 = fmin(p[0].y, p[1].y) / s.units_per_mm,
                         y1 = fmax(p[0].y, p[1].y) / s.units_per_mm;
            if (fabs(x - 105.0) > 0.01 || p[0].x != p[1].x)
                continue;
            upper += y0 < s.frame_mm[0].y && y1 > s.frame_mm[0].y + 4.9;
            lower += y1 > s.frame_mm[1].y && y0 < s.frame_mm[1].y - 4.9;
        }
        assert_int_equal(upper, 1);
        assert_int_equal(lower, with_block ? 0 : 1);
        strokes_free(&s);
    }
    free_views(&v);
}

/* The centring marks run 5 mm into the frame; a drawing that is fitted stays 5 mm away from them. */
static void marks_are_clear(void **state)
{
    (void)state;
    roberts_segment side[] = {line_at(ROBERTS_OUTLINE, 0, 5, 10, 5), line_at(ROBERTS_OUTLINE, 5, 0, 5, 10)};
    roberts_drawing drawing = {.count = 2, .segment = side, .window_max = {10, 10}, .epsilon = 1e-9};
    roberts_draw_options options = roberts_draw_options_default();
    options.frame.off = false;
    for (int zones = 0; zones < 2; zones++) {
        strokes s;
        options.lettering.zones = zones;
        assert_int_equal(strokes_make(&s, &drawing, &options, NULL), ROBERTS_OK);
        const double left = page_place(&s.map, drawing.window_min).x - s.frame_mm[0].x;
        assert_true(fabs(left - (zones ? 10.0 : 5.0)) < 1e-9);
        strokes_free(&s);
    }
}

/* Text about as wide as the measured length, or wider, lies on no extension line. */
static void wide_text(void **state)
{
    (void)state;
    for (int angle = ROBERTS_FIRST_ANGLE; angle <= ROBERTS_THIRD_ANGLE; angle++)
        for (int height = 30; height <= 60; height += 5) {
            views v;
            strokes s;
            roberts_draw_options options = lettered(1);
            hide_views(&v, "chair", (roberts_sheet_angle)angle);
            options.placement.scale = 0.05;
            options.placement.unit_mm = 10.0;
            options.lettering.unit = "cm";
            options.lettering.height_mm = height / 10.0;
            assert_int_equal(strokes_make_sheet(&s, &v.sheet, &options, NULL), ROBERTS_OK);
            check_collisions(&s, "chair");
            strokes_free(&s);
            free_views(&v);
        }
}

static bool says(const strokes *s, const char *text)
{
    for (size_t i = 0; i < s->notes.count; i++)
        if (strcmp(notes_line(&s->notes, i).text, text) == 0)
            return true;
    return false;
}

/* The temple is 30 wide, 42 deep and 25 high; the scale is that of the drawing. */
static void what_it_says(void **state)
{
    (void)state;
    views v;
    strokes s;
    roberts_draw_options options = lettered(1);
    hide_views(&v, "temple", ROBERTS_FIRST_ANGLE);
    options.placement.scale = 0.001;
    options.placement.unit_mm = 1000.0;
    options.lettering.unit = "m";
    assert_int_equal(strokes_make_sheet(&s, &v.sheet, &options, NULL), ROBERTS_OK);
    static const char *const wanted[] = {"Title", "1:1000", "R-17", "2026-11-23", "30 m", "42 m", "25 m", "Owner"};
    for (size_t i = 0; i < sizeof wanted / sizeof wanted[0]; i++)
        if (!says(&s, wanted[i]))
            fail_msg("nothing says %s", wanted[i]);
    strokes_free(&s);
    free_views(&v);
}

/* Text of the title's cell, 90 mm wide: where a line would have letters of less than 3.5 mm, the title breaks at
 * blanks. All is below the caption, and inside of the cell. */
static void long_titles(void **state)
{
    static const struct {
        const char *title, *first, *last; /* lines; NULL: it is one */
        double height;                    /* at least */
    } cases[] = {
        {"Title", NULL, NULL, 5.0},
        {"Somewhat longer, one line", NULL, NULL, 3.5},
        {"A title of two lines that are long enough", "A title of two lines that are long", "enough", 3.4},
        {"A long title that tells everything about a chair, its legs, its back, the seat and who once sat on it, in "
         "1642",
         "A long title that tells everything about a", "once sat on it, in 1642", 2.4},
        {"One-word-that-nothing-can-break-and-that-is-made-smaller-until-it-fits", NULL, NULL, 1.4},
        {"  blanks  before,  between  and  after  the  words  of  a  title  ", NULL, NULL, 1.8},
    };
    views v;
    (void)state;
    hide_views(&v, "chair", ROBERTS_FIRST_ANGLE);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        strokes s;
        double least = INFINITY;
        roberts_draw_options options = lettered(1);
        options.lettering.title = cases[i].title;
        assert_int_equal(strokes_make_sheet(&s, &v.sheet, &options, NULL), ROBERTS_OK);
        check_collisions(&s, cases[i].title);
        const double left = s.frame_mm[1].x - 120.0, top = s.frame_mm[1].y - 27.0;
        for (size_t k = 0; k < s.notes.count; k++) {
            const text_line line = notes_line(&s.notes, k);
            const space_box box = letters_box(line);
            if (!*line.text || line.at.x < left || line.at.x > left + 88.0 || line.at.y < top + 3.1 ||
                line.at.y > top + 18.0)
                continue;
            least = fmin(least, line.height_mm);
            assert_true(box.min.x >= left && box.max.x <= left + 90.0 && box.min.y >= top && box.max.y <= top + 18.0);
        }
        if (!(least >= cases[i].height))
            fail_msg("%s: letters of %g mm", cases[i].title, least);
        if (cases[i].first && !(says(&s, cases[i].first) && says(&s, cases[i].last)))
            fail_msg("other lines than \"%s\" and \"%s\"", cases[i].first, cases[i].last);
        strokes_free(&s);
    }
    free_views(&v);
}

static bool is_corner(const strokes *s, page_point p)
{
    for (size_t i = 0; i < s->start[LINE_CLASSES - 4]; i++) /* those of the views; then frame, symbol and text follow */
        for (uint32_t k = 0; k < s->lines.item[i].count; k++) {
            const page_point q = s->lines.point[s->lines.item[i].first + k];
            if (abs(p.x - q.x) <= 1 && abs(p.y - q.y) <= 1)
                return true;
        }
    return false;
}

/* Each extension line begins 1 mm from a corner of its view, also where the view's box is higher than the view there.
 * `longest` in mm, on paper. */
static void check_extensions(const char *model, roberts_sheet_angle angle, double longest)
{
    enum { DIMENSIONS = 3, LINES = 7 /* of a dimension: two extensions, then itself and two arrows of two */ };
    views v;
    strokes s;
    double most = 0.0;
    roberts_draw_options options = roberts_draw_options_default();
    options.page = (roberts_page){420, 297, 10};
    options.lettering.overall = true;
    options.placement.scale = 1.0;
    hide_views(&v, model, angle);
    assert_int_equal(strokes_make_sheet(&s, &v.sheet, &options, NULL), ROBERTS_OK);
    assert_int_equal(s.notes.lines.count, DIMENSIONS * LINES);
    for (size_t i = 0; i < DIMENSIONS * LINES; i += i % LINES == 0 ? 1 : LINES - 1) {
        const page_point *p = s.notes.lines.point + s.notes.lines.item[i].first;
        const double length = hypot(p[1].x - p[0].x, p[1].y - p[0].y);
        const page_point corner = {p[0].x - (int32_t)lround((p[1].x - p[0].x) / length * 1000.0),
                                   p[0].y - (int32_t)lround((p[1].y - p[0].y) / length * 1000.0)};
        if (!is_corner(&s, corner))
            fail_msg("%s: extension line %zu begins in the air", model, i);
        most = fmax(most, length / 1000.0);
    }
    assert_true(fabs(most - longest) < 0.002);
    strokes_free(&s);
    free_views(&v);
}

static void extensions_reach_corners(void **state)
{
    (void)state;
    check_extensions("chair", ROBERTS_FIRST_ANGLE, 48.0 + 11.0);  /* down to the seat: 93 - 45 */
    check_extensions("chair", ROBERTS_THIRD_ANGLE, 93.0 + 11.0);  /* up to the top of the back, which leans */
    check_extensions("temple", ROBERTS_FIRST_ANGLE, 24.0 + 11.0); /* down to the lowest step */
}

static void small_pages(void **state)
{
    static const struct {
        roberts_page page;
        const char *said;
    } cases[] = {
        {{148, 210, 10}, "148 x 210: --landscape would do"},
        {{105, 148, 10}, "105 x 148: --page a4 would do"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        views v;
        strokes s;
        roberts_error error = {0};
        roberts_draw_options options = lettered(0);
        hide_views(&v, "chair", ROBERTS_THIRD_ANGLE);
        options.page = cases[i].page;
        assert_int_equal(strokes_make_sheet(&s, &v.sheet, &options, &error), ROBERTS_BAD_ARGUMENT);
        strokes_free(&s);
        assert_non_null(strstr(error.message, "page: title block and views need 200 x 125 mm with these margins, and"));
        assert_non_null(strstr(error.message, cases[i].said));
        free_views(&v);
    }
}

static void numbers(void **state)
{
    (void)state;
    static const struct {
        double value;
        const char *unit, *text;
    } cases[] = {{44.0, NULL, "44"},
                 {0.93, "m", "0,93 m"},
                 {1.41421356, NULL, "1,4142"},
                 {123456.7, NULL, "123457"},
                 {0.000125, NULL, "0,000125"},
                 {99999.5, NULL, "100000"},
                 {0.1, "", "0,1"},
                 {20.05, NULL, "20,05"},
                 {0.05, NULL, "0,05"},
                 {1000.0, "ft", "1000 ft"},
                 {1.25e20, NULL, "1,2500e+20"},
                 {0.0, NULL, "0"},
                 {2.8284e-7, NULL, "0,00000028284"},
                 {1e-9, NULL, "0,000000001"},
                 {9.1e-13, "m", "9,1000e-13 m"}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[100];
        dimension_text(cases[i].value, cases[i].unit, text, sizeof text);
        assert_string_equal(text, cases[i].text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(nothing_collides), cmocka_unit_test(mark_ends_at_block),
                                       cmocka_unit_test(marks_are_clear),  cmocka_unit_test(wide_text),
                                       cmocka_unit_test(what_it_says),     cmocka_unit_test(extensions_reach_corners),
                                       cmocka_unit_test(small_pages),      cmocka_unit_test(long_titles),
                                       cmocka_unit_test(numbers)};
    return cmocka_run_group_tests_name("title blocks", tests, NULL, NULL);
}
