/* angle.h - angles in degrees, exact where their sines are: views are seldom turned by anything but 30, 45 or 90. */
#ifndef ROBERTS_BASE_ANGLE_H
#define ROBERTS_BASE_ANGLE_H

#include "base/vec.h"

/* The unit vector at `degrees` from the x axis, any finite number. Its coordinates are the doubles nearest to them at all
 * multiples of 30 and 45 degrees (0, 1/2 and 1 exactly), and of one size where the angles lie alike in two quadrants. */
static inline roberts_vec2 angle_unit(double degrees)
{
    double whole = fmod(degrees, 360.0); /* exact */
    double quarters = nearbyint(whole / 90.0), rest = whole - 90.0 * quarters, a = fabs(rest), c, s;
    if (a == 0.0 || a == 30.0 || a == 45.0) {
        c = a == 0.0 ? 1.0 : a == 30.0 ? 0.86602540378443865 : 0.70710678118654752;
        s = a == 0.0 ? 0.0 : a == 30.0 ? 0.5 : 0.70710678118654752;
    } else {
        c = cos(a * (3.14159265358979323846 / 180.0));
        s = sin(a * (3.14159265358979323846 / 180.0));
    }
    s = rest < 0.0 ? -s : s;
    switch (((int)quarters + 4) % 4) {
    case 0:
        return (roberts_vec2){c, s};
    case 1:
        return (roberts_vec2){0.0 - s, c};
    case 2:
        return (roberts_vec2){0.0 - c, 0.0 - s};
    default:
        return (roberts_vec2){s, 0.0 - c};
    }
}

#endif
