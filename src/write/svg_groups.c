/* svg_groups.c - the strokes of an SVG in groups, with names for scripts and style sheets.
 *
 * Groups are nested: on sheets first the view, then body and class, or class and body. Each run of strokes knows its
 * groups; between two runs, the groups that end are closed, and those that begin are opened. */
#include "write/svg.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/error.h"
#include "draw/sheet.h"

enum { LEVELS = 3, POINTS_A_LINE = 100 /* then the text goes on in a new line */ };

typedef enum level { LEVEL_VIEW, LEVEL_CLASS, LEVEL_BODY } level;

/* The groups that are open. */
typedef struct svg_groups {
    const strokes *s;
    output *out;
    level order[LEVELS]; /* from the outermost */
    int depth;           /* how many of them there are */
    int32_t thousandths; /* of a mm, in a unit */
    uint32_t bodies;     /* numbered layers: those of frame, symbol and text come after so many */
} svg_groups;

/* ---- attributes ---- */

static void attribute_pair(output *out, const char *name, uint32_t a, uint32_t b, const char *between)
{
    output_text(out, name);
    output_integer(out, a);
    if (b != ROBERTS_NONE) {
        output_text(out, between);
        output_integer(out, b);
    }
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

void svg_body(output *out, const roberts_draw_options *options, uint32_t body)
{
    const char *name = body_name(options, body);
    output_text(out, " class=\"body\"");
    svg_attribute_integer(out, "data-body", body);
    if (*name)
        svg_attribute(out, "data-name", name);
}

void svg_view(output *out, const strokes *s, uint32_t view)
{
    output_text(out, " class=\"view\"");
    svg_attribute(out, "data-view", view_name(s, view));
}

/* ---- groups ---- */

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
    const char *name = strokes_class_name(g->line);
    if (outermost)
        svg_id(w->out, w->s->options, name);
    svg_attribute(w->out, "class", name);
    if (g->line == LINE_TEXT || g->line == LINE_HIDDEN_TEXT)
        svg_attribute(w->out, "pointer-events", "none"); /* the pointer finds what lies below */
    if (outermost) {
        const bool own = strokes_pen(w->s->options, g->line)->number != 0;
        svg_layer(w->out, w->s->options, (own ? 0 : w->bodies) + strokes_class_number(w->s->options, g->line), name);
    }
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

/* Frame, symbol and text are in layers of their class alone. */
static bool is_plain(const stroke_group *g)
{
    return g->body == ROBERTS_NONE;
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

/* ---- paths ---- */

static void write_coordinate(const svg_groups *w, const char *before, int32_t units)
{
    output_bytes(w->out, before, 1);
    output_thousandths(w->out, units * w->thousandths);
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

static void write_stroke(const svg_groups *w, const char *command, const polyline *line)
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
        attribute_pair(w->out, " data-edge=\"", segment->v0, segment->v1, "-");
    roberts_segment_faces(w->s->options->scene, drawing, segment, face);
    if (face[0] != ROBERTS_NONE)
        attribute_pair(w->out, " data-faces=\"", face[0], face[1], ",");
    if (segment->state == ROBERTS_HIDDEN && segment->by != ROBERTS_NONE)
        svg_attribute_integer(w->out, "data-by", segment->by);
}

/* Writes strokes as one path. */
static void write_path(const svg_groups *w, const stroke_group *g, size_t first, size_t end)
{
    const bool named = w->s->options->grouping == ROBERTS_GROUP_ELEMENT && !is_plain(g);
    output_text(w->out, "<path");
    if (named)
        write_names(w, g, w->s->lines.item[first].number);
    output_text(w->out, " d=\"");
    for (size_t i = first; i < end; i++) {
        if (i > first && (i - first) % POINTS_A_LINE == 0)
            output_bytes(w->out, "\n", 1);
        write_stroke(w, named ? relative : absolute, &w->s->lines.item[i]);
    }
    output_text(w->out, "\"/>\n");
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
        write_path(w, g, i, end);
    }
}

void svg_groups_write(const strokes *s, output *out)
{
    const bool by_body = s->options->grouping == ROBERTS_GROUP_BODY;
    svg_groups w = {.s = s, .out = out, .thousandths = (int32_t)(1000.0 / s->units_per_mm + 0.5)};
    int open = 0;
    if (s->sheet)
        w.order[w.depth++] = LEVEL_VIEW;
    w.order[w.depth++] = by_body ? LEVEL_BODY : LEVEL_CLASS;
    w.order[w.depth++] = by_body ? LEVEL_CLASS : LEVEL_BODY;
    w.bodies = w.order[0] == LEVEL_BODY ? count_bodies(s) : 0;
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
