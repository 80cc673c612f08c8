/* planar_map.c - see planar_map.h.
 *
 * What is near what is found by halving: a box of lines and nodes is cut in two across the axis at which fewer of them
 * are on both sides, until few are left, which are compared with one another. A fan of lines in one node needs no
 * halving at all. This adapts to pictures that are crowded in places, and takes O(n log n) time unless very many long
 * lines run side by side aslant. */
#include "hide/planar_map.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/sort.h"
#include "model/face_pieces.h"

enum {
    FEW = 12,         /* things in a box that are compared with one another */
    IDLE_HALVINGS = 8 /* in a row that hardly part anything: then all are compared */
};

/* Rounds of division. From the second one on, nodes must be nearer by half to divide a line, so that an end is
 * reached. */
enum { MOST_ROUNDS = 60 };

/* The numbers of nodes, and those of both ends of all lines, are 32 bits wide. */
#define NODES_MOST ((size_t)(UINT32_MAX / 4))

/* A line or a node, or the part of a line that a box holds. */
typedef struct map_item {
    roberts_vec2 a, b;   /* a node: both are its place */
    uint32_t line, node; /* one of them; the other is ROBERTS_NONE */
} map_item;

/* A node that a line has to pass through. */
typedef struct map_stop {
    uint32_t line, node;
    double t; /* along the line, times its length */
} map_stop;

typedef struct map_search {
    planar_map *m;
    double touching; /* what is nearer than this is joined: less in each round */
    double margin;   /* a box holds what is nearer than this: above rounding, the same in each round */
    map_item *item;  /* [count] boxes within boxes: those of the box at work come last */
    map_stop *stop;  /* [stop_count] */
    uint32_t *same;  /* [same_room] the node that a node becomes, or a node on the way to it */
    size_t count, room, stop_count, stop_room, same_room;
    bool joined, lost; /* lost: no memory */
} map_search;

typedef struct map_box {
    roberts_vec2 low, high;
} map_box;

/* ---- input ----------------------------------------------------------------------------------------------------- */

bool planar_map_add(planar_map *m, roberts_vec2 a, roberts_vec2 b)
{
    if (a.x == b.x && a.y == b.y)
        return true;
    if (m->node_count > NODES_MOST || !array_reserve(&m->node, &m->node_room, m->node_count + 2, sizeof *m->node) ||
        !array_reserve(&m->line, &m->line_room, m->line_count + 1, sizeof *m->line))
        return false;
    m->line[m->line_count][0] = (uint32_t)m->node_count;
    m->line[m->line_count++][1] = (uint32_t)m->node_count + 1;
    m->node[m->node_count++] = a;
    m->node[m->node_count++] = b;
    return true;
}

static size_t slot_of(roberts_vec2 p, size_t mask)
{
    uint64_t x, y;
    p.x += 0.0; /* -0 becomes 0 */
    p.y += 0.0;
    memcpy(&x, &p.x, sizeof x);
    memcpy(&y, &p.y, sizeof y);
    uint64_t h = (x ^ x >> 32) * 0x9e3779b97f4a7c15u + (y ^ y >> 29) * 0xc2b2ae3d27d4eb4fu;
    return (size_t)(h ^ h >> 31) & mask;
}

/* Makes nodes in the very same place one. Most ends are those of several lines. False: no memory. */
static bool join_equal(planar_map *m)
{
    size_t size = 16, kept = 0;
    while (size < 2 * m->node_count)
        size *= 2;
    uint32_t *slot = alloc_array(size, sizeof *slot), *now = alloc_array(m->node_count, sizeof *now);
    bool enough = slot && now;
    for (size_t i = 0; enough && i < size; i++)
        slot[i] = ROBERTS_NONE;
    for (size_t n = 0; enough && n < m->node_count; n++) {
        roberts_vec2 p = m->node[n];
        size_t at = slot_of(p, size - 1);
        while (slot[at] != ROBERTS_NONE && !(m->node[slot[at]].x == p.x && m->node[slot[at]].y == p.y))
            at = (at + 1) & (size - 1);
        if (slot[at] == ROBERTS_NONE) {
            m->node[kept] = p;
            slot[at] = (uint32_t)kept++;
        }
        now[n] = slot[at];
    }
    for (size_t i = 0; enough && i < m->line_count; i++)
        for (int k = 0; k < 2; k++)
            m->line[i][k] = now[m->line[i][k]];
    if (enough)
        m->node_count = kept;
    free(slot);
    free(now);
    return enough;
}

/* Puts the lines in order, each once, and leaves out those without length. False: no memory. */
static bool unite_lines(planar_map *m)
{
    uint32_t *key = alloc_array(m->line_count, sizeof *key), *order = alloc_array(m->line_count, sizeof *order);
    uint64_t *line = alloc_array(m->line_count, sizeof *line);
    bool enough = key && order && line;
    for (size_t i = 0; enough && i < m->line_count; i++) {
        const uint32_t *v = m->line[i];
        key[i] = v[0] < v[1] ? v[0] : v[1];
    }
    enough = enough && radix_order(key, (uint32_t)m->line_count, order);
    size_t count = m->line_count;
    for (size_t i = 0; enough && i < count; i++) {
        const uint32_t *v = m->line[order[i]];
        line[i] = v[0] < v[1] ? (uint64_t)v[0] << 32 | v[1] : (uint64_t)v[1] << 32 | v[0];
    }
    for (size_t i = 0, k; enough && i < count; i = k) {
        for (k = i + 1; k < count && line[k] >> 32 == line[i] >> 32;)
            k++;
        if (k - i <= 32) {
            SORT_FEW(uint64_t, line + i, k - i, *a > *b);
        } else {
            qsort(line + i, k - i, sizeof *line, compare_u64);
        }
    }
    size_t to = 0;
    for (size_t i = 0; enough && i < count; i++) {
        uint32_t from = (uint32_t)(line[i] >> 32), end = (uint32_t)line[i];
        if (from == end || (i > 0 && line[i] == line[i - 1]))
            continue;
        m->line[to][0] = from;
        m->line[to++][1] = end;
    }
    if (enough)
        m->line_count = to;
    free(key);
    free(order);
    free(line);
    return enough;
}

/* ---- what is near what ----------------------------------------------------------------------------------------- */

static uint32_t now_of(map_search *s, uint32_t node)
{
    while (s->same[node] != node) {
        s->same[node] = s->same[s->same[node]];
        node = s->same[node];
    }
    return node;
}

static void join_nodes(map_search *s, uint32_t p, uint32_t q)
{
    p = now_of(s, p);
    q = now_of(s, q);
    s->joined = s->joined || p != q;
    s->same[p > q ? p : q] = p < q ? p : q;
}

static void add_stop(map_search *s, uint32_t line, uint32_t node)
{
    if (!array_reserve(&s->stop, &s->stop_room, s->stop_count + 1, sizeof *s->stop)) {
        s->lost = true;
        return;
    }
    s->stop[s->stop_count++] = (map_stop){.line = line, .node = node};
}

static double product(roberts_vec2 a, roberts_vec2 b)
{
    return a.x * b.x + a.y * b.y;
}

static roberts_vec2 between(roberts_vec2 a, roberts_vec2 b)
{
    return (roberts_vec2){b.x - a.x, b.y - a.y};
}

/* Does P touch what is between A and B? */
static bool is_near(roberts_vec2 A, roberts_vec2 B, roberts_vec2 P, double touching)
{
    if (P.x < lesser(A.x, B.x) - touching || P.x > greater(A.x, B.x) + touching || P.y < lesser(A.y, B.y) - touching ||
        P.y > greater(A.y, B.y) + touching)
        return false;
    roberts_vec2 d = between(A, B), p = between(A, P);
    double length2 = product(d, d), t = product(p, d) / length2;
    t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
    roberts_vec2 off = {p.x - t * d.x, p.y - t * d.y};
    return product(off, off) <= touching * touching;
}

static void compare_with_node(map_search *s, uint32_t line, uint32_t node)
{
    const uint32_t *v = s->m->line[line];
    if (v[0] != node && v[1] != node && is_near(s->m->node[v[0]], s->m->node[v[1]], s->m->node[node], s->touching))
        add_stop(s, line, node);
}

static void compare_nodes(map_search *s, uint32_t p, uint32_t q)
{
    roberts_vec2 d = between(s->m->node[p], s->m->node[q]);
    if (product(d, d) <= s->touching * s->touching)
        join_nodes(s, p, q);
}

/* Notes where two lines cross, unless an end of one touches the other, or the place is in another box. */
static void compare_lines(map_search *s, uint32_t i, uint32_t j, const map_box *box)
{
    planar_map *m = s->m;
    const uint32_t *v = m->line[i], *w = m->line[j];
    if (v[0] == w[0] || v[0] == w[1] || v[1] == w[0] || v[1] == w[1])
        return;
    roberts_vec2 A = m->node[v[0]], B = m->node[v[1]], C = m->node[w[0]], D = m->node[w[1]];
    if (lesser(A.x, B.x) > greater(C.x, D.x) || lesser(C.x, D.x) > greater(A.x, B.x) ||
        lesser(A.y, B.y) > greater(C.y, D.y) || lesser(C.y, D.y) > greater(A.y, B.y))
        return;
    double c = piece_turn(A, B, C), d = piece_turn(A, B, D);
    if (!((c > 0.0 && d < 0.0) || (c < 0.0 && d > 0.0)))
        return;
    double a = piece_turn(C, D, A), b = piece_turn(C, D, B);
    if (!((a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0)))
        return;
    if (is_near(A, B, C, s->touching) || is_near(A, B, D, s->touching) || is_near(C, D, A, s->touching) ||
        is_near(C, D, B, s->touching))
        return;
    double t = a / (a - b);
    roberts_vec2 X = {A.x + t * (B.x - A.x), A.y + t * (B.y - A.y)};
    if (!(X.x >= box->low.x && X.x < box->high.x && X.y >= box->low.y && X.y < box->high.y))
        return;
    if (!array_reserve(&m->node, &m->node_room, m->node_count + 1, sizeof *m->node) ||
        !array_reserve(&s->same, &s->same_room, m->node_count + 1, sizeof *s->same)) {
        s->lost = true;
        return;
    }
    uint32_t node = (uint32_t)m->node_count++;
    m->node[node] = X;
    s->same[node] = node;
    add_stop(s, i, node);
    add_stop(s, j, node);
}

static void compare_all(map_search *s, size_t first, size_t end, const map_box *box)
{
    for (size_t i = first; i < end; i++)
        for (size_t k = i + 1; k < end; k++) {
            const map_item *p = &s->item[i], *q = &s->item[k];
            if (p->line != ROBERTS_NONE && q->line != ROBERTS_NONE)
                compare_lines(s, p->line, q->line, box);
            else if (p->line != ROBERTS_NONE)
                compare_with_node(s, p->line, q->node);
            else if (q->line != ROBERTS_NONE)
                compare_with_node(s, q->line, p->node);
            else
                compare_nodes(s, p->node, q->node);
        }
}

/* Do all lines have one node in common, and is there no other node? */
static bool is_fan(const map_search *s, size_t first, size_t end)
{
    uint32_t v[2] = {ROBERTS_NONE, ROBERTS_NONE};
    for (size_t i = first; i < end; i++) {
        const map_item *p = &s->item[i];
        uint32_t own[2] = {p->node, p->node};
        if (p->line != ROBERTS_NONE)
            memcpy(own, s->m->line[p->line], sizeof own);
        if (i == first)
            memcpy(v, own, sizeof own);
        for (int k = 0; k < 2; k++)
            if (v[k] != own[0] && v[k] != own[1])
                v[k] = ROBERTS_NONE;
        if (v[0] == ROBERTS_NONE && v[1] == ROBERTS_NONE)
            return false;
    }
    return true;
}

/* ---- halving --------------------------------------------------------------------------------------------------- */

static double along(roberts_vec2 p, int axis)
{
    return axis ? p.y : p.x;
}

/* The point of a line at `at` of the axis, between p and q. */
static roberts_vec2 cut_at(const map_search *s, uint32_t line, int axis, double at, roberts_vec2 p, roberts_vec2 q)
{
    roberts_vec2 A = s->m->node[s->m->line[line][0]], B = s->m->node[s->m->line[line][1]];
    double t = (at - along(A, axis)) / (along(B, axis) - along(A, axis));
    if (axis) {
        double x = A.x + t * (B.x - A.x);
        return (roberts_vec2){x < lesser(p.x, q.x) ? lesser(p.x, q.x) : lesser(x, greater(p.x, q.x)), at};
    }
    double y = A.y + t * (B.y - A.y);
    return (roberts_vec2){at, y < lesser(p.y, q.y) ? lesser(p.y, q.y) : lesser(y, greater(p.y, q.y))};
}

/* What of an item is on one side: -1 below `at`, 1 above it. False: nothing, not even near it. */
static bool part_of(const map_search *s, const map_item *all, int axis, double at, int side, map_item *part)
{
    double a = side * (along(all->a, axis) - at), b = side * (along(all->b, axis) - at);
    if (greater(a, b) < -s->margin)
        return false;
    *part = *all;
    if (all->line == ROBERTS_NONE || lesser(a, b) >= 0.0)
        return true;
    if (a <= 0.0 && b <= 0.0)
        *(a < b ? &part->a : &part->b) = a < b ? all->b : all->a; /* only its end is near */
    else
        *(a < 0.0 ? &part->a : &part->b) = cut_at(s, all->line, axis, at, all->a, all->b);
    return true;
}

/* How many of the items would be listed again after a cut. */
static size_t count_both(const map_search *s, size_t first, size_t end, int axis, double at)
{
    size_t both = 0;
    for (size_t i = first; i < end; i++) {
        double a = along(s->item[i].a, axis) - at, b = along(s->item[i].b, axis) - at;
        both += lesser(a, b) <= s->margin && greater(a, b) >= -s->margin;
    }
    return both;
}

static void visit(map_search *s, size_t first, size_t end, map_box box, int idle)
{
    if (end - first < 2 || is_fan(s, first, end))
        return;
    map_box own = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (size_t i = first; i < end; i++) {
        const map_item *p = &s->item[i];
        own.low = (roberts_vec2){lesser(own.low.x, lesser(p->a.x, p->b.x)), lesser(own.low.y, lesser(p->a.y, p->b.y))};
        own.high =
            (roberts_vec2){greater(own.high.x, greater(p->a.x, p->b.x)), greater(own.high.y, greater(p->a.y, p->b.y))};
    }
    double size = greater(own.high.x - own.low.x, own.high.y - own.low.y);
    if (end - first <= FEW || idle >= IDLE_HALVINGS || !(size > 8.0 * s->margin)) {
        compare_all(s, first, end, &box);
        return;
    }
    double at[2] = {0.5 * (own.low.x + own.high.x), 0.5 * (own.low.y + own.high.y)};
    size_t both[2] = {count_both(s, first, end, 0, at[0]), count_both(s, first, end, 1, at[1])};
    if (!(own.high.x - own.low.x > 4.0 * s->margin))
        both[0] = SIZE_MAX;
    if (!(own.high.y - own.low.y > 4.0 * s->margin))
        both[1] = SIZE_MAX;
    int axis = both[1] < both[0];
    idle = 4 * both[axis] > 3 * (end - first) ? idle + 1 : 0;
    for (int side = -1; side <= 1 && !s->lost; side += 2) {
        map_box half = box;
        if (axis)
            *(side < 0 ? &half.high.y : &half.low.y) = at[1];
        else
            *(side < 0 ? &half.high.x : &half.low.x) = at[0];
        size_t from = s->count;
        if (!array_reserve(&s->item, &s->room, from + (end - first), sizeof *s->item)) {
            s->lost = true;
            return;
        }
        for (size_t i = first; i < end; i++)
            s->count += part_of(s, &s->item[i], axis, at[axis], side, &s->item[s->count]);
        visit(s, from, s->count, half, idle);
        s->count = from;
    }
}

/* Finds all stops, and the nodes that touch. False: no memory. */
static bool search_all(map_search *s)
{
    planar_map *m = s->m;
    const map_box all = {{-INFINITY, -INFINITY}, {INFINITY, INFINITY}};
    uint8_t *used = alloc_zeroed(m->node_count, 1);
    s->count = s->stop_count = 0;
    s->joined = false;
    if (!used || !array_reserve(&s->item, &s->room, 2 * (m->line_count + m->node_count), sizeof *s->item) ||
        !array_reserve(&s->same, &s->same_room, m->node_count, sizeof *s->same)) {
        free(used);
        return false;
    }
    for (uint32_t i = 0; i < m->line_count; i++) {
        const uint32_t *v = m->line[i];
        s->item[s->count++] = (map_item){m->node[v[0]], m->node[v[1]], i, ROBERTS_NONE};
        used[v[0]] = used[v[1]] = 1;
    }
    for (uint32_t n = 0; n < m->node_count; n++) {
        s->same[n] = n;
        if (used[n])
            s->item[s->count++] = (map_item){m->node[n], m->node[n], ROBERTS_NONE, n};
    }
    free(used);
    visit(s, 0, s->count, all, 0);
    return !s->lost;
}

/* ---- division -------------------------------------------------------------------------------------------------- */

static int compare_stops(const void *pa, const void *pb)
{
    const map_stop *a = pa, *b = pb;
    if (a->line != b->line)
        return a->line < b->line ? -1 : 1;
    if (a->t != b->t)
        return a->t < b->t ? -1 : 1;
    return (a->node > b->node) - (a->node < b->node);
}

/* Divides the lines at their stops. False: no memory. */
static bool divide_lines(map_search *s)
{
    planar_map *m = s->m;
    size_t k = 0, to = 0;
    uint32_t(*line)[2] = alloc_array(m->line_count + s->stop_count, sizeof *line);
    if (!line)
        return false;
    for (size_t i = 0; i < s->stop_count; i++) {
        map_stop *stop = &s->stop[i];
        stop->node = now_of(s, stop->node);
        roberts_vec2 A = m->node[now_of(s, m->line[stop->line][0])], B = m->node[now_of(s, m->line[stop->line][1])];
        stop->t = product(between(A, m->node[stop->node]), between(A, B));
    }
    if (s->stop_count > 1)
        qsort(s->stop, s->stop_count, sizeof *s->stop, compare_stops);
    for (uint32_t i = 0; i < m->line_count; i++) {
        uint32_t from = now_of(s, m->line[i][0]);
        for (bool more = true; more;) {
            more = k < s->stop_count && s->stop[k].line == i;
            uint32_t node = more ? s->stop[k++].node : now_of(s, m->line[i][1]);
            if (node == from)
                continue;
            line[to][0] = from;
            line[to++][1] = node;
            from = node;
        }
    }
    free(m->line);
    m->line = line;
    m->line_room = m->line_count + s->stop_count;
    m->line_count = to;
    return unite_lines(m);
}

bool planar_map_divide(planar_map *m, double touching)
{
    map_search s = {.m = m, .touching = touching, .margin = touching};
    bool enough = join_equal(m) && unite_lines(m), more = enough;
    for (int round = 0; more && round < MOST_ROUNDS; round++) {
        enough = search_all(&s);
        more = enough && (s.joined || s.stop_count > 0);
        if (more)
            more = enough = divide_lines(&s);
        s.touching *= 0.5;
    }
    free(s.item);
    free(s.stop);
    free(s.same);
    return enough;
}

void planar_map_free(planar_map *m)
{
    free(m->node);
    free(m->line);
    *m = (planar_map){0};
}
