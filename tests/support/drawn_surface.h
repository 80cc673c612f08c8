/* drawn_surface.h - a page as Cairo draws it at once, without a file: the pixels of its PNG. */
#ifndef ROBERTS_TESTS_DRAWN_SURFACE_H
#define ROBERTS_TESTS_DRAWN_SURFACE_H

#include <cairo.h>

#include "write/cairo.h"
#include "testing.h"

/* The caller destroys the surface. */
static inline cairo_surface_t *drawn_surface(const strokes *s, int width, int height)
{
    const double pixels_per_mm = s->options->dpi / 25.4;
    const roberts_background white = {true, 255, 255, 255}, *own = &s->options->background,
                             *paper = own->on ? own : &white;
    cairo_surface_t *drawn = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
    cairo_t *cairo = cairo_create(drawn);
    cairo_calls call;
    assert_true(surface_load(&call, NULL));
    cairo_set_source_rgb(cairo, paper->red / 255.0, paper->green / 255.0, paper->blue / 255.0);
    cairo_paint(cairo);
    cairo_scale(cairo, pixels_per_mm, pixels_per_mm);
    surface_draw(&call, cairo, s);
    assert_int_equal(cairo_status(cairo), CAIRO_STATUS_SUCCESS);
    cairo_destroy(cairo);
    cairo_surface_flush(drawn);
    return drawn;
}

/* The pixels of row y, 0x00RRGGBB; the highest byte is undefined. */
static inline const uint32_t *surface_row(cairo_surface_t *image, int y)
{
    return (const uint32_t *)(const void *)(cairo_image_surface_get_data(image) +
                                            (ptrdiff_t)y * cairo_image_surface_get_stride(image));
}

#endif
