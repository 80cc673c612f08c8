/* warp.c - see warp.h. */
#include "base/warp.h"

#include <math.h>

/* Puts the pieces where the map that is wanted takes the values k / WARP_PIECES. That map is straight between low, the
 * values and high. */
static void divide_axis(warp *w, double low, double high, const double *value, size_t count)
{
    double last = low, reached = 0.0;
    size_t i = 0;
    w->at[0] = low;
    for (int k = 1; k < WARP_PIECES; k++) {
        const double wanted = (double)k / WARP_PIECES;
        for (;; i++) {
            double next = i < count ? value[i] : high;
            double by =
                i < count ? 0.5 * (next - low) / (high - low) + 0.5 * ((double)i + 1.0) / ((double)count + 1.0) : 1.0;
            if (by >= wanted || i == count) {
                w->at[k] = by > reached ? last + (next - last) * (wanted - reached) / (by - reached) : next;
                break;
            }
            last = next;
            reached = by;
        }
    }
    w->at[WARP_PIECES] = high;
}

bool warp_make(warp *w, double low, double high, const double *value, size_t count, double least)
{
    w->from = low;
    w->piece = (high - low) / WARP_PIECES;
    if (!(w->piece >= 2.0 * least) || !(w->piece > 0.0))
        return false;
    divide_axis(w, low, high, value, count);
    /* a piece that is too short takes from the next ones, and the last ones from those before them */
    for (int k = 1; k < WARP_PIECES; k++)
        w->at[k] = greater(w->at[k], w->at[k - 1] + least);
    for (int k = WARP_PIECES - 1; k > 0; k--)
        w->at[k] = lesser(w->at[k], w->at[k + 1] - least);
    for (int k = 0; k < WARP_PIECES; k++) {
        if (!(w->at[k] < w->at[k + 1]))
            return false;
        w->per[k] = 1.0 / (w->at[k + 1] - w->at[k]);
    }
    return true;
}

bool warp_is_sound(const warp *w)
{
    if (w->from != w->at[0] || !(w->piece > 0.0) || !isfinite(w->at[WARP_PIECES]) || !isfinite(w->piece))
        return false;
    for (int k = 0; k < WARP_PIECES; k++)
        if (!(w->at[k] < w->at[k + 1]) || w->per[k] != 1.0 / (w->at[k + 1] - w->at[k]))
            return false;
    return true;
}
