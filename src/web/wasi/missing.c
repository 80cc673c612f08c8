/* missing.c - what WASI has not: functions of POSIX, processes for batches, and the formats that need Cairo. */
#include "missing.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "cli/batch.h"
#include "cli/message.h"
#include "write/formats.h"

/* ---- functions of POSIX ---- */

/* Nobody else holds a lock. */
int flock(int descriptor, int operation)
{
    (void)descriptor;
    (void)operation;
    return 0;
}

static int fail(int reason)
{
    errno = reason;
    return -1;
}

int fchown(int descriptor, uid_t owner, gid_t group)
{
    (void)descriptor;
    (void)owner;
    (void)group;
    return fail(ENOSYS);
}

/* Files have no modes. */
int fchmod(int descriptor, mode_t mode)
{
    (void)descriptor;
    (void)mode;
    return 0;
}

uid_t geteuid(void)
{
    return 0;
}

int dup(int descriptor)
{
    (void)descriptor;
    return fail(ENOSYS);
}

/* Tries one number after the other in place of the six X. */
int mkstemp(char *template)
{
    const size_t length = strlen(template);
    for (int i = 0; i < 1000000; i++) {
        snprintf(template + length - 6, 7, "%06d", i);
        int file = open(template, O_RDWR | O_CREAT | O_EXCL, 0600);
        if (file >= 0 || errno != EEXIST)
            return file;
    }
    return -1;
}

int getrlimit(int resource, struct rlimit *limit)
{
    (void)resource;
    (void)limit;
    return fail(ENOSYS);
}

int setrlimit(int resource, const struct rlimit *limit)
{
    (void)resource;
    (void)limit;
    return fail(ENOSYS);
}

/* ---- batches ---- */

int batch_make(const cli_options *options)
{
    roberts_error error = {0};
    error_set(&error, ROBERTS_BAD_ARGUMENT, 0, "--batch needs processes; the program that you install has them");
    return message_error(options->log, &error);
}

/* ---- formats ---- */

static roberts_status refuse(const strokes *s, roberts_error *error, const char *format)
{
    (void)s;
    return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "%s is not written here; the program that you install writes it",
                     format);
}

roberts_status surface_write(const strokes *s, output *out, roberts_error *error)
{
    (void)out;
    return refuse(s, error, s->options->format == ROBERTS_EPS ? "EPS" : "PostScript");
}

roberts_status image_write(const strokes *s, output *out, roberts_error *error)
{
    (void)out;
    return refuse(s, error, "PNG");
}
