/* triangulate.c - cuts the region that the lines of a border wind round into triangles.
 *
 * A sweep line moves over the nodes in the order of x, then y. Between two adjacent lines on it lies a region, filled
 * or not. The uncut part of a filled region is bounded on its left by a chain of nodes, which turns inward everywhere
 * except at its ends. A new node cuts off the triangles that it sees along the chain (S. Hertel, K. Mehlhorn, "Fast
 * triangulation of the plane with respect to simple polygons", Information and Control 64, 1985). This takes O(n log
 * n). Only adjacent lines are tested for crossings (M. I. Shamos, D. Hoey, "Geometric intersection problems", FOCS
 * 1976). If they cross, the crossing is recorded and one of the two lines is removed, so one sweep finds many
 * crossings; then nothing is cut. Every decision is the exact sign of a turn. So the triangles tile the filled region,
 * without overlaps or gaps. */
#include <stdlib.h>

#include "base/array.h"
#include "base/orient.h"
#include "base/search.h"
#include "model/face_pieces.h"

/* A node of a chain. */
typedef struct chain_link {
    uint32_t node;
    uint32_t down, up; /* ROBERTS_NONE: an end */
    uint32_t label;    /* label of the stretch that leads up from here: a line, or from border.count on a cut */
} chain_link;

/* The region above a line of the sweep, if it is filled. */
typedef struct open_region {
    uint32_t bottom, top; /* ends of its chain */
    uint32_t last;        /* where the sweep was last: the rightmost node of the chain */
} open_region;

typedef struct sweep_event {
    double x, y;
    uint32_t node;
} sweep_event;

typedef struct sweep {
    face_pieces *f;
    border *b;
    bool even_odd;
    bool crossed, broken; /* broken: the order contradicts itself, which exact signs exclude */
    sweep_order order;
    uint32_t (*end)[2];  /* [b->count] left and right node of each line */
    int32_t *winding;    /* [b->count] winding number directly above each line */
    open_region *region; /* [b->count] region directly above each line, if it is filled */
    sweep_event *event;
    uint32_t *start[2]; /* [nodes + 1] into line[]: 0 sorted by right end, 1 by left end */
    uint32_t *line[2];
    uint8_t *in_order; /* [b->count] */
    chain_link *link;
    size_t event_count, link_count, link_room;
    uint32_t cuts;
    int32_t inside; /* winding number of the region that is being cut */
} sweep;

static roberts_vec2 place(const sweep *s, uint32_t node)
{
    return s->f->node[node].at;
}

/* > 0: the node is above the line. */
static double side_of(const sweep *s, uint32_t line, uint32_t node)
{
    return orient2d(place(s, s->end[line][0]), place(s, s->end[line][1]), place(s, node));
}

static bool is_filled(const sweep *s, int32_t winding)
{
    return s->even_odd ? winding % 2 != 0 : winding != 0;
}

static int32_t winding_above(const sweep *s, uint32_t line)
{
    return line == ROBERTS_NONE ? 0 : s->winding[line];
}

/* Returns the change of the winding number from below a line to above it. */
static int32_t step_across(const sweep *s, uint32_t line)
{
    return s->b->item[line].v[0] == s->end[line][0] ? s->b->item[line].net : -s->b->item[line].net;
}

/* ---- preparation ----------------------------------------------------------------------------------------------- */

static int compare_events(const void *pa, const void *pb)
{
    const sweep_event *a = pa, *b = pb;
    if (a->x != b->x)
        return a->x < b->x ? -1 : 1;
    if (a->y != b->y)
        return a->y < b->y ? -1 : 1;
    return (a->node > b->node) - (a->node < b->node);
}

static bool comes_before(roberts_vec2 a, roberts_vec2 b)
{
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

/* Lists the lines by their right ends (k = 0) or left ends (k = 1). */
static void list_lines(sweep *s, int k)
{
    size_t nodes = s->f->node_count;
    uint32_t *start = s->start[k];
    for (size_t n = 0; n <= nodes; n++)
        start[n] = 0;
    for (size_t i = 0; i < s->b->count; i++)
        start[s->end[i][1 - k]]++;
    for (uint32_t n = 0, sum = 0; n <= nodes; n++) {
        sum += start[n];
        start[n] = sum;
    }
    for (uint32_t i = (uint32_t)s->b->count; i-- > 0;)
        s->line[k][--start[s->end[i][1 - k]]] = i;
}

static bool prepare_sweep(sweep *s)
{
    size_t lines = s->b->count, nodes = s->f->node_count;
    bool enough = sweep_order_start(&s->order, lines) && (s->end = alloc_array(lines, sizeof *s->end)) &&
                  (s->winding = alloc_array(lines, sizeof *s->winding)) &&
                  (s->region = alloc_array(lines, sizeof *s->region)) &&
                  (s->event = alloc_array(nodes, sizeof *s->event)) && (s->in_order = alloc_zeroed(lines, 1));
    for (int k = 0; enough && k < 2; k++)
        enough = (s->start[k] = alloc_array(nodes + 1, sizeof *s->start[k])) &&
                 (s->line[k] = alloc_array(lines, sizeof *s->line[k]));
    if (!enough)
        return false;
    for (size_t i = 0; i < lines; i++) {
        const border_line *own = &s->b->item[i];
        bool swap = comes_before(place(s, own->v[1]), place(s, own->v[0]));
        s->end[i][0] = own->v[swap];
        s->end[i][1] = own->v[!swap];
    }
    list_lines(s, 0);
    list_lines(s, 1);
    for (uint32_t n = 0; n < nodes; n++)
        if (s->start[0][n + 1] > s->start[0][n] || s->start[1][n + 1] > s->start[1][n])
            s->event[s->event_count++] = (sweep_event){place(s, n).x, place(s, n).y, n};
    if (s->event_count > 1)
        qsort(s->event, s->event_count, sizeof *s->event, compare_events);
    return true;
}

static void free_sweep(sweep *s)
{
    sweep_order_free(&s->order);
    free(s->end);
    free(s->winding);
    free(s->region);
    free(s->event);
    free(s->in_order);
    free(s->link);
    for (int k = 0; k < 2; k++) {
        free(s->start[k]);
        free(s->line[k]);
    }
}

/* ---- crossings ------------------------------------------------------------------------------------------------- */

static void take_out(sweep *s, uint32_t line)
{
    sweep_order_remove(&s->order, line);
    s->in_order[line] = 0;
}

/* Records a node that lies on a line. False: no memory. */
static bool note_touch(sweep *s, uint32_t line, uint32_t node)
{
    s->crossed = true;
    return border_add_stop(s->b, (border_stop){line, node, 0.0});
}

/* Does a line meet the one directly above it before the first right end of the two, or there without sharing it? If so,
 * records the crossing and removes the upper line; repeats until they do not meet. False: no memory. */
static bool check_neighbours(sweep *s, uint32_t low)
{
    while (low != ROBERTS_NONE) {
        uint32_t high = s->order.place[low].near[1];
        if (high == ROBERTS_NONE)
            return true;
        uint32_t a = s->end[low][1], b = s->end[high][1];
        if (a == b)
            return true;
        bool low_ends = comes_before(place(s, a), place(s, b));
        double side = low_ends ? -side_of(s, high, a) : side_of(s, low, b);
        if (side > 0.0)
            return true;
        s->crossed = true;
        if (!(side == 0.0 ? note_touch(s, low_ends ? high : low, low_ends ? a : b)
                          : border_add_crossing(s->f, s->b, low, high)))
            return false;
        take_out(s, high);
    }
    return true;
}

/* Finds the highest line below a node. Lines that pass through the node are recorded and removed. False: no memory. */
static bool find_below(sweep *s, uint32_t node, uint32_t *below)
{
    uint32_t at = s->order.root;
    *below = ROBERTS_NONE;
    while (at != ROBERTS_NONE) {
        bool above = side_of(s, at, node) > 0.0;
        *below = above ? at : *below;
        at = s->order.place[at].child[above];
    }
    for (bool first = true;; first = false) {
        uint32_t next = sweep_order_above(&s->order, *below);
        if (next == ROBERTS_NONE || side_of(s, next, node) != 0.0)
            return first || check_neighbours(s, *below);
        if (!note_touch(s, next, node))
            return false;
        take_out(s, next);
    }
}

/* ---- chains ---------------------------------------------------------------------------------------------------- */

static uint32_t add_link(sweep *s, uint32_t node)
{
    if (!array_reserve(&s->link, &s->link_room, s->link_count + 1, sizeof *s->link))
        return ROBERTS_NONE;
    s->link[s->link_count] = (chain_link){node, ROBERTS_NONE, ROBERTS_NONE, 0};
    return (uint32_t)s->link_count++;
}

static uint32_t new_cut(sweep *s)
{
    return (uint32_t)s->b->count + s->cuts++;
}

static bool add_triangle(sweep *s, const uint32_t node[3], const uint32_t label[3])
{
    face_pieces *f = s->f;
    if (!array_reserve(&f->piece, &f->piece_room, f->piece_count + 1, sizeof *f->piece))
        return false;
    face_piece *t = &f->piece[f->piece_count++];
    t->count = 3;
    t->winding = s->inside;
    for (int i = 0; i < 3; i++) {
        t->node[i] = node[i];
        t->label[i] = label[i];
    }
    return true;
}

static bool turns_left(const sweep *s, uint32_t a, uint32_t b, uint32_t c)
{
    return orient2d(place(s, a), place(s, b), place(s, c)) > 0.0;
}

/* Cuts off the triangles that the chain's uppermost node, the newest, sees. False: no memory. */
static bool cut_down(sweep *s, uint32_t own)
{
    chain_link *link = s->link;
    uint32_t v = link[own].node, c1 = link[own].down, c2 = c1 != ROBERTS_NONE ? link[c1].down : ROBERTS_NONE;
    for (; c2 != ROBERTS_NONE && turns_left(s, link[c2].node, v, link[c1].node); c1 = c2, c2 = link[c2].down) {
        uint32_t cut = new_cut(s);
        if (!add_triangle(s, (uint32_t[]){link[c2].node, v, link[c1].node},
                          (uint32_t[]){cut, link[c1].label, link[c2].label}))
            return false;
        link[c2].label = cut;
        link[c2].up = own;
        link[own].down = c2;
    }
    return true;
}

/* Cuts off the triangles that the chain's lowest node, the newest, sees. last: the label of the line from it to the
 * chain's other end, if the region ends here. False: no memory. */
static bool cut_up(sweep *s, uint32_t own, uint32_t last)
{
    chain_link *link = s->link;
    uint32_t v = link[own].node, c1 = link[own].up, c2 = c1 != ROBERTS_NONE ? link[c1].up : ROBERTS_NONE;
    for (; c2 != ROBERTS_NONE && turns_left(s, link[c1].node, v, link[c2].node); c1 = c2, c2 = link[c2].up) {
        uint32_t cut = last != ROBERTS_NONE && link[c2].up == ROBERTS_NONE ? last : new_cut(s);
        if (!add_triangle(s, (uint32_t[]){link[c1].node, v, link[c2].node},
                          (uint32_t[]){link[own].label, cut, link[c1].label}))
            return false;
        link[own].label = cut;
        link[own].up = c2;
        link[c2].down = own;
    }
    s->broken = s->broken || (last != ROBERTS_NONE && c2 != ROBERTS_NONE);
    return true;
}

/* Extends the region along its upper line to this node. False: no memory. */
static bool extend_top(sweep *s, open_region *r, uint32_t node, uint32_t label)
{
    uint32_t own = add_link(s, node);
    if (own == ROBERTS_NONE)
        return false;
    s->link[own].down = r->top;
    s->link[r->top].up = own;
    s->link[r->top].label = label;
    r->top = r->last = own;
    return cut_down(s, own);
}

/* Extends the region along its lower line to this node. last: as in cut_up(). False: no memory. */
static bool extend_bottom(sweep *s, open_region *r, uint32_t node, uint32_t label, uint32_t last)
{
    uint32_t own = add_link(s, node);
    if (own == ROBERTS_NONE)
        return false;
    s->link[own].up = r->bottom;
    s->link[own].label = label;
    s->link[r->bottom].down = own;
    r->bottom = r->last = own;
    return cut_up(s, own, last);
}

/* Splits a region at a node inside it, with a cut to the chain's rightmost node, which it sees. *high: the part above
 * the node; r becomes the part below. False: no memory. */
static bool split(sweep *s, open_region *r, uint32_t node, open_region *high)
{
    uint32_t low_own = add_link(s, node), copy = add_link(s, s->link[r->last].node), own = add_link(s, node);
    if (low_own == ROBERTS_NONE || copy == ROBERTS_NONE || own == ROBERTS_NONE)
        return false;
    chain_link *link = s->link;
    uint32_t at = r->last, cut = new_cut(s);
    link[copy] = (chain_link){link[at].node, own, link[at].up, link[at].label};
    if (link[at].up != ROBERTS_NONE)
        link[link[at].up].down = copy;
    link[own].up = copy;
    link[own].label = cut;
    *high = (open_region){own, r->top == at ? copy : r->top, own};
    link[at].up = low_own;
    link[at].label = cut;
    link[low_own].down = at;
    r->top = r->last = low_own;
    return cut_down(s, low_own) && cut_up(s, own, ROBERTS_NONE);
}

/* Merges two regions: the chain of the lower one ends at the node where that of the upper one begins. */
static void merge_open_regions(sweep *s, open_region *r, const open_region *high)
{
    chain_link *link = s->link;
    uint32_t dropped = high->bottom, own = r->top;
    link[own].up = link[dropped].up;
    link[own].label = link[dropped].label;
    if (link[own].up != ROBERTS_NONE) {
        link[link[own].up].down = own;
        r->top = high->top;
    }
    r->last = own;
}

static bool begin_region(sweep *s, open_region *r, uint32_t node)
{
    uint32_t own = add_link(s, node);
    *r = (open_region){own, own, own};
    return own != ROBERTS_NONE;
}

/* ---- the sweep ------------------------------------------------------------------------------------------------- */

/* Closes the regions between the lines that end here, and extends the regions around them to the node. The lines run
 * from `first` to `last` in the order. False: no memory. */
static bool end_regions(sweep *s, uint32_t node, uint32_t below, uint32_t first, uint32_t last)
{
    s->inside = winding_above(s, below);
    if (is_filled(s, s->inside) && !extend_top(s, &s->region[below], node, first))
        return false;
    for (uint32_t i = first; i != last; i = s->order.place[i].near[1]) {
        s->inside = s->winding[i];
        if (is_filled(s, s->inside) && !extend_bottom(s, &s->region[i], node, i, s->order.place[i].near[1]))
            return false;
    }
    s->inside = s->winding[last];
    return !is_filled(s, s->inside) || extend_bottom(s, &s->region[last], node, last, ROBERTS_NONE);
}

/* Inserts the lines that leave the node into the order, above `below`. If two coincide, the longer one is divided and
 * removed. False: no memory. */
static bool insert_leaving(sweep *s, uint32_t node, uint32_t below)
{
    for (uint32_t k = s->start[1][node]; k < s->start[1][node + 1]; k++) {
        uint32_t line = s->line[1][k], under = below, to = s->end[line][1];
        uint32_t at = s->order.root;
        double side = 0.0;
        while (at != ROBERTS_NONE) { /* the lines in the tree leave here too, or are clearly below or above */
            bool leaves = s->end[at][0] == node;
            side = side_of(s, at, leaves ? to : node);
            if (leaves && side == 0.0)
                break;
            under = side > 0.0 ? at : under;
            at = s->order.place[at].child[side > 0.0];
        }
        if (at == ROBERTS_NONE) {
            sweep_order_insert(&s->order, line, under);
            s->in_order[line] = 1;
            continue;
        }
        uint32_t end = s->end[at][1];
        bool shorter = comes_before(place(s, to), place(s, end));
        if (!note_touch(s, shorter ? at : line, shorter ? to : end))
            return false;
        if (!shorter)
            continue;
        under = s->order.place[at].near[0];
        take_out(s, at);
        sweep_order_insert(&s->order, line, under);
        s->in_order[line] = 1;
    }
    return true;
}

/* Begins the regions above the lines that leave the node, and extends the regions around them. had: lines ended here;
 * high: the region above the uppermost of them. False: no memory. */
static bool begin_regions(sweep *s, uint32_t node, uint32_t below, bool had, open_region high)
{
    int32_t winding = winding_above(s, below), outer = winding;
    uint32_t line = sweep_order_above(&s->order, below);
    if (line == ROBERTS_NONE || s->end[line][0] != node) {
        if (is_filled(s, outer))
            merge_open_regions(s, &s->region[below], &high);
        return true;
    }
    s->inside = outer;
    if (!had && is_filled(s, outer) && !split(s, &s->region[below], node, &high))
        return false;
    for (bool more = true; more;) {
        uint32_t next = s->order.place[line].near[1];
        winding += step_across(s, line);
        s->winding[line] = winding;
        more = next != ROBERTS_NONE && s->end[next][0] == node;
        if (!more)
            s->region[line] = high;
        else if (is_filled(s, winding) && !begin_region(s, &s->region[line], node))
            return false;
        line = more ? next : line;
    }
    return true;
}

/* Finds the lines that end at a node, from *first to *last in the order; ROBERTS_NONE: none. */
static void find_ending(sweep *s, uint32_t node, uint32_t *first, uint32_t *last)
{
    size_t count = 0, met = 1;
    *first = *last = ROBERTS_NONE;
    for (uint32_t k = s->start[0][node]; k < s->start[0][node + 1]; k++)
        if (s->in_order[s->line[0][k]]) {
            *first = *last = s->line[0][k];
            count++;
        }
    if (count == 0)
        return;
    for (uint32_t i; (i = s->order.place[*first].near[0]) != ROBERTS_NONE && s->end[i][1] == node; met++)
        *first = i;
    for (uint32_t i; (i = s->order.place[*last].near[1]) != ROBERTS_NONE && s->end[i][1] == node; met++)
        *last = i;
    s->broken = s->broken || met != count;
}

/* Processes one node. False: no memory. */
static bool meet(sweep *s, uint32_t node)
{
    uint32_t first, last, below;
    open_region high = {ROBERTS_NONE, ROBERTS_NONE, ROBERTS_NONE};
    find_ending(s, node, &first, &last);
    bool had = first != ROBERTS_NONE;
    if (had)
        below = s->order.place[first].near[0];
    else if (!find_below(s, node, &below))
        return false;
    if (had && !s->crossed && !s->broken) {
        if (!end_regions(s, node, below, first, last))
            return false;
        high = s->region[last];
    }
    for (uint32_t k = s->start[0][node]; k < s->start[0][node + 1]; k++)
        if (s->in_order[s->line[0][k]])
            take_out(s, s->line[0][k]);
    if (!insert_leaving(s, node, below))
        return false;
    if (!s->crossed && !s->broken && !begin_regions(s, node, below, had, high))
        return false;
    if (below != ROBERTS_NONE && !check_neighbours(s, below))
        return false;
    for (uint32_t k = s->start[1][node]; k < s->start[1][node + 1]; k++)
        if (s->in_order[s->line[1][k]] && !check_neighbours(s, s->line[1][k]))
            return false;
    return true;
}

tiling face_pieces_triangulate(face_pieces *f, border *b, bool even_odd)
{
    sweep s = {.f = f, .b = b, .even_odd = even_odd};
    bool enough = prepare_sweep(&s);
    f->piece_count = 0;
    b->stop_count = 0;
    for (size_t i = 0; enough && i < s.event_count; i++)
        enough = meet(&s, s.event[i].node);
    tiling found = !enough ? TILING_NO_MEMORY : s.crossed ? TILING_CROSSED : s.broken ? TILING_BROKEN : TILING_DONE;
    free_sweep(&s);
    if (found != TILING_DONE)
        f->piece_count = 0;
    return found;
}
