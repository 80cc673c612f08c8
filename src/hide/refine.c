/* refine.c - signs and crossings from the coordinates as read. See refine.h. */
#include "hide/refine.h"

#include "base/dd.h"
#include "hide/tolerance.h"

/* Returns the position of a vertex. */
static seen_point vertex_point(const hide_space *space, uint32_t a)
{
    const roberts_scene *scene = space->scene;
    return (seen_point){scene->point[a], scene->low ? scene->low[a] : (roberts_vec3){0.0, 0.0, 0.0}};
}

static seen_point refine_place(const hide_space *space, refine_point x)
{
    return x.vertex == ROBERTS_NONE ? *x.place : vertex_point(space, x.vertex);
}

/* Returns b - a in view units. */
static dd3 between(const hide_space *space, seen_point b, seen_point a)
{
    double k = 1.0 / space->view->unit; /* a power of two: scaling is exact, and products stay in range */
    dd3 p = dd3_between(vec3_scale(k, b.point), vec3_scale(k, a.point));
    return dd3_add(p, dd3_from(vec3_scale(k, vec3_sub(b.low, a.low))));
}

static dd3 from_eye(const hide_space *space, seen_point a)
{
    return between(space, a, (seen_point){.point = space->view->viewpoint});
}

/* The sight plane through p and q. */
typedef struct sight_plane {
    seen_point P, Q;
    dd3 normal; /* perspective: (P - V) x (Q - V), the same for every X */
} sight_plane;

static sight_plane sight_plane_through(const hide_space *space, uint32_t p, uint32_t q)
{
    sight_plane s = {.P = vertex_point(space, p), .Q = vertex_point(space, q)};
    if (space->view->perspective)
        s.normal = dd3_cross(from_eye(space, s.P), from_eye(space, s.Q));
    return s;
}

/* Returns a multiple of the distance of X from the sight plane. The factor is positive and the same for every X. */
static dd side_determinant(const hide_space *space, const sight_plane *s, seen_point X)
{
    if (space->view->perspective)
        return dd_neg(dd3_dot(s->normal, from_eye(space, X)));
    return dd3_dot(dd3_cross(between(space, s->Q, s->P), between(space, X, s->P)), dd3_from(space->view->viewpoint));
}

/* The distance of x from the line through p and q in the picture, divided by the determinant. */
static double per_determinant(const hide_space *space, uint32_t p, uint32_t q, refine_point x)
{
    const view *v = space->view;
    double length = hypot(space->P[q].x - space->P[p].x, space->P[q].y - space->P[p].y);
    if (!v->perspective)
        return 1.0 / (v->viewpoint_depth * length);
    /* the picture's determinant of rows (x, y, 1) is that of rows (x, y, w), divided by the three w / D */
    const double z[] = {space->P[p].z, space->P[q].z, x.z};
    double scale = v->inverse_distance / length;
    for (int i = 0; i < 3; i++)
        scale *= 1.0 + z[i] * v->inverse_distance;
    return scale;
}

double refine_side(const hide_space *space, uint32_t p, uint32_t q, refine_point x)
{
    const sight_plane sight = sight_plane_through(space, p, q);
    return side_determinant(space, &sight, refine_place(space, x)).hi * per_determinant(space, p, q, x);
}

/* ---- the same in doubles ---- */

/* A vector in doubles, and the sizes of its components. Errors are fractions of these sizes. */
typedef struct near3 {
    roberts_vec3 is, size;
} near3;

/* Returns b - a in view units. Each component is off by at most two half epsilons of its size. */
static inline near3 gap(const hide_space *space, const seen_point *b, const seen_point *a)
{
    const double k = space->view->per_unit;
    roberts_vec3 high = vec3_scale(k, vec3_sub(b->point, a->point)), low = vec3_scale(k, vec3_sub(b->low, a->low));
    return (near3){vec3_add(high, low),
                   {fabs(high.x) + fabs(low.x), fabs(high.y) + fabs(low.y), fabs(high.z) + fabs(low.z)}};
}

/* The sight plane through P and Q: its normal is the ray through P times PQ. */
typedef struct near_plane {
    seen_point P;
    near3 normal;
} near_plane;

static near_plane plane_nearly(const hide_space *space, uint32_t p, uint32_t q)
{
    near_plane s = {.P = vertex_point(space, p)};
    const seen_point Q = vertex_point(space, q), eye = {.point = space->view->viewpoint};
    const near3 along = gap(space, &Q, &s.P);
    near3 ray = {eye.point, {fabs(eye.point.x), fabs(eye.point.y), fabs(eye.point.z)}};
    if (space->view->perspective)
        ray = gap(space, &eye, &s.P);
    s.normal.is = vec3_cross(ray.is, along.is);
    s.normal.size = (roberts_vec3){ray.size.y * along.size.z + ray.size.z * along.size.y,
                                   ray.size.z * along.size.x + ray.size.x * along.size.z,
                                   ray.size.x * along.size.y + ray.size.y * along.size.x};
    return s;
}

/* The same determinant as side_determinant() finds. */
static refine_near determinant_nearly(const hide_space *space, const near_plane *s, const seen_point *X)
{
    const near3 to = gap(space, X, &s->P);
    return (refine_near){vec3_dot(s->normal.is, to.is), REFINE_ROUNDINGS * vec3_dot(s->normal.size, to.size)};
}

refine_near refine_side_nearly(const hide_space *space, uint32_t p, uint32_t q, refine_point x)
{
    const near_plane s = plane_nearly(space, p, q);
    const seen_point X = refine_place(space, x);
    const refine_near d = determinant_nearly(space, &s, &X);
    const double scale = per_determinant(space, p, q, x);
    return (refine_near){d.value * scale, d.error * fabs(scale)};
}

/* In the picture, the distances of A and B from the line are these determinants times 1 / w, up to a common factor. */
bool refine_crossing_nearly(const hide_space *space, uint32_t p, uint32_t q, const hide_edge *e, double *t)
{
    const near_plane s = plane_nearly(space, p, q);
    const seen_point A = refine_place(space, refine_start(e)), B = refine_place(space, refine_end(e));
    const refine_near a = determinant_nearly(space, &s, &A), b = determinant_nearly(space, &s, &B);
    const double near_a = 1.0 + e->A.z * space->view->inverse_distance;
    const double near_b = 1.0 + e->B.z * space->view->inverse_distance;
    const double from = a.value * near_a, apart = from - b.value * near_b;
    *t = from / apart;
    return hide_accurate(space, e, (a.error * near_a + b.error * near_b) / fabs(apart));
}

static double to_picture(const hide_space *space, const hide_edge *e, double t)
{
    return view_from_space(space->view, e->A.z, e->B.z, t);
}

double refine_crossing(const hide_space *space, uint32_t p, uint32_t q, const hide_edge *e)
{
    const sight_plane sight = sight_plane_through(space, p, q);
    const dd a = side_determinant(space, &sight, refine_place(space, refine_start(e)));
    const dd b = side_determinant(space, &sight, refine_place(space, refine_end(e)));
    return to_picture(space, e, dd_zero_of(a, b));
}

double refine_pierce(const hide_space *space, const hide_face *F, const hide_edge *e)
{
    seen_point origin = vertex_point(space, F->corner[0]);
    seen_point A = refine_place(space, refine_start(e)), B = refine_place(space, refine_end(e));
    dd3 n = {{0, 0}, {0, 0}, {0, 0}}, sum = n; /* Newell's normal as a sum of triangles; the sum of the corners */
    for (uint32_t i = 0; i < F->count; i++) {
        dd3 p = between(space, vertex_point(space, F->corner[i]), origin);
        dd3 q = between(space, vertex_point(space, F->corner[(i + 1) % F->count]), origin);
        n = dd3_add(n, dd3_cross(p, q));
        sum = dd3_add(sum, p);
    }
    /* n . (X - mean of the corners), times the number of corners */
    dd count = {F->count, 0.0}, offset = dd3_dot(n, sum);
    dd a = dd_sub(dd_mul(count, dd3_dot(n, between(space, A, origin))), offset);
    dd b = dd_sub(dd_mul(count, dd3_dot(n, between(space, B, origin))), offset);
    return to_picture(space, e, dd_zero_of(a, b));
}
