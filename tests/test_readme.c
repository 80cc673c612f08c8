/* test_readme.c - what the README shows works as it stands there.
 *
 * In a new folder with links to build, include and models, each command of a ```sh block is run as printed, and the ```c
 * block is compiled, as example.c, by the README's own command, where `cc` is the compiler that built the library (CC).
 * `make` itself is left out: it is what runs this. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

static char folder[] = "/tmp/roberts-readme-XXXXXX"; /* where the commands run; made by set_up() */

/* Runs a shell command and gives its exit status. */
static int shell(const char *command)
{
    return system(command); /* NOLINT(cert-env33-c): the README's commands are shell commands */
}

/* Links `name` in the folder to `target`, a path from the top folder or an absolute one. */
static int link_in(const char *top, const char *target, const char *name)
{
    char from[4096], to[256];
    snprintf(from, sizeof from, "%s%s%s", target[0] == '/' ? "" : top, target[0] == '/' ? "" : "/", target);
    snprintf(to, sizeof to, "%s/%s", folder, name);
    return symlink(from, to);
}

static int set_up(void **state)
{
    (void)state;
    char top[2048];
    const char *build = getenv("ROBERTS_BUILD");
    if (!getcwd(top, sizeof top) || !mkdtemp(folder))
        return -1;
    return link_in(top, build ? build : "build", "build") || link_in(top, "include", "include") ||
           link_in(top, "models", "models");
}

static int tear_down(void **state)
{
    (void)state;
    char command[256];
    snprintf(command, sizeof command, "rm -rf %s", folder);
    return shell(command);
}

/* Size of a file in the folder, -1 where there is none. */
static long size_of(const char *name)
{
    char path[512];
    struct stat about;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return stat(path, &about) == 0 ? (long)about.st_size : -1;
}

/* Runs one command of the README in the folder: it succeeds and leaves something in `output` there. */
static void run_command(const char *command, const char *output)
{
    char script[512], line[1024];
    snprintf(script, sizeof script, "%s/command.sh", folder);
    FILE *f = fopen(script, "w");
    assert_non_null(f);
    fprintf(f, "cc() { command ${CC:-cc} \"$@\"; }\n%s\n", command);
    assert_int_equal(fclose(f), 0);
    snprintf(line, sizeof line, "cd %s && sh -e command.sh >printed 2>&1", folder);
    int status = shell(line);
    if (status != 0 || size_of(output) <= 0) {
        snprintf(line, sizeof line, "cat %s/printed >&2", folder);
        shell(line);
        fail_msg("exit status %d, %ld bytes in %s: %s", status, size_of(output), output, command);
    }
}

/* The file that a command line writes: what follows "-o " or "> ", else what is printed. */
static void output_of(const char *command, char output[64])
{
    const char *o = strstr(command, " -o "), *redirect = strstr(command, " > ");
    snprintf(output, 64, "printed");
    if (o || redirect)
        sscanf(o ? o + 4 : redirect + 3, "%63s", output);
}

/* Copies the lines of the README's ````language` blocks, one after the other, to `use`. */
static int each_line(const char *language, void use(const char *line, void *context), void *context)
{
    FILE *readme = fopen("README.md", "r");
    char line[1024];
    int count = 0, inside = 0;
    assert_non_null(readme);
    while (fgets(line, sizeof line, readme)) {
        line[strcspn(line, "\n")] = '\0';
        if (strncmp(line, "```", 3) == 0) {
            inside = !inside && strcmp(line + 3, language) == 0;
        } else if (inside) {
            use(line, context);
            count++;
        }
    }
    fclose(readme);
    return count;
}

static void try_command(const char *line, void *context)
{
    char output[64];
    if (strncmp(line, "make ", 5) == 0 || strncmp(line, "cc ", 3) == 0)
        return;
    output_of(line, output);
    run_command(line, output);
    ++*(int *)context;
}

static void test_commands(void **state)
{
    (void)state;
    int tried = 0;
    each_line("sh", try_command, &tried);
    assert_true(tried > 0);
}

static void write_line(const char *line, void *context)
{
    fprintf(context, "%s\n", line);
}

static void try_compiling(const char *line, void *context)
{
    if (strncmp(line, "cc ", 3) != 0)
        return;
    run_command(line, "example");
    ++*(int *)context;
}

/* The example prints one line for each visible row of the table. */
static void test_example(void **state)
{
    (void)state;
#if defined(__SANITIZE_ADDRESS__)
    skip(); /* the README's command cannot link a library with sanitizers */
#endif
    char path[512];
    int compiled = 0;
    snprintf(path, sizeof path, "%s/example.c", folder);
    FILE *example = fopen(path, "w");
    assert_non_null(example);
    assert_true(each_line("c", write_line, example) > 0);
    assert_int_equal(fclose(example), 0);
    each_line("sh", try_compiling, &compiled);
    assert_int_equal(compiled, 1);
    run_command("./example models/table.off > segments", "segments");
    run_command("build/roberts -f csv models/table.off > rows.csv", "rows.csv");
    run_command("test $(wc -l < segments) -eq $(grep -c visible rows.csv) && echo same", "printed");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_commands),
        cmocka_unit_test(test_example),
    };
    return cmocka_run_group_tests_name("readme", tests, set_up, tear_down);
}
