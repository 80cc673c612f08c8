/* test_fault_files.c - files that are not regular, or change or vanish while the program works; few open files, little
 * stack, little memory. tests/README.md lists all faults. */
#include <stdio.h>

#include "program.h"
#include "sanitized.h"
#include "testing.h"

static const char cube_name[] = "models/platonic/cube.off";
static char cube[TEXT], table[TEXT]; /* the cube, and its drawing as CSV */

static void know_cube(void)
{
    read_text(cube_name, cube);
    assert_int_equal(run("-f csv models/platonic/cube.off"), 0);
    strcpy(table, last.out);
    assert_true(strlen(table) > 500);
}

static void write_all(int descriptor, const char *text)
{
    assert_int_equal(write(descriptor, text, strlen(text)), strlen(text));
}

/* Runs the program from a shell script that begins with `before` and ends the program's command with `after`. */
static int run_from(const char *before, const char *line, const char *after)
{
    static char script[8192], kept[sizeof program];
    snprintf(script, sizeof script, "#!/bin/sh\n%s\nexec '%s' \"$@\" %s\n", before, program, after);
    put("script", script);
    assert_int_equal(chmod("script", 0700), 0);
    strcpy(kept, program);
    strcpy(program, "./script");
    run(line);
    strcpy(program, kept);
    return last.status;
}

/* No unfinished file is left in in/, where only `count` files are. */
static void assert_entries(int count)
{
    DIR *directory = opendir("in");
    struct dirent *entry;
    assert_non_null(directory);
    while ((entry = readdir(directory)))
        if (strncmp(entry->d_name, ".roberts", 8) == 0)
            fail_msg("left: %s", entry->d_name);
    closedir(directory);
    assert_int_equal(entries("in", false), count);
}

static void input_is_a_fifo(void **state)
{
    (void)state;
    know_cube();
    assert_int_equal(mkfifo("in/pipe", 0600), 0);
    pid_t child = start("-f csv in/pipe", NULL, -1);
    int end = open("in/pipe", O_WRONLY);
    write_all(end, cube);
    close(end); /* it waits for that: another model might follow */
    finish(child);
    assert_int_equal(last.status, 0);
    assert_string_equal(last.out, table);
    child = start("-f csv in/pipe", NULL, -1);
    close(open("in/pipe", O_WRONLY));
    finish(child);
    assert_int_equal(last.status, 1);
    assert_said("in/pipe:1: the input is empty");
}

static void output_is_a_fifo(void **state)
{
    static char got[TEXT];
    struct stat found;
    (void)state;
    know_cube();
    assert_int_equal(mkfifo("in/pipe", 0600), 0);
    pid_t child = start("-f csv models/platonic/cube.off -o in/pipe", NULL, -1);
    int end = open("in/pipe", O_RDONLY);
    size_t size = 0;
    for (ssize_t more; (more = read(end, got + size, sizeof got - 1 - size)) > 0;)
        size += (size_t)more;
    close(end);
    finish(child);
    assert_int_equal(last.status, 0);
    assert_string_equal(got, table);
    assert_int_equal(lstat("in/pipe", &found), 0);
    assert_true(S_ISFIFO(found.st_mode));
    assert_entries(1);
    for (int ignored = 0; ignored < 2; ignored++) { /* whoever reads it leaves */
        start_pipe_signal = ignored ? SIG_IGN : SIG_DFL;
        child = start("-f csv --hidden solid models/lattice.off -o in/pipe", NULL, -1);
        start_pipe_signal = SIG_DFL;
        close(open("in/pipe", O_RDONLY));
        finish(child);
        assert_int_equal(last.status, ignored ? 1 : 1000 + SIGPIPE);
        if (ignored)
            assert_said("in/pipe: cannot write: Broken pipe");
    }
}

static void input_grows(void **state)
{
    int half = open("in/half.off", O_WRONLY | O_CREAT, 0600);
    (void)state;
    know_cube();
    assert_int_equal(write(half, cube, strlen(cube) / 2), strlen(cube) / 2);
    assert_int_equal(run("-f csv in/half.off"), 1);
    assert_said("but the input ends here");
    write_all(half, cube + strlen(cube) / 2);
    assert_int_equal(run("-f csv in/half.off"), 0);
    assert_string_equal(last.out, table);
    for (int i = 0; i < 1000; i++) /* behind the last face */
        write_all(half, "# and more\n");
    close(half);
    assert_int_equal(run("-f csv in/half.off"), 0);
    assert_string_equal(last.out, table);
}

static void folder_vanishes(void **state)
{
    (void)state;
    know_cube();
    assert_int_equal(mkdir("in/gone", 0700), 0);
    assert_int_equal(mkfifo("in/pipe", 0600), 0);
    pid_t child = start("in/pipe -o in/gone/a.svg", NULL, -1);
    int end = open("in/pipe", O_WRONLY); /* it has begun, then */
    assert_int_equal(rmdir("in/gone"), 0);
    write_all(end, cube);
    close(end);
    finish(child);
    assert_int_equal(last.status, 1);
    assert_said("in/gone/a.svg: cannot write: No such file or directory");
    assert_entries(1);
}

/* Inputs that a batch would replace, by whatever path they are named. */
static void batch_spares_inputs(void **state)
{
    static const char *const line[] = {"--batch in in/cube.svg", "--batch in/../in -f svg in/cube.svg",
                                       "--batch in models/platonic/cube.off in/cube.svg",
                                       "--batch in in/other.off models/lattice.off"};
    static char now[TEXT];
    (void)state;
    know_cube();
    put("in/cube.svg", cube);
    assert_int_equal(symlink("cube.svg", "in/lattice.svg"), 0);
    assert_int_equal(link("in/cube.svg", "in/other.off"), 0);
    for (size_t i = 0; i < sizeof line / sizeof line[0]; i++) {
        assert_int_equal(run(line[i]), 2);
        assert_true(strstr(last.err, "would take its place") || strstr(last.err, "would both be drawn to"));
        read_text("in/cube.svg", now);
        assert_string_equal(now, cube);
    }
    assert_entries(3);
    assert_int_equal(run("--batch in -f null in/cube.svg"), 0); /* nothing is written */
    assert_int_equal(run("--batch in -f csv in/cube.svg"), 0);
}

static void names(void **state)
{
    char line[1200], name[400];
    (void)state;
    memset(name, 'x', sizeof name);
    name[sizeof name - 1] = '\0';
    snprintf(line, sizeof line, "in/%s.off", name);
    assert_int_equal(run(line), 1);
    assert_said("File name too long");
    snprintf(line, sizeof line, "models/platonic/cube.off -o in/%s.svg", name);
    assert_int_equal(run(line), 1);
    assert_said("File name too long");
    name[251] = '\0'; /* 255 with the ending: as long as a name can be, and the unfinished file needs one as well */
    snprintf(line, sizeof line, "models/platonic/cube.off -o in/%s.svg", name);
    assert_int_equal(run(line), 0);
    assert_entries(1);
    assert_int_equal(symlink("b", "in/a") + symlink("a", "in/b"), 0);
    assert_int_equal(run("in/a"), 1);
    assert_said("in/a: Too many levels of symbolic links");
}

static void standard_input_is_closed(void **state)
{
    static char now[TEXT];
    (void)state;
    know_cube();
    assert_int_equal(run_from("", "-f csv -", "<&-"), 1);
    assert_said("standard input: reading failed: Bad file descriptor");
    assert_int_equal(run_from("", "models/platonic/cube.off -o in/a.csv", "<&- >&- 2>&-"), 0);
    read_text("in/a.csv", now);
    assert_string_equal(now, table);
}

/* Many files with sixteen open at most: each is closed. With too few for all threads, each failure is reported. */
static void few_open_files(void **state)
{
    enum { MANY = 400 };
    char name[32];
    (void)state;
    know_cube();
    assert_int_equal(mkdir("in/of", 0700), 0);
    for (int i = 0; i < MANY; i++) {
        snprintf(name, sizeof name, "in/of/%d.off", i);
        put(name, cube);
    }
    assert_int_equal(run_from("ulimit -n 16; set -- \"$@\" in/of/*.off", "--batch in --threads 2", ""), 0);
    assert_entries(MANY + 1);
    assert_int_equal(entries("in", true), MANY + 1);
    int status = run_from("ulimit -n 5; set -- \"$@\" in/of/*.off", "--batch in --threads 8", "");
    int told = count_of(last.err, "Too many open files");
    assert_int_equal(status, told ? 1 : 0);
    assert_entries(MANY + 1 - told);
}

/* A manifest may grow to 1 or 2 kB (two blocks of the shell), which is in the middle of a row. The files are computed
 * all the same. */
static void manifest_is_full(void **state)
{
    char whole[TEXT];
    (void)state;
    assert_int_equal(run_from("ulimit -f 2; set -- \"$@\" models/platonic/*.off models/catalan/*.off",
                              "--batch in --manifest in/rows -f null", ""),
                     1);
    assert_string_equal(last.err, "roberts: in/rows: cannot write: File too large\n");
    read_text("in/rows", whole);
    assert_true(strlen(whole) == 1024 || strlen(whole) == 2048);
    assert_int_equal(run("--batch in --manifest in/rows -f null models/table.off"), 0);
    read_text("in/rows", whole);
    assert_int_equal(count_of(whole, "{\"file\":"), count_of(whole, "}\n"));
}

static void little_stack(void **state)
{
    (void)state;
    if (SANITIZED)
        SKIP_BECAUSE("a sanitizer needs more memory");
    assert_int_equal(run("models/lattice.off --hidden dashed -o in/a.svg"), 0);
    assert_int_equal(run_from("ulimit -s 128", "models/lattice.off --hidden dashed --verify -o in/b.svg", ""), 0);
    assert_said("contradictions: 0");
    read_text("in/a.svg", last.out);
    read_text("in/b.svg", last.err);
    assert_string_equal(last.out, last.err);
}

/* From too little memory for the program itself to enough. */
static void little_memory(void **state)
{
    const char *line = "--threads 1 --hidden dashed --verify -q -o in/a.svg";
    int drawn = 0;
    bool refused = false;
    (void)state;
    if (SANITIZED)
        SKIP_BECAUSE("a sanitizer needs more memory");
    for (int kilobytes = 8000; kilobytes <= 64000 && drawn < 3; kilobytes += 500) {
        char before[200];
        snprintf(before, sizeof before, "ulimit -v %d; m=models/icosahedra.off; set -- \"$@\" $m $m $m $m $m $m $m $m",
                 kilobytes);
        int status = run_from(before, line, "");
        if (status == 127 || status == 2) /* the system had no room for shell, program or libraries */
            continue;
        assert_true(status == 0 || status == 1);
        if (status == 1)
            assert_said("not enough memory");
        assert_entries(status == 0);
        entries("in", true);
        drawn += status == 0;
        refused = refused || status == 1;
    }
    assert_true(drawn == 3 && refused);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_FOLDER(input_is_a_fifo),
        IN_FOLDER(output_is_a_fifo),
        IN_FOLDER(input_grows),
        IN_FOLDER(folder_vanishes),
        IN_FOLDER(batch_spares_inputs),
        IN_FOLDER(names),
        IN_FOLDER(standard_input_is_closed),
        IN_FOLDER(few_open_files),
        IN_FOLDER(manifest_is_full),
        IN_FOLDER(little_stack),
        IN_FOLDER(little_memory),
    };
    if (!program_find())
        return 1;
    return cmocka_run_group_tests_name("faults of files", tests, NULL, NULL);
}
