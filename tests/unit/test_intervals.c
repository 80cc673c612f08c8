/* Hidden parts of an edge: joined as they come, and the union of all, with every tie. */
#include <stdio.h>

#include "hide/intervals.h"
#include "scenes.h"

enum { PARTS = 8 };

/* A part as the tables have it: its ends, and how far it reaches beyond them. */
typedef struct row {
    double t0, t1, e0, e1;
} row;

static hide_interval part_of(row r)
{
    return (hide_interval){r.t0, r.t1, r.t0 - r.e0, r.t1 + r.e1};
}

/* ---- as they come ---------------------------------------------------------------------------------------------- */

/* Two parts, added in both orders: they stay two, or they join; their reach is kept. */
static void joined_as_they_come(void **state)
{
    static const struct {
        const char *name;
        row first, second;
        size_t count;
        double t0, t1, reach0, reach1; /* of the joined one */
    } table[] = {
        {"beside", {0.125, 0.25, 0, 0}, {0.5, 0.75, 0, 0}, 2, 0, 0, 0, 0},
        {"beside within reach", {0.125, 0.25, 0, 0.125}, {0.5, 0.75, 0.125, 0}, 1, 0.125, 0.75, 0.125, 0.75},
        {"ends meet", {0.125, 0.5, 0, 0}, {0.5, 0.75, 0, 0}, 1, 0.125, 0.75, 0.125, 0.75},
        {"overlapping", {0.125, 0.5, 0.0625, 0}, {0.25, 0.75, 0, 0.125}, 1, 0.125, 0.75, 0.0625, 0.875},
        {"inside, reaching farther", {0.25, 0.75, 0, 0}, {0.5, 0.625, 0.5, 0.25}, 1, 0.25, 0.75, 0, 0.875},
        {"the same", {0, 1, 0, 0}, {0, 1, 0, 0}, 1, 0, 1, 0, 1},
    };
    (void)state;
    for (size_t i = 0; i < 2 * (sizeof table / sizeof table[0]); i++) {
        hide_intervals intervals = {0};
        size_t k = i / 2;
        hide_interval one = part_of(i % 2 ? table[k].second : table[k].first);
        hide_interval other = part_of(i % 2 ? table[k].first : table[k].second);
        assert_true(hide_intervals_add(&intervals, 5, &one));
        assert_true(hide_intervals_add(&intervals, 7, &other));
        hide_interval part = intervals.item[0].part;
        if (intervals.count != table[k].count ||
            (intervals.count == 1 && (part.t0 != table[k].t0 || part.t1 != table[k].t1 || part.r0 != table[k].reach0 ||
                                      part.r1 != table[k].reach1)))
            fail_msg("%s: %zu parts, %g..%g, %g, %g", table[k].name, intervals.count, part.t0, part.t1, part.r0,
                     part.r1);
        free(intervals.item);
    }
}

/* ---- their union ----------------------------------------------------------------------------------------------- */

static void fill(hide_intervals *intervals, const hide_interval *part, const uint32_t *order, uint32_t count)
{
    intervals->count = 0;
    for (uint32_t i = 0; i < count; i++) {
        hide_interval one = part[order[i]];
        assert_true(hide_intervals_add(intervals, order[i], &one));
    }
}

static uint32_t count_of(const row *part)
{
    uint32_t count = 0;
    while (count < PARTS && part[count].t1 > 0.0)
        count++;
    return count;
}

static bool equal(const hide_intervals *intervals, const row *expected)
{
    if (intervals->count != count_of(expected))
        return false;
    for (size_t i = 0; i < intervals->count; i++)
        if (intervals->item[i].part.t0 != expected[i].t0 || intervals->item[i].part.t1 != expected[i].t1)
            return false;
    return true;
}

/* Each in ten orders. */
static void union_by_table(void **state)
{
    static const struct {
        const char *name;
        double epsilon, length;
        row intervals[PARTS], expected[PARTS];
    } table[] = {
        {"none", 0, 1, {{0, 0, 0, 0}}, {{0, 0, 0, 0}}},
        {"one", 0, 1, {{0.25, 0.5, 0, 0}}, {{0.25, 0.5, 0, 0}}},
        {"the whole edge", 0, 1, {{0, 1, 0, 0}}, {{0, 1, 0, 0}}},
        {"apart", 0, 1, {{0.25, 0.5, 0, 0}, {0.625, 0.75, 0, 0}}, {{0.25, 0.5, 0, 0}, {0.625, 0.75, 0, 0}}},
        {"overlapping", 0, 1, {{0.25, 0.5, 0, 0}, {0.375, 0.75, 0, 0}}, {{0.25, 0.75, 0, 0}}},
        {"one in the other", 0, 1, {{0.25, 0.75, 0, 0}, {0.375, 0.5, 0, 0}}, {{0.25, 0.75, 0, 0}}},
        {"ends that touch", 0, 1, {{0.25, 0.5, 0, 0}, {0.5, 0.75, 0, 0}}, {{0.25, 0.75, 0, 0}}},
        {"the same beginning", 0, 1, {{0.25, 0.5, 0, 0}, {0.25, 0.75, 0, 0}}, {{0.25, 0.75, 0, 0}}},
        {"the same end", 0, 1, {{0.25, 0.75, 0, 0}, {0.5, 0.75, 0, 0}}, {{0.25, 0.75, 0, 0}}},
        {"the same twice", 0, 1, {{0.25, 0.75, 0, 0}, {0.25, 0.75, 0, 0}}, {{0.25, 0.75, 0, 0}}},
        {"a chain",
         0,
         1,
         {{0.125, 0.25, 0, 0}, {0.25, 0.375, 0, 0}, {0.375, 0.5, 0, 0}, {0.5, 0.625, 0, 0}},
         {{0.125, 0.625, 0, 0}}},
        {"a long one over two short ones",
         0,
         1,
         {{0.125, 0.875, 0, 0}, {0.25, 0.375, 0, 0}, {0.5, 0.625, 0, 0}},
         {{0.125, 0.875, 0, 0}}},
        {"three in two groups",
         0,
         1,
         {{0.125, 0.25, 0, 0}, {0.5, 0.75, 0, 0}, {0.25, 0.375, 0, 0}},
         {{0.125, 0.375, 0, 0}, {0.5, 0.75, 0, 0}}},
        {"all the edge in pieces", 0, 1, {{0, 0.5, 0, 0}, {0.5, 1, 0, 0}}, {{0, 1, 0, 0}}},
        /* epsilon is a length, gaps are parameters: 1/8 of an edge of 4 is 1/2 */
        {"a gap of epsilon", 0.5, 4, {{0.25, 0.5, 0, 0}, {0.625, 0.75, 0, 0}}, {{0.25, 0.75, 0, 0}}},
        {"a gap of more", 0.499, 4, {{0.25, 0.5, 0, 0}, {0.625, 0.75, 0, 0}}, {{0.25, 0.5, 0, 0}, {0.625, 0.75, 0, 0}}},
        {"an end within epsilon of the edge's end", 0.5, 4, {{0.125, 0.5, 0, 0}}, {{0, 0.5, 0, 0}}},
        {"... and the other", 0.5, 4, {{0.5, 0.875, 0, 0}}, {{0.5, 1, 0, 0}}},
        {"ends farther than that", 0.499, 4, {{0.125, 0.875, 0, 0}}, {{0.125, 0.875, 0, 0}}},
        /* an end reaches as far as its own tolerance */
        {"the end before reaches", 0, 4, {{0.25, 0.5, 0, 0.125}, {0.625, 0.75, 0, 0}}, {{0.25, 0.75, 0, 0}}},
        {"the end after reaches", 0, 4, {{0.25, 0.5, 0, 0}, {0.625, 0.75, 0.125, 0}}, {{0.25, 0.75, 0, 0}}},
        {"both reach half way", 0, 4, {{0.25, 0.5, 0, 0.0625}, {0.625, 0.75, 0.0625, 0}}, {{0.25, 0.75, 0, 0}}},
        {"neither reaches far enough",
         0,
         4,
         {{0.25, 0.5, 0, 0.06}, {0.625, 0.75, 0.0625, 0}},
         {{0.25, 0.5, 0, 0}, {0.625, 0.75, 0, 0}}},
        {"the other ends' reach does not count",
         0,
         4,
         {{0.25, 0.5, 0.125, 0}, {0.625, 0.75, 0, 0.125}},
         {{0.25, 0.5, 0, 0}, {0.625, 0.75, 0, 0}}},
        /* the second begins later but reaches to before the first */
        {"one that reaches back over another", 0, 4, {{0.25, 0.5, 0, 0}, {0.375, 0.75, 0.25, 0}}, {{0.25, 0.75, 0, 0}}},
        {"the longer one reaches",
         0,
         4,
         {{0.25, 0.5, 0, 0}, {0.3125, 0.5625, 0, 0.0625}, {0.625, 0.75, 0, 0}},
         {{0.25, 0.75, 0, 0}}},
        {"the shorter one reaches farther",
         0,
         4,
         {{0.25, 0.5, 0, 0.125}, {0.3125, 0.5625, 0, 0}, {0.625, 0.75, 0, 0}},
         {{0.25, 0.75, 0, 0}}},
    };
    hide_intervals intervals = {0};
    rng r = {31};
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++)
        for (int k = 0; k < 10; k++) {
            uint32_t order[PARTS], count = count_of(table[i].intervals);
            hide_interval part[PARTS];
            for (uint32_t p = 0; p < count; p++)
                part[p] = part_of(table[i].intervals[p]);
            rng_permutation(&r, order, count);
            fill(&intervals, part, order, count);
            hide_intervals_unite(&intervals, table[i].epsilon, table[i].length);
            if (!equal(&intervals, table[i].expected)) {
                for (size_t p = 0; p < intervals.count; p++)
                    printf("  got %g..%g\n", intervals.item[p].part.t0, intervals.item[p].part.t1);
                fail_msg("%s", table[i].name);
            }
        }
    free(intervals.item);
}

/* Many parts on a scale of 1/1024. In every third round they begin at few places, in every fifth they are so close
 * together that all floats are equal. What is covered stays covered, and nothing else. Between two parts of the union
 * there is something that is not covered. Every order gives the same bits. */
static void union_of_many(void **state)
{
    enum { MANY = 1200, CELLS = 1024 };
    hide_intervals intervals = {0}, again = {0};
    size_t most = 0;
    rng r = {32};
    (void)state;
    for (int k = 0; k < 500; k++) {
        uint32_t count = (uint32_t)rng_int(&r, 1, k % 2 ? 40 : MANY), order[MANY];
        hide_interval part[MANY];
        bool covered[CELLS] = {false};
        double low = k % 5 ? 0.0 : 0.5, unit = k % 5 ? 1.0 / CELLS : 0x1p-40;
        for (uint32_t i = 0; i < count; i++) {
            int from =
                rng_int(&r, 0, CELLS / 16 - 1) * (k % 3 ? 1 : 16) + (k % 3 ? rng_int(&r, 0, CELLS * 15 / 16) : 0);
            int to = rng_int(&r, from + 1, from + 8 < CELLS ? from + 8 : CELLS);
            part[i] = part_of((row){low + from * unit, low + to * unit, 0, 0});
            for (int c = from; c < to; c++)
                covered[c] = true;
        }
        rng_permutation(&r, order, count);
        fill(&intervals, part, order, count);
        most = intervals.count > most ? intervals.count : most;
        hide_intervals_unite(&intervals, 0, 1);
        rng_permutation(&r, order, count);
        fill(&again, part, order, count);
        hide_intervals_unite(&again, 0, 1);
        assert_int_equal(intervals.count, again.count);
        for (size_t i = 0; i < intervals.count; i++) {
            hide_interval p = intervals.item[i].part, q = again.item[i].part;
            assert_true(p.t0 == q.t0 && p.t1 == q.t1 && p.t0 < p.t1);
            assert_true(i == 0 || p.t0 > intervals.item[i - 1].part.t1);
            for (int c = (int)((p.t0 - low) / unit); c < (int)((p.t1 - low) / unit); c++) {
                assert_true(covered[c]);
                covered[c] = false;
            }
        }
        for (int c = 0; c < CELLS; c++)
            assert_false(covered[c]);
    }
    assert_true(most > 900); /* those that came after many others were not joined at once */
    free(intervals.item);
    free(again.item);
}

static bool reach_each_other(hide_interval a, hide_interval b)
{
    return a.r0 <= b.r1 && b.r0 <= a.r1;
}

/* Parts that reach one another, directly or through others, become one. All numbers are multiples of 1/4096, so that
 * sums are exact and many tie. */
static void reach_joins_in_any_order(void **state)
{
    enum { MANY = 24 };
    hide_intervals intervals = {0};
    rng r = {33};
    (void)state;
    for (int k = 0; k < 2000; k++) {
        uint32_t count = (uint32_t)rng_int(&r, 2, MANY), order[MANY], group[MANY];
        hide_interval part[MANY];
        for (uint32_t i = 0; i < count; i++) {
            int from = rng_int(&r, 0, 4000), to = from + rng_int(&r, 1, 90);
            double e0 = rng_int(&r, 0, 40) / 4096.0, e1 = rng_int(&r, 0, 40) / 4096.0;
            part[i] = part_of((row){from / 4096.0, to / 4096.0, e0, e1});
            group[i] = i;
        }
        for (uint32_t pass = 0; pass < count; pass++) /* the least number spreads through each group */
            for (uint32_t i = 0; i < count; i++)
                for (uint32_t j = 0; j < count; j++)
                    if (reach_each_other(part[i], part[j]) && group[j] < group[i])
                        group[i] = group[j];
        rng_permutation(&r, order, count);
        fill(&intervals, part, order, count);
        hide_intervals_unite(&intervals, 0, 1);
        size_t groups = 0;
        for (uint32_t g = 0; g < count; g++) {
            double t0 = 2, t1 = -1;
            bool found = group[g] != g;
            for (uint32_t i = 0; i < count; i++)
                if (group[i] == g) {
                    t0 = fmin(t0, part[i].t0);
                    t1 = fmax(t1, part[i].t1);
                }
            groups += group[g] == g;
            for (size_t i = 0; i < intervals.count; i++)
                found = found || (intervals.item[i].part.t0 == t0 && intervals.item[i].part.t1 == t1);
            assert_true(found);
        }
        assert_int_equal(intervals.count, groups);
    }
    free(intervals.item);
}

/* The union names one of its members. */
static void union_names_a_member(void **state)
{
    hide_intervals intervals = {0};
    const hide_interval part[3] = {{0.5, 0.75, 0.5, 0.75}, {0, 0.125, 0, 0.125}, {0.625, 1, 0.625, 1}};
    (void)state;
    fill(&intervals, part, (uint32_t[]){2, 0, 1}, 3);
    hide_intervals_unite(&intervals, 0, 1);
    assert_int_equal(intervals.count, 2);
    assert_int_equal(intervals.item[0].solid, 1);
    assert_true(intervals.item[1].solid == 0 || intervals.item[1].solid == 2);
    free(intervals.item);
}

/* Three faces of each solid, with gaps between them, solid by solid or in turn: one hull of each solid, without
 * a gap. */
static void one_hull_of_each_solid(void **state)
{
    enum { MOST = 200, FACES = 3 };
    static const uint32_t counts[] = {1, 2, 40, MOST}, place[FACES] = {1, 0, 2};
    (void)state;
    for (size_t i = 0; i < 2 * (sizeof counts / sizeof counts[0]); i++) {
        hide_intervals hulls = {0};
        uint32_t count = counts[i / 2];
        bool in_turn = i % 2, met[MOST] = {false};
        for (uint32_t k = 0; k < FACES * count; k++) {
            uint32_t solid = in_turn ? k % count : k / FACES, face = in_turn ? k / count : k % FACES;
            double t0 = solid / 256.0 + place[face] / 1024.0;
            assert_true(hide_intervals_hull(&hulls, solid, &(hide_interval){t0, t0 + 1 / 2048.0, t0, t0 + 1 / 2048.0}));
        }
        hide_intervals_hulls_done(&hulls);
        assert_int_equal(hulls.count, count);
        for (size_t k = 0; k < hulls.count; k++) {
            uint32_t solid = hulls.item[k].solid;
            assert_true(solid < count && !met[solid]);
            met[solid] = true;
            assert_true(hulls.item[k].part.t0 == solid / 256.0);
            assert_true(hulls.item[k].part.t1 == solid / 256.0 + 2 / 1024.0 + 1 / 2048.0);
        }
        free(hulls.item);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(joined_as_they_come),  cmocka_unit_test(union_by_table),
        cmocka_unit_test(union_of_many),        cmocka_unit_test(reach_joins_in_any_order),
        cmocka_unit_test(union_names_a_member), cmocka_unit_test(one_hull_of_each_solid),
    };
    return cmocka_run_group_tests_name("intervals", tests, NULL, NULL);
}
