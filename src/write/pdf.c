/* pdf.c - the page as PDF 1.4 (Adobe, "PDF Reference, third edition", 2001): one page, one compressed stream, no date.
 *
 * The stream is written here and not by Cairo's PDF surface, which takes 2.8 times the time of SVG: it prints each
 * number by printf() and compresses at zlib's level 6. Here coordinates are whole units of the page, which a matrix
 * turns into points, and the compression is zlib's fastest. */
#include <stdlib.h>

#include "base/error.h"
#include "write/deflater.h"
#include "write/formats.h"
#include "write/plot.h"

/* ---- text -------------------------------------------------------------------------------------------------------- */

/* Text in PDF: Helvetica in the encoding WinAnsi, Greek and signs of mathematics in the font Symbol (Adobe, "PDF
 * Reference, third edition", 2001, appendix D). Both are among the fonts that need not be in the file. A character that
 * neither has is written without its accent, or as a question mark.
 *
 * Widths are those of Adobe's metrics of these fonts, in thousandths of the size. */

static const double capital = 0.718; /* height of capitals of Helvetica, as a part of its size */

/* From the blank to the tilde. */
static const unsigned short latin_width[95] = {
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333,  278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667,  611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278,  556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500,  500, 334, 260, 334, 584};

/* Greek letters in the order of their alphabet: small ones, then capitals. */
static const char greek_byte[] = "abgdezhqiklmnxoprstufcywABGDEZHQIKLMNXOPRSTUFCYW";
static const unsigned short greek_width[48] = {631, 549, 411, 494, 439, 494, 603, 521, 329, 549, 549, 576,
                                               521, 493, 549, 549, 549, 603, 439, 576, 521, 549, 686, 686,
                                               722, 667, 603, 612, 611, 611, 722, 741, 333, 722, 686, 889,
                                               722, 645, 722, 768, 556, 592, 611, 690, 763, 722, 795, 768};

/* Characters of WinAnsi that have other codes in Unicode. */
static const struct {
    uint32_t code;
    unsigned char byte;
    unsigned short width;
} latin_more[] = {{0x20ac, 0x80, 556}, {0x201a, 0x82, 222},  {0x201e, 0x84, 333}, {0x2026, 0x85, 1000},
                  {0x2018, 0x91, 222}, {0x2019, 0x92, 222},  {0x201c, 0x93, 333}, {0x201d, 0x94, 333},
                  {0x2013, 0x96, 556}, {0x2014, 0x97, 1000}, {0x160, 0x8a, 667},  {0x161, 0x9a, 500},
                  {0x17d, 0x8e, 611},  {0x17e, 0x9e, 500},   {0x152, 0x8c, 1000}, {0x153, 0x9c, 944},
                  {0x178, 0x9f, 667},  {0x2300, 0xd8, 778}};

/* Signs of Symbol that WinAnsi lacks. */
static const struct {
    uint16_t code;
    unsigned char byte;
    unsigned short width;
} symbol_signs[] = {
    {0x2032, 0xa2, 247}, {0x2033, 0xb2, 411},  {0x2190, 0xac, 987}, {0x2192, 0xae, 987}, {0x2194, 0xab, 1042},
    {0x21d2, 0xde, 987}, {0x21d4, 0xdb, 1042}, {0x2200, 0x22, 713}, {0x2202, 0xb6, 494}, {0x2203, 0x24, 549},
    {0x2205, 0xc6, 823}, {0x2207, 0xd1, 713},  {0x2208, 0xce, 713}, {0x2209, 0xcf, 713}, {0x220f, 0xd5, 823},
    {0x2211, 0xe5, 713}, {0x2212, 0x2d, 549},  {0x221a, 0xd6, 549}, {0x221e, 0xa5, 713}, {0x2220, 0xd0, 768},
    {0x2229, 0xc7, 768}, {0x222a, 0xc8, 768},  {0x222b, 0xf2, 274}, {0x2248, 0xbb, 549}, {0x2260, 0xb9, 549},
    {0x2261, 0xba, 549}, {0x2264, 0xa3, 549},  {0x2265, 0xb3, 549}, {0x2282, 0xcc, 713}, {0x22a5, 0x5e, 658}};

/* A character as bytes of one of the fonts. */
typedef struct glyph {
    unsigned char byte[4];
    size_t count;
    bool is_symbol, is_missing;
    double width; /* of all bytes, as a part of the size */
} glyph;

static glyph one_byte(unsigned byte, double width)
{
    return (glyph){.byte = {(unsigned char)byte}, .count = 1, .width = width / 1000.0};
}

static glyph symbol_byte(unsigned byte, double width)
{
    glyph g = one_byte(byte, width);
    g.is_symbol = true;
    return g;
}

static double letter_width(char letter)
{
    return latin_width[letter - ' '];
}

/* For the codes from 0xa0 to 0xff. Accents do not change the width of a letter. */
static double latin_1_width(uint32_t code)
{
    static const unsigned short sign[32] = {278, 333, 556, 556, 556, 556, 260, 556, 333, 737, 370,
                                            556, 584, 333, 737, 333, 400, 584, 333, 333, 333, 556,
                                            537, 278, 333, 333, 365, 556, 834, 834, 834, 611};
    size_t count;
    const char *plain = letters_plain(code, &count);
    if (code < 0xc0)
        return sign[code - 0xa0];
    if (code == 0xc6 || code == 0xe6)
        return code == 0xc6 ? 1000 : 889;
    if (code == 0xd7 || code == 0xf7)
        return 584;
    return plain && count == 1 ? letter_width(plain[0]) : code == 0xde ? 667 : code == 0xdf ? 611 : 556;
}

static glyph find_glyph(uint32_t code)
{
    const int greek = letters_greek_number(code);
    size_t count;
    const char *plain = code ? letters_plain(code, &count) : NULL;
    if (code >= ' ' && code <= '~')
        return one_byte(code, letter_width((char)code));
    if (code >= 0xa0 && code <= 0xff)
        return one_byte(code, latin_1_width(code));
    for (size_t i = 0; i < sizeof latin_more / sizeof latin_more[0]; i++)
        if (latin_more[i].code == code)
            return one_byte(latin_more[i].byte, latin_more[i].width);
    for (size_t i = 0; i < sizeof symbol_signs / sizeof symbol_signs[0]; i++)
        if (symbol_signs[i].code == code)
            return symbol_byte(symbol_signs[i].byte, symbol_signs[i].width);
    if (greek) {
        const int at = greek > 32 ? greek - 33 + 24 : greek - 1;
        return symbol_byte((unsigned char)greek_byte[at], greek_width[at]);
    }
    glyph g = {.count = 0};
    for (size_t i = 0; plain && i < count && i < sizeof g.byte; i++) {
        g.byte[g.count++] = (unsigned char)plain[i];
        g.width += letter_width(plain[i]) / 1000.0;
    }
    if (g.count == 0)
        g = one_byte('?', letter_width('?'));
    g.is_missing = code < 0x2000 || code > 0x206f || g.byte[0] == '?'; /* dashes and blanks lose nothing */
    return g;
}

size_t pdf_text_missing(const char *text, uint32_t *first)
{
    size_t missing = 0, length;
    for (; *text; text += length) {
        const uint32_t code = letters_decode(text, &length);
        if (!find_glyph(code).is_missing)
            continue;
        if (missing++ == 0 && first)
            *first = code;
    }
    return missing;
}

static double text_width(const char *text)
{
    double width = 0.0;
    size_t length;
    for (; *text; text += length)
        width += find_glyph(letters_decode(text, &length)).width;
    return width;
}

static void write_numbers(output *to, const double *number, int count, const char *operator)
{
    for (int i = 0; i < count; i++) {
        output_number(to, number[i]);
        output_bytes(to, " ", 1);
    }
    output_text(to, operator);
}

static void write_color(output *to, unsigned char red, unsigned char green, unsigned char blue, const char *operator)
{
    write_numbers(to, (const double[]){red / 255.0, green / 255.0, blue / 255.0}, 3, operator);
}

static void write_byte(output *to, unsigned char byte)
{
    if (byte == '(' || byte == ')' || byte == '\\')
        output_bytes(to, "\\", 1);
    output_bytes(to, &byte, 1);
}

/* Writes the text in runs of one font. */
static void write_runs(output *to, const char *text, double size)
{
    bool open = false, is_symbol = false;
    size_t length;
    for (; *text; text += length) {
        const glyph g = find_glyph(letters_decode(text, &length));
        if (!open || g.is_symbol != is_symbol) {
            output_text(to, open ? ") Tj " : "");
            output_text(to, g.is_symbol ? "/F2 " : "/F1 ");
            write_numbers(to, &size, 1, "Tf (");
        }
        open = true;
        is_symbol = g.is_symbol;
        for (size_t i = 0; i < g.count; i++)
            write_byte(to, g.byte[i]);
    }
    output_text(to, open ? ") Tj " : "");
}

/* y is down on the page, so letters must be turned over. */
static void write_line(const strokes *s, const text_line *line, output *to)
{
    const double size = line->height_mm / capital * s->units_per_mm;
    const double before = line->align * text_width(line->text) * size;
    const double x = line->at.x * s->units_per_mm, y = line->at.y * s->units_per_mm;
    const roberts_vec2 d = line->along, up = text_upward(d);
    output_text(to, "BT ");
    write_numbers(to, (const double[]){d.x, d.y, up.x, up.y, x - before * d.x, y - before * d.y}, 6, "Tm ");
    write_runs(to, line->text, size);
    output_text(to, "ET\n");
}

static void write_class(const strokes *s, roberts_line class, output *to)
{
    const roberts_pen *pen = pens_of(s->options, class);
    if (pen->off)
        return;
    write_color(to, pen->red, pen->green, pen->blue, "rg\n");
    for (size_t i = 0; i < s->notes.count; i++) {
        const text_line line = notes_line(&s->notes, i);
        if (strokes_text_is_of(s, i, class))
            write_line(s, &line, to);
    }
}

/* Does the page need fonts, or is all its text strokes? */
static bool has_fonts(const strokes *s)
{
    return strokes_text_is_native(s->options) && s->notes.count > 0;
}

/* Writes the text of the page, in its units. */
static void write_text(const strokes *s, output *to)
{
    if (!has_fonts(s))
        return;
    write_class(s, LINE_HIDDEN_TEXT, to);
    write_class(s, LINE_TEXT, to);
}

enum { COMPRESSION = 1, OFFSET_DIGITS = 10, TAIL_MOST = 1000 /* bytes behind the stream */ };

/* In a longer file, the positions of objects cannot be written. */
static const uint64_t longest_file = 9999999999;

enum { CATALOG = 1, PAGES, PAGE, CONTENT, CONTENT_LENGTH, LETTERS, GREEK, OBJECTS };

static const double points_per_mm = 72.0 / mm_per_inch;

/* The stream while it is written. */
typedef struct pdf_plot {
    const strokes *s;
    output text; /* goes through the deflater */
    deflater deflater;
} pdf_plot;

/* ---- the stream ---- */

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
    const roberts_pen *pen = pens_of(p->s->options, line);
    const double units = p->s->units_per_mm;
    double dash[2];
    write_color(&p->text, pen->red, pen->green, pen->blue, "RG ");
    write_numbers(&p->text, (const double[]){pen->width_mm * units}, 1, "w [");
    if (pens_dash(p->s->options, line, dash))
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
    const roberts_page *page = &p->s->page;
    const roberts_background *color = &p->s->options->background;
    const double points = points_per_mm / p->s->units_per_mm;
    if (color->on) {
        write_color(&p->text, color->red, color->green, color->blue, "rg\n");
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
        write_color(&p->text, color->red, color->green, color->blue, f->paint[i].seam ? "RG\n" : "rg\n");
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
    const plotter to = {.begin = begin_class, .stroke = write_stroke, .part = end_part, .context = p};
    p->s = s;
    output_start(&p->text, deflater_write, &p->deflater);
    write_page(p);
    write_fills(p);
    roberts_status status = plot_strokes(s, &to, out, error);
    write_text(s, &p->text);
    output_finish(&p->text, NULL); /* `out` records failures, and pdf_write() checks the length */
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
    output_text(out, has_fonts(s) ? "/Font << /F1 6 0 R /F2 7 0 R >> " : "");
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
    const roberts_page *page = &s->page;
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
    if (!has_fonts(s))
        return;
    begin_object(out, object, LETTERS);
    output_text(out, "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>\nendobj\n");
    begin_object(out, object, GREEK);
    output_text(out, "<< /Type /Font /Subtype /Type1 /BaseFont /Symbol >>\nendobj\n");
}

/* The table of the objects' positions. Each of its lines has 20 bytes. */
static void write_tail(output *out, const strokes *s, const uint64_t object[OBJECTS])
{
    const uint64_t table = output_position(out);
    const uint32_t objects = has_fonts(s) ? OBJECTS : LETTERS;
    output_text(out, "xref\n0 ");
    output_integer(out, objects);
    output_text(out, "\n0000000000 65535 f \n");
    for (uint32_t i = 1; i < objects; i++) {
        output_digits(out, object[i], OFFSET_DIGITS);
        output_text(out, " 00000 n \n");
    }
    output_text(out, "trailer\n<< /Size ");
    output_integer(out, objects);
    output_text(out, " /Root 1 0 R >>\nstartxref\n");
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
    write_tail(out, s, object);
    return status;
}
