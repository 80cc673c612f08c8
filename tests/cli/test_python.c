/* test_python.c - the Python package: tests/python/test_roberts.py with the shared library that was just built, and the
 * package as `make install-python` puts it. */
#include <stdio.h>
#include <stdlib.h>

#include "folders.h"
#include "sanitized.h"
#include "temporary.h"
#include "testing.h"

/* Runs a shell command with the folder of the build as $BUILD, the temporary one as $HERE, and a Python as $python: the
 * first one in the path or, if that lacks numpy, the system's. */
static int shell(const char *command)
{
    char line[4096];
    snprintf(line, sizeof line,
             "BUILD='%s' HERE='%s' python=python3; export BUILD HERE; "
             "$python -c 'import numpy' 2>/dev/null || python=/usr/bin/python3; %s",
             build_folder(), temporary, command);
    return system(line); /* NOLINT(cert-env33-c): a user's commands are shell commands */
}

#define NEED_NUMPY()                                                                                                   \
    do {                                                                                                               \
        if (shell("$python -c 'import numpy' 2>/dev/null") != 0)                                                       \
            SKIP_BECAUSE("no python3-numpy");                                                                          \
        if (SANITIZED)                                                                                                 \
            SKIP_BECAUSE("Python cannot load a library with sanitizers");                                              \
    } while (0)

static void package_works(void **state)
{
    (void)state;
    NEED_NUMPY();
    assert_int_equal(shell("library=$(ls \"$PWD/$BUILD\"/libroberts.so.*.*.*) && "
                           "ROBERTS_LIBRARY=$library PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=src/python "
                           "timeout 300 $python tests/python/test_roberts.py \"$BUILD\" \"$HERE\" 1>&2"),
                     0);
}

static void package_is_installed(void **state)
{
    (void)state;
    NEED_NUMPY();
    assert_int_equal(shell("make --no-print-directory install-python BUILD=\"$BUILD\" PREFIX=\"$HERE/usr\" "
                           "PYTHONTO=\"$HERE/usr/packages\" >\"$HERE/log\" 2>&1 || { cat \"$HERE/log\" >&2; exit 1; }; "
                           "cd / && unset ROBERTS_LIBRARY && PYTHONPATH=\"$HERE/usr/packages\" "
                           "$python -c 'import roberts; print(len(roberts.Scene([[0,0,0],[1,0,0],[0,1,0]], "
                           "[[0,1,2]]).hide(\"top\")))' >\"$HERE/printed\" && grep -qx 3 \"$HERE/printed\""),
                     0);
}

/* DESTDIR is where the files are put; PREFIX is where they will be. */
static void package_is_staged(void **state)
{
    (void)state;
    NEED_NUMPY();
    assert_int_equal(shell("make --no-print-directory install-python BUILD=\"$BUILD\" DESTDIR=\"$HERE/stage\" "
                           "PREFIX=/usr PYTHON=\"$python\" >\"$HERE/log\" 2>&1 || { cat \"$HERE/log\" >&2; exit 1; }; "
                           "cd \"$HERE/stage/usr/lib/python3/dist-packages/roberts\" && test -e py.typed && "
                           "grep -qx 'INSTALLED = \"/usr/lib/libroberts.so.[0-9]*\"' _library.py && "
                           "test -e \"$HERE/stage$(sed -n 's/^INSTALLED = \"\\(.*\\)\"/\\1/p' _library.py)\""),
                     0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(package_works), cmocka_unit_test(package_is_installed),
                                       cmocka_unit_test(package_is_staged)};
    return cmocka_run_group_tests_name("python", tests, temporary_make, temporary_remove);
}
