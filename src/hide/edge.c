/* edge.c - lines through the grid. See edge.h.
 *
 * The edges of a small solid go through the cells together: each front there is met once, by all edges. The edges of a
 * solid that spans many cells go one by one, each through the cells that its own picture crosses. */
#include "hide/edge.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/bits.h"
#include "base/box.h"
#include "base/lanes.h"

/* Edges of a solid with more columns or rows than this go one by one. */
#define GROUP_CELLS 3
/* Part of a cell: where cells have trees, a group must be smaller than this. The lines of a larger one go one by one,
 * since a tree excludes more for a line than for a box. */
#define SMALL_GROUP 0.125
/* For lists of at most this many fronts, choosing which fronts to meet first gains nothing. */
#define SHORT_LIST 32
/* After a group of lines has met this many fronts, most of what further fronts hide is already hidden. */
#define MANY_FRONTS 6
/* How many hidden parts of a line are compared with the part that a node of a tree may hide. */
#define KNOWN_PARTS 8
/* Single faces that a worker caches. The next lines mostly meet the same ones. */
#define KEPT_SINGLES 512u
_Static_assert((KEPT_SINGLES & (KEPT_SINGLES - 1)) == 0, "places in the cache are the last bits of numbers");

bool hide_worker_reserve(hide_worker *w, size_t lines)
{
    size_t room = w->line_room;
    if (lines <= room)
        return true;
    if (!array_grow(&w->line, &w->line_room, lines, sizeof *w->line))
        return false;
    memset(w->line + room, 0, (w->line_room - room) * sizeof *w->line);
    return true;
}

bool hide_worker_init(hide_worker *w, const hide_fronts *fronts, const objet *grid, bool all, bool named)
{
    *w = (hide_worker){
        .fronts = fronts, .grid = grid, .margin = hide_margin(&fronts->space), .all = all, .named = named};
    w->least[0] = w->least[2] = -INFINITY;
    w->most[1] = w->most[3] = INFINITY;
    w->stamped = alloc_zeroed(fronts->front_count, sizeof *w->stamped);
    w->single_mask = fronts->front_count > fronts->whole_count ? KEPT_SINGLES - 1 : 0;
    w->single = alloc_array(w->single_mask + 1, sizeof *w->single);
    for (uint32_t i = 0; w->single && i <= w->single_mask; i++)
        w->single[i].front = ROBERTS_NONE;
    /* Padding keeps the array apart from data that other threads write. At least one line is allocated, so the array
     * always exists. */
    return w->stamped && w->single && hide_sides_reserve(&w->sides, fronts->most_corners + THREADS_APART) &&
           hide_worker_reserve(w, 1);
}

static roberts_vec3 end_point(const hide_fronts *fronts, const seen_line *line, int k)
{
    if (line->v[k] != ROBERTS_NONE)
        return fronts->P[line->v[k]];
    return view_point(&fronts->seen->view, vec3_add(line->end[k].point, line->end[k].low));
}

BITS_RARE void hide_set_ends(const hide_fronts *fronts, const seen_line *line, hide_edge *e)
{
    e->A = end_point(fronts, line, 0);
    e->B = end_point(fronts, line, 1);
}

void hide_worker_add_taken(hide_worker *w, hide_line *line)
{
    size_t n = w->line_count++;
    line->e = (hide_edge){.a = ROBERTS_NONE, .b = ROBERTS_NONE};
    line->intervals.count = line->hulls.count = 0;
    line->hidden = true;
    if (n < HIDE_GROUP) {
        hide_lanes *l = &w->lanes;
        l->x0[n] = l->y0[n] = l->z0[n] = INFINITY;
        l->x1[n] = l->y1[n] = l->z1[n] = -INFINITY;
    }
}

void hide_worker_free(hide_worker *w)
{
    for (size_t i = 0; i < w->line_room; i++) {
        free(w->line[i].intervals.item);
        free(w->line[i].hulls.item);
    }
    free(w->line);
    free(w->sides.H);
    free(w->walk.item);
    free(w->stamped);
    free(w->single);
    free(w->level.item);
    *w = (hide_worker){0};
}

/* Removes from the part whatever is nearer than all corners of the front. The front cannot hide that, however its
 * planes are rounded. False: nothing is left. */
static BITS_RARE bool confine(const hide_worker *w, const hide_box *box, const hide_edge *e, hide_interval *part)
{
    double nearest = (double)box->z1 + w->margin;
    return box_clip(e->A.z, e->B.z, -INFINITY, nearest, &part->t0, &part->t1) &&
           box_clip(e->A.z, e->B.z, -INFINITY, nearest, &part->r0, &part->r1) &&
           hide_is_left(&w->fronts->space, e, part);
}

/* Is no point of the part that near, so that confine() would change nothing? */
static inline bool is_confined(const hide_worker *w, const hide_box *box, const hide_edge *e, const hide_interval *part)
{
    double nearest = (double)box->z1 + w->margin, dz = e->B.z - e->A.z;
    return e->A.z + part->r0 * dz <= nearest && e->A.z + part->r1 * dz <= nearest;
}

/* Shrinks the box of a line that is hidden at one end to the box of the rest, which begins at P. Fronts extend at most
 * a margin beyond their boxes. So a front whose box is more than the margin away from the new box hides nothing of the
 * rest and does not touch it. The box keeps the line's other end. */
BITS_INLINE void shrink(hide_worker *w, size_t n, const hide_interval *hidden)
{
    const hide_edge *e = &w->line[n].e;
    hide_lanes *l = &w->lanes;
    roberts_vec3 P, end;
    if (hidden->t0 == 0.0) {
        P = hide_edge_at(e, hidden->t1);
        end = e->B;
    } else {
        P = hide_edge_at(e, hidden->t0);
        end = e->A;
    }
    if (P.x < end.x)
        l->x0[n] = hide_float_below(P.x - w->margin);
    else
        l->x1[n] = hide_float_above(P.x + w->margin);
    if (P.y < end.y)
        l->y0[n] = hide_float_below(P.y - w->margin);
    else
        l->y1[n] = hide_float_above(P.y + w->margin);
    if (P.z < end.z)
        l->z0[n] = hide_float_below(P.z - w->margin);
}

/* Does the line plainly lie beside a face with which it shares a corner? If it ran through the face, the neighbours of
 * that corner would be on its right and on its left. */
BITS_INLINE bool is_beside_corner(const hide_fronts *fronts, const hide_edge *e, uint32_t right, uint32_t left)
{
    const roberts_vec3 *R = &fronts->P[right], *L = &fronts->P[left];
    two dx = two_of(e->B.x - e->A.x, e->A.x - e->B.x), dy = two_of(e->B.y - e->A.y, e->A.y - e->B.y);
    two x = two_sub(two_of(R->x, L->x), two_all(e->A.x)), y = two_sub(two_of(R->y, L->y), two_all(e->A.y));
    return two_at_most(two_all(fronts->space.plain), two_sub(two_mul(dx, y), two_mul(dy, x))) != 0;
}

/* Are all faces about a vertex one sheet in the picture? Then they lie beside its edges. */
BITS_INLINE bool is_sheet_about(const objet *grid, uint32_t vertex)
{
    return grid->star && atomic_load_explicit(&grid->star[vertex], memory_order_relaxed) == STAR_ONCE;
}

/* Do line and face plainly lie beside one another in the picture? They do if both ends of the line lie outside one side
 * of the face, or all corners on one side of the line. They may share a corner: they touch only there. Most faces of a
 * surface that a line meets are of this kind, and their planes need not be computed. */
BITS_INLINE bool is_beside(const hide_worker *w, const hide_edge *e, uint32_t face)
{
    const hide_fronts *fronts = w->fronts;
    const roberts_scene *scene = fronts->scene;
    const roberts_vec3 *P = fronts->P;
    const uint32_t *corner = scene->corner + scene->face_start[face],
                   *end = scene->corner + scene->face_start[face + 1], *shared = NULL;
    const bool back = fronts->seen->facing[face] == VIEW_BACK; /* the corners run clockwise */
    for (const uint32_t *c = corner; c < end; c++)
        if (*c == e->a || *c == e->b) {
            if (shared)
                return false; /* the line joins two corners */
            shared = c;
        }
    if (shared && is_sheet_about(w->grid, *shared))
        return true;
    if (shared) {
        uint32_t before = shared > corner ? shared[-1] : end[-1], after = shared + 1 < end ? shared[1] : corner[0];
        return (*shared == e->a) == back ? is_beside_corner(fronts, e, before, after)
                                         : is_beside_corner(fronts, e, after, before);
    }
    const double plain = fronts->space.plain;
    double dx = e->B.x - e->A.x, dy = e->B.y - e->A.y, low = INFINITY, high = -INFINITY;
    for (const uint32_t *c = corner; c < end; c++) {
        double left = dx * (P[*c].y - e->A.y) - dy * (P[*c].x - e->A.x);
        low = lesser(low, left);
        high = greater(high, left);
    }
    if (low > plain || high < -plain)
        return true;
    const two X = two_of(e->A.x, e->B.x), Y = two_of(e->A.y, e->B.y), least = two_all(-plain),
              turn = two_all(back ? -1.0 : 1.0);
    two px = two_sub(two_all(P[end[-1]].x), X), py = two_sub(two_all(P[end[-1]].y), Y);
    for (const uint32_t *c = corner; c < end; c++) {
        two qx = two_sub(two_all(P[*c].x), X), qy = two_sub(two_all(P[*c].y), Y);
        two left = two_mul(two_sub(two_mul(px, qy), two_mul(py, qx)), turn);
        if (two_at_most(left, least) == 3)
            return true;
        px = qx;
        py = qy;
    }
    return false;
}

/* Does the line not meet a front because it lies in it, or plainly beside a face of a surface? */
BITS_INLINE bool is_left_out(const hide_worker *w, const hide_line *line, const hide_front *front)
{
    return seen_owns(w->fronts->scene, &line->is.own, hide_key(w->fronts, front)) ||
           (front->kind == HIDE_SURFACE_FACE && is_beside(w, &line->e, front->piece));
}

/* Removes from `bits` the lines that are left out. Bit i stands for line first[i]. */
static BITS_PER_PROCESSOR BITS_RARE uint64_t not_left_out(const hide_worker *w, const hide_line *first, uint64_t bits,
                                                          uint32_t index)
{
    const hide_front *front = &w->fronts->front[index];
    if (bits == 1)
        return !is_left_out(w, first, front);
    for (uint64_t rest = bits; rest; rest &= rest - 1)
        if (is_left_out(w, first + bits_trailing_zeros(rest), front))
            bits &= ~(rest & -rest);
    return bits;
}

/* How a line and a triangle lie in the picture, as far as floats tell. */
typedef enum float_verdict { FLOATS_BESIDE, FLOATS_MEET, FLOATS_UNCLEAR } float_verdict;

/* Does the same as is_beside() from rounded coordinates. They decide if no sign is in doubt: a line that shares a
 * corner with the triangle leaves one in doubt. */
BITS_INLINE float_verdict beside_in_floats(const hide_triangle *t, const hide_edge *e, float plain)
{
    const four ax = four_all((float)e->A.x), ay = four_all((float)e->A.y);
    const four bx = four_all((float)e->B.x), by = four_all((float)e->B.y);
    const four least = four_all(plain), most = four_all(-plain);
    const four x = four_sub(four_load(t->x), ax), y = four_sub(four_load(t->y), ay);
    const four left = four_sub(four_mul(four_sub(bx, ax), y), four_mul(four_sub(by, ay), x));
    unsigned in = four_at_most(least, left), out = four_at_most(left, most), plainly = in | out;
    if (in == 15 || out == 15)
        return FLOATS_BESIDE;
    const four x1 = four_sub(four_load(t->x + 1), ax), y1 = four_sub(four_load(t->y + 1), ay);
    const four a = four_sub(four_mul(x, y1), four_mul(y, x1));
    const four u = four_sub(four_load(t->x), bx), v = four_sub(four_load(t->y), by);
    const four u1 = four_sub(four_load(t->x + 1), bx), v1 = four_sub(four_load(t->y + 1), by);
    const four b = four_sub(four_mul(u, v1), four_mul(v, u1));
    const unsigned out_a = four_at_most(a, most), out_b = four_at_most(b, most);
    if (out_a & out_b)
        return FLOATS_BESIDE;
    plainly &= (out_a | four_at_most(least, a)) & (out_b | four_at_most(least, b));
    return plainly == 15 ? FLOATS_MEET : FLOATS_UNCLEAR;
}

/* Returns the size from which a cross product of rounded coordinates has a plain sign, for lines and a front in these
 * boxes. Rounding one coordinate adds at most 2^-24 `across`, so a difference of two is off by twice that and its own
 * rounding, and the difference of two products by 24 * 2^-24 `across` times their sizes. */
BITS_INLINE float plain_in_floats(const hide_fronts *fronts, const hide_box *a, const hide_box *b)
{
    const float x = (a->x1 > b->x1 ? a->x1 : b->x1) - (a->x0 < b->x0 ? a->x0 : b->x0);
    const float y = (a->y1 > b->y1 ? a->y1 : b->y1) - (a->y0 < b->y0 ? a->y0 : b->y0);
    return (float)(32.0 * 0x1p-24 * fronts->space.view->across * (double)(x + y) + 2.0 * fronts->space.plain);
}

/* The same, where fronts are kept as triangles. box: of the lines. */
static BITS_PER_PROCESSOR BITS_RARE uint64_t not_left_out_in_floats(const hide_worker *w, const hide_line *first,
                                                                    uint64_t bits, const hide_box *box, uint32_t index)
{
    const hide_fronts *fronts = w->fronts;
    const hide_front *front = &fronts->front[index];
    const float plain = plain_in_floats(fronts, &fronts->front_box[index], box);
    for (uint64_t rest = bits; rest; rest &= rest - 1) {
        const hide_line *line = first + bits_trailing_zeros(rest);
        const float_verdict lies = beside_in_floats(&fronts->triangle[index], &line->e, plain);
        if (lies == FLOATS_BESIDE ||
            (lies == FLOATS_MEET ? seen_owns(fronts->scene, &line->is.own, hide_key(fronts, front))
                                 : is_left_out(w, line, front)))
            bits &= ~(rest & -rest);
    }
    return bits;
}

/* Tests lines against a front that may be nearer somewhere. Bit i of `bits` stands for line first[i]. The lines lie
 * within `box`. False: no memory. */
static BITS_PER_PROCESSOR bool meet(hide_worker *w, hide_line *first, uint64_t bits, const hide_box *box,
                                    uint32_t index)
{
    const hide_fronts *fronts = w->fronts;
    const hide_front *front = &fronts->front[index];
    const hide_box *own = &fronts->front_box[index];
    hide_meeting meeting = hide_meet(fronts, index, box, &w->single[index & w->single_mask]);
    bool ask = w->shrinks && ++w->met > MANY_FRONTS;
    if (!meeting.whole)
        w->sides.outline.corner = NULL; /* its corners may be where those of another face were */
    for (; bits; bits &= bits - 1) {
        hide_line *line = first + bits_trailing_zeros(bits);
        const hide_interval *hidden =
            ask && line->intervals.count ? &line->intervals.item[line->intervals.count - 1].part : NULL;
        hide_interval part;
        if (!hide_by_front(fronts, &meeting, &line->e, hidden, &w->sides, &part))
            continue;
        if (!is_confined(w, own, &line->e, &part) && !confine(w, own, &line->e, &part))
            continue;
        if (front->kind == HIDE_SOLID_FACE ? !hide_intervals_hull(&line->hulls, front->solid, &part)
                                           : !hide_intervals_add(&line->intervals, front->solid, &part))
            return false;
        if (part.t0 == 0.0 && part.t1 == 1.0) {
            line->hidden = true;
            w->lanes.x0[line - first] = w->whole.x0[line - first] = INFINITY; /* not used for a single line */
            w->live--;
        } else if (w->shrinks && (part.t0 == 0.0 || part.t1 == 1.0)) {
            shrink(w, (size_t)(line - w->line), &part);
        }
    }
    return true;
}

/* Finds the lines of the group whose boxes meet this one. Bit i stands for line i. */
static inline uint64_t met_by(const hide_lanes *l, size_t count, const hide_box *box)
{
    four x0 = four_all(box->x0), x1 = four_all(box->x1), y0 = four_all(box->y0), y1 = four_all(box->y1);
    four z1 = four_all(box->z1);
    uint64_t bits = 0;
    for (size_t i = 0; i < count; i += 4) {
        four x = four_either(four_below(x1, four_load(l->x0 + i)), four_below(four_load(l->x1 + i), x0));
        four y = four_either(four_below(y1, four_load(l->y0 + i)), four_below(four_load(l->y1 + i), y0));
        four apart = four_either(four_either(x, y), four_below(z1, four_load(l->z0 + i)));
        bits |= (uint64_t)(15u ^ four_signs(apart)) << i;
    }
    return bits;
}

/* Is a side of the box (x0, x1, y0, y1 as lanes) below its lower limit or above its upper limit? */
static inline bool is_apart(const hide_box *box, four least, four most)
{
    float side[4];
    memcpy(side, box, sizeof side);
    return four_signs(four_either(four_below(four_load(side), least), four_below(most, four_load(side)))) != 0;
}

/* Is the front one of the body to which all lines belong? That body is convex. */
static inline bool is_of_body(const hide_worker *w, uint32_t front)
{
    return seen_body_key(w->fronts->front[front].solid) == w->own;
}

/* Lines that go through the cells together: a single one, or all of a group. */
typedef struct line_set {
    hide_line *first;    /* the line, or the group's first line */
    bool alone;          /* a single line; otherwise hide_worker.lanes has the boxes of the lines */
    const hide_box *box; /* of all lines; the depth of a single line is not used */
} line_set;

/* Tests those lines whose boxes reach the front's box against one front that may be nearer somewhere, unless they have
 * already met it. False: no memory. */
BITS_INLINE bool meet_once(hide_worker *w, const line_set *p, uint32_t front)
{
    if (w->stamped[front] == w->stamp)
        return true;
    w->stamped[front] = w->stamp;
    /* The parts hidden by the faces of one solid are joined. So a face counts even if everything it hides is already
     * hidden. */
    bool hull = w->grid->next && w->fronts->front[front].kind == HIDE_SOLID_FACE;
    const hide_lanes *lanes = hull ? &w->whole : &w->lanes;
    const hide_box *box = &w->fronts->front_box[front];
    uint64_t bits =
        p->alone ? !is_apart(box, four_load(w->least), four_load(w->most)) : met_by(lanes, w->line_count, box);
    if (w->own == ROBERTS_NONE)
        bits = w->fronts->triangle ? not_left_out_in_floats(w, p->first, bits, p->box, front)
                                   : not_left_out(w, p->first, bits, front);
    return !bits || is_of_body(w, front) || meet(w, p->first, bits, p->box, front);
}

/* Tests the lines against the entries first .. end - 1, from the last to the first, four at a time. False: no
 * memory. */
BITS_INLINE bool meet_backward(hide_worker *w, const line_set *p, uint32_t first, uint32_t end, uint32_t sides)
{
    while (end > first && w->live) {
        uint32_t k = end - first < 4 ? first : end - 4;
        for (unsigned near = objet_near(w->grid, k, end, sides); near && w->live; near &= near - 1)
            if (!meet_once(w, p, w->grid->entry[k + (uint32_t)bits_trailing_zeros(near)].front))
                return false;
        end = k;
    }
    return true;
}

/* Tests the lines against the entries k .. end - 1, nearest fronts first. far: the farthest depth of the lines there.
 * False: no memory. */
BITS_INLINE bool meet_forward(hide_worker *w, const line_set *p, uint32_t k, uint32_t end, uint32_t sides, float far)
{
    const objet *grid = w->grid;
    const hide_fronts *fronts = w->fronts;
    for (uint32_t next; k < end; k = next) {
        if (grid->next && is_of_body(w, grid->entry[k].front)) {
            next = grid->next[k];
            continue;
        }
        unsigned near = objet_near(grid, k, end, sides);
        for (next = k + 4; near; near &= near - 1) {
            uint32_t front = grid->entry[k + (uint32_t)bits_trailing_zeros(near)].front;
            if (fronts->front_box[front].z1 < far)
                return true; /* from here on, no front has a point nearer than the lines */
            if (!meet_once(w, p, front))
                return false;
            if (!w->live)
                return true;
        }
    }
    return true;
}

/* Tests the lines against the list of one cell until all lines are completely hidden. Fronts that begin in front of
 * all lines come first, the farthest of them first: in a row or a pile, the adjacent solid hides more than a distant
 * one. The other fronts follow. Four fronts are examined at a time. (Prefetching the boxes of the next fronts gains
 * nothing, not even in scenes too large for any cache.) False: no memory. */
static BITS_PER_PROCESSOR bool meet_list(hide_worker *w, const line_set *p, uint32_t column, uint32_t row, float far)
{
    const objet *grid = w->grid;
    size_t cell = scan_number(&grid->frame, column, row);
    const uint32_t *start = grid->start + cell;
    uint32_t sides = objet_most(objet_cut(four_load(w->place), column, row)), k = start[0];
    bool alone = p->alone && grid->next; /* in every cell, a line of a fan would go back over all faces of the fan */
    if (!alone && start[1] - start[0] > SHORT_LIST) {
        k += objet_count_nearer(w->fronts, grid->entry + k, start[1] - k, p->box->z1);
        if (!meet_backward(w, p, start[0], k, sides))
            return false;
    }
    return !w->live || meet_forward(w, p, k, start[1], sides, far);
}

/* Trims a part of a line, with everything it touches, by the parts known to be hidden at its ends. False: nothing is
 * left. Only some of the hidden parts are examined. */
BITS_INLINE bool is_new(const hide_line *line, double *t0, double *t1)
{
    size_t count = line->intervals.count < KNOWN_PARTS ? line->intervals.count : KNOWN_PARTS;
    for (size_t i = 0; i < count; i++) {
        const hide_interval *part = &line->intervals.item[i].part;
        bool first = part->t0 == 0.0 || part->t0 < *t0, last = part->t1 == 1.0 || *t1 < part->t1;
        if (first && last)
            return false;
        if (first && *t0 < part->t1)
            *t0 = part->t1;
        if (last && part->t0 < *t1)
            *t1 = part->t0;
    }
    return true;
}

/* Tests part of a line against the fronts of a child of a cell's tree. False: no memory. */
static bool meet_child(hide_worker *w, const line_set *p, size_t cell, const front_line *line, front_visit v)
{
    const front_node *node = w->grid->tree[cell].node;
    const objet_entry *list = w->grid->entry + w->grid->start[cell];
    front_queue queue;
    front_visit found[4];
    uint32_t count;
    front_queue_begin(&queue);
    for (bool more = true; more && w->live; more = front_queue_next(&queue, found, count, &v)) {
        const uint32_t child = v.child & ~FRONT_TREE_LEAF;
        double from = (double)v.t0, to = (double)v.t1;
        count = 0;
        if (!w->named && !is_new(p->first, &from, &to))
            continue;
        if (child != v.child) {
            if (!meet_once(w, p, list[child].front))
                return false;
        } else if (queue.count > FRONT_QUEUE - 4) { /* no room: those below it get a queue of their own */
            if (!meet_child(w, p, cell, line, v))
                return false;
        } else {
            count = front_node_meets(&node[child], line, hide_float_below(from), hide_float_above(to), found);
        }
    }
    return true;
}

/* Tests the part t0 .. t1 of a line against the fronts of a cell with a tree. False: no memory. */
static bool meet_tree(hide_worker *w, const line_set *p, size_t cell, double t0, double t1)
{
    const front_line line = front_line_of(p->first->e.A, p->first->e.B, w->margin);
    return meet_child(w, p, cell, &line, (front_visit){0, hide_float_below(t0), hide_float_above(t1), 0.0f});
}

/* Tests the lines of a group against the fronts of a cell with a tree. False: no memory. */
static bool meet_tree_together(hide_worker *w, const line_set *p, size_t cell)
{
    const front_node *node = w->grid->tree[cell].node;
    const objet_entry *list = w->grid->entry + w->grid->start[cell];
    uint32_t stack[FRONT_TREE_WAITING] = {0}, depth = 1;
    while (depth > 0 && w->live) {
        const uint32_t which = stack[--depth], child = which & ~FRONT_TREE_LEAF;
        if (child == which)
            depth += front_node_meets_box(&node[child], p->box, stack + depth);
        else if (!meet_once(w, p, list[child].front))
            return false;
    }
    return true;
}

/* Tests the lines against the fronts of one cell. Of a single line, only `part` lies in the cell. far: the farthest
 * depth of the lines there. False: no memory. */
static bool meet_cell(hide_worker *w, const line_set *p, const objet_stretch *part, float far)
{
    const objet *grid = w->grid;
    const size_t cell = scan_number(&grid->frame, part->column, part->row);
    if (grid->below && far > grid->below[cell])
        return true; /* only edges of the sheet that fills the cell remain */
    if (grid->tree && grid->tree[cell].node)
        return p->alone ? meet_tree(w, p, cell, part->t0, part->t1) : meet_tree_together(w, p, cell);
    return meet_list(w, p, part->column, part->row, far);
}

/* Sets the limits that a front's box must reach to meet this box. */
static void set_reach(hide_worker *w, const hide_box *box)
{
    w->least[1] = box->x0;
    w->most[0] = box->x1;
    w->least[3] = box->y0;
    w->most[2] = box->y1;
    four_store(w->place, objet_place(w->grid, box));
}

/* Takes the next stamp. When stamps run out, they start again. */
static void next_stamp(hide_worker *w)
{
    if (++w->stamp == 0) {
        memset(w->stamped, 0, w->fronts->front_count * sizeof *w->stamped);
        w->stamp = 1;
    }
}

/* Takes one line through the cells it crosses. False: no memory. */
static bool run_alone(hide_worker *w, hide_line *line)
{
    const hide_edge *e = &line->e;
    if (line->hidden)
        return true;
    w->live = 1;
    w->shrinks = false;
    next_stamp(w);
    if (!objet_cells(w->grid, e->A, e->B, &w->walk))
        return false;
    hide_box box = hide_edge_box(e, w->margin);
    line_set p = {.first = line, .alone = true, .box = &box};
    set_reach(w, &box);
    for (size_t i = 0; w->live && i < w->walk.count; i++) {
        objet_stretch s = w->walk.item[i];
        float far = hide_float_below(lesser(hide_edge_at(e, s.t0).z, hide_edge_at(e, s.t1).z) - w->margin);
        if (!meet_cell(w, &p, &s, far))
            return false;
    }
    return true;
}

/* Takes all lines through the cells of their common box. False: no memory. */
static bool run_together(hide_worker *w, uint32_t left, uint32_t right, uint32_t low, uint32_t high)
{
    w->live = w->line_count;
    w->met = 0;
    w->shrinks = !w->named;
    for (size_t i = 0; w->all && i < w->line_count; i++) /* only then are there lines that their own body hides */
        if (w->line[i].hidden) {
            w->lanes.x0[i] = INFINITY;
            w->live--;
        }
    if (w->grid->next)
        w->whole = w->lanes;
    next_stamp(w);
    line_set p = {.first = w->line, .box = &w->box};
    set_reach(w, &w->box);
    for (uint32_t i = left; w->live && i <= right; i++)
        for (uint32_t j = low; j <= high; j++)
            if (!meet_cell(w, &p, &(objet_stretch){i, j, 0.0, 1.0}, w->box.z0))
                return false;
    return true;
}

/* Finds the box of a group. The unused ones of the last four lanes get boxes that meet nothing. */
static void box_lines(hide_worker *w)
{
    hide_box all = hide_no_box;
    const hide_lanes *l = &w->lanes;
    for (size_t i = 0; i < w->line_count; i++) {
        all.x0 = l->x0[i] < all.x0 ? l->x0[i] : all.x0;
        all.x1 = l->x1[i] > all.x1 ? l->x1[i] : all.x1;
        all.y0 = l->y0[i] < all.y0 ? l->y0[i] : all.y0;
        all.y1 = l->y1[i] > all.y1 ? l->y1[i] : all.y1;
        all.z0 = l->z0[i] < all.z0 ? l->z0[i] : all.z0;
        all.z1 = l->z1[i] > all.z1 ? l->z1[i] : all.z1;
    }
    for (size_t i = w->line_count; i % 4; i++)
        w->lanes.x0[i] = INFINITY;
    w->box = all;
}

/* Has one of these cells a tree? */
static bool has_tree(const objet *grid, uint32_t left, uint32_t right, uint32_t low, uint32_t high)
{
    for (uint32_t i = left; grid->tree && i <= right; i++)
        for (uint32_t j = low; j <= high; j++)
            if (grid->tree[scan_number(&grid->frame, i, j)].node)
                return true;
    return false;
}

/* Takes the lines through the cells, together or one by one, whichever costs less. False: no memory. */
BITS_INLINE bool run_lines(hide_worker *w)
{
    const scan_frame *f = &w->grid->frame;
    if (w->line_count <= HIDE_GROUP) {
        box_lines(w);
        uint32_t left = scan_column(f, (double)w->box.x0), right = scan_column(f, (double)w->box.x1);
        uint32_t low = scan_row(f, (double)w->box.y0), high = scan_row(f, (double)w->box.y1);
        const double x0 = scan_along_x(f, (double)w->box.x0), x1 = scan_along_x(f, (double)w->box.x1);
        const double y0 = scan_along_y(f, (double)w->box.y0), y1 = scan_along_y(f, (double)w->box.y1);
        const bool small = x1 - x0 < SMALL_GROUP * f->dx && y1 - y0 < SMALL_GROUP * f->dy;
        if (right - left < GROUP_CELLS && high - low < GROUP_CELLS &&
            (small || !has_tree(w->grid, left, right, low, high)))
            return run_together(w, left, right, low, high);
    }
    for (size_t i = 0; i < w->line_count; i++)
        if (!run_alone(w, &w->line[i]))
            return false;
    return true;
}

/* Adds the parts hidden by solids entered face by face. False: no memory. */
static BITS_RARE bool add_hulls(hide_line *line)
{
    hide_intervals_hulls_done(&line->hulls);
    for (size_t k = 0; k < line->hulls.count; k++)
        if (!hide_intervals_add(&line->intervals, line->hulls.item[k].solid, &line->hulls.item[k].part))
            return false;
    return true;
}

BITS_PER_PROCESSOR bool hide_worker_run(hide_worker *w)
{
    /* In a scene of one convex body, nothing hides its lines. (A fan lists all its triangles in the cell of its
     * tip.) */
    bool alone = w->fronts->scene->solid_count == 1 && w->own != ROBERTS_NONE;
    if (w->line_count > 0 && !alone && !run_lines(w))
        return false;
    for (hide_line *line = w->line, *end = line + w->line_count; line < end; line++) {
        if (line->hulls.count > 0 && !add_hulls(line))
            return false;
        hide_intervals_unite(&line->intervals, w->fronts->space.epsilon, line->e.length3);
    }
    return true;
}
