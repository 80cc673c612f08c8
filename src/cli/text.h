/* text.h - the text of a whole file. */
#ifndef ROBERTS_CLI_TEXT_H
#define ROBERTS_CLI_TEXT_H

#include <stdio.h>

#include "roberts.h"

/* Fills `error` and returns `status`. */
roberts_status text_fail(roberts_error *error, roberts_status status, const char *path, size_t line, const char *why);

/* Reads all `*size` bytes of a file, of which there may be about `most`; a NUL follows them. `*text` is freed by the
 * caller, after a failure too. Returns ROBERTS_OK, _IO, _NO_MEMORY or _BAD_SYNTAX (it is too long). */
roberts_status text_read(const char *path, size_t most, char **text, size_t *size, roberts_error *error);

/* The same from an open file, which errors call `path`. */
roberts_status text_read_stream(FILE *file, const char *path, size_t most, char **text, size_t *size,
                                roberts_error *error);

#endif
