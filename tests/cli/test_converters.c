/* test_converters.c - the commands named by refusals of other formats: each is run as printed, and its output is drawn.
 * A test is skipped if its converter is not installed. */
#include "program.h"
#include "testing.h"

static bool has_command(const char *name)
{
    char line[128];
    snprintf(line, sizeof line, "command -v %s >/dev/null 2>&1", name);
    return system(line) == 0; /* NOLINT(cert-env33-c): as a user's shell finds it */
}

static void shell(const char *command)
{
    char line[8192];
    snprintf(line, sizeof line, "{ %s; } >said 2>&1", command);
    if (system(line) != 0) /* NOLINT(cert-env33-c): a user's commands are shell commands */
        fail_msg("failed: %s", command);
}

/* Gives the program a file that it refuses, runs the command that it names, and draws `made`, the model that this
 * command makes. The program reports `what` about it. */
static void convert(const char *file, const char *made, const char *what)
{
    static const char before[] = "to convert it: ";
    char line[128], command[512];
    remove(made);
    snprintf(line, sizeof line, "-f null %s", file);
    assert_int_equal(run(line), 1);
    const char *said = strstr(last.err, before);
    assert_non_null(said);
    snprintf(command, sizeof command, "%s", said + sizeof before - 1);
    command[strcspn(command, "\n")] = '\0';
    shell(command);
    snprintf(line, sizeof line, "-v -f null %s", made);
    assert_int_equal(run(line), 0);
    assert_said(what);
}

static const char cube_of_triangles[] = "1 body, 8 vertices, 12 faces";

static void from_meshes(void **state)
{
    static const char *const file[] = {"model.glb", "model.gltf", "model.dae", "model.3ds", "model.x3d"};
    char line[4096];
    (void)state;
    if (!has_command("assimp"))
        SKIP_BECAUSE("assimp is not installed (Debian: assimp-utils)");
    for (size_t i = 0; i < sizeof file / sizeof file[0]; i++) {
        snprintf(line, sizeof line, "assimp export '%s/models/platonic/cube.off' %s", top, file[i]);
        shell(line);
        convert(file[i], "model.stl", cube_of_triangles);
    }
}

static void from_scad(void **state)
{
    (void)state;
    if (!has_command("openscad"))
        SKIP_BECAUSE("openscad is not installed");
    put("model.scad", "cube(3);\n");
    convert("model.scad", "model.stl", cube_of_triangles);
    shell("openscad -o model.3mf model.scad");
    convert("model.3mf", "model.stl", cube_of_triangles);
}

/* Gmsh divides faces into triangles of a size that it chooses. */
static void from_solids(void **state)
{
    static const char *const file[] = {"model.step", "model.brep"};
    char line[128];
    (void)state;
    if (!has_command("gmsh"))
        SKIP_BECAUSE("gmsh is not installed");
    put("box.geo", "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 1, 2, 3};\n");
    for (size_t i = 0; i < sizeof file / sizeof file[0]; i++) {
        snprintf(line, sizeof line, "gmsh -0 box.geo -o %s", file[i]);
        shell(line);
        convert(file[i], "model.stl", "1 body, ");
    }
    shell("gmsh -2 box.geo -o model.msh && gmsh -2 box.geo -o model.mesh");
    convert("model.msh", "model.stl", "1 body, ");
    convert("model.mesh", "model.stl", "1 body, ");
}

/* A new scene of Blender holds a cube. */
static void from_blender(void **state)
{
    (void)state;
    if (!has_command("blender"))
        SKIP_BECAUSE("blender is not installed");
    shell("blender -b --factory-startup --python-expr "
          "\"import bpy, os; bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath('model.blend'))\"");
    convert("model.blend", "model.obj", "1 body, 8 vertices, 6 faces");
}

int main(void)
{
    const struct CMUnitTest tests[] = {IN_FOLDER(from_meshes), IN_FOLDER(from_scad), IN_FOLDER(from_solids),
                                       IN_FOLDER(from_blender)};
    if (!program_find())
        return 1;
    return cmocka_run_group_tests(tests, NULL, NULL);
}
