/* off_odd.h - which line of a text is not as its header says, or not as the lines before it. */
#ifndef ROBERTS_MODEL_OFF_ODD_H
#define ROBERTS_MODEL_OFF_ODD_H

#include "model/off_lines.h"

enum { ODD_HINT = 120 };

typedef struct odd_line {
    size_t number;
    const char *question; /* "" or what seems to be missing, where that can be told */
    bool sure;            /* worth saying without an error, where something else is doubtful as well */
    char hint[ODD_HINT];  /* "line 7 has 2 words, ..." */
} odd_line;

/* Looks at vertices and faces from the text's beginning on, and claims nothing of lines after `last`. False: nothing is odd. */
bool odd_find(const off_header *h, text *t, size_t last, odd_line *odd);

#endif
