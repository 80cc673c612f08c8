/* signals.h - signals: an interrupted program removes unfinished files and ends its workers. Once a second, a line on
 * the terminal shows the progress. */
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
 * happens (on Linux; elsewhere it must detect that itself), and removes its unfinished file. */
pid_t signals_fork(int number);

/* Ends a worker. signals_reap() must follow. */
void signals_kill(int number);

/* Waits until a worker has ended, and removes the file that it has left unfinished. Returns its status as waitpid()
 * does. */
int signals_reap(int number);

/* ---- progress ---- */

/* From now on, prints a line once a second. If this is never called there is no line, and the other functions do
 * nothing. */
void progress_begin(void);

/* The current stage: a constant, such as "reading". */
void progress_stage(const char *name);

/* `done` of `total` files or pictures. From any thread, but one at a time. */
void progress_count(size_t done, size_t total);

/* Hides the line until progress_show(): around messages. */
void progress_hide(void);
void progress_show(void);

#endif
