/* fills.h - what visible faces are filled with: regions of one colour, joined to rings on the page.
 *
 * A viewer that smooths the borders of two areas side by side lets the paper shine through between them: a hairline.
 * So seams lie below all areas: lines along their common borders, in the colour of one of the two. Where each region is
 * painted by itself, they lie below the borders of all.
 *
 * Plates in the colour of the paper lie above the areas, below letters that could not be read there. */
#ifndef ROBERTS_DRAW_FILLS_H
#define ROBERTS_DRAW_FILLS_H

#include "draw/chain.h"

struct strokes;

typedef struct fill_color {
    unsigned char red, green, blue, alpha; /* alpha: 0 is clear, 255 opaque */
} fill_color;

/* What is painted with one colour. */
typedef struct fill_paint {
    fill_color color;
    bool seam;         /* lines to be stroked, fills.seam_mm wide; otherwise rings to be filled */
    size_t first, end; /* of fills.lines */
    uint32_t body;     /* of the area; ROBERTS_NONE unless lines are grouped */
} fill_paint;

typedef struct fills {
    polylines lines;   /* rings are closed and are filled by the nonzero rule */
    fill_paint *paint; /* [count] in the order of painting: seams, then areas, each by body and colour; then plates */
    size_t count, room;
    size_t plates; /* where the plates begin */
    double seam_mm;
} fills;

/* Makes the fills of all views of a page, as its options say. `out` is released by fills_free() in any case. False: no
 * memory. */
bool fills_make(const struct strokes *s, fills *out);
void fills_free(fills *f);

/* The colour of a region, as the options say; alpha 0: it is left open. */
fill_color fills_color(const roberts_draw_options *options, const roberts_region *region);

/* A colour as it looks on the page's background, which is white where there is none; opaque. */
fill_color fills_on_paper(const roberts_draw_options *options, fill_color color);

#endif
