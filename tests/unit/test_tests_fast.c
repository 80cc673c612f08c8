/* Lanes against plain C, and tests 2 to 4 in one pass against the tests one by one. */
#include "base/lanes.h"
#include "bare_points.h"
#include "scenes.h"

#define EPSILON 1e-9
#define ROUNDING 1e-15

/* Signed zeros, infinities, denormals and numbers of all sizes. */
static double any_double(rng *r)
{
    static const double odd[] = {0.0, -0.0, INFINITY, -INFINITY, 5e-324, -5e-324, 1.0, -1.0};
    if (rng_int(r, 0, 2) == 0)
        return odd[rng_int(r, 0, 7)];
    return ldexp(rng_between(r, -1.0, 1.0), rng_int(r, -1000, 1000));
}

static void assert_same_two(two a, two_plain b)
{
    double lane[2];
    two_store(lane, a);
    assert_memory_equal(lane, b.v, sizeof lane);
}

static void lanes_are_scalars(void **state)
{
    rng r = {7};
    (void)state;
    for (int i = 0; i < 100000; i++) {
        _Alignas(16) double p[2] = {any_double(&r), any_double(&r)}, q[2] = {any_double(&r), any_double(&r)};
        two a = two_load_aligned(p), b = two_load_aligned(q);
        two_plain c = two_plain_load(p), d = two_plain_load(q);
        if (isfinite(p[0]) && isfinite(p[1]) && isfinite(q[0]) && isfinite(q[1])) {
            assert_same_two(two_add(a, b), two_plain_add(c, d));
            assert_same_two(two_sub(a, b), two_plain_sub(c, d));
            assert_same_two(two_mul(a, b), two_plain_mul(c, d));
            if (q[0] != 0.0 && q[1] != 0.0)
                assert_same_two(two_div(a, b), two_plain_div(c, d));
            assert_same_two(two_sqrt(two_abs(a)), two_plain_sqrt(two_plain_abs(c)));
        }
        assert_same_two(two_side(a), two_plain_side(c));
        double lane[2], plain[2];
        two_part(&lane[0], &lane[1], a);
        two_plain_part(&plain[0], &plain[1], c);
        assert_memory_equal(lane, plain, sizeof lane);
        float part[2], plain_part[2];
        two_part_floats(&part[0], &part[1], a);
        two_plain_part_floats(&plain_part[0], &plain_part[1], c);
        assert_memory_equal(part, plain_part, sizeof part);
        assert_same_two(two_lesser(a, b), two_plain_lesser(c, d));
        assert_same_two(two_greater(a, b), two_plain_greater(c, d));
        assert_same_two(two_abs(a), two_plain_abs(c));
        assert_same_two(two_all(p[0]), two_plain_all(p[0]));
        assert_same_two(two_of(p[0], q[1]), two_plain_of(p[0], q[1]));
        assert_int_equal(two_signs(a), two_plain_signs(c));
        assert_int_equal(two_at_most(a, b), two_plain_at_most(c, d));
        assert_true(two_least(a) == two_plain_least(c));
    }
}

static void lanes_of_four_are_scalars(void **state)
{
    static const float values[] = {0.0f, -0.0f, INFINITY, -INFINITY, 1.0f, -1.0f, 2.5f, 1e-45f};
    rng r = {8};
    (void)state;
    for (int i = 0; i < 100000; i++) {
        float p[4], q[4];
        for (int k = 0; k < 4; k++) {
            p[k] = values[rng_int(&r, 0, 7)];
            q[k] = values[rng_int(&r, 0, 7)];
        }
        four below = four_below(four_load(p), four_load(q)), first = four_below(four_all(p[0]), four_load(q));
        four_plain below_plain = four_plain_below(four_plain_load(p), four_plain_load(q));
        four_plain first_plain = four_plain_below(four_plain_all(p[0]), four_plain_load(q));
        assert_int_equal(four_signs(below), four_plain_signs(below_plain));
        assert_int_equal(four_signs(first), four_plain_signs(first_plain));
        assert_int_equal(four_signs(four_either(below, first)),
                         four_plain_signs(four_plain_either(below_plain, first_plain)));
        assert_int_equal(four_signs(below) & 1u, p[0] < q[0]);
    }
}

static void lanes_of_four_are_counted_in_bytes(void **state)
{
    static const float values[] = {0.0f, -0.0f, INFINITY, -INFINITY, 1e-45f, 254.9f, 255.0f, 255.5f, 1e20f, -1e20f};
    rng r = {11};
    (void)state;
    for (int i = 0; i < 100000; i++) {
        float p[4], q[4], difference[4], product[4];
        for (int k = 0; k < 4; k++) {
            p[k] = rng_int(&r, 0, 1) ? values[rng_int(&r, 0, 9)] : (float)rng_between(&r, -10, 270);
            q[k] = (float)rng_between(&r, -10, 10);
        }
        four_store(difference, four_sub(four_load(p), four_load(q)));
        four_store(product, four_mul(four_load(p), four_load(q)));
        float own[5][4], plain[5][4];
        four_store(own[0], four_add(four_load(p), four_load(q)));
        four_store(own[1], four_div(four_load(p), four_load(q)));
        four_store(own[2], four_lesser(four_load(p), four_load(q)));
        four_store(own[3], four_greater(four_load(p), four_load(q)));
        four_store(own[4], four_greater(four_load(q), four_load(p)));
        four_plain_store(plain[0], four_plain_add(four_plain_load(p), four_plain_load(q)));
        four_plain_store(plain[1], four_plain_div(four_plain_load(p), four_plain_load(q)));
        four_plain_store(plain[2], four_plain_lesser(four_plain_load(p), four_plain_load(q)));
        four_plain_store(plain[3], four_plain_greater(four_plain_load(p), four_plain_load(q)));
        four_plain_store(plain[4], four_plain_greater(four_plain_load(q), four_plain_load(p)));
        for (int k = 0; k < 20; k++)
            assert_true(own[k / 4][k % 4] == plain[k / 4][k % 4] ||
                        (isnan(own[k / 4][k % 4]) && isnan(plain[k / 4][k % 4])));
        assert_int_equal(four_at_most(four_load(p), four_load(q)),
                         four_plain_at_most(four_plain_load(p), four_plain_load(q)));
        uint32_t bytes = four_bytes(four_load(p));
        assert_int_equal(bytes, four_plain_bytes(four_plain_load(p)));
        for (int k = 0; k < 4; k++) {
            double cut = fmin(fmax(floor((double)p[k]), 0), 255);
            assert_int_equal(bytes >> 8 * k & 255, (uint32_t)cut);
            assert_true(difference[k] == p[k] - q[k]);
            assert_true(product[k] == p[k] * q[k] || isnan(p[k] * q[k]));
        }
        four_plain_store(difference, four_plain_sub(four_plain_load(p), four_plain_load(q)));
        four_plain_store(product, four_plain_mul(four_plain_load(p), four_plain_load(q)));
        for (int k = 0; k < 4; k++) {
            assert_true(difference[k] == p[k] - q[k]);
            assert_true(product[k] == p[k] * q[k] || isnan(p[k] * q[k]));
        }
    }
}

static void bytes_are_compared_with_the_most(void **state)
{
    rng r = {12};
    unsigned found = 0;
    (void)state;
    for (int i = 0; i < 100000; i++) {
        uint32_t a[8], most = 0;
        unsigned within = 0;
        for (int k = 0; k < 4; k++)
            most |= (uint32_t)rng_int(&r, 100, 255) << 8 * k;
        for (unsigned k = 0; k < 4; k++) {
            bool all = true;
            a[2 * k] = (uint32_t)rng_next(&r);
            a[2 * k + 1] = 0;
            for (int j = 0; j < 32; j += 8) {
                uint32_t byte = rng_int(&r, 0, 2) ? (uint32_t)rng_int(&r, 0, 200) : most >> j & 255;
                a[2 * k + 1] |= byte << j;
                all = all && byte <= (most >> j & 255);
            }
            within |= (all ? 1u : 0u) << k;
        }
        assert_int_equal(four_bytes_at_most(a, most), within);
        assert_int_equal(four_plain_bytes_at_most(a, most), within);
        found |= 1u << within;
    }
    assert_int_equal(found, 0xffff); /* each answer has been found */
}

static void four_numbers_are_compared_with_one(void **state)
{
    rng r = {10};
    (void)state;
    for (int i = 0; i < 1000; i++) {
        uint32_t a[4], x = 0x80000000u | (uint32_t)rng_int(&r, 0, 2);
        unsigned same = 0;
        for (unsigned k = 0; k < 4; k++) {
            a[k] = 0x80000000u | (uint32_t)rng_int(&r, 0, 2);
            same |= (unsigned)(a[k] == x) << k;
        }
        assert_int_equal(four_signs(four_same(a, x)), same);
        assert_int_equal(four_plain_signs(four_plain_same(a, x)), same);
    }
}

static void four_numbers_are_shifted_alike(void **state)
{
    rng r = {9};
    (void)state;
    for (int i = 0; i < 10000; i++) {
        uint32_t a[4], b[4], shift = (uint32_t)rng_next(&r);
        int odd = rng_int(&r, 0, 7); /* from 4 on: none is */
        for (int k = 0; k < 4; k++) {
            a[k] = (uint32_t)rng_next(&r);
            b[k] = a[k] + shift + (k == odd ? 1u << rng_int(&r, 0, 31) : 0u);
        }
        assert_int_equal(four_shifted(a, b, shift), odd >= 4);
        assert_int_equal(four_plain_shifted(a, b, shift), odd >= 4);
    }
}

/* ---- edges and outlines ---------------------------------------------------------------------------------------- */

enum { CORNERS = 12 };

typedef struct fixture {
    roberts_vec3 P[CORNERS + 2];
    uint32_t corner[CORNERS];
    hide_space space;
    hide_face face;
    hide_edge edge;
} fixture;

static roberts_vec3 place(rng *r, bool whole)
{
    if (whole) /* where much lies on much */
        return (roberts_vec3){rng_int(r, -4, 4), rng_int(r, -4, 4), 0.0};
    return (roberts_vec3){rng_between(r, -4.0, 4.0), rng_between(r, -4.0, 4.0), 0.0};
}

/* Corners on an ellipse, numbered at random; or a rectangle with whole corners. */
static void set_outline(fixture *f, rng *r, bool whole)
{
    uint32_t count = whole ? 4 : (uint32_t)rng_int(r, 3, CORNERS);
    double turn = rng_between(r, 0.0, 6.0), w = rng_between(r, 0.01, 3.0), h = rng_between(r, 0.01, 3.0);
    int x = rng_int(r, -3, 2), y = rng_int(r, -3, 2), right = rng_int(r, x + 1, 3), top = rng_int(r, y + 1, 3);
    rng_permutation(r, f->corner, count);
    for (uint32_t i = 0; i < count; i++) {
        double angle = turn + 6.283185307179586 * i / count;
        f->P[f->corner[i]] = (roberts_vec3){w * cos(angle), h * sin(angle), 0.0};
        if (whole)
            f->P[f->corner[i]] = (roberts_vec3){i == 1 || i == 2 ? right : x, i >= 2 ? top : y, 0.0};
    }
    f->face = (hide_face){.corner = f->corner, .count = count};
}

static void set_up(fixture *f, rng *r)
{
    bool whole = rng_int(r, 0, 1) == 1;
    *f = (fixture){0};
    set_outline(f, r, whole);
    uint32_t a = f->face.count, b = a + 1;
    f->P[a] = place(r, whole);
    f->P[b] = place(r, whole);
    f->space = bare_space(f->P, EPSILON, ROUNDING, 12.0);
    f->edge = bare_edge(f->P, a, b);
}

/* Compares the verdict, unless it is unclear, with the tests one by one. */
static fast_verdict compare(const fixture *f, double span, hide_sides *sides)
{
    hide_interval part = {0}, expected = {0};
    fast_outline outline;
    fast_take(&outline, f->P, f->corner, f->face.count);
    const fast_verdict verdict = fast_test(&outline, &f->space, &f->edge, span, NULL, &part);
    if (verdict == FAST_UNCLEAR)
        return verdict;
    assert_int_equal(bare_tests_2_to_4(&f->space, &f->face, &f->edge, sides, &expected),
                     verdict == FAST_INSIDE || verdict == FAST_CUT);
    if (verdict == FAST_INSIDE || verdict == FAST_CUT)
        assert_memory_equal(&part, &expected, sizeof part);
    if (verdict == FAST_MISSED)
        assert_true(hide_test2(&f->space, &f->face, &f->edge));
    return verdict;
}

static void agrees_with_the_tests(void **state)
{
    rng r = {17};
    size_t outcomes[FAST_EMPTY + 1] = {0};
    hide_sides sides = {0};
    (void)state;
    assert_true(hide_sides_reserve(&sides, CORNERS));
    for (int i = 0; i < 200000; i++) {
        fixture f;
        set_up(&f, &r);
        outcomes[compare(&f, 20.0, &sides)]++;
    }
    free(sides.H);
    for (int v = FAST_UNCLEAR; v < FAST_EMPTY; v++) /* an edge that misses the outline has missed it before test 4 */
        assert_true(outcomes[v] > 1000);
}

/* A part inside a hidden part, widened by the touching distance, is dropped; any other is found as it is. */
/* An edge from within a needle that ends beside its tip, within epsilon of both long sides. */
static void agrees_beside_sharp_corners(void **state)
{
    rng r = {19};
    size_t outcomes[FAST_EMPTY + 1] = {0};
    hide_sides sides = {0};
    (void)state;
    assert_true(hide_sides_reserve(&sides, CORNERS));
    for (int i = 0; i < 20000; i++) {
        const double wide = rng_between(&r, 1e-4, 1e-2), near = 2.0 * EPSILON / wide; /* both sides are that near */
        fixture f = {.P = {{0, 0, 0},
                           {-2, wide, 0},
                           {-2, -wide, 0},
                           {-1.5, 0, 0},
                           {near * rng_between(&r, -4.0, 4.0), EPSILON * rng_between(&r, -3.0, 3.0), 0}},
                     .corner = {0, 1, 2}};
        f.face = (hide_face){.corner = f.corner, .count = 3};
        f.space = bare_space(f.P, EPSILON, ROUNDING, 12.0);
        f.edge = bare_edge(f.P, 3, 4);
        const fast_verdict verdict = compare(&f, 4.5, &sides);
        assert_true(verdict == FAST_UNCLEAR || verdict == FAST_INSIDE || verdict == FAST_CUT);
        outcomes[verdict]++;
    }
    free(sides.H);
    if (!(outcomes[FAST_UNCLEAR] > 500 && outcomes[FAST_INSIDE] > 500 && outcomes[FAST_CUT] > 500))
        fail_msg("%zu unclear, %zu inside, %zu cut", outcomes[FAST_UNCLEAR], outcomes[FAST_INSIDE], outcomes[FAST_CUT]);
}

static void within_the_hidden_is_none(void **state)
{
    rng r = {18};
    size_t within = 0, found = 0, unclear = 0;
    hide_sides sides = {0};
    (void)state;
    assert_true(hide_sides_reserve(&sides, CORNERS));
    for (int i = 0; i < 200000; i++) {
        fixture f;
        hide_interval part = {0}, expected = {0}, hidden = {0};
        fast_outline outline;
        hidden.t0 = hidden.r0 = rng_int(&r, 0, 4) / 8.0;
        hidden.t1 = hidden.r1 = rng_int(&r, 5, 8) / 8.0;
        set_up(&f, &r);
        fast_take(&outline, f.P, f.corner, f.face.count);
        fast_verdict all = fast_test(&outline, &f.space, &f.edge, 20.0, NULL, &expected);
        fast_verdict verdict = fast_test(&outline, &f.space, &f.edge, 20.0, &hidden, &part);
        if (all == FAST_CUT && verdict == FAST_EMPTY) {
            assert_true(hidden.t0 == 0.0 || expected.r0 > hidden.t0);
            assert_true(hidden.t1 == 1.0 || expected.r1 < hidden.t1);
            within++;
        } else if (all == FAST_UNCLEAR && verdict == FAST_EMPTY) {
            if (bare_tests_2_to_4(&f.space, &f.face, &f.edge, &sides, &expected)) {
                assert_true(hidden.t0 == 0.0 || expected.r0 > hidden.t0);
                assert_true(hidden.t1 == 1.0 || expected.r1 < hidden.t1);
            }
            unclear++;
        } else if (all == FAST_OUTSIDE) {
            assert_int_equal(verdict, FAST_OUTSIDE);
        } else if (all == FAST_CUT || all == FAST_INSIDE) {
            assert_int_equal(verdict, all);
            assert_memory_equal(&part, &expected, sizeof part);
            found++;
        }
    }
    free(sides.H);
    assert_true(within > 1000 && found > 1000 && unclear > 0);
}

/* An edge in contact is decided in one pass only if it lies outside another side, or ends well inside. */
static void contact_is_unclear(void **state)
{
    static const struct {
        const char *name;
        roberts_vec3 A, B;
        fast_verdict verdict;
    } cases[] = {
        {"along a side", {-2, -1, 0}, {2, -1, 0}, FAST_UNCLEAR},
        {"along a side, beside it", {2, -1, 0}, {3, -1, 0}, FAST_OUTSIDE},
        {"touches a corner", {-2, 0, 0}, {0, -2, 0}, FAST_UNCLEAR},
        {"inside, starts on a side", {0, -1, 0}, {0, 0.5, 0}, FAST_INSIDE},
        {"inside, starts beyond a side within epsilon", {0, -1 - 0.9 * EPSILON, 0}, {0, 0.5, 0}, FAST_INSIDE},
        {"inside, starts beyond a side", {0, -1 - 1.1 * EPSILON, 0}, {0, 0.5, 0}, FAST_CUT},
        {"comes in from where a side would go on", {-2, -1, 0}, {0.5, 0.25, 0}, FAST_CUT},
        {"ends on a side", {0, -1, 0}, {0, -3, 0}, FAST_UNCLEAR},
        {"ends on a side within epsilon", {0, -1 - 0.5 * EPSILON, 0}, {0, 3, 0}, FAST_UNCLEAR},
        {"through two corners", {-2, -2, 0}, {2, 2, 0}, FAST_UNCLEAR},
        {"end-on, outside", {2, 0, 0}, {2, 0, -1}, FAST_OUTSIDE},
        {"end-on, inside", {0.5, 0, 0}, {0.5, 0, -1}, FAST_INSIDE},
        {"inside", {0.5, 0.5, 0}, {-0.5, 0.25, 0}, FAST_INSIDE},
        {"across", {-2, 0.5, 0}, {2, 0.25, 0}, FAST_CUT},
        {"goes out", {0.5, 0.5, 0}, {2, 0.25, 0}, FAST_CUT},
        {"misses a corner", {-2.5, 0, 0}, {0, -2.5, 0}, FAST_MISSED},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        fixture f = {.P = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, .corner = {0, 1, 2, 3}};
        hide_interval part;
        fast_outline outline;
        f.edge = (hide_edge){.A = cases[i].A, .B = cases[i].B, .a = 4, .b = 5, .length = 1.0, .length3 = 1.0};
        f.space = (hide_space){
            .P = f.P, .epsilon = EPSILON, .across_rounding = ROUNDING, .plain = hide_plain(20.0, EPSILON, ROUNDING)};
        fast_take(&outline, f.P, f.corner, 4);
        if (fast_test(&outline, &f.space, &f.edge, 20.0, NULL, &part) != cases[i].verdict)
            fail_msg("%s", cases[i].name);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lanes_are_scalars),
        cmocka_unit_test(lanes_of_four_are_scalars),
        cmocka_unit_test(lanes_of_four_are_counted_in_bytes),
        cmocka_unit_test(bytes_are_compared_with_the_most),
        cmocka_unit_test(four_numbers_are_compared_with_one),
        cmocka_unit_test(four_numbers_are_shifted_alike),
        cmocka_unit_test(agrees_with_the_tests),
        cmocka_unit_test(agrees_beside_sharp_corners),
        cmocka_unit_test(within_the_hidden_is_none),
        cmocka_unit_test(contact_is_unclear),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
