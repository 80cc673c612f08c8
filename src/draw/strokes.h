/* strokes.h - the strokes of a page: polylines by class, in the order in which they are drawn. */
#ifndef ROBERTS_DRAW_STROKES_H
#define ROBERTS_DRAW_STROKES_H

#include "draw/chain.h"
#include "draw/fills.h"
#include "draw/free_space.h"
#include "draw/notes.h"
#include "draw/page.h"
#include "draw/pens.h"

/* The polylines of one class, of one body in one view. */
typedef struct stroke_group {
    size_t first, end; /* polylines */
    uint32_t body;     /* ROBERTS_NONE: frame, symbol and text, which belong to no view */
    uint32_t view;     /* of the strokes' views; views: none */
    roberts_line line;
} stroke_group;

/* A drawing and its place on the page. */
typedef struct page_view {
    const roberts_drawing *drawing;
    page_map map;
    int place;              /* on a sheet: ROBERTS_SHEET_FRONT to _ISO */
    uint32_t first;         /* the number of its first segment */
    uint32_t first_region;  /* the number of its first region: after those of all segments */
    roberts_vec2 low, high; /* if the drawing is `framed`: its field of view, extended to the page's shape */
} page_view;

/* Points are rounded to the page's unit, 0.001 mm (0.01 mm if the page is longer than 4 m). That is far finer than a
 * pen and short to write, and neighbours that share an end still share it. */
typedef struct strokes {
    const roberts_draw_options *options;
    roberts_page page; /* that of the options, or what `crop` leaves of it */
    page_map map;      /* of a sheet: of its front view */
    double units_per_mm;
    int32_t thousandths;                 /* of a mm, in a unit */
    page_view view[ROBERTS_SHEET_VIEWS]; /* [views] those of a sheet that are there, or the only one */
    size_t views;
    const roberts_sheet *sheet;     /* NULL: a single drawing */
    const roberts_drawing *drawing; /* NULL: a sheet */
    double symbol_size;             /* of its symbol, as a part of full size; 0: there is none */
    roberts_vec2 symbol_mm;         /* the symbol's lower right corner */
    roberts_vec2 frame_mm[2];       /* upper left and lower right corner of the frame */
    notes notes;
    space_box *taken; /* [taken_count] boxes of text, and of the title block: further text and hatching avoid them */
    size_t taken_count, taken_room;
    double label_mm; /* height of the letters of labels, or what is to be tried; 0: there are none */
    fills fills;     /* below all lines */
    polylines lines;
    size_t start[LINE_CLASSES + 1]; /* class line_order[i] has the polylines start[i] .. start[i + 1] - 1 */
    /* SVG with groups: the polylines are in groups, and `start` is not used. */
    stroke_group *group;
    size_t group_count;
} strokes;

/* Lays the drawing on the page and makes strokes of it. The box of what is drawn decides where it lies. A drawing with
 * a field of view is laid there by its window, extended to the page's shape, and cut to it. `s` is released by
 * strokes_free() in any case. Returns ROBERTS_OK, _NO_MEMORY or _BAD_ARGUMENT (the drawing leaves the page at its
 * scale, or there are too many dashes). `options` have been checked. */
roberts_status strokes_make(strokes *s, const roberts_drawing *drawing, const roberts_draw_options *options,
                            roberts_error *error);
/* The same with the views of a sheet, and with its symbol. */
roberts_status strokes_make_sheet(strokes *s, const roberts_sheet *sheet, const roberts_draw_options *options,
                                  roberts_error *error);
void strokes_free(strokes *s);

/* Whether the polylines are in groups. */
static inline bool strokes_are_grouped(const roberts_draw_options *options)
{
    return options->format == ROBERTS_SVG && options->grouping != ROBERTS_GROUP_CLASS;
}

/* What the number of a piece stands for. */
typedef struct piece_source {
    uint32_t view, body;
    const roberts_segment *segment; /* NULL: a stroke of hatching */
    const roberts_region *region;   /* on which that stroke lies; otherwise NULL */
} piece_source;

piece_source strokes_source(const strokes *s, uint32_t number);

/* Adds a box to s->taken. False: no memory. */
bool strokes_take(strokes *s, const space_box *box);

/* Height of capitals, mm. */
double strokes_text_height(const roberts_draw_options *options);

/* Whether letters are text of the file's reader, and no strokes. */
bool strokes_text_is_native(const roberts_draw_options *options);

/* The width of text in mm. */
double strokes_text_width(const roberts_draw_options *options, const char *text, double height_mm);

/* Whether line `i` of the text is of this class, which is LINE_TEXT or LINE_HIDDEN_TEXT. */
static inline bool strokes_text_is_of(const strokes *s, size_t i, roberts_line class)
{
    return s->notes.item[i].is_back == (class == LINE_HIDDEN_TEXT);
}

/* Strokes go to Cairo, or into a file's path, in parts of this size: one by one they take several times as long, and
 * much larger parts take much memory. */
enum { SEGMENTS_PER_STROKE = 1000 };

/* The end of the part that begins with polyline `first`: as many polylines before `end` as have SEGMENTS_PER_STROKE
 * segments together. */
size_t strokes_part_end(const strokes *s, size_t first, size_t end);

/* Whether a segment has a place on the page, and its class. A class whose pen is off has its place: it draws nothing,
 * but all else stays where it is. So drawings for one pen each fit together. */
bool strokes_has_place(const roberts_draw_options *options, const roberts_segment *segment, roberts_line *line);

/* Whether a place of a view, in mm, is not cut off at the frame of a field of view. */
bool strokes_is_in_frame(const strokes *s, const page_view *view, roberts_vec2 mm);

/* How often and how far the pen goes. */
roberts_ink strokes_measure(const strokes *s);

#endif
