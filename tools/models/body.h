/* body.h - a model under construction: vertices and faces of one or several solids.
 *
 * Invariants: faces run counter-clockwise seen from outside; corners are vertex numbers below vertex_count; solids
 * share no vertex. A zeroed body is empty. Running out of memory ends the program, since a generator has nothing to
 * save. */
#ifndef MODELS_BODY_H
#define MODELS_BODY_H

#include <stddef.h>
#include <stdint.h>

#include "base/vec.h"

typedef struct body {
    size_t vertex_count, face_count, corner_count;
    roberts_vec3 *vertex;
    uint32_t *face_end; /* face f has the corners corner[face_end[f - 1]] .. corner[face_end[f] - 1] */
    uint32_t *corner;
    uint32_t *color; /* for each face 0xrrggbb; NULL: no colours */
    size_t vertex_room, face_room, corner_room;
} body;

/* x -> m x + shift, where m is a rotation times a scale. */
typedef struct motion {
    double m[3][3];
    roberts_vec3 shift;
} motion;

/* Adds a vertex; returns its number. A negative zero becomes zero. */
uint32_t body_vertex(body *b, double x, double y, double z);

/* Adds a face with the given vertices. */
void body_face(body *b, const uint32_t *corner, size_t count);

/* Adds a face corner by corner. */
void body_corner(body *b, uint32_t vertex);
void body_end_face(body *b);

/* Returns the index in corner[] of the first corner of face f; for f = face_count, the end of the last face. */
size_t body_face_start(const body *b, size_t f);

/* Returns twice the vector area of face f, which points outward. */
roberts_vec3 body_face_normal(const body *b, size_t f);

/* Gives each face its colour. The table has room for them all. */
void body_color(body *b, const uint32_t *color);

/* Adds a moved copy of `part`, without its colours. */
void body_add(body *b, const body *part, motion move);

/* Empties a body, but keeps its memory; releases it. */
void body_clear(body *b);
void body_free(body *b);

/* ---- simple solids, each with its top face first ------------------------------------------------------------- */

/* Adds the box between two corners, lo < hi. */
void body_box(body *b, roberts_vec3 lo, roberts_vec3 hi);

/* Adds the solid below four points, counter-clockwise from above, down to the height `bottom`. */
void body_plate(body *b, double bottom, const roberts_vec3 top[4]);

/* Adds a box between two corners, turned about the vertical through its middle by the angle of the vector (c, s), where
 * c^2 + s^2 = 1. */
void body_turned_box(body *b, roberts_vec3 lo, roberts_vec3 hi, double c, double s);

/* Adds the pyramid over the rectangle lo.x..hi.x, lo.y..hi.y at height lo.z, with its apex above the middle at hi.z. */
void body_pyramid(body *b, roberts_vec3 lo, roberts_vec3 hi);

/* Adds the tetrahedron with these corners, in any order. */
void body_tetrahedron(body *b, roberts_vec3 p0, roberts_vec3 p1, roberts_vec3 p2, roberts_vec3 p3);

static inline roberts_vec3 vec3(double x, double y, double z)
{
    return (roberts_vec3){x, y, z};
}

#endif
