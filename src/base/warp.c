/* warp.c - see warp.h. */
#include "base/warp.h"

/* Puts the pieces where the map that is wanted takes the values k / WARP_PIECES. That map is straight between low, the
 * values and high. */
static void divide(warp *b, double low, double high, const double *value, size_t count)
{
    double last = low, reached = 0.0;
    size_t i = 0;
    b->at[0] = low;
    for (int k = 1; k < WARP_PIECES; k++) {
        const double wanted = (double)k / WARP_PIECES;
        for (;; i++) {
            double next = i < count ? value[i] : high;
            double by =
                i < count ? 0.5 * (next - low) / (high - low) + 0.5 * ((double)i + 1.0) / ((double)count + 1.0) : 1.0;
            if (by >= wanted || i == count) {
                b->at[k] = by > reached ? last + (next - last) * (wanted - reached) / (by - reached) : next;
                break;
            }
            last = next;
            reached = by;
        }
    }
    b->at[WARP_PIECES] = high;
}

bool warp_make(warp *b, double low, double high, const double *value, size_t count, double least)
{
    b->from = low;
    b->piece = (high - low) / WARP_PIECES;
    if (!(b->piece >= 2.0 * least) || !(b->piece > 0.0))
        return false;
    divide(b, low, high, value, count);
    /* a piece that is too short takes from the next ones, and the last ones from those before them */
    for (int k = 1; k < WARP_PIECES; k++)
        b->at[k] = greater(b->at[k], b->at[k - 1] + least);
    for (int k = WARP_PIECES - 1; k > 0; k--)
        b->at[k] = lesser(b->at[k], b->at[k + 1] - least);
    for (int k = 0; k < WARP_PIECES; k++) {
        if (!(b->at[k] < b->at[k + 1]))
            return false;
        b->per[k] = 1.0 / (b->at[k + 1] - b->at[k]);
    }
    return true;
}
