/* PNG: the bands in which an image is drawn change nothing, and the file holds the picture that Cairo draws. */
#include <cairo.h>
#include <stdlib.h>

#include "write/formats.h"
#include "drawing.h"
#include "drawn_surface.h"
#include "read_png.h"
#include "testing.h"

static sink image_of(const strokes *s, size_t surface_bytes)
{
    sink to = {0};
    output *out = malloc(sizeof *out);
    assert_non_null(out);
    output_start(out, sink_write, &to);
    assert_int_equal(image_write_bands(s, surface_bytes, out, NULL), ROBERTS_OK);
    assert_int_equal(output_finish(out, NULL), ROBERTS_OK);
    free(out);
    return to;
}

/* Whether the file holds what Cairo draws at once on a surface of the whole page. */
static void expect_drawn_by_cairo(const strokes *s, const sink *file)
{
    cairo_surface_t *read = read_png(file->bytes, file->size);
    assert_int_equal(cairo_surface_status(read), CAIRO_STATUS_SUCCESS);
    const int width = cairo_image_surface_get_width(read), height = cairo_image_surface_get_height(read);
    cairo_surface_t *drawn = drawn_surface(s, width, height);
    size_t ink = 0;
    for (int y = 0; y < height; y++) {
        const uint32_t *p = surface_row(read, y), *q = surface_row(drawn, y);
        for (int x = 0; x < width; x++) {
            ink += (p[x] & 0xffffff) != 0xffffff;
            if ((p[x] & 0xffffff) != (q[x] & 0xffffff))
                fail_msg("pixel %d,%d: %06x in the file, %06x drawn", x, y, p[x] & 0xffffff, q[x] & 0xffffff);
        }
    }
    assert_true(ink > 1000);
    cairo_surface_destroy(drawn);
    cairo_surface_destroy(read);
}

/* Dashes longer and shorter than a band, as a pattern and as strokes. */
static void bands_change_nothing(void **state)
{
    static const char *const model[] = {"table", "lattice", "interpenetrating-cubes"};
    static const double dash[] = {0.5, 3.0, 40.0};
    static const size_t surface_bytes[] = {1, 50000, 300000};
    (void)state;
    for (size_t i = 0; i < 9; i++) {
        roberts_drawing drawing = model_drawing(model[i % 3], "iso");
        roberts_draw_options options = roberts_draw_options_default();
        strokes s;
        options.page = (roberts_page){.width_mm = 70.0, .height_mm = 90.0, .margin_mm = 2.0};
        options.dpi = 190.0 + 41.0 * (double)i;
        options.hidden = ROBERTS_HIDDEN_DASHED;
        options.back.dash_mm = dash[i / 3];
        options.back.red = 200;
        options.real_dashes = i % 2;
        assert_int_equal(strokes_make(&s, &drawing, &options, NULL), ROBERTS_OK);
        sink whole = image_of(&s, SIZE_MAX);
        expect_drawn_by_cairo(&s, &whole);
        for (size_t k = 0; k < sizeof surface_bytes / sizeof surface_bytes[0]; k++) {
            sink banded = image_of(&s, surface_bytes[k]);
            print_message("%s, dashes of %g mm, %zu bytes\n", model[i % 3], dash[i / 3], surface_bytes[k]);
            assert_int_equal(banded.size, whole.size);
            assert_memory_equal(banded.bytes, whole.bytes, whole.size);
            free(banded.bytes);
        }
        free(whole.bytes);
        strokes_free(&s);
        roberts_drawing_free(&drawing);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(bands_change_nothing)};
    return cmocka_run_group_tests_name("image", tests, NULL, NULL);
}
