/* objet.h - the grid Objet[i][j]: which fronts touch which cell of the picture.
 *
 * Source: the lecture's last section. Here cells list fronts (see fronts.h): a convex solid of few faces is listed
 * once, other bodies face by face. The list of a cell is sorted by the fronts' nearest corners, nearest first. So a
 * search ends at the first front that lies wholly behind the edge. Covers have cells of their own (see cover.h). */
#ifndef ROBERTS_HIDE_OBJET_H
#define ROBERTS_HIDE_OBJET_H

#include <stdatomic.h>
#include <string.h>

#include "base/lanes.h"
#include "hide/cells.h"
#include "hide/front_tree.h"

/* A front in a cell's list. */
typedef struct objet_entry {
    uint32_t front; /* of hide_fronts.front */
    uint32_t sides; /* its box, cut to the cell, in 256ths of the cell: x0, 255 - x1, y0, 255 - y1, a byte each */
} objet_entry;

/* What is known of the faces about a vertex: a fold ends there; they go round it once, or more often. */
enum { STAR_FOLD = 1, STAR_ONCE = 2, STAR_TWICE = 4 };

/* This many entries can be read beyond the end of any list. */
#define OBJET_SPARE 3

typedef struct objet {
    scan_frame frame;
    float from[4];      /* where cell (0, 0) begins: x, x, y, y */
    float per[4];       /* 256ths of a cell in a view unit, likewise */
    uint32_t *start;    /* [nx * ny + 1] cell c lists entry[start[c]] .. entry[start[c + 1] - 1] */
    objet_entry *entry; /* [start[nx * ny] + OBJET_SPARE] */
    size_t room;        /* of `entry` */
    /* For each entry, the first later entry of another solid, or the end of the list. So the lines of a convex solid
     * pass over all of its own faces at once: a fan of very many triangles lists all of them in the cell of its tip.
     * NULL: no convex solid is listed face by face. */
    uint32_t *next;
    front_tree *tree; /* [nx * ny] over the fronts of long lists; no nodes: the list is short. NULL: all are, or `next`
                         is there */
    /* [nx * ny] found by layers.h; NULL: nothing is found */
    unsigned char *apart; /* 1: no two faces cross in the cell; unless hidden lines are wanted: none before the sheet */
    cover sheet;          /* everything deeper lies behind a sheet that fills the cell; `by` is not used */
    float *below;         /* every line that is nearer than this lies in that sheet */
    atomic_uchar *star;   /* [vertices] STAR_FOLD: a fold ends there. (crossing_filter.c adds more.) NULL: not known */
} objet;

/* A cell that an edge meets, from parameter t0 of the edge to t1. */
typedef struct objet_stretch {
    uint32_t column, row;
    double t0, t1;
} objet_stretch;

typedef struct objet_walk {
    objet_stretch *item;
    size_t count, room;
} objet_walk;

/* Lists all fronts in the cells of `frame`, and finds the cells that sheets fill. Faces that wait become fronts. The
 * grid owns the warps of the frame.
 * threads: upper bound; 0: as many as there are. They do not change the result. Returns ROBERTS_OK or _NO_MEMORY. */
roberts_status objet_build(objet *grid, hide_fronts *fronts, scan_frame frame, uint32_t threads);
void objet_free(objet *grid);

/* Columns and rows. */
typedef struct objet_range {
    uint32_t left, right, low, high;
} objet_range;

/* Returns the columns and rows that a box touches, if it is widened by m on all sides. */
BITS_INLINE objet_range objet_range_of(const scan_frame *f, const hide_box *box, double m)
{
    double left = (double)box->x0 - m, right = (double)box->x1 + m, low = (double)box->y0 - m,
           high = (double)box->y1 + m;
    if (f->warps)
        return (objet_range){scan_column(f, left), scan_column(f, right), scan_row(f, low), scan_row(f, high)};
    two x = two_of(left, right), y = two_of(low, high);
    x = two_mul(two_sub(x, two_all(f->x0)), two_all(f->per_dx)); /* as scan_column() and scan_row() do */
    y = two_mul(two_sub(y, two_all(f->y0)), two_all(f->per_dy));
    two_part(&left, &right, two_lesser(two_greater(x, two_all(0.0)), two_all(f->last_x)));
    two_part(&low, &high, two_lesser(two_greater(y, two_all(0.0)), two_all(f->last_y)));
    return (objet_range){(uint32_t)left, (uint32_t)right, (uint32_t)low, (uint32_t)high};
}

/* Maps the sides x0, x1, y0, y1 of a box. */
void objet_warp_sides(const warp warps[2], float side[4]);

/* Returns a box in 256ths of cells, counted from cell (0, 0), as lanes x0, x1, y0, y1. */
static inline four objet_place(const objet *grid, const hide_box *box)
{
    float side[4];
    memcpy(side, box, sizeof side);
    if (grid->frame.warps)
        objet_warp_sides(grid->frame.warps, side);
    return four_mul(four_sub(four_load(side), four_load(grid->from)), four_load(grid->per));
}

/* Cuts such a box to cell (i, j), with a byte for each side. Rounding keeps the order of any two sides. */
static inline uint32_t objet_cut(four place, uint32_t i, uint32_t j)
{
    const float column = 256.0f * (float)(int32_t)i, row = 256.0f * (float)(int32_t)j;
    const float from[4] = {column, column, row, row};
    return four_bytes(four_sub(place, four_load(from)));
}

/* Returns the sides of an entry, from its box as objet_cut() gives it. */
static inline uint32_t objet_sides(uint32_t cut)
{
    return cut ^ 0xff00ff00;
}

/* Returns the largest sides that an entry can have if it meets this box within the cell. */
static inline uint32_t objet_most(uint32_t cut)
{
    return objet_sides((cut >> 8 & 0x00ff00ff) | (cut << 8 & 0xff00ff00));
}

/* Which of the four entries from k on, but before `end`, have all sides at `most` or below? Bit i is entry k + i. */
static inline unsigned objet_near(const objet *grid, uint32_t k, uint32_t end, uint32_t most)
{
    return four_bytes_at_most((const uint32_t *)(grid->entry + k), most) & (end - k < 4 ? (1u << (end - k)) - 1 : 15u);
}

/* How many of the fronts in a list of `count` entries have a point as near as z? They come first. */
static inline uint32_t objet_count_nearer(const hide_fronts *fronts, const objet_entry *list, uint32_t count, float z)
{
    uint32_t low = 0;
    while (low < count) {
        uint32_t middle = low + (count - low) / 2;
        if (fronts->front_box[list[middle].front].z1 < z)
            count = middle;
        else
            low = middle + 1;
    }
    return count;
}

/* Finds the cells that AB touches, column by column. False: no memory. */
bool objet_cells(const objet *grid, roberts_vec3 A, roberts_vec3 B, objet_walk *walk);

#endif
