/* tree.c - a tree of boxes over boxes. See tree.h. */
#include "ray/tree.h"

#include <stdlib.h>

#include "base/array.h"

enum {
    LEAF_ITEMS = 2, /* a leaf holds no more, unless the boxes cannot be told apart */
    BINS = 12,      /* planes tried across an axis, and one; more gained nothing */
    BIN_DEPTH = 60, /* from here on nodes are halved by number, which ends after 32 more levels */
};

static const tree_box empty_box = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

static roberts_vec3 least(roberts_vec3 a, roberts_vec3 b)
{
    return (roberts_vec3){a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, a.z < b.z ? a.z : b.z};
}

static roberts_vec3 most(roberts_vec3 a, roberts_vec3 b)
{
    return (roberts_vec3){a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y, a.z > b.z ? a.z : b.z};
}

static tree_box box_union(tree_box a, tree_box b)
{
    return (tree_box){least(a.lo, b.lo), most(a.hi, b.hi)};
}

double tree_box_shadow(tree_box a, double floor)
{
    double x = a.hi.x - a.lo.x, y = a.hi.y - a.lo.y, z = a.hi.z - floor;
    return x < 0.0 ? 0.0 : x * y * z;
}

static double component(roberts_vec3 a, int axis)
{
    return axis == 0 ? a.x : axis == 1 ? a.y : a.z;
}

/* Twice the middle of a box along an axis. */
static double box_middle(tree_box a, int axis)
{
    return component(a.lo, axis) + component(a.hi, axis);
}

typedef struct builder {
    tree *t;
    const tree_box *box;
    const uint32_t *owner;
    double floor; /* the least z of all boxes */
} builder;

/* Where boxes are divided: along `axis`, those whose bin is below `bin` go first; 0: nowhere. */
typedef struct split {
    int axis, bin;
    double low, bins_per_length, cost;
} split;

static int bin_of(split s, tree_box box)
{
    int bin = (int)((box_middle(box, s.axis) - s.low) * s.bins_per_length);
    return bin < BINS ? bin : BINS - 1;
}

/* The cheapest plane across one axis; the boxes' middles (twice) reach from `low` over `length`. */
static split find_plane(const builder *b, uint32_t first, uint32_t count, int axis, double low, double length)
{
    split s = {axis, 0, low, BINS / length, INFINITY};
    tree_box bin_box[BINS], side = empty_box;
    uint32_t bin_count[BINS] = {0}, below = 0;
    double cost[BINS];
    if (!(length > 0.0) || !isfinite(s.bins_per_length))
        return s;
    for (int k = 0; k < BINS; k++)
        bin_box[k] = empty_box;
    for (uint32_t i = first; i < first + count; i++) {
        tree_box box = b->box[b->t->item[i]];
        int k = bin_of(s, box);
        bin_count[k]++;
        bin_box[k] = box_union(bin_box[k], box);
    }
    for (int k = 0; k < BINS - 1; k++) { /* boxes in bins 0 .. k ... */
        side = box_union(side, bin_box[k]);
        below += bin_count[k];
        cost[k + 1] = below * tree_box_shadow(side, b->floor);
    }
    side = empty_box;
    below = 0;
    for (int k = BINS - 1; k > 0; k--) { /* ... against those in bins k .. */
        side = box_union(side, bin_box[k]);
        below += bin_count[k];
        double both = cost[k] + below * tree_box_shadow(side, b->floor);
        if (below > 0 && below < count && both < s.cost) {
            s.cost = both;
            s.bin = k;
        }
    }
    return s;
}

static split find_split(const builder *b, uint32_t first, uint32_t count)
{
    tree_box middles = empty_box;
    split best = {.cost = INFINITY};
    for (uint32_t i = first; i < first + count; i++) {
        tree_box box = b->box[b->t->item[i]];
        roberts_vec3 m = vec3_add(box.lo, box.hi);
        middles = box_union(middles, (tree_box){m, m});
    }
    for (int axis = 0; axis < 3; axis++) {
        double low = component(middles.lo, axis);
        split s = find_plane(b, first, count, axis, low, component(middles.hi, axis) - low);
        if (s.cost < best.cost)
            best = s;
    }
    return best;
}

/* Moves the items below the split to the front, the others behind them; returns how many are below. */
static uint32_t divide(const builder *b, uint32_t first, uint32_t count, split s)
{
    uint32_t *item = b->t->item + first, below = 0;
    for (uint32_t i = 0; i < count; i++) {
        if (bin_of(s, b->box[item[i]]) < s.bin) {
            uint32_t swap = item[i];
            item[i] = item[below];
            item[below++] = swap;
        }
    }
    return below;
}

static float round_down(double x)
{
    float f = (float)x;
    return (double)f > x ? nextafterf(f, -INFINITY) : f;
}

static float round_up(double x)
{
    return -round_down(-x);
}

/* A leaf over some items: their box, and the owner that all of them have. */
static tree_node make_leaf(const builder *b, uint32_t first, uint32_t count)
{
    tree_box box = empty_box;
    uint32_t owner = b->owner[b->t->item[first]];
    for (uint32_t i = first; i < first + count; i++) {
        box = box_union(box, b->box[b->t->item[i]]);
        owner = b->owner[b->t->item[i]] == owner ? owner : ROBERTS_NONE;
    }
    return (tree_node){round_down(box.lo.x),
                       round_down(box.lo.y),
                       round_up(box.hi.x),
                       round_up(box.hi.y),
                       round_up(box.hi.z),
                       first,
                       count,
                       owner};
}

static void build_node(const builder *b, uint32_t first, uint32_t count, int depth)
{
    tree *t = b->t;
    uint32_t index = t->node_count++, below = count / 2;
    t->node[index] = make_leaf(b, first, count);
    if (count <= LEAF_ITEMS)
        return;
    if (depth < BIN_DEPTH) {
        split s = find_split(b, first, count);
        if (s.bin > 0)
            below = divide(b, first, count, s);
    }
    build_node(b, first, below, depth + 1);
    t->node[index].first = t->node_count;
    t->node[index].count = 0;
    build_node(b, first + below, count - below, depth + 1);
}

bool tree_build(tree *t, const tree_box *box, const uint32_t *owner, uint32_t count)
{
    builder b = {t, box, owner, INFINITY};
    *t = (tree){alloc_array(2 * (size_t)count + 1, sizeof *t->node), alloc_array(count, sizeof *t->item), 0};
    if (!t->node || !t->item) {
        tree_free(t);
        return false;
    }
    for (uint32_t i = 0; i < count; i++) {
        t->item[i] = i;
        b.floor = box[i].lo.z < b.floor ? box[i].lo.z : b.floor;
    }
    if (count)
        build_node(&b, 0, count, 0);
    return true;
}

void tree_free(tree *t)
{
    if (!t)
        return;
    free(t->node);
    free(t->item);
    *t = (tree){0};
}

void tree_walk_start(tree_walk *w, const tree *t, roberts_vec3 point, uint32_t skip)
{
    w->t = t;
    w->point = point;
    w->skip = skip;
    w->depth = 0;
    if (t->node_count)
        w->stack[w->depth++] = 0;
}

static bool is_over(const tree_node *n, roberts_vec3 p)
{
    return n->lo_x <= p.x && p.x <= n->hi_x && n->lo_y <= p.y && p.y <= n->hi_y && p.z <= n->hi_z;
}

uint32_t tree_walk_next(tree_walk *w, const uint32_t **item)
{
    while (w->depth) {
        uint32_t index = w->stack[--w->depth];
        const tree_node *node = &w->t->node[index];
        if (!is_over(node, w->point) || (node->owner == w->skip && w->skip != ROBERTS_NONE))
            continue;
        if (node->count) {
            *item = w->t->item + node->first;
            return node->count;
        }
        w->stack[w->depth++] = node->first;
        w->stack[w->depth++] = index + 1;
    }
    return 0;
}
