/* letters.h - lines of text as strokes of a pen, upright letters near ISO 3098, the same on every machine. */
#ifndef ROBERTS_DRAW_LETTERS_H
#define ROBERTS_DRAW_LETTERS_H

#include "draw/chain.h"

/* A line of text on the page. */
typedef struct text_line {
    const char *text; /* UTF-8 */
    roberts_vec2 at;  /* a point of its base line, mm from the upper left corner of the page */
    double height_mm; /* of capital letters */
    double align;     /* how much of its width lies before `at`: 0 the text begins there, 0.5 it is centred, 1 */
    /* The direction of its base line on the page, a unit vector, y down: TEXT_LEVEL, TEXT_UPRIGHT or any other. */
    roberts_vec2 along;
} text_line;

#define TEXT_LEVEL ((roberts_vec2){1.0, 0.0})
#define TEXT_UPRIGHT ((roberts_vec2){0.0, -1.0}) /* turned by 90 degrees, to be read from the right */

/* The direction from the base line to the tops of the letters. */
static inline roberts_vec2 text_upward(roberts_vec2 along)
{
    return (roberts_vec2){along.y, -along.x};
}

/* How far letters reach above and below their base line, as fractions of the height of capitals. Accents of capitals
 * reach higher. */
#define LETTERS_DEPTH (7.0 / 21.0)

/* How far the line is turned counter-clockwise, in degrees: 0 where it is level. */
double text_degrees(const text_line *line);

/* Width in mm. */
double letters_width(const char *text, double height_mm);

/* About the width in LaTeX, where a formula has one letter for each of its signs. */
double letters_tex_width(const char *text, double height_mm);

/* The bytes of the formula that the text begins with, from one dollar sign to the next; 0: there is none. In a formula
 * the braces match. */
size_t letters_formula(const char *text);

/* Appends the strokes. A character that the fonts lack becomes a box, and so does a byte that is not UTF-8. False: no
 * memory. */
bool letters_draw(const text_line *line, double units_per_mm, polylines *out);

/* How many characters of the text the fonts lack, bytes that are not UTF-8 among them. `first`, unless NULL, receives
 * the first of them (0: a byte that is not UTF-8) if there is one. */
size_t letters_missing(const char *text, uint32_t *first);

/* The character at `text`, which is not at its end; 0 for a byte that is not UTF-8. `length` receives its bytes. */
uint32_t letters_decode(const char *text, size_t *length);

/* The number of a Greek letter in its alphabet: 1 to 24 for small letters, 33 to 56 for capitals; 0: it is none. */
int letters_greek_number(uint32_t code);

/* The ASCII letters that stand for a character, without its accent: "e" for an e with acute, "AE" for that ligature;
 * `count` receives how many. NULL: there are none, as for Greek letters and what the fonts lack. */
const char *letters_plain(uint32_t code, size_t *count);

/* 1 above the line (a square, say), -1 below it, 0 on it. */
int letters_level(uint32_t code);

#endif
