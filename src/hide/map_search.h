/* map_search.h - one round of search in a planar map: the nodes that lines must pass through, and the nodes so near to
 * one another that they become one. */
#ifndef ROBERTS_HIDE_MAP_SEARCH_H
#define ROBERTS_HIDE_MAP_SEARCH_H

#include "hide/planar_map.h"

typedef struct map_item map_item;

/* A node that a line must pass through. */
typedef struct map_stop {
    uint32_t line, node;
    double t; /* along the line, times its length */
} map_stop;

/* What becomes of a node. */
typedef struct map_fate {
    uint32_t node; /* the node that it becomes, or one on the way to it; itself: it stays */
    bool open;     /* new, or another node that it has not become is near */
} map_fate;

typedef struct map_search {
    planar_map *m;
    uint8_t *open;    /* [line_count] the line may meet others; two lines that are not open do not: see map_search.c */
    uint8_t *crowded; /* [line_count] a node is near the line, but does not touch it */
    double touching;  /* things nearer than this are joined: less in each round */
    double margin;    /* things nearer than this are near: the same in each round */
    uint8_t *loose;   /* [loose_count] nodes at which one line ended; what is nearer to them than `reach` is joined */
    size_t loose_count;
    double reach;        /* less in each round */
    map_item *item;      /* [count] boxes within boxes; the items of the current box come last */
    map_stop *stop;      /* [stop_count] */
    uint32_t *last_stop; /* [line_count] the node of each line's last stop, or ROBERTS_NONE; during one round */
    map_fate *fate;      /* [fate_room] of each node */
    size_t count, room, stop_count, stop_room, fate_room;
    bool joined, lost; /* lost: no memory */
} map_search;

static inline double map_product(roberts_vec2 a, roberts_vec2 b)
{
    return a.x * b.x + a.y * b.y;
}

static inline roberts_vec2 map_between(roberts_vec2 a, roberts_vec2 b)
{
    return (roberts_vec2){b.x - a.x, b.y - a.y};
}

/* Finds all stops, adds nodes where lines cross, and joins nodes that touch. False: no memory. */
bool map_search_all(map_search *s);

/* The node that a node has become. */
static inline uint32_t map_search_node(map_search *s, uint32_t node)
{
    while (s->fate[node].node != node) {
        s->fate[node].node = s->fate[s->fate[node].node].node;
        node = s->fate[node].node;
    }
    return node;
}

#endif
