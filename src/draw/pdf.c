/* pdf.c - the page as PDF 1.4 (Adobe, "PDF Reference, third edition", 2001): one page, one compressed stream, no date.
 *
 * The stream is written here and not by Cairo's PDF surface, which takes 2.8 times the time of SVG: it prints each
 * number by printf() and compresses at zlib's level 6. Here coordinates are whole units of the page, which a matrix
 * turns into points, and the compression is zlib's fastest. */
#include <stdlib.h>

#include "base/error.h"
#include "draw/deflater.h"
#include "draw/formats.h"
#include "draw/pdf_text.h"
#include "draw/plot.h"

enum { COMPRESSION = 1, OFFSET_DIGITS = 10, TAIL_MOST = 1000 /* bytes behind the stream */ };

/* A file that is longer cannot say where its objects are. */
static const uint64_t longest_file = 9999999999;

enum { CATALOG = 1, PAGES, PAGE, CONTENT, CONTENT_LENGTH, OBJECTS };

static const double points_per_mm = 72.0 / 25.4;

/* The text of the stream on its way. */
typedef struct pdf_plot {
    const strokes *s;
    output text; /* goes through the deflater */
    deflater deflater;
} pdf_plot;

/* ---- the stream ---- */

static void write_numbers(output *text, const double *number, int count, const char *operator)
{
    for (int i = 0; i < count; i++) {
        output_number(text, number[i]);
        output_bytes(text, " ", 1);
    }
    output_text(text, operator);
}

static void write_color(output *text, const unsigned char rgb[3], const char *operator)
{
    write_numbers(text, (const double[]){rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0}, 3, operator);
}

/* Makes what follows as opaque as the resource says (write_resources()). */
static void write_alpha(output *text, int alpha)
{
    output_text(text, "/A");
    output_integer(text, (uint32_t)alpha);
    output_text(text, " gs\n");
}

static void begin_class(void *context, roberts_line line)
{
    pdf_plot *p = context;
    const roberts_pen *pen = strokes_pen(p->s->options, line);
    const double units = p->s->units_per_mm;
    double dash[2];
    write_color(&p->text, (const unsigned char[]){pen->red, pen->green, pen->blue}, "RG ");
    write_numbers(&p->text, (const double[]){pen->width_mm * units}, 1, "w [");
    if (strokes_dash(p->s->options, line, dash))
        write_numbers(&p->text, (const double[]){dash[0] * units, dash[1] * units}, 2, "");
    output_text(&p->text, "] 0 d\n");
}

static void write_point(output *text, page_point at, const char *operator)
{
    output_signed(text, at.x);
    output_bytes(text, " ", 1);
    output_signed(text, at.y);
    output_bytes(text, operator, 3);
}

static void write_stroke(void *context, const page_point *point, size_t count, bool closed)
{
    pdf_plot *p = context;
    write_point(&p->text, point[0], " m\n");
    for (size_t i = 1; i < count; i++)
        write_point(&p->text, point[i], " l\n");
    if (closed)
        output_bytes(&p->text, "h\n", 2);
}

static void end_part(void *context, bool last)
{
    pdf_plot *p = context;
    (void)last;
    output_bytes(&p->text, "S\n", 2);
}

/* y is down in the page's units, and up in points. */
static void write_page(pdf_plot *p)
{
    const roberts_page *page = &p->s->options->page;
    const roberts_background *color = &p->s->options->background;
    const double points = points_per_mm / p->s->units_per_mm;
    if (color->on) {
        write_color(&p->text, (const unsigned char[]){color->red, color->green, color->blue}, "rg\n");
        write_numbers(&p->text,
                      (const double[]){0.0, 0.0, page->width_mm * points_per_mm, page->height_mm * points_per_mm}, 4,
                      "re f\n");
    }
    write_numbers(&p->text, (const double[]){points, 0.0, 0.0, -points, 0.0, page->height_mm * points_per_mm}, 6,
                  "cm\n1 J 1 j\n");
}

/* Writes the lines of a paint; `operator` paints what is in the path. */
static void write_paint(pdf_plot *p, const fill_paint *paint, const char *operator)
{
    const fills *f = &p->s->fills;
    for (size_t i = paint->first; i < paint->end; i++) {
        const polyline *line = &f->lines.item[i];
        write_stroke(p, f->lines.point + line->first, line->count, line->closed);
    }
    output_text(&p->text, operator);
}

static void write_fills(pdf_plot *p)
{
    const fills *f = &p->s->fills;
    int alpha = 255;
    if (f->count == 0)
        return;
    write_numbers(&p->text, (const double[]){f->seam_mm * p->s->units_per_mm}, 1, "w\n");
    for (size_t i = 0; i < f->count; i++) {
        const fill_color *color = &f->paint[i].color;
        if (color->alpha != alpha)
            write_alpha(&p->text, alpha = color->alpha);
        write_color(&p->text, (const unsigned char[]){color->red, color->green, color->blue},
                    f->paint[i].seam ? "RG\n" : "rg\n");
        write_paint(p, &f->paint[i], f->paint[i].seam ? "S\n" : "f\n");
    }
    if (alpha != 255)
        write_alpha(&p->text, 255);
}

static bool put_compressed(void *out, const void *bytes, size_t size)
{
    output *to = out;
    output_bytes(to, bytes, size);
    return !to->failed && output_position(to) <= longest_file;
}

static roberts_status write_stream(const strokes *s, output *out, roberts_error *error)
{
    pdf_plot *p = malloc(sizeof *p);
    if (!p || !deflater_start(&p->deflater, COMPRESSION, put_compressed, out)) {
        free(p);
        return error_no_memory(error);
    }
    const plotter to = {begin_class, write_stroke, end_part, p};
    p->s = s;
    output_start(&p->text, deflater_write, &p->deflater);
    write_page(p);
    write_fills(p);
    roberts_status status = plot_strokes(s, &to, out, error);
    pdf_text_write(s, &p->text);
    output_finish(&p->text, NULL); /* `out` knows of failures, and pdf_write() looks at the length */
    deflater_finish(&p->deflater);
    deflater_end(&p->deflater);
    free(p);
    return status;
}

/* ---- the file ---- */

static void begin_object(output *out, uint64_t object[OBJECTS], int number)
{
    object[number] = output_position(out);
    output_integer(out, (uint32_t)number);
    output_text(out, " 0 obj\n");
}

/* The fonts of text, and a state of graphics for each translucency that fills use: they are called A0 to A255. */
static void write_resources(output *out, const strokes *s)
{
    const fills *f = &s->fills;
    bool used[256] = {false}, any = false;
    for (size_t i = 0; i < f->count; i++)
        used[f->paint[i].color.alpha] = true;
    for (int alpha = 0; alpha < 255; alpha++)
        any = any || used[alpha];
    output_text(out, "<< ");
    output_text(out, pdf_text_fonts(s));
    output_text(out, any ? "/ExtGState << " : "");
    for (uint32_t alpha = 0; any && alpha < 256; alpha++)
        if (used[alpha] || alpha == 255) {
            output_text(out, "/A");
            output_integer(out, alpha);
            output_text(out, " << /ca ");
            output_number(out, alpha / 255.0);
            output_text(out, " >> ");
        }
    output_text(out, any ? ">> >>" : ">>");
}

static void write_head(output *out, const strokes *s, uint64_t object[OBJECTS])
{
    const roberts_page *page = &s->options->page;
    output_text(out, "%PDF-1.4\n%\xb5\xed\xae\xfb\n"); /* bytes above 127 say that the file is binary */
    begin_object(out, object, CATALOG);
    output_text(out, "<< /Type /Catalog /Pages 2 0 R >>\nendobj\n");
    begin_object(out, object, PAGES);
    output_text(out, "<< /Type /Pages /Kids [3 0 R] /Count 1 >>\nendobj\n");
    begin_object(out, object, PAGE);
    output_text(out, "<< /Type /Page /Parent 2 0 R /Resources ");
    write_resources(out, s);
    output_text(out, " /Contents 4 0 R /MediaBox [0 0 ");
    write_numbers(out, (const double[]){page->width_mm * points_per_mm, page->height_mm * points_per_mm}, 2,
                  "] >>\nendobj\n");
}

/* The table of where the objects are. Each of its lines has 20 bytes. */
static void write_tail(output *out, const uint64_t object[OBJECTS])
{
    const uint64_t table = output_position(out);
    output_text(out, "xref\n0 6\n0000000000 65535 f \n");
    for (int i = 1; i < OBJECTS; i++) {
        output_digits(out, object[i], OFFSET_DIGITS);
        output_text(out, " 00000 n \n");
    }
    output_text(out, "trailer\n<< /Size 6 /Root 1 0 R >>\nstartxref\n");
    output_digits(out, table, OFFSET_DIGITS);
    output_text(out, "\n%%EOF\n");
}

roberts_status pdf_write(const strokes *s, output *out, roberts_error *error)
{
    uint64_t object[OBJECTS] = {0};
    write_head(out, s, object);
    begin_object(out, object, CONTENT);
    output_text(out, "<< /Length 5 0 R /Filter /FlateDecode >>\nstream\n");
    const uint64_t start = output_position(out);
    roberts_status status = write_stream(s, out, error);
    const uint64_t size = output_position(out) - start;
    if (status == ROBERTS_OK && !out->failed && output_position(out) + TAIL_MOST > longest_file)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0,
                         "a PDF of more than 10^10 bytes cannot say where its parts are; choose another format");
    output_text(out, "\nendstream\nendobj\n");
    begin_object(out, object, CONTENT_LENGTH);
    output_digits(out, size, OFFSET_DIGITS);
    output_text(out, "\nendobj\n");
    write_tail(out, object);
    return status;
}
