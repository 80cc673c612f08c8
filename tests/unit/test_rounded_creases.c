/* test_rounded_creases.c - in a flat face given as slivers, rounding of the coordinates makes no creases. */
#include "build_scene.h"
#include "scenes.h"

#include <stdarg.h>
#include <stdio.h>

#define PI 3.14159265358979323846

/* A model in the making, turned and rounded to six decimals. */
typedef struct rounded_text {
    char *at;
    size_t count, room;
    mat3 turn;
} rounded_text;

static void put(rounded_text *t, const char *format, ...)
{
    va_list arguments;
    assert_true(t->room - t->count > 256);
    va_start(arguments, format);
    t->count += (size_t)vsnprintf(t->at + t->count, 256, format, arguments);
    va_end(arguments);
}

static void put_point(rounded_text *t, double x, double y, double z)
{
    const roberts_vec3 P = mat3_map(t->turn, (roberts_vec3){x, y, z});
    put(t, "%.6f %.6f %.6f\n", P.x, P.y, P.z);
}

static rounded_text begin(void)
{
    rng r = {5};
    return (rounded_text){test_malloc(1 << 17), 0, 1 << 17, mat3_turn(&r)};
}

/* The number of edges of which something is drawn, hidden or not. Rows of an edge follow one another. */
static size_t count_lines(rounded_text *t, bool rounded, double crease)
{
    const roberts_camera camera = {.dir = mat3_map(t->turn, (roberts_vec3){0.2, -0.3, 0.9})};
    roberts_hide_options options = roberts_hide_options_default();
    roberts_verify_options verify = roberts_verify_options_default();
    roberts_verification found;
    roberts_mesh mesh = mesh_of_text(t->at);
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

/* Two flat fans of slivers, which meet along a line at this angle from flat. */
static rounded_text two_fans(double degrees)
{
    enum { STEPS = 100 };
    rounded_text t = begin();
    put(&t, "OFF\n%d %d 0\n", STEPS + 3, 2 * STEPS);
    for (int i = 0; i <= STEPS; i++)
        put_point(&t, (double)i / STEPS, 0, 0);
    put_point(&t, 0, -0.02, 0);
    put_point(&t, 1, 0.02 * cos(degrees * PI / 180), 0.02 * sin(degrees * PI / 180));
    for (int i = 0; i < STEPS; i++)
        put(&t, "3 %d %d %d\n3 %d %d %d\n", STEPS + 1, i + 1, i, STEPS + 2, i, i + 1);
    return t;
}

static void fans(void **state)
{
    (void)state;
    rounded_text flat = two_fans(0), bent = two_fans(30);
    assert_int_equal(count_lines(&flat, true, 0.1), 4);       /* its border */
    assert_int_equal(count_lines(&bent, true, 0.1), 4 + 100); /* and where the fans meet */
    assert_true(count_lines(&bent, false, 0.1) > 150);        /* as the numbers are, the slivers are not in one plane */
    assert_int_equal(count_lines(&flat, true, 0.0), 4 + 298); /* then all edges are lines */
    test_free(flat.at);
    test_free(bent.at);
}

/* A disc with caps of slivers: a convex solid, to rounding. */
static void a_disc(void **state)
{
    enum { CORNERS = 1000 };
    rounded_text t = begin();
    (void)state;
    put(&t, "OFF\n%d %d 0\n", 2 * CORNERS, 3 * CORNERS - 4);
    for (int i = 0; i < 2 * CORNERS; i++)
        put_point(&t, cos(2 * PI * i / CORNERS), sin(2 * PI * i / CORNERS), i < CORNERS ? 0 : 0.5);
    for (int i = 1; i + 1 < CORNERS; i++)
        put(&t, "3 0 %d %d\n3 %d %d %d\n", i + 1, i, CORNERS, CORNERS + i, CORNERS + i + 1);
    for (int i = 0, k; i < CORNERS; i++) {
        k = (i + 1) % CORNERS;
        put(&t, "4 %d %d %d %d\n", i, k, CORNERS + k, CORNERS + i);
    }
    /* beside the corner of all slivers, the narrowest one may lie in the plane of a side instead */
    assert_in_range(count_lines(&t, true, 0.1), 3 * CORNERS - 2, 3 * CORNERS + 2);
    test_free(t.at);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(fans), cmocka_unit_test(a_disc)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
