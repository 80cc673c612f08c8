/* shapes.h - seeded random numbers, and convex polyhedra with whole coordinates made of them. */
#ifndef ROBERTS_TESTS_SHAPES_H
#define ROBERTS_TESTS_SHAPES_H

#include <stdbool.h>
#include <stdint.h>

typedef struct dice {
    uint64_t state;
} dice;

uint64_t dice_next(dice *d);
/* A whole number of lo .. hi. */
int dice_int(dice *d, int lo, int hi);
/* A double of -1 .. 1. */
double dice_real(dice *d);

enum { SHAPE_POINTS = 1120, SHAPE_CORNERS = 3400, HULL_POINTS = 64 };

/* Coordinates are below 2^18 in size, so that every determinant of three differences fits 64 bits. */
typedef struct shape {
    int point_count, face_count, corner_count;
    int64_t point[SHAPE_POINTS][3];
    int face_start[SHAPE_CORNERS]; /* [face_count + 1] */
    int corner[SHAPE_CORNERS];
} shape;

/* Adds a point that is not there yet, as long as there is room. */
void shape_point(shape *s, int64_t x, int64_t y, int64_t z);

/* Leaves the convex hull of the shape's points, HULL_POINTS at the most, in the shape; false where they are flat or the hull is
 * too large. */
bool shape_hull(shape *s);

shape shape_box(int x, int y, int z);
/* The hull of `count` random points with coordinates of 0 .. size. Small sizes give many-cornered faces. */
shape shape_random(dice *d, int count, int size);
/* A prism or a pyramid, leaning, over a polygon of up to 16 corners. */
shape shape_prism(dice *d);
/* A prism or a pyramid, leaning, over a polygon of 68 to 144 corners, of which some may be straight. */
shape shape_coin(dice *d);
/* A prism, leaning, over a polygon of about 490 corners, 512 at the most. */
shape shape_large_coin(dice *d);
/* A pyramid over a polygon of 144 to 224 corners: all of its sides meet in the apex. */
shape shape_fan(dice *d);
/* A box whose upper and lower faces have a corner at each whole number of their sides, 68 corners and more. */
shape shape_plate(dice *d);
/* A prism of height 1000 over a regular polygon of radius 1000, its corners rounded to whole numbers. */
shape shape_regular_prism(int sides);
/* Both fill space. The cells of the first are 2 wide and have their centres in the origin and at even coordinates whose sum is
 * a multiple of 4; those of the second in the origin and at coordinates that are all even and alike modulo 4. */
shape shape_rhombic_dodecahedron(void);
shape shape_truncated_octahedron(void);
/* Any of a box, a small prism and a small random hull. */
shape shape_any(dice *d);

#endif
