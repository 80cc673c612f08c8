/* tikz_text.h - text for LaTeX. */
#ifndef ROBERTS_DRAW_TIKZ_TEXT_H
#define ROBERTS_DRAW_TIKZ_TEXT_H

#include "draw/output.h"

/* Writes UTF-8 as LaTeX shows it. A control character becomes a question mark, and so does a byte that is not UTF-8. */
void tikz_text_write(output *out, const char *text);

#endif
