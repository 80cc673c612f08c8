/* off_plain.h - plain lines: a vertex or a face each, as nearly all lines of large files are.
 *
 * Three numbers, or a count of at most PLAIN_CORNERS and as many vertex numbers; between them blanks (spaces and tabs),
 * before and after them blanks too; the line ends with LF or CR LF. No comments, no colours, no vertex numbers of nine
 * digits. What is taken here means what off_text.c would make of it; where anything else stands, the plain lines
 * end, and the reader that knows all forms goes on from there.
 *
 * `at` is the first character after a token, and the first line begins after the line end that follows it. The text ends in
 * 1 + NUMBER_PADDING zeros, so that a line that may go on beyond them is not taken. */
#ifndef ROBERTS_MODEL_OFF_PLAIN_H
#define ROBERTS_MODEL_OFF_PLAIN_H

#include "roberts.h"

enum { PLAIN_CORNERS = 255 };

/* The character after the line end that follows blanks only; NULL where something else does. */
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

#endif
