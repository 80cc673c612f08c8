/* plots.h - strokes and pens read back from the formats for other programs: TikZ, DXF and HP-GL/2. */
#ifndef ROBERTS_TESTS_PLOTS_H
#define ROBERTS_TESTS_PLOTS_H

#include <stdio.h>

#include "paper.h"

/* The pen of a class. */
typedef struct plot_pen {
    bool used; /* the class is in the file */
    bool dashed;
    double width_mm, down_mm, up_mm; /* down and up along a dashed line */
    uint32_t color;                  /* 0xRRGGBB; of DXF its number of a colour */
} plot_pen;

typedef struct plot {
    paper lines;
    plot_pen pen[PAPER_CLASSES];
} plot;

/* Read a page `height_mm` high. False: no memory, or the file has a form that is not understood. */
bool plot_read(plot *p, roberts_format format, const char *text, double height_mm);
void plot_free(plot *p);

/* Whether a file of `format` has the strokes of the SVG, in their order, class and direction, and its pens, as far as
 * the format knows them: points of TikZ and DXF to 0.0005 mm; those of HP-GL/2 are the SVG's, rounded to 0.025 mm. Says
 * on `out`, if not NULL, what differs. */
bool plot_is_same(const plot *svg, const plot *p, roberts_format format, double height_mm, FILE *out);

#endif
