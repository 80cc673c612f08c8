/* program.h - runs the program from outside, each test in a folder of its own: exit status, messages, files. Include it
 * in one file only.
 *
 *     Use IN_FOLDER(test) in the list of tests, and call program_find() first; then run("--view top models/table.off"),
 *     and look at `last`. */
#ifndef ROBERTS_TESTS_PROGRAM_H
#define ROBERTS_TESTS_PROGRAM_H

#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "folders.h"
#include "temporary.h"
#include "testing.h"

enum { ARGUMENTS = 32, TEXT = 65536, CLOSED = -2 };

static char top[2048], program[4096]; /* the source's top folder; the program */

/* The result of a run: exit status, or 1000 + signal; the beginnings of its two streams. */
typedef struct result {
    int status;
    char out[TEXT], err[TEXT];
} result;

static result last;

static inline void read_text(const char *path, char text[TEXT])
{
    int descriptor = open(path, O_RDONLY);
    ssize_t size = descriptor < 0 ? 0 : read(descriptor, text, TEXT - 1);
    text[size > 0 ? size : 0] = '\0';
    if (descriptor >= 0)
        close(descriptor);
}

static inline int open_stream(const char *path, int flags)
{
    return open(path, flags | O_CREAT, 0600);
}

static inline void put(const char *path, const char *text)
{
    int descriptor = open_stream(path, O_WRONLY | O_TRUNC);
    assert_int_equal(write(descriptor, text, strlen(text)), strlen(text));
    close(descriptor);
}

static int start_error = -1; /* standard error of the next program started; -1: the file "err", or CLOSED */
static void (*start_pipe_signal)(int) = SIG_DFL; /* its handling of SIGPIPE */

/* Starts the program with the words of `line` as its arguments. `out`: its standard output, -1: the file "out". */
static inline pid_t start(const char *line, const char *in, int out)
{
    static char words[4096];
    char *argv[ARGUMENTS + 1] = {program};
    int count = 1;
    snprintf(words, sizeof words, "%s", line);
    for (char *word = strtok(words, " "); word && count < ARGUMENTS; word = strtok(NULL, " "))
        argv[count++] = word;
    fflush(stdout);
    pid_t child = fork();
    if (child != 0)
        return child;
    signal(SIGINT, SIG_DFL); /* commands in the background, or under nohup, are started with it ignored */
    signal(SIGHUP, SIG_DFL);
    signal(SIGTERM, SIG_DFL);
    signal(SIGPIPE, start_pipe_signal);
    dup2(open_stream(in ? in : "/dev/null", O_RDONLY), STDIN_FILENO);
    if (start_error != CLOSED)
        dup2(start_error >= 0 ? start_error : open_stream("err", O_WRONLY | O_TRUNC), STDERR_FILENO);
    if (out == CLOSED)
        close(STDOUT_FILENO);
    else
        dup2(out >= 0 ? out : open_stream("out", O_WRONLY | O_TRUNC), STDOUT_FILENO);
    for (int i = start_error == CLOSED ? STDERR_FILENO : 3; i < 64; i++)
        close(i);
    execv(program, argv);
    _exit(127);
}

static inline void finish(pid_t child)
{
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    last.status = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
    read_text("out", last.out);
    read_text("err", last.err);
}

static inline int run(const char *line)
{
    finish(start(line, NULL, -1));
    return last.status;
}

static inline int run_into(const char *line, const char *device)
{
    int out = open(device, O_WRONLY);
    assert_true(out >= 0);
    finish(start(line, NULL, out));
    close(out);
    return last.status;
}

static inline void assert_said(const char *text)
{
    if (strstr(last.err, text) == NULL)
        fail_msg("said: %s\nnot: %s", last.err, text);
}

/* Counts the occurrences of a string in a text. */
static inline int count_of(const char *text, const char *what)
{
    int count = 0;
    for (; (text = strstr(text, what)); text++)
        count++;
    return count;
}

/* Gives each test a folder of its own, with a link to models/. */
static inline int enter_folder(void **state)
{
    char models[4096];
    snprintf(models, sizeof models, "%s/models", top);
    if (temporary_make(state) != 0 || chdir(temporary) != 0 || mkdir("in", 0777) != 0)
        return -1;
    return symlink(models, "models");
}

static inline int leave_folder(void **state)
{
    return chdir(top) == 0 ? temporary_remove(state) : -1;
}

/* Finds a program by its name in the folder of the build, which is relative to the top folder. */
static inline bool program_find_as(const char *name)
{
    const char *build = build_folder();
    if (!getcwd(top, sizeof top))
        return false;
    snprintf(program, sizeof program, "%s%s%s/%s", build[0] == '/' ? "" : top, build[0] == '/' ? "" : "/", build, name);
    return true;
}

static inline bool program_find(void)
{
    return program_find_as("roberts");
}

#define IN_FOLDER(test) cmocka_unit_test_setup_teardown(test, enter_folder, leave_folder)

#endif
