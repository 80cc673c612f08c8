/* ink.c - strokes onto a Cairo surface.
 *
 * Cairo outlines every stroke once, to know what it touches, whatever the surface. A stroke per segment is several
 * times as slow as a path of many; but the outline of one path of 100,000 segments takes 600 MB, and past 1,000
 * segments nothing is gained. */
#include "draw/ink.h"

#include "base/error.h"

void ink_pen(cairo_t *cairo, const roberts_draw_options *options, roberts_line line)
{
    const roberts_pen *pen = strokes_pen(options, line);
    double dash[2];
    bool dashed = strokes_dash(options, line, dash);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_width(cairo, pen->width_mm);
    cairo_set_source_rgb(cairo, pen->red / 255.0, pen->green / 255.0, pen->blue / 255.0);
    cairo_set_dash(cairo, dash, dashed ? 2 : 0, 0.0);
}

static void add_line(cairo_t *cairo, const strokes *s, const polyline *line)
{
    const page_point *p = s->lines.point + line->first;
    cairo_move_to(cairo, p->x / s->units_per_mm, p->y / s->units_per_mm);
    for (uint32_t i = 1; i < line->count; i++)
        cairo_line_to(cairo, p[i].x / s->units_per_mm, p[i].y / s->units_per_mm);
    if (line->closed)
        cairo_close_path(cairo);
}

size_t ink_strokes(cairo_t *cairo, const strokes *s, size_t *at, size_t end, size_t most)
{
    size_t paths = 0, segments = 0, total = 0;
    while (*at < end && total < most) {
        const polyline *line = &s->lines.item[(*at)++];
        add_line(cairo, s, line);
        segments += line->count;
        total += line->count;
        if (segments >= INK_SEGMENTS_PER_STROKE || *at == end || total >= most) {
            cairo_stroke(cairo);
            segments = 0;
            paths++;
        }
    }
    return paths;
}

cairo_status_t ink_stream(void *out, const unsigned char *bytes, unsigned size)
{
    output *to = out;
    output_bytes(to, bytes, size);
    return to->failed ? CAIRO_STATUS_WRITE_ERROR : CAIRO_STATUS_SUCCESS;
}

static roberts_status status_of(cairo_status_t status, roberts_error *error)
{
    switch (status) {
    case CAIRO_STATUS_SUCCESS:
    case CAIRO_STATUS_WRITE_ERROR: /* `out` knows why */
        return ROBERTS_OK;
    case CAIRO_STATUS_NO_MEMORY:
        return error_no_memory(error);
    default:
        return error_set(error, ROBERTS_IO, 0, "cairo: %s", cairo_status_to_string(status));
    }
}

roberts_status ink_finish(cairo_t *cairo, cairo_surface_t *surface, roberts_error *error)
{
    cairo_status_t status = cairo_status(cairo);
    cairo_destroy(cairo);
    cairo_surface_finish(surface);
    if (status == CAIRO_STATUS_SUCCESS)
        status = cairo_surface_status(surface);
    cairo_surface_destroy(surface);
    return status_of(status, error);
}
