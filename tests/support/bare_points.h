/* bare_points.h - faces and edges of bare points in view space, for testing tests 1 to 4. The viewer is at z =
 * +infinity, so a face seen from the front runs counter-clockwise. */
#ifndef ROBERTS_TESTS_BARE_POINTS_H
#define ROBERTS_TESTS_BARE_POINTS_H

#include <math.h>

#include "hide/tests.h"

/* Makes the space of points P, which are within `extent` of the origin. */
static inline hide_space bare_space(const roberts_vec3 *P, double epsilon, double rounding, double extent)
{
    return (hide_space){
        .P = P, .epsilon = epsilon, .across_rounding = rounding, .plain = hide_plain(4.0 * extent, epsilon, rounding)};
}

/* Makes the edge from P[a] to P[b]. */
static inline hide_edge bare_edge(const roberts_vec3 *P, uint32_t a, uint32_t b)
{
    roberts_vec3 AB = vec3_sub(P[b], P[a]);
    return (hide_edge){.A = P[a], .B = P[b], .a = a, .b = b, .length = hypot(AB.x, AB.y), .length3 = vec3_length(AB)};
}

/* Makes tests 2 to 4, one by one. False: the face hides nothing of the edge. */
static inline bool bare_tests_2_to_4(const hide_space *space, const hide_face *F, const hide_edge *e, hide_sides *sides,
                                     hide_interval *part)
{
    if (hide_test2(space, F, e)) {
        sides->tally.test2_visible++;
        return false;
    }
    return hide_by_sides(space, F, e, sides, part);
}

#endif
