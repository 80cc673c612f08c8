/* face_pairs.c - see face_pairs.h. */
#include "hide/face_pairs.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/search.h"
#include "base/threads.h"

box3 face_pairs_body_box(const roberts_scene *scene, uint32_t body)
{
    const scene_solid *own = &scene->solid[body];
    box3 box = box3_none;
    box_add_all(&box.lo, &box.hi, scene->point + own->vertex, own[1].vertex - own->vertex);
    return box;
}

box3 face_pairs_box(const roberts_scene *scene, uint32_t first, uint32_t end)
{
    const uint32_t *start = scene->face_start;
    return box3_of(scene->point, scene->corner + start[first], start[end] - start[first]);
}

/* ---- two bodies, and lists of their faces ------------------------------------------------------------------------ */

/* More pairs of faces of two solids than this are found by sorting. */
#define FEW_PAIRS 1024
/* To show that two solids are apart, at most this many corners are compared with planes. */
#define WORTH_A_PLANE 4096

bool bodies_are_apart(const hide_fronts *fronts, uint32_t solid, uint32_t body)
{
    const roberts_scene *scene = fronts->scene;
    const scene_solid *s = &scene->solid[solid], *b = &scene->solid[body];
    double touching = fronts->space.epsilon * scene->unit;
    if ((size_t)(s[1].face - s->face) * (b[1].vertex - b->vertex) > WORTH_A_PLANE)
        return false;
    for (uint32_t f = s->face; f < s[1].face; f++) {
        plane F = scene_plane(scene, f);
        uint32_t v = b->vertex;
        while (v < b[1].vertex && plane_at(F, vec3_sub(scene->point[v], scene->centre)) <= touching)
            v++;
        if (v == b[1].vertex)
            return !fronts->seen->edges.first || union_takes(fronts->seen->source, body);
    }
    return false;
}

static int compare_left(const void *pa, const void *pb)
{
    const boxed_face *a = pa, *b = pb;
    if (a->box.x0 != b->box.x0)
        return a->box.x0 < b->box.x0 ? -1 : 1;
    return (a->piece > b->piece) - (a->piece < b->piece);
}

static bool take_boxed(const face_taker *to, const boxed_face *f, const boxed_face *g, const uint32_t body[2])
{
    const face_pair pair = {{body[0], body[1]}, {f->piece, g->piece}};
    return !hide_boxes_meet(&f->box, &g->box) || to->take(to->context, to->thread, &pair);
}

bool face_lists_meet(face_list list[2], const uint32_t body[2], const face_taker *to)
{
    face_list *f = &list[0], *g = &list[1];
    bool enough = true;
    if (f->count * g->count <= FEW_PAIRS) {
        for (size_t i = 0; enough && i < f->count; i++)
            for (size_t k = 0; enough && k < g->count; k++)
                enough = take_boxed(to, &f->item[i], &g->item[k], body);
        return enough;
    }
    qsort(f->item, f->count, sizeof *f->item, compare_left);
    qsort(g->item, g->count, sizeof *g->item, compare_left);
    for (size_t i = 0, k = 0; enough && i < f->count && k < g->count;) {
        if (f->item[i].box.x0 <= g->item[k].box.x0) {
            for (size_t n = k; enough && n < g->count && g->item[n].box.x0 <= f->item[i].box.x1; n++)
                enough = take_boxed(to, &f->item[i], &g->item[n], body);
            i++;
        } else {
            for (size_t n = i; enough && n < f->count && f->item[n].box.x0 <= g->item[k].box.x1; n++)
                enough = take_boxed(to, &f->item[n], &g->item[k], body);
            k++;
        }
    }
    return enough;
}

/* ---- pairs of faces in space ------------------------------------------------------------------------------------- */

/* A convex solid of more faces has a tree over them, if its box meets that of another unit. */
#define FACES_WITHOUT_TREE 64

/* What the tree finds: a convex solid, or one face of another body. */
typedef struct unit {
    hide_box in_view;     /* its box in view space */
    uint32_t body, piece; /* piece: the first of the face; ROBERTS_NONE of a solid */
    uint32_t root;        /* of the tree over the faces of a solid; ROBERTS_NONE: there is none */
} unit;

/* The data of one thread. */
typedef struct pair_worker {
    const struct pair_search *of;
    int self;
    face_list list[2];
    char apart[THREADS_APART];
} pair_worker;

typedef struct pair_search {
    const hide_fronts *fronts;
    double touching; /* model units; what is farther apart is left out */
    face_pairs_fn *take;
    void *context;
    unit *unit; /* [count] */
    box3 *box;  /* [count] along the axes of the model, widened by half of `touching` */
    uint32_t count;
    box_tree tree; /* over the units: the first root; over faces of solids: further ones */
} pair_search;

static hide_box box_of_body(const hide_fronts *fronts, uint32_t body)
{
    const scene_solid *solid = &fronts->scene->solid[body];
    box3 own = box3_none;
    box_add_all(&own.lo, &own.hi, fronts->P + solid->vertex, solid[1].vertex - solid->vertex);
    return hide_box_around(&own);
}

/* The box of pieces first .. end - 1. */
static hide_box box_of_pieces(const hide_fronts *fronts, uint32_t first, uint32_t end)
{
    const uint32_t *start = fronts->scene->face_start;
    const box3 own = box3_of(fronts->P, fronts->scene->corner + start[first], start[end] - start[first]);
    return hide_box_around(&own);
}

/* Are all of these pieces edge-on? One alone may be, where the near plane leaves a sliver of it. */
static bool are_edge_on(const hide_fronts *fronts, uint32_t first, uint32_t end)
{
    while (first < end && fronts->seen->facing[first] == VIEW_EDGE_ON)
        first++;
    return first == end;
}

/* Widens a box by half of `touching`. */
static box3 widened(const pair_search *s, box3 box)
{
    const double more = 0.5 * s->touching;
    const roberts_vec3 wide = {more, more, more};
    return (box3){vec3_sub(box.lo, wide), vec3_add(box.hi, wide)};
}

/* The pieces of a planar face are one unit: apart they would give the same pair many times. A body that the near plane
 * has removed has no vertices. */
static void add_units(pair_search *s, uint32_t body)
{
    const hide_fronts *fronts = s->fronts;
    const scene_solid *own = &fronts->scene->solid[body];
    bool convex = scene_is_convex(fronts->scene, body);
    if (own[1].vertex == own->vertex)
        return;
    for (uint32_t f = own->face, end; f < (convex ? own->face + 1 : own[1].face); f = end) {
        end = convex ? own[1].face : scene_end_of_pieces(fronts->scene, body, f);
        if (!convex && are_edge_on(fronts, f, end))
            continue;
        s->box[s->count] =
            widened(s, convex ? face_pairs_body_box(fronts->scene, body) : face_pairs_box(fronts->scene, f, end));
        s->unit[s->count++] = (unit){convex ? box_of_body(fronts, body) : box_of_pieces(fronts, f, end), body,
                                     convex ? ROBERTS_NONE : f, ROBERTS_NONE};
    }
}

typedef bool met_unit_fn(void *context, uint32_t a, uint32_t b);

/* Calls `met` for each unit b whose box meets that of unit a, and for a itself, until it returns false. False: it did.
 */
static bool each_met(const pair_search *s, uint32_t a, met_unit_fn *met, void *context)
{
    box_search near = box_search_begin(&s->tree, 0, &s->box[a]);
    for (uint32_t b; box_search_next(&near, &b);)
        if (box3_meet(&s->box[a], &s->box[b]) && !met(context, a, b))
            return false;
    return true;
}

static bool is_same_unit(void *context, uint32_t a, uint32_t b)
{
    (void)context;
    return a == b;
}

/* Gives a large solid its tree, whose items are its faces in the scene. False: no memory. */
static bool plant_faces(pair_search *s, uint32_t a)
{
    unit *of = &s->unit[a];
    const scene_solid *own = &s->fronts->scene->solid[of->body];
    const uint32_t count = own[1].face - own->face;
    if (of->piece != ROBERTS_NONE || count <= FACES_WITHOUT_TREE ||
        each_met(s, a, is_same_unit, NULL)) /* it meets no other unit */
        return true;
    box3 *box = alloc_array(count, sizeof *box);
    for (uint32_t f = 0; box && f < count; f++)
        box[f] = widened(s, face_pairs_box(s->fronts->scene, own->face + f, own->face + f + 1));
    const bool enough = box && box_tree_add(&s->tree, box, count, own->face, &of->root);
    free(box);
    return enough;
}

/* False: no memory. */
static bool find_units(pair_search *s)
{
    const roberts_scene *scene = s->fronts->scene;
    size_t most = 0;
    for (uint32_t body = 0; body < scene->solid_count; body++)
        most += scene_is_convex(scene, body) ? 1 : scene->solid[body + 1].face - scene->solid[body].face;
    s->unit = alloc_array(most, sizeof *s->unit);
    s->box = alloc_array(most, sizeof *s->box);
    for (uint32_t body = 0; s->unit && s->box && body < scene->solid_count; body++)
        add_units(s, body);
    uint32_t root;
    bool enough = s->unit && s->box && (s->count == 0 || box_tree_add(&s->tree, s->box, s->count, 0, &root));
    for (uint32_t a = 0; enough && a < s->count; a++)
        enough = plant_faces(s, a);
    return enough;
}

/* Adds a face of unit `of` to the list, if its box meets that of the other unit. False: no memory. */
static bool list_face(const hide_fronts *fronts, const unit *of, uint32_t f, const unit *other, face_list *to)
{
    const uint32_t end = of->piece != ROBERTS_NONE ? scene_end_of_pieces(fronts->scene, of->body, f) : f + 1;
    const boxed_face item = {box_of_pieces(fronts, f, end), f};
    if (are_edge_on(fronts, f, end) || !hide_boxes_meet(&item.box, &other->in_view))
        return true;
    if (!array_reserve(&to->item, &to->room, to->count + 1, sizeof *to->item))
        return false;
    to->item[to->count++] = item;
    return true;
}

/* Lists the faces of unit a that meet the boxes of unit b. */
static bool list_faces(const pair_search *s, uint32_t a, uint32_t b, face_list *to)
{
    const unit *of = &s->unit[a], *other = &s->unit[b];
    const scene_solid *own = &s->fronts->scene->solid[of->body];
    const bool one = of->piece != ROBERTS_NONE;
    bool enough = true;
    to->count = 0;
    if (of->root != ROBERTS_NONE) {
        box_search near = box_search_begin(&s->tree, of->root, &s->box[b]);
        for (uint32_t f; enough && box_search_next(&near, &f);)
            enough = list_face(s->fronts, of, f, other, to);
        return enough;
    }
    for (uint32_t f = one ? of->piece : own->face, end = one ? f + 1 : own[1].face; enough && f < end; f++)
        enough = list_face(s->fronts, of, f, other, to);
    return enough;
}

/* Units a and b, of different bodies or not of a convex one. False: no memory. */
static bool meet_units(pair_worker *w, uint32_t a, uint32_t b)
{
    const pair_search *s = w->of;
    const unit *f = &s->unit[a], *g = &s->unit[b];
    const face_taker to = {s->take, s->context, w->self};
    if (f->piece != ROBERTS_NONE && g->piece != ROBERTS_NONE)
        return s->take(s->context, w->self, &(face_pair){{f->body, g->body}, {f->piece, g->piece}});
    if ((f->piece == ROBERTS_NONE && bodies_are_apart(s->fronts, f->body, g->body)) ||
        (g->piece == ROBERTS_NONE && bodies_are_apart(s->fronts, g->body, f->body)))
        return true;
    return list_faces(s, a, b, &w->list[0]) && list_faces(s, b, a, &w->list[1]) &&
           face_lists_meet(w->list, (uint32_t[]){f->body, g->body}, &to);
}

/* Compares a unit with a later one, if their boxes in view space meet, too. */
static bool meet_later(void *context, uint32_t a, uint32_t b)
{
    pair_worker *w = context;
    const unit *units = w->of->unit;
    return b <= a || !hide_boxes_meet(&units[a].in_view, &units[b].in_view) || meet_units(w, a, b);
}

static bool meet_some(void *context, size_t first, size_t end)
{
    pair_worker *w = (pair_worker *)context + thread_self();
    for (size_t a = first; a < end; a++)
        if (!each_met(w->of, (uint32_t)a, meet_later, w))
            return false;
    return true;
}

bool face_pairs_find(const hide_fronts *fronts, double touching, int threads, face_pairs_fn *take, void *context)
{
    pair_search s = {.fronts = fronts, .touching = touching, .take = take, .context = context};
    pair_worker *worker = alloc_zeroed((size_t)threads, sizeof *worker);
    bool lost = !worker || !find_units(&s);
    for (int i = 0; worker && i < threads; i++) {
        worker[i].of = &s;
        worker[i].self = i;
    }
    lost = lost || !threads_each(threads, s.count, 256, meet_some, worker);
    for (int i = 0; worker && i < threads; i++) {
        free(worker[i].list[0].item);
        free(worker[i].list[1].item);
    }
    free(worker);
    free(s.unit);
    free(s.box);
    box_tree_free(&s.tree);
    return !lost;
}
