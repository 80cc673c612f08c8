/* cairo.h - drawing on Cairo's surfaces, and their failures. */
#ifndef ROBERTS_WRITE_CAIRO_H
#define ROBERTS_WRITE_CAIRO_H

#include <cairo.h>

#include "draw/strokes.h"

/* Draws all fills, translucent ones as they look on the page's background, and all strokes. The unit of `cairo` is the
 * mm. */
void surface_draw(cairo_t *cairo, const strokes *s);

/* Turns a failure in Cairo into ours. After a failed write it returns ROBERTS_OK: the output stores the reason. */
roberts_status surface_failure(cairo_status_t status, roberts_error *error);

#endif
