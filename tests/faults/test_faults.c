/* test_faults.c - malicious input, and its cost. Each run has a limit on processor time and, unless a sanitizer needs
 * more, on memory, which must not grow with declared counts. Other faults are tested where they occur: test_cli.c,
 * test_save.c, test_memory_*.c; tests/README.md lists all. */
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "folders.h"
#include "sanitized.h"
#include "testing.h"

/* Seconds of processor time; with the sanitizers things take some ten times as long. */
enum { SECONDS = SANITIZED ? 60 : 8, MEGABYTE = 1 << 20 };

static char program[4096];

typedef void feed_fn(int pipe);

/* Until the program stops reading. */
static bool feed(int pipe, const char *text, size_t size)
{
    while (size > 0) {
        ssize_t done = write(pipe, text, size);
        if (done <= 0)
            return false;
        text += done;
        size -= (size_t)done;
    }
    return true;
}

static void feed_text(int pipe, const char *text)
{
    feed(pipe, text, strlen(text));
}

/* `text` repeated, `total` bytes in all. */
static void feed_often(int pipe, const char *text, uint64_t total)
{
    static char block[60000];
    size_t length = strlen(text), size = sizeof block - sizeof block % length;
    for (size_t i = 0; i < size; i++)
        block[i] = text[i % length];
    for (uint64_t done = 0; done < total && feed(pipe, block, size); done += size)
        ;
}

#define TWO_GIGABYTES ((uint64_t)2 << 30)

static void feed_digits(int pipe)
{
    feed_text(pipe, "OFF\n8 6 0\n");
    feed_often(pipe, "1234567890", TWO_GIGABYTES);
}

static void feed_digits_as_counts(int pipe)
{
    feed_text(pipe, "OFF\n");
    feed_often(pipe, "7", TWO_GIGABYTES);
}

static void feed_digits_in_color(int pipe)
{
    feed_text(pipe, "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 ");
    feed_often(pipe, "1 ", TWO_GIGABYTES);
}

static void feed_blanks(int pipe)
{
    feed_text(pipe, "OFF\n3 1 0\n");
    feed_often(pipe, " ", TWO_GIGABYTES);
}

static void feed_comment(int pipe)
{
    feed_text(pipe, "OFF # ");
    feed_often(pipe, "x", TWO_GIGABYTES);
}

#define CUBE(zero, one)                                                                                                \
    "OFF\n8 6 0\n" zero " " zero " " zero "\n" one " " zero " " zero "\n" zero " " one " " zero "\n" one " " one       \
    " " zero "\n" zero " " zero " " one "\n" one " " zero " " one "\n" zero " " one " " one "\n" one " " one " " one   \
    "\n4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n"

/* Until nobody reads on. */
static void feed_for_ever(int pipe)
{
    feed_text(pipe, CUBE("0", "1"));
    feed_often(pipe, "and so on\n", UINT64_MAX);
}

static void feed_counts(int pipe)
{
    feed_text(pipe, "OFF\n4000000000 4000000000 4000000000\n0 0 0\n1 0 0\n");
}

static void feed_face_count(int pipe)
{
    feed_text(pipe, "OFF\n3 4000000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
}

static void feed_corner_count(int pipe)
{
    feed_text(pipe, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n");
}

static void feed_binary_counts(int pipe)
{
    static const char head[] = "OFF BINARY\n\xee\x6b\x28\xee\xee\x6b\x28\xee\0\0\0\0\0\0\0\0";
    feed(pipe, head, sizeof head - 1);
}

static void feed_binary_corners(int pipe)
{
    static const char head[] = "OFF BINARY\n\0\0\0\1\0\0\0\1\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x6e\x6b\x28\x6e\0\0\0\0";
    feed(pipe, head, sizeof head - 1);
}

/* A face of a million corners, all of them different, and nothing else. */
static void feed_large_face(int pipe)
{
    static char line[64];
    enum { CORNERS = 1000000 };
    FILE *file = fdopen(dup(pipe), "w");
    fprintf(file, "OFF\n%d 1 0\n", CORNERS);
    for (int i = 0; i < CORNERS; i++)
        fprintf(file, "%d %d 0\n", i, i % 2);
    fprintf(file, "%d", CORNERS);
    for (int i = 0; i < CORNERS; i++) {
        snprintf(line, sizeof line, " %d", i);
        fputs(line, file);
    }
    fputc('\n', file);
    fclose(file);
}

/* A pyramid whose base has 400,000 corners on a square; with a cube beside its tip, or without. */
static void feed_pyramid(int pipe, int cubes)
{
    enum { QUARTER = 100000, CORNERS = 4 * QUARTER };
    FILE *file = fdopen(dup(pipe), "w");
    fprintf(file, "OFF\n%d %d 0\n0 0 500000\n", CORNERS + 1 + 8 * cubes, CORNERS + 1 + 6 * cubes);
    for (int side = 0; side < 4; side++)
        for (int i = 0; i < QUARTER; i++) {
            int a = 2 * i - QUARTER, x = side % 2 ? QUARTER : a, y = side % 2 ? a : -QUARTER;
            fprintf(file, "%d %d 0\n", side < 2 ? x : -x, side < 2 ? y : -y);
        }
    for (int i = 0; i < 8 * cubes; i++)
        fprintf(file, "%d %d %d\n", i & 1 ? 100000 : 200000, i & 2 ? 100000 : 200000, i & 4 ? 400000 : 500000);
    fprintf(file, "%d", CORNERS);
    for (int i = CORNERS; i > 0; i--)
        fprintf(file, " %d", i);
    for (int i = 1; i <= CORNERS; i++)
        fprintf(file, "\n3 0 %d %d", i, i % CORNERS + 1);
    for (int axis = 0; axis < 3 * cubes; axis++)
        for (int side = 0; side < 2; side++) {
            int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, first = CORNERS + 1 + (side << axis);
            fprintf(file, "\n4 %d %d %d %d", first, first + u, first + u + v, first + v);
        }
    fputc('\n', file);
    fclose(file);
}

static void feed_large_pyramid(int pipe)
{
    feed_pyramid(pipe, 0);
}

static void feed_pyramid_and_cube(int pipe)
{
    feed_pyramid(pipe, 1);
}

/* The same face again and again. */
static void feed_one_corner(int pipe)
{
    feed_text(pipe, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n1020000");
    feed_often(pipe, " 0 1 2", 2000000); /* in blocks of 30000 corners */
    feed_text(pipe, "\n");
}

#define FEED(name, text)                                                                                               \
    static void name(int pipe)                                                                                         \
    {                                                                                                                  \
        feed_text(pipe, text);                                                                                         \
    }
FEED(feed_nan, CUBE("0", "nan"))
FEED(feed_infinity, CUBE("0", "inf"))
FEED(feed_overflow, CUBE("0", "1e999"))
FEED(feed_1e308, CUBE("0", "1e308"))
FEED(feed_1e150, CUBE("-1e150", "1e150"))
FEED(feed_denormals, CUBE("0", "5e-324"))
FEED(feed_small, CUBE("0", "1e-300"))
FEED(feed_underflow, CUBE("0", "1e-999"))
FEED(feed_nothing, "")

static const struct {
    const char *name;
    feed_fn *feed;
    const char *file; /* NULL: the output of `feed`, on standard input */
    size_t megabytes; /* of address space; an empty run of the program takes some 40 */
    int status;
    const char *said; /* NULL: only the report of --verify */
} cases[] = {
    {"nothing", feed_nothing, NULL, 128, 1, "standard input:1: "},
    {"a folder", NULL, "models", 128, 1, "is a folder"},
    {"/dev/zero", NULL, "/dev/zero", 128, 1, "/dev/zero:1: "},
    {"2 GB of digits for a number", feed_digits, NULL, 128, 1, "standard input:3: "},
    {"2 GB of digits for a count", feed_digits_as_counts, NULL, 128, 1, "standard input:2: "},
    {"2 GB of numbers behind a face", feed_digits_in_color, NULL, 128, 1, "standard input:6: "},
    {"2 GB of blanks", feed_blanks, NULL, 128, 1, "standard input:3: "},
    {"a comment of 2 GB", feed_comment, NULL, 128, 1, "standard input:1: "},
    {"a cube, and text for ever", feed_for_ever, NULL, 128, 0, NULL},
    {"counts of 4e9", feed_counts, NULL, 128, 1, "standard input:"},
    {"4e9 faces, one given", feed_face_count, NULL, 128, 1, "is not closed"},
    {"a face of 4e9 corners", feed_corner_count, NULL, 128, 1, "standard input:"},
    {"counts of 4e9, binary", feed_binary_counts, NULL, 128, 1, "standard input:"},
    {"a face of 2e9 corners, binary", feed_binary_corners, NULL, 128, 1, "standard input:"},
    {"a face of a million corners", feed_large_face, NULL, 512, 1, "is not closed"},
    {"a face of a million corners, three of them different", feed_one_corner, NULL, 256, 1, "solid 0"},
    {"a pyramid on 400,000 corners", feed_large_pyramid, NULL, 800, 0, NULL},
    {"the same and a cube", feed_pyramid_and_cube, NULL, 800, 0, NULL},
    {"NaN", feed_nan, NULL, 128, 1, "standard input:"},
    {"infinity", feed_infinity, NULL, 128, 1, "standard input:"},
    {"1e999", feed_overflow, NULL, 128, 1, "standard input:"},
    {"1e308", feed_1e308, NULL, 128, 1, "standard input:"},
    {"1e150", feed_1e150, NULL, 128, 0, NULL},
    {"1e-300", feed_small, NULL, 128, 0, NULL},
    {"denormals", feed_denormals, NULL, 128, 0, NULL},
    {"1e-999", feed_underflow, NULL, 128, 1, "solid 0"},
};

static void limit(int which, rlim_t most)
{
    struct rlimit now;
    if (getrlimit(which, &now) == 0 && (now.rlim_max == RLIM_INFINITY || most < now.rlim_max)) {
        now.rlim_cur = most;
        setrlimit(which, &now);
    }
}

/* Its exit status, or 1000 + signal; its messages. */
static int run(size_t i, char *said, size_t room)
{
    int in[2], out[2], status;
    assert_int_equal(pipe(in), 0);
    assert_int_equal(pipe(out), 0);
    fflush(stdout);
    pid_t child = fork();
    if (child == 0) {
        dup2(in[0], STDIN_FILENO);
        dup2(out[1], STDERR_FILENO);
        close(in[0]), close(in[1]), close(out[0]), close(out[1]);
        limit(RLIMIT_CPU, SECONDS);
        if (!SANITIZED)
            limit(RLIMIT_AS, (rlim_t)cases[i].megabytes * MEGABYTE);
        execl(program, program, "-q", "-f", "null", "--solids", "--verify=1", "--threads", "1",
              cases[i].file ? cases[i].file : "-", (char *)NULL);
        _exit(127);
    }
    close(in[0]), close(out[1]);
    pid_t feeder = fork();
    if (feeder == 0) {
        signal(SIGPIPE, SIG_IGN);
        close(out[0]);
        if (cases[i].feed)
            cases[i].feed(in[1]);
        _exit(0);
    }
    close(in[1]);
    size_t size = 0;
    for (ssize_t got; size + 1 < room && (got = read(out[0], said + size, room - 1 - size)) > 0;)
        size += (size_t)got;
    said[size] = '\0';
    close(out[0]);
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_int_equal(waitpid(feeder, NULL, 0), feeder);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
}

/* Is it the report of --verify alone, without a contradiction? */
static bool is_report(const char *said)
{
    const char *end = strchr(said, '\n');
    return strncmp(said, "roberts: verify: ", 17) == 0 && strstr(said, "; contradictions: 0, ") && end && !end[1];
}

static void input(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char said[4096];
        int status = run(i, said, sizeof said);
        print_message("%s: %d %s%s", cases[i].name, status, said, *said ? "" : "\n");
        assert_int_equal(status, cases[i].status);
        if (cases[i].said ? !strstr(said, cases[i].said) : !is_report(said))
            fail_msg("said: %s", said);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(input)};
    snprintf(program, sizeof program, "%s/roberts", build_folder());
    return cmocka_run_group_tests_name("faults", tests, NULL, NULL);
}
