/* crossed.h - the faces that a drawing says cross in a line: which of the scene's they are, and whether they do.
 *
 * The check is geometry of its own. The line lies in the planes of both faces; beside it, on either side, a ray along
 * the normal of each face meets that face. */
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
} crossed;

/* A line's faces: a piece of each in whose plane it lies. */
typedef struct crossed_faces {
    crossed_piece of[2];
} crossed_faces;

/* Prepares `c` for a scene. False: no memory. */
bool crossed_begin(crossed *c, const roberts_scene *scene, double touching);
void crossed_end(crossed *c);

/* Finds the faces of a line. False: it does not lie in two faces of these numbers. */
bool crossed_find(const crossed *c, const roberts_crossing *line, crossed_faces *out);

/* Do both faces go on at both sides of the line, somewhere about its middle? */
bool crossed_is_line(const crossed *c, const roberts_crossing *line, const crossed_faces *faces);

#endif
