/* notes.h - text on a page beside the drawing: lines of text, and the lines of title blocks and dimensions. Together
 * they are the class "text", or "hidden-text" if a label names something hidden. */
#ifndef ROBERTS_DRAW_NOTES_H
#define ROBERTS_DRAW_NOTES_H

#include "draw/letters.h"

typedef struct note {
    size_t text; /* place in notes.chars */
    roberts_vec2 at;
    double height_mm, align;
    roberts_vec2 along; /* as in text_line */
    bool is_back;       /* a label of something hidden */
    roberts_name of;    /* what a label names, without the text; of.of is 0 where the note is no label */
} note;

typedef struct notes {
    char *chars;
    note *item;
    size_t char_count, char_room, count, room;
    polylines lines; /* points in units of the page */
} notes;

/* Each returns false where there is no memory. */
bool notes_add_text(notes *n, const text_line *line);
bool notes_add_label(notes *n, const text_line *line, const roberts_name *of, bool is_back);
bool notes_add_line(notes *n, roberts_vec2 a, roberts_vec2 b, double units_per_mm);
/* A small ring, which looks like a dot. */
bool notes_add_dot(notes *n, roberts_vec2 at, double radius_mm, double units_per_mm);
bool notes_add_box(notes *n, roberts_vec2 a, roberts_vec2 b, double units_per_mm);

/* A note as a line of text, valid until the next one is added. */
text_line notes_line(const notes *n, size_t i);

/* Appends the strokes of one of the two classes, without letters where `native`. */
bool notes_draw(const notes *n, bool is_back, bool native, double units_per_mm, polylines *out);

void notes_free(notes *n);

#endif
