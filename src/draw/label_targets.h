/* label_targets.h - what has a label on a page, and what the label says. */
#ifndef ROBERTS_DRAW_LABEL_TARGETS_H
#define ROBERTS_DRAW_LABEL_TARGETS_H

#include "draw/strokes.h"

/* What a label names. Vertices at one place of the picture are one. */
typedef struct target {
    roberts_label_kind kind;
    uint32_t view, number, other; /* as in roberts_name */
    bool is_back;                 /* hidden */
    roberts_vec2 at;              /* mm: the vertex, the middle of the edge's part, the middle of the region */
    roberts_vec2 along;           /* vertex: sum of the directions of its lines; edge: its direction */
    double reach;                 /* edge: half of the part's length; region: how far its border is; mm */
    double size;                  /* edge: length of the part; region: its area */
    double z;                     /* vertex: its depth, model units */
    uint32_t point;               /* vertex: its number among those of the page */
} target;

typedef struct targets {
    target *item;
    size_t count, room;
} targets;

/* The kinds of things that have labels: a set of roberts_label_kind. */
unsigned targets_kinds(const roberts_lettering *lettering);

/* Finds what has a label of one of these kinds, in all views: each thing once. `t` is empty; the caller frees t->item.
 * False: no memory. */
bool targets_find(const strokes *s, unsigned kinds, targets *t);

enum { NUMBER_SIZE = 32 };

/* What the label says: a name, or else a number, which is written to `number`. NULL: there is none. */
const char *target_text(const target *of, const roberts_draw_options *options, char number[NUMBER_SIZE]);

#endif
