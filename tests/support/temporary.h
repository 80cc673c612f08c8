/* temporary.h - a folder of its own for a test's files: in TMPDIR or, where that names no place, in /tmp. Setup and
 * teardown of a test or of a group are temporary_make() and temporary_remove(). It goes with all that is in it, and
 * also where the program ends without teardown, by exit() or by a signal. Include it in one file only. */
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

enum { TEMPORARY_ROOM = 256 /* bytes of its name */ };

static char temporary[TEMPORARY_ROOM]; /* from the root; empty while there is none */
static pid_t temporary_owner;          /* the process whose it is: those that are forked from it leave it alone */

/* By another process: a signal handler, too, may start one, but not look through folders. That process takes over the
 * mask: what ends the test, and all that it has started, does not end the removing. */
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
    (void)raise(number); /* as soon as this returns */
}

/* Once in a program; signals that are ignored stay so. What a sanitizer ends, or SIGKILL, run.sh clears away. */
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

/* Only a TMPDIR that begins at the root is one wherever the test goes to. */
static inline int temporary_make(void **state)
{
    const char *place = getenv("TMPDIR");
    char path[TEMPORARY_ROOM];
    int length = snprintf(path, sizeof path, "%s/roberts-XXXXXX", place && *place == '/' ? place : "/tmp");
    if (*temporary) /* left by a setup that failed later on: cmocka goes on without teardown */
        (void)temporary_remove(state);
    temporary_watch();
    if (length >= TEMPORARY_ROOM || !mkdtemp(path))
        return -1;
    strcpy(temporary, path);
    return 0;
}

/* How many there are in a folder, . and .. not counted; with `clear`, what is no folder is removed. */
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
