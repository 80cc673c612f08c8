/* test_converters.c - the commands that refusals of other formats name: each is run as it is printed, and what it makes
 * is drawn. A test is skipped if its converter is not installed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "program.h"
#include "skip.h"

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

/* Gives the program a file that it refuses, runs the command that it names, and draws the model that this makes. */
static void convert(const char *file)
{
    static const char before[] = "to convert it: ";
    char line[128], command[512];
    snprintf(line, sizeof line, "-f null %s", file);
    assert_int_equal(run(line), 1);
    const char *said = strstr(last.err, before);
    assert_non_null(said);
    snprintf(command, sizeof command, "%s", said + sizeof before - 1);
    command[strcspn(command, "\n")] = '\0';
    shell(command);
    assert_int_equal(run("-v -f null model.stl"), 0);
    assert_said("1 body, 8 vertices, 12 faces");
}

static void from_gltf(void **state)
{
    static const char *const file[] = {"model.glb", "model.gltf"};
    char line[4096];
    (void)state;
    if (!has_command("assimp"))
        SKIP_BECAUSE("assimp is not installed (Debian: assimp-utils)");
    for (size_t i = 0; i < sizeof file / sizeof file[0]; i++) {
        snprintf(line, sizeof line, "rm -f model.stl && assimp export '%s/models/platonic/cube.off' %s", top, file[i]);
        shell(line);
        convert(file[i]);
    }
}

static void from_scad(void **state)
{
    (void)state;
    if (!has_command("openscad"))
        SKIP_BECAUSE("openscad is not installed");
    put("model.scad", "cube(3);\n");
    convert("model.scad");
    shell("rm model.stl && openscad -o model.3mf model.scad");
    convert("model.3mf");
}

int main(void)
{
    const struct CMUnitTest tests[] = {IN_FOLDER(from_gltf), IN_FOLDER(from_scad)};
    if (!program_find())
        return 1;
    return cmocka_run_group_tests(tests, NULL, NULL);
}
