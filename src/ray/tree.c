/* tree.c - a tree of boxes. See tree.h. */
#include "ray/tree.h"

#include <float.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/bits.h"
#include "base/lanes.h"
#include "base/sort.h"

enum {
    LEAF_ITEMS = 1, /* two take 6 % more time on most scenes, and 10 % less on needles seen obliquely */
    BINS = 12,      /* one more than the planes tried for each axis; more gained nothing */
    SAMPLE = 1000,  /* most entries that judge a plane; more gained nothing */
    BIN_DEPTH = 60, /* deeper nodes are halved by number, which takes at most 32 more levels */
};

double tree_box_shadow(box3 a, double floor)
{
    double x = a.hi.x - a.lo.x, y = a.hi.y - a.lo.y, z = a.hi.z - floor;
    return x < 0.0 ? 0.0 : x * y * z;
}

/* nextafterf() is a function call and slower. */
static float round_down(double x)
{
    float f = (float)lesser(greater(x, -FLT_MAX), FLT_MAX);
    return f - (fabsf(f) * FLT_EPSILON + FLT_MIN);
}

static float round_up(double x)
{
    return -round_down(-x);
}

tree_entry tree_entry_of(box3 box, uint32_t owner, tree_item item)
{
    return (tree_entry){{round_down(box.lo.x), round_down(box.lo.y), round_down(box.lo.z)},
                        {round_up(box.hi.x), round_up(box.hi.y), round_up(box.hi.z)},
                        owner,
                        item};
}

/* ---- building -------------------------------------------------------------------------------------------------- */

/* A box without a lower bound in z, which does not matter. */
typedef struct open_box {
    float lo_x, lo_y, hi_x, hi_y, hi_z;
} open_box;

static const open_box no_open_box = {INFINITY, INFINITY, -INFINITY, -INFINITY, -INFINITY};

static inline float less(float a, float b)
{
    return a < b ? a : b;
}

static inline float more(float a, float b)
{
    return a > b ? a : b;
}

static inline open_box open_box_union(open_box a, open_box b)
{
    return (open_box){less(a.lo_x, b.lo_x), less(a.lo_y, b.lo_y), more(a.hi_x, b.hi_x), more(a.hi_y, b.hi_y),
                      more(a.hi_z, b.hi_z)};
}

static inline open_box open_box_of(const tree_entry *e)
{
    return (open_box){e->lo[0], e->lo[1], e->hi[0], e->hi[1], e->hi[2]};
}

static float shadow(open_box a, float floor)
{
    return a.hi_x < a.lo_x ? 0.0f : (a.hi_x - a.lo_x) * (a.hi_y - a.lo_y) * (a.hi_z - floor);
}

/* The contents of a node or a leaf. */
typedef struct contents {
    open_box box;
    float low[3], high[3]; /* range of the boxes' centres, doubled */
    uint32_t owner;        /* ROBERTS_NONE: several */
} contents;

typedef struct builder {
    tree *t;
    tree_entry *entry;
    float floor; /* the least z of all boxes */
} builder;

/* A plane perpendicular to an axis, before bin `bin`; 0: no plane. The boxes' centres, doubled, begin at `low`. */
typedef struct split {
    int axis, bin, bins;
    float low, bins_per_length, cost;
} split;

/* Returns twice the centre of a box along an axis; NaN if it is infinite on both sides. */
static inline float entry_middle(const tree_entry *e, int axis)
{
    return e->lo[axis] + e->hi[axis];
}

static const contents no_contents = {{INFINITY, INFINITY, -INFINITY, -INFINITY, -INFINITY},
                                     {INFINITY, INFINITY, INFINITY},
                                     {-INFINITY, -INFINITY, -INFINITY},
                                     0};

static inline void contents_add(contents *c, const tree_entry *e)
{
    c->owner = !(c->box.lo_x <= c->box.hi_x) || c->owner == e->owner ? e->owner : ROBERTS_NONE;
    c->box = open_box_union(c->box, open_box_of(e));
    for (int axis = 0; axis < 3; axis++) {
        c->low[axis] = less(entry_middle(e, axis), c->low[axis]); /* in this order, NaN is ignored */
        c->high[axis] = more(entry_middle(e, axis), c->high[axis]);
    }
}

static inline int bin_of(const split *s, const tree_entry *e)
{
    float bin = (entry_middle(e, s->axis) - s->low) * s->bins_per_length;
    return bin < (float)s->bins ? (int)bin : s->bins - 1; /* the last one for NaN too */
}

/* Finds the cheapest plane perpendicular to an axis. */
static void find_plane(split *s, const open_box *bin, const uint32_t *bin_count, float floor)
{
    open_box side = no_open_box;
    uint32_t below = 0, above = 0;
    float cost[BINS];
    for (int k = 0; k < s->bins - 1; k++) { /* boxes in bins 0 .. k ... */
        side = open_box_union(side, bin[k]);
        below += bin_count[k];
        cost[k + 1] = below ? (float)below * shadow(side, floor) : INFINITY;
    }
    side = no_open_box;
    for (int k = s->bins - 1; k > 0; k--) { /* ... against those in bins k .. */
        side = open_box_union(side, bin[k]);
        above += bin_count[k];
        float both = cost[k] + (float)above * shadow(side, floor);
        if (above > 0 && both < s->cost) {
            s->cost = both;
            s->bin = k;
        }
    }
}

/* Finds the best plane of any axis. If there are many entries, a sample of them decides. */
static split find_split(const builder *b, uint32_t first, uint32_t count, const contents *held)
{
    open_box bin[3][BINS];
    uint32_t bin_count[3][BINS] = {{0}}, step = count / SAMPLE + 1;
    split s[3], best = {.cost = INFINITY};
    int bins = count < BINS ? (int)count : BINS, axes = 0;
    for (int axis = 0; axis < 3; axis++) {
        float length = held->high[axis] - held->low[axis], scale = (float)bins / length;
        if (!(length > 0.0f) || !isfinite(length) || !isfinite(scale))
            continue;
        for (int k = 0; k < bins; k++)
            bin[axes][k] = no_open_box;
        s[axes++] = (split){axis, 0, bins, held->low[axis], scale, INFINITY};
    }
    for (uint32_t k = first; k < first + count; k += step) {
        const tree_entry *e = &b->entry[k];
        open_box c = open_box_of(e);
        for (int i = 0; i < axes; i++) {
            int at = bin_of(&s[i], e);
            bin_count[i][at]++;
            bin[i][at] = open_box_union(bin[i][at], c);
        }
    }
    for (int i = 0; i < axes; i++) {
        find_plane(&s[i], bin[i], bin_count[i], b->floor);
        if (s[i].cost < best.cost)
            best = s[i];
    }
    return best;
}

/* Moves the entries below the split to the front, the others behind them, and returns how many are below; without a
 * split, half of them. `side`: the contents of the two parts. */
static uint32_t divide_node(const builder *b, uint32_t first, uint32_t count, const split *s, contents *side)
{
    tree_entry *entry = b->entry + first;
    uint32_t below = 0, end = count;
    side[0] = side[1] = no_contents;
    while (below < end) {
        if (s->bin > 0 ? bin_of(s, &entry[below]) < s->bin : below < count / 2) {
            contents_add(&side[0], &entry[below++]);
            continue;
        }
        contents_add(&side[1], &entry[below]);
        tree_entry swap = entry[below];
        entry[below] = entry[--end];
        entry[end] = swap;
    }
    return below;
}

/* Entries that become one child. */
typedef struct part {
    uint32_t first, count;
    int depth;
    contents held;
} part;

/* Divides `p`: the lower part stays in `p`, the other goes to `rest`. */
static void divide_part(const builder *b, part *p, part *rest)
{
    split s = {.bin = 0};
    contents side[2];
    if (p->depth < BIN_DEPTH)
        s = find_split(b, p->first, p->count, &p->held);
    uint32_t below = divide_node(b, p->first, p->count, &s, side);
    *rest = (part){p->first + below, p->count - below, p->depth + 1, side[1]};
    *p = (part){p->first, below, p->depth + 1, side[0]};
}

/* Returns the part that rays meet most often, among those too large for a leaf; `parts` if there is none. */
static int largest(const builder *b, const part *p, int parts)
{
    int best = parts;
    float most = -INFINITY;
    for (int i = 0; i < parts; i++) {
        float s = shadow(p[i].held.box, b->floor);
        if (p[i].count > LEAF_ITEMS && (best == parts || s > most)) {
            best = i;
            most = s;
        }
    }
    return best;
}

static void nearest_first(part *p, int parts)
{
    SORT_FEW(part, p, parts, a->held.box.hi_z < b->held.box.hi_z)
}

static void set_child(tree_node *node, int i, const open_box *c, uint32_t owner, uint32_t first, uint32_t count)
{
    node->lo_x[i] = c->lo_x;
    node->hi_x[i] = c->hi_x;
    node->lo_y[i] = c->lo_y;
    node->hi_y[i] = c->hi_y;
    node->hi_z[i] = c->hi_z;
    node->owner[i] = owner;
    node->first[i] = first;
    node->count[i] = count;
}

/* Builds the node over `all` and returns its number. */
static uint32_t build_node(const builder *b, const part *all)
{
    part p[TREE_WIDTH] = {*all};
    int parts = 1;
    for (int i; parts < TREE_WIDTH && (i = largest(b, p, parts)) < parts; parts++)
        divide_part(b, &p[i], &p[parts]);
    nearest_first(p, parts);
    uint32_t index = b->t->node_count++;
    for (int i = 0; i < TREE_WIDTH; i++) {
        if (i >= parts) {
            set_child(&b->t->node[index], i, &no_open_box, 0, 0, 1);
            continue;
        }
        bool leaf = p[i].count <= LEAF_ITEMS;
        uint32_t first = leaf ? p[i].first : build_node(b, &p[i]);
        set_child(&b->t->node[index], i, &p[i].held.box, p[i].held.owner, first, leaf ? p[i].count : 0);
    }
    return index;
}

bool tree_build(tree *t, tree_entry *entry, uint32_t count)
{
    builder b = {t, entry, INFINITY};
    part all = {0, count, 0, no_contents};
    /* A node over four items or more has four parts, so n > 1 items take at most (2 n - 1) / 3 nodes. */
    size_t nodes = 2 * (size_t)count / 3 + 1;
    *t = (tree){alloc_array(nodes, sizeof *t->node), alloc_array(count, sizeof *t->item), 0};
    if (!t->node || !t->item) {
        tree_free(t);
        return false;
    }
    for (uint32_t i = 0; i < count; i++) {
        b.floor = less(entry[i].lo[2], b.floor);
        contents_add(&all.held, &entry[i]);
    }
    if (count)
        build_node(&b, &all);
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

/* ---- walking --------------------------------------------------------------------------------------------------- */

void tree_walk_init(tree_walk *w, const tree *t)
{
    w->t = t;
    w->kept_count = 0;
}

void tree_walk_start(tree_walk *w, const tree_points *points)
{
    w->points = points;
    w->depth = 0;
    w->root_done = false;
    w->first_count = w->kept_count;
    for (uint32_t i = 0; i < w->kept_count; i++)
        w->first[i] = w->kept[w->kept_count - 1 - i];
    w->lo_x = w->lo_y = w->lo_z = INFINITY;
    w->hi_x = w->hi_y = -INFINITY;
    for (uint32_t i = 0; i < points->count; i++) {
        w->lo_x = less(points->x[i], w->lo_x);
        w->lo_y = less(points->y[i], w->lo_y);
        w->lo_z = less(points->z[i], w->lo_z);
        w->hi_x = more(points->x[i], w->hi_x);
        w->hi_y = more(points->y[i], w->hi_y);
    }
}

/* The groups of four points that contain at least one point of a set, each given by its first point. Usually whole
 * groups walk together. */
typedef struct fours {
    uint32_t count;
    unsigned char first[TREE_POINTS / 4];
} fours;

static void find_fours(fours *f, const tree_set *of)
{
    f->count = 0;
    for (uint32_t k = 0; k < TREE_POINTS / 64; k++)
        for (uint64_t bits = of->word[k]; bits;) {
            uint32_t i = (uint32_t)bits_trailing_zeros(bits) & ~3u;
            f->first[f->count++] = (unsigned char)(64 * k + i);
            bits &= ~((uint64_t)15 << i);
        }
}

/* Returns the points of `of` that lie under the box and do not skip its owner; `f` has the groups of `of`. */
static inline tree_set set_under(const tree_points *p, const open_box *c, uint32_t owner, const fours *f,
                                 const tree_set *of)
{
    const four lo_x = four_all(c->lo_x), hi_x = four_all(c->hi_x), lo_y = four_all(c->lo_y), hi_y = four_all(c->hi_y);
    const four hi_z = four_all(c->hi_z);
    tree_set under = {{0}};
    for (uint32_t k = 0; k < f->count; k++) {
        uint32_t i = f->first[k];
        four x = four_load(p->x + i), y = four_load(p->y + i);
        four beside = four_either(four_either(four_below(x, lo_x), four_below(hi_x, x)),
                                  four_either(four_below(y, lo_y), four_below(hi_y, y)));
        four behind = four_either(four_below(hi_z, four_load(p->z + i)), four_same(p->skip + i, owner));
        under.word[i / 64] |= (uint64_t)(15u ^ four_signs(four_either(beside, behind))) << i % 64;
    }
    for (uint32_t k = 0; k < TREE_POINTS / 64; k++)
        under.word[k] &= of->word[k];
    return under;
}

tree_set tree_points_under(const tree_points *p, const tree_entry *e, const tree_set *of)
{
    open_box c = open_box_of(e);
    fours f;
    find_fours(&f, of);
    return set_under(p, &c, e->owner, &f, of);
}

static inline open_box child_box(const tree_node *n, uint32_t i)
{
    return (open_box){n->lo_x[i], n->lo_y[i], n->hi_x[i], n->hi_y[i], n->hi_z[i]};
}

/* Finds the children that may be over one of the points: bit i for child i. */
static inline unsigned met_children(const tree_walk *w, const tree_node *n)
{
    four x = four_either(four_below(four_all(w->hi_x), four_load(n->lo_x)),
                         four_below(four_load(n->hi_x), four_all(w->lo_x)));
    four y = four_either(four_below(four_all(w->hi_y), four_load(n->lo_y)),
                         four_below(four_load(n->hi_y), four_all(w->lo_y)));
    four z = four_below(four_load(n->hi_z), four_all(w->lo_z));
    return 15u ^ four_signs(four_either(four_either(x, y), z));
}

/* Pushes the children of a node onto the stack, the first on top, each with the points under its box. */
static void spread(tree_walk *w, uint32_t index, const tree_set *points)
{
    const tree_node *n = &w->t->node[index];
    unsigned met = met_children(w, n);
    fours f;
    for (uint32_t i = 0; i < TREE_WIDTH; i++)
        if (n->count[i] == 0 && met >> i & 1)
            FETCH_ARRAY(&w->t->node[n->first[i]], sizeof *n); /* fetched while points are compared */
    find_fours(&f, points);
    for (uint32_t i = TREE_WIDTH; i-- > 0;) {
        if (!(met >> i & 1))
            continue;
        open_box box = child_box(n, i);
        tree_visit *top = &w->stack[w->depth];
        *top = (tree_visit){TREE_WIDTH * index + i, set_under(w->points, &box, n->owner[i], &f, points)};
        w->depth += !tree_set_is_empty(&top->points);
    }
}

static void find_leaf(tree_walk *w, const tree_visit *visit, tree_leaf *leaf)
{
    const tree_node *n = &w->t->node[visit->child / TREE_WIDTH];
    uint32_t i = visit->child % TREE_WIDTH;
    w->leaf = visit->child;
    *leaf = (tree_leaf){w->t->item + n->first[i], n->count[i], visit->points};
}

/* Finds the next of the kept leaves. */
static bool next_kept(tree_walk *w, tree_leaf *leaf)
{
    fours f;
    if (w->first_count == 0)
        return false;
    find_fours(&f, &w->points->live);
    while (w->first_count) {
        uint32_t child = w->first[--w->first_count], i = child % TREE_WIDTH;
        const tree_node *n = &w->t->node[child / TREE_WIDTH];
        open_box box = child_box(n, i);
        tree_visit visit = {child, set_under(w->points, &box, n->owner[i], &f, &w->points->live)};
        if (!tree_set_is_empty(&visit.points)) {
            find_leaf(w, &visit, leaf);
            return true;
        }
    }
    return false;
}

bool tree_walk_next(tree_walk *w, tree_leaf *leaf)
{
    if (next_kept(w, leaf))
        return true;
    if (!w->root_done && w->t->node_count)
        spread(w, 0, &w->points->live);
    w->root_done = true;
    while (w->depth) {
        tree_visit visit = w->stack[--w->depth];
        const tree_node *n = &w->t->node[visit.child / TREE_WIDTH];
        uint32_t i = visit.child % TREE_WIDTH;
        for (uint32_t k = 0; k < TREE_POINTS / 64; k++)
            visit.points.word[k] &= w->points->live.word[k];
        if (tree_set_is_empty(&visit.points))
            continue;
        if (n->count[i]) {
            find_leaf(w, &visit, leaf);
            return true;
        }
        spread(w, n->first[i], &visit.points);
    }
    return false;
}

/* A kept leaf moves up by one place whenever it is useful, so the most useful leaves come first. */
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

/* ---- searching along a segment --------------------------------------------------------------------------------- */

/* May the box be over a point of the segment? It is not if an axis of the picture or a line along the segment separates
 * them. Infinite boxes give NaN, which separates nothing. */
static inline bool is_over_segment(const tree_search *s, const tree_node *n, uint32_t i)
{
    double lo_x = n->lo_x[i], hi_x = n->hi_x[i], lo_y = n->lo_y[i], hi_y = n->hi_y[i];
    double x = s->middle.x - 0.5 * (lo_x + hi_x), y = s->middle.y - 0.5 * (lo_y + hi_y);
    double wide = 0.5 * (hi_x - lo_x), high = 0.5 * (hi_y - lo_y);
    double dx = fabs(s->half.x), dy = fabs(s->half.y);
    bool apart = n->hi_z[i] < s->low_z || fabs(x) > wide + dx || fabs(y) > high + dy;
    return !apart && !(fabs(s->half.x * y - s->half.y * x) > wide * dy + high * dx);
}

static void search_children(tree_search *s, uint32_t index)
{
    const tree_node *n = &s->t->node[index];
    for (uint32_t i = TREE_WIDTH; i-- > 0;)
        if (n->owner[i] != s->skip && is_over_segment(s, n, i))
            s->stack[s->depth++] = TREE_WIDTH * index + i;
}

void tree_search_start(tree_search *s, const tree *t, roberts_vec3 a, roberts_vec3 b, uint32_t skip)
{
    s->t = t;
    s->middle = (roberts_vec2){0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
    s->half = (roberts_vec2){0.5 * (b.x - a.x), 0.5 * (b.y - a.y)};
    s->low_z = lesser(a.z, b.z);
    s->skip = skip;
    s->depth = 0;
    if (t->node_count)
        search_children(s, 0);
}

bool tree_search_next(tree_search *s, tree_leaf *leaf)
{
    while (s->depth) {
        uint32_t child = s->stack[--s->depth], i = child % TREE_WIDTH;
        const tree_node *n = &s->t->node[child / TREE_WIDTH];
        if (n->count[i]) {
            leaf->item = s->t->item + n->first[i];
            leaf->item_count = n->count[i];
            return true;
        }
        search_children(s, n->first[i]);
    }
    return false;
}
