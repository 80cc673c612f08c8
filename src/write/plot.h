/* plot.h - strokes for the text formats, which get each class of lines, and each stroke of it, in turn. */
#ifndef ROBERTS_WRITE_PLOT_H
#define ROBERTS_WRITE_PLOT_H

#include "base/output.h"
#include "draw/strokes.h"

/* The operations of a format, as of a plotter. Any of these may be NULL. */
typedef struct plotter {
    /* A class of lines begins. Classes without strokes are left out. */
    void (*begin)(void *context, roberts_line line);
    /* A stroke of at least two points, in units of the page. A closed one returns to its first point. */
    void (*stroke)(void *context, const page_point *point, size_t count, bool closed);
    /* Called when about SEGMENTS_PER_STROKE segments have been drawn since `begin` or the last call. `last`: the class
     * ends. */
    void (*part)(void *context, bool last);
    /* The pen of a class. Classes that share a pen are drawn one after another, since some plotters change pens by
     * hand. NULL: classes keep their order. */
    uint32_t (*pen)(void *context, roberts_line line);
    void *context;
} plotter;

/* Passes all strokes to `to`, class by class, without points in the middle of straight runs. Stops early after a failed
 * write to `out`. Returns ROBERTS_OK or _NO_MEMORY. */
roberts_status plot_strokes(const strokes *s, const plotter *to, const output *out, roberts_error *error);

#endif
