/* carrier.h - the lines that pieces lie on. */
#ifndef ROBERTS_DRAW_CARRIER_H
#define ROBERTS_DRAW_CARRIER_H

#include <math.h>
#include <stddef.h>

#include "draw/piece.h"

/* One line with pieces on it. */
typedef struct carrier {
    double distance;       /* of its first piece from the middle of all, with no sign */
    float near, direction; /* of its longest piece: distance with no sign, and direction */
    uint32_t longest;      /* piece */
    uint32_t count;        /* pieces */
    uint32_t hash;         /* of the cell that its first piece lies in */
    uint32_t start;        /* of its pieces in `member`; while they are sorted, the next line in its cell */
} carrier;

typedef struct carriers {
    carrier *item;
    uint32_t count;
    uint32_t most;    /* pieces on a line */
    uint32_t *member; /* the pieces of each line that has several; ascends */
} carriers;

/* Sorts pieces to lines, in their order: a piece belongs to the first line found that it coincides with, and its longest
 * piece stands for a line. `c` is released by carriers_free() in any case. False: no memory. */
bool carriers_find(carriers *c, const pieces *p);

void carriers_free(carriers *c);

static inline double piece_length(const piece *p)
{
    double x = p->b.x - p->a.x, y = p->b.y - p->a.y;
    return sqrt(x * x + y * y); /* three times as fast as hypot(); a page is far from overflow */
}

#endif
