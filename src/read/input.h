/* input.h - the bytes of one input: their source, blocks of them, and the tokens of a text.
 *
 * Tokens are separated by white space, '#' (a comment up to the end of the line) and braces. Lines end with LF, CR or
 * CR LF. input_token() brings a whole token into the buffer, so parsers need not know about blocks. The buffer is
 * followed by '\0' and NUMBER_PADDING more bytes. One byte of history precedes it (was the last one a CR?). */
#ifndef ROBERTS_READ_INPUT_H
#define ROBERTS_READ_INPUT_H

#include "roberts.h"

#include <sys/types.h>

#include "base/number.h"

/* Bytes read at a time: enough that the calls do not matter, and few enough to stay in the caches. */
#define INPUT_BLOCK ((size_t)1 << 16)

/* Characters: the longest token. */
#define INPUT_TOKEN_MAX ((size_t)NUMBER_LENGTH_MAX)

/* Bytes: the longest stretch of white space and comments, and the longest rest of a line. No real file has as much, and
 * reading an endless one must end. */
#define INPUT_BLANK_MAX ((size_t)1 << 26)

/* Bytes: the most that is read after a model, so that reading an endless input ends. It takes less than a second. */
#define INPUT_REST_MAX ((uint64_t)1 << 30)

/* ---- sources of bytes ------------------------------------------------------------------------------------------- */

typedef struct input_source {
    roberts_read_fn *read;
    void *context;
    /* Both are NULL if the input can only be read in order (a pipe). read_at: reads `size` bytes from `offset` on, like
     * roberts_read_fn; several threads may call it. go: moves the position of `read` there. */
    ptrdiff_t (*read_at)(void *context, uint64_t offset, void *buffer, size_t size);
    bool (*go)(void *context, uint64_t offset);
    uint64_t size;    /* total bytes, as far as known; only with read_at */
    bool to_end;      /* read what follows the model too; otherwise it may belong to someone else */
    const char *path; /* of the file; NULL: none. Files that it names are searched for beside it */
} input_source;

typedef struct input_file {
    int descriptor;
    off_t start; /* position when the file was passed to us: standard input may be the rest of a file */
} input_file;

typedef struct input_memory {
    const char *bytes;
    size_t size, at;
} input_memory;

/* Make a source of an open file, and of bytes in memory. Both read through `f` or `m`, which must outlive them. */
input_source input_from_file(input_file *f);
input_source input_from_memory(input_memory *m);

/* ---- blocks and tokens ----------------------------------------------------------------------------------------- */

typedef struct input {
    const char *at, *end; /* the bytes not yet taken; *end is '\0' */
    size_t line;          /* line of `at`, from 1 */
    char *buffer;         /* [1 + INPUT_BLOCK + 1 + NUMBER_PADDING] */
    input_source source;
    bool plain;     /* set by a reader: '#' and braces are ordinary characters */
    bool ended;     /* nothing follows `end` */
    int failure;    /* errno of a failed read; 0: none */
    bool too_blank; /* INPUT_BLANK_MAX was passed without a token: the search has ended */
    uint64_t taken; /* bytes read before `end` */
} input;

/* Opens an input. False: no memory. Call input_close() in either case. */
bool input_open(input *in, const input_source *source);
void input_close(input *in);

/* Reads on and keeps the bytes not yet taken; `at` moves. False: nothing more comes, or the buffer is full. */
bool input_more(input *in);

/* Returns the number of bytes before `at`. */
static inline uint64_t input_offset(const input *in)
{
    return in->taken - (uint64_t)(in->end - in->at);
}

/* Moves to `offset`, the end of a token, in an input that can be read at any position. A failure counts as a read
 * error. */
void input_go(input *in, uint64_t offset);

/* Makes `count` bytes available at `at`; count <= INPUT_BLOCK. False: the input ends before. */
bool input_need(input *in, size_t count);

/* Moves to the next token. False: the input ends first. */
bool input_skip_on(input *in);

/* Does the same, without a call if a single blank or line end precedes the token. */
static inline bool input_skip(input *in)
{
    const char *c = in->at;
    if ((unsigned char)c[1] <= ' ' || c[1] == '#')
        return input_skip_on(in);
    if (*c == '\n')
        in->line++; /* not after a CR: CR and LF are always taken together */
    else if (*c != ' ')
        return input_skip_on(in);
    in->at = c + 1;
    return true;
}

/* Moves to the next token of this line. False: there is none, and `at` is at the end of the line or of the input. */
bool input_skip_in_line(input *in);

/* Returns the length of the token at `at`, which is then completely in the buffer. INPUT_TOKEN_MAX + 1: it is longer.
 * At least 1 unless the input ends. */
size_t input_token(input *in);

/* Moves to the end of the token. */
static inline void input_pass_token(input *in)
{
    size_t length = input_token(in); /* moves `at` */
    in->at += length;
}

/* Is the token here `word`, ignoring case? `word` is in lower case. */
bool input_at_word(input *in, const char *word);

/* Is the token here an infinite number or "nan"? */
bool input_not_finite(input *in);

/* Moves to the end of the line. False: it is longer than INPUT_BLANK_MAX. */
bool input_pass_line(input *in);

/* Reads the rest of the input, up to INPUT_REST_MAX, and discards it. */
void input_drain(input *in);

/* Reports that the input has something other than `wanted` here: fills `error`, and returns the status. The message
 * quotes the text and adds `hint`, or says that the input ends or that reading failed. line: 0 if lines have no
 * meaning. */
roberts_status input_expected(input *in, roberts_error *error, roberts_status status, size_t line, const char *wanted,
                              const char *hint);

/* Does `c` certainly end a number? White space does, and characters that are part of no token. '\0', '#' and braces
 * take the slow path through input_token(): '\0' ends the buffer and more may follow it, the others are rare. */
static inline bool input_separator(char c)
{
    return (unsigned char)(c - 1) < ' ';
}

/* Read the number, or the unsigned integer, if it is the whole token here. False: it is not, and nothing is taken. */
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
