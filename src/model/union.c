/* union.c - many bodies as one: where their lines remain. See union.h.
 *
 * A line is cut at its events. Each piece is judged at its middle, by the rays in which faces leave the line there. The
 * rays divide the plane across the line into sectors, and each sector is filled by some body or by none
 * (union_angles.c). */
#include "model/union_work.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/box.h"
#include "base/dd.h"
#include "base/sort.h"
#include "model/winding.h"

/* Bodies with more faces have a tree of their own. */
enum { FEW_FACES = 24 };

/* The least sine of the angle between a line and a plane's normal at which a direction within the plane is well
 * defined. */
#define ACROSS_LEAST 1e-6

/* Touching distances: how far a line where two faces cross may be from their planes. Its ends may have been moved to
 * corners. */
#define OWN_TOUCH 4.0

/* ---- the bodies -------------------------------------------------------------------------------------------------- */

static box3 union_face_box(const roberts_scene *scene, uint32_t face, double margin)
{
    box3 box = box3_none;
    for (uint32_t i = scene->face_start[face]; i < scene->face_start[face + 1]; i++)
        box3_add(&box, union_place(scene, scene->point[scene->corner[i]]));
    roberts_vec3 m = {margin, margin, margin};
    return (box3){vec3_sub(box.lo, m), vec3_add(box.hi, m)};
}

/* Computes the box of a body, and the tree over its faces if it has many. box: scratch for its faces. False: no
 * memory. */
static bool prepare_body(union_bodies *all, uint32_t s, box3 *box, box3 *whole)
{
    const roberts_scene *scene = all->scene;
    uint32_t first = scene->solid[s].face, count = scene->solid[s + 1].face - first;
    for (uint32_t i = 0; i < count; i++)
        all->departure[s] = greater(all->departure[s], scene_deviation(scene, first + i) / scene->unit);
    for (uint32_t i = 0; i < count; i++) {
        box[i] = union_face_box(scene, first + i, all->touch + all->departure[s]);
        if (i == 0)
            *whole = box[0];
        box3_add(whole, box[i].lo);
        box3_add(whole, box[i].hi);
    }
    return count <= FEW_FACES || box_tree_add(&all->tree, box, count, first, &all->root[s]);
}

static bool prepare_bodies(union_bodies *all, const roberts_scene *left, box3 *box, box3 *whole, uint32_t *closed)
{
    const roberts_scene *scene = all->scene;
    uint32_t count = 0;
    for (uint32_t s = 0; s < scene->solid_count; s++) {
        all->root[s] = ROBERTS_NONE;
        if (!union_takes(scene, s) || left->solid[s].vertex == left->solid[s + 1].vertex)
            continue;
        if (!prepare_body(all, s, box, &whole[count]))
            return false;
        all->box[s] = whole[count];
        closed[count++] = s;
    }
    if (count == 0)
        return true;
    size_t first = all->tree.item_count;
    if (!box_tree_add(&all->tree, whole, count, 0, &all->bodies))
        return false;
    for (size_t i = first; i < all->tree.item_count; i++)
        all->tree.item[i] = closed[all->tree.item[i]];
    return true;
}

bool union_prepare(union_bodies *all, const roberts_scene *scene, const roberts_scene *left, double touch)
{
    uint32_t most = 0;
    for (uint32_t s = 0; s < scene->solid_count; s++) {
        uint32_t count = scene->solid[s + 1].face - scene->solid[s].face;
        most = count > most ? count : most;
    }
    *all = (union_bodies){.scene = scene,
                          .touch = touch / scene->unit,
                          .diameter = vec3_length(vec3_sub(scene->box_max, scene->box_min)) / scene->unit,
                          .departure = alloc_zeroed(scene->solid_count, sizeof *all->departure),
                          .box = alloc_array(scene->solid_count, sizeof *all->box),
                          .root = alloc_array(scene->solid_count, sizeof *all->root),
                          .bodies = ROBERTS_NONE};
    box3 *box = alloc_array(most, sizeof *box), *whole = alloc_array(scene->solid_count, sizeof *whole);
    uint32_t *closed = alloc_array(scene->solid_count, sizeof *closed);
    bool done = all->departure && all->box && all->root && box && whole && closed &&
                prepare_bodies(all, left, box, whole, closed) && winding_find(scene, &all->winding);
    free(box);
    free(whole);
    free(closed);
    if (!done)
        union_free(all);
    return done;
}

bool union_set_near(union_bodies *all, plane near)
{
    const roberts_scene *scene = all->scene;
    all->near = near;
    all->near.d /= scene->unit;
    all->cut = alloc_array(scene->solid_count, sizeof *all->cut);
    for (uint32_t s = 0; all->cut && s < scene->solid_count; s++) {
        uint32_t v = scene->solid[s].vertex;
        while (v < scene->solid[s + 1].vertex &&
               plane_at(all->near, union_place(scene, scene->point[v])) >= -(all->touch + all->departure[s]))
            v++;
        all->cut[s] = v < scene->solid[s + 1].vertex;
    }
    return all->cut != NULL;
}

void union_free(union_bodies *all)
{
    free(all->cut);
    free(all->departure);
    free(all->box);
    free(all->root);
    free(all->winding);
    box_tree_free(&all->tree);
    *all = (union_bodies){.bodies = ROBERTS_NONE};
}

void union_work_free(union_work *work)
{
    free(work->piece);
    free(work->side);
    free(work->contacts);
    free(work->fills);
    free(work->contact);
    free(work->ray);
    free(work->fill);
    free(work->event);
    *work = (union_work){0};
}

union_line union_line_of_edge(const roberts_scene *scene, uint32_t s, uint32_t e, uint32_t own[2])
{
    const scene_edge edge = scene_edge_at(scene, s, e);
    union_line line = {.A = scene->point[edge.v[0]], .B = scene->point[edge.v[1]], .body = s};
    line.own_count = scene_faces_at(scene, s, e, own, &line.own);
    return line;
}

/* ---- where the line meets a face --------------------------------------------------------------------------------- */

static bool add_event(union_cutter *c, double t)
{
    union_work *work = c->work;
    double near = 2.0 * c->touch / c->length;
    if (!(t > near && t < 1.0 - near))
        return true; /* at an end of the line */
    if (!array_reserve(&work->event, &work->event_room, work->event_count + 1, sizeof *work->event))
        return false;
    work->event[work->event_count++] = t;
    return true;
}

/* Is the line one of this face's own? If two faces cross in the line, all pieces of these faces count. */
static bool is_own(const union_cutter *c, uint32_t face)
{
    const roberts_scene *scene = c->all->scene;
    for (uint32_t i = 0; i < c->line->own_count; i++) {
        uint32_t own = c->line->own[i] & ~MANY_TURNED;
        if (own == face ||
            (c->line->body == ROBERTS_NONE && union_plane_number(scene, own) == union_plane_number(scene, face)))
            return true;
    }
    return false;
}

/* Returns where the line crosses the plane of a face, in double-double numbers. */
static double crossing(const union_cutter *c, uint32_t face)
{
    const roberts_scene *scene = c->all->scene;
    const uint32_t *corner = scene->corner + scene->face_start[face];
    uint32_t count = scene->face_start[face + 1] - scene->face_start[face];
    double k = 1.0 / scene->unit;
    roberts_vec3 O = vec3_scale(k, scene->point[corner[0]]);
    dd3 n = {{0, 0}, {0, 0}, {0, 0}}, sum = n; /* Newell's normal; the sum of the corners */
    for (uint32_t i = 0; i < count; i++) {
        dd3 p = dd3_between(vec3_scale(k, scene->point[corner[i]]), O);
        n = dd3_add(n, dd3_cross(p, dd3_between(vec3_scale(k, scene->point[corner[(i + 1) % count]]), O)));
        sum = dd3_add(sum, p);
    }
    dd number = {count, 0.0}, offset = dd3_dot(n, sum);
    dd a = dd_sub(dd_mul(number, dd3_dot(n, dd3_between(vec3_scale(k, c->line->A), O))), offset);
    dd b = dd_sub(dd_mul(number, dd3_dot(n, dd3_between(vec3_scale(k, c->line->B), O))), offset);
    return dd_zero_of(a, b);
}

/* How a line passes over a face. */
typedef struct overlap {
    double t0, t1;      /* the part of the line over the face, as parameters */
    double plus, minus; /* how far the face extends to both sides */
} overlap;

static void overlap_add(overlap *o, double t)
{
    o->t0 = lesser(o->t0, t);
    o->t1 = greater(o->t1, t);
}

/* Extends the overlap to a side of the face, from (s, t) to (s1, t1), where it lies beside the line: 0 <= t <= 1. The
 * faces of rounded solids may be farther from the line's continuation than from the line. */
static void overlap_extend(overlap *o, double s, double t, double s1, double t1)
{
    const double from[2] = {s, t}, to[2] = {s1, t1};
    if (greater(t, t1) < 0.0 || lesser(t, t1) > 1.0)
        return;
    for (int end = 0; end < 2; end++) {
        const double *at = end ? to : from, *other = end ? from : to;
        const double inside = lesser(greater(at[1], 0.0), 1.0);
        const double x = inside == at[1] ? at[0] : at[0] + (other[0] - at[0]) * ((inside - at[1]) / (other[1] - at[1]));
        o->plus = greater(o->plus, x);
        o->minus = greater(o->minus, -x);
    }
}

/* Finds where the line passes over a face. w: the direction in the plane of normal n, across the line. A corner nearer
 * than `touch` to the line's projection counts as on it. False: the face lies beside the line. */
static bool find_overlap(const union_cutter *c, uint32_t face, roberts_vec3 n, roberts_vec3 w, double touch, overlap *o)
{
    const roberts_scene *scene = c->all->scene;
    const uint32_t *corner = scene->corner + scene->face_start[face];
    uint32_t count = scene->face_start[face + 1] - scene->face_start[face];
    roberts_vec3 along = vec3_sub(c->U, vec3_scale(vec3_dot(c->U, n), n));
    double per = 1.0 / vec3_dot(along, along), s0 = 0.0, t0 = 0.0;
    *o = (overlap){INFINITY, -INFINITY, 0.0, 0.0};
    for (uint32_t i = 0; i <= count; i++) {
        roberts_vec3 P = vec3_sub(union_place(scene, scene->point[corner[i % count]]), c->A);
        double s = vec3_dot(P, w), t = vec3_dot(P, along) * per;
        if (fabs(s) <= touch)
            overlap_add(o, t);
        else if (i > 0 && fabs(s0) > touch && (s > 0.0) != (s0 > 0.0))
            overlap_add(o, t0 + (t - t0) * (s0 / (s0 - s)));
        if (i > 0)
            overlap_extend(o, s0, t0, s, t);
        s0 = s;
        t0 = t;
    }
    o->plus = o->plus > touch ? o->plus : 0.0;
    o->minus = o->minus > touch ? o->minus : 0.0;
    return o->t0 <= o->t1;
}

static bool add_contact(union_cutter *c, const union_contact *contact)
{
    union_work *work = c->work;
    if (!array_reserve(&work->contacts, &work->contacts_room, work->contacts_count + 1, sizeof *work->contacts))
        return false;
    work->contacts[work->contacts_count] = *contact;
    work->contacts[work->contacts_count].span.order = work->contacts_count;
    work->contacts_count++;
    return add_event(c, contact->span.t0) && add_event(c, contact->span.t1);
}

/* Adds one of an edge's own faces, which lies on one side of it. False: no memory. */
static bool add_own(union_cutter *c, uint32_t body, uint32_t face)
{
    const roberts_scene *scene = c->all->scene;
    plane F = union_plane(scene, face);
    roberts_vec3 n = {F.a, F.b, F.c}, w = vec3_cross(n, c->u);
    double length = vec3_length(w);
    overlap o;
    if (!(length > 0.0))
        return true;
    w = vec3_scale(1.0 / length, w);
    find_overlap(c, face, n, w, 0.0, &o);
    if (o.plus > o.minus)
        o.minus = 0.0;
    else
        o.plus = 0.0;
    return add_contact(
        c, &(union_contact){{0.0, 1.0, 0}, body, face, union_plane_number(scene, face), true, n, w, o.plus, o.minus});
}

/* Does the line, seen along itself, lie in the face or within `touch` of it? Pieces are convex. A side no longer than
 * `touch` has no direction to trust; its neighbours bound the face. */
static bool pierces(const union_cutter *c, uint32_t face, double touch)
{
    const roberts_scene *scene = c->all->scene;
    const uint32_t *corner = scene->corner + scene->face_start[face];
    uint32_t count = scene->face_start[face + 1] - scene->face_start[face];
    bool left = false, right = false;
    roberts_vec3 P = vec3_sub(union_place(scene, scene->point[corner[count - 1]]), c->A);
    double x = vec3_dot(P, c->e1), y = vec3_dot(P, c->e2);
    for (uint32_t i = 0; i < count; i++) {
        P = vec3_sub(union_place(scene, scene->point[corner[i]]), c->A);
        const double x1 = vec3_dot(P, c->e1), y1 = vec3_dot(P, c->e2), H = x * y1 - y * x1;
        const double length = hypot(x1 - x, y1 - y);
        left = left || (length > touch && H > touch * length);
        right = right || (length > touch && H < -touch * length);
        x = x1;
        y = y1;
    }
    return !left || !right;
}

/* Adds a contact, an event or nothing for a face of a body. Sets *beyond to true if the line lies completely on the
 * side of the plane where F < 0. False: no memory. */
static bool meet_face(union_cutter *c, const union_fill *of, uint32_t face, bool *beyond)
{
    const roberts_scene *scene = c->all->scene;
    plane F = union_plane(scene, face);
    double touch = of->touch, a = plane_at(F, c->A), b = plane_at(F, vec3_add(c->A, c->U));
    bool own = is_own(c, face);
    *beyond = !own && a < -touch && b < -touch;
    if (own && c->line->body != ROBERTS_NONE)
        return add_own(c, of->body, face);
    if (!own && (*beyond || (a > touch && b > touch)))
        return true;
    roberts_vec3 n = {F.a, F.b, F.c}, w = vec3_cross(n, c->u);
    double length = vec3_length(w);
    if (!(length > ACROSS_LEAST)) /* it meets the plane in one point */
        return !pierces(c, face, touch) || add_event(c, crossing(c, face));
    w = vec3_scale(1.0 / length, w);
    overlap o;
    if (!find_overlap(c, face, n, w, touch, &o))
        return true;
    double t0 = greater(o.t0, 0.0), t1 = lesser(o.t1, 1.0);
    if ((t1 - t0) * c->length < -touch)
        return true;
    double d0 = a + t0 * (b - a), d1 = a + t1 * (b - a), near = own ? OWN_TOUCH * touch : touch;
    if (fabs(d0) <= near && fabs(d1) <= near) {
        if ((t1 - t0) * c->length <= 2.0 * touch)
            return add_event(c, 0.5 * (t0 + t1));
        if (o.plus == 0.0 && o.minus == 0.0)
            return true; /* no wider than the touching distance */
        return add_contact(
            c,
            &(union_contact){{t0, t1, 0}, of->body, face, union_plane_number(scene, face), own, n, w, o.plus, o.minus});
    }
    if ((d0 > touch && d1 > touch) || (d0 < -touch && d1 < -touch))
        return true;
    return add_event(c, (d0 > 0.0) != (d1 > 0.0) ? crossing(c, face) : fabs(d0) < fabs(d1) ? t0 : t1);
}

/* Adds the contacts and events of one body, which is near the line in `span`. False: no memory. */
static bool meet_body(union_cutter *c, uint32_t body, union_span span, const box3 *box)
{
    const union_bodies *all = c->all;
    const roberts_scene *scene = all->scene;
    union_work *work = c->work;
    union_fill of = {.span = span,
                     .body = body,
                     .touch = all->touch + all->departure[body] + c->departure,
                     .convex = scene_is_convex(scene, body),
                     .wound = all->winding && all->winding[scene->solid[body].face] != 0};
    size_t contacts = work->contacts_count, events = work->event_count;
    bool beyond = false;
    c->touch = greater(c->touch, of.touch);
    if (of.convex && body == c->line->body) {
        for (uint32_t i = 0; i < c->line->own_count; i++)
            if (!meet_face(c, &of, c->line->own[i], &beyond))
                return false;
    } else if (all->root[body] == ROBERTS_NONE) {
        for (uint32_t f = scene->solid[body].face; f < scene->solid[body + 1].face; f++) {
            if (!meet_face(c, &of, f, &beyond))
                return false;
            if (of.convex && beyond) { /* a plane separates them */
                work->contacts_count = contacts;
                work->event_count = events;
                return true;
            }
        }
    } else {
        box_search near = box_search_begin(&all->tree, all->root[body], box);
        for (uint32_t f; box_search_next(&near, &f);)
            if (!meet_face(c, &of, f, &beyond))
                return false;
    }
    for (size_t i = contacts; i < work->contacts_count; i++) { /* by rounding, they may reach farther than its box */
        of.span.t0 = lesser(of.span.t0, work->contacts[i].span.t0);
        of.span.t1 = greater(of.span.t1, work->contacts[i].span.t1);
    }
    of.span.order = work->fills_count;
    if (!array_reserve(&work->fills, &work->fills_room, work->fills_count + 1, sizeof *work->fills))
        return false;
    work->fills[work->fills_count++] = of;
    return true;
}

/* Finds where the line passes the body's box. True: it touches it in at most one point, such as its end. Then the body
 * fills nothing along it. */
static bool passes(const union_cutter *c, uint32_t body, union_span *span)
{
    roberts_vec3 A = c->A, B = vec3_add(c->A, c->U), m = {c->departure, c->departure, c->departure};
    roberts_vec3 low = vec3_sub(c->all->box[body].lo, m), high = vec3_add(c->all->box[body].hi, m);
    double touch = c->all->touch + c->all->departure[body] + c->departure, *t0 = &span->t0, *t1 = &span->t1;
    *span = (union_span){0.0, 1.0, 0};
    return !box_clip(A.x, B.x, low.x, high.x, t0, t1) || !box_clip(A.y, B.y, low.y, high.y, t0, t1) ||
           !box_clip(A.z, B.z, low.z, high.z, t0, t1) || (*t1 - *t0) * c->length <= 2.0 * touch;
}

/* Adds all bodies near the line. False: no memory. */
static bool meet_bodies(union_cutter *c)
{
    const union_bodies *all = c->all;
    const union_span whole = {0.0, 1.0, 0};
    roberts_vec3 B = vec3_add(c->A, c->U), m = {c->touch, c->touch, c->touch};
    box3 box = {c->A, c->A};
    box3_add(&box, B);
    box.lo = vec3_sub(box.lo, m);
    box.hi = vec3_add(box.hi, m);
    box_search near = box_search_begin(&all->tree, all->bodies, &box);
    for (uint32_t body; box_search_next(&near, &body);) {
        union_span span;
        if (!passes(c, body, &span) && !meet_body(c, body, union_is_own(c, body) ? whole : span, &box))
            return false;
    }
    return true;
}

/* ---- the pieces -------------------------------------------------------------------------------------------------- */

static const union_span *span_of(const char *list, size_t size, size_t i)
{
    return (const union_span *)(const void *)(list + i * size);
}

static int by_start(const void *a, const void *b)
{
    const union_span *p = a, *q = b;
    if (p->t0 != q->t0)
        return p->t0 < q->t0 ? -1 : 1;
    return p->order < q->order ? -1 : p->order > q->order;
}

/* Goes on to t: drops what has ended, adds what has begun. */
static void span_list_follow(span_list *l, double t)
{
    const size_t size = l->size;
    size_t kept = 0;
    for (size_t i = 0; i < l->near_count; i++) {
        if (span_of(l->near, size, i)->t1 < t)
            continue;
        if (kept < i)
            memcpy(l->near + kept * size, l->near + i * size, size);
        kept++;
    }
    for (; l->next < l->count && span_of(l->all, size, l->next)->t0 <= t; l->next++) {
        const union_span *own = span_of(l->all, size, l->next);
        size_t k = kept;
        if (own->t1 < t)
            continue;
        while (k > 0 && span_of(l->near, size, k - 1)->order > own->order)
            k--;
        memmove(l->near + (k + 1) * size, l->near + k * size, (kept - k) * size);
        memcpy(l->near + k * size, own, size);
        kept++;
    }
    l->near_count = kept;
}

/* Are both pieces treated the same? Equal sides may be different faces in one plane. */
static bool same_answer(const union_cutter *c, const union_piece *a, const union_piece *b)
{
    const union_work *work = c->work;
    if (a->state != b->state || a->count != b->count)
        return false;
    for (uint32_t i = 0; i < a->count; i++) {
        if (!union_agree(c, &work->side[a->first + i], &work->side[b->first + i], 1.0))
            return false;
    }
    return true;
}

static bool add_union_piece(union_cutter *c, double t0, double t1)
{
    union_work *work = c->work;
    union_piece piece = {.t0 = t0, .t1 = t1};
    span_list_follow(&c->contacts, union_middle(&piece));
    span_list_follow(&c->fills, union_middle(&piece));
    work->contact_count = c->contacts.near_count;
    work->fill_count = c->fills.near_count;
    if (!union_judge(c, &piece))
        return false;
    union_piece *last = work->piece_count > 0 ? &work->piece[work->piece_count - 1] : NULL;
    if (last && same_answer(c, last, &piece)) {
        last->t1 = t1;
        work->side_count -= piece.count;
        return true;
    }
    if (!array_reserve(&work->piece, &work->piece_room, work->piece_count + 1, sizeof *work->piece))
        return false;
    work->piece[work->piece_count++] = piece;
    return true;
}

static void set_cut_frame(union_cutter *c)
{
    const roberts_scene *scene = c->all->scene;
    roberts_vec3 a = {fabs(c->line->B.x - c->line->A.x), fabs(c->line->B.y - c->line->A.y),
                      fabs(c->line->B.z - c->line->A.z)};
    roberts_vec3 axis = {a.x <= a.y && a.x <= a.z, a.y < a.x && a.y <= a.z, a.z < a.x && a.z < a.y};
    c->A = union_place(scene, c->line->A);
    c->U = vec3_scale(1.0 / scene->unit, vec3_sub(c->line->B, c->line->A));
    c->length = vec3_length(c->U);
    c->u = vec3_scale(1.0 / c->length, c->U);
    c->e1 = vec3_cross(c->u, axis);
    c->e1 = vec3_scale(1.0 / vec3_length(c->e1), c->e1);
    c->e2 = vec3_cross(c->u, c->e1);
}

/* Sorts what the line meets. False: no memory. */
static bool begin_lists(union_cutter *c)
{
    union_work *w = c->work;
    if (!array_reserve(&w->contact, &w->contact_room, w->contacts_count, sizeof *w->contact) ||
        !array_reserve(&w->fill, &w->fill_room, w->fills_count, sizeof *w->fill))
        return false;
    SORT_LIST(union_contact, w->contacts, w->contacts_count, by_start(a, b) > 0, by_start)
    SORT_LIST(union_fill, w->fills, w->fills_count, by_start(a, b) > 0, by_start)
    c->contacts = (span_list){
        .all = (char *)w->contacts, .near = (char *)w->contact, .size = sizeof *w->contact, .count = w->contacts_count};
    c->fills =
        (span_list){.all = (char *)w->fills, .near = (char *)w->fill, .size = sizeof *w->fill, .count = w->fills_count};
    return true;
}

/* Finds a face of the edge's own that lies in the near plane. */
static uint32_t find_in_near(const union_cutter *c)
{
    const roberts_scene *scene = c->all->scene;
    for (uint32_t i = 0; c->all->cut && c->line->body != ROBERTS_NONE && i < c->line->own_count; i++) {
        const uint32_t face = c->line->own[i] & ~MANY_TURNED, end = scene->face_start[face + 1];
        uint32_t k = scene->face_start[face];
        while (k < end && fabs(plane_at(c->all->near, union_place(scene, scene->point[scene->corner[k]]))) <= c->touch)
            k++;
        if (k == end)
            return face;
    }
    return ROBERTS_NONE;
}

bool union_cut(const union_bodies *all, const union_line *line, union_work *work)
{
    union_cutter c = {.all = all, .line = line, .work = work, .touch = all->touch};
    work->piece_count = work->side_count = work->contacts_count = work->fills_count = work->event_count = 0;
    set_cut_frame(&c);
    c.departure = line->body != ROBERTS_NONE
                      ? all->departure[line->body]
                      : greater(all->departure[line->crossed[0]], all->departure[line->crossed[1]]);
    c.touch += c.departure;
    c.in_near = find_in_near(&c);
    c.on_near = all->cut && fabs(plane_at(all->near, c.A)) <= c.touch &&
                fabs(plane_at(all->near, vec3_add(c.A, c.U))) <= c.touch;
    if (all->bodies == ROBERTS_NONE || !(c.length > 4.0 * c.touch)) /* shorter than the touching distance */
        return add_union_piece(&c, 0.0, 1.0);
    if (!meet_bodies(&c) || !begin_lists(&c))
        return false;
    double from = 0.0, near = 2.0 * c.touch / c.length;
    SORT_LIST(double, work->event, work->event_count, *a > *b, compare_doubles)
    for (size_t i = 0; i < work->event_count; i++) {
        double t = work->event[i];
        if (t <= from + near || t >= 1.0 - near)
            continue;
        if (!add_union_piece(&c, from, t))
            return false;
        from = t;
    }
    return add_union_piece(&c, from, 1.0);
}
