/* planar_map.c - see planar_map.h. map_search.c finds where lines have to be divided, and which nodes become one. */
#include "hide/planar_map.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/dd.h"
#include "base/orient.h"
#include "base/search.h"
#include "base/sort.h"
#include "hide/map_search.h"
#include "hide/tolerance.h"

/* Rounds of division. From the second one on, the distance at which a node divides a line is halved, so that the
 * division ends. */
enum { MOST_ROUNDS = 60 };

/* Numbers of nodes, and of half-edges, have 32 bits, and unite_lines() needs one bit more. */
#define NODES_MOST ((size_t)(UINT32_MAX / 4))

/* A power of two. */
#define FEWEST_SLOTS 1024

/* ---- input ----------------------------------------------------------------------------------------------------- */

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

/* Returns the slot of the node at p, or the free slot where it belongs. */
static uint32_t *find_slot(const planar_map *m, roberts_vec2 p)
{
    const size_t mask = m->slot_count - 1;
    size_t at = slot_of(p, mask);
    while (m->slot[at] != 0 && !vec2_same(m->node[m->slot[at] - 1], p))
        at = (at + 1) & mask;
    return &m->slot[at];
}

/* At least half of the slots stay free. False: no memory. */
static bool grow_slots(planar_map *m)
{
    free(m->slot);
    m->slot_count = m->slot_count ? 4 * m->slot_count : FEWEST_SLOTS;
    m->slot = alloc_zeroed(m->slot_count, sizeof *m->slot);
    for (uint32_t n = 0; m->slot && n < m->node_count; n++)
        *find_slot(m, m->node[n]) = n + 1;
    return m->slot != NULL;
}

/* Finds or adds the node at p. Most nodes are ends of several lines. False: no memory. */
static bool take_node(planar_map *m, roberts_vec2 p, uint32_t *node)
{
    if (m->node_count > NODES_MOST || (2 * m->node_count >= m->slot_count && !grow_slots(m)))
        return false;
    uint32_t *slot = find_slot(m, p);
    if (*slot == 0) {
        if (!array_reserve(&m->node, &m->node_room, m->node_count + 1, sizeof *m->node))
            return false;
        m->node[m->node_count++] = p;
        *slot = (uint32_t)m->node_count;
    }
    *node = *slot - 1;
    return true;
}

bool planar_map_add(planar_map *m, roberts_vec2 a, roberts_vec2 b)
{
    if (vec2_same(a, b))
        return true;
    if (!array_reserve(&m->line, &m->line_room, m->line_count + 1, sizeof *m->line))
        return false;
    uint32_t *line = m->line[m->line_count];
    const uint32_t *last = m->line_count > 0 ? m->line[m->line_count - 1] : NULL;
    if (last && vec2_same(m->node[last[0]], a)) /* edges are sorted: many begin where the last one does */
        line[0] = last[0];
    else if (!take_node(m, a, &line[0]))
        return false;
    if (!take_node(m, b, &line[1]))
        return false;
    m->line_count++;
    return true;
}

/* Puts the lines in order, each once, and leaves out those without length. Lines that become one are open if one of
 * them is. False: no memory. */
static bool unite_lines(map_search *s)
{
    planar_map *m = s->m;
    const size_t count = m->line_count;
    uint32_t *key = alloc_array(count, sizeof *key), *start = NULL, *order = NULL;
    uint64_t *line = alloc_array(count, sizeof *line); /* the smaller node, the other one, is it open? */
    bool enough = key && line;
    for (size_t i = 0; enough && i < count; i++)
        key[i] = m->line[i][m->line[i][1] < m->line[i][0]];
    enough = enough && sort_buckets(key, count, m->node_count, &start, &order);
    for (size_t i = 0; enough && i < count; i++) {
        const uint32_t *v = m->line[order[i]], from = key[order[i]];
        line[i] = (uint64_t)from << 32 | (v[0] + v[1] - from) << 1 | s->open[order[i]];
    }
    for (size_t n = 0; enough && n < m->node_count; n++)
        sort_short_list(line + start[n], start[n + 1] - start[n]);
    size_t to = 0;
    for (size_t i = 0; enough && i < count; i++) {
        uint32_t from = (uint32_t)(line[i] >> 32), end = (uint32_t)line[i] >> 1;
        if (from == end || (i + 1 < count && line[i] >> 1 == line[i + 1] >> 1))
            continue;
        s->open[to] = line[i] & 1;
        m->line[to][0] = from;
        m->line[to++][1] = end;
    }
    if (enough)
        m->line_count = to;
    free(key);
    free(start);
    free(order);
    free(line);
    return enough;
}

/* ---- division -------------------------------------------------------------------------------------------------- */

static bool comes_later(const map_stop *a, const map_stop *b)
{
    return a->t != b->t ? a->t > b->t : a->node > b->node;
}

static int compare_stops(const void *pa, const void *pb)
{
    return comes_later(pa, pb) ? 1 : comes_later(pb, pa) ? -1 : 0;
}

/* Sorts the stops by their lines, and along each line. Line i has stop[start[i]] .. stop[start[i + 1] - 1]. False: no
 * memory. */
static bool sort_stops(map_search *s, uint32_t **start)
{
    const planar_map *m = s->m;
    uint32_t *key = alloc_array(s->stop_count, sizeof *key), *order = NULL;
    map_stop *stop = alloc_array(s->stop_count, sizeof *stop);
    bool enough = key && stop;
    for (size_t i = 0; enough && i < s->stop_count; i++)
        key[i] = s->stop[i].line;
    enough = enough && sort_buckets(key, s->stop_count, m->line_count, start, &order);
    for (size_t i = 0; enough && i < s->stop_count; i++) {
        const uint32_t line = key[order[i]], *v = m->line[line];
        const roberts_vec2 A = m->node[map_search_node(s, v[0])], B = m->node[map_search_node(s, v[1])];
        const uint32_t node = map_search_node(s, s->stop[order[i]].node);
        stop[i] = (map_stop){line, node, map_product(map_between(A, m->node[node]), map_between(A, B))};
    }
    for (size_t i = 0; enough && i < m->line_count; i++) {
        const size_t few = (*start)[i + 1] - (*start)[i];
        SORT_LIST(map_stop, stop + (*start)[i], few, comes_later(a, b), compare_stops)
    }
    if (enough) {
        free(s->stop);
        s->stop = stop;
        s->stop_room = s->stop_count;
        stop = NULL;
    }
    free(key);
    free(order);
    free(stop);
    return enough;
}

/* Divides the lines at their stops. False: no memory. */
static bool divide_lines(map_search *s)
{
    planar_map *m = s->m;
    const size_t most = m->line_count + s->stop_count;
    size_t to = 0, k = 0;
    if (m->node_count > 2 * NODES_MOST || most > 2 * NODES_MOST)
        return false;
    uint32_t *start = NULL, (*line)[2] = alloc_array(most, sizeof *line);
    uint8_t *open = alloc_array(most, 1);
    bool enough = line && open && sort_stops(s, &start);
    for (uint32_t n = 0; enough && n < m->node_count; n++)
        if (s->fate[n].open)
            s->fate[map_search_node(s, n)].open = true;
    for (size_t i = 0; enough && i < m->line_count; i++) {
        uint32_t from = map_search_node(s, m->line[i][0]);
        for (bool more = true; more;) {
            more = k < start[i + 1];
            const uint32_t node = more ? s->stop[k++].node : map_search_node(s, m->line[i][1]);
            if (node == from)
                continue;
            open[to] = s->crowded[i] || s->fate[from].open || s->fate[node].open;
            line[to][0] = from;
            line[to++][1] = node;
            from = node;
        }
    }
    free(start);
    if (!enough) {
        free(line);
        free(open);
        return false;
    }
    free(m->line);
    free(s->open);
    m->line = line;
    m->line_room = most;
    m->line_count = to;
    s->open = open;
    return unite_lines(s);
}

/* Counts the lines at each node. NULL: no memory. */
static uint32_t *count_lines(const planar_map *m)
{
    uint32_t *degree = alloc_zeroed(m->node_count, sizeof *degree);
    for (size_t i = 0; degree && i < m->line_count; i++)
        for (int k = 0; k < 2; k++)
            degree[m->line[i][k]]++;
    return degree;
}

/* Divides the lines until nothing changes. Frees what the search has. False: no memory. */
static bool divide_all(map_search *s)
{
    planar_map *m = s->m;
    s->open = alloc_array(m->line_count, 1);
    bool enough = s->open != NULL, more;
    if (enough)
        memset(s->open, 1, m->line_count);
    more = enough = enough && unite_lines(s);
    for (int round = 0; more && round < MOST_ROUNDS; round++) {
        enough = map_search_all(s) && ((!s->joined && s->stop_count == 0) || divide_lines(s));
        more = enough && (s->joined || s->stop_count > 0) && memchr(s->open, 1, m->line_count);
        s->touching *= 0.5;
        s->reach *= 0.5;
    }
    free(s->item);
    free(s->stop);
    free(s->fate);
    free(s->open);
    free(s->crowded);
    free(s->loose);
    return enough;
}

bool planar_map_divide(planar_map *m, double touching)
{
    map_search s = {.m = m, .touching = touching, .margin = REGION_MARGIN * touching};
    free(m->slot);
    m->slot = NULL;
    return divide_all(&s);
}

bool planar_map_join_loose(planar_map *m, double touching, double reach)
{
    if (!(reach > touching))
        return true;
    map_search s = {.m = m, .touching = touching, .margin = REGION_MARGIN * reach, .reach = reach};
    uint32_t *degree = count_lines(m);
    bool any = false;
    s.loose = degree ? alloc_array(m->node_count, 1) : NULL;
    s.loose_count = m->node_count;
    for (size_t n = 0; s.loose && n < m->node_count; n++) {
        s.loose[n] = degree[n] == 1;
        any = any || s.loose[n];
    }
    free(degree);
    if (s.loose && any)
        return divide_all(&s);
    bool enough = s.loose;
    free(s.loose);
    return enough;
}

void planar_map_free(planar_map *m)
{
    free(m->node);
    free(m->line);
    free(m->slot);
    *m = (planar_map){0};
}

/* ---- cells -----------------------------------------------------------------------------------------------------
 *
 * Half-edges are sorted round their nodes by exact turns. A cycle goes on with the next half-edge clockwise from the
 * one that it came by. Groups of lines that hang together are put into the cells around them by a sweep, which asks
 * what lies below the leftmost node of each group. */

/* ---- lines that lead nowhere ----------------------------------------------------------------------------------- */

/* Removes lines with an end that no other line has, one after the other. False: no memory. */
static bool prune(planar_map *m)
{
    uint32_t *degree = count_lines(m);
    /* [node_count] the exclusive or of the numbers of the lines at a node: if one line is left, its number */
    uint32_t *sum = alloc_zeroed(m->node_count, sizeof *sum);
    uint8_t *gone = alloc_zeroed(m->line_count, 1);
    size_t to = 0;
    bool enough = degree && sum && gone;
    for (uint32_t i = 0; enough && i < m->line_count; i++)
        for (int k = 0; k < 2; k++)
            sum[m->line[i][k]] ^= i;
    for (uint32_t n = 0; enough && n < m->node_count; n++)
        for (uint32_t at = n; degree[at] == 1;) {
            uint32_t i = sum[at], other = m->line[i][0] == at ? m->line[i][1] : m->line[i][0];
            gone[i] = 1;
            degree[at] = 0;
            degree[other]--;
            sum[other] ^= i;
            at = other;
        }
    for (size_t i = 0; enough && i < m->line_count; i++)
        if (!gone[i]) {
            m->line[to][0] = m->line[i][0];
            m->line[to++][1] = m->line[i][1];
        }
    if (enough)
        m->line_count = to;
    free(degree);
    free(sum);
    free(gone);
    return enough;
}

/* ---- stars ----------------------------------------------------------------------------------------------------- */

/* Half-edges in the order round their nodes. */
typedef struct map_stars {
    uint32_t *start; /* [nodes + 1] node n begins half[start[n]] .. half[start[n + 1] - 1] */
    uint32_t *half;  /* [2 lines] counter-clockwise: to the right from the lowest, then to the left from the highest */
} map_stars;

/* A half-edge about its node. */
typedef struct ray {
    roberts_vec2 from, to;
    uint32_t half;
    bool left; /* it runs to the left, or straight down */
} ray;

static bool comes_after(const ray *a, const ray *b)
{
    if (a->left != b->left)
        return a->left;
    return orient2d(a->from, a->to, b->to) < 0.0;
}

static int compare_rays(const void *pa, const void *pb)
{
    return comes_after(pa, pb) ? 1 : comes_after(pb, pa) ? -1 : 0;
}

static bool sort_stars(map_stars *s, const planar_map *m)
{
    size_t halves = 2 * m->line_count, most = 0;
    uint32_t *node = alloc_array(halves, sizeof *node);
    for (uint32_t h = 0; node && h < halves; h++)
        node[h] = map_from(m, h);
    const bool listed = node && sort_buckets(node, halves, m->node_count, &s->start, &s->half);
    free(node);
    if (!listed)
        return false;
    for (size_t n = 0; n < m->node_count; n++)
        most = s->start[n + 1] - s->start[n] > most ? s->start[n + 1] - s->start[n] : most;
    ray *own = alloc_array(most, sizeof *own);
    for (size_t n = 0; own && n < m->node_count; n++) {
        uint32_t first = s->start[n], count = s->start[n + 1] - first;
        for (uint32_t k = 0; k < count; k++) {
            roberts_vec2 from = m->node[n], to = m->node[map_from(m, s->half[first + k] ^ 1)];
            own[k] = (ray){from, to, s->half[first + k], vec2_compare(to, from) < 0};
        }
        SORT_LIST(ray, own, count, comes_after(a, b), compare_rays)
        for (uint32_t k = 0; k < count; k++)
            s->half[first + k] = own[k].half;
    }
    free(own);
    return own != NULL;
}

/* ---- cycles ---------------------------------------------------------------------------------------------------- */

double map_area(const planar_map *m, const uint32_t *half, size_t count)
{
    const double certain = 1e-6; /* as a fraction of the terms: far above rounding */
    roberts_vec2 O = m->node[map_from(m, half[0])];
    double twice = 0.0, sum = 0.0;
    for (size_t k = 1; k < count; k++) {
        roberts_vec2 P = m->node[map_from(m, half[k])], Q = m->node[map_from(m, half[k] ^ 1)];
        double left = (P.x - O.x) * (Q.y - O.y), right = (P.y - O.y) * (Q.x - O.x);
        twice += left - right;
        sum += fabs(left) + fabs(right);
    }
    if (fabs(twice) > certain * sum)
        return 0.5 * twice;
    dd exact = {0.0, 0.0};
    for (size_t k = 1; k < count; k++) {
        roberts_vec2 P = m->node[map_from(m, half[k])], Q = m->node[map_from(m, half[k] ^ 1)];
        dd left = dd_mul(dd_two_diff(P.x, O.x), dd_two_diff(Q.y, O.y));
        exact = dd_add(exact, dd_sub(left, dd_mul(dd_two_diff(P.y, O.y), dd_two_diff(Q.x, O.x))));
    }
    return 0.5 * (exact.hi + exact.lo);
}

/* Finds the half-edge that follows each one: at its end, the next one clockwise. False: no memory. */
static bool link_halves(map_cells *c, const planar_map *m, const map_stars *s)
{
    c->next = alloc_array(2 * m->line_count, sizeof *c->next);
    for (size_t n = 0; c->next && n < m->node_count; n++)
        for (uint32_t at = s->start[n]; at < s->start[n + 1]; at++)
            c->next[s->half[at] ^ 1] = s->half[(at > s->start[n] ? at : s->start[n + 1]) - 1];
    return c->next != NULL;
}

static bool trace_cycles(map_cells *c, const planar_map *m)
{
    size_t halves = 2 * m->line_count, first_room = 0, area_room = 0, room = 0;
    uint32_t *half = NULL; /* of one cycle */
    c->cycle = alloc_array(halves, sizeof *c->cycle);
    bool enough = c->cycle != NULL;
    for (size_t h = 0; enough && h < halves; h++)
        c->cycle[h] = ROBERTS_NONE;
    for (uint32_t first = 0; enough && first < halves; first++) {
        size_t count = 0;
        if (c->cycle[first] != ROBERTS_NONE)
            continue;
        for (uint32_t h = first; enough && c->cycle[h] == ROBERTS_NONE; h = c->next[h]) {
            c->cycle[h] = (uint32_t)c->cycle_count;
            enough = array_reserve(&half, &room, count + 1, sizeof *half);
            if (enough)
                half[count++] = h;
        }
        enough = enough && array_reserve(&c->first, &first_room, c->cycle_count + 1, sizeof *c->first) &&
                 array_reserve(&c->area, &area_room, c->cycle_count + 1, sizeof *c->area);
        if (enough) {
            c->first[c->cycle_count] = first;
            c->area[c->cycle_count++] = map_area(m, half, count);
        }
    }
    free(half);
    return enough;
}

/* ---- which cell a group of lines lies in ----------------------------------------------------------------------- */

/* A line that the sweep meets. Lines that follow one another there share a place in the order. */
typedef struct sweep_line {
    roberts_vec2 from, to;
    uint32_t half; /* to the right; of a place that is free: the next free one */
} sweep_line;

typedef struct cell_sweep {
    map_cells *c;
    const planar_map *m;
    const map_stars *stars;
    sweep_order order; /* of places */
    sweep_line *line;  /* [lines] by places */
    uint32_t *place;   /* [lines] of the line in the order */
    uint32_t used;     /* places 0 .. used-1 have been used */
    uint32_t unused;   /* the first of them that is free; ROBERTS_NONE: none is */
    uint8_t *second;   /* [lines] the second half-edge is the one that runs to the right */
    uint32_t *node;    /* [count] from left to right, then upward */
    uint32_t *outer;   /* [nodes] of the leftmost node of a group, the cycle round it from outside; else ROBERTS_NONE */
    size_t count;
} cell_sweep;

typedef struct sweep_node {
    roberts_vec2 at;
    uint32_t node;
} sweep_node;

static int compare_nodes(const void *pa, const void *pb)
{
    const sweep_node *a = pa, *b = pb;
    int order = vec2_compare(a->at, b->at);
    return order != 0 ? order : (a->node > b->node) - (a->node < b->node);
}

static bool sort_nodes(cell_sweep *s)
{
    const planar_map *m = s->m;
    const uint32_t *start = s->stars->start;
    sweep_node *item = alloc_array(m->node_count, sizeof *item);
    uint32_t *key = alloc_array(m->node_count, sizeof *key), *order = alloc_array(m->node_count, sizeof *order);
    s->node = alloc_array(m->node_count, sizeof *s->node);
    bool enough = item && key && order && s->node;
    for (uint32_t n = 0; enough && n < m->node_count; n++)
        if (start[n + 1] > start[n]) {
            key[s->count] = ~radix_key_descending((float)m->node[n].x);
            s->node[s->count++] = n;
        }
    enough = enough && radix_order(key, (uint32_t)s->count, order);
    for (size_t i = 0; enough && i < s->count; i++) {
        uint32_t n = s->node[order[i]];
        item[i] = (sweep_node){m->node[n], n};
    }
    for (size_t i = 0, k; enough && i < s->count; i = k) {
        for (k = i + 1; k < s->count && key[order[k]] == key[order[i]];)
            k++;
        SORT_LIST(sweep_node, item + i, k - i, compare_nodes(a, b) > 0, compare_nodes) /* keys are rounded to floats */
    }
    for (size_t i = 0; enough && i < s->count; i++)
        s->node[i] = item[i].node;
    free(item);
    free(key);
    free(order);
    return enough;
}

/* Finds where each outer cycle is farthest left. */
static bool find_leftmost(cell_sweep *s)
{
    const map_cells *c = s->c;
    const planar_map *m = s->m;
    s->outer = alloc_array(m->node_count, sizeof *s->outer);
    for (size_t n = 0; s->outer && n < m->node_count; n++)
        s->outer[n] = ROBERTS_NONE;
    for (uint32_t k = 0; s->outer && k < c->cycle_count; k++) {
        if (c->area[k] > 0.0)
            continue;
        uint32_t least = map_from(m, c->first[k]);
        for (uint32_t h = c->next[c->first[k]]; h != c->first[k]; h = c->next[h])
            if (vec2_compare(m->node[map_from(m, h)], m->node[least]) < 0)
                least = map_from(m, h);
        s->outer[least] = k;
    }
    return s->outer != NULL;
}

/* Finds which half-edge of each line runs to the right. */
static bool find_directions(cell_sweep *s)
{
    const planar_map *m = s->m;
    s->second = alloc_array(m->line_count, 1);
    for (size_t i = 0; s->second && i < m->line_count; i++)
        s->second[i] = vec2_compare(m->node[m->line[i][1]], m->node[m->line[i][0]]) < 0;
    return s->second != NULL;
}

static uint32_t rightward(const cell_sweep *s, uint32_t line)
{
    return 2 * line + s->second[line];
}

/* The place of the line directly below a node at which no line of the order ends; ROBERTS_NONE: there is none. */
static uint32_t place_below(const cell_sweep *s, uint32_t node)
{
    const roberts_vec2 P = s->m->node[node];
    uint32_t below = ROBERTS_NONE;
    for (uint32_t place = s->order.root; place != ROBERTS_NONE;) {
        const bool above = orient2d(s->line[place].from, s->line[place].to, P) > 0.0;
        below = above ? place : below;
        place = s->order.place[place].child[above];
    }
    return below;
}

/* Takes a free place, directly above another one. */
static uint32_t take_place(cell_sweep *s, uint32_t below)
{
    const uint32_t place = s->unused != ROBERTS_NONE ? s->unused : s->used++;
    if (place == s->unused)
        s->unused = s->line[place].half;
    sweep_order_insert(&s->order, place, below);
    return place;
}

static void free_place(cell_sweep *s, uint32_t place)
{
    sweep_order_remove(&s->order, place);
    s->line[place].half = s->unused;
    s->unused = place;
}

/* Removes the lines that end at a node from the order, and inserts those that begin there. Each takes the place of one
 * that ends, as long as there are any. In a star, the lines that begin come first, from the lowest to the highest, then
 * those that end, from the highest to the lowest. */
static void pass_node(cell_sweep *s, uint32_t node)
{
    const uint32_t *half = s->stars->half, first = s->stars->start[node], end = s->stars->start[node + 1];
    uint32_t ends = first, left = end, below;
    while (ends < end && rightward(s, half[ends] >> 1) == half[ends])
        ends++;
    if (left > ends) {
        below = s->order.place[s->place[half[end - 1] >> 1]].near[0];
    } else {
        below = place_below(s, node);
        if (s->outer[node] != ROBERTS_NONE)
            s->c->cell[s->outer[node]] = below == ROBERTS_NONE ? 0 : map_cell_of(s->c, s->line[below].half);
    }
    for (uint32_t i = first; i < ends; i++) {
        below = left > ends ? s->place[half[--left] >> 1] : take_place(s, below);
        s->line[below] = (sweep_line){s->m->node[node], s->m->node[map_from(s->m, half[i] ^ 1)], half[i]};
        s->place[half[i] >> 1] = below;
    }
    while (left > ends)
        free_place(s, s->place[half[--left] >> 1]);
}

/* Gives each cycle its cell. False: no memory. */
static bool number_cells(map_cells *c, const planar_map *m, const map_stars *stars)
{
    cell_sweep s = {.c = c, .m = m, .stars = stars, .unused = ROBERTS_NONE};
    size_t groups = 0;
    c->cell = alloc_array(c->cycle_count, sizeof *c->cell);
    c->cell_count = 1;
    if (!c->cell)
        return false;
    for (size_t k = 0; k < c->cycle_count; k++) {
        c->cell[k] = c->area[k] > 0.0 ? (uint32_t)c->cell_count++ : 0;
        groups += !(c->area[k] > 0.0);
    }
    if (groups < 2)
        return true;
    s.line = alloc_sparse(m->line_count, sizeof *s.line); /* few are in the order at a time */
    s.place = alloc_array(m->line_count, sizeof *s.place);
    bool enough = s.line && s.place && sort_nodes(&s) && find_leftmost(&s) && find_directions(&s) &&
                  sweep_order_start(&s.order, m->line_count);
    for (size_t i = 0; enough && i < s.count; i++)
        pass_node(&s, s.node[i]);
    sweep_order_free(&s.order);
    free(s.line);
    free(s.place);
    free(s.second);
    free(s.node);
    free(s.outer);
    return enough;
}

bool map_cells_find(map_cells *c, planar_map *m)
{
    map_stars stars = {NULL, NULL};
    *c = (map_cells){0};
    const bool enough = prune(m) && sort_stars(&stars, m) && link_halves(c, m, &stars) && trace_cycles(c, m) &&
                        number_cells(c, m, &stars);
    free(stars.start);
    free(stars.half);
    return enough;
}

void map_cells_free(map_cells *c)
{
    free(c->next);
    free(c->cycle);
    free(c->first);
    free(c->area);
    free(c->cell);
    *c = (map_cells){0};
}
