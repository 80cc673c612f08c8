/* label_places.c - the places that a label may take: round a vertex, on both sides of an edge, about the middle of the
 * largest visible region of a face or body. A drawing that is fitted to the page leaves room for labels of vertices and
 * edges in their best places. */
#include "draw/label_places.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/angle.h"
#include "base/array.h"
#include "base/vec.h"

/* Costs, in mm of lines that a label lies on. */
static const double beside_best = 0.2; /* the most that a place costs for not being the best one */
static const double farther = 0.3;     /* each ring */

/* Space kept free round a label, and between a vertex and its label. */
static double text_gap(const strokes *s, double height)
{
    return 0.25 * height + pens_of(s->options, LINE_TEXT)->width_mm / 2.0;
}

void placing_set_height(placing *p, const strokes *s, double height)
{
    p->height = height;
    p->gap = text_gap(s, height);
}

double label_smaller_height(const roberts_draw_options *options, double height)
{
    static const double smaller_mm[] = {2.5, 1.8};
    for (size_t i = 0; i < sizeof smaller_mm / sizeof smaller_mm[0] && options->lettering.height_mm == 0.0; i++)
        if (smaller_mm[i] < height)
            return smaller_mm[i];
    return 0.0;
}

placing placing_of(const strokes *s)
{
    placing p = {.view = s->view};
    placing_set_height(&p, s, s->label_mm);
    for (int i = 0; i < VERTEX_SIDES; i++)
        p.side[i] = angle_unit(360.0 / VERTEX_SIDES * i);
    return p;
}

/* The sum of the directions of a vertex's lines, if they go to all sides. */
static const double no_direction = 1e-6;

/* How far a box reaches from its middle toward direction `d`. */
static double reach(roberts_vec2 half, roberts_vec2 d)
{
    return fmin(fabs(d.x) > 0.0 ? half.x / fabs(d.x) : INFINITY, fabs(d.y) > 0.0 ? half.y / fabs(d.y) : INFINITY);
}

/* Place `i` round a vertex. The directions go round the label as if it were a square: however wide it is, its corners
 * and the middles of its sides may point to the vertex. The best direction is away from the vertex's lines. */
static roberts_vec2 vertex_place(const placing *p, const label *l, size_t i, double *cost)
{
    const roberts_vec2 d = p->side[i % VERTEX_SIDES], away = l->of->along;
    const double ring = (double)(i / VERTEX_SIDES), length = vec2_length(away.x, away.y);
    const double side = reach((roberts_vec2){1.0, 1.0}, d), off = p->gap * (0.5 + 2.0 * ring);
    *cost = farther * ring;
    if (length > no_direction)
        *cost += beside_best * (1.0 + (away.x * d.x + away.y * d.y) / length);
    return (roberts_vec2){l->of->at.x + (side * l->half.x + off) * d.x, l->of->at.y + (side * l->half.y + off) * d.y};
}

/* Place `i` beside an edge: above it first, from the middle outward. */
static roberts_vec2 edge_place(const label *l, size_t i, double gap, double *cost)
{
    const roberts_vec2 along = l->of->along;
    const double side = (i % 2 == 0) == (along.x > 0.0 || (along.x == 0.0 && along.y < 0.0)) ? 1.0 : -1.0;
    const roberts_vec2 normal = {side * along.y, side * -along.x};
    const size_t step = i / 2;
    const double part = (step % 2 ? 1.0 : -1.0) * (double)((step + 1) / 2) / (EDGE_PLACES / 2 + 1);
    const double off = fabs(normal.x) * l->half.x + fabs(normal.y) * l->half.y + gap * 0.5;
    *cost = beside_best * fabs(part) + (i % 2 ? beside_best : 0.0);
    return (roberts_vec2){l->of->at.x + part * l->of->reach * along.x + off * normal.x,
                          l->of->at.y + part * l->of->reach * along.y + off * normal.y};
}

/* Place `i` about the middle of a region. */
static roberts_vec2 face_place(const placing *p, const label *l, size_t i, double *cost)
{
    if (i == 0) {
        *cost = 0.0;
        return l->of->at;
    }
    const size_t ring = (i - 1) / 8 + 1;
    const roberts_vec2 d = p->side[(i - 1) % 8 * (VERTEX_SIDES / 8)];
    const double off = l->of->reach * (double)ring / FACE_RINGS;
    *cost = farther * (double)ring;
    return (roberts_vec2){l->of->at.x + off * d.x, l->of->at.y + off * d.y};
}

size_t label_places(const target *of)
{
    return of->kind == ROBERTS_LABEL_VERTICES ? VERTEX_SIDES * VERTEX_RINGS
           : of->kind == ROBERTS_LABEL_EDGES  ? 2 * EDGE_PLACES
                                              : 1 + 8 * FACE_RINGS;
}

roberts_vec2 label_place(const placing *p, const label *l, size_t i, double *cost)
{
    return l->of->kind == ROBERTS_LABEL_VERTICES ? vertex_place(p, l, i, cost)
           : l->of->kind == ROBERTS_LABEL_EDGES  ? edge_place(l, i, p->gap, cost)
                                                 : face_place(p, l, i, cost);
}

roberts_vec2 label_leader_place(const placing *p, const label *l, size_t i, roberts_vec2 *end, double *cost)
{
    const roberts_vec2 d = p->side[i % VERTEX_SIDES];
    const double length = p->height * (1.0 + (double)(i / VERTEX_SIDES)),
                 off = length + 0.5 * p->gap + reach(l->half, d);
    *end = (roberts_vec2){l->dot.x + length * d.x, l->dot.y + length * d.y};
    *cost = farther * length / p->height;
    return (roberts_vec2){l->dot.x + off * d.x, l->dot.y + off * d.y};
}

/* ---- the labels ---- */

bool label_has_descender(const char *text)
{
    return strpbrk(text, "gjpqy,;Q_()[]{}|/$@") != NULL;
}

/* Visible things first, then those with the fewest places. */
static int by_freedom(const void *a, const void *b)
{
    const target *p = ((const label *)a)->of, *q = ((const label *)b)->of;
    if (p->is_back != q->is_back)
        return p->is_back ? 1 : -1;
    return p->kind != q->kind ? (p->kind > q->kind ? -1 : 1) : (p > q) - (p < q);
}

size_t labels_make(const placing *p, const strokes *s, const targets *t, label *list)
{
    const double height = p->height, gap = p->gap;
    size_t count = 0;
    for (size_t i = 0; i < t->count; i++) {
        label *l = &list[count];
        *l = (label){.of = &t->item[i]};
        l->text = target_text(l->of, s->options, l->number);
        if (!l->text || !*l->text)
            continue;
        const double depth = label_has_descender(l->text) ? LETTERS_DEPTH : 0.0;
        l->half = (roberts_vec2){strokes_text_width(s->options, l->text, height) / 2.0 + gap * 0.5,
                                 height * (1.0 + depth) / 2.0 + gap * 0.5};
        count++;
    }
    qsort(list, count, sizeof *list, by_freedom);
    for (size_t i = 0; i < count; i++) /* sorting has moved the numbers */
        list[i].text = target_text(list[i].of, s->options, list[i].number);
    return count;
}

/* ---- room for labels beside a drawing ---- */

/* What has its label beside it. */
static const unsigned beside_kinds = ROBERTS_LABEL_VERTICES | ROBERTS_LABEL_EDGES;

bool labels_stand_beside(const roberts_draw_options *options)
{
    return (targets_kinds(&options->lettering) & beside_kinds) != 0;
}

/* A drawing is not made smaller than this part of its size without labels. */
static const double least_part = 0.5;
/* mm: so that rounding takes no label out of the margins. */
static const double slack_mm = 1e-3;

/* What must be within the margins: a point of the drawing, and how far a label reaches from it to both sides, along one
 * axis. The point moves with the scale, and the label keeps its size. */
typedef struct extent {
    double at, low, high; /* mm; `at` from the middle of the page, before the drawing is made smaller */
} extent;

/* The ends of all extents where the drawing has `part` of its size; and the part with which they would fill `room`. */
static double part_that_fits(const extent *e, size_t count, double part, double room, double ends[2])
{
    const extent *low = e, *high = e;
    for (size_t i = 1; i < count; i++) {
        if (part * e[i].at + e[i].low < part * low->at + low->low)
            low = &e[i];
        if (part * e[i].at + e[i].high > part * high->at + high->high)
            high = &e[i];
    }
    ends[0] = part * low->at + low->low;
    ends[1] = part * high->at + high->high;
    if (ends[1] - ends[0] <= room)
        return part;
    return high->at > low->at ? fmax((room - high->high + low->low) / (high->at - low->at), least_part) : least_part;
}

/* The largest part with which all extents fit into `room`, by Newton's method: how far they reach is a convex function
 * of the part, made of straight pieces. */
static double largest_part(const extent *e, size_t count, double part, double room)
{
    double ends[2];
    for (int i = 0; i < 50; i++) { /* each step is on another piece; few are ever needed */
        const double next = part_that_fits(e, count, part, room, ends);
        if (next >= part)
            break;
        part = next;
    }
    return part;
}

/* Finds the middle of a label in its best place: that of a vertex away from its lines, that of an edge on both sides of
 * its middle. Returns how many places there are. */
static size_t best_places(const placing *p, const label *l, roberts_vec2 middle[2])
{
    double least = INFINITY, cost;
    if (l->of->kind == ROBERTS_LABEL_EDGES) {
        middle[0] = edge_place(l, 0, p->gap, &cost);
        middle[1] = edge_place(l, 1, p->gap, &cost);
        return 2;
    }
    if (!(vec2_length(l->of->along.x, l->of->along.y) > no_direction))
        return 0; /* its lines go to all sides */
    for (size_t i = 0; i < VERTEX_SIDES; i++) {
        const roberts_vec2 place = vertex_place(p, l, i, &cost);
        if (cost < least) {
            least = cost;
            middle[0] = place;
        }
    }
    return 1;
}

/* Adds the extents of the best places of a label. */
static void add_extents(extent *along[2], size_t *count, const placing *p, const label *l, roberts_vec2 page)
{
    const roberts_vec2 at = l->of->at, half = {l->half.x + slack_mm, l->half.y + slack_mm};
    roberts_vec2 middle[2];
    for (size_t i = 0, places = best_places(p, l, middle); i < places; i++) {
        const roberts_vec2 off = {middle[i].x - at.x, middle[i].y - at.y};
        along[0][*count] = (extent){at.x - page.x, off.x - half.x, off.x + half.x};
        along[1][(*count)++] = (extent){at.y - page.y, off.y - half.y, off.y + half.y};
    }
}

/* The ends of all extents, shortened so that they fit into `room`. The first two extents are those of the drawing. */
static void ends_within(const extent *e, size_t count, double part, double room, double ends[2])
{
    const double low = part * e[0].at, high = part * e[1].at, left = room - (high - low);
    part_that_fits(e, count, part, INFINITY, ends);
    const double beyond = low - ends[0] + ends[1] - high;
    const double kept = beyond > left ? fmax(left, 0.0) / beyond : 1.0;
    ends[0] = low - kept * (low - ends[0]);
    ends[1] = high + kept * (ends[1] - high);
}

/* The extents of a drawing, and of its labels with letters of p->height; along both axes. Returns how many. */
static size_t find_extents(extent *along[2], const placing *p, const strokes *s, const targets *t, label *list,
                           const roberts_vec2 box[2])
{
    const page_map *map = &s->view[0].map;
    const roberts_vec2 a = page_place(map, box[0]), b = page_place(map, box[1]);
    along[0][0] = (extent){a.x - map->page_mm.x, 0.0, 0.0};
    along[0][1] = (extent){b.x - map->page_mm.x, 0.0, 0.0};
    along[1][0] = (extent){b.y - map->page_mm.y, 0.0, 0.0}; /* y is down on the page */
    along[1][1] = (extent){a.y - map->page_mm.y, 0.0, 0.0};
    size_t count = 2;
    for (size_t i = 0, labels = labels_make(p, s, t, list); i < labels; i++)
        add_extents(along, &count, p, &list[i], map->page_mm);
    return count;
}

/* Widens the box by the labels, so that a drawing of `part` of its size fits into `room`. */
static void widen_box(extent *along[2], size_t count, const page_map *map, double part, roberts_vec2 room,
                      roberts_vec2 wide[2])
{
    double x[2], y[2];
    ends_within(along[0], count, part, room.x, x);
    ends_within(along[1], count, part, room.y, y);
    const double unit = map->half / (part * map->half_mm); /* model units per mm */
    wide[0] = (roberts_vec2){map->centre.x + x[0] * unit, map->centre.y - y[1] * unit};
    wide[1] = (roberts_vec2){map->centre.x + x[1] * unit, map->centre.y - y[0] * unit};
}

bool labels_make_room(const roberts_drawing *drawing, const roberts_draw_options *options, const roberts_page *page,
                      roberts_vec2 *min, roberts_vec2 *max, double *height)
{
    const unsigned kinds = targets_kinds(&options->lettering) & beside_kinds;
    const roberts_vec2 box[2] = {*min, *max},
                       room = {page->width_mm - 2.0 * page->margin_mm, page->height_mm - 2.0 * page->margin_mm};
    strokes s = {.options = options, .views = 1, .label_mm = *height};
    targets t = {0};
    if (!kinds)
        return true;
    s.view[0] = (page_view){.drawing = drawing, .map = page_fit(page, *min, *max)};
    const double scale = page_scale(&s.view[0].map), wanted = page_wanted_scale(&options->placement, scale);
    placing p = placing_of(&s);
    bool done = targets_find(&s, kinds, &t);
    label *list = done ? alloc_array(t.count, sizeof *list) : NULL;
    extent *e = done ? alloc_array(4 * (t.count + 1), sizeof *e) : NULL; /* two places at most, along two axes */
    double next = *height;
    done = list && e;
    while (done && next > 0.0) {
        extent *along[2] = {e, e + 2 * (t.count + 1)};
        roberts_vec2 wide[2];
        *height = next;
        placing_set_height(&p, &s, *height);
        const size_t count = find_extents(along, &p, &s, &t, list, box);
        /* labels are not worth a step of the standard scales */
        const double part = wanted > 0.0
                                ? wanted / scale
                                : largest_part(along[1], count, largest_part(along[0], count, 1.0, room.x), room.y);
        widen_box(along, count, &s.view[0].map, part, room, wide);
        *min = wide[0];
        *max = wide[1];
        next = wanted > 0.0 || part >= labels_roomy ? 0.0 : label_smaller_height(options, *height);
    }
    free(list);
    free(e);
    free(t.item);
    return done;
}

/* Enlarges the reach by a label in its best places. */
static void add_label_reach(const placing *p, const strokes *s, const label *l, sheet_reach *reach)
{
    roberts_vec2 middle[2];
    for (size_t i = 0, places = best_places(p, l, middle); i < places; i++) {
        const space_box box = label_box(l, middle[i]);
        sheet_add_box(reach, &s->view[l->of->view], &box, slack_mm);
    }
}

bool labels_add_reach(const strokes *s, sheet_reach *reach)
{
    targets t = {0};
    placing p = placing_of(s);
    const bool found = targets_find(s, targets_kinds(&s->options->lettering) & beside_kinds, &t);
    label *list = found ? alloc_array(t.count, sizeof *list) : NULL;
    for (size_t i = 0, count = list ? labels_make(&p, s, &t, list) : 0; i < count; i++)
        add_label_reach(&p, s, &list[i], reach);
    free(list);
    free(t.item);
    return list != NULL;
}

double labels_reach(const roberts_draw_options *options)
{
    const unsigned kinds = targets_kinds(&options->lettering);
    const double heights = kinds & ROBERTS_LABEL_EDGES ? 3.5 : kinds & ROBERTS_LABEL_VERTICES ? 2.0 : 0.0;
    return heights * strokes_text_height(options);
}
