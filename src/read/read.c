/* read.c - a mesh from a function, a file or memory. */
#include "read/off.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static roberts_status read_source(roberts_mesh *mesh, const char *name, const input_source *source,
                                  const roberts_warnings *warnings, roberts_error *error)
{
    off_division division = off_divide(mesh->threads);
    return off_read(mesh, name, source, &division, warnings, error);
}

roberts_status roberts_mesh_read(roberts_mesh *mesh, const char *name, roberts_read_fn *read, void *context,
                                 const roberts_warnings *warnings, roberts_error *error)
{
    const input_source source = {.read = read, .context = context};
    return read_source(mesh, name, &source, warnings, error);
}

roberts_status roberts_mesh_read_file(roberts_mesh *mesh, const char *path, const roberts_warnings *warnings,
                                      roberts_error *error)
{
    bool standard = strcmp(path, "-") == 0;
    const char *name = standard ? "standard input" : path;
    input_file f = {.descriptor = standard ? STDIN_FILENO : open(path, O_RDONLY | O_CLOEXEC)};
    if (f.descriptor < 0) {
        char reason[128];
        if (strerror_r(errno, reason, sizeof reason) != 0)
            snprintf(reason, sizeof reason, "it cannot be opened");
        error_set_file(error, name);
        return error_set(error, ROBERTS_IO, 0, "%s", reason);
    }
    const input_source source = input_from_file(&f);
    roberts_status status = read_source(mesh, name, &source, warnings, error);
    if (!standard)
        close(f.descriptor);
    return status;
}

roberts_status roberts_mesh_read_memory(roberts_mesh *mesh, const char *name, const void *bytes, size_t size,
                                        const roberts_warnings *warnings, roberts_error *error)
{
    input_memory m = {bytes, size, 0};
    const input_source source = input_from_memory(&m);
    return read_source(mesh, name, &source, warnings, error);
}
