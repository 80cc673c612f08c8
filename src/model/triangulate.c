/* triangulate.c - cuts a simple polygon into triangles, and joins these to convex polygons.
 *
 * Ears are cut off one by one (G. H. Meisters, "Polygons have ears", American Mathematical Monthly 82(6), 1975). Then
 * cuts that convex pieces do not need are taken back (S. Hertel, K. Mehlhorn, "Fast triangulation of simple polygons",
 * FCT 1983). A polygon may touch itself at corners and run along a slit both ways. */
#include <stdlib.h>

#include "base/array.h"
#include "base/bits.h"
#include "base/sort.h"
#include "model/face_pieces.h"

/* With more corners than this, those near a triangle are found along a space-filling curve. */
enum { MANY_CORNERS = 80 };

static roberts_vec2 place(const face_pieces *f, uint32_t link)
{
    return f->node[f->link[link].node].at;
}

static double turn_at(const face_pieces *f, uint32_t b)
{
    return piece_turn(place(f, f->link[b].last), place(f, b), place(f, f->link[b].next));
}

/* The triangle before and after a corner, with its box. */
typedef struct ear {
    uint32_t node[3];
    roberts_vec2 A, B, C, low, high;
} ear;

/* Is corner p in the triangle, or with `strict` also on its border? It is enough to ask corners that do not turn
 * left. */
static bool holds(const face_pieces *f, const ear *e, uint32_t p, bool strict)
{
    roberts_vec2 P = place(f, p);
    uint32_t node = f->link[p].node;
    if (P.x < e->low.x || P.x > e->high.x || P.y < e->low.y || P.y > e->high.y || node == e->node[0] ||
        node == e->node[1] || node == e->node[2])
        return false;
    double ab = piece_turn(e->A, e->B, P), bc = piece_turn(e->B, e->C, P), ca = piece_turn(e->C, e->A, P);
    bool inside = strict ? ab >= 0.0 && bc >= 0.0 && ca >= 0.0 : ab > 0.0 && bc > 0.0 && ca > 0.0;
    return inside && turn_at(f, p) <= 0.0;
}

/* The plane in 2^15 columns and rows, for the curve. */
typedef struct curve {
    roberts_vec2 low;
    double per_x, per_y;
} curve;

static uint32_t cell_along(double x, double low, double per)
{
    double i = (x - low) * per;
    return !(i > 0.0) ? 0 : i >= 32767.0 ? 32767 : (uint32_t)i;
}

static uint32_t place_on(const curve *c, roberts_vec2 P)
{
    return bits_spread(cell_along(P.x, c->low.x, c->per_x)) << 1 | bits_spread(cell_along(P.y, c->low.y, c->per_y));
}

/* Links the corners along the curve (G. M. Morton, 1966). On it, all corners in a box lie between the box's lower left
 * and upper right corner. False: no memory. */
static bool link_curve(face_pieces *f, uint32_t count, curve *c)
{
    uint64_t *key = alloc_array(count, sizeof *key);
    roberts_vec2 high = {-INFINITY, -INFINITY};
    c->low = (roberts_vec2){INFINITY, INFINITY};
    if (!key)
        return false;
    for (uint32_t i = 0; i < count; i++) {
        roberts_vec2 P = place(f, i);
        c->low = (roberts_vec2){lesser(c->low.x, P.x), lesser(c->low.y, P.y)};
        high = (roberts_vec2){greater(high.x, P.x), greater(high.y, P.y)};
    }
    c->per_x = high.x > c->low.x ? 32768.0 / (high.x - c->low.x) : 0.0;
    c->per_y = high.y > c->low.y ? 32768.0 / (high.y - c->low.y) : 0.0;
    for (uint32_t i = 0; i < count; i++) {
        f->link[i].z = place_on(c, place(f, i));
        key[i] = (uint64_t)f->link[i].z << 32 | i;
    }
    qsort(key, count, sizeof *key, compare_u64);
    for (uint32_t i = 0; i < count; i++) {
        f->link[(uint32_t)key[i]].last_z = i > 0 ? (uint32_t)key[i - 1] : ROBERTS_NONE;
        f->link[(uint32_t)key[i]].next_z = i + 1 < count ? (uint32_t)key[i + 1] : ROBERTS_NONE;
    }
    free(key);
    return true;
}

/* Does the triangle before and after b hold no other corner? `strict`: nor on its border. c: NULL where all are
 * asked. */
static bool is_ear(const face_pieces *f, uint32_t b, bool strict, const curve *c)
{
    const ring_link *link = f->link;
    uint32_t before = link[b].last, after = link[b].next;
    ear e = {{link[before].node, link[b].node, link[after].node},
             place(f, before),
             place(f, b),
             place(f, after),
             {0, 0},
             {0, 0}};
    if (!(piece_turn(e.A, e.B, e.C) > 0.0))
        return false;
    e.low = (roberts_vec2){lesser(e.A.x, lesser(e.B.x, e.C.x)), lesser(e.A.y, lesser(e.B.y, e.C.y))};
    e.high = (roberts_vec2){greater(e.A.x, greater(e.B.x, e.C.x)), greater(e.A.y, greater(e.B.y, e.C.y))};
    if (!c) {
        for (uint32_t p = link[after].next; p != before; p = link[p].next)
            if (holds(f, &e, p, strict))
                return false;
        return true;
    }
    uint32_t first = place_on(c, e.low), last = place_on(c, e.high);
    for (uint32_t p = link[b].next_z; p != ROBERTS_NONE && link[p].z <= last; p = link[p].next_z)
        if (p != before && p != after && holds(f, &e, p, strict))
            return false;
    for (uint32_t p = link[b].last_z; p != ROBERTS_NONE && link[p].z >= first; p = link[p].last_z)
        if (p != before && p != after && holds(f, &e, p, strict))
            return false;
    return true;
}

static bool add_triangle(face_pieces *f, uint32_t b, uint32_t across)
{
    const ring_link *link = f->link;
    uint32_t a = link[b].last, c = link[b].next;
    if (!array_reserve(&f->piece, &f->piece_room, f->piece_count + 1, sizeof *f->piece))
        return false;
    face_piece *t = &f->piece[f->piece_count++];
    t->count = 3;
    t->node[0] = link[a].node;
    t->node[1] = link[b].node;
    t->node[2] = link[c].node;
    t->label[0] = link[a].label;
    t->label[1] = link[b].label;
    t->label[2] = across;
    return true;
}

/* The corner of a quadrilateral to begin with: then the shorter diagonal is cut, if both are inside. */
static uint32_t first_ear(const face_pieces *f, uint32_t count)
{
    if (count != 4 || turn_at(f, 0) <= 0.0 || turn_at(f, 1) <= 0.0 || turn_at(f, 2) <= 0.0 || turn_at(f, 3) <= 0.0)
        return 0;
    roberts_vec3 a = vec3_sub(f->node[f->link[2].node].point, f->node[f->link[0].node].point);
    roberts_vec3 b = vec3_sub(f->node[f->link[3].node].point, f->node[f->link[1].node].point);
    return vec3_dot(b, b) <= vec3_dot(a, a) ? 0 : 1;
}

/* Cuts off ears until three corners are left. If rounding leaves no ear, it cuts ears with corners on their border,
 * then any corner that turns left, then any. Returns the number of cuts; ROBERTS_NONE: no memory. */
static uint32_t cut_ears(face_pieces *f, uint32_t count, const curve *c)
{
    ring_link *link = f->link;
    uint32_t left = count, cuts = 0, b = first_ear(f, count), tried = 0, lax = 0;
    while (left > 3) {
        bool cut = lax == 0   ? is_ear(f, b, true, c)
                   : lax == 1 ? is_ear(f, b, false, c)
                   : lax == 2 ? turn_at(f, b) > 0.0
                              : true;
        if (!cut) {
            b = link[b].next;
            if (++tried > left) {
                tried = 0;
                lax++;
            }
            continue;
        }
        uint32_t before = link[b].last, after = link[b].next, across = count + cuts;
        if (turn_at(f, b) > 0.0) {
            if (!add_triangle(f, b, across))
                return ROBERTS_NONE;
            cuts++;
            link[before].label = across;
        }
        link[before].next = after;
        link[after].last = before;
        if (c && link[b].next_z != ROBERTS_NONE)
            link[link[b].next_z].last_z = link[b].last_z;
        if (c && link[b].last_z != ROBERTS_NONE)
            link[link[b].last_z].next_z = link[b].next_z;
        left--;
        b = link[after].next; /* not the same corner again, which would give a fan of thin triangles */
        tried = lax = 0;
    }
    if (turn_at(f, b) > 0.0 && !add_triangle(f, b, link[link[b].next].label))
        return ROBERTS_NONE;
    return cuts;
}

/* The side of a piece that has this label; the number of its sides if there is none. */
static uint32_t find_label(const face_piece *p, uint32_t label)
{
    uint32_t i = 0;
    while (i < p->count && p->label[i] != label)
        i++;
    return i;
}

static roberts_vec2 corner_at(const face_pieces *f, const face_piece *p, uint32_t i)
{
    return f->node[p->node[i % p->count]].at;
}

/* Joins q to p across a cut, side i of p and side j of q, if the result is convex. */
static bool join(const face_pieces *f, face_piece *p, const face_piece *q, uint32_t i, uint32_t j)
{
    face_piece all = {.count = p->count + q->count - 2};
    if (all.count > PIECE_CORNERS ||
        piece_turn(corner_at(f, p, i + p->count - 1), corner_at(f, p, i), corner_at(f, q, j + 2)) < 0.0 ||
        piece_turn(corner_at(f, q, j + q->count - 1), corner_at(f, q, j), corner_at(f, p, i + 2)) < 0.0)
        return false;
    uint32_t to = 0;
    for (uint32_t k = 1; k < p->count; k++, to++) {
        all.node[to] = p->node[(i + k) % p->count];
        all.label[to] = p->label[(i + k) % p->count];
    }
    for (uint32_t k = 1; k < q->count; k++, to++) {
        all.node[to] = q->node[(j + k) % q->count];
        all.label[to] = q->label[(j + k) % q->count];
    }
    *p = all;
    return true;
}

/* Takes back cuts that are not needed. of[]: the two pieces at each cut, which may have been joined to others since. */
static void join_pieces(face_pieces *f, size_t first, uint32_t count, uint32_t cuts, uint32_t *of, uint32_t *parent)
{
    for (uint32_t c = 0; c < 2 * cuts; c++)
        of[c] = ROBERTS_NONE;
    for (size_t p = first; p < f->piece_count; p++) {
        parent[p - first] = (uint32_t)p;
        for (uint32_t i = 0; i < f->piece[p].count; i++)
            if (f->piece[p].label[i] >= count) {
                uint32_t *own = &of[2 * (f->piece[p].label[i] - count)];
                own[own[0] != ROBERTS_NONE] = (uint32_t)p;
            }
    }
    for (uint32_t c = 0; c < cuts; c++) {
        uint32_t p = of[2 * c], q = of[2 * c + 1];
        if (p == ROBERTS_NONE || q == ROBERTS_NONE)
            continue;
        while (parent[p - first] != p)
            p = parent[p - first];
        while (parent[q - first] != q)
            q = parent[q - first];
        uint32_t i = find_label(&f->piece[p], count + c), j = find_label(&f->piece[q], count + c);
        if (p == q || i == f->piece[p].count || j == f->piece[q].count)
            continue;
        if (join(f, &f->piece[p], &f->piece[q], i, j)) {
            parent[q - first] = p;
            f->piece[q].count = 0;
        }
    }
    size_t to = first;
    for (size_t p = first; p < f->piece_count; p++)
        if (f->piece[p].count > 0)
            f->piece[to++] = f->piece[p];
    f->piece_count = to;
}

bool face_pieces_triangulate(face_pieces *f, const uint32_t *ring, uint32_t count, bool merge)
{
    size_t first = f->piece_count;
    if (!array_reserve(&f->link, &f->link_room, count, sizeof *f->link))
        return false;
    for (uint32_t i = 0; i < count; i++)
        f->link[i] = (ring_link){ring[i], i + 1 < count ? i + 1 : 0, i > 0 ? i - 1 : count - 1, i, 0, 0, 0};
    curve along;
    if (count > MANY_CORNERS && !link_curve(f, count, &along))
        return false;
    uint32_t cuts = cut_ears(f, count, count > MANY_CORNERS ? &along : NULL);
    if (cuts == ROBERTS_NONE)
        return false;
    if (!merge || cuts == 0)
        return true;
    uint32_t *of = alloc_array(2 * (size_t)cuts, sizeof *of);
    uint32_t *parent = alloc_array(f->piece_count - first, sizeof *parent);
    bool enough = of && parent;
    if (enough)
        join_pieces(f, first, count, cuts, of, parent);
    free(of);
    free(parent);
    return enough;
}
