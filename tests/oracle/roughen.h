/* roughen.h - turns an exact scene into a realistic one: faces cut into triangles, corners slightly off, coordinates of
 * few digits. Also states how far the answer is then determined. */
#ifndef ROBERTS_TESTS_ROUGHEN_H
#define ROBERTS_TESTS_ROUGHEN_H

#include "studio.h"

/* Moves each coordinate of some vertices, or of all, by up to `most`. Faces of more than three corners need
 * triangulate() after that. */
void shake(studio *st, double most);

/* Cuts each face into triangles in an arbitrary way. */
void triangulate(studio *st);

/* Replaces the faces of each solid by those of its convex hull, all triangles. Then the solid is convex to the last
 * bit, whatever shake() did. */
void triangulate_convex(studio *st);

/* Rounds each coordinate to `digits` significant decimal digits. */
void round_to_digits(studio *st, int digits);

/* Sets the scene's slack to the uncertainty of the answer. Call it last.
 *
 * Let a solid be not quite convex, or its faces not quite planar. The program may treat it as its convex hull H. Or it
 * may treat it as the volume behind the planes of all faces, each moved inward by t, since the distance t of a face's
 * corners from its fitted plane counts as touching. Every answer between these two is right.
 *
 * Let D be how far a vertex lies outside a face's plane, r how far the solid's middle lies behind that plane, and k the
 * greatest (D + t) / r of all faces. Scale H about the middle by 1 - k: now it lies behind all these planes. It also
 * lies within the outline, whose planes are weighted means of two faces' planes. So the correct answer is between those
 * for H and for the scaled H. No vertex moves by more than k times the greatest distance of a vertex from the middle,
 * so the solid's walls may move by that.
 *
 * In addition, as in near_touching(), distances up to 2e-11 of the scene's diameter may count as touching. */
void leave_open(studio *st);

/* Returns how far the roughest solid is from planar and convex, as a fraction of its size: a tolerance that accepts it,
 * perhaps slightly too large. */
double roughness(const studio *st);

/* Looks along a face's plane, or off it by `off`, a fraction of the distance. In perspective, the eye lies in that
 * plane. Coordinates are exact if those of the scene are integers and `off` is 0. */
void look_in_plane(studio *st, double off);

/* Returns a fraction: 0, or 1e-9 to 1e-13. */
double small_angle(studio *st);

#endif
