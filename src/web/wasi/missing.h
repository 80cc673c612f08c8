/* missing.h - what a POSIX system has and WASI has not; included before every file. There is one user, and nobody else
 * writes the files of a run. */
#ifndef ROBERTS_WEB_WASI_MISSING_H
#define ROBERTS_WEB_WASI_MISSING_H

#include <sys/types.h>

int flock(int descriptor, int operation);
int fchown(int descriptor, uid_t owner, gid_t group);
int fchmod(int descriptor, mode_t mode);
uid_t geteuid(void);
int dup(int descriptor);
int mkstemp(char *template);

/* Limits are not known. */
typedef unsigned long long rlim_t;
struct rlimit {
    rlim_t rlim_cur, rlim_max;
};
int getrlimit(int resource, struct rlimit *limit);
int setrlimit(int resource, const struct rlimit *limit);
#define RLIMIT_NOFILE 0

#define F_DUPFD_CLOEXEC (-1) /* no such command: fcntl() fails */

#endif
