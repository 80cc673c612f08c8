/* temporary.h - a temporary folder for a test's files: in TMPDIR or, if that is not a folder, in /tmp. Setup and
 * teardown of a test or of a group are temporary_make() and temporary_remove(). The folder and its contents are also
 * removed if the program ends without teardown, by exit() or by a signal. Include it in one file only. */
#ifndef ROBERTS_TESTS_TEMPORARY_H
#define ROBERTS_TESTS_TEMPORARY_H

#include <dirent.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "testing.h"

enum { TEMPORARY_ROOM = 256 /* bytes of its name */ };

static char temporary[TEMPORARY_ROOM]; /* absolute path; empty: there is none */
static pid_t temporary_owner;          /* the process that owns it: processes forked from it leave it alone */

/* Removes the folder by another process: a signal handler may start one, but not read folders. The process inherits the
 * signal mask, so whatever ends the test and its children does not end the removal. */
static bool temporary_delete(void)
{
    sigset_t all, before;
    int status;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, &before);
    pid_t child = fork();
    if (child == 0) {
        execl("/bin/sh", "sh", "-c", "exec rm -rf -- \"$0\"", temporary, (char *)NULL);
        _exit(127);
    }
    bool done = child > 0 && waitpid(child, &status, 0) == child && status == 0;
    sigprocmask(SIG_SETMASK, &before, NULL);
    return done;
}

static void temporary_at_exit(void)
{
    if (*temporary && getpid() == temporary_owner)
        (void)temporary_delete();
}

static void temporary_at_signal(int number)
{
    temporary_at_exit();
    (void)signal(number, SIG_DFL);
    (void)raise(number); /* takes effect as soon as this returns */
}

/* Installs the handlers once in a program; ignored signals stay ignored. After a sanitizer's abort or SIGKILL, run.sh
 * removes the folder. */
static void temporary_watch(void)
{
    static const int ending[] = {SIGABRT, SIGHUP, SIGINT, SIGPIPE, SIGQUIT, SIGTERM};
    if (temporary_owner)
        return;
    temporary_owner = getpid();
    (void)atexit(temporary_at_exit);
    for (size_t i = 0; i < sizeof ending / sizeof ending[0]; i++)
        if (signal(ending[i], temporary_at_signal) == SIG_IGN)
            (void)signal(ending[i], SIG_IGN);
}

static inline int temporary_remove(void **state)
{
    (void)state;
    if (!*temporary || !temporary_delete())
        return -1;
    *temporary = '\0';
    return 0;
}

/* Only an absolute TMPDIR is valid wherever the test changes to. */
static inline int temporary_make(void **state)
{
    const char *place = getenv("TMPDIR");
    char path[TEMPORARY_ROOM];
    int length = snprintf(path, sizeof path, "%s/roberts-XXXXXX", place && *place == '/' ? place : "/tmp");
    if (*temporary) /* left by a setup that failed later: cmocka continues without teardown */
        (void)temporary_remove(state);
    temporary_watch();
    if (length >= TEMPORARY_ROOM || !mkdtemp(path))
        return -1;
    strcpy(temporary, path);
    return 0;
}

static inline void write_text(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    assert_true(fputs(text, file) >= 0 && fclose(file) == 0);
}

/* Counts the entries of a folder without . and ..; with `clear`, removes those that are not folders. */
static inline int entries(const char *path, bool clear)
{
    int count = 0;
    DIR *directory = opendir(path);
    struct dirent *entry;
    char name[600];
    assert_non_null(directory);
    while ((entry = readdir(directory))) {
        if (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0)
            continue;
        count++;
        snprintf(name, sizeof name, "%s/%s", path, entry->d_name);
        if (clear)
            unlink(name);
    }
    closedir(directory);
    return count;
}

#endif
