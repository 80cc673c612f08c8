/* test_ray.c - the ray kernel: the propositions of the notes as properties, its forms against each other on random
 * rays, special positions by table. */
#include <math.h>
#include <stdio.h>

#include "base/vec.h"
#include "rng.h"
#include "roberts.h"
#include "testing.h"

#define FRONT ROBERTS_FACING_FRONT
#define BACK ROBERTS_FACING_BACK
#define NONE ROBERTS_NONE
#define COUNT(a) (sizeof(a) / sizeof(a)[0])
#define INF INFINITY
#define MISS                                                                                                           \
    {                                                                                                                  \
        0, 0, 0, FRONT, 0                                                                                              \
    }
#define PI 3.14159265358979323846

/* ---- random shapes --------------------------------------------------------------------------------------------- */

static roberts_vec2 draw_vec2(rng *r, double size)
{
    double x = rng_between(r, -size, size), y = rng_between(r, -size, size);
    return (roberts_vec2){x, y};
}

/* A ray from around the origin, with a direction whose length spans six decades. */
static roberts_ray draw_ray(rng *r)
{
    roberts_ray ray = {rng_vec3(r, 3.0), rng_vec3(r, 1.0)};
    ray.direction = vec3_scale(pow(10.0, rng_between(r, -3.0, 3.0)), ray.direction);
    return ray;
}

static roberts_vec3 along(roberts_ray ray, double t)
{
    return vec3_add(ray.origin, vec3_scale(t, ray.direction));
}

static void check_close(const char *what, double found, double expected, double tolerance)
{
    if (!(fabs(found - expected) <= tolerance))
        fail_msg("%s: found %.17g, expected %.17g (within %.3g)", what, found, expected, tolerance);
}

static void check_hit(const char *name, bool met, roberts_hit hit, bool expected, double t, roberts_facing facing)
{
    if (met != expected)
        fail_msg("%s: %s", name, met ? "met" : "missed");
    if (met && (hit.t != t || hit.facing != facing))
        fail_msg("%s: t %.17g (expected %.17g), facing %d (expected %d)", name, hit.t, t, (int)hit.facing, (int)facing);
}

static void check_span(const char *name, bool met, roberts_span span, bool expected, roberts_span wanted)
{
    if (met != expected)
        fail_msg("%s: %s", name, met ? "met" : "missed");
    if (met && (span.t_in != wanted.t_in || span.t_out != wanted.t_out || span.t != wanted.t ||
                span.facing != wanted.facing || span.face != wanted.face))
        fail_msg("%s: [%g, %g] t %g facing %d face %u, expected [%g, %g] t %g facing %d face %u", name, span.t_in,
                 span.t_out, span.t, (int)span.facing, (unsigned)span.face, wanted.t_in, wanted.t_out, wanted.t,
                 (int)wanted.facing, (unsigned)wanted.face);
}

/* ---- segment --------------------------------------------------------------------------------------------------- */

/* Segment from (0, 0) to (4, 0): n looks up, so rays from above meet its front. */
static const struct {
    const char *name;
    roberts_vec2 s, v;
    bool met;
    double t;
    roberts_facing facing;
} segment_cases[] = {
    {"from above", {1, 2}, {0, -1}, true, 2, FRONT},
    {"from below", {1, -2}, {0, 1}, true, 2, BACK},
    {"v of length 8", {1, 2}, {0, -8}, true, 0.25, FRONT},
    {"behind the source", {1, 2}, {0, 1}, false, 0, FRONT},
    {"through A", {0, 2}, {0, -1}, true, 2, FRONT},
    {"through B", {2, 2}, {1, -1}, true, 2, FRONT},
    {"just past B", {4.000000001, 2}, {0, -1}, false, 0, FRONT},
    {"source on the segment, downward", {3, 0}, {0, -1}, true, 0, FRONT},
    {"source on the segment, upward", {3, 0}, {1, 1}, true, 0, BACK},
    {"source at A", {0, 0}, {1, 1}, true, 0, BACK},
    {"parallel, beside", {-1, 1}, {1, 0}, false, 0, FRONT},
    {"along the segment", {-1, 0}, {1, 0}, false, 0, FRONT},
    {"no direction", {1, 0}, {0, 0}, false, 0, FRONT},
    {"not a number", {1, NAN}, {0, -1}, false, 0, FRONT},
    {"infinite direction", {1, 1}, {0, -INF}, false, 0, FRONT},
};

static void test_segment_table(void **state)
{
    (void)state;
    for (size_t i = 0; i < COUNT(segment_cases); i++) {
        roberts_hit hit = {0};
        roberts_ray2 ray = {segment_cases[i].s, segment_cases[i].v};
        bool met = roberts_ray_segment(ray, (roberts_vec2){0, 0}, (roberts_vec2){4, 0}, &hit);
        check_hit(segment_cases[i].name, met, hit, segment_cases[i].met, segment_cases[i].t, segment_cases[i].facing);
    }
    roberts_hit hit;
    roberts_ray2 down = {{1, 1}, {0, -1}};
    assert_false(
        roberts_ray_segment(down, (roberts_vec2){1, 0}, (roberts_vec2){1, 0}, &hit)); /* a segment of length 0 */
    roberts_ray2 third = {{0, 0}, {1.0 / 3, 0.1}}; /* parallel but for the rounding of 1/3 and 0.1 */
    assert_false(roberts_ray_segment(third, (roberts_vec2){1.0 / 3, 0.1}, (roberts_vec2){1, 0.3}, &hit));
}

/* Proposition 1: S + t v and A + alpha AB are the same point; met exactly where the lines cross at t >= 0 and alpha in
 * [0, 1]; the other side is seen by the ray turned round or the segment turned round. */
static void test_segment_properties(void **state)
{
    rng r = {1};
    size_t hits = 0;
    (void)state;
    for (int i = 0; i < 200000; i++) {
        roberts_ray2 ray = {draw_vec2(&r, 3.0), draw_vec2(&r, 1.0)};
        roberts_vec2 a = draw_vec2(&r, 3.0), b = draw_vec2(&r, 3.0);
        roberts_hit hit, turned;
        bool met = roberts_ray_segment(ray, a, b, &hit);
        assert_int_equal(met, roberts_ray_segment(ray, b, a, &turned));
        /* The ray separates A from B, and the segment's line lies ahead: by orientations alone. */
        roberts_vec2 v = ray.direction, sa = {a.x - ray.origin.x, a.y - ray.origin.y},
                     sb = {b.x - ray.origin.x, b.y - ray.origin.y};
        double oa = v.x * sa.y - v.y * sa.x, ob = v.x * sb.y - v.y * sb.x, os = sa.x * sb.y - sa.y * sb.x;
        if (fabs(oa) > 1e-12 && fabs(ob) > 1e-12 && fabs(os) > 1e-12)
            assert_int_equal(met, (oa > 0) != (ob > 0) && (os > 0) == (ob > oa));
        if (!met)
            continue;
        hits++;
        double size = 1e-13 * (10 + hit.t) / fabs((ob - oa) / (hypot(v.x, v.y) + 1e-3));
        check_close("x", ray.origin.x + hit.t * v.x, a.x + hit.alpha * (b.x - a.x), size);
        check_close("y", ray.origin.y + hit.t * v.y, a.y + hit.alpha * (b.y - a.y), size);
        assert_true(hit.facing != turned.facing);
        check_close("alpha from B", turned.alpha, 1.0 - hit.alpha, size);
    }
    assert_true(hits > 20000);
}

/* ---- plane ----------------------------------------------------------------------------------------------------- */

static const struct {
    const char *name;
    roberts_vec3 s, v;
    roberts_plane F;
    bool met;
    double t;
    roberts_facing facing;
} plane_cases[] = {
    {"from above", {0, 0, 3}, {0, 0, -1}, {0, 0, 1, -1}, true, 2, FRONT},
    {"from below", {0, 0, -3}, {0, 0, 1}, {0, 0, 1, -1}, true, 4, BACK},
    {"normal of length 5", {0, 0, 3}, {0, 0, -1}, {0, 0, 5, -5}, true, 2, FRONT},
    {"normal turned", {0, 0, 3}, {0, 0, -1}, {0, 0, -1, 1}, true, 2, BACK},
    {"behind", {0, 0, 3}, {0, 0, 1}, {0, 0, 1, -1}, false, 0, FRONT},
    {"source on it", {5, 7, 1}, {1, 0, -1}, {0, 0, 1, -1}, true, 0, FRONT},
    {"parallel", {0, 0, 3}, {1, 1, 0}, {0, 0, 1, -1}, false, 0, FRONT},
    {"within", {0, 0, 1}, {1, 1, 0}, {0, 0, 1, -1}, false, 0, FRONT},
    {"parallel but for rounding", {0, 0, 3}, {0.1, 0.2, -0.3}, {1, 1, 1, 0}, false, 0, FRONT},
    {"no normal", {0, 0, 3}, {0, 0, -1}, {0, 0, 0, 1}, false, 0, FRONT},
    {"not a number", {0, 0, 3}, {0, 0, -1}, {0, 0, 1, NAN}, false, 0, FRONT},
};

static void test_plane_table(void **state)
{
    (void)state;
    for (size_t i = 0; i < COUNT(plane_cases); i++) {
        roberts_hit hit = {0};
        roberts_ray ray = {plane_cases[i].s, plane_cases[i].v};
        bool met = roberts_ray_plane(ray, plane_cases[i].F, &hit);
        check_hit(plane_cases[i].name, met, hit, plane_cases[i].met, plane_cases[i].t, plane_cases[i].facing);
    }
}

/* Proposition 2: the point S + t v satisfies the plane's equation, and the sign of F(S) gives the side that is met. */
static void test_plane_properties(void **state)
{
    rng r = {2};
    (void)state;
    for (int i = 0; i < 100000; i++) {
        roberts_ray ray = draw_ray(&r);
        roberts_vec3 n = rng_vec3(&r, 1.0);
        roberts_plane F = {n.x, n.y, n.z, rng_between(&r, -2.0, 2.0)};
        roberts_hit hit;
        double at = plane_at(F, ray.origin), vn = vec3_dot(n, ray.direction);
        bool met = roberts_ray_plane(ray, F, &hit);
        assert_int_equal(met, (at > 0) == (vn < 0));
        if (!met)
            continue;
        check_close("F(P)", plane_at(F, along(ray, hit.t)), 0.0, 1e-14 * (10 + hit.t * vec3_length(ray.direction)));
        assert_int_equal(hit.facing, at > 0 ? FRONT : BACK);
    }
}

/* ---- triangle -------------------------------------------------------------------------------------------------- */

typedef bool triangle_fn(roberts_ray, roberts_vec3, roberts_vec3, roberts_vec3, roberts_hit *);
static const struct {
    const char *name;
    triangle_fn *meets;
} triangle_forms[] = {{"cross products", roberts_ray_triangle},
                      {"Moeller-Trumbore", roberts_ray_triangle_mt},
                      {"barycentric", roberts_ray_triangle_barycentric}};

/* Triangle (0, 0, 0), (4, 0, 0), (0, 4, 0): AB x AC looks up. */
static const struct {
    const char *name;
    roberts_vec3 s, v;
    bool met;
    double t;
    roberts_facing facing;
} triangle_cases[] = {
    {"front", {1, 1, 3}, {0, 0, -1}, true, 3, FRONT},
    {"back", {1, 1, -3}, {0, 0, 2}, true, 1.5, BACK},
    {"behind", {1, 1, 3}, {0, 0, 1}, false, 0, FRONT},
    {"source within", {1, 1, 0}, {0, 0, -1}, true, 0, FRONT},
    {"through A", {0, 0, 1}, {0, 0, -1}, true, 1, FRONT},
    {"through B", {4, 0, 1}, {0, 0, -1}, true, 1, FRONT},
    {"through C", {0, 4, 1}, {0, 0, -1}, true, 1, FRONT},
    {"through AB", {2, 0, 1}, {0, 0, -1}, true, 1, FRONT},
    {"through AC", {0, 2, 1}, {0, 0, -1}, true, 1, FRONT},
    {"through BC", {2, 2, 1}, {0, 0, -1}, true, 1, FRONT},
    {"beside AB", {2, -0x1p-40, 1}, {0, 0, -1}, false, 0, FRONT},
    {"beside AC", {-0x1p-40, 2, 1}, {0, 0, -1}, false, 0, FRONT},
    {"beside BC", {2, 2 + 0x1p-40, 1}, {0, 0, -1}, false, 0, FRONT},
    {"beyond B on line AB", {5, 0, 1}, {0, 0, -1}, false, 0, FRONT},
    {"parallel above", {-1, 1, 1}, {1, 0, 0}, false, 0, FRONT},
    {"in its plane", {-1, 1, 0}, {1, 0, 0}, false, 0, FRONT},
    {"in its plane from within", {1, 1, 0}, {1, 0, 0}, false, 0, FRONT},
    {"grazing", {1, 1, 0x1p-30}, {1, 0, -0x1p-30}, true, 1, FRONT},
    {"no direction", {1, 1, 0}, {0, 0, 0}, false, 0, FRONT},
    {"not a number", {1, 1, 1}, {0, NAN, -1}, false, 0, FRONT},
    {"infinite", {1, 1, 1}, {0, 0, -INF}, false, 0, FRONT},
};

static void test_triangle_table(void **state)
{
    const roberts_vec3 a = {0, 0, 0}, b = {4, 0, 0}, c = {0, 4, 0};
    (void)state;
    for (size_t k = 0; k < COUNT(triangle_forms); k++)
        for (size_t i = 0; i < COUNT(triangle_cases); i++) {
            char name[128];
            roberts_hit hit = {0};
            roberts_ray ray = {triangle_cases[i].s, triangle_cases[i].v};
            snprintf(name, sizeof name, "%s, %s", triangle_forms[k].name, triangle_cases[i].name);
            bool met = triangle_forms[k].meets(ray, a, b, c, &hit);
            check_hit(name, met, hit, triangle_cases[i].met, triangle_cases[i].t, triangle_cases[i].facing);
            /* corners in the other order: the same points, the other side */
            met = triangle_forms[k].meets(ray, a, c, b, &hit);
            check_hit(name, met, hit, triangle_cases[i].met, triangle_cases[i].t,
                      triangle_cases[i].facing == FRONT ? BACK : FRONT);
        }
}

/* Triangles without area are never met, nor are those whose area is only rounding. */
static void test_triangle_flat(void **state)
{
    const roberts_vec3 a = {0.1, 0.2, 0.3}, b = {0.2, 0.4, 0.6}, c = {0.7, 1.4, 2.1};
    roberts_ray ray = {{0.2, 0.4, 3}, {0, 0, -1}};
    roberts_hit hit;
    (void)state;
    for (size_t k = 0; k < COUNT(triangle_forms); k++) {
        assert_false(triangle_forms[k].meets(ray, a, b, c, &hit));
        assert_false(triangle_forms[k].meets(ray, a, a, c, &hit));
        assert_false(triangle_forms[k].meets(ray, a, a, a, &hit));
    }
}

/* Proposition 3 on random rays, and the three forms against each other: near a side or nearly parallel they may fall
 * on different sides of the border by rounding, and only there; elsewhere hit, t, alpha, beta and facing agree. */
static void test_triangle_forms(void **state)
{
    rng r = {3};
    size_t hits = 0, split = 0;
    (void)state;
    for (int i = 0; i < 1000000; i++) {
        roberts_vec3 a = rng_vec3(&r, 2.0), b = rng_vec3(&r, 2.0), c = rng_vec3(&r, 2.0);
        roberts_ray ray = draw_ray(&r);
        roberts_hit hit[3] = {{0}};
        bool met[3];
        for (size_t k = 0; k < 3; k++)
            met[k] = triangle_forms[k].meets(ray, a, b, c, &hit[k]);
        if (!met[0] && !met[1] && !met[2])
            continue;
        roberts_vec3 n = vec3_cross(vec3_sub(b, a), vec3_sub(c, a));
        double length = vec3_length(ray.direction), sine = fabs(vec3_dot(n, ray.direction)) / length;
        double slack = 1e-14 * 100 / (sine * fmin(1.0, vec3_length(n)));
        const roberts_hit *one = met[0] ? &hit[0] : met[1] ? &hit[1] : &hit[2];
        double border = fmin(fmin(one->alpha, one->beta), fmin(1.0 - one->alpha - one->beta, one->t * length));
        if (!(met[0] && met[1] && met[2])) {
            split++;
            if (border > slack)
                fail_msg("ray %d: forms %d%d%d, %g from the border (slack %g)", i, met[0], met[1], met[2], border,
                         slack);
            continue;
        }
        hits++;
        for (size_t k = 0; k < 3; k++) {
            check_close("t", hit[k].t * length, hit[0].t * length, slack);
            check_close("alpha", hit[k].alpha, hit[0].alpha, slack);
            check_close("beta", hit[k].beta, hit[0].beta, slack);
            assert_int_equal(hit[k].facing, vec3_dot(n, ray.direction) < 0 ? FRONT : BACK);
        }
        roberts_vec3 p = along(ray, hit[0].t), q = vec3_add(a, vec3_add(vec3_scale(hit[0].alpha, vec3_sub(b, a)),
                                                                        vec3_scale(hit[0].beta, vec3_sub(c, a))));
        check_close("P", vec3_length(vec3_sub(p, q)), 0.0, slack);
    }
    assert_true(hits > 10000);
    assert_true(split < 100);
}

/* Half of a parallelogram each: what crosses it off the diagonal meets exactly one of the two triangles. */
static void test_triangle_halves(void **state)
{
    rng r = {4};
    size_t hits = 0;
    (void)state;
    for (int i = 0; i < 100000; i++) {
        roberts_vec3 a = rng_vec3(&r, 1.0), b = rng_vec3(&r, 1.0), d = rng_vec3(&r, 1.0);
        roberts_vec3 c = vec3_sub(vec3_add(b, d), a);
        double alpha = rng_between(&r, -0.5, 1.5), beta = rng_between(&r, -0.5, 1.5);
        roberts_vec3 p = vec3_add(a, vec3_add(vec3_scale(alpha, vec3_sub(b, a)), vec3_scale(beta, vec3_sub(d, a))));
        roberts_vec3 s = rng_vec3(&r, 3.0);
        roberts_ray ray = {s, vec3_sub(p, s)};
        roberts_vec3 n = vec3_cross(vec3_sub(b, a), vec3_sub(d, a));
        double border = fmin(fmin(fabs(alpha), fabs(1 - alpha)), fmin(fabs(beta), fabs(1 - beta)));
        if (border < 1e-6 || fabs(alpha + beta - 1) < 1e-6 || fabs(vec3_dot(n, ray.direction)) < 1e-4)
            continue;
        roberts_hit hit;
        bool inside = alpha > 0 && alpha < 1 && beta > 0 && beta < 1;
        bool first = roberts_ray_triangle(ray, a, b, d, &hit), second = roberts_ray_triangle_mt(ray, c, d, b, &hit);
        assert_int_equal(first, inside && alpha + beta < 1);
        assert_int_equal(second, inside && alpha + beta > 1);
        if (inside)
            check_close("t", hit.t, first || second ? 1.0 : NAN, second ? 1e-9 : INF);
        hits += inside;
    }
    assert_true(hits > 20000);
}

/* ---- polygon --------------------------------------------------------------------------------------------------- */

static const struct {
    const char *name;
    roberts_inside_fn *inside;
} inside_tests[] = {{"crossings", roberts_inside_crossings},
                    {"signs", roberts_inside_signs},
                    {"frame", roberts_inside_frame},
                    {"angles", roberts_inside_angles}};

/* A hexagon with two corners on one line, (2, 0) between (0, 0) and (4, 0); its first corner is that one. */
static const roberts_vec3 hexagon[] = {{2, 0, 1}, {4, 0, 1}, {6, 2, 1}, {4, 4, 1}, {0, 4, 1}, {0, 0, 1}};

static const struct {
    const char *name;
    roberts_vec3 p;
    bool inside;
} inside_cases[] = {
    {"middle", {2, 2, 1}, true},
    {"level with a corner, inside", {1, 2, 1}, true},
    {"level with a corner, left of it", {-1, 2, 1}, false},
    {"level with a corner, right of it", {7, 2, 1}, false},
    {"level with the top side, left", {-1, 4, 1}, false},
    {"level with the top side, right", {5, 4, 1}, false},
    {"level with the bottom side, left", {-1, 0, 1}, false},
    {"level with the bottom side, right", {5, 0, 1}, false},
    {"on a level side", {3, 4, 1}, true},
    {"on an upright side", {0, 1, 1}, true},
    {"on a slanting side", {5, 1, 1}, true},
    {"on the corner between two sides of one line", {2, 0, 1}, true},
    {"on a corner", {6, 2, 1}, true},
    {"near a corner, inside", {6 - 0x1p-20, 2, 1}, true},
    {"near a corner, outside", {6 + 0x1p-20, 2, 1}, false},
    {"near a side, inside", {3, 0x1p-20, 1}, true},
    {"near a side, outside", {3, -0x1p-20, 1}, false},
    {"not a number", {NAN, 2, 1}, false},
};

static void test_inside_table(void **state)
{
    (void)state;
    for (size_t k = 0; k < COUNT(inside_tests); k++)
        for (size_t i = 0; i < COUNT(inside_cases); i++)
            for (int turn = 0; turn < 2; turn++) { /* corners either way round */
                roberts_vec3 corner[6];
                for (size_t j = 0; j < 6; j++)
                    corner[j] = hexagon[turn ? 5 - j : j];
                if (inside_tests[k].inside(corner, 6, inside_cases[i].p) != inside_cases[i].inside)
                    fail_msg("%s, %s, turned %d", inside_tests[k].name, inside_cases[i].name, turn);
            }
}

static void test_inside_degenerate(void **state)
{
    const roberts_vec3 line[] = {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {2, 2, 2}}, p = {1, 1, 1};
    (void)state;
    for (size_t k = 0; k < COUNT(inside_tests); k++) {
        assert_false(inside_tests[k].inside(line, 4, p)); /* no area */
        assert_false(inside_tests[k].inside(line, 3, p));
        assert_false(inside_tests[k].inside(line, 2, p)); /* too few corners */
        assert_false(inside_tests[k].inside(line, 0, p));
    }
    /* Parity alone serves polygons that are not convex: an L. */
    const roberts_vec3 ell[] = {{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}};
    assert_true(roberts_inside_crossings(ell, 6, (roberts_vec3){0.5, 3, 0}));
    assert_true(roberts_inside_crossings(ell, 6, (roberts_vec3){3, 0.5, 0}));
    assert_false(roberts_inside_crossings(ell, 6, (roberts_vec3){3, 3, 0}));
    assert_true(roberts_inside_angles(ell, 6, (roberts_vec3){0.5, 3, 0}));
    assert_false(roberts_inside_angles(ell, 6, (roberts_vec3){3, 3, 0}));
}

/* Corners on an ellipse at random angles in a random plane; returns its count. */
static size_t draw_polygon(rng *r, roberts_vec3 corner[12], roberts_vec3 *o, roberts_vec3 *u, roberts_vec3 *v)
{
    size_t count = (size_t)rng_between(r, 3.0, 13.0);
    double first = rng_between(r, 0.0, 1.0);
    *o = rng_vec3(r, 2.0);
    do {
        *u = rng_vec3(r, 1.0);
        *v = rng_vec3(r, 1.0);
    } while (vec3_length(vec3_cross(*u, *v)) < 0.05);
    for (size_t i = 0; i < count; i++) {
        double angle = 2 * PI * ((double)i + rng_between(r, 0.05, 0.95) + first) / (double)count;
        corner[i] = vec3_add(*o, vec3_add(vec3_scale(cos(angle), *u), vec3_scale(sin(angle), *v)));
    }
    return count;
}

/* Propositions 4, 5 and 6 decide alike, and as the fan of triangles from the first corner does. */
static void test_polygon_forms(void **state)
{
    rng r = {5};
    size_t hits = 0, split = 0;
    (void)state;
    for (int i = 0; i < 200000; i++) {
        roberts_vec3 corner[12], o, u, v;
        size_t count = draw_polygon(&r, corner, &o, &u, &v);
        double x = rng_between(&r, -1.2, 1.2), y = rng_between(&r, -1.2, 1.2);
        roberts_vec3 p = vec3_add(o, vec3_add(vec3_scale(x, u), vec3_scale(y, v))), s = rng_vec3(&r, 4.0);
        roberts_ray ray = {s, vec3_sub(p, s)};
        roberts_vec3 n = vec3_cross(u, v);
        double vn = vec3_dot(n, ray.direction) / vec3_length(n);
        if (fabs(vn) < 1e-3)
            continue;
        double nearest = INF; /* to a side, in the plane where the ellipse is a circle */
        bool fan = false;
        for (size_t k = 0; k < count; k++) {
            roberts_vec3 a = corner[k], b = corner[(k + 1) % count], c = vec3_cross(vec3_sub(b, a), vec3_sub(p, a));
            nearest = fmin(nearest, vec3_length(c) / vec3_length(vec3_sub(b, a)));
            roberts_hit hit;
            fan |= k > 0 && k + 1 < count && roberts_ray_triangle(ray, corner[0], a, b, &hit);
        }
        for (size_t k = 0; k < COUNT(inside_tests); k++) {
            roberts_hit hit;
            bool met = roberts_ray_polygon(ray, corner, count, inside_tests[k].inside, &hit);
            if (met != fan) {
                split++;
                if (nearest > 1e-9)
                    fail_msg("ray %d, %s: %d, triangles %d, %g from a side", i, inside_tests[k].name, met, fan,
                             nearest);
            } else if (met) {
                hits++;
                check_close("t", hit.t, 1.0, 1e-11);
                assert_int_equal(hit.facing, vn < 0 ? FRONT : BACK);
            }
        }
    }
    assert_true(hits > 100000);
    assert_true(split < 100);
}

static void test_polygon_table(void **state)
{
    roberts_hit hit = {0};
    roberts_ray down = {{2, 2, 4}, {0, 0, -1}}, up = {{2, 2, 0}, {0, 0, 4}}, level = {{-2, 2, 1}, {1, 0, 0}};
    (void)state;
    check_hit("front", roberts_ray_polygon(down, hexagon, 6, NULL, &hit), hit, true, 3, FRONT);
    check_hit("back", roberts_ray_polygon(up, hexagon, 6, NULL, &hit), hit, true, 0.25, BACK);
    check_hit("within", roberts_ray_polygon(level, hexagon, 6, NULL, &hit), hit, false, 0, FRONT);
    check_hit("no corners", roberts_ray_polygon(down, hexagon, 0, NULL, &hit), hit, false, 0, FRONT);
    down.origin.z = 1;
    check_hit("source within", roberts_ray_polygon(down, hexagon, 6, NULL, &hit), hit, true, 0, FRONT);
    down.origin.z = 0;
    check_hit("behind", roberts_ray_polygon(down, hexagon, 6, NULL, &hit), hit, false, 0, FRONT);
}

/* ---- circle and sphere ----------------------------------------------------------------------------------------- */

/* Centre (1, 2, 3), radius 5. */
static const struct {
    const char *name;
    roberts_vec3 s, v;
    bool met;
    roberts_span span;
} sphere_cases[] = {
    {"through the middle", {-9, 2, 3}, {1, 0, 0}, true, {5, 15, 5, FRONT, NONE}},
    {"v of length 5", {-9, 2, 3}, {5, 0, 0}, true, {1, 3, 1, FRONT, NONE}},
    {"v of length 1/4", {-9, 2, 3}, {0.25, 0, 0}, true, {20, 60, 20, FRONT, NONE}},
    {"off the middle", {-9, 5, 3}, {1, 0, 0}, true, {6, 14, 6, FRONT, NONE}},
    {"from the centre", {1, 2, 3}, {0, 2, 0}, true, {-2.5, 2.5, 2.5, BACK, NONE}},
    {"from inside", {1, 5, 3}, {1, 0, 0}, true, {-4, 4, 4, BACK, NONE}},
    {"behind", {11, 2, 3}, {1, 0, 0}, false, MISS},
    {"missed", {-9, 8, 3}, {1, 0, 0}, false, MISS},
    {"tangent", {-9, 7, 3}, {1, 0, 0}, true, {10, 10, 10, FRONT, NONE}},
    {"tangent behind", {9, 7, 3}, {1, 0, 0}, false, MISS},
    {"tangent at the source", {1, 7, 3}, {1, 0, 0}, true, {0, 0, 0, FRONT, NONE}},
    {"source on it, inward", {-4, 2, 3}, {1, 0, 0}, true, {0, 10, 0, FRONT, NONE}},
    {"source on it, outward", {6, 2, 3}, {1, 0, 0}, true, {-10, 0, 0, BACK, NONE}},
    {"no direction", {1, 2, 3}, {0, 0, 0}, false, MISS},
    {"not a number", {1, 2, NAN}, {1, 0, 0}, false, MISS},
    {"infinite", {1, 2, 3}, {INF, 0, 0}, false, MISS},
};

static void test_sphere_table(void **state)
{
    const roberts_vec3 centre = {1, 2, 3};
    (void)state;
    for (size_t i = 0; i < COUNT(sphere_cases); i++) {
        roberts_span span = {0};
        roberts_ray ray = {sphere_cases[i].s, sphere_cases[i].v};
        roberts_ray2 flat = {{ray.origin.x, ray.origin.y}, {ray.direction.x, ray.direction.y}};
        bool met = roberts_ray_sphere(ray, centre, 5, &span);
        check_span(sphere_cases[i].name, met, span, sphere_cases[i].met, sphere_cases[i].span);
        met = roberts_ray_sphere_geometric(ray, centre, 5, &span);
        check_span(sphere_cases[i].name, met, span, sphere_cases[i].met, sphere_cases[i].span);
        if (isnan(ray.origin.z))
            continue; /* the one case whose fault the circle cannot see */
        met = roberts_ray_circle(flat, (roberts_vec2){1, 2}, 5, &span);
        check_span(sphere_cases[i].name, met, span, sphere_cases[i].met, sphere_cases[i].span);
    }
    roberts_span span;
    roberts_ray through = {{-2, 2, 3}, {1, 0, 0}};
    assert_false(roberts_ray_sphere(through, centre, -5, &span)); /* nothing has a negative radius */
    assert_false(roberts_ray_sphere_geometric(through, centre, -5, &span));
    assert_true(roberts_ray_sphere(through, centre, 0, &span)); /* a point */
    assert_true(span.t_in == 3 && span.t_out == 3);
    assert_true(roberts_ray_sphere_geometric(through, centre, 0, &span));
    assert_true(span.t_in == 3 && span.t_out == 3);
}

/* Propositions 7 and 8 agree wherever the sphere is not merely grazed; both ends lie on it; t_H is half way; the sphere
 * is its circle in the plane of ray and centre. */
static void test_sphere_forms(void **state)
{
    rng r = {6};
    size_t hits = 0;
    (void)state;
    for (int i = 0; i < 1000000; i++) {
        roberts_ray ray = draw_ray(&r);
        roberts_vec3 centre = rng_vec3(&r, 3.0), v = ray.direction, so = vec3_sub(centre, ray.origin);
        double radius = rng_between(&r, 0.0, 2.0), length = vec3_length(v), t_h = vec3_dot(so, v) / (length * length);
        double d = vec3_length(vec3_sub(so, vec3_scale(t_h, v)));
        roberts_span algebraic, geometric, circle;
        bool met = roberts_ray_sphere_geometric(ray, centre, radius, &geometric);
        if (fabs(d - radius) < 1e-12 || fabs(vec3_length(so) - radius) < 1e-12)
            continue; /* rounding decides here */
        assert_int_equal(met, d < radius && (t_h > 0 || vec3_length(so) < radius));
        assert_int_equal(met, roberts_ray_sphere(ray, centre, radius, &algebraic));
        /* in the plane of ray and centre: S at 0, v along x, O at (t_H |v|, d) */
        roberts_ray2 flat = {{0, 0}, {length, 0}};
        assert_int_equal(met, roberts_ray_circle(flat, (roberts_vec2){t_h * length, d}, radius, &circle));
        if (!met)
            continue;
        hits++;
        double slack =
            1e-13 / fmin(1.0, sqrt(radius * radius - d * d)); /* half-chord: roots lose digits as it closes */
        const double t[] = {algebraic.t_in,  algebraic.t_out, geometric.t_in,
                            geometric.t_out, circle.t_in,     circle.t_out};
        for (size_t k = 2; k < 6; k++)
            check_close("forms", t[k] * length, t[k % 2] * length, slack);
        check_close("t_H", (geometric.t_in + geometric.t_out) / 2 * length, t_h * length, 1e-14);
        for (size_t k = 2; k < 4; k++)
            check_close("on the sphere", vec3_length(vec3_sub(along(ray, t[k]), centre)), radius, slack);
        assert_int_equal(algebraic.facing, vec3_length(so) > radius ? FRONT : BACK);
        assert_int_equal(geometric.facing, algebraic.facing);
    }
    assert_true(hits > 50000);
}

/* Far from the sphere the geometric form keeps its digits. */
static void test_sphere_far(void **state)
{
    roberts_ray ray = {{-1e8, 0.6, 0}, {1, 0, 0}};
    roberts_span span;
    (void)state;
    assert_true(roberts_ray_sphere_geometric(ray, (roberts_vec3){0, 0, 0}, 1.0, &span));
    check_close("in", span.t_in - 1e8, -0.8, 4e-8);
    check_close("out", span.t_out - 1e8, 0.8, 4e-8);
}

/* ---- box ------------------------------------------------------------------------------------------------------- */

/* Box from (0, 0, 0) to (4, 2, 8). */
static const struct {
    const char *name;
    roberts_vec3 s, v;
    bool met;
    roberts_span span;
} box_cases[] = {
    {"along x", {-2, 1, 1}, {1, 0, 0}, true, {2, 6, 2, FRONT, 0}},
    {"against x", {6, 1, 1}, {-2, 0, 0}, true, {1, 3, 1, FRONT, 1}},
    {"along y", {1, -3, 1}, {0, 1, 0}, true, {3, 5, 3, FRONT, 2}},
    {"against y", {1, 5, 1}, {0, -1, 0}, true, {3, 5, 3, FRONT, 3}},
    {"along z", {1, 1, -4}, {0, 0, 4}, true, {1, 3, 1, FRONT, 4}},
    {"against z", {1, 1, 9}, {0, 0, -1}, true, {1, 9, 1, FRONT, 5}},
    {"slanting", {-1, 0, 4}, {2, 1, 0}, true, {0.5, 2, 0.5, FRONT, 0}},
    {"slanting past", {-1, 2, 4}, {1, 1, 0}, false, MISS},
    {"parallel to a slab, beside it", {-2, 3, 1}, {1, 0, 0}, false, MISS},
    {"parallel to two slabs, beside one", {-2, 1, 9}, {1, 0, 0}, false, MISS},
    {"parallel with -0", {-2, 3, 1}, {1, -0.0, -0.0}, false, MISS},
    {"along a face", {-2, 2, 1}, {1, 0, 0}, true, {2, 6, 2, FRONT, 0}},
    {"along an edge", {-2, 2, 8}, {1, 0, 0}, true, {2, 6, 2, FRONT, 0}},
    {"along an edge with -0", {-2, 2, 8}, {1, -0.0, -0.0}, true, {2, 6, 2, FRONT, 0}},
    {"inside", {1, 1, 1}, {1, 0, 0}, true, {-1, 3, 3, BACK, 1}},
    {"inside, back", {1, 1, 1}, {0, 0, -1}, true, {-7, 1, 1, BACK, 4}},
    {"behind", {5, 1, 1}, {1, 0, 0}, false, MISS},
    {"on a face, inward", {0, 1, 1}, {1, 0, 0}, true, {0, 4, 0, FRONT, 0}},
    {"on a face, outward", {0, 1, 1}, {-1, 0, 0}, true, {-4, 0, 0, BACK, 0}},
    {"on a face, along it", {1, 2, 1}, {1, 0, 0}, true, {-1, 3, 3, BACK, 1}},
    {"on a corner, away", {4, 2, 8}, {1, 1, 1}, true, {-2, 0, 0, BACK, 1}},
    {"touches a corner", {-1, 1, 0}, {1, -1, 0}, true, {1, 1, 1, FRONT, 0}},
    {"touches an edge", {3, 3, 4}, {1, -1, 0}, true, {1, 1, 1, FRONT, 3}},
    {"in through an edge", {-1, -1, 4}, {1, 1, 0}, true, {1, 3, 1, FRONT, 0}},
    {"no direction", {1, 1, 1}, {0, 0, 0}, false, MISS},
    {"not a number", {NAN, 1, 1}, {1, 0, 0}, false, MISS},
    {"not a direction", {1, 1, 1}, {NAN, 0, 0}, false, MISS},
    {"infinite", {1, 1, 1}, {INF, 0, 0}, false, MISS},
    {"arrives beyond all numbers", {-2, 1, 1}, {5e-324, 0, 0}, false, MISS},
};

static void test_box_table(void **state)
{
    const roberts_vec3 a = {0, 0, 0}, b = {4, 2, 8}, c = {4, 0, 8}, d = {0, 2, 0};
    (void)state;
    for (size_t i = 0; i < COUNT(box_cases); i++) {
        roberts_span span = {0};
        roberts_ray ray = {box_cases[i].s, box_cases[i].v};
        bool met = roberts_ray_box(ray, a, b, &span);
        check_span(box_cases[i].name, met, span, box_cases[i].met, box_cases[i].span);
        met = roberts_ray_box(ray, c, d, &span); /* any two opposite corners */
        check_span(box_cases[i].name, met, span, box_cases[i].met, box_cases[i].span);
        if (ray.direction.z != 0.0 || !(ray.origin.z >= 0.0 && ray.origin.z <= 8.0))
            continue;
        roberts_ray2 flat = {{ray.origin.x, ray.origin.y}, {ray.direction.x, ray.direction.y}};
        met = roberts_ray_box2(flat, (roberts_vec2){0, 0}, (roberts_vec2){4, 2}, &span);
        check_span(box_cases[i].name, met, span, box_cases[i].met, box_cases[i].span);
    }
}

/* ---- polyhedron ------------------------------------------------------------------------------------------------ */

/* The box above as half-spaces, in the order of its faces. */
static const roberts_plane box_planes[] = {{1, 0, 0, 0},  {-1, 0, 0, 4}, {0, 1, 0, 0},
                                           {0, -1, 0, 2}, {0, 0, 1, 0},  {0, 0, -1, 8}};

static void test_polyhedron_table(void **state)
{
    (void)state;
    for (size_t i = 0; i < COUNT(box_cases); i++) {
        roberts_span span = {0};
        roberts_ray ray = {box_cases[i].s, box_cases[i].v};
        bool met = roberts_ray_polyhedron(ray, box_planes, 6, &span);
        check_span(box_cases[i].name, met, span, box_cases[i].met, box_cases[i].span);
    }
    roberts_span span = {0};
    roberts_ray ray = {{-2, 1, 1}, {1, 0, 0}};
    check_span("half-space, from outside", roberts_ray_polyhedron(ray, box_planes, 1, &span), span, true,
               (roberts_span){2, INF, 2, FRONT, 0});
    ray.origin.x = 3;
    check_span("half-space, from inside", roberts_ray_polyhedron(ray, box_planes, 1, &span), span, true,
               (roberts_span){-3, INF, INF, BACK, NONE});
    const roberts_plane nothing[] = {{1, 0, 0, -4}, {-1, 0, 0, 0}}; /* x >= 4 and x <= 0 */
    assert_false(roberts_ray_polyhedron(ray, nothing, 2, &span));
}

/* Boxes: as half-spaces, and as slabs, the same; and in the plane against the four segments of its border. */
static void test_box_forms(void **state)
{
    rng r = {7};
    size_t hits = 0;
    (void)state;
    for (int i = 0; i < 300000; i++) {
        roberts_ray ray = draw_ray(&r);
        roberts_vec3 a = rng_vec3(&r, 2.0), b = rng_vec3(&r, 2.0);
        roberts_vec3 lo = {fmin(a.x, b.x), fmin(a.y, b.y), fmin(a.z, b.z)};
        roberts_vec3 hi = {fmax(a.x, b.x), fmax(a.y, b.y), fmax(a.z, b.z)};
        const roberts_plane planes[] = {{1, 0, 0, -lo.x}, {-1, 0, 0, hi.x}, {0, 1, 0, -lo.y},
                                        {0, -1, 0, hi.y}, {0, 0, 1, -lo.z}, {0, 0, -1, hi.z}};
        roberts_span slabs, spaces;
        bool met = roberts_ray_box(ray, a, b, &slabs);
        assert_int_equal(met, roberts_ray_polyhedron(ray, planes, 6, &spaces));
        if (met) {
            hits++;
            assert_memory_equal(&slabs.t_in, &spaces.t_in, sizeof slabs.t_in);
            assert_memory_equal(&slabs.t_out, &spaces.t_out, sizeof slabs.t_out);
            assert_true(slabs.facing == spaces.facing && slabs.face == spaces.face && slabs.t == spaces.t);
        }
        const roberts_ray2 flat = {{ray.origin.x, ray.origin.y}, {ray.direction.x, ray.direction.y}};
        const roberts_vec2 corner[] = {{lo.x, lo.y}, {hi.x, lo.y}, {hi.x, hi.y}, {lo.x, hi.y}};
        roberts_span span;
        double first = INF;
        roberts_facing facing = FRONT;
        for (size_t k = 0; k < 4; k++) { /* clockwise: the segments' fronts look out */
            roberts_hit hit;
            if (roberts_ray_segment(flat, corner[(k + 1) % 4], corner[k], &hit) && hit.t < first) {
                first = hit.t;
                facing = hit.facing;
            }
        }
        met = roberts_ray_box2(flat, (roberts_vec2){a.x, a.y}, (roberts_vec2){b.x, b.y}, &span);
        if (met && (span.t_out - span.t_in) * hypot(flat.direction.x, flat.direction.y) < 1e-9)
            continue; /* a corner cut off within rounding */
        assert_int_equal(met, first < INF);
        if (met) {
            check_close("t", span.t, first, 1e-12 * (1.0 + first));
            assert_int_equal(span.facing, facing);
        }
    }
    assert_true(hits > 10000);
}

/* Tetrahedra: half-spaces against the four triangles of the surface. */
static void test_polyhedron_forms(void **state)
{
    static const int face[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    rng r = {8};
    size_t hits = 0, inside = 0, split = 0;
    (void)state;
    for (int i = 0; i < 300000; i++) {
        roberts_vec3 p[4];
        roberts_plane F[4];
        roberts_ray ray = draw_ray(&r);
        for (int k = 0; k < 4; k++)
            p[k] = rng_vec3(&r, 3.0);
        double volume = vec3_dot(vec3_cross(vec3_sub(p[1], p[0]), vec3_sub(p[2], p[0])), vec3_sub(p[3], p[0]));
        if (fabs(volume) < 1.0)
            continue;
        roberts_hit first = {.t = INF};
        for (int k = 0; k < 4; k++) {
            roberts_vec3 a = p[face[k][0]], b = p[face[k][1]], c = p[face[k][2]], n;
            roberts_hit hit;
            if (volume < 0) {
                roberts_vec3 swap = b;
                b = c;
                c = swap;
            }
            n = vec3_cross(vec3_sub(b, a), vec3_sub(c, a)); /* outward */
            F[k] = (roberts_plane){-n.x, -n.y, -n.z, vec3_dot(n, a)};
            if (roberts_ray_triangle_mt(ray, a, b, c, &hit) && hit.t < first.t)
                first = hit;
        }
        roberts_span span;
        bool met = roberts_ray_polyhedron(ray, F, 4, &span);
        double length = vec3_length(ray.direction);
        if (met && (span.t_out - span.t_in) * length < 1e-9)
            continue; /* an edge or corner cut off within rounding */
        if (met != (first.t < INF)) {
            split++;
            continue;
        }
        if (!met)
            continue;
        hits++;
        inside += span.t_in < 0;
        check_close("t", span.t * length, first.t * length, 1e-9);
        assert_int_equal(span.facing, first.facing);
    }
    assert_true(hits > 20000 && inside > 1000);
    assert_true(split == 0);
}

/* A ray misses the box round a shape only where it misses the shape (what boxes are for). */
static void test_box_bounds(void **state)
{
    rng r = {9};
    (void)state;
    for (int i = 0; i < 100000; i++) {
        roberts_ray ray = draw_ray(&r);
        roberts_vec3 a = rng_vec3(&r, 2.0), b = rng_vec3(&r, 2.0), c = rng_vec3(&r, 2.0);
        roberts_vec3 lo = {fmin(a.x, fmin(b.x, c.x)), fmin(a.y, fmin(b.y, c.y)), fmin(a.z, fmin(b.z, c.z))};
        roberts_vec3 hi = {fmax(a.x, fmax(b.x, c.x)), fmax(a.y, fmax(b.y, c.y)), fmax(a.z, fmax(b.z, c.z))};
        roberts_hit hit;
        roberts_span span;
        if (!roberts_ray_triangle(ray, a, b, c, &hit))
            continue;
        assert_true(roberts_ray_box(ray, lo, hi, &span));
        assert_true(span.t_in <= hit.t * (1 + 1e-9) && hit.t <= span.t_out * (1 + 1e-9));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_segment_table),    cmocka_unit_test(test_segment_properties),
        cmocka_unit_test(test_plane_table),      cmocka_unit_test(test_plane_properties),
        cmocka_unit_test(test_triangle_table),   cmocka_unit_test(test_triangle_flat),
        cmocka_unit_test(test_triangle_forms),   cmocka_unit_test(test_triangle_halves),
        cmocka_unit_test(test_inside_table),     cmocka_unit_test(test_inside_degenerate),
        cmocka_unit_test(test_polygon_forms),    cmocka_unit_test(test_polygon_table),
        cmocka_unit_test(test_sphere_table),     cmocka_unit_test(test_sphere_forms),
        cmocka_unit_test(test_sphere_far),       cmocka_unit_test(test_box_table),
        cmocka_unit_test(test_polyhedron_table), cmocka_unit_test(test_box_forms),
        cmocka_unit_test(test_polyhedron_forms), cmocka_unit_test(test_box_bounds),
    };
    return cmocka_run_group_tests_name("ray", tests, NULL, NULL);
}
