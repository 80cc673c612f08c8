/* tikz.c - the page as a picture of TikZ, for \input in a LaTeX document that loads the package tikz, in a picture of
 * its own or as a part of one.
 *
 * Each stroke is a path, each class a style: "roberts outline", "roberts crease", ... A style that the document has
 * defined is left as it is. Units are mm, the origin is the lower left corner of the page, and y is up. Each vertex
 * of a line that is drawn is a coordinate: v12 is vertex 12. */
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/error.h"
#include "draw/letters.h"
#include "write/formats.h"
#include "write/plot.h"

/* ---- text -------------------------------------------------------------------------------------------------------- */

/* Characters that TeX reads as commands get names, Greek letters and signs of mathematics are in mathematics. All
 * others stay as they are, in UTF-8, which LaTeX reads since 2018. */

/* A character, and what it is in TeX. */
typedef struct tex_word {
    uint32_t code;
    const char *text;
} tex_word;

/* Characters that are special in TeX, or missing from old fonts. */
static const tex_word names[] = {{'#', "\\#"},
                                 {'$', "\\$"},
                                 {'%', "\\%"},
                                 {'&', "\\&"},
                                 {'_', "\\_"},
                                 {'{', "\\{"},
                                 {'}', "\\}"},
                                 {'\\', "\\textbackslash{}"},
                                 {'^', "\\textasciicircum{}"},
                                 {'~', "\\textasciitilde{}"},
                                 {'<', "\\textless{}"},
                                 {'>', "\\textgreater{}"},
                                 {'|', "\\textbar{}"},
                                 {'"', "''"},
                                 {0x2300, "\\O{}"}};

/* Signs that plain LaTeX has in mathematics only. Its sums, products and integrals do not grow with the text. */
static const tex_word mathematics[] = {{0xb0, "{}^\\circ"},
                                       {0xb1, "\\pm"},
                                       {0xb7, "\\cdot"},
                                       {0xbd, "\\frac12"},
                                       {0xd7, "\\times"},
                                       {0xf7, "\\div"},
                                       {0x2032, "{}^\\prime"},
                                       {0x2033, "{}^{\\prime\\prime}"},
                                       {0x2034, "{}^{\\prime\\prime\\prime}"},
                                       {0x2190, "\\leftarrow"},
                                       {0x2192, "\\rightarrow"},
                                       {0x2194, "\\leftrightarrow"},
                                       {0x21d2, "\\Rightarrow"},
                                       {0x21d4, "\\Leftrightarrow"},
                                       {0x2200, "\\forall"},
                                       {0x2202, "\\partial"},
                                       {0x2203, "\\exists"},
                                       {0x2205, "\\emptyset"},
                                       {0x2207, "\\nabla"},
                                       {0x2208, "\\in"},
                                       {0x2209, "\\notin"},
                                       {0x220f, "\\Pi"},
                                       {0x2211, "\\Sigma"},
                                       {0x2212, "-"},
                                       {0x2213, "\\mp"},
                                       {0x221a, "\\surd"},
                                       {0x221e, "\\infty"},
                                       {0x2220, "\\angle"},
                                       {0x2225, "\\parallel"},
                                       {0x2229, "\\cap"},
                                       {0x222a, "\\cup"},
                                       {0x222b, "\\smallint"},
                                       {0x2248, "\\approx"},
                                       {0x2260, "\\neq"},
                                       {0x2261, "\\equiv"},
                                       {0x2264, "\\leq"},
                                       {0x2265, "\\geq"},
                                       {0x2282, "\\subset"},
                                       {0x22a5, "\\perp"},
                                       {0x25b3, "\\triangle"}};

/* Ranges of characters beyond ASCII that LaTeX defines itself, in the encoding T1. */
static const struct {
    uint16_t first, last;
} defined[] = {{0xa0, 0x125},    {0x128, 0x137},   {0x139, 0x13e},   {0x141, 0x148},   {0x14a, 0x165},
               {0x168, 0x17e},   {0x192, 0x192},   {0x1cd, 0x1d4},   {0x1e6, 0x1eb},   {0x1f0, 0x1f0},
               {0x1f4, 0x1f5},   {0x218, 0x21b},   {0x237, 0x237},   {0x1e9e, 0x1e9e}, {0x2010, 0x2016},
               {0x2018, 0x201a}, {0x201c, 0x201e}, {0x2020, 0x2022}, {0x2026, 0x2026}, {0x2030, 0x2031},
               {0x2039, 0x203b}, {0x20ac, 0x20ac}, {0x2103, 0x2103}, {0x2116, 0x2117}, {0x2122, 0x2122},
               {0x2190, 0x2193}, {0x25e6, 0x25e6}, {0x25ef, 0x25ef}, {0x27e8, 0x27e9}};

/* Commands for accents that follow their letter: LaTeX reads no combining characters. */
static const tex_word accents[] = {{0x300, "\\`"}, {0x301, "\\'"}, {0x302, "\\^"}, {0x303, "\\~"},  {0x304, "\\="},
                                   {0x305, "\\="}, {0x306, "\\u"}, {0x307, "\\."}, {0x308, "\\\""}, {0x30a, "\\r"},
                                   {0x30b, "\\H"}, {0x30c, "\\v"}, {0x327, "\\c"}, {0x328, "\\k"}};

/* Of these, what the encoding OT1 lacks, which LaTeX takes without \usepackage[T1]{fontenc}. */
static const uint16_t only_in_t1[] = {0xab,  0xbb,  0xd0,  0xde,   0xf0,   0xfe,   0x104, 0x105, 0x110,
                                      0x111, 0x118, 0x119, 0x12e,  0x12f,  0x14a,  0x14b, 0x172, 0x173,
                                      0x1ea, 0x1eb, 0x328, 0x201a, 0x201e, 0x2039, 0x203a};

static const char *find_tex_word(const tex_word *word, size_t count, uint32_t code)
{
    for (size_t i = 0; i < count; i++)
        if (word[i].code == code)
            return word[i].text;
    return NULL;
}

/* TeX has no commands for Greek letters that look like Latin ones. */
static const char *tex_greek(int number)
{
    /* [number of letters_greek_number()] */
    static const char *const name[] = {[1] = "alpha", "beta",      "gamma",     "delta",     "varepsilon",
                                       "zeta",        "eta",       "theta",     "iota",      "kappa",
                                       "lambda",      "mu",        "nu",        "xi",        "mathrm{o}",
                                       "pi",          "rho",       "sigma",     "tau",       "upsilon",
                                       "varphi",      "chi",       "psi",       "omega",     [33] = "mathrm{A}",
                                       "mathrm{B}",   "Gamma",     "Delta",     "mathrm{E}", "mathrm{Z}",
                                       "mathrm{H}",   "Theta",     "mathrm{I}", "mathrm{K}", "Lambda",
                                       "mathrm{M}",   "mathrm{N}", "Xi",        "mathrm{O}", "Pi",
                                       "mathrm{P}",   "Sigma",     "mathrm{T}", "Upsilon",   "Phi",
                                       "mathrm{X}",   "Psi",       "Omega"};
    return name[number];
}

static const char *find_name(uint32_t code)
{
    return find_tex_word(names, sizeof names / sizeof names[0], code);
}

static const char *find_sign(uint32_t code)
{
    return find_tex_word(mathematics, sizeof mathematics / sizeof mathematics[0], code);
}

/* The command for the accent that the text begins with. Each accent has two bytes. */
static const char *find_accent(const char *text)
{
    size_t length;
    return find_tex_word(accents, sizeof accents / sizeof accents[0], letters_decode(text, &length));
}

static bool is_defined(uint32_t code)
{
    if ((code >= ' ' && code <= '~') || find_sign(code) || find_name(code))
        return true;
    for (size_t i = 0; i < sizeof defined / sizeof defined[0]; i++)
        if (code >= defined[i].first && code <= defined[i].last)
            return true;
    return letters_greek_number(code) || letters_level(code);
}

/* Is there no definition of the character at `at`? */
static bool is_missing(const char *text, const char *at, uint32_t code)
{
    return !is_defined(code) && !(at > text && find_accent(at));
}

static bool is_only_in_t1(const char *text, const char *at, uint32_t code)
{
    (void)text, (void)at;
    for (size_t i = 0; i < sizeof only_in_t1 / sizeof only_in_t1[0]; i++)
        if (only_in_t1[i] == code)
            return true;
    return false;
}

/* Counts these characters outside formulas, and stores the first. */
static size_t count_characters(const char *text, bool (*counts)(const char *text, const char *at, uint32_t code),
                               uint32_t *first)
{
    size_t found = 0, length;
    for (const char *at = text; *at; at += length) {
        const uint32_t code = letters_decode(at, &length);
        const size_t formula = letters_formula(at);
        if (formula)
            length = formula;
        else if (counts(text, at, code) && found++ == 0 && first)
            *first = code;
    }
    return found;
}

size_t tikz_text_missing(const char *text, uint32_t *first)
{
    return count_characters(text, is_missing, first);
}

size_t tikz_text_only_in_t1(const char *text, uint32_t *first)
{
    return count_characters(text, is_only_in_t1, first);
}

void tikz_text_write(output *out, const char *text)
{
    size_t length, count;
    for (; *text; text += length) {
        const uint32_t code = letters_decode(text, &length);
        const size_t formula = letters_formula(text);
        size_t marks = 0;
        if (formula) {
            output_bytes(out, text, formula);
            length = formula;
            continue;
        }
        while (find_accent(text + length + 2 * marks))
            marks++;
        for (size_t i = marks; i > 0; i--) { /* the last one is the outermost */
            output_text(out, find_accent(text + length + 2 * (i - 1)));
            output_text(out, "{");
        }
        const int greek = letters_greek_number(code), level = letters_level(code);
        const char *name = find_name(code), *sign = find_sign(code);
        if (name) {
            output_text(out, name);
        } else if (sign || greek) {
            output_text(out, sign ? "\\ensuremath{" : "\\ensuremath{\\");
            output_text(out, sign ? sign : tex_greek(greek));
            output_text(out, "}");
        } else if (level) {
            output_text(out, level > 0 ? "\\textsuperscript{" : "\\textsubscript{");
            output_bytes(out, letters_plain(code, &count), 1);
            output_text(out, "}");
        } else if (code < ' ' || code == 0x7f) {
            output_text(out, "?");
        } else {
            output_bytes(out, text, length);
        }
        for (; marks > 0; marks--, length += 2)
            output_text(out, "}");
    }
}

/* ---- the page ---------------------------------------------------------------------------------------------------- */

static const double longest_mm = 5700.0; /* TeX's longest length is 5758 mm */

enum { POINTS_A_LINE = 8 /* then the text goes on in a new line */ };

typedef struct tikz {
    const strokes *s;
    output *out;
    int32_t height; /* of the page, in its units */
} tikz;

/* ---- text ---- */

/* Writes (x,y). */
static void write_point(const tikz *p, page_point at)
{
    output_bytes(p->out, "(", 1);
    output_thousandths(p->out, at.x * p->s->thousandths);
    output_bytes(p->out, ",", 1);
    output_thousandths(p->out, (p->height - at.y) * p->s->thousandths);
    output_bytes(p->out, ")", 1);
}

/* Writes a comment; nothing where `text` is NULL. A byte that could end the line, or is no UTF-8, becomes a question
 * mark. */
static void write_comment(output *out, const char *text)
{
    if (!text || !*text)
        return;
    output_text(out, "% ");
    while (*text) {
        size_t length = output_character(text);
        output_bytes(out, length && *text != '\n' ? text : "?", length ? length : 1);
        text += length ? length : 1;
    }
    output_text(out, "\n");
}

/* Writes a colour for TikZ, as {rgb,255:red,200;green,0;blue,0}. */
static void write_color(output *out, unsigned char red, unsigned char green, unsigned char blue)
{
    const unsigned char part[] = {red, green, blue};
    static const char *const name[] = {"{rgb,255:red,", ";green,", ";blue,"};
    for (int i = 0; i < 3; i++) {
        output_text(out, name[i]);
        output_integer(out, part[i]);
    }
    output_text(out, "}");
}

/* ---- styles ---- */

/* Opens the definition of a style, unless the document has one. */
static void begin_style(output *out, const char *name)
{
    output_text(out, "\\pgfkeysifdefined{/tikz/roberts ");
    output_text(out, name);
    output_text(out, "/.@cmd}{}{\\tikzset{roberts ");
    output_text(out, name);
    output_text(out, "/.style={");
}

static void write_style(const strokes *s, roberts_line line, output *out)
{
    const roberts_pen *pen = pens_of(s->options, line);
    double dash[2];
    begin_style(out, pens_class_name(line));
    output_text(out, "draw=");
    write_color(out, pen->red, pen->green, pen->blue);
    output_text(out, ",line width=");
    output_mm(out, pen->width_mm);
    output_text(out, "mm,line cap=round,line join=round");
    if (pens_dash(s->options, line, dash)) {
        output_text(out, ",dash pattern=on ");
        output_mm(out, dash[0]);
        output_text(out, "mm off ");
        output_mm(out, dash[1]);
        output_text(out, "mm");
    }
    output_text(out, "}}}\n");
}

/* The page's rectangle as a path. It determines the size of the picture only if there is a background. Otherwise the
 * picture is as large as the drawing, and the document can make it as large as the page. */
static void write_page(const tikz *p)
{
    const roberts_background *color = &p->s->options->background;
    begin_style(p->out, "page");
    output_text(p->out, color->on ? "fill=" : "overlay");
    if (color->on)
        write_color(p->out, color->red, color->green, color->blue);
    output_text(p->out, "}}}\n\\path[roberts page] (0,0) rectangle (");
    output_mm(p->out, p->s->page.width_mm);
    output_text(p->out, ",");
    output_mm(p->out, p->s->page.height_mm);
    output_text(p->out, ");\n");
}

/* ---- vertices ---- */

typedef struct drawn_vertex {
    uint32_t number;
    page_point at;
} drawn_vertex;

static int by_number(const void *a, const void *b)
{
    const drawn_vertex *p = a, *q = b;
    if (p->number != q->number)
        return p->number < q->number ? -1 : 1;
    if (p->at.x != q->at.x)
        return p->at.x < q->at.x ? -1 : 1;
    return (p->at.y > q->at.y) - (p->at.y < q->at.y);
}

/* Appends one end of a segment if it is a vertex within the page's frame. */
static void add_vertex(const strokes *s, uint32_t number, roberts_vec2 end, drawn_vertex *list, size_t *count)
{
    roberts_vec2 mm = page_place(&s->map, end);
    if (number != ROBERTS_NONE && strokes_is_in_frame(s, s->view, mm))
        list[(*count)++] = (drawn_vertex){number, page_from_mm(mm, s->units_per_mm)};
}

/* Writes the vertices at which a line that is drawn begins or ends, each once. A sheet has each vertex in several
 * views: there they are left out. */
static roberts_status write_vertices(const tikz *p, roberts_error *error)
{
    const roberts_drawing *drawing = p->s->drawing;
    size_t count = 0;
    roberts_line line;
    if (!drawing)
        return ROBERTS_OK;
    drawn_vertex *list = alloc_array(drawing->count, 2 * sizeof *list);
    if (!list)
        return error_no_memory(error);
    for (size_t i = 0; i < drawing->count; i++) {
        const roberts_segment *segment = &drawing->segment[i];
        if (!strokes_has_place(p->s->options, segment, &line))
            continue;
        if (segment->t0 == 0.0)
            add_vertex(p->s, segment->v0, segment->p0, list, &count);
        if (segment->t1 == 1.0)
            add_vertex(p->s, segment->v1, segment->p1, list, &count);
    }
    qsort(list, count, sizeof *list, by_number);
    for (size_t i = 0; i < count; i++) {
        if (i > 0 && list[i].number == list[i - 1].number)
            continue;
        output_text(p->out, "\\coordinate (v");
        output_integer(p->out, list[i].number);
        output_text(p->out, ") at ");
        write_point(p, list[i].at);
        output_text(p->out, ";\n");
    }
    free(list);
    return ROBERTS_OK;
}

/* ---- strokes ---- */

static void begin_class(void *context, roberts_line line)
{
    const tikz *p = context;
    write_style(p->s, line, p->out);
    output_text(p->out, "\\begin{scope}[every path/.style={roberts ");
    output_text(p->out, pens_class_name(line));
    output_text(p->out, "}]\n");
}

static void write_points(const tikz *p, const page_point *point, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (i > 0)
            output_text(p->out, i % POINTS_A_LINE == 0 ? "\n--" : "--");
        write_point(p, point[i]);
    }
}

static void write_stroke(void *context, const page_point *point, size_t count, bool closed)
{
    const tikz *p = context;
    output_text(p->out, "\\path ");
    write_points(p, point, count);
    output_text(p->out, closed ? "--cycle;\n" : ";\n");
}

static void end_part(void *context, bool last)
{
    const tikz *p = context;
    if (last)
        output_text(p->out, "\\end{scope}\n");
}

/* ---- fills ---- */

/* One path for each colour, and one for each line of a seam. */
static void write_fills(const tikz *p)
{
    const fills *f = &p->s->fills;
    for (size_t i = 0; i < f->count; i++) {
        const fill_paint *paint = &f->paint[i];
        const fill_color *color = &paint->color;
        for (size_t k = paint->first; k < paint->end; k++) {
            if (k == paint->first || paint->seam) {
                output_text(p->out, paint->seam ? "\\path[line width=" : "\\path[fill=");
                if (paint->seam) {
                    output_mm(p->out, f->seam_mm);
                    output_text(p->out, "mm,line cap=round,line join=round,draw=");
                }
                write_color(p->out, color->red, color->green, color->blue);
                if (color->alpha < 255) {
                    output_text(p->out, ",fill opacity=");
                    output_mm(p->out, color->alpha / 255.0);
                }
                output_text(p->out, "] ");
            }
            const polyline *line = &f->lines.item[k];
            write_points(p, f->lines.point + line->first, line->count);
            if (line->closed)
                output_text(p->out, "--cycle\n");
            if (k + 1 == paint->end || paint->seam)
                output_text(p->out, ";\n");
        }
    }
}

/* ---- text of the document ---- */

/* The size of a font whose capitals have a height of 1, as in Computer Modern. */
static const double size_of_capitals = 1.0 / 0.683;

/* A document that defines this command itself decides about sizes. */
static const char size_command[] = "\\providecommand\\robertssize[1]{\\fontsize{#1}{#1}\\selectfont}\n";

/* Writes the text of a class as nodes, unless it is strokes: in the font of the document, in its own size. */
static void write_nodes(const tikz *p, roberts_line class)
{
    const strokes *s = p->s;
    const roberts_pen *pen = pens_of(s->options, class);
    const char *style = class == LINE_TEXT ? "letters" : "hidden-letters";
    size_t written = 0;
    for (size_t i = 0; i < s->notes.count && strokes_text_is_native(s->options) && !pen->off; i++) {
        const text_line line = notes_line(&s->notes, i);
        if (!strokes_text_is_of(s, i, class))
            continue;
        if (written++ == 0) {
            begin_style(p->out, style);
            output_text(p->out, "inner sep=0pt,outer sep=0pt,text=");
            write_color(p->out, pen->red, pen->green, pen->blue);
            output_text(p->out, "}}}\n");
            output_text(p->out, size_command);
        }
        output_text(p->out, "\\node[font=\\robertssize{");
        output_mm(p->out, size_of_capitals * line.height_mm);
        output_text(p->out, "mm},roberts ");
        output_text(p->out, style);
        output_text(p->out, line.align <= 0.0  ? ",anchor=base west"
                            : line.align < 1.0 ? ",anchor=base"
                                               : ",anchor=base east");
        if (text_degrees(&line) != 0.0) {
            output_text(p->out, ",rotate=");
            output_mm(p->out, text_degrees(&line));
        }
        output_text(p->out, "] at ");
        write_point(p, page_from_mm(line.at, s->units_per_mm));
        output_text(p->out, " {");
        tikz_text_write(p->out, line.text);
        output_text(p->out, "};\n");
    }
}

/* Inside a picture of the document, the file becomes part of it. */
static const char begin_picture[] =
    "\\ifpgfpicture\\def\\robertspicture{scope}\\else\\def\\robertspicture{tikzpicture}\\fi\n"
    "\\begin{\\robertspicture}[x=1mm,y=1mm]\n";

roberts_status tikz_write(const strokes *s, output *out, roberts_error *error)
{
    const roberts_page *page = &s->page;
    tikz p = {.s = s, .out = out, .height = page_round(page->height_mm * s->units_per_mm)};
    const plotter to = {.begin = begin_class, .stroke = write_stroke, .part = end_part, .context = &p};
    if (page->width_mm > longest_mm || page->height_mm > longest_mm)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0,
                         "TeX knows no lengths of more than %g mm: choose a smaller page", longest_mm);
    write_comment(out, s->options->title);
    write_comment(out, s->options->description);
    output_text(out, begin_picture);
    write_page(&p);
    write_fills(&p);
    roberts_status status = write_vertices(&p, error);
    if (status == ROBERTS_OK)
        status = plot_strokes(s, &to, out, error);
    write_nodes(&p, LINE_HIDDEN_TEXT);
    write_nodes(&p, LINE_TEXT);
    output_text(out, "\\end{\\robertspicture}%\n"); /* otherwise the line end would be a space beside the picture */
    return status;
}
