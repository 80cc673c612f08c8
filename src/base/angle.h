/* angle.h - directions at angles, the same to the last bit on every machine. */
#ifndef ROBERTS_BASE_ANGLE_H
#define ROBERTS_BASE_ANGLE_H

#include "roberts.h"

#define PI 3.14159265358979323846

/* Returns the unit vector at `degrees`, any finite number, from the x axis. Its coordinates are the nearest doubles: 0,
 * 1/2 and 1 exactly where they belong. Angles at the same position in two quadrants give coordinates of equal absolute
 * value. */
roberts_vec2 angle_unit(double degrees);

#endif
