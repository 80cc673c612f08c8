/* svg.c - the page as SVG: size and user units in mm, one layer and one path per class of lines.
 *
 * Each path goes into Cairo, in whole units of the page, and comes back by cairo_copy_path(), without points on a
 * straight way. The text is written here, because the SVG of Cairo 1.16 has no layers, and numbers its groups by a
 * counter of the process. */
#include "draw/svg.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "draw/cairo.h"

enum { SEGMENTS_PER_PATH = 1000 /* a path is taken to Cairo and back in parts of about this size */ };

/* ---- numbers and colours ---- */

/* Writes n / 1000 with at most three decimals: 0.35, 12, 1189.5. */
static void write_thousandths(output *out, int32_t n)
{
    if (n < 0)
        output_bytes(out, "-", 1);
    uint32_t whole = (uint32_t)abs(n) / 1000, rest = (uint32_t)abs(n) % 1000;
    output_integer(out, whole);
    if (rest == 0)
        return;
    const char digits[] = {'.', (char)('0' + rest / 100), (char)('0' + rest / 10 % 10), (char)('0' + rest % 10)};
    output_bytes(out, digits, rest % 10 ? 4 : rest % 100 ? 3 : 2);
}

static void write_mm(output *out, double mm)
{
    write_thousandths(out, (int32_t)floor(mm * 1000.0 + 0.5));
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

/* ---- text ---- */

/* Writes UTF-8 with <, > and & as entities. A byte that belongs to no character of XML 1.0, in its shortest form (RFC
 * 3629), becomes a question mark: a file's name may hold any bytes. */
static void write_escaped(output *out, const char *text)
{
    while (*text) {
        size_t length = output_character(text);
        if (*text == '<' || *text == '>' || *text == '&')
            output_text(out, *text == '<' ? "&lt;" : *text == '>' ? "&gt;" : "&amp;");
        else if (length)
            output_bytes(out, text, length);
        else
            output_text(out, "?");
        text += length ? length : 1;
    }
}

static void open_layer(output *out, const roberts_draw_options *options, roberts_line line)
{
    static const char *const name[] = {
        [ROBERTS_OUTLINE] = "outline", [ROBERTS_CREASE] = "crease", [ROBERTS_BACK] = "hidden",
        [ROBERTS_BORDER] = "border",   [ROBERTS_WIRE] = "wire",     [ROBERTS_INTERSECTION] = "intersection",
        [LINE_FRAME] = "frame",        [LINE_SYMBOL] = "symbol"};
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
    if (strokes_dash(options, line, dash)) {
        output_text(out, " stroke-dasharray=\"");
        write_mm(out, dash[0]);
        output_text(out, " ");
        write_mm(out, dash[1]);
        output_text(out, "\"");
    }
    output_text(out, " d=\"");
}

/* ---- paths ---- */

static void write_point(output *out, const char *command, const cairo_path_data_t *at, int32_t thousandths)
{
    output_text(out, command);
    write_thousandths(out, (int32_t)at->point.x * thousandths);
    output_bytes(out, " ", 1);
    write_thousandths(out, (int32_t)at->point.y * thousandths);
    output_bytes(out, " ", 1);
}

/* After a closed line Cairo moves to its start once more. A move that no line follows is not written. */
static void write_path(output *out, const cairo_path_t *path, int32_t thousandths)
{
    const cairo_path_data_t *start = NULL;
    for (int i = 0; i < path->num_data; i += path->data[i].header.length) {
        const cairo_path_data_t *data = &path->data[i];
        if (data->header.type == CAIRO_PATH_MOVE_TO) {
            start = data + 1;
            continue;
        }
        if (start)
            write_point(out, "M ", start, thousandths);
        start = NULL;
        if (data->header.type == CAIRO_PATH_LINE_TO)
            write_point(out, "L ", data + 1, thousandths);
        else
            output_text(out, "Z ");
    }
}

/* Writes polylines from `*at` on, at most up to `end`, and moves `*at` behind them. */
static cairo_status_t write_polylines(cairo_t *cairo, const strokes *s, size_t *at, size_t end, output *out)
{
    const int32_t thousandths = (int32_t)(1000.0 / s->units_per_mm + 0.5); /* of a mm, in a unit */
    cairo_new_path(cairo);
    for (size_t segments = 0; *at < end && segments < SEGMENTS_PER_PATH; ++*at) {
        surface_add_line(cairo, s, &s->lines.item[*at], 1.0);
        segments += s->lines.item[*at].count;
    }
    cairo_path_t *path = cairo_copy_path(cairo);
    cairo_status_t status = path->status;
    if (status == CAIRO_STATUS_SUCCESS)
        write_path(out, path, thousandths);
    cairo_path_destroy(path);
    return status;
}

static roberts_status write_layer(const strokes *s, int class, output *out, cairo_t *cairo, roberts_error *error)
{
    size_t at = s->start[class], end = s->start[class + 1];
    if (at == end)
        return ROBERTS_OK; /* no layer without lines */
    open_layer(out, s->options, line_order[class]);
    while (at < end && !out->failed) {
        cairo_status_t status = write_polylines(cairo, s, &at, end, out);
        if (status != CAIRO_STATUS_SUCCESS)
            return surface_failure(status, error);
        if (at < end)
            output_text(out, "\n");
    }
    output_text(out, "\"/>\n</g>\n");
    return ROBERTS_OK;
}

/* ---- the page ---- */

/* Writes nothing where `text` is NULL. */
static void write_element(output *out, const char *tag, const char *text)
{
    if (!text)
        return;
    output_text(out, "<");
    output_text(out, tag);
    output_text(out, ">");
    write_escaped(out, text);
    output_text(out, "</");
    output_text(out, tag);
    output_text(out, ">\n");
}

/* Outside of the layers, because a plotter must not draw it. */
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
    write_element(out, "title", s->options->title);
    write_element(out, "desc", s->options->description);
    if (s->options->background.on)
        write_background(out, page, &s->options->background);
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1); /* nothing is drawn on it */
    cairo_t *cairo = cairo_create(surface);
    roberts_status status = ROBERTS_OK;
    for (int i = 0; i < LINE_CLASSES && status == ROBERTS_OK; i++)
        status = write_layer(s, i, out, cairo, error);
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
    output_text(out, "</svg>\n");
    return status;
}
