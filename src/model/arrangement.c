/* arrangement.c - cuts a face that is not convex: its border as a graph whose lines meet only in nodes.
 *
 * Stretches of the border that coincide become one line, with a count of how often the border runs along it. A line
 * that the border runs along equally often both ways bounds nothing and is left out. Nodes that touch are merged, and
 * lines are divided at the nodes that they touch. Then the graph is swept (triangulate.c). If the sweep finds lines
 * that cross, these are divided there, and all begins again. Rounding bends the divided lines, which may cause new
 * crossings; the next sweep finds them. A sweep that finds no crossing gives a tiling, whatever the rounding. The
 * winding number of a region follows from the lines crossed on the way to it. */
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/orient.h"
#include "base/search.h"
#include "base/sort.h"
#include "model/face_pieces.h"

/* Sweeps of one face. From FIRST_WIDER on, the merging distance of nodes doubles with each sweep, which forces an
 * end. */
enum { MOST_SWEEPS = 60, FIRST_WIDER = 40 };

/* A border with more crossings than this is not cut: it would take minutes and gigabytes. */
enum { MOST_CROSSINGS = 1 << 18 };

/* Up to this many pairs of lines are compared directly. With more, only sweeps find crossings. */
#define MOST_PAIRS 0x1p27

bool border_add_stop(border *b, border_stop stop)
{
    if (!array_reserve(&b->stop, &b->stop_room, b->stop_count + 1, sizeof *b->stop))
        return false;
    b->stop[b->stop_count++] = stop;
    return true;
}

bool border_add_crossing(face_pieces *f, border *b, uint32_t i, uint32_t j)
{
    const uint32_t *v = b->item[i].v, *w = b->item[j].v;
    double p = orient2d(f->node[w[0]].at, f->node[w[1]].at, f->node[v[0]].at);
    double q = orient2d(f->node[w[0]].at, f->node[w[1]].at, f->node[v[1]].at);
    double t = p != q ? greater(0.0, lesser(1.0, p / (p - q))) : 0.5;
    uint32_t node = face_pieces_add_crossing(f, v[0], v[1], t);
    return node != ROBERTS_NONE && border_add_stop(b, (border_stop){i, node, 0.0}) &&
           border_add_stop(b, (border_stop){j, node, 0.0});
}

/* ---- all crossings at once ------------------------------------------------------------------------------------- */

/* A line's extent along an axis. */
typedef struct extent {
    double low, high;
    uint32_t line;
} extent;

static int compare_extents(const void *pa, const void *pb)
{
    const extent *a = pa, *b = pb;
    if (a->low != b->low)
        return a->low < b->low ? -1 : 1;
    return (a->line > b->line) - (a->line < b->line);
}

static double coordinate(const face_pieces *f, uint32_t node, int axis)
{
    return axis == 0 ? f->node[node].at.x : f->node[node].at.y;
}

/* Sorts the lines along an axis, and counts the pairs whose extents overlap there. */
static double sort_extents(const face_pieces *f, const border *b, int axis, extent *item)
{
    double pairs = 0.0;
    for (uint32_t i = 0; i < b->count; i++) {
        double p = coordinate(f, b->item[i].v[0], axis), q = coordinate(f, b->item[i].v[1], axis);
        item[i] = (extent){lesser(p, q), greater(p, q), i};
    }
    if (b->count > 1)
        qsort(item, b->count, sizeof *item, compare_extents);
    for (size_t i = 0; i < b->count; i++) {
        const extent last = {.low = item[i].high, .line = UINT32_MAX};
        pairs += (double)find_first(&last, item + i + 1, b->count - i - 1, sizeof *item, compare_extents);
    }
    return pairs;
}

/* Records where two lines cross. Lines that only touch are left to the sweep. False: no memory. */
static bool cross(face_pieces *f, border *b, uint32_t i, uint32_t j)
{
    const uint32_t *v = b->item[i].v, *w = b->item[j].v;
    roberts_vec2 A = f->node[v[0]].at, B = f->node[v[1]].at, C = f->node[w[0]].at, D = f->node[w[1]].at;
    double c = orient2d(A, B, C), d = orient2d(A, B, D);
    if (!((c > 0.0 && d < 0.0) || (c < 0.0 && d > 0.0)))
        return true;
    double p = orient2d(C, D, A), q = orient2d(C, D, B);
    return !((p > 0.0 && q < 0.0) || (p < 0.0 && q > 0.0)) || border_add_crossing(f, b, i, j);
}

/* Replaces the crossings found by a sweep by those of all pairs of lines, unless there are too many pairs. Stops early
 * if there are too many crossings. A sweep finds at least one crossing of each tangle, but seldom all. False: no
 * memory. */
static bool cross_all(face_pieces *f, border *b)
{
    extent *item = alloc_array(b->count, sizeof *item);
    size_t most = 2 * ((size_t)MOST_CROSSINGS + 1);
    if (!item)
        return false;
    double along_x = sort_extents(f, b, 0, item), along_y = sort_extents(f, b, 1, item);
    int axis = along_x <= along_y ? 0 : 1;
    bool enough = true, few = lesser(along_x, along_y) <= MOST_PAIRS;
    if (few) {
        b->stop_count = 0;
        sort_extents(f, b, axis, item);
    }
    for (size_t i = 0; few && enough && i < b->count; i++) {
        const border_line *own = &b->item[item[i].line];
        double p = coordinate(f, own->v[0], 1 - axis), q = coordinate(f, own->v[1], 1 - axis);
        double low = lesser(p, q), high = greater(p, q);
        for (size_t k = i + 1; enough && k < b->count && item[k].low <= item[i].high && b->stop_count < most; k++) {
            const border_line *other = &b->item[item[k].line];
            p = coordinate(f, other->v[0], 1 - axis);
            q = coordinate(f, other->v[1], 1 - axis);
            if (lesser(p, q) <= high && low <= greater(p, q))
                enough = cross(f, b, item[i].line, item[k].line);
        }
    }
    free(item);
    return enough;
}

/* ---- nodes on lines ---------------------------------------------------------------------------------------------- */

/* Up to this many pairs of lines and nodes are compared directly; with more, a tree finds the lines near a node. */
enum { FEW_PAIRS = 4096 };

/* Does the node lie within `touching` of a line, between its ends and apart from them? */
static bool lies_on(const face_pieces *f, const border_line *line, uint32_t node, double touching)
{
    const roberts_vec2 A = f->node[line->v[0]].at, B = f->node[line->v[1]].at, P = f->node[node].at;
    const double dx = B.x - A.x, dy = B.y - A.y, x = P.x - A.x, y = P.y - A.y, off = fabs(dx * y - dy * x);
    if (node == line->v[0] || node == line->v[1] || off > 2.0 * touching * greater(fabs(dx), fabs(dy)))
        return false; /* most are excluded without a root */
    const double length = hypot(dx, dy), at = (dx * x + dy * y) / length;
    return off <= touching * length && at > touching && at < length - touching;
}

/* Makes a tree over the boxes of the lines, widened by `touching`. False: no memory. */
static bool make_line_tree(const face_pieces *f, const border *b, double touching, box_tree *tree)
{
    box3 *box = alloc_array(b->count, sizeof *box);
    uint32_t root;
    for (size_t i = 0; box && i < b->count; i++) {
        const roberts_vec2 A = f->node[b->item[i].v[0]].at, B = f->node[b->item[i].v[1]].at;
        box[i] = (box3){{lesser(A.x, B.x) - touching, lesser(A.y, B.y) - touching, 0.0},
                        {greater(A.x, B.x) + touching, greater(A.y, B.y) + touching, 0.0}};
    }
    const bool enough = box && box_tree_add(tree, box, (uint32_t)b->count, 0, &root);
    free(box);
    return enough;
}

/* Adds a stop to each line of the tree on which the node lies. False: no memory. */
static bool stop_near_lines(const face_pieces *f, border *b, const box_tree *tree, uint32_t node, double touching)
{
    const roberts_vec2 P = f->node[node].at;
    const box3 at = {{P.x, P.y, 0.0}, {P.x, P.y, 0.0}};
    box_search near = box_search_begin(tree, 0, &at);
    for (uint32_t i; box_search_next(&near, &i);)
        if (lies_on(f, &b->item[i], node, touching) && !border_add_stop(b, (border_stop){i, node, 0.0}))
            return false;
    return true;
}

/* Adds a stop wherever a node lies on a line. An exact sweep finds such a node only if it lies on the line exactly, and
 * would otherwise leave a sliver of a piece. False: no memory. */
static bool stop_at_nodes(const face_pieces *f, border *b, double touching)
{
    const bool few = (double)f->node_count * (double)b->count <= FEW_PAIRS;
    uint8_t *is_end = alloc_zeroed(f->node_count, 1); /* of a line; others have been merged */
    box_tree tree = {0};
    bool enough = is_end && (few || make_line_tree(f, b, touching, &tree));
    for (size_t i = 0; enough && i < b->count; i++)
        is_end[b->item[i].v[0]] = is_end[b->item[i].v[1]] = 1;
    for (uint32_t n = 0; enough && n < f->node_count; n++) {
        if (!is_end[n])
            continue;
        if (!few)
            enough = stop_near_lines(f, b, &tree, n, touching);
        for (uint32_t i = 0; few && enough && i < b->count; i++)
            if (lies_on(f, &b->item[i], n, touching))
                enough = border_add_stop(b, (border_stop){i, n, 0.0});
    }
    box_tree_free(&tree);
    free(is_end);
    return enough;
}

/* ---- division -------------------------------------------------------------------------------------------------- */

static size_t slot_of(double x, double y, size_t mask)
{
    uint64_t h = ((uint64_t)(int64_t)x * 0x9e3779b97f4a7c15u) ^ ((uint64_t)(int64_t)y * 0xc2b2ae3d27d4eb4fu);
    return (size_t)(h ^ h >> 29) & mask;
}

/* Sets same[n] to the first node within `touching` of node n, using a hash grid. False: no memory. */
static bool join_nodes(const face_pieces *f, double touching, uint32_t *same)
{
    size_t size = 16;
    while (size < 2 * f->node_count)
        size *= 2;
    uint32_t *slot = alloc_array(size, sizeof *slot);
    double cell = touching > 0.0 ? 2.0 * touching : 1.0;
    if (!slot)
        return false;
    for (size_t i = 0; i < size; i++)
        slot[i] = ROBERTS_NONE;
    for (uint32_t n = 0; n < f->node_count; n++) {
        roberts_vec2 P = f->node[n].at;
        double x = floor(P.x / cell), y = floor(P.y / cell);
        uint32_t found = ROBERTS_NONE;
        for (int k = 0; k < 9; k++)
            for (size_t at = slot_of(x + k % 3 - 1, y + (int)(k / 3) - 1, size - 1); slot[at] != ROBERTS_NONE;
                 at = (at + 1) & (size - 1)) {
                roberts_vec2 Q = f->node[slot[at]].at;
                if (slot[at] < found && hypot(P.x - Q.x, P.y - Q.y) <= touching)
                    found = slot[at];
            }
        same[n] = found == ROBERTS_NONE ? n : found;
        if (found != ROBERTS_NONE)
            continue;
        size_t at = slot_of(x, y, size - 1);
        while (slot[at] != ROBERTS_NONE)
            at = (at + 1) & (size - 1);
        slot[at] = n;
    }
    free(slot);
    return true;
}

static int compare_stops(const void *pa, const void *pb)
{
    const border_stop *a = pa, *b = pb;
    if (a->line != b->line)
        return a->line < b->line ? -1 : 1;
    if (a->t != b->t)
        return a->t < b->t ? -1 : 1;
    return (a->node > b->node) - (a->node < b->node);
}

static int compare_lines(const void *pa, const void *pb)
{
    const border_line *a = pa, *b = pb;
    if (a->v[0] != b->v[0])
        return a->v[0] < b->v[0] ? -1 : 1;
    if (a->v[1] != b->v[1])
        return a->v[1] < b->v[1] ? -1 : 1;
    return (a->side > b->side) - (a->side < b->side);
}

/* Merges coincident lines, and removes those that bound nothing. */
static void unite_lines(border *b)
{
    size_t to = 0;
    if (b->count > 1)
        qsort(b->item, b->count, sizeof *b->item, compare_lines);
    for (size_t i = 0, k; i < b->count; i = k) {
        border_line own = b->item[i];
        for (k = i + 1; k < b->count && b->item[k].v[0] == own.v[0] && b->item[k].v[1] == own.v[1]; k++)
            own.net += b->item[k].net;
        if (own.net != 0)
            b->item[to++] = own;
    }
    b->count = to;
}

static border_line line_of(uint32_t from, uint32_t to, int32_t net, uint32_t side)
{
    return (border_line){{from < to ? from : to, from < to ? to : from}, from < to ? net : -net, side};
}

/* Makes a line of each side of the ring. False: no memory. */
static bool take_sides(const face_pieces *f, border *b)
{
    b->item = alloc_array(f->ring_count, sizeof *b->item);
    for (uint32_t i = 0; b->item && i < f->ring_count; i++) {
        uint32_t from = f->ring[i], to = f->ring[i + 1 < f->ring_count ? i + 1 : 0];
        if (from != to)
            b->item[b->count++] = line_of(from, to, 1, f->side_of[i]);
    }
    if (b->item)
        unite_lines(b);
    return b->item != NULL;
}

/* Returns where a node lies along a line, times the line's length squared. */
static double along(const face_pieces *f, const border_line *line, uint32_t node)
{
    roberts_vec2 A = f->node[line->v[0]].at, B = f->node[line->v[1]].at, P = f->node[node].at;
    return (P.x - A.x) * (B.x - A.x) + (P.y - A.y) * (B.y - A.y);
}

/* Divides the lines at their stops. same[]: from join_nodes(). False: no memory. */
static bool divide_border(const face_pieces *f, border *b, const uint32_t *same)
{
    size_t k = 0, to = 0;
    border_line *item = alloc_array(b->count + b->stop_count, sizeof *item);
    if (!item)
        return false;
    for (size_t i = 0; i < b->stop_count; i++) {
        b->stop[i].node = same[b->stop[i].node];
        b->stop[i].t = along(f, &b->item[b->stop[i].line], b->stop[i].node);
    }
    if (b->stop_count > 1)
        qsort(b->stop, b->stop_count, sizeof *b->stop, compare_stops);
    for (uint32_t i = 0; i < b->count; i++) {
        const border_line *own = &b->item[i];
        uint32_t from = same[own->v[0]];
        for (bool more = true; more;) {
            more = k < b->stop_count && b->stop[k].line == i;
            uint32_t node = more ? b->stop[k++].node : same[own->v[1]];
            if (node == from)
                continue;
            item[to++] = line_of(from, node, own->net, own->side);
            from = node;
        }
    }
    free(b->item);
    b->item = item;
    b->count = to;
    unite_lines(b);
    return true;
}

/* Merges coincident corners of the ring into one node. *apart: some of them are different vertices. False: no
 * memory. */
static bool join_ring(face_pieces *f, double touching, bool *apart)
{
    uint32_t *same = alloc_array(f->node_count, sizeof *same);
    bool enough = same && join_nodes(f, touching, same);
    for (size_t r = 0; enough && r < f->ring_count; r++) {
        *apart = *apart || same[f->ring[r]] != f->ring[r];
        f->ring[r] = same[f->ring[r]];
    }
    free(same);
    return enough;
}

/* Finds where lines are to be divided. If nowhere, the face is cut into triangles. first: cross_all() has not run yet.
 */
static tiling find_stops(face_pieces *f, border *b, const face_rules *rules, bool *first)
{
    b->stop_count = 0;
    if (!stop_at_nodes(f, b, rules->touching / rules->unit))
        return TILING_NO_MEMORY;
    if (b->stop_count > 0)
        return TILING_CROSSED;
    tiling found = face_pieces_triangulate(f, b, rules->even_odd);
    if (found == TILING_CROSSED && *first) {
        *first = false;
        if (!cross_all(f, b))
            return TILING_NO_MEMORY;
    }
    return found;
}

/* Sweeps and divides until no lines cross, and no node lies on a line. *crossed: lines were divided. */
static tiling sweep_border(face_pieces *f, border *b, const face_rules *rules, bool *crossed)
{
    double touching = rules->touching / rules->unit;
    size_t corners = f->node_count;
    bool first = true;
    for (int sweeps = 0; sweeps < MOST_SWEEPS; sweeps++) {
        tiling found = find_stops(f, b, rules, &first);
        if (found != TILING_CROSSED)
            return found;
        *crossed = true;
        if (f->node_count - corners > MOST_CROSSINGS)
            return TILING_BROKEN;
        touching *= sweeps < FIRST_WIDER ? 1.0 : 2.0;
        uint32_t *same = alloc_array(f->node_count, sizeof *same);
        bool enough = same && join_nodes(f, touching, same) && divide_border(f, b, same);
        free(same);
        if (!enough)
            return TILING_NO_MEMORY;
    }
    return TILING_BROKEN;
}

/* Lists the sides of the triangles of a face that is not planar. False: no memory. */
static bool list_sides(face_pieces *f, const border *b)
{
    for (uint32_t p = 0; p < f->piece_count; p++)
        for (uint32_t i = 0; i < 3; i++) {
            const face_piece *own = &f->piece[p];
            uint32_t side = own->label[i] < b->count ? b->item[own->label[i]].side : ROBERTS_NONE;
            if (!face_pieces_add_side(f, (piece_side){own->node[i], own->node[(i + 1) % 3], p, side}))
                return false;
        }
    return true;
}

/* Does the stretch run in the direction of its side of the ring? */
static bool runs_along(const face_pieces *f, const piece_side *s, uint32_t from, uint32_t to)
{
    roberts_vec2 A = f->node[from].at, B = f->node[to].at, P = f->node[s->from].at, Q = f->node[s->to].at;
    return (B.x - A.x) * (Q.x - P.x) + (B.y - A.y) * (Q.y - P.y) > 0.0;
}

/* A stretch of a side of the ring, and where it lies on that side. */
typedef struct placed_side {
    uint32_t side;
    double t0, t1;
    bool off; /* it is not on the side in space */
    piece_side own;
} placed_side;

static int compare_placed(const void *pa, const void *pb)
{
    const placed_side *a = pa, *b = pb;
    if (a->side != b->side)
        return a->side < b->side ? -1 : 1;
    if (a->t0 != b->t0)
        return a->t0 < b->t0 ? -1 : 1;
    if (a->t1 != b->t1)
        return a->t1 < b->t1 ? -1 : 1;
    return (a->own.piece > b->own.piece) - (a->own.piece < b->own.piece);
}

/* Returns where a node lies along AB in space. Sets *off if it is farther from AB than `most`. */
static double place_on(const piece_node *node, roberts_vec3 A, roberts_vec3 B, double most, bool *off)
{
    roberts_vec3 d = vec3_sub(B, A), p = vec3_add(vec3_sub(node->point, A), node->low);
    double t = vec3_dot(p, d) / vec3_dot(d, d);
    *off = *off || !(vec3_length(vec3_sub(p, vec3_scale(t, d))) <= most);
    return vec3_part_along(p, d);
}

/* Finds where each stretch lies on its side. given: the ring before merging, since nodes that coincide in the plane may
 * be apart in space. NULL: no memory. */
static placed_side *place_sides(const face_pieces *f, const uint32_t *given, double touching)
{
    placed_side *placed = alloc_array(f->side_count, sizeof *placed);
    uint32_t *at = alloc_array(f->ring_count > 0 ? f->side_of[f->ring_count - 1] + (size_t)1 : 0, sizeof *at);
    for (uint32_t i = 0; at && i < f->ring_count; i++)
        at[f->side_of[i]] = i;
    for (size_t i = 0; placed && at && i < f->side_count; i++) {
        const piece_side *s = &f->side[i];
        uint32_t r = at[s->side];
        roberts_vec3 A = f->node[given[r]].point, B = f->node[given[r + 1 < f->ring_count ? r + 1 : 0]].point;
        bool off = false;
        double t = place_on(&f->node[s->from], A, B, touching, &off);
        double u = place_on(&f->node[s->to], A, B, touching, &off);
        placed[i] = (placed_side){s->side, lesser(t, u), greater(t, u), off, *s};
    }
    free(at);
    if (!at) {
        free(placed);
        placed = NULL;
    }
    if (placed && f->side_count > 1)
        qsort(placed, f->side_count, sizeof *placed, compare_placed);
    return placed;
}

/* Are the stretches of each side on it, one after the other? */
static bool follow(const placed_side *placed, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const placed_side *a = &placed[i], *b = a + 1;
        if (a->off)
            return false;
        if (i + 1 < count && a->side == b->side && b->t0 < a->t1 && !(a->t0 == b->t0 && a->t1 == b->t1))
            return false;
    }
    return true;
}

/* Adds side i of the ring whole, with the piece of a stretch. The stretch lies on this side or, if this side has no
 * length in the plane, on one beside it. */
static bool add_whole_side(face_pieces *f, const uint32_t *given, size_t i, const placed_side *stretch, bool along)
{
    uint32_t from = given[i], to = given[i + 1 < f->ring_count ? i + 1 : 0];
    piece_side whole = {along ? from : to, along ? to : from, stretch->own.piece, f->side_of[i]};
    return from == to || face_pieces_add_side(f, whole);
}

/* If a crossing does not lie on its sides in space, since the border is not quite planar or nodes that touch have
 * become one, edges cannot be divided there: other faces would not find their parts. The edges are then the whole
 * sides, each with one of the pieces along it. A side without length in the plane has no piece along it, and takes that
 * of the next side that has one. A side that the border runs along both ways has none either, but has length. */
static bool take_whole_sides(face_pieces *f, const uint32_t *given, double touching)
{
    size_t count = f->side_count, k = count;
    placed_side *placed = place_sides(f, given, touching);
    bool enough = placed != NULL;
    if (enough && !follow(placed, count)) {
        const placed_side *next = &placed[0];
        size_t first = 0;
        while (f->side_of[first] != next->side)
            first++;
        bool along = runs_along(f, &next->own, given[first], given[first + 1 < f->ring_count ? first + 1 : 0]);
        f->side_count = 0;
        f->whole_sides = true;
        for (size_t i = f->ring_count; enough && i-- > 0;) { /* side_of[] ascends */
            uint32_t after = i + 1 < f->ring_count ? (uint32_t)i + 1 : 0;
            while (k > 0 && placed[k - 1].side >= f->side_of[i])
                k--;
            if (k < count && placed[k].side == f->side_of[i]) {
                next = &placed[k];
                along = runs_along(f, &next->own, given[i], given[after]);
            } else if (f->ring[i] != f->ring[after])
                continue;
            enough = add_whole_side(f, given, i, next, along);
        }
    }
    free(placed);
    return enough;
}

bool face_pieces_arrange(face_pieces *f, const face_rules *rules)
{
    border b = {0};
    bool crossed = false;
    tiling found = TILING_NO_MEMORY;
    uint32_t *given = alloc_array(f->ring_count, sizeof *given);
    if (!given)
        return false;
    memcpy(given, f->ring, f->ring_count * sizeof *given);
    if (join_ring(f, rules->touching / rules->unit, &crossed) && take_sides(f, &b))
        found = sweep_border(f, &b, rules, &crossed);
    f->bent = crossed && !f->planar;
    f->planar = f->planar || crossed;
    f->uncut = found == TILING_BROKEN;
    bool enough =
        found != TILING_NO_MEMORY && (f->planar ? face_pieces_join(f, &b, rules->keep_straight) : list_sides(f, &b));
    if (enough && crossed && f->side_count > 0)
        enough = take_whole_sides(f, given, rules->touching);
    free(given);
    free(b.item);
    free(b.stop);
    return enough;
}
