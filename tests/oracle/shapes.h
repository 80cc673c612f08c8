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

enum { SHAPE_POINTS = 400, SHAPE_CORNERS = 1280, HULL_POINTS = 64 };

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
/* A pyramid over a polygon of 144 to 224 corners: all of its sides meet in the apex. */
shape shape_fan(dice *d);
/* A box whose upper and lower faces have a corner at each whole number of their sides, 68 corners and more. */
shape shape_plate(dice *d);
/* Any of these but the last three, small. */
shape shape_any(dice *d);

#endif
