/* off.h - what the parts of the OFF reader share.
 *
 * off.c         the public functions: sources, warnings, going back after an error
 * off_header.c  keyword, dimension, counts
 * off_text.c    vertices and faces as text
 * off_plain.c   most of them: plain lines
 * off_pieces.c  plain lines by several threads
 * off_binary.c  vertices and faces as 32-bit words
 * off_color.c   what the numbers of a colour mean
 * off_foreign.c other formats, by how they begin
 * off_explain.c after an error: which line may be the reason, or that it is no OFF
 * off_odd.c     the line that is not as its header says, or not as those before it
 * off_lines.c   the text once more, line by line, for these two
 * off_input.c   blocks and tokens */
#ifndef ROBERTS_MODEL_OFF_H
#define ROBERTS_MODEL_OFF_H

#include "roberts.h"

#include "base/error.h"
#include "model/mesh.h"
#include "model/off_input.h"

/* What stands before the vertices. */
typedef struct off_header {
    bool texture, color, normal, homogeneous, dimension; /* prefixes ST, C, N, 4, n */
    bool binary;
    bool bare;                /* no keyword */
    size_t line;              /* where the counts end; 0: not yet read, or a vertex begins there */
    size_t braces;            /* opened, and to be closed after the last face */
    uint64_t vertices, faces; /* as declared: nothing is allocated for them */
} off_header;

struct off_division;

typedef struct off_reader {
    off_input in;
    off_header header;
    roberts_mesh *mesh;
    mesh_mark mark; /* the mesh before this input */
    const char *name;
    const roberts_warnings *warnings;
    roberts_error *error;
    size_t vertices_filled, faces_filled; /* whose colours are set */
    size_t thin_faces;                    /* with fewer than 3 corners */
    const struct off_division *division;  /* into pieces for threads */
    unsigned tries_in_vain;               /* of pieces */
    size_t odd_colors, first_odd_color;   /* colours that make no sense, and the line of the first */
} off_reader;

/* Fills the error with the current line; returns `status`. */
roberts_status off_fail(off_reader *r, roberts_status status, const char *format, ...) ROBERTS_PRINTF(3, 4);

/* Fails because something else than `format` (what should stand here) stands at the input's place: quotes what is there
 * or says that the input ends or that reading failed. */
roberts_status off_expected(off_reader *r, roberts_status status, const char *format, ...) ROBERTS_PRINTF(3, 4);

/* Reads the number, or the unsigned integer, at the input's place, which must be a whole token. False: it is none, and
 * nothing is taken. */
bool off_number_slowly(off_reader *r, double *value);
bool off_integer(off_reader *r, uint64_t *value);

static inline bool off_number(off_reader *r, double *value)
{
    const char *end = number_parse(r->in.at, value);
    if (!end || !input_separator(*end))
        return off_number_slowly(r, value);
    r->in.at = end;
    return true;
}

/* What is above all vertex numbers of plain lines, which have no more than eight digits. */
static inline uint32_t off_index_limit(const off_reader *r)
{
    return r->header.vertices < UINT32_MAX ? (uint32_t)r->header.vertices : UINT32_MAX;
}

roberts_status off_read_header(off_reader *r);
roberts_status off_read_text(off_reader *r);
roberts_status off_read_binary(off_reader *r);

/* Says that there are fewer faces than declared. */
void off_warn_fewer(off_reader *r, uint64_t found);

/* Reads a text once more, when all is done, and adds to its error which of its lines may be the reason, or says instead that
 * it is no OFF; or warns of a line in which a number seems to be missing. The reader's buffer is lost. */
void off_explain_error(off_reader *r);
void off_explain_warning(off_reader *r);

/* Whether a keyword comes next, also behind "{" or "{ ="; what is before it is taken. */
bool off_at_keyword(off_reader *r);

/* Warns of text after the last face: that it is one more model, where it has a keyword, or that the input is no OFF, if it
 * does not look like one. */
void off_explain_rest(off_reader *r);

/* The name of the format that begins with this word; NULL: not known. */
const char *off_foreign(const char *word, size_t length);

enum { COLOR_MOST = 4 };

/* The numbers of a colour as they stand there. */
typedef struct off_color_numbers {
    int count;
    bool real; /* one of them has a point or an exponent */
    double value[COLOR_MOST];
} off_color_numbers;

/* Colours the vertex, or the face, that was read last. What makes no sense is counted and left out. */
roberts_status off_color_vertex(off_reader *r, const off_color_numbers *numbers);
roberts_status off_color_face(off_reader *r, const off_color_numbers *numbers);

#endif
