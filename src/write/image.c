/* image.c - the page as PNG (ISO/IEC 15948): Cairo draws the pixels, band by band, and zlib compresses them.
 *
 * All pixels at once would take 2.1 GB for A4 at 2400 dpi. Here a band of some rows is drawn and written; then the same
 * memory serves for the next rows. Each band begins at a whole pixel, and all strokes are drawn for each of them, so
 * the picture does not depend on the bands. (To leave out strokes that do not touch a band saves little time: Cairo
 * does not fill what is outside.)
 *
 * Each row is filtered by the one above it (PNG's filter "up"): equal pixels become zeros. */
#include <math.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <unistd.h>

#include "base/array.h"
#include "base/error.h"
#include "write/cairo.h"
#include "write/deflater.h"
#include "write/formats.h"

enum {
    PIXELS_MAX = 32767 /* Cairo's limit for the side of an image */,
    BYTES_PER_PIXEL = 4, /* in memory */
    CHANNELS = 3,        /* in the file: red, green, blue */
    SURFACE_BYTES = 1 << 27,
    COMPRESSION = 6,
    FILTER_UP = 2
};

typedef struct image {
    const strokes *s;
    output *out;
    cairo_calls call;
    double pixels_per_mm;
    int width, height, band_height, surface_height, margin; /* in pixels */
    cairo_surface_t *surface;
    unsigned char *line[2]; /* rows for the file: the previous one, and this one after the byte of its filter */
    deflater deflater;
} image;

/* ---- the file ---- */

static void put_integer(unsigned char *to, uint32_t n)
{
    for (int i = 0; i < 4; i++)
        to[i] = (unsigned char)(n >> (24 - 8 * i));
}

/* A chunk: length, name, data, checksum. */
static void write_chunk(output *out, const char *name, const void *data, size_t size)
{
    unsigned char number[4];
    uLong sum = crc32(crc32(0, (const Bytef *)name, 4), data, (uInt)size);
    put_integer(number, (uint32_t)size);
    output_bytes(out, number, 4);
    output_bytes(out, name, 4);
    output_bytes(out, data, size);
    put_integer(number, (uint32_t)sum);
    output_bytes(out, number, 4);
}

static bool write_pixels(void *out, const void *bytes, size_t size)
{
    output *to = out;
    write_chunk(to, "IDAT", bytes, size);
    return !to->failed;
}

static void write_head(const image *m)
{
    unsigned char header[13] = {0}, resolution[9];
    const uint32_t pixels_per_metre = (uint32_t)(1000.0 * m->pixels_per_mm + 0.5);
    put_integer(header, (uint32_t)m->width);
    put_integer(header + 4, (uint32_t)m->height);
    header[8] = 8; /* bits of a channel */
    header[9] = 2; /* red, green, blue */
    put_integer(resolution, pixels_per_metre);
    put_integer(resolution + 4, pixels_per_metre);
    resolution[8] = 1; /* the unit is the metre */
    output_bytes(m->out, "\x89PNG\r\n\x1a\n", 8);
    write_chunk(m->out, "IHDR", header, sizeof header);
    write_chunk(m->out, "pHYs", resolution, sizeof resolution);
}

/* Writes one row of pixels, which Cairo has as 0x00RRGGBB. */
static bool write_row(image *m, const uint32_t *pixel)
{
    unsigned char *above = m->line[0], *own = m->line[1];
    const size_t size = (size_t)m->width * CHANNELS;
    own[0] = FILTER_UP;
    for (int x = 0, i = 0; x < m->width; x++, i += CHANNELS) {
        const unsigned char rgb[CHANNELS] = {(unsigned char)(pixel[x] >> 16), (unsigned char)(pixel[x] >> 8),
                                             (unsigned char)pixel[x]};
        for (int c = 0; c < CHANNELS; c++) {
            own[1 + i + c] = (unsigned char)(rgb[c] - above[i + c]);
            above[i + c] = rgb[c];
        }
    }
    return deflater_write(&m->deflater, own, 1 + size);
}

/* ---- bands ---- */

/* Draws the rows from `top` on. */
static cairo_status_t draw_surface(const image *m, int top)
{
    const roberts_background white = {true, 255, 255, 255}, *color = &m->s->options->background;
    cairo_t *cairo = m->call.create(m->surface);
    color = color->on ? color : &white;
    m->call.set_source_rgb(cairo, color->red / 255.0, color->green / 255.0, color->blue / 255.0);
    m->call.paint(cairo); /* includes the last row and column, which the page may cover in part */
    m->call.translate(cairo, 0.0, -top);
    m->call.scale(cairo, m->pixels_per_mm, m->pixels_per_mm);
    surface_draw(&m->call, cairo, m->s);
    cairo_status_t status = m->call.status(cairo);
    m->call.destroy(cairo);
    m->call.surface_flush(m->surface);
    return status;
}

static cairo_status_t write_bands(image *m)
{
    const int stride = m->call.image_surface_get_stride(m->surface), lowest = m->height - m->surface_height;
    const unsigned char *data = m->call.image_surface_get_data(m->surface);
    for (int from = 0; from < m->height; from += m->band_height) {
        int top = from - m->margin < 0 ? 0 : from - m->margin > lowest ? lowest : from - m->margin;
        cairo_status_t status = draw_surface(m, top);
        if (status != CAIRO_STATUS_SUCCESS)
            return status;
        for (int y = from; y < from + m->band_height && y < m->height; y++)
            if (!write_row(m, (const uint32_t *)(const void *)(data + (ptrdiff_t)(y - top) * stride)))
                return CAIRO_STATUS_WRITE_ERROR;
    }
    return CAIRO_STATUS_SUCCESS;
}

/* ---- the image ---- */

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

static roberts_status check_size(double width, double height, const strokes *s, roberts_error *error)
{
    if (width >= 1.0 && height >= 1.0 && width <= PIXELS_MAX && height <= PIXELS_MAX)
        return ROBERTS_OK;
    return error_set(error, ROBERTS_BAD_ARGUMENT, 0,
                     "%g dpi make an image of %.0f x %.0f pixels; it has 1 to %d a side, on this page at most %.0f dpi",
                     s->options->dpi, width, height, PIXELS_MAX,
                     floor(PIXELS_MAX * mm_per_inch / fmax(s->page.width_mm, s->page.height_mm)));
}

/* Refuses an image that needs too much. A system that promises more memory than it has would not: it would kill this
 * process, or others. */
static roberts_status check_memory(const image *m, roberts_error *error)
{
    const double megabyte = 1e6, bytes = (double)m->width * m->surface_height * BYTES_PER_PIXEL, most = memory_limit();
    if (bytes <= most)
        return ROBERTS_OK;
    return error_set(
        error, ROBERTS_NO_MEMORY, 0,
        "%g dpi make an image of %d x %d pixels; it takes %.0f MB of memory, and there are %.0f MB at the most",
        m->s->options->dpi, m->width, m->height, ceil(bytes / megabyte), floor(most / megabyte));
}

/* The rows above and below a band that are drawn with it: as many as the longest dash covers, with its caps. Where both
 * ends of a dash lie outside of the surface, Cairo 1.16 may leave it out. */
static double margin_rows(const strokes *s, double pixels_per_mm)
{
    double longest = 0.0, dash[2];
    for (int i = 0; i < LINE_CLASSES; i++)
        if (s->start[i] < s->start[i + 1] && pens_dash(s->options, line_order[i], dash))
            longest = fmax(longest, dash[0] + pens_of(s->options, line_order[i])->width_mm);
    return ceil(longest * pixels_per_mm) + 2.0;
}

/* Chooses the bands. Their rows and the margins take `surface_bytes`, if that leaves at least as many rows as a margin
 * has. */
static void set_bands(image *m, double width, double height, size_t surface_bytes)
{
    const double margin = margin_rows(m->s, m->pixels_per_mm);
    const double budget = floor((double)surface_bytes / BYTES_PER_PIXEL / width);
    const double band = fmax(margin, budget - 2.0 * margin);
    m->width = (int)width;
    m->height = (int)height;
    m->surface_height = (int)fmin(budget >= height ? budget : band + 2.0 * margin, m->height);
    m->band_height = m->surface_height == m->height ? m->height : (int)band;
    m->margin = (int)fmin(margin, height);
}

/* False: no memory. */
static bool get_memory(image *m)
{
    for (int i = 0; i < 2; i++)
        m->line[i] = alloc_zeroed(1 + (size_t)m->width * CHANNELS, 1);
    return m->line[0] && m->line[1];
}

/* Draws and writes all, once there is memory for it. */
static roberts_status write_image(image *m, roberts_error *error)
{
    m->surface = m->call.image_surface_create(CAIRO_FORMAT_RGB24, m->width, m->surface_height);
    cairo_status_t status = m->call.surface_status(m->surface);
    if (status == CAIRO_STATUS_SUCCESS && !deflater_start(&m->deflater, COMPRESSION, write_pixels, m->out))
        status = CAIRO_STATUS_NO_MEMORY;
    if (status == CAIRO_STATUS_SUCCESS) {
        write_head(m);
        status = write_bands(m);
        deflater_finish(&m->deflater);
        deflater_end(&m->deflater);
        write_chunk(m->out, "IEND", "", 0);
    }
    m->call.surface_destroy(m->surface);
    return surface_failure(&m->call, status, error);
}

roberts_status image_write_bands(const strokes *s, size_t surface_bytes, output *out, roberts_error *error)
{
    const roberts_page *page = &s->page;
    const double pixels_per_mm = s->options->dpi / mm_per_inch;
    const double width = ceil(page->width_mm * pixels_per_mm), height = ceil(page->height_mm * pixels_per_mm);
    roberts_status status = check_size(width, height, s, error);
    if (status != ROBERTS_OK)
        return status;
    image *m = malloc(sizeof *m);
    if (!m)
        return error_no_memory(error);
    *m = (image){.s = s, .out = out, .pixels_per_mm = pixels_per_mm};
    set_bands(m, width, height, surface_bytes);
    status = check_memory(m, error);
    if (status == ROBERTS_OK && !surface_load(&m->call, error))
        status = ROBERTS_IO;
    if (status == ROBERTS_OK)
        status = get_memory(m) ? write_image(m, error) : error_no_memory(error);
    free(m->line[0]);
    free(m->line[1]);
    free(m);
    return status;
}

roberts_status image_write(const strokes *s, output *out, roberts_error *error)
{
    return image_write_bands(s, SURFACE_BYTES, out, error);
}
