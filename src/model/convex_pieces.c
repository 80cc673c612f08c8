/* convex_pieces.c - joins the triangles of a planar face to convex pieces.
 *
 * In a face of many triangles, cuts are first flipped until each is the shorter diagonal of the quadrilateral round it,
 * if both lie inside. Otherwise the slivers of a long face would lie over one another's boxes, and each line behind
 * them would be hidden bit by bit. Then cuts that convex pieces do not need are removed (S. Hertel, K. Mehlhorn, "Fast
 * triangulation of the plane with respect to simple polygons", Information and Control 64, 1985).
 *
 * If a piece would have too many corners, those at which it does not turn are dropped. So the back of a comb is one
 * piece. */
#include <stdlib.h>

#include "base/array.h"
#include "base/orient.h"
#include "base/sets.h"
#include "model/face_pieces.h"

/* In faces of fewer triangles no cut is flipped: their slivers cost little, and the sweep's cuts leave fewer pieces. */
#define WORTH_A_FLIP 64
/* Greatest number of looks at a cut, on average. Profiles of 20,000 corners need up to 50. */
#define LOOKS_AT_CUT 400

/* A side of a triangle, counter-clockwise from its node. Side i of triangle t is half 3 t + i. */
typedef struct half {
    uint32_t node;       /* ROBERTS_NONE: of a cut that has been removed */
    uint32_t twin;       /* the same cut as a side of the other triangle; ROBERTS_NONE: on the border */
    uint32_t label;      /* of the triangle's side */
    uint32_t next, prev; /* round the piece */
    bool turns;          /* the piece turns left at the node; if not, it goes straight on */
} half;

typedef struct joining {
    face_pieces *f;
    const border *b;
    bool keep_straight; /* as in face_rules */
    half *half;         /* [3 * triangles] */
    uint32_t *cut;      /* [cuts] one half of each cut; ROBERTS_NONE: none */
    uint32_t *parent;   /* [triangles] a triangle of the same piece; the last one stands for the piece */
    uint32_t *turns;    /* [triangles] of the one that stands for a piece: how often the piece turns */
    uint32_t triangles, cuts;
} joining;

/* Takes the triangles. False: no memory. */
static bool take_triangles(joining *j)
{
    const face_piece *triangle = j->f->piece;
    const uint32_t lines = (uint32_t)j->b->count;
    j->triangles = (uint32_t)j->f->piece_count;
    for (uint32_t h = 0; h < 3 * j->triangles; h++) {
        const uint32_t label = triangle[h / 3].label[h % 3];
        j->cuts = label >= lines + j->cuts ? label - lines + 1 : j->cuts;
    }
    j->half = alloc_array(3 * (size_t)j->triangles, sizeof *j->half);
    j->cut = alloc_array(j->cuts, sizeof *j->cut);
    j->parent = alloc_array(j->triangles, sizeof *j->parent);
    j->turns = alloc_array(j->triangles, sizeof *j->turns);
    if (!j->half || !j->cut || !j->parent || !j->turns)
        return false;
    for (uint32_t c = 0; c < j->cuts; c++)
        j->cut[c] = ROBERTS_NONE;
    for (uint32_t t = 0; t < j->triangles; t++) {
        j->parent[t] = t;
        j->turns[t] = 3;
        for (uint32_t i = 0; i < 3; i++) {
            const uint32_t h = 3 * t + i, label = triangle[t].label[i];
            j->half[h] =
                (half){triangle[t].node[i], ROBERTS_NONE, label, 3 * t + (i + 1) % 3, 3 * t + (i + 2) % 3, true};
            if (label < lines)
                continue;
            j->half[h].twin = j->cut[label - lines];
            if (j->half[h].twin != ROBERTS_NONE)
                j->half[j->half[h].twin].twin = h;
            j->cut[label - lines] = h;
        }
    }
    return true;
}

static roberts_vec2 place(const joining *j, uint32_t h)
{
    return j->f->node[j->half[h].node].at;
}

/* ---- flipping -------------------------------------------------------------------------------------------------- */

static double squared_length(roberts_vec2 a, roberts_vec2 b)
{
    return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
}

/* Moves what half `from` is to half `to`. */
static void move_half(joining *j, uint32_t to, half from)
{
    half *own = &j->half[to];
    own->node = from.node;
    own->twin = from.twin;
    own->label = from.label;
    if (own->twin != ROBERTS_NONE)
        j->half[own->twin].twin = to;
    if (own->label >= j->b->count)
        j->cut[own->label - j->b->count] = to;
}

/* Replaces a cut by the other diagonal of the quadrilateral round it, if that is shorter and lies inside. */
static bool flip(joining *j, uint32_t cut)
{
    uint32_t h = j->cut[cut], g = h == ROBERTS_NONE ? h : j->half[h].twin;
    if (g == ROBERTS_NONE)
        return false;
    uint32_t side[] = {j->half[g].next, j->half[g].prev, j->half[h].next, j->half[h].prev};
    roberts_vec2 a = place(j, side[0]), b = place(j, side[1]), c = place(j, side[2]), d = place(j, side[3]);
    if (squared_length(b, d) >= squared_length(a, c) || orient2d(a, b, d) <= 0.0 || orient2d(b, c, d) <= 0.0)
        return false;
    half round[] = {j->half[side[0]], j->half[side[1]], j->half[side[2]], j->half[side[3]]};
    j->half[h].node = round[1].node;
    j->half[g].node = round[3].node;
    move_half(j, side[2], round[3]);
    move_half(j, side[3], round[0]);
    move_half(j, side[0], round[1]);
    move_half(j, side[1], round[2]);
    return true;
}

/* Cuts to be looked at. */
typedef struct waiting_cuts {
    uint32_t *cut; /* [count] */
    uint8_t *is;   /* [all cuts] */
    uint32_t count;
} waiting_cuts;

static void look_later(waiting_cuts *w, uint32_t cut)
{
    if (!w->is[cut])
        w->cut[w->count++] = cut;
    w->is[cut] = 1;
}

/* Looks later at the other two sides of the triangle, if they are cuts. */
static void look_at_sides(const joining *j, waiting_cuts *w, uint32_t h)
{
    const uint32_t label[] = {j->half[j->half[h].next].label, j->half[j->half[h].prev].label};
    for (int i = 0; i < 2; i++)
        if (label[i] >= j->b->count)
            look_later(w, label[i] - (uint32_t)j->b->count);
}

/* Flips cuts until no flip makes one shorter. Each flip makes their sum less, so this ends. False: no memory. */
static bool flip_cuts(joining *j)
{
    waiting_cuts w = {alloc_array(j->cuts, sizeof *w.cut), alloc_zeroed(j->cuts, sizeof *w.is), 0};
    const bool enough = w.cut && w.is;
    for (uint32_t c = 0; enough && c < j->cuts; c++)
        look_later(&w, c);
    for (uint64_t looks = LOOKS_AT_CUT * (uint64_t)j->cuts; enough && w.count > 0 && looks > 0; looks--) {
        const uint32_t c = w.cut[--w.count];
        w.is[c] = 0;
        if (flip(j, c)) {
            look_at_sides(j, &w, j->cut[c]);
            look_at_sides(j, &w, j->half[j->cut[c]].twin);
        }
    }
    free(w.cut);
    free(w.is);
    return enough;
}

/* ---- joining --------------------------------------------------------------------------------------------------- */

/* Returns the triangle that stands for the piece of half h. */
static uint32_t piece_of(const joining *j, uint32_t h)
{
    return sets_root(j->parent, h / 3);
}

/* Joins the two pieces at a cut, if the result is convex and does not turn too often. */
static void join(joining *j, uint32_t cut)
{
    half *at = j->half;
    uint32_t h = j->cut[cut], g = h == ROBERTS_NONE ? h : at[h].twin;
    if (g == ROBERTS_NONE)
        return;
    uint32_t p = piece_of(j, h), q = piece_of(j, g);
    if (p == q)
        return;
    uint32_t a = at[g].next, b = at[h].next;
    double first = orient2d(place(j, at[h].prev), place(j, a), place(j, at[a].next));
    double second = orient2d(place(j, at[g].prev), place(j, b), place(j, at[b].next));
    uint32_t fewer = at[h].turns + at[g].turns + at[a].turns + at[b].turns;
    bool turns[] = {first > 0.0 || j->keep_straight, second > 0.0 || j->keep_straight};
    uint32_t sum = j->turns[p] + j->turns[q] - fewer + turns[0] + turns[1];
    if (first < 0.0 || second < 0.0 || sum > PIECE_CORNERS)
        return;
    at[a].turns = turns[0];
    at[b].turns = turns[1];
    at[a].prev = at[h].prev;
    at[at[h].prev].next = a;
    at[b].prev = at[g].prev;
    at[at[g].prev].next = b;
    at[h].node = at[g].node = ROBERTS_NONE;
    j->parent[q] = p;
    j->turns[p] = sum;
}

typedef struct cut_length {
    double squared;
    uint32_t cut;
} cut_length;

static int compare_lengths(const void *pa, const void *pb)
{
    const cut_length *a = pa, *b = pb;
    if (a->squared != b->squared)
        return a->squared > b->squared ? -1 : 1;
    return (a->cut > b->cut) - (a->cut < b->cut);
}

/* Joins pieces at the longest cuts first, so that no piece is long. False: no memory. */
static bool join_longest(joining *j)
{
    cut_length *cut = alloc_array(j->cuts, sizeof *cut);
    const bool enough = cut != NULL;
    for (uint32_t c = 0; enough && c < j->cuts; c++) {
        uint32_t h = j->cut[c];
        cut[c] = (cut_length){h == ROBERTS_NONE ? 0.0 : squared_length(place(j, h), place(j, j->half[h].next)), c};
    }
    if (enough && j->cuts > 1)
        qsort(cut, j->cuts, sizeof *cut, compare_lengths);
    for (uint32_t c = 0; enough && c < j->cuts; c++)
        join(j, cut[c].cut);
    free(cut);
    return enough;
}

/* Stores the piece to which half h belongs. */
static void store_piece(joining *j, uint32_t h, face_piece *to)
{
    const half *at = j->half;
    uint32_t sides = 1;
    to->winding = j->f->piece[h / 3].winding;
    for (uint32_t i = at[h].next; i != h; i = at[i].next)
        sides++;
    to->count = 0;
    for (uint32_t i = 0; i < sides; i++, h = at[h].next)
        if (sides <= PIECE_CORNERS || at[h].turns)
            to->node[to->count++] = at[h].node;
    j->f->whole_sides = j->f->whole_sides || to->count < sides;
}

/* Stores the pieces, and the sides that are not cuts. False: no memory. */
static bool store_pieces(joining *j)
{
    face_pieces *f = j->f;
    const uint32_t lines = (uint32_t)j->b->count;
    uint32_t *number = alloc_array(j->triangles, sizeof *number); /* of the piece for which a triangle stands */
    bool enough = number != NULL;
    for (uint32_t t = 0; enough && t < j->triangles; t++)
        number[t] = ROBERTS_NONE;
    f->piece_count = 0;
    for (uint32_t h = 0; enough && h < 3 * j->triangles; h++) {
        const half *own = &j->half[h];
        if (own->node == ROBERTS_NONE)
            continue;
        uint32_t p = piece_of(j, h);
        if (number[p] == ROBERTS_NONE) {
            number[p] = (uint32_t)f->piece_count;
            store_piece(j, h, &f->piece[f->piece_count++]);
        }
        enough = own->label >= lines || face_pieces_add_side(f, (piece_side){own->node, j->half[own->next].node,
                                                                             number[p], j->b->item[own->label].side});
    }
    free(number);
    return enough;
}

bool face_pieces_join(face_pieces *f, const border *b, bool keep_straight)
{
    joining j = {.f = f, .b = b, .keep_straight = keep_straight};
    bool enough = take_triangles(&j);
    if (enough && j.triangles > WORTH_A_FLIP)
        enough = flip_cuts(&j) && join_longest(&j);
    else
        for (uint32_t c = 0; enough && c < j.cuts; c++)
            join(&j, c);
    enough = enough && store_pieces(&j);
    free(j.half);
    free(j.cut);
    free(j.parent);
    free(j.turns);
    return enough;
}
