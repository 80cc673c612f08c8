/* plots.c - reads strokes back from TikZ, DXF and HP-GL/2, and compares them with those of an SVG.
 *
 * It reads only what src/draw/ writes. */
#include "plots.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"

static const char *const class_names[PAPER_CLASSES] = {
    "outline", "crease", "hidden", "border", "wire", "intersection", "frame", "symbol", "hatch", "text", "hidden-text"};

/* The class whose name begins `text`, in small or capital letters, and ends before `end`; -1: none. */
static int class_at(const char *text, char end)
{
    for (int i = 0; i < PAPER_CLASSES; i++) {
        size_t length = strlen(class_names[i]), same = 0;
        while (same < length && (text[same] | 32) == class_names[i][same])
            same++;
        if (same == length && text[length] == end)
            return i;
    }
    return -1;
}

/* ---- strokes --------------------------------------------------------------------------------------------------- */

typedef struct reader {
    plot *p;
    double height_mm;
    int line; /* class */
    roberts_vec2 start, at;
    bool failed;
} reader;

/* Points in mm, y up. */
static void lift_to(reader *r, double x, double y)
{
    r->start = r->at = (roberts_vec2){x, r->height_mm - y};
    r->p->lines.strokes++;
}

static void draw_to(reader *r, double x, double y)
{
    paper *to = &r->p->lines;
    const roberts_vec2 next = {x, r->height_mm - y};
    r->failed = r->failed || r->line < 0 || !array_reserve(&to->item, &to->room, to->count + 1, sizeof *to->item);
    if (!r->failed)
        to->item[to->count++] = (paper_line){r->at, next, r->line, to->strokes};
    r->at = next;
}

static void draw_home(reader *r)
{
    draw_to(r, r->start.x, r->height_mm - r->start.y);
}

static plot_pen *begin_class(reader *r, int line)
{
    r->line = line;
    r->failed = r->failed || line < 0;
    if (r->failed)
        return &r->p->pen[0];
    r->p->pen[line].used = true;
    return &r->p->pen[line];
}

/* Whether the text goes on with `word`; then it is passed. */
static bool passed(const char **at, const char *word)
{
    size_t length = strlen(word);
    bool is_there = strncmp(*at, word, length) == 0;
    *at += is_there ? length : 0;
    return is_there;
}

static double number(reader *r, const char **at)
{
    char *end;
    double value = strtod(*at, &end);
    r->failed = r->failed || end == *at;
    *at = end;
    return value;
}

/* A whole number. */
static uint32_t whole(reader *r, const char **at)
{
    double value = number(r, at);
    r->failed = r->failed || !(value >= 0.0 && value == floor(value));
    return r->failed ? 0 : (uint32_t)value;
}

static void expect(reader *r, const char **at, const char *word)
{
    r->failed = !passed(at, word) || r->failed;
}

/* ---- SVG ------------------------------------------------------------------------------------------------------- */

/* The pens; paper_read_svg() has read the lines. */
static void read_svg_pens(reader *r, const char *text)
{
    for (const char *at = text; !r->failed && (at = strstr(at, "<g id=\"")) != NULL;) {
        at += strlen("<g id=\"");
        plot_pen *pen = begin_class(r, class_at(at, '"'));
        at = strstr(at, " stroke=\"#");
        r->failed = r->failed || !at;
        if (r->failed)
            return;
        char *end;
        pen->color = (uint32_t)strtoul(at + 10, &end, 16);
        at = end;
        expect(r, &at, "\" stroke-width=\"");
        pen->width_mm = number(r, &at);
        expect(r, &at, "\" stroke-linecap=\"round\" stroke-linejoin=\"round\"");
        pen->dashed = passed(&at, " stroke-dasharray=\"");
        if (pen->dashed) {
            pen->down_mm = number(r, &at);
            pen->up_mm = number(r, &at);
        }
    }
}

/* ---- TikZ ------------------------------------------------------------------------------------------------------ */

static void read_tikz_style(reader *r, const char *at)
{
    plot_pen *pen = begin_class(r, class_at(at, '/'));
    at = strstr(at, "draw={rgb,255:red,");
    r->failed = r->failed || !at;
    if (r->failed)
        return;
    at += strlen("draw={rgb,255:red,");
    pen->color = whole(r, &at) << 16;
    expect(r, &at, ";green,");
    pen->color |= whole(r, &at) << 8;
    expect(r, &at, ";blue,");
    pen->color |= whole(r, &at);
    expect(r, &at, "},line width=");
    pen->width_mm = number(r, &at);
    expect(r, &at, "mm,line cap=round,line join=round");
    pen->dashed = passed(&at, ",dash pattern=on ");
    if (pen->dashed) {
        pen->down_mm = number(r, &at);
        expect(r, &at, "mm off ");
        pen->up_mm = number(r, &at);
        expect(r, &at, "mm");
    }
    expect(r, &at, "}}}\n");
}

static void read_tikz_path(reader *r, const char *at)
{
    for (bool first = true; !r->failed; first = false) {
        if (!first && passed(&at, "cycle;")) {
            draw_home(r);
            return;
        }
        expect(r, &at, "(");
        double x = number(r, &at);
        expect(r, &at, ",");
        double y = number(r, &at);
        expect(r, &at, ")");
        first ? lift_to(r, x, y) : draw_to(r, x, y);
        if (passed(&at, ";"))
            return;
        passed(&at, "\n");
        expect(r, &at, "--");
    }
}

static void read_tikz(reader *r, const char *text)
{
    static const char style[] = "\\pgfkeysifdefined{/tikz/roberts ",
                      scope[] = "\\begin{scope}[every path/.style={roberts ";
    const char *at = text;
    int scopes = 0;
    for (; !r->failed && *at; at = strchr(at, '\n') + 1) {
        const char *word = at;
        if (passed(&word, "\\path [") || passed(&word, "\\path[roberts page]"))
            continue;
        if (passed(&word, style)) {
            if (!passed(&word, "page/"))
                read_tikz_style(r, word);
        } else if (passed(&word, scope)) {
            r->failed = r->failed || class_at(word, '}') != r->line || scopes++ != 0;
        } else if (passed(&word, "\\end{scope}")) {
            r->failed = r->failed || --scopes != 0;
        } else if (passed(&word, "\\path ")) {
            r->failed = r->failed || scopes != 1;
            read_tikz_path(r, word);
        } else if (!(passed(&word, "%") || passed(&word, "--(") || passed(&word, "\\coordinate (v") ||
                     passed(&word, "\\ifpgfpicture") || passed(&word, "\\begin{\\robertspicture}[x=1mm,y=1mm]\n") ||
                     passed(&word, "\\end{\\robertspicture}%\n"))) {
            r->failed = true;
        }
    }
}

/* ---- DXF ------------------------------------------------------------------------------------------------------- */

enum { NAME = 40, LINE_TYPES = PAPER_CLASSES + 1 };

/* A record: a code and the value behind it. */
typedef struct record {
    int code;
    char text[NAME];
    double value;
} record;

static bool next_record(reader *r, const char **at, record *found)
{
    char *end;
    if (!**at || r->failed)
        return false;
    found->code = (int)strtol(*at, &end, 10);
    r->failed = end == *at || *end != '\n';
    size_t length = r->failed ? 0 : strcspn(end + 1, "\n");
    if (r->failed || end[1 + length] != '\n' || length >= NAME) {
        r->failed = true;
        return false;
    }
    memcpy(found->text, end + 1, length);
    found->text[length] = '\0';
    found->value = strtod(found->text, NULL);
    *at = end + 1 + length + 1;
    return true;
}

static bool is_record(const record *f, int code, const char *text)
{
    return f->code == code && strcmp(f->text, text) == 0;
}

typedef struct line_type {
    char name[NAME];
    double down_mm, up_mm;
} line_type;

/* Where the reader of a DXF is. */
typedef struct dxf {
    char section[NAME], table[NAME], entity[NAME];
    line_type type[LINE_TYPES];
    int types;
    double x[2], y[2]; /* of the entity's points */
    bool in_polyline, is_first, is_closed;
} dxf;

static void layer_has_type(reader *r, const dxf *d, const char *name)
{
    plot_pen *pen = &r->p->pen[r->line < 0 ? 0 : r->line];
    for (int i = 0; i < d->types; i++)
        if (strcmp(d->type[i].name, name) == 0) {
            pen->dashed = d->type[i].down_mm > 0.0;
            pen->down_mm = d->type[i].down_mm;
            pen->up_mm = d->type[i].up_mm;
            return;
        }
    r->failed = true;
}

static void read_dxf_table(reader *r, dxf *d, const record *f)
{
    line_type *type = &d->type[d->types > 0 ? d->types - 1 : 0];
    if (strcmp(d->entity, "LTYPE") == 0) {
        if (f->code == 2)
            memcpy(type->name, f->text, NAME);
        if (f->code == 49)
            *(f->value > 0.0 ? &type->down_mm : &type->up_mm) = fabs(f->value);
    } else if (strcmp(d->entity, "LAYER") == 0) {
        if (f->code == 2)
            r->line = strcmp(f->text, "0") == 0 ? -1 : class_at(f->text, '\0');
        if (r->line < 0) /* layer 0 */
            return;
        if (f->code == 2)
            begin_class(r, r->line);
        if (f->code == 62)
            r->p->pen[r->line].color = (uint32_t)f->value;
        if (f->code == 6)
            layer_has_type(r, d, f->text);
    }
}

/* The entity before a record of code 0 is complete. */
static void end_entity(reader *r, dxf *d)
{
    if (strcmp(d->entity, "LINE") == 0) {
        lift_to(r, d->x[0], d->y[0]);
        draw_to(r, d->x[1], d->y[1]);
    } else if (strcmp(d->entity, "POLYLINE") == 0) {
        d->in_polyline = d->is_first = true;
    } else if (strcmp(d->entity, "VERTEX") == 0) {
        r->failed = r->failed || !d->in_polyline;
        d->is_first ? lift_to(r, d->x[0], d->y[0]) : draw_to(r, d->x[0], d->y[0]);
        d->is_first = false;
    } else if (strcmp(d->entity, "SEQEND") == 0) {
        r->failed = r->failed || !d->in_polyline;
        if (d->is_closed)
            draw_home(r);
        d->in_polyline = false;
    }
    d->entity[0] = '\0';
}

static void read_dxf_entity(reader *r, dxf *d, const record *f)
{
    if (f->code == 8)
        r->line = class_at(f->text, '\0');
    if (f->code == 10 || f->code == 11)
        d->x[f->code - 10] = f->value;
    if (f->code == 20 || f->code == 21)
        d->y[f->code - 20] = f->value;
    if (f->code == 70 && strcmp(d->entity, "POLYLINE") == 0)
        d->is_closed = (int)f->value & 1;
}

static void read_dxf(reader *r, const char *text)
{
    dxf d = {.types = 0};
    record f;
    bool named = false, ended = false;
    for (const char *at = text; next_record(r, &at, &f);) {
        r->failed = r->failed || ended;
        if (f.code == 0) {
            end_entity(r, &d);
            named = is_record(&f, 0, "SECTION") || is_record(&f, 0, "TABLE");
            ended = is_record(&f, 0, "EOF");
            memcpy(d.entity, f.text, NAME);
            if (is_record(&f, 0, "LTYPE"))
                r->failed = r->failed || d.types++ == LINE_TYPES;
        } else if (named && f.code == 2) {
            memcpy(strcmp(d.entity, "SECTION") == 0 ? d.section : d.table, f.text, NAME);
            named = false;
        } else if (strcmp(d.section, "TABLES") == 0) {
            read_dxf_table(r, &d, &f);
        } else if (strcmp(d.section, "ENTITIES") == 0) {
            read_dxf_entity(r, &d, &f);
        }
    }
    r->failed = r->failed || !ended;
}

/* ---- HP-GL/2 --------------------------------------------------------------------------------------------------- */

static const double hpgl_unit_mm = 0.025;

static const int hpgl_class[] = {
    -1,          ROBERTS_BACK, ROBERTS_WIRE, ROBERTS_INTERSECTION, ROBERTS_CREASE, ROBERTS_BORDER, ROBERTS_OUTLINE,
    PAPER_FRAME, PAPER_SYMBOL, PAPER_HATCH};

/* x,y,x,y,... up to a semicolon. */
static void read_hpgl_points(reader *r, const char **at)
{
    do {
        double x = number(r, at);
        expect(r, at, ",");
        double y = number(r, at);
        r->failed = r->failed || x != floor(x) || y != floor(y);
        draw_to(r, x * hpgl_unit_mm, y * hpgl_unit_mm);
        if (passed(at, ";"))
            return;
        expect(r, at, ",");
        passed(at, "\n");
    } while (!r->failed);
}

/* The numbers of an instruction. */
static void read_numbers(reader *r, const char **at, double *value, int count)
{
    for (int i = 0; i < count; i++) {
        value[i] = number(r, at);
        expect(r, at, i + 1 < count ? "," : ";");
    }
}

static void read_hpgl(reader *r, const char *text)
{
    const char *at = text;
    double n[4], share = 0.0;
    plot_pen *pen = r->p->pen;
    uint32_t chosen = 0;
    expect(r, &at, "IN;NP16;");
    while (!r->failed && *at) {
        if (passed(&at, "\n") || passed(&at, "LT;") || passed(&at, "PU;")) {
            continue;
        } else if (passed(&at, "SP0;")) {
            chosen = 0;
        } else if (passed(&at, "SP")) {
            chosen = whole(r, &at);
            expect(r, &at, ";");
            pen = begin_class(r, chosen < sizeof hpgl_class / sizeof hpgl_class[0] ? hpgl_class[chosen] : -1);
        } else if (passed(&at, "PW")) {
            read_numbers(r, &at, n, 2);
            r->failed = r->failed || n[1] != chosen;
            pen->width_mm = n[0];
        } else if (passed(&at, "PC")) {
            read_numbers(r, &at, n, 4);
            r->failed = r->failed || n[0] != chosen;
            pen->color = (uint32_t)n[1] << 16 | (uint32_t)n[2] << 8 | (uint32_t)n[3];
        } else if (passed(&at, "UL8,")) {
            read_numbers(r, &at, n, 2);
            share = n[0] / 100.0;
            r->failed = r->failed || fabs(n[0] + n[1] - 100.0) > 1e-9;
        } else if (passed(&at, "LT8,")) {
            read_numbers(r, &at, n, 2);
            pen->dashed = true;
            pen->down_mm = share * n[0];
            pen->up_mm = n[0] - pen->down_mm;
        } else if (passed(&at, "PU")) {
            read_numbers(r, &at, n, 2);
            lift_to(r, n[0] * hpgl_unit_mm, n[1] * hpgl_unit_mm);
            expect(r, &at, "PD");
            read_hpgl_points(r, &at);
        } else {
            r->failed = true;
        }
    }
    r->failed = r->failed || chosen != 0;
}

/* ---- all together ---------------------------------------------------------------------------------------------- */

bool plot_read(plot *p, roberts_format format, const char *text, double height_mm)
{
    reader r = {.p = p, .height_mm = height_mm, .line = -1};
    *p = (plot){0};
    switch (format) {
    case ROBERTS_SVG:
        r.failed = !paper_read_svg(&p->lines, text, strlen(text));
        read_svg_pens(&r, text);
        break;
    case ROBERTS_TIKZ:
        read_tikz(&r, text);
        break;
    case ROBERTS_DXF:
        read_dxf(&r, text);
        break;
    case ROBERTS_HPGL:
        read_hpgl(&r, text);
        break;
    default:
        r.failed = true;
    }
    return !r.failed;
}

void plot_free(plot *p)
{
    paper_free(&p->lines);
}

/* ---- comparing ------------------------------------------------------------------------------------------------- */

static roberts_vec2 rounded(roberts_vec2 p, double height_mm)
{
    double x = floor(p.x / hpgl_unit_mm + 0.5), y = floor((height_mm - p.y) / hpgl_unit_mm + 0.5);
    return (roberts_vec2){x * hpgl_unit_mm, height_mm - y * hpgl_unit_mm};
}

static bool is_at(roberts_vec2 p, roberts_vec2 q)
{
    const double rounding = 0.0005;
    return fabs(p.x - q.x) < rounding && fabs(p.y - q.y) < rounding;
}

/* The lines of an SVG as HP-GL has them: rounded, and without those that become points, if others are left of their
 * stroke. False: no memory. */
static bool round_lines(const paper *svg, double height_mm, paper *to)
{
    *to = (paper){.strokes = svg->strokes};
    to->item = alloc_array(svg->count, sizeof *to->item);
    for (size_t i = 0; i < svg->count && to->item; i++) {
        const paper_line *own = &svg->item[i];
        const paper_line line = {rounded(own->a, height_mm), rounded(own->b, height_mm), own->line, own->stroke};
        bool is_last = i + 1 == svg->count || svg->item[i + 1].stroke != own->stroke;
        bool is_alone = to->count == 0 || to->item[to->count - 1].stroke != own->stroke;
        if (!is_at(line.a, line.b) || (is_last && is_alone))
            to->item[to->count++] = line;
    }
    return to->item != NULL;
}

static bool are_lines_same(const paper *p, const paper *q, FILE *out)
{
    if (p->count != q->count || p->strokes != q->strokes) {
        if (out)
            fprintf(out, "  %zu lines in %u strokes, and %zu in %u\n", p->count, p->strokes, q->count, q->strokes);
        return false;
    }
    for (size_t i = 0; i < p->count; i++) {
        const paper_line *a = &p->item[i], *b = &q->item[i];
        if (a->line == b->line && a->stroke == b->stroke && is_at(a->a, b->a) && is_at(a->b, b->b))
            continue;
        if (out)
            fprintf(out, "  line %zu: class %d, stroke %u, %.6f,%.6f to %.6f,%.6f; %d, %u, %.6f,%.6f to %.6f,%.6f\n", i,
                    a->line, a->stroke, a->a.x, a->a.y, a->b.x, a->b.y, b->line, b->stroke, b->a.x, b->a.y, b->b.x,
                    b->b.y);
        return false;
    }
    return true;
}

/* DXF has neither widths nor colours as they are, and its dashes are as seen: with the caps that SVG adds. */
static bool is_pen_same(const plot_pen *svg, const plot_pen *p, roberts_format format)
{
    const double cap = format == ROBERTS_DXF && svg->dashed ? svg->width_mm : 0.0, rounding = 0.0015;
    bool same = svg->used == p->used && svg->dashed == p->dashed && fabs(svg->down_mm + cap - p->down_mm) < rounding &&
                fabs(svg->up_mm - cap - p->up_mm) < rounding;
    return same && (format == ROBERTS_DXF || (svg->width_mm == p->width_mm && svg->color == p->color));
}

bool plot_is_same(const plot *svg, const plot *p, roberts_format format, double height_mm, FILE *out)
{
    paper units = {0};
    if (format == ROBERTS_HPGL && !round_lines(&svg->lines, height_mm, &units))
        return false;
    bool same = are_lines_same(format == ROBERTS_HPGL ? &units : &svg->lines, &p->lines, out);
    paper_free(&units);
    for (int i = 0; i < PAPER_CLASSES; i++)
        if (!is_pen_same(&svg->pen[i], &p->pen[i], format)) {
            same = false;
            if (out)
                fprintf(out, "  another pen of %s\n", class_names[i]);
        }
    return same;
}
