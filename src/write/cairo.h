/* cairo.h - drawing on Cairo's surfaces, and their failures.
 *
 * Cairo is loaded by the first page that it draws. With it come some twenty other libraries. To load them takes longer
 * than to read, hide and draw a small model, and most formats do not need them. */
#ifndef ROBERTS_WRITE_CAIRO_H
#define ROBERTS_WRITE_CAIRO_H

#include <cairo-ps.h>
#include <cairo.h>

#include "draw/strokes.h"

/* The functions of Cairo that we call. */
/* clang-format off */
#define CAIRO_CALLS(call) \
    call(image_surface_create) call(image_surface_get_data) call(image_surface_get_stride) \
    call(ps_surface_create_for_stream) call(ps_surface_set_eps) \
    call(surface_status) call(surface_flush) call(surface_finish) call(surface_destroy) \
    call(create) call(status) call(status_to_string) call(destroy) call(translate) call(scale) \
    call(set_source_rgb) call(set_line_width) call(set_line_cap) call(set_line_join) call(set_dash) \
    call(move_to) call(line_to) call(close_path) call(rectangle) \
    call(fill) call(stroke) call(paint) call(show_page)
/* clang-format on */

/* move_to is cairo_move_to(), and so on. (GCC and clang have __typeof__, and so the types are those of Cairo's header.)
 */
typedef struct cairo_calls {
#define CAIRO_MEMBER(name) __typeof__(cairo_##name) *name;
    CAIRO_CALLS(CAIRO_MEMBER)
#undef CAIRO_MEMBER
} cairo_calls;

/* Loads Cairo, unless the process has it already; it stays loaded. False: it cannot be loaded; `error` is set, to
 * ROBERTS_IO. */
bool surface_load(cairo_calls *call, roberts_error *error);

/* Draws all fills, translucent ones as they look on the page's background, and all strokes. The unit of `cairo` is the
 * mm. */
void surface_draw(const cairo_calls *call, cairo_t *cairo, const strokes *s);

/* Turns a failure in Cairo into ours. After a failed write it returns ROBERTS_OK: the output stores the reason. */
roberts_status surface_failure(const cairo_calls *call, cairo_status_t status, roberts_error *error);

#endif
