/* svg.h - shared by the parts of an SVG: colours, text, pens. */
#ifndef ROBERTS_WRITE_SVG_H
#define ROBERTS_WRITE_SVG_H

#include "base/output.h"
#include "draw/strokes.h"

void svg_color(output *out, unsigned char red, unsigned char green, unsigned char blue);

/* Writes UTF-8 with <, > and & as entities. A byte that belongs to no character of XML 1.0, in its shortest form (RFC
 * 3629), becomes a question mark: a file's name may hold any bytes. */
void svg_text(output *out, const char *text);

/* Writes ` name="text"`, with quotes, line feeds and tabs as entities, too. */
void svg_attribute(output *out, const char *name, const char *text);
void svg_attribute_integer(output *out, const char *name, uint32_t value);

/* Writes ` id="..."` with the prefix of all ids. */
void svg_id(output *out, const roberts_draw_options *options, const char *name);

/* Writes the attributes that make a group a layer of Inkscape. number: before its name where layers are numbered. */
void svg_layer(output *out, const roberts_draw_options *options, uint32_t number, const char *name);

/* Writes the pen of a class as attributes. */
void svg_pen(output *out, const roberts_draw_options *options, roberts_line line);

/* Write the attributes that name a body, and a view of a sheet. */
void svg_body(output *out, const roberts_draw_options *options, uint32_t body);
void svg_view(output *out, const strokes *s, uint32_t view);

/* Writes the strokes in their groups. */
void svg_groups_write(const strokes *s, output *out);

#endif
