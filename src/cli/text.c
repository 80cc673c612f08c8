/* text.c - the text of a whole file. */
#include "cli/text.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PIECE = 4096 };

roberts_status text_fail(roberts_error *error, roberts_status status, const char *path, size_t line, const char *why)
{
    *error = (roberts_error){.status = status, .line = line};
    snprintf(error->file, sizeof error->file, "%s", path);
    snprintf(error->message, sizeof error->message, "%s", why);
    return status;
}

roberts_status text_read_stream(FILE *file, const char *path, size_t most, char **text, size_t *size,
                                roberts_error *error)
{
    size_t room = 0;
    *text = NULL;
    *size = 0;
    for (size_t got = 1; got > 0; *size += got) {
        if (*size + PIECE > room) {
            if (*size > most)
                return text_fail(error, ROBERTS_BAD_SYNTAX, path, 0, "is too long");
            room = 2 * room + 2 * PIECE;
            char *grown = realloc(*text, room);
            if (!grown)
                return text_fail(error, ROBERTS_NO_MEMORY, path, 0, "not enough memory");
            *text = grown;
        }
        got = fread(*text + *size, 1, PIECE - 1, file);
    }
    (*text)[*size] = '\0';
    return ferror(file) ? text_fail(error, ROBERTS_IO, path, 0, "cannot be read") : ROBERTS_OK;
}

roberts_status text_read(const char *path, size_t most, char **text, size_t *size, roberts_error *error)
{
    FILE *file = fopen(path, "rb");
    *text = NULL;
    *size = 0;
    if (!file)
        return text_fail(error, ROBERTS_IO, path, 0, strerror(errno));
    const roberts_status status = text_read_stream(file, path, most, text, size, error);
    fclose(file);
    return status;
}
