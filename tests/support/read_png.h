/* read_png.h - a PNG in memory as a surface of Cairo's. */
#ifndef ROBERTS_TESTS_READ_PNG_H
#define ROBERTS_TESTS_READ_PNG_H

#include <cairo.h>
#include <string.h>

typedef struct png_source {
    const char *bytes;
    size_t left;
} png_source;

static inline cairo_status_t read_png_bytes(void *closure, unsigned char *to, unsigned size)
{
    png_source *s = closure;
    if (size > s->left)
        return CAIRO_STATUS_READ_ERROR;
    memcpy(to, s->bytes, size);
    s->bytes += size;
    s->left -= size;
    return CAIRO_STATUS_SUCCESS;
}

/* The caller destroys the surface. Its status says whether it could be read. */
static inline cairo_surface_t *read_png(const char *bytes, size_t size)
{
    png_source s = {bytes, size};
    return cairo_image_surface_create_from_png_stream(read_png_bytes, &s);
}

#endif
