/* objet.h - the grid Objet[i][j]: which fronts touch which cell of the picture.
 *
 * Source: the lecture's last section. A front is what one solid shows: all its front faces are listed once, under their
 * common outline. A solid of many faces is listed face by face (see fronts.h). A cell lists its fronts by their nearest
 * corners, the nearest first, so that the first one that begins behind an edge ends the search. Covers are kept apart
 * (see cover.h). */
#ifndef ROBERTS_HIDE_OBJET_H
#define ROBERTS_HIDE_OBJET_H

#include <string.h>

#include "base/lanes.h"
#include "hide/fronts.h"
#include "hide/scan.h"

/* A front in a cell's list. */
typedef struct objet_entry {
    uint32_t front; /* of hide_fronts.front */
    uint32_t sides; /* of its box, counted in 256ths of the cell and cut to it, a byte for each: x0, 255 - x1, y0, 255 -
                       y1 */
} objet_entry;

/* Entries that can be read beyond a list, the last one's too. */
#define OBJET_SPARE 3

typedef struct objet {
    scan_frame frame;
    float from[4],
        per[4];      /* where cell (0, 0) begins and how many 256ths of a cell there are in a view unit: x, x, y, y */
    uint32_t *start; /* [nx * ny + 1] cell c lists entry[start[c]] .. entry[start[c + 1] - 1] */
    objet_entry *entry; /* [start[nx * ny] + OBJET_SPARE] */
    /* [as entry] where the list goes on with another solid, or ends. So the lines of a solid pass over all of its own
     * faces at once. A fan of very many triangles has all of them in the cell of its tip. NULL: no solid is listed face
     * by face. */
    uint32_t *next;
    /* [nx * ny] what layers.h finds; NULL: nothing */
    unsigned char *apart; /* 1: no two faces of the cell cross */
    cover sheet;          /* all that is deeper lies behind a sheet that fills the cell; `by` is not used */
    float *below;         /* what is nearer than this lies in that sheet, if it is a line */
} objet;

/* A cell that an edge meets, and between which of the edge's parameters. */
typedef struct objet_stretch {
    uint32_t column, row;
    double t0, t1;
} objet_stretch;

typedef struct objet_walk {
    objet_stretch *item;
    size_t count, room;
} objet_walk;

/* Fills the cells of `frame`, by at most so many threads (0: as many as there are). The threads do not change the
 * result. Returns ROBERTS_OK or _NO_MEMORY. */
roberts_status objet_build(objet *grid, const hide_fronts *fronts, scan_frame frame, uint32_t threads);
void objet_free(objet *grid);

/* A box in 256ths of cells from cell (0, 0) on, as lanes x0, x1, y0, y1. */
static inline four objet_place(const objet *grid, const hide_box *box)
{
    float side[4];
    memcpy(side, box, sizeof side);
    return four_mul(four_sub(four_load(side), four_load(grid->from)), four_load(grid->per));
}

/* ... cut to cell (i, j), a byte for each side. Rounding keeps the order of two sides. */
static inline uint32_t objet_cut(four place, uint32_t i, uint32_t j)
{
    const float column = 256.0f * (float)(int32_t)i, row = 256.0f * (float)(int32_t)j;
    const float from[4] = {column, column, row, row};
    return four_bytes(four_sub(place, four_load(from)));
}

/* The sides of an entry, from its box as objet_cut() gives it. */
static inline uint32_t objet_sides(uint32_t cut)
{
    return cut ^ 0xff00ff00;
}

/* The most that the sides of an entry can be if it meets this box within the cell. */
static inline uint32_t objet_most(uint32_t cut)
{
    return objet_sides((cut >> 8 & 0x00ff00ff) | (cut << 8 & 0xff00ff00));
}

/* Which of the four entries from k on, but before `end`, have no side above its most? Bit i stands for entry k + i. */
static inline unsigned objet_near(const objet *grid, uint32_t k, uint32_t end, uint32_t most)
{
    return four_bytes_at_most((const uint32_t *)(grid->entry + k), most) & (end - k < 4 ? (1u << (end - k)) - 1 : 15u);
}

/* The cells that AB touches, column by column; false: no memory. */
bool objet_cells(const objet *grid, roberts_vec3 A, roberts_vec3 B, objet_walk *walk);

#endif
