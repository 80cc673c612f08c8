/* tree.c - a tree of boxes over boxes. See tree.h. */
#include "ray/tree.h"

#include <stdlib.h>

#include "base/array.h"

enum {
    LEAF_ITEMS = 2, /* a leaf holds no more, unless the boxes cannot be told apart */
    BINS = 12,      /* planes tried for a split, and one; more gained nothing */
    BIN_DEPTH = 60, /* from here on nodes are halved by number, which ends after 32 more levels */
};

static const tree_box empty_box = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

static tree_box box_union(tree_box a, tree_box b)
{
    return (tree_box){{fmin(a.lo.x, b.lo.x), fmin(a.lo.y, b.lo.y), fmin(a.lo.z, b.lo.z)},
                      {fmax(a.hi.x, b.hi.x), fmax(a.hi.y, b.hi.y), fmax(a.hi.z, b.hi.z)}};
}

double tree_box_area(tree_box a)
{
    double x = a.hi.x - a.lo.x, y = a.hi.y - a.lo.y, z = a.hi.z - a.lo.z;
    return x < 0.0 ? 0.0 : x * y + y * z + z * x;
}

int tree_longest_axis(tree_box a)
{
    double x = a.hi.x - a.lo.x, y = a.hi.y - a.lo.y, z = a.hi.z - a.lo.z;
    return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

/* Twice the middle of a box along an axis. */
static double box_middle(tree_box a, int axis)
{
    return tree_component(a.lo, axis) + tree_component(a.hi, axis);
}

typedef struct builder {
    tree *t;
    const tree_box *box;
    const uint32_t *owner;
} builder;

/* Where boxes are divided: along `axis`, those whose bin is below `bin` go first. */
typedef struct split {
    int axis, bin;
    double low, bins_per_length;
} split;

static int bin_of(split s, tree_box box)
{
    int bin = (int)((box_middle(box, s.axis) - s.low) * s.bins_per_length);
    return bin < BINS ? bin : BINS - 1;
}

/* The cheapest of the planes across the longest side of the middles; false where all middles are the same. */
static bool find_split(const builder *b, uint32_t first, uint32_t count, split *best)
{
    tree_box middles = empty_box, bin_box[BINS];
    uint32_t bin_count[BINS] = {0}, below = 0;
    double cost[BINS], least = INFINITY;
    for (uint32_t i = first; i < first + count; i++) {
        tree_box box = b->box[b->t->item[i]];
        roberts_vec3 m = vec3_add(box.lo, box.hi);
        middles = box_union(middles, (tree_box){m, m});
    }
    int axis = tree_longest_axis(middles);
    double low = tree_component(middles.lo, axis), length = tree_component(middles.hi, axis) - low;
    *best = (split){axis, 0, low, BINS / length};
    if (!(length > 0.0) || !isfinite(best->bins_per_length))
        return false;
    for (int k = 0; k < BINS; k++)
        bin_box[k] = empty_box;
    for (uint32_t i = first; i < first + count; i++) {
        tree_box box = b->box[b->t->item[i]];
        int k = bin_of(*best, box);
        bin_count[k]++;
        bin_box[k] = box_union(bin_box[k], box);
    }
    tree_box side = empty_box;
    for (int k = 0; k < BINS - 1; k++) { /* boxes in bins 0 .. k ... */
        side = box_union(side, bin_box[k]);
        below += bin_count[k];
        cost[k + 1] = below * tree_box_area(side);
    }
    side = empty_box;
    below = 0;
    for (int k = BINS - 1; k > 0; k--) { /* ... against those in bins k .. */
        side = box_union(side, bin_box[k]);
        below += bin_count[k];
        if (below < count && cost[k] + below * tree_box_area(side) < least && below > 0) {
            least = cost[k] + below * tree_box_area(side);
            best->bin = k;
        }
    }
    return best->bin > 0;
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

/* The owner that all of some items have. */
static uint32_t one_owner(const builder *b, uint32_t first, uint32_t count)
{
    uint32_t owner = b->owner[b->t->item[first]];
    for (uint32_t i = 1; i < count; i++)
        if (b->owner[b->t->item[first + i]] != owner)
            return ROBERTS_NONE;
    return owner;
}

static void build_node(const builder *b, uint32_t first, uint32_t count, int depth)
{
    tree *t = b->t;
    uint32_t index = t->node_count++, below = count / 2;
    tree_box box = empty_box;
    split s = {0};
    for (uint32_t i = first; i < first + count; i++)
        box = box_union(box, b->box[t->item[i]]);
    t->node[index] = (tree_node){box, first, count, one_owner(b, first, count)};
    if (count <= LEAF_ITEMS)
        return;
    if (depth < BIN_DEPTH && find_split(b, first, count, &s))
        below = divide(b, first, count, s);
    build_node(b, first, below, depth + 1);
    t->node[index].first = t->node_count;
    t->node[index].count = 0;
    build_node(b, first + below, count - below, depth + 1);
}

bool tree_build(tree *t, const tree_box *box, const uint32_t *owner, uint32_t count)
{
    const builder b = {t, box, owner};
    *t = (tree){alloc_array(2 * (size_t)count + 1, sizeof *t->node), alloc_array(count, sizeof *t->item), 0};
    if (!t->node || !t->item) {
        tree_free(t);
        return false;
    }
    for (uint32_t i = 0; i < count; i++)
        t->item[i] = i;
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

/* 1 / v, but a number where v is 0 or nearly: then the slab is met for (almost) all t or for none, and no 0 times
 * infinity can arise. `size`: the largest component of the direction. */
static double finite_inverse(double v, double size)
{
    return fabs(v) > 1e-30 * size ? 1.0 / v : 1e30 / size;
}

void tree_walk_start(tree_walk *w, const tree *t, roberts_ray ray, double reach, uint32_t skip)
{
    roberts_vec3 v = ray.direction;
    double size = fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z)));
    w->t = t;
    w->origin = ray.origin;
    w->inverse = (roberts_vec3){finite_inverse(v.x, size), finite_inverse(v.y, size), finite_inverse(v.z, size)};
    w->reach = reach;
    w->skip = skip;
    w->depth = 0;
    if (t->node_count)
        w->stack[w->depth++] = 0;
}

static inline void narrow(double lo, double hi, double s, double inverse, double *t_in, double *t_out)
{
    double t0 = (lo - s) * inverse, t1 = (hi - s) * inverse;
    double near = t0 < t1 ? t0 : t1, far = t0 < t1 ? t1 : t0;
    *t_in = near > *t_in ? near : *t_in;
    *t_out = far < *t_out ? far : *t_out;
}

static bool meets(const tree_walk *w, const tree_box *box)
{
    double t_in = 0.0, t_out = w->reach;
    narrow(box->lo.x, box->hi.x, w->origin.x, w->inverse.x, &t_in, &t_out);
    narrow(box->lo.y, box->hi.y, w->origin.y, w->inverse.y, &t_in, &t_out);
    narrow(box->lo.z, box->hi.z, w->origin.z, w->inverse.z, &t_in, &t_out);
    return t_in <= t_out;
}

uint32_t tree_walk_next(tree_walk *w, const uint32_t **item)
{
    while (w->depth) {
        uint32_t index = w->stack[--w->depth];
        const tree_node *node = &w->t->node[index];
        if ((node->owner == w->skip && w->skip != ROBERTS_NONE) || !meets(w, &node->box))
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
