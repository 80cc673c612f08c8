/* edge.h - edges through the grid: what hides them, and whom the viewer sees there instead. */
#ifndef ROBERTS_HIDE_EDGE_H
#define ROBERTS_HIDE_EDGE_H

#include "hide/objet.h"
#include "hide/pair.h"
#include "hide/parts.h"

/* A solid of more edges than this is taken edge by edge. A multiple of 4. */
#define HIDE_GROUP 64

/* An edge at work. */
typedef struct hide_line {
    hide_edge e;
    hide_parts parts; /* hidden so far */
    hide_parts hulls; /* ... by solids entered face by face: one interval for each of them */
    bool hidden;      /* wholly: nothing more need be asked */
    uint32_t edge;    /* of the scene */
} hide_line;

/* Scratch memory of one thread, serving solid after solid. */
typedef struct hide_worker {
    const hide_picture *picture;
    const objet *grid;
    hide_sides sides;
    objet_walk walk;
    double margin;   /* hide_margin() */
    hide_line *line; /* [line_count] the edges at work, all of one solid; those beyond keep their memory */
    size_t line_count, line_room;
    hide_box box; /* of all of them */
    /* Boxes of the first of them, rounded outward, side by side; one that is wholly hidden begins at infinity, and so
     * do those that fill up the last four. */
    float x0[HIDE_GROUP], x1[HIDE_GROUP], y0[HIDE_GROUP], y1[HIDE_GROUP], z0[HIDE_GROUP];
    size_t live;    /* lines of the group at work that are not wholly hidden */
    uint32_t *seen; /* [front_count] the last group of edges that met the front */
    uint32_t stamp; /* of the group at work */
    roberts_tally tally;
} hide_worker;

/* False: no memory; hide_worker_free() is due in any case. */
bool hide_worker_init(hide_worker *w, const hide_picture *picture, const objet *grid);
void hide_worker_free(hide_worker *w);

/* Begins a solid. */
static inline void hide_worker_begin(hide_worker *w)
{
    w->line_count = 0;
    w->box = (hide_box){INFINITY, -INFINITY, INFINITY, -INFINITY, INFINITY, -INFINITY};
}

/* Takes up one more edge of the scene; NULL: no memory. */
hide_line *hide_worker_add(hide_worker *w, uint32_t edge);

/* Finds what the other solids hide of the lines taken up, edges of `solid`: their parts ascend and are disjoint. False:
 * no memory. */
bool hide_worker_run(hide_worker *w, uint32_t solid);

/* The solid seen at picture point (x, y), the one of smallest number where several touch there; ROBERTS_NONE where no
 * front face is. */
uint32_t hide_seen_at(const hide_worker *w, double x, double y);

#endif
