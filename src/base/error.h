/* error.h - fills a roberts_error; sends warnings. */
#ifndef ROBERTS_BASE_ERROR_H
#define ROBERTS_BASE_ERROR_H

#include "roberts.h"

#if defined(__GNUC__)
#define ROBERTS_PRINTF(text, first) __attribute__((__format__(__printf__, text, first)))
#else
#define ROBERTS_PRINTF(text, first)
#endif

/* Fills `error` (unless NULL) and returns `status`, so that a caller can write `return error_set(...)`. Keeps a file
 * name set by error_set_file(). */
roberts_status error_set(roberts_error *error, roberts_status status, size_t line, const char *format, ...)
    ROBERTS_PRINTF(4, 5);

/* Sets the file that the error is about. If the name is too long, its end is kept. */
void error_set_file(roberts_error *error, const char *file);

/* error_set() for exhausted memory. */
roberts_status error_no_memory(roberts_error *error);

/* Formats one warning and sends it. Does nothing if `warnings` or its function is NULL. */
void warning_send(const roberts_warnings *warnings, const char *file, size_t line, const char *format, ...)
    ROBERTS_PRINTF(4, 5);

#endif
