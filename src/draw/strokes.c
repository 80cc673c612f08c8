/* strokes.c - from segments to strokes: segments are chosen, placed on the page, freed of doubles, chained, ordered.
 *
 * For SVG, strokes may be in groups: by body, or by class and body, with each piece of an edge by itself. Pieces are
 * sorted by view, then by body and class, or by class and body; each run of pieces with the same key is a group. Within
 * it they are chained and put in order like the pieces of a class. The pen goes from group to group. */
#include "draw/strokes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/box.h"
#include "base/error.h"
#include "base/vec.h"
#include "draw/dashes.h"
#include "draw/dimensions.h"
#include "draw/hatch.h"
#include "draw/label_places.h"
#include "draw/label_targets.h"
#include "draw/labels.h"
#include "draw/overlap.h"
#include "draw/sheet.h"
#include "draw/title_block.h"
#include "draw/travel.h"

/* Cairo keeps coordinates in 32 bits, 8 of them after the binary point, and larger ones wrap silently. A page has less
 * than half of 2^23 units, so wide pens on its border are safe too. */
static const double finest_longest_mm = 4000.0, fine_units_per_mm = 1000.0, coarse_units_per_mm = 100.0;

/* mm: more than a distance reaches from its view: its dimension lines are up to 101 mm from what they measure. */
static const double farthest_distance = 130.0;
enum { REACH_ROUNDS = 4 };
/* Views are not made smaller than this part of their size for distances, which is a step of the standard scales, and
 * not even by such a step for labels. */
static const double least_for_distances = 0.4, least_for_labels = 0.5;

static const double from_frame_mm = 5.0; /* clearance inside a frame, so that no outline lies on it */

bool strokes_is_in_frame(const strokes *s, const page_view *view, roberts_vec2 mm)
{
    return !view->drawing->framed || (mm.x >= s->frame_mm[0].x && mm.x <= s->frame_mm[1].x &&
                                      mm.y >= s->frame_mm[0].y && mm.y <= s->frame_mm[1].y);
}

bool strokes_has_place(const roberts_draw_options *options, const roberts_segment *segment, roberts_line *line)
{
    if (segment->state == ROBERTS_CLIPPED)
        return false;
    if (segment->state == ROBERTS_HIDDEN)
        *line = ROBERTS_BACK;
    else
        *line = segment->line == ROBERTS_BACK || segment->line == ROBERTS_BACK_OUTLINE ? ROBERTS_OUTLINE
                                                                                       : (roberts_line)segment->line;
    return pens_has_place(options, *line);
}

static void enlarge_box(roberts_vec2 *min, roberts_vec2 *max, roberts_vec2 p)
{
    *min = (roberts_vec2){lesser(min->x, p.x), lesser(min->y, p.y)};
    *max = (roberts_vec2){greater(max->x, p.x), greater(max->y, p.y)};
}

/* Finds the part of p..q in the view's field of view, from t[0] to t[1]. False: there is none. After Y.-D. Liang, B.
 * A. Barsky, "A new concept and method for line clipping", ACM Transactions on Graphics 3(1), 1984. */
static bool frame_cut(const page_view *view, roberts_vec2 p, roberts_vec2 q, double t[2])
{
    const roberts_vec2 low = view->low, high = view->high;
    t[0] = 0.0;
    t[1] = 1.0;
    return !view->drawing->framed ||
           (box_clip(p.x, q.x, low.x, high.x, &t[0], &t[1]) && box_clip(p.y, q.y, low.y, high.y, &t[0], &t[1]));
}

static bool draws_hatching(const roberts_draw_options *options)
{
    return options->hatching.on && !options->hatch.off;
}

/* How many segments there are, with those along which the near plane cuts bodies. */
static size_t count_segments(const roberts_drawing *drawing)
{
    return drawing->count + drawing->cut_count;
}

/* The box of all lines that have a place and of all regions that may be filled or hatched, or the drawing's window.
 * Regions reach farther than lines where `unite` leaves out edges of faces that are far from planar. */
static void find_box(const roberts_drawing *drawing, const roberts_draw_options *options, roberts_vec2 *min,
                     roberts_vec2 *max)
{
    roberts_line line;
    *min = (roberts_vec2){INFINITY, INFINITY};
    *max = (roberts_vec2){-INFINITY, -INFINITY};
    if (drawing->framed || drawing->windowed) {
        *min = drawing->window_min;
        *max = drawing->window_max;
        return;
    }
    for (size_t i = 0; i < count_segments(drawing); i++) {
        const roberts_segment *segment = &drawing->segment[i];
        if (strokes_has_place(options, segment, &line)) {
            enlarge_box(min, max, segment->p0);
            enlarge_box(min, max, segment->p1);
        }
    }
    if (drawing->regions && (options->fill != ROBERTS_FILL_NONE || options->hatching.on))
        for (size_t i = 0; i < drawing->regions->corner_count; i++)
            enlarge_box(min, max, drawing->regions->corner[i]);
    if (min->x > max->x)
        *min = *max = (roberts_vec2){0.0, 0.0}; /* nothing is drawn */
}

static roberts_vec2 point_between(roberts_vec2 p, roberts_vec2 q, double t)
{
    if (t == 0.0 || t == 1.0)
        return t == 0.0 ? p : q;
    return (roberts_vec2){p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
}

static roberts_vec2 place_on_page(const strokes *s, const page_map *map, roberts_vec2 p)
{
    roberts_vec2 mm = page_place(map, p);
    return (roberts_vec2){mm.x * s->units_per_mm, mm.y * s->units_per_mm};
}

/* Appends the pieces that have a place, numbered from `number` on. Leaves out those without length once rounded. `p`
 * has room for all segments. */
static void collect(const strokes *s, const page_view *view, size_t number, pieces *p)
{
    for (size_t i = 0; i < count_segments(view->drawing); i++) {
        const roberts_segment *segment = &view->drawing->segment[i];
        roberts_line line;
        double t[2];
        if (!strokes_has_place(s->options, segment, &line) || !frame_cut(view, segment->p0, segment->p1, t))
            continue;
        double z = segment->z1 - segment->z0;
        piece own = {.a = place_on_page(s, &view->map, point_between(segment->p0, segment->p1, t[0])),
                     .b = place_on_page(s, &view->map, point_between(segment->p0, segment->p1, t[1])),
                     .za = segment->z0 + t[0] * z,
                     .zb = segment->z0 + t[1] * z,
                     .number = (uint32_t)(number + i),
                     .line = (uint8_t)line};
        if (!page_is_same(page_rounded(own.a), page_rounded(own.b)))
            p->item[p->count++] = own;
    }
}

static bool add_frame(const strokes *s, polylines *out)
{
    const double x0 = s->frame_mm[0].x * s->units_per_mm, x1 = s->frame_mm[1].x * s->units_per_mm;
    const double y0 = s->frame_mm[0].y * s->units_per_mm, y1 = s->frame_mm[1].y * s->units_per_mm;
    const roberts_vec2 corner[5] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}, {x0, y0}};
    piece side[4];
    for (int i = 0; i < 4; i++)
        side[i] = (piece){.a = corner[i], .b = corner[i + 1], .line = LINE_FRAME};
    return chain_in_order(&(pieces){.item = side, .count = 4}, LINE_FRAME, out);
}

static bool add_symbol(const strokes *s, polylines *out)
{
    return s->symbol_size == 0.0 || symbol_draw(s->sheet->angle, s->symbol_mm, s->symbol_size, s->units_per_mm, out);
}

bool strokes_take(strokes *s, const space_box *box)
{
    if (!array_reserve(&s->taken, &s->taken_room, s->taken_count + 1, sizeof *s->taken))
        return false;
    s->taken[s->taken_count++] = *box;
    return true;
}

double strokes_text_height(const roberts_draw_options *options)
{
    return options->lettering.height_mm > 0.0 ? options->lettering.height_mm : 3.5;
}

bool strokes_text_is_native(const roberts_draw_options *options)
{
    return options->lettering.native && roberts_format_has_text(options->format);
}

double strokes_text_width(const roberts_draw_options *options, const char *text, double height_mm)
{
    return options->lettering.native && options->format == ROBERTS_TIKZ ? letters_tex_width(text, height_mm)
                                                                        : letters_width(text, height_mm);
}

static bool add_text(const strokes *s, roberts_line line, polylines *out)
{
    return notes_draw(&s->notes, line == LINE_HIDDEN_TEXT, strokes_text_is_native(s->options), s->units_per_mm, out);
}

/* The room for text beside what is drawn. NULL: no memory. */
static free_space *text_room(const strokes *s, const pieces *p)
{
    polylines standing = {0};
    free_space *room = NULL;
    if ((s->options->frame.off || add_frame(s, &standing)) && (s->options->symbol.off || add_symbol(s, &standing)))
        room = labels_room(s, p, &standing);
    polylines_free(&standing);
    return room;
}

/* Finds the places of distances and labels, beside the pieces, the frame and the symbol. One room serves both, so that
 * neither lies on the other. */
static roberts_status place_text(strokes *s, const pieces *p, roberts_error *error)
{
    distances_outcome outcome;
    roberts_status status = ROBERTS_OK;
    if (!distances_wanted(s) && !labels_wanted(s))
        return ROBERTS_OK;
    free_space *room = text_room(s, p);
    if (!room)
        status = error_no_memory(error);
    if (status == ROBERTS_OK && distances_wanted(s))
        status = distances_add(s, room, &outcome, error);
    if (status == ROBERTS_OK && labels_wanted(s) && !labels_add(s, room))
        status = error_no_memory(error);
    space_free(room);
    return status;
}

/* Drops the strokes of hatching, from `first` on, that are too short; warns if none is left. */
static void drop_short(const strokes *s, polylines *out, size_t first)
{
    const double least = s->options->hatching.shortest_mm * s->units_per_mm;
    const roberts_warnings *to = &s->options->lettering.warnings;
    size_t kept = first;
    for (size_t i = first; i < out->count; i++) {
        const page_point *p = out->point + out->item[i].first;
        double length = 0.0;
        for (uint32_t k = 1; k < out->item[i].count; k++)
            length += page_distance(p[k - 1], p[k]);
        if (length >= least)
            out->item[kept++] = out->item[i];
    }
    if (kept == first && out->count > first && to->warn) {
        char text[80];
        snprintf(text, sizeof text, "all strokes of hatching are shorter than %g mm, and left out",
                 s->options->hatching.shortest_mm);
        to->warn(to->context, "", 0, text);
    }
    out->count = kept;
}

/* Appends the polylines of the pieces of one class, in order and with their dashes. The pen comes from `*pen`, which
 * becomes the end of the last polyline. Returns ROBERTS_OK, _NO_MEMORY or _BAD_ARGUMENT (too many dashes). */
static roberts_status chain_class(const strokes *s, const pieces *p, roberts_line line, polylines *out, page_point *pen,
                                  roberts_error *error)
{
    const bool apart = strokes_are_grouped(s->options) && s->options->grouping == ROBERTS_GROUP_ELEMENT;
    const bool ordered = s->options->order == ROBERTS_ORDER_TRAVEL;
    const size_t first = out->count;
    bool done, in_place = line == LINE_FRAME || line == LINE_SYMBOL;
    if (pens_of(s->options, line)->off)
        return ROBERTS_OK;
    if (line == LINE_FRAME)
        done = add_frame(s, out);
    else if (line == LINE_SYMBOL)
        done = add_symbol(s, out);
    else if (line == LINE_TEXT || line == LINE_HIDDEN_TEXT)
        done = add_text(s, line, out);
    else if (apart)
        done = chain_apart(p, line, out);
    else if (!ordered)
        done = chain_in_order(p, line, out);
    else
        done = chain_pieces(p, line, out);
    if (done && line == LINE_HATCH)
        drop_short(s, out, first);
    if (!done || (ordered && !in_place && !travel_order(out, first, pen)))
        return error_no_memory(error);
    if (!s->options->real_dashes || !pens_is_broken(s->options, line))
        return ROBERTS_OK;
    const roberts_pen *with = pens_of(s->options, line);
    const dash_pattern pattern = {with->dash_mm * s->units_per_mm, with->gap_mm * s->units_per_mm,
                                  with->width_mm * s->units_per_mm};
    return dashes_cut(out, first, &pattern, error);
}

/* Makes the polylines of all classes. */
static roberts_status make_classes(strokes *s, const pieces *p, roberts_error *error)
{
    page_point pen = {0, 0}; /* the upper left corner */
    roberts_status status = ROBERTS_OK;
    for (int i = 0; i < LINE_CLASSES && status == ROBERTS_OK; i++) {
        s->start[i] = s->lines.count;
        status = chain_class(s, p, line_order[i], &s->lines, &pen, error);
        s->start[i + 1] = s->lines.count;
    }
    return status;
}

/* ---- groups ------------------------------------------------------------------------------------------------------ */

piece_source strokes_source(const strokes *s, uint32_t number)
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

/* Returns, for each of `count` numbers of pieces, the part that it belongs to: a body in one view, or a region, or
 * what one body hides of an edge, or leaves visible. The views of `s` are set. The caller frees the result; NULL: no
 * memory. */
static uint32_t *groups_parts(const strokes *s, size_t count)
{
    const bool by_body = s->options->grouping == ROBERTS_GROUP_BODY;
    uint32_t *part = alloc_array(count, sizeof *part), next = 0;
    for (size_t v = 0; part && v < s->views; v++) {
        const roberts_drawing *d = s->view[v].drawing;
        uint32_t most = 0;
        for (size_t i = 0; i < count_segments(d); i++) {
            const roberts_segment *own = &d->segment[i];
            if (by_body) {
                most = own->solid > most ? own->solid : most;
                part[s->view[v].first + i] = next + own->solid;
            } else {
                most += i > 0 && !(is_same_edge(own - 1, own) && own[-1].by == own->by);
                part[s->view[v].first + i] = next + most;
            }
        }
        next += most + 1; /* views do not overlap, so it is harmless if this exceeds 2^32 */
    }
    for (size_t i = s->view[0].first_region; part && i < count; i++) {
        const piece_source source = strokes_source(s, (uint32_t)i);
        part[i] = by_body ? source.body : (uint32_t)i; /* strokes of hatching are joined only with one another */
    }
    return part;
}

/* Where a piece belongs. */
typedef struct group_key {
    uint64_t key;
    uint32_t index; /* of the piece */
} group_key;

static uint32_t rank_of(roberts_line line)
{
    uint32_t below = 0;
    while (line_order[below] != line)
        below++;
    return below;
}

static uint64_t key_of_piece(const strokes *s, const piece *p)
{
    const piece_source source = strokes_source(s, p->number);
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
        key[i] = (group_key){key_of_piece(s, &p->item[i]), (uint32_t)i};
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
    roberts_status status = chain_class(s, p, group.line, &own, pen, error);
    group.first = s->lines.count;
    if (status == ROBERTS_OK && !polylines_copy(&own, 0, own.count, &s->lines))
        status = error_no_memory(error);
    group.end = s->lines.count;
    if (status == ROBERTS_OK && group.end > group.first)
        s->group[s->group_count++] = group;
    polylines_free(&own);
    return status;
}

/* Makes the polylines of all groups, and the groups: by view, then by body and class, or by class and body. Frame,
 * symbol and text come last. Changes the order of the pieces. Returns ROBERTS_OK, _NO_MEMORY or _BAD_ARGUMENT. */
static roberts_status groups_make(strokes *s, pieces *p, roberts_error *error)
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
        const piece_source source = strokes_source(s, first->number);
        const stroke_group group = {.view = source.view, .body = source.body, .line = (roberts_line)first->line};
        status = make_group(s, &(pieces){.item = p->item + i, .count = end - i}, group, &pen, error);
    }
    for (size_t i = 0; status == ROBERTS_OK && i < sizeof plain / sizeof plain[0]; i++) {
        const stroke_group group = {.view = none, .body = ROBERTS_NONE, .line = plain[i]};
        status = make_group(s, &(pieces){0}, group, &pen, error);
    }
    free(key);
    return status;
}

/* ---- a page ------------------------------------------------------------------------------------------------------ */

/* Would something that the options ask for be missing because a view has no regions? */
static bool lacks_regions(const strokes *s)
{
    const roberts_draw_options *options = s->options;
    const bool filled =
        options->fill != ROBERTS_FILL_NONE && options->format != ROBERTS_DXF && options->format != ROBERTS_HPGL;
    const unsigned labels = targets_kinds(&options->lettering) & ROBERTS_LABEL_AREAS;
    bool lacks = false;
    for (size_t i = 0; i < s->views; i++)
        lacks |= !s->view[i].drawing->regions;
    return lacks && (filled || labels || draws_hatching(options));
}

/* Makes the strokes of all views together. `s` is complete but for its lines. */
static roberts_status draw(strokes *s, roberts_error *error)
{
    const page_view *view = s->view;
    size_t room = 0, number = 0;
    double epsilon = 0.0;
    pieces p = {0};
    uint32_t *part = NULL;
    roberts_status status = ROBERTS_OK;
    if (lacks_regions(s))
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0,
                         "fills, hatching, and labels of faces and bodies need the regions of each drawing, as "
                         "roberts_hide_with_regions() gives them");
    for (size_t i = 0; i < s->views; i++) {
        room += count_segments(view[i].drawing);
        epsilon = fmax(epsilon, view[i].drawing->epsilon);
    }
    p.item = room <= INT32_MAX ? alloc_array(room, sizeof *p.item) : NULL;
    if (!p.item)
        return error_no_memory(error);
    for (size_t i = 0; i < s->views; number += count_segments(view[i++].drawing)) {
        s->view[i].first = (uint32_t)number;
        collect(s, &view[i], number, &p);
    }
    for (size_t i = 0; i < s->views; i++) {
        s->view[i].first_region = (uint32_t)number;
        number += draws_hatching(s->options) ? view[i].drawing->regions->count : 0;
    }
    if (number > INT32_MAX)
        status = error_no_memory(error);
    if (status == ROBERTS_OK && draws_hatching(s->options))
        status = hatch_add(s, &p, &room, error);
    if (status == ROBERTS_OK && strokes_are_grouped(s->options) && !(p.part = part = groups_parts(s, number)))
        status = error_no_memory(error);
    if (status == ROBERTS_OK && !overlap_remove(&p, epsilon))
        status = error_no_memory(error);
    if (status == ROBERTS_OK)
        status = place_text(s, &p, error);
    if (status == ROBERTS_OK && !hatch_spare_text(s, &p))
        status = error_no_memory(error);
    if (status == ROBERTS_OK)
        status = part ? groups_make(s, &p, error) : make_classes(s, &p, error);
    free(p.item);
    free(part);
    if (status == ROBERTS_OK && !fills_make(s, &s->fills))
        status = error_no_memory(error);
    return status;
}

/* No strokes yet; the frame lies on the margins. */
static strokes nothing_drawn(const roberts_draw_options *options)
{
    const roberts_page *page = &options->page;
    bool is_fine = fmax(page->width_mm, page->height_mm) <= finest_longest_mm;
    const double units_per_mm = is_fine ? fine_units_per_mm : coarse_units_per_mm;
    return (strokes){.options = options,
                     .page = *page,
                     .units_per_mm = units_per_mm,
                     .thousandths = (int32_t)(1000.0 / units_per_mm + 0.5),
                     .label_mm = targets_kinds(&options->lettering) ? strokes_text_height(options) : 0.0,
                     .frame_mm = {{page->margin_mm, page->margin_mm},
                                  {page->width_mm - page->margin_mm, page->height_mm - page->margin_mm}}};
}

/* The page with margins that keep the drawing away from a frame and its centring marks, by 5 mm; on small pages by a
 * tenth of the shorter side within the margins. A drawing with a field of view ends at its frame. One of a series with
 * a common window has the same place whatever its labels are, and margins leave room for these. */
static roberts_page page_within_frame(const roberts_drawing *drawing, const roberts_draw_options *options)
{
    roberts_page page = options->page;
    double room_mm = fmin(page.width_mm, page.height_mm) - 2.0 * page.margin_mm;
    if (!options->frame.off && !drawing->framed)
        page.margin_mm += fmin(from_frame_mm + (options->lettering.zones ? CENTRE_MARK : 0.0), room_mm / 10.0);
    if (drawing->windowed && !drawing->framed && options->placement.scale == 0.0)
        page.margin_mm += fmin(labels_reach(options), room_mm / 10.0);
    return page;
}

static bool has_line(const roberts_drawing *drawing, roberts_line line)
{
    for (size_t i = 0; drawing && i < drawing->count; i++)
        if (drawing->segment[i].line == line)
            return true;
    return false;
}

/* The width of the widest pen that the views may need. Only the segments show whether there are borders, wires and
 * intersections. */
static double widest_pen(const roberts_drawing *const *view, int views, const roberts_draw_options *options)
{
    double widest = 0.0;
    for (int i = ROBERTS_OUTLINE; i <= ROBERTS_INTERSECTION; i++) {
        const roberts_line line = (roberts_line)i;
        const double width = pens_of(options, line)->width_mm;
        bool needed = pens_has_place(options, line) && width > widest;
        if (needed && i > ROBERTS_BACK) {
            needed = false;
            for (int k = 0; k < views && !needed; k++)
                needed = has_line(view[k], line);
        }
        if (needed)
            widest = width;
    }
    return pens_has_place(options, LINE_HATCH) ? fmax(widest, options->hatch.width_mm) : widest;
}

/* A line on the border of the margins has half of its width beyond it. So that small margins cut no line off, a fitted
 * drawing keeps half of the `widest` pen from the page's edge, but on small pages at most a tenth of their shorter
 * side. A drawing at a given scale may fill the page, and one within a frame is far from its edge. */
static roberts_page page_within_edge(roberts_page page, double widest, const roberts_draw_options *options)
{
    if (options->frame.off && options->placement.scale == 0.0)
        page.margin_mm = fmax(page.margin_mm, fmin(widest / 2.0, fmin(page.width_mm, page.height_mm) / 10.0));
    return page;
}

/* Warns that the drawing is tiny at the given scale: the model probably has another unit than was meant. Or it is tiny
 * though it is fitted: margins and gaps leave no room on the page. */
static void warn_tiny(const strokes *s)
{
    const double least_mm = 10.0;
    const bool fitted = s->options->placement.scale == 0.0;
    const roberts_warnings *to = &s->options->lettering.warnings;
    double most = 0.0;
    char text[160];
    for (size_t i = 0; i < s->views; i++) {
        const roberts_drawing *d = s->view[i].drawing;
        most = fmax(most, fmax(d->window_max.x - d->window_min.x, d->window_max.y - d->window_min.y));
    }
    most *= page_scale(&s->map);
    if (most >= least_mm || most == 0.0 || !to->warn)
        return;
    snprintf(text, sizeof text, "%s the drawing is less than %.0f mm large: is --%s?",
             fitted ? "on this page" : "at this scale", most < 1.0 ? 1.0 : least_mm,
             fitted                                ? "page right"
             : s->options->placement.unit_mm > 0.0 ? "unit right"
                                                   : "unit missing");
    to->warn(to->context, "", 0, text);
}

/* Finds the box of the labels, where they lie if the page is not cut; mm. It is empty if there are none. False: no
 * memory. */
static bool find_label_box(const strokes *s, space_box *box)
{
    roberts_draw_options quiet = *s->options;
    strokes trial = *s;
    pieces p = {.item = alloc_array(count_segments(s->drawing), sizeof *p.item)};
    quiet.lettering.warnings = (roberts_warnings){0};
    trial.options = &quiet;
    if (p.item)
        collect(&trial, &trial.view[0], 0, &p);
    free_space *room = p.item ? text_room(&trial, &p) : NULL;
    const bool done = room && labels_add(&trial, room);
    *box = (space_box){{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (size_t i = 0; i < trial.taken_count; i++) {
        const space_box *one = &trial.taken[i];
        *box = (space_box){{fmin(box->min.x, one->min.x), fmin(box->min.y, one->min.y)},
                           {fmax(box->max.x, one->max.x), fmax(box->max.y, one->max.y)}};
    }
    space_free(room);
    free(p.item);
    strokes_free(&trial);
    return done;
}

/* Cuts one side of the page, which has this length. The drawing and its margin reach `reach` from its middle; labels
 * lie from `least` to `most`, and have the margin `margin`. `*middle`: the drawing's middle, before and after. All in
 * mm. Returns the new length. */
static double crop_side(double reach, double least, double most, double margin, double length, double *middle)
{
    const double slack = 1e-3; /* so that rounding puts no label into the margins */
    double from = -greater(reach, 0.5), to = greater(reach, 0.5);
    from = lesser(from, least - margin - slack - *middle);
    to = greater(to, most + margin + slack - *middle);
    from = greater(from, -*middle);
    to = lesser(to, length - *middle);
    *middle = -from;
    return to - from;
}

/* Cuts the page to the drawing, its labels and the margins of `page`, on which it is laid already. No line leaves the
 * cut page. In a series, labels get room that does not depend on them. False: no memory. */
static bool crop(strokes *s, const roberts_page *page, double widest, roberts_vec2 min, roberts_vec2 max)
{
    const roberts_page *whole = &s->options->page;
    const double half = 0.5 * page_scale(&s->map),
                 room = s->drawing->windowed && s->options->placement.scale != 0.0 ? labels_reach(s->options) : 0.0;
    const double around = fmax(page->margin_mm + room, widest / 2.0);
    const roberts_vec2 reach = {half * (max.x - min.x) + around, half * (max.y - min.y) + around};
    space_box labels = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    if (labels_wanted(s) && !s->drawing->windowed && !lacks_regions(s) && !find_label_box(s, &labels))
        return false;
    s->page.width_mm =
        crop_side(reach.x, labels.min.x, labels.max.x, page->margin_mm, whole->width_mm, &s->map.page_mm.x);
    s->page.height_mm =
        crop_side(reach.y, labels.min.y, labels.max.y, page->margin_mm, whole->height_mm, &s->map.page_mm.y);
    s->view[0].map = s->map;
    s->frame_mm[1] = (roberts_vec2){s->page.width_mm - whole->margin_mm, s->page.height_mm - whole->margin_mm};
    return true;
}

roberts_status strokes_make(strokes *s, const roberts_drawing *drawing, const roberts_draw_options *options,
                            roberts_error *error)
{
    roberts_vec2 min, max;
    roberts_drawing shaped = *drawing;
    roberts_page page = page_within_frame(drawing, options);
    roberts_placement placement = options->placement;
    const double widest = widest_pen(&drawing, 1, options);
    if (!drawing->framed) /* a field of view is cut off at the border anyway */
        page = page_within_edge(page, widest, options);
    *s = nothing_drawn(options);
    s->drawing = drawing;
    if (drawing->framed)
        roberts_page_shape(&page, &shaped.window_min, &shaped.window_max);
    find_box(&shaped, options, &min, &max);
    if (!drawing->framed && !drawing->windowed && options->placement.scale == 0.0 &&
        !labels_make_room(drawing, options, &page, &min, &max, &s->label_mm))
        return error_no_memory(error);
    if (options->crop && !drawing->framed)
        placement.align_x = placement.align_y = 0;
    if (!page_lay(&page, &placement, min, max, &s->map, error))
        return ROBERTS_BAD_ARGUMENT;
    s->view[s->views++] = (page_view){.drawing = drawing, .map = s->map, .low = min, .high = max};
    if (options->crop && !drawing->framed && !crop(s, &page, widest, min, max))
        return error_no_memory(error);
    if (drawing->framed) {
        s->frame_mm[0] = page_place(&s->map, (roberts_vec2){min.x, max.y});
        s->frame_mm[1] = page_place(&s->map, (roberts_vec2){max.x, min.y});
    }
    if (!drawing->framed)
        warn_tiny(s);
    if (!drawing->framed && !zones_add(s))
        return error_no_memory(error);
    return draw(s, error);
}

/* Lays the views of a sheet on the page, with all text but distances and labels. */
static roberts_status lay_sheet(strokes *s, const roberts_sheet *sheet, const roberts_draw_options *options,
                                const sheet_reach *reach, roberts_error *error)
{
    sheet_map map;
    roberts_draw_options within = *options;
    *s = nothing_drawn(options);
    within.page = page_within_edge(options->page, widest_pen(sheet->view, ROBERTS_SHEET_VIEWS, options), options);
    if (!sheet_lay(sheet, &within, reach, &map, error))
        return ROBERTS_BAD_ARGUMENT;
    for (int i = 0; i < ROBERTS_SHEET_VIEWS; i++)
        if (sheet->view[i])
            s->view[s->views++] = (page_view){.drawing = sheet->view[i], .map = map.view[i], .place = i};
    s->map = map.view[ROBERTS_SHEET_FRONT];
    s->sheet = sheet;
    s->symbol_size = map.symbol_size;
    s->symbol_mm = map.symbol_mm;
    warn_tiny(s);
    return zones_add(s) && title_block_add(s) && dimensions_add(s) ? ROBERTS_OK : error_no_memory(error);
}

/* Finds out what becomes of the distances on a sheet, and its scale in mm per model unit. Nothing is kept. */
static roberts_status try_distances(const roberts_sheet *sheet, const roberts_draw_options *options,
                                    const sheet_reach *reach, distances_outcome *outcome, double *scale,
                                    roberts_error *error)
{
    strokes s;
    pieces p = {0};
    free_space *room = NULL;
    size_t segments = 0;
    roberts_status status = lay_sheet(&s, sheet, options, reach, error);
    for (size_t i = 0; i < s.views; i++)
        segments += count_segments(s.view[i].drawing);
    if (status == ROBERTS_OK && (p.item = alloc_array(segments, sizeof *p.item)) != NULL) {
        for (size_t i = 0; i < s.views; i++)
            collect(&s, &s.view[i], 0, &p);
        *scale = page_scale(&s.map);
        room = text_room(&s, &p);
    }
    if (status == ROBERTS_OK)
        status = room ? distances_add(&s, room, outcome, error) : error_no_memory(error);
    space_free(room);
    free(p.item);
    strokes_free(&s);
    return status;
}

/* Enlarges the reach by that of the distances if there were room for all of them, on a far larger page, at this scale.
 */
static roberts_status add_reach(const roberts_sheet *sheet, const roberts_draw_options *options, double scale,
                                sheet_reach *reach, roberts_error *error)
{
    const sheet_reach none = {0};
    roberts_sheet apart = *sheet;
    roberts_draw_options wide = *options;
    distances_outcome outcome;
    apart.gap_mm = 2.0 * farthest_distance;
    wide.page.width_mm += 4.0 * farthest_distance;
    wide.page.height_mm += 4.0 * farthest_distance;
    wide.placement = (roberts_placement){.scale = scale};
    const roberts_status status = try_distances(&apart, &wide, &none, &outcome, &scale, error);
    if (status == ROBERTS_OK)
        sheet_add_reach(reach, &outcome.reach);
    return status;
}

/* Where distances do not all find a good place on the sheet, views must be farther apart, or farther from the margins.
 * Finds how far, in a few rounds: they make the scale smaller, and then the distances reach a little farther. The best
 * round counts. Rounds that make the views too small do not. */
static roberts_status find_reach(const roberts_sheet *sheet, const roberts_draw_options *options, sheet_reach *best,
                                 roberts_error *error)
{
    roberts_draw_options quiet = *options;
    distances_outcome outcome = {0};
    sheet_reach reach = {0};
    size_t least = SIZE_MAX;
    double scale = 0.0, smallest = 0.0;
    roberts_error why;
    roberts_status status = ROBERTS_OK;
    quiet.lettering.warnings = (roberts_warnings){0};
    for (int round = 0; round < REACH_ROUNDS && least > 0 && status == ROBERTS_OK; round++) {
        if (round > 0)
            status = add_reach(sheet, &quiet, scale, &reach, &why);
        if (status == ROBERTS_OK)
            status = try_distances(sheet, &quiet, &reach, &outcome, &scale, &why);
        if (round == 0)
            smallest = (1.0 - 1e-9) * least_for_distances * scale;
        if (status == ROBERTS_OK && outcome.poor < least && scale >= smallest) {
            least = outcome.poor;
            *best = reach;
        }
    }
    if (status == ROBERTS_BAD_ARGUMENT && least < SIZE_MAX)
        status = ROBERTS_OK; /* there is no room for such a reach */
    if (status != ROBERTS_OK && error)
        *error = why;
    return status;
}

/* Letters of some height, and what they make of a sheet. */
typedef struct letters_tried {
    double height_mm;
    sheet_reach reach; /* that the labels want */
    double part;       /* of its size that the sheet would have with this reach; 0: it would have no room */
} letters_tried;

/* Tries labels that belong beside their vertices and edges. reach: without labels. */
static roberts_status try_letters(letters_tried *tried, const roberts_sheet *sheet, const roberts_draw_options *options,
                                  const sheet_reach *reach, roberts_error *error)
{
    strokes s;
    roberts_status status = lay_sheet(&s, sheet, options, reach, error);
    const double scale = status == ROBERTS_OK ? page_scale(&s.map) : 0.0;
    tried->reach = *reach;
    tried->part = 0.0;
    s.label_mm = tried->height_mm;
    if (status == ROBERTS_OK && !labels_add_reach(&s, &tried->reach))
        status = error_no_memory(error);
    strokes_free(&s);
    if (status != ROBERTS_OK)
        return status;
    status = lay_sheet(&s, sheet, options, &tried->reach, NULL);
    if (status == ROBERTS_OK)
        tried->part = page_scale(&s.map) / scale;
    strokes_free(&s);
    return status == ROBERTS_NO_MEMORY ? error_no_memory(error) : ROBERTS_OK;
}

/* Enlarges the reach by labels that belong beside their vertices and edges, if there is room for that; with smaller
 * letters if that leaves the views much larger. */
static roberts_status find_label_reach(const roberts_sheet *sheet, const roberts_draw_options *options,
                                       sheet_reach *reach, double *height, roberts_error *error)
{
    roberts_draw_options quiet = *options;
    const sheet_reach without = *reach;
    letters_tried tried = {.height_mm = *height};
    roberts_status status = ROBERTS_OK;
    quiet.lettering.warnings = (roberts_warnings){0};
    while (tried.height_mm > 0.0 && tried.part < labels_roomy && status == ROBERTS_OK) {
        status = try_letters(&tried, sheet, &quiet, &without, error);
        if (status == ROBERTS_OK && tried.part > (1.0 + 1e-9) * least_for_labels) {
            *reach = tried.reach;
            *height = tried.height_mm;
        }
        tried.height_mm = label_smaller_height(options, tried.height_mm);
    }
    return status;
}

roberts_status strokes_make_sheet(strokes *s, const roberts_sheet *sheet, const roberts_draw_options *options,
                                  roberts_error *error)
{
    sheet_reach reach = {0};
    double height = strokes_text_height(options);
    roberts_status status = ROBERTS_OK;
    *s = (strokes){0};
    if (options->lettering.distance_count > 0)
        status = find_reach(sheet, options, &reach, error);
    if (status == ROBERTS_OK && labels_stand_beside(options) && options->placement.scale == 0.0)
        status = find_label_reach(sheet, options, &reach, &height, error);
    if (status == ROBERTS_OK)
        status = lay_sheet(s, sheet, options, &reach, error);
    if (s->label_mm > 0.0)
        s->label_mm = height;
    return status == ROBERTS_OK ? draw(s, error) : status;
}

void strokes_free(strokes *s)
{
    polylines_free(&s->lines);
    notes_free(&s->notes);
    free(s->taken);
    free(s->group);
    fills_free(&s->fills);
}

size_t strokes_part_end(const strokes *s, size_t first, size_t end)
{
    size_t segments = 0;
    while (first < end && segments < SEGMENTS_PER_STROKE)
        segments += s->lines.item[first++].count;
    return first;
}

roberts_ink strokes_measure(const strokes *s)
{
    roberts_ink ink = {.strokes = s->lines.count,
                       .scale = page_scale(&s->map),
                       .origin_mm = page_place(&s->map, (roberts_vec2){0.0, 0.0}),
                       .label_mm = s->label_mm};
    for (size_t i = 0; i < s->lines.count; i++) {
        const polyline *line = &s->lines.item[i];
        const page_point *p = s->lines.point + line->first;
        for (uint32_t k = 1; k < line->count; k++)
            ink.down_mm += page_distance(p[k - 1], p[k]) / s->units_per_mm;
        if (line->closed)
            ink.down_mm += page_distance(p[line->count - 1], p[0]) / s->units_per_mm;
        if (i)
            ink.up_mm +=
                page_distance(polyline_end(&s->lines, line - 1), polyline_start(&s->lines, line)) / s->units_per_mm;
    }
    return ink;
}
