/* The SVG as other programs draw it. The pictures of librsvg, Inkscape and Chromium are compared with each other and
 * with our own, which Cairo draws without the file. A program that is not installed is skipped. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cairo.h>

#include "drawing.h"
#include "drawn_surface.h"
#include "temporary.h"
#include "testing.h"

/* ---- two pictures beside each other ---- */

/* Ink is measured in completely black pixels. */
typedef struct likeness {
    int width, height;
    double ink;        /* of the first picture */
    double difference; /* sum over all pixels */
    double pixel;      /* the greatest one of a pixel: at most 1 */
    double block;      /* ... of the ink in a block of BLOCK x BLOCK pixels */
    bool same_size;    /* but for one pixel, for sizes that are no whole number of them */
} likeness;

/* Fraction of all ink by which pictures may differ: each renderer rounds coverage and coordinates in its own way.
 * Measured: librsvg, which draws with Cairo as we do, under 0.001; Chromium 0.012 to 0.023. */
#define INK_PART 0.03

/* By how much a pixel may differ between renderers that both use Cairo; a stroke missing or moved by half a pixel has
 * more. */
#define PIXEL_MOST 0.375

/* Where strokes cross or meet at a sharp angle, Chromium fills single pixels that Cairo leaves white, or the other way
 * round. So its ink is compared in blocks, at 192 dpi (7.56 pixels a mm). The finest stroke, 0.25 mm, has 15 pixels of
 * ink in a block that it passes through; 0.35 mm instead of 0.25 make 6, 0.5 instead of 0.35 make 9. Measured: up
 * to 2.2. */
enum { BLOCK = 8, PIXELS = 4000 /* in a row, at the most */ };
#define BLOCK_MOST 3.8

/* How bright a pixel is, 0 to 255, by its green: outlines are red here. */
static int green(uint32_t pixel)
{
    return (int)(pixel >> 8 & 255);
}

/* Adds what the two rows of pixels have to what has been found, and to `sum` by how much each block differs. */
static void add_row(likeness *found, const uint32_t *a, const uint32_t *b, int *sum)
{
    int ink = 0, difference = 0, most = 0;
    for (int x = 0; x < found->width; x++) {
        const int d = green(b[x]) - green(a[x]);
        ink += 255 - green(a[x]);
        difference += abs(d);
        most = abs(d) > most ? abs(d) : most;
        sum[x / BLOCK] += d;
    }
    found->ink += ink / 255.0;
    found->difference += difference / 255.0;
    found->pixel = fmax(found->pixel, most / 255.0);
}

static likeness compare(cairo_surface_t *a, cairo_surface_t *b)
{
    int wa = cairo_image_surface_get_width(a), wb = cairo_image_surface_get_width(b);
    int ha = cairo_image_surface_get_height(a), hb = cairo_image_surface_get_height(b);
    int sum[PIXELS / BLOCK];
    likeness found = {
        .width = wa < wb ? wa : wb, .height = ha < hb ? ha : hb, .same_size = abs(wa - wb) <= 1 && abs(ha - hb) <= 1};
    assert_in_range(found.width, 1, PIXELS);
    for (int y = 0; y < found.height; y++) {
        if (y % BLOCK == 0)
            memset(sum, 0, sizeof sum);
        add_row(&found, surface_row(a, y), surface_row(b, y), sum);
        for (int k = 0; k * BLOCK < found.width && (y % BLOCK == BLOCK - 1 || y == found.height - 1); k++)
            found.block = fmax(found.block, abs(sum[k]) / 255.0);
    }
    return found;
}

/* `by_pixel`: held to PIXEL_MOST as well. */
static bool is_alike(const likeness *l, bool by_pixel)
{
    return l->same_size && l->ink > 100.0 && l->difference < INK_PART * l->ink && l->block < BLOCK_MOST &&
           (!by_pixel || l->pixel < PIXEL_MOST);
}

/* Destroys both. */
static void assert_alike(const char *what, cairo_surface_t *first, cairo_surface_t *second, bool by_pixel)
{
    likeness l = compare(first, second);
    cairo_surface_destroy(first);
    cairo_surface_destroy(second);
    print_message("%s: %d x %d, ink %.0f, difference %.1f, worst pixel %.2f, worst block %.2f\n", what, l.width,
                  l.height, l.ink, l.difference, l.pixel, l.block);
    if (!is_alike(&l, by_pixel))
        fail_msg("%s: the pictures differ", what);
}

/* ---- what is drawn ---- */

static const double mm_per_inch = 25.4;

static const struct {
    const char *model;
    roberts_hidden hidden;
    bool frame, real_dashes, shrunk; /* at 1:2 in the lower left */
    roberts_background background;
} cases[] = {
    {"platonic/cube", ROBERTS_HIDDEN_DASHED, false, false, false, {0}},
    {"table", ROBERTS_HIDDEN_DASHED, true, false, false, {0}},
    {"table", ROBERTS_HIDDEN_DASHED, false, true, false, {0}},
    {"temple", ROBERTS_HIDDEN_NONE, true, false, true, {0}},
    {"interpenetrating-cubes", ROBERTS_HIDDEN_SOLID, false, false, false, {0}},
    {"table", ROBERTS_HIDDEN_NONE, false, false, true, {true, 255, 128, 0}},
};

enum { CASES = sizeof cases / sizeof cases[0] };

static roberts_draw_options options_of(size_t i)
{
    roberts_draw_options options = roberts_draw_options_default();
    options.hidden = cases[i].hidden;
    options.frame.off = !cases[i].frame;
    options.real_dashes = cases[i].real_dashes;
    options.outline.red = 255;
    options.background = cases[i].background;
    options.title = "<&>";
    if (cases[i].shrunk)
        options.placement = (roberts_placement){.scale = 0.5, .unit_mm = 1, .align_x = -1, .align_y = -1};
    return options;
}

/* 8 x 8 inches at 192 dpi: a whole number of a browser's pixels, each of two by two. Browsers stretch an SVG to
 * whole pixels: A4 (793.7 of them) by up to a third of one, which would look like a shift of our drawing. */
static roberts_draw_options options_for_browser(size_t i)
{
    roberts_draw_options options = options_of(i);
    options.page.width_mm = options.page.height_mm = 203.2;
    options.dpi = 192;
    return options;
}

static char *path(const char *name)
{
    static char text[4][TEMPORARY_ROOM + 44]; /* as many as are needed at a time */
    static int next;
    char *to = text[next++ % 4];
    snprintf(to, sizeof text[0], "%s/%s", temporary, name);
    return to;
}

static void save(const roberts_drawing *drawing, roberts_draw_options options, roberts_format format, const char *name)
{
    options.format = format;
    assert_int_equal(roberts_drawing_save(drawing, &options, path(name), NULL), ROBERTS_OK);
}

/* The picture without a file; test_image.c shows that a PNG holds the same. */
static cairo_surface_t *drawn(const roberts_drawing *drawing, const roberts_draw_options *options)
{
    const double pixels_per_mm = options->dpi / mm_per_inch;
    strokes s;
    assert_int_equal(strokes_make(&s, drawing, options, NULL), ROBERTS_OK);
    cairo_surface_t *surface = drawn_surface(&s, (int)ceil(options->page.width_mm * pixels_per_mm),
                                             (int)ceil(options->page.height_mm * pixels_per_mm));
    strokes_free(&s);
    return surface;
}

/* A picture in the folder. */
static cairo_surface_t *picture(const char *name)
{
    cairo_surface_t *image = cairo_image_surface_create_from_png(path(name));
    assert_int_equal(cairo_surface_status(image), CAIRO_STATUS_SUCCESS);
    return image;
}

/* ---- librsvg ---- */

static bool has_librsvg(void)
{
    return system("rsvg-convert --version >/dev/null 2>&1") == 0;
}

static void run_librsvg(const char *name, double dpi)
{
    char command[4 * TEMPORARY_ROOM];
    snprintf(command, sizeof command, "rsvg-convert -d %g -p %g -b white -o '%s' '%s'", dpi, dpi, path("librsvg.png"),
             path(name));
    assert_int_equal(system(command), 0);
}

static void librsvg_sees_the_same(void **state)
{
    (void)state;
    if (!has_librsvg()) {
        SKIP_BECAUSE("no rsvg-convert");
    }
    for (size_t i = 0; i < CASES; i++) {
        roberts_drawing drawing = model_drawing(cases[i].model, "iso");
        roberts_draw_options options = options_of(i);
        options.dpi = 127; /* 5 pixels a mm */
        save(&drawing, options, ROBERTS_SVG, "a.svg");
        save(&drawing, options, ROBERTS_PNG, "own.png");
        run_librsvg("a.svg", options.dpi);
        assert_alike(cases[i].model, picture("own.png"), picture("librsvg.png"), true);
        roberts_drawing_free(&drawing);
    }
}

/* ---- Inkscape ---- */

/* It draws with Cairo as well, and knows the layers by name. */
static void inkscape_sees_the_same(void **state)
{
    (void)state;
    const size_t table = 1;
    char command[600];
    snprintf(command, sizeof command, "HOME='%s' inkscape --version >/dev/null 2>&1", temporary);
    if (system(command) != 0) {
        SKIP_BECAUSE("no Inkscape");
    }
    roberts_drawing drawing = model_drawing(cases[table].model, "iso");
    roberts_draw_options options = options_for_browser(table);
    save(&drawing, options, ROBERTS_SVG, "a.svg");
    save(&drawing, options, ROBERTS_PNG, "own.png");
    snprintf(
        command, sizeof command,
        "cd '%s' && HOME=$PWD inkscape -d 192 -b white -o inkscape.png a.svg 2>/dev/null && test -s inkscape.png && "
        "HOME=$PWD inkscape --query-all a.svg 2>/dev/null | grep -c -E '^(hidden|crease|outline|frame),' | grep -qx 4",
        temporary);
    assert_int_equal(system(command), 0);
    assert_alike(cases[table].model, picture("own.png"), picture("inkscape.png"), true);
    roberts_drawing_free(&drawing);
}

/* ---- the comparison itself ---- */

/* Draws once more, with something changed: the comparison must find it. */
static void assert_seen(const char *what, cairo_surface_t *own, const roberts_drawing *drawing,
                        const roberts_draw_options *options)
{
    cairo_surface_t *changed = drawn(drawing, options);
    likeness l = compare(own, changed);
    cairo_surface_destroy(changed);
    if (is_alike(&l, false))
        fail_msg("not seen: %s (difference %.1f of %.0f, worst block %.2f)", what, l.difference, l.ink, l.block);
}

/* Each visible segment of two cubes left out in turn. */
static void a_missing_line_is_seen(void **state)
{
    (void)state;
    const size_t two_cubes = 4;
    roberts_drawing drawing = model_drawing(cases[two_cubes].model, "iso");
    roberts_draw_options options = options_for_browser(two_cubes);
    options.hidden = ROBERTS_HIDDEN_NONE;
    drawing.framed = true; /* the rest stays in its place */
    cairo_surface_t *own = drawn(&drawing, &options);
    size_t left_out = 0;
    for (size_t i = 0; i < drawing.count; i++) {
        char what[40];
        if (drawing.segment[i].state != ROBERTS_VISIBLE)
            continue;
        snprintf(what, sizeof what, "segment %zu left out", i);
        drawing.segment[i].state = ROBERTS_HIDDEN;
        assert_seen(what, own, &drawing, &options);
        drawing.segment[i].state = ROBERTS_VISIBLE;
        left_out++;
    }
    assert_true(left_out > 10);
    cairo_surface_destroy(own);
    roberts_drawing_free(&drawing);
}

static void a_wrong_pen_is_seen(void **state)
{
    (void)state;
    const size_t table = 1;
    roberts_drawing drawing = model_drawing(cases[table].model, "iso");
    const roberts_draw_options options = options_for_browser(table);
    roberts_draw_options changed = options;
    cairo_surface_t *own = drawn(&drawing, &options);
    changed.outline.width_mm = options.crease.width_mm;
    assert_seen("outlines as fine as creases", own, &drawing, &changed);
    changed = options;
    changed.crease.width_mm = options.back.width_mm;
    assert_seen("creases as fine as hidden lines", own, &drawing, &changed);
    changed = options;
    changed.back.off = true;
    assert_seen("no hidden lines", own, &drawing, &changed);
    changed = options;
    changed.back.dash_mm *= 1.2;
    assert_seen("longer dashes", own, &drawing, &changed);
    changed = options;
    changed.hidden = ROBERTS_HIDDEN_SOLID;
    assert_seen("no dashes", own, &drawing, &changed);
    changed = options;
    changed.frame.off = true;
    assert_seen("no frame", own, &drawing, &changed);
    changed = options;
    changed.outline.red = 0;
    changed.outline.green = 255;
    assert_seen("green outlines", own, &drawing, &changed);
    cairo_surface_destroy(own);
    roberts_drawing_free(&drawing);
}

/* ---- fills ---- */

/* Faces shaded from dark to middle grey, without any line. */
#define GREY 128

/* Seams end half of their width before the paper, so that they do not stick out. */
static const double seam_mm = 0.4;

/* How far from paper there may be a mixture of colours, in pixels. */
static int pixels_near_paper(double dpi)
{
    return 2 + (int)ceil(seam_mm / 2.0 * dpi / mm_per_inch);
}

static bool is_near_paper(cairo_surface_t *image, int x, int y, int near)
{
    const int width = cairo_image_surface_get_width(image), height = cairo_image_surface_get_height(image);
    for (int v = y - near; v <= y + near; v++)
        for (int u = x - near; u <= x + near; u++)
            if (u < 0 || v < 0 || u >= width || v >= height || green(surface_row(image, v)[u]) == 255)
                return true;
    return false;
}

/* How much brighter than two faces a mixture of them may be, of 255, as colours are rounded. Paper that is seen to one
 * part in fifty adds more than 2. Chromium mixes in two steps and rounds in each. */
enum { CAIRO_ROUNDING = 1, CHROMIUM_ROUNDING = 2 };

/* Counts the pixels that are brighter than any face, but not next to the paper: it shines through. Destroys the image.
 */
static size_t hairlines(cairo_surface_t *image, double dpi, int rounding, size_t *inside)
{
    const int width = cairo_image_surface_get_width(image), height = cairo_image_surface_get_height(image);
    size_t found = 0;
    *inside = 0;
    for (int y = 0; y < height; y++) {
        const uint32_t *row = surface_row(image, y);
        for (int x = 0; x < width; x++) {
            const int value = green(row[x]);
            found += value > GREY + rounding && value < 255 && !is_near_paper(image, x, y, pixels_near_paper(dpi));
            *inside += value < 255;
        }
    }
    cairo_surface_destroy(image);
    return found;
}

/* The drawing of a model with its regions and options that show nothing but fills. The scene is freed at once. */
static roberts_drawing filled_drawing(const char *model, roberts_region_list *regions, roberts_draw_options *options)
{
    char name[100];
    roberts_mesh mesh = {0};
    roberts_scene *scene;
    snprintf(name, sizeof name, "models/%s.off", model);
    roberts_camera camera = preset_camera("iso");
    assert_int_equal(roberts_mesh_read_file(&mesh, name, NULL, NULL), ROBERTS_OK);
    assert_int_equal(roberts_scene_take(&mesh, NULL, &scene, NULL), ROBERTS_OK);
    roberts_drawing drawing = drawing_of(scene, &camera, NULL);
    assert_int_equal(roberts_regions(scene, &camera, NULL, regions, NULL), ROBERTS_OK);
    roberts_scene_free(scene);
    roberts_mesh_free(&mesh);
    drawing.regions = regions;
    *options = options_for_browser(0);
    options->fill = ROBERTS_FILL_COLOR;
    options->fill_color[0] = options->fill_color[1] = options->fill_color[2] = GREY;
    options->shaded = true;
    options->outline.off = options->crease.off = options->intersection.off = options->border.off = true;
    return drawing;
}

static void assert_no_hairlines(const char *what, cairo_surface_t *image, double dpi, int rounding)
{
    size_t inside, found = hairlines(image, dpi, rounding, &inside);
    print_message("%s, %g dpi: %zu pixels inside\n", what, dpi, inside);
    assert_true(inside > 1000);
    if (found > 0)
        fail_msg("%s, %g dpi: paper shines through in %zu pixels of %zu", what, dpi, found, inside);
}

/* Takes the seams out of the file; then it has hairlines. */
static void remove_seams(const char *name)
{
    char command[3 * TEMPORARY_ROOM];
    snprintf(command, sizeof command, "sed -i 's/stroke-width=\"0.4\"/stroke-width=\"0\"/' '%s'", path(name));
    assert_int_equal(system(command), 0);
}

static void no_paper_shines_through(void **state)
{
    static const char *const models[] = {"compound-of-five-tetrahedra", "shapes/torus", "shapes/terrain",
                                         "star/great-icosahedron", "stacked-blocks"};
    static const double dpis[] = {96, 131, 300};
    const bool librsvg = has_librsvg();
    (void)state;
    for (size_t i = 0; i < sizeof models / sizeof models[0]; i++) {
        roberts_region_list regions;
        roberts_draw_options options;
        roberts_drawing drawing = filled_drawing(models[i], &regions, &options);
        save(&drawing, options, ROBERTS_SVG, "a.svg");
        for (size_t d = 0; d < sizeof dpis / sizeof dpis[0]; d++) {
            options.dpi = dpis[d];
            assert_no_hairlines(models[i], drawn(&drawing, &options), dpis[d], CAIRO_ROUNDING);
            if (librsvg) {
                run_librsvg("a.svg", dpis[d]);
                assert_no_hairlines(models[i], picture("librsvg.png"), dpis[d], CAIRO_ROUNDING);
            }
        }
        if (librsvg) { /* regions of one colour, each an element of its own */
            options.grouping = ROBERTS_GROUP_ELEMENT;
            options.shaded = false;
            options.fill_color[0] = options.fill_color[1] = options.fill_color[2] =
                GREY - 2; /* all faces alike; a pixel of a border is mixed of three layers, and rounded in each */
            save(&drawing, options, ROBERTS_SVG, "elements.svg");
            run_librsvg("elements.svg", 96);
            assert_no_hairlines(models[i], picture("librsvg.png"), 96, CAIRO_ROUNDING);
        }
        if (librsvg && i == 0) {
            size_t inside;
            remove_seams("a.svg");
            run_librsvg("a.svg", 96);
            assert_true(hairlines(picture("librsvg.png"), 96, CAIRO_ROUNDING, &inside) > 100);
        }
        roberts_drawing_free(&drawing);
        roberts_regions_free(&regions);
    }
}

/* ---- Chromium ---- */

/* What it draws stands on one page, as starting it takes longer than drawing: first the cases at 192 dpi, three in a
 * row; then those that show fills at 96 dpi, in one row, and at 288 dpi, two in a row. In a browser's pixels, of which
 * 96 are an inch. */
enum {
    FILLS_SIDE = 768,
    LINES_SIDE = 2 * FILLS_SIDE,
    LARGE_SIDE = 3 * FILLS_SIDE,
    FILLS_TOP = CASES / 3 * LINES_SIDE,
    LARGE_TOP = FILLS_TOP + FILLS_SIDE,
    PAGE_WIDTH = 2 * LARGE_SIDE,
    PAGE_HEIGHT = LARGE_TOP + 2 * LARGE_SIDE
};

static const char *const browser_fills[] = {"compound-of-five-tetrahedra", "shapes/torus", "star/great-icosahedron"};
enum { BROWSER_FILLS = sizeof browser_fills / sizeof browser_fills[0], SEAMLESS = BROWSER_FILLS };

typedef struct place {
    int x, y, width, height;
} place;

static place place_of_lines(int i)
{
    return (place){i % 3 * LINES_SIDE, i / 3 * LINES_SIDE, LINES_SIDE, LINES_SIDE};
}

static place place_of_fills(int i, bool large)
{
    return large ? (place){i % 2 * LARGE_SIDE, LARGE_TOP + i / 2 * LARGE_SIDE, LARGE_SIDE, LARGE_SIDE}
                 : (place){i * FILLS_SIDE, FILLS_TOP, FILLS_SIDE, FILLS_SIDE};
}

static const char *numbered(const char *base, int i)
{
    static char name[40];
    snprintf(name, sizeof name, "%s%d.svg", base, i);
    return name;
}

static void put_on_page(FILE *page, const char *name, place at)
{
    fprintf(page, "<img src=%s style='left: %dpx; top: %dpx; width: %dpx; height: %dpx'>\n", name, at.x, at.y, at.width,
            at.height);
}

/* Writes the page and its pictures. */
static void write_page(void)
{
    FILE *page = fopen(path("page.html"), "w");
    assert_non_null(page);
    fputs("<!DOCTYPE html><style>body { margin: 0 } img { position: absolute }</style>\n", page);
    for (int i = 0; i < CASES; i++) {
        roberts_drawing drawing = model_drawing(cases[i].model, "iso");
        save(&drawing, options_for_browser((size_t)i), ROBERTS_SVG, numbered("lines", i));
        put_on_page(page, numbered("lines", i), place_of_lines(i));
        roberts_drawing_free(&drawing);
    }
    for (int i = 0; i <= SEAMLESS; i++) {
        roberts_region_list regions;
        roberts_draw_options options;
        roberts_drawing drawing = filled_drawing(browser_fills[i % BROWSER_FILLS], &regions, &options);
        save(&drawing, options, ROBERTS_SVG, numbered("fills", i));
        for (int large = 0; large < 2; large++)
            put_on_page(page, numbered("fills", i), place_of_fills(i, large));
        roberts_drawing_free(&drawing);
        roberts_regions_free(&regions);
    }
    remove_seams(numbered("fills", SEAMLESS));
    assert_int_equal(fclose(page), 0);
}

static cairo_surface_t *browser_page; /* as Chromium draws it */

/* False: there is no browser that draws it. The name of the program varies, and its home folder must be writable. */
static bool run_chromium(void)
{
    static bool tried;
    char command[1200];
    if (tried)
        return browser_page;
    tried = true;
    write_page();
    snprintf(
        command, sizeof command,
        "for name in chromium chromium-browser google-chrome; do browser=$(command -v $name) && break; done; "
        "[ -n \"$browser\" ] && cd '%s' && HOME=$PWD timeout 120 \"$browser\" --headless "
        "--no-sandbox --disable-gpu --disable-dev-shm-usage --disable-quic --no-first-run "
        "--disable-background-networking --disable-component-update --disable-sync --user-data-dir=\"$PWD/profile\" "
        "--hide-scrollbars --default-background-color=ffffffff --force-device-scale-factor=1 "
        "--window-size=%d,%d --screenshot=chromium.png \"file://$PWD/page.html\" >/dev/null 2>&1 && "
        "test -s chromium.png",
        temporary, PAGE_WIDTH, PAGE_HEIGHT);
    if (system(command) == 0)
        browser_page = picture("chromium.png");
    return browser_page;
}

/* A picture of the page. It holds until that is destroyed. */
static cairo_surface_t *cut_picture(place at)
{
    const int stride = cairo_image_surface_get_stride(browser_page);
    assert_true(cairo_image_surface_get_width(browser_page) >= at.x + at.width);
    assert_true(cairo_image_surface_get_height(browser_page) >= at.y + at.height);
    return cairo_image_surface_create_for_data(
        cairo_image_surface_get_data(browser_page) + (ptrdiff_t)stride * at.y + 4 * (ptrdiff_t)at.x,
        cairo_image_surface_get_format(browser_page), at.width, at.height, stride);
}

static void chromium_sees_the_same(void **state)
{
    (void)state;
    const bool librsvg = has_librsvg();
    if (!run_chromium())
        SKIP_BECAUSE("no Chromium that draws a page");
    for (int i = 0; i < CASES; i++) {
        roberts_drawing drawing = model_drawing(cases[i].model, "iso");
        const roberts_draw_options options = options_for_browser((size_t)i);
        assert_alike(cases[i].model, drawn(&drawing, &options), cut_picture(place_of_lines(i)), false);
        roberts_drawing_free(&drawing);
        if (librsvg) {
            run_librsvg(numbered("lines", i), options.dpi);
            assert_alike("... librsvg", picture("librsvg.png"), cut_picture(place_of_lines(i)), false);
        }
    }
}

static void no_paper_shines_through_in_chromium(void **state)
{
    size_t inside;
    (void)state;
    if (!run_chromium())
        SKIP_BECAUSE("no Chromium that draws a page");
    for (int large = 0; large < 2; large++) {
        const double dpi = large ? 288.0 : 96.0;
        for (int i = 0; i < BROWSER_FILLS; i++)
            assert_no_hairlines(browser_fills[i], cut_picture(place_of_fills(i, large)), dpi, CHROMIUM_ROUNDING);
        assert_true(hairlines(cut_picture(place_of_fills(SEAMLESS, large)), dpi, CHROMIUM_ROUNDING, &inside) > 100);
    }
}

static int remove_all(void **state)
{
    if (browser_page)
        cairo_surface_destroy(browser_page);
    return temporary_remove(state);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_paper_shines_through), cmocka_unit_test(no_paper_shines_through_in_chromium),
        cmocka_unit_test(librsvg_sees_the_same),   cmocka_unit_test(inkscape_sees_the_same),
        cmocka_unit_test(chromium_sees_the_same),  cmocka_unit_test(a_missing_line_is_seen),
        cmocka_unit_test(a_wrong_pen_is_seen),
    };
    return cmocka_run_group_tests_name("render", tests, temporary_make, remove_all);
}
