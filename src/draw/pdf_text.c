/* pdf_text.c - text in PDF: Helvetica in the encoding WinAnsi, Greek in the font Symbol (Adobe, "PDF Reference, third
 * edition", 2001, appendix D). Both are among the fonts that need not be in the file. A character that neither has is
 * written without its accent, or as a question mark.
 *
 * Widths are those of Adobe's metrics of these fonts, in thousandths of the size. */
#include "draw/pdf_text.h"

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
                  {0x178, 0x9f, 667},  {0x2212, 0x96, 556},  {0x2300, 0xd8, 778}};

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

static double letter_width(char letter)
{
    return latin_width[letter - ' '];
}

/* Of the codes from 0xa0 to 0xff: letters are as wide as without their accents. */
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
    if (greek) {
        const int at = greek > 32 ? greek - 33 + 24 : greek - 1;
        glyph g = one_byte((unsigned char)greek_byte[at], greek_width[at]);
        g.is_symbol = true;
        return g;
    }
    glyph g = {.count = 0};
    for (size_t i = 0; plain && i < count && i < sizeof g.byte; i++) {
        g.byte[g.count++] = (unsigned char)plain[i];
        g.width += letter_width(plain[i]) / 1000.0;
    }
    if (g.count == 0) {
        g = one_byte('?', letter_width('?'));
        g.is_missing = true;
    }
    return g;
}

size_t pdf_text_missing(const char *text)
{
    size_t missing = 0, length;
    for (; *text; text += length)
        missing += find_glyph(letters_decode(text, &length)).is_missing;
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

/* ---- the stream ---- */

static void write_number(output *to, double number)
{
    output_number(to, number);
    output_bytes(to, " ", 1);
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
            write_number(to, size);
            output_text(to, "Tf (");
        }
        open = true;
        is_symbol = g.is_symbol;
        for (size_t i = 0; i < g.count; i++)
            write_byte(to, g.byte[i]);
    }
    output_text(to, open ? ") Tj " : "");
}

/* y is down on the page, so letters stand on their heads there. */
static void write_line(const strokes *s, const text_line *line, output *to)
{
    const double size = line->height_mm / capital * s->units_per_mm;
    const double before = line->align * text_width(line->text) * size;
    const double x = line->at.x * s->units_per_mm, y = line->at.y * s->units_per_mm;
    const roberts_vec2 d = line->along, up = text_upward(d);
    output_text(to, "BT ");
    write_number(to, d.x);
    write_number(to, d.y);
    write_number(to, up.x);
    write_number(to, up.y);
    write_number(to, x - before * d.x);
    write_number(to, y - before * d.y);
    output_text(to, "Tm ");
    write_runs(to, line->text, size);
    output_text(to, "ET\n");
}

static void write_class(const strokes *s, roberts_line class, output *to)
{
    const roberts_pen *pen = strokes_pen(s->options, class);
    if (pen->off)
        return;
    write_number(to, pen->red / 255.0);
    write_number(to, pen->green / 255.0);
    write_number(to, pen->blue / 255.0);
    output_text(to, "rg\n");
    for (size_t i = 0; i < s->notes.count; i++) {
        const text_line line = notes_line(&s->notes, i);
        if (s->notes.item[i].is_back == (class == LINE_HIDDEN_TEXT))
            write_line(s, &line, to);
    }
}

void pdf_text_write(const strokes *s, output *to)
{
    if (!strokes_text_is_native(s->options) || s->notes.count == 0)
        return;
    write_class(s, LINE_HIDDEN_TEXT, to);
    write_class(s, LINE_TEXT, to);
}

const char *pdf_text_fonts(const strokes *s)
{
    if (!strokes_text_is_native(s->options) || s->notes.count == 0)
        return "";
    return "/Font << /F1 << /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >> "
           "/F2 << /Type /Font /Subtype /Type1 /BaseFont /Symbol >> >> ";
}
