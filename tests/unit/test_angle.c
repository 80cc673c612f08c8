/* Directions at angles are the nearest doubles, the same on every machine. */
#include <math.h>

#include "base/angle.h"
#include "testing.h"

/* Computed with 60 digits and rounded once. */
static const struct {
    double degrees, x, y;
} nearest[] = {
    {0.0, 1.0, 0.0},
    {30.0, 0.86602540378443865, 0.5},
    {45.0, 0.70710678118654752, 0.70710678118654752},
    {60.0, 0.5, 0.86602540378443865},
    {90.0, 0.0, 1.0},
    {180.0, -1.0, 0.0},
    {-90.0, 0.0, -1.0},
    {3600000030.0, 0.86602540378443865, 0.5},
    {33.7, 0.8319541221304825, 0.5548444274479993},
    {21.3, 0.9316912275855489, 0.36325123047297836},
    {1e-09, 1.0, 1.7453292519943298e-11},
    {44.999, 0.7071191224203432, 0.7070944397373548},
    {0.1, 0.9999984769132877, 0.001745328365898309},
    {67.25, 0.3867109616368206, 0.9222009716704518},
    {359.0, 0.9998476951563913, -0.01745240643728351},
    {-12.5, 0.9762960071199334, -0.21643961393810288},
    {123.456, -0.5512964442855824, 0.8343094333148066},
};

static void a_direction_is_the_nearest(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof nearest / sizeof nearest[0]; i++) {
        const roberts_vec2 got = angle_unit(nearest[i].degrees);
        if (got.x != nearest[i].x || got.y != nearest[i].y)
            fail_msg("%g degrees: %.17g, %.17g, not %.17g, %.17g", nearest[i].degrees, got.x, got.y, nearest[i].x,
                     nearest[i].y);
    }
}

/* All four quadrants have the same absolute values, and no zero is negative. */
static void quadrants_are_alike(void **state)
{
    (void)state;
    for (int i = 0; i < 3600; i++) {
        const roberts_vec2 p = angle_unit(i / 10.0), q = angle_unit(i / 10.0 + 90.0);
        if (i % 10 == 0) {
            assert_true(p.x == q.y && p.y == -q.x);
        }
        assert_false((p.x == 0.0 && signbit(p.x)) || (p.y == 0.0 && signbit(p.y)));
        assert_true(fabs(p.x * p.x + p.y * p.y - 1.0) < 4e-16);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_direction_is_the_nearest),
        cmocka_unit_test(quadrants_are_alike),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
