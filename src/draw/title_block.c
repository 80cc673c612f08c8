/* title_block.c - the title block of a sheet after ISO 7200, in the lower right corner: 180 mm wide, three rows;
 * centring marks and zones of the frame. */
#include "draw/title_block.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "draw/dimensions.h"

static const double row_mm = 9.0, caption_mm = 1.8, inset_mm = 1.2;

/* A cell: columns in mm from the left border, rows from the top. `field`: its name in roberts_field; NULL: the title,
 * the scale or the symbol. */
typedef struct block_cell {
    const char *caption, *field;
    double left, right;
    int top, bottom;
} block_cell;

enum { TITLE_CELL = 1, SCALE_CELL = 2, SYMBOL_CELL = 3 };

static const block_cell cells[] = {
    {"Owner", "owner", 0.0, 60.0, 0, 1},     {"Title", NULL, 60.0, 150.0, 0, 2},
    {"Scale", NULL, 150.0, 180.0, 0, 1},     {"", NULL, 150.0, 180.0, 1, 2},
    {"Author", "author", 0.0, 60.0, 1, 2},   {"Approved by", "approved", 0.0, 60.0, 2, 3},
    {"Number", "number", 60.0, 112.0, 2, 3}, {"Revision", "revision", 112.0, 126.0, 2, 3},
    {"Date", "date", 126.0, 156.0, 2, 3},    {"Sheet", "sheet", 156.0, 180.0, 2, 3},
};

bool title_block_is_wanted(const roberts_draw_options *options)
{
    return options->lettering.title || options->lettering.field_count > 0;
}

/* In the middle of its cell. */
roberts_vec2 title_block_symbol(double *size)
{
    const block_cell *cell = &cells[SYMBOL_CELL];
    *size = 0.7;
    return (roberts_vec2){(cell->right - cell->left - *size * SYMBOL_WIDTH) / 2.0,
                          row_mm + (row_mm - *size * SYMBOL_HEIGHT) / 2.0};
}

static const char *find_field(const roberts_lettering *lettering, const char *name)
{
    for (size_t i = 0; name && i < lettering->field_count; i++)
        if (strcmp(lettering->field[i].name, name) == 0)
            return lettering->field[i].text;
    return "";
}

/* The ratio of the drawing to the object: 1:20, 2:1. */
static void scale_text(const strokes *s, char *text, size_t size)
{
    const double ratio = page_scale(&s->map) / page_unit_mm(&s->options->placement);
    char number[40];
    dimension_text(ratio < 1.0 ? 1.0 / ratio : ratio, NULL, number, sizeof number);
    snprintf(text, size, ratio < 1.0 ? "1:%s" : "%s:1", number);
}

/* mm: the smallest letters of ISO 3098 that are easy to read. */
static const double readable_mm = 1.8;

static void warn_small(const strokes *s, const block_cell *cell, double height)
{
    const roberts_warnings *to = &s->options->lettering.warnings;
    char text[120];
    if (height >= readable_mm || !to->warn)
        return;
    snprintf(text, sizeof text,
             "title block: the letters of \"%s\" are only %.2g mm high, so that they fit into their cell",
             cell->caption, height);
    to->warn(to->context, "", 0, text);
}

/* Breaks a text at blanks into lines no wider than `width`, and ends each with a NUL. Returns how many, or 0 if it
 * takes more than `most` or a word is wider. */
static int wrap_text(char *text, double height, double width, int most)
{
    char *line = text, *blank = NULL; /* the last one where the line can end */
    int lines = 1;
    for (char *at = text;; at++) {
        const char here = *at;
        if (here && here != ' ')
            continue;
        *at = '\0';
        if (letters_width(line, height) > width && blank) {
            *blank = '\0';
            line = blank + 1;
            lines++;
        }
        if (lines > most || letters_width(line, height) > width)
            return 0;
        if (!here)
            return lines;
        *at = here;
        blank = at;
    }
}

/* mm: the room for lines of a title below its caption; the largest and the smallest letters of several lines. */
static const double title_room_mm = 12.0, lines_most_mm = 3.5, lines_least_mm = 0.5;
/* How far their base lines are apart, in heights of letters. */
static const double line_pitch = 1.6;

/* How high this many lines are together, in heights of letters. */
static double lines_high(int lines)
{
    return 1.0 + line_pitch * (lines - 1) + LETTERS_DEPTH;
}

/* A title in several lines, each ended by a NUL. */
typedef struct title_lines {
    char *text;
    int count;
    double height; /* of the letters, mm */
} title_lines;

/* Breaks a title into lines no wider than `width` whose letters are larger than `least`, if there is a way; otherwise
 * there are no lines. False: no memory. The caller frees the text. */
static bool break_title(title_lines *t, const char *title, double width, double least)
{
    const size_t size = strlen(title) + 1;
    double height = lines_most_mm;
    *t = (title_lines){.text = alloc_array(size, 1)};
    while (t->text && !t->count && height > fmax(least, lines_least_mm)) {
        const double most = (title_room_mm / height - 1.0 - LETTERS_DEPTH) / line_pitch + 1.0;
        memcpy(t->text, title, size);
        t->count = wrap_text(t->text, height, width, (int)most);
        t->height = height;
        height *= 0.97;
    }
    return t->text;
}

/* Writes the lines, in the middle of the room that ends above `at`. False: no memory. */
static bool put_lines(strokes *s, const title_lines *t, roberts_vec2 at)
{
    const char *part = t->text;
    const double first = at.y - (title_room_mm + t->height * lines_high(t->count)) / 2.0 + t->height;
    for (int i = 0; i < t->count; i++) {
        const text_line line = {part, {at.x, first + t->height * line_pitch * i}, t->height, 0.0, TEXT_LEVEL};
        if (!notes_add_text(&s->notes, &line))
            return false;
        part += strlen(part) + 1;
    }
    return true;
}

/* Writes a text into a cell, smaller if it is too wide; the title in several lines, if that leaves it larger. */
static bool fill_cell(strokes *s, const block_cell *cell, roberts_vec2 corner, const char *text)
{
    const double width = cell->right - cell->left - 2.0 * inset_mm, left = corner.x + cell->left + inset_mm;
    const double top = corner.y + cell->top * row_mm, bottom = corner.y + cell->bottom * row_mm;
    const bool is_high = cell->bottom - cell->top > 1;
    text_line line = {cell->caption, {left, top + inset_mm + caption_mm}, caption_mm, 0.0, TEXT_LEVEL};
    if (*cell->caption && !notes_add_text(&s->notes, &line))
        return false;
    if (!*text)
        return true;
    const double high = is_high ? 5.0 : 2.5, height = fmin(high, high * width / letters_width(text, high));
    title_lines title = {0};
    bool enough = !is_high || break_title(&title, text, width, height);
    warn_small(s, cell, title.count > 0 ? title.height : height);
    line = (text_line){text, {left, bottom - (is_high ? 5.0 : 1.7)}, height, 0.0, TEXT_LEVEL};
    if (enough && title.count > 0)
        enough = put_lines(s, &title, (roberts_vec2){left, bottom - inset_mm});
    else if (enough)
        enough = notes_add_text(&s->notes, &line);
    free(title.text);
    return enough;
}

/* The border of the block. Its right and lower sides lie on the frame, if there is one. */
static bool add_block_border(strokes *s, roberts_vec2 corner)
{
    const roberts_vec2 end = s->frame_mm[1];
    if (s->options->frame.off)
        return notes_add_box(&s->notes, corner, end, s->units_per_mm);
    return notes_add_line(&s->notes, (roberts_vec2){corner.x, end.y}, corner, s->units_per_mm) &&
           notes_add_line(&s->notes, corner, (roberts_vec2){end.x, corner.y}, s->units_per_mm);
}

bool title_block_add(strokes *s)
{
    const roberts_lettering *lettering = &s->options->lettering;
    const roberts_vec2 corner = {s->frame_mm[1].x - BLOCK_WIDTH, s->frame_mm[1].y - BLOCK_HEIGHT};
    char scale[60];
    bool done = true;
    if (!title_block_is_wanted(s->options))
        return true;
    scale_text(s, scale, sizeof scale);
    if (!strokes_take(s, &(space_box){corner, s->frame_mm[1]}))
        return false;
    for (size_t i = 0; i < sizeof cells / sizeof cells[0] && done; i++) {
        const block_cell *cell = &cells[i];
        const char *text = i == TITLE_CELL    ? (lettering->title ? lettering->title : "")
                           : i == SCALE_CELL  ? scale
                           : i == SYMBOL_CELL ? ""
                                              : find_field(lettering, cell->field);
        done = fill_cell(s, cell, corner, text);
        if (done && cell->right < BLOCK_WIDTH) /* right and lower side; those of the block are its border */
            done = notes_add_line(&s->notes, (roberts_vec2){corner.x + cell->right, corner.y + cell->top * row_mm},
                                  (roberts_vec2){corner.x + cell->right, corner.y + cell->bottom * row_mm},
                                  s->units_per_mm);
        if (done && cell->bottom < 3)
            done = notes_add_line(&s->notes, (roberts_vec2){corner.x + cell->left, corner.y + cell->bottom * row_mm},
                                  (roberts_vec2){corner.x + cell->right, corner.y + cell->bottom * row_mm},
                                  s->units_per_mm);
    }
    return done && add_block_border(s, corner);
}

/* ---- zones of the frame ------------------------------------------------------------------------------------------ */

/* Centring marks and zones of a frame after ISO 5457: fields of 50 mm, counted from the middle of each side,
 * with letters from top to bottom and numbers from left to right. */

/* mm */
static const double field_mm = 50.0, strip_mm = 5.0, letter_mm = 2.5;

/* Where field `i` of a side of this length ends, from its start; the outer fields take the rest. */
static double field_end(double length, int fields, int i)
{
    return i + 1 == fields ? length : length / 2.0 + (i + 1 - fields / 2) * field_mm;
}

/* Fields on a side: an even number, so that the middle is between two. */
static int count_fields(double length)
{
    const int half = (int)ceil(length / 2.0 / field_mm - 0.5);
    return 2 * (half < 1 ? 1 : half > 12 ? 12 : half);
}

/* Is a point of the lower side of the frame on the title block? No mark runs into the block. */
static bool is_at_block(const strokes *s, double x)
{
    return s->sheet && title_block_is_wanted(s->options) && x > s->frame_mm[1].x - BLOCK_WIDTH;
}

/* A point by its coordinates along a level or upright side and across it. */
static roberts_vec2 by_side(bool is_level, double along, double across)
{
    return is_level ? (roberts_vec2){along, across} : (roberts_vec2){across, along};
}

static bool add_zones(strokes *s, bool is_level)
{
    static const char letters[] = "ABCDEFGHJKLMNPQRSTUVWXYZ"; /* without I and O */
    const roberts_vec2 low = s->frame_mm[0], high = s->frame_mm[1];
    const double start = is_level ? low.x : low.y, length = (is_level ? high.x : high.y) - start;
    const int fields = count_fields(length);
    double begin = 0.0;
    bool done = true;
    for (int i = 0; i < fields && done; i++) {
        const double end = field_end(length, fields, i), middle = start + (begin + end) / 2.0, at = start + end;
        const char text[] = {is_level ? (char)('0' + (i + 1) / 10) : letters[i], (char)('0' + (i + 1) % 10), '\0'};
        const char name[] = {text[0], '\0'};
        const char *shown = is_level ? (i + 1 < 10 ? text + 1 : text) : name;
        for (int side = 0; side < 2 && done; side++) {
            const double edge = is_level ? (side ? high.y : low.y) : (side ? high.x : low.x), out = side ? 1.0 : -1.0;
            const bool is_centre = i + 1 == fields / 2, is_lower = is_level && side == 1;
            const double off = edge + out * strip_mm / 2.0, far = edge + out * strip_mm,
                         near = is_centre && !(is_lower && is_at_block(s, at)) ? edge - out * CENTRE_MARK : edge;
            text_line line = {shown, by_side(is_level, middle, off), letter_mm, 0.5, TEXT_LEVEL};
            line.at.y += letter_mm / 2.0;
            done = notes_add_text(&s->notes, &line);
            if (done && i + 1 < fields)
                done =
                    notes_add_line(&s->notes, by_side(is_level, at, far), by_side(is_level, at, near), s->units_per_mm);
        }
        begin = end;
    }
    return done;
}

bool zones_add(strokes *s)
{
    return !s->options->lettering.zones || s->options->frame.off || (add_zones(s, true) && add_zones(s, false));
}
