/* cairo.c - the page as PDF, PostScript, EPS and PNG, by Cairo's surfaces.
 *
 * On every surface Cairo computes the outline of each stroke, to know what it touches. One stroke for each segment
 * takes several times as long as one stroke for many segments. But the outline of 100,000 segments takes 600 MB, and
 * strokes of more than 1,000 segments are no faster.
 *
 * Cairo's fixed point holds 1/256 of a point, 0.0014 mm. Files carry no date, so that the same drawing gives the same
 * bytes: a PDF surface can be told so, and from a PostScript stream the date's line is dropped. */
#include "draw/cairo.h"

#include <cairo-pdf.h>
#include <cairo-ps.h>
#include <math.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

#include "base/error.h"

static const double mm_per_inch = 25.4, points_per_inch = 72.0;

enum {
    PIXELS_MAX = 32767 /* Cairo's limit for the side of an image */,
    BYTES_PER_PIXEL = 4,
    SEGMENTS_PER_STROKE = 1000
};

/* ---- strokes ---- */

/* Width, dashes, caps and colour for a class of lines. `cairo` has mm as its units, here and below. */
static void set_pen(cairo_t *cairo, const roberts_draw_options *options, roberts_line line)
{
    const roberts_pen *pen = strokes_pen(options, line);
    double dash[2];
    bool dashed = strokes_dash(options, line, dash);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_width(cairo, pen->width_mm);
    cairo_set_source_rgb(cairo, pen->red / 255.0, pen->green / 255.0, pen->blue / 255.0);
    cairo_set_dash(cairo, dash, dashed ? 2 : 0, 0.0);
}

void surface_add_line(cairo_t *cairo, const strokes *s, const polyline *line, double units)
{
    const page_point *p = s->lines.point + line->first;
    cairo_move_to(cairo, p->x / units, p->y / units);
    for (uint32_t i = 1; i < line->count; i++)
        cairo_line_to(cairo, p[i].x / units, p[i].y / units);
    if (line->closed)
        cairo_close_path(cairo);
}

/* Draws the polylines first .. end - 1. A stroke of Cairo's ends when it has SEGMENTS_PER_STROKE segments. */
static void draw_strokes(cairo_t *cairo, const strokes *s, size_t first, size_t end)
{
    size_t segments = 0;
    for (size_t i = first; i < end; i++) {
        surface_add_line(cairo, s, &s->lines.item[i], s->units_per_mm);
        segments += s->lines.item[i].count;
        if (segments >= SEGMENTS_PER_STROKE || i + 1 == end) {
            cairo_stroke(cairo);
            segments = 0;
        }
    }
}

/* Writes a stream of Cairo's to an output, which remembers failures. */
static cairo_status_t pass_on(void *out, const unsigned char *bytes, unsigned size)
{
    output *to = out;
    output_bytes(to, bytes, size);
    return to->failed ? CAIRO_STATUS_WRITE_ERROR : CAIRO_STATUS_SUCCESS;
}

roberts_status surface_failure(cairo_status_t status, roberts_error *error)
{
    switch (status) {
    case CAIRO_STATUS_SUCCESS:
    case CAIRO_STATUS_WRITE_ERROR: /* `out` knows why */
        return ROBERTS_OK;
    case CAIRO_STATUS_NO_MEMORY:
        return error_no_memory(error);
    default:
        return error_set(error, ROBERTS_IO, 0, "cairo: %s", cairo_status_to_string(status));
    }
}

/* Finishes and releases both. Returns the first failure. */
static roberts_status finish(cairo_t *cairo, cairo_surface_t *surface, roberts_error *error)
{
    cairo_status_t status = cairo_status(cairo);
    cairo_destroy(cairo);
    cairo_surface_finish(surface);
    if (status == CAIRO_STATUS_SUCCESS)
        status = cairo_surface_status(surface);
    cairo_surface_destroy(surface);
    return surface_failure(status, error);
}

/* ---- streams that are changed on their way ---- */

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

/* Passes on a PNG and adds its resolution, which Cairo cannot write, as a chunk behind the header. */
typedef struct resolution_filter {
    output *out;
    size_t passed; /* bytes of Cairo's signature and header so far */
    uint32_t pixels_per_metre;
} resolution_filter;

enum { PNG_HEADER = 8 + 25, PNG_CHUNK = 21 };

/* CRC-32 as PNG has it (ISO 3309). */
static uint32_t checksum(const unsigned char *bytes, size_t size)
{
    uint32_t crc = 0xffffffff;
    for (size_t i = 0; i < size; i++) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; bit++)
            crc = crc >> 1 ^ (crc & 1 ? 0xedb88320 : 0);
    }
    return ~crc;
}

static void put_integer(unsigned char *to, uint32_t n)
{
    for (int i = 0; i < 4; i++)
        to[i] = (unsigned char)(n >> (24 - 8 * i));
}

static void write_resolution(const resolution_filter *m)
{
    unsigned char chunk[PNG_CHUNK] = {0, 0, 0, 9, 'p', 'H', 'Y', 's'};
    put_integer(chunk + 8, m->pixels_per_metre);
    put_integer(chunk + 12, m->pixels_per_metre);
    chunk[16] = 1; /* the unit is the metre */
    put_integer(chunk + 17, checksum(chunk + 4, 13));
    output_bytes(m->out, chunk, PNG_CHUNK);
}

static cairo_status_t resolution_filter_stream(void *closure, const unsigned char *bytes, unsigned size)
{
    resolution_filter *m = closure;
    size_t head = PNG_HEADER - m->passed < size ? PNG_HEADER - m->passed : size;
    output_bytes(m->out, bytes, head);
    if (head && (m->passed += head) == PNG_HEADER)
        write_resolution(m);
    output_bytes(m->out, bytes + head, size - head);
    return m->out->failed ? CAIRO_STATUS_WRITE_ERROR : CAIRO_STATUS_SUCCESS;
}

/* ---- the page ---- */

static cairo_surface_t *document(const strokes *s, output *out, date_filter *filter)
{
    const double points = points_per_inch / mm_per_inch;
    double width = s->options->page.width_mm * points, height = s->options->page.height_mm * points;
    cairo_surface_t *surface;
    if (s->options->format == ROBERTS_PDF) {
        surface = cairo_pdf_surface_create_for_stream(pass_on, out, width, height);
        cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, NULL);
        return surface;
    }
    surface = cairo_ps_surface_create_for_stream(date_filter_stream, filter, width, height);
    cairo_ps_surface_set_eps(surface, s->options->format == ROBERTS_EPS);
    return surface;
}

/* Fills a rectangle: if the whole surface were painted, PostScript would contain an image. */
static void paint_page(cairo_t *cairo, const roberts_page *page, const roberts_background *color)
{
    cairo_set_source_rgb(cairo, color->red / 255.0, color->green / 255.0, color->blue / 255.0);
    cairo_rectangle(cairo, 0.0, 0.0, page->width_mm, page->height_mm);
    cairo_fill(cairo);
}

static void draw_page(cairo_t *cairo, const strokes *s, double units_per_mm)
{
    cairo_scale(cairo, units_per_mm, units_per_mm);
    if (s->options->background.on && s->options->format != ROBERTS_PNG)
        paint_page(cairo, &s->options->page, &s->options->background);
    for (int i = 0; i < LINE_CLASSES; i++) {
        set_pen(cairo, s->options, line_order[i]);
        draw_strokes(cairo, s, s->start[i], s->start[i + 1]);
    }
}

/* The most memory that the process can have, in bytes: that of the machine, or the limit of the process. */
static double memory_limit(void)
{
    double most = INFINITY;
    struct rlimit limit;
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
        most = (double)limit.rlim_cur;
#ifdef _SC_PHYS_PAGES
    long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
    if (pages > 0 && size > 0)
        most = fmin(most, (double)pages * (double)size);
#endif
    return most;
}

/* Refuses an image that is too large. A system that promises more memory than it has would not: it would kill this
 * process, or others. */
static roberts_status check_image(double width, double height, const roberts_draw_options *options,
                                  roberts_error *error)
{
    const double megabyte = 1e6, bytes = BYTES_PER_PIXEL * width * height;
    const roberts_page *page = &options->page;
    if (!(width >= 1.0 && height >= 1.0 && width <= PIXELS_MAX && height <= PIXELS_MAX))
        return error_set(
            error, ROBERTS_BAD_ARGUMENT, 0,
            "%g dpi make an image of %.0f x %.0f pixels; it has 1 to %d a side, on this page at most %.0f dpi",
            options->dpi, width, height, PIXELS_MAX,
            floor(PIXELS_MAX * mm_per_inch / fmax(page->width_mm, page->height_mm)));
    double most = memory_limit();
    if (bytes > most)
        return error_set(
            error, ROBERTS_NO_MEMORY, 0,
            "%g dpi make an image of %.0f x %.0f pixels; it takes %.0f MB of memory, and there are %.0f MB at the most",
            options->dpi, width, height, ceil(bytes / megabyte), floor(most / megabyte));
    return ROBERTS_OK;
}

static roberts_status write_image(const strokes *s, output *out, roberts_error *error)
{
    const roberts_page *page = &s->options->page;
    double pixels_per_mm = s->options->dpi / mm_per_inch;
    double width = ceil(page->width_mm * pixels_per_mm), height = ceil(page->height_mm * pixels_per_mm);
    roberts_status status = check_image(width, height, s->options, error);
    if (status != ROBERTS_OK)
        return status;
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, (int)width, (int)height);
    cairo_t *cairo = cairo_create(surface);
    const roberts_background white = {true, 255, 255, 255}, *color = &s->options->background;
    color = color->on ? color : &white;
    cairo_set_source_rgb(cairo, color->red / 255.0, color->green / 255.0, color->blue / 255.0);
    cairo_paint(cairo); /* includes the last row and column, which the page may cover in part */
    draw_page(cairo, s, pixels_per_mm);
    if (cairo_status(cairo) == CAIRO_STATUS_SUCCESS) {
        resolution_filter filter = {.out = out, .pixels_per_metre = (uint32_t)(1000.0 * pixels_per_mm + 0.5)};
        cairo_status_t written = cairo_surface_write_to_png_stream(surface, resolution_filter_stream, &filter);
        if (written == CAIRO_STATUS_NO_MEMORY) {
            finish(cairo, surface, NULL);
            return error_no_memory(error);
        }
    }
    return finish(cairo, surface, error);
}

roberts_status surface_write(const strokes *s, output *out, roberts_error *error)
{
    date_filter filter = {.out = out, .at = LINE_START};
    if (s->options->format == ROBERTS_PNG)
        return write_image(s, out, error);
    cairo_surface_t *surface = document(s, out, &filter);
    cairo_t *cairo = cairo_create(surface);
    draw_page(cairo, s, points_per_inch / mm_per_inch);
    cairo_show_page(cairo);
    return finish(cairo, surface, error);
}
