/* off.h - what the parts of the OFF reader share.
 *
 * off.c          the driver: what comes after what; colours
 * off_header.c   keyword, dimension, counts
 * off_text.c     vertices and faces as text
 * off_pieces.c   large texts by several threads
 * off_binary.c   vertices and faces as 32-bit words
 * off_explain.c  messages about a faulty file */
#ifndef ROBERTS_READ_OFF_H
#define ROBERTS_READ_OFF_H

#include "read/read.h"

/* What precedes the vertices. */
typedef struct off_header {
    bool texture, color, normal, homogeneous, dimension; /* prefixes ST, C, N, 4, n */
    bool binary;
    bool bare;                /* no keyword */
    size_t line;              /* where the counts end; 0: not yet read, or a vertex begins there */
    size_t braces;            /* opened, and to be closed after the last face */
    uint64_t vertices, faces; /* as declared: nothing is allocated for them */
} off_header;

struct off_division;

/* What the reader of OFF keeps besides. */
typedef struct off_state {
    off_header header;
    const struct off_division *division; /* into pieces for threads */
    unsigned tries_in_vain;              /* of pieces */
    size_t odd_colors, first_odd_color;  /* colours that make no sense, and the line of the first */
} off_state;

/* ---- off.c ----------------------------------------------------------------------------------------------------- */

/* Says that there are fewer faces than declared. */
void off_warn_fewer(reader *r, uint64_t found);

enum { COLOR_MOST = 4 };

/* The numbers of a colour as the file has them. */
typedef struct off_color_numbers {
    int count;
    bool real; /* one of them has a point or an exponent */
    double value[COLOR_MOST];
} off_color_numbers;

/* Colour the vertex, or the face, that was read last. A colour that makes no sense is counted and left out. */
roberts_status off_color_vertex(reader *r, const off_color_numbers *numbers);
roberts_status off_color_face(reader *r, const off_color_numbers *numbers);

/* What a message adds about a word that should be something else: commas between numbers, or in them, a negative
 * number;
 * "": nothing. */
const char *off_explain_word(const char *token, size_t length);

/* ---- the other parts ------------------------------------------------------------------------------------------- */

roberts_status off_read_header(reader *r);
roberts_status off_read_text(reader *r);
roberts_status off_read_binary(reader *r);

/* Whether a word is a keyword of OFF. */
bool off_is_keyword(const char *word, size_t length);

/* Whether a keyword comes next, perhaps after "{" or "{ =". What precedes it is taken. */
bool off_at_keyword(reader *r);

/* After an error: reads the text once more and adds which of its lines may be the reason, or says that this is no OFF.
 * After success: warns of a line in which a number seems to be missing. The reader's buffer is lost. */
void off_explain_error(reader *r);
void off_explain_warning(reader *r);

/* Warns of text after the last face: it is another model where it has a keyword, and the input is no OFF where it does
 * not look like one. */
void off_explain_rest(reader *r);

/* ---- plain lines (off_text.c) ---------------------------------------------------------------------------------- */

/* A plain line is a vertex or a face and nothing else, as nearly all lines of large files are: three numbers, or a
 * count of at most PLAIN_CORNERS and as many vertex numbers. Blanks (spaces and tabs) stand between them, perhaps
 * before and after them too; the line ends with LF or CR LF. It has no comment, no colour, and no vertex number of nine
 * digits. Whatever else comes ends the plain lines, and the reader that knows all forms goes on from there.
 *
 * `at` is the first character after a token, and the first line begins after the line end that follows it. The text
 * must end in 1 + NUMBER_PADDING zeros: a line that may go on beyond them is not taken. */
enum { PLAIN_CORNERS = 255 };

/* The character after the line end that follows blanks alone; NULL where something else comes. */
const char *plain_next_line(const char *at);

/* Reads at most `room` vertices; returns the character after the last token taken, and how many in *count. */
const char *plain_vertices(const char *at, roberts_vec3 *vertex, size_t room, size_t *count);

/* Where faces go. */
typedef struct plain_faces {
    uint32_t *corner; /* [corner_room] vertex numbers plus `first` */
    uint32_t *end;    /* [room] how many corners there are up to the end of each face */
    size_t corner_room, room;
    uint32_t first, limit;            /* vertex numbers of the file are below `limit` */
    size_t count, corner_count, thin; /* so far; faces with fewer than 3 corners */
} plain_faces;

/* Adds faces; returns the character after the last token taken. */
const char *plain_read_faces(const char *at, plain_faces *faces);

/* Above all vertex numbers of the file that plain lines can have: those have at most eight digits. */
static inline uint32_t off_index_limit(const reader *r)
{
    return r->off->header.vertices < UINT32_MAX ? (uint32_t)r->off->header.vertices : UINT32_MAX;
}

/* ---- pieces (off_pieces.c) ------------------------------------------------------------------------------------- */

/* What each of the threads, numbered from 0, does. */
typedef void off_work_fn(void *job, uint32_t thread);

/* Runs `work` on at most `threads` threads, and waits for them. */
typedef void off_run_fn(off_work_fn *work, void *job, uint32_t threads);

/* How the work is divided. Tests have values of their own. */
typedef struct off_division {
    uint32_t threads; /* 1: no pieces */
    size_t piece;     /* bytes of a piece */
    size_t overhang;  /* bytes that a piece's last line may have beyond the piece; at a longer line the pieces end */
    size_t least;     /* bytes left for each thread that make it worth while */
    off_run_fn *run;
} off_division;

/* Divides among `threads` threads (0: one per processor); inside a parallel region there is only one. */
off_division off_divide(uint32_t threads);

/* Reads on from the end of a vertex or face as far as pieces go, into the mesh; counts lines. `in` is then at the end
 * of a vertex or face again. Costs next to nothing where there is nothing to do. */
void off_read_pieces(reader *r);

#endif
