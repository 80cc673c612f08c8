/* crossings.c - see crossings.h. */
#include "hide/crossings.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/bits.h"
#include "base/lanes.h"
#include "base/sort.h"
#include "base/threads.h"
#include "hide/crossing_filter.h"
#include "hide/edge_crossings.h"
#include "hide/face_pairs.h"
#include "hide/front.h"

/* Cells that a thread takes at a time. With fewer entries than this, one more thread does not pay. */
#define CELLS_AT_ONCE 64
#define WORTH_A_THREAD 8192
/* How many faces of a cell are kept. */
#define KEPT_FACES 512
/* Of pairs, this many are remembered. */
#define RECENT_PAIRS 4096
/* Boxes that take no more than this part of a cell's width and height are in no more than two columns and rows. */
#define MOST_OF_CELL 0.999
/* Cells are widened by this many margins. Fronts are listed with one. */
#define CELL_MARGINS 2.0

/* Four entries of a cell's list side by side. Their boxes are cut to the cell. Unused lanes meet nothing. */
typedef struct four_entries {
    float x0[4], x1[4], y0[4], y1[4], z0[4], z1[4];
    uint32_t v[3][4];    /* corners of a triangle of a surface; else numbers beyond those of vertices, each used once */
    uint32_t star[3][4]; /* 15: all faces about that corner are one sheet; else 0 */
    uint32_t kin[4];     /* two fronts with the same number do not cross */
} four_entries;

/* Whether nothing in the cell last searched crosses a patch. */
typedef struct asked_patch {
    uint32_t cell;
    bool alone;
} asked_patch;

/* Some of the last pairs, by their hashes; 0: none. */
typedef uint64_t recent_pairs[RECENT_PAIRS];

/* The data of one thread. */
typedef struct finder {
    const hide_fronts *fronts;
    const objet *grid;
    const crossing_filter *filter;
    const float *nearest; /* [cells] everything deeper is hidden in the cell; NULL: not known, or not needed */
    crossing_rules rules;
    crossing_list found;
    uint64_t *pair; /* [pair_count] first pieces of two faces, that of one in several before that of one in one; they
                       are tested at the end */
    size_t pair_count, pair_room;
    recent_pairs listed, tested; /* the last pairs of faces in `pair`, and of fronts that cells have tested */
    struct {
        uint32_t number, first; /* its scene_plane_number() and its first piece */
    } whole[2];                 /* the last faces of several pieces that were asked for */
    crossing_face *face;        /* [KEPT_FACES] of the entries of this cell, where `kept` says so */
    bool kept[KEPT_FACES];
    four_entries *four; /* the entries of this cell */
    uint32_t *patch;    /* of the nodes of this cell's tree: see find_patches() */
    size_t four_room, patch_room;
    asked_patch *asked; /* [patches] see is_alone() */
    face_list list[2];
    crossing_kept last; /* the first face of the last pair */
    char apart[THREADS_APART];
} finder;

/* ---- two faces ------------------------------------------------------------------------------------------------- */

/* Lines behind covers or sheets are not computed if hidden lines are not wanted and the view is parallel, and no more
 * oblique than this. Then a line that ends near A and B in the model is less than an epsilon from AB in view space:
 * (1 + OBLIQUE_FOR_COVERS) CROSSING_NEAR < 1. cover_hides_edge() allows for hide_margin(), which is four times as
 * much. */
#define OBLIQUE_FOR_COVERS 2.0

static bool may_be_unseen(const seen *s)
{
    const view *v = &s->view;
    return !s->rules.hidden && !v->perspective && fabs(v->oblique.x) <= OBLIQUE_FOR_COVERS &&
           fabs(v->oblique.y) <= OBLIQUE_FOR_COVERS;
}

/* Do covers or sheets hide the line between two points of the model? */
static bool is_unseen(const void *context, roberts_vec3 A, roberts_vec3 B)
{
    const finder *t = context;
    const view *v = &t->fronts->seen->view;
    const cover *covers = &t->fronts->cover, *sheets = &t->grid->sheet;
    A = view_point(v, A);
    B = view_point(v, B);
    return (covers->depth && cover_hides_edge(covers, A, B)) || (sheets->depth && cover_hides_edge(sheets, A, B));
}

/* Sorts the pairs, and keeps one of each. */
static void tidy_pairs(finder *t)
{
    size_t kept = 0;
    if (t->pair_count > 1)
        qsort(t->pair, t->pair_count, sizeof *t->pair, compare_u64);
    for (size_t k = 0; k < t->pair_count; k++)
        if (kept == 0 || t->pair[kept - 1] != t->pair[k])
            t->pair[kept++] = t->pair[k];
    t->pair_count = kept;
}

/* Remembers a pair of two different numbers. Was it remembered before? */
static bool is_recent(recent_pairs recent, uint32_t a, uint32_t b)
{
    const uint64_t pair = (uint64_t)a << 32 | b;
    uint64_t *place = &recent[bits_hash(&pair, sizeof pair) % RECENT_PAIRS];
    const bool before = *place == pair;
    *place = pair;
    return before;
}

/* Two faces of many pieces give the same pair many times. Those listed lately are passed over. The list is tidied when
 * it is full, and grows only if it is still half full then. */
static bool add_pair(finder *t, uint32_t f, uint32_t g)
{
    if (is_recent(t->listed, f, g))
        return true;
    if (t->pair_count > 0 && t->pair_count == t->pair_room) {
        tidy_pairs(t);
        if (t->pair_count > t->pair_room / 2 &&
            !array_reserve(&t->pair, &t->pair_room, t->pair_room + 1, sizeof *t->pair))
            return false;
    }
    if (!array_reserve(&t->pair, &t->pair_room, t->pair_count + 1, sizeof *t->pair))
        return false;
    t->pair[t->pair_count++] = (uint64_t)f << 32 | g;
    return true;
}

static bool is_any_in_pieces(const finder *t, const uint32_t body[2], const uint32_t piece[2])
{
    return scene_is_in_pieces(t->rules.scene, body[0], piece[0]) ||
           scene_is_in_pieces(t->rules.scene, body[1], piece[1]);
}

/* The first piece of a face of several pieces. A face of very many, such as a plate with holes, is asked for again and
 * again. */
static uint32_t first_of_several(finder *t, uint32_t body, uint32_t piece)
{
    const uint32_t number = scene_plane_number(t->rules.scene, piece);
    for (int k = 0; k < 2; k++)
        if (t->whole[k].number == number)
            return t->whole[k].first;
    t->whole[1] = t->whole[0];
    t->whole[0].number = number;
    return t->whole[0].first = scene_first_piece(t->rules.scene, body, piece);
}

/* Leaves a pair of which a face is in several pieces to the end: then such a face is computed once. False: no memory.
 */
static bool leave_pair(finder *t, const uint32_t body[2], const uint32_t piece[2])
{
    const roberts_scene *scene = t->rules.scene;
    const bool several[2] = {scene_is_in_pieces(scene, body[0], piece[0]),
                             scene_is_in_pieces(scene, body[1], piece[1])};
    const uint32_t first[2] = {several[0] ? first_of_several(t, body[0], piece[0]) : piece[0],
                               several[1] ? first_of_several(t, body[1], piece[1]) : piece[1]};
    const int k = several[0] == several[1] ? first[1] < first[0] : several[1];
    return first[0] == first[1] || add_pair(t, first[k], first[1 - k]);
}

/* In a fixed order, so that the result is the same. */
static bool meet_faces(finder *t, crossing_face *f, crossing_face *g)
{
    return f->first < g->first ? crossing_find(&t->rules, f, g, &t->found) : crossing_find(&t->rules, g, f, &t->found);
}

/* Tests two faces, given by their first pieces. The first one is kept, for the next pair. */
static bool meet_whole(finder *t, const uint32_t body[2], const uint32_t first[2])
{
    crossing_face *f = crossing_keep(&t->last, &t->rules, body[0], first[0]);
    crossing_face other = crossing_face_of(&t->rules, body[1], first[1]);
    return crossing_limit(&t->last, &t->rules, &other) && meet_faces(t, f, &other);
}

/* Do flat patches keep two faces apart? */
static bool are_flat_apart(const flat_patches *flat, uint32_t f, uint32_t g)
{
    return flat->count > 0 && (flat_patches_beside(flat, f, flat->of[g]) || flat_patches_beside(flat, g, flat->of[f]));
}

/* Tests the faces of two pieces. Nothing crosses a cap: everything ends at the near plane. */
static bool meet_pair(void *context, int thread, const face_pair *pair)
{
    finder *t = &((finder *)context)[thread];
    const roberts_scene *scene = t->rules.scene;
    if (seen_is_cap(scene, pair->piece[0]) || seen_is_cap(scene, pair->piece[1]))
        return true;
    if (is_any_in_pieces(t, pair->body, pair->piece))
        return leave_pair(t, pair->body, pair->piece);
    return are_flat_apart(&t->filter->flat, pair->piece[0], pair->piece[1]) ||
           filter_share_side(scene, pair->piece[0], pair->piece[1]) ||
           filter_apart_in_space(t->filter, pair->piece[0], pair->piece[1]) || meet_whole(t, pair->body, pair->piece);
}

/* ---- two fronts ------------------------------------------------------------------------------------------------ */

/* Lists the faces of a front that meet a box. */
static bool list_faces(const hide_fronts *fronts, const hide_front *front, const hide_box *box, face_list *to)
{
    const scene_solid *s = &fronts->scene->solid[front->solid];
    uint32_t first = hide_is_face(front) ? front->piece : s->face, end = hide_is_face(front) ? first + 1 : s[1].face;
    to->count = 0;
    for (uint32_t f = first; f < end; f++) {
        if (!hide_is_face(front) && fronts->seen->facing[f] != VIEW_FRONT)
            continue;
        boxed_face item = {front_box_of_face(fronts, f), f};
        if (!hide_boxes_meet(&item.box, box))
            continue;
        if (!array_reserve(&to->item, &to->room, to->count + 1, sizeof *to->item))
            return false;
        to->item[to->count++] = item;
    }
    return true;
}

/* Tests two fronts of different bodies, at least one of them a whole solid. */
static bool meet_solids(finder *t, uint32_t a, uint32_t b)
{
    const hide_fronts *fronts = t->fronts;
    const hide_front *f = &fronts->front[a], *g = &fronts->front[b];
    const hide_box *p = &fronts->front_box[a], *q = &fronts->front_box[b];
    if ((scene_is_convex(fronts->scene, f->solid) && bodies_are_apart(fronts, f->solid, g->solid)) ||
        (scene_is_convex(fronts->scene, g->solid) && bodies_are_apart(fronts, g->solid, f->solid)))
        return true;
    return list_faces(fronts, f, q, &t->list[0]) && list_faces(fronts, g, p, &t->list[1]) &&
           face_lists_meet(t->list, (uint32_t[]){f->solid, g->solid}, &(face_taker){meet_pair, t, 0});
}

/* The same for the fronts and all their copies, which no cell lists. */
static bool meet_copies(finder *t, uint32_t a, uint32_t b)
{
    const uint32_t *next = t->fronts->next_copy, wholes = t->fronts->whole_count;
    if (!next)
        return meet_solids(t, a, b);
    for (; a != ROBERTS_NONE; a = a < wholes ? next[a] : ROBERTS_NONE)
        for (uint32_t c = b; c != ROBERTS_NONE; c = c < wholes ? next[c] : ROBERTS_NONE)
            if (!meet_solids(t, a, c))
                return false;
    return true;
}

/* ---- cells ----------------------------------------------------------------------------------------------------- */

/* The face of entry k of a list. It is kept until the next cell. */
static crossing_face *face_at(finder *t, const hide_front *front, uint32_t k, crossing_face *other)
{
    crossing_face *f = k < KEPT_FACES ? &t->face[k] : other;
    if (k >= KEPT_FACES || !t->kept[k])
        *f = crossing_face_of(&t->rules, front->solid, front->piece);
    if (k < KEPT_FACES)
        t->kept[k] = true;
    return f;
}

/* Tests entries i < k of a cell's list, whose boxes meet. */
static bool meet_entries(finder *t, const objet_entry *list, uint32_t i, uint32_t k)
{
    const hide_fronts *fronts = t->fronts;
    const hide_front *f = &fronts->front[list[i].front], *g = &fronts->front[list[k].front];
    const uint32_t body[2] = {f->solid, g->solid}, piece[2] = {f->piece, g->piece};
    crossing_face other[2];
    if (hide_key(fronts, f) == hide_key(fronts, g))
        return true; /* a convex solid, or pieces of one face */
    if (!hide_is_face(f) || !hide_is_face(g))
        return meet_copies(t, list[i].front, list[k].front);
    if (seen_is_cap(fronts->scene, f->piece) || seen_is_cap(fronts->scene, g->piece) ||
        filter_apart_in_picture(fronts, list[i].front, list[k].front))
        return true;
    if (is_any_in_pieces(t, body, piece))
        return leave_pair(t, body, piece);
    if (body[0] == body[1] &&
        (filter_share_side(fronts->scene, f->piece, g->piece) || filter_apart_in_space(t->filter, f->piece, g->piece)))
        return true;
    /* Faces of different bodies have no corner in common, and crossing_find() finds the same as quickly. */
    return meet_faces(t, face_at(t, f, i, &other[0]), face_at(t, g, k, &other[1]));
}

/* The entries of a cell that are tested. */
typedef struct cell_list {
    const objet_entry *list; /* [count] */
    uint32_t first, count;   /* first: its place in the entries of the grid */
    uint32_t column, row;
} cell_list;

/* Does the cell test a pair that it lists? deeper: the nearest depth of the deeper front. */
static inline bool is_sought(const finder *t, size_t cell, float deeper)
{
    return !(t->grid->apart && t->grid->apart[cell]) && !(t->nearest && deeper < t->nearest[cell]);
}

/* Is the front no larger than a cell? Then its box touches at most two columns and two rows, and all its cells list it
 * (see objet.c). */
static bool is_small(const finder *t, uint32_t front)
{
    const scan_frame *frame = &t->grid->frame;
    const hide_box *box = &t->fronts->front_box[front];
    double m = frame->margin + hide_loose(t->fronts, front);
    double x0 = scan_along_x(frame, (double)box->x0 - m), x1 = scan_along_x(frame, (double)box->x1 + m);
    double y0 = scan_along_y(frame, (double)box->y0 - m), y1 = scan_along_y(frame, (double)box->y1 + m);
    return x1 - x0 < MOST_OF_CELL * frame->dx && y1 - y0 < MOST_OF_CELL * frame->dy;
}

/* Has an earlier cell tested the pair? False if that is not known. */
static bool is_met_before(const finder *t, const cell_list *c, uint32_t a, uint32_t b)
{
    const scan_frame *frame = &t->grid->frame;
    const hide_box *p = &t->fronts->front_box[a], *q = &t->fronts->front_box[b];
    uint32_t left = scan_column(frame, greater((double)p->x0, (double)q->x0) - frame->margin);
    uint32_t low = scan_row(frame, greater((double)p->y0, (double)q->y0) - frame->margin);
    if ((left >= c->column && low >= c->row) || !is_small(t, a) || !is_small(t, b))
        return false;
    for (uint32_t i = left; i <= c->column; i++)
        for (uint32_t j = low; j <= c->row; j++)
            if ((i < c->column || j < c->row) && is_sought(t, scan_number(frame, i, j), q->z1))
                return true;
    return false;
}

/* Packs entry k of a list, to lane k of `four`. */
static void pack_entry(const finder *t, const hide_box *cell, uint32_t front, uint32_t k)
{
    const hide_fronts *fronts = t->fronts;
    const hide_box *box = &fronts->front_box[front];
    const hide_front *f = &fronts->front[front];
    four_entries *to = &t->four[k / 4];
    const uint32_t lane = k % 4;
    to->x0[lane] = box->x0 > cell->x0 ? box->x0 : cell->x0;
    to->x1[lane] = box->x1 < cell->x1 ? box->x1 : cell->x1;
    to->y0[lane] = box->y0 > cell->y0 ? box->y0 : cell->y0;
    to->y1[lane] = box->y1 < cell->y1 ? box->y1 : cell->y1;
    to->z0[lane] = box->z0;
    to->z1[lane] = box->z1;
    to->kin[lane] = filter_is_simple(t->filter, f->solid) ? seen_body_key(f->solid) : hide_key(fronts, f);
    const uint32_t *start = fronts->scene->face_start + f->piece, *corner = fronts->scene->corner;
    atomic_uchar *star = t->filter->star;
    const bool triangle = f->kind == HIDE_SURFACE_FACE && start[1] - start[0] == 3;
    for (uint32_t i = 0; i < 3; i++) {
        uint32_t v = triangle ? corner[start[0] + i] : ROBERTS_NONE - 3 * k - i;
        to->v[i][lane] = v;
        to->star[i][lane] =
            triangle && star && atomic_load_explicit(&star[v], memory_order_relaxed) == STAR_ONCE ? 15 : 0;
    }
}

/* Packs the list of a cell. The cell is widened by more than the margin by which its fronts are listed. */
static bool pack_cell(finder *t, const cell_list *c)
{
    const scan_frame *frame = &t->grid->frame;
    uint32_t full = (c->count + 3) & ~3u;
    if (!array_reserve(&t->four, &t->four_room, full / 4, sizeof *t->four))
        return false;
    const double m = CELL_MARGINS * frame->margin;
    const bool edge[4] = {c->column == 0, c->column + 1 == frame->nx, c->row == 0, c->row + 1 == frame->ny};
    const hide_box cell = {.x0 = edge[0] ? -INFINITY : hide_float_below(scan_left(frame, c->column) - m),
                           .x1 = edge[1] ? INFINITY : hide_float_above(scan_left(frame, c->column + 1.0) + m),
                           .y0 = edge[2] ? -INFINITY : hide_float_below(scan_lower(frame, c->row) - m),
                           .y1 = edge[3] ? INFINITY : hide_float_above(scan_lower(frame, c->row + 1.0) + m)};
    for (uint32_t k = 0; k < c->count; k++)
        pack_entry(t, &cell, c->list[k].front, k);
    for (uint32_t k = c->count; k < full; k++) {
        t->four[k / 4].x0[k % 4] = INFINITY;
        t->four[k / 4].z1[k % 4] = -INFINITY;
        t->four[k / 4].kin[k % 4] = ROBERTS_NONE;
        for (uint32_t i = 0; i < 3; i++)
            t->four[k / 4].v[i][k % 4] = ROBERTS_NONE - 3 * k - i;
    }
    return true;
}

/* Do covers hide all points that two boxes have in common? */
static bool is_covered(const hide_fronts *fronts, const hide_box *p, const hide_box *q)
{
    const hide_box both = {p->x0 > q->x0 ? p->x0 : q->x0, p->x1 < q->x1 ? p->x1 : q->x1, p->y0 > q->y0 ? p->y0 : q->y0,
                           p->y1 < q->y1 ? p->y1 : q->y1, p->z0 > q->z0 ? p->z0 : q->z0, p->z1 < q->z1 ? p->z1 : q->z1};
    return fronts->cover.depth &&
           cover_nearer(&fronts->cover, 0.5 * ((double)both.x0 + (double)both.x1),
                        0.5 * ((double)both.y0 + (double)both.y1), both.z1) &&
           cover_hides(&fronts->cover, &both);
}

/* Tests entry i with entry k, unless an earlier cell has tested them, or nobody sees where they may cross. A pair that
 * touches many cells is tested in few of them. */
static bool meet_listed(finder *t, const cell_list *c, uint32_t i, uint32_t k)
{
    const uint32_t a = c->list[i].front, b = c->list[k].front;
    return is_met_before(t, c, a, b) || is_recent(t->tested, a < b ? a : b, a < b ? b : a) ||
           is_covered(t->fronts, &t->fronts->front_box[a], &t->fronts->front_box[b]) || meet_entries(t, c->list, i, k);
}

/* Which lanes have this corner? */
BITS_INLINE unsigned lanes_with(const four_entries *e, uint32_t v)
{
    return four_signs(four_either(four_same(e->v[0], v), four_either(four_same(e->v[1], v), four_same(e->v[2], v))));
}

/* Which of the lanes `near` of `e` may cross a triangle of a surface? Not those that share a side with it, or a corner
 * about which all faces are one sheet, or lie beside it at a corner. */
BITS_INLINE unsigned drop_neighbours(const finder *t, const four_entries *own, uint32_t lane, const four_entries *e,
                                     unsigned near)
{
    const uint32_t v[3] = {own->v[0][lane], own->v[1][lane], own->v[2][lane]};
    const unsigned a = lanes_with(e, v[0]), b = lanes_with(e, v[1]), c = lanes_with(e, v[2]);
    near &= ~((a & (b | c)) | (b & c) | (a & own->star[0][lane]) | (b & own->star[1][lane]) | (c & own->star[2][lane]));
    for (unsigned one = (a | b | c) & near; one; one &= one - 1) {
        uint32_t at = (uint32_t)bits_trailing_zeros(one);
        const uint32_t g[3] = {e->v[0][at], e->v[1][at], e->v[2][at]};
        if (filter_apart_at_corner(t->fronts, v, a >> at & 1 ? 0 : b >> at & 1 ? 1 : 2, g))
            near &= ~(1u << at);
    }
    return near;
}

static inline bool are_kin(const finder *t, uint32_t i, uint32_t k)
{
    return t->four[i / 4].kin[i % 4] == t->four[k / 4].kin[k % 4];
}

/* Tests entry i with those that follow it. Fronts are listed nearest first, so the first front behind it ends the
 * search. */
static bool meet_those_behind(finder *t, const cell_list *c, uint32_t i)
{
    const four_entries *own = &t->four[i / 4];
    const uint32_t lane = i % 4, kin = own->kin[lane];
    const four x0 = four_all(own->x0[lane]), x1 = four_all(own->x1[lane]), y0 = four_all(own->y0[lane]),
               y1 = four_all(own->y1[lane]), z0 = four_all(own->z0[lane]);
    const bool of_solid = t->grid->next && kin & SEEN_BODY; /* faces of one solid do not cross */
    for (uint32_t k = i + 1, next; k < c->count; k = next) {
        const four_entries *e = &t->four[k / 4];
        next = (k | 3) + 1;
        if (e->z1[k % 4] < own->z0[lane])
            return true;
        unsigned same = four_signs(four_same(e->kin, kin));
        if (of_solid && same >> k % 4 & 1) {
            next = t->grid->next[c->first + k] - c->first;
            continue;
        }
        unsigned near = four_at_most(x0, four_load(e->x1)) & four_at_most(four_load(e->x0), x1) &
                        four_at_most(y0, four_load(e->y1)) & four_at_most(four_load(e->y0), y1) &
                        four_at_most(z0, four_load(e->z1)) & ~same & 15u << k % 4;
        if (near)
            near = drop_neighbours(t, own, lane, e, near);
        for (; near; near &= near - 1) {
            const uint32_t at = (k & ~3u) + (uint32_t)bits_trailing_zeros(near);
            if (!filter_boxes_apart(t->filter, c->list[i].front, c->list[at].front) && !meet_listed(t, c, i, at))
                return false;
        }
    }
    return true;
}

/* The same if all fronts are whole solids: their lists are short, and are not packed. */
static bool meet_solids_behind(finder *t, const cell_list *c, uint32_t i)
{
    const hide_box *box = t->fronts->front_box, *own = &box[c->list[i].front];
    const uint32_t most = objet_most(objet_sides(c->list[i].sides)), end = c->first + c->count;
    for (uint32_t k = c->first + i + 1; k < end; k += 4)
        for (unsigned near = objet_near(t->grid, k, end, most); near; near &= near - 1) {
            const uint32_t at = k - c->first + (uint32_t)bits_trailing_zeros(near);
            if (box[c->list[at].front].z1 < own->z0)
                return true;
            if (!filter_boxes_apart(t->filter, c->list[i].front, c->list[at].front) &&
                hide_boxes_meet(own, &box[c->list[at].front]) && !meet_listed(t, c, i, at))
                return false;
        }
    return true;
}

/* The flat patch of an entry; ROBERTS_NONE: it has none. */
static uint32_t patch_at(const finder *t, const cell_list *c, uint32_t k)
{
    const hide_front *front = &t->fronts->front[c->list[k].front];
    return hide_is_face(front) ? flat_patches_of(&t->filter->flat, front->piece) : ROBERTS_NONE;
}

/* Finds the flat patch to which all fronts below each node of a cell's tree belong; ROBERTS_NONE: there is none. The
 * children of a node follow it. False: no memory. */
static bool find_patches(finder *t, const cell_list *c, const front_tree *tree)
{
    if (t->filter->flat.count == 0)
        return true;
    if (!array_reserve(&t->patch, &t->patch_room, tree->count, sizeof *t->patch))
        return false;
    for (uint32_t n = tree->count; n-- > 0;) {
        bool any = false;
        for (int k = 0; k < 4; k++) {
            const uint32_t child = tree->node[n].child[k], place = child & ~FRONT_TREE_LEAF;
            if (child == 0) /* it is unused */
                continue;
            const uint32_t own = place == child ? t->patch[place] : patch_at(t, c, place);
            t->patch[n] = !any || own == t->patch[n] ? own : ROBERTS_NONE;
            any = true;
        }
    }
    return true;
}

/* Is it certain that entry k crosses no face of a patch? */
static bool lies_beside(const finder *t, const cell_list *c, uint32_t k, uint32_t patch)
{
    const hide_front *front = &t->fronts->front[c->list[k].front];
    return patch != ROBERTS_NONE && hide_is_face(front) && flat_patches_beside(&t->filter->flat, front->piece, patch);
}

/* Is it certain that nothing in the cell crosses the patch of entry i? Asked once for each patch in the cell. */
static bool is_alone(finder *t, const cell_list *c, uint32_t patch)
{
    if (patch == ROBERTS_NONE)
        return false;
    const size_t cell = scan_number(&t->grid->frame, c->column, c->row);
    uint32_t k = 0;
    if (t->asked[patch].cell != cell) {
        while (k < c->count && lies_beside(t, c, k, patch))
            k++;
        t->asked[patch].cell = cell;
        t->asked[patch].alone = k == c->count;
    }
    return t->asked[patch].alone;
}

/* Tests entry i with those that follow it, as the tree of the cell finds them. */
static bool meet_by_tree(finder *t, const cell_list *c, const front_tree *tree, uint32_t i)
{
    const uint32_t patch = patch_at(t, c, i);
    const bool flat = t->filter->flat.count > 0;
    if (is_alone(t, c, patch))
        return true;
    uint32_t stack[FRONT_TREE_WAITING] = {0}, depth = 1;
    const hide_box *box = t->fronts->front_box;
    const bool packed = t->fronts->front_count > t->fronts->whole_count;
    front_shape shape;
    front_shape_of(&shape, t->fronts, c->list[i].front);
    while (depth > 0) {
        const uint32_t child = stack[--depth], k = child & ~FRONT_TREE_LEAF;
        if (flat && lies_beside(t, c, i, k == child ? t->patch[k] : patch_at(t, c, k)))
            continue;
        if (k == child) {
            for (unsigned met = front_node_touches(&tree->node[k], &shape, i); met; met &= met - 1)
                stack[depth++] = tree->node[k].child[bits_trailing_zeros(met)];
            continue;
        }
        if (k <= i || k >= c->count || (packed && are_kin(t, i, k)) ||
            !hide_boxes_meet(&box[c->list[i].front], &box[c->list[k].front]) || lies_beside(t, c, k, patch) ||
            filter_boxes_apart(t->filter, c->list[i].front, c->list[k].front) ||
            (packed && !drop_neighbours(t, &t->four[i / 4], i % 4, &t->four[k / 4], 1u << k % 4)))
            continue;
        if (!meet_listed(t, c, i, k))
            return false;
    }
    return true;
}

/* Tests all pairs of one cell. */
static bool meet_cell(finder *t, uint32_t column, uint32_t row)
{
    const objet *grid = t->grid;
    size_t cell = scan_number(&grid->frame, column, row);
    cell_list c = {grid->entry + grid->start[cell], grid->start[cell], grid->start[cell + 1] - grid->start[cell],
                   column, row};
    if (grid->apart && grid->apart[cell])
        return true;
    if (t->nearest)
        c.count = objet_count_nearer(t->fronts, c.list, c.count, t->nearest[cell]);
    const bool solids = t->fronts->front_count == t->fronts->whole_count;
    if (t->filter->fronts->rear && filter_apart_in_cell(t->filter, c.list, c.count))
        return true;
    if (!solids) {
        memset(t->kept, 0, (c.count < KEPT_FACES ? c.count : KEPT_FACES) * sizeof *t->kept);
        if (!pack_cell(t, &c))
            return false;
    }
    const front_tree *tree = grid->tree && grid->tree[cell].node ? &grid->tree[cell] : NULL;
    if (tree && !find_patches(t, &c, tree))
        return false;
    for (uint32_t i = 0; i + 1 < c.count; i++)
        if (!(tree     ? meet_by_tree(t, &c, tree, i)
              : solids ? meet_solids_behind(t, &c, i)
                       : meet_those_behind(t, &c, i)))
            return false;
    return true;
}

static bool meet_some(void *finders, size_t first, size_t end)
{
    finder *t = (finder *)finders + thread_self();
    const uint32_t ny = t->grid->frame.ny;
    for (size_t c = first; c < end; c++)
        if (!meet_cell(t, (uint32_t)(c / ny), (uint32_t)(c % ny)))
            return false;
    return true;
}

static bool meet_all(finder *finders, const objet *grid, int threads)
{
    return threads_each(threads, scan_cells(&grid->frame), CELLS_AT_ONCE, meet_some, finders);
}

/* ---- faces of several pieces ----------------------------------------------------------------------------------- */

/* Merges the pairs that the threads have listed, each once. */
static bool unite_pairs(finder *finders, int threads)
{
    finder *all = &finders[0];
    for (int i = 1; i < threads; i++) {
        finder *t = &finders[i];
        if (!array_reserve(&all->pair, &all->pair_room, all->pair_count + t->pair_count, sizeof *all->pair))
            return false;
        if (t->pair_count > 0)
            memcpy(all->pair + all->pair_count, t->pair, t->pair_count * sizeof *all->pair);
        all->pair_count += t->pair_count;
    }
    tidy_pairs(all);
    return true;
}

static bool meet_some_pairs(void *context, size_t first, size_t end)
{
    finder *finders = context, *t = &finders[thread_self()];
    const roberts_scene *scene = t->fronts->scene;
    const uint64_t *pair = finders->pair;
    for (size_t k = first; k < end; k++) {
        uint32_t f = (uint32_t)(pair[k] >> 32), g = (uint32_t)pair[k];
        const uint32_t body[2] = {scene_body_of_face(scene, f), scene_body_of_face(scene, g)};
        if (!meet_whole(t, body, (uint32_t[]){f, g}))
            return false;
    }
    return true;
}

static bool meet_pairs(finder *finders, int threads)
{
    return unite_pairs(finders, threads) && threads_each(threads, finders->pair_count, 16, meet_some_pairs, finders);
}

/* ---- all of it ------------------------------------------------------------------------------------------------- */

/* A segment, with the numbers of its faces in the file. */
typedef struct named {
    uint32_t number[2];
    crossing_segment is;
} named;

static int compare_points(const crossing_point *p, const crossing_point *q)
{
    int order = vec3_compare(p->point, q->point);
    return order != 0 ? order : vec3_compare(p->low, q->low);
}

static int compare_named(const void *pa, const void *pb)
{
    const named *a = pa, *b = pb;
    int order = compare_pairs(a->number, b->number);
    if (order == 0)
        order = compare_pairs(a->is.face, b->is.face);
    for (int i = 0; order == 0 && i < 2; i++)
        order = compare_points(&a->is.end[i], &b->is.end[i]);
    return order != 0 ? order : compare_pairs(a->is.edge, b->is.edge);
}

/* Are they one line? An edge may have a part in common with several others. */
static bool same_named(const named *a, const named *b)
{
    named c = *b;
    c.is.edge[0] = a->is.edge[0];
    c.is.edge[1] = a->is.edge[1];
    return compare_named(a, &c) == 0;
}

/* Puts the face of smaller number first. */
static named name_segment(const roberts_scene *scene, const crossing_segment *s)
{
    named n = {{scene_face_number(scene, s->face[0]), scene_face_number(scene, s->face[1])}, *s};
    if (n.number[0] < n.number[1] || (n.number[0] == n.number[1] && s->face[0] < s->face[1]))
        return n;
    for (int i = 0; i < 2; i++) {
        n.number[i] = scene_face_number(scene, s->face[1 - i]);
        n.is.face[i] = s->face[1 - i];
        n.is.body[i] = s->body[1 - i];
        n.is.edge[i] = s->edge[1 - i];
    }
    return n;
}

/* Sorts what the threads have found. Several cells may have found a segment; it is kept once. */
static bool gather(crossings *c, const roberts_scene *scene, const finder *finders, int threads)
{
    size_t count = 0;
    for (int i = 0; i < threads; i++)
        count += finders[i].found.count;
    if (count == 0)
        return true;
    named *all = alloc_array(count, sizeof *all);
    c->item = alloc_array(count, sizeof *c->item);
    c->end = alloc_array(count, sizeof *c->end);
    c->name = alloc_array(count, sizeof *c->name);
    bool enough = all && c->item && c->end && c->name;
    for (int i = 0, to = 0; enough && i < threads; i++)
        for (size_t k = 0; k < finders[i].found.count; k++)
            all[to++] = name_segment(scene, &finders[i].found.item[k]);
    if (enough)
        qsort(all, count, sizeof *all, compare_named);
    for (size_t k = 0; enough && k < count; k++) {
        const named *n = &all[k];
        if (k > 0 && same_named(n, n - 1)) {
            c->item[c->count - 1].seam = c->item[c->count - 1].seam && n->is.seam;
            continue;
        }
        c->pairs += k == 0 || n->is.face[0] != n[-1].is.face[0] || n->is.face[1] != n[-1].is.face[1];
        c->item[c->count] = n->is;
        c->name[c->count] = (roberts_crossing){{n->number[0], n->number[1]}, {n->is.end[0].point, n->is.end[1].point}};
        for (int i = 0; i < 2; i++)
            c->end[c->count][i] = (seen_point){n->is.end[i].point, n->is.end[i].low};
        c->count++;
    }
    free(all);
    return enough;
}

static bool finders_init(finder *finders, int threads, const hide_fronts *fronts, const objet *grid,
                         const crossing_filter *filter)
{
    for (int i = 0; i < threads; i++) {
        finders[i].fronts = fronts;
        finders[i].grid = grid;
        finders[i].filter = filter;
        finders[i].nearest = grid->sheet.depth;
        finders[i].whole[0].number = finders[i].whole[1].number = ROBERTS_NONE;
        finders[i].rules = (crossing_rules){.scene = fronts->scene,
                                            .touching = fronts->space.epsilon * fronts->scene->unit,
                                            .unseen = may_be_unseen(fronts->seen) ? is_unseen : NULL,
                                            .context = &finders[i]};
        finders[i].face = alloc_array(KEPT_FACES, sizeof *finders[i].face);
        finders[i].asked = alloc_array(filter->flat.count, sizeof *finders[i].asked);
        if (!finders[i].face || !finders[i].asked)
            return false;
        for (size_t k = 0; k < filter->flat.count; k++)
            finders[i].asked[k].cell = ROBERTS_NONE;
    }
    return true;
}

/* All that the threads have found to touch, and the lines that it gives. */
static bool find_on_edges(finder *finders, int threads)
{
    crossing_list *all = &finders[0].found;
    for (int i = 1; i < threads; i++) {
        const crossing_list *more = &finders[i].found;
        if (!array_reserve(&all->touch, &all->touch_room, all->touch_count + more->touch_count, sizeof *all->touch))
            return false;
        if (more->touch_count > 0)
            memcpy(all->touch + all->touch_count, more->touch, more->touch_count * sizeof *all->touch);
        all->touch_count += more->touch_count;
    }
    return edge_crossings_find(finders->fronts, &finders->rules, all);
}

typedef struct crossed_lines {
    const crossings *of;
    const seen *seen;
} crossed_lines;

/* A line in which a closed body meets a sheet, which is face[sheet]. Whether it lies along edges makes no difference.
 * If the near plane has cut the scene, its faces have other numbers than those given. */
static union_line union_line_of_sheet(const seen *s, const crossing_segment *is, int sheet, uint32_t own[2])
{
    const uint32_t body = is->body[1 - sheet];
    const plane G = scene_plane(s->scene, is->face[sheet]);
    own[0] = is->face[1 - sheet];
    return (union_line){.A = is->end[0].point,
                        .B = is->end[1].point,
                        .body = ROBERTS_NONE,
                        .crossed = {body, body},
                        .sheet = {G.a, G.b, G.c},
                        .number = scene_face_number(s->scene, own[0]),
                        .own = own,
                        .own_count = s->scene == s->source};
}

/* A line in which faces cross, of closed bodies, or of one and a sheet. */
static bool union_line_of(const void *context, uint32_t index, union_line *line, uint32_t own[2])
{
    const crossed_lines *lines = context;
    const seen *s = lines->seen;
    const crossing_segment *is = &lines->of->item[index];
    const bool takes[2] = {union_takes(s->source, is->body[0]), union_takes(s->source, is->body[1])};
    if (takes[0] != takes[1])
        *line = union_line_of_sheet(s, is, takes[0], own);
    if (!takes[0] || !takes[1])
        return takes[0] || takes[1];
    if (is->edge[0] != ROBERTS_NONE || is->edge[1] != ROBERTS_NONE) {
        int i = is->edge[0] == ROBERTS_NONE;
        if (s->scene != s->source)
            return false;
        *line = union_line_of_edge(s->source, is->body[i], is->edge[i], own);
        line->A = is->end[0].point;
        line->B = is->end[1].point;
        return true;
    }
    *line = (union_line){.A = is->end[0].point,
                         .B = is->end[1].point,
                         .body = ROBERTS_NONE,
                         .crossed = {is->body[0], is->body[1]},
                         .own = own,
                         .own_count = s->scene == s->source ? 2 : 0};
    own[0] = is->face[0];
    own[1] = is->face[1];
    return true;
}

static bool find_pieces(crossings *c, const seen *s, uint32_t threads)
{
    const crossed_lines lines = {c, s};
    if (!s->edges.first || c->count == 0)
        return true;
    return c->count < ROBERTS_NONE &&
           united_find(&c->pieces, &s->bodies, union_line_of, &lines, (uint32_t)c->count, threads);
}

/* Is it part of an edge that the union draws? Where closed bodies meet in an edge, its pieces say so. */
static bool is_united_edge(const seen *s, const crossing_segment *is)
{
    return (is->edge[0] != ROBERTS_NONE || is->edge[1] != ROBERTS_NONE) && is->body[0] != is->body[1] &&
           union_takes(s->source, is->body[0]) && union_takes(s->source, is->body[1]);
}

bool crossings_unite(const crossings *c, const seen *s, size_t k, seen_line *line)
{
    const crossing_segment *is = &c->item[k];
    if (!s->edges.first)
        return true;
    if (is_united_edge(s, is))
        return false;
    if (!united_pieces(&c->pieces, (uint32_t)k))
        return !is->seam;
    line->alone = !is->seam;
    line->sheet = union_takes(s->source, is->body[0]) != union_takes(s->source, is->body[1]);
    return seen_take_pieces(s, c->item[k].body[0], &c->pieces, (uint32_t)k, line);
}

/* Drops lines along edges that turn out to be no seams. */
static void drop_false_seams(crossings *c, const seen *s)
{
    const size_t count = c->count;
    c->count = c->pairs = 0;
    for (size_t k = 0; k < count; k++) {
        const crossing_segment *is = &c->item[k];
        seen_line line = {.class = ROBERTS_INTERSECTION};
        if (is->seam && !crossings_unite(c, s, k, &line))
            continue;
        c->pairs += c->count == 0 || compare_pairs(is->face, c->item[c->count - 1].face) != 0;
        c->pieces.first[c->count] = c->pieces.first[k];
        c->name[c->count] = c->name[k];
        memmove(c->end[c->count], c->end[k], sizeof *c->end);
        c->item[c->count++] = *is;
    }
}

bool crossings_find(crossings *c, const hide_fronts *fronts, const objet *grid, uint32_t threads)
{
    int count = threads_for(threads, 1 + grid->start[scan_cells(&grid->frame)] / WORTH_A_THREAD);
    finder *finders = alloc_zeroed((size_t)count, sizeof *finders);
    crossing_filter filter = {0};
    bool hidden = fronts->seen->rules.hidden;
    bool enough = finders && filter_begin(&filter, fronts, grid, count) &&
                  finders_init(finders, count, fronts, grid, &filter) &&
                  (hidden ? face_pairs_find(fronts, filter.touching, count, meet_pair, finders)
                          : meet_all(finders, grid, count)) &&
                  meet_pairs(finders, count) && find_on_edges(finders, count) &&
                  gather(c, fronts->scene, finders, count) && find_pieces(c, fronts->seen, threads);
    if (enough && c->pieces.first)
        drop_false_seams(c, fronts->seen);
    for (int i = 0; finders && i < count; i++) {
        crossing_list_free(&finders[i].found);
        crossing_kept_free(&finders[i].last);
        free(finders[i].pair);
        free(finders[i].face);
        free(finders[i].four);
        free(finders[i].patch);
        free(finders[i].asked);
        free(finders[i].list[0].item);
        free(finders[i].list[1].item);
    }
    free(finders);
    filter_end(&filter);
    return enough;
}

void crossings_free(crossings *c)
{
    free(c->item);
    free(c->end);
    free(c->name);
    united_free(&c->pieces);
    *c = (crossings){0};
}

/* Is the face at the back of a convex body, or edge-on? Then the body hides what lies in it. */
static bool is_back_face(const seen *s, const crossing_segment *is, int i)
{
    return scene_is_convex(s->scene, is->body[i]) && s->facing[is->face[i]] != VIEW_FRONT;
}

bool crossings_is_back(const crossings *c, const seen *s, size_t k)
{
    return is_back_face(s, &c->item[k], 0) || is_back_face(s, &c->item[k], 1);
}

seen_line crossings_line(const crossings *c, const seen *s, size_t k)
{
    const roberts_scene *scene = s->scene;
    const crossing_segment *is = &c->item[k];
    seen_line line = {.edge = (uint32_t)k,
                      .v = {is->end[0].vertex, is->end[1].vertex},
                      .end = c->end[k],
                      .own = seen_owns_one(ROBERTS_NONE),
                      .t1 = 1.0,
                      .class = ROBERTS_INTERSECTION};
    int keys = 0;
    for (int i = 0; i < 2; i++) {
        bool edge = is->edge[i] != ROBERTS_NONE && !scene_is_convex(scene, is->body[i]);
        seen_own own = edge ? seen_own_of(scene, is->body[i], is->edge[i])
                            : seen_owns_one(seen_face_key(scene, is->body[i], is->face[i]));
        for (int n = 0; n < SEEN_KEYS && keys < SEEN_KEYS && !is_back_face(s, is, i); n++)
            if (own.key[n] != ROBERTS_NONE)
                line.own.key[keys++] = own.key[n];
        line.own.many = own.many ? own.many : line.own.many;
    }
    return line;
}
