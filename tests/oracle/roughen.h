/* roughen.h - makes of an exact scene what people have: faces cut into triangles, corners a little off, coordinates of a few
 * digits; and says how far the answer is then determined. */
#ifndef ROBERTS_TESTS_ROUGHEN_H
#define ROBERTS_TESTS_ROUGHEN_H

#include "studio.h"

/* Moves each coordinate of some vertices, or of all, by up to `most`. Faces of more than three corners need triangulate() after
 * that. */
void shake(studio *st, double most);

/* Cuts each face into triangles, anyhow. */
void triangulate(studio *st);

/* Replaces the faces of each solid by those of its convex hull, triangles all: then it is convex to the last bit, whatever
 * shake() did. */
void triangulate_convex(studio *st);

/* Leaves `digits` significant decimal digits of each coordinate. */
void round_to_digits(studio *st, int digits);

/* Sets the scene's slack to what the answer is open by. Call it last.
 *
 * A solid that is not quite convex, or whose faces are not quite planar, may be taken for its convex hull H, or for what lies
 * behind the planes of all its faces, each less the distance t of its corners from the plane that is fitted to them (these
 * count as touching). Let D be how far a vertex lies outside a face's plane, r how far the solid's middle lies behind it, and k the greatest
 * (D + t) / r of all faces. Drawn together about the middle by the factor 1 - k, H lies behind all these planes; and behind those of the
 * outline too, which are weighted means of two faces' planes. So all right answers lie between that of H and that of this smaller solid, whose
 * vertices are nowhere farther from those of H than k times the greatest distance from the middle: this is what the solid's walls may move by.
 *
 * Besides, what lies nearer than 1e-11 of the scene's diameter, or 16 ulp of its largest coordinate, counts as touching: as in near_touching(). */
void leave_open(studio *st);

/* The part of its size by which the roughest solid is not planar and convex: the tolerance that accepts it, or somewhat more. */
double roughness(const studio *st);

/* Looks along a face's plane, from an eye if one is wanted, which then lies in that plane; off it by `off`, as a part of the
 * distance. Coordinates are exact where those of the scene are whole and `off` is 0. */
void look_in_plane(studio *st, double off);

/* A part: 0, or of 1e-9 to 1e-13. */
double small_angle(studio *st);

#endif
