/* face_plane.h - the plane of a face, fitted to all its corners. */
#ifndef ROBERTS_MODEL_FACE_PLANE_H
#define ROBERTS_MODEL_FACE_PLANE_H

#include "base/vec.h"

typedef struct fitted_plane {
    roberts_vec3 n;   /* length 1; seen from its end the corners turn counter-clockwise. 0,0,0 where there is no area */
    double mean;      /* the plane is n.(P - first corner) = mean: it passes through the mean of the corners */
    double deviation; /* greatest distance of a corner from the plane */
    double area;
    double width; /* area over greatest chord: between half of the least width and all of it */
    bool strict;  /* the face is strictly convex, decided without a tolerance */
} fitted_plane;

/* Fits a plane to `count` >= 3 corners in order around a face, given relative to the first one, which is 0,0,0. Lengths
 * must survive being taken to the fourth power. */
fitted_plane face_plane_fit(const roberts_vec3 *corner, uint32_t count);

/* What follows from the sum of the cross products, the square of the greatest chord, and the corners' heights. */
static inline fitted_plane face_plane_of(roberts_vec3 n, double length, double chord_squared, double least, double most,
                                         double mean)
{
    double area = 0.5 * length;
    return (fitted_plane){n, mean, greater(most - mean, mean - least), area, area / sqrt(chord_squared), true};
}

/* The same for the two kinds that make up nearly all faces, without loops: a third of the instructions. */
static inline fitted_plane face_plane_of_triangle(roberts_vec3 a, roberts_vec3 b)
{
    roberts_vec3 n = vec3_cross(a, b), c = vec3_sub(b, a);
    double length = vec3_length(n), ha, hb;
    if (!(length > 0.0))
        return (fitted_plane){0};
    n = (roberts_vec3){n.x / length, n.y / length, n.z / length}; /* not times 1 / length: an axis stays exact */
    ha = vec3_dot(n, a);                                          /* nothing but rounding */
    hb = vec3_dot(n, b);
    return face_plane_of(n, length, greater(greater(vec3_dot(a, a), vec3_dot(b, b)), vec3_dot(c, c)),
                         lesser(lesser(ha, hb), 0.0), greater(greater(ha, hb), 0.0), (ha + hb) / 3);
}

static inline fitted_plane face_plane_of_quadrilateral(roberts_vec3 a, roberts_vec3 b, roberts_vec3 c)
{
    roberts_vec3 ab = vec3_cross(a, b), bc = vec3_cross(b, c), n = vec3_add(ab, bc);
    roberts_vec3 p = vec3_sub(b, a), q = vec3_sub(c, b), r = vec3_sub(c, a);
    double length = vec3_length(n), ha, hb, hc, at_a, at_c, at_origin;
    fitted_plane face;
    if (!(length > 0.0))
        return (fitted_plane){0};
    n = (roberts_vec3){n.x / length, n.y / length, n.z / length};
    ha = vec3_dot(n, a);
    hb = vec3_dot(n, b);
    hc = vec3_dot(n, c);
    face = face_plane_of(n, length,
                         greater(greater(greater(vec3_dot(a, a), vec3_dot(b, b)), vec3_dot(c, c)),
                                 greater(greater(vec3_dot(p, p), vec3_dot(q, q)), vec3_dot(r, r))),
                         lesser(lesser(ha, hb), lesser(hc, 0.0)), greater(greater(ha, hb), greater(hc, 0.0)),
                         (ha + hb + hc) / 4);
    at_a = vec3_dot(n, ab); /* areas of the triangles at the four corners: four left turns make up one whole turn */
    at_c = vec3_dot(n, bc);
    at_origin = vec3_dot(n, vec3_cross(a, c));
    face.strict = at_a > 0.0 && at_c > 0.0 && at_origin > 0.0 && at_a + at_c - at_origin > 0.0;
    return face;
}

#endif
