/* message.h - what the program says on standard error, or in a log that goes there in its turn. Every line begins with
 * "roberts: ". */
#ifndef ROBERTS_CLI_MESSAGE_H
#define ROBERTS_CLI_MESSAGE_H

#include <stdio.h>

#include "roberts.h"

enum { EXIT_DONE = 0, EXIT_FAILED = 1, EXIT_MISUSED = 2 };

#if defined(__GNUC__)
#define MESSAGE_PRINTF __attribute__((__format__(__printf__, 1, 2)))
#else
#define MESSAGE_PRINTF
#endif

/* Says what is wrong with the command and where help is; returns EXIT_MISUSED. */
int message_misuse(const char *format, ...) MESSAGE_PRINTF;

/* Around what is written to a log: where that is standard error, a line of progress makes room meanwhile. */
void message_open(FILE *log);
void message_close(FILE *log);

/* "roberts: ", and what it is about: a file or a picture; NULL: nothing else. */
void message_begin(FILE *log, const char *label);

/* FILE:LINE: what and why; returns the exit status that goes with it. */
int message_error(FILE *log, const roberts_error *error);

/* A roberts_warning_fn, whose context is the log: FILE:LINE: warning: what. */
void message_warning(void *context, const char *file, size_t line, const char *text);

#endif
