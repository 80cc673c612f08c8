/* paper.h - what a file shows: the lines of an SVG or a PDF, and the pixels of a PNG, read back. */
#ifndef ROBERTS_TESTS_PAPER_H
#define ROBERTS_TESTS_PAPER_H

#include <stddef.h>
#include <stdint.h>

#include "roberts.h"

/* Classes of lines: those of roberts_line, the frame, the symbol of a sheet, hatching, and text. */
enum {
    PAPER_FRAME = ROBERTS_INTERSECTION + 1,
    PAPER_SYMBOL,
    PAPER_HATCH,
    PAPER_TEXT,
    PAPER_HIDDEN_TEXT,
    PAPER_CLASSES
};

/* A straight line of the pen, in mm from the upper left corner of the page, y down. */
typedef struct paper_line {
    roberts_vec2 a, b;
    int line;        /* class */
    uint32_t stroke; /* lines of one stroke are drawn without lifting the pen */
} paper_line;

typedef struct paper {
    paper_line *item;
    size_t count, room;
    uint32_t strokes;
} paper;

/* The colour that paper_options() gives a class, 0xRRGGBB. */
uint32_t paper_color(int line);

/* Default options with a different colour for each class. */
roberts_draw_options paper_options(void);

/* Read the lines of a file. False: no memory, or the file has a form that is not understood. A PDF has to be drawn with
 * the colours of paper_options(). */
bool paper_read_svg(paper *p, const char *bytes, size_t size);
bool paper_read_pdf(paper *p, const char *bytes, size_t size, double height_mm);
void paper_free(paper *p);

/* Pixels from the upper left corner, row by row, as 0xRRGGBB. */
typedef struct picture {
    uint32_t *pixel;
    int width, height;
} picture;

bool picture_read_png(picture *p, const char *bytes, size_t size);
void picture_free(picture *p);

#endif
