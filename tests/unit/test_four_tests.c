/* The four tests of src/hide/tests.c, each by itself, with every tie; then all of them together. */
#include <math.h>
#include <stdlib.h>

#include "bare_points.h"
#include "base/box.h"
#include "hide/front_test.h"
#include "testing.h"

#define EPSILON 1e-9

/* Every face is the horizontal unit square or a triangle at z = 0 unless a row tilts it; then A and B. */
enum { CORNERS = 4 };

typedef struct fixture {
    roberts_vec3 P[CORNERS + 2];
    uint32_t corner[CORNERS];
    hide_space space;
    hide_face face;
    hide_edge edge;
    hide_sides sides;
} fixture;

static void set_up(fixture *f, const roberts_vec3 *corners, uint32_t count, roberts_vec3 A, roberts_vec3 B)
{
    roberts_vec3 n;
    *f = (fixture){0};
    for (uint32_t i = 0; i < count; i++) {
        f->P[i] = corners[i];
        f->corner[i] = i;
    }
    f->P[count] = A;
    f->P[count + 1] = B;
    f->space = bare_space(f->P, EPSILON, 1e-16, 10.0);
    n = vec3_cross(vec3_sub(corners[1], corners[0]), vec3_sub(corners[2], corners[0]));
    n = vec3_scale(-1.0 / vec3_length(n), n); /* inward: away from the viewer */
    f->face = (hide_face){.F = {n.x, n.y, n.z, -vec3_dot(n, corners[0])},
                          .corner = f->corner,
                          .count = count,
                          .touch = EPSILON,
                          .limit = EPSILON};
    f->edge = bare_edge(f->P, count, count + 1);
    assert_true(hide_sides_reserve(&f->sides, count));
}

static const roberts_vec3 square[4] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
static const roberts_vec3 ramp[4] = {{0, 0, 0}, {1, 0, 1}, {1, 1, 1}, {0, 1, 0}}; /* z = x */

static void test1_by_table(void **state)
{
    static const struct {
        const char *name;
        roberts_vec3 A, B;
        hide_verdict depth;
    } cases[] = {
        {"both in front", {0.2, 0.5, 1}, {0.8, 0.5, 2}, HIDE_VISIBLE},
        {"in the plane", {0.2, 0.5, 0}, {0.8, 0.5, 0}, HIDE_VISIBLE},
        {"one on, one in front", {0.2, 0.5, 0}, {0.8, 0.5, 1}, HIDE_VISIBLE},
        {"on within epsilon, both sides", {0.2, 0.5, -0.9 * EPSILON}, {0.8, 0.5, 0.9 * EPSILON}, HIDE_VISIBLE},
        {"one behind by more than epsilon", {0.2, 0.5, -1.1 * EPSILON}, {0.8, 0.5, 1}, HIDE_UNDECIDED},
        {"one behind, one in front", {0.2, 0.5, -1}, {0.8, 0.5, 1}, HIDE_UNDECIDED},
        {"one behind, one on", {0.2, 0.5, -1}, {0.8, 0.5, 0}, HIDE_UNDECIDED},
        {"both behind", {0.2, 0.5, -1}, {0.8, 0.5, -2}, HIDE_INVISIBLE},
        {"both behind, one within two epsilons", {0.2, 0.5, -1}, {0.8, 0.5, -1.9 * EPSILON}, HIDE_UNDECIDED},
        {"behind, but far beside the face", {7, 7, -1}, {8, 7, -1}, HIDE_INVISIBLE},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        fixture f, g;
        set_up(&f, square, 4, cases[i].A, cases[i].B);
        set_up(&g, square, 4, cases[i].B, cases[i].A);
        if (hide_test1(&f.face, &f.edge) != cases[i].depth || hide_test1(&g.face, &g.edge) != cases[i].depth)
            fail_msg("%s", cases[i].name);
        free(f.sides.H);
        free(g.sides.H);
    }
}

/* If a face's plane is uncertain far away, the later tests decide everything that is not certainly in front. */
static void test1_of_an_uncertain_plane(void **state)
{
    fixture f;
    (void)state;
    set_up(&f, square, 4, (roberts_vec3){7, 7, 0}, (roberts_vec3){8, 7, 0});
    f.face.limit = EPSILON - 1e-6;
    assert_int_not_equal(hide_test1(&f.face, &f.edge), HIDE_VISIBLE);
    f.edge.A.z = f.edge.B.z = 2e-6;
    assert_int_equal(hide_test1(&f.face, &f.edge), HIDE_VISIBLE);
    f.edge.A.z = f.edge.B.z = -2.0 * EPSILON - 0.5e-6;
    assert_int_equal(hide_test1(&f.face, &f.edge), HIDE_UNDECIDED);
    f.edge.A.z = f.edge.B.z = -2.0 * EPSILON - 2e-6;
    assert_int_equal(hide_test1(&f.face, &f.edge), HIDE_INVISIBLE);
    free(f.sides.H);
}

static void test2_by_table(void **state)
{
    static const struct {
        const char *name;
        roberts_vec3 A, B;
        bool visible;
    } cases[] = {
        {"passes beside", {-1, 2, -1}, {2, 2, -1}, true},
        {"passes beside, askew", {-1, 0, -1}, {1, -2, -1}, true},
        {"touches one corner only", {-1, 1, -1}, {1, -1, -1}, true},
        {"touches one corner within epsilon", {-1 - 0.5 * EPSILON, 1, -1}, {1 - 0.5 * EPSILON, -1, -1}, true},
        {"cuts off less than epsilon", {-1 + 0.5 * EPSILON, 1, -1}, {1 + 0.5 * EPSILON, -1, -1}, false},
        {"cuts off a corner", {-1 + 1e-6, 1, -1}, {1 + 1e-6, -1, -1}, false},
        {"through two opposite corners", {-1, -1, -1}, {2, 2, -1}, false},
        {"along a side", {-1, 0, -1}, {2, 0, -1}, false},
        {"along a side within epsilon", {-1, -0.5 * EPSILON, -1}, {2, -0.5 * EPSILON, -1}, false},
        {"beside a side by more than epsilon", {-1, -3 * EPSILON, -1}, {2, -3 * EPSILON, -1}, true},
        {"crosses", {-1, 0.5, -1}, {2, 0.5, -1}, false},
        {"its line crosses, itself is far away", {5, 0.5, -1}, {6, 0.5, -1}, false},
        {"seen end-on beside", {5, 5, -1}, {5, 5, -2}, false},
        {"seen end-on inside", {0.5, 0.5, -1}, {0.5, 0.5, -2}, false},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        fixture f, g;
        bool expected = cases[i].visible;
        set_up(&f, square, 4, cases[i].A, cases[i].B);
        set_up(&g, square, 4, cases[i].B, cases[i].A);
        if (hide_test2(&f.space, &f.face, &f.edge) != expected || hide_test2(&g.space, &g.face, &g.edge) != expected)
            fail_msg("%s", cases[i].name);
        free(f.sides.H);
        free(g.sides.H);
    }
}

static void test3_by_table(void **state)
{
    static const struct {
        const char *name;
        roberts_vec3 A, B;
        hide_verdict verdict;
    } cases[] = {
        {"both inside", {0.2, 0.5, -1}, {0.8, 0.5, -1}, HIDE_INVISIBLE},
        {"one inside, one on a side", {0.2, 0.5, -1}, {1, 0.5, -1}, HIDE_INVISIBLE},
        {"one inside, one on a corner", {0.2, 0.5, -1}, {1, 1, -1}, HIDE_INVISIBLE},
        {"from side to side", {0, 0.5, -1}, {1, 0.5, -1}, HIDE_INVISIBLE},
        {"along a side, whole", {0, 0, -1}, {1, 0, -1}, HIDE_INVISIBLE},
        {"along a side, part of it", {0.2, 0, -1}, {0.7, 0, -1}, HIDE_INVISIBLE},
        {"along a side, within epsilon outside", {0.2, -0.5 * EPSILON, -1}, {0.7, -0.5 * EPSILON, -1}, HIDE_INVISIBLE},
        {"end-on inside", {0.5, 0.5, -1}, {0.5, 0.5, -3}, HIDE_INVISIBLE},
        {"end-on on a side", {0.5, 0, -1}, {0.5, 0, -3}, HIDE_INVISIBLE},
        {"end-on on a corner", {1, 1, -1}, {1, 1, -3}, HIDE_INVISIBLE},
        {"end-on outside", {1.5, 0.5, -1}, {1.5, 0.5, -3}, HIDE_VISIBLE},
        {"both outside one side", {1.2, 0.5, -1}, {1.5, 0.2, -1}, HIDE_VISIBLE},
        {"one outside, the other on the same side", {1.2, 0.5, -1}, {1, 0.5, -1}, HIDE_VISIBLE},
        {"one outside, the other on a corner", {1.2, 0.9, -1}, {1, 1, -1}, HIDE_VISIBLE},
        {"on the line of a side, beyond it", {1.2, 0, -1}, {2, 0, -1}, HIDE_VISIBLE},
        {"on the line of a side, ends at its corner", {1, 0, -1}, {2, 0, -1}, HIDE_VISIBLE},
        {"runs out along a side", {0.5, 0, -1}, {2, 0, -1}, HIDE_UNDECIDED},
        {"one inside, one outside", {0.5, 0.5, -1}, {2, 0.5, -1}, HIDE_UNDECIDED},
        {"crosses", {-1, 0.5, -1}, {2, 0.5, -1}, HIDE_UNDECIDED},
        {"misses across a corner", {0.5, 1.8, -1}, {1.8, 0.5, -1}, HIDE_UNDECIDED},
        {"outside by more than epsilon", {1 + 2 * EPSILON, 0.5, -1}, {1 + 2 * EPSILON, 0.7, -1}, HIDE_VISIBLE},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        fixture f, g;
        set_up(&f, square, 4, cases[i].A, cases[i].B);
        set_up(&g, square, 4, cases[i].B, cases[i].A);
        if (hide_test3(&f.space, &f.face, &f.edge, &f.sides) != cases[i].verdict ||
            hide_test3(&g.space, &g.face, &g.edge, &g.sides) != cases[i].verdict)
            fail_msg("%s", cases[i].name);
        free(f.sides.H);
        free(g.sides.H);
    }
}

static void test4_by_table(void **state)
{
    static const struct {
        const char *name;
        roberts_vec3 A, B;
        bool hidden;
        double t0, t1;
    } cases[] = {
        {"two crossings", {-1, 0.5, -1}, {2, 0.5, -1}, true, 1.0 / 3, 2.0 / 3},
        {"one crossing, A inside", {0.5, 0.5, -1}, {2.5, 0.5, -1}, true, 0, 0.25},
        {"one crossing, B inside", {2.5, 0.5, -1}, {0.5, 0.5, -1}, true, 0.75, 1},
        {"A on a side, runs through", {0, 0.5, -1}, {4, 0.5, -1}, true, 0, 0.25},
        {"out through a corner", {0, 0, -1}, {2, 2, -1}, true, 0, 0.5},
        {"through two corners", {-1, -1, -1}, {2, 2, -1}, true, 1.0 / 3, 2.0 / 3},
        {"runs out along a side", {0.5, 0, -1}, {2.5, 0, -1}, true, 0, 0.25},
        {"runs along a side, both ends beyond", {-1, 1, -1}, {3, 1, -1}, true, 0.25, 0.5},
        {"misses across a corner", {0.5, 1.8, -1}, {1.8, 0.5, -1}, false, 0, 0},
        {"touches a corner", {0.5, 1.5, -1}, {1.5, 0.5, -1}, false, 0, 0},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        fixture f;
        hide_interval part;
        set_up(&f, square, 4, cases[i].A, cases[i].B);
        assert_int_equal(hide_test3(&f.space, &f.face, &f.edge, &f.sides), HIDE_UNDECIDED);
        if (hide_test4(&f.space, &f.face, &f.edge, &f.sides, &part) != cases[i].hidden)
            fail_msg("%s", cases[i].name);
        if (cases[i].hidden && (fabs(part.t0 - cases[i].t0) > 1e-15 || fabs(part.t1 - cases[i].t1) > 1e-15))
            fail_msg("%s: [%.17g, %.17g]", cases[i].name, part.t0, part.t1);
        free(f.sides.H);
    }
}

/* Tests 1 to 4 in their order; false where F hides nothing of e. */
static bool one_by_one(const hide_space *space, const hide_face *F, const hide_edge *e, hide_sides *sides,
                       hide_interval *part)
{
    sides->tally.pairs++;
    if (hide_test1(F, e) == HIDE_VISIBLE) {
        sides->tally.test1_visible++;
        return false;
    }
    if (!bare_tests_2_to_4(space, F, e, sides, part))
        return false;
    hide_interval inside = *part;
    return hide_pierce(space, F, e, &inside, sides, part) && hide_is_left(space, e, part);
}

/* All four tests, and where AB pierces the face; on the ramp z = x. */
static void all_by_table(void **state)
{
    static const struct {
        const char *name;
        const roberts_vec3 *corners;
        roberts_vec3 A, B;
        bool hidden;
        double t0, t1;
    } cases[] = {
        {"in front", square, {0.2, 0.5, 1}, {0.8, 0.5, 1}, false, 0, 0},
        {"behind", square, {0.2, 0.5, -1}, {0.8, 0.5, -1}, true, 0, 1},
        {"in the plane, crossing the face", square, {-1, 0.5, 0}, {2, 0.5, 0}, false, 0, 0},
        {"in the plane, on a side", square, {0, 0, 0}, {1, 0, 0}, false, 0, 0},
        {"starts on the face and goes behind", square, {0.5, 0.5, 0}, {0.5, 0.75, -1}, true, 0, 1},
        {"starts on the face and comes forward", square, {0.5, 0.5, 0}, {0.5, 0.75, 1}, false, 0, 0},
        {"pierces, end-on", square, {0.5, 0.5, 1}, {0.5, 0.5, -3}, true, 0.25, 1},
        {"pierces, from behind", square, {0.2, 0.5, -1}, {0.8, 0.5, 3}, true, 0, 0.25},
        {"pierces beside the face", square, {-4, 0.5, 1}, {2, 0.5, -5}, true, 4.0 / 6, 5.0 / 6},
        {"pierces beside it the other way", square, {-4, 0.5, -5}, {2, 0.5, 1}, true, 4.0 / 6, 5.0 / 6},
        {"in front over the face, behind beyond", square, {-4, 0.5, 5}, {2, 0.5, -0.5}, false, 0, 0},
        {"pierces a ramp", ramp, {-1, 0.5, 0.25}, {3, 0.5, 0.25}, true, 0.3125, 0.5},
        {"parallel to a ramp, behind", ramp, {-1, 0.5, -2}, {2, 0.5, 1}, true, 1.0 / 3, 2.0 / 3},
        {"parallel to a ramp, in it", ramp, {-1, 0.5, -1}, {2, 0.5, 2}, false, 0, 0},
        {"pierces exactly on the border", ramp, {-1, 0.5, 1}, {1, 0.5, -1}, true, 0.5, 1},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        fixture f;
        hide_interval part;
        f.sides.tally = (roberts_tally){0};
        const roberts_tally *tally = &f.sides.tally;
        set_up(&f, cases[i].corners, 4, cases[i].A, cases[i].B);
        if (one_by_one(&f.space, &f.face, &f.edge, &f.sides, &part) != cases[i].hidden)
            fail_msg("%s", cases[i].name);
        if (cases[i].hidden && (fabs(part.t0 - cases[i].t0) > 1e-15 || fabs(part.t1 - cases[i].t1) > 1e-15))
            fail_msg("%s: [%.17g, %.17g]", cases[i].name, part.t0, part.t1);
        assert_int_equal(tally->pairs, 1);
        assert_int_equal(tally->test1_visible + tally->test2_visible + tally->test3_visible + tally->test3_invisible +
                             tally->test4,
                         1);
        free(f.sides.H);
    }
}

/* Edges so far behind a triangle that its plane is not asked. */
static void deep_by_table(void **state)
{
    static const double slack = SHEET_SLACK * EPSILON;
    static const struct {
        const char *name;
        roberts_vec3 corner[3];
        double z; /* of the edges' nearest point */
        bool perspective, deep;
    } cases[] = {
        {"level, far behind", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, -1, false, true},
        {"in front", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 1, false, false},
        {"a little behind", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, -0.9 * slack, false, false},
        {"behind by more than the slack", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, -1.1 * slack, false, true},
        {"behind the nearest corner only", {{0, 0, 0}, {1, 0, 0}, {0, 1, -2}}, -1, false, false},
        {"steep", {{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 1}}, -1, false, true},
        {"nearly edge-on", {{0, 0, 0}, {1, 0, 0}, {0, 1e-5, 1}}, -1, false, false},
        {"edge-on", {{0, 0, 0}, {1, 0, 0}, {0.5, 0, 1}}, -1, false, false},
        {"as small as rounding", {{0, 0, 0}, {1e-15, 0, 0}, {0, 1e-15, 0}}, -1, false, false},
        {"seen from an eye", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, -1, true, false},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const view seen_by = {.perspective = cases[i].perspective};
        hide_fronts fronts = {.space = bare_space(cases[i].corner, EPSILON, 1e-15, 10.0)};
        box3 own = box3_none, edges = {{-1, -1, -3}, {1, 1, cases[i].z}};
        fronts.space.view = &seen_by;
        for (int k = 0; k < 3; k++)
            box3_add(&own, cases[i].corner[k]);
        const hide_box face = hide_box_around(&own), box = hide_box_around(&edges);
        if (hide_are_deep(&fronts, (uint32_t[]){0, 1, 2}, &face, &box) != cases[i].deep)
            fail_msg("%s", cases[i].name);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test1_by_table), cmocka_unit_test(test1_of_an_uncertain_plane),
        cmocka_unit_test(test2_by_table), cmocka_unit_test(test3_by_table),
        cmocka_unit_test(test4_by_table), cmocka_unit_test(all_by_table),
        cmocka_unit_test(deep_by_table),
    };
    return cmocka_run_group_tests_name("four tests", tests, NULL, NULL);
}
