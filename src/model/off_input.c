/* off_input.c - reading blocks, skipping white space and comments, finding tokens. */
#include "model/off_input.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"

bool input_open(off_input *in, const off_source *source)
{
    *in = (off_input){.line = 1, .source = *source};
    in->buffer = alloc_zeroed(1 + OFF_BLOCK + 1 + NUMBER_PADDING, 1);
    in->at = in->end = in->buffer ? in->buffer + 1 : NULL;
    return in->buffer;
}

void input_close(off_input *in)
{
    free(in->buffer);
    *in = (off_input){0};
}

bool input_more(off_input *in)
{
    size_t kept = (size_t)(in->end - in->at);
    if (in->ended || kept == OFF_BLOCK)
        return false;
    memmove(in->buffer, in->at - 1, kept + 1);
    char *to = in->buffer + 1 + kept;
    errno = 0;
    ptrdiff_t got = in->source.read(in->source.context, to, OFF_BLOCK - kept);
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

void input_go(off_input *in, uint64_t offset)
{
    errno = 0;
    in->ended = !in->source.go(in->source.context, offset);
    if (in->ended)
        in->failure = errno ? errno : EIO;
    in->taken = offset;
    in->at = in->end = in->buffer + 1;
    in->buffer[0] = ' '; /* no CR */
    memset(in->buffer + 1, 0, 1 + NUMBER_PADDING);
}

bool input_need(off_input *in, size_t count)
{
    while ((size_t)(in->end - in->at) < count) {
        if (!input_more(in))
            return false;
    }
    return true;
}

/* After a comment's characters in the buffer. */
static const char *comment(const char *c)
{
    while (*c != '\n' && *c != '\r' && *c != '\0')
        c++;
    return c;
}

/* The common part: skips blanks and comments, and line ends too if `lines`. */
static bool skip(off_input *in, bool lines)
{
    const char *c = in->at;
    uint64_t start = in->taken;
    bool commented = false; /* within a comment, which a '\0' does not end */
    if (in->too_blank)
        return false; /* perhaps within a comment, still */
    for (;;) {
        if (commented)
            c = comment(c);
        if (c == in->end) {
            in->at = c;
            in->too_blank = in->taken - start > OFF_BLANK_MAX;
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
        } else if (*c == '#') {
            commented = true;
        } else {
            break;
        }
    }
    in->at = c;
    return *c != '\n' && *c != '\r';
}

bool input_skip_on(off_input *in)
{
    return skip(in, true);
}

bool input_skip_in_line(off_input *in)
{
    return skip(in, false);
}

static bool in_token(char c)
{
    return !input_separator(c) && c != '#' && c != '{' && c != '}';
}

size_t input_token(off_input *in)
{
    size_t length = 0;
    for (;;) {
        const char *c = in->at + length;
        while (c < in->end && in_token(*c))
            c++;
        length = (size_t)(c - in->at);
        if (length > OFF_TOKEN_MAX)
            return OFF_TOKEN_MAX + 1;
        if (c < in->end || !input_more(in))
            return (length || in->at == in->end) ? length : 1; /* a brace is a token of its own */
    }
}
