/* sphere.c - ray against a circle in the plane and against a sphere in two forms: "Lancer de rayons I", 2.1 to 2.3.
 *
 * The note takes v of length 1; here v has any length, with a = v . v (the note's exercise: deciding takes no square
 * root). A tangent touches at t_in = t_out. A negative radius is an empty sphere, radius 0 a point. */
#include "ray/ray.h"

/* a t^2 + 2 B t + C = 0 with B = v . OS, C = OS^2 - R^2 and the reduced discriminant B^2 - a C (proposition 7;
 * correction 2: C, not C^2). The root of larger size comes from a sum without cancellation, the other from their
 * product C / a. */
bool roberts_ray_sphere(roberts_ray ray, roberts_vec3 centre, double radius, roberts_span *span)
{
    roberts_vec3 v = ray.direction, os = vec3_sub(ray.origin, centre);
    double a = vec3_dot(v, v), b = vec3_dot(v, os), c = vec3_dot(os, os) - radius * radius;
    double discriminant = b * b - a * c;
    if (!(a > 0.0 && a < INFINITY && radius >= 0.0 && discriminant >= 0.0))
        return false;
    double q = -(b + copysign(sqrt(discriminant), b));
    double t0 = q / a, t1 = q != 0.0 ? c / q : t0; /* q = 0: both roots are 0 */
    return ray_span(fmin(t0, t1), ROBERTS_NONE, fmax(t0, t1), ROBERTS_NONE, span);
}

/* H = S + t_H v is the foot of the perpendicular from O, d = OH (proposition 8). The note's d^2 = SO^2 - (SO . v)^2
 * loses all digits where S is far from O; O - H, squared, is the same number and keeps them. */
bool roberts_ray_sphere_geometric(roberts_ray ray, roberts_vec3 centre, double radius, roberts_span *span)
{
    roberts_vec3 v = ray.direction, so = vec3_sub(centre, ray.origin);
    double a = vec3_dot(v, v), t_h = vec3_dot(so, v) / a;
    roberts_vec3 ho = vec3_sub(so, vec3_scale(t_h, v));
    double h2 = radius * radius - vec3_dot(ho, ho);
    if (!(a > 0.0 && a < INFINITY && radius >= 0.0 && h2 >= 0.0))
        return false;
    double h = sqrt(h2 / a);
    return ray_span(t_h - h, ROBERTS_NONE, t_h + h, ROBERTS_NONE, span);
}

/* The sphere's geometric form without z. */
bool roberts_ray_circle(roberts_ray2 ray, roberts_vec2 centre, double radius, roberts_span *span)
{
    roberts_ray flat = {{ray.origin.x, ray.origin.y, 0.0}, {ray.direction.x, ray.direction.y, 0.0}};
    return roberts_ray_sphere_geometric(flat, (roberts_vec3){centre.x, centre.y, 0.0}, radius, span);
}
