/* bundle.c - see bundle.h. */
#include "hide/bundle.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/box.h"
#include "base/sort.h"

/* Up to this many keys are sorted by insertion. */
#define FEW 64

bool bundle_table_init(bundle_table *table, size_t count)
{
    *table = (bundle_table){.count = count / BUNDLE_FACES + 1};
    table->at = alloc_zeroed(table->count, sizeof(bundle *));
    return table->at != NULL;
}

static void free_bundle(bundle *b)
{
    if (b)
        free(b->order);
    free(b);
}

void bundle_table_free(bundle_table *table)
{
    for (size_t i = 0; table->at && i < table->count; i++)
        free_bundle(table->at[i]);
    free(table->at);
    *table = (bundle_table){0};
}

static roberts_vec3 middle_of(const hide_space *space, const hide_face *F)
{
    roberts_vec3 sum = {0.0, 0.0, 0.0};
    for (uint32_t i = 0; i < F->count; i++)
        sum = vec3_add(sum, space->P[F->corner[i]]);
    return vec3_scale(1.0 / F->count, sum);
}

/* The faces' midpoints, and scratch memory for sorting them. */
typedef struct middles {
    const roberts_vec3 *at;
    uint32_t *order;
    uint32_t *key, *place, *moved; /* [as many as order] */
} middles;

/* Sorts order[first .. first+count-1] by key[0 .. count-1]. False: no memory. */
static bool sort_middles(const middles *m, uint32_t first, uint32_t count)
{
    uint32_t *order = m->order + first;
    if (count > FEW && !radix_order(m->key, count, m->place))
        return false;
    for (uint32_t i = 0; count <= FEW && i < count; i++)
        m->place[i] = i;
    if (count <= FEW)
        SORT_FEW(uint32_t, m->place, count, m->key[*a] > m->key[*b])
    for (uint32_t i = 0; i < count; i++)
        m->moved[i] = order[m->place[i]];
    memcpy(order, m->moved, count * sizeof *order);
    return true;
}

/* Sorts the items of a node so that each node of `rank` below it holds neighbouring faces. The items are sorted by
 * midpoint along the longer side of their box; then each part is sorted likewise. (A Z-order curve jumps: with it, an
 * edge in front of a fan was compared with two to five times as many faces.) */
static bool sort_node(const middles *m, const list_tree *over, int rank, uint32_t first, uint32_t end)
{
    roberts_vec3 low = {INFINITY, INFINITY, INFINITY}, high = {-INFINITY, -INFINITY, -INFINITY};
    for (uint32_t i = first; i < end; i++)
        box_add(&low, &high, m->at[m->order[i]]);
    bool upright = high.y - low.y > high.x - low.x;
    for (uint32_t i = first; i < end; i++) {
        roberts_vec3 M = m->at[m->order[i]];
        m->key[i - first] = radix_key_descending((float)(upright ? M.y : M.x));
    }
    if (!sort_middles(m, first, end - first))
        return false;
    for (uint32_t next; rank > 0 && first < end; first = next) {
        next = list_tree_end(over, rank, first);
        if (!sort_node(m, over, rank - 1, first, next))
            return false;
    }
    return true;
}

/* Orders the faces so that neighbours in the list have neighbouring midpoints. False: no memory. */
static bool put_in_order(const hide_space *space, const hide_face *face, const list_tree *over, uint32_t *order)
{
    uint32_t count = over->items;
    roberts_vec3 *at = alloc_array(count, sizeof *at);
    uint32_t *scratch = alloc_array(count, 3 * sizeof *scratch);
    bool done = at && scratch;
    for (uint32_t i = 0; done && i < count; i++) {
        at[i] = middle_of(space, &face[i]);
        order[i] = i;
    }
    middles m = {at, order, scratch, scratch + count, scratch + 2 * (size_t)count};
    done = done && sort_node(&m, over, (int)over->ranks - 1, 0, count);
    free(at);
    free(scratch);
    return done;
}

/* The faces of a node: order[first .. end - 1]. */
typedef struct node_faces {
    const hide_space *space;
    const hide_face *face;
    const uint32_t *order;
    uint32_t first, end;
} node_faces;

/* Sets the node's frame: M is the mean of the midpoints, and (ux, uy) the direction in which the corners spread most,
 * the first principal axis of their second moments. */
static void set_node_frame(const node_faces *s, bundle_node *n)
{
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (uint32_t k = s->first; k < s->end; k++)
        n->M = vec3_add(n->M, middle_of(s->space, &s->face[s->order[k]]));
    n->M = vec3_scale(1.0 / (s->end - s->first), n->M);
    for (uint32_t k = s->first; k < s->end; k++) {
        const hide_face *F = &s->face[s->order[k]];
        for (uint32_t i = 0; i < F->count; i++) {
            roberts_vec3 D = vec3_sub(s->space->P[F->corner[i]], n->M);
            xx += D.x * D.x;
            xy += D.x * D.y;
            yy += D.y * D.y;
        }
    }
    double half = 0.5 * fabs(xx - yy), root = half + sqrt(half * half + xy * xy);
    double x = xx >= yy ? root : xy, y = xx >= yy ? xy : root, length = sqrt(x * x + y * y);
    n->ux = length > 0.0 ? x / length : 1.0;
    n->uy = length > 0.0 ? y / length : 0.0;
}

/* Adds a face to the node. At the far end of the scene its plane may be off by `touch - limit`, or by half of `touch`
 * if that is more (see set_trust() in front.c). */
static void add_to_node(const node_faces *s, bundle_node *n, const hide_face *F)
{
    double m = hide_margin(s->space), uncertain = greater(0.5 * F->touch, F->touch - (double)F->limit);
    for (uint32_t i = 0; i < F->count; i++) {
        roberts_vec3 D = vec3_sub(s->space->P[F->corner[i]], n->M);
        double x = n->ux * D.x + n->uy * D.y, y = n->ux * D.y - n->uy * D.x;
        n->x0 = lesser(n->x0, x - m);
        n->x1 = greater(n->x1, x + m);
        n->y0 = lesser(n->y0, y - m);
        n->y1 = greater(n->y1, y + m);
    }
    box_add(&n->least, &n->most, (roberts_vec3){F->F.a, F->F.b, F->F.c});
    n->behind = greater(n->behind, plane_at(F->F, n->M) + F->touch + uncertain + BUNDLE_ROUNDINGS * s->space->rounding);
}

static bundle_node make_node(const node_faces *s)
{
    bundle_node n = {.x0 = INFINITY,
                     .x1 = -INFINITY,
                     .y0 = INFINITY,
                     .y1 = -INFINITY,
                     .least = {INFINITY, INFINITY, INFINITY},
                     .most = {-INFINITY, -INFINITY, -INFINITY},
                     .behind = -INFINITY};
    set_node_frame(s, &n);
    for (uint32_t k = s->first; k < s->end; k++)
        add_to_node(s, &n, &s->face[s->order[k]]);
    return n;
}

static bundle *make_bundle(const hide_space *space, const hide_face *face, uint32_t count)
{
    list_tree over = list_tree_over(count);
    bundle *b = malloc(sizeof *b + over.start[over.ranks] * sizeof *b->node);
    if (!b)
        return NULL;
    b->tree = over;
    b->order = alloc_array(count, sizeof *b->order);
    if (!b->order || !put_in_order(space, face, &over, b->order)) {
        free_bundle(b);
        return NULL;
    }
    for (int rank = 0; rank < (int)over.ranks; rank++)
        for (uint32_t item = 0, end; item < count; item = end) {
            end = list_tree_end(&over, rank, item);
            b->node[list_tree_node(&over, rank, item)] = make_node(&(node_faces){space, face, b->order, item, end});
        }
    return b;
}

bool bundle_enter(bundle_table *table, const hide_space *space, const hide_face *face, uint32_t count, uint32_t first)
{
    bundle **at = &table->at[first / BUNDLE_FACES];
    *at = make_bundle(space, face, count);
    return *at != NULL;
}

bool bundle_meets(const bundle_node *n, const hide_edge *e, double *t0, double *t1)
{
    double ax = e->A.x - n->M.x, ay = e->A.y - n->M.y, bx = e->B.x - n->M.x, by = e->B.y - n->M.y;
    *t0 = 0.0;
    *t1 = 1.0;
    return box_clip(n->ux * ax + n->uy * ay, n->ux * bx + n->uy * by, n->x0, n->x1, t0, t1) &&
           box_clip(n->ux * ay - n->uy * ax, n->ux * by - n->uy * bx, n->y0, n->y1, t0, t1);
}

static bool holds(const bundle_node *n, double px, double py)
{
    double dx = px - n->M.x, dy = py - n->M.y, x = n->ux * dx + n->uy * dy, y = n->ux * dy - n->uy * dx;
    return x >= n->x0 && x <= n->x1 && y >= n->y0 && y <= n->y1;
}

bool bundle_next(const bundle *b, double x, double y, uint32_t *item, uint32_t *end)
{
    while (*item < b->tree.items) {
        int rank = list_tree_highest(&b->tree, *item);
        while (rank >= 0 && holds(&b->node[list_tree_node(&b->tree, rank, *item)], x, y))
            rank--;
        *end = list_tree_end(&b->tree, rank < 0 ? 0 : rank, *item);
        if (rank < 0)
            return true;
        *item = *end;
    }
    return false;
}
