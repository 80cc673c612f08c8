/* crossed.h - the faces that a drawing says cross in a line: which of the scene's they are, and whether they do.
 *
 * The check is geometry of its own. The line lies in the planes of both faces; beside it, on either side, a ray along
 * the normal of each face meets that face. Where a face is met on one side only, it must end along an edge that it
 * shares with another face. */
#ifndef ROBERTS_RAY_CROSSED_H
#define ROBERTS_RAY_CROSSED_H

#include "view/seen.h"

/* A piece of a face by the number of that face. */
typedef struct crossed_piece {
    uint32_t number, body, face;
} crossed_piece;

typedef struct crossed {
    const roberts_scene *scene;
    double touching;      /* model units */
    crossed_piece *piece; /* [scene->face_count] by number */
    uint32_t *edge_start; /* [scene->face_count + 1] into `edge` */
    uint32_t *edge;       /* the edges of each piece that have two faces or more */
} crossed;

/* A line's faces: a piece of each in whose plane it lies. */
typedef struct crossed_faces {
    crossed_piece of[2];
    uint32_t edge[2]; /* of the scene: along which the face ends there; ROBERTS_NONE: it goes on */
} crossed_faces;

/* Prepares `c` for a scene. False: no memory. */
bool crossed_begin(crossed *c, const roberts_scene *scene, double touching);
void crossed_end(crossed *c);

/* Finds the faces of a line. False: it does not lie in two faces of these numbers. */
bool crossed_find(const crossed *c, const roberts_crossing *line, crossed_faces *out);

/* Do both faces go on at both sides of the line, somewhere about its middle, or end along an edge there? Sets the
 * edges.
 */
bool crossed_is_line(const crossed *c, const roberts_crossing *line, crossed_faces *faces);

#endif
