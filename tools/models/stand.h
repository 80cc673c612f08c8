/* stand.h - solids that stand on one of their faces. */
#ifndef MODELS_STAND_H
#define MODELS_STAND_H

#include <stdbool.h>

#include "body.h"

/* Adds a regular or semiregular solid, scaled, standing on the first of its faces with this many corners. The middle of
 * that face is at `at`, and its first corner lies in the direction of the unit vector from there. The face's corners
 * get exactly the height of `at`, so it lies in that plane. */
void stand_uniform(body *b, int solid, size_t corners, double scale, roberts_vec3 at, roberts_vec2 direction);

/* Adds a column or cone over a regular polygon, standing at `at`. */
void stand_round(body *b, bool pointed, uint32_t n, double radius, double height, roberts_vec3 at);

#endif
