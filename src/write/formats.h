/* formats.h - the page in each format. */
#ifndef ROBERTS_WRITE_FORMATS_H
#define ROBERTS_WRITE_FORMATS_H

#include "base/output.h"
#include "draw/strokes.h"

static const double mm_per_inch = 25.4;

/* Each writes the page. The caller finishes `out`, which records failed writes. Each returns ROBERTS_OK, _NO_MEMORY or
 * _IO; all but svg_write(), dxf_write() and hpgl_write() also _BAD_ARGUMENT. */
typedef roberts_status page_writer(const strokes *s, output *out, roberts_error *error);

page_writer svg_write;
page_writer pdf_write;
page_writer surface_write; /* PS and EPS, by Cairo's surfaces */
page_writer image_write;   /* PNG */
page_writer tikz_write;
page_writer dxf_write;
page_writer hpgl_write;

/* image_write() with about this many bytes of pixels in memory, more only for long dashes. The picture does not depend
 * on it. */
roberts_status image_write_bands(const strokes *s, size_t surface_bytes, output *out, roberts_error *error);

/* Writes UTF-8 as LaTeX source. A formula between dollar signs stays as it is. A control character becomes a question
 * mark, and so does a byte that is not UTF-8. (tikz.c) */
void tikz_text_write(output *out, const char *text);

/* How many characters of the text LaTeX does not define; control characters and bytes that are not UTF-8 count, too.
 * `first`, unless NULL, receives the first of them; 0: such a byte. (tikz.c) */
size_t tikz_text_missing(const char *text, uint32_t *first);

/* The same of characters that LaTeX defines, but not in its usual encoding, OT1. (tikz.c) */
size_t tikz_text_only_in_t1(const char *text, uint32_t *first);

/* How many characters of the text are in neither of the two fonts that every reader of PDF has, Helvetica and Symbol.
 * They become plain letters or question marks. `first`, unless NULL, receives the first of them; 0: a byte that is not
 * UTF-8. (pdf.c) */
size_t pdf_text_missing(const char *text, uint32_t *first);

#endif
