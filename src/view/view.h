/* view.h - from model space to view space: the viewer at z = +infinity, right-handed, x right, y up.
 *
 * One map serves both projections. With q = P - origin, components (x, y, e) along right, up and dir, and the eye at
 * distance D in front of the origin, the projective map
 *
 *     (x, y, e)  ->  (x, y, e) / (1 - e / D)
 *
 * preserves lines, planes and convexity and sends the eye to z = +infinity. For D = infinity (1 / D = 0) it is the
 * orthographic view. (In an oblique view, x and y are first shifted in proportion to -e.) A plane a x + b y + c e + d =
 * 0 becomes a x + b y + (c + d / D) z + d = 0, so a face is front (c' < 0) exactly if the eye is outside its plane.
 * Lengths at the origin's depth do not change.
 *
 * Lengths in view space are in units of the scene's `unit`, a power of two near its size. So no product of a few
 * coordinates overflows or underflows, whatever the model's unit, and a scene times 2^k gives the same bits. */
#ifndef ROBERTS_VIEW_VIEW_H
#define ROBERTS_VIEW_VIEW_H

#include "base/vec.h"
#include "model/scene.h"

/* Touching distance as a fraction of the scene's diameter: far above rounding (1e-16), far below a pen (1e-4 of a
 * page). */
#define EPSILON_OF_DIAMETER 1e-11
/* Fraction of the scene's diameter: the largest touching distance accepted. Beyond it, "on" would mean a visible
 * length. */
#define EPSILON_MOST 0.01

enum { VIEW_UNKNOWN = 0, VIEW_FRONT = 1, VIEW_BACK = 2, VIEW_EDGE_ON = 3 }; /* facing of a face */

typedef struct view {
    roberts_vec3 right, up, dir; /* unit vectors in model space */
    roberts_vec3 origin;         /* model units: the scene's centre, or the look-at point */
    double inverse_distance;     /* 1 / D in 1 / unit; 0 for the orthographic view */
    double unit;                 /* model units per unit of view space: the scene's */
    double per_unit;             /* 1 / unit */
    roberts_vec2 oblique; /* orthographic: how far a unit of depth moves a point to the right and up; usually 0, 0 */
    bool perspective;
    /* The viewer as a point of projective space. Perspective: the eye, in model units. Orthographic: a point at
     * infinity, that is, the direction toward the viewer, as given except for a power of two. */
    roberts_vec3 viewpoint;
    double viewpoint_depth; /* orthographic: the component of the viewpoint along dir */
    double diameter;        /* diagonal of the scene's box, view units */
    double extent;          /* bounds all view coordinates, view units; at least the diameter */
    double across;          /* bounds x and y, view units; at most the extent */
    double epsilon;         /* touching distance, view units */
    roberts_epsilon_reason epsilon_reason;
    double rounding;        /* bounds the rounding error of a view coordinate, view units */
    double across_rounding; /* bounds the rounding error of an x or y; at most `rounding` */
    double plane_rounding;  /* perspective: bounds the rounding error of the eye's distance from a face's plane;
                               otherwise 0 */
} view;

/* Prepares the map of `scene` seen by `camera`. epsilon: touching distance in model units. 0: choose it (1e-11 of the
 * diameter, at least 16 ulp of the largest coordinate before and after the map, the eye's included). Returns
 * ROBERTS_OK, _BAD_VIEW (no direction, or the scene is not completely in front of the eye) or _BAD_ARGUMENT. */
roberts_status view_prepare(view *v, const roberts_scene *scene, const roberts_camera *camera, double epsilon,
                            roberts_error *error);

/* Prepares the map alone, from the scene's box: view_point() works afterwards, but there are no tolerances. */
roberts_status view_begin(view *v, const roberts_scene *scene, const roberts_camera *camera, double epsilon,
                          roberts_error *error);

/* Extends `reach` to points of the model, for a view that has been prepared. It starts with nearest = INFINITY and
 * zeros. In an orthographic view nothing is measured: there the box is enough. */
void view_add_reach(const view *v, const roberts_vec3 *P, size_t count, scene_reach *reach);

/* Maps a point of the model to view space, in view units. */
roberts_vec3 view_point(const view *v, roberts_vec3 P);

/* Maps `count` points. */
void view_points(const view *v, const roberts_vec3 *P, size_t count, roberts_vec3 *out);

/* Maps a point in the plane at this distance from the eye, model units: near the eye, the rounding of its own distance
 * would be seen. */
roberts_vec3 view_point_at(const view *v, roberts_vec3 P, double distance);

/* Returns a face's plane in view space (view units, unit normal). `*stretch`, unless NULL, becomes the factor by which
 * distances from the plane grow per unit of 1 + z / D; in the orthographic view it is 1. */
plane view_plane(const view *v, const roberts_scene *scene, uint32_t face, double *stretch);

/* The same for a plane of the model, F, of a scene with this centre. */
plane view_plane_of(const view *v, roberts_vec3 centre, plane F, double *stretch);

/* Returns whether a face is front, back or edge-on. It is edge-on if its picture is no wider than epsilon. P: view
 * points of all vertices of the scene; F: the plane of the face in view space. */
int view_facing(const view *v, const roberts_scene *scene, uint32_t face, plane F, const roberts_vec3 *P);

/* Is this a parallel view along dir? Then the map only rotates, and changes the unit. */
static inline bool view_at_right_angles(const view *v)
{
    return !v->perspective && v->oblique.x == 0.0 && v->oblique.y == 0.0;
}

/* A triangle is plainly front or back if its picture is wider than the sum of these. */
#define PLAIN_EPSILONS 4.0
#define PLAIN_ROUNDINGS 64.0

/* Returns the facing of a triangle whose plane follows from its corners alone, if that is plain from its picture. It is
 * that of view_facing(). VIEW_UNKNOWN: it is not.
 *
 * Twice the signed area of a triangle's picture is also |n| c, for the normal n and its part c toward the viewer. If it
 * exceeds the bound here, neither rounding nor epsilon matters: c has its sign, and the picture is wider than epsilon.
 */
static inline int view_facing_of_triangle(const view *v, const uint32_t corner[3], const roberts_vec3 *P)
{
    roberts_vec3 A = P[corner[0]], AB = vec3_sub(P[corner[1]], A), AC = vec3_sub(P[corner[2]], A);
    double twice = AB.x * AC.y - AB.y * AC.x;
    double size = fabs(AB.x) + fabs(AB.y) + fabs(AB.z) + fabs(AC.x) + fabs(AC.y) + fabs(AC.z);
    if (!(fabs(twice) > (PLAIN_EPSILONS * v->epsilon + PLAIN_ROUNDINGS * v->rounding) * size) ||
        !view_at_right_angles(v))
        return VIEW_UNKNOWN;
    return twice > 0.0 ? VIEW_FRONT : VIEW_BACK;
}

/* Returns the facing of a face and, if it is front, sets its plane and stretch. */
int view_face(const view *v, const roberts_scene *scene, uint32_t face, const roberts_vec3 *P, plane *F,
              double *stretch);

/* Converts parameter `s` along an edge's picture to the parameter along the edge in space, and back. zA, zB: view
 * depths of the edge's ends. In the orthographic view both parameters are equal. In perspective, equal steps in space
 * crowd together in the picture where the edge is far from the eye. */
double view_to_space(const view *v, double zA, double zB, double s);
double view_from_space(const view *v, double zA, double zB, double t);

/* Is the picture the square of a field of view, about the look-at point? It is if one is given, or if the near plane
 * has cut the scene (`clipped`) and what is left is wider. Then *min and *max, the corners of the scene's box, become
 * those of the square. Model units. */
bool view_frame(const view *v, const roberts_camera *camera, bool clipped, roberts_vec2 *min, roberts_vec2 *max);

#endif
