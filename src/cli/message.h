/* message.h - what the program says on standard error. Every line begins with "roberts: ". */
#ifndef ROBERTS_CLI_MESSAGE_H
#define ROBERTS_CLI_MESSAGE_H

#include "roberts.h"

enum { EXIT_DONE = 0, EXIT_FAILED = 1, EXIT_MISUSED = 2 };

#if defined(__GNUC__)
#define MESSAGE_PRINTF __attribute__((__format__(__printf__, 1, 2)))
#else
#define MESSAGE_PRINTF
#endif

/* Says what is wrong with the command and where help is; returns EXIT_MISUSED. */
int message_misuse(const char *format, ...) MESSAGE_PRINTF;

/* FILE:LINE: what and why; returns the exit status that goes with it. */
int message_error(const roberts_error *error);

/* A roberts_warning_fn: FILE:LINE: warning: what. */
void message_warning(void *context, const char *file, size_t line, const char *text);

#endif
