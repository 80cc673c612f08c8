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

enum { PAIRS_UP_TO = 8 }; /* corners; up to so many, all pairs are measured for the greatest chord */

static roberts_vec3 newell(const roberts_vec3 *corner, uint32_t count)
{
    roberts_vec3 sum = vec3_cross(corner[1], corner[2]);
    for (uint32_t i = 3; i < count; i++)
        sum = vec3_add(sum, vec3_cross(corner[i - 1], corner[i]));
    return sum;
}

static double chord_of_pairs(const roberts_vec3 *corner, uint32_t count)
{
    double greatest = 0.0;
    for (uint32_t i = 1; i < count; i++) {
        double squared = vec3_dot(corner[i], corner[i]);
        greatest = squared > greatest ? squared : greatest;
        for (uint32_t j = 1; j < i; j++) {
            roberts_vec3 d = vec3_sub(corner[i], corner[j]);
            squared = vec3_dot(d, d);
            greatest = squared > greatest ? squared : greatest;
        }
    }
    return sqrt(greatest);
}

/* Width of the corners' projection on u. */
static double extent(const roberts_vec3 *corner, uint32_t count, roberts_vec3 u)
{
    double least = 0.0, most = 0.0;
    for (uint32_t i = 1; i < count; i++) {
        double x = vec3_dot(u, corner[i]);
        least = x < least ? x : least;
        most = x > most ? x : most;
    }
    return most - least;
}

/* For many corners: the greatest extent along 16 directions of the plane, which is at least cos(pi / 32) > 0.995 of the
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
    return greatest;
}

/* Lets the plane pass through the mean of the corners and measures how far they lie from it. */
static void measure_deviation(fitted_plane *face, const roberts_vec3 *corner, uint32_t count, roberts_vec3 n)
{
    double sum = 0.0, least = 0.0, most = 0.0, mean;
    for (uint32_t i = 1; i < count; i++) {
        double height = vec3_dot(n, corner[i]);
        sum += height;
        least = height < least ? height : least;
        most = height > most ? height : most;
    }
    mean = sum / count;
    face->mean = mean;
    face->deviation = most - mean > mean - least ? most - mean : mean - least;
}

void face_plane_fit(fitted_plane *face, const roberts_vec3 *corner, uint32_t count)
{
    roberts_vec3 n = newell(corner, count);
    double length = vec3_length(n);
    if (!(length > 0.0)) {
        *face = (fitted_plane){{0, 0, 0}, 0, 0, 0, 0};
        return;
    }
    n = (roberts_vec3){n.x / length, n.y / length, n.z / length}; /* not times 1 / length: an axis stays exact */
    face->n = n;
    face->area = 0.5 * length;
    face->width = face->area / (count <= PAIRS_UP_TO ? chord_of_pairs(corner, count) : chord_of_extents(corner, count, n));
    measure_deviation(face, corner, count, n);
}
