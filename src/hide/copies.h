/* copies.h - fronts of solids that lie at the very same place.
 *
 * Of copies of a solid one front is enough: a thousand of them would cost a million comparisons. */
#ifndef ROBERTS_HIDE_COPIES_H
#define ROBERTS_HIDE_COPIES_H

#include "hide/picture.h"

/* Sets `listed` of the picture's fronts, which are of whole solids: false of copies other than the first, which has the
 * smallest number, since a stable order of the keys brings them together. False: no memory. */
bool copies_leave_out(hide_picture *picture);

#endif
