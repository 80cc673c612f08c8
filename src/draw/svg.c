/* svg.c - the page as SVG: size and user units in mm, one layer and one path per class of lines.
 *
 * Cairo draws the paths. What stands round them is ours, because Cairo 1.16 knows no layers, numbers its groups by a
 * counter of the process, and keeps coordinates as multiples of 1/256 of a device unit: in points, that is 0.0014 mm,
 * and all page units are the same. So the device unit here is 0.001 mm with a transformation to mm on top; Cairo then
 * writes each coordinate of a path in mm with three digits, and the transformation beside it. Of its stream only the
 * path data are kept, joined to one path.
 *
 * The page comes in several Cairo surfaces, because each holds its drawing twice until it is finished. */
#include "draw/svg.h"

#include <cairo-svg.h>
#include <math.h>
#include <string.h>

#include "base/error.h"
#include "draw/ink.h"
#include "draw/xml.h"

enum { SEGMENTS_PER_SURFACE = 50000 };

/* ---- Cairo's stream, path data alone ---- */

typedef enum place {
    BETWEEN,   /* not in a tag */
    NAME,      /* in the name of a tag */
    TAG,       /* in a tag that is no path */
    PATH,      /* in a path's tag, before or in the name of an attribute */
    VALUE,     /* in the value of an attribute that is not wanted */
    PATH_DATA, /* in the value of d */
} place;

enum { DATA_TAIL = 48 }; /* longer than a command and its numbers */

typedef struct extract {
    output *out;
    char tail[DATA_TAIL]; /* the last bytes of path data, kept back */
    size_t tail_length;
    place at;
    char name[8]; /* of a tag or an attribute; the beginning of longer ones */
    size_t length;
    size_t paths; /* path data so far, over all surfaces of the class */
} extract;

static void name_start(extract *e, place at)
{
    e->at = at;
    e->length = 0;
}

static void name_add(extract *e, unsigned char c)
{
    if (e->length < sizeof e->name)
        e->name[e->length++] = (char)c;
}

static bool name_is(const extract *e, const char *name)
{
    return e->length == strlen(name) && memcmp(e->name, name, e->length) == 0;
}

/* One byte, outside of path data. */
static void extract_byte(extract *e, unsigned char c)
{
    bool blank = c == ' ' || c == '\n';
    switch (e->at) {
    case BETWEEN:
        if (c == '<')
            name_start(e, NAME);
        break;
    case NAME:
        if (c == '>')
            e->at = BETWEEN;
        else if (blank)
            name_start(e, name_is(e, "path") ? PATH : TAG);
        else
            name_add(e, c);
        break;
    case TAG:
        if (c == '>')
            e->at = BETWEEN;
        break;
    case PATH:
        if (c == '>')
            e->at = BETWEEN;
        else if (c == '"' && name_is(e, "d="))
            e->at = PATH_DATA;
        else if (c == '"')
            e->at = VALUE;
        else if (blank)
            name_start(e, PATH);
        else
            name_add(e, c);
        break;
    default: /* VALUE */
        if (c == '"')
            name_start(e, PATH);
    }
}

static void data_add(extract *e, const char *bytes, size_t size)
{
    size_t total = e->tail_length + size, out = total > DATA_TAIL ? total - DATA_TAIL : 0;
    size_t of_tail = out < e->tail_length ? out : e->tail_length;
    output_bytes(e->out, e->tail, of_tail);
    output_bytes(e->out, bytes, out - of_tail);
    memmove(e->tail, e->tail + of_tail, e->tail_length - of_tail);
    e->tail_length -= of_tail;
    memcpy(e->tail + e->tail_length, bytes + (out - of_tail), size - (out - of_tail));
    e->tail_length += size - (out - of_tail);
}

/* Behind a closed line Cairo goes to its start once more, as the start of another line; where none follows, that is not
 * passed on. */
static void data_end(extract *e)
{
    size_t last = e->tail_length;
    while (last > 0 && !(e->tail[last - 1] >= 'A' && e->tail[last - 1] <= 'Z'))
        last--;
    output_bytes(e->out, e->tail, last > 0 && e->tail[last - 1] == 'M' ? last - 1 : e->tail_length);
    e->tail_length = 0;
}

static cairo_status_t extract_stream(void *closure, const unsigned char *bytes, unsigned size)
{
    extract *e = closure;
    const unsigned char *end = bytes + size;
    while (bytes < end) {
        if (e->at == PATH_DATA) {
            const unsigned char *quote = memchr(bytes, '"', (size_t)(end - bytes));
            const unsigned char *stop = quote ? quote : end;
            data_add(e, (const char *)bytes, (size_t)(stop - bytes));
            bytes = stop;
            if (!quote)
                break;
            data_end(e);
            name_start(e, PATH);
        } else {
            extract_byte(e, *bytes);
            if (e->at == PATH_DATA && e->paths++)
                output_text(e->out, "\n");
        }
        bytes++;
    }
    return e->out->failed ? CAIRO_STATUS_WRITE_ERROR : CAIRO_STATUS_SUCCESS;
}

/* ---- the page ---- */

/* A length with at most three decimals: 0.35, 12, 1189.5. */
static void write_mm(output *out, double mm)
{
    uint32_t um = (uint32_t)floor(mm * 1000.0 + 0.5);
    output_integer(out, um / 1000);
    if ((um %= 1000) == 0)
        return;
    char digits[] = {'.', (char)('0' + um / 100), (char)('0' + um / 10 % 10), (char)('0' + um % 10)};
    size_t length = um % 10 ? 4 : um % 100 ? 3 : 2;
    output_bytes(out, digits, length);
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
    if (strokes_dash(options, line, dash)) {
        output_text(out, " stroke-dasharray=\"");
        write_mm(out, dash[0]);
        output_text(out, " ");
        write_mm(out, dash[1]);
        output_text(out, "\"");
    }
    output_text(out, " d=\"");
}

/* Draws some polylines from `*at` on through a surface of its own; `*paths` grows by the number of paths. */
static roberts_status write_some(const strokes *s, size_t *at, size_t end, size_t *paths, extract *e,
                                 roberts_error *error)
{
    const roberts_page *page = &s->options->page;
    cairo_surface_t *surface = cairo_svg_surface_create_for_stream(extract_stream, e, page->width_mm * s->units_per_mm,
                                                                   page->height_mm * s->units_per_mm);
    cairo_t *cairo = cairo_create(surface);
    cairo_scale(cairo, s->units_per_mm, s->units_per_mm);
    cairo_set_tolerance(cairo, 1e6); /* device units: the roughest outline will do, as only the path is written */
    *paths += ink_strokes(cairo, s, at, end, SEGMENTS_PER_SURFACE);
    return ink_finish(cairo, surface, error);
}

static roberts_status write_layer(const strokes *s, int class, output *out, roberts_error *error)
{
    extract e = {.out = out};
    size_t at = s->start[class], end = s->start[class + 1], paths = 0;
    if (at == end)
        return ROBERTS_OK; /* no layer without lines */
    open_layer(out, s->options, line_order[class]);
    while (at < end) {
        e.at = BETWEEN;
        roberts_status status = write_some(s, &at, end, &paths, &e, error);
        if (status != ROBERTS_OK || out->failed)
            return status;
    }
    output_text(out, "\"/>\n</g>\n");
    if (e.paths != paths)
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
