/* hpgl.c - the page as HP-GL/2 (Hewlett-Packard, "HP-GL/2 and HP RTL Reference Guide", 1997), for pen plotters and
 * cutters.
 *
 * A class has a pen (SP). The file also gives the width and colour of the pen (PW, PC): plotters with real pens ignore
 * them. 40 units are a mm. The origin is the lower left corner of the page, or its middle, or lies at some distance
 * from there, and the page may be turned, as the plotter needs it. Coordinates are whole numbers, because many plotters
 * and cutters read no others. So they are accurate to half a unit, 0.0125 mm. */
#include <stdio.h>

#include "write/formats.h"
#include "write/plot.h"

enum {
    UNITS_PER_MM = 40,
    PENS = 16,         /* of the palette: a power of two above the number of classes */
    LINE_TYPE = 8,     /* the one that we define for dashes */
    POINTS_A_LINE = 20 /* then the text goes on in a new line */
};

typedef struct hpgl {
    const strokes *s;
    output *out;
    double units;         /* of HP-GL in a unit of the page */
    double width, height; /* of the page, in units of HP-GL */
    int32_t least;        /* the least coordinate that was written, or 0 */
} hpgl;

/* Writes an instruction up to `value`, and what stands behind it. */
static void write_integer(output *out, const char *before, uint32_t value, const char *behind)
{
    output_text(out, before);
    output_integer(out, value);
    output_text(out, behind);
}

/* Dashes and gaps as a line type of our own (UL, in percent of the pattern), and the pattern's length in mm (LT). */
static void write_dashes(output *out, const double dash[2])
{
    const double pattern = dash[0] + dash[1], percent = dash[0] / pattern * 100.0;
    write_integer(out, "UL", LINE_TYPE, ",");
    output_mm(out, percent);
    output_text(out, ",");
    output_mm(out, 100.0 - percent);
    write_integer(out, ";LT", LINE_TYPE, ",");
    output_mm(out, pattern);
    output_text(out, ",1;\n");
}

static void begin_class(void *context, roberts_line line)
{
    const hpgl *p = context;
    const roberts_pen *pen = pens_of(p->s->options, line);
    const uint32_t number = pens_class_number(p->s->options, line);
    double dash[2];
    write_integer(p->out, "SP", number, ";PW");
    output_mm(p->out, pen->width_mm);
    write_integer(p->out, ",", number, ";PC");
    write_integer(p->out, "", number, ",");
    write_integer(p->out, "", pen->red, ",");
    write_integer(p->out, "", pen->green, ",");
    write_integer(p->out, "", pen->blue, ";");
    if (pens_dash(p->s->options, line, dash))
        write_dashes(p->out, dash);
    else
        output_text(p->out, "LT;\n");
}

static uint32_t pen_of(void *context, roberts_line line)
{
    const hpgl *p = context;
    return pens_class_number(p->s->options, line);
}

static page_point on_plotter(const hpgl *p, page_point at)
{
    const roberts_plotter *axes = &p->s->options->plotter;
    double x = at.x * p->units, y = p->height - at.y * p->units, width = p->width, height = p->height;
    for (uint32_t turned = 0; turned < axes->turn; turned += 90) {
        const double up = x, side = width;
        x = height - y;
        y = up;
        width = height;
        height = side;
    }
    if (axes->centre) {
        x -= width / 2.0;
        y -= height / 2.0;
    }
    return page_rounded((roberts_vec2){x - UNITS_PER_MM * axes->inside_mm.x, y - UNITS_PER_MM * axes->inside_mm.y});
}

static void write_point(hpgl *p, page_point at)
{
    output_signed(p->out, at.x);
    output_bytes(p->out, ",", 1);
    output_signed(p->out, at.y);
    p->least = at.x < p->least ? at.x : p->least;
    p->least = at.y < p->least ? at.y : p->least;
}

/* Points that coincide after rounding are written once. So a tiny stroke becomes a dot. */
static void write_stroke(void *context, const page_point *point, size_t count, bool closed)
{
    hpgl *p = context;
    const page_point first = on_plotter(p, point[0]);
    page_point last = first;
    size_t written = 0;
    output_text(p->out, "PU");
    write_point(p, first);
    output_text(p->out, ";PD");
    for (size_t i = 1; i < count + closed; i++) {
        page_point at = i < count ? on_plotter(p, point[i]) : first;
        bool is_needed = at.x != last.x || at.y != last.y || (written == 0 && i + 1 == count + closed);
        if (!is_needed)
            continue;
        if (written++)
            output_text(p->out, written % POINTS_A_LINE == 0 ? ",\n" : ",");
        write_point(p, at);
        last = at;
    }
    output_text(p->out, ";\n");
}

/* Warns of lines beyond an origin in a corner: the pen of a plotter cannot go there. */
static void warn_outside(const hpgl *p)
{
    const roberts_warnings *to = &p->s->options->lettering.warnings;
    char text[120];
    if (p->least >= 0 || p->s->options->plotter.centre || !to->warn)
        return;
    snprintf(text, sizeof text, "lines reach %.1f mm beyond the plotter's origin; its pen may not go there",
             -(double)p->least / UNITS_PER_MM);
    to->warn(to->context, "", 0, text);
}

roberts_status hpgl_write(const strokes *s, output *out, roberts_error *error)
{
    const roberts_page *page = &s->page;
    hpgl p = {s, out, UNITS_PER_MM / s->units_per_mm, page->width_mm * UNITS_PER_MM, page->height_mm * UNITS_PER_MM, 0};
    const plotter to = {.begin = begin_class, .stroke = write_stroke, .pen = pen_of, .context = &p};
    write_integer(out, "IN;NP", PENS, ";\n");
    roberts_status status = plot_strokes(s, &to, out, error);
    output_text(out, "PU;SP0;\n");
    warn_outside(&p);
    return status;
}
