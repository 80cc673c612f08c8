/* whole_file.h - files that appear whole or not at all. */
#ifndef ROBERTS_WRITE_WHOLE_FILE_H
#define ROBERTS_WRITE_WHOLE_FILE_H

#include <sys/stat.h>

#include "roberts.h"

typedef struct whole_file {
    int descriptor;                 /* where the bytes go */
    roberts_temporary_fn *announce; /* called as roberts_draw_options.temporary is, with `context`; NULL: nobody asks */
    void *context;
    char *path;      /* links followed */
    char *temporary; /* the file that will be renamed to `path`; NULL: written in place */
    struct stat old; /* of `path` if `replaces` */
    bool replaces;
} whole_file;

/* Opens a file for writing. `announce` and `context` are set, all else is zeroed. Returns ROBERTS_OK, _NO_MEMORY or
 * _IO; only after ROBERTS_OK must whole_file_close() be called. */
roberts_status whole_file_open(whole_file *f, const char *path, roberts_error *error);

/* Closes the file, and renames it where all went well. In every case the temporary file is gone. status: ROBERTS_OK if
 * all bytes are written, else why not. Returns it, or why the file could not get its name. */
roberts_status whole_file_close(whole_file *f, roberts_status status, roberts_error *error);

/* Returns the folder of `path` with its slash, then `name`, to be freed by the caller. NULL: no memory. */
char *whole_file_beside(const char *path, const char *name);

#endif
