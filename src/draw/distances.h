/* distances.h - dimensions between two vertices of a sheet's scene. */
#ifndef ROBERTS_DRAW_DISTANCES_H
#define ROBERTS_DRAW_DISTANCES_H

#include "draw/title_block.h"

/* Adds the distances that s->options ask for to s->notes. The lines of the views are in s->lines already. A distance
 * that no view shows in true length, or for which there is no room, is left out with a warning. Returns ROBERTS_OK,
 * _NO_MEMORY or _BAD_ARGUMENT (a vertex is not there, or both are at one place). */
roberts_status distances_add(strokes *s, roberts_error *error);

#endif
