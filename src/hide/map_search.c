/* map_search.c - see map_search.h.
 *
 * A bucket grid finds what is near what: each cell lists the lines and nodes in it or near it. A crowded cell is halved
 * along the axis that leaves fewer items in both halves. This is repeated until few items are left, which are compared
 * with one another. A fan of lines at one node is not cut at all. So the search adapts to pictures that are crowded in
 * places. It takes O(n log n) time unless very many long lines run side by side at an angle.
 *
 * After a round of division, only new items are compared with their neighbours. Two items that the last round left
 * unchanged are not near one another. */
#include "hide/map_search.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/orient.h"

enum {
    FEW = 12,         /* things in a box that are compared with one another */
    IDLE_HALVINGS = 8 /* cuts in a row that separate hardly anything; then all items are compared */
};

/* A line or a node, or the part of a line that a box holds. */
struct map_item {
    roberts_vec2 a, b;   /* a node: both are its place */
    uint32_t line, node; /* one of them; the other is ROBERTS_NONE */
};

/* The bucket grid: cell (x, y) lists entry[start[y columns + x]] and so on. Line i is number i, node n is number
 * line_count + n. The outermost cells are infinite. */
typedef struct map_grid {
    roberts_vec2 low;
    double size; /* of a cell */
    size_t columns, rows;
    uint8_t *busy;   /* [columns rows] something new is in it or near it; in others nothing is listed */
    size_t *start;   /* [columns rows + 2] */
    uint32_t *entry; /* [start[columns rows]] */
} map_grid;

typedef struct map_box {
    roberts_vec2 low, high;
} map_box;

/* ---- pairs ----------------------------------------------------------------------------------------------------- */

static void join_nodes(map_search *s, uint32_t p, uint32_t q)
{
    p = map_search_node(s, p);
    q = map_search_node(s, q);
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

/* Does P touch the line between A and B? */
static bool is_near(roberts_vec2 A, roberts_vec2 B, roberts_vec2 P, double touching)
{
    if (P.x < lesser(A.x, B.x) - touching || P.x > greater(A.x, B.x) + touching || P.y < lesser(A.y, B.y) - touching ||
        P.y > greater(A.y, B.y) + touching)
        return false;
    roberts_vec2 d = map_between(A, B), p = map_between(A, P);
    double length2 = map_product(d, d), t = map_product(p, d) / length2;
    t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
    roberts_vec2 off = {p.x - t * d.x, p.y - t * d.y};
    return map_product(off, off) <= touching * touching;
}

static void compare_with_node(map_search *s, uint32_t line, uint32_t node)
{
    const uint32_t *v = s->m->line[line];
    if (v[0] != node && v[1] != node && is_near(s->m->node[v[0]], s->m->node[v[1]], s->m->node[node], s->touching))
        add_stop(s, line, node);
}

static void compare_nodes(map_search *s, uint32_t p, uint32_t q)
{
    roberts_vec2 d = map_between(s->m->node[p], s->m->node[q]);
    if (map_product(d, d) <= s->touching * s->touching)
        join_nodes(s, p, q);
}

/* Records where two lines cross, unless an end of one touches the other or the crossing is in another box. */
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
    double c = orient2d(A, B, C), d = orient2d(A, B, D);
    if (!((c > 0.0 && d < 0.0) || (c < 0.0 && d > 0.0)))
        return;
    double a = orient2d(C, D, A), b = orient2d(C, D, B);
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

/* Did the last round leave it unchanged? */
static bool is_old(const map_search *s, const map_item *p)
{
    return p->line != ROBERTS_NONE ? s->old[p->line] : p->node < s->old_nodes;
}

static void compare_all(map_search *s, size_t first, size_t end, const map_box *box)
{
    for (size_t i = first; i < end; i++)
        for (size_t k = i + 1; k < end; k++) {
            const map_item *p = &s->item[i], *q = &s->item[k];
            if (is_old(s, p) && is_old(s, q))
                continue;
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

/* Do all lines share one node, and is there no other node? */
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

/* Finds the part of an item on one side: -1 below `at`, 1 above it. False: there is none, not even near it. */
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

/* Is any of it new? */
static bool has_new(const map_search *s, size_t first, size_t end)
{
    for (size_t i = first; i < end; i++)
        if (!is_old(s, &s->item[i]))
            return true;
    return false;
}

static void visit(map_search *s, size_t first, size_t end, map_box box, int idle)
{
    if (end - first < 2 || !has_new(s, first, end) || is_fan(s, first, end))
        return;
    if (end - first <= FEW) {
        compare_all(s, first, end, &box);
        return;
    }
    map_box own = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (size_t i = first; i < end; i++) {
        const map_item *p = &s->item[i];
        own.low = (roberts_vec2){lesser(own.low.x, lesser(p->a.x, p->b.x)), lesser(own.low.y, lesser(p->a.y, p->b.y))};
        own.high =
            (roberts_vec2){greater(own.high.x, greater(p->a.x, p->b.x)), greater(own.high.y, greater(p->a.y, p->b.y))};
    }
    double size = greater(own.high.x - own.low.x, own.high.y - own.low.y);
    if (idle >= IDLE_HALVINGS || !(size > 8.0 * s->margin)) {
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

/* ---- the grid -------------------------------------------------------------------------------------------------- */

static map_item item_of(const map_search *s, uint32_t number)
{
    const planar_map *m = s->m;
    if (number >= m->line_count) {
        uint32_t node = number - (uint32_t)m->line_count;
        return (map_item){m->node[node], m->node[node], ROBERTS_NONE, node};
    }
    return (map_item){m->node[m->line[number][0]], m->node[m->line[number][1]], number, ROBERTS_NONE};
}

/* The column or row of a coordinate, one of the grid's. */
static size_t place_in(double at, double low, double size, size_t count)
{
    double place = (at - low) / size;
    return !(place > 0.0) ? 0 : place >= (double)count ? count - 1 : (size_t)(int64_t)place;
}

/* The operation on each cell that an item is in or near. */
typedef enum list_pass {
    MARK,  /* they become busy */
    COUNT, /* busy ones count the item */
    LIST   /* busy ones list it */
} list_pass;

static void list_in_cells(const map_search *s, map_grid *g, uint32_t number, list_pass pass)
{
    const map_item p = item_of(s, number);
    const double near = 2.0 * s->margin; /* twice: for rounding */
    const double low = lesser(p.a.y, p.b.y) - near, high = greater(p.a.y, p.b.y) + near;
    const size_t first = place_in(low, g->low.y, g->size, g->rows), last = place_in(high, g->low.y, g->size, g->rows);
    for (size_t row = first; row <= last; row++) {
        double a = p.a.x, b = p.b.x;
        if (first < last && p.line != ROBERTS_NONE && p.a.y != p.b.y) { /* what of it is in the row */
            const double y0 = row == first ? low : g->low.y + (double)row * g->size - near;
            const double y1 = row == last ? high : g->low.y + (double)(row + 1) * g->size + near;
            const double t0 = (y0 - p.a.y) / (p.b.y - p.a.y), t1 = (y1 - p.a.y) / (p.b.y - p.a.y);
            a = p.a.x + greater(0.0, lesser(1.0, t0)) * (p.b.x - p.a.x);
            b = p.a.x + greater(0.0, lesser(1.0, t1)) * (p.b.x - p.a.x);
        }
        const size_t from = place_in(lesser(a, b) - near, g->low.x, g->size, g->columns);
        const size_t to = place_in(greater(a, b) + near, g->low.x, g->size, g->columns);
        for (size_t cell = row * g->columns + from; cell <= row * g->columns + to; cell++) {
            if (pass == MARK)
                g->busy[cell] = 1;
            else if (pass == COUNT)
                g->start[cell + 2] += g->busy[cell];
            else if (g->busy[cell])
                g->entry[g->start[cell + 1]++] = number;
        }
    }
}

/* Chooses the size of the cells: about one for each item, so that a line is in a few of them on average. */
static void choose_cells(const map_search *s, map_grid *g, size_t items)
{
    const planar_map *m = s->m;
    roberts_vec2 high = {-INFINITY, -INFINITY};
    double length = 0.0;
    g->low = (roberts_vec2){INFINITY, INFINITY};
    for (size_t i = 0; i < m->line_count; i++) {
        const map_item p = item_of(s, (uint32_t)i);
        length += fabs(p.b.x - p.a.x) + fabs(p.b.y - p.a.y);
        g->low = (roberts_vec2){lesser(g->low.x, lesser(p.a.x, p.b.x)), lesser(g->low.y, lesser(p.a.y, p.b.y))};
        high = (roberts_vec2){greater(high.x, greater(p.a.x, p.b.x)), greater(high.y, greater(p.a.y, p.b.y))};
    }
    const double width = high.x - g->low.x, height = high.y - g->low.y, most = (double)items;
    const double size = greater(sqrt(width) * sqrt(height) / sqrt(most),
                                greater(greater(width, height) / most, length / (2.0 * (double)items)));
    g->size = greater(size, 64.0 * s->margin);
    g->columns = g->rows = 1;
    if (items <= FEW || !(g->size > 0.0) || !isfinite(g->size)) {
        g->size = 1.0;
        return;
    }
    g->columns += (size_t)(width / g->size);
    g->rows += (size_t)(height / g->size);
}

/* Compares what is in a cell. */
static void visit_cell(map_search *s, const map_grid *g, size_t column, size_t row)
{
    const size_t cell = row * g->columns + column, first = g->start[cell], end = g->start[cell + 1];
    map_box box = {{-INFINITY, -INFINITY}, {INFINITY, INFINITY}};
    if (end - first < 2)
        return;
    if (!array_reserve(&s->item, &s->room, end - first, sizeof *s->item)) {
        s->lost = true;
        return;
    }
    if (column > 0)
        box.low.x = g->low.x + (double)column * g->size;
    if (column + 1 < g->columns)
        box.high.x = g->low.x + (double)(column + 1) * g->size;
    if (row > 0)
        box.low.y = g->low.y + (double)row * g->size;
    if (row + 1 < g->rows)
        box.high.y = g->low.y + (double)(row + 1) * g->size;
    s->count = 0;
    for (size_t i = first; i < end; i++) {
        map_item *p = &s->item[s->count];
        *p = item_of(s, g->entry[i]);
        s->count += end - first <= FEW || ((column == 0 || part_of(s, p, 0, box.low.x, 1, p)) &&
                                           (column + 1 == g->columns || part_of(s, p, 0, box.high.x, -1, p)) &&
                                           (row == 0 || part_of(s, p, 1, box.low.y, 1, p)) &&
                                           (row + 1 == g->rows || part_of(s, p, 1, box.high.y, -1, p)));
    }
    visit(s, 0, s->count, box, 0);
}

/* Lists the lines, and the nodes that they use, in the cells with anything new. False: no memory. */
static bool fill_grid(const map_search *s, map_grid *g)
{
    const planar_map *m = s->m;
    uint8_t *used = alloc_zeroed(m->node_count, 1);
    size_t items = m->line_count;
    bool enough = used;
    for (size_t i = 0; enough && i < m->line_count; i++)
        for (int k = 0; k < 2; k++) {
            items += !used[m->line[i][k]];
            used[m->line[i][k]] = 1;
        }
    if (enough) {
        choose_cells(s, g, items);
        g->start = alloc_zeroed(g->columns * g->rows + 2, sizeof *g->start);
        g->busy = alloc_zeroed(g->columns * g->rows, 1);
        enough = g->start && g->busy;
    }
    const bool all_new = s->old_nodes == 0;
    if (enough && all_new)
        memset(g->busy, 1, g->columns * g->rows);
    for (list_pass pass = all_new ? COUNT : MARK; enough && pass <= LIST; pass++) {
        for (uint32_t i = 0; i < m->line_count + m->node_count; i++) {
            const map_item p = item_of(s, i);
            if ((p.node == ROBERTS_NONE || used[p.node]) && (pass != MARK || !is_old(s, &p)))
                list_in_cells(s, g, i, pass);
        }
        if (pass == COUNT) {
            for (size_t c = 0; c < g->columns * g->rows; c++)
                g->start[c + 2] += g->start[c + 1];
            g->entry = alloc_array(g->start[g->columns * g->rows + 1], sizeof *g->entry);
            enough = g->entry;
        }
    }
    free(used);
    return enough;
}

bool map_search_all(map_search *s)
{
    map_grid g = {0};
    const size_t before = s->m->node_count;
    s->stop_count = 0;
    s->joined = false;
    bool enough = array_reserve(&s->same, &s->same_room, before, sizeof *s->same) && fill_grid(s, &g);
    for (uint32_t n = 0; enough && n < before; n++)
        s->same[n] = n;
    for (size_t row = 0; enough && row < g.rows; row++)
        for (size_t column = 0; column < g.columns && !s->lost; column++)
            visit_cell(s, &g, column, row);
    s->old_nodes = before;
    free(g.busy);
    free(g.start);
    free(g.entry);
    return enough && !s->lost;
}
