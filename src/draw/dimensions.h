/* dimensions.h - dimensions on a sheet: of the whole scene, and between two vertices. */
#ifndef ROBERTS_DRAW_DIMENSIONS_H
#define ROBERTS_DRAW_DIMENSIONS_H

#include "draw/free_space.h"
#include "draw/sheet.h"
#include "draw/strokes.h"

/* Returns the space that dimensions need beside a view, mm. */
double dimensions_room(const roberts_draw_options *options);

/* Adds width, height and depth to s->notes, and the space that labels must avoid to s->taken. The sheet has been laid
 * out. False: no memory. */
bool dimensions_add(strokes *s);

/* Whether s->options ask for distances on a sheet. */
bool distances_wanted(const strokes *s);

/* What became of the distances. */
typedef struct distances_outcome {
    size_t poor;       /* how many have no room, or lie across lines */
    sheet_reach reach; /* of the others, with what they measure */
} distances_outcome;

/* Adds them to s->notes, and to `r`, the room of the page, which holds the lines of the views. A distance that no view
 * shows in true length, or for which there is no room, is left out with a warning. One that is a dimension of the
 * whole scene is not drawn again. Returns ROBERTS_OK, _NO_MEMORY or _BAD_ARGUMENT (a vertex is not there, or both are
 * at one place). */
roberts_status distances_add(strokes *s, free_space *r, distances_outcome *outcome, roberts_error *error);

/* Writes a number rounded to five digits, or to a whole one if that has more, with a comma (ISO 129-1). */
void dimension_text(double value, const char *unit, char *text, size_t size);

#endif
