/* read.h - shared by the readers of all formats. */
#ifndef ROBERTS_READ_READ_H
#define ROBERTS_READ_READ_H

#include "roberts.h"

#include <string.h>

#include "base/error.h"
#include "read/input.h"
#include "read/mesh.h"

/* Binary STL, bytes: a header, the number of triangles, the triangles. */
enum { STL_HEADER = 80, STL_FIRST = STL_HEADER + 4, STL_TRIANGLE = 50 };

struct off_division;
struct off_state;

typedef struct reader {
    input in;
    roberts_mesh *mesh;
    mesh_mark mark;   /* the mesh before this input */
    const char *name; /* what messages call the input */
    const roberts_warnings *warnings;
    roberts_error *error;
    bool binary;                          /* errors name bytes, not lines */
    size_t vertices_filled, faces_filled; /* colours are set up to here */
    size_t thin_faces;                    /* with fewer than 3 corners, and not meant as a line */
    struct off_state *off;                /* used by the OFF reader */
} reader;

/* Reads one input of any format; see roberts_mesh_read(). division: how OFF is divided among threads. */
roberts_status read_mesh(roberts_mesh *mesh, const char *name, const input_source *source,
                         const struct off_division *division, const roberts_warnings *warnings, roberts_error *error);

/* The readers. The input is at its first byte, or after the byte-order mark; for OBJ, at its first word. On failure
 * they may leave anything in the mesh after r->mark. */
roberts_status off_read(reader *r, const struct off_division *division);
roberts_status stl_read_text(reader *r);
roberts_status stl_read_binary(reader *r);
roberts_status obj_read(reader *r);
roberts_status ply_read(reader *r);

/* ---- errors ---------------------------------------------------------------------------------------------------- */

/* Fills the error, with the current line or, in a binary file, the current byte. Returns `status`. */
roberts_status read_fail(reader *r, roberts_status status, const char *format, ...) ROBERTS_PRINTF(3, 4);

/* Does the same if the input lacks what `format` names; see input_expected(). A binary input is then at its end. */
roberts_status read_expected(reader *r, roberts_status status, const char *format, ...) ROBERTS_PRINTF(3, 4);

/* Refuses the input, which is of that format. command: converts it, or "". */
roberts_status read_refuse_format(reader *r, const char *format, const char *command);

/* Refuses the input if the word here, of that length, begins a format that cannot be read. The message names the
 * format, and a command that converts it. ROBERTS_OK: no such format is known. */
roberts_status read_refuse_foreign(reader *r, size_t length);

/* Warns that `count` colours, the first of them in line `line`, are ignored; not if there are none. */
void read_warn_colors(const roberts_warnings *warnings, const char *name, size_t line, size_t count);

/* ---- text, word by word ---------------------------------------------------------------------------------------- */

/* Reads the rest of the line as one name: its words separated by one blank, truncated to `room` - 1 characters. */
void read_rest(reader *r, char *text, size_t room);

/* ---- binary ---------------------------------------------------------------------------------------------------- */

static inline uint32_t read_word(const char *bytes, bool little)
{
    const unsigned char *b = (const unsigned char *)bytes;
    return little ? (uint32_t)b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24
                  : (uint32_t)b[3] | (uint32_t)b[2] << 8 | (uint32_t)b[1] << 16 | (uint32_t)b[0] << 24;
}

static inline float read_float(const char *bytes, bool little)
{
    uint32_t word = read_word(bytes, little);
    float value;
    memcpy(&value, &word, sizeof value);
    return value;
}

/* Reports a coordinate that is infinite, not a number, or too large: vertex number `v` of the file. */
roberts_status read_bad_position(reader *r, uint64_t v);

#endif
