/* test_golden.c - the visible segments of every scene of models/, kept as text in tests/golden/: the program against
 * the golden, and the golden against the exact oracle. `make goldens` writes them anew. */
#include <dirent.h>
#include <string.h>
#include <sys/stat.h>

#include "oracle/golden.h"
#include "folders.h"
#include "testing.h"

/* Folders of bodies that are not convex: test_mesh_oracle.c compares their drawings with the exact oracle. */
static bool left_out(const char *folder)
{
    return !strcmp(folder, "star") || !strcmp(folder, "shapes");
}

/* Calls visit for each model in a folder below models/ and in the folders in it. */
static void each_model(const char *below, void (*visit)(const char *below, void *context), void *context)
{
    char path[600];
    snprintf(path, sizeof path, "models/%s", below);
    DIR *folder = opendir(path);
    assert_non_null(folder);
    for (struct dirent *entry; (entry = readdir(folder));) {
        char name[512];
        struct stat about;
        if (entry->d_name[0] == '.')
            continue;
        snprintf(name, sizeof name, "%s%s", below, entry->d_name);
        snprintf(path, sizeof path, "models/%s", name);
        assert_int_equal(stat(path, &about), 0);
        size_t length = strlen(name);
        if (S_ISDIR(about.st_mode)) {
            if (left_out(name))
                continue;
            snprintf(path, sizeof path, "%s/", name);
            each_model(path, visit, context);
        } else if (length > 4 && !strcmp(name + length - 4, ".off")) {
            visit(name, context);
        }
    }
    closedir(folder);
}

typedef struct outcome {
    golden_total total;
    size_t failed;
} outcome;

static void check_model(const char *below, void *context)
{
    outcome *o = context;
    char path[600];
    snprintf(path, sizeof path, "tests/golden/%.*s.txt", (int)strlen(below) - 4, below);
    if (!golden_check(path, &o->total, stderr))
        o->failed++;
}

static void test_models(void **state)
{
    outcome o = {0};
    (void)state;
    each_model("", check_model, &o);
    print_message("note: %zu models, %zu visible segments; %zu edges held against the exact oracle, not judged: %.5g "
                  "edges\n",
                  o.total.models, o.total.segments, o.total.edges, o.total.unjudged);
    assert_true(o.total.models > 10);
    assert_int_equal(o.failed, 0);
}

/* The oracle notices a wrong golden, whatever the program does. */
static void test_wrong_golden(void **state)
{
    static const struct {
        const char *name, *line;
    } wrong[] = {
        {"hidden edge shown", "1 8 9 0 1 outline\n"},
        {"end moved by 1e-6", "1 8 9 0.250001 1 outline\n"},
        {"edge that is not there", "1 8 70 0 1 outline\n"},
        {"wrong class", "1 8 9 0 0.25 crease\n"},
        {"not a segment", "1 8 9\n"},
    };
    char path[400], said[2000];
    (void)state;
    snprintf(path, sizeof path, "%s/wrong-golden.txt", build_folder());
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        golden_total total = {0};
        FILE *file = fopen(path, "w"), *out = fmemopen(said, sizeof said, "w");
        assert_non_null(file);
        assert_non_null(out);
        fprintf(file, "# model models/tests/test4-two-crossings.off\n# view top\n# slack 0\n%s", wrong[i].line);
        fclose(file);
        if (golden_check(path, &total, out))
            fail_msg("%s: believed", wrong[i].name);
        fclose(out);
        if (i < 4 && !strstr(said, "oracle differ") && !strstr(said, "out of order"))
            fail_msg("%s: not by the oracle: %s", wrong[i].name, said);
    }
    remove(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_models), cmocka_unit_test(test_wrong_golden)};
    return cmocka_run_group_tests_name("golden", tests, NULL, NULL);
}
