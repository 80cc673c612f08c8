/* stars.h - vertices about which all faces are one sheet in the picture.
 *
 * The star of a vertex is all faces at it. Let each of its edges there have one face on its left in the picture and one
 * on its right, let the faces go round the vertex once, and let no side of a face run through it. Then no two of them
 * lie over one another, and two of them have nothing in common in the picture but the vertex or a side. */
#ifndef ROBERTS_HIDE_STARS_H
#define ROBERTS_HIDE_STARS_H

#include "hide/fronts.h"

/* Finds such vertices of triangles of surfaces. *sheet, [vertices]: 1 where it is one, else 0; NULL: none is known.
 * False: no memory. */
bool stars_find(const hide_fronts *fronts, int threads, unsigned char **sheet);

#endif
