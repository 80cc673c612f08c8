/* tolerance.h - every tolerance and bound of hidden-line removal: name, value, unit, reason.
 *
 * Three lengths come from the view, in view units, since they depend on the scene (see map.c): `epsilon`, nearer than
 * which things touch; `rounding`, a bound of the error of one view coordinate; `across_rounding`, the same of an x or
 * y. A hide_space holds them as `epsilon`, `depth_rounding` and `rounding`. The numbers below are multiples of these,
 * or have no unit. Numbers that change time and memory alone stand in the files that use them. */
#ifndef ROBERTS_HIDE_TOLERANCE_H
#define ROBERTS_HIDE_TOLERANCE_H

#include "hide/types.h"

/* ---- signs and parameters ---- */

/* No unit: wanted accuracy of a parameter t along an edge. Drawings are checked to 1e-9. A crossing whose rounding
 * could exceed this is computed again in twice the precision. */
#define HIDE_T_ACCURACY 1e-10

/* Part of epsilon: the error that a distance may have for its sign to be trusted. */
#define HIDE_TRUSTED 0.125

/* Part of the scene's diameter: the largest touching distance that is accepted. Beyond it "on" would mean a visible
 * length. */
#define EPSILON_MOST 0.01

/* Epsilons along the edge: a hidden part that reaches no farther than this beyond its end is taken as it is. Cells and
 * boxes are widened by as much. */
#define REACH_PLAIN 4.0

/* Roundings of a picture coordinate, times a length: the cross product of two sides of an outline is off by less. */
#define TURN_ROUNDINGS 8.0

/* Part of epsilon: an outline may turn inward at a corner if the lines of both sides cut off no more than this. */
#define INWARD_TURN 0.5

/* Is a parameter with this error good enough, along the edge and as a length? */
static inline bool hide_accurate(const hide_space *space, const hide_edge *e, double error)
{
    return error <= HIDE_T_ACCURACY && error * e->length3 <= HIDE_TRUSTED * space->epsilon;
}

/* View units squared: a cross product of two vectors of the picture that is larger than this has a plain sign.
 *
 * |u x v| is the distance of one point from the line through two others, times their distance l. It is more than
 * epsilon, with certainty, where |u x v| > epsilon l + 2 rounding (l + reach), and l is no more than 3 and the reach no
 * more than 6 extents (of the picture: x and y), and the products' own rounding adds no more than 4 extents times
 * rounding. There is one bound for the whole scene. Where it does not decide, the sign is computed with its error. */
static inline double hide_plain(double extent, double epsilon, double rounding)
{
    return 4.0 * extent * (epsilon + 8.0 * rounding);
}

/* View units: cells and boxes are widened by this, so that an edge and a face that touch are never kept apart. */
static inline double hide_margin(const hide_space *space)
{
    return 4.0 * (space->epsilon + space->depth_rounding);
}

/* No unit: bound of the error of the parameter t at which AB crosses the line through P along `side`, which goes from
 * corner to corner. `apart`: |a - b| for the signed distances a, b of A and B from that line, times the side's
 * length.
 *
 * This bound is sharper than the errors of a and b where the crossing lies near a short side, or far from the ends of
 * AB. With a and b off by da and db, t is off by ((1 - t) da + t db) / (a - b). That is the error that the distance
 * of the crossing X itself would have. Moved by `rounding` in each coordinate, P, Q and X change the cross product by
 * no more than 2 rounding (|PQ| + |PX|), where both norms are sums of coordinates; the products' own rounding adds
 * less than 2 rounding |PQ|. X is taken where it was found. It may be off by t's error times |AB|, which at most
 * doubles the bound as long as 4 rounding |AB| <= apart. */
static inline double hide_crossing_error(const hide_space *space, const hide_edge *e, double t, roberts_vec2 P,
                                         roberts_vec2 side, double apart)
{
    roberts_vec3 X = hide_edge_at(e, t);
    double length = fabs(side.x) + fabs(side.y), reach = fabs(X.x - P.x) + fabs(X.y - P.y);
    double run = fabs(e->B.x - e->A.x) + fabs(e->B.y - e->A.y);
    return 4.0 * space->rounding * run <= apart ? 4.0 * space->rounding * (2.0 * length + reach) / apart : INFINITY;
}

/* ---- the planes of faces ---- */

/* Roundings of a view coordinate: the error of a distance from a face's plane, near the face. */
#define PLANE_ROUNDINGS 4.0

/* No unit: a face is narrow where its solid is larger than this times its width. Only then is the face's departure from
 * its plane counted far from the face. */
#define WIDTHS_OF_SOLID 64.0

/* No unit: a front may fail to fill its outline by this times what its faces depart from their planes. */
#define LOOSE_DEPARTURES 4.0

/* Epsilons of depth: what lies this much deeper than a sheet that fills a cell does not touch the sheet. A plane that
 * is deeper by d at one place of the picture is d times the depth of its unit normal away. So this holds for a face
 * whose normal has a depth of more than 2^-20; a steeper one is nearly edge-on. */
#define SHEET_SLACK 0x1p20

/* Roundings of a view coordinate: the error of F(M) and of what is added to it for a point of the scene. It comes from
 * three products of coordinates, none larger than the extent, and from four sums. */
#define BUNDLE_ROUNDINGS 16.0

/* ---- runs of sides of a large polygon ---- */

/* Epsilons: how far inside of the sides a point must be to count as well inside of a run. Sides that rise no steeper
 * than the run's chord is long are at 2.1 then. What the tests call "on a side" is no farther from it than 1.125:
 * epsilon, and the HIDE_TRUSTED part of it. Half of an epsilon is for the guesses. The rest is to spare. */
#define RUNS_CLEAR 3.0

/* Roundings of a picture coordinate, added to that. Each coordinate of a corner and of the point is off by one, in the
 * frame by a root of two; turning to the frame adds less than one each. */
#define RUNS_CLEAR_ROUNDINGS 16.0

/* Roundings of a picture coordinate, divided by the side's run along the chord: the error of the side's slope, if its
 * two corners are off by that in both directions. The run must be more than RUNS_SIDE_ROUNDINGS roundings. */
#define RUNS_SLOPE_ROUNDINGS 12.0
#define RUNS_SIDE_ROUNDINGS 32.0

/* Part of epsilon: corners of a run may lie so far beside its chord for the chord to stand for the run. */
#define RUNS_STRAIGHT 0.1

/* Part of epsilon, in the picture: by how much the sides that were asked may leave more than was guessed. */
#define RUNS_GUESS_ACCURACY 0.5

/* ---- sizes above which another method finds the same ---- */

/* Front faces of a solid: with more, the solid is entered face by face. An edge that passes it would be compared with
 * all of them. No more than 32: hide_test1_of_all() gives each face a bit. */
#define FACES_OF_ONE_FRONT 24

/* Front faces of a solid: with more, it may be a bundle. Below, a tree over them gains nothing. */
#define BUNDLE_FACES 64

/* Boxes of faces over a point of the solid's box, on average: with more, it is a bundle. */
#define DEPTH_OF_BUNDLE 8.0

/* Faces of a solid in one cell, about: with more, it is a bundle too. With fewer, the tree takes longer. */
#define FACES_OF_A_CELL 1000.0

/* Corners of a face or an outline: with more, its sides are taken in runs. Below, that gains nothing. */
#define RUNS_CORNERS 64

/* Corners of an outline: with more, tests_fast.h leaves it to tests.c. An even number. */
#define FAST_CORNERS 16

#endif
