/* oracle.h - which parts of which edges are hidden, decided with exact numbers. The program is compared with this.
 *
 * The definition is that of the drawing: a point X of an edge is hidden if a front face of another solid, closed in
 * projection, contains a point strictly nearer to the viewer on the same sight line. Everything is decided in model
 * space on the doubles of the mesh, taken as exact rational numbers. The viewer is a homogeneous point (dir, 0) or
 * (eye, 1), and nothing is ever turned. Rounding happens once, when an end t of an interval is returned as a double.
 *
 * Only the library's mesh is used, as plain data. */
#ifndef ROBERTS_TESTS_ORACLE_H
#define ROBERTS_TESTS_ORACLE_H

#include "roberts.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The viewer. w == 0: infinitely far in direction (x, y, z), which points from the scene toward the viewer. w == 1: an
 * eye at (x, y, z). If `cut`, a near plane passes through `near`, perpendicular to that direction, or to the line from
 * the eye to that point. Everything on the viewer's side of it is removed: edges end on it, and solids that it passes
 * through are closed by it. A solid that only touches it from that side is removed too, and so is an edge in it, unless
 * all of its solid lies beyond. An eye with the whole scene in front of it needs no near plane. */
typedef struct oracle_view {
    double x, y, z;
    int w;
    bool cut; /* there is a near plane; then no slack can be given */
    roberts_vec3 near;
} oracle_view;

typedef enum oracle_answer { ORACLE_NO, ORACLE_YES, ORACLE_UNSURE } oracle_answer;

typedef struct oracle_interval {
    double t0, t1;
} oracle_interval;

/* An edge and its hidden part. `sure` is the part hidden for all positions of the corners within `slack`, `maybe` the
 * part hidden for some of them; without slack they are equal. Intervals ascend and do not touch. */
typedef struct oracle_edge {
    uint32_t solid, v0, v1; /* v0 < v1, vertex numbers of the mesh */
    oracle_answer survives; /* it has a front face; UNSURE only with slack */
    double bend_degrees;    /* angle between its two faces if both are front; 180 if not both are (an outline); -1 if
                               unsure */
    double t0, t1;          /* the part beyond the near plane; 1, 1: nothing */
    size_t sure, sure_count, maybe, maybe_count; /* indices into oracle_result.interval */
} oracle_edge;

typedef struct oracle_result {
    size_t edge_count, interval_count, solid_count;
    oracle_edge *edge; /* [edge_count], sorted by solid, v0, v1 */
    oracle_interval *interval;
    uint32_t *vertex_solid; /* [vertex_count of the mesh] ROBERTS_NONE: no face uses the vertex */
    size_t pairs, exact;    /* pairs of edge and solid clipped; those for which intervals were too wide */
    char error[160];        /* empty: no error */
} oracle_result;

typedef struct oracle_options {
    double slack;    /* model units: how far any corner may be from its position in the mesh; 0: exact */
    bool exact_only; /* use rational numbers for everything, without intervals of doubles first: slow, same result */
} oracle_options;

/* Finds the hidden intervals of every edge of `mesh`. The solids are its components by shared vertices, numbered by
 * smallest vertex; each is convex (its convex hull hides). Winding is ignored. options: NULL: defaults. The eye must
 * not be inside a solid. False: *result contains only an error. Release with oracle_free(). */
bool oracle_run(const roberts_mesh *mesh, const oracle_view *view, const oracle_options *options,
                oracle_result *result);
void oracle_free(oracle_result *result);

/* Computes the convex hull of points as triangles, by exact predicates; `face` has room for 2 * count of them. Points
 * inside it are not used. Returns the number of triangles; 0 if the points are flat or there is no memory. */
size_t oracle_hull(const roberts_vec3 *point, uint32_t count, uint32_t (*face)[3]);

/* A point of an edge, from which a ray is cast toward the viewer. */
typedef struct oracle_point {
    const roberts_mesh *mesh;     /* its faces are exactly planar */
    const uint32_t *vertex_solid; /* from oracle_run() */
    const oracle_view *view;
    uint32_t v0, v1;
    double t;
    roberts_vec3 aside; /* displacement of the point */
} oracle_point;

/* The definition applied as directly as possible, to check the oracle itself (rays.cpp): casts the ray against every
 * triangle of every face of the mesh. Returns whether a front face of another solid lies strictly nearer to the
 * viewer. */
bool oracle_point_hidden(const oracle_point *point);

/* Does the viewer see solid `by` in the direction of that point? It does if the solid has a front face on the same
 * sight line whose plane is no farther than `touch` (model units) from the nearest face's point.
 * seen  the nearest solid; of several there, the smallest number; ROBERTS_NONE: none */
bool oracle_point_seen(const oracle_point *point, double touch, uint32_t by, uint32_t *seen);

#ifdef __cplusplus
}
#endif

#endif
