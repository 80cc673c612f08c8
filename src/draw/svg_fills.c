/* svg_fills.c - fills in SVG: a layer below all lines.
 *
 * Translucent areas have no seams, which would shine through. Instead viewers are asked not to smooth their borders.
 * Where layers are numbered, the name of this one begins with a percent sign: the software of AxiDraw leaves such
 * layers out, for a pen cannot fill. */
#include "draw/svg_fills.h"

#include "draw/page_regions.h"
#include "draw/svg.h"

static void write_point(output *out, const char *command, page_point at, int32_t thousandths)
{
    output_bytes(out, command, 1);
    output_thousandths(out, at.x * thousandths);
    output_bytes(out, " ", 1);
    output_thousandths(out, at.y * thousandths);
}

/* Writes a colour, and what it needs if it is translucent, up to the quote of the last value. */
static void write_color(output *out, const fill_color *color)
{
    svg_color(out, color->red, color->green, color->blue);
    if (color->alpha < 255) {
        output_text(out, "\" shape-rendering=\"crispEdges\" fill-opacity=\"");
        output_mm(out, color->alpha / 255.0);
    }
    output_text(out, "\"");
}

static void write_path(const strokes *s, const fill_paint *paint, output *out)
{
    const int32_t thousandths = (int32_t)(1000.0 / s->units_per_mm + 0.5);
    output_text(out, paint->seam ? "<path stroke=\"" : "<path fill=\"");
    write_color(out, &paint->color);
    output_text(out, " d=\"");
    for (size_t i = paint->first; i < paint->end; i++) {
        const polyline *line = &s->fills.lines.item[i];
        const page_point *p = s->fills.lines.point + line->first;
        for (uint32_t k = 0; k < line->count; k++)
            write_point(out, k == 0 ? "M" : "L", p[k], thousandths);
        output_text(out, line->closed ? "Z\n" : "\n");
    }
    output_text(out, "\"/>\n");
}

/* ---- each region by itself ---- */

typedef struct region_writer {
    const strokes *s;
    output *out;
    const page_view *view; /* of the region before; NULL: there is none */
    uint32_t body;         /* of the region before */
} region_writer;

/* Closes and opens the groups of views and bodies from the region before to this one. NULL: there are no more. */
static void change_groups(region_writer *w, const page_region *on)
{
    const bool same_view = on && w->view == on->view;
    if (same_view && w->body == on->region->solid)
        return;
    if (w->view)
        output_text(w->out, "</g>\n");
    if (w->view && !same_view && w->s->sheet)
        output_text(w->out, "</g>\n");
    if (!on)
        return;
    if (!same_view && w->s->sheet) {
        output_text(w->out, "<g");
        svg_view(w->out, w->s, (uint32_t)(on->view - w->s->view));
        output_text(w->out, ">\n");
    }
    output_text(w->out, "<g");
    svg_body(w->out, w->s->options, on->region->solid);
    output_text(w->out, ">\n");
    w->view = on->view;
    w->body = on->region->solid;
}

static bool write_region(void *context, const page_region *on)
{
    region_writer *w = context;
    const fill_color color = fills_color(w->s->options, on->region);
    const int32_t thousandths = (int32_t)(1000.0 / w->s->units_per_mm + 0.5);
    if (on->ring_count == 0 || color.alpha == 0)
        return true;
    change_groups(w, on);
    output_text(w->out, "<path class=\"region\"");
    if (on->region->face != ROBERTS_NONE) {
        output_text(w->out, " data-face=\"");
        output_integer(w->out, on->region->face);
        output_text(w->out, "\"");
    }
    output_text(w->out, " fill=\"");
    write_color(w->out, &color);
    output_text(w->out, " d=\"");
    for (size_t r = 0; r < on->ring_count; r++) {
        for (size_t k = on->ring_start[r]; k < on->ring_start[r + 1]; k++)
            write_point(w->out, k == on->ring_start[r] ? "M" : "L",
                        (page_point){page_round(on->point[k].x), page_round(on->point[k].y)}, thousandths);
        output_text(w->out, "Z");
    }
    output_text(w->out, "\"/>\n");
    return true;
}

static bool write_regions(const strokes *s, output *out)
{
    region_writer w = {.s = s, .out = out};
    const bool done = page_regions_walk(s, write_region, &w);
    change_groups(&w, NULL);
    return done;
}

/* ---- the layer ---- */

bool svg_write_fills(const strokes *s, output *out)
{
    const fills *f = &s->fills;
    const bool grouped = strokes_are_grouped(s->options);
    bool done = true;
    if (f->count == 0)
        return true;
    output_text(out, "<g");
    svg_id(out, s->options, "fill");
    if (grouped)
        output_text(out, " class=\"fill\"");
    output_text(out, " inkscape:groupmode=\"layer\" inkscape:label=\"");
    output_text(out, s->options->number_layers ? "%fill\">\n" : "fill\">\n");
    if (f->paint[0].seam) {
        output_text(out,
                    grouped ? "<g class=\"seam\" fill=\"none\" stroke-width=\"" : "<g fill=\"none\" stroke-width=\"");
        output_mm(out, f->seam_mm);
        output_text(out, "\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n");
    }
    for (size_t i = 0; i < f->count; i++) {
        if (i > 0 && f->paint[i - 1].seam && !f->paint[i].seam)
            output_text(out, "</g>\n");
        if (f->paint[i].seam || !grouped)
            write_path(s, &f->paint[i], out);
    }
    if (grouped)
        done = write_regions(s, out);
    output_text(out, "</g>\n");
    return done;
}
