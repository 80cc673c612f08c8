/* labels.h - numbers and names beside vertices and edges, and in faces and bodies. */
#ifndef ROBERTS_DRAW_LABELS_H
#define ROBERTS_DRAW_LABELS_H

#include "draw/free_space.h"
#include "draw/notes.h"
#include "draw/sheet.h"
#include "draw/strokes.h"

/* Whether s->options ask for any. */
bool labels_wanted(const strokes *s);

/* Adds these labels to s->notes and their boxes to `taken`, for all views. `r` is the room of the page as it is now. If
 * there is room beside what a label names, it lies on no other label, on no line, and on none of the boxes `taken`. The
 * same input gives the same places. False: no memory. */
bool labels_add(strokes *s, free_space *r);

/* The page with these lines but no hatching, with the lines of notes, and with the boxes `taken`. Released by
 * space_free(). NULL: no memory. */
free_space *labels_room(const strokes *s, const pieces *p, const polylines *lines);

/* Whether there are labels of vertices or edges, which stand beside these. */
bool labels_stand_beside(const roberts_draw_options *options);

/* Makes room for labels beside a drawing that is to be fitted into the margins of `page`: widens its box from `min` to
 * `max` so that, once this box is fitted, labels of vertices and edges have room in their best places. False: no
 * memory. */
bool labels_make_room(const roberts_drawing *drawing, const roberts_draw_options *options, const roberts_page *page,
                      roberts_vec2 *min, roberts_vec2 *max);

/* Enlarges `reach` by the labels of vertices and edges in their best places, on a sheet that has been laid out. False:
 * no memory. */
bool labels_add_reach(const strokes *s, sheet_reach *reach);

/* How far from the window of a drawing labels may reach where all pictures of a series have one window, mm; 0: there
 * are none beside it. */
double labels_reach(const roberts_draw_options *options);

#endif
