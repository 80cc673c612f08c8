/* triangle.c - ray against a triangle in three forms.
 *
 * S + t v = A + alpha AB + beta AC. The forms differ in how they solve this; all agree on the determinant (v . n with
 * n = AB x AC, up to its sign), on its smallness (relative to its six terms) and on the closed triangle alpha >= 0,
 * beta >= 0, alpha + beta <= 1, t >= 0. */
#include "ray/ray.h"

static bool hit_triangle(double t, double alpha, double beta, double vn, roberts_hit *hit)
{
    if (!(t >= 0.0 && alpha >= 0.0 && beta >= 0.0 && alpha + beta <= 1.0 && t < INFINITY))
        return false;
    *hit = (roberts_hit){t, alpha, beta, vn < 0.0 ? ROBERTS_FACING_FRONT : ROBERTS_FACING_BACK};
    return true;
}

/* "Lancer de rayons I", 1.3, proposition 3; beta with . v in its numerator, as in its proof (correction 1). */
bool roberts_ray_triangle(roberts_ray ray, roberts_vec3 a, roberts_vec3 b, roberts_vec3 c, roberts_hit *hit)
{
    roberts_vec3 v = ray.direction, sa = vec3_sub(a, ray.origin);
    roberts_vec3 ab = vec3_sub(b, a), ac = vec3_sub(c, a), n = vec3_cross(ab, ac);
    double vn = vec3_dot(v, n);
    if (ray_parallel(vn, vec3_triple_size(ab, ac, v)))
        return false;
    double t = vec3_dot(sa, n) / vn;
    double alpha = -vec3_dot(vec3_cross(sa, ac), v) / vn;
    double beta = vec3_dot(vec3_cross(sa, ab), v) / vn;
    return hit_triangle(t, alpha, beta, vn, hit);
}

/* "Prienik luca s objektami", Moeller-Trumbore, in the note's letters; its a = e1 . (d x e2) is -(v . n). Correction 2:
 * a is compared relative to its terms, not with 0. */
bool roberts_ray_triangle_mt(roberts_ray ray, roberts_vec3 a, roberts_vec3 b, roberts_vec3 c, roberts_hit *hit)
{
    roberts_vec3 d = ray.direction, e1 = vec3_sub(b, a), e2 = vec3_sub(c, a);
    roberts_vec3 h = vec3_cross(d, e2);
    double determinant = vec3_dot(e1, h);
    if (ray_parallel(determinant, vec3_triple_size(d, e2, e1)))
        return false;
    double f = 1.0 / determinant;
    roberts_vec3 s = vec3_sub(ray.origin, a);
    double u = f * vec3_dot(s, h);
    if (!(u >= 0.0 && u <= 1.0))
        return false;
    roberts_vec3 q = vec3_cross(s, e1);
    return hit_triangle(f * vec3_dot(e2, q), u, f * vec3_dot(d, q), -determinant, hit);
}

/* "Prienik luca s objektami": P in the plane first, then w = P - V0 in the base (u, v) of the sides, where v is the side
 * V2 - V0 and not the ray (correction 1). */
bool roberts_ray_triangle_barycentric(roberts_ray ray, roberts_vec3 a, roberts_vec3 b, roberts_vec3 c, roberts_hit *hit)
{
    roberts_vec3 u = vec3_sub(b, a), v = vec3_sub(c, a), n = vec3_cross(u, v);
    double dn = vec3_dot(ray.direction, n);
    if (ray_parallel(dn, vec3_triple_size(u, v, ray.direction)))
        return false;
    double r = vec3_dot(n, vec3_sub(a, ray.origin)) / dn;
    roberts_vec3 w = vec3_sub(ray_at(ray, r), a);
    double uu = vec3_dot(u, u), uv = vec3_dot(u, v), vv = vec3_dot(v, v), wu = vec3_dot(w, u), wv = vec3_dot(w, v);
    double gram = uv * uv - vv * uu; /* -(n . n) */
    return hit_triangle(r, (uv * wv - vv * wu) / gram, (uv * wu - uu * wv) / gram, dn, hit);
}
