/* slope.h - how the steepest line and the level line of a face run in the picture. */
#ifndef ROBERTS_HIDE_SLOPE_H
#define ROBERTS_HIDE_SLOPE_H

#include "view/seen.h"

/* What points up in the model: +z, or the axis along which the camera's `up` lies. A camera that looks along z has any
 * such `up`, so there it is +z. */
roberts_vec3 slope_upright(const roberts_camera *camera);

/* Fills the normal, steep, level and foot of a region of scene face `face`. upright: a unit vector. Faces in one plane
 * that are seen from the same side get the same, to within rounding. */
void slope_find(const seen *s, uint32_t face, roberts_vec3 upright, roberts_region *region);

#endif
