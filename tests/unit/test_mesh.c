/* test_mesh.c - the mesh as a container: what may be added, and what is refused and changes nothing. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "roberts.h"
#include "testing.h"

static void adds_vertices_and_faces(void **state)
{
    roberts_mesh mesh = {0};
    (void)state;
    for (uint32_t v = 0; v < 1000; v++) {
        uint32_t index = ROBERTS_NONE;
        assert_int_equal(roberts_mesh_add_vertex(&mesh, (roberts_vec3){v, -1.0 * v, 0.5}, &index, NULL), ROBERTS_OK);
        assert_int_equal(index, v);
    }
    for (uint32_t count = 0; count < 200; count++) {
        uint32_t corner[200];
        for (uint32_t i = 0; i < count; i++)
            corner[i] = (count * 7 + i) % 1000;
        assert_int_equal(roberts_mesh_add_face(&mesh, count ? corner : NULL, count, NULL), ROBERTS_OK);
    }
    assert_true(mesh.vertex_count == 1000 && mesh.face_count == 200 && mesh.corner_count == 199 * 200 / 2);
    for (uint32_t count = 0; count < 200; count++) {
        assert_int_equal(mesh.face_start[count + 1] - mesh.face_start[count], count);
        for (uint32_t i = 0; i < count; i++)
            assert_int_equal(mesh.corner[mesh.face_start[count] + i], (count * 7 + i) % 1000);
    }
    assert_true(mesh.vertex[999].y == -999.0 && mesh.vertex[999].z == 0.5);
    assert_true(!mesh.vertex_color && !mesh.face_color && !mesh.source);
    roberts_mesh_free(&mesh);
}

static void refuses_bad_coordinates(void **state)
{
    static const double bad[] = {INFINITY, -INFINITY, NAN, DBL_MAX, -1.0000000000000002e150};
    static const double good[] = {1e150, -1e150, 0.0, DBL_MIN, 4.9e-324};
    roberts_mesh mesh = {0};
    roberts_error error;
    (void)state;
    for (size_t i = 0; i < 3 * sizeof bad / sizeof *bad; i++) {
        roberts_vec3 p = {1, 2, 3};
        *(i % 3 == 0 ? &p.x : i % 3 == 1 ? &p.y : &p.z) = bad[i / 3];
        strcpy(error.file, "of another call");
        assert_int_equal(roberts_mesh_add_vertex(&mesh, p, NULL, &error), ROBERTS_BAD_NUMBER);
        assert_string_equal(error.message, "vertex 0 has a coordinate that is infinite or beyond 1e+150");
        assert_true(error.file[0] == '\0' && error.line == 0 && mesh.vertex_count == 0);
    }
    for (size_t i = 0; i < sizeof good / sizeof *good; i++)
        assert_int_equal(roberts_mesh_add_vertex(&mesh, (roberts_vec3){good[i], -good[i], 0}, NULL, &error),
                         ROBERTS_OK);
    roberts_mesh_free(&mesh);
}

static void refuses_bad_corners(void **state)
{
    static const uint32_t rows[][3] = {{0, 1, 3}, {3, 0, 1}, {0, UINT32_MAX, 1}};
    roberts_mesh mesh = {0};
    roberts_error error;
    (void)state;
    for (int i = 0; i < 3; i++)
        assert_int_equal(roberts_mesh_add_vertex(&mesh, (roberts_vec3){i, 0, 0}, NULL, NULL), ROBERTS_OK);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        assert_int_equal(roberts_mesh_add_face(&mesh, rows[i], 3, &error), ROBERTS_BAD_INDEX);
        assert_true(mesh.face_count == 0 && mesh.corner_count == 0);
    }
    assert_string_equal(error.message, "face 0 names vertex 4294967295, but there are 3");
    roberts_mesh_free(&mesh);
}

/* Vertices and faces added by hand to a mesh with colours have none. */
static void adds_to_a_coloured_mesh(void **state)
{
    static const char text[] = "COFF 1 1 0\n0 0 0 1. 0 0\n1 0 7\n";
    const uint32_t corner[] = {0, 1, 0};
    roberts_mesh mesh = {0};
    (void)state;
    assert_int_equal(roberts_mesh_read_memory(&mesh, "t", text, strlen(text), NULL, NULL), ROBERTS_OK);
    for (int i = 0; i < 100; i++) {
        assert_int_equal(roberts_mesh_add_vertex(&mesh, (roberts_vec3){1, 2, 3}, NULL, NULL), ROBERTS_OK);
        assert_int_equal(roberts_mesh_add_face(&mesh, corner, 3, NULL), ROBERTS_OK);
        assert_int_equal(mesh.vertex_color[i + 1].count, 0);
        assert_int_equal(mesh.face_color[i + 1].count, 0);
    }
    assert_int_equal(mesh.vertex_color[0].count, 3);
    assert_int_equal(mesh.face_color[0].count, 1);
    roberts_mesh_free(&mesh);
}

/* An input without a name can be read, and refused. */
static void reads_without_a_name(void **state)
{
    static const char text[] = "OFF 1 0 0\n0 0 0\n", bad[] = "OFF 1 0 0\n0 0 x\n";
    roberts_mesh mesh = {0};
    roberts_error error;
    (void)state;
    assert_int_equal(roberts_mesh_read_memory(&mesh, NULL, text, strlen(text), NULL, &error), ROBERTS_OK);
    assert_string_equal(mesh.source[0].name, "");
    assert_int_equal(roberts_mesh_read_memory(&mesh, NULL, bad, strlen(bad), NULL, &error), ROBERTS_BAD_SYNTAX);
    assert_string_equal(error.file, "");
    assert_int_equal(error.line, 2);
    roberts_mesh_free(&mesh);
}

/* A mesh over arrays gives the scene that vertices and faces one by one give, and leaves the arrays as they are. */
static void takes_arrays_in_place(void **state)
{
    static const roberts_vec3 vertex[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    static const uint32_t start[] = {0, 3, 3, 6, 9, 12}, corner[] = {0, 1, 2, 0, 1, 3, 1, 2, 3, 2, 0, 3};
    roberts_vec3 own_vertex[4];
    uint32_t own_start[6], own_corner[12];
    roberts_mesh built = {0};
    roberts_scene *scene[2];
    (void)state;
    memcpy(own_vertex, vertex, sizeof vertex);
    memcpy(own_start, start, sizeof start);
    memcpy(own_corner, corner, sizeof corner);
    const roberts_mesh given = {.vertex_count = 4,
                                .face_count = 5,
                                .corner_count = 12,
                                .vertex = own_vertex,
                                .face_start = own_start,
                                .corner = own_corner};
    for (size_t v = 0; v < 4; v++)
        assert_int_equal(roberts_mesh_add_vertex(&built, vertex[v], NULL, NULL), ROBERTS_OK);
    for (size_t f = 0; f < 5; f++)
        assert_int_equal(roberts_mesh_add_face(&built, corner + start[f], start[f + 1] - start[f], NULL), ROBERTS_OK);
    assert_int_equal(roberts_mesh_check(&given, NULL), ROBERTS_OK);
    assert_int_equal(roberts_scene_build(&given, NULL, &scene[0], NULL), ROBERTS_OK);
    assert_int_equal(roberts_scene_build(&built, NULL, &scene[1], NULL), ROBERTS_OK);
    assert_int_equal(roberts_scene_edge_count(scene[0]), 6);
    assert_int_equal(roberts_scene_edge_count(scene[1]), 6);
    assert_int_equal(roberts_scene_face_count(scene[0]), roberts_scene_face_count(scene[1]));
    assert_memory_equal(own_vertex, vertex, sizeof vertex);
    assert_memory_equal(own_start, start, sizeof start);
    assert_memory_equal(own_corner, corner, sizeof corner);
    roberts_scene_free(scene[0]);
    roberts_scene_free(scene[1]);
    roberts_mesh_free(&built);
}

static void refuses_bad_arrays(void **state)
{
    static roberts_vec3 vertex[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, bad[] = {{0, 0, 0}, {0, NAN, 0}, {0, 1, 0}};
    static uint32_t corner[] = {0, 1, 2}, beyond[] = {0, 1, 3}, start[] = {0, 3, 3}, late[] = {1, 3, 3},
                    back[] = {0, 4, 3}, brief[] = {0, 1, 2};
    const struct {
        size_t vertices;
        roberts_vec3 *vertex;
        uint32_t *start, *corner; /* NULL: no faces */
        roberts_status status;
        const char *message;
    } rows[] = {
        {3, vertex, start, corner, ROBERTS_OK, NULL},
        {3, vertex, NULL, NULL, ROBERTS_OK, NULL},
        {3, bad, start, corner, ROBERTS_BAD_NUMBER, "vertex 1 has a coordinate that is infinite or beyond 1e+150"},
        {3, vertex, start, beyond, ROBERTS_BAD_INDEX, "face 0 names vertex 3, but there are 3"},
        {3, vertex, late, corner, ROBERTS_BAD_ARGUMENT, "face_start begins with 1, not with 0"},
        {3, vertex, back, corner, ROBERTS_BAD_ARGUMENT, "face_start descends behind face 1"},
        {3, vertex, brief, corner, ROBERTS_BAD_ARGUMENT, "face_start ends with 2, but there are 3 corners"},
        {3, NULL, start, corner, ROBERTS_BAD_ARGUMENT, "vertex is NULL, but there are 3 vertices"},
        {3, vertex, start, NULL, ROBERTS_BAD_ARGUMENT, "corner is NULL, but there are 3 corners"},
        {ROBERTS_NONE, vertex, start, corner, ROBERTS_BAD_ARGUMENT,
         "there are more vertices, faces or corners than 32 bits count"},
    };
    roberts_scene *scene;
    roberts_error error;
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const roberts_mesh mesh = {.vertex_count = rows[i].vertices,
                                   .vertex = rows[i].vertex,
                                   .face_count = rows[i].start ? 2 : 0,
                                   .face_start = rows[i].start,
                                   .corner_count = rows[i].start ? 3 : 0,
                                   .corner = rows[i].corner};
        assert_int_equal(roberts_mesh_check(&mesh, &error), rows[i].status);
        if (!rows[i].message)
            continue;
        assert_string_equal(error.message, rows[i].message);
        assert_int_equal(roberts_scene_build(&mesh, NULL, &scene, &error), rows[i].status);
        assert_null(scene);
        assert_true(rows[i].status == ROBERTS_BAD_NUMBER || strcmp(error.message, rows[i].message) == 0);
    }
    assert_int_equal(roberts_mesh_check(&(roberts_mesh){.source_count = 1}, &error), ROBERTS_BAD_ARGUMENT);
    assert_string_equal(error.message, "arrays have neither sources nor groups");
    assert_int_equal(roberts_mesh_check(&(roberts_mesh){.face_count = 2}, &error), ROBERTS_BAD_ARGUMENT);
    assert_string_equal(error.message, "face_start is NULL, but there are 2 faces");
}

static void frees_what_is_empty(void **state)
{
    roberts_mesh mesh = {0};
    (void)state;
    roberts_mesh_free(NULL);
    roberts_mesh_free(&mesh);
    assert_int_equal(roberts_mesh_add_vertex(&mesh, (roberts_vec3){0, 0, 0}, NULL, NULL), ROBERTS_OK);
    roberts_mesh_free(&mesh);
    roberts_mesh_free(&mesh);
    assert_true(mesh.vertex == NULL && mesh.vertex_count == 0 && mesh.vertex_room == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(adds_vertices_and_faces), cmocka_unit_test(refuses_bad_coordinates),
        cmocka_unit_test(refuses_bad_corners),     cmocka_unit_test(adds_to_a_coloured_mesh),
        cmocka_unit_test(frees_what_is_empty),     cmocka_unit_test(reads_without_a_name),
        cmocka_unit_test(takes_arrays_in_place),   cmocka_unit_test(refuses_bad_arrays),
    };
    return cmocka_run_group_tests_name("mesh", tests, NULL, NULL);
}
