/* dxf.c - the page as DXF of AutoCAD release 12, as text: the oldest that all readers know.
 *
 * A class is a layer with its colour and line type. Drawing units are mm, the origin is the lower left corner of the
 * page, and y is up. A stroke of two points is a LINE, any other a POLYLINE. Release 12 knows no widths of lines, and
 * 255 colours of its own: the nearest is taken. A record is two lines, a code and a value. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "write/formats.h"
#include "write/plot.h"

enum { BLACK_OR_WHITE = 7 /* the colour that contrasts with the screen */, COLORS = 256 };

typedef struct dxf {
    const strokes *s;
    output *out;
    const char *layer;
    int32_t height; /* of the page, in its units */
} dxf;

/* ---- records ---- */

static void write_code(output *out, uint32_t code)
{
    output_integer(out, code);
    output_bytes(out, "\n", 1);
}

static void write_text(output *out, uint32_t code, const char *text)
{
    write_code(out, code);
    output_text(out, text);
    output_bytes(out, "\n", 1);
}

/* Names have only capital letters, as release 12 requires. */
static void write_name(output *out, uint32_t code, const char *before, const char *name)
{
    write_code(out, code);
    output_text(out, before);
    for (; *name; name++) {
        const char letter = *name >= 'a' && *name <= 'z' ? (char)(*name - 'a' + 'A') : *name;
        output_bytes(out, &letter, 1);
    }
    output_bytes(out, "\n", 1);
}

static void write_integer(output *out, uint32_t code, uint32_t value)
{
    write_code(out, code);
    output_integer(out, value);
    output_bytes(out, "\n", 1);
}

static void write_mm(output *out, uint32_t code, double mm)
{
    write_code(out, code);
    output_mm(out, mm);
    output_bytes(out, "\n", 1);
}

/* x and y, by codes that begin with `code`. */
static void write_point(const dxf *p, uint32_t code, page_point at)
{
    write_code(p->out, code);
    output_thousandths(p->out, at.x * p->s->thousandths);
    output_bytes(p->out, "\n", 1);
    write_code(p->out, code + 10);
    output_thousandths(p->out, (p->height - at.y) * p->s->thousandths);
    output_bytes(p->out, "\n", 1);
}

/* ---- colours ---- */

/* The colours by number. 1 to 9 are fixed. From 10 on there are 24 hues, in steps of 15 degrees; each has five levels
 * of brightness, each full or half pale. From 250 on there are six grays. */
static void color_of(int number, double rgb[3])
{
    static const unsigned char fixed[10][3] = {{0, 0, 0},       {255, 0, 0},    {255, 255, 0}, {0, 255, 0},
                                               {0, 255, 255},   {0, 0, 255},    {255, 0, 255}, {0, 0, 0},
                                               {128, 128, 128}, {192, 192, 192}};
    static const double gray[6] = {51, 80, 105, 130, 190, 255}, level[5] = {255, 165, 127, 76, 38};
    for (int i = 0; i < 3; i++) {
        if (number < 10) {
            rgb[i] = fixed[number][i];
            continue;
        }
        if (number >= 250) {
            rgb[i] = gray[number - 250];
            continue;
        }
        int away = abs(number / 10 * 15 - 15 - i * 120) % 360; /* degrees from the hue of red, green or blue */
        double part = fmin(fmax((120.0 - (away > 180 ? 360 - away : away)) / 60.0, 0.0), 1.0);
        rgb[i] = level[number % 10 / 2] * (number % 2 ? 0.5 + 0.5 * part : part);
    }
}

static double color_distance(const roberts_pen *pen, int number)
{
    double rgb[3];
    color_of(number, rgb);
    return hypot(hypot(rgb[0] - pen->red, rgb[1] - pen->green), rgb[2] - pen->blue);
}

/* The colour nearest to the pen's, the first of several. Black becomes the colour that contrasts with the screen. */
static uint32_t nearest_color(const roberts_pen *pen)
{
    int nearest = BLACK_OR_WHITE;
    for (int i = 1; i < COLORS; i++)
        if (color_distance(pen, i) < color_distance(pen, nearest))
            nearest = i;
    return (uint32_t)nearest;
}

/* ---- tables ---- */

static void begin_table(output *out, const char *name, uint32_t rows)
{
    write_text(out, 0, "TABLE");
    write_text(out, 2, name);
    write_integer(out, 70, rows);
}

/* The line type of a class: that of hidden lines is DASHED. */
static void write_line_type_name(output *out, uint32_t code, const roberts_draw_options *options, roberts_line line)
{
    double dash[2];
    if (!pens_dash(options, line, dash))
        write_text(out, code, "CONTINUOUS");
    else if (line == ROBERTS_BACK)
        write_text(out, code, "DASHED");
    else
        write_name(out, code, "DASHED_", pens_class_name(line));
}

static void begin_line_type(output *out, const char *description, uint32_t parts, double length_mm)
{
    write_integer(out, 70, 0);
    write_text(out, 3, description);
    write_integer(out, 72, 65); /* always */
    write_integer(out, 73, parts);
    write_mm(out, 40, length_mm);
}

/* Lengths are as seen on paper: readers draw lines without caps. */
static void write_line_types(const dxf *p)
{
    const roberts_draw_options *options = p->s->options;
    uint32_t broken = 0;
    double dash[2];
    for (int i = 0; i < LINE_CLASSES; i++)
        broken += pens_dash(options, line_order[i], dash);
    begin_table(p->out, "LTYPE", 1 + broken);
    write_text(p->out, 0, "LTYPE");
    write_text(p->out, 2, "CONTINUOUS");
    begin_line_type(p->out, "Solid line", 0, 0.0);
    for (int i = 0; i < LINE_CLASSES; i++) {
        const roberts_pen *pen = pens_of(options, line_order[i]);
        if (!pens_dash(options, line_order[i], dash))
            continue;
        write_text(p->out, 0, "LTYPE");
        write_line_type_name(p->out, 2, options, line_order[i]);
        begin_line_type(p->out, "__ __ __ __ __", 2, pen->dash_mm + pen->gap_mm);
        write_mm(p->out, 49, pen->dash_mm);
        write_mm(p->out, 49, -pen->gap_mm);
    }
    write_text(p->out, 0, "ENDTAB");
}

/* Whether text of this class is written as text. */
static bool has_text(const strokes *s, roberts_line class)
{
    const bool is_text = class == LINE_TEXT || class == LINE_HIDDEN_TEXT;
    if (!is_text || !strokes_text_is_native(s->options) || pens_of(s->options, class)->off)
        return false;
    for (size_t i = 0; i < s->notes.count; i++)
        if (strokes_text_is_of(s, i, class))
            return true;
    return false;
}

/* Whether anything is on the layer of class line_order[i]. */
static bool has_layer(const strokes *s, int i)
{
    return s->start[i] < s->start[i + 1] || has_text(s, line_order[i]);
}

/* Layer 0 is required; nothing is on it. */
static void write_layers(const dxf *p)
{
    uint32_t layers = 1;
    for (int i = 0; i < LINE_CLASSES; i++)
        layers += has_layer(p->s, i);
    begin_table(p->out, "LAYER", layers);
    write_text(p->out, 0, "LAYER");
    write_text(p->out, 2, "0");
    write_integer(p->out, 70, 0);
    write_integer(p->out, 62, BLACK_OR_WHITE);
    write_text(p->out, 6, "CONTINUOUS");
    for (int i = 0; i < LINE_CLASSES; i++) {
        if (!has_layer(p->s, i))
            continue;
        write_text(p->out, 0, "LAYER");
        write_name(p->out, 2, "", pens_class_name(line_order[i]));
        write_integer(p->out, 70, 0);
        write_integer(p->out, 62, nearest_color(pens_of(p->s->options, line_order[i])));
        write_line_type_name(p->out, 6, p->s->options, line_order[i]);
    }
    write_text(p->out, 0, "ENDTAB");
}

/* The limits are the page. $INSUNITS is younger than release 12, but most readers know it: 4 is the mm. */
static void write_header(const dxf *p)
{
    const roberts_page *page = &p->s->page;
    write_text(p->out, 0, "SECTION");
    write_text(p->out, 2, "HEADER");
    write_text(p->out, 9, "$ACADVER");
    write_text(p->out, 1, "AC1009");
    write_text(p->out, 9, "$INSUNITS");
    write_integer(p->out, 70, 4);
    write_text(p->out, 9, "$LIMMIN");
    write_mm(p->out, 10, 0.0);
    write_mm(p->out, 20, 0.0);
    write_text(p->out, 9, "$LIMMAX");
    write_mm(p->out, 10, page->width_mm);
    write_mm(p->out, 20, page->height_mm);
    write_text(p->out, 0, "ENDSEC");
}

/* ---- strokes ---- */

static void begin_class(void *context, roberts_line line)
{
    dxf *p = context;
    p->layer = pens_class_name(line);
}

static void begin_entity(const dxf *p, const char *name)
{
    write_text(p->out, 0, name);
    write_name(p->out, 8, "", p->layer);
}

/* 70 of a POLYLINE: 1 it is closed, 128 dashes go on round its corners. Release 12 requires a point here, which
 * readers ignore. */
static void write_polyline(const dxf *p, const page_point *point, size_t count, bool closed)
{
    begin_entity(p, "POLYLINE");
    write_integer(p->out, 66, 1);
    write_integer(p->out, 10, 0);
    write_integer(p->out, 20, 0);
    write_integer(p->out, 30, 0);
    write_integer(p->out, 70, 128 + closed);
    for (size_t i = 0; i < count; i++) {
        begin_entity(p, "VERTEX");
        write_point(p, 10, point[i]);
    }
    begin_entity(p, "SEQEND");
}

static void write_stroke(void *context, const page_point *point, size_t count, bool closed)
{
    const dxf *p = context;
    if (count > 2 || closed) {
        write_polyline(p, point, count, closed);
        return;
    }
    begin_entity(p, "LINE");
    write_point(p, 10, point[0]);
    write_point(p, 11, point[1]);
}

/* ---- text ---- */

/* What is not ASCII is written as \U+00E9, beyond 16 bits as two of these. A byte that is not UTF-8, or a control
 * character, becomes a question mark. Two percent signs would begin a special character; three mean one percent
 * sign. */
static void write_string(output *out, const char *text)
{
    size_t length;
    char escaped[20];
    const bool percents = strstr(text, "%%") != NULL;
    write_code(out, 1);
    for (; *text; text += length) {
        const uint32_t c = letters_decode(text, &length);
        if (c >= 0x10000)
            snprintf(escaped, sizeof escaped, "\\U+%04X\\U+%04X", (unsigned)(0xd800 + ((c - 0x10000) >> 10)),
                     (unsigned)(0xdc00 + ((c - 0x10000) & 0x3ff)));
        else if (c > 0x9f)
            snprintf(escaped, sizeof escaped, "\\U+%04X", (unsigned)c);
        else
            snprintf(escaped, sizeof escaped, "%c", c < 0x20 || c >= 0x7f ? '?' : (int)c);
        output_text(out, c == '%' && percents ? "%%%" : escaped);
    }
    output_bytes(out, "\n", 1);
}

/* 72: 0 the text begins at the point, 1 it is centred there, 2 it ends there; in cases 1 and 2 the point is written
 * once more. */
static void write_texts(dxf *p, roberts_line class)
{
    const strokes *s = p->s;
    if (!has_text(s, class))
        return;
    p->layer = pens_class_name(class);
    for (size_t i = 0; i < s->notes.count; i++) {
        const text_line line = notes_line(&s->notes, i);
        const page_point at = page_from_mm(line.at, s->units_per_mm);
        const uint32_t aligned = line.align <= 0.0 ? 0 : line.align < 1.0 ? 1 : 2;
        if (!strokes_text_is_of(s, i, class) || !*line.text)
            continue;
        begin_entity(p, "TEXT");
        write_point(p, 10, at);
        write_mm(p->out, 40, line.height_mm);
        write_string(p->out, line.text);
        if (text_degrees(&line) != 0.0)
            write_mm(p->out, 50, text_degrees(&line));
        if (aligned > 0) {
            write_integer(p->out, 72, aligned);
            write_point(p, 11, at);
        }
    }
}

roberts_status dxf_write(const strokes *s, output *out, roberts_error *error)
{
    dxf p = {.s = s, .out = out, .height = page_round(s->page.height_mm * s->units_per_mm)};
    const plotter to = {.begin = begin_class, .stroke = write_stroke, .context = &p};
    write_header(&p);
    write_text(out, 0, "SECTION");
    write_text(out, 2, "TABLES");
    write_line_types(&p);
    write_layers(&p);
    write_text(out, 0, "ENDSEC");
    write_text(out, 0, "SECTION");
    write_text(out, 2, "ENTITIES");
    roberts_status status = plot_strokes(s, &to, out, error);
    write_texts(&p, LINE_TEXT);
    write_texts(&p, LINE_HIDDEN_TEXT);
    write_text(out, 0, "ENDSEC");
    write_text(out, 0, "EOF");
    return status;
}
