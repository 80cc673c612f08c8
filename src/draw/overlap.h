/* overlap.h - no line is drawn twice. */
#ifndef ROBERTS_DRAW_OVERLAP_H
#define ROBERTS_DRAW_OVERLAP_H

#include "draw/chain.h"

/* Cuts pieces that lie on one another, so that each place is drawn once: as hidden if all pieces there are hidden,
 * otherwise as the class of the nearest visible one. If several are within `tie` (unit of za, zb) of the nearest, an
 * outline wins over a crease, and so on. Then joins pieces of one class and part that lie on one line with no more than
 * PIECE_TOUCH between them. Pieces stay sorted by number. A joined piece takes the number and the direction of that
 * part which has the least number. False: no memory. */
bool overlap_remove(pieces *p, double tie);

#endif
