/* test_formats.c - one model in all formats gives one drawing, from files and from pipes; and how 32-bit floats affect
 * the touching distance. The model is tests/fuzz/seeds/house.*: a box and the roof on it. */
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "read/mesh.h"
#include "build_scene.h"
#include "roberts.h"
#include "testing.h"

static const struct format {
    const char *path;
    size_t vertices, faces;
    const char *groups;
    roberts_epsilon_reason reason;
} formats[] = {
    {"tests/fuzz/seeds/house.off", 14, 11, "", ROBERTS_EPSILON_DIAMETER},
    {"tests/fuzz/seeds/house.stl", 14, 20, "walls@0 roof@12 ", ROBERTS_EPSILON_DIAMETER},
    {"tests/fuzz/seeds/house-binary.stl", 10, 20, "", ROBERTS_EPSILON_FLOAT32},
    {"tests/fuzz/seeds/house.obj", 14, 11, "walls@0 roof@6 ", ROBERTS_EPSILON_DIAMETER},
    {"tests/fuzz/seeds/house.ply", 14, 11, "", ROBERTS_EPSILON_DIAMETER},
    {"tests/fuzz/seeds/house-little.ply", 14, 11, "", ROBERTS_EPSILON_FLOAT32},
    {"tests/fuzz/seeds/house-big.ply", 14, 11, "", ROBERTS_EPSILON_FLOAT32},
};

typedef struct bytes {
    char text[1 << 16];
    size_t length;
} bytes;

static bool take_bytes(void *context, const void *from, size_t size)
{
    bytes *b = context;
    assert_true(b->length + size < sizeof b->text);
    memcpy(b->text + b->length, from, size);
    b->length += size;
    return true;
}

static ptrdiff_t read_pipe(void *context, void *buffer, size_t size)
{
    return read(*(int *)context, buffer, size);
}

/* Draws the mesh and empties it. */
static roberts_drawing draw(roberts_mesh *mesh, double epsilon, bytes *svg)
{
    roberts_scene *scene;
    roberts_hide_options hide = roberts_hide_options_default();
    roberts_draw_options options = roberts_draw_options_default();
    assert_int_equal(roberts_scene_take(mesh, NULL, &scene, NULL), ROBERTS_OK);
    assert_int_equal(roberts_scene_solid_count(scene), 2);
    roberts_camera camera = preset_camera("trimetric");
    hide.keep_hidden = true;
    hide.epsilon = epsilon;
    options.hidden = ROBERTS_HIDDEN_DASHED;
    svg->length = 0;
    roberts_drawing drawing = drawing_of(scene, &camera, &hide);
    assert_int_equal(roberts_drawing_write(&drawing, &options, take_bytes, svg, NULL), ROBERTS_OK);
    roberts_scene_free(scene);
    return drawing;
}

static void one_drawing(void **state)
{
    static bytes first, other;
    (void)state;
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++)
        for (int piped = 0; piped < 2; piped++) {
            roberts_mesh mesh = {0};
            roberts_error error = {0};
            char groups[100] = "";
            int descriptor = open(formats[i].path, O_RDONLY);
            assert_true(descriptor >= 0);
            roberts_status status = piped ? roberts_mesh_read(&mesh, "pipe", read_pipe, &descriptor, NULL, &error)
                                          : roberts_mesh_read_file(&mesh, formats[i].path, NULL, &error);
            close(descriptor);
            if (status != ROBERTS_OK)
                fail_msg("%s: %s", formats[i].path, error.message);
            assert_int_equal(mesh.vertex_count, formats[i].vertices);
            assert_int_equal(mesh.face_count, formats[i].faces);
            for (size_t g = 0; g < mesh.group_count; g++)
                snprintf(groups + strlen(groups), sizeof groups - strlen(groups), "%s@%lu ", mesh.group[g].name,
                         (unsigned long)mesh.group[g].first_face);
            assert_string_equal(groups, formats[i].groups);
            roberts_drawing drawing = draw(&mesh, 0, i + (size_t)piped ? &other : &first);
            assert_int_equal(drawing.epsilon_reason, formats[i].reason);
            if (i + (size_t)piped &&
                (first.length != other.length || memcmp(first.text, other.text, first.length) != 0))
                fail_msg("%s: another drawing", formats[i].path);
            roberts_drawing_free(&drawing);
        }
}

/* The house's largest coordinate is 3, whose last place as a float is 2^-22. */
static void epsilon_of_floats(void **state)
{
    static bytes svg;
    roberts_mesh mesh = {0};
    (void)state;
    assert_int_equal(roberts_mesh_read_file(&mesh, "tests/fuzz/seeds/house-big.ply", NULL, NULL), ROBERTS_OK);
    roberts_drawing drawing = draw(&mesh, 0, &svg);
    assert_true(drawing.epsilon == 0x1p-21);
    roberts_drawing_free(&drawing);
    assert_int_equal(roberts_mesh_read_file(&mesh, "tests/fuzz/seeds/house-big.ply", NULL, NULL), ROBERTS_OK);
    drawing = draw(&mesh, 1e-9, &svg);
    assert_true(fabs(drawing.epsilon - 1e-9) < 1e-20);
    assert_int_equal(drawing.epsilon_reason, ROBERTS_EPSILON_GIVEN);
    roberts_drawing_free(&drawing);
}

/* The step between floats of some size: see nextafterf(). Inputs without floats do not count, whatever their size. */
static void steps(void **state)
{
    static const float sizes[] = {1.0f, 1.5f, 0x1.fffffep0f, 2.0f, 3.0f, 1e-3f, 12345.678f, 1e20f, 1e-20f};
    (void)state;
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        roberts_mesh mesh = {0};
        assert_true(mesh_source(&mesh, "text"));
        mesh_vertex(&mesh, (roberts_vec3){1e30, 0, 0});
        assert_true(mesh_rounding(&mesh, true).float32 == 0.0);
        assert_true(mesh_source(&mesh, "floats"));
        mesh_float32(&mesh);
        assert_true(mesh_rounding(&mesh, true).float32 == 0.0);
        mesh_vertex(&mesh, (roberts_vec3){0, -(double)sizes[i], 0});
        assert_true(mesh_source(&mesh, "text again"));
        mesh_vertex(&mesh, (roberts_vec3){1e30, 0, 0});
        assert_true(mesh_rounding(&mesh, true).float32 ==
                    2.0 * ((double)nextafterf(sizes[i], INFINITY) - (double)sizes[i]));
        roberts_mesh_free(&mesh);
    }
}

/* Solids have the names of their groups, whether the mesh is taken over or copied. */
static void names(void **state)
{
    (void)state;
    for (int taken = 0; taken < 2; taken++) {
        roberts_mesh mesh = {0};
        roberts_scene *scene;
        assert_int_equal(roberts_mesh_read_file(&mesh, "tests/fuzz/seeds/house.off", NULL, NULL), ROBERTS_OK);
        assert_int_equal(roberts_mesh_read_file(&mesh, "tests/fuzz/seeds/house.stl", NULL, NULL), ROBERTS_OK);
        assert_int_equal(roberts_mesh_read_file(&mesh, "tests/fuzz/seeds/house-big.ply", NULL, NULL), ROBERTS_OK);
        assert_int_equal(taken ? roberts_scene_take(&mesh, NULL, &scene, NULL)
                               : roberts_scene_build(&mesh, NULL, &scene, NULL),
                         ROBERTS_OK);
        assert_int_equal(mesh.group_count, taken ? 0 : 3);
        roberts_mesh_free(&mesh);
        static const char *const expected[] = {"", "", "walls", "roof", "", "", ""};
        assert_int_equal(roberts_scene_solid_count(scene), 6);
        for (uint32_t s = 0; s < 7; s++)
            assert_string_equal(roberts_scene_name(scene, s), expected[s]);
        roberts_scene_free(scene);
    }
}

/* The groups of a file end with it. */
static void groups_of_several_inputs(void **state)
{
    roberts_mesh mesh = {0};
    (void)state;
    assert_int_equal(roberts_mesh_read_file(&mesh, "tests/fuzz/seeds/house.off", NULL, NULL), ROBERTS_OK);
    assert_null(mesh.group);
    assert_int_equal(roberts_mesh_read_file(&mesh, "tests/fuzz/seeds/house.obj", NULL, NULL), ROBERTS_OK);
    assert_int_equal(roberts_mesh_read_file(&mesh, "tests/fuzz/seeds/house.off", NULL, NULL), ROBERTS_OK);
    assert_int_equal(mesh.group_count, 3);
    assert_string_equal(mesh.group[2].name, "");
    assert_int_equal(mesh.group[0].first_face, 11);
    assert_int_equal(mesh.group[2].first_face, 22);
    roberts_mesh_free(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_drawing), cmocka_unit_test(epsilon_of_floats),        cmocka_unit_test(steps),
        cmocka_unit_test(names),       cmocka_unit_test(groups_of_several_inputs),
    };
    return cmocka_run_group_tests_name("formats", tests, NULL, NULL);
}
