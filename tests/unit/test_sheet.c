/* Sheets: the place of each view, to the micrometre, and of the symbol; one scale; every format; refusals. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/vec.h"
#include "drawing.h"
#include "sheet_views.h"
#include "temporary.h"
#include "testing.h"
#include "whole_file.h"

enum { VIEWS = ROBERTS_SHEET_VIEWS, POINTS = 400, FIGURES = 3 + 3 * 5 /* of the symbol, with dashes and dots */ };

/* A box of 30 by 20 by 10 far from the origin. */
static const char box[] = "OFF\n8 6 0\n110 220 5\n140 220 5\n140 240 5\n110 240 5\n110 220 15\n140 220 15\n140 240 15\n"
                          "110 240 15\n4 0 1 2 3\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

static const double micrometre = 0.00101; /* mm; coordinates are rounded to the nearest */

static void hide_text_views(views *v, const char *off, roberts_sheet_angle angle)
{
    roberts_hide_options options = roberts_hide_options_default();
    options.keep_hidden = true;
    hide_scene_views(v, scene_of_text(off), angle, &options);
}

/* The points of one layer's path. start[i]: the line goes on to another figure with it. */
typedef struct path {
    roberts_vec2 point[POINTS];
    bool start[POINTS];
    size_t count;
} path;

static void read_layer(const char *svg, const char *layer, path *p)
{
    char open[64];
    snprintf(open, sizeof open, "<g id=\"%s\"", layer);
    const char *at = strstr(svg, open);
    p->count = 0;
    if (!at)
        return;
    at = strstr(at, " d=\"") + 4;
    while (*at != '"') {
        double x, y;
        int used = 0;
        char command = *at++;
        if (sscanf(at, " %lf %lf%n", &x, &y, &used) == 2) { /* NOLINT(cert-err34-c): numbers of our own */
            assert_true(p->count < POINTS && (command == 'M' || command == 'L'));
            p->start[p->count] = command == 'M';
            p->point[p->count++] = (roberts_vec2){x, y};
        }
        at += used;
        at += strspn(at, " \n");
    }
}

typedef struct rectangle {
    double left, top, right, bottom; /* mm on the page */
} rectangle;

static const rectangle empty = {INFINITY, INFINITY, -INFINITY, -INFINITY};

static bool is_inside(rectangle r, roberts_vec2 p)
{
    return p.x > r.left - micrometre && p.x < r.right + micrometre && p.y > r.top - micrometre &&
           p.y < r.bottom + micrometre;
}

static void enlarge(rectangle *r, roberts_vec2 p)
{
    *r = (rectangle){fmin(r->left, p.x), fmin(r->top, p.y), fmax(r->right, p.x), fmax(r->bottom, p.y)};
}

static bool is_same(rectangle a, rectangle b)
{
    return fabs(a.left - b.left) < micrometre && fabs(a.top - b.top) < micrometre &&
           fabs(a.right - b.right) < micrometre && fabs(a.bottom - b.bottom) < micrometre;
}

/* ---- places ---- */

/* The isometric view of the box: 50 / sqrt 2 wide, 50 / sqrt 6 + 10 sqrt 2/3 high. */
#define W 35.35533905932738
#define H 28.57738033247041

/* Views of the box, in the order front, top, side, iso, on A4; the strip for the symbol is 15.5 mm high. */
static const struct {
    const char *name;
    roberts_sheet_angle angle;
    roberts_placement placement;
    double gap_mm;
    rectangle view[VIEWS];
} place_cases[] = {
    {"first angle, 1:1, upper left",
     ROBERTS_FIRST_ANGLE,
     {1, 0, -1, 1, false},
     0,
     {{10, 10, 40, 20}, {10, 35, 40, 55}, {55, 10, 75, 20}, {55, 35, 55 + W, 35 + H}}},
    {"third angle, 1:1, upper left",
     ROBERTS_THIRD_ANGLE,
     {1, 0, -1, 1, false},
     0,
     {{10, 25 + H, 40, 35 + H}, {10, H - 10, 40, 10 + H}, {55, 25 + H, 75, 35 + H}, {55, 10, 55 + W, 10 + H}}},
    {"first angle, 1:1, lower right",
     ROBERTS_FIRST_ANGLE,
     {1, 0, 1, -1, false},
     0,
     {{155 - W, 246.5 - H, 185 - W, 256.5 - H},
      {155 - W, 271.5 - H, 185 - W, 291.5 - H},
      {200 - W, 246.5 - H, 220 - W, 256.5 - H},
      {200 - W, 271.5 - H, 200, 271.5}}},
    {"first angle, gap of 1 mm, 1:2 of inches",
     ROBERTS_FIRST_ANGLE,
     {0.5, 2, -1, 1, false},
     1,
     {{10, 10, 40, 20}, {10, 21, 40, 41}, {41, 10, 61, 20}, {41, 21, 41 + W, 21 + H}}},
    {"third angle, fitted by its width, at the bottom",
     ROBERTS_THIRD_ANGLE,
     {0, 0, 0, -1, false},
     0,
     {{10, 271.5 - 10 * 175 / (30 + W), 10 + 30 * 175 / (30 + W), 271.5},
      {10, 256.5 - 30 * 175 / (30 + W), 10 + 30 * 175 / (30 + W), 256.5 - 10 * 175 / (30 + W)},
      {25 + 30 * 175 / (30 + W), 271.5 - 10 * 175 / (30 + W), 25 + 50 * 175 / (30 + W), 271.5},
      {25 + 30 * 175 / (30 + W), 256.5 - (10 + H) * 175 / (30 + W), 200, 256.5 - 10 * 175 / (30 + W)}}},
};

/* Nothing lies outside of the four rectangles, and each is filled. Returns how many points the lines have. */
static size_t assert_places(const char *svg, const char *layer, const rectangle *wanted)
{
    rectangle found[VIEWS] = {empty, empty, empty, empty};
    path lines;
    read_layer(svg, layer, &lines);
    for (size_t k = 0; k < lines.count; k++) {
        int at = 0;
        while (at < VIEWS && !is_inside(wanted[at], lines.point[k]))
            at++;
        if (at == VIEWS)
            fail_msg("%g, %g belongs to no view", lines.point[k].x, lines.point[k].y);
        enlarge(&found[at], lines.point[k]);
    }
    for (int k = 0; k < VIEWS; k++)
        if (!is_same(found[k], wanted[k]))
            fail_msg("view %d: %g %g %g %g", k, found[k].left, found[k].top, found[k].right, found[k].bottom);
    return lines.count;
}

/* The corners of the first three rectangles are there, too. */
static void views_have_their_places(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof place_cases / sizeof place_cases[0]; i++) {
        roberts_draw_options options = roberts_draw_options_default();
        views v;
        print_message("%s\n", place_cases[i].name);
        hide_text_views(&v, box, place_cases[i].angle);
        v.sheet.gap_mm = place_cases[i].gap_mm;
        options.placement = place_cases[i].placement;
        char *svg = sheet_written(&v.sheet, &options).bytes;
        assert_int_equal(assert_places(svg, "outline", place_cases[i].view), 4 + 4 + 4 + 6);
        free(svg);
        free_views(&v);
    }
}

/* A gap also lies beside the views of a flat scene that are mere lines. First angle, 1:1, in the upper left corner. */
static const struct {
    const char *name, *off;
    rectangle view[VIEWS];
} flat_cases[] = {
    {"level",
     "OFF\n4 1 0\n0 0 0\n30 0 0\n30 20 0\n0 20 0\n4 0 1 2 3\n",
     {{10, 10, 40, 10}, {10, 25, 40, 45}, {55, 10, 75, 10}, {55, 25, 55 + W, 45.41241452319315}}},
    {"upright, seen from the side",
     "OFF\n4 1 0\n0 0 0\n0 30 0\n0 30 30\n0 0 30\n4 0 1 2 3\n",
     {{10, 10, 10, 40},
      {10, 55, 10, 85},
      {25, 10, 55, 40},
      {29.393398282201787, 55, 50.606601717798213, 91.742346141747673}}},
};

static void views_of_flat_scenes_stand_apart(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof flat_cases / sizeof flat_cases[0]; i++) {
        roberts_draw_options options = roberts_draw_options_default();
        views v;
        print_message("%s\n", flat_cases[i].name);
        hide_text_views(&v, flat_cases[i].off, ROBERTS_FIRST_ANGLE);
        options.placement = (roberts_placement){1, 0, -1, 1, false};
        char *svg = sheet_written(&v.sheet, &options).bytes;
        assert_places(svg, "border", flat_cases[i].view);
        free(svg);
        free_views(&v);
    }
}

static void assert_same_camera(const roberts_camera *a, const roberts_camera *b)
{
    assert_int_equal(a->projection, b->projection);
    assert_true(vec3_same(a->dir, b->dir) && vec3_same(a->eye, b->eye) && vec3_same(a->up, b->up));
    assert_true(a->has_look_at == b->has_look_at && vec3_same(a->look_at, b->look_at));
    assert_true(a->oblique.x == b->oblique.x && a->oblique.y == b->oblique.y);
    assert_true(a->near_distance == b->near_distance && a->fov_degrees == b->fov_degrees);
    assert_true(a->roll_degrees == b->roll_degrees);
}

/* The isometric view shows the side that the side view shows. */
static void sides_are_the_right_ones(void **state)
{
    static const char *const side[] = {"left", "right"};
    (void)state;
    for (int angle = ROBERTS_FIRST_ANGLE; angle <= ROBERTS_THIRD_ANGLE; angle++) {
        roberts_camera camera, preset;
        assert_true(roberts_sheet_camera((roberts_sheet_angle)angle, ROBERTS_SHEET_SIDE, &camera));
        assert_true(roberts_camera_preset(side[angle], &preset));
        assert_same_camera(&camera, &preset);
        assert_true(roberts_sheet_camera((roberts_sheet_angle)angle, ROBERTS_SHEET_ISO, &camera));
        assert_true(camera.dir.x == (angle == ROBERTS_FIRST_ANGLE ? -1 : 1) && camera.dir.y == -1);
        assert_true(roberts_sheet_camera((roberts_sheet_angle)angle, ROBERTS_SHEET_FRONT, &camera));
        assert_true(roberts_camera_preset("front", &preset));
        assert_same_camera(&camera, &preset);
        assert_true(roberts_sheet_camera((roberts_sheet_angle)angle, ROBERTS_SHEET_TOP, &camera));
        assert_true(roberts_camera_preset("top", &preset));
        assert_same_camera(&camera, &preset);
    }
    roberts_camera camera;
    assert_false(roberts_sheet_camera(ROBERTS_FIRST_ANGLE, VIEWS, &camera));
    assert_false(roberts_sheet_camera(ROBERTS_FIRST_ANGLE, -1, &camera));
}

/* Views that are left out take no room, and neither do their gaps. */
static void views_can_be_left_out(void **state)
{
    views v;
    path lines;
    rectangle found = empty;
    roberts_draw_options options = roberts_draw_options_default();
    (void)state;
    hide_text_views(&v, box, ROBERTS_FIRST_ANGLE);
    v.sheet.view[ROBERTS_SHEET_TOP] = v.sheet.view[ROBERTS_SHEET_ISO] = NULL;
    options.symbol.off = true;
    options.page = (roberts_page){85, 30, 10};
    char *svg = sheet_written(&v.sheet, &options).bytes;
    read_layer(svg, "outline", &lines);
    for (size_t i = 0; i < lines.count; i++)
        enlarge(&found, lines.point[i]);
    assert_true(is_same(found, (rectangle){10, 10, 75, 20}));
    free(svg);
    v.sheet.view[ROBERTS_SHEET_FRONT] = v.sheet.view[ROBERTS_SHEET_SIDE] = NULL;
    svg = sheet_written(&v.sheet, &options).bytes;
    read_layer(svg, "outline", &lines);
    assert_int_equal(lines.count, 0);
    free(svg);
    free_views(&v);
}

/* ---- the page ---- */

/* Fitted, the views fill the area left by margins, frame and symbol, in width or in height. */
static const struct {
    const char *name;
    roberts_page page;
    bool frame, symbol;
    rectangle room;
} fit_cases[] = {
    {"upright", {210, 297, 10}, false, true, {10, 10, 200, 271.5}},
    {"lying", {297, 210, 10}, false, true, {10, 10, 287, 184.5}},
    {"no symbol", {297, 210, 10}, false, false, {10, 10, 287, 200}},
    {"frame", {297, 210, 10}, true, true, {20, 20, 277, 179.5}},
    {"frame, no symbol", {297, 210, 5}, true, false, {15, 15, 282, 195}},
    {"a smaller symbol, for its width", {55, 100, 5}, false, true, {5, 5, 50, 95 - 5 - 10.5 * 15 / 22.75}},
    {"a smaller symbol, for its height", {120, 49, 5}, false, true, {5, 5, 115, 44 - 5 - 19.0 / 3}},
    {"none, for its width", {48.3, 100, 5}, false, true, {5, 5, 43.3, 95}},
    {"none, for its height", {120, 46.1, 5}, false, true, {5, 5, 115, 41.1}},
    {"as narrow as the symbol", {42, 297, 10}, false, true, {10, 10, 32, 287}},
};

static void sheets_fill_the_page(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof fit_cases / sizeof fit_cases[0]; i++)
        for (int angle = ROBERTS_FIRST_ANGLE; angle <= ROBERTS_THIRD_ANGLE; angle++) {
            const rectangle room = fit_cases[i].room;
            rectangle found = empty;
            roberts_draw_options options = roberts_draw_options_default();
            views v;
            path lines;
            print_message("%s\n", fit_cases[i].name);
            hide_text_views(&v, box, (roberts_sheet_angle)angle);
            options.page = fit_cases[i].page;
            options.frame.off = !fit_cases[i].frame;
            options.symbol.off = !fit_cases[i].symbol;
            char *svg = sheet_written(&v.sheet, &options).bytes;
            read_layer(svg, "outline", &lines);
            for (size_t k = 0; k < lines.count; k++)
                enlarge(&found, lines.point[k]);
            bool wide = fabs(found.left - room.left) < micrometre && fabs(found.right - room.right) < micrometre;
            bool high = fabs(found.top - room.top) < micrometre && fabs(found.bottom - room.bottom) < micrometre;
            assert_true(wide || high);
            assert_true(fabs(found.left + found.right - room.left - room.right) < 2 * micrometre);
            assert_true(fabs(found.top + found.bottom - room.top - room.bottom) < 2 * micrometre);
            assert_true(is_inside(room, (roberts_vec2){found.left, found.top}));
            assert_true(is_inside(room, (roberts_vec2){found.right, found.bottom}));
            free(svg);
            free_views(&v);
        }
}

/* Cone: a quadrangle, narrow on the left; circles: 48 corners each. In first angle the circles are right of it. */
static void symbols_tell_the_angle(void **state)
{
    (void)state;
    for (int angle = ROBERTS_FIRST_ANGLE; angle <= ROBERTS_THIRD_ANGLE; angle++) {
        rectangle figure[FIGURES], all = empty;
        size_t corners[FIGURES], figures = 0;
        roberts_draw_options options = roberts_draw_options_default();
        views v;
        path lines;
        hide_text_views(&v, box, (roberts_sheet_angle)angle);
        char *svg = sheet_written(&v.sheet, &options).bytes;
        read_layer(svg, "symbol", &lines);
        for (size_t i = 0; i < lines.count; i++) {
            if (lines.start[i]) {
                assert_true(figures < FIGURES);
                figure[figures] = empty;
                corners[figures++] = 0;
            }
            corners[figures - 1]++;
            enlarge(&figure[figures - 1], lines.point[i]);
            enlarge(&all, lines.point[i]);
        }
        assert_true(is_same(all, (rectangle){177.25, 276.5, 200, 287}));
        bool first = angle == ROBERTS_FIRST_ANGLE;
        double cone = first ? 182.5 : 194.75, circle = first ? 194.75 : 182.5, level = 281.75;
        assert_int_equal(corners[0], 4);
        assert_true(is_same(figure[0], (rectangle){cone - 3.5, level - 3.5, cone + 3.5, level + 3.5}));
        for (int i = 0; i < 4; i++)
            assert_true(fabs(fabs(lines.point[i].y - level) - (lines.point[i].x < cone ? 1.75 : 3.5)) < micrometre);
        int circles = 0;
        for (size_t i = 1; i < figures; i++)
            if (corners[i] > 2) {
                double radius = circles++ ? 3.5 : 1.75;
                assert_int_equal(corners[i], 48);
                assert_true(
                    is_same(figure[i], (rectangle){circle - radius, level - radius, circle + radius, level + radius}));
            }
        assert_int_equal(circles, 2);
        assert_int_equal(figures, FIGURES);
        free(svg);
        free_views(&v);
    }
}

/* It is no larger than one of four cells, and is not drawn at all below about half its size. */
static const struct {
    roberts_page page;
    double size;
} symbol_cases[] = {
    {{70.5, 61.5, 5}, 1},
    {{70.4, 61.5, 5}, 22.7 / 22.75},
    {{70.5, 61.4, 5}, 31.4 / 31.5},
    {{48.5, 100, 5}, 11.75 / 22.75},
    {{48.3, 100, 5}, 0},
    {{120, 46.3, 5}, 16.3 / 31.5},
    {{120, 46.1, 5}, 0},
    {{40, 30, 5}, 0},
};

static void symbols_go_with_the_page(void **state)
{
    views v;
    (void)state;
    hide_text_views(&v, box, ROBERTS_FIRST_ANGLE);
    for (size_t i = 0; i < sizeof symbol_cases / sizeof symbol_cases[0]; i++) {
        const roberts_page page = symbol_cases[i].page;
        const double right = page.width_mm - page.margin_mm, low = page.height_mm - page.margin_mm;
        const double size = symbol_cases[i].size;
        rectangle all = empty;
        roberts_draw_options options = roberts_draw_options_default();
        path lines;
        options.page = page;
        char *svg = sheet_written(&v.sheet, &options).bytes;
        read_layer(svg, "symbol", &lines);
        for (size_t k = 0; k < lines.count; k++)
            enlarge(&all, lines.point[k]);
        print_message("%g x %g: %zu points\n", page.width_mm, page.height_mm, lines.count);
        assert_int_equal(lines.count > 0, size > 0.0);
        assert_true(size == 0.0 || is_same(all, (rectangle){right - 22.75 * size, low - 10.5 * size, right, low}));
        free(svg);
    }
    free_views(&v);
}

static size_t count(const char *text, const char *word)
{
    size_t found = 0;
    for (; (text = strstr(text, word)); text++)
        found++;
    return found;
}

static void all_views_share_the_layers(void **state)
{
    static const char *const layers[] = {"outline", "crease", "hidden", "frame", "symbol"};
    roberts_draw_options options = roberts_draw_options_default();
    roberts_ink ink;
    views v;
    char open[64];
    (void)state;
    hide_text_views(&v, box, ROBERTS_FIRST_ANGLE);
    options.hidden = ROBERTS_HIDDEN_DASHED;
    options.frame.off = false;
    options.placement.scale = 2;
    options.ink = &ink;
    char *svg = sheet_written(&v.sheet, &options).bytes;
    assert_int_equal(count(svg, "<g "), 5);
    for (int i = 0; i < 5; i++) {
        snprintf(open, sizeof open, "<g id=\"%s\" inkscape:groupmode=\"layer\" inkscape:label=\"%s\">", layers[i],
                 layers[i]);
        assert_int_equal(count(svg, open), 1);
    }
    assert_true(ink.scale == 2.0);
    free(svg);
    free_views(&v);
}

/* ---- formats and failures ---- */

static void every_page_format(void **state)
{
    static const struct {
        roberts_format format;
        const char *begins;
    } formats[] = {{ROBERTS_SVG, "<?xml"},
                   {ROBERTS_PDF, "%PDF-"},
                   {ROBERTS_PS, "%!PS-Adobe"},
                   {ROBERTS_EPS, "%!PS-Adobe"},
                   {ROBERTS_PNG, "\x89PNG"}};
    views v;
    (void)state;
    hide_text_views(&v, box, ROBERTS_THIRD_ANGLE);
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++) {
        roberts_draw_options options = roberts_draw_options_default();
        options.format = formats[i].format;
        sink one = sheet_written(&v.sheet, &options), two = sheet_written(&v.sheet, &options);
        assert_memory_equal(one.bytes, formats[i].begins, strlen(formats[i].begins));
        assert_int_equal(one.size, two.size);
        assert_memory_equal(one.bytes, two.bytes, one.size);
        free(one.bytes);
        free(two.bytes);
    }
    free_views(&v);
}

/* The rows of each view are those of its own table, after the view's name. */
static void tables_name_the_views(void **state)
{
    static const char *const names[2][4] = {{"front", "top", "left", "iso"}, {"front", "top", "right", "iso"}};
    (void)state;
    for (int angle = 0; angle < 2; angle++)
        for (int without_top = 0; without_top < 2; without_top++) {
            roberts_draw_options options = roberts_draw_options_default();
            views v;
            hide_text_views(&v, box, angle ? ROBERTS_THIRD_ANGLE : ROBERTS_FIRST_ANGLE);
            options.format = ROBERTS_CSV;
            options.column_count = 1;
            options.column[0] = ROBERTS_COLUMN_DEPTH;
            if (without_top)
                v.sheet.view[ROBERTS_SHEET_TOP] = NULL;
            char *sheet = sheet_written(&v.sheet, &options).bytes;
            const char *at = sheet;
            assert_memory_equal(at, "view,body,v0,", 13);
            at = strchr(at, '\n') + 1;
            for (int i = 0; i < ROBERTS_SHEET_VIEWS; i++) {
                if (!v.sheet.view[i])
                    continue;
                char *own = drawing_written(&v.drawing[i], &options).bytes;
                assert_non_null(strstr(own, ",z0,z1\n"));
                for (const char *row = strchr(own, '\n') + 1; *row; row = strchr(row, '\n') + 1) {
                    const size_t length = strcspn(row, "\n") + 1, name = strlen(names[angle][i]);
                    assert_memory_equal(at, names[angle][i], name);
                    assert_int_equal(at[name], ',');
                    assert_memory_equal(at + name + 1, row, length);
                    at += name + 1 + length;
                }
                free(own);
            }
            assert_int_equal(*at, '\0');
            free(sheet);
            options.format = ROBERTS_JSON;
            sheet = sheet_written(&v.sheet, &options).bytes;
            assert_memory_equal(sheet, "[\n{\"view\":\"front\",\"body\":", 25);
            assert_non_null(
                strstr(sheet, angle ? "\n{\"view\":\"right\",\"body\":" : "\n{\"view\":\"left\",\"body\":"));
            free(sheet);
            free_views(&v);
        }
}

static const struct {
    const char *name;
    roberts_format format;
    roberts_page page;
    roberts_placement placement;
    double gap_mm;
    const char *message;
} refused_cases[] = {
    {"too large",
     ROBERTS_SVG,
     {210, 297, 10},
     {4, 1, 0, 0, false},
     0,
     "at 4:1 the drawing is 277 x 170 mm and would leave the page, whose margins leave 190 x 261; 2.67:1 would fit"},
    {"2.68:1", ROBERTS_SVG, {210, 297, 10}, {2.68, 1, 0, 0, false}, 0, "2.67:1 would fit"},
    {"a stamp", ROBERTS_PDF, {40, 25, 5}, {0, 0, 0, 0, false}, 0, "page: margins and gaps leave no room"},
    {"as wide as the gap", ROBERTS_PDF, {210, 297, 10}, {0, 0, 0, 0, false}, 190, "leave no room"},
    {"negative gap", ROBERTS_SVG, {210, 297, 10}, {0, 0, 0, 0, false}, -1, "sheet: its gap has 0 to 1000 mm"},
    {"gap not a number", ROBERTS_SVG, {210, 297, 10}, {0, 0, 0, 0, false}, NAN, "sheet: its gap has 0 to 1000 mm"},
    {"scale not a number", ROBERTS_SVG, {210, 297, 10}, {NAN, 0, 0, 0, false}, 0, "placement"},
    {"no page", ROBERTS_SVG, {0, 297, 10}, {0, 0, 0, 0, false}, 0, "page: each side"},
};

static void what_makes_no_sheet_is_refused(void **state)
{
    views v;
    (void)state;
    hide_text_views(&v, box, ROBERTS_FIRST_ANGLE);
    for (size_t i = 0; i < sizeof refused_cases / sizeof refused_cases[0]; i++) {
        roberts_draw_options options = roberts_draw_options_default();
        roberts_error error = {0};
        sink to = {0};
        options.format = refused_cases[i].format;
        options.page = refused_cases[i].page;
        options.placement = refused_cases[i].placement;
        v.sheet.gap_mm = refused_cases[i].gap_mm;
        print_message("%s\n", refused_cases[i].name);
        assert_int_equal(roberts_sheet_write(&v.sheet, &options, sink_write, &to, &error), ROBERTS_BAD_ARGUMENT);
        if (!strstr(error.message, refused_cases[i].message))
            fail_msg("%s", error.message);
        assert_null(to.bytes);
    }
    v.sheet.gap_mm = 0;
    v.drawing[ROBERTS_SHEET_SIDE].segment[0].p1.y = NAN;
    assert_int_equal(roberts_sheet_write(&v.sheet, NULL, sink_write, &(sink){0}, NULL), ROBERTS_BAD_NUMBER);
    free_views(&v);
}

/* Scenes of any size give the same sheet. */
static void size_changes_nothing(void **state)
{
    static const double scales[] = {1e140, 1e-140};
    char off[1024];
    views v;
    (void)state;
    hide_text_views(&v, "OFF\n4 4 0\n0 0 0\n3 0 0\n0 2 0\n0 0 1\n3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n",
                    ROBERTS_THIRD_ANGLE);
    char *wanted = sheet_written(&v.sheet, NULL).bytes;
    free_views(&v);
    for (size_t i = 0; i < 2; i++) {
        double s = scales[i];
        snprintf(off, sizeof off, "OFF\n4 4 0\n0 0 0\n%g 0 0\n0 %g 0\n0 0 %g\n3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n",
                 3 * s, 2 * s, s);
        hide_text_views(&v, off, ROBERTS_THIRD_ANGLE);
        char *found = sheet_written(&v.sheet, NULL).bytes;
        assert_string_equal(found, wanted);
        free(found);
        free_views(&v);
    }
    free(wanted);
}

static void saved_as_written(void **state)
{
    views v;
    char path_name[TEMPORARY_ROOM + 10];
    size_t size;
    roberts_error error = {0};
    (void)state;
    snprintf(path_name, sizeof path_name, "%s/sheet.svg", temporary);
    hide_text_views(&v, box, ROBERTS_FIRST_ANGLE);
    char *wanted = sheet_written(&v.sheet, NULL).bytes;
    assert_int_equal(roberts_sheet_save(&v.sheet, NULL, path_name, NULL), ROBERTS_OK);
    char *bytes = whole_file(path_name, &size);
    assert_string_equal(bytes, wanted);
    assert_int_equal(roberts_sheet_save(&v.sheet, NULL, "/no/such/folder/a.svg", &error), ROBERTS_IO);
    assert_string_equal(error.file, "/no/such/folder/a.svg");
    free(wanted);
    free(bytes);
    free_views(&v);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(views_have_their_places),
        cmocka_unit_test(views_of_flat_scenes_stand_apart),
        cmocka_unit_test(sides_are_the_right_ones),
        cmocka_unit_test(views_can_be_left_out),
        cmocka_unit_test(sheets_fill_the_page),
        cmocka_unit_test(symbols_tell_the_angle),
        cmocka_unit_test(symbols_go_with_the_page),
        cmocka_unit_test(all_views_share_the_layers),
        cmocka_unit_test(every_page_format),
        cmocka_unit_test(tables_name_the_views),
        cmocka_unit_test(what_makes_no_sheet_is_refused),
        cmocka_unit_test(size_changes_nothing),
        cmocka_unit_test_setup_teardown(saved_as_written, temporary_make, temporary_remove),
    };
    return cmocka_run_group_tests_name("sheet", tests, NULL, NULL);
}
