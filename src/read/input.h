/* input.h - the bytes of one input: where they come from, blocks of them, and the tokens in a text.
 *
 * A token is what stands between white space, '#' (a comment up to the end of the line) and braces. Lines end with LF,
 * CR or CR LF. input_token() brings a token whole into the buffer, so parsers need not know about blocks. The buffer is
 * followed by '\0' and NUMBER_PADDING more bytes. One byte of history precedes it (was the last one a CR?). */
#ifndef ROBERTS_READ_INPUT_H
#define ROBERTS_READ_INPUT_H

#include "roberts.h"

#include <sys/types.h>

#include "base/number.h"

/* Bytes asked for at a time: enough that calls do not count, and few enough to stay in the caches. */
#define INPUT_BLOCK ((size_t)1 << 16)

/* Longest token, characters. */
#define INPUT_TOKEN_MAX ((size_t)NUMBER_LENGTH_MAX)

/* Longest stretch of white space and comments, and longest rest of a line, bytes. No real file has as much, and reading
 * an endless one must end. */
#define INPUT_BLANK_MAX ((size_t)1 << 26)

/* ---- where bytes come from ------------------------------------------------------------------------------------- */

typedef struct input_source {
    roberts_read_fn *read;
    void *context;
    /* Both NULL if the input can only be read in order (a pipe). read_at: gives `size` bytes from `offset` on,
     * like roberts_read_fn; several threads may call it. go: moves the place of `read` there. */
    ptrdiff_t (*read_at)(void *context, uint64_t offset, void *buffer, size_t size);
    bool (*go)(void *context, uint64_t offset);
    uint64_t size;    /* bytes in all, as far as is known; only with read_at */
    bool finite;      /* reading up to the end cannot wait for ever */
    const char *path; /* of the file; NULL: none. Files that this one names are looked for beside it */
} input_source;

typedef struct input_file {
    int descriptor;
    off_t start; /* where it stood when we got it: standard input may be the rest of a file */
} input_file;

typedef struct input_memory {
    const char *bytes;
    size_t size, at;
} input_memory;

/* The sources of an open file, and of bytes in memory. Both read through `f` or `m`, which must outlive them. */
input_source input_from_file(input_file *f);
input_source input_from_memory(input_memory *m);

/* ---- blocks and tokens ----------------------------------------------------------------------------------------- */

typedef struct input {
    const char *at, *end; /* what is not yet taken; *end is '\0' */
    size_t line;          /* of `at`, from 1 */
    char *buffer;         /* [1 + INPUT_BLOCK + 1 + NUMBER_PADDING] */
    input_source source;
    bool plain;     /* to be set by a reader: '#' and braces are characters like others */
    bool ended;     /* nothing follows `end` */
    int failure;    /* errno of a failed read; 0: none */
    bool too_blank; /* INPUT_BLANK_MAX was passed without a token: no other is looked for */
    uint64_t taken; /* bytes read before `end` */
} input;

/* False: no memory. Call input_close() in either case. */
bool input_open(input *in, const input_source *source);
void input_close(input *in);

/* Reads on and keeps what is not yet taken; `at` moves. False: nothing more comes, or the buffer is full. */
bool input_more(input *in);

/* Bytes before `at`. */
static inline uint64_t input_offset(const input *in)
{
    return in->taken - (uint64_t)(in->end - in->at);
}

/* Goes to `offset`, the end of a token, in an input that can be read at any place. A failure counts as one
 * of reading. */
void input_go(input *in, uint64_t offset);

/* Brings `count` bytes to `at`; count <= INPUT_BLOCK. False: the input ends before. */
bool input_need(input *in, size_t count);

/* Goes to the next token. False: the input ends first. */
bool input_skip_on(input *in);

/* The same, without a call where one blank or one line end precedes the token. */
static inline bool input_skip(input *in)
{
    const char *c = in->at;
    if ((unsigned char)c[1] <= ' ' || c[1] == '#')
        return input_skip_on(in);
    if (*c == '\n')
        in->line++; /* no CR precedes it: the two are always passed together */
    else if (*c != ' ')
        return input_skip_on(in);
    in->at = c + 1;
    return true;
}

/* Goes to the next token of this line. False: there is none, and `at` is at the end of the line or of the input. */
bool input_skip_in_line(input *in);

/* Length of the token at `at`, which then stands whole in the buffer. INPUT_TOKEN_MAX + 1 where it is longer. At least
 * 1 unless the input ends. */
size_t input_token(input *in);

/* Goes to the end of the token. */
static inline void input_pass_token(input *in)
{
    size_t length = input_token(in); /* moves `at` */
    in->at += length;
}

/* Whether the token here is `word`, which is in lower case; upper case in the input will do. */
bool input_at_word(input *in, const char *word);

/* Whether the token here is an infinite number or "nan". */
bool input_not_finite(input *in);

/* Goes to the end of the line. False: it is longer than INPUT_BLANK_MAX. */
bool input_pass_line(input *in);

/* Says that the input has something else than `wanted` at its place: fills `error`, and returns the status. The message
 * quotes what stands there and adds `hint`, or says that the input ends or that reading failed. line: 0 where lines
 * mean nothing. */
roberts_status input_expected(input *in, roberts_error *error, roberts_status status, size_t line, const char *wanted,
                              const char *hint);

/* Whether `c` ends a number for sure: white space, or a character that is part of no token. '\0', '#' and braces take
 * the slow way by input_token(): '\0' ends the buffer and may have more behind it, the others are rare. */
static inline bool input_separator(char c)
{
    return (unsigned char)(c - 1) < ' ';
}

/* Read the number, or the unsigned integer, that is the whole token here. False: it is none, and nothing is taken. */
bool input_number_slowly(input *in, double *value);
bool input_integer(input *in, uint64_t *value);

static inline bool input_number(input *in, double *value)
{
    const char *end = number_parse(in->at, value);
    if (!end || !input_separator(*end))
        return input_number_slowly(in, value);
    in->at = end;
    return true;
}

#endif
