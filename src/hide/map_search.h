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

typedef struct map_search {
    planar_map *m;
    uint32_t (*kept)[2];          /* [kept_count] lines that a round has left as they were, in order */
    uint8_t *old;                 /* [line_count] the line is one of them */
    size_t kept_count, old_nodes; /* nodes from number old_nodes on are new */
    double touching;              /* things nearer than this are joined: less in each round */
    double margin;                /* a box holds everything nearer than this: above rounding, the same in each round */
    map_item *item;               /* [count] boxes within boxes; the items of the current box come last */
    map_stop *stop;               /* [stop_count] */
    uint32_t *same;               /* [same_room] the node that each node becomes, or one on the way to it */
    size_t count, room, stop_count, stop_room, same_room;
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
    while (s->same[node] != node) {
        s->same[node] = s->same[s->same[node]];
        node = s->same[node];
    }
    return node;
}

#endif
