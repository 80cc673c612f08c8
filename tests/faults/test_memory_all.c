/* test_memory_all.c - from a file in memory to its drawing with each allocation failing in turn: solids, the near
 * plane, grid and covers, hiding, writing. Each failure is ROBERTS_NO_MEMORY and leaves nothing; once no allocation
 * fails, everything succeeds. There is one thread, so that the allocations come in a fixed order. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "roberts.h"
#include "testing.h"

static bool take(void *context, const void *bytes, size_t size)
{
    (void)bytes;
    *(size_t *)context += size;
    return true;
}

typedef struct run_case {
    const char *name, *file, *text; /* one of the two */
    roberts_camera camera;
    bool keep_hidden;
    uint32_t grid;
    roberts_format format;
    bool hull, unite;
} run_case;

/* Reads, builds, hides, writes; the first status that is not ROBERTS_OK. */
static roberts_status run(const run_case *c, roberts_error *error, size_t *written)
{
    roberts_mesh mesh = {0};
    roberts_scene *scene = NULL;
    roberts_drawing drawing = {0};
    roberts_hide_options hide = roberts_hide_options_default();
    roberts_draw_options draw = roberts_draw_options_default();
    hide.keep_hidden = hide.levels = c->keep_hidden;
    hide.grid = c->grid;
    hide.unite = c->unite;
    hide.threads = 1;
    draw.format = c->format;
    *written = 0;
    roberts_status status = c->text ? roberts_mesh_read_memory(&mesh, c->name, c->text, strlen(c->text), NULL, error)
                                    : roberts_mesh_read_file(&mesh, c->file, NULL, error);
    if (status == ROBERTS_OK)
        status = roberts_scene_take(&mesh, &(roberts_scene_options){.hull = c->hull, .threads = 1}, &scene, error);
    assert_int_equal(scene != NULL, status == ROBERTS_OK);
    if (status == ROBERTS_OK)
        status = roberts_hide(scene, &c->camera, &hide, &drawing, error);
    assert_true(status == ROBERTS_OK || (drawing.count == 0 && !drawing.segment));
    if (status == ROBERTS_OK)
        status = roberts_drawing_write(&drawing, &draw, take, written, error);
    roberts_drawing_free(&drawing);
    roberts_scene_free(scene);
    roberts_mesh_free(&mesh);
    return status;
}

static void survives(const run_case *c)
{
    size_t failures = 0, unharmed = 0, before = memory_blocks, written;
    print_message("%s\n", c->name);
    for (size_t n = 1;; n++) {
        roberts_error error = {0};
        memory_fail(n);
        roberts_status status = run(c, &error, &written);
        bool failed = memory_failed();
        memory_fail(0);
        assert_int_equal(memory_blocks, before);
        if (!failed) {
            assert_int_equal(status, ROBERTS_OK);
            assert_true(written > 0 || c->format == ROBERTS_NULL);
            break;
        }
        if (status == ROBERTS_OK) { /* an array that could not be made smaller */
            unharmed++;
            continue;
        }
        assert_int_equal(status, ROBERTS_NO_MEMORY);
        assert_int_equal(error.status, ROBERTS_NO_MEMORY);
        assert_string_equal(error.message, "not enough memory");
        failures++;
    }
    print_message("    %zu allocations failed, %zu without harm\n", failures, unharmed);
    /* counted: 64 and more; two arrays of vertices and one of edges at each of two layouts, one of solids;
     * nine where bodies that are not convex make a third layout; with hulls twelve */
    assert_true(failures >= 40 && unharmed <= (c->hull ? 12 : 9));
}

#define ISO                                                                                                            \
    {                                                                                                                  \
        .dir = { 1, -1, 1 }                                                                                            \
    }
#define EYE(x, y, z, near)                                                                                             \
    {                                                                                                                  \
        .projection = ROBERTS_PERSPECTIVE, .eye = {x, y, z}, .near_distance = (near)                                   \
    }

/* A cube whose faces have vertices of their own. */
static const char soup[] = "OFF 24 6 0\n"
                           "0 0 0 0 1 0 1 1 0 1 0 0\n"
                           "0 0 1 1 0 1 1 1 1 0 1 1\n"
                           "0 0 0 1 0 0 1 0 1 0 0 1\n"
                           "0 1 0 0 1 1 1 1 1 1 1 0\n"
                           "0 0 0 0 0 1 0 1 1 0 1 0\n"
                           "1 0 0 1 1 0 1 1 1 1 0 1\n"
                           "4 0 1 2 3\n4 4 5 6 7\n4 8 9 10 11\n4 12 13 14 15\n4 16 17 18 19\n4 20 21 22 23\n";

/* Two tetrahedra with an edge in common; their faces are mixed, so that the angles must separate them. */
static const char hinge[] = "OFF 6 8 0\n"
                            "0 0 0\n0 0 1\n1 0.2 0\n1 -0.2 0.1\n-1 0.2 0\n-1 -0.2 0.1\n"
                            "3 0 1 2\n3 0 1 4\n3 0 1 3\n3 0 1 5\n3 0 2 3\n3 0 4 5\n3 1 2 3\n3 1 4 5\n";

/* Cubes: with colours, and a corner that lies on one face's side only; with a bevel narrower than the rounding, which
 * takes its plane from its neighbours. */
static const char open_side[] = "COFF 9 7 0\n"
                                "0 0 0 255 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n.5 0 0\n"
                                "5 0 2 3 1 8 255 0 0\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n3 0 8 1\n";
static const char bevel[] = "OFF 10 7 0\n"
                            "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1.000001 0 1\n0 1 1\n1.000001 1 1\n"
                            "1 0 .999999\n1 1 .999999\n"
                            "4 0 2 3 1\n4 4 5 7 6\n5 0 1 8 5 4\n5 2 6 7 9 3\n4 0 4 6 2\n4 1 3 9 8\n4 5 8 9 7\n";

/* A tetrahedron, which is whole, and two triangles that share an edge, with a colour; points of a wedge. */
static const char half_open[] = "OFF 8 6 0\n"
                                "0 0 0\n1 0 0\n0 1 0\n0 0 1\n5 0 0\n6 0 0\n5 1 0\n5 0 1\n"
                                "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n3 4 5 6 255 0 0\n3 4 5 7\n";
static const char points[] = "OFF 7 0 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n.3 .3 .3\n";

/* Bodies that are no convex solids, and a tetrahedron: an L-block with concave faces, a pentagram, three faces at an
 * edge that a vertex divides, a quadrilateral that is not planar, a wire, a face with a hole at the end of a slit, a
 * face of 20 corners. */
static const char mixture[] =
    "OFF 62 22 0\n"
    "0 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n0 0 1\n2 0 1\n2 1 1\n1 1 1\n1 2 1\n0 2 1\n0 1 2\n"
    "-0.588 -0.809 2\n0.951 0.309 2\n-0.951 0.309 2\n0.588 -0.809 2\n4 0 0\n6 0 0\n5 1 0\n5 0 0\n5 -1 0\n"
    "4 -1 1\n6 0 2\n0 4 0\n1 4 1\n1 5 0\n0 5 1\n0 6 0\n1 6 1\n3 4 0\n6 4 0\n6 7 0\n3 7 0\n4 5 0\n4 6 0\n5 6 0\n"
    "5 5 0\n8 0 0\n9 0 0\n8 1 0\n8 0 1\n10 5 1\n9.9511 5.309 1\n9.809 5.5878 1\n9.5878 5.809 1\n9.309 5.9511 1\n"
    "9 6 1\n8.691 5.9511 1\n8.4122 5.809 1\n8.191 5.5878 1\n8.0489 5.309 1\n8 5 1\n8.0489 4.691 1\n"
    "8.191 4.4122 1\n8.4122 4.191 1\n8.691 4.0489 1\n9 4 1\n9.309 4.0489 1\n9.5878 4.191 1\n9.809 4.4122 1\n"
    "9.9511 4.691 1\n"
    "6 5 4 3 2 1 0\n6 6 7 8 9 10 11\n4 0 1 7 6\n4 1 2 8 7\n4 2 3 9 8\n4 3 4 10 9\n4 4 5 11 10\n4 5 0 6 11\n"
    "5 12 13 14 15 16\n3 17 18 19\n3 17 20 21\n3 20 18 21\n3 20 18 23\n3 20 18 22\n4 24 25 26 27\n2 28 29\n"
    "10 30 31 32 33 30 34 35 36 37 34\n3 38 40 39\n3 38 39 41\n3 38 41 40\n3 39 40 41\n"
    "20 42 43 44 45 46 47 48 49 50 51 52 53 54 55 56 57 58 59 60 61\n";

/* A prism of 81 sides, two of which meet in a dent of half the tolerance: too many corners to compare all with all
 * planes, and enough for runs. */
static const char *dented_prism(void)
{
    enum { SIDES = 81 };
    static char text[32000];
    size_t n = (size_t)sprintf(text, "OFF %d %d 0\n", 2 * SIDES, SIDES + 2);
    for (int i = 0; i < 2 * SIDES; i++) {
        double step = 8 * atan(1) / (SIDES - 1), angle = (i / 2 - 0.5 * (i / 2 == 1) - (i / 2 > 1)) * step;
        double radius = i / 2 == 1 ? cos(step / 2) - 1e-5 : 1;
        n += (size_t)sprintf(text + n, "%.17g %.17g %d\n", radius * cos(angle), radius * sin(angle), i % 2);
    }
    for (int i = 0; i < SIDES; i++) {
        int k = (i + 1) % SIDES;
        n += (size_t)sprintf(text + n, "4 %d %d %d %d\n", 2 * i, 2 * k, 2 * k + 1, 2 * i + 1);
    }
    for (int top = 0; top < 2; top++) {
        n += (size_t)sprintf(text + n, "%d", SIDES);
        for (int i = 0; i < SIDES; i++)
            n += (size_t)sprintf(text + n, " %d", top + 2 * (top ? i : SIDES - 1 - i));
        n += (size_t)sprintf(text + n, "\n");
    }
    return text;
}

/* A pyramid of 160 sides, whose faces are a bundle. */
static const char *fan(void)
{
    enum { SIDES = 160 };
    static char text[24000];
    size_t n = (size_t)sprintf(text, "OFF %d %d 0\n0 0 .5\n", SIDES + 1, SIDES + 1);
    for (int i = 0; i < SIDES; i++)
        n += (size_t)sprintf(text + n, "%.17g %.17g 0\n", cos(8 * atan(1) * i / SIDES), sin(8 * atan(1) * i / SIDES));
    n += (size_t)sprintf(text + n, "%d", SIDES);
    for (int i = SIDES; i > 0; i--)
        n += (size_t)sprintf(text + n, " %d", i);
    for (int i = 0; i < SIDES; i++)
        n += (size_t)sprintf(text + n, "\n3 0 %d %d", i + 1, (i + 1) % SIDES + 1);
    return text;
}

/* One face with more corners than are cut without flips. */
static const char *comb(void)
{
    enum { TEETH = 40 };
    static char text[4000];
    size_t n = (size_t)sprintf(text, "OFF %d 1 0\n0 0 0\n%d 0 0\n", 2 * TEETH + 2, 2 * TEETH);
    for (int i = 2 * TEETH; i > 0; i--)
        n += (size_t)sprintf(text + n, "%d %d 0\n", i, 1 + i % 2);
    n += (size_t)sprintf(text + n, "%d", 2 * TEETH + 2);
    for (int i = 0; i < 2 * TEETH + 2; i++)
        n += (size_t)sprintf(text + n, " %d", i);
    return text;
}

/* More sheets above one another than a list has without a tree. */
static const char *pile(void)
{
    enum { SHEETS = 900 };
    static char text[64000];
    size_t n = (size_t)sprintf(text, "OFF %d %d 0\n", 3 * SHEETS, SHEETS);
    for (int i = 0; i < SHEETS; i++)
        n += (size_t)sprintf(text + n, "0 0 %d\n9 %d %d\n%d 9 %d\n", i, i % 7, i, i % 5, i);
    for (int i = 0; i < SHEETS; i++)
        n += (size_t)sprintf(text + n, "3 %d %d %d\n", 3 * i, 3 * i + 1, 3 * i + 2);
    return text;
}

/* A disc of more slivers than a list has without a tree. */
static const char *slivers(void)
{
    enum { CORNERS = 900 };
    static char text[80000];
    size_t n = (size_t)sprintf(text, "OFF %d %d 0\n", CORNERS, CORNERS - 2);
    for (int i = 0; i < CORNERS; i++)
        n += (size_t)sprintf(text + n, "%.17g %.17g 0\n", cos(8 * atan(1) * i / CORNERS),
                             sin(8 * atan(1) * i / CORNERS));
    for (int i = 1; i < CORNERS - 1; i++)
        n += (size_t)sprintf(text + n, "3 0 %d %d\n", i, i + 1);
    return text;
}

static const run_case cases[] = {
    {.name = "bodies as one", .file = "models/compound-of-three-cubes.off", .camera = ISO, .unite = true},
    {.name = "bodies as one, hidden lines, the near plane",
     .file = "models/table.off",
     .camera = EYE(18, -60, 30, 65),
     .keep_hidden = true,
     .unite = true},
    {"overlapping solids", "models/compound-of-three-cubes.off", NULL, ISO, false, 0, ROBERTS_SVG, false, false},
    {"hidden lines, a grid", "models/table.off", NULL, ISO, true, 9, ROBERTS_CSV, false, false},
    {"covers", "models/city.off", NULL, ISO, false, 0, ROBERTS_SVG, false, false},
    {"oblique",
     "models/needles.off",
     NULL,
     {.dir = {0, -1, 0}, .oblique = {0.4, 0.3}},
     true,
     0,
     ROBERTS_JSON,
     false,
     false},
    {"perspective", "models/prisms/prism-60.off", NULL, EYE(9, -7, 5, 0), true, 0, ROBERTS_NULL, false, false},
    {"the near plane", "models/table.off", NULL, EYE(18, -60, 30, 65), true, 0, ROBERTS_SVG, false, false},
    {"welded", NULL, soup, ISO, true, 0, ROBERTS_SVG, false, false},
    {"a corner on a side", NULL, open_side, ISO, true, 0, ROBERTS_CSV, false, false},
    {"a narrow face", NULL, bevel, ISO, true, 0, ROBERTS_SVG, false, false},
    {"many vertices", "models/sphere.off", NULL, ISO, false, 0, ROBERTS_SVG, false, false},
    {"an edge of four faces", NULL, hinge, ISO, true, 0, ROBERTS_SVG, false, false},
    {"hulls of what is open, and a solid beside it", NULL, half_open, ISO, true, 0, ROBERTS_SVG, true, false},
    {"the hull of points", NULL, points, ISO, true, 0, ROBERTS_SVG, true, false},
    {"bodies of all kinds", NULL, mixture, ISO, true, 0, ROBERTS_SVG, false, false},
    {"a star at the near plane", "models/star/pentagrammic-prism.off", NULL, EYE(3, -2.2, 2, 4.1), true, 0, ROBERTS_SVG,
     false, false},
    {"bodies of all kinds at the near plane", NULL, mixture, EYE(5, -3, 1, 3.5), true, 0, ROBERTS_CSV, false, false},
};

static void files(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        survives(&cases[i]);
    survives(&(run_case){"a dent", NULL, dented_prism(), ISO, true, 0, ROBERTS_SVG, false, false});
    survives(&(run_case){"a fan", NULL, fan(), ISO, true, 0, ROBERTS_SVG, false, false});
    survives(&(run_case){"a comb", NULL, comb(), ISO, true, 0, ROBERTS_SVG, false, false});
    survives(&(run_case){"a pile in one cell", NULL, pile(), ISO, false, 1, ROBERTS_SVG, false, false});
    survives(&(run_case){"slivers in one cell", NULL, slivers(), ISO, false, 1, ROBERTS_SVG, false, false});
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(files)};
    return cmocka_run_group_tests_name("memory_all", tests, NULL, NULL);
}
