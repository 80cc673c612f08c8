/* tolerance.h - the tolerances and bounds of hidden-line removal: name, value, unit, reason.
 *
 * Three lengths depend on the scene and come from the view, in view units (see map.c). `epsilon` is the touching
 * distance. `rounding` bounds the error of any view coordinate. `across_rounding` bounds the error of an x or y. The
 * numbers below are multiples of these, or have no unit. Numbers that affect only time and memory are in the files that
 * use them, and so are bounds that follow from a proof there (front_tree.c, star_bodies.c, crossings.c). */
#ifndef ROBERTS_HIDE_TOLERANCE_H
#define ROBERTS_HIDE_TOLERANCE_H

#include <float.h>

#include "hide/types.h"

/* ---- signs and parameters ---- */

/* No unit: the wanted accuracy of a parameter t along an edge. Drawings are checked to 1e-9. A crossing whose rounding
 * could exceed this is recomputed in double-double numbers. */
#define HIDE_T_ACCURACY 1e-10

/* Fraction of epsilon: the largest error of a distance whose sign is trusted. */
#define HIDE_TRUSTED 0.125

/* No unit: the error of a determinant in doubles of differences of coordinates as read, over the same sum of products
 * with all terms positive. A difference is off by half an epsilon for each of: the high parts, the low parts, their
 * sum; together at most 2 half epsilons of its size. A product of two is off by 5, a component of the normal by 6. Its
 * product with a third difference is off by 9, the sum by 11 half epsilons. The rest covers the rounding of the sizes.
 */
#define REFINE_ROUNDINGS (16.0 * 0.5 * DBL_EPSILON)

/* Epsilons along the edge: a hidden part with a reach of at most this beyond its end needs no closer look. Cells and
 * boxes are widened by the same amount. */
#define REACH_PLAIN 4.0

/* Roundings of a picture coordinate, times a length: bounds the error of the cross product of two sides of an
 * outline. */
#define TURN_ROUNDINGS 8.0

/* Fraction of epsilon: an outline may turn inward at a corner if the lines of both sides cut off no more than this. */
#define INWARD_TURN 0.5

/* Is a parameter with this error accurate enough, as a parameter and as a length? */
static inline bool hide_accurate(const hide_space *space, const hide_edge *e, double error)
{
    return error <= HIDE_T_ACCURACY && error * e->length3 <= HIDE_TRUSTED * space->epsilon;
}

/* Is this part of an edge longer than epsilon, so that something is left of it? */
static inline bool hide_is_left(const hide_space *space, const hide_edge *e, const hide_interval *part)
{
    return (part->t1 - part->t0) * e->length3 > space->epsilon;
}

/* View units squared: bounds the error of the cross product of a side of this length and the vector (dx, dy) from one
 * of its ends to a point: the distance of the point from the side's line, times the length. */
static inline double hide_product_error(const hide_space *space, double length, double dx, double dy)
{
    return 2.0 * space->across_rounding * (length + fabs(dx) + fabs(dy));
}

/* View units squared: a cross product of two picture vectors has a plain sign if it is larger than this. span: bounds
 * the distance |dx| + |dy| of any two of their points; 4 extents hold for the whole picture.
 *
 * |u x v| is the distance of a point from the line through two others, times their distance l. The distance certainly
 * exceeds epsilon if |u x v| > epsilon l + 2 r (l + reach), r being `across_rounding`. Here l and the reach, |dx| +
 * |dy| of the point from one end, are at most the span. The rounding of the products adds less than 2 r span. One bound
 * serves all sides of a front and an edge. A sign that it does not decide is computed with its own error. */
static inline double hide_plain(double span, double epsilon, double across_rounding)
{
    return span * (epsilon + 8.0 * across_rounding);
}

/* View units: cells and boxes are widened by this, so that an edge and a face that touch are never separated. */
static inline double hide_margin(const hide_space *space)
{
    return 4.0 * (space->epsilon + space->rounding);
}

/* No unit: bounds the error of the parameter t at which AB crosses the line through P along `side`, the vector from one
 * corner to the next. `apart` is |a - b|, where a and b are the signed distances of A and B from that line, times the
 * side's length.
 *
 * This bound is sharper than the errors of a and b if the crossing lies near a short side, or far from the ends of AB.
 * If a and b are off by da and db, t is off by ((1 - t) da + t db) / (a - b). That is the error that the distance of
 * the crossing X itself would have. If P, Q and X move by r, the `across_rounding`, in each coordinate, the cross
 * product changes by at most 2 r (|PQ| + |PX|), with both norms as sums of coordinates. The rounding of the products
 * adds less than 2 r |PQ|. X is taken as computed. It may be off by t's error times |AB|, which at most doubles the
 * bound as long as 4 r |AB| <= apart. */
static inline double hide_crossing_error(const hide_space *space, const hide_edge *e, double t, roberts_vec2 P,
                                         roberts_vec2 side, double apart)
{
    roberts_vec3 X = hide_edge_at(e, t);
    double length = fabs(side.x) + fabs(side.y), reach = fabs(X.x - P.x) + fabs(X.y - P.y);
    double run = fabs(e->B.x - e->A.x) + fabs(e->B.y - e->A.y), r = space->across_rounding;
    return 4.0 * r * run <= apart ? 4.0 * r * (2.0 * length + reach) / apart : INFINITY;
}

/* ---- the planes of faces ---- */

/* Roundings of a view coordinate: the error of a distance from a face's plane, near the face. */
#define PLANE_ROUNDINGS 4.0

/* No unit: a face is narrow if its solid is larger than this times the face's width. Only for narrow faces does the
 * departure limit how far from the face its plane is trusted. */
#define WIDTHS_OF_SOLID 64.0

/* No unit: a front may leave gaps in its outline of up to this times the departure of its faces from their planes.
 * Ends of lines of regions that are no farther apart become one node. */
#define LOOSE_DEPARTURES 4.0

/* Epsilons of depth: what lies this much deeper than a sheet that fills a cell does not touch the sheet. A point that
 * is deeper than a plane by d lies at a distance of d times the depth of the plane's unit normal. So this holds for
 * faces whose normal has a depth of more than 2^-20; steeper faces are nearly edge-on. */
#define SHEET_SLACK 0x1p20

/* No unit: what is deeper than a triangle by SHEET_SLACK is known to be behind its plane if the triangle's unit normal
 * has at least this depth: then it is 64 epsilons behind. */
#define NORMAL_DEPTH 0x1p-14

/* Roundings of a view coordinate: the error of F(M) and of the terms added to it for a point of the scene. It comes
 * from three products of coordinates, none larger than the extent, and from four sums. */
#define BUNDLE_ROUNDINGS 16.0

/* ---- runs of sides of a large polygon ---- */

/* Epsilons: how far inside the sides a point must be to count as well inside a run. If no side rises by more than it
 * advances, the point is then at least 2.1 epsilons from each side. A point that the tests call "on a side" is at most
 * 1.125 away: epsilon and the HIDE_TRUSTED fraction of it. Half an epsilon is for the guesses. The rest is reserve. */
#define RUNS_CLEAR 3.0

/* Roundings of a picture coordinate, added to RUNS_CLEAR. Each coordinate of a corner and of the point is off by one,
 * which the frame increases by a factor of sqrt(2). The rotation into the frame adds less than one each. */
#define RUNS_CLEAR_ROUNDINGS 16.0

/* Roundings of a picture coordinate, divided by the side's advance along the chord: the error of the side's slope, if
 * its two corners are off by one rounding in both directions. The advance must exceed RUNS_SIDE_ROUNDINGS roundings. */
#define RUNS_SLOPE_ROUNDINGS 12.0
#define RUNS_SIDE_ROUNDINGS 32.0

/* Fraction of epsilon: how far the corners of a run may lie from its chord if the chord stands for the run. */
#define RUNS_STRAIGHT 0.1

/* Fraction of epsilon, in the picture: by how much the tested sides may leave more than was guessed. */
#define RUNS_GUESS_ACCURACY 0.5

/* ---- fronts that do not cross ---- */

/* Touching distances: solids this many of them apart do not touch. */
#define FILTER_APART 4.0

/* Roundings of a picture coordinate, times a length: a corner that is no farther than this on the inner side of a line
 * counts as outside. */
#define FILTER_BESIDE 4.0

/* ---- visible regions ---- */

/* Epsilons, and roundings of a picture coordinate: ends of lines that should meet are nearer to one another than
 * this. */
#define REGION_TOUCHING 8.0

/* No unit: where faces depart from their planes, lines that should meet may miss one another by up to this times the
 * greatest departure. An edge that ends in a face at a small angle may end that much earlier or later. */
#define REGION_DEPARTURES 64.0

/* Touching distances of regions: what is farther apart cannot meet by the division of lines. A round moves a line by at
 * most two of its touching distances, and each round has half the one of the round before, so a line moves by less than
 * four. The rest is for both lines, and for ends that are beside one another. */
#define REGION_MARGIN 16.0

/* Epsilons: corners made by the near plane are nearer to it than this. */
#define CUT_TOUCHING 16.0

/* Fraction of the scene's diameter: a face whose box begins deeper than this behind the visible point does not touch
 * it. A steep face may reach so far, but its picture is then narrower than a few epsilon there. */
#define LOOK_DEPTH 1e-5

/* ---- sizes above which another method finds the same result ---- */

/* Front faces of a solid: with more, each face is a front of its own. Otherwise an edge that passes the solid would be
 * compared with all of them. */
#define FACES_OF_ONE_FRONT 24
_Static_assert(FACES_OF_ONE_FRONT <= 32, "hide_test1_of_all() gives each face a bit");

/* Front faces of a solid: with more, it may be a bundle. Below this, a tree over the faces gains nothing. */
#define BUNDLE_FACES 64

/* Average number of face boxes over a point of the solid's box: with more, the solid is a bundle. */
#define DEPTH_OF_BUNDLE 8.0

/* Approximate number of the solid's faces in one cell: with more, the solid is a bundle too. With fewer, the tree takes
 * longer. */
#define FACES_OF_A_CELL 1000.0

/* Corners of a face or an outline: with more, its sides are grouped into runs. Below this, runs gain nothing. */
#define RUNS_CORNERS 64

/* Corners of an outline: with more, tests_fast.h leaves it to tests.c. */
#define FAST_CORNERS 16
_Static_assert(FAST_CORNERS % 2 == 0, "tests_fast.h takes two sides at a time");

#endif
