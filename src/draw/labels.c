/* labels.c - where labels go.
 *
 * A label may take one of several places: round a vertex, on both sides of an edge, about the middle of the largest
 * visible region of a face or body. Each place has a cost: the length of the lines that lie there already, and its
 * distance from the best place. Labels choose one by one, those with the fewest places first; then each may choose
 * again a few times, knowing the others. Unless the size of letters is given, smaller ones are tried where the labels
 * find no room. So the work is bounded, and the result is always the same. */
#include "draw/labels.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/angle.h"
#include "base/array.h"
#include "base/vec.h"
#include "draw/free_space.h"

enum {
    NAME_SIZE = 32,
    VERTEX_SIDES = 16, /* directions from a vertex */
    VERTEX_RINGS = 4,  /* distances from it */
    EDGE_PLACES = 9,   /* along an edge, on each side */
    FACE_RINGS = 4,    /* of eight places each, round the middle of a region */
    PASSES = 5,
    MOST_UNDER = 3 /* labels that a place may lie on, until one of them is moved: then the work stays in proportion to
                      the labels even if most of them find no room */
};

/* mm: the least that counts as something. */
#define ANYTHING DBL_MIN

/* The box of a label that has no place. */
#define NO_BOX UINT32_MAX

/* Costs, in mm of lines that a label lies on. */
static const double beside_best = 0.2; /* the most that a place costs for not being the best one */
static const double farther = 0.3;     /* each ring */
static const double crowded = 1.0;     /* the most that a place costs for being near to another label */
static const double elsewhere = 1.5;   /* for a place nearer to another vertex, or behind another line */
static const double touching = 2.0;    /* for a place with anything on it, however little: worse than any free place */
static const double on_label = 20.0;   /* for a place on another label: then one of the two is left out */

/* Heights of letters: places whose boxes are no farther apart read like two lines of one text, or like two words. */
static const double apart_heights = 0.75;

/* Heights of letters (ISO 3098) that are tried if the usual height leaves too little room. */
static const double smaller_mm[] = {2.5, 1.8};
/* The largest fraction of the labels that may lie on lines before smaller letters are tried. */
static const double most_on_lines = 0.05;

/* What a label names. Vertices at one place of the picture are one. */
typedef struct target {
    roberts_label_kind kind;
    uint32_t view, number, other; /* as in roberts_name */
    bool is_back;                 /* hidden */
    roberts_vec2 at;              /* mm: the vertex, the middle of the edge's part, the middle of the region */
    roberts_vec2 along;           /* vertex: sum of the directions of its lines; edge: its direction */
    double reach;                 /* edge: half of the part's length; region: how far its border is; mm */
    double size;                  /* edge: length of the part; region: its area */
    uint32_t point;               /* vertex: its number in placing.vertices */
} target;

typedef struct targets {
    target *item;
    size_t count, room;
} targets;

typedef struct label {
    const char *text;
    char number[NAME_SIZE]; /* `text` of what has no name */
    const target *of;
    roberts_vec2 half; /* mm, of the box that is kept free */
    uint32_t box;      /* in the room; or NO_BOX */
    roberts_vec2 middle;
    bool is_dropped; /* there is no room for it */
    bool has_leader;
    roberts_vec2 leader; /* where the line from of->at to the label ends */
} label;

/* ---- what has a label ---- */

static unsigned labelled_kinds(const roberts_lettering *lettering)
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

static bool is_on_page(const strokes *s, const page_view *view, roberts_vec2 mm)
{
    return !view->drawing->framed || (mm.x >= s->frame_mm[0].x && mm.x <= s->frame_mm[1].x &&
                                      mm.y >= s->frame_mm[0].y && mm.y <= s->frame_mm[1].y);
}

static bool add_segment(const strokes *s, uint32_t v, const roberts_segment *segment, unsigned kinds, targets *t)
{
    const page_view *view = &s->view[v];
    const bool is_back = segment->state == ROBERTS_HIDDEN;
    const roberts_vec2 a = page_place(&view->map, segment->p0), b = page_place(&view->map, segment->p1);
    const double length = hypot(b.x - a.x, b.y - a.y);
    if (segment->v0 == ROBERTS_NONE || !(length > 0.0))
        return true;
    const roberts_vec2 along = {(b.x - a.x) / length, (b.y - a.y) / length};
    const roberts_vec2 middle = {(a.x + b.x) / 2.0, (a.y + b.y) / 2.0};
    target one = {ROBERTS_LABEL_VERTICES, v, segment->v0, 0, is_back, a, along, 0.0, 0.0, 0};
    if ((kinds & ROBERTS_LABEL_VERTICES) && segment->t0 == 0.0 && is_on_page(s, view, a) && !add_target(t, &one))
        return false;
    one = (target){ROBERTS_LABEL_VERTICES, v, segment->v1, 0, is_back, b, {-along.x, -along.y}, 0.0, 0.0, 0};
    if ((kinds & ROBERTS_LABEL_VERTICES) && segment->t1 == 1.0 && is_on_page(s, view, b) && !add_target(t, &one))
        return false;
    one = (target){ROBERTS_LABEL_EDGES, v, segment->v0, segment->v1, is_back, middle, along, length / 2.0, length, 0};
    return !(kinds & ROBERTS_LABEL_EDGES) || !is_on_page(s, view, middle) || add_target(t, &one);
}

/* A region whose middle the frame cuts off has no label. */
static bool add_region(const strokes *s, uint32_t v, const roberts_region *region, unsigned kinds, targets *t)
{
    const page_view *view = &s->view[v];
    const roberts_region_list *list = view->drawing->regions;
    const double mm = page_scale(&view->map);
    const pole middle = pole_find(list, region);
    target one = {.view = v,
                  .kind = ROBERTS_LABEL_FACES,
                  .number = region->face,
                  .at = page_place(&view->map, middle.at),
                  .reach = middle.distance * mm,
                  .size = region->area};
    if (!is_on_page(s, view, one.at))
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

/* Finds what has a label of one of these kinds. */
static bool find_targets(const strokes *s, unsigned kinds, targets *t)
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

static int compare_names(const roberts_name *p, roberts_label_kind kind, uint32_t number, uint32_t other)
{
    if (p->of != kind)
        return p->of < kind ? -1 : 1;
    if (p->number != number)
        return p->number < number ? -1 : 1;
    return (p->other > other) - (p->other < other);
}

/* Names are in order. NULL: it has none. */
static const char *find_name(const roberts_lettering *lettering, const target *of)
{
    size_t low = 0, high = lettering->name_count;
    while (low < high) {
        const size_t mid = low + (high - low) / 2;
        const int order = compare_names(&lettering->name[mid], of->kind, of->number, of->other);
        if (order == 0)
            return lettering->name[mid].text;
        if (order < 0)
            low = mid + 1;
        else
            high = mid;
    }
    return NULL;
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

static void set_text(label *l, const roberts_lettering *lettering)
{
    l->text = find_name(lettering, l->of);
    if (l->text || !(lettering->labels & (unsigned)l->of->kind))
        return;
    if (l->of->kind == ROBERTS_LABEL_EDGES)
        snprintf(l->number, sizeof l->number, "%u-%u", (unsigned)l->of->number, (unsigned)l->of->other);
    else
        snprintf(l->number, sizeof l->number, "%s%u", number_prefix(lettering->labels, l->of->kind),
                 (unsigned)l->of->number);
    l->text = l->number;
}

/* ---- where it goes ---- */

/* Space kept free round a label, and between a vertex and its label. */
static double text_gap(const strokes *s, double height)
{
    return 0.25 * height + strokes_pen(s->options, LINE_TEXT)->width_mm / 2.0;
}

static size_t count_places(const target *of)
{
    return of->kind == ROBERTS_LABEL_VERTICES ? VERTEX_SIDES * VERTEX_RINGS
           : of->kind == ROBERTS_LABEL_EDGES  ? 2 * EDGE_PLACES
                                              : 1 + 8 * FACE_RINGS;
}

/* The data for placing labels. */
typedef struct placing {
    free_space *room;
    free_space *vertices;            /* those that have labels, as boxes without size */
    double height, gap;              /* of the letters; round a label, and between a vertex and its label; mm */
    roberts_vec2 side[VERTEX_SIDES]; /* directions, counter-clockwise from that to the right */
} placing;

static void set_height(placing *p, const strokes *s, double height)
{
    p->height = height;
    p->gap = text_gap(s, height);
}

/* The data for letters of the usual height. */
static placing placing_of(const strokes *s)
{
    placing p = {0};
    set_height(&p, s, strokes_text_height(s->options));
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

/* Place `i` round a vertex. The best direction is away from the vertex's lines. */
static roberts_vec2 vertex_place(const placing *p, const label *l, size_t i, double *cost)
{
    const roberts_vec2 d = p->side[i % VERTEX_SIDES], away = l->of->along;
    const double ring = (double)(i / VERTEX_SIDES), length = hypot(away.x, away.y);
    const double off = reach(l->half, d) + p->gap * (0.5 + 2.0 * ring);
    *cost = farther * ring;
    if (length > no_direction)
        *cost += beside_best * (1.0 + (away.x * d.x + away.y * d.y) / length);
    return (roberts_vec2){l->of->at.x + off * d.x, l->of->at.y + off * d.y};
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

static space_box box_of(const label *l, roberts_vec2 middle)
{
    return (space_box){{middle.x - l->half.x, middle.y - l->half.y}, {middle.x + l->half.x, middle.y + l->half.y}};
}

/* The cost of what lies in a box. Infinite: the box leaves what labels must stay within, or lies on too many
 * labels. A cost of at least `enough` may be too low. */
static double cost_of_what_lies_there(const free_space *r, const space_box *box, uint32_t own, double enough)
{
    const space_load load = space_load_of(r, box, own, MOST_UNDER, greater(enough - touching, ANYTHING));
    if (load.mm <= 0.0)
        return 0.0;
    return load.boxes > MOST_UNDER ? INFINITY : load.mm + touching + (load.boxes > 0 ? on_label : 0.0);
}

static double box_distance(const space_box *box, roberts_vec2 p)
{
    const double x = fmax(fmax(box->min.x - p.x, p.x - box->max.x), 0.0);
    return hypot(x, fmax(fmax(box->min.y - p.y, p.y - box->max.y), 0.0));
}

/* The point of a vertex or an edge that is nearest to `p`. */
static roberts_vec2 nearest_point(const target *of, roberts_vec2 p)
{
    const roberts_vec2 d = {p.x - of->at.x, p.y - of->at.y};
    const double t = fmin(fmax(d.x * of->along.x + d.y * of->along.y, -of->reach), of->reach);
    return of->kind == ROBERTS_LABEL_EDGES ? (roberts_vec2){of->at.x + t * of->along.x, of->at.y + t * of->along.y}
                                           : of->at;
}

/* Does a place seem to belong to another vertex, or to what is behind another line? */
static bool is_elsewhere(const placing *p, const label *l, const space_box *box, roberts_vec2 middle)
{
    const roberts_vec2 from = nearest_point(l->of, middle);
    const double own = box_distance(box, l->of->at), length = hypot(middle.x - from.x, middle.y - from.y);
    const double off = fmin(0.5 * p->gap / length, 1.0); /* its own lines do not count */
    const roberts_vec2 start = {from.x + off * (middle.x - from.x), from.y + off * (middle.y - from.y)};
    if (l->of->kind != ROBERTS_LABEL_VERTICES && l->of->kind != ROBERTS_LABEL_EDGES)
        return false;
    return (l->of->kind == ROBERTS_LABEL_VERTICES && space_to_next_box(p->vertices, box, l->of->point, own) < own) ||
           space_count_crossings(p->room, start, middle) > 0;
}

/* The cost of what is near by. */
static double cost_of_neighbours(const placing *p, const label *l, const space_box *box, roberts_vec2 middle)
{
    const double apart = apart_heights * p->height, near = space_to_next_box(p->room, box, l->box, apart);
    return crowded * (1.0 - near / apart) + (is_elsewhere(p, l, box, middle) ? elsewhere : 0.0);
}

/* Finds the cheapest place, the first of several. False: there is none. */
static bool choose_place(const placing *p, label *l)
{
    double least = INFINITY;
    for (size_t i = 0, places = count_places(l->of); i < places; i++) {
        double cost;
        const roberts_vec2 middle = l->of->kind == ROBERTS_LABEL_VERTICES ? vertex_place(p, l, i, &cost)
                                    : l->of->kind == ROBERTS_LABEL_EDGES  ? edge_place(l, i, p->gap, &cost)
                                                                          : face_place(p, l, i, &cost);
        const space_box box = box_of(l, middle);
        if (cost < least)
            cost += cost_of_what_lies_there(p->room, &box, l->box, least - cost);
        if (cost < least)
            cost += cost_of_neighbours(p, l, &box, middle);
        if (cost < least) {
            least = cost;
            l->middle = middle;
        }
    }
    return least < INFINITY;
}

/* Visible things first, then those with the fewest places. */
static int by_freedom(const void *a, const void *b)
{
    const target *p = ((const label *)a)->of, *q = ((const label *)b)->of;
    if (p->is_back != q->is_back)
        return p->is_back ? 1 : -1;
    return p->kind != q->kind ? (p->kind > q->kind ? -1 : 1) : (p > q) - (p < q);
}

/* Enters the box of a label into the room. False: no memory. */
static bool place_box(const placing *p, label *l)
{
    const space_box box = box_of(l, l->middle);
    return l->box == NO_BOX ? space_add_box(p->room, &box, &l->box) : space_move_box(p->room, l->box, &box);
}

/* Puts a label where it is best. False: no memory. */
static bool place_one(const placing *p, label *l)
{
    if (choose_place(p, l))
        return place_box(p, l);
    if (l->box != NO_BOX)
        space_drop_box(p->room, l->box);
    l->box = NO_BOX;
    return true;
}

static bool place_all(const placing *p, label *l, size_t count)
{
    for (size_t i = 0; i < count; i++)
        l[i].box = NO_BOX;
    for (int pass = 0; pass < PASSES; pass++)
        for (size_t i = 0; i < count; i++)
            if (!place_one(p, &l[i]))
                return false;
    return true;
}

/* Leaves out labels that have no place, or lie on others, starting with those placed last. */
static void drop_some(label *l, size_t count, free_space *r)
{
    for (size_t i = count; i-- > 0;) {
        const space_box box = box_of(&l[i], l[i].middle);
        l[i].is_dropped = l[i].box == NO_BOX || space_load_of(r, &box, l[i].box, 0, INFINITY).boxes > 0;
        if (l[i].is_dropped && l[i].box != NO_BOX)
            space_drop_box(r, l[i].box);
    }
}

/* ---- leader lines ---- */

/* A face or body may be too narrow for its label. Then the label moves to a free place near by, and a leader line goes
 * from there to a dot in the face (ISO 128-22). It goes through no label and crosses no other leader line. */

enum {
    LEADER_RINGS = 12, /* distances from the middle of the region, a height of the letters each */
    LEADERS_MOST = 100 /* so that the work is bounded: each is compared with the others */
};
static const double most_leaders = 0.25;   /* part of the labels: more would be a thicket, and then there are none */
static const double leader_crowded = 2.0;  /* the most that a place costs for being near to another label */
static const double leader_crossing = 1.0; /* cost of each line that a leader line crosses */
static const double leader_apart_heights = 3.0; /* heights of letters: other labels are near if they are nearer */
static const double dot_radius = 0.3;           /* mm */

static bool lies_on_lines(const placing *p, const label *l)
{
    const space_box box = box_of(l, l->middle);
    return space_load_of(p->room, &box, l->box, UINT32_MAX, ANYTHING).mm > 0.0;
}

static bool needs_leader(const placing *p, const label *l)
{
    const bool is_area = l->of->kind == ROBERTS_LABEL_FACES || l->of->kind == ROBERTS_LABEL_BODIES;
    return is_area && (l->is_dropped || lies_on_lines(p, l));
}

/* Does a label in `box`, and its leader line to `end`, keep off the labels, and off the leader lines of others? */
static bool leader_is_free(const placing *p, const label *l, const space_box *box, roberts_vec2 end, const label *list,
                           size_t count)
{
    if (space_line_meets_boxes(p->room, l->of->at, end, UINT32_MAX))
        return false;
    for (size_t i = 0; i < count; i++)
        if (list[i].has_leader && (space_lines_cross(l->of->at, end, list[i].of->at, list[i].leader) ||
                                   space_line_meets_box(list[i].of->at, list[i].leader, box)))
            return false;
    return true;
}

/* Place `i` beyond a region; `*end` receives the end of the leader line, and `*cost` what its length costs. */
static roberts_vec2 leader_place(const placing *p, const label *l, size_t i, roberts_vec2 *end, double *cost)
{
    const roberts_vec2 d = p->side[i % VERTEX_SIDES];
    const double length = p->height * (1.0 + (double)(i / VERTEX_SIDES)),
                 off = length + 0.5 * p->gap + reach(l->half, d);
    *end = (roberts_vec2){l->of->at.x + length * d.x, l->of->at.y + length * d.y};
    *cost = farther * length / p->height;
    return (roberts_vec2){l->of->at.x + off * d.x, l->of->at.y + off * d.y};
}

/* What a place beyond a region costs: lines that the leader line crosses, or would cross beside its way; labels near
 * by, since what stands in another face seems to belong there. */
static double leader_cost(const placing *p, const label *l, const space_box *box, roberts_vec2 end)
{
    const roberts_vec2 at = l->of->at;
    const double length = hypot(end.x - at.x, end.y - at.y), apart = leader_apart_heights * p->height;
    double crossed = 0.0;
    for (int side = -1; side <= 1; side++) {
        const roberts_vec2 off = {side * p->gap * (end.y - at.y) / length, side * p->gap * (at.x - end.x) / length};
        crossed += (double)space_count_crossings(p->room, (roberts_vec2){at.x + off.x, at.y + off.y},
                                                 (roberts_vec2){end.x + off.x, end.y + off.y});
    }
    return leader_crossing * crossed / 3.0 +
           leader_crowded * (1.0 - space_to_next_box(p->room, box, UINT32_MAX, apart) / apart);
}

/* Moves a label, which is not in the room, to the cheapest free place with a leader line. False: no memory. */
static bool lead_out(const placing *p, label *l, const label *list, size_t count)
{
    double least = INFINITY;
    for (size_t i = 0; i < VERTEX_SIDES * LEADER_RINGS; i++) {
        double cost;
        roberts_vec2 end;
        const roberts_vec2 middle = leader_place(p, l, i, &end, &cost);
        const space_box box = box_of(l, middle);
        if (cost >= least || space_load_of(p->room, &box, UINT32_MAX, 0, ANYTHING).mm > 0.0)
            continue;
        cost += leader_cost(p, l, &box, end);
        if (cost < least && leader_is_free(p, l, &box, end, list, count)) {
            least = cost;
            l->middle = middle;
            l->leader = end;
        }
    }
    l->has_leader = least < INFINITY;
    return !l->has_leader || place_box(p, l);
}

/* Gives leader lines to labels that need them, unless too many do. False: no memory. */
static bool add_leaders(const placing *p, label *l, size_t count)
{
    size_t needed = 0;
    for (size_t i = 0; i < count; i++)
        needed += needs_leader(p, &l[i]);
    if (needed > LEADERS_MOST || (double)needed > most_leaders * (double)count)
        return true;
    for (size_t i = 0; i < count; i++) {
        const label before = l[i];
        if (!needs_leader(p, &l[i]))
            continue;
        if (!l[i].is_dropped)
            space_drop_box(p->room, l[i].box);
        l[i].is_dropped = false;
        if (!lead_out(p, &l[i], l, count))
            return false;
        if (l[i].has_leader)
            continue;
        l[i] = before;
        if (!before.is_dropped && !place_box(p, &l[i]))
            return false;
    }
    return true;
}

static size_t count_dropped(const label *l, size_t count)
{
    size_t dropped = 0;
    for (size_t i = 0; i < count; i++)
        dropped += l[i].is_dropped;
    return dropped;
}

/* Is there room for all labels, and do nearly all of them lie on no line? */
static bool have_room(const label *l, size_t count, const free_space *r)
{
    size_t on_lines = 0;
    if (count_dropped(l, count) > 0)
        return false;
    for (size_t i = 0; i < count; i++) {
        const space_box box = box_of(&l[i], l[i].middle);
        on_lines += space_load_of(r, &box, l[i].box, 0, ANYTHING).mm > 0.0;
    }
    return (double)on_lines <= most_on_lines * (double)count;
}

static void tell_dropped(const roberts_lettering *lettering, const label *l, size_t count)
{
    const size_t dropped = count_dropped(l, count);
    char text[160];
    if (dropped == 0 || !lettering->warnings.warn)
        return;
    snprintf(text, sizeof text,
             "no room for %zu of %zu labels, which are left out: choose smaller letters or a larger page", dropped,
             count);
    lettering->warnings.warn(lettering->warnings.context, "", 0, text);
}

static bool has_descender(const char *text)
{
    return strpbrk(text, "gjpqy,;Q_()[]{}|/$@") != NULL;
}

static bool add_note(strokes *s, const label *l, double height)
{
    const double depth = has_descender(l->text) ? LETTERS_DEPTH * height : 0.0;
    const text_line line = {.text = l->text,
                            .at = {l->middle.x, l->middle.y + (height - depth) / 2.0},
                            .height_mm = height,
                            .align = 0.5,
                            .along = TEXT_LEVEL};
    const space_box box = box_of(l, l->middle);
    if (l->has_leader && !(notes_add_line(&s->notes, l->of->at, l->leader, s->units_per_mm) &&
                           notes_add_dot(&s->notes, l->of->at, dot_radius, s->units_per_mm)))
        return false;
    return strokes_take(s, &box) && notes_add_text(&s->notes, &line, l->of->is_back);
}

/* Fills `list` with the labels of targets that have a text. */
static size_t make_labels(const placing *p, const strokes *s, const targets *t, label *list)
{
    const double height = p->height, gap = p->gap;
    size_t count = 0;
    for (size_t i = 0; i < t->count; i++) {
        label *l = &list[count];
        *l = (label){.of = &t->item[i]};
        set_text(l, &s->options->lettering);
        if (!l->text || !*l->text)
            continue;
        const double depth = has_descender(l->text) ? LETTERS_DEPTH : 0.0;
        l->half =
            (roberts_vec2){letters_width(l->text, height) / 2.0 + gap * 0.5, height * (1.0 + depth) / 2.0 + gap * 0.5};
        count++;
    }
    qsort(list, count, sizeof *list, by_freedom);
    for (size_t i = 0; i < count; i++) /* sorting has moved them */
        if (!find_name(&s->options->lettering, list[i].of))
            list[i].text = list[i].number;
    return count;
}

/* ---- room for labels beside a drawing ---- */

/* What has its label beside it. */
static const unsigned beside_kinds = ROBERTS_LABEL_VERTICES | ROBERTS_LABEL_EDGES;

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
    if (!(hypot(l->of->along.x, l->of->along.y) > no_direction))
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

/* Widens the box by the labels. `map` is that of the drawing without them. */
static void widen_box(extent *along[2], size_t count, const strokes *s, const roberts_page *page, roberts_vec2 *min,
                      roberts_vec2 *max)
{
    const page_map *map = &s->view[0].map;
    const double scale = page_scale(map), wide = page->width_mm - 2.0 * page->margin_mm,
                 high = page->height_mm - 2.0 * page->margin_mm;
    double x[2], y[2];
    const double wanted = page_wanted_scale(&s->options->placement, scale);
    /* labels are not worth a step of the standard scales */
    const double part =
        wanted > 0.0 ? wanted / scale : largest_part(along[1], count, largest_part(along[0], count, 1.0, wide), high);
    ends_within(along[0], count, part, wide, x);
    ends_within(along[1], count, part, high, y);
    const double unit = map->half / (part * map->half_mm); /* model units per mm */
    *min = (roberts_vec2){map->centre.x + x[0] * unit, map->centre.y - y[1] * unit};
    *max = (roberts_vec2){map->centre.x + x[1] * unit, map->centre.y - y[0] * unit};
}

bool labels_make_room(const roberts_drawing *drawing, const roberts_draw_options *options, const roberts_page *page,
                      roberts_vec2 *min, roberts_vec2 *max)
{
    const unsigned kinds = labelled_kinds(&options->lettering) & beside_kinds;
    strokes s = {.options = options, .views = 1};
    targets t = {0};
    if (!kinds)
        return true;
    s.view[0] = (page_view){.drawing = drawing, .map = page_fit(page, *min, *max)};
    const page_map *map = &s.view[0].map;
    placing p = placing_of(&s);
    bool done = find_targets(&s, kinds, &t);
    label *list = done ? alloc_array(t.count, sizeof *list) : NULL;
    extent *e = done ? alloc_array(4 * (t.count + 1), sizeof *e) : NULL; /* two places at most, along two axes */
    if (list && e) {
        extent *along[2] = {e, e + 2 * (t.count + 1)};
        const roberts_vec2 a = page_place(map, *min), b = page_place(map, *max);
        along[0][0] = (extent){a.x - map->page_mm.x, 0.0, 0.0};
        along[0][1] = (extent){b.x - map->page_mm.x, 0.0, 0.0};
        along[1][0] = (extent){b.y - map->page_mm.y, 0.0, 0.0}; /* y is down on the page */
        along[1][1] = (extent){a.y - map->page_mm.y, 0.0, 0.0};
        size_t count = 2;
        for (size_t i = 0, labels = make_labels(&p, &s, &t, list); i < labels; i++)
            add_extents(along, &count, &p, &list[i], map->page_mm);
        widen_box(along, count, &s, page, min, max);
    }
    done = list && e;
    free(list);
    free(e);
    free(t.item);
    return done;
}

/* Enlarges the reach by a label in its best places. */
static void add_label_reach(const placing *p, const strokes *s, const label *l, sheet_reach *reach)
{
    const page_view *view = &s->view[l->of->view];
    const roberts_vec2 low = page_place(&view->map, view->drawing->window_min);
    const roberts_vec2 high = page_place(&view->map, view->drawing->window_max);
    roberts_vec2 middle[2];
    for (size_t i = 0, places = best_places(p, l, middle); i < places; i++) {
        const space_box box = box_of(l, middle[i]);
        sheet_reach own = {0};
        own.view[view->place].left = low.x - box.min.x + slack_mm;
        own.view[view->place].right = box.max.x - high.x + slack_mm;
        own.view[view->place].above = high.y - box.min.y + slack_mm;
        own.view[view->place].below = box.max.y - low.y + slack_mm;
        sheet_add_reach(reach, &own);
    }
}

bool labels_add_reach(const strokes *s, sheet_reach *reach)
{
    targets t = {0};
    placing p = placing_of(s);
    const bool found = find_targets(s, labelled_kinds(&s->options->lettering) & beside_kinds, &t);
    label *list = found ? alloc_array(t.count, sizeof *list) : NULL;
    for (size_t i = 0, count = list ? make_labels(&p, s, &t, list) : 0; i < count; i++)
        add_label_reach(&p, s, &list[i], reach);
    free(list);
    free(t.item);
    return list != NULL;
}

/* Hatching would leave no room anywhere, so labels may lie on it. */
static bool add_pieces_to_room(const strokes *s, const pieces *p, free_space *r)
{
    for (size_t i = 0; i < p->count; i++) {
        const piece *own = &p->item[i];
        if (own->line != PIECE_GONE && own->line != LINE_HATCH &&
            !space_add_line(r, page_in_mm(own->a, s->units_per_mm), page_in_mm(own->b, s->units_per_mm)))
            return false;
    }
    return true;
}

static bool add_polylines_to_room(const polylines *lines, double units_per_mm, free_space *r)
{
    for (size_t i = 0; i < lines->count; i++)
        if (!space_add_polyline(r, lines, i, units_per_mm))
            return false;
    return true;
}

free_space *labels_room(const strokes *s, const pieces *p, const polylines *lines)
{
    const roberts_page *page = &s->options->page;
    space_box within = {s->frame_mm[0], s->frame_mm[1]};
    if (s->options->placement.scale > 0.0) /* a drawing at a given scale may lie on the margins */
        within = (space_box){{0.0, 0.0}, {page->width_mm, page->height_mm}};
    free_space *r = space_new(page->width_mm, page->height_mm, 2.0 * strokes_text_height(s->options), &within);
    bool done = r && add_pieces_to_room(s, p, r) && add_polylines_to_room(lines, s->units_per_mm, r) &&
                add_polylines_to_room(&s->notes.lines, s->units_per_mm, r) &&
                space_add_boxes(r, s->taken, s->taken_count, 0.0);
    if (done)
        return r;
    space_free(r);
    return NULL;
}

double labels_reach(const roberts_draw_options *options)
{
    const unsigned kinds = labelled_kinds(&options->lettering);
    const double heights = kinds & ROBERTS_LABEL_EDGES ? 3.5 : kinds & ROBERTS_LABEL_VERTICES ? 2.0 : 0.0;
    return heights * strokes_text_height(options);
}

bool labels_wanted(const strokes *s)
{
    return labelled_kinds(&s->options->lettering) != 0;
}

/* Makes the labels with letters of this height, and finds their places. */
static bool try_height(placing *p, double height, const strokes *s, const targets *t, label *list, size_t *count)
{
    set_height(p, s, height);
    *count = make_labels(p, s, t, list);
    if (!place_all(p, list, *count))
        return false;
    drop_some(list, *count, p->room);
    return add_leaders(p, list, *count);
}

/* Removes the labels from the page again. */
static void take_off(const label *l, size_t count, free_space *r)
{
    for (size_t i = 0; i < count; i++)
        if (!l[i].is_dropped)
            space_drop_box(r, l[i].box);
}

/* False: no memory. */
static bool enter_vertices(placing *p, const strokes *s, targets *t)
{
    const roberts_page *page = &s->options->page;
    const space_box whole = {{0.0, 0.0}, {page->width_mm, page->height_mm}};
    p->vertices = space_new(page->width_mm, page->height_mm, 2.0 * strokes_text_height(s->options), &whole);
    bool done = p->vertices != NULL;
    for (size_t i = 0; done && i < t->count; i++) {
        const space_box point = {t->item[i].at, t->item[i].at};
        if (t->item[i].kind == ROBERTS_LABEL_VERTICES)
            done = space_add_box(p->vertices, &point, &t->item[i].point);
    }
    return done;
}

bool labels_add(strokes *s, free_space *r)
{
    const roberts_lettering *lettering = &s->options->lettering;
    const size_t sizes = lettering->height_mm > 0.0 ? 0 : sizeof smaller_mm / sizeof smaller_mm[0];
    placing p = placing_of(s);
    targets t = {0};
    label *list = NULL;
    size_t count = 0;
    p.room = r;
    bool done = find_targets(s, labelled_kinds(lettering), &t) && enter_vertices(&p, s, &t) &&
                (list = alloc_array(t.count, sizeof *list)) != NULL &&
                try_height(&p, strokes_text_height(s->options), s, &t, list, &count);
    for (size_t i = 0; done && i < sizes && !have_room(list, count, r); i++) {
        take_off(list, count, r);
        done = try_height(&p, smaller_mm[i], s, &t, list, &count);
    }
    if (done)
        tell_dropped(lettering, list, count);
    for (size_t i = 0; i < count && done; i++)
        done = list[i].is_dropped || add_note(s, &list[i], p.height);
    space_free(p.vertices);
    free(list);
    free(t.item);
    return done;
}
