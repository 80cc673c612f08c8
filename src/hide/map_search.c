/* map_search.c - see map_search.h.
 *
 * A bucket grid finds what is near what: each cell lists the lines in it or near it. A crowded cell is halved along the
 * axis that leaves fewer lines in both halves. This is repeated until few lines are left, which are compared with one
 * another. A fan of lines at one node is not cut at all. So the search adapts to pictures that are crowded in places.
 * It takes O(n log n) time unless very many long lines run side by side at an angle.
 *
 * After a round of division, only lines that are open are compared with their neighbours. At first all are. A node is
 * open if it is new, or if another node is near that it has not become. A part of a line is open if an end of it is, or
 * if a node is near the line but does not touch it. Two lines that are not open have nothing to do with one another:
 * the division moves a line by less than four touching distances in all rounds, so it makes two lines meet only where
 * an end of one was near the other: see REGION_MARGIN. */
#include "hide/map_search.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/orient.h"

enum {
    FEW = 24, /* lines in a box that are compared with one another */
    CELLS_PER_LINE = 1,
    IDLE_HALVINGS = 2 /* cuts in a row that separate hardly anything; then all lines are compared */
};

/* A line, or the part of it that a box holds. */
struct map_item {
    roberts_vec2 a, b;
    roberts_vec2 low, high; /* of the whole line; each is half a margin farther out */
    uint32_t line;
};

/* The bucket grid: cell (x, y) lists entry[start[y columns + x]] and so on. The outermost cells are infinite. */
typedef struct map_grid {
    roberts_vec2 low;
    double size, per_size; /* of a cell; 1 / size */
    size_t columns, rows;
    uint8_t *busy;   /* [columns rows] an open line is in it or near it; others list nothing. NULL: all are busy */
    size_t *start;   /* [columns rows + 2] */
    uint32_t *entry; /* [start[columns rows]] */
    uint32_t *cell;  /* [cell_count] the cells of the lines, line by line */
    size_t cell_count, cell_room;
} map_grid;

typedef struct map_box {
    roberts_vec2 low, high;
} map_box;

static bool box_holds(const map_box *box, roberts_vec2 P)
{
    return P.x >= box->low.x && P.x < box->high.x && P.y >= box->low.y && P.y < box->high.y;
}

/* ---- pairs ----------------------------------------------------------------------------------------------------- */

static void join_nodes(map_search *s, uint32_t p, uint32_t q)
{
    p = map_search_node(s, p);
    q = map_search_node(s, q);
    s->joined = s->joined || p != q;
    s->fate[p > q ? p : q].node = p < q ? p : q;
}

/* What is nearer to a node than this touches it. */
static double reach_of(const map_search *s, uint32_t node)
{
    return node < s->loose_count && s->loose[node] ? s->reach : s->touching;
}

static void compare_nodes(map_search *s, uint32_t p, uint32_t q)
{
    const roberts_vec2 d = map_between(s->m->node[p], s->m->node[q]);
    const double apart2 = map_product(d, d), reach = greater(reach_of(s, p), reach_of(s, q));
    if (apart2 <= reach * reach)
        join_nodes(s, p, q);
    else if (apart2 <= s->margin * s->margin)
        s->fate[p].open = s->fate[q].open = true;
}

/* Many lines may end in the node, or in others that it has become: most of these follow one another, and are added
 * once. */
static void add_stop(map_search *s, uint32_t line, uint32_t node)
{
    node = map_search_node(s, node);
    if (s->last_stop[line] == node)
        return;
    s->last_stop[line] = node;
    if (!array_reserve(&s->stop, &s->stop_room, s->stop_count + 1, sizeof *s->stop)) {
        s->lost = true;
        return;
    }
    s->stop[s->stop_count++] = (map_stop){.line = line, .node = node};
}

/* Does a node touch a line that does not end in it? Then the line has to stop there. */
static bool compare_with_node(map_search *s, uint32_t line, uint32_t node)
{
    const roberts_vec2 *at = s->m->node;
    const roberts_vec2 A = at[s->m->line[line][0]], d = map_between(A, at[s->m->line[line][1]]);
    const roberts_vec2 p = map_between(A, at[node]);
    double t = map_product(p, d) / map_product(d, d);
    t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
    const roberts_vec2 off = {p.x - t * d.x, p.y - t * d.y};
    const double apart2 = map_product(off, off), reach = reach_of(s, node);
    if (apart2 <= reach * reach) {
        add_stop(s, line, node);
        return true;
    }
    if (apart2 <= s->margin * s->margin)
        s->crowded[line] = 1;
    return false;
}

/* Adds a node where two lines cross, unless the last stop of one of them is there already: near the corner of a fan of
 * slivers, thousands of lines may cross another one in one place. */
static void add_crossing(map_search *s, uint32_t i, uint32_t j, roberts_vec2 X)
{
    planar_map *m = s->m;
    const uint32_t last[] = {s->last_stop[i], s->last_stop[j]};
    for (int k = 0; k < 2; k++) {
        const roberts_vec2 d =
            last[k] == ROBERTS_NONE ? (roberts_vec2){INFINITY, 0.0} : map_between(m->node[last[k]], X);
        if (map_product(d, d) <= 0.25 * s->touching * s->touching) {
            add_stop(s, i, last[k]);
            add_stop(s, j, last[k]);
            return;
        }
    }
    if (!array_reserve(&m->node, &m->node_room, m->node_count + 1, sizeof *m->node) ||
        !array_reserve(&s->fate, &s->fate_room, m->node_count + 1, sizeof *s->fate)) {
        s->lost = true;
        return;
    }
    uint32_t node = (uint32_t)m->node_count++;
    m->node[node] = X;
    s->fate[node] = (map_fate){node, true};
    add_stop(s, i, node);
    add_stop(s, j, node);
}

static double map_turn(roberts_vec2 a, roberts_vec2 b)
{
    return a.x * b.y - a.y * b.x;
}

/* Are C and D on one side of the line from A along `ab`, and not near it? */
static bool is_beside(roberts_vec2 A, roberts_vec2 ab, roberts_vec2 C, roberts_vec2 D, double margin)
{
    const double c = map_turn(ab, map_between(A, C)), d = map_turn(ab, map_between(A, D));
    const double near = margin * (fabs(ab.x) + fabs(ab.y));
    return lesser(c, d) > near || greater(c, d) < -near;
}

static bool differ(double a, double b)
{
    return (a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0);
}

/* Compares two lines that share no node. A crossing in another box is left to that box. */
static void compare_apart(map_search *s, uint32_t i, uint32_t j, const map_box *box)
{
    const uint32_t *v = s->m->line[i], *w = s->m->line[j];
    const roberts_vec2 *at = s->m->node;
    const roberts_vec2 A = at[v[0]], B = at[v[1]], C = at[w[0]], D = at[w[1]];
    bool touching = false;
    if (is_beside(A, map_between(A, B), C, D, s->margin) || is_beside(C, map_between(C, D), A, B, s->margin))
        return;
    for (int k = 0; k < 2; k++) {
        compare_nodes(s, v[k], w[0]);
        compare_nodes(s, v[k], w[1]);
    }
    for (int k = 0; k < 2; k++) {
        touching = compare_with_node(s, i, w[k]) || touching;
        touching = compare_with_node(s, j, v[k]) || touching;
    }
    if (touching || !differ(orient2d(A, B, C), orient2d(A, B, D)))
        return;
    const double a = orient2d(C, D, A), b = orient2d(C, D, B), t = a / (a - b);
    const roberts_vec2 X = {A.x + t * (B.x - A.x), A.y + t * (B.y - A.y)};
    if (differ(a, b) && box_holds(box, X))
        add_crossing(s, i, j, X);
}

/* Compares two lines that share the node S and go on to P and Q. */
static void compare_branches(map_search *s, uint32_t i, uint32_t j, uint32_t S, uint32_t P, uint32_t Q)
{
    const roberts_vec2 *at = s->m->node;
    const roberts_vec2 p = map_between(at[S], at[P]), q = map_between(at[S], at[Q]);
    const double size = fabs(map_turn(p, q)), r = s->margin;
    if (size > r * (fabs(p.x) + fabs(p.y)) && size > r * (fabs(q.x) + fabs(q.y)))
        return;
    compare_with_node(s, i, Q);
    compare_with_node(s, j, P);
    compare_nodes(s, P, Q);
}

static void compare_lines(map_search *s, const map_item *p, const map_item *q, const map_box *box)
{
    const uint32_t i = p->line, j = q->line, *v = s->m->line[i], *w = s->m->line[j];
    if (p->low.x > q->high.x || q->low.x > p->high.x || p->low.y > q->high.y || q->low.y > p->high.y ||
        (!s->open[i] && !s->open[j]))
        return;
    for (int k = 0; k < 2; k++)
        if (v[k] == w[0] || v[k] == w[1]) {
            compare_branches(s, i, j, v[k], v[1 - k], w[v[k] == w[0]]);
            return;
        }
    compare_apart(s, i, j, box);
}

static void compare_all(map_search *s, size_t first, size_t end, const map_box *box)
{
    for (size_t i = first; i < end; i++)
        for (size_t k = i + 1; k < end; k++)
            compare_lines(s, &s->item[i], &s->item[k], box);
}

/* Do all lines share one node, and are their other ends elsewhere? */
static bool is_fan(const map_search *s, size_t first, size_t end, const map_box *box)
{
    const planar_map *m = s->m;
    for (int k = 0; k < 2; k++) {
        const uint32_t node = m->line[s->item[first].line][k];
        size_t i = first;
        for (; i < end; i++) {
            const uint32_t *v = m->line[s->item[i].line];
            if ((v[0] != node && v[1] != node) || box_holds(box, m->node[v[v[0] == node]]))
                break;
        }
        if (i == end)
            return true;
    }
    return false;
}

/* ---- halving --------------------------------------------------------------------------------------------------- */

static double map_coordinate(roberts_vec2 p, int axis)
{
    return axis ? p.y : p.x;
}

/* The point of a line at `at` of the axis, between p and q. */
static roberts_vec2 cut_at(const map_search *s, uint32_t line, int axis, double at, roberts_vec2 p, roberts_vec2 q)
{
    roberts_vec2 A = s->m->node[s->m->line[line][0]], B = s->m->node[s->m->line[line][1]];
    double t = (at - map_coordinate(A, axis)) / (map_coordinate(B, axis) - map_coordinate(A, axis));
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
    double a = side * (map_coordinate(all->a, axis) - at), b = side * (map_coordinate(all->b, axis) - at);
    if (greater(a, b) < -s->margin)
        return false;
    *part = *all;
    if (lesser(a, b) >= 0.0)
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
        double a = map_coordinate(s->item[i].a, axis) - at, b = map_coordinate(s->item[i].b, axis) - at;
        both += lesser(a, b) <= s->margin && greater(a, b) >= -s->margin;
    }
    return both;
}

static bool has_open(const map_search *s, size_t first, size_t end)
{
    for (size_t i = first; i < end; i++)
        if (s->open[s->item[i].line])
            return true;
    return false;
}

static void visit(map_search *s, size_t first, size_t end, map_box box, int idle)
{
    if (end - first < 2 || !has_open(s, first, end) || is_fan(s, first, end, &box))
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

static inline map_item item_of(const map_search *s, uint32_t line)
{
    const roberts_vec2 A = s->m->node[s->m->line[line][0]], B = s->m->node[s->m->line[line][1]];
    const double r = 0.5 * s->margin;
    return (map_item){.a = A,
                      .b = B,
                      .low = {lesser(A.x, B.x) - r, lesser(A.y, B.y) - r},
                      .high = {greater(A.x, B.x) + r, greater(A.y, B.y) + r},
                      .line = line};
}

/* The column or row of a coordinate, one of the grid's. */
static size_t place_in(const map_grid *g, double at, double low, size_t count)
{
    const double place = (at - low) * g->per_size;
    return !(place > 0.0) ? 0 : place >= (double)count ? count - 1 : (size_t)(int64_t)place;
}

/* Appends the busy cells that a line is in or near to g->cell. False: no memory. */
static bool add_cells(const map_search *s, map_grid *g, uint32_t line)
{
    const map_item p = item_of(s, line);
    const double near = 2.0 * s->margin; /* twice: for rounding */
    const double low = lesser(p.a.y, p.b.y) - near, high = greater(p.a.y, p.b.y) + near;
    const size_t first = place_in(g, low, g->low.y, g->rows), last = place_in(g, high, g->low.y, g->rows);
    for (size_t row = first; row <= last; row++) {
        double a = p.a.x, b = p.b.x;
        if (first < last && p.a.y != p.b.y) { /* what of it is in the row */
            const double y0 = row == first ? low : g->low.y + (double)row * g->size - near;
            const double y1 = row == last ? high : g->low.y + (double)(row + 1) * g->size + near;
            const double t0 = (y0 - p.a.y) / (p.b.y - p.a.y), t1 = (y1 - p.a.y) / (p.b.y - p.a.y);
            a = p.a.x + greater(0.0, lesser(1.0, t0)) * (p.b.x - p.a.x);
            b = p.a.x + greater(0.0, lesser(1.0, t1)) * (p.b.x - p.a.x);
        }
        const size_t from = row * g->columns + place_in(g, lesser(a, b) - near, g->low.x, g->columns);
        const size_t to = row * g->columns + place_in(g, greater(a, b) + near, g->low.x, g->columns);
        if (!array_reserve(&g->cell, &g->cell_room, g->cell_count + (to - from + 1), sizeof *g->cell))
            return false;
        for (size_t cell = from; cell <= to; cell++)
            if (!g->busy || g->busy[cell])
                g->cell[g->cell_count++] = (uint32_t)cell;
    }
    return true;
}

/* Chooses the size of the cells: about one for each line, so that a line is in a few of them on average. */
static void choose_cells(const map_search *s, map_grid *g)
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
    const double width = high.x - g->low.x, height = high.y - g->low.y, most = CELLS_PER_LINE * (double)m->line_count;
    const double size =
        greater(sqrt(width) * sqrt(height) / sqrt(most), greater(greater(width, height) / most, length / (2.0 * most)));
    g->size = greater(size, 64.0 * s->margin);
    g->columns = g->rows = 1;
    if (m->line_count <= FEW || !(g->size > 0.0) || !isfinite(g->size))
        g->size = 1.0;
    else {
        g->columns += (size_t)(width / g->size);
        g->rows += (size_t)(height / g->size);
    }
    g->per_size = 1.0 / g->size;
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

/* Marks the cells of open lines as busy, unless all lines are open. False: no memory. */
static bool mark_busy(const map_search *s, map_grid *g)
{
    const size_t lines = s->m->line_count;
    if (!memchr(s->open, 0, lines))
        return true;
    uint8_t *busy = alloc_zeroed(g->columns * g->rows, 1);
    for (uint32_t i = 0; busy && i < lines; i++) {
        g->cell_count = 0;
        if (s->open[i] && !add_cells(s, g, i)) {
            free(busy);
            return false;
        }
        for (size_t k = 0; k < g->cell_count; k++)
            busy[g->cell[k]] = 1;
    }
    g->busy = busy;
    g->cell_count = 0;
    return busy;
}

/* Lists the lines in the busy cells. False: no memory. */
static bool fill_grid(const map_search *s, map_grid *g)
{
    const size_t lines = s->m->line_count;
    choose_cells(s, g);
    const size_t cells = g->columns * g->rows;
    size_t *end = alloc_array(lines, sizeof *end); /* of each line's cells */
    g->start = alloc_zeroed(cells + 2, sizeof *g->start);
    bool enough = end && g->start && mark_busy(s, g);
    for (uint32_t i = 0; enough && i < lines; i++) {
        enough = add_cells(s, g, i);
        end[i] = g->cell_count;
    }
    g->entry = enough ? alloc_array(g->cell_count, sizeof *g->entry) : NULL;
    enough = g->entry;
    for (size_t k = 0; enough && k < g->cell_count; k++)
        g->start[g->cell[k] + 2]++;
    for (size_t c = 0; enough && c < cells; c++)
        g->start[c + 2] += g->start[c + 1];
    size_t k = 0;
    for (uint32_t i = 0; enough && i < lines; i++)
        for (; k < end[i]; k++)
            g->entry[g->start[g->cell[k] + 1]++] = i;
    free(end);
    return enough;
}

bool map_search_all(map_search *s)
{
    map_grid g = {0};
    const planar_map *m = s->m;
    s->stop_count = 0;
    s->joined = false;
    free(s->crowded);
    s->crowded = alloc_zeroed(m->line_count, 1);
    s->last_stop = alloc_array(m->line_count, sizeof *s->last_stop);
    for (size_t i = 0; s->last_stop && i < m->line_count; i++)
        s->last_stop[i] = ROBERTS_NONE;
    bool enough = s->crowded && s->last_stop && array_reserve(&s->fate, &s->fate_room, m->node_count, sizeof *s->fate);
    for (uint32_t n = 0; enough && n < m->node_count; n++)
        s->fate[n] = (map_fate){n, false};
    for (size_t i = 0; enough && i < m->line_count; i++)
        if (s->open[i])
            compare_nodes(s, m->line[i][0], m->line[i][1]);
    enough = enough && fill_grid(s, &g);
    for (size_t row = 0; enough && row < g.rows; row++)
        for (size_t column = 0; column < g.columns && !s->lost; column++)
            visit_cell(s, &g, column, row);
    free(s->last_stop);
    free(g.busy);
    free(g.start);
    free(g.entry);
    free(g.cell);
    return enough && !s->lost;
}
