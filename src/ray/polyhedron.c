/* polyhedron.c - ray against a convex polyhedron: the line, cut by one half-space after the other (Cyrus and Beck). */
#include "ray/ray.h"

/* Along the ray F is F(S) + t (v . n): a plane with v . n > 0 is where the line enters, with v . n < 0 where it leaves.
 * A plane parallel to the ray keeps all of it where S is inside or on it, else nothing. */
bool roberts_ray_polyhedron(roberts_ray ray, const roberts_plane *F, size_t count, roberts_span *span)
{
    double t_in = -INFINITY, t_out = INFINITY;
    uint32_t face_in = ROBERTS_NONE, face_out = ROBERTS_NONE;
    if (!ray_has_direction(ray.direction))
        return false;
    for (size_t i = 0; i < count; i++) {
        roberts_vec3 n = {F[i].a, F[i].b, F[i].c};
        double vn = vec3_dot(ray.direction, n), inside = plane_at(F[i], ray.origin), t = -inside / vn;
        if (ray_parallel(vn, vec3_dot_size(ray.direction, n))) {
            if (!(inside >= 0.0))
                return false;
        } else if (!isfinite(t)) {
            return false;
        } else if (vn > 0.0 && t > t_in) {
            t_in = t;
            face_in = (uint32_t)i;
        } else if (vn < 0.0 && t < t_out) {
            t_out = t;
            face_out = (uint32_t)i;
        }
    }
    return ray_span(t_in, face_in, t_out, face_out, span);
}
