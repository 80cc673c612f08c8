/* angle.c - directions at angles.
 *
 * The sine and the cosine of different C libraries differ in the last bit, which a table of 17 digits shows. So their
 * series are summed here in double-double numbers, whose error is far below half of a last bit of a double. Whole
 * quarter turns are removed first. At most an eighth of a turn remains, so 14 terms are enough, since 0.79^29 / 29! is
 * 1e-34. */
#include "base/angle.h"

#include <math.h>

#include "base/dd.h"

enum { TERMS = 14 };

static const dd radian = {0.017453292519943295, 2.9486522708701687e-19}; /* pi / 180 */

/* Returns 1 - x^2 / (n (n + 1)) (1 - x^2 / ((n + 2) (n + 3)) (1 - ...)): cos x with n = 1, sin x / x with n = 2. */
static dd series(dd x, int n)
{
    const dd one = {1.0, 0.0}, square = dd_mul(x, x);
    dd sum = one;
    for (int k = n + 2 * (TERMS - 1); k >= n; k -= 2)
        sum = dd_sub(one, dd_mul(dd_div(square, (dd){(double)k * (k + 1), 0.0}), sum));
    return sum;
}

roberts_vec2 angle_unit(double degrees)
{
    const double whole = fmod(degrees, 360.0); /* exact */
    const double quarters = nearbyint(whole / 90.0), rest = whole - 90.0 * quarters;
    const dd x = dd_mul(radian, (dd){fabs(rest), 0.0});
    const double c = series(x, 1).hi, sine = dd_mul(x, series(x, 2)).hi, s = rest < 0.0 ? -sine : sine;
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
