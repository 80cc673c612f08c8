/* segment.c - ray against a segment in the plane: "Lancer de rayons I", 1.1, proposition 1. */
#include "ray/ray.h"

/* S + t v = A + alpha AB; the dot product with n (across AB) leaves t, with m (across v) alpha. Since
 * AB . m = -(v . n), one determinant serves both. */
bool roberts_ray_segment(roberts_ray2 ray, roberts_vec2 a, roberts_vec2 b, roberts_hit *hit)
{
    roberts_vec2 v = ray.direction;
    roberts_vec2 sa = {a.x - ray.origin.x, a.y - ray.origin.y};
    roberts_vec2 n = {-(b.y - a.y), b.x - a.x}; /* (AB, n) is a direct base: n looks out of the visible side */
    roberts_vec2 m = {-v.y, v.x};
    double vn = v.x * n.x + v.y * n.y;
    if (ray_parallel(vn, fabs(v.x * n.x) + fabs(v.y * n.y)))
        return false;
    double t = (sa.x * n.x + sa.y * n.y) / vn;
    double alpha = (sa.x * m.x + sa.y * m.y) / vn;
    if (!(t >= 0.0 && alpha >= 0.0 && alpha <= 1.0 && t < INFINITY))
        return false;
    *hit = (roberts_hit){t, alpha, 0.0, vn < 0.0 ? ROBERTS_FACING_FRONT : ROBERTS_FACING_BACK};
    return true;
}
