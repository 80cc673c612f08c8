/* whole_file.c - files that appear whole or not at all.
 *
 * The bytes go into a new file beside the old one, which is then renamed over it: at every moment the name leads to
 * the old file or to the whole new one. Links are followed first, so that a link stays a link. A device or a pipe
 * cannot be replaced and is written in place. So are the names of open descriptors (/dev/stdout, /dev/fd/3); otherwise
 * a shell's `>>`, or what was written before, would be lost.
 *
 * The new file is locked while it is written. Its name depends only on the target's name. So a later run removes the
 * file that a killed run has left; if the file is locked, another run is still writing it, and the later run takes
 * another name.
 *
 * Nothing is forced to disk: this guards against failures and interruptions of the program, not against loss
 * of power. */
#include "write/whole_file.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

#include "base/error.h"
#include "base/output.h"

enum { LINKS_MAX = 40 /* as the kernel's own limit */, NAMES_TRIED = 100 };

char *whole_file_beside(const char *path, const char *name)
{
    const char *slash = strrchr(path, '/');
    size_t head = slash ? (size_t)(slash - path) + 1 : 0, tail = strlen(name);
    char *joined = malloc(head + tail + 1);
    if (joined) {
        memcpy(joined, path, head);
        memcpy(joined + head, name, tail + 1);
    }
    return joined;
}

/* The number in /dev/fd/N or /proc/self/fd/N, or -1. */
static int descriptor_named(const char *path)
{
    static const char *const folder[] = {"/dev/fd/", "/proc/self/fd/"};
    for (size_t i = 0; i < sizeof folder / sizeof folder[0]; i++) {
        size_t length = strlen(folder[i]);
        if (strncmp(path, folder[i], length) != 0)
            continue;
        const char *digits = path + length;
        size_t count = strspn(digits, "0123456789");
        if (count >= 1 && count <= 6 && digits[count] == '\0')
            return (int)strtol(digits, NULL, 10);
    }
    return -1;
}

/* Follows links until f->path is no link; the name of a descriptor is not followed. Returns 0 or errno. */
static int follow_links(whole_file *f)
{
    char link[PATH_MAX];
    for (int i = 0; i < LINKS_MAX; i++) {
        if (descriptor_named(f->path) >= 0)
            return 0;
        ssize_t length = readlink(f->path, link, sizeof link - 1);
        if (length < 0)
            return errno == EINVAL || errno == ENOENT ? 0 : errno; /* no link; nothing there yet */
        link[length] = '\0';
        char *next = whole_file_beside(link[0] == '/' ? "" : f->path, link);
        if (!next)
            return ENOMEM;
        free(f->path);
        f->path = next;
    }
    return ELOOP;
}

/* The name of the new file, the same for a target in every run, so that a later run finds what a killed one has left.
 * Each `attempt` has another name. It is a hash, and so always short: FNV-1a (G. Fowler, L. C. Noll, P. Vo). */
static char *temporary_name(const whole_file *f, unsigned attempt)
{
    const char *slash = strrchr(f->path, '/');
    uint64_t hash = 14695981039346656037u;
    char name[64];
    for (const char *c = slash ? slash + 1 : f->path; *c; c++)
        hash = (hash ^ (unsigned char)*c) * 1099511628211u;
    snprintf(name, sizeof name, ".roberts-%016llx-%x", (unsigned long long)hash, attempt);
    return whole_file_beside(f->path, name);
}

/* Whether an open file still has that name. */
static bool is_named(int descriptor, const char *path)
{
    struct stat own, named;
    return fstat(descriptor, &own) == 0 && lstat(path, &named) == 0 && own.st_dev == named.st_dev &&
           own.st_ino == named.st_ino;
}

/* Removes the unfinished file of a run that was killed. A file stays if it is locked, because another run is writing
 * it, if it is not ours, or if it cannot be locked. */
static void remove_left(const char *path)
{
    struct stat left;
    int descriptor = open(path, O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0)
        return;
    if (fstat(descriptor, &left) == 0 && S_ISREG(left.st_mode) && left.st_uid == geteuid() &&
        flock(descriptor, LOCK_EX | LOCK_NB) == 0 && is_named(descriptor, path))
        unlink(path);
    close(descriptor);
}

/* Locks a file that has just been created, so that no other run removes it. False: another run was faster. */
static bool lock_new(int descriptor, const char *path)
{
    return (flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) && is_named(descriptor, path);
}

static void announce(const whole_file *f, const char *path)
{
    if (f->announce)
        f->announce(f->context, path);
}

/* Creates the unfinished file and locks it. It is announced before it is created, because an interrupted program
 * removes the announced file; so a name that is already taken is not announced. */
static int open_beside(whole_file *f)
{
    mode_t mode = f->replaces ? S_IRUSR | S_IWUSR : S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH;
    struct stat other;
    int reason = EEXIST;
    for (unsigned i = 0; i < NAMES_TRIED && reason == EEXIST; i++) {
        free(f->temporary);
        f->temporary = temporary_name(f, i);
        if (!f->temporary)
            return ENOMEM;
        remove_left(f->temporary);
        if (lstat(f->temporary, &other) == 0)
            continue;
        announce(f, f->temporary);
        f->descriptor = open(f->temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        reason = f->descriptor < 0 ? errno : EEXIST;
        if (f->descriptor >= 0 && lock_new(f->descriptor, f->temporary))
            return 0;
        announce(f, NULL);
        if (f->descriptor >= 0)
            close(f->descriptor);
        f->descriptor = -1;
    }
    free(f->temporary);
    f->temporary = NULL;
    return reason;
}

/* Gives the new file the owner and mode of the old one. Only root can set the owner; where that fails, the set-user
 * and set-group bits are dropped. */
static int take_mode(const whole_file *f)
{
    mode_t mode = f->old.st_mode & (S_ISUID | S_ISGID | S_IRWXU | S_IRWXG | S_IRWXO);
    if (fchown(f->descriptor, f->old.st_uid, f->old.st_gid) != 0)
        mode &= S_IRWXU | S_IRWXG | S_IRWXO;
    return fchmod(f->descriptor, mode) == 0 ? 0 : errno;
}

static int open_target(whole_file *f)
{
    struct stat old;
    int reason = follow_links(f), named = descriptor_named(f->path);
    if (reason)
        return reason;
    if (named >= 0)
        return (f->descriptor = dup(named)) >= 0 ? 0 : errno;
    if (stat(f->path, &old) != 0) {
        if (errno != ENOENT)
            return errno;
        return f->path[0] && f->path[strlen(f->path) - 1] == '/' ? EISDIR : open_beside(f);
    }
    if (S_ISDIR(old.st_mode))
        return EISDIR;
    if (!S_ISREG(old.st_mode))
        return (f->descriptor = open(f->path, O_WRONLY | O_NOCTTY | O_CLOEXEC)) >= 0 ? 0 : errno;
    if (faccessat(AT_FDCWD, f->path, W_OK, AT_EACCESS) != 0)
        return errno; /* a file that is protected against writing is protected against replacing */
    f->old = old;
    f->replaces = true;
    return open_beside(f);
}

roberts_status whole_file_open(whole_file *f, const char *path, roberts_error *error)
{
    f->path = whole_file_beside("", path);
    f->descriptor = -1;
    int reason = f->path ? open_target(f) : ENOMEM;
    if (!reason)
        return ROBERTS_OK;
    free(f->path);
    return reason == ENOMEM ? error_no_memory(error) : output_error(error, "cannot write", reason);
}

roberts_status whole_file_close(whole_file *f, roberts_status status, roberts_error *error)
{
    int reason = 0;
    if (status == ROBERTS_OK && f->replaces)
        reason = take_mode(f);
    int lock = f->temporary ? fcntl(f->descriptor, F_DUPFD_CLOEXEC, 0) : -1; /* the lock holds until the file has its
                                                                                name */
    if (close(f->descriptor) != 0 && !reason && errno != EINTR)
        reason = errno; /* a network disk may report only now that it is full */
    if (f->temporary) {
        if (status == ROBERTS_OK && !reason && rename(f->temporary, f->path) != 0)
            reason = errno;
        if (status != ROBERTS_OK || reason)
            unlink(f->temporary);
        announce(f, NULL);
    }
    if (lock >= 0)
        close(lock);
    free(f->temporary);
    free(f->path);
    return status == ROBERTS_OK && reason ? output_error(error, "cannot write", reason) : status;
}
