/* Dashes fitted to their lines: from corner to corner, with at least one gap, as strokes in sequence. */
#include <math.h>
#include <stdio.h>

#include "draw/dashes.h"
#include "rng.h"
#include "testing.h"

/* Hidden lines, in units of 0.001 mm. */
#define USUAL                                                                                                          \
    {                                                                                                                  \
        .dash = 3000, .gap = 750, .width = 250                                                                         \
    }
static const dash_pattern usual = USUAL;

enum { POINTS = 6 };

/* Appends a polyline. */
static void append(polylines *p, const page_point *point, size_t count, bool closed)
{
    assert_true(polylines_start(p));
    p->item[p->count - 1].closed = closed;
    for (size_t i = 0; i < count; i++)
        assert_true(polylines_append(p, point[i]));
}

static void print_lines(const polylines *p, char *text, size_t size)
{
    size_t used = 0;
    text[0] = '\0';
    for (size_t i = 0; i < p->count && used < size; i++) {
        const polyline *line = &p->item[i];
        used += (size_t)snprintf(text + used, size - used, "%s", i ? ";" : "");
        for (uint32_t k = 0; k < line->count && used < size; k++)
            used += (size_t)snprintf(text + used, size - used, "%s%d,%d", i || k ? " " : "",
                                     p->point[line->first + k].x, p->point[line->first + k].y);
        if (line->closed && used < size)
            used += (size_t)snprintf(text + used, size - used, " closed");
    }
}

static const struct {
    const char *name;
    dash_pattern pattern;
    bool closed;
    int count;
    page_point point[POINTS];
    const char *wanted;
} cases[] = {
    /* one straight line; seen, it is longer by the pen's width */
    {"exactly two dashes and a gap", USUAL, false, 2, {{0, 0}, {6500, 0}}, "0,0 2750,0; 3750,0 6500,0"},
    {"exactly three", USUAL, false, 2, {{0, 0}, {10250, 0}}, "0,0 2750,0; 3750,0 6500,0; 7500,0 10250,0"},
    {"more: all longer by a factor", USUAL, false, 2, {{0, 0}, {7850, 0}}, "0,0 3350,0; 4500,0 7850,0"},
    {"half more: a dash more, all shorter",
     USUAL,
     false,
     2,
     {{0, 0}, {8525, 0}},
     "0,0 2257,0; 3134,0 5391,0; 6268,0 8525,0"},
    {"as long as one dash", USUAL, false, 2, {{0, 0}, {2750, 0}}, "0,0 1083,0; 1667,0 2750,0"},
    {"3 mm, as in the chair", USUAL, false, 2, {{0, 0}, {0, 3000}}, "0,0 0,1194; 0,1806 0,3000"},
    {"the gap just as wide as the pen", USUAL, false, 2, {{0, 0}, {2000, 0}}, "0,0 750,0; 1250,0 2000,0"},
    {"shorter: the gap keeps that", USUAL, false, 2, {{0, 0}, {1300, 0}}, "0,0 400,0; 900,0 1300,0"},
    {"the least dashes", USUAL, false, 2, {{0, 0}, {750, 0}}, "0,0 125,0; 625,0 750,0"},
    {"shorter: whole", USUAL, false, 2, {{0, 0}, {749, 0}}, "0,0 749,0"},
    {"a unit", USUAL, false, 2, {{0, 0}, {1, 0}}, "0,0 1,0"},
    /* corners, and bends that are none */
    {"round a corner",
     USUAL,
     false,
     3,
     {{0, 0}, {6500, 0}, {6500, 6500}},
     "0,0 2750,0; 3750,0 6500,0 6500,2750; 6500,3750 6500,6500"},
    {"back on itself",
     USUAL,
     false,
     3,
     {{0, 0}, {6500, 0}, {1000, 0}},
     "0,0 2750,0; 3750,0 6500,0 4194,0; 3306,0 1000,0"},
    {"a corner of 10 degrees between long sides",
     USUAL,
     false,
     3,
     {{0, 0}, {6500, 0}, {12901, 1129}},
     "0,0 2750,0; 3750,0 6500,0 9208,478; 10193,651 12901,1129"},
    {"a side too short for a gap is drawn whole, and with what it joins",
     USUAL,
     false,
     4,
     {{0, 0}, {6500, 0}, {6500, 700}, {0, 700}},
     "0,0 2750,0; 3750,0 6500,0 6500,700 3750,700; 2750,700 0,700"},
    {"nothing but short sides", USUAL, false, 4, {{0, 0}, {700, 0}, {700, 700}, {0, 700}}, "0,0 700,0 700,700 0,700"},
    {"straight on: one line", USUAL, false, 3, {{0, 0}, {3000, 0}, {6500, 0}}, "0,0 2750,0; 3750,0 6500,0"},
    {"bent by rounding", USUAL, false, 4, {{0, 0}, {100, 1}, {3000, 1}, {6500, 0}}, "0,0 100,1 2750,1; 3750,1 6500,0"},
    {"a curve of short sides",
     USUAL,
     false,
     5,
     {{0, 0}, {1600, 0}, {3200, 100}, {4800, 400}, {6400, 900}},
     "0,0 1600,0 2751,72; 3742,202 4800,400 6400,900"},
    /* closed */
    {"a square",
     USUAL,
     true,
     4,
     {{0, 0}, {6500, 0}, {6500, 6500}, {0, 6500}},
     "3750,0 6500,0 6500,2750; 6500,3750 6500,6500 3750,6500; 2750,6500 0,6500 0,3750; 0,2750 0,0 2750,0"},
    {"its start is none of its corners",
     USUAL,
     true,
     5,
     {{3000, 0}, {6500, 0}, {6500, 6500}, {0, 6500}, {0, 0}},
     "6500,3750 6500,6500 3750,6500; 2750,6500 0,6500 0,3750; 0,2750 0,0 2750,0; 3750,0 6500,0 6500,2750"},
    {"it begins with a short side",
     USUAL,
     true,
     4,
     {{0, 0}, {700, 0}, {700, 6500}, {0, 6500}},
     "700,3750 700,6500 0,6500 0,3750; 0,2750 0,0 700,0 700,2750"},
    {"one gap in all", USUAL, true, 3, {{0, 0}, {800, 0}, {400, 500}}, "650,0 800,0 400,500 0,0 150,0"},
    {"too small for gaps", USUAL, true, 4, {{0, 0}, {700, 0}, {700, 700}, {0, 700}}, "0,0 700,0 700,700 0,700 closed"},
    /* other patterns */
    {"no gap was asked for: dashes touch", {3000, 0, 250}, false, 2, {{0, 0}, {5750, 0}}, "0,0 2750,0; 3000,0 5750,0"},
    {"a gap finer than the pen stays as fine",
     {1000, 100, 250},
     false,
     2,
     {{0, 0}, {1850, 0}},
     "0,0 750,0; 1100,0 1850,0"},
    {"dots", {250, 500, 250}, false, 2, {{0, 0}, {1506, 0}}, "0,0 2,0; 752,0 754,0; 1504,0 1506,0"},
    {"dots closer together, none longer or shorter",
     {250, 500, 250},
     false,
     2,
     {{0, 0}, {602, 0}},
     "0,0 2,0; 600,0 602,0"},
    {"no room for two dots and the pen's width between", {250, 500, 250}, false, 2, {{0, 0}, {503, 0}}, "0,0 503,0"},
};

static void lines_get_their_dashes(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        polylines p = {0};
        char text[1000];
        append(&p, cases[i].point, (size_t)cases[i].count, cases[i].closed);
        assert_int_equal(dashes_cut(&p, 0, &cases[i].pattern, NULL), ROBERTS_OK);
        print_lines(&p, text, sizeof text);
        print_message("%s: %s\n", cases[i].name, text);
        assert_string_equal(text, cases[i].wanted);
        polylines_free(&p);
    }
}

/* Closed lines without corners, from a curve too small for one gap to a large one: dashes and gaps are alike
 * all round. */
static void curves_come_round(void **state)
{
    enum { SIDES = 90 };
    page_point point[SIDES];
    (void)state;
    for (int radius = 20; radius < 20000; radius += radius / 10 + 1) {
        polylines p = {0};
        double round = 0.0, down = 0.0;
        for (int i = 0; i < SIDES; i++)
            point[i] = (page_point){page_round(radius * cos(2 * 3.14159265358979 * i / SIDES)),
                                    page_round(radius * sin(2 * 3.14159265358979 * i / SIDES))};
        for (int i = 0; i < SIDES; i++)
            round += page_distance(point[i], point[(i + 1) % SIDES]);
        append(&p, point, SIDES, true);
        assert_int_equal(dashes_cut(&p, 0, &usual, NULL), ROBERTS_OK);
        for (uint32_t k = 1; k < p.item[0].count; k++)
            down += page_distance(p.point[k - 1], p.point[k]);
        print_message("%.0f round: %zu dashes, the first %.0f\n", round, p.count, down);
        if (p.item[0].closed) {
            assert_true(p.count == 1 &&
                        round < 875.0 + 1.0); /* less than the least dash, 375, and gap, 250, but for ... */
        } else {
            assert_true(round >= 625.0);
            assert_int_equal(p.count, fmax(1.0, floor(round / 3750.0 + 0.5)));
            assert_true(round / (double)p.count - down > 500.0 - 2.0);
        }
        polylines_free(&p);
    }
}

/* For all polylines: dashes lie on their line, in its order; both ends and every corner are drawn; no gap is shorter
 * than twice the pen's width, and each side that is three widths long has one. */
static void any_line_is_dashed(void **state)
{
    enum { TRIALS = 3000, MOST = 12 };
    rng r = {1};
    (void)state;
    for (int trial = 0; trial < TRIALS; trial++) {
        page_point point[MOST] = {{0, 0}};
        size_t count = 2 + rng_next(&r) % (MOST - 1), at = 0;
        int64_t step = trial % 3 == 0 ? 500 : trial % 3 == 1 ? 3000 : 30000;
        count = count > MOST ? MOST : count;
        for (size_t i = 1; i < count; i++) { /* right angles, so that the direction tells the side */
            int32_t way = (int32_t)(10 + rng_next(&r) % (uint64_t)step) * (rng_next(&r) % 2 ? 1 : -1);
            point[i] = (page_point){point[i - 1].x + (i % 2 ? way : 0), point[i - 1].y + (i % 2 ? 0 : way)};
        }
        polylines p = {0};
        append(&p, point, count, false);
        assert_int_equal(dashes_cut(&p, 0, &usual, NULL), ROBERTS_OK);
        page_point pen = p.point[0];
        int gaps = 0;
        assert_true(pen.x == point[0].x && pen.y == point[0].y);
        for (size_t i = 0; i < p.count; i++)
            for (uint32_t k = 0; k < p.item[i].count; k++) {
                page_point to = p.point[p.item[i].first + k];
                page_point goal = point[at + 1];
                double left = page_distance(pen, goal), way = page_distance(pen, to);
                if (i == 0 && k == 0)
                    continue;
                assert_true(fabs(way + page_distance(to, goal) - left) < 1e-6); /* on the side, and beyond */
                if (k == 0) {
                    assert_true(way >= 2 * usual.width - 1.0);
                    gaps++;
                }
                pen = to;
                if (to.x == goal.x && to.y == goal.y) {
                    assert_true(k > 0);
                    assert_int_equal(gaps > 0, page_distance(point[at], goal) >= 3 * usual.width);
                    gaps = 0;
                    at++;
                }
            }
        assert_int_equal(at, count - 1);
        polylines_free(&p);
    }
}

static void classes_before_stay(void **state)
{
    polylines p = {0};
    char text[200];
    (void)state;
    append(&p, (page_point[]){{0, 0}, {6500, 0}, {6500, 9}}, 3, true);
    append(&p, (page_point[]){{0, 0}, {6500, 0}}, 2, false);
    assert_int_equal(dashes_cut(&p, 1, &usual, NULL), ROBERTS_OK);
    print_lines(&p, text, sizeof text);
    assert_string_equal(text, "0,0 6500,0 6500,9 closed; 0,0 2750,0; 3750,0 6500,0");
    polylines_free(&p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines_get_their_dashes),
        cmocka_unit_test(curves_come_round),
        cmocka_unit_test(any_line_is_dashed),
        cmocka_unit_test(classes_before_stay),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
