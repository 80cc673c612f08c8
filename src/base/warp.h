/* warp.h - an axis warped so that what crowds in one place takes more room: a continuous, ascending map of an interval
 * to itself, made of straight pieces. All pieces are equally long after the map. */
#ifndef ROBERTS_BASE_WARP_H
#define ROBERTS_BASE_WARP_H

#include <stdbool.h>
#include <stddef.h>

#include "base/vec.h"

/* A power of two. */
#define WARP_PIECES 64

typedef struct warp {
    double from, piece;         /* where the interval begins; length of a piece after the map */
    double at[WARP_PIECES + 1]; /* where pieces begin before the map, ascending; at[WARP_PIECES]: the end */
    double per[WARP_PIECES];    /* 1 / the length of each piece before the map */
} warp;

/* Makes a map of low..high to itself. Half of its result is divided evenly over the interval, half over the `count`
 * values, which are in ascending order and inside the interval. Each piece is at least `least` long. False: the
 * interval is too short for that. */
bool warp_make(warp *w, double low, double high, const double *value, size_t count, double least);

/* Can warp_make() have made this map? For one read from a file. */
bool warp_is_sound(const warp *w);

/* The piece that x lies in. */
static inline unsigned warp_piece_of(const warp *w, double x)
{
    unsigned k = 0;
    for (unsigned step = WARP_PIECES / 2; step > 0; step /= 2)
        k += x >= w->at[k + step] ? step : 0;
    return k;
}

/* Maps x. If x < y, the result for x is at most that for y, whatever the rounding. */
static inline double warp_at(const warp *w, double x)
{
    unsigned k = warp_piece_of(w, x);
    return w->from + w->piece * (k + lesser((x - w->at[k]) * w->per[k], 1.0));
}

/* The inverse, but for rounding. */
static inline double warp_back(const warp *w, double x)
{
    double at = (x - w->from) / w->piece;
    unsigned k = (unsigned)lesser(greater(at, 0.0), WARP_PIECES - 1.0);
    return w->at[k] + (at - k) * (w->at[k + 1] - w->at[k]);
}

/* How many times longer the map makes what is near x. */
static inline double warp_stretch(const warp *w, double x)
{
    return w->piece * w->per[warp_piece_of(w, x)];
}

#endif
