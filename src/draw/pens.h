/* pens.h - the classes of lines on a page: their order, pens, dashes, names and numbers. */
#ifndef ROBERTS_DRAW_PENS_H
#define ROBERTS_DRAW_PENS_H

#include "roberts.h"

/* Additional classes besides those of roberts_line: the border of the picture or of the area within the margins, the
 * symbol of a sheet, hatching, text and its lines, and labels of what is hidden. */
#define LINE_FRAME ((roberts_line)(ROBERTS_BACK_OUTLINE + 1))
#define LINE_SYMBOL ((roberts_line)(ROBERTS_BACK_OUTLINE + 2))
#define LINE_HATCH ((roberts_line)(ROBERTS_BACK_OUTLINE + 3)) /* strokes on faces */
#define LINE_TEXT ((roberts_line)(ROBERTS_BACK_OUTLINE + 4))
#define LINE_HIDDEN_TEXT ((roberts_line)(ROBERTS_BACK_OUTLINE + 5))

/* From the lowest class to the highest. */
enum { LINE_CLASSES = 11 };
static const roberts_line line_order[LINE_CLASSES] = {
    LINE_HATCH, ROBERTS_BACK, ROBERTS_WIRE, ROBERTS_INTERSECTION, ROBERTS_CREASE, ROBERTS_BORDER, ROBERTS_OUTLINE,
    LINE_FRAME, LINE_SYMBOL,  LINE_TEXT,    LINE_HIDDEN_TEXT};

/* The pen for a class of lines. Segments in state hidden are of class ROBERTS_BACK here, whatever their edge is. */
const roberts_pen *pens_of(const roberts_draw_options *options, roberts_line line);

/* Fills `dash` with the lengths in mm for which the pen is down and up along a line of class `line`. False: the line is
 * unbroken, or its dashes are strokes of their own. A round cap adds half of the width to each end of a dash. So the
 * pen is down for a dash less a width, and a dash no longer than the width is a dot. */
bool pens_dash(const roberts_draw_options *options, roberts_line line, double dash[2]);

/* "outline", "hidden", ...: what a class is called in files. */
const char *pens_class_name(roberts_line line);

/* The number of a class if layers and pens are numbered: that of its pen, or else the same in every drawing, from 1,
 * the lowest first, but hatching has 9. */
uint32_t pens_class_number(const roberts_draw_options *options, roberts_line line);

/* Are lines of this class dashed, by a dash pattern or by strokes of their own? */
bool pens_is_broken(const roberts_draw_options *options, roberts_line line);

/* Has a class a place on the page? Not that of hidden lines if they are not wanted, nor that of a hatching that is
 * not. */
bool pens_has_place(const roberts_draw_options *options, roberts_line line);

#endif
