/* label_targets.c - what has a label: vertices and edges of lines that are drawn, visible regions of faces and bodies;
 * and its name or number. */
#include "draw/label_targets.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/box.h"
#include "base/search.h"
#include "base/vec.h"
#include "draw/free_space.h"

unsigned targets_kinds(const roberts_lettering *lettering)
{
    unsigned kinds = lettering->labels;
    for (size_t i = 0; i < lettering->name_count; i++)
        kinds |= (unsigned)lettering->name[i].of;
    return kinds & ROBERTS_LABEL_NAMES ? kinds | ROBERTS_LABEL_BODIES : kinds;
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
    target one = {.kind = ROBERTS_LABEL_VERTICES,
                  .view = v,
                  .number = segment->v0,
                  .is_back = is_back,
                  .at = a,
                  .along = along,
                  .z = segment->z0};
    if ((kinds & ROBERTS_LABEL_VERTICES) && segment->t0 == 0.0 && strokes_is_in_frame(s, view, a) &&
        !add_target(t, &one))
        return false;
    one.number = segment->v1;
    one.at = b;
    one.z = segment->z1;
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

/* ---- regions ---- */

/* A segment of a drawing, and its body. */
typedef struct drawn_segment {
    uint32_t solid;
    size_t number;
} drawn_segment;

/* A search for places in the regions of a view. */
typedef struct region_search {
    const strokes *s;
    targets *to;
    uint32_t view;
    pole_line *line; /* [count] scratch */
    size_t count, room;
    drawn_segment *drawn;     /* [drawn_count] visible segments, by body */
    size_t drawn_count, next; /* next: the first of a body that is not done */
} region_search;

static bool add_line(region_search *w, roberts_vec2 a, roberts_vec2 b)
{
    if (!array_reserve(&w->line, &w->room, w->count + 1, sizeof *w->line))
        return false;
    w->line[w->count++] = (pole_line){a, b};
    return true;
}

/* Adds the sides of a region's rings. */
static bool add_rings(region_search *w, const roberts_region_list *list, const roberts_region *region)
{
    bool enough = true;
    for (size_t r = region->first_ring; r < region->first_ring + region->ring_count; r++)
        for (size_t start = list->ring_start[r], end = list->ring_start[r + 1], i = start; enough && i < end; i++)
            enough = add_line(w, list->corner[i], list->corner[i + 1 < end ? i + 1 : start]);
    return enough;
}

/* Sets the place of a target: within the first `border` lines, which go round a region, and as far as possible from all
 * lines. Of what the frame cuts, only the part within it counts; then the reach may be 0. */
static void place_within(const region_search *w, size_t border, target *one)
{
    const page_view *view = &w->s->view[w->view];
    const space_box field = {view->low, view->high};
    const pole middle = pole_find(w->line, w->count, border, view->drawing->framed ? &field : NULL);
    one->at = page_place(&view->map, middle.at);
    one->reach = middle.distance * page_scale(&view->map);
}

/* Adds a target, unless the frame shows nothing of it. */
static bool add_placed(region_search *w, const target *one)
{
    return (w->s->view[w->view].drawing->framed && !(one->reach > 0.0)) || add_target(w->to, one);
}

static bool place_in_region(region_search *w, const roberts_region_list *list, const roberts_region *region,
                            target *one)
{
    w->count = 0;
    one->size = region->area;
    if (!add_rings(w, list, region))
        return false;
    place_within(w, w->count, one);
    return true;
}

static bool add_face(region_search *w, const roberts_region_list *list, const roberts_region *region)
{
    target one = {.kind = ROBERTS_LABEL_FACES, .view = w->view, .number = region->face};
    return region->face == ROBERTS_NONE || (place_in_region(w, list, region, &one) && add_placed(w, &one));
}

/* Fraction: regions that differ in area by less are equal, so that rounding does not choose. */
static const double same_size = 1e-9;

/* Places the label of a body in its largest region; of equal ones, in that with the highest middle on the page, then in
 * the one on the left. */
static bool place_in_largest(region_search *w, const roberts_region_list *list, size_t first, size_t end, target *one)
{
    double largest = 0.0;
    bool found = false;
    for (size_t i = first; i < end; i++)
        largest = greater(largest, list->region[i].area);
    for (size_t i = first; i < end; i++) {
        target other = *one;
        if (list->region[i].area < (1.0 - same_size) * largest)
            continue;
        if (!place_in_region(w, list, &list->region[i], &other))
            return false;
        if (!found || (other.at.y != one->at.y ? other.at.y < one->at.y : other.at.x < one->at.x))
            *one = other;
        found = true;
    }
    return true;
}

static int by_point(roberts_vec2 a, roberts_vec2 b)
{
    if (a.x != b.x)
        return a.x < b.x ? -1 : 1;
    return (a.y > b.y) - (a.y < b.y);
}

/* Both directions of a line are equal. */
static int by_place(const void *a, const void *b)
{
    const pole_line *p = a, *q = b;
    const bool p_turned = by_point(p->a, p->b) > 0, q_turned = by_point(q->a, q->b) > 0;
    const int first = by_point(p_turned ? p->b : p->a, q_turned ? q->b : q->a);
    return first ? first : by_point(p_turned ? p->a : p->b, q_turned ? q->a : q->b);
}

/* Removes the sides between two of the regions. */
static void leave_border(region_search *w)
{
    size_t kept = 0;
    if (w->count > 1)
        qsort(w->line, w->count, sizeof *w->line, by_place);
    for (size_t i = 0; i < w->count; i++)
        if (kept > 0 && by_place(&w->line[kept - 1], &w->line[i]) == 0)
            kept--;
        else
            w->line[kept++] = w->line[i];
    w->count = kept;
}

/* Lists the border of all regions of a body, then its visible segments that are drawn. */
static bool add_lines_of_body(region_search *w, const roberts_region_list *list, size_t first, size_t end,
                              size_t *border)
{
    const roberts_segment *segment = w->s->view[w->view].drawing->segment;
    const uint32_t solid = list->region[first].solid;
    bool enough = true;
    w->count = 0;
    for (size_t i = first; enough && i < end; i++)
        enough = add_rings(w, list, &list->region[i]);
    leave_border(w);
    *border = w->count;
    while (w->next < w->drawn_count && w->drawn[w->next].solid < solid)
        w->next++;
    for (; enough && w->next < w->drawn_count && w->drawn[w->next].solid == solid; w->next++) {
        const roberts_segment *drawn = &segment[w->drawn[w->next].number];
        enough = add_line(w, drawn->p0, drawn->p1);
    }
    return enough;
}

/* A body's label leaves its largest region for another place in the body that has this many times as much room, such as
 * the middle of a round body, whose edges are not drawn. */
static const double much_more_room = 1.5;

static bool add_body(region_search *w, const roberts_region_list *list, size_t first, size_t end)
{
    target one = {.kind = ROBERTS_LABEL_BODIES, .view = w->view, .number = list->region[first].solid}, all = one;
    size_t border;
    if (!place_in_largest(w, list, first, end, &one) || !add_lines_of_body(w, list, first, end, &border))
        return false;
    place_within(w, border, &all);
    all.size = one.size;
    return add_placed(w, all.reach > much_more_room * one.reach ? &all : &one);
}

static int by_solid(const void *a, const void *b)
{
    const drawn_segment *p = a, *q = b;
    if (p->solid != q->solid)
        return p->solid < q->solid ? -1 : 1;
    return (p->number > q->number) - (p->number < q->number);
}

/* Lists the visible segments that are drawn. */
static bool list_drawn(region_search *w, const roberts_drawing *drawing)
{
    roberts_line line;
    w->drawn = alloc_array(drawing->count + drawing->cut_count, sizeof *w->drawn);
    for (size_t i = 0; w->drawn && i < drawing->count + drawing->cut_count; i++) {
        const roberts_segment *segment = &drawing->segment[i];
        if (segment->state == ROBERTS_VISIBLE && strokes_has_place(w->s->options, segment, &line))
            w->drawn[w->drawn_count++] = (drawn_segment){segment->solid, i};
    }
    if (w->drawn_count > 1)
        qsort(w->drawn, w->drawn_count, sizeof *w->drawn, by_solid);
    return w->drawn != NULL;
}

static bool add_regions(const strokes *s, uint32_t v, unsigned kinds, targets *t)
{
    const roberts_drawing *drawing = s->view[v].drawing;
    const roberts_region_list *list = drawing->regions;
    const bool bodies = kinds & ROBERTS_LABEL_BODIES;
    region_search w = {.s = s, .to = t, .view = v};
    bool enough = !bodies || list_drawn(&w, drawing);
    for (size_t i = 0; enough && (kinds & ROBERTS_LABEL_FACES) && i < list->count; i++)
        enough = add_face(&w, list, &list->region[i]);
    for (size_t i = 0, end; enough && bodies && i < list->count; i = end) {
        for (end = i + 1; end < list->count && list->region[end].solid == list->region[i].solid;)
            end++;
        enough = add_body(&w, list, i, end);
    }
    free(w.line);
    free(w.drawn);
    return enough;
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
        }
    }
    t->count = kept;
}

/* ---- vertices on lines ---- */

/* A point of a view: on the page, mm, and its depth times the scale. */
static roberts_vec3 place_of(const page_view *view, roberts_vec2 at, double z)
{
    return (roberts_vec3){at.x, at.y, page_scale(&view->map) * z};
}

/* Is X on the segment, or within `touching` of it? */
static bool touches_segment(roberts_vec3 X, roberts_vec3 A, roberts_vec3 B, double touching)
{
    const roberts_vec3 d = vec3_sub(B, A), x = vec3_sub(X, A);
    const double t = lesser(1.0, greater(0.0, vec3_dot(x, d) / vec3_dot(d, d)));
    return vec3_length(vec3_sub(x, vec3_scale(t, d))) <= touching;
}

/* A vertex whose own lines are all hidden is not hidden if it lies on a visible line: the end of a height within a
 * solid, in the middle of an edge. item[0 .. count - 1]: targets of the view. False: no memory. */
static bool find_on_lines(const strokes *s, uint32_t v, target *item, size_t count)
{
    const page_view *view = &s->view[v];
    const roberts_drawing *drawing = view->drawing;
    const double touching = drawing->epsilon * page_scale(&view->map);
    const size_t segments = drawing->count + drawing->cut_count;
    roberts_vec3(*line)[2] = alloc_array(segments, sizeof *line);
    box3 *box = alloc_array(segments, sizeof *box);
    box_tree tree = {0};
    uint32_t lines = 0, root = 0;
    roberts_line class;
    bool enough = line && box;
    for (size_t i = 0; enough && i < segments && lines < ROBERTS_NONE; i++) {
        const roberts_segment *own = &drawing->segment[i];
        if (own->state != ROBERTS_VISIBLE || !strokes_has_place(s->options, own, &class))
            continue;
        const roberts_vec3 A = place_of(view, page_place(&view->map, own->p0), own->z0);
        const roberts_vec3 B = place_of(view, page_place(&view->map, own->p1), own->z1);
        line[lines][0] = A;
        line[lines][1] = B;
        box[lines++] =
            (box3){{lesser(A.x, B.x) - touching, lesser(A.y, B.y) - touching, lesser(A.z, B.z) - touching},
                   {greater(A.x, B.x) + touching, greater(A.y, B.y) + touching, greater(A.z, B.z) + touching}};
    }
    enough = enough && (lines == 0 || box_tree_add(&tree, box, lines, 0, &root));
    for (size_t i = 0; enough && i < count; i++) {
        if (item[i].kind != ROBERTS_LABEL_VERTICES || !item[i].is_back)
            continue;
        const roberts_vec3 X = place_of(view, item[i].at, item[i].z);
        const box3 at = {X, X};
        box_search near = box_search_begin(&tree, root, &at);
        for (uint32_t k; item[i].is_back && box_search_next(&near, &k);)
            item[i].is_back = !touches_segment(X, line[k][0], line[k][1], touching);
    }
    box_tree_free(&tree);
    free(line);
    free(box);
    return enough;
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
        if (drawing->regions && (kinds & ROBERTS_LABEL_AREAS) && !add_regions(s, v, kinds, t))
            return false;
    }
    unite(t);
    for (size_t i = 0, end; (kinds & ROBERTS_LABEL_VERTICES) && s->options->hidden && i < t->count; i = end) {
        for (end = i + 1; end < t->count && t->item[end].view == t->item[i].view;)
            end++;
        if (!find_on_lines(s, t->item[i].view, &t->item[i], end - i))
            return false;
    }
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
    const unsigned alike = kinds & ~(unsigned)(ROBERTS_LABEL_EDGES | ROBERTS_LABEL_NAMES);
    if ((alike & (alike - 1)) == 0)
        return "";
    return kind == ROBERTS_LABEL_VERTICES ? "v" : kind == ROBERTS_LABEL_FACES ? "f" : "b";
}

const char *target_text(const target *of, const roberts_draw_options *options, char number[NUMBER_SIZE])
{
    const roberts_lettering *lettering = &options->lettering;
    const char *name = find_name(lettering, of);
    if (!name && of->kind == ROBERTS_LABEL_BODIES && lettering->labels & ROBERTS_LABEL_NAMES && options->scene) {
        name = roberts_scene_name(options->scene, of->number);
        name = *name ? name : NULL;
    }
    if (name || !(lettering->labels & (unsigned)of->kind))
        return name;
    if (of->kind == ROBERTS_LABEL_EDGES)
        snprintf(number, NUMBER_SIZE, "%u-%u", (unsigned)of->number, (unsigned)of->other);
    else
        snprintf(number, NUMBER_SIZE, "%s%u", number_prefix(lettering->labels, of->kind), (unsigned)of->number);
    return number;
}
