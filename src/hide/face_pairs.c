/* face_pairs.c - see face_pairs.h. */
#include "hide/face_pairs.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/search.h"
#include "base/threads.h"

/* More pairs of faces of two solids than this are found by sorting. */
#define FEW_PAIRS 1024
/* To show that two solids are apart, at most this many corners are compared with planes. */
#define WORTH_A_PLANE 4096

/* What the tree finds: a convex solid, or one face of another body. */
typedef struct unit {
    uint32_t body, piece; /* piece: ROBERTS_NONE of a solid */
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
    face_pairs_fn *take;
    void *context;
    unit *unit; /* [count] */
    box3 *box;  /* [count] */
    uint32_t count;
    box_tree tree;
} pair_search;

/* ---- units ----------------------------------------------------------------------------------------------------- */

static box3 wide_box(const hide_box *box)
{
    return (box3){{(double)box->x0, (double)box->y0, (double)box->z0},
                  {(double)box->x1, (double)box->y1, (double)box->z1}};
}

static hide_box box_of_body(const hide_fronts *fronts, uint32_t body)
{
    hide_bounds own = hide_no_bounds;
    for (uint32_t v = fronts->scene->solid[body].vertex; v < fronts->scene->solid[body + 1].vertex; v++)
        box_add(&own.low, &own.high, fronts->P[v]);
    return hide_box_around(&own);
}

/* A body that the near plane has removed has no vertices. */
static void add_units(pair_search *s, uint32_t body)
{
    const hide_fronts *fronts = s->fronts;
    const scene_solid *own = &fronts->scene->solid[body];
    bool convex = scene_is_convex(fronts->scene, body);
    if (own[1].vertex == own->vertex)
        return;
    for (uint32_t f = own->face; f < (convex ? own->face + 1 : own[1].face); f++) {
        if (!convex && fronts->seen->facing[f] == VIEW_EDGE_ON)
            continue;
        hide_box box = convex ? box_of_body(fronts, body) : box_of_face(fronts, f);
        s->box[s->count] = wide_box(&box);
        s->unit[s->count++] = (unit){body, convex ? ROBERTS_NONE : f};
    }
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
    return s->unit && s->box && (s->count == 0 || box_tree_add(&s->tree, s->box, s->count, 0, &root));
}

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
            return true;
    }
    return false;
}

/* ---- two units ------------------------------------------------------------------------------------------------- */

/* Lists the faces of a unit that meet a box. */
static bool list_faces(const hide_fronts *fronts, const unit *of, const box3 *box, face_list *to)
{
    const scene_solid *own = &fronts->scene->solid[of->body];
    bool one = of->piece != ROBERTS_NONE;
    to->count = 0;
    for (uint32_t f = one ? of->piece : own->face; f < (one ? of->piece + 1 : own[1].face); f++) {
        boxed_face item = {box_of_face(fronts, f), f};
        box3 wide = wide_box(&item.box);
        if (fronts->seen->facing[f] == VIEW_EDGE_ON || !box3_meet(&wide, box))
            continue;
        if (!array_reserve(&to->item, &to->room, to->count + 1, sizeof *to->item))
            return false;
        to->item[to->count++] = item;
    }
    return true;
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
    return !boxes_meet(&f->box, &g->box) || to->take(to->context, to->thread, &pair);
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

/* ---- the search ------------------------------------------------------------------------------------------------ */

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
    return list_faces(s->fronts, f, &s->box[b], &w->list[0]) && list_faces(s->fronts, g, &s->box[a], &w->list[1]) &&
           face_lists_meet(w->list, (uint32_t[]){f->body, g->body}, &to);
}

/* Compares a unit with all later units whose boxes meet its box. */
static bool meet_others(pair_worker *w, uint32_t a)
{
    const pair_search *s = w->of;
    const box_tree *tree = &s->tree;
    for (uint32_t i = 0, end = tree->node[0].skip; i < end;) {
        const box_tree_node *node = &tree->node[i];
        if (!box3_meet(&node->box, &s->box[a])) {
            i = node->skip;
            continue;
        }
        for (uint32_t k = node->first; k < node->first + node->count; k++) {
            uint32_t b = tree->item[k];
            if (b > a && box3_meet(&s->box[a], &s->box[b]) && !meet_units(w, a, b))
                return false;
        }
        i++;
    }
    return true;
}

static bool meet_some(void *context, size_t first, size_t end)
{
    pair_worker *w = (pair_worker *)context + thread_self();
    for (size_t a = first; a < end; a++)
        if (!meet_others(w, (uint32_t)a))
            return false;
    return true;
}

bool face_pairs_find(const hide_fronts *fronts, int threads, face_pairs_fn *take, void *context)
{
    pair_search s = {.fronts = fronts, .take = take, .context = context};
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
