/* error.h - filling a roberts_error. */
#ifndef ROBERTS_BASE_ERROR_H
#define ROBERTS_BASE_ERROR_H

#include "roberts.h"

#if defined(__GNUC__)
#define ROBERTS_PRINTF(text, first) __attribute__((__format__(__printf__, text, first)))
#else
#define ROBERTS_PRINTF(text, first)
#endif

/* Fills `error` (where not NULL) and returns `status`, so that failing reads `return error_set(...)`. The file is kept
 * where error_set_file() has put one. */
roberts_status error_set(roberts_error *error, roberts_status status, size_t line, const char *format, ...)
    ROBERTS_PRINTF(4, 5);

/* Names the file that the error concerns; a name too long keeps its end. */
void error_set_file(roberts_error *error, const char *file);

/* error_set() for an exhausted memory. */
roberts_status error_no_memory(roberts_error *error);

/* Formats one warning and passes it on; nothing where `warnings` or its function is NULL. */
void warning_send(const roberts_warnings *warnings, const char *file, size_t line, const char *format, ...)
    ROBERTS_PRINTF(4, 5);

#endif
