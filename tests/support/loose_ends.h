/* loose_ends.h - examines the ends of the lines of a picture: where a line ends, others must continue. */
#ifndef ROBERTS_TESTS_LOOSE_ENDS_H
#define ROBERTS_TESTS_LOOSE_ENDS_H

#include "roberts.h"

/* Fraction of the picture's diagonal: ends this near to a line lie on it. Coordinates in text models are rounded, and
 * lines that meet at small angles amplify the error. */
#define LOOSE_END_NEAR 1e-7

/* An end at which no line continues. */
typedef struct loose_end {
    size_t segment; /* index in the drawing */
    int end;
} loose_end;

/* Finds the ends of visible segments, except wires, at which all visible segments lead in the same direction. An end
 * may meet ends and insides of others. Ends of segments shorter than the nearness limit are not examined; *asked counts
 * the others. Returns the number of loose ends and fills in the first `most`; SIZE_MAX: no memory. */
size_t loose_ends_find(const roberts_drawing *drawing, loose_end *found, size_t most, size_t *asked);

#endif
