/* Warps of an axis: they ascend, map an interval to itself, make most of what is crowded, and have an inverse. */
#include "base/warp.h"
#include "scenes.h"

enum { VALUES = 500 };
#define LOW (-3.0)
#define HIGH 5.0
#define LEAST 1e-6

/* Ascending values: kind 0: none apart; 1: in two crowds, with nothing in the middle; 2: evenly divided; 3: at the
 * ends. */
static void make_values(double value[VALUES], int kind)
{
    for (int i = 0; i < VALUES; i++)
        value[i] = kind == 0   ? 1.25
                   : kind == 1 ? (i < 200 ? -2.0 + 1e-5 * i : 4.0 + 1e-3 * i)
                   : kind == 2 ? LOW + (HIGH - LOW) * (i + 0.5) / VALUES
                               : (i < 100 ? LOW : HIGH);
}

static void it_ascends_and_turns_back(void **state)
{
    (void)state;
    for (int kind = 0; kind < 4; kind++) {
        double value[VALUES];
        rng r = {(uint64_t)kind + 1};
        warp w;
        make_values(value, kind);
        assert_true(warp_make(&w, LOW, HIGH, value, VALUES, LEAST));
        assert_true(warp_at(&w, LOW) == LOW && fabs(warp_at(&w, HIGH) - HIGH) < 1e-14);
        for (int k = 0; k < WARP_PIECES; k++)
            assert_true(w.at[k + 1] - w.at[k] >= 0.999 * LEAST);
        for (int i = 0; i < 20000; i++) {
            double x = rng_between(&r, LOW - 1, HIGH + 1);
            if (i % 3 == 0) /* around a corner of the map */
                x = w.at[rng_int(&r, 0, WARP_PIECES)];
            double y = i % 2 ? nextafter(x, INFINITY) : x + rng_between(&r, 0, 1e-3);
            assert_true(warp_at(&w, x) <= warp_at(&w, y));
            if (x >= LOW && x <= HIGH)
                assert_true(fabs(warp_back(&w, warp_at(&w, x)) - x) < 1e-13);
        }
        assert_true(warp_is_sound(&w));
        double *const wrong[] = {&w.from, &w.at[0], &w.at[17], &w.at[WARP_PIECES], &w.per[0], &w.per[63], &w.piece};
        for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
            const double right = *wrong[i];
            *wrong[i] = i % 2 ? (double)NAN : -right;
            assert_false(warp_is_sound(&w));
            *wrong[i] = right;
        }
    }
}

/* Half of the interval goes to the values in proportion to their number, and half to the rest. */
static void crowds_get_their_share(void **state)
{
    double value[VALUES];
    warp w;
    (void)state;
    make_values(value, 1);
    assert_true(warp_make(&w, LOW, HIGH, value, VALUES, LEAST));
    double crowd = (warp_at(&w, -2.0 + 2e-3) - warp_at(&w, -2.0)) / (HIGH - LOW);
    double empty = (warp_at(&w, 3.5) - warp_at(&w, -1.5)) / (HIGH - LOW);
    assert_true(fabs(crowd - 0.2) < 0.03); /* 200 of 500, half of it */
    assert_true(fabs(empty - 0.5 * 5.0 / 8.0) < 0.03);
    assert_true(warp_stretch(&w, -2.0 + 1e-3) > 100 && warp_stretch(&w, 2.0) < 1);
    make_values(value, 2);
    assert_true(warp_make(&w, LOW, HIGH, value, VALUES, LEAST));
    for (int i = 0; i < VALUES; i++)
        assert_true(fabs(warp_stretch(&w, value[i]) - 1.0) < 0.05);
    assert_true(warp_make(&w, LOW, HIGH, NULL, 0, LEAST));
    assert_true(fabs(warp_at(&w, 1.0) - (LOW + 0.5 * (HIGH - LOW))) < 1e-14);
}

static void a_short_interval_has_no_warp(void **state)
{
    double value[VALUES];
    warp w;
    (void)state;
    make_values(value, 0);
    assert_false(warp_make(&w, LOW, HIGH, value, VALUES, (HIGH - LOW) / WARP_PIECES));
    assert_false(warp_make(&w, 1.25, 1.25, value, VALUES, 0.0));
    assert_false(warp_make(&w, LOW, (double)NAN, value, VALUES, 0.0));
    assert_false(warp_make(&w, LOW, HIGH, value, VALUES, 0.0)); /* all values at one place: a piece has no length */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_ascends_and_turns_back),
        cmocka_unit_test(crowds_get_their_share),
        cmocka_unit_test(a_short_interval_has_no_warp),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
