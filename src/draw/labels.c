/* labels.c - where labels go.
 *
 * A label may take one of several places (label_places.c). Each has a cost: the length of the lines that lie there
 * already, other labels near by, and its distance from the best place. Labels choose one by one, those with the fewest
 * places first; then each may choose again a few times, knowing the others. What is too narrow for its label gets a
 * leader line. Unless the size of letters is given, smaller ones are tried where the labels find no room. So the work
 * is bounded, and the result is always the same. */
#include "draw/labels.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/vec.h"
#include "draw/free_space.h"
#include "draw/label_places.h"

enum {
    PASSES = 5,
    MOST_UNDER = 3 /* labels that a place may lie on, until one of them is moved: then the work stays in proportion to
                      the labels even if most of them find no room */
};

/* mm: the least that counts as something. */
#define ANYTHING DBL_MIN

/* Costs, in mm of lines that a label lies on. */
static const double crowded = 1.0;   /* the most that a place costs for being near to another label */
static const double elsewhere = 1.5; /* for a place nearer to another vertex, or behind another line */
static const double touching = 2.0;  /* for a place with anything on it, however little: worse than any free place */
static const double on_label = 20.0; /* for a place on another label: then one of the two is left out */

/* Heights of letters: places whose boxes are no farther apart read like two lines of one text, or like two words. */
static const double apart_heights = 0.75;

/* Heights of letters: a line nearer than this to the label of a face or body looks like an accent or a fraction bar. */
static const double clear_heights = 0.5;
static const double near_line = 0.7; /* cost of such a place: rather one that is two rings from the middle */

/* The largest fraction of the labels that may be misplaced before smaller letters are tried. */
static const double most_misplaced = 0.05;

/* ---- where it goes ---- */

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
    return vec2_length(x, fmax(fmax(box->min.y - p.y, p.y - box->max.y), 0.0));
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
    if (l->of->kind != ROBERTS_LABEL_VERTICES && l->of->kind != ROBERTS_LABEL_EDGES)
        return false;
    const roberts_vec2 from = nearest_point(l->of, middle);
    const double own = box_distance(box, l->of->at), length = vec2_length(middle.x - from.x, middle.y - from.y);
    const double off = fmin(0.5 * p->gap / length, 1.0); /* its own lines do not count */
    const roberts_vec2 start = {from.x + off * (middle.x - from.x), from.y + off * (middle.y - from.y)};
    return (l->of->kind == ROBERTS_LABEL_VERTICES && space_to_next_box(p->vertices, box, l->of->point, own) < own) ||
           space_count_crossings(p->room, start, middle) > 0;
}

static bool is_area(const target *of)
{
    return of->kind & ROBERTS_LABEL_AREAS;
}

/* Is a line close to a box? */
static bool is_close(const placing *p, const space_box *box)
{
    const double more = clear_heights * p->height;
    const space_box wide = {{box->min.x - more, box->min.y - more}, {box->max.x + more, box->max.y + more}};
    return space_meets_line(p->room, &wide);
}

/* The cost of what is near by. Vertices and edges have lines of their own there. */
static double cost_of_neighbours(const placing *p, const label *l, const space_box *box, roberts_vec2 middle)
{
    const double apart = apart_heights * p->height, near = space_to_next_box(p->room, box, l->box, apart);
    return crowded * (1.0 - near / apart) + (is_elsewhere(p, l, box, middle) ? elsewhere : 0.0) +
           (is_area(l->of) && is_close(p, box) ? near_line : 0.0);
}

/* Finds the cheapest place, the first of several. False: there is none. */
static bool choose_place(const placing *p, label *l)
{
    double least = INFINITY;
    for (size_t i = 0, places = label_places(l->of); i < places; i++) {
        double cost;
        const roberts_vec2 middle = label_place(p, l, i, &cost);
        const space_box box = label_box(l, middle);
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

/* Enters the box of a label into the room. False: no memory. */
static bool place_box(const placing *p, label *l)
{
    const space_box box = label_box(l, l->middle);
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
        const space_box box = label_box(&l[i], l[i].middle);
        l[i].is_dropped = l[i].box == NO_BOX || space_load_of(r, &box, l[i].box, 0, INFINITY).boxes > 0;
        if (l[i].is_dropped && l[i].box != NO_BOX)
            space_drop_box(r, l[i].box);
    }
}

/* ---- leader lines ---- */

/* A face or body may be too narrow for its label. Then the label moves to a free place near by, and a leader line goes
 * from there to a dot in the face (ISO 128-22). It goes through no label and crosses no other leader line. */

enum {
    LEADERS_FEW = 20,  /* so many are no thicket */
    LEADERS_MOST = 100 /* labels that may ask for one: then the work is bounded */
};
static const double most_leaders = 0.4;         /* part of the labels: more would be a thicket */
static const double leader_crowded = 2.0;       /* the most that a place costs for being near to another label */
static const double leader_crossing = 1.0;      /* cost of each line that a leader line crosses */
static const double leader_on_face = 3.0;       /* cost of a place on a face that is seen, instead of the paper */
static const double leader_apart_heights = 3.0; /* heights of letters: other labels are near if they are nearer */
static const double dot_radius = 0.3;           /* mm */
static const double dot_apart = 0.5;            /* mm: a dot nearer than this to a line seems to be a point of it */

static bool lies_on_lines(const placing *p, const label *l)
{
    const space_box box = label_box(l, l->middle);
    return space_load_of(p->room, &box, l->box, UINT32_MAX, ANYTHING).mm > 0.0;
}

static bool needs_leader(const placing *p, const label *l)
{
    return is_area(l->of) && (l->is_dropped || lies_on_lines(p, l));
}

/* What a dot needs. */
static space_box dot_box(roberts_vec2 at)
{
    const double reach = dot_radius + dot_apart;
    return (space_box){{at.x - reach, at.y - reach}, {at.x + reach, at.y + reach}};
}

/* Does a label in `box`, and its leader line to `end`, keep off the labels, and off the leader lines of others? */
static bool leader_is_free(const placing *p, const label *l, const space_box *box, roberts_vec2 end, const label *list,
                           size_t count)
{
    if (space_line_meets_boxes(p->room, l->dot, end, UINT32_MAX))
        return false;
    const space_box own = dot_box(l->dot);
    for (size_t i = 0; i < count; i++) {
        const roberts_vec2 dot = list[i].dot, leader = list[i].leader;
        const space_box other = dot_box(dot);
        if (list[i].has_leader &&
            (space_lines_cross(l->dot, end, dot, leader) || space_line_meets_box(dot, leader, box) ||
             space_line_meets_box(dot, leader, &own) || space_line_meets_box(l->dot, end, &other)))
            return false;
    }
    return true;
}

/* What a place beyond a region costs: lines that the leader line crosses, or would cross beside its way; labels near
 * by, since what stands in another face seems to belong there. */
static double leader_cost(const placing *p, const label *l, const space_box *box, roberts_vec2 end)
{
    const roberts_vec2 at = l->dot;
    const double length = vec2_length(end.x - at.x, end.y - at.y), apart = leader_apart_heights * p->height;
    double crossed = 0.0;
    for (int side = -1; side <= 1; side++) {
        const roberts_vec2 off = {side * p->gap * (end.y - at.y) / length, side * p->gap * (at.x - end.x) / length};
        crossed += (double)space_count_crossings(p->room, (roberts_vec2){at.x + off.x, at.y + off.y},
                                                 (roberts_vec2){end.x + off.x, end.y + off.y});
    }
    return leader_crossing * crossed / 3.0 +
           leader_crowded * (1.0 - space_to_next_box(p->room, box, UINT32_MAX, apart) / apart) +
           (is_close(p, box) ? near_line : 0.0);
}

/* Does a point lie on a face that is seen? Regions have the same corners along a common border and do not overlap, so
 * all their rings may be taken together. */
static bool is_on_face(const page_view *view, roberts_vec2 at)
{
    const roberts_region_list *regions = view->drawing->regions;
    return page_rings_hold(regions->ring_count, regions->ring_start, regions->corner, page_picture(&view->map, at));
}

/* Where a leader line begins: in the middle of the region, or beside it if a line is there, a hidden one perhaps. */
static roberts_vec2 dot_place(const placing *p, const label *l)
{
    for (size_t i = 0, places = label_places(l->of); i < places; i++) {
        double cost;
        const roberts_vec2 at = label_place(p, l, i, &cost);
        const space_box box = dot_box(at);
        if (!(space_load_of(p->room, &box, UINT32_MAX, 0, ANYTHING).mm > 0.0))
            return at;
    }
    return l->of->at;
}

/* Moves a label, which is not in the room, to the cheapest free place with a leader line. Returns what that costs;
 * infinite: there is none. */
static double lead_out(const placing *p, label *l, const label *list, size_t count)
{
    double least = INFINITY;
    l->dot = dot_place(p, l);
    for (size_t i = 0; i < VERTEX_SIDES * LEADER_RINGS; i++) {
        double cost;
        roberts_vec2 end;
        const roberts_vec2 middle = label_leader_place(p, l, i, &end, &cost);
        const space_box box = label_box(l, middle);
        if (cost >= least || space_load_of(p->room, &box, UINT32_MAX, 0, ANYTHING).mm > 0.0)
            continue;
        cost += leader_cost(p, l, &box, end);
        if (cost < least && is_on_face(&p->view[l->of->view], middle))
            cost += leader_on_face;
        if (cost < least && leader_is_free(p, l, &box, end, list, count)) {
            least = cost;
            l->middle = middle;
            l->leader = end;
        }
    }
    l->has_leader = least < INFINITY;
    return least;
}

/* A label that needs a leader line, and what that would cost. */
typedef struct leader_wish {
    double cost;
    size_t label;
} leader_wish;

static int by_cost(const void *a, const void *b)
{
    const leader_wish *p = a, *q = b;
    return p->cost != q->cost ? (p->cost > q->cost) - (p->cost < q->cost)
                              : (p->label > q->label) - (p->label < q->label);
}

/* Finds a place with a leader line for label i, as it would be without the label where it is now. */
static double find_leader(const placing *p, label *l, size_t i, size_t count, label *led)
{
    *led = l[i];
    if (!l[i].is_dropped)
        space_drop_box(p->room, l[i].box);
    led->is_dropped = false;
    return lead_out(p, led, l, count);
}

/* Enters a label that has a box into the room again, where it was. */
static bool put_back(const placing *p, label *l)
{
    return l->is_dropped || place_box(p, l);
}

/* Gives leader lines to the first LEADERS_MOST labels that need them, cheapest first, but not to so many that they
 * become a thicket. False: no memory. */
static bool add_leaders(const placing *p, label *l, size_t count)
{
    leader_wish wish[LEADERS_MOST];
    size_t wishes = 0, left = (size_t)(most_leaders * (double)count);
    label led;
    left = left > LEADERS_FEW ? left : LEADERS_FEW;
    for (size_t i = 0; i < count && wishes < LEADERS_MOST; i++) {
        if (!needs_leader(p, &l[i]))
            continue;
        wish[wishes++] = (leader_wish){find_leader(p, l, i, count, &led), i};
        if (!put_back(p, &l[i]))
            return false;
    }
    qsort(wish, wishes, sizeof wish[0], by_cost);
    for (size_t k = 0; k < wishes && left > 0; k++) {
        label *own = &l[wish[k].label];
        if (find_leader(p, l, wish[k].label, count, &led) < INFINITY) {
            *own = led;
            left--;
        }
        if (!put_back(p, own))
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

/* Does a label lie on a line, or seem to belong elsewhere? What is hidden is behind lines anyway. */
static bool is_misplaced(const placing *p, const label *l)
{
    const space_box box = label_box(l, l->middle);
    return space_load_of(p->room, &box, l->box, 0, ANYTHING).mm > 0.0 ||
           (!l->of->is_back && is_elsewhere(p, l, &box, l->middle));
}

/* Is there room for all labels, and are nearly all of them in good places? */
static bool have_room(const placing *p, const label *l, size_t count)
{
    size_t misplaced = 0;
    if (count_dropped(l, count) > 0)
        return false;
    for (size_t i = 0; i < count; i++)
        misplaced += is_misplaced(p, &l[i]);
    return (double)misplaced <= most_misplaced * (double)count;
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

static bool add_note(strokes *s, const label *l, double height)
{
    const double depth = label_has_descender(l->text) ? LETTERS_DEPTH * height : 0.0;
    const text_line line = {.text = l->text,
                            .at = {l->middle.x, l->middle.y + (height - depth) / 2.0},
                            .height_mm = height,
                            .align = 0.5,
                            .along = TEXT_LEVEL};
    const roberts_name of = {.of = l->of->kind, .number = l->of->number, .other = l->of->other};
    const space_box box = label_box(l, l->middle);
    if (l->has_leader && !(notes_add_line(&s->notes, l->dot, l->leader, s->units_per_mm) &&
                           notes_add_dot(&s->notes, l->dot, dot_radius, s->units_per_mm)))
        return false;
    return strokes_take(s, &box) && notes_add_label(&s->notes, &line, &of, l->of->is_back);
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
    const roberts_page *page = &s->page;
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

bool labels_wanted(const strokes *s)
{
    return targets_kinds(&s->options->lettering) != 0;
}

/* Makes the labels with letters of this height, and finds their places. */
static bool try_height(placing *p, double height, const strokes *s, const targets *t, label *list, size_t *count)
{
    placing_set_height(p, s, height);
    *count = labels_make(p, s, t, list);
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
    const roberts_page *page = &s->page;
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
    placing p = placing_of(s);
    targets t = {0};
    label *list = NULL;
    size_t count = 0;
    p.room = r;
    bool done = targets_find(s, targets_kinds(lettering), &t) && enter_vertices(&p, s, &t) &&
                (list = alloc_array(t.count, sizeof *list)) != NULL && try_height(&p, s->label_mm, s, &t, list, &count);
    double smaller = label_smaller_height(s->options, s->label_mm);
    while (done && smaller > 0.0 && !have_room(&p, list, count)) {
        take_off(list, count, r);
        done = try_height(&p, smaller, s, &t, list, &count);
        smaller = label_smaller_height(s->options, smaller);
    }
    if (done)
        tell_dropped(lettering, list, count);
    for (size_t i = 0; i < count && done; i++)
        done = list[i].is_dropped || add_note(s, &list[i], p.height);
    s->label_mm = count > 0 ? p.height : 0.0;
    space_free(p.vertices);
    free(list);
    free(t.item);
    return done;
}
