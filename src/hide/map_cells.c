/* map_cells.c - see map_cells.h.
 *
 * Half-edges are sorted round their nodes by exact turns. A cycle goes on with the next half-edge clockwise from the
 * one that it came by. Groups of lines that hang together are put into the cells around them by a sweep, which asks
 * what lies below the leftmost node of each group. */
#include "hide/map_cells.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/dd.h"
#include "base/sort.h"
#include "model/face_pieces.h"
#include "model/sweep_order.h"

/* ---- lines that lead nowhere ----------------------------------------------------------------------------------- */

/* Takes away lines with an end that no other line has, one after the other. False: no memory. */
static bool prune(planar_map *m)
{
    uint32_t *degree = alloc_zeroed(m->node_count, sizeof *degree);
    /* [node_count] the exclusive or of the numbers of the lines at a node: where one line is left, its number */
    uint32_t *sum = alloc_zeroed(m->node_count, sizeof *sum);
    uint8_t *gone = alloc_zeroed(m->line_count, 1);
    size_t to = 0;
    bool enough = degree && sum && gone;
    for (uint32_t i = 0; enough && i < m->line_count; i++)
        for (int k = 0; k < 2; k++) {
            degree[m->line[i][k]]++;
            sum[m->line[i][k]] ^= i;
        }
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

/* A half-edge about its node. */
typedef struct ray {
    roberts_vec2 from, to;
    uint32_t half;
    bool lower; /* it points down, or straight left */
} ray;

static bool comes_after(const ray *a, const ray *b)
{
    if (a->lower != b->lower)
        return a->lower;
    return piece_turn(a->from, a->to, b->to) < 0.0;
}

static int compare_rays(const void *pa, const void *pb)
{
    return comes_after(pa, pb) ? 1 : comes_after(pb, pa) ? -1 : 0;
}

static bool sort_stars(map_stars *s, const planar_map *m)
{
    size_t halves = 2 * m->line_count, most = 0;
    s->start = alloc_zeroed(m->node_count + 2, sizeof *s->start);
    s->half = alloc_array(halves, sizeof *s->half);
    s->place = alloc_array(halves, sizeof *s->place);
    if (!s->start || !s->half || !s->place)
        return false;
    for (uint32_t h = 0; h < halves; h++)
        s->start[map_from(m, h) + 2]++;
    for (size_t n = 0; n <= m->node_count; n++) {
        most = s->start[n + 1] > most ? s->start[n + 1] : most;
        s->start[n + 1] += s->start[n];
    }
    for (uint32_t h = 0; h < halves; h++)
        s->half[s->start[map_from(m, h) + 1]++] = h;
    ray *own = alloc_array(most, sizeof *own);
    for (size_t n = 0; own && n < m->node_count; n++) {
        uint32_t first = s->start[n], count = s->start[n + 1] - first;
        for (uint32_t k = 0; k < count; k++) {
            roberts_vec2 from = m->node[n], to = m->node[map_from(m, s->half[first + k] ^ 1)];
            own[k] = (ray){from, to, s->half[first + k], to.y < from.y || (to.y == from.y && to.x < from.x)};
        }
        if (count <= 16) {
            SORT_FEW(ray, own, count, comes_after(a, b));
        } else {
            qsort(own, count, sizeof *own, compare_rays);
        }
        for (uint32_t k = 0; k < count; k++) {
            s->half[first + k] = own[k].half;
            s->place[own[k].half] = first + k;
        }
    }
    free(own);
    return own != NULL;
}

/* ---- cycles ---------------------------------------------------------------------------------------------------- */

double map_area(const map_cells *c, const planar_map *m, uint32_t half, const uint8_t *gone)
{
    roberts_vec2 O = m->node[map_from(m, half)];
    double twice = 0.0, sum = 0.0;
    for (uint32_t h = map_next(c, m, half, gone); h != half; h = map_next(c, m, h, gone)) {
        roberts_vec2 P = m->node[map_from(m, h)], Q = m->node[map_from(m, h ^ 1)];
        double left = (P.x - O.x) * (Q.y - O.y), right = (P.y - O.y) * (Q.x - O.x);
        twice += left - right;
        sum += fabs(left) + fabs(right);
    }
    if (fabs(twice) > 1e-6 * sum)
        return 0.5 * twice;
    dd exact = {0.0, 0.0};
    for (uint32_t h = map_next(c, m, half, gone); h != half; h = map_next(c, m, h, gone)) {
        roberts_vec2 P = m->node[map_from(m, h)], Q = m->node[map_from(m, h ^ 1)];
        dd left = dd_mul(dd_two_diff(P.x, O.x), dd_two_diff(Q.y, O.y));
        exact = dd_add(exact, dd_sub(left, dd_mul(dd_two_diff(P.y, O.y), dd_two_diff(Q.x, O.x))));
    }
    return 0.5 * (exact.hi + exact.lo);
}

static bool trace_cycles(map_cells *c, const planar_map *m)
{
    size_t halves = 2 * m->line_count, room = 0, area_room = 0;
    c->cycle = alloc_array(halves, sizeof *c->cycle);
    for (size_t h = 0; c->cycle && h < halves; h++)
        c->cycle[h] = ROBERTS_NONE;
    for (uint32_t first = 0; c->cycle && first < halves; first++) {
        if (c->cycle[first] != ROBERTS_NONE)
            continue;
        if (!array_reserve(&c->first, &room, c->cycle_count + 1, sizeof *c->first) ||
            !array_reserve(&c->area, &area_room, c->cycle_count + 1, sizeof *c->area))
            return false;
        for (uint32_t h = first; c->cycle[h] == ROBERTS_NONE; h = map_next(c, m, h, NULL))
            c->cycle[h] = (uint32_t)c->cycle_count;
        c->first[c->cycle_count] = first;
        c->area[c->cycle_count++] = map_area(c, m, first, NULL);
    }
    return c->cycle != NULL;
}

/* ---- which cell a group of lines lies in ----------------------------------------------------------------------- */

typedef struct cell_sweep {
    map_cells *c;
    const planar_map *m;
    sweep_order order;
    uint32_t *node;  /* [count] from left to right, then upward */
    uint32_t *outer; /* [nodes] of the leftmost node of a group, the cycle round it from outside; else ROBERTS_NONE */
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
    const uint32_t *start = s->c->stars.start;
    sweep_node *item = alloc_array(m->node_count, sizeof *item);
    s->node = alloc_array(m->node_count, sizeof *s->node);
    for (uint32_t n = 0; item && s->node && n < m->node_count; n++)
        if (start[n + 1] > start[n])
            item[s->count++] = (sweep_node){m->node[n], n};
    if (item && s->node && s->count > 1)
        qsort(item, s->count, sizeof *item, compare_nodes);
    for (size_t i = 0; item && s->node && i < s->count; i++)
        s->node[i] = item[i].node;
    free(item);
    return item && s->node;
}

/* Where each outer cycle is farthest left. */
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
        for (uint32_t h = map_next(c, m, c->first[k], NULL); h != c->first[k]; h = map_next(c, m, h, NULL))
            if (vec2_compare(m->node[map_from(m, h)], m->node[least]) < 0)
                least = map_from(m, h);
        s->outer[least] = k;
    }
    return s->outer != NULL;
}

/* The half-edge of a line that runs to the right. */
static uint32_t rightward(const planar_map *m, uint32_t line)
{
    return 2 * line + (vec2_compare(m->node[m->line[line][1]], m->node[m->line[line][0]]) < 0);
}

/* The line right below a node that no line in the order ends at; ROBERTS_NONE: there is none. */
static uint32_t line_below(const cell_sweep *s, uint32_t node)
{
    uint32_t below = ROBERTS_NONE;
    for (uint32_t line = s->order.root; line != ROBERTS_NONE;) {
        uint32_t h = rightward(s->m, line);
        bool above = piece_turn(s->m->node[map_from(s->m, h)], s->m->node[map_from(s->m, h ^ 1)], s->m->node[node]) > 0;
        below = above ? line : below;
        line = s->order.place[line].child[above];
    }
    return below;
}

/* The cell above a line, or outside of all. */
static uint32_t cell_above(const cell_sweep *s, uint32_t line)
{
    return line == ROBERTS_NONE ? 0 : map_cell_of(s->c, rightward(s->m, line));
}

/* Takes the lines that end at a node out of the order and puts those in that begin there. */
static void pass_node(cell_sweep *s, uint32_t node)
{
    const map_stars *stars = &s->c->stars;
    const planar_map *m = s->m;
    uint32_t below = ROBERTS_NONE;
    bool known = false;
    for (uint32_t k = stars->start[node]; k < stars->start[node + 1]; k++) {
        uint32_t line = stars->half[k] >> 1;
        if (rightward(m, line) == stars->half[k])
            continue;
        below = s->order.place[line].near[0]; /* the last one of them is the lowest */
        known = true;
        sweep_order_remove(&s->order, line);
    }
    if (!known) {
        below = line_below(s, node);
        if (s->outer[node] != ROBERTS_NONE)
            s->c->cell[s->outer[node]] = cell_above(s, below);
    }
    /* From the lowest to the highest: counter-clockwise from straight down on. */
    for (int lower = 1; lower >= 0; lower--)
        for (uint32_t k = stars->start[node]; k < stars->start[node + 1]; k++) {
            uint32_t half = stars->half[k], line = half >> 1;
            if (rightward(m, line) != half || (m->node[map_from(m, half ^ 1)].y < m->node[node].y) != lower)
                continue;
            sweep_order_insert(&s->order, line, below);
            below = line;
        }
}

/* Gives each cycle its cell. False: no memory. */
static bool number_cells(map_cells *c, const planar_map *m)
{
    cell_sweep s = {.c = c, .m = m};
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
    bool enough = sort_nodes(&s) && find_leftmost(&s) && sweep_order_start(&s.order, m->line_count);
    for (size_t i = 0; enough && i < s.count; i++)
        pass_node(&s, s.node[i]);
    sweep_order_free(&s.order);
    free(s.node);
    free(s.outer);
    return enough;
}

bool map_cells_find(map_cells *c, planar_map *m)
{
    *c = (map_cells){0};
    return prune(m) && sort_stars(&c->stars, m) && trace_cycles(c, m) && number_cells(c, m);
}

void map_cells_free(map_cells *c)
{
    free(c->stars.start);
    free(c->stars.half);
    free(c->stars.place);
    free(c->cycle);
    free(c->first);
    free(c->area);
    free(c->cell);
    *c = (map_cells){0};
}
