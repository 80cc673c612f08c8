/* off_lines.h - a text that is read once more, line by line, to explain what went wrong. */
#ifndef ROBERTS_MODEL_OFF_LINES_H
#define ROBERTS_MODEL_OFF_LINES_H

#include "model/off.h"

typedef struct text {
    const off_source *source;
    char *buffer; /* [OFF_BLOCK] */
    size_t size, at;
    uint64_t offset; /* of the byte after the buffer's last */
    size_t line;     /* of the next byte, from 1 */
    bool after_cr;
    bool cut; /* there may be more than is looked at */
} text;

/* A line with a word in it. */
typedef struct text_line {
    size_t number;
    unsigned words;
    unsigned integers; /* so many words, the first and those behind it, are digits alone */
    uint64_t value;    /* of the first of these; UINT64_MAX where it is too large */
    bool numbers;      /* each word begins as a number does */
    bool named;        /* each but the first, which begins with a letter */
    bool commas;       /* or semicolons, which here stand between words */
} text_line;

/* The reader's input from its beginning. The reader's buffer is lost. */
text text_begin(const off_reader *r);

/* Reads up to the end of the next line with a word. False: there is none, or none that is looked at. */
bool text_next_line(text *t, text_line *line);

#endif
