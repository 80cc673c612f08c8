/* save.c - a drawing or a sheet in any format: to a function or into a file. */
#include "write/save.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/error.h"
#include "base/vec.h"
#include "draw/letters.h"
#include "draw/page.h"
#include "draw/sheet.h"
#include "draw/strokes.h"
#include "write/formats.h"
#include "write/table.h"
#include "write/whole_file.h"

/* ---- formats, and any of them to a function ---- */

/* The thing to write: one of these; the others are NULL. */
typedef struct subject {
    const roberts_drawing *drawing;
    const roberts_sheet *sheet;
    const roberts_region_list *regions;
    const save_source *source;
} subject;

static const double widest_gap = 1000.0;  /* mm, between the views of a sheet */
static const double inside_most = 1000.0; /* mm, from the origin of a plotter to the corner or middle of the page */

static const struct {
    const char *name; /* also the ending of file names */
    roberts_format format;
} formats[] = {
    {"svg", ROBERTS_SVG},   {"pdf", ROBERTS_PDF},   {"ps", ROBERTS_PS},    {"eps", ROBERTS_EPS},
    {"png", ROBERTS_PNG},   {"tikz", ROBERTS_TIKZ}, {"tex", ROBERTS_TIKZ}, {"dxf", ROBERTS_DXF},
    {"hpgl", ROBERTS_HPGL}, {"plt", ROBERTS_HPGL},  {"csv", ROBERTS_CSV},  {"json", ROBERTS_JSON},
    {"null", ROBERTS_NULL},
};

/* Ignores the case of letters A to Z, whatever the locale. */
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

bool roberts_format_has_text(roberts_format format)
{
    return format == ROBERTS_SVG || format == ROBERTS_PDF || format == ROBERTS_TIKZ || format == ROBERTS_DXF;
}

roberts_draw_options roberts_draw_options_default(void)
{
    return (roberts_draw_options){
        .format = ROBERTS_SVG,
        .hidden = ROBERTS_HIDDEN_NONE,
        .page = {.width_mm = 210.0, .height_mm = 297.0, .margin_mm = 10.0},
        .outline = {.width_mm = 0.5},
        .border = {.width_mm = 0.5},
        .crease = {.width_mm = 0.35},
        .intersection = {.width_mm = 0.35},
        .wire = {.width_mm = 0.35},
        .back = {.width_mm = 0.25, .dash_mm = 12 * 0.25, .gap_mm = 3 * 0.25},
        .frame = {.width_mm = 0.7, .off = true},
        .symbol = {.width_mm = 0.35},
        .hatch = {.width_mm = 0.25},
        .hatching = {.spacing_mm = 0.8, .levels = 10, .degrees = 45.0, .cross = 1.0},
        .text = {.width_mm = 0.25},
        .hidden_text = {.width_mm = 0.25, .red = 128, .green = 128, .blue = 128},
        .fill = ROBERTS_FILL_NONE,
        .fill_color = {255, 255, 255},
        .light = {-1.0, 2.0, 3.0},
        .dpi = 150.0,
    };
}

static bool pen_is_valid(const roberts_pen *pen)
{
    const double widest = 1000.0; /* mm */
    return pen->width_mm > 0.0 && pen->width_mm <= widest && pen->dash_mm >= 0.0 && pen->dash_mm <= widest &&
           pen->gap_mm >= 0.0 && pen->gap_mm <= widest;
}

static bool pens_are_valid(const roberts_draw_options *options)
{
    const roberts_pen *const pen[] = {&options->outline, &options->border, &options->crease,     &options->intersection,
                                      &options->wire,    &options->back,   &options->frame,      &options->symbol,
                                      &options->hatch,   &options->text,   &options->hidden_text};
    for (size_t i = 0; i < sizeof pen / sizeof pen[0]; i++)
        if (!pen_is_valid(pen[i]))
            return false;
    return true;
}

static bool hatching_is_valid(const roberts_hatching *h)
{
    return !h->on ||
           (h->spacing_mm >= 0.01 && h->spacing_mm <= 1000.0 && h->levels <= 1000 &&
            h->along >= ROBERTS_HATCH_PICTURE && h->along <= ROBERTS_HATCH_ACROSS && fabs(h->degrees) <= 360.0 &&
            h->cross >= 0.0 && h->cross <= 1.0 && h->shortest_mm >= 0.0 && h->shortest_mm <= 1000.0);
}

static bool columns_are_valid(const roberts_draw_options *options)
{
    if (options->column_count > ROBERTS_COLUMNS)
        return false;
    for (size_t i = 0; i < options->column_count; i++) {
        if (options->column[i] < 0 || options->column[i] >= ROBERTS_COLUMNS)
            return false;
        for (size_t k = 0; k < i; k++)
            if (options->column[k] == options->column[i])
                return false;
    }
    return true;
}

static roberts_status check_options(const roberts_draw_options *options, roberts_error *error)
{
    if (options->hidden < ROBERTS_HIDDEN_NONE || options->hidden > ROBERTS_HIDDEN_SOLID)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "unknown way to draw hidden lines");
    if (!pens_are_valid(options))
        return error_set(
            error, ROBERTS_BAD_ARGUMENT, 0,
            "a pen must be more than 0 and at most 1000 mm wide; dashes and gaps must be 0 to 1000 mm long");
    if (options->lettering.zones && options->page.margin_mm < 7.0)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "zones of a frame need margins of at least 7 mm");
    const double height = options->lettering.height_mm;
    if (!(height == 0.0 || (height >= 0.5 && height <= 100.0)))
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "letters must be 0.5 to 100 mm high");
    if (options->order < ROBERTS_ORDER_TRAVEL || options->order > ROBERTS_ORDER_NONE)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "unknown order of strokes");
    if (options->grouping < ROBERTS_GROUP_CLASS || options->grouping > ROBERTS_GROUP_ELEMENT)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "unknown way to group the lines of SVG");
    if (options->plotter.turn > 270 || options->plotter.turn % 90 != 0)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "a plotter's page is turned by 0, 90, 180 or 270 degrees");
    if (!(fabs(options->plotter.inside_mm.x) <= inside_most) || !(fabs(options->plotter.inside_mm.y) <= inside_most))
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "a plotter's origin lies at most %g mm inside", inside_most);
    if (options->fill < ROBERTS_FILL_NONE || options->fill > ROBERTS_FILL_BODY)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "unknown way to fill faces");
    if (!(isnormal(vec3_length(options->light))))
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "the light comes from no direction");
    if (!hatching_is_valid(&options->hatching))
        return error_set(
            error, ROBERTS_BAD_ARGUMENT, 0,
            "hatching: the spacing is 0.01 to 1000 mm; there are at most 1000 levels; the angle is -360 to "
            "360 degrees, cross 0 to 1, and the shortest stroke 0 to 1000 mm");
    if (!columns_are_valid(options))
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "an unknown column of tables, or one that is wanted twice");
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

/* By format; the others have no page. */
static page_writer *const page_writers[] = {
    [ROBERTS_SVG] = svg_write,     [ROBERTS_PDF] = pdf_write,   [ROBERTS_PS] = surface_write,
    [ROBERTS_EPS] = surface_write, [ROBERTS_PNG] = image_write, [ROBERTS_TIKZ] = tikz_write,
    [ROBERTS_DXF] = dxf_write,     [ROBERTS_HPGL] = hpgl_write,
};

/* What counts missing characters, what lacks them, and what becomes of them. */
typedef struct letter_stock {
    size_t (*missing)(const char *text, uint32_t *first);
    const char *name, *result;
} letter_stock;

static const letter_stock pens_stock = {letters_missing, "letters", "a box stands for each"},
                          pdf_stock = {pdf_text_missing, "fonts of PDF",
                                       "a plain letter or a question mark stands for each"},
                          tikz_stock = {tikz_text_missing, "definitions of LaTeX",
                                        "pdflatex fails unless the document defines each"},
                          tikz_ot1_stock = {tikz_text_only_in_t1, "usual fonts of LaTeX",
                                            "pdflatex fails without \\usepackage[T1]{fontenc}"};

/* Warns once about the characters that a stock lacks. */
static void tell_lack(const strokes *s, const letter_stock *stock)
{
    const roberts_warnings *to = &s->options->lettering.warnings;
    size_t missing = 0;
    uint32_t first = 0;
    char text[160], which[32] = "a byte that is not UTF-8";
    for (size_t i = 0; i < s->notes.count; i++)
        missing += stock->missing(notes_line(&s->notes, i).text, missing ? NULL : &first);
    if (missing == 0 || !to->warn)
        return;
    if (first)
        snprintf(which, sizeof which, "U+%04X", (unsigned)first);
    snprintf(text, sizeof text, "the %s lack %zu character%s, the first of them %s: %s", stock->name, missing,
             missing == 1 ? "" : "s", which,
             stock == &tikz_stock && first < 0x80 ? "a question mark stands for each" : stock->result);
    to->warn(to->context, "", 0, text);
}

/* Warns of missing characters. Fonts of viewers of other formats are unknown here. */
static void tell_missing(const strokes *s)
{
    const roberts_format format = s->options->format;
    if (!strokes_text_is_native(s->options)) {
        tell_lack(s, &pens_stock);
    } else if (format == ROBERTS_PDF) {
        tell_lack(s, &pdf_stock);
    } else if (format == ROBERTS_TIKZ) {
        tell_lack(s, &tikz_stock);
        tell_lack(s, &tikz_ot1_stock);
    }
}

static roberts_status write_page(const subject *what, const roberts_draw_options *options, output *out,
                                 roberts_error *error)
{
    strokes s;
    roberts_status status = what->sheet ? strokes_make_sheet(&s, what->sheet, options, error)
                                        : strokes_make(&s, what->drawing, options, error);
    if (status == ROBERTS_OK) {
        tell_missing(&s);
        status = page_writers[options->format](&s, out, error);
    }
    if (status == ROBERTS_OK && options->ink)
        *options->ink = strokes_measure(&s);
    strokes_free(&s);
    return status;
}

/* A sheet is one table, which names the view of each row. */
static void write_table(const subject *what, const roberts_draw_options *options, output *out)
{
    table_view view[ROBERTS_SHEET_VIEWS] = {{what->drawing, NULL}};
    size_t count = what->sheet ? 0 : 1;
    for (int i = 0; what->sheet && i < ROBERTS_SHEET_VIEWS; i++)
        if (what->sheet->view[i])
            view[count++] = (table_view){what->sheet->view[i], roberts_sheet_view_name(what->sheet->angle, i)};
    if (options->format == ROBERTS_CSV)
        table_write_csv(view, count, options, out);
    else
        table_write_json(view, count, options, out);
}

static roberts_status write_format(const subject *what, const roberts_draw_options *options, output *out,
                                   roberts_error *error)
{
    if (what->regions) {
        if (options->format == ROBERTS_CSV)
            region_table_write_csv(what->regions, out);
        else
            region_table_write_json(what->regions, out);
        return ROBERTS_OK;
    }
    if (options->format < ROBERTS_SVG || options->format > ROBERTS_NULL)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "unknown format");
    if ((size_t)options->format < sizeof page_writers / sizeof page_writers[0])
        return write_page(what, options, out, error);
    if (options->format != ROBERTS_NULL)
        write_table(what, options, out);
    return ROBERTS_OK;
}

static roberts_status check_subject(const subject *what, roberts_error *error)
{
    roberts_status status = ROBERTS_OK;
    if (what->regions || what->source)
        return ROBERTS_OK;
    if (!what->sheet)
        return check_segments(what->drawing, error);
    if (!(what->sheet->gap_mm >= 0.0 && what->sheet->gap_mm <= widest_gap))
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "sheet: its gap has 0 to 1000 mm");
    for (int i = 0; i < ROBERTS_SHEET_VIEWS && status == ROBERTS_OK; i++)
        if (what->sheet->view[i])
            status = check_segments(what->sheet->view[i], error);
    return status;
}

/* As roberts_drawing_write(); `options` are not NULL. */
static roberts_status write_subject(const subject *what, const roberts_draw_options *options, roberts_write_fn *write,
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
    status =
        what->source ? what->source->write(what->source->context, out, error) : write_format(what, options, out, error);
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

/* ---- to a file ---- */

static roberts_status save_file(const subject *what, const roberts_draw_options *options, const char *path,
                                roberts_error *error)
{
    whole_file file = {.announce = options->temporary, .context = options->temporary_context};
    roberts_status status = whole_file_open(&file, path, error);
    if (status != ROBERTS_OK)
        return status;
    status = write_subject(what, options, output_descriptor, &file.descriptor, error);
    return whole_file_close(&file, status, error);
}

static roberts_status save(const subject *what, const roberts_draw_options *options, const char *path,
                           roberts_error *error)
{
    const roberts_draw_options defaults = roberts_draw_options_default();
    int standard_output = STDOUT_FILENO;
    bool to_standard_output = strcmp(path, "-") == 0;
    roberts_status status;
    if (!options)
        options = &defaults;
    if (to_standard_output || options->format == ROBERTS_NULL)
        status = write_subject(what, options, output_descriptor, &standard_output, error);
    else
        status = save_file(what, options, path, error);
    if (status != ROBERTS_OK)
        error_set_file(error, to_standard_output ? "standard output" : path);
    return status;
}

roberts_status save_from(const save_source *source, roberts_temporary_fn *temporary, void *temporary_context,
                         const char *path, roberts_error *error)
{
    roberts_draw_options options = roberts_draw_options_default();
    options.temporary = temporary;
    options.temporary_context = temporary_context;
    return save(&(subject){.source = source}, &options, path, error);
}

roberts_status roberts_drawing_save(const roberts_drawing *drawing, const roberts_draw_options *options,
                                    const char *path, roberts_error *error)
{
    return save(&(subject){.drawing = drawing}, options, path, error);
}

roberts_status roberts_sheet_save(const roberts_sheet *sheet, const roberts_draw_options *options, const char *path,
                                  roberts_error *error)
{
    return save(&(subject){.sheet = sheet}, options, path, error);
}

roberts_status roberts_regions_save(const roberts_region_list *regions, const roberts_draw_options *options,
                                    const char *path, roberts_error *error)
{
    roberts_draw_options own = roberts_draw_options_default();
    own.format = options && options->format == ROBERTS_CSV ? ROBERTS_CSV : ROBERTS_JSON;
    if (options) {
        own.temporary = options->temporary;
        own.temporary_context = options->temporary_context;
    }
    return save(&(subject){.regions = regions}, &own, path, error);
}
