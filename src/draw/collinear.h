/* collinear.h - the lines that pieces lie on. */
#ifndef ROBERTS_DRAW_COLLINEAR_H
#define ROBERTS_DRAW_COLLINEAR_H

#include <math.h>
#include <stddef.h>

#include "draw/chain.h"

/* One line with pieces on it. */
typedef struct page_line {
    double distance;       /* of its first piece from the middle of all pieces, without a sign */
    float near, direction; /* of its longest piece: distance without a sign, and direction */
    uint32_t longest;      /* piece */
    uint32_t count;        /* pieces */
    uint32_t hash;         /* of the cell that its first piece lies in */
    union {
        uint32_t next;  /* while pieces are sorted: the next line in its cell */
        uint32_t start; /* afterwards: of its pieces in `member` */
    };
} page_line;

typedef struct page_lines {
    page_line *item;
    uint32_t count;
    uint32_t most;    /* pieces on a line */
    uint32_t *member; /* the pieces of each line that has several; ascends */
} page_lines;

/* Sorts pieces to lines, in the order of the pieces. A line is represented by its longest piece; a piece joins the
 * first line found that it coincides with. `c` is released by collinear_free() in any case. False: no memory. */
bool collinear_find(page_lines *c, const pieces *p);

void collinear_free(page_lines *c);

static inline double piece_length(const piece *p)
{
    double x = p->b.x - p->a.x, y = p->b.y - p->a.y;
    return sqrt(x * x + y * y); /* three times as fast as hypot(); a page is far from overflow */
}

#endif
