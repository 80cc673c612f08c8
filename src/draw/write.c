/* write.c - a drawing in any format: defaults, checks, and the way to the room that writes it. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/error.h"
#include "draw/output.h"
#include "draw/page.h"
#include "draw/cairo.h"
#include "draw/strokes.h"
#include "draw/svg.h"
#include "draw/table.h"
#include "draw/write.h"

static const double widest_gap = 1000.0; /* mm, between the views of a sheet */

static const struct {
    const char *name; /* also the ending of file names */
    roberts_format format;
} formats[] = {
    {"svg", ROBERTS_SVG}, {"pdf", ROBERTS_PDF}, {"ps", ROBERTS_PS},     {"eps", ROBERTS_EPS},
    {"png", ROBERTS_PNG}, {"csv", ROBERTS_CSV}, {"json", ROBERTS_JSON}, {"null", ROBERTS_NULL},
};

/* Letters A to Z fold, whatever the locale. */
static bool same_word(const char *a, const char *b)
{
    for (;; a++, b++) {
        int x = *a >= 'A' && *a <= 'Z' ? *a - 'A' + 'a' : *a, y = *b >= 'A' && *b <= 'Z' ? *b - 'A' + 'a' : *b;
        if (x != y)
            return false;
        if (x == '\0')
            return true;
    }
}

bool roberts_format_by_name(const char *name, roberts_format *format)
{
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++)
        if (same_word(name, formats[i].name)) {
            *format = formats[i].format;
            return true;
        }
    return false;
}

bool roberts_format_by_path(const char *path, roberts_format *format)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path, *dot = strrchr(name, '.');
    return dot && dot != name && roberts_format_by_name(dot + 1, format);
}

roberts_draw_options roberts_draw_options_default(void)
{
    return (roberts_draw_options){
        .format = ROBERTS_SVG,
        .hidden = ROBERTS_HIDDEN_NONE,
        .page = {.width_mm = 210.0, .height_mm = 297.0, .margin_mm = 10.0},
        .outline = {.width_mm = 0.5},
        .crease = {.width_mm = 0.35},
        .back = {.width_mm = 0.25, .dash_mm = 12 * 0.25, .gap_mm = 3 * 0.25},
        .frame = {.width_mm = 0.7, .off = true},
        .symbol = {.width_mm = 0.35},
        .dpi = 150.0,
    };
}

static bool pen_is_valid(const roberts_pen *pen)
{
    const double widest = 1000.0; /* mm */
    return pen->width_mm > 0.0 && pen->width_mm <= widest && pen->dash_mm >= 0.0 && pen->dash_mm <= widest &&
           pen->gap_mm >= 0.0 && pen->gap_mm <= widest;
}

static roberts_status check_options(const roberts_draw_options *options, roberts_error *error)
{
    if (options->hidden < ROBERTS_HIDDEN_NONE || options->hidden > ROBERTS_HIDDEN_SOLID)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "no such way to draw hidden lines");
    if (!pen_is_valid(&options->outline) || !pen_is_valid(&options->crease) || !pen_is_valid(&options->back) ||
        !pen_is_valid(&options->frame) || !pen_is_valid(&options->symbol))
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "a pen is 0.001 to 1000 mm wide, dashes and gaps up to that");
    if (options->order < ROBERTS_ORDER_TRAVEL || options->order > ROBERTS_ORDER_NONE)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "no such order");
    return page_is_valid(&options->page, error) ? ROBERTS_OK : ROBERTS_BAD_ARGUMENT;
}

static bool is_finite(roberts_vec2 p)
{
    return isfinite(p.x) && isfinite(p.y);
}

static roberts_status check_segments(const roberts_drawing *drawing, roberts_error *error)
{
    for (size_t i = 0; i < drawing->count; i++) {
        const roberts_segment *s = &drawing->segment[i];
        if (!(is_finite(s->p0) && is_finite(s->p1) && isfinite(s->t0) && isfinite(s->t1)))
            return error_set(error, ROBERTS_BAD_NUMBER, 0, "segment %zu is not finite", i);
    }
    return ROBERTS_OK;
}

static roberts_status write_page(const subject *what, const roberts_draw_options *options, output *out,
                                 roberts_error *error)
{
    strokes s;
    roberts_status status = what->sheet ? strokes_make_sheet(&s, what->sheet, options, error)
                                        : strokes_make(&s, what->drawing, options, error);
    if (status == ROBERTS_OK)
        status = options->format == ROBERTS_SVG ? svg_write(&s, out, error) : surface_write(&s, out, error);
    if (status == ROBERTS_OK && options->ink)
        *options->ink = strokes_measure(&s);
    strokes_free(&s);
    return status;
}

static roberts_status write_table(const subject *what, const roberts_draw_options *options, output *out,
                                  roberts_error *error)
{
    bool with_hidden = options->hidden != ROBERTS_HIDDEN_NONE;
    if (what->sheet)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "a table cannot hold a sheet of several views");
    if (options->format == ROBERTS_CSV)
        table_write_csv(what->drawing, with_hidden, out);
    else
        table_write_json(what->drawing, with_hidden, out);
    return ROBERTS_OK;
}

static roberts_status write_format(const subject *what, const roberts_draw_options *options, output *out,
                                   roberts_error *error)
{
    switch (options->format) {
    case ROBERTS_SVG:
    case ROBERTS_PDF:
    case ROBERTS_PS:
    case ROBERTS_EPS:
    case ROBERTS_PNG:
        return write_page(what, options, out, error);
    case ROBERTS_CSV:
    case ROBERTS_JSON:
        return write_table(what, options, out, error);
    case ROBERTS_NULL:
        return ROBERTS_OK;
    }
    return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "no such format");
}

static roberts_status check_subject(const subject *what, roberts_error *error)
{
    roberts_status status = ROBERTS_OK;
    if (!what->sheet)
        return check_segments(what->drawing, error);
    if (!(what->sheet->gap_mm >= 0.0 && what->sheet->gap_mm <= widest_gap))
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "sheet: its gap has 0 to 1000 mm");
    for (int i = 0; i < ROBERTS_SHEET_VIEWS && status == ROBERTS_OK; i++)
        if (what->sheet->view[i])
            status = check_segments(what->sheet->view[i], error);
    return status;
}

roberts_status write_subject(const subject *what, const roberts_draw_options *options, roberts_write_fn *write,
                             void *context, roberts_error *error)
{
    roberts_status status, written;
    if ((status = check_options(options, error)) != ROBERTS_OK)
        return status;
    if ((status = check_subject(what, error)) != ROBERTS_OK)
        return status;
    output *out = malloc(sizeof *out);
    if (!out)
        return error_no_memory(error);
    output_start(out, write, context);
    status = write_format(what, options, out, error);
    written = status == ROBERTS_OK || out->failed ? output_finish(out, error) : status;
    free(out);
    return status == ROBERTS_OK ? written : status;
}

roberts_status roberts_drawing_write(const roberts_drawing *drawing, const roberts_draw_options *options,
                                     roberts_write_fn *write, void *context, roberts_error *error)
{
    const roberts_draw_options defaults = roberts_draw_options_default();
    return write_subject(&(subject){.drawing = drawing}, options ? options : &defaults, write, context, error);
}

roberts_status roberts_sheet_write(const roberts_sheet *sheet, const roberts_draw_options *options,
                                   roberts_write_fn *write, void *context, roberts_error *error)
{
    const roberts_draw_options defaults = roberts_draw_options_default();
    return write_subject(&(subject){.sheet = sheet}, options ? options : &defaults, write, context, error);
}
