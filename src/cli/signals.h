/* signals.h - what the program does on signals: it removes unfinished files when it is interrupted, ends its workers,
 * and once a second it says on a terminal what is being done. */
#ifndef ROBERTS_CLI_SIGNALS_H
#define ROBERTS_CLI_SIGNALS_H

#include <stddef.h>
#include <sys/types.h>

/* ---- interruption ---- */

/* From now on SIGINT, SIGTERM, SIGHUP and SIGPIPE (the reader of the output is gone) end the workers, remove unfinished
 * files and then end the program as usual. A signal that was ignored stays ignored; a closed pipe is then an error of
 * write(), as the limit on file sizes always is. */
void signals_prepare(void);

/* A roberts_temporary_fn. A process has one unfinished file at a time. */
void signals_temporary(void *context, const char *path);

/* ---- workers: processes that are forked to draw, each with a number from 0 ---- */

enum { SIGNALS_WORKERS = 64 };

/* As fork(), with a number that no living worker has. A worker is ended by SIGTERM when this process ends, however that
 * happens (on Linux; elsewhere it has to look for that itself), and removes its unfinished file. */
pid_t signals_fork(int number);

/* Ends a worker. signals_reap() has to follow. */
void signals_kill(int number);

/* Waits until a worker has ended, and removes the file that it has left unfinished. Returns its status as waitpid()
 * does. */
int signals_reap(int number);

/* ---- progress ---- */

/* From now on, a line once a second. Where this is never called there is no line, and the other functions do
 * nothing. */
void progress_begin(void);

/* What is being done: a constant, such as "reading". */
void progress_stage(const char *name);

/* `done` of `total` files or pictures. From any thread, but one at a time. */
void progress_count(size_t done, size_t total);

/* Takes the line away, and keeps it away until progress_show(): around messages. */
void progress_hide(void);
void progress_show(void);

#endif
