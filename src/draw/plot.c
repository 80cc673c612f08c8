/* plot.c - hands strokes to the formats that are text.
 *
 * Each stroke goes into a path of Cairo's, in whole units of the page, and comes back by cairo_copy_path(), without
 * points in the middle of straight runs. */
#include "draw/plot.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/error.h"
#include "draw/cairo.h"

/* A stroke on its way back from Cairo. */
typedef struct way_back {
    const plotter *to;
    page_point *point;
    size_t count, room;
} way_back;

static bool add_point(way_back *w, const cairo_path_data_t *at)
{
    if (!array_reserve(&w->point, &w->room, w->count + 1, sizeof *w->point))
        return false;
    w->point[w->count++] = (page_point){(int32_t)at->point.x, (int32_t)at->point.y};
    return true;
}

static void end_stroke(way_back *w, bool closed)
{
    if (w->count > 1 && w->to->stroke)
        w->to->stroke(w->to->context, w->point, w->count, closed);
    w->count = 0;
}

/* After a closed line Cairo moves to its start once more: a stroke of one point, which is dropped. */
static roberts_status take_path(way_back *w, const cairo_path_t *path, roberts_error *error)
{
    for (int i = 0; i < path->num_data; i += path->data[i].header.length) {
        const cairo_path_data_t *data = &path->data[i];
        if (data->header.type == CAIRO_PATH_CLOSE_PATH)
            end_stroke(w, true);
        else if (data->header.type == CAIRO_PATH_MOVE_TO)
            end_stroke(w, false);
        if (data->header.type != CAIRO_PATH_CLOSE_PATH && !add_point(w, data + 1))
            return error_no_memory(error);
    }
    end_stroke(w, false);
    return ROBERTS_OK;
}

/* Draws polylines first .. end - 1. */
static roberts_status plot_some(cairo_t *cairo, const strokes *s, size_t first, size_t end, way_back *w,
                                roberts_error *error)
{
    cairo_new_path(cairo);
    for (size_t i = first; i < end; i++)
        surface_add_line(cairo, &s->lines, &s->lines.item[i], 1.0);
    cairo_path_t *path = cairo_copy_path(cairo);
    roberts_status status =
        path->status == CAIRO_STATUS_SUCCESS ? take_path(w, path, error) : surface_failure(path->status, error);
    cairo_path_destroy(path);
    return status;
}

static roberts_status plot_class(cairo_t *cairo, const strokes *s, int class, way_back *w, const output *out,
                                 roberts_error *error)
{
    const plotter *to = w->to;
    size_t at = s->start[class], end = s->start[class + 1];
    roberts_status status = ROBERTS_OK;
    if (at == end)
        return ROBERTS_OK;
    if (to->begin)
        to->begin(to->context, line_order[class]);
    while (at < end && !out->failed && status == ROBERTS_OK) {
        size_t next = strokes_part_end(s, at, end);
        status = plot_some(cairo, s, at, next, w, error);
        at = next;
        if (to->part)
            to->part(to->context, at == end);
    }
    return status;
}

roberts_status plot_strokes(const strokes *s, const plotter *to, const output *out, roberts_error *error)
{
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1); /* nothing is drawn on it */
    cairo_t *cairo = cairo_create(surface);
    way_back w = {.to = to};
    roberts_status status = ROBERTS_OK;
    for (int i = 0; i < LINE_CLASSES && status == ROBERTS_OK; i++)
        status = plot_class(cairo, s, i, &w, out, error);
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
    free(w.point);
    return status;
}
