/* label_targets.c - what has a label: vertices and edges of lines that are drawn, visible regions of faces and bodies;
 * and its name or number. */
#include "draw/label_targets.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/box.h"
#include "base/vec.h"
#include "draw/free_space.h"

unsigned targets_kinds(const roberts_lettering *lettering)
{
    unsigned kinds = lettering->labels;
    for (size_t i = 0; i < lettering->name_count; i++)
        kinds |= (unsigned)lettering->name[i].of;
    return kinds;
}

static bool add_target(targets *t, const target *one)
{
    if (!array_reserve(&t->item, &t->room, t->count + 1, sizeof *t->item))
        return false;
    t->item[t->count++] = *one;
    return true;
}

/* Finds the part of the line from a to b that the frame shows. False: there is none. */
static bool clip_to_frame(const strokes *s, const page_view *view, roberts_vec2 a, roberts_vec2 b, double *from,
                          double *to)
{
    const roberts_vec2 *frame = s->frame_mm;
    return !view->drawing->framed || (box_clip(a.x, b.x, frame[0].x, frame[1].x, from, to) &&
                                      box_clip(a.y, b.y, frame[0].y, frame[1].y, from, to) && *from < *to);
}

static bool add_segment(const strokes *s, uint32_t v, const roberts_segment *segment, unsigned kinds, targets *t)
{
    const page_view *view = &s->view[v];
    const bool is_back = segment->state == ROBERTS_HIDDEN;
    const roberts_vec2 a = page_place(&view->map, segment->p0), b = page_place(&view->map, segment->p1);
    const double length = vec2_length(b.x - a.x, b.y - a.y);
    if (segment->v0 == ROBERTS_NONE || !(length > 0.0))
        return true;
    const roberts_vec2 along = {(b.x - a.x) / length, (b.y - a.y) / length};
    target one = {
        .kind = ROBERTS_LABEL_VERTICES, .view = v, .number = segment->v0, .is_back = is_back, .at = a, .along = along};
    if ((kinds & ROBERTS_LABEL_VERTICES) && segment->t0 == 0.0 && strokes_is_in_frame(s, view, a) &&
        !add_target(t, &one))
        return false;
    one.number = segment->v1;
    one.at = b;
    one.along = (roberts_vec2){-along.x, -along.y};
    if ((kinds & ROBERTS_LABEL_VERTICES) && segment->t1 == 1.0 && strokes_is_in_frame(s, view, b) &&
        !add_target(t, &one))
        return false;
    double from = 0.0, to = 1.0;
    if (!(kinds & ROBERTS_LABEL_EDGES) || !clip_to_frame(s, view, a, b, &from, &to))
        return true;
    const double middle = (from + to) / 2.0, part = (to - from) * length;
    one = (target){.kind = ROBERTS_LABEL_EDGES,
                   .view = v,
                   .number = segment->v0,
                   .other = segment->v1,
                   .is_back = is_back,
                   .at = {a.x + middle * (b.x - a.x), a.y + middle * (b.y - a.y)},
                   .along = along,
                   .reach = part / 2.0,
                   .size = part};
    return add_target(t, &one);
}

/* Of a region that the frame cuts, only the part within it counts. */
static bool add_region(const strokes *s, uint32_t v, const roberts_region *region, unsigned kinds, targets *t)
{
    const page_view *view = &s->view[v];
    const roberts_region_list *list = view->drawing->regions;
    const double mm = page_scale(&view->map);
    const space_box field = {view->low, view->high};
    const pole middle = pole_find(list, region, view->drawing->framed ? &field : NULL);
    target one = {.view = v,
                  .kind = ROBERTS_LABEL_FACES,
                  .number = region->face,
                  .at = page_place(&view->map, middle.at),
                  .reach = middle.distance * mm,
                  .size = region->area};
    if (view->drawing->framed && !(middle.distance > 0.0))
        return true;
    if ((kinds & ROBERTS_LABEL_FACES) && region->face != ROBERTS_NONE && !add_target(t, &one))
        return false;
    one.kind = ROBERTS_LABEL_BODIES;
    one.number = region->solid;
    return !(kinds & ROBERTS_LABEL_BODIES) || add_target(t, &one);
}

/* By view, kind and number; for one thing, visible parts come first, the largest one first. */
static int by_thing(const void *a, const void *b)
{
    const target *p = a, *q = b;
    const uint32_t key[][2] = {{p->view, q->view},
                               {(uint32_t)p->kind, (uint32_t)q->kind},
                               {p->number, q->number},
                               {p->other, q->other},
                               {p->is_back, q->is_back}};
    for (size_t i = 0; i < sizeof key / sizeof key[0]; i++)
        if (key[i][0] != key[i][1])
            return key[i][0] < key[i][1] ? -1 : 1;
    const double value[][2] = {
        {q->size, p->size}, {p->at.x, q->at.x}, {p->at.y, q->at.y}, {p->along.x, q->along.x}, {p->along.y, q->along.y}};
    for (size_t i = 0; i < sizeof value / sizeof value[0]; i++)
        if (value[i][0] != value[i][1])
            return value[i][0] < value[i][1] ? -1 : 1;
    return 0;
}

static bool is_same_thing(const target *p, const target *q)
{
    return p->view == q->view && p->kind == q->kind && p->number == q->number && p->other == q->other;
}

/* Fraction: parts that differ in size by less are equal, so that rounding does not choose. */
static const double same_size = 1e-9;

/* Is a part of a face or body, no larger than another part, as good for its label? Of equal parts the highest on the
 * page is the best, then the one on the left. */
static bool is_better_part(const target *part, const target *than)
{
    const bool is_higher = part->at.y != than->at.y ? part->at.y < than->at.y : part->at.x < than->at.x;
    return (part->kind == ROBERTS_LABEL_FACES || part->kind == ROBERTS_LABEL_BODIES) &&
           part->size >= (1.0 - same_size) * than->size && is_higher;
}

/* Leaves one target of each thing. A vertex keeps the sum of the directions of all its lines that have its state. */
static void unite(targets *t)
{
    size_t kept = 0;
    if (t->count)
        qsort(t->item, t->count, sizeof *t->item, by_thing);
    for (size_t i = 0; i < t->count; i++) {
        target *last = kept ? &t->item[kept - 1] : NULL;
        if (!last || !is_same_thing(last, &t->item[i])) {
            t->item[kept++] = t->item[i];
        } else if (last->kind == ROBERTS_LABEL_VERTICES && last->is_back == t->item[i].is_back) {
            last->along.x += t->item[i].along.x;
            last->along.y += t->item[i].along.y;
        } else if (is_better_part(&t->item[i], last)) {
            *last = t->item[i];
        }
    }
    t->count = kept;
}

bool targets_find(const strokes *s, unsigned kinds, targets *t)
{
    for (uint32_t v = 0; v < s->views; v++) {
        const page_view *view = s->view;
        const roberts_drawing *drawing = view[v].drawing;
        roberts_line line;
        for (size_t i = 0; i < drawing->count && (kinds & (ROBERTS_LABEL_VERTICES | ROBERTS_LABEL_EDGES)); i++)
            if (strokes_has_place(s->options, &drawing->segment[i], &line) &&
                !add_segment(s, v, &drawing->segment[i], kinds, t))
                return false;
        for (size_t i = 0;
             drawing->regions && i < drawing->regions->count && (kinds & (ROBERTS_LABEL_FACES | ROBERTS_LABEL_BODIES));
             i++)
            if (!add_region(s, v, &drawing->regions->region[i], kinds, t))
                return false;
    }
    unite(t);
    return true;
}

/* ---- what it says ---- */

int roberts_name_order(const void *a, const void *b)
{
    const roberts_name *p = a, *q = b;
    if (p->of != q->of)
        return p->of < q->of ? -1 : 1;
    if (p->number != q->number)
        return p->number < q->number ? -1 : 1;
    return (p->other > q->other) - (p->other < q->other);
}

/* Names are in order. NULL: it has none. */
static const char *find_name(const roberts_lettering *lettering, const target *of)
{
    const roberts_name wanted = {.of = of->kind, .number = of->number, .other = of->other}, *name = NULL;
    if (lettering->name_count > 0)
        name = bsearch(&wanted, lettering->name, lettering->name_count, sizeof wanted, roberts_name_order);
    return name ? name->text : NULL;
}

/* The prefix that distinguishes numbers of vertices, faces and bodies if several kinds are shown. Edges have two
 * numbers. */
static const char *number_prefix(unsigned kinds, roberts_label_kind kind)
{
    const unsigned alike = kinds & ~(unsigned)ROBERTS_LABEL_EDGES;
    if ((alike & (alike - 1)) == 0)
        return "";
    return kind == ROBERTS_LABEL_VERTICES ? "v" : kind == ROBERTS_LABEL_FACES ? "f" : "b";
}

const char *target_text(const target *of, const roberts_lettering *lettering, char number[NUMBER_SIZE])
{
    const char *name = find_name(lettering, of);
    if (name || !(lettering->labels & (unsigned)of->kind))
        return name;
    if (of->kind == ROBERTS_LABEL_EDGES)
        snprintf(number, NUMBER_SIZE, "%u-%u", (unsigned)of->number, (unsigned)of->other);
    else
        snprintf(number, NUMBER_SIZE, "%s%u", number_prefix(lettering->labels, of->kind), (unsigned)of->number);
    return number;
}
