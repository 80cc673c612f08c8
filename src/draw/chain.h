/* chain.h - straight pieces on the page, and polylines made of them. */
#ifndef ROBERTS_DRAW_CHAIN_H
#define ROBERTS_DRAW_CHAIN_H

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

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

/* A point of the page, in its units. */
typedef struct page_point {
    int32_t x, y;
} page_point;

/* Rounds to the nearest whole unit, halves up. int32_t holds far more than a page. */
static inline int32_t page_round(double units)
{
    double up = units + 0.5;
    int32_t whole = (int32_t)up; /* no floor(), which is a call */
    return whole - (up < whole);
}

/* The square of their distance. It is exact, because a page is less than 2^22 units wide. Square roots of two such
 * numbers are in the same order as the numbers. */
static inline double page_square(page_point p, page_point q)
{
    double x = (double)p.x - q.x, y = (double)p.y - q.y;
    return x * x + y * y;
}

static inline double page_distance(page_point p, page_point q)
{
    return sqrt(page_square(p, q));
}

/* The cell of a coordinate, `size` units wide, and a neighbour that may hold what is within PIECE_TOUCH of it.
 * Returns how many of both have to be looked into: 1 or 2. */
static inline int page_cells(int32_t value, int32_t size, int32_t cell[2])
{
    int32_t in = ((value % size) + size) % size;
    cell[0] = (value - in) / size;
    cell[1] = in == 0 ? cell[0] - 1 : cell[0] + 1;
    return in == 0 || in == size - 1 ? 2 : 1;
}

/* Whether two rounded ends are one place. */
static inline bool page_touches(page_point p, page_point q)
{
    return llabs((int64_t)p.x - q.x) <= (int64_t)PIECE_TOUCH && llabs((int64_t)p.y - q.y) <= (int64_t)PIECE_TOUCH;
}

/* What the pen draws without being lifted: at least two points, neighbours differ. A closed one goes on to its first
 * point. */
typedef struct polyline {
    uint32_t first, count; /* points */
    bool closed;
} polyline;

typedef struct polylines {
    page_point *point;
    polyline *item;
    size_t point_count, count, point_room, room;
} polylines;

/* Longer ones are cut: Cairo outlines each as a whole, which takes 6 kB of memory a point. */
enum { CHAIN_POINTS_MAX = 5000 };

/* Appends the pieces of one class as polylines: as few as their ends allow. Ends within PIECE_TOUCH of each other are
 * one place. Where more than two meet, the line goes on as straight as it can. False: no memory. */
bool chain_pieces(const pieces *p, roberts_line line, polylines *out);

/* The same in the order of the pieces. A polyline goes on with the next piece where that starts or ends at its end. */
bool chain_in_order(const pieces *p, roberts_line line, polylines *out);

/* Begins a polyline; appends a point to the last one. False: no memory. */
bool polylines_start(polylines *p);
bool polylines_append(polylines *p, page_point at);

void polylines_free(polylines *p);

#endif
