/* svg.c - the page as SVG: size and user units in mm, one layer and one path per class of lines.
 *
 * Cairo draws the paths. What stands round them is ours, because Cairo 1.16 knows no layers, numbers its groups by a
 * counter of the process, and keeps coordinates as multiples of 1/256 of a device unit: in points, that is 0.0014 mm,
 * and all page units are the same. So the device unit here is 0.001 mm with a transformation on top; Cairo writes the
 * coordinates of a path before it, and the transformation beside them. Of its stream only the path data are kept,
 * brought to mm (extract.c) and joined to one path.
 *
 * The page comes in several Cairo surfaces, because each holds its drawing twice until it is finished. */
#include "draw/svg.h"

#include <cairo-svg.h>
#include <math.h>

#include "base/error.h"
#include "draw/decimal.h"
#include "draw/extract.h"
#include "draw/ink.h"
#include "draw/travel.h"
#include "draw/xml.h"

enum { SEGMENTS_PER_SURFACE = 50000 };

/* A length with at most three decimals: 0.35, 12, 1189.5. */
static void write_mm(output *out, double mm)
{
    char text[DECIMAL_ROOM];
    output_bytes(out, text, decimal_fixed(text, (int32_t)floor(mm * 1000.0 + 0.5), 3));
}

static void write_color(output *out, unsigned char red, unsigned char green, unsigned char blue)
{
    static const char hex[] = "0123456789abcdef";
    const unsigned char part[] = {red, green, blue};
    output_text(out, "#");
    for (int i = 0; i < 3; i++) {
        output_bytes(out, &hex[part[i] >> 4], 1);
        output_bytes(out, &hex[part[i] & 15], 1);
    }
}

static void open_layer(output *out, const roberts_draw_options *options, roberts_line line)
{
    static const char *const name[] = {[ROBERTS_OUTLINE] = "outline",
                                       [ROBERTS_CREASE] = "crease",
                                       [ROBERTS_BACK] = "hidden",
                                       [LINE_FRAME] = "frame",
                                       [LINE_SYMBOL] = "symbol"};
    const roberts_pen *pen = strokes_pen(options, line);
    double dash[2];
    output_text(out, "<g id=\"");
    output_text(out, name[line]);
    output_text(out, "\" inkscape:groupmode=\"layer\" inkscape:label=\"");
    output_text(out, name[line]);
    output_text(out, "\">\n<path fill=\"none\" stroke=\"");
    write_color(out, pen->red, pen->green, pen->blue);
    output_text(out, "\" stroke-width=\"");
    write_mm(out, pen->width_mm);
    output_text(out, "\" stroke-linecap=\"round\" stroke-linejoin=\"round\"");
    if (!options->real_dashes && strokes_dash(options, line, dash)) {
        output_text(out, " stroke-dasharray=\"");
        write_mm(out, dash[0]);
        output_text(out, " ");
        write_mm(out, dash[1]);
        output_text(out, "\"");
    }
    output_text(out, " d=\"");
}

/* A writer for Cairo's streams; the closure is an extract. */
static cairo_status_t take_bytes(void *closure, const unsigned char *bytes, unsigned size)
{
    extract *e = closure;
    extract_bytes(e, bytes, size);
    return e->out->failed ? CAIRO_STATUS_WRITE_ERROR : CAIRO_STATUS_SUCCESS;
}

/* Draws some polylines from `*at` on through a surface of its own; `*paths` grows by the number of paths. */
static roberts_status write_some(const strokes *s, size_t *at, size_t end, size_t *paths, extract *e,
                                 roberts_error *error)
{
    const roberts_page *page = &s->options->page;
    const ink_space space = {EXTRACT_ORIGIN, EXTRACT_UNITS};
    cairo_surface_t *surface = cairo_svg_surface_create_for_stream(take_bytes, e, page->width_mm * s->units_per_mm,
                                                                   page->height_mm * s->units_per_mm);
    cairo_t *cairo = cairo_create(surface);
    cairo_scale(cairo, space.units, space.units);
    cairo_translate(cairo, -space.origin, -space.origin);
    cairo_set_line_width(cairo, 1.0 / space.units); /* any will do, as only the path is written; so for: */
    cairo_set_tolerance(cairo, 1e6);                /* device units: the roughest outline */
    extract_surface(e, polyline_start(&s->lines, &s->lines.item[*at]));
    *paths += ink_strokes(cairo, s, &space, at, end, SEGMENTS_PER_SURFACE);
    return ink_finish(cairo, surface, error);
}

static roberts_status write_layer(const strokes *s, int class, output *out, roberts_error *error)
{
    extract e = {.out = out, .decimals = s->units_per_mm < 1000.0 ? 2 : 3};
    size_t at = s->start[class], end = s->start[class + 1], paths = 0;
    if (at == end)
        return ROBERTS_OK; /* no layer without lines */
    open_layer(out, s->options, line_order[class]);
    while (at < end) {
        roberts_status status = write_some(s, &at, end, &paths, &e, error);
        if (status != ROBERTS_OK || out->failed)
            return status;
    }
    output_text(out, "\"/>\n</g>\n");
    if (e.paths != paths || e.strange)
        return error_set(error, ROBERTS_IO, 0, "this version of Cairo writes SVG in a form that is not understood");
    return ROBERTS_OK;
}

static void write_text(output *out, const char *tag, const char *text)
{
    const char *const parts[] = {"<", tag, ">", text, "</", tag, ">\n"};
    for (int i = 0; text && i < 7; i++)
        if (i == 3)
            xml_text(out, text);
        else
            output_text(out, parts[i]);
}

/* No layer and no path: it is no line to draw. */
static void write_background(output *out, const roberts_page *page, const roberts_background *color)
{
    output_text(out, "<rect id=\"background\" width=\"");
    write_mm(out, page->width_mm);
    output_text(out, "\" height=\"");
    write_mm(out, page->height_mm);
    output_text(out, "\" fill=\"");
    write_color(out, color->red, color->green, color->blue);
    output_text(out, "\"/>\n");
}

roberts_status svg_write(const strokes *s, output *out, roberts_error *error)
{
    const roberts_page *page = &s->options->page;
    output_text(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\""
                     " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\" width=\"");
    write_mm(out, page->width_mm);
    output_text(out, "mm\" height=\"");
    write_mm(out, page->height_mm);
    output_text(out, "mm\" viewBox=\"0 0 ");
    write_mm(out, page->width_mm);
    output_text(out, " ");
    write_mm(out, page->height_mm);
    output_text(out, "\">\n");
    write_text(out, "title", s->options->title);
    write_text(out, "desc", s->options->description);
    if (s->options->background.on)
        write_background(out, page, &s->options->background);
    for (int i = 0; i < LINE_CLASSES; i++) {
        roberts_status status = write_layer(s, i, out, error);
        if (status != ROBERTS_OK)
            return status;
    }
    output_text(out, "</svg>\n");
    return ROBERTS_OK;
}
