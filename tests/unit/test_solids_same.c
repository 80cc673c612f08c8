/* test_solids_same.c - solids built by several threads, or from a mesh that is taken over, give the same scene. If
 * there are several faults, the first one is reported. */
#include <stdlib.h>
#include <string.h>

#include "model/scene.h"
#include "same_scene.h"
#include "scenes.h"
#include "testing.h"

enum { CUBES = 6000 }; /* enough for seven threads to have something to do */

static const uint32_t face[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

/* What may be wrong with a cube. */
typedef enum fault { SOUND, DENTED, FLAT, OPEN, ENDLESS /* and open */ } fault;

static fault fault_of(uint32_t cube, const uint32_t *faulty, const fault *kind, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (faulty[i] == cube)
            return kind[i];
    return SOUND;
}

/* Cubes in a row, some of them with a fault. */
static roberts_mesh row_of_cubes(const uint32_t *faulty, const fault *kind, size_t count)
{
    roberts_mesh mesh = {0};
    for (uint32_t cube = 0; cube < CUBES; cube++) {
        fault wrong = fault_of(cube, faulty, kind, count);
        uint32_t first = (uint32_t)mesh.vertex_count, v[4];
        for (int c = 0; c < 8; c++) {
            roberts_vec3 p = {2.0 * cube + (c & 1), c >> 1 & 1, wrong == FLAT ? 0.0 : c >> 2};
            if (wrong == DENTED && c == 7)
                p = vec3_add(p, (roberts_vec3){-0.25, -0.25, 0.5});
            mesh_vertex(&mesh, p);
        }
        if (wrong == ENDLESS)
            mesh.vertex[first].x = INFINITY; /* roberts_mesh_add_vertex() refuses this */
        for (int side = wrong == OPEN || wrong == ENDLESS; side < 6; side++) {
            for (int i = 0; i < 4; i++)
                v[i] = first + face[side][i];
            mesh_face(&mesh, v, 4);
        }
    }
    return mesh;
}

static void expect_refusal(const char *what, const roberts_mesh *mesh, roberts_status status, const char *message)
{
    static const uint32_t threads[] = {1, 2, 3, 7};
    for (size_t i = 0; i < sizeof threads / sizeof *threads; i++)
        for (int run = 0; run < 5; run++) {
            roberts_scene_options options = {.solids = true, .threads = threads[i]};
            roberts_scene *scene;
            roberts_error error = {0};
            if (roberts_scene_build(mesh, &options, &scene, &error) != status || !strstr(error.message, message))
                fail_msg("%s, %u threads: status %d, \"%s\"", what, threads[i], (int)error.status, error.message);
            assert_null(scene);
        }
}

static void the_first_fault_is_told(void **state)
{
    static const struct {
        const char *what;
        size_t count;
        uint32_t faulty[4];
        fault kind[4];
        roberts_status status;
        const char *message;
    } cases[] = {
        {"one", 1, {4321}, {FLAT}, ROBERTS_FLAT, "solid 4321 is flat"},
        {"the last", 1, {CUBES - 1}, {FLAT}, ROBERTS_FLAT, "solid 5999 is flat"},
        {"two kinds", 2, {5000, 100}, {FLAT, DENTED}, ROBERTS_NOT_PLANAR, "of solid 100 "},
        {"two kinds, the other way", 2, {5000, 100}, {DENTED, FLAT}, ROBERTS_FLAT, "solid 100 is flat"},
        {"four in one chunk", 4, {259, 258, 257, 256}, {FLAT, FLAT, DENTED, FLAT}, ROBERTS_FLAT, "solid 256 is flat"},
        /* an open solid that cannot be welded is reported first */
        {"open and flat", 2, {10, 5000}, {OPEN, FLAT}, ROBERTS_NOT_CLOSED, "not closed"},
        {"flat and open", 2, {10, 5000}, {FLAT, OPEN}, ROBERTS_NOT_CLOSED, "not closed"},
        {"endless", 1, {4321}, {ENDLESS}, ROBERTS_BAD_NUMBER, "vertex 34568 is not a finite number"},
        {"flat and endless", 2, {10, 300}, {FLAT, ENDLESS}, ROBERTS_BAD_NUMBER, "vertex 2400 is not a finite number"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        roberts_mesh mesh = row_of_cubes(cases[i].faulty, cases[i].kind, cases[i].count);
        expect_refusal(cases[i].what, &mesh, cases[i].status, cases[i].message);
        roberts_mesh_free(&mesh);
    }
}

static void the_scene_is_the_same(void **state)
{
    roberts_mesh mesh = row_of_cubes(NULL, NULL, 0);
    roberts_scene_options one = {.threads = 1};
    (void)state;
    roberts_scene *expected = scene_of_mesh(&mesh, &one);
    assert_int_equal(expected->solid_count, CUBES);
    assert_int_equal(expected->edge_count, 12 * CUBES);
    for (uint32_t threads = 0; threads <= 7; threads++) {
        roberts_scene_options options = {.threads = threads};
        roberts_scene *scene = scene_of_mesh(&mesh, &options);
        expect_same_scene(scene, expected);
        roberts_scene_free(scene);
    }
    roberts_scene_free(expected);
    roberts_mesh_free(&mesh);
}

/* Vertices and faces in the order of their solids, or not. */
static roberts_mesh two_cubes(bool vertices_mixed, bool faces_mixed, bool open)
{
    roberts_mesh mesh = {0};
    for (uint32_t i = 0; i < 16; i++) {
        uint32_t cube = vertices_mixed ? i % 2 : i / 8, c = vertices_mixed ? i / 2 : i % 8;
        roberts_vec3 p = {3.0 * cube + (c & 1), c >> 1 & 1, c >> 2};
        mesh_vertex(&mesh, p);
    }
    for (uint32_t i = 0; i < (open ? 11u : 12u); i++) {
        uint32_t cube = faces_mixed ? i % 2 : i / 6, side = faces_mixed ? i / 2 : i % 6, v[4];
        for (int k = 0; k < 4; k++)
            v[k] = vertices_mixed ? 2 * face[side][k] + cube : 8 * cube + face[side][k];
        mesh_face(&mesh, v, 4);
    }
    return mesh;
}

/* Every vertex or face a colour of its own. */
static void paint(roberts_color **color, size_t *room, size_t count)
{
    *color = calloc(count, sizeof **color);
    *room = count;
    for (size_t i = 0; i < count; i++)
        (*color)[i] = (roberts_color){1, {(float)i, 0, 0, 0}};
}

static void a_mesh_taken_over_gives_the_same(void **state)
{
    (void)state;
    for (int kind = 0; kind < 16; kind++) {
        int mixed = kind & 3;
        roberts_mesh mesh = two_cubes(mixed & 1, mixed & 2, false);
        const roberts_vec3 *vertex = mesh.vertex;
        const uint32_t *corner = mesh.corner;
        if (kind & 4)
            paint(&mesh.vertex_color, &mesh.vertex_color_room, mesh.vertex_count);
        if (kind & 8)
            paint(&mesh.face_color, &mesh.face_color_room, mesh.face_count);
        roberts_scene *built, *taken;
        assert_int_equal(roberts_scene_build(&mesh, NULL, &built, NULL), ROBERTS_OK);
        assert_int_equal(built->solid_count, 2);
        assert_ptr_equal(mesh.vertex, vertex);
        assert_ptr_not_equal(built->point, vertex);
        assert_int_equal(roberts_scene_take(&mesh, NULL, &taken, NULL), ROBERTS_OK);
        expect_same_scene(taken, built);
        assert_true((taken->point == vertex) == !(mixed & 1));
        assert_true((taken->corner == corner) == (mixed == 0));
        assert_int_equal(mesh.vertex_count + mesh.face_count + mesh.corner_count, 0);
        assert_null(mesh.vertex);
        roberts_mesh_free(&mesh);
        roberts_scene_free(taken);
        roberts_scene_free(built);
    }
}

/* Cubes of loose squares are welded: nothing of the mesh can be kept. */
static void a_mesh_taken_over_may_be_welded(void **state)
{
    roberts_mesh cubes = two_cubes(false, false, false), loose = {0};
    roberts_scene *built, *taken;
    (void)state;
    for (size_t i = 0; i < cubes.corner_count; i++)
        mesh_vertex(&loose, cubes.vertex[cubes.corner[i]]);
    for (uint32_t i = 0; i < cubes.corner_count; i += 4)
        mesh_face(&loose, (uint32_t[]){i, i + 1, i + 2, i + 3}, 4);
    assert_int_equal(roberts_scene_build(&loose, NULL, &built, NULL), ROBERTS_OK);
    assert_int_equal(built->solid_count, 2);
    assert_int_equal(roberts_scene_take(&loose, NULL, &taken, NULL), ROBERTS_OK);
    expect_same_scene(taken, built);
    roberts_scene_free(taken);
    roberts_scene_free(built);
    roberts_mesh_free(&cubes);
}

static void a_mesh_refused_stays_as_it_was(void **state)
{
    roberts_mesh mesh = two_cubes(false, false, true), copy = two_cubes(false, false, true);
    roberts_scene *scene;
    (void)state;
    const roberts_scene_options only_solids = {.solids = true};
    assert_int_equal(roberts_scene_take(&mesh, &only_solids, &scene, NULL), ROBERTS_NOT_CLOSED);
    assert_null(scene);
    assert_int_equal(mesh.vertex_count, copy.vertex_count);
    assert_int_equal(mesh.face_count, copy.face_count);
    assert_memory_equal(mesh.vertex, copy.vertex, copy.vertex_count * sizeof *copy.vertex);
    assert_memory_equal(mesh.face_start, copy.face_start, (copy.face_count + 1) * sizeof *copy.face_start);
    assert_memory_equal(mesh.corner, copy.corner, copy.corner_count * sizeof *copy.corner);
    roberts_mesh_free(&mesh);
    roberts_mesh_free(&copy);
    assert_int_equal(roberts_scene_take(&mesh, &only_solids, &scene, NULL), ROBERTS_NOT_CLOSED); /* without a face */
    roberts_mesh_free(&mesh);
}

static void too_many_threads_are_refused(void **state)
{
    roberts_mesh mesh = {0};
    (void)state;
    for (uint32_t threads = 1025; threads; threads *= 2) {
        roberts_scene_options options = {.threads = threads};
        roberts_scene *scene;
        assert_int_equal(roberts_scene_build(&mesh, &options, &scene, NULL), ROBERTS_BAD_ARGUMENT);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_first_fault_is_told),          cmocka_unit_test(the_scene_is_the_same),
        cmocka_unit_test(a_mesh_taken_over_gives_the_same), cmocka_unit_test(a_mesh_taken_over_may_be_welded),
        cmocka_unit_test(a_mesh_refused_stays_as_it_was),   cmocka_unit_test(too_many_threads_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
