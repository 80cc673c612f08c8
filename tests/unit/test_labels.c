/* Labels of visible things avoid the lines and one another, on pages from A4 to A0, and are the same every time.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/orient.h"
#include "draw/label_targets.h"
#include "draw/free_space.h"
#include "draw/strokes.h"
#include "drawing.h"
#include "letters_box.h"
#include "sheet_views.h"
#include "testing.h"

static const double upright[][2] = {{210, 297}, {297, 420}, {420, 594}, {594, 841}, {841, 1189}};

typedef struct told {
    size_t count;
    char text[200];
} told;

static void tell(void *context, const char *file, size_t line, const char *message)
{
    told *t = context;
    (void)file;
    (void)line;
    t->count++;
    snprintf(t->text, sizeof t->text, "%s", message);
}

static roberts_draw_options options_of(unsigned labels, size_t page, told *warnings)
{
    roberts_draw_options options = roberts_draw_options_default();
    options.page.width_mm = upright[page][0];
    options.page.height_mm = upright[page][1];
    options.lettering.labels = labels;
    options.lettering.warnings = (roberts_warnings){tell, warnings};
    return options;
}

/* Whether a..b goes through the box, found from its sides and not by the code that is tested. */
static bool goes_through(roberts_vec2 a, roberts_vec2 b, space_box box)
{
    const roberts_vec2 corner[4] = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
    int left = 0;
    if (is_apart((space_box){{fmin(a.x, b.x), fmin(a.y, b.y)}, {fmax(a.x, b.x), fmax(a.y, b.y)}}, box))
        return false;
    for (int i = 0; i < 4; i++)
        left += (b.x - a.x) * (corner[i].y - a.y) - (b.y - a.y) * (corner[i].x - a.x) > 0.0;
    return left != 0 && left != 4;
}

/* Letters that lie on a line, of all classes below text. */
static size_t count_crossed(const strokes *s)
{
    size_t crossed = 0;
    for (size_t i = 0; i < s->notes.count; i++) {
        const space_box box = letters_box(notes_line(&s->notes, i));
        bool found = false;
        for (size_t k = 0; k < s->lines.count; k++) {
            const polyline *line = &s->lines.item[k];
            const page_point *p = s->lines.point + line->first;
            bool own = false;
            for (int c = 0; c < LINE_CLASSES; c++)
                own = own || ((line_order[c] == LINE_TEXT || line_order[c] == LINE_HIDDEN_TEXT) && k >= s->start[c] &&
                              k < s->start[c + 1]);
            for (uint32_t j = 0; !own && j + 1 < line->count + line->closed; j++) {
                const page_point q = p[(j + 1) % line->count];
                found = found || goes_through((roberts_vec2){p[j].x / 1000.0, p[j].y / 1000.0},
                                              (roberts_vec2){q.x / 1000.0, q.y / 1000.0}, box);
            }
        }
        crossed += found;
    }
    return crossed;
}

static void check_apart(const strokes *s, const char *what)
{
    const space_box whole = {s->frame_mm[0], s->frame_mm[1]};
    for (size_t i = 0; i < s->notes.count; i++) {
        const space_box box = letters_box(notes_line(&s->notes, i));
        assert_true(box.min.x >= whole.min.x && box.min.y >= whole.min.y && box.max.x <= whole.max.x &&
                    box.max.y <= whole.max.y);
        for (size_t k = 0; k < i; k++)
            if (!is_apart(box, letters_box(notes_line(&s->notes, k))))
                fail_msg("%s: %s lies on %s", what, notes_line(&s->notes, i).text, notes_line(&s->notes, k).text);
    }
}

/* A dodecahedron has room for all labels: in isometric view 17 vertices and 24 edges are seen, as the segments confirm.
 */
static void all_of_a_dodecahedron(void **state)
{
    (void)state;
    roberts_drawing drawing = model_drawing("platonic/dodecahedron", "iso");
    for (size_t page = 0; page < 5; page++) {
        told warnings = {0};
        roberts_draw_options options = options_of(ROBERTS_LABEL_VERTICES | ROBERTS_LABEL_EDGES, page, &warnings);
        bool vertex[20] = {false};
        size_t vertices = 0, edges = 0;
        strokes s;
        for (size_t i = 0; i < drawing.count; i++) {
            const roberts_segment *one = &drawing.segment[i];
            if (one->state != ROBERTS_VISIBLE)
                continue;
            edges++;
            vertices += !vertex[one->v0];
            vertex[one->v0] = true;
            vertices += !vertex[one->v1];
            vertex[one->v1] = true;
        }
        assert_int_equal(strokes_make(&s, &drawing, &options, NULL), ROBERTS_OK);
        assert_int_equal(s.notes.count, vertices + edges);
        assert_int_equal(warnings.count, 0);
        check_apart(&s, "dodecahedron");
        assert_int_equal(count_crossed(&s), 0);
        strokes_free(&s);
    }
    roberts_drawing_free(&drawing);
}

/* A drawing at a given scale may fill the page within the margins; then labels may lie on the margins. */
static void margins_at_a_scale(void **state)
{
    (void)state;
    roberts_drawing drawing = model_drawing("platonic/dodecahedron", "iso");
    told warnings = {0};
    roberts_draw_options options = options_of(ROBERTS_LABEL_VERTICES, 0, &warnings);
    const double width = drawing.window_max.x - drawing.window_min.x;
    options.page.margin_mm = 20.0;
    options.placement.scale = (options.page.width_mm - 2.0 * options.page.margin_mm) / width;
    strokes s;
    size_t beyond = 0;
    assert_int_equal(strokes_make(&s, &drawing, &options, NULL), ROBERTS_OK);
    for (size_t i = 0; i < s.notes.count; i++) {
        const space_box box = letters_box(notes_line(&s.notes, i));
        beyond += box.min.x < s.frame_mm[0].x || box.max.x > s.frame_mm[1].x;
    }
    assert_true(beyond > 0);
    strokes_free(&s);
    roberts_drawing_free(&drawing);
}

/* A drawing is fitted together with the labels beside it: this long one stands at the right of its vertex, free of all
 * lines, and drawing and label together are as wide as the margins allow. For a label wider than the
 * page, the drawing becomes no smaller than half of its size. */
static void fitted_with_its_labels(void **state)
{
    (void)state;
    roberts_drawing drawing = model_drawing("platonic/dodecahedron", "iso");
    told warnings = {0};
    roberts_draw_options options = options_of(0, 0, &warnings);
    roberts_name name = {ROBERTS_LABEL_VERTICES, 12, 0, "right side"};
    const double width = drawing.window_max.x - drawing.window_min.x;
    char longest[200] = {0};
    strokes s;
    options.page.margin_mm = 40.0;
    options.lettering.height_mm = 3.5;
    options.lettering.name = &name;
    options.lettering.name_count = 1;
    assert_int_equal(strokes_make(&s, &drawing, &options, NULL), ROBERTS_OK);
    assert_int_equal(s.notes.count, 1);
    assert_int_equal(count_crossed(&s), 0);
    const space_box box = letters_box(notes_line(&s.notes, 0));
    const double left = page_place(&s.map, drawing.window_min).x, right = page_place(&s.map, drawing.window_max).x;
    assert_true(fabs(left - 40.0) < 0.01);
    assert_true(box.min.x > right && box.max.x > 168.5 && box.max.x < 170.0);
    strokes_free(&s);
    memset(longest, 'm', sizeof longest - 1);
    name.text = longest;
    assert_int_equal(strokes_make(&s, &drawing, &options, NULL), ROBERTS_OK);
    assert_int_equal(s.notes.count, 0);
    assert_int_equal(warnings.count, 1);
    assert_true(fabs(width * page_scale(&s.map) - 65.0) < 0.1);
    strokes_free(&s);
    roberts_drawing_free(&drawing);
}

/* So are the views of a sheet. The label of a vertex on the upper border of the top view, which reached the margin,
 * stood within the view. */
static void sheet_with_its_labels(void **state)
{
    const roberts_name name = {ROBERTS_LABEL_VERTICES, 12, 0, "right side"};
    told warnings = {0};
    views v;
    strokes s;
    (void)state;
    hide_views(&v, "platonic/dodecahedron", ROBERTS_THIRD_ANGLE);
    roberts_draw_options options = options_of(0, 0, &warnings);
    options.page = (roberts_page){297, 210, 10};
    options.lettering.name = &name;
    options.lettering.name_count = 1;
    assert_int_equal(strokes_make_sheet(&s, &v.sheet, &options, NULL), ROBERTS_OK);
    assert_int_equal(s.notes.count, 3);
    for (size_t i = 0; i < s.notes.count; i++)
        for (size_t k = 0; k < s.views; k++) {
            const page_view *view = &s.view[k];
            const roberts_vec2 a = page_place(&view->map, view->drawing->window_min);
            const roberts_vec2 b = page_place(&view->map, view->drawing->window_max);
            const space_box box = letters_box(notes_line(&s.notes, i)), window = {{a.x, b.y}, {b.x, a.y}};
            assert_true(is_apart(box, window));
            assert_true(box.min.x >= 10.0 && box.min.y >= 10.0 && box.max.x <= 287.0 && box.max.y <= 200.0);
        }
    strokes_free(&s);
    free_views(&v);
}

/* Drawings and sheets are not much smaller for their labels: on small pages these have smaller letters, unless their
 * height is given. */
static void small_pages(void **state)
{
    static const struct {
        unsigned labels;
        double side_mm, given_mm, height_mm, part; /* `part`: the least of its size without labels */
    } row[] = {{ROBERTS_LABEL_VERTICES, 60, 0.0, 3.5, 0.75},
               {ROBERTS_LABEL_EDGES, 60, 0.0, 2.5, 0.75},
               {ROBERTS_LABEL_EDGES, 60, 3.5, 3.5, 0.5},
               {ROBERTS_LABEL_EDGES, 45, 0.0, 1.8, 0.75},
               {ROBERTS_LABEL_EDGES, 80, 0.0, 3.5, 0.75}};
    roberts_drawing drawing = model_drawing("platonic/cube", "trimetric");
    (void)state;
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        told warnings = {0};
        roberts_draw_options options = options_of(0, 0, &warnings);
        strokes s;
        options.page = (roberts_page){row[i].side_mm, row[i].side_mm, 3.0};
        options.lettering.height_mm = row[i].given_mm;
        assert_int_equal(strokes_make(&s, &drawing, &options, NULL), ROBERTS_OK);
        const double without = page_scale(&s.map);
        strokes_free(&s);
        options.lettering.labels = row[i].labels;
        assert_int_equal(strokes_make(&s, &drawing, &options, NULL), ROBERTS_OK);
        assert_float_equal(s.label_mm, row[i].height_mm, 0.0);
        assert_true(page_scale(&s.map) >= row[i].part * without);
        strokes_free(&s);
    }
    roberts_drawing_free(&drawing);
}

/* The same on a sheet. */
static void small_sheets(void **state)
{
    static const struct {
        double side_mm, height_mm;
    } row[] = {{60, 2.5}, {100, 3.5}};
    views v;
    (void)state;
    hide_views(&v, "platonic/cube", ROBERTS_FIRST_ANGLE);
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        told warnings = {0};
        roberts_draw_options options = options_of(0, 0, &warnings);
        strokes s;
        options.page = (roberts_page){row[i].side_mm, row[i].side_mm, 3.0};
        assert_int_equal(strokes_make_sheet(&s, &v.sheet, &options, NULL), ROBERTS_OK);
        const double without = page_scale(&s.map);
        strokes_free(&s);
        options.lettering.labels = ROBERTS_LABEL_VERTICES;
        assert_int_equal(strokes_make_sheet(&s, &v.sheet, &options, NULL), ROBERTS_OK);
        assert_float_equal(s.label_mm, row[i].height_mm, 0.0);
        assert_true(page_scale(&s.map) >= 0.75 * without);
        strokes_free(&s);
    }
    free_views(&v);
}

/* If there is little room, labels are left out and counted; the others lie apart. */
static void models_from_a4_to_a0(void **state)
{
    (void)state;
    static const char *const models[] = {"table", "chair", "temple", "platonic-solids"};
    for (size_t m = 0; m < sizeof models / sizeof models[0]; m++) {
        roberts_drawing drawing = model_drawing(models[m], "iso");
        size_t before = 0;
        for (size_t page = 0; page < 5; page++) {
            told warnings = {0};
            roberts_draw_options options = options_of(ROBERTS_LABEL_VERTICES, page, &warnings);
            strokes s;
            options.hidden = ROBERTS_HIDDEN_DASHED;
            assert_int_equal(strokes_make(&s, &drawing, &options, NULL), ROBERTS_OK);
            check_apart(&s, models[m]);
            assert_true(s.notes.count > before / 2); /* about as many as on a smaller page, or more */
            if (warnings.count)
                assert_non_null(strstr(warnings.text, "labels, which are left out"));
            before = s.notes.count;
            strokes_free(&s);
        }
        roberts_drawing_free(&drawing);
    }
}

/* Letters are 3.5 mm high if that leaves room for all labels, smaller on a crowded page, and otherwise as given. */
static void letters_fit_the_room(void **state)
{
    (void)state;
    static const struct {
        const char *model;
        double given_mm, height_mm;
        bool all;
    } row[] = {{"platonic/dodecahedron", 0.0, 3.5, true},
               {"stacked-blocks", 0.0, 3.5, true},
               {"chair", 0.0, 1.8, true},
               {"table", 0.0, 1.8, true},
               {"table", 3.5, 3.5, false},
               {"platonic/dodecahedron", 1.8, 1.8, true}};
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        told warnings = {0};
        roberts_drawing drawing = model_drawing(row[i].model, "iso");
        roberts_draw_options options = options_of(ROBERTS_LABEL_VERTICES, 0, &warnings);
        strokes s;
        options.lettering.height_mm = row[i].given_mm;
        assert_int_equal(strokes_make(&s, &drawing, &options, NULL), ROBERTS_OK);
        for (size_t n = 0; n < s.notes.count; n++)
            assert_float_equal(notes_line(&s.notes, n).height_mm, row[i].height_mm, 0.0);
        assert_int_equal(warnings.count, row[i].all ? 0 : 1);
        assert_true(s.notes.count > 0);
        if (row[i].given_mm == 0.0)
            assert_true(count_crossed(&s) <= s.notes.count / 4); /* if there is no room at all */
        check_apart(&s, row[i].model);
        strokes_free(&s);
        roberts_drawing_free(&drawing);
    }
}

/* Names are wider than numbers: their corners point to the vertex where there is no room beside, above or below it. */
static void wide_names(void **state)
{
    static const char *const models[] = {"platonic/dodecahedron", "archimedean/cuboctahedron"};
    roberts_name name[20];
    (void)state;
    for (uint32_t v = 0; v < 20; v++)
        name[v] = (roberts_name){.of = ROBERTS_LABEL_VERTICES, .number = v, .text = "south-western corner"};
    for (size_t i = 0; i < sizeof models / sizeof models[0]; i++) {
        roberts_drawing drawing = model_drawing(models[i], "iso");
        told warnings = {0};
        roberts_draw_options options = options_of(0, 0, &warnings);
        strokes s;
        options.lettering.name = name;
        options.lettering.name_count = sizeof name / sizeof name[0];
        assert_int_equal(strokes_make(&s, &drawing, &options, NULL), ROBERTS_OK);
        assert_true(s.notes.count > 8 && warnings.count == 0);
        assert_int_equal(count_crossed(&s), 0);
        check_apart(&s, models[i]);
        strokes_free(&s);
        roberts_drawing_free(&drawing);
    }
}

/* Writes the drawing; its bytes do not matter, but what is warned of does. */
static void write_drawing(const roberts_drawing *drawing, const roberts_draw_options *options)
{
    sink file = {0};
    assert_int_equal(roberts_drawing_write(drawing, options, sink_write, &file, NULL), ROBERTS_OK);
    free(file.bytes);
}

static void hidden_and_named(void **state)
{
    (void)state;
    told warnings = {0};
    roberts_segment some[] = {line_at(ROBERTS_OUTLINE, 0, 0, 10, 0), line_at(ROBERTS_OUTLINE, 0, 0, 0, 10),
                              line_at(ROBERTS_OUTLINE, 10, 0, 0, 10)};
    some[0].v0 = 3, some[0].v1 = 5;
    some[1].v0 = 3, some[1].v1 = 8;
    some[2].v0 = 5, some[2].v1 = 8;
    some[1].state = some[2].state = ROBERTS_HIDDEN;
    roberts_drawing drawing = {.count = 3, .segment = some, .epsilon = 1e-9};
    roberts_draw_options options = options_of(ROBERTS_LABEL_VERTICES, 0, &warnings);
    const roberts_name name[] = {{ROBERTS_LABEL_VERTICES, 5, 0, "Ω"}, {ROBERTS_LABEL_EDGES, 3, 8, "h\xff"}};
    strokes s;
    assert_int_equal(strokes_make(&s, &drawing, &options, NULL), ROBERTS_OK);
    assert_int_equal(s.notes.count, 2);
    strokes_free(&s);
    options.hidden = ROBERTS_HIDDEN_DASHED;
    options.lettering.name = name;
    options.lettering.name_count = 2;
    assert_int_equal(strokes_make(&s, &drawing, &options, NULL), ROBERTS_OK);
    assert_int_equal(s.notes.count, 4);
    assert_string_equal(notes_line(&s.notes, 0).text, "3");
    assert_string_equal(notes_line(&s.notes, 1).text, "Ω");
    assert_string_equal(notes_line(&s.notes, 2).text, "h\xff");
    assert_string_equal(notes_line(&s.notes, 3).text, "8");
    for (size_t i = 0; i < 4; i++)
        assert_int_equal(s.notes.item[i].is_back, i >= 2);
    strokes_free(&s);
    write_drawing(&drawing, &options);
    assert_int_equal(warnings.count, 1);
    assert_string_equal(warnings.text, "the letters lack 1 character, the first of them a byte that is not UTF-8: a "
                                       "box stands for each");
    const roberts_name far_name = {ROBERTS_LABEL_VERTICES, 5, 0, "\u4e00\u4e8c"};
    options.lettering.name = &far_name;
    options.lettering.name_count = 1;
    write_drawing(&drawing, &options);
    assert_string_equal(warnings.text,
                        "the letters lack 2 characters, the first of them U+4E00: a box stands for each");
    options.format = ROBERTS_PDF;
    options.lettering.native = true;
    write_drawing(&drawing, &options);
    assert_string_equal(warnings.text, "the fonts of PDF lack 2 characters, the first of them U+4E00: a plain letter "
                                       "or a question mark stands for each");
    options.format = ROBERTS_TIKZ;
    write_drawing(&drawing, &options);
    assert_string_equal(warnings.text, "the definitions of LaTeX lack 2 characters, the first of them U+4E00: pdflatex "
                                       "fails unless the document defines each");
    const roberts_name bytes = {ROBERTS_LABEL_VERTICES, 5, 0, "h\xff"};
    options.lettering.name = &bytes;
    write_drawing(&drawing, &options);
    assert_string_equal(warnings.text, "the definitions of LaTeX lack 1 character, the first of them a byte that is "
                                       "not UTF-8: a question mark stands for each");
    const roberts_name polish = {ROBERTS_LABEL_VERTICES, 5, 0, "k\u0105t \u0142"};
    options.lettering.name = &polish;
    write_drawing(&drawing, &options);
    assert_string_equal(warnings.text, "the usual fonts of LaTeX lack 1 character, the first of them U+0105: pdflatex "
                                       "fails without \\usepackage[T1]{fontenc}");
    options.format = ROBERTS_PDF;
    const roberts_name author = {ROBERTS_LABEL_VERTICES, 5, 0, "k\u016f\u0148 \u2010 \u017e\u00e9"};
    options.lettering.name = &author;
    write_drawing(&drawing, &options);
    assert_string_equal(warnings.text, "the fonts of PDF lack 2 characters, the first of them U+016F: a plain letter "
                                       "or a question mark stands for each");
}

/* Hidden lines end on a visible line: in the middle of it, beside it by more than the touching distance, and behind it.
 * Only the first of these vertices is not hidden. */
static void vertices_on_lines(void **state)
{
    (void)state;
    told warnings = {0};
    roberts_segment some[] = {line_at(ROBERTS_OUTLINE, 0, 0, 10, 0), line_at(ROBERTS_CREASE, 5, 0, 5, 9),
                              line_at(ROBERTS_CREASE, 7, 2e-9, 7, 9), line_at(ROBERTS_CREASE, 3, 0, 3, 9)};
    for (uint32_t i = 0; i < 4; i++) {
        some[i].v0 = 2 * i;
        some[i].v1 = 2 * i + 1;
        some[i].state = i ? ROBERTS_HIDDEN : ROBERTS_VISIBLE;
        some[i].z0 = some[i].z1 = 4.0;
    }
    some[3].z0 = 4.0 - 2e-9;
    roberts_drawing drawing = {.count = 4, .segment = some, .epsilon = 1e-9};
    roberts_draw_options options = options_of(ROBERTS_LABEL_VERTICES, 0, &warnings);
    options.hidden = ROBERTS_HIDDEN_DASHED;
    strokes s;
    assert_int_equal(strokes_make(&s, &drawing, &options, NULL), ROBERTS_OK);
    assert_int_equal(s.notes.count, 8);
    for (size_t i = 0; i < 8; i++) {
        const uint32_t vertex = s.notes.item[i].of.number;
        assert_int_equal(s.notes.item[i].is_back, vertex > 2);
    }
    strokes_free(&s);
}

/* The same strokes again; with native text there are no strokes of letters, but the same notes. */
static void same_again(void **state)
{
    (void)state;
    told warnings = {0};
    roberts_drawing drawing = model_drawing("table", "iso");
    roberts_draw_options options = options_of(ROBERTS_LABEL_VERTICES, 2, &warnings);
    strokes a, b;
    assert_int_equal(strokes_make(&a, &drawing, &options, NULL), ROBERTS_OK);
    assert_int_equal(strokes_make(&b, &drawing, &options, NULL), ROBERTS_OK);
    assert_int_equal(a.lines.point_count, b.lines.point_count);
    assert_memory_equal(a.lines.point, b.lines.point, a.lines.point_count * sizeof *a.lines.point);
    strokes_free(&b);
    options.lettering.native = true;
    assert_int_equal(strokes_make(&b, &drawing, &options, NULL), ROBERTS_OK);
    assert_int_equal(a.notes.count, b.notes.count);
    assert_true(b.lines.count < a.lines.count);
    strokes_free(&a);
    strokes_free(&b);
    roberts_drawing_free(&drawing);
}

/* A model, a cube for the most part, with its regions. */
typedef struct cube {
    roberts_drawing drawing;
    roberts_region_list regions;
} cube;

static void see_model_to(cube *c, const char *model, const roberts_camera *camera, double crease_degrees)
{
    roberts_hide_options options = roberts_hide_options_default();
    roberts_mesh mesh = {0};
    roberts_scene *scene;
    assert_int_equal(roberts_mesh_read_file(&mesh, model, NULL, NULL), ROBERTS_OK);
    assert_int_equal(roberts_scene_take(&mesh, NULL, &scene, NULL), ROBERTS_OK);
    options.crease_degrees = crease_degrees;
    options.keep_hidden = true;
    assert_int_equal(roberts_hide(scene, camera, &options, &c->drawing, NULL), ROBERTS_OK);
    assert_int_equal(roberts_regions(scene, camera, NULL, &c->regions, NULL), ROBERTS_OK);
    c->drawing.regions = &c->regions;
    roberts_scene_free(scene);
    roberts_mesh_free(&mesh);
}

static void see_model(cube *c, const char *model, const roberts_camera *camera)
{
    see_model_to(c, model, camera, roberts_hide_options_default().crease_degrees);
}

static void see_cube(cube *c, const roberts_camera *camera)
{
    see_model(c, "models/platonic/cube.off", camera);
}

static void free_cube(cube *c)
{
    roberts_drawing_free(&c->drawing);
    roberts_regions_free(&c->regions);
}

static size_t labels_with(const cube *c, unsigned labels, char first)
{
    told warnings = {0};
    const roberts_draw_options options = options_of(labels, 0, &warnings);
    size_t count = 0;
    strokes s;
    assert_int_equal(strokes_make(&s, &c->drawing, &options, NULL), ROBERTS_OK);
    assert_int_equal(warnings.count, 0);
    for (size_t i = 0; i < s.notes.count; i++)
        count += notes_line(&s.notes, i).text[0] == first;
    if (!first)
        count = s.notes.count;
    strokes_free(&s);
    return count;
}

static double distance(space_box a, space_box b)
{
    const double x = fmax(fmax(a.min.x - b.max.x, b.min.x - a.max.x), 0.0);
    return hypot(x, fmax(fmax(a.min.y - b.max.y, b.min.y - a.max.y), 0.0));
}

/* No two labels are so near to one another that they read as one, where there is room. */
static void labels_keep_apart(void **state)
{
    static const struct {
        const char *model;
        unsigned labels;
        roberts_page page;
        double least; /* heights of the letters */
    } row[] = {{"models/platonic/dodecahedron.off", ROBERTS_LABEL_VERTICES | ROBERTS_LABEL_FACES, {210, 297, 10}, 0.8},
               {"models/archimedean/cuboctahedron.off",
                ROBERTS_LABEL_VERTICES | ROBERTS_LABEL_EDGES | ROBERTS_LABEL_FACES,
                {120, 120, 10},
                0.55}};
    (void)state;
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        roberts_camera camera = preset_camera("iso");
        told warnings = {0};
        roberts_draw_options options = options_of(row[i].labels, 0, &warnings);
        cube c;
        strokes s;
        see_model(&c, row[i].model, &camera);
        options.page = row[i].page;
        assert_int_equal(strokes_make(&s, &c.drawing, &options, NULL), ROBERTS_OK);
        assert_int_equal(warnings.count, 0);
        assert_int_equal(count_crossed(&s), 0);
        for (size_t k = 0; k < s.notes.count; k++)
            for (size_t m = 0; m < k; m++) {
                const text_line a = notes_line(&s.notes, k), b = notes_line(&s.notes, m);
                if (distance(letters_box(a), letters_box(b)) < row[i].least * a.height_mm)
                    fail_msg("%s is too near to %s", a.text, b.text);
            }
        strokes_free(&s);
        free_cube(&c);
    }
}

/* Whether a line on the page crosses an outline that is seen, and no other line. */
static bool crosses_outline(const roberts_drawing *drawing, const strokes *s, roberts_vec2 a, roberts_vec2 b)
{
    size_t outlines = 0, others = 0;
    for (size_t i = 0; i < drawing->count; i++) {
        const roberts_segment *other = &drawing->segment[i];
        if (space_lines_cross(a, b, page_place(&s->map, other->p0), page_place(&s->map, other->p1)))
            *(other->line == ROBERTS_OUTLINE ? &outlines : &others) += other->state == ROBERTS_VISIBLE;
    }
    return outlines == 1 && others == 0;
}

/* Faces that are narrower than their labels have these beside them, at the end of a leader line with a dot. Then no
 * letter lies on a line, and no leader line goes through letters or across another one. A few leader lines are no
 * thicket, even if all labels need one. A label stands on the paper rather than on another face. */
static void narrow_faces(void **state)
{
    static const roberts_name side[] = {{ROBERTS_LABEL_FACES, 2, 0, "top"}};
    static const struct {
        const char *model;
        roberts_vec3 dir; /* 0: isometric */
        roberts_page page;
        const roberts_name *name;
        size_t names, leaders;
    } row[] = {{"models/chair.off", {0, 0, 0}, {210, 297, 10}, NULL, 0, 11},
               {"models/platonic/cube.off", {0.5, 0.2, 1.2}, {60, 60, 2}, side, 1, 1}};
    (void)state;
    for (size_t n = 0; n < sizeof row / sizeof row[0]; n++) {
        const roberts_camera camera = row[n].dir.z > 0.0 ? (roberts_camera){.dir = row[n].dir} : preset_camera("iso");
        told warnings = {0};
        roberts_draw_options options = options_of(row[n].name ? 0 : ROBERTS_LABEL_FACES, 0, &warnings);
        cube c;
        strokes s;
        options.page = row[n].page;
        options.lettering.name = row[n].name;
        options.lettering.name_count = row[n].names;
        see_model(&c, row[n].model, &camera);
        assert_int_equal(strokes_make(&s, &c.drawing, &options, NULL), ROBERTS_OK);
        assert_int_equal(warnings.count, 0);
        assert_int_equal(count_crossed(&s), 0);
        assert_int_equal(s.notes.lines.count, 2 * row[n].leaders);
        for (size_t i = 0; i < s.notes.lines.count; i += 2) {
            const page_point *p = s.notes.lines.point + s.notes.lines.item[i].first;
            const roberts_vec2 a = {p[0].x / 1000.0, p[0].y / 1000.0}, b = {p[1].x / 1000.0, p[1].y / 1000.0};
            assert_int_equal(s.notes.lines.item[i].count, 2);
            assert_true(s.notes.lines.item[i + 1].closed);
            assert_true(!row[n].name || crosses_outline(&c.drawing, &s, a, b));
            for (size_t k = 0; k < s.notes.count; k++)
                assert_false(goes_through(a, b, letters_box(notes_line(&s.notes, k))));
            for (size_t k = 0; k < i; k += 2) {
                const page_point *q = s.notes.lines.point + s.notes.lines.item[k].first;
                assert_false(space_lines_cross(a, b, (roberts_vec2){q[0].x / 1000.0, q[0].y / 1000.0},
                                               (roberts_vec2){q[1].x / 1000.0, q[1].y / 1000.0}));
            }
        }
        strokes_free(&s);
        free_cube(&c);
    }
}

/* The label of a round body, whose edges are not drawn, belongs in the middle of the body. That of a box, of which
 * three faces of one size are seen, belongs in the highest. */
static void bodies_are_more_than_their_faces(void **state)
{
    static const struct {
        const char *model;
        double x[2], y[2]; /* mm: where the label belongs on a page of 100 x 100 */
    } row[] = {{"models/sphere.off", {47, 53}, {47, 53}}, {"models/platonic/cube.off", {45, 55}, {20, 32}}};
    const roberts_camera camera = preset_camera("iso");
    (void)state;
    for (size_t n = 0; n < sizeof row / sizeof row[0]; n++) {
        told warnings = {0};
        roberts_draw_options options = options_of(0, 0, &warnings);
        targets found = {0};
        cube c;
        strokes s;
        options.page = (roberts_page){100, 100, 2};
        see_model_to(&c, row[n].model, &camera, 30);
        assert_int_equal(strokes_make(&s, &c.drawing, &options, NULL), ROBERTS_OK);
        assert_true(targets_find(&s, ROBERTS_LABEL_BODIES, &found));
        assert_int_equal(found.count, 1);
        const roberts_vec2 at = found.item[0].at;
        if (!(at.x > row[n].x[0] && at.x < row[n].x[1] && at.y > row[n].y[0] && at.y < row[n].y[1]))
            fail_msg("%s: the label belongs at %g, %g", row[n].model, at.x, at.y);
        free(found.item);
        strokes_free(&s);
        free_cube(&c);
    }
}

/* The edge behind the middle of a prism's face is hidden. The face's label, and the dot of its leader line where the
 * face is too narrow for it, keep off that line. */
static void hidden_lines_are_avoided(void **state)
{
    static const char *const text[] = {"1", "a name longer than its face"};
    const roberts_camera camera = {.dir = {0.5, 0.8660254037844386, 0.2}};
    (void)state;
    for (size_t n = 0; n < 2; n++) {
        const roberts_name face = {ROBERTS_LABEL_FACES, 2, 0, text[n]};
        told warnings = {0};
        roberts_draw_options options = options_of(0, 0, &warnings);
        cube c;
        strokes s;
        options.page = (roberts_page){250, 60, 10};
        options.hidden = ROBERTS_HIDDEN_DASHED;
        options.lettering.height_mm = 3.5;
        options.lettering.name = &face;
        options.lettering.name_count = 1;
        see_model(&c, "models/prisms/prism-3.off", &camera);
        assert_int_equal(strokes_make(&s, &c.drawing, &options, NULL), ROBERTS_OK);
        assert_int_equal(s.notes.count, 1);
        assert_int_equal(s.notes.lines.count, 2 * n);
        const page_point *dot = s.notes.lines.point;
        const roberts_vec2 at = n > 0 ? (roberts_vec2){dot->x / 1000.0, dot->y / 1000.0} : (roberts_vec2){0.0, 0.0};
        space_box box = n > 0 ? (space_box){at, at} : letters_box(notes_line(&s.notes, 0));
        const double off = n > 0 ? 0.7 : 0.5 * 3.5; /* mm */
        box = (space_box){{box.min.x - off, box.min.y - off}, {box.max.x + off, box.max.y + off}};
        size_t hidden = 0;
        for (size_t i = 0; i < c.drawing.count; i++) {
            const roberts_segment *line = &c.drawing.segment[i];
            hidden += line->state == ROBERTS_HIDDEN;
            assert_false(goes_through(page_place(&s.map, line->p0), page_place(&s.map, line->p1), box));
        }
        assert_true(hidden > 0);
        strokes_free(&s);
        free_cube(&c);
    }
}

/* A page is cut to the drawing, its labels and the margins. The label of the prism's face stands at the end of a leader
 * line, beside the drawing. A label without room is told once. */
static void cropped_with_labels(void **state)
{
    static const double margin[] = {2.0, 10.0};
    const roberts_camera camera = {.dir = {0.5, 0.8660254037844386, 0.2}};
    (void)state;
    for (size_t n = 0; n < 6; n++) {
        const roberts_name face = {ROBERTS_LABEL_FACES, 2, 0, "a name longer than its face"};
        const bool has_room = n < 4;
        told warnings = {0};
        roberts_draw_options options = options_of(0, 0, &warnings);
        cube c;
        strokes s;
        options.placement.scale = n % 4 > 1 ? 15.0 : 0.0;
        options.page = (roberts_page){has_room ? 250.0 : 60.0, n % 4 > 1 ? 90.0 : 60.0, margin[n % 2]};
        options.crop = true;
        options.lettering = (roberts_lettering){
            .name = &face, .name_count = 1, .height_mm = has_room ? 3.5 : 20.0, .warnings = options.lettering.warnings};
        see_model(&c, "models/prisms/prism-3.off", &camera);
        assert_int_equal(strokes_make(&s, &c.drawing, &options, NULL), ROBERTS_OK);
        assert_int_equal(warnings.count, !has_room);
        assert_int_equal(s.notes.count, has_room);
        const roberts_vec2 a = page_place(&s.map, c.drawing.window_min), b = page_place(&s.map, c.drawing.window_max);
        space_box ink = {{a.x, b.y}, {b.x, a.y}};
        if (has_room) {
            const space_box box = letters_box(notes_line(&s.notes, 0));
            ink = (space_box){{fmin(ink.min.x, box.min.x), fmin(ink.min.y, box.min.y)},
                              {fmax(ink.max.x, box.max.x), fmax(ink.max.y, box.max.y)}};
            assert_true(is_apart(box, (space_box){{a.x, b.y}, {b.x, a.y}}));
        }
        const double m = margin[n % 2], most = m + 1.5; /* mm: some space is kept round letters */
        assert_true(ink.min.x > m - 1e-6 && ink.min.x < most && s.page.width_mm - ink.max.x > m - 1e-6 &&
                    s.page.width_mm - ink.max.x < most);
        assert_true(ink.min.y > m - 1e-6 && ink.min.y < most && s.page.height_mm - ink.max.y > m - 1e-6 &&
                    s.page.height_mm - ink.max.y < most);
        strokes_free(&s);
        free_cube(&c);
    }
}

/* Where more than twenty labels need a leader line, the twenty that cost least get one. */
static void no_thicket(void **state)
{
    static const struct {
        const char *model, *text;
        double scale;
        size_t labels, leaders;
    } row[] = {{"models/archimedean/icosidodecahedron.off", "longer name", 15, 16, 14},
               {"models/archimedean/snub-dodecahedron.off", "name", 25, 25, 20}};
    enum { FACES = 92 };
    const roberts_camera camera = {.dir = {0.5, 0.2, 1.2}};
    (void)state;
    for (size_t n = 0; n < sizeof row / sizeof row[0]; n++) {
        roberts_name name[FACES];
        told warnings = {0};
        roberts_draw_options options = options_of(0, 0, &warnings);
        cube c;
        strokes s;
        for (uint32_t i = 0; i < FACES; i++)
            name[i] = (roberts_name){ROBERTS_LABEL_FACES, i, 0, row[n].text};
        options.page = (roberts_page){200, 200, 10};
        options.placement.scale = row[n].scale;
        options.lettering.name = name;
        options.lettering.name_count = FACES;
        options.lettering.height_mm = 3.5;
        see_model(&c, row[n].model, &camera);
        assert_int_equal(strokes_make(&s, &c.drawing, &options, NULL), ROBERTS_OK);
        assert_int_equal(s.notes.lines.count / 2, row[n].leaders);
        assert_int_equal(s.notes.count, row[n].labels);
        strokes_free(&s);
        free_cube(&c);
    }
}

/* Whether a line that is seen lies between a vertex and its label. */
static bool is_behind_line(const roberts_drawing *drawing, const strokes *s, roberts_vec2 vertex, roberts_vec2 label)
{
    const roberts_vec2 from = {0.9 * vertex.x + 0.1 * label.x, 0.9 * vertex.y + 0.1 * label.y};
    bool found = false;
    for (size_t i = 0; i < drawing->count; i++) {
        const roberts_segment *other = &drawing->segment[i];
        const roberts_vec2 a = page_place(&s->map, other->p0), b = page_place(&s->map, other->p1);
        found = found || (other->state == ROBERTS_VISIBLE && orient2d(a, b, from) * orient2d(a, b, label) < 0.0 &&
                          orient2d(from, label, a) * orient2d(from, label, b) < 0.0);
    }
    return found;
}

/* How many labels of vertices stand behind a line that is seen. */
static size_t count_behind(const roberts_drawing *drawing, const strokes *s)
{
    size_t behind = 0;
    for (size_t i = 0; i < s->notes.count; i++) {
        const text_line line = notes_line(&s->notes, i);
        const unsigned number = (unsigned)strtoul(line.text, NULL, 10);
        const space_box box = letters_box(line);
        for (size_t k = 0; k < drawing->count; k++) {
            const roberts_segment *own = &drawing->segment[k];
            const bool is_start = own->v0 == number && own->t0 == 0.0, is_end = own->v1 == number && own->t1 == 1.0;
            if (own->state != ROBERTS_VISIBLE || (!is_start && !is_end))
                continue;
            behind += is_behind_line(drawing, s, page_place(&s->map, is_start ? own->p0 : own->p1),
                                     (roberts_vec2){0.5 * (box.min.x + box.max.x), 0.5 * (box.min.y + box.max.y)});
            break;
        }
    }
    return behind;
}

/* Vertices have their labels on their own side of all lines where there is room: of the chair's, 88 and 66 stood beyond
 * the edge of a leg. Where three parts meet there is none for all: 8 of 58 stood so, and 4 do. On a small page letters
 * are made smaller for this, as they are to keep off lines. */
static void none_behind_a_line(void **state)
{
    static const struct {
        const char *model, *view;
        roberts_page page;
        roberts_hidden hidden;
        size_t labels, most;
    } row[] = {{"chair", "iso", {210, 297, 10}, ROBERTS_HIDDEN_NONE, 51, 5},
               {"platonic/icosahedron", "dimetric", {60, 60, 3}, ROBERTS_HIDDEN_DASHED, 12, 0}, /* 1 at 3.5 mm */
               {"star/small-stellated-dodecahedron", "trimetric", {60, 60, 3}, ROBERTS_HIDDEN_DASHED, 10, 1}}; /* 3 */
    (void)state;
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        roberts_drawing drawing = model_drawing(row[i].model, row[i].view);
        told warnings = {0};
        roberts_draw_options options = options_of(ROBERTS_LABEL_VERTICES, 0, &warnings);
        strokes s;
        options.page = row[i].page;
        options.hidden = row[i].hidden;
        assert_int_equal(strokes_make(&s, &drawing, &options, NULL), ROBERTS_OK);
        assert_true(s.notes.count >= row[i].labels && count_behind(&drawing, &s) <= row[i].most);
        strokes_free(&s);
        roberts_drawing_free(&drawing);
    }
}

/* Seven vertices and three faces of a cube are seen in isometric view. */
static void kinds_are_told_apart(void **state)
{
    (void)state;
    const unsigned vertices = ROBERTS_LABEL_VERTICES, faces = ROBERTS_LABEL_FACES, bodies = ROBERTS_LABEL_BODIES;
    cube c;
    roberts_camera camera = preset_camera("iso");
    see_cube(&c, &camera);
    assert_int_equal(labels_with(&c, vertices | faces, 'v'), 7);
    assert_int_equal(labels_with(&c, vertices | faces, 'f'), 3);
    assert_int_equal(labels_with(&c, vertices | bodies, 'b'), 1);
    assert_int_equal(labels_with(&c, vertices | ROBERTS_LABEL_EDGES, 'v'), 0);
    assert_int_equal(labels_with(&c, faces, 'f'), 0);
    assert_int_equal(labels_with(&c, faces, 0), 3);
    free_cube(&c);
}

/* A narrow field of view about a corner shows neither the middle of the face, nor those of its edges, nor that corner's
 * neighbours. What it shows of the face and of two edges has labels there. */
static void none_beyond_the_frame(void **state)
{
    (void)state;
    roberts_camera camera = {.projection = ROBERTS_PERSPECTIVE,
                             .eye = {0.9, -30.0, 0.9},
                             .look_at = {0.9, -1.0, 0.9},
                             .has_look_at = true,
                             .fov_degrees = 40.0};
    cube c;
    see_cube(&c, &camera);
    assert_int_equal(labels_with(&c, ROBERTS_LABEL_FACES, 0), 1);
    free_cube(&c);
    camera.fov_degrees = 1.0;
    see_cube(&c, &camera);
    assert_true(c.drawing.framed);
    assert_int_equal(labels_with(&c, ROBERTS_LABEL_FACES, 0), 1);
    assert_int_equal(labels_with(&c, ROBERTS_LABEL_EDGES, 0), 2);
    assert_int_equal(labels_with(&c, ROBERTS_LABEL_VERTICES, 0), 1);
    free_cube(&c);
}

/* What lies in a box, by hand: each line and each other box counts once, however many cells they share; and nothing
 * more is counted where that is enough. */
static void what_lies_in_a_box(void **state)
{
    const space_box asked = {{10, 10}, {40, 20}}, other = {{35, 5}, {60, 18}}, beside = {{40, 10}, {50, 20}},
                    over[] = {{{12, 12}, {30, 14}}, {{12, 13}, {30, 15}}};
    free_space *r = space_new(100, 100, 7, &(space_box){{0, 0}, {100, 100}});
    uint32_t own, number[4];
    space_load load;
    (void)state;
    assert_non_null(r);
    assert_true(space_load_of(r, &asked, UINT32_MAX, 9, INFINITY).mm == 0.0);
    assert_true(isinf(space_load_of(r, &(space_box){{90, 90}, {101, 95}}, UINT32_MAX, 9, INFINITY).mm));
    assert_true(space_add_box(r, &asked, &own));
    assert_true(space_load_of(r, &asked, own, 9, INFINITY).mm == 0.0);
    assert_true(space_add_line(r, (roberts_vec2){0, 15}, (roberts_vec2){100, 15}));
    assert_true(fabs(space_load_of(r, &asked, own, 9, INFINITY).mm - 30.0) < 1e-12);
    assert_true(space_add_box(r, &beside, &number[0]) && space_add_box(r, &other, &number[1]));
    load = space_load_of(r, &asked, own, 9, INFINITY);
    assert_true(load.boxes == 1 && fabs(load.mm - 35.0) < 1e-12);
    load = space_load_of(r, &asked, own, 0, INFINITY); /* no box may lie there: lines do not matter */
    assert_true(load.boxes == 1 && fabs(load.mm - 5.0) < 1e-12);
    load = space_load_of(r, &asked, own, 9, 6.0);
    assert_true(load.mm >= 6.0 && load.mm < 35.0);
    assert_true(space_add_box(r, &over[0], &number[2]) && space_add_box(r, &over[1], &number[3]));
    load = space_load_of(r, &asked, own, 9, INFINITY);
    assert_true(load.boxes == 3 && fabs(load.mm - 39.0) < 1e-12);
    space_drop_box(r, number[1]);
    space_drop_box(r, number[2]);
    load = space_load_of(r, &asked, own, 9, INFINITY);
    assert_true(load.boxes == 1 && fabs(load.mm - 32.0) < 1e-12);
    space_free(r);
}

/* What crosses a line, by hand; each crossing counts once, whatever the cells. */
static void lines_that_cross(void **state)
{
    static const struct {
        roberts_vec2 a, b;
        size_t crossings;
        bool meets;
    } row[] = {{{5, 5}, {5, 95}, 2, false},   {{5, 5}, {95, 95}, 2, true},  {{5, 20}, {95, 20}, 0, false},
               {{5, 21}, {95, 22}, 0, true},  {{5, 5}, {5, 20}, 0, false},  {{5, 5}, {5, 80}, 1, false},
               {{30, 30}, {35, 35}, 0, true}, {{0, 22}, {25, 22}, 0, true}, {{0, 22}, {20, 22}, 0, false}};
    free_space *r = space_new(100, 100, 7, &(space_box){{0, 0}, {100, 100}});
    const space_box box = {{20, 20.5}, {60, 60}};
    uint32_t number;
    (void)state;
    assert_non_null(r);
    assert_true(space_add_line(r, (roberts_vec2){0, 20}, (roberts_vec2){100, 20}));
    assert_true(space_add_line(r, (roberts_vec2){0, 80}, (roberts_vec2){100, 80}));
    assert_true(space_add_box(r, &box, &number));
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        assert_int_equal(space_count_crossings(r, row[i].a, row[i].b), row[i].crossings);
        assert_int_equal(space_count_crossings(r, row[i].b, row[i].a), row[i].crossings);
        assert_int_equal(space_line_meets_boxes(r, row[i].a, row[i].b, UINT32_MAX), row[i].meets);
        assert_false(space_line_meets_boxes(r, row[i].a, row[i].b, number));
    }
    assert_true(space_to_next_box(r, &(space_box){{63, 64}, {70, 70}}, UINT32_MAX, 10.0) == 5.0);
    assert_true(space_to_next_box(r, &(space_box){{63, 64}, {70, 70}}, UINT32_MAX, 4.0) == 4.0);
    assert_true(space_to_next_box(r, &(space_box){{63, 64}, {70, 70}}, number, 10.0) == 10.0);
    assert_true(space_to_next_box(r, &(space_box){{50, 50}, {70, 70}}, UINT32_MAX, 10.0) == 0.0);
    space_free(r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(all_of_a_dodecahedron),
                                       cmocka_unit_test(margins_at_a_scale),
                                       cmocka_unit_test(small_pages),
                                       cmocka_unit_test(small_sheets),
                                       cmocka_unit_test(models_from_a4_to_a0),
                                       cmocka_unit_test(letters_fit_the_room),
                                       cmocka_unit_test(wide_names),
                                       cmocka_unit_test(hidden_and_named),
                                       cmocka_unit_test(vertices_on_lines),
                                       cmocka_unit_test(same_again),
                                       cmocka_unit_test(kinds_are_told_apart),
                                       cmocka_unit_test(none_beyond_the_frame),
                                       cmocka_unit_test(what_lies_in_a_box),
                                       cmocka_unit_test(labels_keep_apart),
                                       cmocka_unit_test(none_behind_a_line),
                                       cmocka_unit_test(fitted_with_its_labels),
                                       cmocka_unit_test(sheet_with_its_labels),
                                       cmocka_unit_test(narrow_faces),
                                       cmocka_unit_test(hidden_lines_are_avoided),
                                       cmocka_unit_test(cropped_with_labels),
                                       cmocka_unit_test(no_thicket),
                                       cmocka_unit_test(bodies_are_more_than_their_faces),
                                       cmocka_unit_test(lines_that_cross)};
    return cmocka_run_group_tests_name("labels", tests, NULL, NULL);
}
