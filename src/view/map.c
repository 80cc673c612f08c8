/* map.c - the map of points, planes and faces to view space. See view.h. */
#include "view/view.h"

#include <float.h>
#include <math.h>

#include "base/angle.h"
#include "base/bits.h"
#include "base/error.h"
#include "base/lanes.h"
#include "base/vec.h"

/* The least touching distance, in ulps of the largest coordinate: for scenes far from the origin. */
#define EPSILON_ULPS 16.0
/* Fraction of the scene's diameter: the least distance of the eye from the scene, along the line of sight. As the
 * distance goes to 0, the picture grows without bound. This is half of what the near plane always cuts off (see
 * clip.c), so rounding does not matter. */
#define NEAREST_OF_DIAMETER 5e-7
/* Bound of the error of a view coordinate, in half ulps of the largest coordinate: from a subtraction, three products
 * and two sums with unit vectors that are themselves rounded, and the division. */
#define ROUNDINGS 8.0
/* The bounds for x and y are used only if they are at most this fraction of the bound for all coordinates. Otherwise
 * they gain little. The larger bound makes the most oblique crossings more accurate than promised. */
#define MUCH_SHARPER 0.25
/* A face with more corners is not measured across each side: the time would grow with the square of their number. */
#define MEASURED_CORNERS 64
/* Steeper oblique views are unreadable. */
#define OBLIQUE_MOST 1000.0
/* If the sine of the angle between `up` and the line of sight is at most this, they count as parallel. */
#define PARALLEL 1e-9
/* If the cosine of the angle between a section's direction and that toward the viewer is this far below 0, the section
 * faces away. */
#define AWAY 1e-9
/* If the cosine of the angle between an axis of the picture and the line of sight is at most this, it is rounding, and
 * they are perpendicular. */
#define ACROSS (4.0 * DBL_EPSILON)

/* Returns a / |a|, even if the squares would overflow or underflow; zero stays zero. */
static roberts_vec3 unit_vector(roberts_vec3 a)
{
    double m = vec3_largest(a);
    if (m == 0.0)
        return a;
    a = (roberts_vec3){a.x / m, a.y / m, a.z / m}; /* not times 1 / m, which overflows for a denormal m */
    return vec3_scale(1.0 / vec3_length(a), a);
}

/* Rolls the picture counter-clockwise: a point right of the origin moves up. */
static void roll_frame(view *v, double degrees)
{
    roberts_vec2 by = angle_unit(degrees);
    roberts_vec3 right = v->right, up = v->up;
    v->right = vec3_sub(vec3_scale(by.x, right), vec3_scale(by.y, up));
    v->up = vec3_add(vec3_scale(by.y, right), vec3_scale(by.x, up));
}

/* Returns the unit vector of a x dir. If the two are nearly parallel, rounding dominates the product and leaves a
 * component along dir. This component is subtracted; otherwise depth would leak into the picture. */
static roberts_vec3 unit_across(roberts_vec3 a, roberts_vec3 dir)
{
    roberts_vec3 across = unit_vector(vec3_cross(a, dir));
    double along = vec3_dot(across, dir);
    return fabs(along) > ACROSS ? unit_vector(vec3_sub(across, vec3_scale(along, dir))) : across;
}

/* Sets the picture's right and up: `up` is made perpendicular to the line of sight. If it is zero or parallel to that
 * line, +z replaces it, and then +y. */
static void set_view_axes(view *v, roberts_vec3 dir, roberts_vec3 up, double roll_degrees)
{
    const roberts_vec3 choices[] = {unit_vector(up), {0, 0, 1}, {0, 1, 0}};
    v->dir = unit_vector(dir);
    for (size_t i = 0; i < sizeof choices / sizeof choices[0]; i++) {
        if (vec3_length(vec3_cross(choices[i], v->dir)) > PARALLEL) {
            v->right = unit_across(choices[i], v->dir);
            v->up = vec3_cross(v->dir, v->right);
            if (roll_degrees != 0.0) /* a turn by 0 might change -0 to 0 */
                roll_frame(v, roll_degrees);
            return;
        }
    }
}

/* Divides by the weight w = 1 - e / D. For points nearer to the eye than to the look-at point, x, y and w are computed
 * relative to the eye, which is on the axis of sight. Near the eye, the two terms of w nearly cancel, and so do those
 * of x and y, but the difference of P and the eye is exact or nearly so. */
static roberts_vec3 perspective_point(const view *v, roberts_vec3 P, roberts_vec3 p)
{
    double w = 1.0 - p.z * v->inverse_distance;
    if (w < 0.5) {
        roberts_vec3 q = vec3_scale(v->per_unit, vec3_sub(P, v->viewpoint));
        p.x = vec3_dot(v->right, q);
        p.y = vec3_dot(v->up, q);
        w = -vec3_dot(v->dir, q) * v->inverse_distance;
    }
    return vec3_scale(1.0 / w, p);
}

roberts_vec3 view_point(const view *v, roberts_vec3 P)
{
    roberts_vec3 q = vec3_scale(v->per_unit, vec3_sub(P, v->origin));
    roberts_vec3 p = {vec3_dot(v->right, q), vec3_dot(v->up, q), vec3_dot(v->dir, q)};
    p.x -= v->oblique.x * p.z;
    p.y -= v->oblique.y * p.z;
    return v->perspective ? perspective_point(v, P, p) : p;
}

/* Computes x and y in parallel. Both equal those of view_point() to the last bit. */
BITS_INLINE void points_in_parallel(const view *v, const roberts_vec3 *P, size_t count, roberts_vec3 *out)
{
    two ax = two_of(v->right.x, v->up.x), ay = two_of(v->right.y, v->up.y), az = two_of(v->right.z, v->up.z);
    two oblique = two_of(v->oblique.x, v->oblique.y);
    for (size_t i = 0; i < count; i++) {
        roberts_vec3 q = vec3_scale(v->per_unit, vec3_sub(P[i], v->origin));
        two xy = two_add(two_add(two_mul(ax, two_all(q.x)), two_mul(ay, two_all(q.y))), two_mul(az, two_all(q.z)));
        double z = vec3_dot(v->dir, q);
        two_part(&out[i].x, &out[i].y, two_sub(xy, two_mul(oblique, two_all(z))));
        out[i].z = z;
    }
}

BITS_PER_PROCESSOR void view_points(const view *v, const roberts_vec3 *P, size_t count, roberts_vec3 *out)
{
    if (!v->perspective) {
        points_in_parallel(v, P, count, out);
        return;
    }
    for (size_t i = 0; i < count; i++)
        out[i] = view_point(v, P[i]);
}

roberts_vec3 view_point_at(const view *v, roberts_vec3 P, double distance)
{
    const roberts_vec3 q = vec3_scale(v->per_unit, vec3_sub(P, v->viewpoint));
    const double w = distance * v->per_unit * v->inverse_distance;
    return (roberts_vec3){vec3_dot(v->right, q) / w, vec3_dot(v->up, q) / w, (1.0 - w) / (w * v->inverse_distance)};
}

plane view_plane(const view *v, const roberts_scene *scene, uint32_t face, double *stretch)
{
    return view_plane_of(v, scene->centre, scene_plane(scene, face), stretch);
}

plane view_plane_of(const view *v, roberts_vec3 centre, plane F, double *stretch)
{
    roberts_vec3 n = {F.a, F.b, F.c};
    plane G = {vec3_dot(v->right, n), vec3_dot(v->up, n), vec3_dot(v->dir, n), F.d * v->per_unit};
    if (stretch)
        *stretch = 1.0;
    if (view_at_right_angles(v))
        return G; /* a rotation keeps the normal's length */
    G.c += v->oblique.x * G.a + v->oblique.y * G.b;
    if (v->perspective) { /* c' = c + d / D is the eye's distance from the plane, as a fraction of D */
        G.d += vec3_dot(n, vec3_sub(v->origin, centre)) * v->per_unit;
        G.c = (F.d + vec3_dot(n, vec3_sub(v->viewpoint, centre))) * v->per_unit * v->inverse_distance;
    }
    double length = sqrt(G.a * G.a + G.b * G.b + G.c * G.c);
    if (stretch)
        *stretch = 1.0 / length;
    return (plane){G.a / length, G.b / length, G.c / length, G.d / length};
}

/* Returns the extent of the face's picture in direction (x, y), which has any length but 0. */
static double extent_across(const roberts_scene *scene, uint32_t face, const roberts_vec3 *P, double x, double y)
{
    double low = INFINITY, high = -INFINITY, length = hypot(x, y);
    for (uint32_t k = scene->face_start[face]; k < scene->face_start[face + 1]; k++) {
        roberts_vec3 p = P[scene->corner[k]];
        double s = (x * p.y - y * p.x) / length;
        low = lesser(low, s);
        high = greater(high, s);
    }
    return high - low;
}

/* Returns the width of the face's picture, which is its least extent. A polygon has its least extent perpendicular to
 * one of its sides. A face of very many corners is measured only in the direction (b, -a), in which the tilt of its
 * plane makes it narrow. */
static double picture_width(const roberts_scene *scene, uint32_t face, plane F, const roberts_vec3 *P)
{
    uint32_t first = scene->face_start[face], end = scene->face_start[face + 1];
    double width = F.a != 0.0 || F.b != 0.0 ? extent_across(scene, face, P, F.b, -F.a) : INFINITY;
    for (uint32_t k = first; k < end && end - first <= MEASURED_CORNERS; k++) {
        roberts_vec3 p = P[scene->corner[k]], q = P[scene->corner[k + 1 < end ? k + 1 : first]];
        if (p.x != q.x || p.y != q.y)
            width = lesser(width, extent_across(scene, face, P, q.x - p.x, q.y - p.y));
    }
    return width;
}

/* Model units: if |c| times the face's width exceeds this, 4 epsilons, the picture need not be measured. The picture of
 * a face is at least about |c| times as wide as the face. */
static inline double wide_enough(const view *v)
{
    return 4.0 * v->epsilon * v->unit;
}

int view_facing(const view *v, const roberts_scene *scene, uint32_t face, plane F, const roberts_vec3 *P)
{
    double shrunk = 1.0; /* in perspective, a face also shrinks with distance, at most by this factor */
    if (v->perspective) {
        double z = P[scene->corner[scene->face_start[face]]].z;
        shrunk = lesser(1.0, 1.0 + z * v->inverse_distance);
        shrunk *= shrunk;
    }
    if (fabs(F.c) * scene_width(scene, face) * shrunk <= wide_enough(v) &&
        picture_width(scene, face, F, P) <= v->epsilon)
        return VIEW_EDGE_ON;
    return F.c < 0.0 ? VIEW_FRONT : F.c > 0.0 ? VIEW_BACK : VIEW_EDGE_ON;
}

/* In an orthographic view that is not oblique, the depth of the normal is enough to decide whether the face is wide,
 * and a back face needs no plane. a and b are computed in parallel. The plane equals that of view_plane() to the last
 * bit. */
int view_face(const view *v, const roberts_scene *scene, uint32_t face, const roberts_vec3 *P, plane *F,
              double *stretch)
{
    if (view_at_right_angles(v)) {
        const plane *G = &scene->face_plane[face];
        double c = vec3_dot(v->dir, (roberts_vec3){G->a, G->b, G->c}), least = wide_enough(v);
        double wide = c * scene_width(scene, face);
        if (wide > least)
            return VIEW_BACK;
        if (wide < -least) {
            two a = two_of(v->right.x, v->up.x), b = two_of(v->right.y, v->up.y), d = two_of(v->right.z, v->up.z);
            a = two_add(two_mul(a, two_all(G->a)), two_mul(b, two_all(G->b)));
            two_part(&F->a, &F->b, two_add(a, two_mul(d, two_all(G->c))));
            F->c = c;
            F->d = G->d * v->per_unit;
            *stretch = 1.0;
            return VIEW_FRONT;
        }
    }
    *F = view_plane(v, scene, face, stretch);
    return view_facing(v, scene, face, *F, P);
}

/* With weights w = 1 - e / D = 1 / (1 + z / D), the picture of R(t) = (1-t) A + t B divides the picture of AB in the
 * ratio (1-t) wA : t wB. */
double view_to_space(const view *v, double zA, double zB, double s)
{
    if (!v->perspective)
        return s;
    double near_a = 1.0 + zA * v->inverse_distance, near_b = 1.0 + zB * v->inverse_distance; /* 1 / wA, 1 / wB */
    return s * near_b / ((1.0 - s) * near_a + s * near_b);
}

double view_from_space(const view *v, double zA, double zB, double t)
{
    if (!v->perspective)
        return t;
    double near_a = 1.0 + zA * v->inverse_distance, near_b = 1.0 + zB * v->inverse_distance;
    return t * near_a / ((1.0 - t) * near_b + t * near_a);
}

/* Returns the distance D of the eye, view units. */
static double eye_distance(const view *v)
{
    roberts_vec3 back = vec3_sub(v->viewpoint, v->origin);
    double m = vec3_largest(back);
    return m * vec3_length((roberts_vec3){back.x / m, back.y / m, back.z / m}) / v->unit;
}

/* Returns the least distance of the points from the eye's plane, or `nearest` if that is less. */
static double nearest_of(const view *v, const roberts_vec3 *P, size_t count, double nearest)
{
    double distance = eye_distance(v);
    for (size_t i = 0; i < count; i++) {
        roberts_vec3 q = vec3_scale(v->per_unit, vec3_sub(P[i], v->origin));
        nearest = fmin(nearest, distance - vec3_dot(v->dir, q));
    }
    return nearest;
}

/* The whole scene must lie in front of the eye. */
static roberts_status check_nearest(const view *v, const roberts_scene *scene, roberts_error *error)
{
    double nearest =
        scene->whole ? scene->whole->reach.nearest : nearest_of(v, scene->point, scene->vertex_count, INFINITY);
    if (!(nearest > NEAREST_OF_DIAMETER * v->diameter))
        return error_set(error, ROBERTS_BAD_VIEW, 0,
                         "the scene is not wholly in front of the eye: its nearest vertex lies %.6g %s the eye's plane",
                         fabs(nearest) * v->unit, nearest < 0.0 ? "behind" : "in front of");
    return ROBERTS_OK;
}

/* Returns the sum of |a_i| h_i: the greatest coordinate along a in a box of half sizes h about the origin. */
static double reach_along(roberts_vec3 a, roberts_vec3 h)
{
    return fabs(a.x) * h.x + fabs(a.y) * h.y + fabs(a.z) * h.z;
}

static roberts_vec3 size_of(roberts_vec3 a)
{
    return (roberts_vec3){fabs(a.x), fabs(a.y), fabs(a.z)};
}

/* Bounds |a . V|, which is zero except for rounding. Three products and two sums add at most 3.01 units of rounding
 * (half an epsilon each) times the sum of |a_i V_i|. V may come from a subtraction, which adds one more. */
static double leak(roberts_vec3 a, roberts_vec3 V)
{
    return fabs(vec3_dot(a, V)) + 2.0 * DBL_EPSILON * reach_along(a, size_of(V));
}

/* Sets bounds for x and y and for their errors, for an orthographic view that is not oblique. A scene may be much
 * deeper than its picture is wide, and the depth adds nothing to the errors of x and y.
 *
 * The exact picture is a projection along the viewpoint V as given. For the axis a (right or up) it is x' = (a - (a.V /
 * V.V) V) . q with q = P - origin; shifting, stretching or turning the picture changes no parameter and no sign. The
 * computed x is a . q. It has two errors. First, one subtraction, one product and at most two sums are each off by half
 * an epsilon of their result, together by at most 4.01 half epsilons times the sum of |a_i q_i|. Eight half epsilons
 * are allowed; the rest covers the rounding of products of coordinates (see hide_plain()). Second, |x - x'| = |a.V|
 * |V.q| / V.V: the depth leaks into x as far as the axis is not perpendicular to V. */
static void set_across(view *v, const roberts_scene *scene)
{
    roberts_vec3 low = vec3_sub(v->origin, scene->box_min), high = vec3_sub(scene->box_max, v->origin);
    roberts_vec3 h =
        vec3_scale(v->per_unit, (roberts_vec3){fmax(low.x, high.x), fmax(low.y, high.y), fmax(low.z, high.z)});
    roberts_vec3 V = v->viewpoint;
    double depth = reach_along(V, h) / vec3_dot(V, V);
    /* the bounds are rounded too */
    double across = 1.001 * fmax(reach_along(v->right, h), reach_along(v->up, h));
    double rounding = ROUNDINGS * 0.5 * DBL_EPSILON * across + fmax(leak(v->right, V), leak(v->up, V)) * 1.001 * depth;
    if (rounding > MUCH_SHARPER * v->rounding)
        return;
    v->across = across;
    v->across_rounding = rounding;
}

/* Bounds the error of x and y of a vertex seen from an eye V. leaks: bounds |a.(V - O)| for both axes a of the picture.
 *
 * The exact picture is x' / w' with x' = a.(P - V) and w' = -dir.(P - V) / D, for axes and D as they are stored: a map
 * that takes planes through V to lines. The computed values are x = a.q and w = 1 - dir.q / D, with q = P - O. Let u be
 * half an epsilon, and R(a) the sum of |a_i q_i|:
 *
 *     x is off by 4.01 u R(a), as in set_across(), and by a.(V - O), which is zero except for rounding;
 *     w is off by 5.01 u R(dir) / D + u w, and by dir.(V - O) / D - 1: the rounding of dir and D, less than 16 u;
 *     1 / w and its product with x are each off by u times |x / w| <= R(a) / w.
 *
 * So x / w is off by at most (7.01 u R(a) + |a.(V - O)| + |x / w| u (5.01 R(dir) / D + 16)) / w. Sixteen u are allowed
 * for each; the rest of those of R(a) covers the rounding of products of coordinates (see hide_plain()). If
 * perspective_point() computes x, y and w relative to the eye, q is P - V, and the same holds without a.(V - O) and
 * without the 16 u. For a vertex made by the near plane, q includes the vertex's rounding error. */
static double eye_rounding(const view *v, roberts_vec3 P, const roberts_vec3 *low, double leaks)
{
    roberts_vec3 q = vec3_scale(v->per_unit, vec3_sub(P, v->origin)), X = view_point(v, P);
    double wide = fmax(fabs(X.x), fabs(X.y)), widest = wide * v->inverse_distance;
    double w = 1.0 - vec3_dot(v->dir, q) * v->inverse_distance;
    if (w < 0.5) {
        q = vec3_scale(v->per_unit, vec3_sub(P, v->viewpoint));
        w = -vec3_dot(v->dir, q) * v->inverse_distance;
        leaks = 0.0;
    }
    q = size_of(q);
    double bound = fmax(reach_along(v->right, q), reach_along(v->up, q)) + wide + widest * reach_along(v->dir, q);
    bound = 2.0 * ROUNDINGS * 0.5 * DBL_EPSILON * bound + leaks;
    if (low) {
        roberts_vec3 off = size_of(vec3_scale(v->per_unit, *low));
        bound += fmax(reach_along(v->right, off), reach_along(v->up, off)) + widest * reach_along(v->dir, off);
    }
    return 1.001 * bound / w; /* the bounds are rounded too; 1 + z / D is too inexact if w is large */
}

/* The leaks that eye_rounding() needs. */
static double eye_leaks(const view *v)
{
    roberts_vec3 back = vec3_scale(v->per_unit, vec3_sub(v->viewpoint, v->origin));
    return fmax(leak(v->right, back), leak(v->up, back));
}

/* Does the same as set_across() for an eye. No x or y exceeds `across`. */
static void set_across_from_eye(view *v, const roberts_scene *scene, double across)
{
    double leaks = eye_leaks(v), most = MUCH_SHARPER * v->rounding;
    double rounding = scene->whole ? scene->whole->reach.rounding : 0.0;
    for (uint32_t i = 0; !scene->whole && i < scene->vertex_count && rounding <= most; i++)
        rounding = fmax(rounding, eye_rounding(v, scene->point[i], scene->low ? &scene->low[i] : NULL, leaks));
    if (rounding > most)
        return;
    v->across = across;
    v->across_rounding = rounding;
}

/* Sets the touching distance: the given one, or the greatest of those with a reason. largest_coordinate: view units. */
static void choose_epsilon(view *v, const roberts_scene *scene, double given, double largest_coordinate)
{
    const struct choice {
        double epsilon;
        roberts_epsilon_reason reason;
    } choices[] = {{EPSILON_OF_DIAMETER * v->diameter, ROBERTS_EPSILON_DIAMETER},
                   {EPSILON_ULPS * DBL_EPSILON * largest_coordinate, ROBERTS_EPSILON_ROUNDING},
                   {scene->steps.float32 / v->unit, ROBERTS_EPSILON_FLOAT32},
                   {scene->steps.decimal / v->unit, ROBERTS_EPSILON_DECIMAL}};
    v->epsilon = given / v->unit;
    v->epsilon_reason = ROBERTS_EPSILON_GIVEN;
    for (size_t i = 0; !(given > 0.0) && i < sizeof choices / sizeof choices[0]; i++)
        if (choices[i].epsilon > v->epsilon) {
            v->epsilon = choices[i].epsilon;
            v->epsilon_reason = choices[i].reason;
        }
}

/* Extends the reach in the picture and in depth to points seen from an eye. */
static void add_extents(const view *v, const roberts_vec3 *P, size_t count, scene_reach *reach)
{
    for (size_t i = 0; i < count; i++) {
        roberts_vec3 X = view_point(v, P[i]);
        reach->across = fmax(reach->across, fmax(fabs(X.x), fabs(X.y)));
        reach->extent = fmax(reach->extent, fmax(reach->across, fabs(X.z)));
    }
}

void view_add_reach(const view *v, const roberts_vec3 *P, size_t count, scene_reach *reach)
{
    if (!v->perspective)
        return;
    reach->nearest = nearest_of(v, P, count, reach->nearest);
    add_extents(v, P, count, reach);
    const double leaks = eye_leaks(v);
    for (size_t i = 0; i < count; i++)
        reach->rounding = fmax(reach->rounding, eye_rounding(v, P[i], NULL, leaks));
}

/* Sets the bound of all view coordinates, and from it the touching distance and the rounding. */
static void set_tolerances(view *v, const roberts_scene *scene, double epsilon)
{
    double raw = fmax(vec3_largest(scene->box_min), vec3_largest(scene->box_max)) / v->unit;
    /* Rotation about the box's centre moves no point farther away than the diameter. An oblique view adds a fraction of
     * the depth. */
    v->extent = v->diameter * (1.0 + fmax(fabs(v->oblique.x), fabs(v->oblique.y)));
    scene_reach reach = scene->whole ? scene->whole->reach : (scene_reach){0};
    if (v->perspective && !scene->whole)
        add_extents(v, scene->point, scene->vertex_count, &reach);
    if (v->perspective)
        v->extent = fmax(v->extent, reach.extent);
    if (v->perspective)
        raw = fmax(raw, fmax(vec3_largest(v->viewpoint), vec3_largest(v->origin)) / v->unit);
    v->rounding = v->across_rounding = ROUNDINGS * 0.5 * DBL_EPSILON * v->extent;
    v->across = v->extent;
    if (view_at_right_angles(v))
        set_across(v, scene);
    if (v->perspective) {
        set_across_from_eye(v, scene, reach.across);
        v->plane_rounding =
            ROUNDINGS * 0.5 * DBL_EPSILON *
            fmax(v->diameter, vec3_length(vec3_scale(v->per_unit, vec3_sub(v->viewpoint, scene->centre))));
    }
    choose_epsilon(v, scene, epsilon, fmax(raw, v->extent));
}

/* Sets the direction toward the viewer, about 1 long. It keeps the given digits, so that exact arithmetic can use them.
 * In an oblique view it is computed from the map. */
static void set_sight_line(view *v, const roberts_camera *camera)
{
    int exponent;
    frexp(vec3_largest(camera->dir), &exponent);
    v->viewpoint = (roberts_vec3){ldexp(camera->dir.x, -exponent), ldexp(camera->dir.y, -exponent),
                                  ldexp(camera->dir.z, -exponent)};
    roberts_vec2 by = angle_unit(camera->roll_degrees), oblique = camera->oblique; /* rolls with the picture */
    v->oblique = (roberts_vec2){by.x * oblique.x - by.y * oblique.y, by.y * oblique.x + by.x * oblique.y};
    if (v->oblique.x != 0.0 || v->oblique.y != 0.0)
        v->viewpoint = vec3_add(v->dir, vec3_add(vec3_scale(v->oblique.x, v->right), vec3_scale(v->oblique.y, v->up)));
    v->viewpoint_depth = vec3_dot(v->viewpoint, v->dir);
}

static roberts_status check_camera(const roberts_camera *camera, double epsilon, roberts_error *error)
{
    bool perspective = camera->projection == ROBERTS_PERSPECTIVE;
    if (!(epsilon >= 0.0) || !isfinite(epsilon))
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "epsilon must be a finite length, 0 or more");
    if (perspective && (!vec3_is_finite(camera->eye) || (camera->has_look_at && !vec3_is_finite(camera->look_at))))
        return error_set(error, ROBERTS_BAD_VIEW, 0, "the eye and the look-at point must be finite");
    if (perspective && (!(camera->fov_degrees >= 0.0) || !(camera->fov_degrees < 180.0)))
        return error_set(error, ROBERTS_BAD_VIEW, 0, "the field of view must be between 0 and 180 degrees");
    if (perspective && (!(camera->near_distance >= 0.0) || !isfinite(camera->near_distance)))
        return error_set(error, ROBERTS_BAD_VIEW, 0, "the near distance must be finite and not negative");
    if (!perspective && (!vec3_is_finite(camera->dir) || vec3_largest(camera->dir) == 0.0))
        return error_set(error, ROBERTS_BAD_VIEW, 0, "the direction of view must be finite and not zero");
    if (!isfinite(camera->oblique.x) || !isfinite(camera->oblique.y) ||
        fmax(fabs(camera->oblique.x), fabs(camera->oblique.y)) > OBLIQUE_MOST)
        return error_set(error, ROBERTS_BAD_VIEW, 0, "an oblique view moves a unit of depth by no more than %g",
                         OBLIQUE_MOST);
    if (camera->has_section && (!vec3_is_finite(camera->section) || !vec3_is_finite(camera->section_normal)))
        return error_set(error, ROBERTS_BAD_VIEW, 0, "the point and the direction of the section must be finite");
    if (camera->has_section && perspective && vec3_largest(camera->section_normal) > 0.0)
        return error_set(error, ROBERTS_BAD_VIEW, 0, "from an eye, a section has no direction but the axis of sight");
    if (!vec3_is_finite(camera->up) || !isfinite(camera->roll_degrees))
        return error_set(error, ROBERTS_BAD_VIEW, 0, "the up vector and the roll must be finite");
    return ROBERTS_OK;
}

/* Does a direction point away from the viewer of a parallel view? */
static bool points_away(const view *v, roberts_vec3 n)
{
    return vec3_dot(unit_vector(n), v->viewpoint) < -AWAY * vec3_length(v->viewpoint);
}

roberts_status view_begin(view *v, const roberts_scene *scene, const roberts_camera *camera, double epsilon,
                          roberts_error *error)
{
    roberts_vec3 half = vec3_sub(vec3_scale(0.5, scene->box_max), vec3_scale(0.5, scene->box_min));
    roberts_vec3 dir = camera->dir;
    roberts_status status = check_camera(camera, epsilon, error);
    *v = (view){.origin = scene->centre, .unit = scene->unit, .per_unit = 1.0 / scene->unit, .diameter = 1.0};
    if (status != ROBERTS_OK)
        return status;
    if (vec3_largest(half) > 0.0)
        v->diameter = 2.0 * vec3_length(vec3_scale(v->per_unit, half));
    if (camera->projection == ROBERTS_PERSPECTIVE) {
        v->perspective = true;
        v->viewpoint = camera->eye;
        if (camera->has_look_at)
            v->origin = camera->look_at;
        dir = vec3_sub(camera->eye, v->origin);
        if (!vec3_is_finite(dir) || vec3_largest(dir) == 0.0)
            return error_set(error, ROBERTS_BAD_VIEW, 0, "the eye is at the point that it looks at; move one of them");
    }
    set_view_axes(v, dir, camera->up, camera->roll_degrees);
    if (v->perspective) {
        v->inverse_distance = 1.0 / eye_distance(v);
        return ROBERTS_OK;
    }
    set_sight_line(v, camera);
    if (camera->has_section && points_away(v, camera->section_normal))
        return error_set(
            error, ROBERTS_BAD_VIEW, 0,
            "the section faces away from the viewer; turn its direction round, or look from the other side");
    return ROBERTS_OK;
}

roberts_status view_prepare(view *v, const roberts_scene *scene, const roberts_camera *camera, double epsilon,
                            roberts_error *error)
{
    roberts_status status = view_begin(v, scene, camera, epsilon, error);
    if (status == ROBERTS_OK && v->perspective)
        status = check_nearest(v, scene, error);
    if (status == ROBERTS_OK)
        set_tolerances(v, scene, epsilon);
    return status;
}
