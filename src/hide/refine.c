/* refine.c - see refine.h. */
#include "hide/refine.h"

#include "base/dd.h"

/* Vertex a from where `from` is, in view units; low: what is to be added to that place. */
static dd3 seen_from(const hide_space *space, uint32_t a, roberts_vec3 from, roberts_vec3 low)
{
    const roberts_scene *scene = space->scene;
    double k = 1.0 / space->view->unit; /* a power of two: scaling is exact, and products stay in range */
    dd3 p = dd3_between(vec3_scale(k, scene->point[a]), vec3_scale(k, from));
    return scene->low ? dd3_add(p, dd3_from(vec3_scale(k, vec3_sub(scene->low[a], low)))) : p;
}

static dd3 between(const hide_space *space, uint32_t a, uint32_t b)
{
    roberts_vec3 none = {0.0, 0.0, 0.0};
    return seen_from(space, a, space->scene->point[b], space->scene->low ? space->scene->low[b] : none);
}

static dd3 from_eye(const hide_space *space, uint32_t a)
{
    return seen_from(space, a, space->view->viewpoint, (roberts_vec3){0.0, 0.0, 0.0});
}

/* A multiple, positive and the same for every x, of the distance of x from the sight plane through p and q. */
static dd side_determinant(const hide_space *space, uint32_t p, uint32_t q, uint32_t x)
{
    if (space->view->perspective)
        return dd_neg(dd3_dot(dd3_cross(from_eye(space, p), from_eye(space, q)), from_eye(space, x)));
    return dd3_dot(dd3_cross(between(space, q, p), between(space, x, p)), dd3_from(space->view->viewpoint));
}

double refine_side(const hide_space *space, uint32_t p, uint32_t q, uint32_t x)
{
    const view *v = space->view;
    double length = hypot(space->P[q].x - space->P[p].x, space->P[q].y - space->P[p].y);
    double determinant = side_determinant(space, p, q, x).hi;
    if (v->perspective) /* the picture's determinant of (x, y, 1) is that of (x, y, w), divided by the three w / D */
        for (int i = 0; i < 3; i++)
            determinant *= 1.0 + space->P[i == 0 ? p : i == 1 ? q : x].z * v->inverse_distance;
    return v->perspective ? determinant * v->inverse_distance / length : determinant / (v->viewpoint_depth * length);
}

static double to_picture(const hide_space *space, const hide_edge *e, double t)
{
    return view_from_space(space->view, e->A.z, e->B.z, t);
}

double refine_crossing(const hide_space *space, uint32_t p, uint32_t q, const hide_edge *e)
{
    return to_picture(space, e, dd_zero_of(side_determinant(space, p, q, e->a), side_determinant(space, p, q, e->b)));
}

double refine_pierce(const hide_space *space, const hide_face *F, const hide_edge *e)
{
    uint32_t origin = F->corner[0];
    dd3 n = {{0, 0}, {0, 0}, {0, 0}}, sum = n; /* Newell's normal, as a sum of triangles; sum of the corners */
    for (uint32_t i = 0; i < F->count; i++) {
        dd3 p = between(space, F->corner[i], origin);
        n = dd3_add(n, dd3_cross(p, between(space, F->corner[(i + 1) % F->count], origin)));
        sum = dd3_add(sum, p);
    }
    /* n . (X - mean of the corners), times their count */
    dd count = {F->count, 0.0}, offset = dd3_dot(n, sum);
    dd a = dd_sub(dd_mul(count, dd3_dot(n, between(space, e->a, origin))), offset);
    dd b = dd_sub(dd_mul(count, dd3_dot(n, between(space, e->b, origin))), offset);
    return to_picture(space, e, dd_zero_of(a, b));
}
