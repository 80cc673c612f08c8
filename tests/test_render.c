/* The SVG as another program sees it: librsvg's picture of it beside our own, drawn by Cairo without the way through the
 * file. Skipped where there is no rsvg-convert. */
#include <errno.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cairo.h>
#include <cmocka.h>

#include "drawing.h"

static char folder[] = "/tmp/roberts-render-XXXXXX";

static const struct {
    const char *model;
    roberts_hidden hidden;
    bool frame, real_dashes, shrunk; /* at 1:2 in the lower left */
} cases[] = {
    {"platonic/cube", ROBERTS_HIDDEN_DASHED, false, false, false},
    {"table", ROBERTS_HIDDEN_DASHED, true, false, false},
    {"table", ROBERTS_HIDDEN_DASHED, false, true, false},
    {"temple", ROBERTS_HIDDEN_NONE, true, false, true},
    {"interpenetrating-cubes", ROBERTS_HIDDEN_SOLID, false, false, false},
};

/* How dark a pixel is, 0 to 255. */
static int darkness(cairo_surface_t *image, int x, int y)
{
    const unsigned char *row =
        cairo_image_surface_get_data(image) + (ptrdiff_t)y * cairo_image_surface_get_stride(image);
    uint32_t pixel;
    memcpy(&pixel, row + 4 * (ptrdiff_t)x, sizeof pixel);
    return 255 - (int)(pixel >> 8 & 255);
}

static void compare(const char *ours, const char *theirs)
{
    cairo_surface_t *a = cairo_image_surface_create_from_png(ours), *b = cairo_image_surface_create_from_png(theirs);
    int width = cairo_image_surface_get_width(a), height = cairo_image_surface_get_height(a), worst = 0;
    double ink = 0.0, difference = 0.0;
    assert_int_equal(cairo_surface_status(a), CAIRO_STATUS_SUCCESS);
    assert_int_equal(cairo_surface_status(b), CAIRO_STATUS_SUCCESS);
    assert_true(abs(cairo_image_surface_get_width(b) - width) <= 1 &&
                abs(cairo_image_surface_get_height(b) - height) <= 1);
    if (cairo_image_surface_get_width(b) < width)
        width--;
    if (cairo_image_surface_get_height(b) < height)
        height--;
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            int p = darkness(a, x, y), q = darkness(b, x, y), d = abs(p - q);
            ink += p;
            difference += d;
            worst = d > worst ? d : worst;
        }
    print_message("%d x %d, ink %.0f, difference %.0f, worst %d\n", width, height, ink / 255, difference / 255, worst);
    assert_true(ink > 100 * 255.0);
    assert_true(difference < 0.03 * ink); /* rounding of coverage and of coordinates to 1/256 pixel */
    assert_true(worst < 96);              /* a stroke missing or moved by half a pixel has more */
    cairo_surface_destroy(a);
    cairo_surface_destroy(b);
}

static void librsvg_sees_the_same(void **state)
{
    char svg[64], ours[64], theirs[64], command[400];
    (void)state;
    if (system("rsvg-convert --version >/dev/null 2>&1") != 0) {
        print_message("no rsvg-convert\n");
        skip();
    }
    assert_non_null(mkdtemp(folder));
    snprintf(svg, sizeof svg, "%s/a.svg", folder);
    snprintf(ours, sizeof ours, "%s/a.png", folder);
    snprintf(theirs, sizeof theirs, "%s/b.png", folder);
    snprintf(command, sizeof command, "rsvg-convert -d 127 -p 127 -b white -o %s %s", theirs, svg);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        roberts_drawing drawing = model_drawing(cases[i].model, "iso");
        roberts_draw_options options = roberts_draw_options_default();
        options.hidden = cases[i].hidden;
        options.frame.off = !cases[i].frame;
        options.real_dashes = cases[i].real_dashes;
        options.outline.red = 255; /* green is looked at */
        options.title = "<&>";
        options.dpi = 127; /* 5 pixels a mm */
        if (cases[i].shrunk)
            options.placement = (roberts_placement){.scale = 0.5, .unit_mm = 1, .align_x = -1, .align_y = -1};
        assert_int_equal(roberts_drawing_save(&drawing, &options, svg, NULL), ROBERTS_OK);
        options.format = ROBERTS_PNG;
        assert_int_equal(roberts_drawing_save(&drawing, &options, ours, NULL), ROBERTS_OK);
        assert_int_equal(system(command), 0);
        print_message("%s: ", cases[i].model);
        compare(ours, theirs);
        roberts_drawing_free(&drawing);
    }
    unlink(svg);
    unlink(ours);
    unlink(theirs);
    rmdir(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(librsvg_sees_the_same)};
    return cmocka_run_group_tests_name("render", tests, NULL, NULL);
}
