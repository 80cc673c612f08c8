/* pdf.h - text in PDF, in the two fonts that every reader has: Helvetica and Symbol. pdf_write() is in formats.h. */
#ifndef ROBERTS_DRAW_PDF_H
#define ROBERTS_DRAW_PDF_H

#include <stddef.h>

/* How many characters of the text these fonts lack; they become question marks. */
size_t pdf_text_missing(const char *text);

#endif
