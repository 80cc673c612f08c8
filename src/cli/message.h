/* message.h - the program's messages on standard error, or in a log that is printed there later. Every line begins with
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

/* Reports what is wrong with the command, and where help is; returns EXIT_MISUSED. */
int message_misuse(const char *format, ...) MESSAGE_PRINTF;

/* Call these before and after writing to a log: if it is standard error, they remove the progress line meanwhile. */
void message_open(FILE *log);
void message_close(FILE *log);

/* A terminal must not obey control characters in names. */
static inline bool message_is_control(char c)
{
    return (unsigned char)c < ' ' || c == 0x7f;
}

/* Writes "roberts: " and the subject of the message: a file or a picture, or NULL. */
void message_begin(FILE *log, const char *label);

/* Writes FILE:LINE: what is wrong. Returns the exit status for it. */
int message_error(FILE *log, const roberts_error *error);

/* Writes FILE:LINE: warning: what. A roberts_warning_fn, whose context is the log. */
void message_warning(void *context, const char *file, size_t line, const char *text);

/* Writes `text` as a string of JSON (RFC 8259), with its quotes; NULL is null. Bytes that are not UTF-8, which names of
 * files may have, become U+FFFD. */
void message_json(FILE *file, const char *text);

#endif
