/* svg.c - the page as SVG: size and user units in mm, one layer and one path per class of lines.
 *
 * It is written here and not by Cairo: the SVG of Cairo 1.16 has no layers, and numbers its groups by a counter of the
 * process.
 *
 * Strokes may be in groups, with names for scripts and style sheets. Groups are nested: on sheets first the view, then
 * body and class, or class and body. Each run of strokes knows its groups; between two runs, the groups that end are
 * closed, and those that begin are opened. */
#include "write/formats.h"

#include <stdio.h>

#include "base/error.h"
#include "base/output.h"
#include "draw/page.h"
#include "draw/sheet.h"
#include "draw/strokes.h"
#include "write/plot.h"

/* ---- colours ----------------------------------------------------------------------------------------------------- */

static void svg_color(output *out, unsigned char red, unsigned char green, unsigned char blue)
{
    static const char hex[] = "0123456789abcdef";
    const unsigned char part[] = {red, green, blue};
    output_text(out, "#");
    for (int i = 0; i < 3; i++) {
        output_bytes(out, &hex[part[i] >> 4], 1);
        output_bytes(out, &hex[part[i] & 15], 1);
    }
}

/* ---- text -------------------------------------------------------------------------------------------------------- */

/* The entity of a character, or NULL. White space and quotes are replaced only in attributes. */
static const char *entity_of(char c, bool in_attribute)
{
    switch (c) {
    case '<':
        return "&lt;";
    case '>':
        return "&gt;";
    case '&':
        return "&amp;";
    case '"':
        return in_attribute ? "&quot;" : NULL;
    case '\t':
        return in_attribute ? "&#9;" : NULL;
    case '\n':
        return in_attribute ? "&#10;" : NULL;
    default:
        return NULL;
    }
}

static void write_escaped(output *out, const char *text, bool in_attribute)
{
    while (*text) {
        size_t length = output_character(text);
        const char *entity = entity_of(*text, in_attribute);
        if (entity)
            output_text(out, entity);
        else if (length)
            output_bytes(out, text, length);
        else
            output_text(out, "?");
        text += length ? length : 1;
    }
}

/* Writes UTF-8 with <, > and & as entities. A byte that belongs to no character of XML 1.0, in its shortest form (RFC
 * 3629), becomes a question mark: a file's name may hold any bytes. */
static void svg_text(output *out, const char *text)
{
    write_escaped(out, text, false);
}

/* Writes ` name="a"`, or ` name="a,b"`, say, if b is not ROBERTS_NONE. */
static void svg_attribute_pair(output *out, const char *name, uint32_t a, uint32_t b, const char *between)
{
    output_text(out, " ");
    output_text(out, name);
    output_text(out, "=\"");
    output_integer(out, a);
    if (b != ROBERTS_NONE) {
        output_text(out, between);
        output_integer(out, b);
    }
    output_text(out, "\"");
}

static void svg_attribute_integer(output *out, const char *name, uint32_t value)
{
    svg_attribute_pair(out, name, value, ROBERTS_NONE, "");
}

/* Writes ` name="text"`, with quotes, line feeds and tabs as entities, too. */
static void svg_attribute(output *out, const char *name, const char *text)
{
    output_text(out, " ");
    output_text(out, name);
    output_text(out, "=\"");
    write_escaped(out, text, true);
    output_text(out, "\"");
}

/* Where each drawing has ids of its own, layers of classes have a class, too, for a style sheet of all drawings. */
static bool has_classes(const roberts_draw_options *options)
{
    return options->id_prefix && options->grouping == ROBERTS_GROUP_CLASS;
}

/* Writes ` id="..."` with the prefix of all ids. */
static void svg_id(output *out, const roberts_draw_options *options, const char *name)
{
    output_text(out, " id=\"");
    if (options->id_prefix)
        write_escaped(out, options->id_prefix, true);
    output_text(out, name);
    output_text(out, "\"");
    if (has_classes(options))
        svg_attribute(out, "class", name);
}

/* Writes the attributes that make a group a layer of Inkscape. number: before its name where layers are numbered. */
static void svg_layer(output *out, const roberts_draw_options *options, uint32_t number, const char *name)
{
    output_text(out, " inkscape:groupmode=\"layer\" inkscape:label=\"");
    if (options->number_layers) {
        output_integer(out, number);
        output_text(out, " ");
    }
    write_escaped(out, name, true);
    output_text(out, "\"");
}

/* Writes the pen of a class as attributes. */
static void svg_pen(output *out, const roberts_draw_options *options, roberts_line line)
{
    const roberts_pen *pen = pens_of(options, line);
    double dash[2];
    output_text(out, " fill=\"none\" stroke=\"");
    svg_color(out, pen->red, pen->green, pen->blue);
    output_text(out, "\" stroke-width=\"");
    output_mm(out, pen->width_mm);
    output_text(out, "\" stroke-linecap=\"round\" stroke-linejoin=\"round\"");
    if (!pens_dash(options, line, dash))
        return;
    output_text(out, " stroke-dasharray=\"");
    output_mm(out, dash[0]);
    output_text(out, " ");
    output_mm(out, dash[1]);
    output_text(out, "\"");
}

static const char *view_name(const strokes *s, uint32_t view)
{
    return roberts_sheet_view_name(s->sheet->angle, s->view[view].place);
}

static const char *body_name(const roberts_draw_options *options, uint32_t body)
{
    return options->scene ? roberts_scene_name(options->scene, body) : "";
}

/* Write the attributes that name a body, and a view of a sheet. */
static void svg_body(output *out, const roberts_draw_options *options, uint32_t body)
{
    const char *name = body_name(options, body);
    output_text(out, " class=\"body\"");
    svg_attribute_integer(out, "data-body", body);
    if (*name)
        svg_attribute(out, "data-name", name);
}

static void svg_view(output *out, const strokes *s, uint32_t view)
{
    output_text(out, " class=\"view\"");
    svg_attribute(out, "data-view", view_name(s, view));
}

/* Frame, symbol and text are in layers of their class alone. */
static bool is_plain(const stroke_group *g)
{
    return g->body == ROBERTS_NONE;
}

/* The bodies of the scene; if it is not known, up to the last one that is drawn. */
static uint32_t count_bodies(const strokes *s)
{
    uint32_t count = s->options->scene ? (uint32_t)roberts_scene_solid_count(s->options->scene) : 0;
    for (size_t i = 0; i < s->group_count; i++)
        if (!is_plain(&s->group[i]) && s->group[i].body >= count)
            count = s->group[i].body + 1;
    return count;
}

/* The number of a layer that is a class: that of its pen, if it has one of its own; greater than those of bodies, where
 * these are layers. */
static uint32_t layer_number(const strokes *s, roberts_line line)
{
    const bool own = pens_of(s->options, line)->number != 0;
    const bool beside_bodies = s->options->grouping == ROBERTS_GROUP_BODY && !s->sheet;
    return (beside_bodies && !own ? count_bodies(s) : 0) + pens_class_number(s->options, line);
}

/* ---- layers of classes ------------------------------------------------------------------------------------------- */

static void open_layer(output *out, const roberts_draw_options *options, roberts_line line)
{
    const char *name = pens_class_name(line);
    output_text(out, "<g");
    svg_id(out, options, name);
    svg_layer(out, options, pens_class_number(options, line), name);
    if (has_classes(options))
        svg_pen(out, options, line); /* here a style sheet can override it */
    output_text(out, ">\n<path");
    if (!has_classes(options))
        svg_pen(out, options, line);
    output_text(out, " d=\"");
}

/* Where the strokes go. */
typedef struct svg_plot {
    const strokes *s;
    output *out;
} svg_plot;

static void begin_layer(void *context, roberts_line line)
{
    const svg_plot *p = context;
    open_layer(p->out, p->s->options, line);
}

static void write_point(const svg_plot *p, const char *command, page_point at)
{
    output_bytes(p->out, command, 2);
    output_thousandths(p->out, at.x * p->s->thousandths);
    output_bytes(p->out, " ", 1);
    output_thousandths(p->out, at.y * p->s->thousandths);
    output_bytes(p->out, " ", 1);
}

static void write_stroke(void *context, const page_point *point, size_t count, bool closed)
{
    const svg_plot *p = context;
    write_point(p, "M ", point[0]);
    for (size_t i = 1; i < count; i++)
        write_point(p, "L ", point[i]);
    if (closed)
        output_bytes(p->out, "Z ", 2);
}

static void end_part(void *context, bool last)
{
    const svg_plot *p = context;
    output_text(p->out, last ? "\"/>\n</g>\n" : "\n");
}

/* ---- text of the reader ------------------------------------------------------------------------------------------ */

static const double capital = 0.716; /* height of capitals of usual fonts, as a part of their size */

/* Writes what a label names; nothing for text that is no label. */
static void write_subject(output *out, const roberts_name *of)
{
    switch (of->of) {
    case ROBERTS_LABEL_VERTICES:
        svg_attribute_integer(out, "data-vertex", of->number);
        return;
    case ROBERTS_LABEL_EDGES:
        svg_attribute_pair(out, "data-edge", of->number, of->other, "-");
        return;
    case ROBERTS_LABEL_FACES:
        svg_attribute_integer(out, "data-face", of->number);
        return;
    case ROBERTS_LABEL_BODIES:
    case ROBERTS_LABEL_NAMES:
        svg_attribute_integer(out, "data-body", of->number);
        return;
    }
}

static void write_text_line(output *out, const text_line *line, const roberts_name *of)
{
    output_text(out, "<text");
    if (of)
        write_subject(out, of);
    output_text(out, " x=\"");
    output_mm(out, line->at.x);
    output_text(out, "\" y=\"");
    output_mm(out, line->at.y);
    output_text(out, "\" font-size=\"");
    output_mm(out, line->height_mm / capital);
    if (line->align > 0.0)
        output_text(out, line->align < 1.0 ? "\" text-anchor=\"middle" : "\" text-anchor=\"end");
    const double degrees = text_degrees(line);
    if (degrees != 0.0) {
        output_text(out, "\" transform=\"rotate(");
        output_mm(out, -degrees);
        output_text(out, " ");
        output_mm(out, line->at.x);
        output_text(out, " ");
        output_mm(out, line->at.y);
        output_text(out, ")");
    }
    output_text(out, "\">");
    svg_text(out, line->text);
    output_text(out, "</text>\n");
}

/* Writes the text of a class as text, unless it is strokes: a layer of its own above that of its lines. */
static void write_text_layer(const strokes *s, roberts_line class, output *out)
{
    const roberts_pen *pen = pens_of(s->options, class);
    const char *name = class == LINE_TEXT ? "letters" : "hidden-letters";
    size_t written = 0;
    for (size_t i = 0; i < s->notes.count && strokes_text_is_native(s->options) && !pen->off; i++) {
        const text_line line = notes_line(&s->notes, i);
        if (!strokes_text_is_of(s, i, class))
            continue;
        if (written++ == 0) {
            output_text(out, "<g");
            svg_id(out, s->options, name);
            svg_layer(out, s->options, layer_number(s, class), name);
            if (strokes_are_grouped(s->options)) {
                svg_attribute(out, "class", name);
                svg_attribute(out, "pointer-events", "none"); /* the pointer finds what lies below */
            }
            output_text(out, " font-family=\"sans-serif\" fill=\"");
            svg_color(out, pen->red, pen->green, pen->blue);
            output_text(out, "\">\n");
        }
        write_text_line(out, &line, strokes_are_grouped(s->options) ? &s->notes.item[i].of : NULL);
    }
    output_text(out, written ? "</g>\n" : "");
}

/* ---- fills ------------------------------------------------------------------------------------------------------- */

/* Fills are a layer below all lines. Translucent areas have no seams, which would shine through. Instead viewers are
 * asked not to smooth their borders. Where layers are numbered, the name of this one begins with a percent sign: the
 * software of AxiDraw leaves such layers out, since a pen cannot fill. */

static void write_fill_point(const strokes *s, output *out, const char *command, page_point at)
{
    output_bytes(out, command, 1);
    output_thousandths(out, at.x * s->thousandths);
    output_bytes(out, " ", 1);
    output_thousandths(out, at.y * s->thousandths);
}

/* Writes a colour, and its opacity if it is translucent, up to the quote of the last value. */
static void write_color(output *out, const fill_color *color)
{
    svg_color(out, color->red, color->green, color->blue);
    if (color->alpha < 255) {
        output_text(out, "\" shape-rendering=\"crispEdges\" fill-opacity=\"");
        output_mm(out, color->alpha / 255.0);
    }
    output_text(out, "\"");
}

static void write_fill(const strokes *s, const fill_paint *paint, output *out)
{
    output_text(out, "<path");
    if (paint->body != ROBERTS_NONE)
        svg_attribute_integer(out, "data-body", paint->body);
    output_text(out, paint->seam ? " stroke=\"" : " fill=\"");
    write_color(out, &paint->color);
    output_text(out, " d=\"");
    for (size_t i = paint->first; i < paint->end; i++) {
        const polyline *line = &s->fills.lines.item[i];
        const page_point *p = s->fills.lines.point + line->first;
        for (uint32_t k = 0; k < line->count; k++)
            write_fill_point(s, out, k == 0 ? "M" : "L", p[k]);
        output_text(out, line->closed ? "Z\n" : "\n");
    }
    output_text(out, "\"/>\n");
}

typedef struct region_writer {
    const strokes *s;
    output *out;
    const page_view *view; /* of the previous region; NULL: there is none */
    uint32_t body;         /* of the region before */
} region_writer;

/* Closes and opens groups of views and bodies between the previous region and this one. NULL: there are no more
 * regions. */
static void change_groups(region_writer *w, const page_region *on)
{
    const bool same_view = on && w->view == on->view;
    if (same_view && w->body == on->region->solid)
        return;
    if (w->view)
        output_text(w->out, "</g>\n");
    if (w->view && !same_view && w->s->sheet)
        output_text(w->out, "</g>\n");
    if (!on)
        return;
    if (!same_view && w->s->sheet) {
        output_text(w->out, "<g");
        svg_view(w->out, w->s, (uint32_t)(on->view - w->s->view));
        output_text(w->out, ">\n");
    }
    output_text(w->out, "<g");
    svg_body(w->out, w->s->options, on->region->solid);
    output_text(w->out, ">\n");
    w->view = on->view;
    w->body = on->region->solid;
}

static bool write_region(void *context, const page_region *on)
{
    region_writer *w = context;
    const fill_color color = fills_color(w->s->options, on->region);
    if (on->ring_count == 0 || color.alpha == 0)
        return true;
    change_groups(w, on);
    output_text(w->out, "<path class=\"region\"");
    if (on->region->face != ROBERTS_NONE)
        svg_attribute_integer(w->out, "data-face", on->region->face);
    output_text(w->out, " fill=\"");
    write_color(w->out, &color);
    output_text(w->out, " d=\"");
    for (size_t r = 0; r < on->ring_count; r++) {
        for (size_t k = on->ring_start[r]; k < on->ring_start[r + 1]; k++)
            write_fill_point(w->s, w->out, k == on->ring_start[r] ? "M" : "L", page_rounded(on->point[k]));
        output_text(w->out, "Z");
    }
    output_text(w->out, "\"/>\n");
    return true;
}

static bool write_regions(const strokes *s, output *out)
{
    region_writer w = {.s = s, .out = out};
    const bool done = page_regions_walk(s, write_region, &w);
    change_groups(&w, NULL);
    return done;
}

/* Writes a layer with a path for each colour, and below them, in a group, one for the seams of each colour (where lines
 * are grouped, of each body and colour). Where lines are grouped, it has a path for each region instead of one for each
 * colour, in groups of bodies, on sheets within those of views. Nothing if nothing is filled. False: no memory. */
static bool write_fills(const strokes *s, output *out)
{
    const fills *f = &s->fills;
    const bool grouped = strokes_are_grouped(s->options);
    bool done = true;
    if (f->count == 0)
        return true;
    output_text(out, "<g");
    svg_id(out, s->options, "fill");
    if (grouped)
        output_text(out, " class=\"fill\"");
    output_text(out, " inkscape:groupmode=\"layer\" inkscape:label=\"");
    output_text(out, s->options->number_layers ? "%fill\">\n" : "fill\">\n");
    if (f->paint[0].seam) {
        output_text(out,
                    grouped ? "<g class=\"seam\" fill=\"none\" stroke-width=\"" : "<g fill=\"none\" stroke-width=\"");
        output_mm(out, f->seam_mm);
        output_text(out, "\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n");
    }
    for (size_t i = 0; i < f->plates; i++) {
        if (i > 0 && f->paint[i - 1].seam && !f->paint[i].seam)
            output_text(out, "</g>\n");
        if (f->paint[i].seam || !grouped)
            write_fill(s, &f->paint[i], out);
    }
    if (grouped)
        done = write_regions(s, out);
    if (f->plates < f->count)
        output_text(out, "<g class=\"plate\" pointer-events=\"none\">\n"); /* the pointer finds what lies below */
    for (size_t i = f->plates; i < f->count; i++)
        write_fill(s, &f->paint[i], out);
    if (f->plates < f->count)
        output_text(out, "</g>\n");
    output_text(out, "</g>\n");
    return done;
}

/* ---- strokes in groups ------------------------------------------------------------------------------------------- */

enum { LEVELS = 3, POINTS_A_LINE = 100 /* then the text goes on in a new line */ };

typedef enum level { LEVEL_VIEW, LEVEL_CLASS, LEVEL_BODY } level;

/* The groups that are open. */
typedef struct svg_groups {
    const strokes *s;
    output *out;
    level order[LEVELS]; /* from the outermost */
    int depth;           /* how many of them there are */
} svg_groups;

static void open_view(const svg_groups *w, const stroke_group *g)
{
    const char *name = view_name(w->s, g->view);
    svg_id(w->out, w->s->options, name);
    svg_layer(w->out, w->s->options, (uint32_t)w->s->view[g->view].place + 1, name);
    svg_view(w->out, w->s, g->view);
}

/* Only layers have an id: on sheets and within bodies there are several groups of a class. */
static void open_class(const svg_groups *w, const stroke_group *g, bool outermost)
{
    const char *name = pens_class_name(g->line);
    if (outermost)
        svg_id(w->out, w->s->options, name);
    svg_attribute(w->out, "class", name);
    if (g->line == LINE_TEXT || g->line == LINE_HIDDEN_TEXT)
        svg_attribute(w->out, "pointer-events", "none"); /* the pointer finds what lies below */
    if (outermost)
        svg_layer(w->out, w->s->options, layer_number(w->s, g->line), name);
    svg_pen(w->out, w->s->options, g->line);
}

static void open_body(const svg_groups *w, const stroke_group *g, bool outermost)
{
    const roberts_draw_options *options = w->s->options;
    const char *name = body_name(options, g->body);
    char unnamed[24];
    snprintf(unnamed, sizeof unnamed, "body-%u", (unsigned)g->body);
    if (outermost) {
        svg_id(w->out, options, unnamed);
        svg_layer(w->out, options, g->body + 1, *name ? name : unnamed);
    }
    svg_body(w->out, options, g->body);
}

static void open_level(const svg_groups *w, const stroke_group *g, int depth)
{
    output_text(w->out, "<g");
    switch (w->order[depth]) {
    case LEVEL_VIEW:
        open_view(w, g);
        break;
    case LEVEL_CLASS:
        open_class(w, g, depth == 0);
        break;
    case LEVEL_BODY:
        open_body(w, g, depth == 0);
        break;
    }
    output_text(w->out, ">\n");
}

static bool same_group(const stroke_group *g, const stroke_group *h, level at)
{
    return at == LEVEL_VIEW ? g->view == h->view : at == LEVEL_BODY ? g->body == h->body : g->line == h->line;
}

/* How many groups two runs share, from the outermost. */
static int shared(const svg_groups *w, const stroke_group *g, const stroke_group *h)
{
    int depth = 0;
    if (is_plain(g) || is_plain(h))
        return 0;
    while (depth < w->depth && same_group(g, h, w->order[depth]))
        depth++;
    return depth;
}

static void close_levels(const svg_groups *w, int count)
{
    for (int i = 0; i < count; i++)
        output_text(w->out, "</g>\n");
}

static void write_coordinate(const svg_groups *w, const char *before, int32_t units)
{
    output_bytes(w->out, before, 1);
    output_thousandths(w->out, units * w->s->thousandths);
}

/* Lines are relative in elements: these are short, so relative ends have fewer digits. */
static const char absolute[] = "HVL", relative[] = "hvl";

/* Level and upright lines have shorter commands, H and V. */
static void write_line(const svg_groups *w, const char *command, page_point from, page_point to)
{
    const page_point start = command == relative ? from : (page_point){0, 0};
    if (from.y == to.y) {
        write_coordinate(w, command, to.x - start.x);
    } else if (from.x == to.x) {
        write_coordinate(w, command + 1, to.y - start.y);
    } else {
        write_coordinate(w, command + 2, to.x - start.x);
        write_coordinate(w, " ", to.y - start.y);
    }
}

static void write_group_stroke(const svg_groups *w, const char *command, const polyline *line)
{
    const page_point *p = w->s->lines.point + line->first;
    write_coordinate(w, "M", p[0].x);
    write_coordinate(w, " ", p[0].y);
    for (uint32_t i = 1; i < line->count; i++) {
        if (i % POINTS_A_LINE == 0)
            output_bytes(w->out, "\n", 1);
        write_line(w, command, p[i - 1], p[i]);
    }
    if (line->closed)
        output_bytes(w->out, "Z", 1);
}

/* The names of a piece's edge, or of the face of a stroke of hatching. */
static void write_names(const svg_groups *w, const stroke_group *g, uint32_t number)
{
    const piece_source source = strokes_source(w->s, number);
    const roberts_drawing *drawing = w->s->view[g->view].drawing;
    const roberts_segment *segment = source.segment;
    uint32_t face[2];
    output_text(w->out, segment ? " class=\"edge\"" : " class=\"hatch\"");
    if (source.region && source.region->face != ROBERTS_NONE)
        svg_attribute_integer(w->out, "data-face", source.region->face);
    if (!segment)
        return;
    if (segment->v0 != ROBERTS_NONE)
        svg_attribute_pair(w->out, "data-edge", segment->v0, segment->v1, "-");
    roberts_segment_faces(w->s->options->scene, drawing, segment, face);
    if (face[0] != ROBERTS_NONE)
        svg_attribute_pair(w->out, "data-faces", face[0], face[1], ",");
    if (segment->state == ROBERTS_HIDDEN && segment->by != ROBERTS_NONE)
        svg_attribute_integer(w->out, "data-by", segment->by);
}

/* Writes strokes as one path. */
static void write_group_path(const svg_groups *w, const stroke_group *g, size_t first, size_t end)
{
    const bool named = w->s->options->grouping == ROBERTS_GROUP_ELEMENT && !is_plain(g);
    output_text(w->out, "<path");
    if (named)
        write_names(w, g, w->s->lines.item[first].number);
    output_text(w->out, " d=\"");
    for (size_t i = first; i < end; i++) {
        if (i > first && (i - first) % POINTS_A_LINE == 0)
            output_bytes(w->out, "\n", 1);
        write_group_stroke(w, named ? relative : absolute, &w->s->lines.item[i]);
    }
    output_text(w->out, "\"/>\n");
}

/* With an element for each piece, the dashes of a piece and the hatching of a region are one path; otherwise all
 * strokes are. */
static void write_paths(const svg_groups *w, const stroke_group *g)
{
    const roberts_draw_options *options = w->s->options;
    const polyline *line = w->s->lines.item;
    const bool several =
        options->grouping == ROBERTS_GROUP_BODY || options->real_dashes || is_plain(g) || g->line == LINE_HATCH;
    for (size_t i = g->first, end; i < g->end; i = end) {
        for (end = i + 1; several && end < g->end && line[end].number == line[i].number;)
            end++;
        write_group_path(w, g, i, end);
    }
}

/* Writes the strokes in their groups. */
static void svg_groups_write(const strokes *s, output *out)
{
    const bool by_body = s->options->grouping == ROBERTS_GROUP_BODY;
    svg_groups w = {.s = s, .out = out};
    int open = 0;
    if (s->sheet)
        w.order[w.depth++] = LEVEL_VIEW;
    w.order[w.depth++] = by_body ? LEVEL_BODY : LEVEL_CLASS;
    w.order[w.depth++] = by_body ? LEVEL_CLASS : LEVEL_BODY;
    for (size_t i = 0; i < s->group_count; i++) {
        const stroke_group *g = &s->group[i];
        const int kept = i > 0 ? shared(&w, g - 1, g) : 0;
        close_levels(&w, open - kept);
        if (is_plain(g)) {
            output_text(out, "<g");
            open_class(&w, g, true);
            output_text(out, ">\n");
            open = 1;
        } else {
            for (open = kept; open < w.depth; open++)
                open_level(&w, g, open);
        }
        write_paths(&w, g);
    }
    close_levels(&w, open);
}

/* ---- the page ---------------------------------------------------------------------------------------------------- */

/* Writes nothing where `text` is NULL. */
static void write_element(output *out, const char *tag, const char *text)
{
    if (!text || !*text)
        return;
    output_text(out, "<");
    output_text(out, tag);
    output_text(out, ">");
    svg_text(out, text);
    output_text(out, "</");
    output_text(out, tag);
    output_text(out, ">\n");
}

/* Outside of the layers, because a plotter must not draw it. */
static void write_background(output *out, const strokes *s)
{
    const roberts_page *page = &s->page;
    const roberts_background *color = &s->options->background;
    output_text(out, "<rect");
    svg_id(out, s->options, "background");
    output_text(out, " width=\"");
    output_mm(out, page->width_mm);
    output_text(out, "\" height=\"");
    output_mm(out, page->height_mm);
    output_text(out, "\" fill=\"");
    svg_color(out, color->red, color->green, color->blue);
    output_text(out, "\"/>\n");
}

roberts_status svg_write(const strokes *s, output *out, roberts_error *error)
{
    const roberts_page *page = &s->page;
    output_text(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\""
                     " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\" width=\"");
    output_mm(out, page->width_mm);
    output_text(out, "mm\" height=\"");
    output_mm(out, page->height_mm);
    output_text(out, "mm\" viewBox=\"0 0 ");
    output_mm(out, page->width_mm);
    output_text(out, " ");
    output_mm(out, page->height_mm);
    output_text(out, "\">\n");
    write_element(out, "title", s->options->title);
    write_element(out, "desc", s->options->description);
    if (s->options->background.on)
        write_background(out, s);
    svg_plot p = {s, out};
    const plotter to = {.begin = begin_layer, .stroke = write_stroke, .part = end_part, .context = &p};
    roberts_status status = ROBERTS_OK;
    if (!write_fills(s, out))
        status = error_no_memory(error);
    else if (strokes_are_grouped(s->options))
        svg_groups_write(s, out);
    else
        status = plot_strokes(s, &to, out, error);
    write_text_layer(s, LINE_HIDDEN_TEXT, out);
    write_text_layer(s, LINE_TEXT, out);
    output_text(out, "</svg>\n");
    return status;
}
