/* overlap.h - no line is drawn twice. */
#ifndef ROBERTS_DRAW_OVERLAP_H
#define ROBERTS_DRAW_OVERLAP_H

#include "draw/chain.h"

/* Cuts pieces that lie on one another so that each place is drawn once: as hidden only where all of them are hidden
 * there, else as the class of the nearest visible one. Of several within `tie` (in the measure of za, zb) of it, an
 * outline is drawn rather than a crease. Then joins pieces of one class that lie on one line with no more than
 * PIECE_TOUCH between them. Pieces stay sorted by number; a joined one has the least of its parts' and runs as that
 * part does. False: no memory. */
bool overlap_remove(pieces *p, double tie);

#endif
