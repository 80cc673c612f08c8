/* test_oracle.c - the oracle against cases worked out by hand, against itself without intervals of doubles and against
 * plain rays; then the program against the oracle on some scenes of each family (more: make check-long). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "oracle/judge.h"
#include "folders.h"
#include "make_mesh.h"
#include "rng.h"
#include "testing.h"

/* ---- by hand --------------------------------------------------------------------------------------------------- */

/* clang-format off */
#define TOP {.z = 1}
#define CORNER {.x = 1, .y = 1, .z = 1}
#define ONE_CUBE {0, 0, 0}, {0, 0, 0}

/* The unit cube, a second box where its two corners differ, and a tetrahedron; judged is the tetrahedron's edge from
 * its first to its second point. The third and fourth point lie so that it has a front face unless the case says
 * otherwise. */
static const struct {
    const char *name;
    oracle_view view;
    roberts_vec3 lo, hi;
    roberts_vec3 p[4];
    oracle_answer survives;
    size_t count;
    oracle_interval hidden[2];
} cases[] = {
    {"passes below the cube", TOP, ONE_CUBE,
     {{-1, 0.5, -1}, {2, 0.5, -1}, {0, 0.6, -2}, {0, 0.4, -2}}, ORACLE_YES, 1, {{1.0 / 3, 2.0 / 3}}},
    {"passes above it", TOP, ONE_CUBE,
     {{-1, 0.5, 2}, {2, 0.5, 2}, {0, 0.6, 1.5}, {0, 0.4, 1.5}}, ORACLE_YES, 0, {{0, 0}}},
    {"ends below it", TOP, ONE_CUBE,
     {{0.5, 0.5, -1}, {0.5, 2.5, -1}, {0, 0.6, -2}, {1, 0.4, -2}}, ORACLE_YES, 1, {{0, 0.25}}},
    {"lies wholly below it", TOP, ONE_CUBE,
     {{0.25, 0.5, -1}, {0.5, 0.5, -1}, {0, 0.6, -2}, {0, 0.4, -2}}, ORACLE_YES, 1, {{0, 1}}},
    {"along its border, from below", TOP, ONE_CUBE,
     {{-1, 0, -1}, {2, 0, -1}, {0, -0.1, -2}, {0, 0.1, -2}}, ORACLE_YES, 1, {{1.0 / 3, 2.0 / 3}}},
    {"just outside its border", TOP, ONE_CUBE,
     {{-1, -1e-12, -1}, {2, -1e-12, -1}, {0, -0.1, -2}, {0, 0.1, -2}}, ORACLE_YES, 0, {{0, 0}}},
    {"along its upper edge: in the plane of a face", TOP, ONE_CUBE,
     {{-1, 0, 1}, {2, 0, 1}, {0, -0.1, -2}, {0, 0.1, -2}}, ORACLE_YES, 0, {{0, 0}}},
    {"in the plane of its upper face", TOP, ONE_CUBE,
     {{-1, 0.5, 1}, {2, 0.5, 1}, {0, 0.4, -2}, {0, 0.6, -2}}, ORACLE_YES, 0, {{0, 0}}},
    {"just below that plane", TOP, ONE_CUBE,
     {{-1, 0.5, 1 - 1e-12}, {2, 0.5, 1 - 1e-12}, {0, 0.4, -2}, {0, 0.6, -2}}, ORACLE_YES, 1, {{1.0 / 3, 2.0 / 3}}},
    {"touches a corner of its projection", TOP, ONE_CUBE,
     {{-1, 1, -1}, {1, -1, -1}, {0, 0.1, -2}, {0, -0.1, -2}}, ORACLE_YES, 0, {{0, 0}}},
    {"enters exactly at a corner", TOP, ONE_CUBE,
     {{-1, -1, -1}, {3, 3, -1}, {1, 0.9, -2}, {1, 1.1, -2}}, ORACLE_YES, 1, {{0.25, 0.5}}},
    {"ends on its upper face from below", TOP, ONE_CUBE,
     {{0.25, 0.5, 0}, {0.75, 0.5, 1}, {0, 0.4, -2}, {0, 0.6, -2}}, ORACLE_YES, 1, {{0, 1}}},
    {"stands on its upper face", TOP, ONE_CUBE,
     {{0.25, 0.5, 1}, {0.75, 0.5, 2}, {0.75, 0.4, 1}, {0.75, 0.6, 1}}, ORACLE_YES, 0, {{0, 0}}},
    {"pierces its upper face", TOP, ONE_CUBE,
     {{0.25, 0.5, 0}, {0.75, 0.5, 2}, {0, 0.4, -2}, {0, 0.6, -2}}, ORACLE_YES, 1, {{0, 0.5}}},
    {"has an end within, below a side", TOP, ONE_CUBE,
     {{0.5, 0.5, 0.5}, {2.5, 0.5, 0.5}, {1, 0.4, -2}, {1, 0.6, -2}}, ORACLE_YES, 1, {{0, 0.25}}},
    {"seen end-on: no face is front", TOP, ONE_CUBE,
     {{3, 3, 0}, {3, 3, 1}, {4, 3, 0}, {3, 4, 0}}, ORACLE_NO, 1, {{0, 1}}},
    {"on the far side of its solid", TOP, ONE_CUBE,
     {{3, 3, 0}, {4, 3, 0}, {3, 4, 0}, {3.5, 3.25, 1}}, ORACLE_YES, 0, {{0, 0}}},
    {"the same, turned over", TOP, ONE_CUBE,
     {{3, 3, 0}, {4, 3, 0}, {3.5, 4, 1}, {3.5, 2, 1}}, ORACLE_NO, 1, {{0, 1}}},
    {"below two boxes that touch", TOP, {1, 0, 0}, {2, 1, 3},
     {{-1, 0.5, -1}, {3, 0.5, -1}, {0, 0.6, -2}, {0, 0.4, -2}}, ORACLE_YES, 1, {{0.25, 0.75}}},
    {"below two boxes apart", TOP, {2, 0, 0}, {3, 1, 3},
     {{-1, 0.5, -1}, {3, 0.5, -1}, {0, 0.6, -2}, {0, 0.4, -2}}, ORACLE_YES, 2, {{0.25, 0.5}, {0.75, 1}}},
    {"below the seam of two boxes", TOP, {1, 0, 0}, {2, 1, 3},
     {{1, 0, -1}, {1, 2, -1}, {0, 0, -2}, {2, 0, -2}}, ORACLE_YES, 1, {{0, 0.5}}},
    {"behind the hexagon, near its middle", CORNER, ONE_CUBE,
     {{-3.5, -3, -3}, {-3, -3.5, -3}, {-4, -4, -3}, {-4, -4, -6}}, ORACLE_YES, 1, {{0, 1}}},
    {"behind the hexagon, along its border", CORNER, ONE_CUBE,
     {{-1, -2, -2}, {-1, 1, -2}, {-1, 0, -4}, {-3, 0, -3}}, ORACLE_YES, 1, {{0, 1.0 / 3}}},
    {"from an eye above the middle", {.x = 0.5, .y = 0.5, .z = 5, .w = 1}, ONE_CUBE,
     {{-1.5, 0.5, -3}, {2.5, 0.5, -3}, {0, 0.6, -5}, {0, 0.4, -5}}, ORACLE_YES, 1, {{0.25, 0.75}}},
    {"from an eye, along the border", {.x = 0.5, .y = 0.5, .z = 5, .w = 1}, ONE_CUBE,
     {{-1.5, -0.5, -3}, {2.5, -0.5, -3}, {0, 0.6, -5}, {0, -1, -5}}, ORACLE_YES, 1, {{0.25, 0.75}}},
};
/* clang-format on */

static void test_by_hand(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        roberts_mesh mesh = {0};
        oracle_result result;
        const oracle_edge *e;
        uint32_t first;
        mesh_box(&mesh, (roberts_vec3){0, 0, 0}, (roberts_vec3){1, 1, 1});
        if (cases[i].hi.x > cases[i].lo.x)
            mesh_box(&mesh, cases[i].lo, cases[i].hi);
        first = (uint32_t)mesh.vertex_count;
        mesh_tetrahedron(&mesh, cases[i].p);
        if (!oracle_run(&mesh, &cases[i].view, NULL, &result))
            fail_msg("%s: %s", cases[i].name, result.error);
        for (e = result.edge; e->v0 != first || e->v1 != first + 1; e++)
            assert_true(e < result.edge + result.edge_count);
        if (e->survives != cases[i].survives || e->sure_count != cases[i].count)
            fail_msg("%s: survives %d, %zu intervals", cases[i].name, e->survives, e->sure_count);
        for (size_t k = 0; k < cases[i].count; k++) {
            const oracle_interval *got = result.interval + e->sure + k, *want = cases[i].hidden + k;
            if (fabs(got->t0 - want->t0) > 1e-15 || fabs(got->t1 - want->t1) > 1e-15)
                fail_msg("%s: [%.17g, %.17g]", cases[i].name, got->t0, got->t1);
        }
        oracle_free(&result);
        roberts_mesh_free(&mesh);
    }
}

/* clang-format off */
/* From an eye above the middle of the unit cube, with a near plane half way down it: the cube's section hides what lies
 * behind it. Judged is the edge from the first to the second point of a tetrahedron, and what is left of it. */
static const struct {
    const char *name;
    roberts_vec3 p[4];
    double t0, t1;
    size_t count;
    oracle_interval hidden;
} near_cases[] = {
    {"behind the section", {{-2.5, 0.5, -4}, {3.5, 0.5, -4}, {0, 0.6, -6}, {0, 0.4, -6}}, 0, 1, 1, {1.0 / 3, 2.0 / 3}},
    {"from the section away", {{0.5, 0.5, 0.5}, {0.5, 2.5, -4}, {0.7, 1, -5}, {0.3, 1, -5}}, 0, 1, 1, {0, 1.0 / 3}},
    {"through the near plane", {{2, 0.5, 2}, {2, 0.5, -4}, {2.5, 0.6, -6}, {2.5, 0.4, -6}}, 0.25, 1, 0, {0, 0}},
    {"before the near plane", {{-1, 0.5, 2}, {2, 0.5, 2}, {0, 0.6, -6}, {0, 0.4, -6}}, 1, 1, 0, {0, 0}},
    {"in the near plane", {{2, 0, 0.5}, {2, 1, 0.5}, {2.8, 0.5, -0.9}, {2.2, 0.5, -1.1}}, 0, 1, 0, {0, 0}},
    {"in a section", {{2, 0, 0.5}, {2, 1, 0.5}, {2.8, 0.5, 0.9}, {2.2, 0.5, -1.1}}, 1, 1, 0, {0, 0}},
    {"all before, but for this edge", {{2, 0, 0.5}, {2, 1, 0.5}, {2.8, 0.5, 0.9}, {2.2, 0.5, 1}}, 1, 1, 0, {0, 0}},
};
/* clang-format on */

static void test_near(void **state)
{
    oracle_view view = {.x = 0.5, .y = 0.5, .z = 5, .w = 1, .cut = true, .near = {0.5, 0.5, 0.5}};
    (void)state;
    for (size_t i = 0; i < sizeof near_cases / sizeof *near_cases; i++) {
        roberts_mesh mesh = {0};
        oracle_result result;
        const oracle_edge *e;
        mesh_box(&mesh, (roberts_vec3){0, 0, 0}, (roberts_vec3){1, 1, 1});
        mesh_tetrahedron(&mesh, near_cases[i].p);
        if (!oracle_run(&mesh, &view, NULL, &result))
            fail_msg("%s: %s", near_cases[i].name, result.error);
        for (e = result.edge; e->v0 != 8 || e->v1 != 9; e++)
            assert_true(e < result.edge + result.edge_count);
        if (fabs(e->t0 - near_cases[i].t0) > 1e-15 || fabs(e->t1 - near_cases[i].t1) > 1e-15)
            fail_msg("%s: left is [%.17g, %.17g]", near_cases[i].name, e->t0, e->t1);
        if (e->sure_count != near_cases[i].count)
            fail_msg("%s: %zu intervals", near_cases[i].name, e->sure_count);
        if (e->sure_count && (fabs(result.interval[e->sure].t0 - near_cases[i].hidden.t0) > 1e-15 ||
                              fabs(result.interval[e->sure].t1 - near_cases[i].hidden.t1) > 1e-15))
            fail_msg("%s: [%.17g, %.17g]", near_cases[i].name, result.interval[e->sure].t0,
                     result.interval[e->sure].t1);
        oracle_free(&result);
        roberts_mesh_free(&mesh);
    }
}

/* What a slack means: an edge in the plane of a face may be hidden or not, one that pierces it only near there. */
static void test_slack(void **state)
{
    static const struct {
        const char *name;
        roberts_vec3 p[4];
        double sure, maybe;
    } slack_cases[] = {
        {"in the plane of the face", {{-1, 0.5, 1}, {2, 0.5, 1}, {0, 0.4, -2}, {0, 0.6, -2}}, 0, 1.0 / 3},
        {"a little below it", {{-1, 0.5, 1 - 1e-3}, {2, 0.5, 1 - 1e-3}, {0, 0.4, -2}, {0, 0.6, -2}}, 1.0 / 3, 1.0 / 3},
        {"a little above it", {{-1, 0.5, 1 + 1e-3}, {2, 0.5, 1 + 1e-3}, {0, 0.4, -2}, {0, 0.6, -2}}, 0, 0},
        {"along the border", {{-1, 0, -1}, {2, 0, -1}, {0, -0.1, -2}, {0, 0.1, -2}}, 0, 1.0 / 3},
        {"pierces it", {{0.25, 0.5, 0}, {0.75, 0.5, 2}, {0, 0.4, -2}, {0, 0.6, -2}}, 0.5, 0.5},
    };
    (void)state;
    for (size_t i = 0; i < sizeof slack_cases / sizeof *slack_cases; i++) {
        roberts_mesh mesh = {0};
        oracle_result result;
        oracle_options options = {1e-9, false};
        oracle_view view = TOP;
        oracle_interval all = {0, 1};
        const oracle_edge *e;
        mesh_box(&mesh, (roberts_vec3){0, 0, 0}, (roberts_vec3){1, 1, 1});
        mesh_tetrahedron(&mesh, slack_cases[i].p);
        assert_true(oracle_run(&mesh, &view, &options, &result));
        for (e = result.edge; e->v0 != 8 || e->v1 != 9; e++)
            assert_true(e < result.edge + result.edge_count);
        double sure = 1 - judge_outside(&all, 1, result.interval + e->sure, e->sure_count);
        double maybe = 1 - judge_outside(&all, 1, result.interval + e->maybe, e->maybe_count);
        if (fabs(sure - slack_cases[i].sure) > 2e-8 || fabs(maybe - slack_cases[i].maybe) > 2e-8 || sure > maybe)
            fail_msg("%s: sure %.17g, maybe %.17g", slack_cases[i].name, sure, maybe);
        oracle_free(&result);
        roberts_mesh_free(&mesh);
    }
}

static void test_refusals(void **state)
{
    static const roberts_vec3 flat[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    static const unsigned char open_face[] = {3, 0, 1, 2, 0};
    roberts_mesh mesh = {0};
    oracle_result result;
    oracle_view view = TOP, before = {.x = 0.5, .y = 0.5, .z = 1.5, .w = 1};
    (void)state;
    mesh_tetrahedron(&mesh, flat);
    assert_false(oracle_run(&mesh, &view, NULL, &result));
    assert_string_not_equal(result.error, "");
    roberts_mesh_free(&mesh);
    mesh_solid(&mesh, flat, 4, open_face);
    assert_false(oracle_run(&mesh, &view, NULL, &result));
    roberts_mesh_free(&mesh);
    mesh_box(&mesh, (roberts_vec3){0, 0, 0}, (roberts_vec3){1, 1, 1});
    mesh_box(&mesh, (roberts_vec3){0, 0, 2}, (roberts_vec3){1, 1, 3});
    oracle_view within = {.x = 0.5, .y = 0.5, .z = 2.5, .w = 1, .cut = true, .near = {0.5, 0.5, 0.5}};
    assert_false(oracle_run(&mesh, &before, NULL, &result)); /* and no near plane */
    assert_false(oracle_run(&mesh, &within, NULL, &result));
    roberts_mesh_free(&mesh);
}

/* ---- the oracle against itself --------------------------------------------------------------------------------- */

/* Rational numbers throughout are slow, so larger scenes are left out; others have the same solids. */
enum { FILTER_CORNERS = 600, RAYS = 12, RAYS_CORNERS = 8000 };

/* Intervals of doubles tried first, or rational numbers throughout: the same answers, ends to 1e-14. */
static void test_filter(void **state)
{
    size_t compared = 0;
    (void)state;
    for (size_t f = 0; f < scene_family_count(); f++) {
        test_scene scene;
        oracle_result fast, slow;
        assert_true(scene_make(scene_family_name(f), 1, &scene));
        if (scene.mesh.corner_count > FILTER_CORNERS) {
            test_scene_free(&scene);
            continue;
        }
        compared++;
        oracle_options options = {scene.slack, false}, exact = {scene.slack, true};
        assert_true(oracle_run(&scene.mesh, &scene.view, &options, &fast));
        assert_true(oracle_run(&scene.mesh, &scene.view, &exact, &slow));
        assert_int_equal(fast.edge_count, slow.edge_count);
        assert_int_equal(fast.interval_count, slow.interval_count);
        for (size_t i = 0; i < fast.edge_count; i++)
            if (fast.edge[i].survives != slow.edge[i].survives || fast.edge[i].maybe != slow.edge[i].maybe)
                fail_msg("%s: edge %zu", scene_family_name(f), i);
        for (size_t i = 0; i < fast.interval_count; i++)
            if (fabs(fast.interval[i].t0 - slow.interval[i].t0) > 1.1e-14 ||
                fabs(fast.interval[i].t1 - slow.interval[i].t1) > 1.1e-14)
                fail_msg("%s: interval %zu", scene_family_name(f), i);
        oracle_free(&fast);
        oracle_free(&slow);
        test_scene_free(&scene);
    }
    print_message("note: %zu families of %zu\n", compared, scene_family_count());
    assert_true(compared > scene_family_count() / 2);
}

static bool within(const oracle_interval *list, size_t count, double t)
{
    for (size_t i = 0; i < count; i++)
        if (list[i].t0 <= t && t <= list[i].t1)
            return true;
    return false;
}

/* Random points of random edges: a ray cast by the definition says what the intervals say. */
static void test_rays(void **state)
{
    size_t points = 0, hidden = 0;
    rng r = {1};
    (void)state;
    for (size_t f = 0; f < scene_family_count(); f++)
        for (uint64_t seed = 100; seed < 101; seed++) {
            test_scene scene;
            oracle_result result;
            assert_true(scene_make(scene_family_name(f), seed, &scene));
            assert_true(oracle_run(&scene.mesh, &scene.view, NULL, &result));
            size_t rays = RAYS * RAYS_CORNERS / (RAYS_CORNERS + RAYS * scene.mesh.corner_count);
            for (size_t k = 0; k < rays && !scene.rough; k++) {
                const oracle_edge *e = result.edge + rng_below(&r, (uint32_t)result.edge_count);
                double t = rng_between(&r, 0, 1);
                if (e->survives != ORACLE_YES || t < e->t0 || t > e->t1)
                    continue;
                oracle_point point = {&scene.mesh, result.vertex_solid, &scene.view, e->v0, e->v1, t, {0, 0, 0}};
                bool ray = oracle_point_hidden(&point);
                if (ray != within(result.interval + e->sure, e->sure_count, t))
                    fail_msg("%s-%u: edge %u-%u at %.17g: the ray says %s", scene_family_name(f), (unsigned)seed, e->v0,
                             e->v1, t, ray ? "hidden" : "visible");
                points++;
                hidden += ray;
            }
            oracle_free(&result);
            test_scene_free(&scene);
        }
    print_message("note: %zu points, %zu of them hidden\n", points, hidden);
    assert_true(hidden > points / 10 && hidden < points - points / 10); /* or it would show nothing */
}

/* ---- scenes ---------------------------------------------------------------------------------------------------- */

/* FNV-1a, of G. Fowler, L. C. Noll and K.-P. Vo. */
static uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t size)
{
    for (const unsigned char *c = bytes; size > 0; size--)
        hash = (hash ^ *c++) * 0x100000001b3u;
    return hash;
}

/* A family and a seed give one scene, in whatever order a compiler evaluates arguments. This holds for families
 * whose coordinates are whole numbers, halves and powers of two. Others differ where sines and roots do. */
static const struct {
    const char *family;
    uint64_t hash; /* of vertices, corners and view, little-endian */
} scene_cases[] = {
    {"hulls", 0x4d1ceffe4b12650cu},  {"blocks", 0xb80a0e59b9838b3du},          {"shaft", 0xb91e4dc4cbf7b215u},
    {"crowd", 0x1ae08c4009eef13eu},  {"touching", 0x166ad64a86304a7cu},        {"sizes", 0x759cf2a1e49f6604u},
    {"nudged", 0x030f7b31d71142c2u}, {"crooked", 0x3d22bdcb42827301u},         {"coins", 0x261fcf1e15099519u},
    {"fans", 0x65a76f66132606b6u},   {"plates-in-parts", 0x2850b3d4b094a3b8u}, {"crowd@oblique", 0x078c489ee2039609u},
};

static void test_scenes_are_the_same(void **state)
{
    const uint16_t one = 1;
    (void)state;
    if (*(const unsigned char *)&one != 1)
        SKIP_BECAUSE("the processor is not little-endian");
    for (size_t i = 0; i < sizeof scene_cases / sizeof *scene_cases; i++) {
        uint64_t hash = 0xcbf29ce484222325u;
        for (uint64_t seed = 1; seed <= 5; seed++) {
            test_scene scene;
            assert_true(scene_make(scene_cases[i].family, seed, &scene));
            const double view[3] = {scene.view.x, scene.view.y, scene.view.z};
            hash = hash_bytes(hash, scene.mesh.vertex, scene.mesh.vertex_count * sizeof *scene.mesh.vertex);
            hash = hash_bytes(hash, scene.mesh.corner, scene.mesh.corner_count * sizeof *scene.mesh.corner);
            hash = hash_bytes(hash, view, sizeof view);
            test_scene_free(&scene);
        }
        print_message("%s: %#018llx\n", scene_cases[i].family, (unsigned long long)hash);
        assert_true(hash == scene_cases[i].hash);
    }
}

/* ---- the program against the oracle ---------------------------------------------------------------------------- */

enum { EDGES_OF_EACH = 500 };

/* Some scenes of each family, until so many of its edges have been compared. */
static void test_program(void **state)
{
    judge_total total = {0};
    (void)state;
    for (size_t f = 0; f < scene_family_count(); f++)
        for (size_t seed = 1, first = total.edges; total.edges < first + EDGES_OF_EACH; seed++) {
            char name[100];
            test_scene scene;
            snprintf(name, sizeof name, "%s-%zu", scene_family_name(f), seed);
            assert_true(scene_make(scene_family_name(f), seed, &scene));
            size_t before = total.edges;
            judge_scene(name, &scene, build_folder(), &total, stderr);
            test_scene_free(&scene);
            if (total.edges == before || total.disagreements > 100)
                break;
        }
    print_message(
        "note: %zu edges of %zu scenes of %zu families compared with the exact oracle: %zu disagreements; left open: "
        "%.5g edges\n",
        total.edges, total.scenes, scene_family_count(), total.disagreements, total.unjudged);
    assert_true(total.cut > total.edges / 20); /* scenes in which little is cut would show little */
    assert_true(total.unjudged < 0.1 * (double)total.edges);
    assert_int_equal(total.disagreements, 0);
}

/* The near plane through edges of solids. */
/* clang-format off */
static const struct {
    const char *name;
    roberts_vec3 box[2][2], eye, near, look_at;
} contact_cases[] = {
    {"what was left of faces as lines made a spike of the outline",
     {{{1, 1, 0}, {2, 2, 1}}, {{0, 2, 0}, {1, 3, 1}}}, {3.5, -0.5, 1.5}, {3.5, 0, 2}, {3.5, 1.5, 3.5}},
    {"far aside, an edge in the near plane lay behind a section there, to rounding",
     {{{1, 7, 133}, {2, 8, 142}}, {{0, 5, 138}, {1, 8, 142}}}, {4, 6, 123.5}, {3.5, 5.5, 123.5}, {-124, -122, 123.5}},
};
/* clang-format on */

static void test_near_contact(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof contact_cases / sizeof *contact_cases; i++) {
        test_scene scene = {.look_at = contact_cases[i].look_at};
        roberts_vec3 eye = contact_cases[i].eye;
        judge_total total = {0};
        scene.view = (oracle_view){eye.x, eye.y, eye.z, 1, true, contact_cases[i].near};
        for (int k = 0; k < 2; k++)
            mesh_box(&scene.mesh, contact_cases[i].box[k][0], contact_cases[i].box[k][1]);
        if (!judge_scene("near-contact", &scene, build_folder(), &total, stderr))
            fail_msg("%s", contact_cases[i].name);
        assert_int_equal(total.edges, 24);
        assert_true(total.clipped > 0 && total.cut > 0);
        test_scene_free(&scene);
    }
}

/* The tip of a tetrahedron lies in from the outline by less than epsilon, over its longest edge: the face there is
 * edge-on, and without it the outline turns inward at the tip. Boxes below the edge, from near the tip to its other
 * end, are cut there, give or take epsilon: also where the tip is so near the edge's end that it turns by no more than
 * rounding. */
static void test_edge_on(void **state)
{
    const double along[] = {0.1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10}, in[] = {3e-11, 2e-14, 1e-15, 1e-16, 0.0};
    (void)state;
    for (int i = 0; i < 35; i++) {
        test_scene scene = {.view = TOP, .slack = 1e-10};
        judge_total total = {0};
        roberts_vec3 tip = {along[i % 7], in[i / 7], 0.1};
        mesh_tetrahedron(&scene.mesh, (roberts_vec3[]){{0, 0, 0}, {1, 0, 0}, {0.5, 0.8, 0}, tip});
        for (int k = 1; k < 10; k++)
            mesh_box(&scene.mesh, (roberts_vec3){0.1 * k, -0.5, -3}, (roberts_vec3){0.1 * k + 0.01, 0.1, -2.9});
        if (!judge_scene("edge-on", &scene, build_folder(), &total, stderr))
            fail_msg("tip at %g, %g", tip.x, tip.y);
        assert_true(total.cut >= 18);
        test_scene_free(&scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_by_hand),
        cmocka_unit_test(test_near),
        cmocka_unit_test(test_slack),
        cmocka_unit_test(test_refusals),
        cmocka_unit_test(test_filter),
        cmocka_unit_test(test_rays),
        cmocka_unit_test(test_scenes_are_the_same),
        cmocka_unit_test(test_program),
        cmocka_unit_test(test_near_contact),
        cmocka_unit_test(test_edge_on),
    };
    return cmocka_run_group_tests_name("oracle", tests, NULL, NULL);
}
