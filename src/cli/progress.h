/* progress.h - a line on the terminal that says what is being done, once that takes more than a second. */
#ifndef ROBERTS_CLI_PROGRESS_H
#define ROBERTS_CLI_PROGRESS_H

#include <stddef.h>

/* From now on, once a second. Never called: there is no line, and the other functions do nothing. */
void progress_begin(void);

/* What is being done: a constant, such as "reading". */
void progress_stage(const char *name);

/* `done` of `total` files or pictures. From any thread, but one at a time. */
void progress_count(size_t done, size_t total);

/* Takes the line away, and keeps it away until progress_show(): around messages. */
void progress_hide(void);
void progress_show(void);

#endif
