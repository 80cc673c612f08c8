/* chain.c - pieces on the page become polylines.
 *
 * Places are stored in a hash: an end belongs to the first place found within PIECE_TOUCH of it. Cells are four times
 * as wide, so an end needs a neighbour cell only near a border. Then every piece is walked once. A connected figure
 * takes k polylines if 2 k of its places are odd, that is, an odd number of pieces ends there; and one closed polyline
 * if no place is odd (Euler). So walks start at odd places first, and the rest are closed lines. */
#include "draw/chain.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/bits.h"

#define NO_PLACE UINT32_MAX

enum {
    PLACE_CELL = 4,     /* units */
    LOOK_AT_MOST = 8,   /* of the pieces at a place, to find the one that goes straight on */
    ENDS_AT_A_TIME = 32 /* ends in a group, so that memory can be prefetched */
};

typedef struct place {
    page_point at;
    uint32_t next;        /* in the same cell of the hash */
    uint32_t start, left; /* its links in `leaving`: the first, and how many are still to be drawn */
} place;

typedef struct link {
    uint32_t from, to; /* places */
    bool drawn;        /* or dropped as a double of another link */
} link;

typedef struct net {
    uint32_t *head, bits; /* of the hash, 2^bits cells: the first place of each, or NO_PLACE */
    place *place;
    link *link;
    uint32_t *leaving; /* links by place, each at both of its places */
    uint32_t place_count, link_count;
} net;

/* ---- polylines ---- */

bool polylines_start(polylines *out)
{
    if (!array_reserve(&out->item, &out->room, out->count + 1, sizeof *out->item))
        return false;
    out->item[out->count++] = (polyline){.first = (uint32_t)out->point_count};
    return true;
}

bool polylines_append(polylines *out, page_point at)
{
    if (!array_reserve(&out->point, &out->point_room, out->point_count + 1, sizeof *out->point))
        return false;
    out->point[out->point_count++] = at;
    out->item[out->count - 1].count++;
    return true;
}

bool polylines_append_new(polylines *out, page_point at)
{
    bool ends_there = out->item[out->count - 1].count && page_is_same(out->point[out->point_count - 1], at);
    return ends_there || polylines_append(out, at);
}

bool polylines_copy(const polylines *from, size_t first, size_t end, polylines *out)
{
    for (size_t i = first; i < end; i++) {
        const polyline *line = &from->item[i];
        if (!polylines_start(out))
            return false;
        out->item[out->count - 1].closed = line->closed;
        out->item[out->count - 1].number = line->number;
        for (uint32_t k = 0; k < line->count; k++)
            if (!polylines_append(out, from->point[line->first + k]))
                return false;
    }
    return true;
}

bool polylines_extend(polylines *out, page_point at)
{
    if (out->item[out->count - 1].count < 2)
        return polylines_append(out, at); /* before the very first point, out->point is NULL */
    page_point *end = out->point + out->point_count;
    if (!page_is_between(end[-2], end[-1], at))
        return polylines_append(out, at);
    end[-1] = at;
    return true;
}

/* Closes a line that has returned to its start. Drops its first point if that lies on a straight line. */
static void finish_line(polylines *out)
{
    polyline *line = &out->item[out->count - 1];
    page_point *p = out->point + line->first;
    if (line->count < 4 || !page_is_same(p[0], p[line->count - 1]))
        return;
    line->closed = true;
    line->count--;
    out->point_count--;
    if (line->count > 3 && page_is_between(p[line->count - 1], p[0], p[1])) {
        memmove(p, p + 1, (line->count - 1) * sizeof *p);
        line->count--;
        out->point_count--;
    }
}

void polylines_free(polylines *p)
{
    free(p->point);
    free(p->item);
    *p = (polylines){0};
}

/* ---- in the order of the pieces ---- */

bool chain_in_order(const pieces *p, roberts_line line, polylines *out)
{
    bool open = false;
    for (size_t i = 0; i < p->count; i++) {
        if (p->item[i].line != line)
            continue;
        page_point a = page_rounded(p->item[i].a), b = page_rounded(p->item[i].b);
        if (page_is_same(a, b))
            continue;
        polyline *last = open ? &out->item[out->count - 1] : NULL;
        page_point *end = out->point + out->point_count;
        if (open && last->count == 2 && !page_is_same(end[-1], a) && !page_is_same(end[-1], b) &&
            (page_is_same(end[-2], a) || page_is_same(end[-2], b))) {
            page_point swap = end[-1]; /* draws the first piece the other way round */
            end[-1] = end[-2];
            end[-2] = swap;
        }
        if (open && last->count < CHAIN_POINTS_MAX && (page_is_same(end[-1], a) || page_is_same(end[-1], b))) {
            if (!polylines_extend(out, page_is_same(end[-1], a) ? b : a))
                return false;
            continue;
        }
        if (open)
            finish_line(out);
        open = true;
        if (!polylines_start(out) || !polylines_extend(out, a) || !polylines_extend(out, b))
            return false;
    }
    if (open)
        finish_line(out);
    return true;
}

bool chain_apart(const pieces *p, roberts_line line, polylines *out)
{
    for (size_t i = 0; i < p->count; i++) {
        page_point a = page_rounded(p->item[i].a), b = page_rounded(p->item[i].b);
        if (p->item[i].line != line || page_is_same(a, b))
            continue;
        if (!polylines_start(out) || !polylines_append(out, a) || !polylines_append(out, b))
            return false;
        out->item[out->count - 1].number = p->item[i].number;
    }
    return true;
}

/* ---- places ---- */

static uint32_t *net_cell(const net *n, int32_t x, int32_t y)
{
    uint64_t key = (uint64_t)(uint32_t)x << 32 | (uint32_t)y;
    return &n->head[(key * 0x9e3779b97f4a7c15u) >> (64 - n->bits)];
}

/* The cells that may hold the place of a point. */
typedef struct search {
    page_point at;
    uint32_t *cell[4]; /* may hold places within PIECE_TOUCH; the first is its own */
    int cells;
} search;

static search search_for(const net *n, roberts_vec2 p)
{
    search f = {.at = page_rounded(p)};
    int32_t x[2], y[2];
    int columns = page_cells(f.at.x, PLACE_CELL, x), rows = page_cells(f.at.y, PLACE_CELL, y);
    for (int i = 0; i < columns; i++)
        for (int k = 0; k < rows; k++)
            f.cell[f.cells++] = net_cell(n, x[i], y[k]);
    return f;
}

/* The first place within PIECE_TOUCH of a point, among `i` and those after it in its cell; NO_PLACE: there is none. */
static uint32_t find_in_cell(const net *n, page_point at, uint32_t i)
{
    while (i != NO_PLACE && !page_touches(n->place[i].at, at))
        i = n->place[i].next;
    return i;
}

static uint32_t net_place(net *n, const search *f)
{
    for (int k = 0; k < f->cells; k++) {
        uint32_t found = find_in_cell(n, f->at, *f->cell[k]);
        if (found != NO_PLACE)
            return found;
    }
    n->place[n->place_count] = (place){.at = f->at, .next = *f->cell[0]};
    return *f->cell[0] = n->place_count++;
}

static void net_free(net *n)
{
    free(n->head);
    free(n->place);
    free(n->link);
    free(n->leaving);
    *n = (net){0};
}

/* Room for `count` links. */
static bool net_init(net *n, size_t count)
{
    *n = (net){.bits = 4};
    while (n->bits < 31 && count >> n->bits)
        n->bits++;
    n->head = alloc_array((size_t)1 << n->bits, sizeof *n->head);
    n->place = alloc_array(count, 2 * sizeof *n->place);
    n->link = alloc_array(count, sizeof *n->link);
    n->leaving = alloc_array(count, 2 * sizeof *n->leaving);
    if (!n->head || !n->place || !n->link || !n->leaving)
        return false;
    memset(n->head, 0xff, ((size_t)1 << n->bits) * sizeof *n->head);
    return true;
}

/* Finds the places of some ends and links them, two by two. A piece whose ends have one place is too short to be seen,
 * and is left out. */
static void link_some(net *n, const search *f, size_t ends)
{
    for (size_t i = 0; i < ends; i++)
        for (int k = 0; k < f[i].cells; k++)
            if (*f[i].cell[k] != NO_PLACE)
                FETCH_AHEAD(&n->place[*f[i].cell[k]]);
    for (size_t i = 0; i < ends; i += 2) {
        uint32_t from = net_place(n, &f[i]), to = net_place(n, &f[i + 1]);
        if (from == to)
            continue;
        n->link[n->link_count++] = (link){.from = from, .to = to};
        n->place[from].left++;
        n->place[to].left++;
    }
}

static void add_links(net *n, const pieces *p, roberts_line line)
{
    search f[ENDS_AT_A_TIME];
    size_t ends = 0;
    for (size_t i = 0; i < p->count; i++) {
        if (p->item[i].line != line)
            continue;
        f[ends++] = search_for(n, p->item[i].a);
        f[ends++] = search_for(n, p->item[i].b);
        for (size_t e = ends - 2; e < ends; e++)
            for (int k = 0; k < f[e].cells; k++)
                FETCH_AHEAD(f[e].cell[k]);
        if (ends == ENDS_AT_A_TIME) {
            link_some(n, f, ends);
            ends = 0;
        }
    }
    link_some(n, f, ends);
    uint32_t total = 0;
    for (uint32_t i = 0; i < n->place_count; i++) {
        n->place[i].start = total;
        total += n->place[i].left;
        n->place[i].left = 0;
    }
    for (uint32_t i = 0; i < n->link_count; i++) {
        place *from = &n->place[n->link[i].from], *to = &n->place[n->link[i].to];
        n->leaving[from->start + from->left++] = i;
        n->leaving[to->start + to->left++] = i;
    }
}

static uint32_t other_end(const link *l, uint32_t from)
{
    return l->from == from ? l->to : l->from;
}

/* Keeps one of several links between the same two places: their pieces are so near each other that they count as
 * one. */
static void drop_doubles(net *n)
{
    for (uint32_t at = 0; at < n->place_count; at++) {
        const place *p = &n->place[at];
        uint32_t count = p->left < LOOK_AT_MOST ? p->left : LOOK_AT_MOST;
        for (uint32_t i = 1; i < count; i++)
            for (uint32_t k = 0; k < i; k++) {
                link *one = &n->link[n->leaving[p->start + i]], *other = &n->link[n->leaving[p->start + k]];
                one->drawn = one->drawn || (!other->drawn && other_end(one, at) == other_end(other, at));
            }
    }
}

/* ---- walks ---- */

/* Removes a link from the list of a place. The last link of the list takes its position. */
static void leave_out(net *n, uint32_t at, uint32_t index)
{
    place *p = &n->place[at];
    n->leaving[p->start + index] = n->leaving[p->start + --p->left];
}

/* Drops drawn links from the part of a place's list that the next choice examines. */
static void tidy(net *n, uint32_t at)
{
    const place *p = &n->place[at];
    for (uint32_t i = 0; i < p->left && i < LOOK_AT_MOST;)
        if (n->link[n->leaving[p->start + i]].drawn)
            leave_out(n, at, i);
        else
            i++;
}

/* The link at place `at` that best continues the direction from point `from`, as an index of the place's list. At the
 * start of a walk, where `from` is the place itself, the first link. */
static uint32_t straightest(const net *n, page_point from, uint32_t at)
{
    const place *p = &n->place[at];
    double ux = (double)p->at.x - from.x, uy = (double)p->at.y - from.y, best = -INFINITY;
    uint32_t chosen = 0;
    for (uint32_t i = 0; i < p->left && i < LOOK_AT_MOST; i++) {
        page_point to = n->place[other_end(&n->link[n->leaving[p->start + i]], at)].at;
        double vx = (double)to.x - p->at.x, vy = (double)to.y - p->at.y;
        double cosine = (ux * vx + uy * vy) / sqrt(vx * vx + vy * vy);
        if (cosine > best) {
            best = cosine;
            chosen = i;
        }
    }
    return chosen;
}

/* Walks from a place until no link is left there. */
static bool walk(net *n, uint32_t at, polylines *out)
{
    page_point from = n->place[at].at;
    if (!polylines_start(out) || !polylines_extend(out, from))
        return false;
    for (tidy(n, at); n->place[at].left; tidy(n, at)) {
        if (out->item[out->count - 1].count >= CHAIN_POINTS_MAX &&
            (!polylines_start(out) || !polylines_extend(out, n->place[at].at)))
            return false;
        uint32_t index = straightest(n, from, at), chosen = n->leaving[n->place[at].start + index];
        leave_out(n, at, index);
        n->link[chosen].drawn = true;
        from = n->place[at].at;
        at = other_end(&n->link[chosen], at);
        if (!polylines_extend(out, n->place[at].at))
            return false;
    }
    finish_line(out);
    return true;
}

/* Drops drawn links from a place's list and returns how many are left. */
static uint32_t count_left(net *n, uint32_t at)
{
    place *p = &n->place[at];
    for (uint32_t i = 0; i < p->left;)
        if (n->link[n->leaving[p->start + i]].drawn)
            leave_out(n, at, i);
        else
            i++;
    return p->left;
}

/* Starts at loose ends, so that where three links meet, the two that go straight on become one line. */
static bool walk_all(net *n, polylines *out)
{
    for (uint32_t i = 0; i < n->place_count; i++)
        if (count_left(n, i) == 1 && !walk(n, i, out))
            return false;
    for (uint32_t i = 0; i < n->place_count; i++)
        if (count_left(n, i) % 2 == 1 && !walk(n, i, out))
            return false;
    for (uint32_t i = 0; i < n->link_count; i++)
        if (!n->link[i].drawn && !walk(n, n->link[i].from, out))
            return false;
    return true;
}

bool chain_pieces(const pieces *p, roberts_line line, polylines *out)
{
    net n;
    size_t count = 0;
    for (size_t i = 0; i < p->count; i++)
        count += p->item[i].line == line;
    bool done = net_init(&n, count);
    if (done) {
        add_links(&n, p, line);
        drop_doubles(&n);
        done = walk_all(&n, out);
    }
    net_free(&n);
    return done;
}
