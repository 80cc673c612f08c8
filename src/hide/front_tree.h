/* front_tree.h - a tree over the fronts of a cell, for cells that list very many.
 *
 * Each node has up to four children: nodes, or fronts. A child is bounded by half-spaces: the box of its fronts; two
 * strips of the picture, along the longest sides of their outlines; and a plane in front of them, parallel to the
 * largest of their faces. So the tree separates oblique thin solids, and piles of sheets seen nearly edge-on, as well
 * as cubes. A line is clipped to the half-spaces. The fronts neither hide nor touch the rest of the line. To find
 * fronts that touch one another, there is a box along the axes of the model, too.
 *
 * Fronts are divided at the median of their middles, along the axis of their greatest spread; if that is the depth, at
 * the median of their depths or of their turns in the picture. */
#ifndef ROBERTS_HIDE_FRONT_TREE_H
#define ROBERTS_HIDE_FRONT_TREE_H

#include <string.h>

#include "base/bits.h"
#include "base/lanes.h"
#include "hide/fronts.h"

/* Fronts with more corners or faces than this are bounded by their boxes alone. */
#define FRONT_TREE_CORNERS 96

/* The most pending children in a search in depth. */
#define FRONT_TREE_WAITING 64

/* Of a child: this bit says that it is a single front; without it, the child is a node. */
#define FRONT_TREE_LEAF 0x80000000u

/* Bounds of the children, one lane each. Unused children have no points. */
typedef struct front_node {
    float x0[4], x1[4], y0[4], y1[4], z0[4], z1[4];
    struct {
        float x[4], y[4], low[4], high[4]; /* low <= x X.x + y X.y <= high */
    } strip[2];
    struct {
        float x[4], y[4], z[4], low[4], high[4]; /* low <= x X.x + y X.y + z X.z <= high */
    } plane;
    struct {
        float low[4], high[4]; /* along an axis of the model, model units */
    } model[3];
    uint32_t last[4];  /* the last place in the list below the child */
    uint32_t child[4]; /* a node, or the place of a front in the list and FRONT_TREE_LEAF */
} front_node;

typedef struct front_tree {
    front_node *node; /* the root first; NULL: there is no tree */
    uint32_t count;
} front_tree;

/* Builds the tree over a list of at least one front. False: no memory. */
bool front_tree_build(front_tree *tree, const hide_fronts *fronts, const uint32_t *front, uint32_t count);
void front_tree_free(front_tree *tree);

/* A line for the tree: AB, and margins that cover the rounding of floats. */
typedef struct front_line {
    four Ax, Ay, Az, dx, dy, dz; /* d: B - A */
    four per_dx, per_dy;         /* 1 / dx, 1 / dy */
    four margin, margin_z, margin_plane;
} front_line;

front_line front_line_of(roberts_vec3 A, roberts_vec3 B, double margin);

/* What a line may meet in a tree: a child, and the part of the line that it may hide or touch. */
typedef struct front_visit {
    uint32_t child;
    float t0, t1;
    float z1; /* the nearest depth of the child */
} front_visit;

/* Finds the children of a node that may hide or touch anything of the part t0 .. t1 of the line, and which part.
 * Returns their number. The longest part comes last. Of equal parts, the last is that of the child farther from the
 * viewer, which is mostly the nearest one in front of the line. */
uint32_t front_node_meets(const front_node *n, const front_line *line, float t0, float t1, front_visit found[4]);

/* Children that a line has still to visit, in lists by the length of the part that each may hide: at least an eighth
 * of the line, at least a sixteenth of that, and so on. The first list that is not empty gives the next child: the one
 * that it got last. So what hides much is met early, and children of like size are searched in depth. */
#define FRONT_QUEUE 64
#define FRONT_QUEUE_LISTS 8

typedef struct front_queue {
    front_visit visit[FRONT_QUEUE];
    uint8_t next[FRONT_QUEUE];        /* of each visit, the next one of its list, or itself: it is the last */
    uint8_t first[FRONT_QUEUE_LISTS]; /* of each list that is not empty */
    uint8_t unused[FRONT_QUEUE];      /* [FRONT_QUEUE - count] places without a visit */
    uint32_t lists;                   /* bit k: list k is not empty */
    uint32_t count;
} front_queue;

static inline void front_queue_begin(front_queue *q)
{
    q->lists = q->count = 0;
    for (uint32_t i = 0; i < FRONT_QUEUE; i++)
        q->unused[i] = (uint8_t)i;
}

/* The list of a visit. */
static inline uint32_t front_queue_list(const front_visit *v)
{
    const float length = v->t1 - v->t0;
    uint32_t bits;
    memcpy(&bits, &length, sizeof bits);
    const uint32_t list = (127 - (bits >> 23)) / 4; /* the exponent of 1 is 127 */
    return length >= 1.0f ? 0 : list < FRONT_QUEUE_LISTS ? list : FRONT_QUEUE_LISTS - 1;
}

/* There must be room. */
static inline void front_queue_add(front_queue *q, const front_visit *v)
{
    const uint32_t list = front_queue_list(v), at = q->unused[FRONT_QUEUE - ++q->count];
    q->visit[at] = *v;
    q->next[at] = q->lists >> list & 1 ? q->first[list] : (uint8_t)at;
    q->first[list] = (uint8_t)at;
    q->lists |= 1u << list;
}

static inline front_visit front_queue_take(front_queue *q, uint32_t list)
{
    const uint32_t at = q->first[list];
    if (q->next[at] == at)
        q->lists &= ~(1u << list);
    q->first[list] = q->next[at];
    q->unused[FRONT_QUEUE - q->count--] = (uint8_t)at;
    return q->visit[at];
}

/* Adds the children that front_node_meets() has found, and takes the next one. False: there is none. */
static inline bool front_queue_next(front_queue *q, const front_visit *found, uint32_t count, front_visit *next)
{
    for (uint32_t i = 0; i + 1 < count; i++)
        front_queue_add(q, &found[i]);
    const uint32_t list = q->lists ? (uint32_t)bits_trailing_zeros(q->lists) : FRONT_QUEUE_LISTS;
    if (count > 0 && front_queue_list(&found[count - 1]) <= list) {
        *next = found[count - 1];
        return true;
    }
    if (list == FRONT_QUEUE_LISTS)
        return false;
    *next = front_queue_take(q, list);
    if (count > 0)
        front_queue_add(q, &found[count - 1]);
    return true;
}

/* Finds the children of a node that may hide or hold anything in a box, which the caller has widened by its margin:
 * their numbers, the farthest child from the viewer last. Returns how many they are. */
uint32_t front_node_meets_box(const front_node *n, const hide_box *box, uint32_t found[4]);

/* A front for the tree. */
typedef struct front_shape {
    const hide_box *box;
    uint32_t count; /* of the corners of its faces, or of its box */
    float x[FRONT_TREE_CORNERS], y[FRONT_TREE_CORNERS], z[FRONT_TREE_CORNERS];
    float margin, margin_plane;
    float low[3], high[3]; /* along the axes of the model, as in a node */
} front_shape;

void front_shape_of(front_shape *shape, const hide_fronts *fronts, uint32_t front);

/* Which children may have a point in common with the front, and come after `place` in the list? Bit i is child i. */
unsigned front_node_touches(const front_node *n, const front_shape *shape, uint32_t place);

#endif
