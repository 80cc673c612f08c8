/* oracle.h - which parts of which edges are hidden, decided with exact numbers: what the program is held against.
 *
 * The definition is that of the drawing: a point X of an edge is hidden where a front face of another solid, closed in
 * projection, holds a point strictly nearer the viewer on the same sight line. Everything is decided in model space on
 * the doubles of the mesh, each taken as the rational number it is; the viewer is a homogeneous point (dir, 0) or
 * (eye, 1); nothing is ever turned. Rounding happens once, when an end t of an interval leaves as a double.
 *
 * Of the library only the mesh is used, as plain data. */
#ifndef ROBERTS_TESTS_ORACLE_H
#define ROBERTS_TESTS_ORACLE_H

#include "roberts.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The viewer: w == 0: infinitely far in direction (x, y, z), which points from the scene toward the viewer; w == 1: an
 * eye at (x, y, z).
 * An eye with the whole scene in front of it needs no more. Else the near plane runs through `near`, square to the line from
 * the eye to that point, and what lies on the eye's side of it is not there: edges end on it, and solids that it passes
 * through are closed by it. A solid that only touches it from that side is not there either; nor is an edge that lies in it,
 * unless all of its solid lies beyond. */
typedef struct oracle_view {
    double x, y, z;
    int w;
    bool cut; /* there is a near plane; w is 1 then, and no slack can be given */
    roberts_vec3 near;
} oracle_view;

typedef enum oracle_answer { ORACLE_NO, ORACLE_YES, ORACLE_UNSURE } oracle_answer;

typedef struct oracle_interval {
    double t0, t1;
} oracle_interval;

/* An edge and its hidden part. `sure` holds what is hidden wherever within `slack` the corners lie, `maybe` what is
 * hidden for some such positions; without slack the two are the same. Intervals ascend and do not touch. */
typedef struct oracle_edge {
    uint32_t solid, v0, v1; /* v0 < v1, vertex numbers of the mesh */
    oracle_answer survives; /* has a front face; UNSURE only with slack */
    double bend_degrees;    /* between its two faces where both are front; 180 where not both are (an outline);
                               -1 where that is unsure */
    double t0, t1;          /* the part of it beyond the near plane; 1, 1 where there is none */
    size_t sure, sure_count, maybe, maybe_count; /* into oracle_result.interval */
} oracle_edge;

typedef struct oracle_result {
    size_t edge_count, interval_count, solid_count;
    oracle_edge *edge; /* [edge_count], sorted by solid, v0, v1 */
    oracle_interval *interval;
    uint32_t *vertex_solid; /* [vertex_count of the mesh] ROBERTS_NONE where no face uses the vertex */
    size_t pairs, exact;    /* pairs of edge and solid clipped; those for which intervals were too wide */
    char error[160];        /* what went wrong; empty if nothing */
} oracle_result;

typedef struct oracle_options {
    double slack;    /* model units: how far any corner may be from where the mesh says; 0 = it is there */
    bool exact_only; /* rational numbers for everything, without trying intervals of doubles first: slow, same result */
} oracle_options;

/* Finds the hidden intervals of every edge of `mesh`. The solids are its components by shared vertices, numbered by
 * smallest vertex, each convex (its convex hull is what hides). Winding is not looked at. options: NULL for none. The eye
 * must not be within a solid.
 * False: *result holds nothing but an error. Release with oracle_free(). */
bool oracle_run(const roberts_mesh *mesh, const oracle_view *view, const oracle_options *options,
                oracle_result *result);
void oracle_free(oracle_result *result);

/* The convex hull of points as triangles, by exact predicates; `face` has room for 2 * count of them. Points within it have
 * none. Returns the number of triangles, 0 where the points are flat or there is no memory. */
size_t oracle_hull(const roberts_vec3 *point, uint32_t count, uint32_t (*face)[3]);

/* A point of an edge, from which the ray toward the viewer is cast. */
typedef struct oracle_point {
    const roberts_mesh *mesh;     /* its faces are exactly planar */
    const uint32_t *vertex_solid; /* that of oracle_run() */
    const oracle_view *view;
    uint32_t v0, v1;
    double t;
    roberts_vec3 aside; /* what the point is moved by */
} oracle_point;

/* The definition once more and as plainly as possible, to check the oracle itself (rays.cpp): casts the ray against every triangle
 * of every face as the mesh gives it. Returns whether a front face of another solid lies strictly nearer the viewer. */
bool oracle_point_hidden(const oracle_point *point);

/* Whether solid `by` is seen by the viewer in the direction of that point: it has a front face on the same sight line
 * whose plane is not farther than `touch` (model units) from the nearest one's point.
 * seen  what is nearest; of several solids there the smallest number; ROBERTS_NONE where there is none */
bool oracle_point_seen(const oracle_point *point, double touch, uint32_t by, uint32_t *seen);

#ifdef __cplusplus
}
#endif

#endif
