/* svg_fills.c - fills in SVG: a layer below all lines.
 *
 * Translucent areas have no seams, which would shine through. Instead viewers are asked not to smooth their borders.
 * Where layers are numbered, the name of this one begins with a percent sign: the software of AxiDraw leaves such
 * layers out, for a pen cannot fill. */
#include "draw/svg_fills.h"

static void write_color(output *out, const fill_color *color)
{
    static const char hex[] = "0123456789abcdef";
    const unsigned char part[] = {color->red, color->green, color->blue};
    output_text(out, "#");
    for (int i = 0; i < 3; i++) {
        output_bytes(out, &hex[part[i] >> 4], 1);
        output_bytes(out, &hex[part[i] & 15], 1);
    }
}

static void write_point(output *out, const char *command, page_point at, int32_t thousandths)
{
    output_bytes(out, command, 1);
    output_thousandths(out, at.x * thousandths);
    output_bytes(out, " ", 1);
    output_thousandths(out, at.y * thousandths);
}

static void write_path(const strokes *s, const fill_paint *paint, output *out)
{
    const int32_t thousandths = (int32_t)(1000.0 / s->units_per_mm + 0.5);
    output_text(out, paint->seam ? "<path stroke=\"" : "<path fill=\"");
    write_color(out, &paint->color);
    if (paint->color.alpha < 255) {
        output_text(out, "\" shape-rendering=\"crispEdges\" fill-opacity=\"");
        output_mm(out, paint->color.alpha / 255.0);
    }
    output_text(out, "\" d=\"");
    for (size_t i = paint->first; i < paint->end; i++) {
        const polyline *line = &s->fills.lines.item[i];
        const page_point *p = s->fills.lines.point + line->first;
        for (uint32_t k = 0; k < line->count; k++)
            write_point(out, k == 0 ? "M" : "L", p[k], thousandths);
        output_text(out, line->closed ? "Z\n" : "\n");
    }
    output_text(out, "\"/>\n");
}

void svg_write_fills(const strokes *s, output *out)
{
    const fills *f = &s->fills;
    if (f->count == 0)
        return;
    output_text(out, "<g id=\"fill\" inkscape:groupmode=\"layer\" inkscape:label=\"");
    output_text(out, s->options->number_layers ? "%fill\">\n" : "fill\">\n");
    if (f->paint[0].seam) {
        output_text(out, "<g fill=\"none\" stroke-width=\"");
        output_mm(out, f->seam_mm);
        output_text(out, "\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n");
    }
    for (size_t i = 0; i < f->count; i++) {
        if (i > 0 && f->paint[i - 1].seam && !f->paint[i].seam)
            output_text(out, "</g>\n");
        write_path(s, &f->paint[i], out);
    }
    output_text(out, "</g>\n");
}
