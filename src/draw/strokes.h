/* strokes.h - what the pen does: polylines by class, on the page, in the order in which they are drawn. */
#ifndef ROBERTS_DRAW_STROKES_H
#define ROBERTS_DRAW_STROKES_H

#include "draw/chain.h"
#include "draw/page.h"

/* The border of the picture or of what the margins leave, and the symbol of a sheet: classes of their own beside
 * those of roberts_line. */
#define LINE_FRAME ((roberts_line)(ROBERTS_WIRE + 1))
#define LINE_SYMBOL ((roberts_line)(ROBERTS_WIRE + 2))

/* Hidden lines lie undermost, outlines on top, frame and symbol over all. */
enum { LINE_CLASSES = 7 };
static const roberts_line line_order[LINE_CLASSES] = {ROBERTS_BACK,    ROBERTS_WIRE, ROBERTS_CREASE, ROBERTS_BORDER,
                                                      ROBERTS_OUTLINE, LINE_FRAME,   LINE_SYMBOL};

/* Points are rounded to the page's unit, 0.001 mm (0.01 mm where the page is longer than 4 m): far finer than a pen,
 * short to write, and the same for neighbours that share an end. */
typedef struct strokes {
    const roberts_draw_options *options;
    page_map map; /* of a sheet: of its front view */
    double units_per_mm;
    const roberts_sheet *sheet; /* NULL: a single drawing */
    double symbol;              /* size of its symbol, as a part of the full one; 0: there is none */
    roberts_vec2 symbol_mm;     /* lower right corner of it */
    roberts_vec2 frame_mm[2];   /* upper left and lower right corner of the frame */
    polylines lines;
    size_t start[LINE_CLASSES + 1]; /* class line_order[i] has the polylines start[i] .. start[i + 1] - 1 */
} strokes;

/* Lays the drawing on the page and makes strokes of it. It is laid there by the box of what is drawn. A field of view
 * is laid there by its window, made to the page's shape, and all is cut to it. `s` is released by strokes_free() in
 * any case. Returns ROBERTS_OK, _NO_MEMORY or _BAD_ARGUMENT (a scale at which the drawing leaves the page, too many
 * dashes). `options` have been checked. */
roberts_status strokes_make(strokes *s, const roberts_drawing *drawing, const roberts_draw_options *options,
                            roberts_error *error);
/* The same with the views of a sheet, and with its symbol. */
roberts_status strokes_make_sheet(strokes *s, const roberts_sheet *sheet, const roberts_draw_options *options,
                                  roberts_error *error);
void strokes_free(strokes *s);

/* The pen for a class of lines. Segments in state hidden are of class ROBERTS_BACK here, whatever their edge is. */
const roberts_pen *strokes_pen(const roberts_draw_options *options, roberts_line line);

/* Fills `dash` with the lengths in mm of pen down and pen up along a line of class `line`; false where it is
 * unbroken, or its dashes are strokes of their own. A round cap adds half of the width to both ends of a dash, so pen
 * down is shorter than what is seen by the width, and a dash no longer than that is a dot. */
bool strokes_dash(const roberts_draw_options *options, roberts_line line, double dash[2]);

/* How often and how far the pen goes. */
roberts_ink strokes_measure(const strokes *s);

#endif
