/* tikz.h - text for LaTeX; tikz_write() is in formats.h. */
#ifndef ROBERTS_DRAW_TIKZ_H
#define ROBERTS_DRAW_TIKZ_H

#include "draw/output.h"

/* Writes UTF-8 as LaTeX source. A control character becomes a question mark, and so does a byte that is not UTF-8. */
void tikz_text_write(output *out, const char *text);

#endif
