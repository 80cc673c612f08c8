/* manifest.c - the manifest of batches: a file with a line of JSON for each file that was tried.
 *
 * A row is written by one write() to a file opened for appending, so rows of several processes do not mix. A killed
 * process may still leave a part of a row. The next process that opens the manifest cuts it off, unless another one has
 * the manifest open: all hold a shared lock, and cutting needs an exclusive one. */
#include "cli/manifest.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/lists.h"
#include "cli/message.h"

static const char first[] = "{\"file\":", command[] = ",\"command\":";

static roberts_status fail(const manifest *m, const char *what, roberts_error *error)
{
    char why[200];
    snprintf(why, sizeof why, "%s: %s", what, strerror(errno));
    return lists_fail(error, ROBERTS_IO, m->path, 0, why);
}

static roberts_status no_memory(const manifest *m, roberts_error *error)
{
    return lists_fail(error, ROBERTS_NO_MEMORY, m->path, 0, "not enough memory");
}

/* Finds where the last whole line ends. False: it cannot be read. */
static bool find_end(int descriptor, off_t size, off_t *end)
{
    char piece[4096];
    for (*end = size; *end > 0;) {
        const off_t from = *end > (off_t)sizeof piece ? *end - (off_t)sizeof piece : 0;
        if (pread(descriptor, piece, (size_t)(*end - from), from) != *end - from)
            return false;
        for (; *end > from; --*end)
            if (piece[*end - from - 1] == '\n')
                return true;
    }
    return true;
}

/* Cuts off a line without an end. */
static roberts_status cut(const manifest *m, off_t size, roberts_error *error)
{
    off_t end;
    if (!find_end(m->descriptor, size, &end))
        return fail(m, "cannot read", error);
    return end == size || ftruncate(m->descriptor, end) == 0 ? ROBERTS_OK : fail(m, "cannot write", error);
}

/* Whether the file, as far as it goes, begins like a manifest. */
static bool begins_well(int descriptor)
{
    char found[sizeof first];
    const ssize_t size = pread(descriptor, found, sizeof first - 1, 0);
    return size >= 0 && memcmp(found, first, (size_t)size) == 0;
}

roberts_status manifest_open(manifest *m, const char *path, roberts_error *error)
{
    struct stat found;
    roberts_status status = ROBERTS_OK;
    *m = (manifest){path, open(path, O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0666)};
    if (m->descriptor < 0)
        return fail(m, "cannot write", error);
    const bool only = flock(m->descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
    if (fstat(m->descriptor, &found) != 0 || !S_ISREG(found.st_mode))
        status = lists_fail(error, ROBERTS_IO, path, 0, "is no file");
    else if (!begins_well(m->descriptor))
        status = lists_fail(error, ROBERTS_BAD_SYNTAX, path, 0, "is no manifest: its first line is something else");
    else if (only)
        status = cut(m, found.st_size, error);
    (void)flock(m->descriptor, LOCK_SH);
    if (status != ROBERTS_OK)
        manifest_close(m);
    return status;
}

void manifest_close(manifest *m)
{
    close(m->descriptor);
    m->descriptor = -1;
}

/* The most bytes that a string can take in JSON. */
static size_t room_for(const char *text)
{
    return text ? 6 * strlen(text) + 2 : 4;
}

/* Returns the text of a row; unless `whole`, only the part that does not depend on the drawing. The caller frees it;
 * NULL: no memory. All memory is allocated first, since open_memstream() may lose bytes silently. */
static char *write_row(const manifest_row *row, bool whole)
{
    const size_t size =
        200 + room_for(row->file) + room_for(row->output) + room_for(row->command) + room_for(row->error);
    char *text = malloc(size);
    FILE *to = text ? fmemopen(text, size, "w") : NULL;
    if (!to) {
        free(text);
        return NULL;
    }
    fputs(first, to);
    message_json(to, row->file);
    fputs(",\"output\":", to);
    message_json(to, row->output);
    fputs(command, to);
    message_json(to, row->command);
    fputs(",\"error\":", to);
    message_json(to, row->error);
    fputc(',', to);
    if (whole)
        fprintf(to, "\"seconds\":%.6f,\"lines\":%zu,\"warnings\":%zu}\n", row->seconds, row->lines, row->warnings);
    fclose(to); /* puts a NUL behind it */
    return text;
}

/* A full disk or a signal may interrupt the writing of a row: the rest is tried once more. */
static bool write_all(int descriptor, const char *text, size_t size)
{
    while (size > 0) {
        const ssize_t done = write(descriptor, text, size);
        if (done < 0 && errno == EINTR)
            continue;
        if (done <= 0)
            return false;
        text += done;
        size -= (size_t)done;
    }
    return true;
}

roberts_status manifest_add(const manifest *m, const manifest_row *row, roberts_error *error)
{
    char *text = write_row(row, true);
    if (!text)
        return no_memory(m, error);
    const roberts_status status =
        write_all(m->descriptor, text, strlen(text)) ? ROBERTS_OK : fail(m, "cannot write", error);
    free(text);
    return status;
}

/* ---- what the rows say ---- */

/* How many bytes of a row identify its file. In the strings before it each quote has a backslash, so `command` is found
 * only at its place. */
static size_t key_length(const char *row)
{
    const char *end = strstr(row, command);
    return end ? (size_t)(end - row) : 0;
}

bool manifest_ask(manifest_query *query, const manifest_row *row)
{
    query->drawn = false;
    query->begins = write_row(row, false);
    query->key = query->begins ? key_length(query->begins) : 0;
    return query->begins != NULL;
}

static int compare_keys(const char *a, size_t a_size, const char *b, size_t b_size)
{
    const int order = memcmp(a, b, a_size < b_size ? a_size : b_size);
    return order ? order : (a_size > b_size) - (a_size < b_size);
}

static int by_key(const void *a, const void *b)
{
    const manifest_query *p = a, *q = b;
    return compare_keys(p->begins, p->key, q->begins, q->key);
}

/* Later rows override earlier ones. */
static void take_row(const char *row, manifest_query *query, size_t count)
{
    const size_t key = key_length(row);
    size_t low = 0, high = count;
    while (low < high) { /* the first query that is not less */
        const size_t middle = low + (high - low) / 2;
        if (compare_keys(query[middle].begins, query[middle].key, row, key) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    for (; low < count && compare_keys(query[low].begins, query[low].key, row, key) == 0; low++)
        query[low].drawn = strncmp(row, query[low].begins, strlen(query[low].begins)) == 0;
}

roberts_status manifest_answer(const manifest *m, manifest_query *query, size_t count, roberts_error *error)
{
    char *row = NULL;
    size_t room = 0;
    FILE *file = fopen(m->path, "r");
    if (!file)
        return fail(m, "cannot read", error);
    qsort(query, count, sizeof *query, by_key);
    errno = 0;
    while (getline(&row, &room, file) >= 0)
        take_row(row, query, count);
    const bool failed = !feof(file);
    const roberts_status status = !failed           ? ROBERTS_OK
                                  : errno == ENOMEM ? no_memory(m, error)
                                                    : fail(m, "cannot read", error);
    free(row);
    fclose(file);
    return status;
}
