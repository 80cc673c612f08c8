/* face_plane.c - the plane of a face, fitted to all its corners by Newell's method.
 *
 * The normal is the sum of the cross products round the polygon. Its components are twice the areas of the three
 * projections. Source: I. E. Sutherland, R. F. Sproull, R. A. Schumacker, "A characterization of ten hidden-surface
 * algorithms", Computing Surveys 6(1), 1974, where the method is credited to M. Newell. All corners are relative to the
 * first one, so nothing is lost far from the origin, and a face parallel to a coordinate plane gets an exact normal.
 *
 * The plane passes through the mean of the corners. Three corners lie in their plane up to rounding; in a narrow
 * triangle even that deviation matters. */
#include "model/face_plane.h"

#include "base/angle.h"
#include "model/convex.h"

enum { PAIRS_UP_TO = 8 }; /* corners; up to this many, the greatest chord is found by measuring all pairs */

static roberts_vec3 newell(const roberts_vec3 *corner, uint32_t count)
{
    roberts_vec3 sum = vec3_cross(corner[1], corner[2]);
    for (uint32_t i = 3; i < count; i++)
        sum = vec3_add(sum, vec3_cross(corner[i - 1], corner[i]));
    return sum;
}

/* Returns the square of the greatest distance between two corners. */
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

/* Returns the extent of the corners along u. */
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

/* Returns the greatest chord of a face of many corners, approximately: the greatest extent along 16 directions of the
 * plane. It never exceeds the greatest chord, and is at least cos(pi / 32) > 0.995 of it. */
static double chord_of_extents(const roberts_vec3 *corner, uint32_t count, roberts_vec3 n)
{
    roberts_vec3 axis = fabs(n.x) < 0.6 ? (roberts_vec3){1, 0, 0} : (roberts_vec3){0, 1, 0}, u, v;
    double greatest = 0.0;
    u = vec3_cross(axis, n);
    u = vec3_scale(1.0 / vec3_length(u), u);
    v = vec3_cross(n, u);
    for (int k = 0; k < 16; k++) {
        double angle = k * (PI / 16);
        roberts_vec3 w = vec3_add(vec3_scale(cos(angle), u), vec3_scale(sin(angle), v));
        greatest = fmax(greatest, extent(corner, count, w));
    }
    return greatest * greatest;
}

/* Returns the first lane. */
static fitted_plane lane_of(const two_planes *faces)
{
    double values[7], other;
    if (faces->empty & 1)
        return (fitted_plane){0};
    two_part(&values[0], &other, faces->n.x);
    two_part(&values[1], &other, faces->n.y);
    two_part(&values[2], &other, faces->n.z);
    two_part(&values[3], &other, faces->mean);
    two_part(&values[4], &other, faces->deviation);
    two_part(&values[5], &other, faces->area);
    two_part(&values[6], &other, faces->width);
    return (fitted_plane){
        {values[0], values[1], values[2]}, values[3], values[4], values[5], values[6], faces->strict & 1};
}

fitted_plane face_plane_fit(const roberts_vec3 *corner, uint32_t count)
{
    double length, sum = 0.0, least = 0.0, most = 0.0, chord_squared;
    roberts_vec3 n;
    if (count == 3) {
        two_planes same = two_planes_of_triangles(two_vec3_all(corner[1]), two_vec3_all(corner[2]));
        return lane_of(&same);
    }
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
    chord_squared = count <= PAIRS_UP_TO ? chord_of_pairs(corner, count) : chord_of_extents(corner, count, n);
    return (fitted_plane){.n = n,
                          .mean = sum / count,
                          .deviation = greater(most - sum / count, sum / count - least),
                          .area = 0.5 * length,
                          .width = 0.5 * length / sqrt(chord_squared),
                          .strict = polygon_strictly_convex(corner, count, n)};
}
