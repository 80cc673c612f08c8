/* slope.h - how the steepest line and the level line of a face run in the picture. */
#ifndef ROBERTS_HIDE_SLOPE_H
#define ROBERTS_HIDE_SLOPE_H

#include "view/seen.h"

/* Fills the normal, steep, level and foot of a region of scene face `face`. upright: what points up in the model, of
 * any length; 0,0,0 is +z. Faces in one plane that are seen from the same side get the same, to within rounding. */
void slope_find(const seen *s, uint32_t face, roberts_vec3 upright, roberts_region *region);

#endif
