/* pdf_text.h - text in PDF, in the two fonts that every reader has: Helvetica and Symbol. */
#ifndef ROBERTS_DRAW_PDF_TEXT_H
#define ROBERTS_DRAW_PDF_TEXT_H

#include "draw/output.h"
#include "draw/strokes.h"

/* The fonts, as a part of the page's resources; empty if the page has no text but strokes. */
const char *pdf_text_fonts(const strokes *s);

/* Writes the text of the page, in its units. */
void pdf_text_write(const strokes *s, output *to);

/* How many characters of the text these fonts lack; they become question marks. */
size_t pdf_text_missing(const char *text);

#endif
