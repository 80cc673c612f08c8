/* strokes.h - what the pen does: which segments are drawn with which pen, and from where to where on the page. */
#ifndef ROBERTS_DRAW_STROKES_H
#define ROBERTS_DRAW_STROKES_H

#include "draw/page.h"

/* Ends are rounded to the page's unit, 0.001 mm (0.01 mm where the page is longer than 4 m): far finer than a pen,
 * short to write, and the same for neighbours that share an end. */
typedef struct strokes {
    const roberts_drawing *drawing;
    const roberts_draw_options *options;
    page_map map;
    double units_per_mm;
} strokes;

typedef struct stroke {
    roberts_vec2 a, b; /* integers, in units of the page */
} stroke;

/* Hidden lines lie undermost, outlines on top. */
enum { LINE_CLASSES = 3 };
static const roberts_line line_order[LINE_CLASSES] = {ROBERTS_BACK, ROBERTS_CREASE, ROBERTS_OUTLINE};

/* Places the drawing on the page: what is to be drawn is fitted. `options` have been checked. */
strokes strokes_prepare(const roberts_drawing *drawing, const roberts_draw_options *options);

/* The pen for a class of lines. Segments in state hidden are of class ROBERTS_BACK here, whatever their edge is. */
const roberts_pen *strokes_pen(const roberts_draw_options *options, roberts_line line);

/* Fills `dash` with the lengths in mm of pen down and pen up along a line of class `line`; false where it is unbroken.
 * A round cap adds half of the width to both ends of a dash, so pen down is shorter than what is seen by the width, and
 * a dash no longer than that is a dot. */
bool strokes_dash(const roberts_draw_options *options, roberts_line line, double dash[2]);

/* The next stroke of class `line` at or after segment `*at`, which moves behind it; false: there is none. What is of
 * length 0 once rounded is no stroke. */
bool strokes_next(const strokes *s, roberts_line line, size_t *at, stroke *out);

#endif
