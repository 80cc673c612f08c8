/* input.c - files and memory as sources of bytes; reads blocks, skips white space and comments, finds tokens. */
#include "read/input.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/array.h"
#include "base/error.h"

/* ---- files ----------------------------------------------------------------------------------------------------- */

static ptrdiff_t read_file(void *context, void *buffer, size_t size)
{
    const input_file *f = context;
    ssize_t got;
    do
        got = read(f->descriptor, buffer, size);
    while (got < 0 && errno == EINTR);
    return got;
}

static ptrdiff_t read_file_at(void *context, uint64_t offset, void *buffer, size_t size)
{
    const input_file *f = context;
    ssize_t got;
    do
        got = pread(f->descriptor, buffer, size, f->start + (off_t)offset);
    while (got < 0 && errno == EINTR);
    return got;
}

static bool go_in_file(void *context, uint64_t offset)
{
    const input_file *f = context;
    return lseek(f->descriptor, f->start + (off_t)offset, SEEK_SET) >= 0;
}

input_source input_from_file(input_file *f)
{
    input_source source = {.read = read_file, .context = f, .to_end = true};
    struct stat about;
    if (fstat(f->descriptor, &about) != 0 || !S_ISREG(about.st_mode))
        return source;
    f->start = lseek(f->descriptor, 0, SEEK_CUR);
    if (f->start >= 0 && about.st_size > f->start) {
        source.read_at = read_file_at;
        source.go = go_in_file;
        source.size = (uint64_t)(about.st_size - f->start);
    }
    return source;
}

/* ---- memory ---------------------------------------------------------------------------------------------------- */

static ptrdiff_t read_memory_at(void *context, uint64_t offset, void *buffer, size_t size)
{
    const input_memory *m = context;
    size_t left = offset < m->size ? m->size - (size_t)offset : 0, taken = left < size ? left : size;
    if (taken)
        memcpy(buffer, m->bytes + offset, taken);
    return (ptrdiff_t)taken;
}

static ptrdiff_t read_memory(void *context, void *buffer, size_t size)
{
    input_memory *m = context;
    ptrdiff_t got = read_memory_at(m, m->at, buffer, size);
    m->at += (size_t)got;
    return got;
}

static bool go_in_memory(void *context, uint64_t offset)
{
    input_memory *m = context;
    m->at = (size_t)offset;
    return true;
}

input_source input_from_memory(input_memory *m)
{
    return (input_source){.read = read_memory,
                          .context = m,
                          .read_at = read_memory_at,
                          .go = go_in_memory,
                          .size = m->size,
                          .to_end = true};
}

/* ---- blocks ---------------------------------------------------------------------------------------------------- */

bool input_open(input *in, const input_source *source)
{
    *in = (input){.line = 1, .source = *source};
    in->buffer = alloc_zeroed(1 + INPUT_BLOCK + 1 + NUMBER_PADDING, 1);
    in->at = in->end = in->buffer ? in->buffer + 1 : NULL;
    return in->buffer;
}

void input_close(input *in)
{
    free(in->buffer);
    *in = (input){0};
}

bool input_more(input *in)
{
    size_t kept = (size_t)(in->end - in->at);
    if (in->ended || kept == INPUT_BLOCK)
        return false;
    memmove(in->buffer, in->at - 1, kept + 1);
    char *to = in->buffer + 1 + kept;
    errno = 0;
    ptrdiff_t got = in->source.read(in->source.context, to, INPUT_BLOCK - kept);
    if (got <= 0) {
        in->ended = true;
        if (got < 0)
            in->failure = errno ? errno : EIO;
        got = 0;
    }
    in->at = in->buffer + 1;
    in->end = to + got;
    in->taken += (size_t)got;
    memset(to + got, 0, 1 + NUMBER_PADDING);
    return got > 0;
}

void input_go(input *in, uint64_t offset)
{
    errno = 0;
    in->ended = !in->source.go(in->source.context, offset);
    if (in->ended)
        in->failure = errno ? errno : EIO;
    in->taken = offset;
    in->at = in->end = in->buffer + 1;
    in->buffer[0] = ' '; /* not a CR */
    memset(in->buffer + 1, 0, 1 + NUMBER_PADDING);
}

void input_drain(input *in)
{
    const uint64_t start = in->taken;
    do
        in->at = in->end;
    while (in->taken - start < INPUT_REST_MAX && input_more(in));
}

bool input_need(input *in, size_t count)
{
    while ((size_t)(in->end - in->at) < count) {
        if (!input_more(in))
            return false;
    }
    return true;
}

/* ---- tokens ---------------------------------------------------------------------------------------------------- */

/* Returns the end of a comment, or of the part of it in the buffer. */
static const char *comment(const char *c)
{
    while (*c != '\n' && *c != '\r' && *c != '\0')
        c++;
    return c;
}

/* Skips blanks and comments, and line ends too if `lines`. False: no token follows. */
static bool skip(input *in, bool lines)
{
    const char *c = in->at;
    uint64_t start = in->taken;
    bool commented = false; /* inside a comment; a '\0' does not end it */
    if (in->too_blank)
        return false; /* `at` may be inside a comment */
    for (;;) {
        if (commented)
            c = comment(c);
        if (c == in->end) {
            in->at = c;
            in->too_blank = in->taken - start > INPUT_BLANK_MAX;
            if (in->too_blank || !input_more(in))
                return false;
            c = in->at;
        } else if (*c == '\n' || *c == '\r') {
            commented = false;
            if (!lines)
                break;
            in->line += *c == '\r' || c[-1] != '\r';
            c++;
        } else if (commented || *c == ' ' || *c == '\t' || *c == '\v' || *c == '\f') {
            c++;
        } else if (*c == '#' && !in->plain) {
            commented = true;
        } else {
            break;
        }
    }
    in->at = c;
    return *c != '\n' && *c != '\r';
}

bool input_skip_on(input *in)
{
    return skip(in, true);
}

bool input_skip_in_line(input *in)
{
    return skip(in, false);
}

static bool in_token(char c, bool plain)
{
    return !input_separator(c) && (plain || (c != '#' && c != '{' && c != '}'));
}

size_t input_token(input *in)
{
    size_t length = 0;
    for (;;) {
        const char *c = in->at + length;
        while (c < in->end && in_token(*c, in->plain))
            c++;
        length = (size_t)(c - in->at);
        if (length > INPUT_TOKEN_MAX)
            return INPUT_TOKEN_MAX + 1;
        if (c < in->end || !input_more(in))
            return (length || in->at == in->end) ? length : 1; /* a brace is a token of its own */
    }
}

/* ---- words ----------------------------------------------------------------------------------------------------- */

bool input_not_finite(input *in)
{
    size_t length = input_token(in);
    const char *c = in->at;
    if (length && (*c == '-' || *c == '+')) {
        c++;
        length--;
    }
    return length >= 3 && ((c[0] | 0x20) == 'n' ? (c[1] | 0x20) == 'a' && (c[2] | 0x20) == 'n'
                                                : (c[0] | 0x20) == 'i' && (c[1] | 0x20) == 'n' && (c[2] | 0x20) == 'f');
}

bool input_at_word(input *in, const char *word)
{
    const size_t length = strlen(word);
    if (input_token(in) != length)
        return false;
    for (size_t i = 0; i < length; i++) {
        char c = in->at[i];
        if ((c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c) != word[i])
            return false;
    }
    return true;
}

bool input_number_slowly(input *in, double *value)
{
    size_t length = input_token(in);
    if (length > INPUT_TOKEN_MAX || number_parse(in->at, value) != in->at + length)
        return false;
    in->at += length;
    return true;
}

bool input_integer(input *in, uint64_t *value)
{
    size_t length = input_token(in);
    if (length > INPUT_TOKEN_MAX || number_integer(in->at, value) != in->at + length)
        return false;
    in->at += length;
    return true;
}

bool input_pass_line(input *in)
{
    const uint64_t start = in->taken;
    while (input_skip_in_line(in)) {
        if (in->taken - start > INPUT_BLANK_MAX)
            return false;
        input_pass_token(in);
    }
    return true;
}

/* ---- errors ---------------------------------------------------------------------------------------------------- */

static roberts_status fail_reading(const input *in, roberts_error *error)
{
    char reason[128];
    if (strerror_r(in->failure, reason, sizeof reason) != 0)
        snprintf(reason, sizeof reason, "error %d", in->failure);
    return error_set(error, ROBERTS_IO, 0, "reading failed: %s", reason);
}

/* Copies the token for a message: shortened, and without characters that would disturb a terminal. */
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

roberts_status input_expected(input *in, roberts_error *error, roberts_status status, size_t line, const char *wanted,
                              const char *hint)
{
    char found[112];
    size_t length = input_token(in);
    if (in->failure)
        return fail_reading(in, error);
    if (in->too_blank)
        return error_set(error, ROBERTS_BAD_SYNTAX, line, "%s expected, but nothing but blanks and comments follows",
                         wanted);
    if (length == 0)
        return error_set(error, ROBERTS_BAD_SYNTAX, line, "%s expected, but the input ends here", wanted);
    if (length > INPUT_TOKEN_MAX)
        return error_set(error, ROBERTS_BAD_SYNTAX, line, "%s expected, found a word of more than %zu characters",
                         wanted, INPUT_TOKEN_MAX);
    if (*in->at == '\n' || *in->at == '\r')
        return error_set(error, ROBERTS_BAD_SYNTAX, line, "%s expected, but the line ends here", wanted);
    quote(in->at, length, found, sizeof found);
    return error_set(error, status, line, "%s expected, found \"%s\"%s", wanted, found, hint);
}
