/* planar_map.c - see planar_map.h. map_search.c finds where lines have to be divided, and which nodes become one. */
#include "hide/planar_map.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/sort.h"
#include "hide/map_search.h"

/* Rounds of division. From the second one on, nodes must be nearer by half to divide a line, so that an end is
 * reached. */
enum { MOST_ROUNDS = 60 };

/* The numbers of nodes, and those of both ends of all lines, are 32 bits wide. */
#define NODES_MOST ((size_t)(UINT32_MAX / 4))

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

/* Marks the lines that the division has left as they were. False: no memory. */
static bool mark_old(map_search *s)
{
    const planar_map *m = s->m;
    size_t k = 0;
    free(s->old);
    s->old = alloc_zeroed(m->line_count, 1);
    for (size_t i = 0; s->old && i < m->line_count; i++) {
        const uint32_t *v = m->line[i];
        while (k < s->kept_count && (s->kept[k][0] < v[0] || (s->kept[k][0] == v[0] && s->kept[k][1] < v[1])))
            k++;
        s->old[i] = k < s->kept_count && s->kept[k][0] == v[0] && s->kept[k][1] == v[1];
    }
    return s->old;
}

/* Divides the lines at their stops. False: no memory. */
static bool divide_lines(map_search *s)
{
    planar_map *m = s->m;
    size_t k = 0, to = 0;
    uint32_t(*line)[2] = alloc_array(m->line_count + s->stop_count, sizeof *line);
    free(s->kept);
    s->kept = alloc_array(m->line_count, sizeof *s->kept);
    s->kept_count = 0;
    if (!line || !s->kept) {
        free(line);
        return false;
    }
    for (size_t i = 0; i < s->stop_count; i++) {
        map_stop *stop = &s->stop[i];
        stop->node = map_search_node(s, stop->node);
        const uint32_t *v = m->line[stop->line];
        roberts_vec2 A = m->node[map_search_node(s, v[0])], B = m->node[map_search_node(s, v[1])];
        stop->t = map_product(map_between(A, m->node[stop->node]), map_between(A, B));
    }
    if (s->stop_count > 1)
        qsort(s->stop, s->stop_count, sizeof *s->stop, compare_stops);
    for (uint32_t i = 0; i < m->line_count; i++) {
        const uint32_t *v = m->line[i];
        uint32_t from = map_search_node(s, v[0]);
        if ((k == s->stop_count || s->stop[k].line != i) && from == v[0] && map_search_node(s, v[1]) == v[1])
            memcpy(s->kept[s->kept_count++], v, sizeof *s->kept);
        for (bool more = true; more;) {
            more = k < s->stop_count && s->stop[k].line == i;
            uint32_t node = more ? s->stop[k++].node : map_search_node(s, m->line[i][1]);
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
    return unite_lines(m) && mark_old(s);
}

bool planar_map_divide(planar_map *m, double touching)
{
    map_search s = {.m = m, .touching = touching, .margin = touching};
    bool enough = join_equal(m) && unite_lines(m) && mark_old(&s), more = enough;
    for (int round = 0; more && round < MOST_ROUNDS; round++) {
        enough = map_search_all(&s);
        more = enough && (s.joined || s.stop_count > 0);
        if (more)
            more = enough = divide_lines(&s);
        s.touching *= 0.5;
    }
    free(s.item);
    free(s.stop);
    free(s.same);
    free(s.kept);
    free(s.old);
    return enough;
}

void planar_map_free(planar_map *m)
{
    free(m->node);
    free(m->line);
    *m = (planar_map){0};
}
