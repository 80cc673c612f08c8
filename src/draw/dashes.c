/* dashes.c - dashes as strokes of their own.
 *
 * A run is the part of a polyline between two corners or ends. A run of length L, as seen, gets n gaps and n + 1
 * dashes,
 *
 * n = max(1, round((L - d) / (d + g))),    each L / (n (d + g) + d) times as long as the pattern's d and g.
 *
 * The last dash of a run and the first of the next are one stroke, round the corner.
 *
 * In a short run a gap would get narrower than the pen. It then keeps the pen's width, and the dashes share the rest.
 * If that makes a dash shorter than least_dash_widths, the run is drawn whole. Such a run is shorter than any dash, so
 * it does not look like a line of another class; left out, it would leave a corner open. A pattern that is finer than
 * these limits stays as it is. */
#include "draw/dashes.h"

#include <math.h>

#include "base/error.h"

static const double least_dash_widths = 1.5;          /* widths of the pen: a shorter dash looks like a dot */
static const double dot_units = 2.0;                  /* shortest stroke of the pen: its ends differ once rounded */
static const double curve_cosine = 0.939692620785908; /* turns of up to 20 degrees: a polygon of 18 sides or more */
static const double straight_units = 2.0; /* a point so near to the line of its neighbours was moved by rounding */

/* ---- from corner to corner ---- */

/* The position of a walk along a polyline. */
typedef struct walker {
    const page_point *p;
    uint32_t count; /* points */
    uint32_t side;  /* the walk is on this side, from p[side] to the next; counted on, lap after lap */
    uint32_t end;   /* the run ends before this side */
    bool closed;
    double at, length; /* position on that side, and its length */
    size_t most;       /* polylines in all */
} walker;

/* Point i, counted on lap after lap of a closed line. */
static page_point corner(const walker *w, uint32_t i)
{
    while (i >= w->count)
        i -= w->count; /* few laps */
    return w->p[i];
}

static double side_length(const walker *w, uint32_t i)
{
    return page_distance(corner(w, i), corner(w, i + 1));
}

/* Whether there is a corner at point i, which has neighbours. There is none where rounding alone has bent a straight
 * line, nor in a curve: turns are small, and sides are so short that gaps on them would be narrower than the pen. */
static bool is_corner(const walker *w, const dash_pattern *pattern, uint32_t i)
{
    page_point p = corner(w, i + w->count - 1), q = corner(w, i), r = corner(w, i + 1);
    double ux = (double)q.x - p.x, uy = (double)q.y - p.y, vx = (double)r.x - q.x, vy = (double)r.y - q.y;
    double along = ux * vx + uy * vy, across = fabs(ux * vy - uy * vx);
    if (along > 0.0 && across <= straight_units * page_distance(p, r))
        return false;
    double before = page_distance(p, q), behind = page_distance(q, r);
    double enough = fmin(1.0, pattern->width / pattern->gap) * (2.0 * pattern->dash + pattern->gap) - pattern->width;
    return along < curve_cosine * before * behind || before >= enough || behind >= enough;
}

/* Enters the run that begins with side `from` and ends before side `end` at the latest. Returns its length. */
static double run_from(walker *w, const dash_pattern *pattern, uint32_t from, uint32_t end)
{
    w->side = from;
    w->at = 0.0;
    w->length = side_length(w, from);
    double sum = w->length;
    for (w->end = from + 1; w->end < end && !is_corner(w, pattern, w->end); w->end++)
        sum += side_length(w, w->end);
    return sum;
}

static page_point here(const walker *w)
{
    page_point a = corner(w, w->side), b = corner(w, w->side + 1);
    double t = w->at / w->length;
    return page_rounded((roberts_vec2){a.x + t * ((double)b.x - a.x), a.y + t * ((double)b.y - a.y)});
}

/* Advances by `way`, or to the end of the run. Adds the way to the last polyline of `out`, unless that is NULL. False:
 * no memory. */
static bool go(walker *w, double way, polylines *out)
{
    while (way >= w->length - w->at) {
        if (out && !polylines_append_new(out, corner(w, w->side + 1)))
            return false;
        way -= w->length - w->at;
        w->at = 0.0;
        if (++w->side == w->end)
            return true;
        w->length = side_length(w, w->side);
    }
    w->at += way;
    return !out || polylines_append_new(out, here(w));
}

/* ---- the pattern on a run ---- */

/* How a run is cut: lengths along the path of the pen. */
typedef struct fit {
    size_t gaps; /* 0: drawn whole */
    double down, up;
} fit;

/* Fits the pattern to a run of this length, with one dash more than gaps. A `ring`, which is a closed line without
 * corners, gets as many dashes as gaps. */
static fit fit_pattern(const dash_pattern *p, double length, bool ring)
{
    const double more = ring ? 0.0 : 1.0, seen = ring ? length : length + p->width, period = p->dash + p->gap;
    const double least = fmin(p->dash, fmax(least_dash_widths * p->width, p->width + dot_units)),
                 least_gap = fmin(p->gap, p->width);
    double n = fmax(1.0, floor((seen - more * p->dash) / period + 0.5));
    n = fmin(n, floor((seen - more * least) / (least + least_gap)));
    if (n < 1.0)
        return (fit){0};
    double dash = fmax(seen / (n * period + more * p->dash) * p->dash, least);
    double down = fmin(dash, (seen - n * least_gap) / (n + more)) - p->width;
    return (fit){(size_t)n, down, (length - (n + more) * down) / n};
}

/* Starts a dash. False: no memory. */
static bool put_down(const walker *w, polylines *out)
{
    return polylines_start(out) && polylines_append_new(out, here(w));
}

/* Cuts the rest of a run, after its first dash, into gaps and dashes. The last dash goes to the end of the run. */
static bool cut_run(walker *w, const fit *f, polylines *out)
{
    for (size_t k = 1; k <= f->gaps; k++)
        if (!go(w, f->up, NULL) || !put_down(w, out) || !go(w, k < f->gaps ? f->down : INFINITY, out))
            return false;
    return true;
}

static bool has_room(const walker *w, const fit *f, const polylines *out)
{
    return out->count < w->most && f->gaps < w->most - out->count;
}

/* Cuts the runs from side `from` to side `end`. In a closed line the first run has a gap, and its first dash is drawn
 * last, as the end of the dash that leads to it. */
static roberts_status cut_runs(walker *w, const dash_pattern *pattern, uint32_t from, uint32_t end, polylines *out)
{
    fit first = {0};
    for (uint32_t i = from; i < end; i = w->end) {
        fit f = fit_pattern(pattern, run_from(w, pattern, i, end), false);
        if (!has_room(w, &f, out))
            return ROBERTS_BAD_ARGUMENT;
        bool done = i > from || w->closed || put_down(w, out);
        if (i == from)
            first = f;
        done = done && go(w, f.gaps ? f.down : INFINITY, i == from && w->closed ? NULL : out);
        if (!done || !cut_run(w, &f, out))
            return ROBERTS_NO_MEMORY;
    }
    if (w->closed) {
        run_from(w, pattern, end, end + end - from);
        if (!go(w, first.down, out))
            return ROBERTS_NO_MEMORY;
    }
    return ROBERTS_OK;
}

/* A closed line without corners. */
static roberts_status cut_ring(walker *w, const dash_pattern *pattern, polylines *out)
{
    fit f = fit_pattern(pattern, run_from(w, pattern, 0, w->count), true);
    if (!has_room(w, &f, out))
        return ROBERTS_BAD_ARGUMENT;
    for (size_t k = 0; k < f.gaps; k++)
        if (!put_down(w, out) || !go(w, f.down, out) || !go(w, f.up, NULL))
            return ROBERTS_NO_MEMORY;
    return ROBERTS_OK;
}

/* Cuts a closed line. It starts at a corner whose run has a gap, so that the dash round that corner is one stroke. */
static roberts_status cut_closed(walker *w, const dash_pattern *pattern, polylines *out)
{
    uint32_t first = 0;
    while (first < w->count && !is_corner(w, pattern, first))
        first++;
    if (first == w->count)
        return cut_ring(w, pattern, out);
    for (uint32_t i = first; i < first + w->count; i = w->end)
        if (fit_pattern(pattern, run_from(w, pattern, i, first + w->count), false).gaps)
            return cut_runs(w, pattern, i, i + w->count, out);
    return ROBERTS_OK;
}

static roberts_status cut_line(const polylines *from, size_t i, const dash_pattern *pattern, size_t most,
                               polylines *out)
{
    const polyline *line = &from->item[i];
    walker w = {.p = from->point + line->first, .count = line->count, .closed = line->closed, .most = most};
    const size_t before = out->count;
    roberts_status status = w.closed ? cut_closed(&w, pattern, out) : cut_runs(&w, pattern, 0, w.count - 1, out);
    if (status == ROBERTS_OK && out->count == before && !polylines_copy(from, i, i + 1, out))
        return ROBERTS_NO_MEMORY; /* closed, and no run has a gap */
    for (size_t k = before; k < out->count; k++)
        out->item[k].number = line->number;
    return status;
}

roberts_status dashes_cut(polylines *p, size_t first, const dash_pattern *pattern, roberts_error *error)
{
    polylines cut = {0};
    dash_pattern least = *pattern;
    least.dash = fmax(pattern->dash, pattern->width + dot_units);
    roberts_status status = polylines_copy(p, 0, first, &cut) ? ROBERTS_OK : ROBERTS_NO_MEMORY;
    for (size_t i = first; i < p->count && status == ROBERTS_OK; i++)
        status = cut_line(p, i, &least, first + DASHES_MAX, &cut);
    if (status != ROBERTS_OK) {
        polylines_free(&cut);
        return status == ROBERTS_NO_MEMORY ? error_no_memory(error)
                                           : error_set(error, status, 0,
                                                       "the drawing takes more than %d dashes; make them longer, or "
                                                       "let the file's reader lay the pattern",
                                                       DASHES_MAX);
    }
    polylines_free(p);
    *p = cut;
    return ROBERTS_OK;
}
