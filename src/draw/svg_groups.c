/* svg_groups.c - the strokes of an SVG in groups, with names for scripts and style sheets.
 *
 * Groups are nested: on sheets first the view, then body and class, or class and body. Each run of strokes knows its
 * groups; between two runs, the groups that end are closed, and those that begin are opened. */
#include "draw/svg_groups.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/error.h"
#include "draw/sheet.h"
#include "draw/svg.h"

/* ---- sorting strokes into groups --------------------------------------------------------------------------------- */

/* Pieces are sorted by view, then by body and class, or by class and body; each run of pieces with the same key is a
 * group. Within it they are chained and put in order like the pieces of a class. The pen goes from group to group. */

/* Where a piece belongs. */
typedef struct group_key {
    uint64_t key;
    uint32_t index; /* of the piece */
} group_key;

/* ---- what a number stands for ---- */

piece_source groups_source(const strokes *s, uint32_t number)
{
    uint32_t view = 0;
    if (number >= s->view[0].first_region) {
        while (view + 1 < s->views && s->view[view + 1].first_region <= number)
            view++;
        const roberts_region *region = &s->view[view].drawing->regions->region[number - s->view[view].first_region];
        return (piece_source){.view = view, .body = region->solid, .region = region};
    }
    while (view + 1 < s->views && s->view[view + 1].first <= number)
        view++;
    const roberts_segment *segment = &s->view[view].drawing->segment[number - s->view[view].first];
    return (piece_source){.view = view, .body = segment->solid, .segment = segment};
}

/* Whether two segments, one after the other, are of one edge or one intersection. */
static bool is_same_edge(const roberts_segment *a, const roberts_segment *b)
{
    return a->solid == b->solid && a->v0 == b->v0 && a->v1 == b->v1 && a->edge == b->edge;
}

uint32_t *groups_parts(const strokes *s, size_t count)
{
    const bool by_body = s->options->grouping == ROBERTS_GROUP_BODY;
    uint32_t *part = alloc_array(count, sizeof *part), next = 0;
    for (size_t v = 0; part && v < s->views; v++) {
        const roberts_drawing *d = s->view[v].drawing;
        uint32_t most = 0;
        for (size_t i = 0; i < d->count; i++) {
            const roberts_segment *own = &d->segment[i];
            if (by_body) {
                most = own->solid > most ? own->solid : most;
                part[s->view[v].first + i] = next + own->solid;
            } else {
                most += i > 0 && !is_same_edge(own - 1, own);
                part[s->view[v].first + i] = next + most;
            }
        }
        next += most + 1; /* views do not overlap, so it is harmless if this exceeds 2^32 */
    }
    for (size_t i = s->view[0].first_region; part && i < count; i++) {
        const piece_source source = groups_source(s, (uint32_t)i);
        part[i] = by_body ? source.body : (uint32_t)i; /* strokes of hatching are joined only with one another */
    }
    return part;
}

/* ---- groups ---- */

static uint32_t rank_of(roberts_line line)
{
    uint32_t below = 0;
    while (line_order[below] != line)
        below++;
    return below;
}

static uint64_t key_of(const strokes *s, const piece *p)
{
    const piece_source source = groups_source(s, p->number);
    const uint64_t view = source.view, body = source.body;
    const uint64_t rank = rank_of((roberts_line)p->line);
    return s->options->grouping == ROBERTS_GROUP_BODY ? view << 40 | body << 8 | rank : view << 40 | rank << 32 | body;
}

static int by_key(const void *a, const void *b)
{
    const group_key *p = a, *q = b;
    if (p->key != q->key)
        return p->key < q->key ? -1 : 1;
    return p->index < q->index ? -1 : p->index > q->index;
}

/* Sorts the pieces by their keys. Returns the keys, which the caller frees; NULL: no memory. */
static group_key *sort_pieces(const strokes *s, pieces *p)
{
    group_key *key = alloc_array(p->count, sizeof *key);
    piece *sorted = alloc_array(p->count, sizeof *sorted);
    if (!key || !sorted) {
        free(key);
        free(sorted);
        return NULL;
    }
    for (size_t i = 0; i < p->count; i++)
        key[i] = (group_key){key_of(s, &p->item[i]), (uint32_t)i};
    if (p->count > 1)
        qsort(key, p->count, sizeof *key, by_key);
    for (size_t i = 0; i < p->count; i++)
        sorted[i] = p->item[key[i].index];
    free(p->item);
    p->item = sorted;
    return key;
}

/* Whether piece i is in the group of the piece before it. With an element for each piece, the hatching of each region
 * is a group too. */
static bool is_same_group(const strokes *s, const group_key *key, const pieces *p, size_t i)
{
    return key[i].key == key[i - 1].key &&
           (s->options->grouping == ROBERTS_GROUP_BODY || p->item[i].line != LINE_HATCH ||
            p->item[i].number == p->item[i - 1].number);
}

/* Makes one group of `p`, which holds its pieces alone. */
static roberts_status make_group(strokes *s, const pieces *p, stroke_group group, page_point *pen, roberts_error *error)
{
    polylines own = {0}; /* cutting dashes copies all lines before them */
    roberts_status status = strokes_chain(s, p, group.line, &own, pen, error);
    group.first = s->lines.count;
    if (status == ROBERTS_OK && !polylines_copy(&own, &s->lines))
        status = error_no_memory(error);
    group.end = s->lines.count;
    if (status == ROBERTS_OK && group.end > group.first)
        s->group[s->group_count++] = group;
    polylines_free(&own);
    return status;
}

roberts_status groups_make(strokes *s, pieces *p, roberts_error *error)
{
    const uint32_t none = (uint32_t)s->views;
    page_point pen = {0, 0}; /* the upper left corner */
    static const roberts_line plain[] = {LINE_FRAME, LINE_SYMBOL, LINE_TEXT, LINE_HIDDEN_TEXT}; /* of no body */
    size_t groups = sizeof plain / sizeof plain[0];
    roberts_status status = ROBERTS_OK;
    group_key *key = sort_pieces(s, p);
    for (size_t i = 0; key && i < p->count; i++)
        groups += i == 0 || !is_same_group(s, key, p, i);
    s->group = alloc_array(groups, sizeof *s->group);
    if (!key || !s->group)
        status = error_no_memory(error);
    for (size_t i = 0, end; status == ROBERTS_OK && i < p->count; i = end) {
        const piece *first = &p->item[i];
        for (end = i + 1; end < p->count && is_same_group(s, key, p, end);)
            end++;
        const piece_source source = groups_source(s, first->number);
        const stroke_group group = {.view = source.view, .body = source.body, .line = (roberts_line)first->line};
        status = make_group(s, &(pieces){.item = p->item + i, .count = end - i}, group, &pen, error);
    }
    for (size_t i = 0; status == ROBERTS_OK && i < sizeof plain / sizeof plain[0]; i++) {
        const stroke_group group = {.view = none, .body = ROBERTS_NONE, .line = plain[i]};
        if (plain[i] == LINE_TEXT)
            status = strokes_label(s, error);
        if (status == ROBERTS_OK)
            status = make_group(s, &(pieces){0}, group, &pen, error);
    }
    free(key);
    return status;
}

/* ---- writing the groups ------------------------------------------------------------------------------------------ */

enum { LEVELS = 3, POINTS_A_LINE = 100 /* then the text goes on in a new line */ };

typedef enum level { LEVEL_VIEW, LEVEL_CLASS, LEVEL_BODY } level;

/* The groups that are open. */
typedef struct svg_groups {
    const strokes *s;
    output *out;
    level order[LEVELS]; /* from the outermost */
    int depth;           /* how many of them there are */
    int32_t thousandths; /* of a mm, in a unit */
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

static void attribute_integer(output *out, const char *name, uint32_t a)
{
    attribute_pair(out, name, a, ROBERTS_NONE, "");
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
    attribute_integer(out, " data-body=\"", body);
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
    if (outermost)
        svg_layer(w->out, w->s->options, strokes_class_number(g->line), name);
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

static bool is_same(const stroke_group *g, const stroke_group *h, level at)
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
    while (depth < w->depth && is_same(g, h, w->order[depth]))
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
    const piece_source source = groups_source(w->s, number);
    const roberts_drawing *drawing = w->s->view[g->view].drawing;
    const roberts_segment *segment = source.segment;
    uint32_t face[2];
    output_text(w->out, segment ? " class=\"edge\"" : " class=\"hatch\"");
    if (source.region && source.region->face != ROBERTS_NONE)
        attribute_integer(w->out, " data-face=\"", source.region->face);
    if (!segment)
        return;
    if (segment->v0 != ROBERTS_NONE)
        attribute_pair(w->out, " data-edge=\"", segment->v0, segment->v1, "-");
    roberts_segment_faces(w->s->options->scene, drawing, segment, face);
    if (face[0] != ROBERTS_NONE)
        attribute_pair(w->out, " data-faces=\"", face[0], face[1], ",");
    if (segment->state == ROBERTS_HIDDEN && segment->by != ROBERTS_NONE)
        attribute_integer(w->out, " data-by=\"", segment->by);
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
