/* cull.h - solids that are wholly hidden by covers. */
#ifndef ROBERTS_HIDE_CULL_H
#define ROBERTS_HIDE_CULL_H

#include "hide/picture.h"

/* Is the solid, of this box, certainly hidden by what is entered so far? */
bool cull_hides(const hide_picture *picture, const hide_box *box, uint32_t solid);

#endif
