/* check.h - compares what a page shows with the segments that it was drawn from. */
#ifndef ROBERTS_TESTS_CHECK_H
#define ROBERTS_TESTS_CHECK_H

#include <stdio.h>

#include "paper.h"

/* A drawn segment, cut to the field of view: where it has to lie on the page, in mm. */
typedef struct row {
    roberts_vec2 a, b;
    double za, zb; /* as in roberts_segment */
    int line;      /* the class it is drawn as: ROBERTS_BACK if hidden */
    uint32_t segment;
} row;

typedef struct row_list {
    row *item;
    size_t count, room;
    double epsilon;           /* of depths, model units */
    roberts_vec2 frame_mm[2]; /* upper left and lower right corner of the frame */
} row_list;

/* Place what is drawn of a drawing, or of the views of a sheet. Margins are at least half of the widest pen.
 * False: no memory, or the sheet does not fit. */
bool rows_place(row_list *r, const roberts_drawing *drawing, const roberts_draw_options *options);
bool rows_place_sheet(row_list *r, const roberts_sheet *sheet, const roberts_draw_options *options);
void rows_free(row_list *r);

/* What was found. */
typedef struct findings {
    FILE *out;        /* the first few are described there; NULL: none */
    size_t missing;   /* rows with a part that is not drawn as it has to be */
    size_t unfounded; /* lines with a part that belongs to no row of their class */
    size_t twice;     /* lines drawn along another line */
    size_t pixels;    /* rows without their pixels, and pixels without a row */
} findings;

size_t findings_total(const findings *f);

/* Checks three rules. Lines of its class cover every row within 0.01 mm; where a nearer visible row lies on it, lines
 * of that row's class do. Rows of its class cover every line. No two lines lie on one another. */
void check_lines(const row_list *r, const paper *p, const roberts_draw_options *options, findings *f);

/* Whether the lines of both have the same total length, but for the rounding of a PDF. */
bool check_same(const paper *p, const paper *q);

/* Checks that pixels along rows have the colour of their class, and that coloured pixels lie near such rows. */
void check_pixels(const row_list *r, const picture *p, const roberts_draw_options *options, findings *f);

#endif
