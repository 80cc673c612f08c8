/* roughen.h - makes of an exact scene what people have: faces cut into triangles, corners a little off, coordinates of
 * a few digits; and says how far the answer is then determined. */
#ifndef ROBERTS_TESTS_ROUGHEN_H
#define ROBERTS_TESTS_ROUGHEN_H

#include "studio.h"

/* Moves each coordinate of some vertices, or of all, by up to `most`. Faces of more than three corners need
 * triangulate() after that. */
void shake(studio *st, double most);

/* Cuts each face into triangles, anyhow. */
void triangulate(studio *st);

/* Replaces the faces of each solid by those of its convex hull, triangles all: then it is convex to the last bit,
 * whatever shake() did. */
void triangulate_convex(studio *st);

/* Leaves `digits` significant decimal digits of each coordinate. */
void round_to_digits(studio *st, int digits);

/* Sets the scene's slack to how far the answer is open. Call it last.
 *
 * Let a solid be not quite convex, or its faces not quite planar. The program may take it for its convex hull H. Or it
 * may take it for what lies behind the planes of all faces, each moved inward by t: the distance t of a face's corners
 * from its fitted plane counts as touching. Every answer between these two is right.
 *
 * Let D be how far a vertex lies outside a face's plane, r how far the solid's middle lies behind that plane, and k the
 * greatest (D + t) / r of all faces. Scale H about the middle by 1 - k: now it lies behind all these planes. It also
 * lies within the outline, whose planes are weighted means of two faces' planes. So the open part lies between H and
 * the scaled H. No vertex moves by more than k times the greatest distance of a vertex from the middle: the walls of
 * the solid may move by that.
 *
 * Besides, as in near_touching(): distances up to 2e-11 of the scene's diameter may count as touching. */
void leave_open(studio *st);

/* The part of its size by which the roughest solid is not planar and convex: the tolerance that accepts it, or
 * somewhat more. */
double roughness(const studio *st);

/* Looks along a face's plane, from an eye if one is wanted, which then lies in that plane; off it by `off`, as a part
 * of the distance. Coordinates are exact where those of the scene are whole and `off` is 0. */
void look_in_plane(studio *st, double off);

/* A part: 0, or of 1e-9 to 1e-13. */
double small_angle(studio *st);

#endif
