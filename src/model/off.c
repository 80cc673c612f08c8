/* off.c - reading OFF: from a function, a file or memory into a mesh, which stays as it was where anything fails. */
#include "model/off_pieces.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

roberts_status off_fail(off_reader *r, roberts_status status, const char *format, ...)
{
    char message[sizeof r->error->message];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    return error_set(r->error, status, r->header.binary ? 0 : r->in.line, "%s", message);
}

static roberts_status fail_reading(off_reader *r)
{
    char reason[128];
    if (strerror_r(r->in.failure, reason, sizeof reason) != 0)
        snprintf(reason, sizeof reason, "error %d", r->in.failure);
    return error_set(r->error, ROBERTS_IO, 0, "reading failed: %s", reason);
}

/* The token for a message: short, and without what a terminal might take amiss. */
static void quote(const char *token, size_t length, char *text, size_t room)
{
    size_t shown = length < 24 ? length : 24, n = 0;
    for (size_t i = 0; i < shown && n + 5 < room; i++) {
        unsigned char c = (unsigned char)token[i];
        if (c > ' ' && c < 0x7f)
            text[n++] = (char)c;
        else
            n += (size_t)snprintf(text + n, room - n, "\\x%02x", c);
    }
    snprintf(text + n, room - n, "%s", shown < length ? "..." : "");
}

/* For somebody who writes 0,5 or separates numbers by commas. */
static const char *explain_commas(const char *token, size_t length)
{
    const bool number = strchr("+-.0123456789", token[0]) != NULL;
    return number && (memchr(token, ',', length) || memchr(token, ';', length))
               ? "; OFF has decimal points, and blanks between numbers"
               : "";
}

/* -3, where only whole numbers from 0 on may stand: every other negative number is read. */
static bool is_negative(const char *token, size_t length)
{
    bool digits = length > 1 && token[0] == '-', zero = true;
    for (size_t i = 1; i < length && digits; i++) {
        digits = token[i] >= '0' && token[i] <= '9';
        zero = zero && token[i] == '0';
    }
    return digits && !zero;
}

static const char *explain_word(roberts_status status, const char *token, size_t length)
{
    if (status == ROBERTS_BAD_NUMBER)
        return "; it must be a finite number";
    return is_negative(token, length) ? ", which is negative" : explain_commas(token, length);
}

roberts_status off_expected(off_reader *r, roberts_status status, const char *format, ...)
{
    char wanted[120], found[112];
    size_t length = input_token(&r->in);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(wanted, sizeof wanted, format, arguments);
    va_end(arguments);
    if (r->in.failure)
        return fail_reading(r);
    if (r->in.too_blank)
        return off_fail(r, ROBERTS_BAD_SYNTAX, "%s expected, but nothing but blanks and comments follows", wanted);
    if (length == 0)
        return off_fail(r, ROBERTS_BAD_SYNTAX, "%s expected, but the input ends here", wanted);
    if (length > OFF_TOKEN_MAX)
        return off_fail(r, ROBERTS_BAD_SYNTAX, "%s expected, found a word of more than %zu characters", wanted,
                        OFF_TOKEN_MAX);
    quote(r->in.at, length, found, sizeof found);
    return off_fail(r, status, "%s expected, found \"%s\"%s", wanted, found, explain_word(status, r->in.at, length));
}

bool off_number_slowly(off_reader *r, double *value)
{
    size_t length = input_token(&r->in);
    if (length > OFF_TOKEN_MAX || number_parse(r->in.at, value) != r->in.at + length)
        return false;
    r->in.at += length;
    return true;
}

bool off_integer(off_reader *r, uint64_t *value)
{
    size_t length = input_token(&r->in);
    if (length > OFF_TOKEN_MAX || number_integer(r->in.at, value) != r->in.at + length)
        return false;
    r->in.at += length;
    return true;
}

void off_warn_fewer(off_reader *r, uint64_t found)
{
    warning_send(r->warnings, r->name, 0, "%llu faces declared, but there are %llu",
                 (unsigned long long)r->header.faces, (unsigned long long)found);
}

/* What is worth saying once an input is read. */
static void warn(off_reader *r)
{
    if (r->thin_faces)
        warning_send(r->warnings, r->name, 0, "%zu face%s with fewer than 3 corners ignored", r->thin_faces,
                     r->thin_faces == 1 ? "" : "s");
    if (r->odd_colors)
        warning_send(r->warnings, r->name, r->first_odd_color, "%zu colour%s that make%s no sense ignored",
                     r->odd_colors, r->odd_colors == 1 ? "" : "s", r->odd_colors == 1 ? "s" : "");
}

static roberts_status read_all(off_reader *r)
{
    roberts_status status = off_read_header(r);
    if (status != ROBERTS_OK)
        return status;
    if (!mesh_source(r->mesh, r->name))
        return error_no_memory(r->error);
    status = r->header.binary ? off_read_binary(r) : off_read_text(r);
    if (status != ROBERTS_OK)
        return status;
    bool faces_missing = r->mesh->face_count - r->mark.faces < r->header.faces;
    if (!mesh_color_rest(r->mesh, r->vertices_filled, r->faces_filled))
        return error_no_memory(r->error);
    warn(r);
    if (r->thin_faces || r->odd_colors || faces_missing)
        off_explain_warning(r);
    return ROBERTS_OK;
}

roberts_status off_read(roberts_mesh *mesh, const char *name, const off_source *source, const off_division *division,
                        const roberts_warnings *warnings, roberts_error *error)
{
    roberts_status status = ROBERTS_NO_MEMORY;
    off_reader r = {.mesh = mesh,
                    .mark = mesh_here(mesh),
                    .name = name,
                    .warnings = warnings,
                    .error = error,
                    .division = division,
                    .vertices_filled = mesh->vertex_color ? mesh->vertex_count : 0,
                    .faces_filled = mesh->face_color ? mesh->face_count : 0};
    error_set_file(error, name);
    if (!input_open(&r.in, source))
        error_no_memory(error);
    else
        status = read_all(&r);
    if (status == ROBERTS_BAD_SYNTAX || status == ROBERTS_BAD_INDEX)
        off_explain_error(&r);
    input_close(&r.in);
    if (status != ROBERTS_OK)
        mesh_back(mesh, r.mark);
    return status;
}

static roberts_status read_source(roberts_mesh *mesh, const char *name, const off_source *source,
                                  const roberts_warnings *warnings, roberts_error *error)
{
    off_division division = off_divide(mesh->threads);
    return off_read(mesh, name, source, &division, warnings, error);
}

roberts_status roberts_mesh_read(roberts_mesh *mesh, const char *name, roberts_read_fn *read, void *context,
                                 const roberts_warnings *warnings, roberts_error *error)
{
    const off_source source = {.read = read, .context = context};
    return read_source(mesh, name, &source, warnings, error);
}

/* ---- files --------------------------------------------------------------------------------------------------------- */

typedef struct file {
    int descriptor;
    off_t start; /* where it stood when it was given to us: not at 0 where standard input is the rest of a file */
} file;

static ptrdiff_t read_file(void *context, void *buffer, size_t size)
{
    const file *f = context;
    ssize_t got;
    do
        got = read(f->descriptor, buffer, size);
    while (got < 0 && errno == EINTR);
    return got;
}

static ptrdiff_t read_file_at(void *context, uint64_t offset, void *buffer, size_t size)
{
    const file *f = context;
    ssize_t got;
    do
        got = pread(f->descriptor, buffer, size, f->start + (off_t)offset);
    while (got < 0 && errno == EINTR);
    return got;
}

static bool go_in_file(void *context, uint64_t offset)
{
    const file *f = context;
    return lseek(f->descriptor, f->start + (off_t)offset, SEEK_SET) >= 0;
}

static off_source source_of(file *f)
{
    off_source source = {.read = read_file, .context = f};
    struct stat about;
    if (fstat(f->descriptor, &about) != 0 || !S_ISREG(about.st_mode))
        return source;
    source.finite = true;
    f->start = lseek(f->descriptor, 0, SEEK_CUR);
    if (f->start >= 0 && about.st_size > f->start) {
        source.read_at = read_file_at;
        source.go = go_in_file;
        source.size = (uint64_t)(about.st_size - f->start);
    }
    return source;
}

roberts_status roberts_mesh_read_file(roberts_mesh *mesh, const char *path, const roberts_warnings *warnings,
                                      roberts_error *error)
{
    bool standard = strcmp(path, "-") == 0;
    const char *name = standard ? "standard input" : path;
    file f = {.descriptor = standard ? STDIN_FILENO : open(path, O_RDONLY | O_CLOEXEC)};
    if (f.descriptor < 0) {
        char reason[128];
        if (strerror_r(errno, reason, sizeof reason) != 0)
            snprintf(reason, sizeof reason, "it cannot be opened");
        error_set_file(error, name);
        return error_set(error, ROBERTS_IO, 0, "%s", reason);
    }
    const off_source source = source_of(&f);
    roberts_status status = read_source(mesh, name, &source, warnings, error);
    if (!standard)
        close(f.descriptor);
    return status;
}

/* ---- memory -------------------------------------------------------------------------------------------------------- */

typedef struct memory {
    const char *bytes;
    size_t size, at;
} memory;

static ptrdiff_t read_memory_at(void *context, uint64_t offset, void *buffer, size_t size)
{
    const memory *m = context;
    size_t left = offset < m->size ? m->size - (size_t)offset : 0, taken = left < size ? left : size;
    if (taken)
        memcpy(buffer, m->bytes + offset, taken);
    return (ptrdiff_t)taken;
}

static ptrdiff_t read_memory(void *context, void *buffer, size_t size)
{
    memory *m = context;
    ptrdiff_t got = read_memory_at(m, m->at, buffer, size);
    m->at += (size_t)got;
    return got;
}

static bool go_in_memory(void *context, uint64_t offset)
{
    memory *m = context;
    m->at = (size_t)offset;
    return true;
}

roberts_status roberts_mesh_read_memory(roberts_mesh *mesh, const char *name, const void *bytes, size_t size,
                                        const roberts_warnings *warnings, roberts_error *error)
{
    memory m = {bytes, size, 0};
    const off_source source = {.read = read_memory,
                               .context = &m,
                               .read_at = read_memory_at,
                               .go = go_in_memory,
                               .size = size,
                               .finite = true};
    return read_source(mesh, name, &source, warnings, error);
}
