/* tikz_text.h - text for LaTeX. */
#ifndef ROBERTS_DRAW_TIKZ_TEXT_H
#define ROBERTS_DRAW_TIKZ_TEXT_H

#include "draw/output.h"

/* Writes UTF-8 as LaTeX shows it. A byte that is not UTF-8 becomes a question mark. */
void tikz_text_write(output *out, const char *text);

#endif
