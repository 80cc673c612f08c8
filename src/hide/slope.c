/* slope.c - how the steepest line and the level line of a face run in the picture.
 *
 * Both go through the foot: the point of the face's plane that is nearest to the middle of the scene. So they depend on
 * the plane alone, and what is drawn along them goes on from face to face. */
#include "hide/slope.h"

#include <math.h>

/* Sine of the least angle from the horizontal at which a plane is steep anywhere. */
static const double least_slope = 1e-6;
/* In perspective a foot that is nearer to the eye than this part of the distance to the look-at point, or behind the
 * eye, is not used. */
static const double nearest_foot = 0.01;

/* Along the axes of the viewer. */
static roberts_vec3 to_viewer(const view *v, roberts_vec3 u)
{
    return (roberts_vec3){vec3_dot(u, v->right), vec3_dot(u, v->up), vec3_dot(u, v->dir)};
}

/* How far the eye is before P, as a part of its distance from the look-at point; 1 in the orthographic view. */
static double weight(const view *v, roberts_vec3 P)
{
    return 1.0 - vec3_dot(v->dir, vec3_sub(P, v->origin)) * v->per_unit * v->inverse_distance;
}

/* The derivative of the picture of P + h u by h. */
static roberts_vec2 moves(const view *v, roberts_vec3 P, roberts_vec3 u)
{
    const roberts_vec3 q = to_viewer(v, u), p = view_point(v, P); /* p is divided by the weight */
    const double w = weight(v, P), toward = q.z * v->inverse_distance;
    return (roberts_vec2){(q.x - v->oblique.x * q.z + p.x * toward) / w, (q.y - v->oblique.y * q.z + p.y * toward) / w};
}

/* The steepest direction in a plane with unit normal n. Where it is level, that is +y for an upright +z. */
static roberts_vec3 steepest(roberts_vec3 n, roberts_vec3 upright)
{
    const roberts_vec3 choices[] = {upright, {0, 1, 0}, {1, 0, 0}};
    roberts_vec3 best = {0, 0, 0};
    for (int i = 0; i < 3; i++) {
        const roberts_vec3 own = vec3_sub(choices[i], vec3_scale(vec3_dot(choices[i], n), n));
        const double length = vec3_length(own);
        if (length > least_slope)
            return vec3_scale(1.0 / length, own);
        best = own;
    }
    return best;
}

static int sign(double x)
{
    return (x > 0.0) - (x < 0.0);
}

roberts_vec3 slope_upright(const roberts_camera *camera)
{
    const roberts_vec3 up = {sign(camera->up.x), sign(camera->up.y), sign(camera->up.z)};
    const bool from_above = camera->dir.x == 0.0 && camera->dir.y == 0.0 && camera->dir.z != 0.0;
    const bool along_axis = fabs(up.x) + fabs(up.y) + fabs(up.z) == 1.0;
    return along_axis && !from_above ? up : (roberts_vec3){0, 0, 1};
}

void slope_find(const seen *s, uint32_t face, roberts_vec3 upright, roberts_region *region)
{
    const view *v = &s->view;
    const plane F = scene_plane(s->scene, face);
    const roberts_vec3 inward = {F.a, F.b, F.c};
    const double length = vec3_length(inward);
    const roberts_vec3 n = vec3_scale((s->facing[face] == VIEW_BACK ? 1.0 : -1.0) / length, inward);
    roberts_vec3 foot = vec3_add(s->scene->centre, vec3_scale(-F.d / (length * length), inward));
    if (weight(v, foot) < nearest_foot)
        foot = s->scene->point[s->scene->corner[s->scene->face_start[face]]];
    const roberts_vec3 steep = steepest(n, upright), p = view_point(v, foot);
    region->normal = to_viewer(v, n);
    region->steep = moves(v, foot, steep);
    region->level = moves(v, foot, vec3_cross(steep, n));
    region->foot = (roberts_vec2){p.x * v->unit, p.y * v->unit};
}
