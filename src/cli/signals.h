/* signals.h - what the program does on signals: it removes unfinished files when it is interrupted, and once a second
 * it says on a terminal what is being done. */
#ifndef ROBERTS_CLI_SIGNALS_H
#define ROBERTS_CLI_SIGNALS_H

#include <stddef.h>

/* ---- interruption ---- */

enum { SIGNALS_SLOTS = 64 }; /* files that can be under way at a time */

/* From now on SIGINT, SIGTERM, SIGHUP and SIGPIPE (the reader of the output is gone) remove the unfinished files and
 * then end the program as usual. A signal that was ignored stays ignored; a closed pipe is then an error of write(), as
 * the limit on file sizes always is. */
void signals_prepare(void);

/* The context that signals_temporary() wants, one for each thread that writes, from 0. */
void *signals_slot(int number);

/* A roberts_temporary_fn. */
void signals_temporary(void *context, const char *path);

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
