/* shapes.h - convex polyhedra with integer coordinates, made from random numbers. */
#ifndef ROBERTS_TESTS_SHAPES_H
#define ROBERTS_TESTS_SHAPES_H

#include <stdbool.h>
#include <stdint.h>

#include "rng.h"

enum { SHAPE_POINTS = 1120, SHAPE_CORNERS = 3400, HULL_POINTS = 64 };

/* Coordinates are below 2^18 in size, so every determinant of three differences fits into 64 bits. */
typedef struct shape {
    int point_count, face_count, corner_count;
    int64_t point[SHAPE_POINTS][3];
    int face_start[SHAPE_CORNERS]; /* [face_count + 1] */
    int corner[SHAPE_CORNERS];
} shape;

/* Adds a point unless it exists already or there is no room. */
void shape_point(shape *s, int64_t x, int64_t y, int64_t z);

/* Replaces the shape by the convex hull of its points, at most HULL_POINTS. False: they are flat or the hull is too
 * large. */
bool shape_hull(shape *s);

shape shape_box(int x, int y, int z);
/* Returns the hull of `count` random points with coordinates from 0 to `size`. Small sizes give faces with many
 * corners. */
shape shape_random(rng *d, int count, int size);
/* Returns an oblique prism or pyramid over a polygon of up to 16 corners. */
shape shape_prism(rng *d);
/* Returns an oblique prism or pyramid over a polygon of 68 to 144 corners, some of which may be straight. */
shape shape_coin(rng *d);
/* Returns an oblique prism over a polygon of about 490 corners, at most 512. */
shape shape_large_coin(rng *d);
/* Returns a pyramid over a polygon of 144 to 224 corners: all its sides meet at the apex. */
shape shape_fan(rng *d);
/* Returns a box whose upper and lower faces have a corner at each integer point of their sides, 68 corners or more. */
shape shape_plate(rng *d);
/* Returns a prism of height 1000 over a regular polygon of radius 1000, with corners rounded to integers. */
shape shape_regular_prism(int sides);
/* Both fill space. The cells of the first are 2 wide, with centres at the origin and at even coordinates whose sum is a
 * multiple of 4. Those of the second are centred at the origin and at coordinates that are all even and congruent
 * modulo 4. */
shape shape_rhombic_dodecahedron(void);
shape shape_truncated_octahedron(void);
/* Returns a box, a small prism or a small random hull. */
shape shape_any(rng *d);

#endif
