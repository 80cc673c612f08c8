/* face_plane.c - the plane of a face, fitted to all its corners by Newell's method.
 *
 * Source: I. E. Sutherland, R. F. Sproull, R. A. Schumacker, "A characterization of ten hidden-surface algorithms",
 * Computing Surveys 6(1), 1974, where the method is credited to M. Newell: the normal is the sum of the cross products
 * round the polygon, its components twice the areas of the three projections. Taken relative to the first corner, so
 * that nothing is lost far from the origin, and a face parallel to a coordinate plane gets an exact normal.
 *
 * The plane passes through the mean of the corners. Three corners lie in theirs up to rounding, which in a narrow triangle
 * is worth knowing. */
#include "model/face_plane.h"

#include "model/face_polygon.h"

enum { PAIRS_UP_TO = 8 }; /* corners; up to so many, all pairs are measured for the greatest chord */

static roberts_vec3 newell(const roberts_vec3 *corner, uint32_t count)
{
    roberts_vec3 sum = vec3_cross(corner[1], corner[2]);
    for (uint32_t i = 3; i < count; i++)
        sum = vec3_add(sum, vec3_cross(corner[i - 1], corner[i]));
    return sum;
}

/* The square of the greatest distance of two corners. */
static double chord_of_pairs(const roberts_vec3 *corner, uint32_t count)
{
    double greatest = 0.0;
    for (uint32_t i = 1; i < count; i++)
        for (uint32_t j = 0; j < i; j++) {
            roberts_vec3 d = vec3_sub(corner[i], corner[j]);
            greatest = greater(greatest, vec3_dot(d, d));
        }
    return greatest;
}

/* Width of the corners' projection on u. */
static double extent(const roberts_vec3 *corner, uint32_t count, roberts_vec3 u)
{
    double least = 0.0, most = 0.0;
    for (uint32_t i = 1; i < count; i++) {
        double x = vec3_dot(u, corner[i]);
        least = lesser(least, x);
        most = greater(most, x);
    }
    return most - least;
}

/* The same for many corners: the greatest extent along 16 directions of the plane, which is at least cos(pi / 32) > 0.995 of the
 * greatest chord, and never more than it. */
static double chord_of_extents(const roberts_vec3 *corner, uint32_t count, roberts_vec3 n)
{
    roberts_vec3 axis = fabs(n.x) < 0.6 ? (roberts_vec3){1, 0, 0} : (roberts_vec3){0, 1, 0}, u, v;
    double greatest = 0.0;
    u = vec3_cross(axis, n);
    u = vec3_scale(1.0 / vec3_length(u), u);
    v = vec3_cross(n, u);
    for (int k = 0; k < 16; k++) {
        double angle = k * (3.14159265358979323846 / 16);
        roberts_vec3 w = vec3_add(vec3_scale(cos(angle), u), vec3_scale(sin(angle), v));
        greatest = fmax(greatest, extent(corner, count, w));
    }
    return greatest * greatest;
}

fitted_plane face_plane_fit(const roberts_vec3 *corner, uint32_t count)
{
    double length, sum = 0.0, least = 0.0, most = 0.0;
    roberts_vec3 n;
    fitted_plane face;
    if (count == 3)
        return face_plane_of_triangle(corner[1], corner[2]);
    n = newell(corner, count);
    length = vec3_length(n);
    if (!(length > 0.0))
        return (fitted_plane){0};
    n = (roberts_vec3){n.x / length, n.y / length, n.z / length};
    for (uint32_t i = 1; i < count; i++) {
        double height = vec3_dot(n, corner[i]);
        sum += height;
        least = lesser(least, height);
        most = greater(most, height);
    }
    face = face_plane_of(n, length,
                         count <= PAIRS_UP_TO ? chord_of_pairs(corner, count) : chord_of_extents(corner, count, n),
                         least, most, sum / count);
    face.strict = polygon_strictly_convex(corner, count, n);
    return face;
}
