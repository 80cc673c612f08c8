/* tree.c - a tree of boxes over boxes. See tree.h. */
#include "ray/tree.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/fetch.h"

enum {
    LEAF_ITEMS = 1, /* two: 6 % more time on most scenes, 10 % less on needles seen askew */
    BINS = 12,      /* planes tried across an axis, and one; more gained nothing */
    SAMPLE = 1000,  /* entries that judge a plane, at the most twice as many; more gained nothing */
    BIN_DEPTH = 60, /* from here on nodes are halved by number, which ends after 32 more levels */
};

double tree_box_shadow(tree_box a, double floor)
{
    double x = a.hi.x - a.lo.x, y = a.hi.y - a.lo.y, z = a.hi.z - floor;
    return x < 0.0 ? 0.0 : x * y * z;
}

/* nextafterf() is a call, which takes longer. */
static float round_down(double x)
{
    float f = (float)lesser(greater(x, -FLT_MAX), FLT_MAX);
    return f - (fabsf(f) * FLT_EPSILON + FLT_MIN);
}

static float round_up(double x)
{
    return -round_down(-x);
}

tree_entry tree_entry_of(tree_box box, uint32_t owner, tree_item item)
{
    return (tree_entry){{round_down(box.lo.x), round_down(box.lo.y), round_down(box.lo.z)},
                        {round_up(box.hi.x), round_up(box.hi.y), round_up(box.hi.z)},
                        owner,
                        item};
}

/* ---- building --------------------------------------------------------------------------------------------------- */

/* What counts of a box. */
typedef struct cover {
    float lo_x, lo_y, hi_x, hi_y, hi_z;
} cover;

static const cover no_cover = {INFINITY, INFINITY, -INFINITY, -INFINITY, -INFINITY};

static inline float less(float a, float b)
{
    return a < b ? a : b;
}

static inline float more(float a, float b)
{
    return a > b ? a : b;
}

static inline cover cover_union(cover a, cover b)
{
    return (cover){less(a.lo_x, b.lo_x), less(a.lo_y, b.lo_y), more(a.hi_x, b.hi_x), more(a.hi_y, b.hi_y),
                   more(a.hi_z, b.hi_z)};
}

static inline cover cover_of(const tree_entry *e)
{
    return (cover){e->lo[0], e->lo[1], e->hi[0], e->hi[1], e->hi[2]};
}

static float shadow(cover a, float floor)
{
    return a.hi_x < a.lo_x ? 0.0f : (a.hi_x - a.lo_x) * (a.hi_y - a.lo_y) * (a.hi_z - floor);
}

/* What lies below a node. */
typedef struct crop {
    cover all;
    float low[3], high[3]; /* middles of boxes, twice */
    uint32_t owner;        /* ROBERTS_NONE: several */
} crop;

typedef struct builder {
    tree *t;
    tree_entry *entry;
    float floor; /* the least z of all boxes */
} builder;

/* Planes across an axis: those whose bin is below `bin` go first; 0: nowhere. Middles of boxes (twice) begin at `low`. */
typedef struct split {
    int axis, bin, bins;
    float low, bins_per_length, cost;
} split;

/* Twice the middle of a box along an axis. */
static inline float middle(const tree_entry *e, int axis)
{
    return e->lo[axis] + e->hi[axis];
}

static const crop no_crop = {{INFINITY, INFINITY, -INFINITY, -INFINITY, -INFINITY},
                             {INFINITY, INFINITY, INFINITY},
                             {-INFINITY, -INFINITY, -INFINITY},
                             0};

static inline void reap(crop *c, const tree_entry *e)
{
    c->owner = !(c->all.lo_x <= c->all.hi_x) || c->owner == e->owner ? e->owner : ROBERTS_NONE;
    c->all = cover_union(c->all, cover_of(e));
    for (int axis = 0; axis < 3; axis++) {
        c->low[axis] = less(c->low[axis], middle(e, axis));
        c->high[axis] = more(c->high[axis], middle(e, axis));
    }
}

static inline int bin_of(const split *s, const tree_entry *e)
{
    float bin = (middle(e, s->axis) - s->low) * s->bins_per_length;
    return bin < (float)s->bins ? (int)bin : s->bins - 1; /* the last one for NaN too */
}

/* The cheapest of an axis's planes. */
static void find_plane(split *s, const cover *bin, const uint32_t *bin_count, float floor)
{
    cover side = no_cover;
    uint32_t below = 0, above = 0;
    float cost[BINS];
    for (int k = 0; k < s->bins - 1; k++) { /* boxes in bins 0 .. k ... */
        side = cover_union(side, bin[k]);
        below += bin_count[k];
        cost[k + 1] = below ? (float)below * shadow(side, floor) : INFINITY;
    }
    side = no_cover;
    for (int k = s->bins - 1; k > 0; k--) { /* ... against those in bins k .. */
        side = cover_union(side, bin[k]);
        above += bin_count[k];
        float both = cost[k] + (float)above * shadow(side, floor);
        if (above > 0 && both < s->cost) {
            s->cost = both;
            s->bin = k;
        }
    }
}

/* The best plane of all axes, judged by a sample where there are many entries. */
static split find_split(const builder *b, uint32_t first, uint32_t count, const crop *below)
{
    cover bin[3][BINS];
    uint32_t bin_count[3][BINS] = {{0}}, step = count / SAMPLE + 1;
    split s[3], best = {.cost = INFINITY};
    int bins = count < BINS ? (int)count : BINS, axes = 0;
    for (int axis = 0; axis < 3; axis++) {
        float length = below->high[axis] - below->low[axis], scale = (float)bins / length;
        if (!(length > 0.0f) || !isfinite(length) || !isfinite(scale))
            continue;
        for (int k = 0; k < bins; k++)
            bin[axes][k] = no_cover;
        s[axes++] = (split){axis, 0, bins, below->low[axis], scale, INFINITY};
    }
    for (uint32_t k = first; k < first + count; k += step) {
        const tree_entry *e = &b->entry[k];
        cover c = cover_of(e);
        for (int i = 0; i < axes; i++) {
            int at = bin_of(&s[i], e);
            bin_count[i][at]++;
            bin[i][at] = cover_union(bin[i][at], c);
        }
    }
    for (int i = 0; i < axes; i++) {
        find_plane(&s[i], bin[i], bin_count[i], b->floor);
        if (s[i].cost < best.cost)
            best = s[i];
    }
    return best;
}

/* Moves the entries below the split to the front, the others behind them; returns how many are below. No split: half of
 * them. `side`: what they come to. */
static uint32_t divide(const builder *b, uint32_t first, uint32_t count, const split *s, crop *side)
{
    tree_entry *entry = b->entry + first;
    uint32_t below = 0, end = count;
    side[0] = side[1] = no_crop;
    while (below < end) {
        if (s->bin > 0 ? bin_of(s, &entry[below]) < s->bin : below < count / 2) {
            reap(&side[0], &entry[below++]);
            continue;
        }
        reap(&side[1], &entry[below]);
        tree_entry swap = entry[below];
        entry[below] = entry[--end];
        entry[end] = swap;
    }
    return below;
}

static void build_node(const builder *b, uint32_t first, uint32_t count, const crop *c, int depth)
{
    tree *t = b->t;
    uint32_t index = t->node_count++;
    t->node[index] =
        (tree_node){c->all.lo_x, c->all.lo_y, c->all.hi_x, c->all.hi_y, c->all.hi_z, first, count, c->owner};
    if (count <= LEAF_ITEMS)
        return;
    split s = {.bin = 0};
    crop side[2];
    if (depth < BIN_DEPTH)
        s = find_split(b, first, count, c);
    uint32_t below = divide(b, first, count, &s, side);
    bool upper = side[1].all.hi_z > side[0].all.hi_z;
    if (upper)
        build_node(b, first + below, count - below, &side[1], depth + 1);
    else
        build_node(b, first, below, &side[0], depth + 1);
    t->node[index].first = t->node_count;
    t->node[index].count = 0;
    if (upper)
        build_node(b, first, below, &side[0], depth + 1);
    else
        build_node(b, first + below, count - below, &side[1], depth + 1);
}

bool tree_build(tree *t, tree_entry *entry, uint32_t count)
{
    builder b = {t, entry, INFINITY};
    crop all = no_crop;
    *t = (tree){alloc_array(2 * (size_t)count + 1, sizeof *t->node), alloc_array(count, sizeof *t->item), 0};
    if (!t->node || !t->item) {
        tree_free(t);
        return false;
    }
    for (uint32_t i = 0; i < count; i++) {
        b.floor = less(entry[i].lo[2], b.floor);
        reap(&all, &entry[i]);
    }
    if (count)
        build_node(&b, 0, count, &all, 0);
    for (uint32_t i = 0; i < count; i++)
        t->item[i] = entry[i].item;
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

/* ---- walking ---------------------------------------------------------------------------------------------------- */

static const tree_crowd no_crowd = {0, 0, 0, INFINITY, INFINITY, -INFINITY, -INFINITY, INFINITY, -INFINITY};

/* Takes point i, which is on the list already, into the crowd's box. */
static inline void join(tree_crowd *c, const tree_points *p, uint32_t i)
{
    c->lo_x = less(p->x[i], c->lo_x);
    c->lo_y = less(p->y[i], c->lo_y);
    c->lo_z = less(p->z[i], c->lo_z);
    c->hi_x = more(p->x[i], c->hi_x);
    c->hi_y = more(p->y[i], c->hi_y);
    c->hi_z = more(p->z[i], c->hi_z);
}

static void push(tree_walk *w, uint32_t node, const tree_crowd *crowd)
{
    w->stack[w->depth].node = node;
    w->stack[w->depth++].crowd = *crowd;
}

void tree_walk_init(tree_walk *w, const tree *t)
{
    w->t = t;
    w->kept_count = 0;
}

void tree_walk_start(tree_walk *w, const tree_points *points)
{
    tree_crowd all = no_crowd;
    w->points = points;
    w->depth = 0;
    for (uint32_t i = 0; i < points->count; i++) {
        w->list[i] = (unsigned char)i;
        join(&all, points, i);
    }
    all.count = points->count;
    if (w->t->node_count)
        push(w, 0, &all);
    for (uint32_t i = w->kept_count; i-- > 0;)
        push(w, w->kept[i], &all);
}

static inline uint32_t points_under(const tree_points *p, const cover *c, uint32_t owner, const unsigned char *list,
                                    uint32_t count, unsigned char *under)
{
    const float lo_x = c->lo_x, lo_y = c->lo_y, hi_x = c->hi_x, hi_y = c->hi_y, hi_z = c->hi_z;
    uint32_t found = 0;
    for (uint32_t k = 0; k < count; k++) {
        uint32_t i = list[k];
        under[found] = (unsigned char)i;
        float x = less(p->x[i] - lo_x, hi_x - p->x[i]), y = less(p->y[i] - lo_y, hi_y - p->y[i]);
        /* No jumps: none could be foreseen. NaN comes last, so that it is the least. */
        found += (uint32_t)((less(less(x, y), hi_z - p->z[i]) >= 0.0f) & (p->skip[i] != owner));
    }
    return found;
}

uint32_t tree_points_under(const tree_points *p, const tree_entry *e, const unsigned char *list, uint32_t count,
                           unsigned char *under)
{
    cover c = cover_of(e);
    return points_under(p, &c, e->owner, list, count, under);
}

/* Those of the crowd that the node's box is over, and which do not skip it, behind it on the list. */
static tree_crowd find_under(tree_walk *w, const tree_node *n, const tree_crowd *c)
{
    const tree_points *p = w->points;
    const cover box = {n->lo_x, n->lo_y, n->hi_x, n->hi_y, n->hi_z};
    unsigned char *over = w->list + c->start + c->count;
    uint32_t found = points_under(p, &box, n->owner, w->list + c->start, c->count, over);
    tree_crowd under = no_crowd;
    for (uint32_t k = 0; k < found; k++)
        join(&under, p, over[k]);
    under.start = c->start + c->count;
    under.count = found;
    under.dropped = p->dropped;
    return under;
}

static bool is_over_none(const tree_node *n, const tree_crowd *c)
{
    return n->lo_x > c->hi_x || n->hi_x < c->lo_x || n->lo_y > c->hi_y || n->hi_y < c->lo_y || n->hi_z < c->lo_z;
}

static bool is_over_all(const tree_node *n, const tree_crowd *c)
{
    return n->lo_x <= c->lo_x && c->hi_x <= n->hi_x && n->lo_y <= c->lo_y && c->hi_y <= n->hi_y && c->hi_z <= n->hi_z;
}

bool tree_walk_next(tree_walk *w, tree_leaf *leaf)
{
    while (w->depth) {
        uint32_t index = w->stack[--w->depth].node;
        const tree_node *node = &w->t->node[index];
        tree_crowd crowd = w->stack[w->depth].crowd;
        if (is_over_none(node, &crowd))
            continue;
        if (node->count == 0)
            FETCH_AHEAD(&w->t->node[node->first]); /* while points are compared */
        if (crowd.dropped != w->points->dropped || node->owner != ROBERTS_NONE || !is_over_all(node, &crowd))
            crowd = find_under(w, node, &crowd);
        if (crowd.count == 0)
            continue;
        if (node->count) {
            w->leaf = index;
            *leaf = (tree_leaf){w->t->item + node->first, w->list + crowd.start, node->count, crowd.count};
            return true;
        }
        push(w, node->first, &crowd);
        push(w, index + 1, &crowd);
    }
    return false;
}

/* Each time a leaf is of use it changes places with the one before it: those of use most often come to be first. */
void tree_walk_keep(tree_walk *w)
{
    uint32_t i = 0;
    while (i < w->kept_count && w->kept[i] != w->leaf)
        i++;
    if (i < w->kept_count) {
        if (i > 0) {
            w->kept[i] = w->kept[i - 1];
            w->kept[i - 1] = w->leaf;
        }
    } else {
        w->kept_count += w->kept_count < TREE_KEPT;
        w->kept[w->kept_count - 1] = w->leaf;
    }
}
