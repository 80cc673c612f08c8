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
} fitted_plane;

/* Fits a plane to `count` >= 3 corners in order around a face, given relative to the first one, which is 0,0,0. Lengths
 * must survive being taken to the fourth power. */
void face_plane_fit(fitted_plane *face, const roberts_vec3 *corner, uint32_t count);

#endif
