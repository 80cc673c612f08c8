/* loose_ends.h - walks over the ends of the lines of a picture: where a line ends, others must lead on. */
#ifndef ROBERTS_TESTS_LOOSE_ENDS_H
#define ROBERTS_TESTS_LOOSE_ENDS_H

#include "roberts.h"

/* Ends this near to a line lie on it, as a part of the picture's diagonal. Twice the digits that models as text have
 * are lost where lines meet at small angles. */
#define LOOSE_END_NEAR 1e-7

/* An end at which no line leads on. */
typedef struct loose_end {
    size_t segment; /* of the drawing */
    int end;
} loose_end;

/* Finds the ends of visible segments, wires left out, at which all visible segments lead one and the same way. An end
 * may meet ends and insides of others. Where a segment is no longer than what counts as near, its ends are not asked.
 * Returns how many there are and fills the first `most`; SIZE_MAX: no memory. */
size_t loose_ends_find(const roberts_drawing *drawing, loose_end *found, size_t most, size_t *asked);

#endif
