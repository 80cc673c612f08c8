/* off_input.h - the bytes of one input, block by block, and the tokens in them.
 *
 * A token is what stands between white space, '#' (a comment to the end of the line) and braces. Lines end with LF, CR
 * or CR LF. A token always ends up whole in the buffer, so that parsers need not know of blocks; the buffer is
 * followed by '\0' and NUMBER_PADDING more bytes, and preceded by one byte of history (was the last one a CR?). */
#ifndef ROBERTS_MODEL_OFF_INPUT_H
#define ROBERTS_MODEL_OFF_INPUT_H

#include "roberts.h"

#include "base/number.h"

/* Bytes asked for at a time: some, so that calls do not count, and no more than lies well in the caches. */
#define OFF_BLOCK ((size_t)1 << 16)

/* Longest token, characters. */
#define OFF_TOKEN_MAX ((size_t)NUMBER_LENGTH_MAX)

/* Longest stretch of white space and comments, or of what follows a face on its line, bytes: no file has as much, and an
 * endless one must end some time. */
#define OFF_BLANK_MAX ((size_t)1 << 26)

/* Where bytes come from. */
typedef struct off_source {
    roberts_read_fn *read;
    void *context;
    /* Where any place can be read at any time, by several threads: size bytes from `offset` on into the buffer, as
     * roberts_read_fn, and going there with `read`; else NULL. */
    ptrdiff_t (*read_at)(void *context, uint64_t offset, void *buffer, size_t size);
    bool (*go)(void *context, uint64_t offset);
    uint64_t size; /* bytes in all, as far as is known; only with read_at */
    bool finite;   /* reading up to the end cannot wait for ever */
} off_source;

typedef struct off_input {
    const char *at, *end; /* what is not yet taken; *end is '\0' */
    size_t line;          /* of `at`, from 1 */
    char *buffer;         /* [1 + OFF_BLOCK + 1 + NUMBER_PADDING] */
    off_source source;
    bool ended;     /* nothing follows `end` */
    int failure;    /* errno of a failed read; 0: none */
    bool too_blank; /* more than OFF_BLANK_MAX without a token: no other is looked for */
    uint64_t taken; /* bytes that were read before `end` */
} off_input;

/* False: no memory. Closed by input_close(), also then. */
bool input_open(off_input *in, const off_source *source);
void input_close(off_input *in);

/* Reads on, keeping what is not yet taken; `at` moves. False: nothing more comes, or the buffer is full. */
bool input_more(off_input *in);

/* Bytes before `at`. */
static inline uint64_t input_offset(const off_input *in)
{
    return in->taken - (uint64_t)(in->end - in->at);
}

/* Goes to where a token has ended, in an input that can be read at any place; a failure is one of reading. */
void input_go(off_input *in, uint64_t offset);

/* Makes `count` bytes stand at `at`; count <= OFF_BLOCK. False: the input ends before. */
bool input_need(off_input *in, size_t count);

/* Goes to the next token. False: the input ends first. */
bool input_skip_on(off_input *in);

/* The same; short where the next token comes after one blank or at the start of the next line. */
static inline bool input_skip(off_input *in)
{
    const char *c = in->at;
    if ((unsigned char)c[1] <= ' ' || c[1] == '#')
        return input_skip_on(in);
    if (*c == '\n')
        in->line++; /* no CR before it: the two are always passed together */
    else if (*c != ' ')
        return input_skip_on(in);
    in->at = c + 1;
    return true;
}

/* Goes to the next token of this line. False: there is none, and `at` is at the end of the line or of the input. */
bool input_skip_in_line(off_input *in);

/* Length of the token at `at`, which is made to stand whole in the buffer; beyond OFF_TOKEN_MAX it is cut off. At least
 * 1 unless the input ends. */
size_t input_token(off_input *in);

/* Goes to the end of the token. */
static inline void input_pass_token(off_input *in)
{
    size_t length = input_token(in); /* moves `at` */
    in->at += length;
}

/* What ends a number for sure: white space, or something that is no part of any token. Neither '\0', which ends the
 * buffer and may have more behind it, nor '#' and braces, which are rare: those go the slow way by input_token(). */
static inline bool input_separator(char c)
{
    return (unsigned char)(c - 1) < ' ';
}

#endif
