/* test_web.c - what `make web` builds: the npm package in node (tests/web/npm.js), its types (tests/web/types.ts), and
 * the page in Chromium (tests/web/page.js). All are skipped if it has not been run. */
#include <stdio.h>
#include <stdlib.h>

#include "folders.h"
#include "temporary.h"
#include "testing.h"

/* Runs a shell command with the folder of the build as $BUILD and the temporary one as $HERE. */
static int shell(const char *command)
{
    char line[4096];
    snprintf(line, sizeof line, "BUILD='%s' HERE='%s'; export BUILD HERE; %s", build_folder(), temporary, command);
    return system(line); /* NOLINT(cert-env33-c): a user's commands are shell commands */
}

#define NEED_WEB()                                                                                                     \
    do {                                                                                                               \
        if (shell("test -e \"$BUILD/web/npm/roberts.wasm\"") != 0)                                                     \
            SKIP_BECAUSE("`make web` has not run");                                                                    \
        if (shell("command -v node >\"$HERE/node\"") != 0)                                                             \
            SKIP_BECAUSE("no node");                                                                                   \
    } while (0)

static void package_draws_as_the_program(void **state)
{
    (void)state;
    NEED_WEB();
    assert_int_equal(shell("timeout 300 node --expose-gc tests/web/npm.js \"$BUILD/roberts\" \"$BUILD/web/npm\" models "
                           "models/archimedean models/star models/shapes models/tests >\"$HERE/said\" 2>&1 || "
                           "{ cat \"$HERE/said\" >&2; exit 1; }"),
                     0);
}

static void types_are_checked(void **state)
{
    (void)state;
    NEED_WEB();
    if (shell("command -v tsc >\"$HERE/tsc\"") != 0)
        SKIP_BECAUSE("no tsc");
    assert_int_equal(shell("mkdir -p \"$HERE/types/node_modules\" && "
                           "cp -r \"$BUILD/web/npm\" \"$HERE/types/node_modules/roberts\" && "
                           "cp tests/web/package.json tests/web/types.ts \"$HERE/types/\" && cd \"$HERE/types\" && "
                           "timeout 100 tsc --noEmit --strict --module nodenext --target es2022 types.ts 1>&2"),
                     0);
}

static void page_works_in_a_browser(void **state)
{
    (void)state;
    NEED_WEB();
    if (shell("command -v chromium chromium-browser google-chrome >\"$HERE/browser\"; test -s \"$HERE/browser\"") != 0)
        SKIP_BECAUSE("no Chromium");
    assert_int_equal(shell("mkdir \"$HERE/page\" && timeout 300 node tests/web/page.js \"$BUILD/roberts\" "
                           "\"$BUILD/web/page\" \"$HERE/page\" >\"$HERE/said\" 2>&1; status=$?; "
                           "[ $status -eq 0 ] || { cat \"$HERE/said\" >&2; exit 1; }; grep '^note: ' \"$HERE/said\""),
                     0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(package_draws_as_the_program),
                                       cmocka_unit_test(types_are_checked), cmocka_unit_test(page_works_in_a_browser)};
    return cmocka_run_group_tests_name("web", tests, temporary_make, temporary_remove);
}
