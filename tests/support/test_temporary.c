/* test_temporary.c - the folders of temporary.h are removed however a test program ends. The program starts itself with
 * a kind of end as its argument, and checks the place of its folder. */
#include <sys/stat.h>

#include "temporary.h"
#include "testing.h"

static const char *self;

/* Makes folders in the test's own folder, a link out of it and a pipe, and changes to it. */
static void fill(void)
{
    assert_int_equal(chdir(temporary), 0);
    assert_int_equal(mkdir("a b", 0777), 0);
    assert_int_equal(mkdir("a b/c", 0777), 0);
    assert_int_equal(symlink("/", "a b/root"), 0);
    assert_int_equal(mkfifo("a b/c/pipe", 0600), 0);
}

static void fails(void **state)
{
    (void)state;
    fill();
    fail_msg("as it should");
}

static void passes(void **state)
{
    (void)state;
    fill();
}

/* A setup that fails has no teardown. */
static int half_made(void **state)
{
    assert_int_equal(temporary_make(state), 0);
    fill();
    return -1;
}

/* The action of a program called as "test_temporary END". */
static int end(const char *name)
{
    const struct CMUnitTest failing[] = {
        cmocka_unit_test_setup_teardown(fails, temporary_make, temporary_remove),
        cmocka_unit_test_setup_teardown(passes, half_made, temporary_remove),
        cmocka_unit_test_setup_teardown(passes, temporary_make, temporary_remove),
    };
    if (strcmp(name, "failure") == 0)
        return cmocka_run_group_tests(failing, NULL, NULL);
    if (temporary_make(NULL) != 0)
        return 100;
    fill();
    pid_t child = fork();
    if (child == 0)
        exit(0); /* leaves a folder that is not its own alone */
    waitpid(child, NULL, 0);
    if (access(temporary, F_OK) != 0)
        return 101;
    if (strcmp(name, "exit") == 0)
        exit(3);
    raise((int)strtol(name, NULL, 10));
    return 102;
}

/* Returns the status of the program that ends in this way with this TMPDIR. */
static int status_of(const char *name, const char *place)
{
    int status;
    fflush(stdout);
    pid_t child = fork();
    if (child == 0) {
        setenv("TMPDIR", place, 1);
        signal(SIGHUP, SIG_DFL); /* in case it is ignored, as it is under nohup */
        signal(SIGINT, SIG_DFL);
        signal(SIGQUIT, SIG_DFL);
        close(STDOUT_FILENO);
        close(STDERR_FILENO);
        execl(self, self, name, (char *)NULL);
        _exit(127);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
}

static void nothing_is_left(void **state)
{
    static const struct {
        const char *end;
        int status;
    } table[] = {{"failure", 2}, {"exit", 3}};
    static const int signals[] = {SIGABRT, SIGHUP, SIGINT, SIGPIPE, SIGQUIT, SIGTERM};
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        assert_int_equal(status_of(table[i].end, temporary), table[i].status);
        assert_int_equal(entries(temporary, false), 0);
    }
    for (size_t i = 0; i < sizeof signals / sizeof signals[0]; i++) {
        char number[12];
        snprintf(number, sizeof number, "%d", signals[i]);
        assert_int_equal(status_of(number, temporary), 1000 + signals[i]);
        assert_int_equal(entries(temporary, false), 0);
    }
}

/* Nothing is removed if nothing was made. */
static void places(void **state)
{
    char place[2 * TEMPORARY_ROOM];
    (void)state;
    snprintf(place, sizeof place, "%s/missing", temporary);
    assert_int_equal(status_of("exit", place), 100);
    memset(place, '/', sizeof place - 1); /* an absolute path, but too long */
    place[sizeof place - 1] = '\0';
    assert_int_equal(status_of("exit", place), 100);
    assert_int_equal(status_of("exit", "here"), 3); /* in /tmp */
    assert_int_equal(status_of("exit", ""), 3);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(nothing_is_left, temporary_make, temporary_remove),
        cmocka_unit_test_setup_teardown(places, temporary_make, temporary_remove),
    };
    self = argv[0];
    if (argc > 1)
        return end(argv[1]);
    return cmocka_run_group_tests_name("temporary", tests, NULL, NULL);
}
