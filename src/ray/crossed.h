/* crossed.h - the faces that cross in a line, according to a drawing: which faces of the scene they are, and whether
 * they cross.
 *
 * This check has its own geometry. The line must lie in the planes of both faces. Beside it, on both sides, a ray along
 * the normal of each face must meet that face. A face that is met on one side only must end along an edge that it
 * shares with another face. */
#ifndef ROBERTS_RAY_CROSSED_H
#define ROBERTS_RAY_CROSSED_H

#include "view/seen.h"

/* A piece of a face, and the number of that face. */
typedef struct crossed_piece {
    uint32_t number, body, face;
} crossed_piece;

typedef struct crossed {
    const roberts_scene *scene;
    double touching;      /* model units */
    crossed_piece *piece; /* [scene->face_count] sorted by number */
    uint32_t *edge_start; /* [scene->face_count + 1] into `edge` */
    uint32_t *edge;       /* the edges of each piece that have two faces or more */
} crossed;

/* The faces of a line: for each, a piece in whose plane the line lies. */
typedef struct crossed_faces {
    crossed_piece of[2];
    uint32_t edge[2]; /* of the scene: along which the face ends there; ROBERTS_NONE: it goes on */
} crossed_faces;

/* Prepares `c` for a scene. False: no memory. */
bool crossed_begin(crossed *c, const roberts_scene *scene, double touching);
void crossed_end(crossed *c);

/* Finds two faces with the numbers of the line that cross in it: near its middle, both go on at both sides of it, or
 * end there along an edge. (All faces of hulls have one number.) False: there are none. */
bool crossed_find(const crossed *c, const roberts_crossing *line, crossed_faces *out);

#endif
