/* test_rounded.c - models whose coordinates were rounded to decimals: how the rounding is found, and that solids that
 * touched before it are drawn as touching. */
#include <math.h>
#include <stdio.h>

#include "base/box.h"
#include "build_scene.h"
#include "read/mesh.h"
#include "rng.h"
#include "segments.h"
#include "testing.h"

/* ---- how the rounding is found ---- */

static const struct {
    const char *name;
    double x, y, z; /* of a vertex; the others are 0 0 0 and 1 1 1 */
    double step;
} step_cases[] = {
    {"whole numbers", 123456, 7, 1, 0},
    {"halves and eighths", 0.5, 0.375, 12.625, 0},
    {"a fraction of seven digits that doubles hold", 0.0009765625, 0, 0, 0},
    {"six digits", 0.707107, 0, 0, 2e-6},
    {"six digits, the last one 0 or 5", 0.70711, 0.577345, 0, 2e-6},
    {"the largest rounded coordinate counts", 12.3457, 0.00123457, 0, 2e-4},
    {"whole ones do not", 100, 0.707107, 0, 2e-6},
    {"negative", -0.707107, 0, 0, 2e-6},
    {"nine digits", 0.707106781, 0, 0, 2e-9},
    {"a third", 0.707107, 1.0 / 3.0, 0, 0},
    {"a root", 0, 1.4142135623730951, 0, 0},
    {"tenths: too coarse", 0.1, 0.3, 0, 0},
    {"three digits: too coarse", 0.707, 0, 0, 0},
    {"five digits", 0.70711, 0, 0, 2e-5},
    {"a tenth in a model a million times as wide", 0.1, 0, 1e6, 0.2},
    {"printed floats, in nine digits", 12.2099447, -0.745752811, 22.2603035, 0x1p-18},
    {"printed floats, in as many digits as tell them apart", 9.2099447, 0.0012345, 0.1, 0x1p-19},
    {"printed floats, in all their digits", (double)1.8378500938415527f, (double)0.1f, 0, 0x1p-22},
    {"the largest float counts, though it is exact", (double)0.1f, 0, (double)100.7f, 0x1p-16},
    {"all digits of floats, and a decimal that shows one", (double)1.837f, 0.707106769, 0, 0x1p-22},
    {"all digits of floats, and a decimal that shows none", (double)1.837f, 0.745752812, 0, 0},
    {"all digits of floats, and a double", (double)1.837f, 1.0 / 3.0, 0, 0},
    {"a power of two is the first of its units", 0.333333343, 2.0000002, 0, 0x1p-21},
    {"one is no float", 12.2099447, 0.745752812, 22.2603035, 2e-7},
    {"seven digits are coarser than a float", 0.7071068, 0, 0, 2e-7},
    {"many sizes: the unit is that of six digits of the largest", 98765.4, 1.23456e-7, 0, 0.2},
};

static void steps_by_table(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof step_cases / sizeof step_cases[0]; i++) {
        roberts_mesh mesh = {0};
        char text[200];
        mesh_vertex(&mesh, (roberts_vec3){0, 0, 0});
        mesh_vertex(&mesh, (roberts_vec3){step_cases[i].x, step_cases[i].y, step_cases[i].z});
        mesh_vertex(&mesh, (roberts_vec3){1, 1, 1});
        mesh_steps found = mesh_rounding(&mesh, true);
        if (!(fabs(found.decimal - step_cases[i].step) <= 1e-9 * step_cases[i].step) || found.float32 != 0.0)
            fail_msg("%s: %g, expected %g", step_cases[i].name, found.decimal, step_cases[i].step);
        roberts_mesh_free(&mesh);
        snprintf(text, sizeof text, "OFF 3 1 0\n0 0 0\n%.17g %.17g %.17g\n1 1 1\n3 0 1 2\n", step_cases[i].x,
                 step_cases[i].y, step_cases[i].z);
        mesh = mesh_of_text(text);
        assert_true(mesh_rounding(&mesh, true).decimal == found.decimal);
        assert_true(mesh_rounding(&mesh, false).decimal == 0.0);
        roberts_mesh_free(&mesh);
    }
}

/* Each input has a step of its own, and the greatest counts. One without vertices, or with floats, has none. */
static void steps_of_inputs(void **state)
{
    static const double digits[] = {0.7071, 0.707107, 0.70710678118654757};
    (void)state;
    roberts_mesh mesh = {0};
    assert_true(mesh_rounding(&mesh, true).decimal == 0.0);
    for (int i = 2; i >= 0; i--) {
        assert_true(mesh_source(&mesh, "empty") && mesh_source(&mesh, "input"));
        mesh_vertex(&mesh, (roberts_vec3){-1, -1, -1});
        mesh_vertex(&mesh, (roberts_vec3){digits[i], 1, 1});
        assert_true(fabs(mesh_rounding(&mesh, true).decimal - (i == 2 ? 0.0 : i == 1 ? 2e-6 : 2e-4)) < 1e-12);
        if (i == 0)
            mesh_float32(&mesh);
    }
    assert_true(fabs(mesh_rounding(&mesh, true).decimal - 2e-6) < 1e-12);
    assert_true(mesh_rounding(&mesh, true).float32 == 0x1p-22);
    roberts_mesh_free(&mesh);
}

/* ---- rounded solids that touch, overlap and are flush ----
 * Solids on a grid of whole numbers are drawn as they are, along a random direction; and turned so that this direction
 * is the z axis, with coordinates rounded. The lines must cover the same places of the picture. */

enum { SCENES = 300, SOLIDS = 5, SAMPLES = 24 };

typedef struct turn {
    roberts_vec3 x, y, z; /* rows of the matrix */
} turn;

static roberts_vec3 unit_vector(roberts_vec3 v)
{
    return vec3_scale(1.0 / vec3_length(v), v);
}

static turn random_turn(rng *r)
{
    roberts_vec3 z = unit_vector(rng_vec3(r, 1.0)), x = unit_vector(vec3_cross(rng_vec3(r, 1.0), z));
    return (turn){x, vec3_cross(z, x), z};
}

static roberts_vec3 turned(const turn *t, roberts_vec3 p)
{
    return (roberts_vec3){vec3_dot(t->x, p), vec3_dot(t->y, p), vec3_dot(t->z, p)};
}

/* Adds a box, a prism over an L, or a pentagram. */
static void add_random_solid(roberts_mesh *mesh, rng *r)
{
    static const unsigned char sides[] = {4, 6, 7, 1,  0, 4, 7, 8, 2, 1, 4, 8, 9, 3, 2, 4, 9, 10, 4, 3,  4,  10, 11,
                                          5, 4, 4, 11, 6, 0, 5, 6, 5, 4, 3, 2, 1, 0, 6, 6, 7, 8,  9, 10, 11, 0};
    const double x = rng_int(r, 0, 4), y = rng_int(r, 0, 4), z = rng_int(r, 0, 4), height = rng_int(r, 1, 2);
    const int kind = rng_int(r, 0, 4), axis = rng_int(r, 0, 2);
    if (kind < 2) {
        mesh_box(mesh, (roberts_vec3){x, y, z}, (roberts_vec3){x + rng_int(r, 1, 3), y + rng_int(r, 1, 3), z + height});
        return;
    }
    static const double corner[6][2] = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
    static const double star[5][2] = {{3, 6}, {5, 0}, {0, 4}, {6, 4}, {1, 0}};
    static const unsigned char star_side[] = {5, 0, 1, 2, 3, 4, 0};
    roberts_vec3 point[12];
    for (int i = 0; i < (kind == 4 ? 5 : 12); i++) {
        const double *q = kind == 4 ? star[i] : corner[i % 6], p[3] = {q[0], q[1], i < 6 ? 0 : height};
        point[i] = (roberts_vec3){x + p[axis], y + p[(axis + 1) % 3], z + p[(axis + 2) % 3]};
    }
    mesh_solid(mesh, point, kind == 4 ? 5 : 12, kind == 4 ? star_side : sides);
}

static roberts_vec3 middle(const roberts_mesh *mesh)
{
    roberts_vec3 low = mesh->vertex[0], high = low;
    box_add_all(&low, &high, mesh->vertex, mesh->vertex_count);
    return vec3_scale(0.5, vec3_add(low, high));
}

/* Returns the longest part of a line of `a` that no line of `b` covers. shift: from the picture of `a` to that of `b`.
 */
static double uncovered(const roberts_drawing *a, const roberts_drawing *b, roberts_vec2 shift, double touch)
{
    double most = 0.0;
    for (size_t i = 0; i < a->count; i++) {
        const roberts_segment *s = &a->segment[i];
        int missed = 0;
        for (int k = 0; k < SAMPLES; k++) {
            const double t = (k + 0.5) / SAMPLES;
            roberts_vec2 p = {s->p0.x + t * (s->p1.x - s->p0.x) + shift.x, s->p0.y + t * (s->p1.y - s->p0.y) + shift.y};
            bool covered = false;
            for (size_t j = 0; j < b->count && !covered; j++)
                covered = distance_to(&b->segment[j], p.x, p.y) <= touch;
            missed += !covered;
        }
        most = fmax(most, hypot(s->p1.x - s->p0.x, s->p1.y - s->p0.y) * missed / SAMPLES);
    }
    return most;
}

static void same_lines(bool unite)
{
    rng r = {unite ? 2 : 1};
    for (int n = 0; n < SCENES; n++) {
        roberts_mesh exact = {0}, rounded = {0};
        const turn t = random_turn(&r);
        const double unit = pow(10.0, rng_int(&r, -7, -5));
        for (int i = rng_int(&r, 1, SOLIDS); i > 0; i--)
            add_random_solid(&exact, &r);
        for (size_t i = 0; i < exact.vertex_count; i++) {
            const roberts_vec3 p = turned(&t, exact.vertex[i]);
            mesh_vertex(&rounded,
                        (roberts_vec3){rint(p.x / unit) * unit, rint(p.y / unit) * unit, rint(p.z / unit) * unit});
        }
        for (size_t f = 0; f < exact.face_count; f++)
            mesh_face(&rounded, exact.corner + exact.face_start[f], exact.face_start[f + 1] - exact.face_start[f]);
        const roberts_vec3 from = turned(&t, middle(&exact)), to = middle(&rounded);
        const roberts_camera along = {.dir = t.z, .up = t.y}, down = {.dir = {0, 0, 1}, .up = {0, 1, 0}};
        roberts_hide_options options = roberts_hide_options_default();
        options.unite = unite;
        const roberts_scene_options as_rounded = {.rounded = true};
        roberts_scene *scene[] = {build_scene(&exact), scene_of_mesh(&rounded, &as_rounded)};
        roberts_mesh_free(&rounded);
        roberts_drawing a = drawing_of(scene[0], &along, &options), b = drawing_of(scene[1], &down, &options);
        assert_int_equal(b.epsilon_reason, ROBERTS_EPSILON_DECIMAL);
        const double missing = uncovered(&a, &b, (roberts_vec2){from.x - to.x, from.y - to.y}, 50 * unit);
        const double extra = uncovered(&b, &a, (roberts_vec2){to.x - from.x, to.y - from.y}, 50 * unit);
        if (missing > 0.05 || extra > 0.05)
            fail_msg("scene %d, rounded to %g: %g of a line is missing, %g of one is too much", n, unit, missing,
                     extra);
        roberts_drawing_free(&a);
        roberts_drawing_free(&b);
        roberts_scene_free(scene[0]);
        roberts_scene_free(scene[1]);
    }
}

static void rounded_solids(void **state)
{
    (void)state;
    same_lines(false);
}

static void rounded_unions(void **state)
{
    (void)state;
    same_lines(true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_by_table),
        cmocka_unit_test(steps_of_inputs),
        cmocka_unit_test(rounded_solids),
        cmocka_unit_test(rounded_unions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
