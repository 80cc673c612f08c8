/* shade.h - how bright a face is: J. H. Lambert's law of the cosine ("Photometria", 1760), and ambient light. */
#ifndef ROBERTS_DRAW_SHADE_H
#define ROBERTS_DRAW_SHADE_H

#include <math.h>

#include "base/vec.h"

/* The brightness of a face without light, as a fraction of the greatest. */
#define SHADE_AMBIENT 0.45

/* From SHADE_AMBIENT (the light comes from behind the face) to 1. normal: unit; light: toward the light, any length but
 * 0; both along the axes of the viewer. */
static inline double shade(roberts_vec3 normal, roberts_vec3 light)
{
    double cosine = vec3_dot(normal, light) / vec3_length(light);
    return SHADE_AMBIENT + (1.0 - SHADE_AMBIENT) * fmin(fmax(cosine, 0.0), 1.0);
}

#endif
