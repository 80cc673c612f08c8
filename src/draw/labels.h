/* labels.h - numbers and names beside vertices and edges, and in faces and bodies. */
#ifndef ROBERTS_DRAW_LABELS_H
#define ROBERTS_DRAW_LABELS_H

#include "draw/free_space.h"
#include "draw/notes.h"
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

#endif
