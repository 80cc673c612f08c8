/* error.h - fills a roberts_error; sends warnings. */
#ifndef ROBERTS_BASE_ERROR_H
#define ROBERTS_BASE_ERROR_H

#include "roberts.h"

#if defined(__GNUC__)
#define ROBERTS_PRINTF(text, first) __attribute__((__format__(__printf__, text, first)))
#else
#define ROBERTS_PRINTF(text, first)
#endif

/* Fills `error` (unless NULL), without a file, and returns `status`, so that a caller can write
 * `return error_set(...)`. */
roberts_status error_set(roberts_error *error, roberts_status status, size_t line, const char *format, ...)
    ROBERTS_PRINTF(4, 5);

/* Names the file of an error that error_set() has filled. If the name is too long, its end is kept. */
void error_set_file(roberts_error *error, const char *file);

/* Names the file and returns the error's `status`, so that a caller can write `return error_in(error, file,
 * error_set(...))`. */
roberts_status error_in(roberts_error *error, const char *file, roberts_status status);

/* error_set() for exhausted memory. */
roberts_status error_no_memory(roberts_error *error);

/* Formats one warning and sends it. Does nothing if `warnings` or its function is NULL. */
void warning_send(const roberts_warnings *warnings, const char *file, size_t line, const char *format, ...)
    ROBERTS_PRINTF(4, 5);

#endif
