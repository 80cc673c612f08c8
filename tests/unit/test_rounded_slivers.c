/* test_rounded_slivers.c - slivers of a flat face, with rounded coordinates: no creases, borders or intersections where
 * there are none. */
#include "build_scene.h"
#include "put_text.h"
#include "read/mesh.h"
#include "scenes.h"

#define PI 3.14159265358979323846

/* A model in the making, turned and rounded to six decimals. */
typedef struct turned_text {
    put_text text;
    mat3 turn;
} turned_text;

static void put_point(turned_text *t, double x, double y, double z)
{
    const roberts_vec3 P = mat3_map(t->turn, (roberts_vec3){x, y, z});
    put(&t->text, "%.6f %.6f %.6f\n", P.x, P.y, P.z);
}

static turned_text begin(void)
{
    rng r = {5};
    return (turned_text){put_begin(), mat3_turn(&r)};
}

/* The number of edges of which something is drawn, hidden or not. Rows of an edge follow one another. */
static size_t count_lines_of(turned_text *t, roberts_camera camera, bool rounded, double crease)
{
    roberts_hide_options options = roberts_hide_options_default();
    roberts_verify_options verify = roberts_verify_options_default();
    roberts_verification found;
    roberts_mesh mesh = mesh_of_text(t->text.at);
    roberts_scene *scene = scene_of_mesh(&mesh, &(roberts_scene_options){.rounded = rounded});
    size_t lines = 0;
    options.keep_hidden = true;
    options.crease_auto = verify.crease_auto = false;
    options.crease_degrees = verify.crease_degrees = crease;
    roberts_drawing drawing = drawing_of(scene, &camera, &options);
    for (size_t k = 0; k < drawing.count; k++)
        lines += k == 0 || drawing.segment[k].edge != drawing.segment[k - 1].edge;
    assert_int_equal(roberts_verify(scene, &camera, &drawing, &verify, &found, NULL), ROBERTS_OK);
    assert_int_equal(found.contradictions, 0);
    roberts_drawing_free(&drawing);
    roberts_scene_free(scene);
    roberts_mesh_free(&mesh);
    return lines;
}

static size_t count_lines_along(turned_text *t, roberts_vec3 dir, bool rounded, double crease)
{
    return count_lines_of(t, (roberts_camera){.dir = mat3_map(t->turn, dir)}, rounded, crease);
}

static size_t count_lines(turned_text *t, bool rounded, double crease)
{
    return count_lines_along(t, (roberts_vec3){0.2, -0.3, 0.9}, rounded, crease);
}

/* Two flat fans of slivers, which meet along a line at this angle from flat. */
static turned_text two_fans(double degrees)
{
    enum { STEPS = 100 };
    turned_text t = begin();
    put(&t.text, "OFF\n%d %d 0\n", STEPS + 3, 2 * STEPS);
    for (int i = 0; i <= STEPS; i++)
        put_point(&t, (double)i / STEPS, 0, 0);
    put_point(&t, 0, -0.02, 0);
    put_point(&t, 1, 0.02 * cos(degrees * PI / 180), 0.02 * sin(degrees * PI / 180));
    for (int i = 0; i < STEPS; i++)
        put(&t.text, "3 %d %d %d\n3 %d %d %d\n", STEPS + 1, i + 1, i, STEPS + 2, i, i + 1);
    return t;
}

static void fans(void **state)
{
    (void)state;
    turned_text flat = two_fans(0), bent = two_fans(30);
    assert_int_equal(count_lines(&flat, true, 0.1), 4);       /* its border */
    assert_int_equal(count_lines(&bent, true, 0.1), 4 + 100); /* and where the fans meet */
    assert_true(count_lines(&bent, false, 0.1) > 150);        /* as the numbers are, the slivers are not in one plane */
    assert_int_equal(count_lines(&flat, true, 0.0), 4 + 298); /* then all edges are lines */
    test_free(flat.text.at);
    test_free(bent.text.at);
}

/* Two triangles, cut into a fan each, which meet along a line at this angle from flat. Every other point there is a
 * few steps of the rounding beside it, so that there are 50 slivers of this width between the fans. If that is
 * negative, the fans meet the slivers without a fold. */
static turned_text two_triangles(double degrees, double width)
{
    enum { STEPS = 100, LEFT = STEPS + 1, RIGHT };
    const double c = cos(degrees * PI / 180), s = sin(degrees * PI / 180);
    turned_text t = begin();
    put(&t.text, "OFF\n%d %d 0\n", STEPS + 3, 2 * STEPS);
    for (int i = 0; i <= STEPS; i++)
        put_point(&t, (double)i / STEPS, i % 2 * width * c, i % 2 * width * s);
    put_point(&t, 0.5, c, s);
    put_point(&t, 0.5, -1, 0);
    for (int i = 0; i < STEPS; i += 2) {
        put(&t.text, "3 %d %d %d\n3 %d %d %d\n", i, i + 1, i + 2, LEFT, i, i + 2);
        put(&t.text, "3 %d %d %d\n3 %d %d %d\n", RIGHT, i + 1, i, RIGHT, i + 2, i + 1);
    }
    return t;
}

/* Slivers that are folded back by a few steps count as turned over by rounding. */
static void slivers_that_are_turned_over(void **state)
{
    const roberts_vec3 dir[] = {{0.2, -0.3, 0.9}, {0.3, -0.9, 0.002}, {0.1, 0.9, 0.3}};
    turned_text flat = two_triangles(0, 1e-5), bent = two_triangles(30, 1e-5), wider = two_triangles(0, -2e-5);
    (void)state;
    for (int i = 0; i < 3; i++) {
        assert_int_equal(count_lines_along(&flat, dir[i], true, 0.1), 4);
        assert_int_equal(count_lines_along(&wider, dir[i], true, 0.1), 4);
        assert_true(count_lines_along(&flat, dir[i], false, 0.1) > 50);
        assert_int_equal(count_lines_along(&bent, dir[i], true, 0.1), 4 + 100);
    }
    /* an oblique view, whose lines of sight are almost in the plane */
    const roberts_camera oblique = {.dir = mat3_map(wider.turn, (roberts_vec3){0, -1, 1}),
                                    .up = mat3_map(wider.turn, (roberts_vec3){0, 0, 1}),
                                    .oblique = {0, -0.998}};
    assert_int_equal(count_lines_of(&wider, oblique, true, 0.1), 4);
    test_free(flat.text.at);
    test_free(bent.text.at);
    test_free(wider.text.at);
}

/* A roof whose ridge is cut off, by a few steps of the rounding: two slivers, with one of which a slope goes on. */
static void a_ridge_of_slivers(void **state)
{
    turned_text t = begin();
    (void)state;
    put(&t.text, "OFF\n8 6 0\n");
    for (int side = -1; side <= 1; side += 2) {
        put_point(&t, 0, side * 0.000004, 0);
        put_point(&t, 1, side * 0.000004, 0);
        put_point(&t, 1, side, -1);
        put_point(&t, 0, side, -1);
    }
    put(&t.text, "3 0 1 2\n3 0 2 3\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n");
    assert_int_equal(count_lines(&t, true, 0.1), 1 + 2 * 3 + 2); /* the ridge, and a border */
    assert_int_equal(count_lines_along(&t, (roberts_vec3){0.1, -1, 0.2}, true, 0.1), 1 + 2 * 3 + 2);
    test_free(t.text.at);
}

/* A disc with caps of slivers: a convex solid, to rounding. */
static void a_disc(void **state)
{
    enum { CORNERS = 1000 };
    turned_text t = begin();
    (void)state;
    put(&t.text, "OFF\n%d %d 0\n", 2 * CORNERS, 3 * CORNERS - 4);
    for (int i = 0; i < 2 * CORNERS; i++)
        put_point(&t, cos(2 * PI * i / CORNERS), sin(2 * PI * i / CORNERS), i < CORNERS ? 0 : 0.5);
    for (int i = 1; i + 1 < CORNERS; i++)
        put(&t.text, "3 0 %d %d\n3 %d %d %d\n", i + 1, i, CORNERS, CORNERS + i, CORNERS + i + 1);
    for (int i = 0, k; i < CORNERS; i++) {
        k = (i + 1) % CORNERS;
        put(&t.text, "4 %d %d %d %d\n", i, k, CORNERS + k, CORNERS + i);
    }
    /* beside the corner of all slivers, the narrowest one may lie in the plane of a side instead */
    assert_in_range(count_lines(&t, true, 0.1), 3 * CORNERS - 2, 3 * CORNERS + 2);
    test_free(t.text.at);
}

/* The scene of coordinates that were read as 32-bit floats. */
static roberts_scene *scene_of_floats(const char *text)
{
    roberts_mesh mesh = mesh_of_text(text);
    mesh_float32(&mesh);
    return build_scene(&mesh);
}

/* The lines of a cube whose top is cut along its diagonal, with a facet of this height between. */
static size_t lines_of_cut_cube(double height, bool floats, roberts_vec3 dir)
{
    char text[600];
    const roberts_camera camera = {.dir = dir};
    const roberts_hide_options options = roberts_hide_options_default();
    snprintf(text, sizeof text,
             "OFF\n9 14 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 2\n2 0 2\n2 2 2\n0 2 2\n%.9g %.9g 2\n3 0 3 2\n"
             "3 0 2 1\n3 4 5 6\n3 4 8 7\n3 8 6 7\n3 4 6 8\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n"
             "3 3 0 4\n3 3 4 7\n",
             1 - height, 1 + height);
    roberts_scene *scene = floats ? scene_of_floats(text) : scene_of_text(text);
    assert_int_equal(roberts_scene_body_kind(scene, 0), ROBERTS_CONVEX);
    roberts_drawing drawing = drawing_of(scene, &camera, &options);
    const size_t count = drawing.count;
    roberts_drawing_free(&drawing);
    roberts_scene_free(scene);
    return count;
}

/* A facet without area, or narrower than the touching distance, is no wider in the picture, but it is not edge-on. */
static void a_facet_without_area(void **state)
{
    (void)state;
    for (int floats = 0; floats < 2; floats++)
        for (int i = 0; i < 2; i++) {
            const double height = i * (floats ? 1.2e-7 : 1e-12);
            assert_int_equal(lines_of_cut_cube(height, floats, (roberts_vec3){1, -2, 3}), 9);
            assert_int_equal(lines_of_cut_cube(height, floats, (roberts_vec3){-1, 2, 3}), 9);
            assert_int_equal(lines_of_cut_cube(height, floats, (roberts_vec3){0, 0, 1}), 4);
            assert_int_equal(lines_of_cut_cube(height, floats, (roberts_vec3){0, 1, 0}), 4);
        }
}

/* Two narrow triangles in one plane, one across the other, turned anyhow. */
static void strips(void **state)
{
    roberts_scene *scene =
        scene_of_floats("OFF\n6 2 0\n-0.265728116 27.9072762 27.5919685\n0.0891593397 27.7847004 "
                        "27.2702732\n12.4298458 26.4682236 18.7312717\n9.24903011 27.1209679 21.2138767\n8.44766998 "
                        "25.5464363 20.2764988\n8.48820019 25.4853306 20.3444939\n3 0 1 2\n3 3 4 5\n");
    const roberts_camera camera = {.dir = {0.3, -0.8, 0.5}};
    (void)state;
    for (int hidden = 0; hidden < 2; hidden++) {
        roberts_hide_options options = roberts_hide_options_default();
        options.keep_hidden = hidden;
        roberts_drawing drawing = drawing_of(scene, &camera, &options);
        assert_int_equal(drawing.crossing_count, 0);
        roberts_drawing_free(&drawing);
    }
    roberts_scene_free(scene);
}

/* Plates of the shape of an L, on one another. A corner lies `aside` from the middle of a side, and there are slivers
 * along that side. */
static roberts_scene *plates(int count, double aside)
{
    static const char faces[] = "0 1 2 3 4 5 0 2 6 7 3 5 2 8 6 7 9 3 0 6 10 11 7 5 6 12 10 11 13 7 5 4 1 5 1 0 4 3 2 "
                                "4 2 1 3 9 8 3 8 2 9 7 6 9 6 8 7 13 12 7 12 6 13 11 10 13 10 12 11 5 0 11 0 10";
    put_text text = put_begin();
    put(&text, "OFF\n%d %d 0\n", 14 * count, 24 * count);
    for (int i = 0, z = 10, low = 0; i < count; i++, z += 10, low += 10) {
        put(&text, "0 0 %d\n40 %.9g %d\n100 0 %d\n100 0 %d\n40 %.9g %d\n0 0 %d\n60 50 %d\n60 50 %d\n", z, -aside, z, z,
            low, -aside, low, low, z, low);
        put(&text, "100 50 %d\n100 50 %d\n0 90 %d\n0 90 %d\n60 90 %d\n60 90 %d\n", z, low, z, low, z, low);
    }
    for (int i = 0; i < count; i++)
        for (const char *at = faces; *at;) {
            int corner[3], length = 0;
            assert_int_equal(sscanf(at, "%d %d %d%n", &corner[0], &corner[1], &corner[2], &length), 3);
            put(&text, "3 %d %d %d\n", corner[0] + 14 * i, corner[1] + 14 * i, corner[2] + 14 * i);
            at += length;
        }
    roberts_scene *scene = scene_of_floats(text.at);
    test_free(text.at);
    return scene;
}

/* The slivers are wider than the touching distance by little, or narrower. Plates are closed and stay apart. */
static void slivers_along_a_side(void **state)
{
    static const double aside[] = {1.99999995e-05, 4e-6};
    (void)state;
    for (int i = 0; i < 2; i++)
        for (int count = 1; count <= 2; count++) {
            roberts_scene *scene = plates(count, aside[i]);
            assert_int_equal(roberts_scene_solid_count(scene), count);
            for (int body = 0; body < count; body++)
                assert_int_equal(roberts_scene_body_kind(scene, (uint32_t)body), ROBERTS_CLOSED);
            roberts_scene_free(scene);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(fans),
                                       cmocka_unit_test(slivers_that_are_turned_over),
                                       cmocka_unit_test(a_ridge_of_slivers),
                                       cmocka_unit_test(a_disc),
                                       cmocka_unit_test(a_facet_without_area),
                                       cmocka_unit_test(strips),
                                       cmocka_unit_test(slivers_along_a_side)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
