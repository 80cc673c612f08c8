/* cover.c - see cover.h. */
#include "hide/cover.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/box.h"
#include "base/lanes.h"
#include "base/threads.h"
#include "hide/cells.h"
#include "hide/front.h"
#include "hide/objet.h"

/* Cells that are filled at a time. Up to this many cells are all filled by one thread. */
#define FILL 1024
#define FILLED_BY_ONE 500000

/* In piles of at least this many cells, those whose covers are nearer already are passed over. */
#define LONG_PILE 4

/* How far beside a box its cells may be read and written. */
enum { CELLS_BESIDE = 4 };

/* Faces cover cells together only in bodies of at least TOGETHER_FACES faces, with at most TOGETHER_CELLS cells for
 * each face. */
enum { TOGETHER_FACES = 4, TOGETHER_CELLS = 64 };

/* Bodies of fewer faces have no covers of their own. */
enum { OWN_FACES = 64 };

static bool fill_some(void *context, size_t first, size_t end)
{
    float none[FILL], *depth = context;
    for (size_t i = 0; i < FILL; i++)
        none[i] = -INFINITY;
    for (size_t i = first; i < end; i += FILL)
        memcpy(depth + i, none, (end - i < FILL ? end - i : FILL) * sizeof *depth);
    return true;
}

/* Sets all depths to -infinity. With several threads, each gets its part of the memory from the system. */
static void fill_depths(float *depth, size_t count, int threads)
{
    threads_each(count > FILLED_BY_ONE ? threads : 1, count, 0, fill_some, depth);
}

/* Allocates the cells, and takes the warps of the frame. */
static bool alloc_cells(cover *c, scan_frame frame)
{
    size_t cells = scan_cells(&frame);
    *c = (cover){.frame = frame};
    if (cells == 0)
        return true;
    c->depth = alloc_array(cells, sizeof *c->depth);
    c->by = alloc_array(cells, sizeof *c->by); /* not set where there is no cover */
    return c->depth && c->by;
}

bool cover_init(cover *c, scan_frame frame, int threads)
{
    if (!alloc_cells(c, frame))
        return false;
    if (c->depth)
        fill_depths(c->depth, scan_cells(&frame), threads);
    return true;
}

bool cover_init_part(cover *c, scan_frame frame, roberts_vec2 low, roberts_vec2 high)
{
    if (!alloc_cells(c, frame))
        return false;
    if (!c->depth)
        return true;
    const uint32_t column = scan_column(&frame, low.x), row = scan_row(&frame, low.y);
    const uint32_t first = row > CELLS_BESIDE ? row - CELLS_BESIDE : 0;
    const uint32_t end = scan_clamp(scan_row(&frame, high.y) + (double)CELLS_BESIDE, frame.last_y) + 1;
    const uint32_t last = scan_clamp(scan_column(&frame, high.x) + (double)CELLS_BESIDE, frame.last_x);
    for (uint32_t i = column > CELLS_BESIDE ? column - CELLS_BESIDE : 0; i <= last; i++)
        fill_depths(c->depth + scan_number(&frame, i, first), end - first, 1);
    return true;
}

void cover_free(cover *c)
{
    free(c->depth);
    free(c->by);
    free(c->frame.warps);
    *c = (cover){0};
}

/* Cells of a column, one above the other. */
typedef struct cell_pile {
    const scan_frame *f;
    double left, right, lower; /* lower: where the next cell begins */
    uint32_t row, end;         /* the next cell, and the end */
} cell_pile;

static inline cell_pile pile_of(const scan_frame *f, uint32_t column, uint32_t first, uint32_t last)
{
    return (cell_pile){f, scan_left(f, column), scan_left(f, column + 1.0), scan_lower(f, first), first, last + 1};
}

/* Finds the depth of a front over the next two cells, and passes them: what is nowhere nearer lies behind the front.
 * Since z = (a x + b y + d) / -c with c < 0, each plane has its least depth at a corner of the cell. */
BITS_INLINE void pass_two(cell_pile *p, const cover_front *front, float depth[2])
{
    const double middle = scan_lower(p->f, p->row + 1.0), end = scan_lower(p->f, p->row + 2.0);
    const two lower = two_of(p->lower, middle), upper = two_of(middle, end), ulp = two_all(0x1p-23);
    two least = two_all(front->face_count ? INFINITY : -INFINITY);
    for (uint32_t k = 0; k < front->face_count; k++) {
        const plane F = front->face[k].F;
        const two x = two_all(F.a * (F.a > 0.0 ? p->left : p->right));
        const two y = two_mul(two_all(F.b), F.b > 0.0 ? lower : upper);
        least = two_lesser(least, two_div(two_add(two_add(x, y), two_all(F.d)), two_all(-F.c)));
    }
    const two z = two_sub(two_greater(two_all(front->depth), least), two_all(front->slack));
    two_part_floats(&depth[0], &depth[1], two_sub(z, two_mul(two_abs(z), ulp))); /* rounds as hide_float_below() does */
    p->row += 2;
    p->lower = end;
}

static inline void raise_cell(float *cell, uint32_t *cell_by, float bound, uint32_t by)
{
    if (bound > *cell) {
        *cell = bound;
        *cell_by = by;
    }
}

static inline void enter_level(float *cell, uint32_t *cell_by, uint32_t count, float bound, uint32_t by)
{
    for (uint32_t k = 0; k < count; k++)
        raise_cell(&cell[k], &cell_by[k], bound, by);
}

/* Passes four cells at once if all are nearer than the front is anywhere in the pile: none of them is raised. */
static inline bool pass_nearer(cell_pile *p, const float *cell, float nearest)
{
    if (p->end - p->row < 4 || four_signs(four_below(four_load(cell + p->row), four_all(nearest))))
        return false;
    p->row += 4;
    p->lower = scan_lower(p->f, p->row);
    return true;
}

/* Returns the greatest depth that pass_two() can find in the pile. As each of its steps rounds, what is greater stays
 * greater. */
static float nearest_in(const cell_pile *p, const cover_front *front)
{
    const double upper = scan_lower(p->f, p->end);
    double nearest = INFINITY;
    for (uint32_t k = 0; k < front->face_count; k++) {
        const plane F = front->face[k].F;
        const double x = F.a * (F.a > 0.0 ? p->right : p->left), y = F.b * (F.b > 0.0 ? upper : p->lower);
        nearest = lesser(nearest, (x + y + F.d) / -F.c);
    }
    return hide_float_below(greater(front->depth, nearest) - front->slack);
}

static inline void enter_pile(cell_pile p, float *cell, uint32_t *cell_by, const cover_front *front)
{
    float z[2];
    const float nearest = p.end - p.row < LONG_PILE ? INFINITY : nearest_in(&p, front);
    for (uint32_t j = p.row; j < p.end; j = p.row) {
        if (nearest < INFINITY && pass_nearer(&p, cell, nearest))
            continue;
        pass_two(&p, front, z);
        raise_cell(&cell[j], &cell_by[j], z[0], front->by);
        if (j + 1 < p.end)
            raise_cell(&cell[j + 1], &cell_by[j + 1], z[1], front->by);
    }
}

void cover_add(cover *c, scan *s, const roberts_vec3 *P, const cover_front *front)
{
    scan_frame wider = c->frame;
    const scan_frame *f = &wider;
    if (!c->depth)
        return;
    wider.margin += front->loose;
    scan_inner(s, f, P, front->corner, front->count);
    float level = hide_float_below(front->depth - front->slack);
    for (uint32_t i = s->inner_first; i <= s->inner_last; i++) {
        uint32_t first, last;
        float *cell = c->depth + scan_number(f, i, 0);
        uint32_t *cell_by = c->by + scan_number(f, i, 0);
        if (!scan_inside(s, f, i, &first, &last))
            continue;
        if (!front->face_count)
            enter_level(cell + first, cell_by + first, last - first + 1, level, front->by);
        else
            enter_pile(pile_of(f, i, first, last), cell, cell_by, front);
    }
}

/* ---- bodies that are not convex --------------------------------------------------------------------------------- */

void cover_scratch_free(cover_scratch *w)
{
    scan_free(&w->scan);
    free(w->depth);
    free(w->taken);
    *w = (cover_scratch){0};
}

/* The cells that the box of a body touches, column by column. */
typedef struct body_cells {
    objet_range in;
    uint32_t rows;
    float *depth; /* of the farthest face there. INFINITY: there is none. -INFINITY: there is a fold */
} body_cells;

/* Is a piece of a face certainly convex in the picture? It may dent inward within the tolerance, unless it is a
 * triangle. Then the scan would touch cells in which no piece is. */
static bool is_plainly_convex(const hide_fronts *fronts, const uint32_t *corner, uint32_t count, bool clockwise)
{
    const roberts_vec3 *P = fronts->P;
    for (uint32_t i = 0; count > 3 && i < count; i++) {
        const roberts_vec3 *A = &P[corner[i]], *B = &P[corner[i + 1 < count ? i + 1 : i + 1 - count]],
                           *C = &P[corner[i + 2 < count ? i + 2 : i + 2 - count]];
        double left = (B->x - A->x) * (C->y - B->y) - (B->y - A->y) * (C->x - B->x);
        if (!((clockwise ? -left : left) > fronts->space.plain))
            return false;
    }
    return true;
}

/* Marks the faces that count. */
static void take_faces(const hide_fronts *fronts, uint32_t body, int late, unsigned char *taken)
{
    const roberts_scene *scene = fronts->scene;
    const scene_solid *own = &scene->solid[body];
    for (uint32_t face = own->face; face < own[1].face; face++) {
        const uint32_t *start = scene->face_start + face;
        const int facing = fronts->seen->facing[face];
        taken[face - own->face] =
            facing != VIEW_EDGE_ON && facing != late &&
            is_plainly_convex(fronts, scene->corner + start[0], start[1] - start[0], facing == VIEW_BACK);
    }
}

/* Lowers the depth of the cells that a face, or a fold, touches to its depth there. */
static void lower_cells(const hide_fronts *fronts, scan *s, const cover_front *front, body_cells *cells)
{
    const scan_frame *f = &fronts->cover.frame;
    scan_polygon(s, f, fronts->P, front->corner, front->count);
    for (uint32_t i = s->first; i <= s->last; i++) {
        uint32_t first, last;
        scan_touched(s, f, i, &first, &last);
        float *cell = cells->depth + (size_t)(i - cells->in.left) * cells->rows, z[2];
        cell_pile p = pile_of(f, i, first, last);
        for (float *at = cell + (first - cells->in.low); p.row < p.end; at += 2) {
            const bool both = p.row + 1 < p.end;
            pass_two(&p, front, z);
            at[0] = z[0] < at[0] ? z[0] : at[0];
            if (both)
                at[1] = z[1] < at[1] ? z[1] : at[1];
        }
    }
}

static void mark_folds(const hide_fronts *fronts, cover_scratch *w, uint32_t body, body_cells *cells)
{
    const roberts_scene *scene = fronts->scene;
    const scene_solid *own = &scene->solid[body];
    const unsigned char *facing = fronts->seen->facing + own->face;
    const scene_edge *edge = scene->edge + own->stored;
    for (uint32_t e = own->edge; e < own[1].edge; e++, edge++) {
        const uint8_t is = scene->surface->edge_is[e];
        const bool left = w->taken[edge->f[0]], right = edge->f[1] != ROBERTS_NONE && w->taken[edge->f[1]];
        if (left && right ? seen_joins_faces(facing, edge, is) : !left && !right)
            continue;
        const uint32_t end[2] = {own->vertex + edge->v[0], own->vertex + edge->v[1]};
        lower_cells(fronts, &w->scan, &(cover_front){.corner = end, .count = 2, .depth = -INFINITY}, cells);
    }
}

/* Enters what is found into the covers. A fold meets all cells at the border of the body's box. */
static void raise_cells(cover *c, const body_cells *cells)
{
    for (uint32_t i = cells->in.left; i <= cells->in.right; i++)
        for (uint32_t j = 0; j < cells->rows; j++) {
            const float depth = cells->depth[(size_t)(i - cells->in.left) * cells->rows + j];
            const size_t cell = scan_number(&c->frame, i, cells->in.low + j);
            if (depth > -INFINITY && depth < INFINITY)
                raise_cell(&c->depth[cell], &c->by[cell], depth, ROBERTS_NONE);
        }
}

/* May the near plane have cut the body? A border that it has made is no edge, and ends in new vertices. */
static bool may_be_cut(const hide_fronts *fronts, uint32_t body)
{
    const scene_solid *own = &fronts->scene->solid[body];
    for (uint32_t v = own->vertex; fronts->seen->clip.clipped && v < own[1].vertex; v++)
        if (scene_vertex_number(fronts->scene, v) == ROBERTS_NONE)
            return true;
    return false;
}

/* Finds the cells of a body whose faces may cover cells together, and the faces that count. *together: there are such
 * cells. False: no memory. */
static bool begin_cells(const hide_fronts *fronts, cover_scratch *w, uint32_t body, int late, body_cells *cells,
                        bool *together)
{
    const scene_solid *own = &fronts->scene->solid[body];
    const scan_frame *f = &fronts->cover.frame;
    const uint32_t faces = own[1].face - own->face;
    *cells = (body_cells){.in = objet_range_of(f, &fronts->box[body], f->margin)};
    const objet_range *in = &cells->in;
    cells->rows = in->high - in->low + 1;
    const size_t count = (size_t)(in->right - in->left + 1) * cells->rows;
    *together = faces >= TOGETHER_FACES && count <= (size_t)TOGETHER_CELLS * faces && in->right - in->left >= 2 &&
                in->high - in->low >= 2 && seen_has_plain_edges(fronts->seen) && !may_be_cut(fronts, body);
    if (!*together)
        return true;
    if (!array_reserve(&w->depth, &w->depth_room, count, sizeof *w->depth) ||
        !array_reserve(&w->taken, &w->taken_room, faces, sizeof *w->taken))
        return false;
    for (size_t i = 0; i < count; i++)
        w->depth[i] = INFINITY;
    cells->depth = w->depth;
    take_faces(fronts, body, late, w->taken);
    mark_folds(fronts, w, body, cells);
    return true;
}

/* Returns a face as a cover. */
static cover_front cover_of_face(const hide_fronts *fronts, uint32_t body, uint32_t face, hide_single *single)
{
    hide_make_face(fronts, body, face, single);
    const hide_face *F = &single->face;
    return (cover_front){.corner = F->corner,
                         .count = F->count,
                         .by = ROBERTS_NONE,
                         .face = F,
                         .face_count = 1,
                         .depth = hide_farthest(fronts, F->corner, F->count),
                         .slack = 2.0 * (F->touch + hide_margin(&fronts->space)) / -F->F.c};
}

/* May the box hold a cell? */
static inline bool may_hold_cell(const scan_frame *f, const hide_box *box)
{
    return scan_columns(f, (double)box->x0, (double)box->x1) >= 1.0 &&
           scan_rows(f, (double)box->y0, (double)box->y1) >= 1.0;
}

/* Adds a face, unless it may dent inward: the scan takes it for convex. */
static void add_face(const hide_fronts *fronts, cover *c, scan *s, const cover_front *front)
{
    if (is_plainly_convex(fronts, front->corner, front->count, false))
        cover_add(c, s, fronts->P, front);
}

bool cover_add_body(hide_fronts *fronts, cover_scratch *w, uint32_t body, int late)
{
    const scene_solid *own = &fronts->scene->solid[body];
    body_cells cells;
    bool together;
    if (!begin_cells(fronts, w, body, late, &cells, &together))
        return false;
    for (uint32_t face = own->face; face < own[1].face; face++) {
        if (fronts->seen->facing[face] == VIEW_EDGE_ON)
            continue;
        const hide_box box = front_box_of_face(fronts, face);
        const bool wide = may_hold_cell(&fronts->cover.frame, &box), taken = together && w->taken[face - own->face];
        if (!wide && !taken)
            continue;
        hide_single single;
        const cover_front front = cover_of_face(fronts, body, face, &single);
        if (wide)
            add_face(fronts, &fronts->cover, &w->scan, &front);
        if (taken)
            lower_cells(fronts, &w->scan, &front, &cells);
    }
    if (together)
        raise_cells(&fronts->cover, &cells);
    return true;
}

bool cover_add_own(hide_fronts *fronts, uint32_t body, uint32_t first, uint32_t end)
{
    if (!fronts->own || end - first < OWN_FACES)
        return true;
    const hide_box *box = &fronts->box[body];
    const scan_frame frame = cells_for_own_covers(&(cells_boxes){fronts->front_box + first,
                                                                 end - first,
                                                                 {(double)box->x0, (double)box->y0},
                                                                 {(double)box->x1, (double)box->y1},
                                                                 hide_margin(&fronts->space)});
    if (!frame.nx)
        return true;
    scan s = {0};
    cover *own = fronts->own[body] = alloc_zeroed(1, sizeof *own);
    const bool enough = own && cover_init(own, frame, 1) && scan_init(&s, frame.nx);
    for (uint32_t k = first; enough && k < end; k++) {
        hide_single single;
        if (!may_hold_cell(&frame, &fronts->front_box[k]))
            continue;
        const cover_front front = cover_of_face(fronts, body, fronts->front[k].piece, &single);
        add_face(fronts, own, &s, &front);
    }
    for (uint32_t k = first; enough && k < end; k++)
        fronts->front[k].listed = !cover_hides(own, &fronts->front_box[k]);
    scan_free(&s);
    return enough;
}

/* ---- what covers hide -------------------------------------------------------------------------------------------- */

static inline bool four_nearer(const float *cell, four z)
{
    return four_signs(four_below(z, four_load(cell))) == 15;
}

/* Are all of cell[0 .. count-1] nearer than z? Four are read at a time. No other cells are read, since another thread
 * may be writing them. */
static inline bool all_nearer(const float *cell, uint32_t count, float z)
{
    if (count < 4)
        return count == 0 || (z < cell[0] && z < cell[count / 2] && z < cell[count - 1]);
    four depth = four_all(z);
    for (uint32_t k = 0; k < count - 4; k += 4)
        if (!four_nearer(cell + k, depth))
            return false;
    return four_nearer(cell + count - 4, depth);
}

bool cover_hides(const cover *c, const hide_box *box)
{
    const scan_frame *f = &c->frame;
    if (!c->depth)
        return false;
    double m = f->margin;
    uint32_t last = scan_column(f, (double)box->x1 + m);
    uint32_t low = scan_row(f, (double)box->y0 - m), high = scan_row(f, (double)box->y1 + m);
    for (uint32_t i = scan_column(f, (double)box->x0 - m); i <= last; i++)
        if (!all_nearer(c->depth + scan_number(f, i, low), high - low + 1, box->z1))
            return false;
    return true;
}

uint32_t cover_at(const cover *c, double x, double y, float z)
{
    size_t cell = scan_cell(&c->frame, x, y);
    return c->depth[cell] > z ? c->by[cell] : ROBERTS_NONE;
}

/* Are all cells along AB nearer? The frame is warped: each column has its own width. */
static BITS_RARE bool warped_hides_edge(const cover *c, roberts_vec3 A, roberts_vec3 B)
{
    const scan_frame *f = &c->frame;
    const double m = f->margin;
    const uint32_t last = scan_column(f, greater(A.x, B.x) + m);
    for (uint32_t i = scan_column(f, lesser(A.x, B.x) - m); i <= last; i++) {
        double t0 = 0.0, t1 = 1.0;
        if (!box_clip(A.x, B.x, scan_left(f, i) - m, scan_left(f, i + 1.0) + m, &t0, &t1))
            continue;
        const double ya = A.y + t0 * (B.y - A.y), yb = A.y + t1 * (B.y - A.y);
        const double near = greater(A.z + t0 * (B.z - A.z), A.z + t1 * (B.z - A.z)) + m;
        const uint32_t j = scan_row(f, lesser(ya, yb) - m), end = scan_row(f, greater(ya, yb) + m);
        if (!all_nearer(c->depth + scan_number(f, i, j), end - j + 1, hide_float_above(near)))
            return false;
    }
    return true;
}

/* Goes along AB column by column, as cells.c does along a polygon's side. In each column it looks at the rows that AB
 * crosses, and compares their covers with the nearest depth of AB there. Rows and depth are linear in the column's
 * number. A margin on all sides makes up for rounding. */
BITS_PER_PROCESSOR bool cover_hides_edge(const cover *c, roberts_vec3 A, roberts_vec3 B)
{
    const scan_frame *f = &c->frame;
    if (!c->depth)
        return false;
    /* the middle of most edges that are not covered is not covered either */
    size_t middle = scan_cell(f, 0.5 * (A.x + B.x), 0.5 * (A.y + B.y));
    if (!((double)c->depth[middle] > 0.5 * (A.z + B.z)))
        return false;
    if (f->warps)
        return warped_hides_edge(c, A, B);
    double m = f->margin, run = B.x - A.x, near = greater(A.z, B.z) + m;
    double low = (lesser(A.y, B.y) - m - f->y0) * f->per_dy, high = (greater(A.y, B.y) + m - f->y0) * f->per_dy;
    uint32_t first = scan_column(f, lesser(A.x, B.x) - m), last = scan_column(f, greater(A.x, B.x) + m);
    double row = low, row_end = high, row_step = 0.0, z = near, z_step = 0.0;
    if (first < last && fabs(run) > 4.0 * m) {
        double slope = (B.y - A.y) / run, incline = (B.z - A.z) / run, from = f->x0 + first * f->dx - A.x;
        double y = A.y + from * slope - f->y0, rise = f->dx * slope, climb = f->dx * incline;
        double wide = m * (1.0 + fabs(slope));
        row = (y + lesser(0.0, rise) - wide) * f->per_dy;
        row_end = (y + greater(0.0, rise) + wide) * f->per_dy;
        row_step = rise * f->per_dy;
        z = A.z + from * incline + greater(0.0, climb) + m * (1.0 + fabs(incline));
        z_step = climb;
    }
    for (uint32_t k = 0; k <= last - first; k++) {
        uint32_t j = scan_clamp(greater(low, row + k * row_step), f->last_y);
        uint32_t end = scan_clamp(lesser(high, row_end + k * row_step), f->last_y);
        float nearest = hide_float_above(lesser(near, z + k * z_step));
        if (!all_nearer(c->depth + scan_number(f, first + k, j), end - j + 1, nearest))
            return false;
    }
    return true;
}

/* Does the front hide the solid? It does if it is nearer, and all vertices of the solid lie inside its outline or on
 * it. If the front may leave gaps in its outline, the vertices must lie as far inside as the gaps are wide. */
static bool hides_solid(const hide_fronts *fronts, const hide_whole_front *front, uint32_t solid)
{
    const roberts_scene *scene = fronts->scene;
    const uint32_t *corner = fronts->outline + front->outline;
    double slack = 0.5 * fronts->space.epsilon - (double)front->loose;
    if (!(front->depth > fronts->box[solid].z1))
        return false;
    if (slack < 0.0 && runs_of(&fronts->outline_runs, corner, front->corners))
        return false; /* runs cannot tell how far inside a point lies */
    for (uint32_t v = scene->solid[solid].vertex; v < scene->solid[solid + 1].vertex; v++) {
        roberts_vec3 X = view_point(&fronts->seen->view, scene->point[v]);
        if (!hide_polygon_holds(fronts, &fronts->outline_runs, corner, front->corners, (roberts_vec2){X.x, X.y}, slack))
            return false;
    }
    return true;
}

/* The box without one and a half cells at each side. */
static hide_box without_border(const scan_frame *f, const hide_box *box)
{
    float dx = 1.5f * (float)f->dx, dy = 1.5f * (float)f->dy, x0 = dx, x1 = dx, y0 = dy, y1 = dy;
    if (f->warps) {
        x0 /= (float)warp_stretch(&f->warps[0], (double)box->x0);
        x1 /= (float)warp_stretch(&f->warps[0], (double)box->x1);
        y0 /= (float)warp_stretch(&f->warps[1], (double)box->y0);
        y1 /= (float)warp_stretch(&f->warps[1], (double)box->y1);
    }
    return (hide_box){box->x0 + x0, box->x1 - x1, box->y0 + y0, box->y1 - y1, box->z0, box->z1};
}

/* If the border of a solid lies on the border of the front that hides it, the cells there are not wholly covered. So if
 * only the inner cells are covered, hides_solid() asks the fronts that cover the middle and the corners of these. For
 * most solids that are not hidden, the middle is not covered. */
bool cover_hides_solid(const struct hide_fronts *fronts, const hide_box *box, uint32_t solid)
{
    const cover *c = &fronts->cover;
    static const float at[5][2] = {{0.5f, 0.5f}, {0, 0}, {0, 1}, {1, 0}, {1, 1}};
    uint32_t last = ROBERTS_NONE;
    if (!c->depth ||
        !cover_nearer(c, 0.5 * ((double)box->x0 + (double)box->x1), 0.5 * ((double)box->y0 + (double)box->y1), box->z1))
        return false;
    if (fronts->convex_count == 0) /* the cells name no fronts to ask */
        return cover_hides(c, box);
    hide_box inner = without_border(&c->frame, box);
    if (inner.x0 > inner.x1 || inner.y0 > inner.y1)
        return cover_hides(c, box);
    if (cover_hides(c, box))
        return true;
    if (!cover_hides(c, &inner))
        return false;
    for (int k = 0; k < 5; k++) {
        float x = inner.x0 + at[k][0] * (inner.x1 - inner.x0), y = inner.y0 + at[k][1] * (inner.y1 - inner.y0);
        uint32_t front = cover_at(c, (double)x, (double)y, box->z1);
        if (front != ROBERTS_NONE && front != last && hides_solid(fronts, &fronts->whole[front], solid))
            return true;
        last = front;
    }
    return false;
}
