/* arrangement.c - cuts a face whose border crosses or touches itself into cells, and counts how often the border winds
 * round each.
 *
 * Sides are divided where they cross, and at corners that lie on them. The stretches are then walked cell by cell: at
 * each node the walk takes the leftmost stretch. From a cell to its neighbour the winding number changes by the number
 * of times that the border runs along the stretch between them. A slit (a stretch that the border runs along both ways)
 * bounds nothing. */
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/dd.h"
#include "model/face_pieces.h"

/* A border that departs from its plane by more than this part of the touching distance is not quite planar:
 * crossings of two faces at one edge may lie farther apart than what touches. */
#define PLANAR_PART 0x1p-10

/* A point on a stretch, at t along it. */
typedef struct side_stop {
    uint32_t side, node;
    double t;
} side_stop;

/* A stretch between two nodes, in the direction of the smaller one to the larger. */
typedef struct stretch {
    uint32_t v[2];
    int32_t net;   /* how often the border runs this way, minus how often it runs back */
    uint32_t side; /* the first side of the face that it is part of */
} stretch;

/* Half-edge 2 s runs along stretch s, 2 s + 1 back. */
typedef struct arrangement {
    side_stop *stop;
    stretch *item;
    uint32_t *next, *cell; /* [2 count] of each half-edge */
    uint32_t *around;      /* [2 count] half-edges by the node they leave, counter-clockwise */
    uint32_t *start;       /* [nodes + 1] into around */
    uint32_t *place;       /* [2 count] in around */
    int32_t *winding;      /* [cells] */
    double *area;          /* [cells] twice */
    uint32_t *ring;        /* scratch: nodes of a cell, */
    uint32_t *ring_half;   /* and their half-edges */
    size_t stop_count, stop_room, count, cells;
} arrangement;

static bool add_stop(arrangement *a, uint32_t side, uint32_t node, double t)
{
    if (!array_reserve(&a->stop, &a->stop_room, a->stop_count + 1, sizeof *a->stop))
        return false;
    a->stop[a->stop_count++] = (side_stop){side, node, t};
    return true;
}

/* Where P lies along AB, and how far beside it. */
static double along(roberts_vec2 A, roberts_vec2 B, roberts_vec2 P, double *beside)
{
    double dx = B.x - A.x, dy = B.y - A.y, squared = dx * dx + dy * dy;
    double t = squared > 0.0 ? ((P.x - A.x) * dx + (P.y - A.y) * dy) / squared : 0.0;
    *beside = hypot(P.x - (A.x + t * dx), P.y - (A.y + t * dy));
    return t;
}

static double interpolate(double a, double b, double t, double *low)
{
    dd p = dd_add((dd){a, 0.0}, dd_mul((dd){t, 0.0}, dd_two_diff(b, a)));
    *low = p.lo;
    return p.hi;
}

/* The crossing at t of AB. ROBERTS_NONE: no memory. */
static uint32_t add_crossing(face_pieces *f, uint32_t a, uint32_t b, double t)
{
    const piece_node A = f->node[a], B = f->node[b];
    piece_node X = {.at = {A.at.x + t * (B.at.x - A.at.x), A.at.y + t * (B.at.y - A.at.y)}, .vertex = ROBERTS_NONE};
    X.point =
        (roberts_vec3){interpolate(A.point.x, B.point.x, t, &X.low.x), interpolate(A.point.y, B.point.y, t, &X.low.y),
                       interpolate(A.point.z, B.point.z, t, &X.low.z)};
    if (f->node_count >= ROBERTS_NONE - 1 ||
        !array_reserve(&f->node, &f->node_room, f->node_count + 1, sizeof *f->node))
        return ROBERTS_NONE;
    f->node[f->node_count] = X;
    return (uint32_t)f->node_count++;
}

/* A corner of another stretch that lies within stretch i. *touches: there is one. */
static bool stop_at_corner(face_pieces *f, arrangement *a, uint32_t i, uint32_t node, double touching, bool *touches)
{
    uint32_t from = a->item[i].v[0], to = a->item[i].v[1];
    double beside, t = along(f->node[from].at, f->node[to].at, f->node[node].at, &beside);
    double length = hypot(f->node[to].at.x - f->node[from].at.x, f->node[to].at.y - f->node[from].at.y);
    if (node == from || node == to || beside > touching || t * length <= touching || (1.0 - t) * length <= touching)
        return true;
    *touches = true;
    return add_stop(a, i, node, t);
}

/* Stretches i and j, whose boxes meet along x. */
static bool stop_at_crossing(face_pieces *f, arrangement *a, uint32_t i, uint32_t j, double touching)
{
    uint32_t va = a->item[i].v[0], vb = a->item[i].v[1], vc = a->item[j].v[0], vd = a->item[j].v[1];
    roberts_vec2 A = f->node[va].at, B = f->node[vb].at, C = f->node[vc].at, D = f->node[vd].at;
    bool touches = false;
    if (lesser(A.y, B.y) > greater(C.y, D.y) + touching || lesser(C.y, D.y) > greater(A.y, B.y) + touching)
        return true;
    if (!stop_at_corner(f, a, i, vc, touching, &touches) || !stop_at_corner(f, a, i, vd, touching, &touches) ||
        !stop_at_corner(f, a, j, va, touching, &touches) || !stop_at_corner(f, a, j, vb, touching, &touches))
        return false;
    if (touches || va == vc || va == vd || vb == vc || vb == vd)
        return true;
    double c = piece_turn(A, B, C), d = piece_turn(A, B, D), p = piece_turn(C, D, A), q = piece_turn(C, D, B);
    if (!((c > 0.0 && d < 0.0) || (c < 0.0 && d > 0.0)) || !((p > 0.0 && q < 0.0) || (p < 0.0 && q > 0.0)))
        return true;
    double t = p / (p - q), s = c / (c - d);
    uint32_t node = add_crossing(f, va, vb, t);
    return node != ROBERTS_NONE && add_stop(a, i, node, t) && add_stop(a, j, node, s);
}

/* A stretch by where it begins along x. */
typedef struct sweep_item {
    double low, high;
    uint32_t stretch;
} sweep_item;

static int compare_sweep(const void *pa, const void *pb)
{
    const sweep_item *a = pa, *b = pb;
    if (a->low != b->low)
        return a->low < b->low ? -1 : 1;
    return (a->stretch > b->stretch) - (a->stretch < b->stretch);
}

/* Crosses all pairs of stretches whose boxes meet along x. */
static bool find_stops(face_pieces *f, arrangement *a, double touching)
{
    size_t count = a->count;
    sweep_item *item = alloc_array(count, sizeof *item);
    bool enough = item != NULL;
    for (uint32_t i = 0; enough && i < count; i++) {
        double x = f->node[a->item[i].v[0]].at.x, y = f->node[a->item[i].v[1]].at.x;
        item[i] = (sweep_item){lesser(x, y), greater(x, y) + touching, i};
    }
    if (enough)
        qsort(item, count, sizeof *item, compare_sweep);
    for (size_t i = 0; enough && i < count; i++)
        for (size_t k = i + 1; enough && k < count && item[k].low <= item[i].high; k++) {
            uint32_t p = item[i].stretch, q = item[k].stretch;
            enough = stop_at_crossing(f, a, p < q ? p : q, p < q ? q : p, touching);
        }
    free(item);
    return enough;
}

static size_t slot_of(double x, double y, size_t mask)
{
    uint64_t h = ((uint64_t)(int64_t)x * 0x9e3779b97f4a7c15u) ^ ((uint64_t)(int64_t)y * 0xc2b2ae3d27d4eb4fu);
    return (size_t)(h ^ h >> 29) & mask;
}

/* same[n]: the first node that lies within `touching` of node n, by cells of that size. False: no memory. */
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

/* Is a node met twice? */
static bool ring_repeats(const face_pieces *f, uint32_t *seen)
{
    for (size_t n = 0; n < f->node_count; n++)
        seen[n] = 0;
    for (size_t r = 0; r < f->ring_count; r++)
        if (seen[f->ring[r]]++)
            return true;
    return false;
}

static int compare_stops(const void *pa, const void *pb)
{
    const side_stop *a = pa, *b = pb;
    if (a->side != b->side)
        return a->side < b->side ? -1 : 1;
    if (a->t != b->t)
        return a->t < b->t ? -1 : 1;
    return (a->node > b->node) - (a->node < b->node);
}

static int compare_stretches(const void *pa, const void *pb)
{
    const stretch *a = pa, *b = pb;
    if (a->v[0] != b->v[0])
        return a->v[0] < b->v[0] ? -1 : 1;
    if (a->v[1] != b->v[1])
        return a->v[1] < b->v[1] ? -1 : 1;
    return (a->side > b->side) - (a->side < b->side);
}

/* Joins stretches that lie on one another. */
static void unite_stretches(arrangement *a)
{
    size_t to = 0;
    qsort(a->item, a->count, sizeof *a->item, compare_stretches);
    for (size_t i = 0; i < a->count; i++) {
        if (to && a->item[to - 1].v[0] == a->item[i].v[0] && a->item[to - 1].v[1] == a->item[i].v[1])
            a->item[to - 1].net += a->item[i].net;
        else
            a->item[to++] = a->item[i];
    }
    a->count = to;
}

static stretch stretch_of(uint32_t from, uint32_t to, int32_t net, uint32_t side)
{
    return (stretch){{from < to ? from : to, from < to ? to : from}, from < to ? net : -net, side};
}

/* The sides of the ring. */
static bool take_sides(const face_pieces *f, arrangement *a)
{
    a->item = alloc_array(f->ring_count, sizeof *a->item);
    for (uint32_t i = 0; a->item && i < f->ring_count; i++) {
        uint32_t from = f->ring[i], to = f->ring[i + 1 < f->ring_count ? i + 1 : 0];
        if (from != to)
            a->item[a->count++] = stretch_of(from, to, 1, f->side_of[i]);
    }
    if (a->item)
        unite_stretches(a);
    return a->item != NULL;
}

/* Divides the stretches at their stops. same[]: from join_nodes(). */
static bool divide(arrangement *a, const uint32_t *same)
{
    size_t k = 0, to = 0;
    stretch *item = alloc_array(a->count + a->stop_count, sizeof *item);
    if (!item)
        return false;
    if (a->stop_count > 1)
        qsort(a->stop, a->stop_count, sizeof *a->stop, compare_stops);
    for (uint32_t i = 0; i < a->count; i++) {
        const stretch *own = &a->item[i];
        uint32_t from = same[own->v[0]];
        for (bool more = true; more;) {
            more = k < a->stop_count && a->stop[k].side == i;
            uint32_t node = same[more ? a->stop[k++].node : own->v[1]];
            if (node == from)
                continue;
            item[to++] = stretch_of(from, node, own->net, own->side);
            from = node;
        }
    }
    free(a->item);
    a->item = item;
    a->count = to;
    unite_stretches(a);
    return true;
}

/* Leaves out stretches that lead nowhere: the border runs along them both ways, and they end without a neighbour. */
static void drop_dead_ends(const face_pieces *f, arrangement *a, uint32_t *degree)
{
    for (bool again = true; again;) {
        size_t to = 0;
        for (size_t n = 0; n < f->node_count; n++)
            degree[n] = 0;
        for (size_t i = 0; i < a->count; i++) {
            degree[a->item[i].v[0]]++;
            degree[a->item[i].v[1]]++;
        }
        for (size_t i = 0; i < a->count; i++) {
            uint32_t *p = &degree[a->item[i].v[0]], *q = &degree[a->item[i].v[1]];
            if (*p > 1 && *q > 1) {
                a->item[to++] = a->item[i];
                continue;
            }
            --*p; /* if the next one comes later, this pass meets it */
            --*q;
        }
        again = to < a->count;
        a->count = to;
    }
}

static uint32_t half_from(const arrangement *a, uint32_t h)
{
    return a->item[h / 2].v[h % 2];
}

static uint32_t half_to(const arrangement *a, uint32_t h)
{
    return a->item[h / 2].v[1 - h % 2];
}

/* Does half-edge g come before h, counter-clockwise round their node, starting from the right? */
static bool turns_before(const face_pieces *f, const arrangement *a, uint32_t g, uint32_t h)
{
    roberts_vec2 O = f->node[half_from(a, g)].at, P = f->node[half_to(a, g)].at, Q = f->node[half_to(a, h)].at;
    bool low_p = P.y < O.y || (P.y == O.y && P.x < O.x), low_q = Q.y < O.y || (Q.y == O.y && Q.x < O.x);
    if (low_p != low_q)
        return low_q;
    double turn = piece_turn(O, P, Q);
    return turn != 0.0 ? turn > 0.0 : g < h;
}

/* Sorts the half-edges round each node, and finds which one follows which round a cell. */
static void link_halves(const face_pieces *f, arrangement *a)
{
    size_t halves = 2 * a->count, nodes = f->node_count;
    for (size_t n = 0; n <= nodes; n++)
        a->start[n] = 0;
    for (uint32_t h = 0; h < halves; h++)
        a->start[half_from(a, h) + 1]++;
    for (size_t n = 0; n < nodes; n++)
        a->start[n + 1] += a->start[n];
    for (size_t n = nodes; n > 0; n--)
        a->start[n] = a->start[n - 1];
    for (uint32_t h = 0; h < halves; h++)
        a->around[a->start[half_from(a, h) + 1]++] = h; /* which becomes the next node's start */
    for (size_t n = 0; n < nodes; n++)
        for (uint32_t i = a->start[n] + 1; i < a->start[n + 1]; i++) {
            uint32_t h = a->around[i], k = i;
            for (; k > a->start[n] && turns_before(f, a, h, a->around[k - 1]); k--)
                a->around[k] = a->around[k - 1];
            a->around[k] = h;
        }
    for (uint32_t k = 0; k < halves; k++)
        a->place[a->around[k]] = k;
    for (uint32_t h = 0; h < halves; h++) {
        uint32_t n = half_to(a, h), back = a->place[h ^ 1];
        a->next[h] = a->around[back > a->start[n] ? back - 1 : a->start[n + 1] - 1];
    }
}

/* Numbers the cells, and measures them. */
static void walk_cells(const face_pieces *f, arrangement *a)
{
    a->cells = 0;
    for (size_t h = 0; h < 2 * a->count; h++)
        a->cell[h] = ROBERTS_NONE;
    for (uint32_t first = 0; first < 2 * a->count; first++) {
        if (a->cell[first] != ROBERTS_NONE)
            continue;
        roberts_vec2 O = f->node[half_from(a, first)].at;
        double area = 0.0;
        for (uint32_t h = first; a->cell[h] == ROBERTS_NONE; h = a->next[h]) {
            a->cell[h] = (uint32_t)a->cells;
            area += piece_turn(O, f->node[half_from(a, h)].at, f->node[half_to(a, h)].at);
        }
        a->area[a->cells++] = area;
    }
}

/* Counts from the outer cell inward: from each cell to those across its stretches. */
static void wind(arrangement *a)
{
    size_t outer = 0, waiting = 0;
    uint32_t *first = a->ring, *stack = a->ring_half; /* a half-edge of each cell */
    for (size_t c = 0; c < a->cells; c++) {
        a->winding[c] = INT32_MIN;
        outer = a->area[c] < a->area[outer] ? c : outer;
    }
    if (a->cells == 0)
        return;
    for (uint32_t h = 0; h < 2 * a->count; h++)
        first[a->cell[h]] = h;
    a->winding[outer] = 0;
    stack[waiting++] = (uint32_t)outer;
    while (waiting > 0) {
        uint32_t cell = stack[--waiting], h = first[cell];
        do {
            uint32_t other = a->cell[h ^ 1];
            if (a->winding[other] == INT32_MIN) { /* to the right of h, which changes it by what runs along h */
                a->winding[other] = a->winding[cell] - (h % 2 ? -a->item[h / 2].net : a->item[h / 2].net);
                stack[waiting++] = other;
            }
            h = a->next[h];
        } while (h != first[cell]);
    }
}

/* Takes the pieces of one cell, and the sides of the face along it. */
static bool take_cell(face_pieces *f, arrangement *a, uint32_t first)
{
    uint32_t count = 0, h = first;
    size_t piece = f->piece_count;
    do {
        a->ring[count] = half_from(a, h);
        a->ring_half[count++] = h;
        h = a->next[h];
    } while (h != first);
    if (count < 3)
        return true;
    if (!face_pieces_triangulate(f, a->ring, count, true))
        return false;
    for (; piece < f->piece_count; piece++)
        for (uint32_t i = 0; i < f->piece[piece].count; i++) {
            const face_piece *p = &f->piece[piece];
            uint32_t to = p->node[i + 1 < p->count ? i + 1 : 0];
            if (p->label[i] >= count || a->item[a->ring_half[p->label[i]] / 2].net == 0)
                continue;
            if (!face_pieces_add_side(
                    f, (piece_side){p->node[i], to, (uint32_t)piece, a->item[a->ring_half[p->label[i]] / 2].side}))
                return false;
        }
    return true;
}

static bool take_cells(face_pieces *f, arrangement *a, bool even_odd)
{
    for (uint32_t h = 0; h < 2 * a->count; h++) {
        uint32_t cell = a->cell[h];
        if (cell == ROBERTS_NONE)
            continue;
        int32_t winding = a->winding[cell];
        bool filled = winding != INT32_MIN && (even_odd ? winding % 2 != 0 : winding != 0) && a->area[cell] > 0.0;
        if (filled && !take_cell(f, a, h))
            return false;
        for (uint32_t k = h; a->cell[k] == cell; k = a->next[k])
            a->cell[k] = ROBERTS_NONE; /* taken */
    }
    return true;
}

static bool alloc_arrangement(const face_pieces *f, arrangement *a)
{
    size_t halves = 2 * a->count + 1;
    a->next = alloc_array(halves, sizeof *a->next);
    a->cell = alloc_array(halves, sizeof *a->cell);
    a->around = alloc_array(halves, sizeof *a->around);
    a->place = alloc_array(halves, sizeof *a->place);
    a->ring = alloc_array(halves, sizeof *a->ring);
    a->ring_half = alloc_array(halves, sizeof *a->ring_half);
    a->winding = alloc_array(halves, sizeof *a->winding);
    a->area = alloc_array(halves, sizeof *a->area);
    a->start = alloc_array(f->node_count + 2, sizeof *a->start);
    return a->next && a->cell && a->around && a->place && a->ring && a->ring_half && a->winding && a->area && a->start;
}

static void free_arrangement(arrangement *a)
{
    free(a->stop);
    free(a->item);
    free(a->next);
    free(a->cell);
    free(a->around);
    free(a->place);
    free(a->ring);
    free(a->ring_half);
    free(a->winding);
    free(a->area);
    free(a->start);
}

/* Makes corners that lie on one another one node of the ring. */
static bool join_ring(face_pieces *f, double touching)
{
    uint32_t *same = alloc_array(f->node_count, sizeof *same);
    bool enough = same && join_nodes(f, touching, same);
    for (size_t r = 0; enough && r < f->ring_count; r++)
        f->ring[r] = same[f->ring[r]];
    free(same);
    return enough;
}

/* The stretches between all crossings, walked cell by cell. */
static bool fill_cells(face_pieces *f, const face_rules *rules, arrangement *a)
{
    uint32_t *same = alloc_array(f->node_count, sizeof *same);
    bool enough = same && join_nodes(f, rules->touching / rules->unit, same) && divide(a, same);
    if (enough)
        drop_dead_ends(f, a, same);
    free(same);
    if (!enough || !alloc_arrangement(f, a))
        return false;
    link_halves(f, a);
    walk_cells(f, a);
    wind(a);
    return take_cells(f, a, rules->even_odd);
}

/* Does the stretch run in the direction of its side of the ring? */
static bool runs_along(const face_pieces *f, const piece_side *s, uint32_t from, uint32_t to)
{
    roberts_vec2 A = f->node[from].at, B = f->node[to].at, P = f->node[s->from].at, Q = f->node[s->to].at;
    return (B.x - A.x) * (Q.x - P.x) + (B.y - A.y) * (Q.y - P.y) > 0.0;
}

static int compare_piece_sides(const void *pa, const void *pb)
{
    const piece_side *a = pa, *b = pb;
    if (a->side != b->side)
        return a->side < b->side ? -1 : 1;
    if (a->piece != b->piece)
        return a->piece < b->piece ? -1 : 1;
    return (a->from > b->from) - (a->from < b->from);
}

/* If a border is not quite planar, a crossing lies on neither of its sides in space. The edges are then the whole
 * sides, each with one of the pieces along it. given: the ring as it was, since nodes that coincide in the plane may be
 * apart in space. */
static bool take_whole_sides(face_pieces *f, const uint32_t *given)
{
    size_t count = f->side_count, k = 0;
    if (count > 1)
        qsort(f->side, count, sizeof *f->side, compare_piece_sides);
    for (size_t i = 0; i < f->ring_count; i++) { /* side_of[] ascends */
        uint32_t from = given[i], to = given[i + 1 < f->ring_count ? i + 1 : 0];
        while (k < count && f->side[k].side < f->side_of[i])
            k++;
        if (k == count || f->side[k].side != f->side_of[i] || from == to)
            continue;
        piece_side whole = {from, to, f->side[k].piece, f->side_of[i]};
        if (!runs_along(f, &f->side[k], from, to)) {
            whole.from = to;
            whole.to = from;
        }
        if (!face_pieces_add_side(f, whole))
            return false;
    }
    f->side_count -= count;
    memmove(f->side, f->side + count, f->side_count * sizeof *f->side);
    return true;
}

bool face_pieces_arrange(face_pieces *f, const face_rules *rules, bool *done)
{
    double touching = rules->touching / rules->unit;
    arrangement a = {0};
    *done = false;
    uint32_t *given = alloc_array(f->ring_count, sizeof *given);
    if (!given)
        return false;
    memcpy(given, f->ring, f->ring_count * sizeof *given);
    bool enough = join_ring(f, touching);
    uint32_t *seen = enough ? alloc_array(f->node_count, sizeof *seen) : NULL;
    bool repeats = seen && ring_repeats(f, seen);
    free(seen);
    enough = seen && take_sides(f, &a) && find_stops(f, &a, touching);
    if (enough && (repeats || a.stop_count > 0)) {
        *done = true;
        enough = fill_cells(f, rules, &a);
        if (enough && f->fit.deviation > PLANAR_PART * rules->touching && f->side_count > 0)
            enough = take_whole_sides(f, given);
    }
    free(given);
    free_arrangement(&a);
    return enough;
}
