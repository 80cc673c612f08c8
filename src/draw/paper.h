/* paper.h - the page as PDF, PostScript, EPS and PNG. */
#ifndef ROBERTS_DRAW_PAPER_H
#define ROBERTS_DRAW_PAPER_H

#include "draw/output.h"
#include "draw/strokes.h"

/* The caller finishes `out`, which knows of failed writes. Returns ROBERTS_OK, _NO_MEMORY, _IO or _BAD_ARGUMENT. */
roberts_status paper_write(const strokes *s, output *out, roberts_error *error);

#endif
