/* cells.h - the cells that the picture is divided into, for the lists of Objet[i][j] and for covers: a frame of columns
 * and rows, how many there are, and which cells a convex polygon touches. */
#ifndef ROBERTS_HIDE_CELLS_H
#define ROBERTS_HIDE_CELLS_H

#include <stdbool.h>

#include "base/vec.h"
#include "base/warp.h"
#include "hide/types.h"
#include "model/scene.h"

/* A grid of nx columns and ny rows over the window. Cell (i, j) is column i, row j, and has number i * ny + j. */
typedef struct scan_frame {
    uint32_t nx, ny;
    double x0, y0;         /* lower left corner of cell (0, 0) */
    double dx, dy;         /* size of a cell */
    double per_dx, per_dy; /* 1 / dx, 1 / dy */
    double last_x, last_y; /* nx - 1, ny - 1 */
    double margin;         /* cells are widened by this on all sides */
    warp *warps;           /* [2] x, y: columns and rows are equally wide only after these maps. NULL: no maps */
} scan_frame;

/* Makes a grid over the window low..high. If the window has no width or height, the columns or rows still have some. */
scan_frame scan_frame_over(roberts_vec2 low, roberts_vec2 high, uint32_t nx, uint32_t ny, double margin);

static inline size_t scan_cells(const scan_frame *f)
{
    return (size_t)f->nx * f->ny;
}

/* Return where x or y lies along the frame. */
static inline double scan_along_x(const scan_frame *f, double x)
{
    return f->warps ? warp_at(&f->warps[0], x) : x;
}

static inline double scan_along_y(const scan_frame *f, double y)
{
    return f->warps ? warp_at(&f->warps[1], y) : y;
}

/* Return the left border of column i, or the lower one of row i. Between them, fractions count. */
static inline double scan_left(const scan_frame *f, double i)
{
    double x = f->x0 + i * f->dx;
    return f->warps ? warp_back(&f->warps[0], x) : x;
}

static inline double scan_lower(const scan_frame *f, double i)
{
    double y = f->y0 + i * f->dy;
    return f->warps ? warp_back(&f->warps[1], y) : y;
}

/* Return how many columns x, or rows y, is away from the frame's corner: the inverse of scan_left() and scan_lower().
 */
static inline double scan_place_x(const scan_frame *f, double x)
{
    return (scan_along_x(f, x) - f->x0) * f->per_dx;
}

static inline double scan_place_y(const scan_frame *f, double y)
{
    return (scan_along_y(f, y) - f->y0) * f->per_dy;
}

/* Rounds down to the number of a column or row and clamps it to the grid; NaN gives 0. */
static inline uint32_t scan_clamp(double position, double last)
{
    return (uint32_t)lesser(greater(position, 0.0), last);
}

static inline uint32_t scan_column(const scan_frame *f, double x)
{
    return scan_clamp(scan_place_x(f, x), f->last_x);
}

static inline uint32_t scan_row(const scan_frame *f, double y)
{
    return scan_clamp(scan_place_y(f, y), f->last_y);
}

/* Return how many columns wide, or rows high, something is. */
static inline double scan_columns(const scan_frame *f, double x0, double x1)
{
    return (scan_along_x(f, x1) - scan_along_x(f, x0)) * f->per_dx;
}

static inline double scan_rows(const scan_frame *f, double y0, double y1)
{
    return (scan_along_y(f, y1) - scan_along_y(f, y0)) * f->per_dy;
}

/* Returns the number of a cell. */
static inline size_t scan_number(const scan_frame *f, uint32_t column, uint32_t row)
{
    return (size_t)column * f->ny + row;
}

/* Returns the cell of picture point (x, y). */
static inline size_t scan_cell(const scan_frame *f, double x, double y)
{
    return scan_number(f, scan_column(f, x), scan_row(f, y));
}

/* ---- the scan of a polygon --------------------------------------------------------------------------------------- */

/* The conservative Bresenham-like scan of a convex polygon over a grid of cells.
 *
 * Source: the lecture's last section. The scan walks the lower half of the polygon from the leftmost to the rightmost
 * corner and notes Bas[i] in every column. Then it walks back along the upper half and notes Haut[i]. In column i, the
 * polygon touches the rows from Bas[i] to Haut[i].
 *
 * A thin Bresenham line skips cells that the true line cuts only at a corner. Here each side counts with its whole part
 * over the closed column, widened by a margin. So the scan misses no cell that the closed polygon touches. A second
 * scan finds the cells that lie completely inside. */

/* The result of scanning one polygon. */
typedef struct scan {
    uint32_t first, last;             /* columns touched */
    double *bas, *haut;               /* [nx] least and greatest ordinate in the column */
    uint32_t inner_first, inner_last; /* columns within the polygon's width; none if first > last */
    /* [nx + 1] Bounds at the left border of each inner column and at the right border of the last: `under` is at least
     * any ordinate of the lower sides, and -over at most any ordinate of the upper sides. */
    double *under, *over;
} scan;

/* Allocates arrays for grids of nx columns. False: no memory. scan_free() accepts a zeroed scan. */
bool scan_init(scan *s, uint32_t nx);
void scan_free(scan *s);

/* Finds the cells touched by the convex polygon P[corner[0]], P[corner[1]], ..., which is counter-clockwise; read them
 * with scan_touched(). */
void scan_polygon(scan *s, const scan_frame *f, const roberts_vec3 *P, const uint32_t *corner, uint32_t count);

/* Finds the cells completely inside the polygon; read them with scan_inside(). */
void scan_inner(scan *s, const scan_frame *f, const roberts_vec3 *P, const uint32_t *corner, uint32_t count);

/* Gets the rows touched in column i. */
static inline void scan_touched(const scan *s, const scan_frame *f, uint32_t i, uint32_t *first, uint32_t *last)
{
    *first = scan_row(f, s->bas[i] - f->margin);
    *last = scan_row(f, s->haut[i] + f->margin);
}

/* Gets the rows completely inside in inner column i. False if there are none. */
static inline bool scan_inside(const scan *s, const scan_frame *f, uint32_t i, uint32_t *first, uint32_t *last)
{
    double low = scan_place_y(f, greater(s->under[i], s->under[i + 1]) + f->margin);
    double high = scan_place_y(f, -greater(s->over[i], s->over[i + 1]) - f->margin);
    if (!(low < f->ny) || !(high >= 1.0))
        return false;
    uint32_t below = low > 0.0 ? (uint32_t)low : 0;
    *first = below + (below < low); /* rounded up */
    *last = (high < f->ny ? (uint32_t)high : f->ny) - 1;
    return *first <= *last;
}

/* ---- how many cells ---------------------------------------------------------------------------------------------- */

/* Boxes over a window of the picture. */
typedef struct cells_boxes {
    const hide_box *box; /* [count] */
    uint32_t count;
    roberts_vec2 low, high; /* the window */
    double margin;          /* hide_margin() */
} cells_boxes;

/* Returns the cells for lists. They are about two mean boxes wide, but larger if the lists would otherwise grow faster
 * than the number of boxes. n: number of cells per side, fewer if their lists would take several times the scene's
 * memory; 0: choose. *depth: mean number of boxes over a point of the window. Where the boxes crowd, the frame has
 * warps; the caller frees them (objet_build() takes them). */
scan_frame cells_for_lists(const cells_boxes *b, uint32_t n, double *depth);

/* Returns the cells for covers, which are much smaller than a mean box, and smaller still for bodies of many vertices
 * and for loose triangles. If few boxes lie over one another, covers do not pay, and the frame has no columns.
 * vertices: of all bodies. Warps as above; cover_init() takes them. The threads do not change the result. */
scan_frame cells_for_covers(const cells_boxes *b, size_t vertices, int threads);

/* Returns the cells for covers that hide faces of one body: the boxes are those of its faces. If few of them lie over
 * one another, the frame has no columns. */
scan_frame cells_for_own_covers(const cells_boxes *b);

/* Returns the cells for covers of the scene to which a part belongs, as its plan keeps them. */
scan_frame cells_of_whole(const scene_whole *w, double margin);

/* Can cells_for_covers() return this many columns and rows for this many vertices? */
bool cells_may_cover(uint32_t nx, uint32_t ny, size_t vertices);

#endif
