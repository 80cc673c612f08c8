/* plane.c - ray against a plane: "Lancer de rayons I", 1.2, proposition 2. */
#include "ray/ray.h"

bool roberts_ray_plane(roberts_ray ray, roberts_plane F, roberts_hit *hit)
{
    roberts_vec3 n = {F.a, F.b, F.c};
    double vn = vec3_dot(ray.direction, n);
    if (ray_parallel(vn, vec3_dot_size(ray.direction, n)))
        return false;
    double t = -plane_at(F, ray.origin) / vn;
    if (!(t >= 0.0 && t < INFINITY))
        return false;
    *hit = (roberts_hit){t, 0.0, 0.0, vn < 0.0 ? ROBERTS_FACING_FRONT : ROBERTS_FACING_BACK};
    return true;
}
