/* dashes.c - dashes as strokes of their own, for pens that know no patterns. */
#include "draw/dashes.h"

#include <math.h>
#include <stdlib.h>

#include "base/error.h"

/* Where a walk along a polyline is. */
typedef struct walker {
    const page_point *p;
    uint32_t count, side; /* points; the side that the walk is on, from p[side] to the next */
    bool closed;
    double at, length; /* on that side, and its length */
} walker;

static page_point corner(const walker *w, uint32_t i)
{
    return w->p[i % w->count];
}

static uint32_t sides(const walker *w)
{
    return w->closed ? w->count : w->count - 1;
}

static double side_length(const walker *w, uint32_t i)
{
    return page_distance(corner(w, i), corner(w, i + 1));
}

static page_point here(const walker *w)
{
    page_point a = corner(w, w->side), b = corner(w, w->side + 1);
    double t = w->at / w->length;
    return (page_point){(int32_t)floor(a.x + t * ((double)b.x - a.x) + 0.5),
                        (int32_t)floor(a.y + t * ((double)b.y - a.y) + 0.5)};
}

static bool add(polylines *out, page_point at)
{
    const page_point *last = out->point + out->point_count;
    bool same = out->item[out->count - 1].count && last[-1].x == at.x && last[-1].y == at.y;
    return same || polylines_append(out, at);
}

/* Goes on by `way`, or to the end; with `out`, corners on the way are added to its last polyline. False: no memory. */
static bool go(walker *w, double way, polylines *out)
{
    while (way >= w->length - w->at) {
        if (out && !add(out, corner(w, w->side + 1)))
            return false;
        way -= w->length - w->at;
        w->at = 0.0;
        if (++w->side == sides(w))
            return true;
        w->length = side_length(w, w->side);
    }
    w->at += way;
    return !out || add(out, here(w));
}

static bool cut_line(const polylines *from, const polyline *line, double down, double up, polylines *out)
{
    walker w = {.p = from->point + line->first, .count = line->count, .closed = line->closed};
    w.length = side_length(&w, 0);
    while (w.side < sides(&w)) {
        if (!polylines_start(out) || !add(out, here(&w)) || !go(&w, down, out))
            return false;
        if (out->item[out->count - 1].count == 1) { /* the rest of a line, rounded to nothing */
            out->count--;
            out->point_count--;
        }
        if (w.side < sides(&w) && !go(&w, up, NULL))
            return false;
    }
    return true;
}

static double length_of(const polylines *p, const polyline *line)
{
    walker w = {.p = p->point + line->first, .count = line->count, .closed = line->closed};
    double sum = 0.0;
    for (uint32_t i = 0; i < sides(&w); i++)
        sum += side_length(&w, i);
    return sum;
}

static bool copy_line(const polylines *from, const polyline *line, polylines *out)
{
    if (!polylines_start(out))
        return false;
    out->item[out->count - 1].closed = line->closed;
    for (uint32_t i = 0; i < line->count; i++)
        if (!add(out, from->point[line->first + i]))
            return false;
    return true;
}

roberts_status dashes_cut(polylines *p, size_t first, double down, double up, roberts_error *error)
{
    polylines cut = {0};
    double dashes = 0.0;
    down = fmax(down, 1.0);
    for (size_t i = first; i < p->count; i++)
        dashes += 1.0 + length_of(p, &p->item[i]) / (down + up);
    if (dashes > DASHES_MAX)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "more than %d dashes: longer ones are needed", DASHES_MAX);
    for (size_t i = 0; i < p->count; i++) {
        const polyline *line = &p->item[i];
        bool done = i >= first ? cut_line(p, line, down, up, &cut) : copy_line(p, line, &cut);
        if (!done) {
            polylines_free(&cut);
            return error_no_memory(error);
        }
    }
    polylines_free(p);
    *p = cut;
    return ROBERTS_OK;
}
