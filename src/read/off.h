/* off.h - shared by the parts of the OFF reader.
 *
 * off.c          the driver: the order of the parts; keyword, dimension, counts; colours
 * off_text.c     vertices and faces as text
 * off_pieces.c   large texts by several threads
 * off_binary.c   vertices and faces as 32-bit words
 * off_explain.c  messages about a faulty file */
#ifndef ROBERTS_READ_OFF_H
#define ROBERTS_READ_OFF_H

#include "read/read.h"

/* Everything before the vertices. */
typedef struct off_header {
    bool texture, color, normal, homogeneous, dimension; /* prefixes ST, C, N, 4, n */
    bool binary;
    bool bare;                /* no keyword */
    size_t line;              /* where the counts end; 0: not yet read, or a vertex begins on the same line */
    size_t braces;            /* open braces, to be closed after the last face */
    uint64_t vertices, faces; /* as declared: nothing is allocated for them */
} off_header;

struct off_division;

/* A vertex or a face, and the line where it begins; line 0: none. */
typedef struct off_place {
    size_t line;
    uint64_t number;
} off_place;

/* State of the OFF reader besides `reader`. */
typedef struct off_state {
    off_header header;
    const struct off_division *division; /* how to divide the text into pieces for threads */
    unsigned tries_in_vain;              /* to read pieces */
    size_t odd_colors, first_odd_color;  /* number of invalid colours, and the line of the first */
    off_place uneven;                    /* the first vertex that does not end with its line */
    off_place short_face;                /* the first face that seems to end within the line of the next */
    bool runs_on;                        /* the first face begins on the line of a vertex */
} off_state;

/* ---- off.c ----------------------------------------------------------------------------------------------------- */

/* Returns how many faces were read. */
static inline uint64_t off_faces_read(const reader *r)
{
    return r->mesh->face_count - r->mark.faces;
}

/* Returns how many faces have no corners. Elements of one corner or two are points and lines, which OFF may hold. */
size_t off_count_empty(const reader *r);

/* How many numbers each part of a vertex has. */
enum { POSITION = 3, NORMAL = 3, TEXTURE = 2, COLOR_MOST = 4 };

/* The numbers of a colour as in the file. */
typedef struct off_color_numbers {
    int count;
    bool real; /* one of them has a point or an exponent */
    double value[COLOR_MOST];
} off_color_numbers;

/* Colour the vertex, or the face, that was read last. An invalid colour is counted and left out. */
roberts_status off_color_vertex(reader *r, const off_color_numbers *numbers);
roberts_status off_color_face(reader *r, const off_color_numbers *numbers);

/* Returns an addition to a message about a wrong word: about commas between or in numbers, or a negative number; "":
 * nothing. */
const char *off_explain_word(const char *token, size_t length);

/* Is this word a keyword of OFF? */
bool off_is_keyword(const char *word, size_t length);

/* Does a keyword come next, perhaps after "{" or "{ ="? Takes whatever precedes it. */
bool off_at_keyword(reader *r);

/* ---- the other parts ------------------------------------------------------------------------------------------- */

roberts_status off_read_text(reader *r);
roberts_status off_read_binary(reader *r);

/* After an error: reads the text again, and adds to the message the line that may be the reason, or says that this is
 * not OFF. After success: warns of a line in which a number seems to be missing. The contents of the reader's buffer
 * are lost. */
void off_explain_error(reader *r);
void off_explain_warning(reader *r);

/* Warns of text after the last face. If it has a keyword, it is another model; if it does not look like OFF, the input
 * is not OFF. */
void off_explain_rest(reader *r);

/* ---- plain lines (off_text.c) ---------------------------------------------------------------------------------- */

/* A plain line is a vertex or a face and nothing else, like nearly all lines of large files: three numbers, or a count
 * of at most PLAIN_CORNERS and that many vertex numbers. They are separated by blanks (spaces and tabs), and there may
 * be blanks before and after them. The line ends with LF or CR LF. It has no comment, no colour, and no vertex number
 * of nine digits. Anything else ends the plain lines, and the general reader continues from there.
 *
 * `at` is the first character after a token, and the first line begins after the next line end. The text must end in 1
 * + NUMBER_PADDING zeros: a line that may continue beyond them is not taken. */
enum { PLAIN_CORNERS = 255 };

/* Returns the character after a line end that only blanks precede; NULL: something else comes first. */
const char *plain_next_line(const char *at);

/* Reads at most `room` vertices, and sets *count. Returns the character after the last token taken. */
const char *plain_vertices(const char *at, roberts_vec3 *vertex, size_t room, size_t *count);

/* Where the faces read are stored. */
typedef struct plain_faces {
    uint32_t *corner; /* [corner_room] vertex numbers plus `first` */
    uint32_t *end;    /* [room] total number of corners up to the end of each face */
    size_t corner_room, room;
    uint32_t first, limit;            /* vertex numbers of the file are below `limit` */
    size_t count, corner_count, thin; /* so far; thin: faces with fewer than 3 corners */
} plain_faces;

/* Adds faces. Returns the character after the last token taken. */
const char *plain_read_faces(const char *at, plain_faces *faces);

/* Returns a bound above all vertex numbers that plain lines can have, which have at most eight digits. */
static inline uint32_t off_index_limit(const reader *r)
{
    return r->off->header.vertices < UINT32_MAX ? (uint32_t)r->off->header.vertices : UINT32_MAX;
}

/* ---- pieces (off_pieces.c) ------------------------------------------------------------------------------------- */

/* The work of one thread; threads are numbered from 0. */
typedef void off_work_fn(void *job, uint32_t thread);

/* Runs `work` on at most `threads` threads, and waits for them. */
typedef void off_run_fn(off_work_fn *work, void *job, uint32_t threads);

/* How the work is divided. Tests use their own values. */
typedef struct off_division {
    uint32_t threads; /* 1: no pieces */
    size_t piece;     /* bytes of a piece */
    size_t overhang;  /* bytes by which a piece's last line may exceed the piece; a longer line ends the pieces */
    size_t least;     /* least remaining bytes for each thread that make it worthwhile */
    off_run_fn *run;
} off_division;

/* Divides the work among `threads` threads (0: one per processor); inside a parallel region there is only one. */
off_division off_divide(uint32_t threads);

/* Reads on from the end of a vertex or face as far as pieces go, into the mesh; counts lines. Afterwards `in` is again
 * at the end of a vertex or face. Costs almost nothing if there is nothing to do. */
void off_read_pieces(reader *r);

#endif
