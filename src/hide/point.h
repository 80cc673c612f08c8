/* point.h - what lies at a point of the picture: the solid or the face seen there, and how many layers lie in front of
 * a hidden point. */
#ifndef ROBERTS_HIDE_POINT_H
#define ROBERTS_HIDE_POINT_H

#include "hide/objet.h"

/* Returns the solid seen at point X of the picture. If several touch there, the smallest number counts. ROBERTS_NONE:
 * no front face is there. */
uint32_t point_solid(const hide_fronts *fronts, const objet *grid, roberts_vec2 X);

/* The face seen there, as numbered in the scene: of the solid of smallest number that touches there, the smallest one;
 * *F: its plane. ROBERTS_NONE: there is none. */
uint32_t point_face(const hide_fronts *fronts, const objet *grid, roberts_vec2 X, plane *F);

/* A face in front of a point. */
typedef struct level_hit {
    uint32_t body;
    unsigned ways; /* bits of the directions in which the point can be moved into the face */
} level_hit;

/* Scratch memory; the caller frees `item`. */
typedef struct level_hits {
    level_hit *item;
    size_t count, room;
} level_hits;

/* Counts the layers in front of X, a hidden point of the line; at least 1. A convex or closed body counts once each
 * time the line of sight enters it; an open body counts once for each face that the line of sight meets. Requires a
 * grid that lists every front or the first of its copies, as it does when hidden lines are wanted. False: no memory. */
bool point_level(const hide_fronts *fronts, const objet *grid, const seen_line *line, roberts_vec3 X, level_hits *hits,
                 uint32_t *level);

#endif
