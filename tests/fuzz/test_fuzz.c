/* test_fuzz.c - what the fuzzers once found (fuzz/found/), and their harnesses on the files of models/. A failure stops
 * the program with the file's name as the last line. The sanitizers see most: make test-sanitize. */
#include <dirent.h>
#include <stdio.h>
#include <string.h>

#include "fuzz/fuzz.h"
#include "testing.h"

typedef int harness(const uint8_t *bytes, size_t size);

/* The file behind `settings`. */
static void run(harness *fuzz, const char *path, const char *settings, size_t settings_size)
{
    static uint8_t bytes[1 << 16];
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    if (settings_size > 0)
        memcpy(bytes, settings, settings_size);
    size_t size = settings_size + fread(bytes + settings_size, 1, sizeof bytes - settings_size, file);
    assert_true(size < sizeof bytes && !ferror(file));
    fclose(file);
    fprintf(stderr, "%s\n", path);
    fuzz(bytes, size);
}

static void found(void **state)
{
    char path[512];
    size_t count = 0;
    (void)state;
    DIR *directory = opendir("tests/fuzz/found");
    assert_non_null(directory);
    for (struct dirent *entry; (entry = readdir(directory));) {
        harness *fuzz = strncmp(entry->d_name, "read-", 5) == 0       ? fuzz_read
                        : strncmp(entry->d_name, "stl-", 4) == 0      ? fuzz_stl
                        : strncmp(entry->d_name, "obj-", 4) == 0      ? fuzz_obj
                        : strncmp(entry->d_name, "ply-", 4) == 0      ? fuzz_ply
                        : strncmp(entry->d_name, "pipeline-", 9) == 0 ? fuzz_pipeline
                                                                      : NULL;
        if (!fuzz)
            continue;
        snprintf(path, sizeof path, "tests/fuzz/found/%s", entry->d_name);
        run(fuzz, path, NULL, 0);
        count++;
    }
    closedir(directory);
    assert_true(count > 0);
}

static void models(void **state)
{
    static const char *const files[] = {"models/table.off",
                                        "models/tower.off",
                                        "models/plates.off",
                                        "models/stella-octangula.off",
                                        "models/staircase.off",
                                        "models/compound-of-three-cubes.off",
                                        "models/brick-wall.off",
                                        "models/tests/test3-pierced.off",
                                        "tests/fuzz/seeds/house.stl",
                                        "tests/fuzz/seeds/house-binary.stl",
                                        "tests/fuzz/seeds/house.obj",
                                        "tests/fuzz/seeds/house.ply",
                                        "tests/fuzz/seeds/house-little.ply",
                                        "tests/fuzz/seeds/house-big.ply"};
    static const char settings[][FUZZ_SETTINGS + 1] = {
        {0},                             /* isometric */
        "\1\12\24\36\1\0\4\3\12\0\0\0",  /* from any side, with hidden lines */
        "\2\0\360\1\10\10\3\21\0\0\0\0", /* oblique */
        "\3\50\24\30\0\0\1\11\1\0\0\0",  /* perspective */
        "\7\4\2\3\1\1\5\23\1\0\10\132",  /* the eye within the scene's box */
    };
    (void)state;
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
        run(fuzz_read, files[i], NULL, 0);
        run(fuzz_stl, files[i], "\0", 1);
        run(fuzz_stl, files[i], "\1", 1);
        run(fuzz_stl, files[i], "\2", 1);
        run(fuzz_obj, files[i], NULL, 0);
        run(fuzz_ply, files[i], NULL, 0);
        for (size_t k = 0; k < sizeof settings / sizeof settings[0]; k++)
            run(fuzz_pipeline, files[i], settings[k], FUZZ_SETTINGS);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(found), cmocka_unit_test(models)};
    return cmocka_run_group_tests_name("fuzz", tests, NULL, NULL);
}
