/* piece.h - straight pieces on the page, on their way from segments to strokes. */
#ifndef ROBERTS_DRAW_PIECE_H
#define ROBERTS_DRAW_PIECE_H

#include "roberts.h"

/* Two places of the page nearer to each other than this, in its units of 0.001 mm, are one: pieces farther apart by no
 * more are joined, lines farther apart by no more coincide. It is what coordinates are rounded to anyway, and takes in
 * models given to six digits (2e-4 mm on A4); no pen is finer than 50 times this. */
#define PIECE_TOUCH 1.0

/* `line` of what is drawn no more. */
#define PIECE_GONE UINT8_MAX

typedef struct piece {
    roberts_vec2 a, b; /* units of the page, y down, not rounded */
    double za, zb;     /* greater is nearer, linear between a and b */
    uint32_t number;   /* rank in the drawing; ascends */
    uint8_t line;      /* roberts_line: the class it is drawn as */
} piece;

typedef struct pieces {
    piece *item;
    size_t count;
} pieces;

#endif
