/* unite.h - covers of two fronts together.
 *
 * Where fronts overlap, the cells that their borders cross are covered by none of them alone. So each cell without a
 * cover remembers two fronts that leave little of it open: the one that reaches farthest beyond its middle, and the one
 * that reaches farthest beyond the corner where the first reaches least. Where both together leave nothing open the
 * cell is covered; and a solid of which they leave nothing open in any cell is hidden. */
#ifndef ROBERTS_HIDE_UNITE_H
#define ROBERTS_HIDE_UNITE_H

#include "hide/picture.h"

/* Lets the cells remember, from now on. False: no memory. */
bool unite_init(cover *c);

/* Offers a front, as unite_hides() has just looked at it and cover_add() entered it with the same scan, to the cells that it
 * does not cover. first_front: the first of those that this thread has entered. */
void unite_offer(hide_picture *picture, const scan *s, uint32_t front, uint32_t first_front);

/* Is a solid with this outline (numbers of view points) and no point nearer than z1 certainly hidden? */
bool unite_hides(const hide_picture *picture, scan *s, const uint32_t *corner, uint32_t count, float z1);

#endif
