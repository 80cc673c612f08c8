/* check.h - holds what a page shows against the segments that it was drawn from. */
#ifndef ROBERTS_TESTS_CHECK_H
#define ROBERTS_TESTS_CHECK_H

#include <stdio.h>

#include "paper.h"

/* A segment that is drawn, where it has to lie on the page, in mm, cut to the field of view. */
typedef struct row {
    roberts_vec2 a, b;
    double za, zb; /* as in roberts_segment */
    int line;      /* class as which it is drawn: a hidden one is ROBERTS_BACK */
    uint32_t segment;
} row;

typedef struct row_list {
    row *item;
    size_t count, room;
    double epsilon;           /* of depths, model units */
    roberts_vec2 frame_mm[2]; /* upper left and lower right corner of the frame */
} row_list;

/* Places what is drawn of a drawing, or of the views of a sheet. Margins are no less than half of the widest pen.
 * False: no memory, or the sheet does not fit. */
bool rows_place(row_list *r, const roberts_drawing *drawing, const roberts_draw_options *options);
bool rows_place_sheet(row_list *r, const roberts_sheet *sheet, const roberts_draw_options *options);
void rows_free(row_list *r);

/* What was found. */
typedef struct findings {
    FILE *out;        /* the first few are described there; NULL: none */
    size_t missing;   /* rows of which a part is not drawn as it has to be */
    size_t unfounded; /* lines of which a part belongs to no row of their class */
    size_t twice;     /* lines drawn along another one */
    size_t pixels;    /* that are not dark, or dark, as they have to be */
} findings;

size_t findings_total(const findings *f);

/* Every row is covered by lines of its class within 0.01 mm, or where a nearer visible one lies on it, by lines of
 * that one's class; every line is covered by rows of its class; no two lines lie on one another. */
void check_lines(const row_list *r, const paper *p, const roberts_draw_options *options, findings *f);

/* Both have as much of lines, as far as the rounding of a PDF goes. */
bool check_same(const paper *p, const paper *q);

/* Pixels along rows have the colour of their class, and pixels with a colour lie near rows of it. */
void check_pixels(const row_list *r, const picture *p, const roberts_draw_options *options, findings *f);

#endif
