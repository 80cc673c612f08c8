/* save.h - files that are no drawings, saved like drawings. */
#ifndef ROBERTS_WRITE_SAVE_H
#define ROBERTS_WRITE_SAVE_H

#include "base/output.h"

/* Writes the file. Failures of `out` need not be checked. */
typedef struct save_source {
    roberts_status (*write)(void *context, output *out, roberts_error *error);
    void *context;
} save_source;

/* Saves a file as roberts_drawing_save() does; "-" is standard output. temporary: as in roberts_draw_options. */
roberts_status save_from(const save_source *source, roberts_temporary_fn *temporary, void *temporary_context,
                         const char *path, roberts_error *error);

#endif
