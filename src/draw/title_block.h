/* title_block.h - text on a sheet: its title block, and the zones of its frame. */
#ifndef ROBERTS_DRAW_TITLE_BLOCK_H
#define ROBERTS_DRAW_TITLE_BLOCK_H

#include "draw/strokes.h"

/* mm, of the title block */
#define BLOCK_WIDTH 180.0
#define BLOCK_HEIGHT 27.0

/* mm: how far the centring marks of zones run into the frame */
#define CENTRE_MARK 5.0

/* Whether the sheet has a title block: there is a title or a field. */
bool title_block_is_wanted(const roberts_draw_options *options);

/* Each adds lines and text to s->notes, and the boxes that labels must avoid to s->taken. The sheet has been laid out.
 * False: no memory. */
bool title_block_add(strokes *s);
bool zones_add(strokes *s); /* also of a single drawing */

/* Where the symbol lies in a title block: its lower right corner, from that of the block, and its size. */
roberts_vec2 title_block_symbol(double *size);

#endif
