/* chain.h - straight pieces on the page, and polylines made of them. */
#ifndef ROBERTS_DRAW_CHAIN_H
#define ROBERTS_DRAW_CHAIN_H

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

#include "roberts.h"

/* Two places of the page that are no farther apart than this count as one, in units of the page (0.001 mm). Pieces this
 * near are joined, lines this near coincide. Coordinates are rounded to as much anyway. It covers models given to six
 * digits (2e-4 mm on A4), and even the finest pen is 50 times as wide. */
#define PIECE_TOUCH 1.0

/* `line` of a piece that is no longer drawn. */
#define PIECE_GONE UINT8_MAX

typedef struct piece {
    roberts_vec2 a, b; /* units of the page, y down, not rounded */
    double za, zb;     /* greater is nearer, linear between a and b */
    uint32_t number;   /* place in the drawing; ascends */
    uint8_t line;      /* roberts_line: the class it is drawn as */
} piece;

typedef struct pieces {
    piece *item;
    size_t count;
    const uint32_t *part; /* by number: pieces of different parts are not joined; NULL: there is only one part */
} pieces;

/* A point of the page, in its units. */
typedef struct page_point {
    int32_t x, y;
} page_point;

/* Returns a point of the page, given in its units, in mm. */
static inline roberts_vec2 page_in_mm(roberts_vec2 p, double units_per_mm)
{
    return (roberts_vec2){p.x / units_per_mm, p.y / units_per_mm};
}

/* Rounds to the nearest whole unit, halves up. int32_t holds far more than a page. */
static inline int32_t page_round(double units)
{
    double up = units + 0.5;
    int32_t whole = (int32_t)up; /* no floor(), which is a call */
    return whole - (up < whole);
}

/* The point of the page nearest to a place in its units; to a place in mm. */
static inline page_point page_rounded(roberts_vec2 p)
{
    return (page_point){page_round(p.x), page_round(p.y)};
}

static inline page_point page_from_mm(roberts_vec2 mm, double units_per_mm)
{
    return page_rounded((roberts_vec2){mm.x * units_per_mm, mm.y * units_per_mm});
}

static inline bool page_is_same(page_point p, page_point q)
{
    return p.x == q.x && p.y == q.y;
}

/* The square of their distance. It is exact, because a page is less than 2^22 units wide. Square roots of two such
 * squares are in the same order as the squares. */
static inline double page_square(page_point p, page_point q)
{
    double x = (double)p.x - q.x, y = (double)p.y - q.y;
    return x * x + y * y;
}

static inline double page_distance(page_point p, page_point q)
{
    return sqrt(page_square(p, q));
}

/* Whether q lies exactly on the straight line from p to r. */
static inline bool page_is_between(page_point p, page_point q, page_point r)
{
    int64_t ax = q.x - (int64_t)p.x, ay = q.y - (int64_t)p.y, bx = r.x - (int64_t)q.x, by = r.y - (int64_t)q.y;
    return ax * by == ay * bx && ax * bx + ay * by > 0;
}

/* The cell of a coordinate, `size` units wide, and a neighbour that may hold places within PIECE_TOUCH of it. Returns
 * 2 if the neighbour may hold any, otherwise 1. */
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

/* A line drawn without lifting the pen: at least two points, neighbours differ. A closed one returns to its first
 * point. */
typedef struct polyline {
    uint32_t first, count; /* points */
    uint32_t number;       /* of the piece, if that is not chained; otherwise 0 */
    bool closed;
} polyline;

typedef struct polylines {
    page_point *point;
    polyline *item;
    size_t point_count, count, point_room, room;
} polylines;

/* Longer polylines are cut: Cairo outlines each one as a whole, which takes 6 kB of memory for a point. */
enum { CHAIN_POINTS_MAX = 5000 };

/* Appends the pieces of one class as polylines, so that no two of them end at one place. Ends within PIECE_TOUCH of
 * each other are one place. Where more than two pieces meet, the line continues as straight as possible. False: no
 * memory.
 */
bool chain_pieces(const pieces *p, roberts_line line, polylines *out);

/* The same in the order of the pieces. A polyline continues with the next piece if that starts or ends where it
 * ends. */
bool chain_in_order(const pieces *p, roberts_line line, polylines *out);

/* Makes a polyline of each piece by itself, with its number. */
bool chain_apart(const pieces *p, roberts_line line, polylines *out);

/* Begins a polyline; appends a point to the last one; the same, unless that ends there. False: no memory. */
bool polylines_start(polylines *p);
bool polylines_append(polylines *p, page_point at);
bool polylines_append_new(polylines *p, page_point at);

/* Appends a point, which replaces the last one if that lies on the straight line to it. False: no memory. */
bool polylines_extend(polylines *p, page_point at);

/* Appends the polylines first to end - 1 of `from`. False: no memory. */
bool polylines_copy(const polylines *from, size_t first, size_t end, polylines *out);

void polylines_free(polylines *p);

#endif
