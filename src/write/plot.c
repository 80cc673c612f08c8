/* plot.c - passes strokes to the text formats.
 *
 * Like Cairo, it joins straight runs into one line (tests/paper reads all formats back). */
#include "write/plot.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/error.h"

/* The points of a stroke that are drawn. */
typedef struct drawn {
    page_point *point;
    size_t count, room;
} drawn;

/* Appends a point. It replaces the last one if that lies on the straight line to it. */
static void add_plot_point(drawn *d, page_point at)
{
    if (d->count > 1 && page_is_between(d->point[d->count - 2], d->point[d->count - 1], at))
        d->count--;
    d->point[d->count++] = at;
}

/* Takes the points of a polyline. The last side of a closed one may continue straight, too; its first point stays.
 * False: no memory. */
static bool take_line(drawn *d, const polylines *lines, const polyline *line)
{
    const page_point *p = lines->point + line->first;
    if (!array_reserve(&d->point, &d->room, (size_t)line->count + 1, sizeof *d->point))
        return false;
    d->count = 0;
    for (uint32_t i = 0; i < line->count; i++)
        add_plot_point(d, p[i]);
    if (line->closed) {
        add_plot_point(d, p[0]);
        d->count--;
    }
    return true;
}

/* Draws polylines first .. end - 1. False: no memory. */
static bool plot_some(const strokes *s, size_t first, size_t end, const plotter *to, drawn *d)
{
    for (size_t i = first; i < end && to->stroke; i++) {
        const polyline *line = &s->lines.item[i];
        if (!take_line(d, &s->lines, line))
            return false;
        if (d->count > 1)
            to->stroke(to->context, d->point, d->count, line->closed);
    }
    return true;
}

/* False: no memory. */
static bool plot_class(const strokes *s, int class, const plotter *to, drawn *d, const output *out)
{
    size_t at = s->start[class], end = s->start[class + 1];
    if (to->begin)
        to->begin(to->context, line_order[class]);
    while (at < end && !out->failed) {
        size_t next = strokes_part_end(s, at, end);
        if (!plot_some(s, at, next, to, d))
            return false;
        at = next;
        if (to->part)
            to->part(to->context, at == end);
    }
    return true;
}

static bool is_same_pen(const plotter *to, int a, int b)
{
    return to->pen && to->pen(to->context, line_order[a]) == to->pen(to->context, line_order[b]);
}

/* Lists the classes that have strokes in the order in which they are drawn: each follows the last one before it that
 * has its pen. Returns how many there are. */
static int order_classes(const strokes *s, const plotter *to, int order[LINE_CLASSES])
{
    int count = 0;
    for (int i = 0; i < LINE_CLASSES; i++) {
        int at = count;
        if (s->start[i] == s->start[i + 1])
            continue;
        while (at > 0 && !is_same_pen(to, order[at - 1], i))
            at--;
        if (at == 0)
            at = count;
        for (int k = count++; k > at; k--)
            order[k] = order[k - 1];
        order[at] = i;
    }
    return count;
}

roberts_status plot_strokes(const strokes *s, const plotter *to, const output *out, roberts_error *error)
{
    drawn d = {0};
    int order[LINE_CLASSES];
    bool done = true;
    const int count = order_classes(s, to, order);
    for (int i = 0; i < count && done; i++)
        done = plot_class(s, order[i], to, &d, out);
    free(d.point);
    return done ? ROBERTS_OK : error_no_memory(error);
}
