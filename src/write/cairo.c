/* cairo.c - the page as PostScript and EPS, by Cairo's surfaces; strokes and pens for all of Cairo's surfaces.
 *
 * On every surface Cairo computes the outline of each stroke, to find what it touches. One stroke for each segment
 * takes several times as long as one stroke for many segments. But the outline of 100,000 segments takes 600 MB, and
 * strokes of more than 1,000 segments are no faster.
 *
 * Cairo's fixed point holds 1/256 of a point, 0.0014 mm. Pages of PostScript are whole points, so a page may be up to
 * a point wider and higher than asked for: the drawing keeps its distance from the upper left corner. Files have no
 * date, so that the same drawing gives the same bytes: the line with the date is dropped from the PostScript stream. */
#include "write/cairo.h"

#include <dlfcn.h>
#include <math.h>
#include <string.h>

#include "base/error.h"
#include "write/formats.h"

static const double points_per_inch = 72.0;

/* ---- Cairo itself ---- */

#ifdef __APPLE__
static const char cairo_library[] = "libcairo.2.dylib";
#else
static const char cairo_library[] = "libcairo.so.2";
#endif

bool surface_load(cairo_calls *call, roberts_error *error)
{
    void *library = dlopen(cairo_library, RTLD_NOW | RTLD_LOCAL);
    bool found = library != NULL;
    void *at;
/* In POSIX, unlike in C, a pointer to an object can hold the address of a function. */
#define CAIRO_FIND(name)                                                                                               \
    if (found && (found = (at = dlsym(library, "cairo_" #name)) != NULL))                                              \
        memcpy(&call->name, &at, sizeof at);
    CAIRO_CALLS(CAIRO_FIND)
#undef CAIRO_FIND
    if (!found)
        error_set(error, ROBERTS_IO, 0, "PNG, PS and EPS are drawn by Cairo: %s", dlerror());
    return found;
}

/* ---- fills and strokes ---- */

/* Sets width, dashes, caps and colour for a class of lines. */
static void set_pen(const cairo_calls *call, cairo_t *cairo, const roberts_draw_options *options, roberts_line line)
{
    const roberts_pen *pen = pens_of(options, line);
    double dash[2];
    bool dashed = pens_dash(options, line, dash);
    call->set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    call->set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    call->set_line_width(cairo, pen->width_mm);
    call->set_source_rgb(cairo, pen->red / 255.0, pen->green / 255.0, pen->blue / 255.0);
    call->set_dash(cairo, dash, dashed ? 2 : 0, 0.0);
}

/* Adds a polyline to the current path of `cairo`, whose unit is `units` units of the page. */
static void trace_polyline(const cairo_calls *call, cairo_t *cairo, const polylines *lines, const polyline *line,
                           double units)
{
    const page_point *p = lines->point + line->first;
    call->move_to(cairo, p->x / units, p->y / units);
    for (uint32_t i = 1; i < line->count; i++)
        call->line_to(cairo, p[i].x / units, p[i].y / units);
    if (line->closed)
        call->close_path(cairo);
}

/* Draws the polylines first .. end - 1, which are of the class whose pen is set. */
static void draw_some(const cairo_calls *call, cairo_t *cairo, const strokes *s, size_t first, size_t end)
{
    while (first < end) {
        size_t next = strokes_part_end(s, first, end);
        for (; first < next; first++)
            trace_polyline(call, cairo, &s->lines, &s->lines.item[first], s->units_per_mm);
        call->stroke(cairo);
    }
}

static void paint_fills(const cairo_calls *call, cairo_t *cairo, const strokes *s)
{
    const fills *f = &s->fills;
    call->set_dash(cairo, NULL, 0, 0.0);
    call->set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    call->set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    call->set_line_width(cairo, f->seam_mm);
    for (size_t i = 0; i < f->count; i++) {
        const fill_paint *paint = &f->paint[i];
        const fill_color color = fills_on_paper(s->options, paint->color);
        call->set_source_rgb(cairo, color.red / 255.0, color.green / 255.0, color.blue / 255.0);
        for (size_t k = paint->first; k < paint->end; k++) {
            trace_polyline(call, cairo, &f->lines, &f->lines.item[k], s->units_per_mm);
            if (paint->seam)
                call->stroke(cairo);
        }
        if (!paint->seam)
            call->fill(cairo);
    }
}

void surface_draw(const cairo_calls *call, cairo_t *cairo, const strokes *s)
{
    paint_fills(call, cairo, s);
    for (int i = 0; i < LINE_CLASSES; i++) {
        set_pen(call, cairo, s->options, line_order[i]);
        draw_some(call, cairo, s, s->start[i], s->start[i + 1]);
    }
}

roberts_status surface_failure(const cairo_calls *call, cairo_status_t status, roberts_error *error)
{
    switch (status) {
    case CAIRO_STATUS_SUCCESS:
    case CAIRO_STATUS_WRITE_ERROR: /* `out` knows why */
        return ROBERTS_OK;
    case CAIRO_STATUS_NO_MEMORY:
        return error_no_memory(error);
    default:
        return error_set(error, ROBERTS_IO, 0, "cairo: %s", call->status_to_string(status));
    }
}

/* Finishes and releases both. Returns the first failure. */
static roberts_status finish(const cairo_calls *call, cairo_t *cairo, cairo_surface_t *surface, roberts_error *error)
{
    cairo_status_t status = call->status(cairo);
    call->destroy(cairo);
    call->surface_finish(surface);
    if (status == CAIRO_STATUS_SUCCESS)
        status = call->surface_status(surface);
    call->surface_destroy(surface);
    return surface_failure(call, status, error);
}

/* ---- PostScript without a date ---- */

/* Passes on PostScript without the line "%%CreationDate: ..." of its head. */
typedef struct date_filter {
    output *out;
    size_t matched; /* bytes of `date_line` that begin the current line; they are kept back */
    enum { LINE_START, LINE_REST, LINE_DROPPED } at;
} date_filter;

static const char date_line[] = "%%CreationDate:";

static void date_filter_byte(date_filter *u, unsigned char c)
{
    if (u->at == LINE_START && c == (unsigned char)date_line[u->matched]) {
        if (++u->matched == sizeof date_line - 1)
            u->at = LINE_DROPPED;
        return;
    }
    if (u->at == LINE_START) {
        output_bytes(u->out, date_line, u->matched);
        u->at = LINE_REST;
    }
    if (u->at == LINE_REST)
        output_bytes(u->out, &c, 1);
    if (c == '\n') {
        u->at = LINE_START;
        u->matched = 0;
    }
}

static cairo_status_t date_filter_stream(void *closure, const unsigned char *bytes, unsigned size)
{
    date_filter *u = closure;
    for (unsigned i = 0; i < size; i++)
        date_filter_byte(u, bytes[i]);
    return u->out->failed ? CAIRO_STATUS_WRITE_ERROR : CAIRO_STATUS_SUCCESS;
}

/* ---- the page ---- */

/* Fills a rectangle of whole points, as a page of PostScript is. If the whole surface were painted, PostScript would
 * contain an image. */
static void paint_page(const cairo_calls *call, cairo_t *cairo, const roberts_page *page, double units_per_mm,
                       const roberts_background *color)
{
    call->set_source_rgb(cairo, color->red / 255.0, color->green / 255.0, color->blue / 255.0);
    call->rectangle(cairo, 0.0, 0.0, ceil(page->width_mm * units_per_mm), ceil(page->height_mm * units_per_mm));
    call->fill(cairo);
}

roberts_status surface_write(const strokes *s, output *out, roberts_error *error)
{
    const roberts_page *page = &s->page;
    const double points = points_per_inch / mm_per_inch;
    cairo_calls call;
    if (!surface_load(&call, error))
        return ROBERTS_IO;
    date_filter filter = {.out = out, .at = LINE_START};
    cairo_surface_t *surface = call.ps_surface_create_for_stream(date_filter_stream, &filter, page->width_mm * points,
                                                                 page->height_mm * points);
    call.ps_surface_set_eps(surface, s->options->format == ROBERTS_EPS);
    cairo_t *cairo = call.create(surface);
    if (s->options->background.on)
        paint_page(&call, cairo, page, points, &s->options->background);
    call.scale(cairo, points, points);
    surface_draw(&call, cairo, s);
    call.show_page(cairo);
    return finish(&call, cairo, surface, error);
}
