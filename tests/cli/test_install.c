/* test_install.c - `make install` into a folder, and three clients built against the installed files, as a user would:
 * by pkg-config, with the shared and with the static library. */
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "testing.h"

static char root[256]; /* everything goes here, below the build folder */

static const char *setting(const char *name, const char *fallback)
{
    const char *value = getenv(name);
    return value && *value ? value : fallback;
}

/* Runs a shell command, its output to `root`.log, which a failure shows. */
static void run(const char *command)
{
    char line[8192], log[512], text[4096];
    snprintf(line, sizeof line, "{ %s; } >%s.log 2>&1", command, root);
    if (system(line) == 0) /* NOLINT(cert-env33-c): a user's commands are shell commands */
        return;
    snprintf(log, sizeof log, "%s.log", root);
    FILE *file = fopen(log, "r");
    size_t got = file ? fread(text, 1, sizeof text - 1, file) : 0;
    text[got] = '\0';
    if (file)
        (void)fclose(file);
    fail_msg("%s\n%s", command, text);
}

static int set_up(void **state)
{
    char command[4096];
    const char *build = setting("ROBERTS_BUILD", "build");
    (void)state;
    snprintf(root, sizeof root, "%s/installed", build);
    snprintf(command, sizeof command, "rm -rf %s && make --no-print-directory install BUILD=%s PREFIX=\"$PWD/%s\"",
             root, build, root);
    run(command);
    return 0;
}

/* pkg-config puts a backslash before a blank in a path, which the shell must read once more (eval).
 * The compiler's own flags belong to the build that is tested: a sanitizer's library needs its run-time library. */
static void build_client(const char *compiler, const char *source, const char *flags, const char *link)
{
    char command[4096];
    snprintf(command, sizeof command,
             "PKG_CONFIG_PATH=\"$PWD/%s/lib/pkgconfig\"; export PKG_CONFIG_PATH; "
             "eval \"%s %s tests/examples/%s $(pkg-config --cflags roberts) -o %s/client %s -lm\"",
             root, compiler, flags, source, root, link);
    run(command);
}

static void run_client(const char *arguments, const char *expected)
{
    char command[4096];
    snprintf(command, sizeof command, "LD_LIBRARY_PATH=\"$PWD/%s/lib\" %s/client %s >%s.out && grep -q '%s' %s.out",
             root, root, arguments, root, expected, root);
    run(command);
}

static void c_client_draws(void **state)
{
    char arguments[512], command[4096];
    (void)state;
    build_client(setting("CC", "cc"), "draw_scene.c", setting("CFLAGS_USED", ""), "$(pkg-config --libs roberts)");
    snprintf(arguments, sizeof arguments, "%s/blocks.svg; echo done", root);
    run_client(arguments, "done");
    snprintf(command, sizeof command, "grep -q '</svg>' %s/blocks.svg", root);
    run(command);
}

/* A cube of edge 2 seen from above: its top's four sides. */
static void c_client_takes_segments(void **state)
{
    (void)state;
    build_client(setting("CC", "cc"), "segments.c", setting("CFLAGS_USED", ""), "$(pkg-config --libs roberts)");
    run_client("models/platonic/cube.off", "4 segments, 8 long");
    build_client(setting("CC", "cc"), "segments.c", setting("CFLAGS_USED", ""),
                 "-Wl,-Bstatic $(pkg-config --static --libs-only-L roberts) -lroberts -Wl,-Bdynamic "
                 "$(pkg-config --libs qhull_r zlib) -ldl -pthread");
    run_client("models/platonic/cube.off", "4 segments, 8 long");
}

static void cxx_client(void **state)
{
    char flags[1024];
    (void)state;
    snprintf(flags, sizeof flags, "-std=c++17 %s", setting("CFLAGS_USED", ""));
    build_client(setting("CXX", "c++"), "segments.cpp", flags, "$(pkg-config --libs roberts)");
    run_client("models/platonic/cube.off", "solid 0: 4 segments");
}

/* Every symbol that the shared library defines for others begins with roberts_, and the header's are among them. */
static void exports_only_its_own(void **state)
{
    char command[4096];
    (void)state;
    snprintf(command, sizeof command,
             "nm -D --defined-only %s/lib/libroberts.so >%s.nm && ! grep -v ' roberts_' %s.nm && "
             "grep -q ' roberts_hide$' %s.nm && grep -q ' roberts_ray_triangle$' %s.nm && "
             "readelf -d %s/lib/libroberts.so | grep -q 'SONAME.*libroberts.so.[0-9]'",
             root, root, root, root, root, root);
    run(command);
}

static void brings_manual_and_completions(void **state)
{
    char command[4096];
    (void)state;
    snprintf(command, sizeof command,
             "cd %s/share && test -s man/man1/roberts.1 && test -s bash-completion/completions/roberts && "
             "test -s zsh/site-functions/_roberts && test -s fish/vendor_completions.d/roberts.fish",
             root);
    run(command);
}

/* An installation by root renews the loader's cache. One by others, into DESTDIR, or to where the loader never looks
 * does not. */
static void tells_the_loader(void **state)
{
    static const struct {
        const char *user, *destdir, *prefix, *looked_into, *wanted;
    } table[] = {{"0", "", "$PWD/$d/usr", "$PWD/$d/usr/lib", "told"},
                 {"0", "", "$d/usr", "$PWD/$d/usr/lib", "told"}, /* a relative PREFIX counts from the top folder */
                 {"1000", "", "$PWD/$d/usr", "$PWD/$d/usr/lib", ""},
                 {"0", "$PWD/$d", "/usr", "/usr/lib", ""},
                 {"0", "", "$PWD/$d/usr", "$PWD/$d/usr", ""}};
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        char command[4096];
        snprintf(
            command, sizeof command,
            "d=%s/loader; mkdir -p $d/bin; rm -f $d/told; echo \"#!/bin/sh\" >$d/bin/id; cp $d/bin/id $d/bin/ldconfig; "
            "echo echo %s >>$d/bin/id; chmod +x $d/bin/*; "
            "echo \"[ \\$# = 0 ] && echo told >$d/told || echo '%s: '\" >>$d/bin/ldconfig; "
            "PATH=\"$PWD/$d/bin:$PATH\" make --no-print-directory install BUILD=%s DESTDIR=\"%s\" PREFIX=\"%s\" && "
            "test \"$(cat $d/told 2>/dev/null)\" = '%s'",
            root, table[i].user, table[i].looked_into, setting("ROBERTS_BUILD", "build"), table[i].destdir,
            table[i].prefix, table[i].wanted);
        run(command);
    }
}

/* A folder with a blank in its name, and one that is not writable: a message says what to do. */
static void other_folders(void **state)
{
    const char *build = setting("ROBERTS_BUILD", "build");
    char command[4096];
    (void)state;
    snprintf(command, sizeof command,
             "make --no-print-directory install BUILD=%s PREFIX='%s/a b' && '%s/a b/bin/roberts' --version && "
             "grep -q \"^prefix=$PWD/%s/a b$\" '%s/a b/lib/pkgconfig/roberts.pc' && "
             "make --no-print-directory uninstall BUILD=%s PREFIX='%s/a b' && test -z \"$(find '%s/a b' -type f)\"",
             build, root, root, root, root, build, root, root);
    run(command);
    static const char *const refused[] = {"/dev/null", "/proc"}; /* also to root */
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
        snprintf(command, sizeof command,
                 "how='as root: sudo make install'; test \"$(id -u)\" != 0 || how='choose another PREFIX'; "
                 "! make --no-print-directory install BUILD=%s PREFIX=%s/usr 2>%s.said && "
                 "grep -q \"cannot write to %s; $how; or for yourself alone:\" %s.said && "
                 "grep -q '  make install PREFIX=.*/.local' %s.said",
                 build, refused[i], root, refused[i], root, root);
        run(command);
    }
}

/* A build folder of another user, in which nothing has been built: a message says what to do, whether or not the user
 * may write to PREFIX. */
static void other_users(void **state)
{
    static const struct {
        const char *prefix, *said;
    } table[] = {{"/proc/usr", "cannot write to /proc; as root: sudo make install; or for yourself alone:"},
                 {"$PWD/$t/usr", "cannot write to $t/build, where it builds; choose a folder of your own:"}};
    const char *user = geteuid() ? "" : "setpriv --reuid=65534 --regid=65534 --clear-groups";
    char command[4096];
    (void)state;
    snprintf(command, sizeof command, "%s make -n help >/dev/null 2>&1", user);
    if (system(command) != 0) /* NOLINT(cert-env33-c) */
        SKIP_BECAUSE("another user cannot read this folder, or there is no setpriv");
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        snprintf(command, sizeof command,
                 "t=%s/theirs; mkdir -p $t/build $t/usr && chmod 777 $t/usr && chmod 555 $t/build && "
                 "! %s make --no-print-directory install BUILD=$t/build PREFIX=%s 2>%s.said && "
                 "grep -q \"%s\" %s.said && ! ls $t/usr/bin/roberts",
                 root, user, table[i].prefix, root, table[i].said, root);
        run(command);
    }
}

static void uninstalls(void **state)
{
    char command[4096];
    (void)state;
    snprintf(command, sizeof command,
             "make --no-print-directory uninstall BUILD=%s PREFIX=\"$PWD/%s\" && "
             "test -z \"$(find %s -type f -name '*roberts*' ! -name client)\"",
             setting("ROBERTS_BUILD", "build"), root, root);
    run(command);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(c_client_draws),
        cmocka_unit_test(c_client_takes_segments),
        cmocka_unit_test(cxx_client),
        cmocka_unit_test(exports_only_its_own),
        cmocka_unit_test(brings_manual_and_completions),
        cmocka_unit_test(uninstalls),
        cmocka_unit_test(tells_the_loader),
        cmocka_unit_test(other_folders),
        cmocka_unit_test(other_users),
    };
    return cmocka_run_group_tests_name("install", tests, set_up, NULL);
}
