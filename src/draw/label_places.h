/* label_places.h - the places that a label may take; and the room that fitted drawings leave for labels. */
#ifndef ROBERTS_DRAW_LABEL_PLACES_H
#define ROBERTS_DRAW_LABEL_PLACES_H

#include "draw/label_targets.h"
#include "draw/sheet.h"

enum {
    VERTEX_SIDES = 16, /* directions from a vertex */
    VERTEX_RINGS = 4,  /* distances from it */
    EDGE_PLACES = 9,   /* along an edge, on each side */
    FACE_RINGS = 4,    /* of eight places each, round the middle of a region */
    LEADER_RINGS = 12  /* distances from the middle of a region, a height of the letters each */
};

/* The box of a label that has no place. */
#define NO_BOX UINT32_MAX

typedef struct label {
    const char *text;
    char number[NUMBER_SIZE]; /* `text` of what has no name */
    const target *of;
    roberts_vec2 half; /* mm, of the box that is kept free */
    uint32_t box;      /* in the room; or NO_BOX */
    roberts_vec2 middle;
    bool is_dropped; /* there is no room for it */
    bool has_leader;
    roberts_vec2 dot, leader; /* where the leader line begins, and where it ends beside the label */
} label;

/* The data for placing labels. */
typedef struct placing {
    free_space *room;
    free_space *vertices;            /* all that are drawn, as boxes without size */
    const page_view *view;           /* those of the page */
    double height, gap;              /* of the letters; round a label, and between a vertex and its label; mm */
    roberts_vec2 side[VERTEX_SIDES]; /* directions, counter-clockwise from that to the right */
} placing;

/* The next smaller height of letters (ISO 3098) to try, mm; 0: there is none, or the options give the height. */
double label_smaller_height(const roberts_draw_options *options, double height);

/* Data for letters of s->label_mm; `room` and `vertices` are not set. placing_set_height() changes the height. */
placing placing_of(const strokes *s);
void placing_set_height(placing *p, const strokes *s, double height);

/* Fills `list` with the labels of targets that have a text: visible ones first, then those with the fewest places.
 * Returns how many. */
size_t labels_make(const placing *p, const strokes *s, const targets *t, label *list);

static inline space_box label_box(const label *l, roberts_vec2 middle)
{
    return (space_box){{middle.x - l->half.x, middle.y - l->half.y}, {middle.x + l->half.x, middle.y + l->half.y}};
}

/* Whether letters reach below the base line. */
bool label_has_descender(const char *text);

/* How many places a label has, and the middle of place `i`; `*cost` receives what this costs for not being the best
 * one, in mm of lines that a label lies on. */
size_t label_places(const target *of);
roberts_vec2 label_place(const placing *p, const label *l, size_t i, double *cost);

/* The same with a leader line that begins at l->dot, VERTEX_SIDES * LEADER_RINGS places; `*end` receives the end of
 * that line. */
roberts_vec2 label_leader_place(const placing *p, const label *l, size_t i, roberts_vec2 *end, double *cost);

/* ---- room for labels beside a drawing ---- */

/* Whether there are labels of vertices or edges, which stand beside these. */
bool labels_stand_beside(const roberts_draw_options *options);

/* Letters are made smaller before labels make a drawing smaller than this part of its size without them. */
static const double labels_roomy = 0.75;

/* Makes room for labels beside a drawing that is to be fitted into the margins of `page`: widens its box from `min` to
 * `max` so that, once this box is fitted, labels of vertices and edges have room in their best places. `*height` is
 * that of the letters, mm, and is made smaller if the drawing would be too small. False: no memory. */
bool labels_make_room(const roberts_drawing *drawing, const roberts_draw_options *options, const roberts_page *page,
                      roberts_vec2 *min, roberts_vec2 *max, double *height);

/* Enlarges `reach` by the labels of vertices and edges in their best places, with letters of s->label_mm, on a sheet
 * that has been laid out. False: no memory. */
bool labels_add_reach(const strokes *s, sheet_reach *reach);

/* How far from the window of a drawing labels may reach where all pictures of a series have one window, mm; 0: there
 * are none beside it. */
double labels_reach(const roberts_draw_options *options);

#endif
