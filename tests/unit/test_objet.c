/* The grid: the conservative scan of polygons, the cells' lists, covers, edges walking through the cells, and how many
 * cells there are. The contents of cells are compared with a plain test of two convex sets: they are apart if the
 * direction of one of their sides separates them. */

#include "hide/cells.h"
#include "hide/cover.h"
#include "hide/objet.h"
#include "scenes.h"

enum { MOST_CORNERS = 12 };

typedef struct polygon {
    uint32_t count, corner[MOST_CORNERS];
    roberts_vec3 P[MOST_CORNERS];
} polygon;

static const roberts_vec2 window_low = {-1, 2}, window_high = {7, 6};
#define MARGIN 1e-9

/* ---- two convex sets ------------------------------------------------------------------------------------------- */

static void extent_along(const roberts_vec3 *p, uint32_t count, double nx, double ny, double *low, double *high)
{
    *low = INFINITY;
    *high = -INFINITY;
    for (uint32_t i = 0; i < count; i++) {
        double s = nx * p[i].x + ny * p[i].y;
        *low = fmin(*low, s);
        *high = fmax(*high, s);
    }
}

static bool apart_along(const roberts_vec3 *p, uint32_t np, const roberts_vec3 *q, uint32_t nq, double nx, double ny)
{
    double p0, p1, q0, q1;
    extent_along(p, np, nx, ny, &p0, &p1);
    extent_along(q, nq, nx, ny, &q0, &q1);
    return p1 < q0 || q1 < p0;
}

static bool touches(const roberts_vec3 *p, uint32_t np, const roberts_vec3 *q, uint32_t nq)
{
    if (apart_along(p, np, q, nq, 1, 0) || apart_along(p, np, q, nq, 0, 1)) /* most are */
        return false;
    for (int set = 0; set < 2; set++) {
        const roberts_vec3 *side = set ? q : p;
        uint32_t count = set ? nq : np;
        for (uint32_t i = 0; i < count; i++) {
            roberts_vec3 a = side[i], b = side[(i + 1) % count];
            if (apart_along(p, np, q, nq, a.y - b.y, b.x - a.x))
                return false;
            if (count == 2 && apart_along(p, np, q, nq, b.x - a.x, b.y - a.y))
                return false;
        }
    }
    return true;
}

enum { MOST_CELLS = 400 };

/* The left sides of all columns and the lower sides of all rows, and the last ones' other sides. */
typedef struct borders {
    double x[MOST_CELLS + 1], y[MOST_CELLS + 1];
} borders;

static borders borders_of(const scan_frame *f)
{
    borders b;
    assert_true(f->nx <= MOST_CELLS && f->ny <= MOST_CELLS);
    for (uint32_t i = 0; i <= f->nx; i++)
        b.x[i] = scan_left(f, i);
    for (uint32_t j = 0; j <= f->ny; j++)
        b.y[j] = scan_lower(f, j);
    return b;
}

/* The corners of a cell grown by `more` on all sides. */
static void cell_corners(const borders *b, uint32_t i, uint32_t j, double more, roberts_vec3 q[4])
{
    double x0 = b->x[i] - more, x1 = b->x[i + 1] + more, y0 = b->y[j] - more, y1 = b->y[j + 1] + more;
    q[0] = (roberts_vec3){x0, y0, 0};
    q[1] = (roberts_vec3){x1, y0, 0};
    q[2] = (roberts_vec3){x1, y1, 0};
    q[3] = (roberts_vec3){x0, y1, 0};
}

static bool cell_touches(const borders *b, uint32_t i, uint32_t j, double more, const roberts_vec3 *p, uint32_t n)
{
    roberts_vec3 q[4];
    cell_corners(b, i, j, more, q);
    return touches(p, n, q, 4);
}

/* Is (x, y) in the polygon, which runs counter-clockwise, or within `more` of it? */
static bool holds(const roberts_vec3 *p, uint32_t n, double x, double y, double more)
{
    for (uint32_t i = 0; i < n; i++) {
        roberts_vec3 a = p[i], b = p[(i + 1) % n];
        double dx = b.x - a.x, dy = b.y - a.y;
        if (dx * (y - a.y) - dy * (x - a.x) < -more * sqrt(dx * dx + dy * dy))
            return false;
    }
    return true;
}

/* ---- polygons -------------------------------------------------------------------------------------------------- */

static double in_window_x(double x)
{
    return fmin(fmax(x, window_low.x), window_high.x);
}

static double in_window_y(double y)
{
    return fmin(fmax(y, window_low.y), window_high.y);
}

static void set_corner(polygon *g, double x, double y)
{
    g->corner[g->count] = g->count;
    g->P[g->count++] = (roberts_vec3){x, y, 0};
}

static polygon rectangle(double x0, double y0, double x1, double y1)
{
    polygon g = {0};
    set_corner(&g, x0, y0);
    set_corner(&g, x1, y0);
    set_corner(&g, x1, y1);
    set_corner(&g, x0, y1);
    return g;
}

/* Corners on an ellipse, ascending by angle: half-axes a and b, turned, inside the window. */
static polygon random_ellipse(rng *r, double a, double b)
{
    polygon g = {0};
    uint32_t count = (uint32_t)rng_int(r, 3, MOST_CORNERS);
    double turn = rng_between(r, 0, 6.28), angle = 0.0;
    double m = fmax(a, b), x = rng_between(r, window_low.x + m, window_high.x - m);
    double y = rng_between(r, window_low.y + m, window_high.y - m);
    for (uint32_t i = 0; i < count; i++) {
        angle += rng_between(r, 0.2, 1.8) * 6.28 / count / 1.8;
        double u = a * cos(angle), v = b * sin(angle);
        set_corner(&g, x + u * cos(turn) - v * sin(turn), y + u * sin(turn) + v * cos(turn));
    }
    return g;
}

/* Corners on the borders of cells, except for the margin, if there are 8 or 16 columns and 4 or 8 rows. */
static polygon random_on_borders(rng *r)
{
    int x0 = rng_int(r, -2, 12), x1 = rng_int(r, x0 + 1, 14), y0 = rng_int(r, 4, 11), y1 = rng_int(r, y0 + 1, 12);
    polygon g = rectangle(0.5 * x0, 0.5 * y0, 0.5 * x1, 0.5 * y1);
    if (rng_int(r, 0, 1)) /* a triangle with a diagonal through corners of cells */
        g.count = 3;
    return g;
}

enum { ROUND, NEEDLE, TINY, BORDERS, CORNER, WHOLE, SLIVER, KINDS };

static polygon random_polygon(rng *r, int kind)
{
    polygon g = {0};
    switch (kind) {
    case ROUND:
        return random_ellipse(r, rng_between(r, 0.2, 1.9), rng_between(r, 0.1, 1.9));
    case NEEDLE:
        return random_ellipse(r, rng_between(r, 0.5, 1.9), pow(10, rng_between(r, -8, -2)));
    case TINY:
        return random_ellipse(r, 1e-6, 1e-6);
    case BORDERS:
        return random_on_borders(r);
    case CORNER: /* at a corner of the window */
        set_corner(&g, window_high.x, window_high.y);
        set_corner(&g, window_high.x - rng_between(r, 0, 8), window_high.y);
        set_corner(&g, window_high.x, window_high.y - rng_between(r, 0, 4));
        return g;
    case WHOLE:
        return rectangle(window_low.x, window_low.y, window_high.x, window_high.y);
    default: /* upright or level, almost without width */
        g = rectangle(0, 0, 0, 0);
        double x = rng_between(r, -1, 7), y = rng_between(r, 2, 6), w = pow(10, rng_between(r, -12, -3));
        return rng_int(r, 0, 1) ? rectangle(in_window_x(x - w), 2, in_window_x(x + w) + w, 6)
                                : rectangle(-1, in_window_y(y - w), 7, in_window_y(y + w) + w);
    }
}

/* Those with equal cells come first; then those with warps. */
static const struct {
    uint32_t nx, ny;
} frames[] = {{1, 1}, {8, 4}, {16, 8}, {3, 7}, {50, 1}, {1, 40}, {37, 23}, {8, 4}, {37, 23}, {64, 90}};
enum { FRAMES = 7, ALL_FRAMES = sizeof frames / sizeof frames[0] };

/* Warps for the window: half of the cells are near (1, 5). */
static warp *warps_of_window(void)
{
    double x[300], y[300];
    warp *warps = malloc(2 * sizeof *warps);
    assert_non_null(warps);
    for (int i = 0; i < 300; i++) {
        x[i] = 1.0 + 1e-4 * i;
        y[i] = 5.0 + 1e-5 * i * i;
    }
    assert_true(warp_make(&warps[0], window_low.x - MARGIN, window_high.x + MARGIN, x, 300, 256 * MARGIN));
    assert_true(warp_make(&warps[1], window_low.y - MARGIN, window_high.y + MARGIN, y, 300, 256 * MARGIN));
    return warps;
}

/* objet_free() of its grid frees the warps. */
static scan_frame frame_of(size_t i)
{
    scan_frame f = scan_frame_over(window_low, window_high, frames[i].nx, frames[i].ny, MARGIN);
    f.warps = i < FRAMES ? NULL : warps_of_window();
    return f;
}

/* ---- the scan -------------------------------------------------------------------------------------------------- */

/* Every cell that the closed polygon touches is listed, even if it only reaches into the margin. No cell is listed that
 * it misses by several margins. A cell that counts as inside has its corners inside, and a cell well inside counts as
 * inside. */
static void expect_scan(const scan *s, const scan_frame *f, const borders *b, const polygon *g, int kind)
{
    for (uint32_t i = 0; i < f->nx; i++) {
        uint32_t first = 1, last = 0, in_first = 1, in_last = 0;
        if (i >= s->first && i <= s->last)
            scan_touched(s, f, i, &first, &last);
        if (i >= s->inner_first && i <= s->inner_last && !scan_inside(s, f, i, &in_first, &in_last))
            in_last = (in_first = 1) - 1;
        for (uint32_t j = 0; j < f->ny; j++) {
            bool listed = j >= first && j <= last, inside = j >= in_first && j <= in_last;
            roberts_vec3 q[4];
            cell_corners(b, i, j, 0, q);
            bool all = true, well = true;
            for (int k = 0; k < 4; k++) {
                all = all && holds(g->P, g->count, q[k].x, q[k].y, 0);
                well = well && holds(g->P, g->count, q[k].x, q[k].y, -1e4 * MARGIN);
            }
            if ((!listed && cell_touches(b, i, j, 0.5 * MARGIN, g->P, g->count)) ||
                (listed && !cell_touches(b, i, j, 8 * MARGIN, g->P, g->count)) || (inside && !all) || (well && !inside))
                fail_msg("kind %d, %u x %u cells: cell %u, %u is %slisted, %sinside", kind, f->nx, f->ny, i, j,
                         listed ? "" : "not ", inside ? "" : "not ");
        }
    }
}

static void scan_is_conservative_and_tight(void **state)
{
    rng r = {71};
    (void)state;
    for (size_t k = 0; k < ALL_FRAMES; k++) {
        scan_frame f = frame_of(k);
        const borders b = borders_of(&f);
        scan s;
        assert_true(scan_init(&s, f.nx));
        s.inner_first = 1;
        s.inner_last = 0;
        for (int i = 0; i < 100 * KINDS; i++) {
            polygon g = random_polygon(&r, i % KINDS);
            scan_polygon(&s, &f, g.P, g.corner, g.count);
            scan_inner(&s, &f, g.P, g.corner, g.count);
            expect_scan(&s, &f, &b, &g, i % KINDS);
        }
        scan_free(&s);
        free(f.warps);
    }
}

/* Scratch memory is reused for polygon after polygon: remains of an earlier one have no effect. */
static void scan_forgets(void **state)
{
    rng r = {72};
    scan_frame f = frame_of(2);
    scan used, fresh;
    (void)state;
    assert_true(scan_init(&used, f.nx));
    for (int i = 0; i < 200; i++) {
        polygon g = random_polygon(&r, i % KINDS);
        uint32_t a0, a1, b0, b1;
        assert_true(scan_init(&fresh, f.nx));
        scan_polygon(&used, &f, g.P, g.corner, g.count);
        scan_inner(&used, &f, g.P, g.corner, g.count);
        scan_polygon(&fresh, &f, g.P, g.corner, g.count);
        scan_inner(&fresh, &f, g.P, g.corner, g.count);
        assert_true(used.first == fresh.first && used.last == fresh.last && used.inner_first == fresh.inner_first &&
                    used.inner_last == fresh.inner_last);
        for (uint32_t c = used.first; c <= used.last; c++) {
            scan_touched(&used, &f, c, &a0, &a1);
            scan_touched(&fresh, &f, c, &b0, &b1);
            assert_true(a0 == b0 && a1 == b1);
        }
        scan_free(&fresh);
    }
    scan_free(&used);
}

/* Even a window without width or height has cells of some size, and its points are in them. */
static void windows_without_size(void **state)
{
    static const struct {
        roberts_vec2 low, high;
    } table[] = {{{1, 2}, {1, 6}}, {{1, 2}, {5, 2}}, {{1, 2}, {1, 2}}, {{0, 0}, {0, 0}}};
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++)
        for (uint32_t n = 1; n < 40; n += 13) {
            scan_frame f = scan_frame_over(table[i].low, table[i].high, n, n, MARGIN);
            assert_true(f.dx > 0 && f.dy > 0 && isfinite(f.per_dx) && isfinite(f.per_dy));
            assert_true(f.x0 + n * f.dx >= table[i].high.x && f.y0 + n * f.dy >= table[i].high.y);
            assert_true(f.x0 <= table[i].low.x && f.y0 <= table[i].low.y);
            objet grid = {.frame = f};
            objet_walk walk = {0};
            roberts_vec3 A = {table[i].low.x, table[i].low.y, 0}, B = {table[i].high.x, table[i].high.y, 0};
            assert_true(objet_cells(&grid, A, B, &walk));
            assert_true(walk.count >= 1);
            free(walk.item);
        }
}

/* ---- edges through the cells ----------------------------------------------------------------------------------- */

enum { ANYHOW, LEVEL, UPRIGHT, DIAGONAL, POINT, SHORT, ALONG_WINDOW, LINES };

static void random_line(rng *r, int kind, roberts_vec3 *A, roberts_vec3 *B)
{
    *A = (roberts_vec3){rng_between(r, -1, 7), rng_between(r, 2, 6), rng_between(r, -1, 1)};
    *B = (roberts_vec3){rng_between(r, -1, 7), rng_between(r, 2, 6), rng_between(r, -1, 1)};
    switch (kind) {
    case LEVEL:
        A->y = B->y = 0.5 * rng_int(r, 4, 12);
        break;
    case UPRIGHT:
        A->x = B->x = 0.5 * rng_int(r, -2, 14);
        break;
    case DIAGONAL:
        *A = (roberts_vec3){rng_int(r, -1, 3), 2, 0};
        *B = (roberts_vec3){A->x + 4, 6, 1};
        break;
    case POINT:
        *A = (roberts_vec3){0.5 * rng_int(r, -2, 14), 0.5 * rng_int(r, 4, 12), 0};
        *B = (roberts_vec3){A->x, A->y, 1};
        break;
    case SHORT:
        *B = (roberts_vec3){in_window_x(A->x + rng_between(r, -1e-8, 1e-8)), in_window_y(A->y + 1e-9), 0};
        break;
    case ALONG_WINDOW:
        *A = (roberts_vec3){-1, 6, 0};
        *B = (roberts_vec3){7, 6, 1};
        break;
    default:
        break;
    }
    if (rng_int(r, 0, 1)) {
        roberts_vec3 swapped = *A;
        *A = *B;
        *B = swapped;
    }
}

/* The stretch of a walk in a cell, or NULL. */
static const objet_stretch *stretch_in(const objet_walk *walk, uint32_t column, uint32_t row)
{
    const objet_stretch *found = NULL;
    for (size_t k = 0; k < walk->count; k++)
        if (walk->item[k].column == column && walk->item[k].row == row) {
            assert_null(found); /* no cell twice */
            found = &walk->item[k];
        }
    return found;
}

/* Is (x, y) in the cell with these corners? */
static bool is_in(const roberts_vec3 q[4], double x, double y)
{
    return x >= q[0].x && x <= q[2].x && y >= q[0].y && y <= q[2].y;
}

/* Each cell that the closed edge touches is in its walk, and the parameters at which it is there in the stretch; no
 * cell that it misses by some margins, no stretch that leaves its cell. */
static void expect_walk(const scan_frame *f, const borders *b, roberts_vec3 A, roberts_vec3 B, const objet_walk *walk,
                        int kind)
{
    roberts_vec3 line[2] = {A, B};
    for (uint32_t i = 0; i < f->nx; i++)
        for (uint32_t j = 0; j < f->ny; j++) {
            const objet_stretch *s = stretch_in(walk, i, j);
            if ((!s && cell_touches(b, i, j, 0.5 * MARGIN, line, 2)) ||
                (s && !cell_touches(b, i, j, 8 * MARGIN, line, 2)))
                fail_msg("kind %d, %u x %u cells: cell %u, %u is %sin the walk", kind, f->nx, f->ny, i, j,
                         s ? "" : "not ");
            roberts_vec3 own[4], around[4];
            cell_corners(b, i, j, 0, own);
            cell_corners(b, i, j, 8 * MARGIN, around);
            for (int k = 0; k <= 64; k++) {
                double t = k / 64.0, x = A.x + t * (B.x - A.x), y = A.y + t * (B.y - A.y);
                assert_true(!is_in(own, x, y) || (s && s->t0 <= t && t <= s->t1));
                assert_true(!s || t < s->t0 || t > s->t1 || is_in(around, x, y));
            }
            assert_true(!s || (s->t0 >= 0 && s->t0 <= s->t1 && s->t1 <= 1));
        }
}

static void walks_meet_every_cell(void **state)
{
    rng r = {73};
    objet_walk walk = {0};
    (void)state;
    for (size_t k = 0; k < ALL_FRAMES; k++) {
        objet grid = {.frame = frame_of(k)};
        const borders b = borders_of(&grid.frame);
        for (int i = 0; i < 20 * LINES; i++) {
            roberts_vec3 A, B;
            random_line(&r, i % LINES, &A, &B);
            assert_true(objet_cells(&grid, A, B, &walk));
            expect_walk(&grid.frame, &b, A, B, &walk, i % LINES);
            for (size_t c = 1; c < walk.count; c++) /* column by column */
                assert_true(walk.item[c].column >= walk.item[c - 1].column);
        }
        objet_free(&grid);
    }
    free(walk.item);
}

/* ---- lists ----------------------------------------------------------------------------------------------------- */

/* Nearest corner first, ties by number. */
static bool in_order(const hide_fronts *fronts, uint32_t a, uint32_t b)
{
    float za = fronts->front_box[a].z1, zb = fronts->front_box[b].z1;
    return za > zb || (za == zb && a < b);
}

static void expect_lists(const objet *grid, const hide_fronts *fronts)
{
    const scan_frame *f = &grid->frame;
    const borders b = borders_of(f);
    const size_t count = fronts->front_count;
    bool *listed = calloc(scan_cells(f) * count, sizeof *listed);
    assert_non_null(listed);
    for (uint32_t cell = 0; cell < scan_cells(f); cell++)
        for (uint32_t k = grid->start[cell]; k < grid->start[cell + 1]; k++) {
            uint32_t front = grid->entry[k].front;
            bool *own = &listed[cell * count + front];
            assert_true(!*own && fronts->front[front].listed); /* once, and only listed fronts */
            assert_true(k == grid->start[cell] || in_order(fronts, grid->entry[k - 1].front, front));
            *own = true;
        }
    for (uint32_t k = 0; k < count; k++) {
        uint32_t turned[SEEN_TURNED];
        hide_face outline = hide_outline(fronts, k, turned);
        roberts_vec3 P[64];
        assert_true(outline.count <= 64);
        for (uint32_t i = 0; i < outline.count; i++)
            P[i] = fronts->P[outline.corner[i]];
        for (uint32_t cell = 0; cell < scan_cells(f) && fronts->front[k].listed; cell++)
            if (!listed[cell * count + k] &&
                cell_touches(&b, cell / f->ny, cell % f->ny, 0.5 * f->margin, P, outline.count))
                fail_msg("front %u is missing in cell %u", k, cell);
    }
    free(listed);
}

/* A grid of this frame without fronts, which measures sides in its own units. */
static objet grid_of(scan_frame frame)
{
    static const roberts_scene nothing;
    hide_fronts none = {.scene = &nothing};
    objet grid;
    assert_int_equal(objet_build(&grid, &none, frame, 1), ROBERTS_OK);
    return grid;
}

/* A box about the window, of any size; often with sides that other boxes or cells have too. */
static hide_box random_box(rng *r, const scan_frame *f)
{
    float x[2], y[2];
    for (int k = 0; k < 2; k++) {
        x[k] = (float)(rng_int(r, 0, 1) ? rng_between(r, -3, 9) : scan_left(f, rng_int(r, -1, (int)f->nx)));
        y[k] = (float)(rng_int(r, 0, 1) ? rng_between(r, 1, 8) : scan_lower(f, rng_int(r, -1, (int)f->ny)));
    }
    return (hide_box){
        .x0 = fminf(x[0], x[1]), .x1 = fmaxf(x[0], x[1]), .y0 = fminf(y[0], y[1]), .y1 = fmaxf(y[0], y[1])};
}

typedef struct stretch {
    double from, to;
} stretch;

/* Are two stretches of an axis apart in a cell, by more than a hundredth of it? */
static bool apart_in_cell(stretch a, stretch b, stretch cell)
{
    const double gap = 0.01 * (cell.to - cell.from);
    return (a.to + gap < b.from && a.to + gap < cell.to && b.from > cell.from + gap) ||
           (b.to + gap < a.from && b.to + gap < cell.to && a.from > cell.from + gap);
}

static stretch along_x(const scan_frame *f, float from, float to)
{
    return (stretch){scan_along_x(f, (double)from), scan_along_x(f, (double)to)};
}

static stretch along_y(const scan_frame *f, float from, float to)
{
    return (stretch){scan_along_y(f, (double)from), scan_along_y(f, (double)to)};
}

/* Boxes that meet are not separated in any cell. Boxes that are a hundredth of a cell apart are separated there. */
static void sides_tell_boxes_apart(void **state)
{
    rng r = {75};
    size_t met = 0, apart[2] = {0};
    (void)state;
    for (size_t k = 0; k < ALL_FRAMES; k++) {
        objet grid = grid_of(frame_of(k));
        const scan_frame *f = &grid.frame;
        for (int n = 0; n < 2000; n++) {
            hide_box a = random_box(&r, f), b = random_box(&r, f);
            uint32_t i = (uint32_t)rng_int(&r, 0, (int)f->nx - 1), j = (uint32_t)rng_int(&r, 0, (int)f->ny - 1);
            uint32_t own = objet_sides(objet_cut(objet_place(&grid, &a), i, j));
            uint32_t entries[8] = {0, own, 0, own, 0, own, 0, own};
            uint32_t most = objet_most(objet_cut(objet_place(&grid, &b), i, j));
            bool meet = four_bytes_at_most(entries, most) == 15;
            double left = f->x0 + i * f->dx, low = f->y0 + j * f->dy;
            bool beside = apart_in_cell(along_x(f, a.x0, a.x1), along_x(f, b.x0, b.x1), (stretch){left, left + f->dx});
            bool above = apart_in_cell(along_y(f, a.y0, a.y1), along_y(f, b.y0, b.y1), (stretch){low, low + f->dy});
            if (a.x0 <= b.x1 && b.x0 <= a.x1 && a.y0 <= b.y1 && b.y0 <= a.y1) {
                assert_true(meet);
                met++;
            } else if (beside || above) {
                assert_false(meet);
                apart[beside ? 0 : 1]++;
            }
        }
        objet_free(&grid);
    }
    assert_true(met > 1000 && apart[0] > 1000 && apart[1] > 1000);
}

static uint32_t listed_count(const hide_fronts *fronts)
{
    uint32_t count = 0;
    for (uint32_t k = 0; k < fronts->front_count; k++)
        count += fronts->front[k].listed;
    return count;
}

/* Whole scenes: each cell lists every front whose outline touches it, nearest corner first. */
static void lists_are_complete_and_in_order(void **state)
{
    static const uint32_t sides[] = {0, 1, 5, 60};
    (void)state;
    for (int scene = 0; scene < 3; scene++) {
        model m = {0};
        if (scene == 0)
            model_lattice(&m, 4, 0.7, 74);
        else if (scene == 1)
            model_crowd(&m, 40, 5, 75);
        else
            model_wall(&m, 6, 6);
        roberts_scene *built = model_build(&m);
        for (size_t i = 0; i < sizeof sides / sizeof sides[0]; i++) {
            roberts_camera camera = {.dir = {i % 2 ? 1 : 0, -1, scene}};
            hide_fronts fronts;
            seen seen_scene;
            double depth;
            objet grid;
            assert_int_equal(seen_begin(&seen_scene, built, &camera, 0.0, NULL), ROBERTS_OK);
            assert_true(hide_fronts_build(&fronts, &seen_scene,
                                          &(roberts_hide_options){.keep_hidden = true, .threads = 1}, false));
            assert_int_equal(fronts.culled_count, 0);
            scan_frame frame = cells_for_lists(&(cells_boxes){fronts.front_box, fronts.front_count, fronts.low,
                                                              fronts.high, hide_margin(&fronts.space)},
                                               sides[i], &depth);
            assert_int_equal(objet_build(&grid, &fronts, frame, 1), ROBERTS_OK);
            expect_lists(&grid, &fronts);
            assert_true(listed_count(&fronts) > 10);
            objet_free(&grid);
            hide_fronts_free(&fronts);
            seen_end(&seen_scene);
        }
        roberts_scene_free(built);
        model_free(&m);
    }
}

/* With enough fronts for several threads, the lists are the same. */
static void lists_by_threads(void **state)
{
    roberts_camera camera = {.dir = {1, 2, 3}};
    hide_fronts fronts;
    seen seen_scene;
    objet alone, together;
    double depth;
    model m = {0};
    (void)state;
    for (int i = 0; i < 700; i++)
        model_round(&m, MODEL_CORNERS, false, mat3_scale(1, 1, 1), (roberts_vec3){i % 20, i / 20, i % 7});
    roberts_scene *scene = model_build(&m);
    assert_int_equal(seen_begin(&seen_scene, scene, &camera, 0.0, NULL), ROBERTS_OK);
    assert_true(
        hide_fronts_build(&fronts, &seen_scene, &(roberts_hide_options){.keep_hidden = true, .threads = 1}, false));
    assert_true(fronts.front_count > 40000);
    scan_frame frame = cells_for_lists(
        &(cells_boxes){fronts.front_box, fronts.front_count, fronts.low, fronts.high, hide_margin(&fronts.space)}, 150,
        &depth);
    size_t cells = scan_cells(&frame);
    assert_true(cells > 8192);
    assert_int_equal(objet_build(&alone, &fronts, frame, 1), ROBERTS_OK);
    for (uint32_t threads = 2; threads < 5; threads++) {
        assert_int_equal(objet_build(&together, &fronts, frame, threads), ROBERTS_OK);
        assert_memory_equal(together.start, alone.start, (cells + 1) * sizeof *alone.start);
        assert_memory_equal(together.entry, alone.entry, alone.start[cells] * sizeof *alone.entry);
        assert_memory_equal(together.next, alone.next, alone.start[cells] * sizeof *alone.next);
        objet_free(&together);
    }
    objet_free(&alone);
    hide_fronts_free(&fronts);
    seen_end(&seen_scene);
    roberts_scene_free(scene);
    model_free(&m);
}

/* Of copies at the same place, only the first front counts. Solids that differ a little all count. */
static void copies_count_once(void **state)
{
    static const struct {
        const char *name;
        double change;
        uint32_t fronts;
    } table[] = {{"copies", 0, 1}, {"of another height", 0.25, 4}, {"a little larger", 1e-6, 4}};
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        model m = {0};
        roberts_camera camera = {.dir = {1, -2, 3}};
        hide_fronts fronts;
        seen seen_scene;
        for (int k = 0; k < 4; k++)
            model_box(&m, (roberts_vec3){0, 0, 0}, (roberts_vec3){1, 1, 1 + k * table[i].change});
        roberts_scene *built = model_build(&m);
        assert_int_equal(seen_begin(&seen_scene, built, &camera, 0.0, NULL), ROBERTS_OK);
        assert_true(
            hide_fronts_build(&fronts, &seen_scene, &(roberts_hide_options){.keep_hidden = true, .threads = 1}, false));
        if (listed_count(&fronts) != table[i].fronts || !fronts.front[0].listed)
            fail_msg("%s: %u fronts", table[i].name, listed_count(&fronts));
        hide_fronts_free(&fronts);
        seen_end(&seen_scene);
        roberts_scene_free(built);
        model_free(&m);
    }
}

/* ---- covers ---------------------------------------------------------------------------------------------------- */

/* A face over the polygon: depth z = u x + v y + w. c < 0 and n of length 1. */
typedef struct slope {
    double u, v, w;
} slope;

static hide_face face_of(slope s)
{
    double length = sqrt(1 + s.u * s.u + s.v * s.v);
    return (hide_face){.F = {s.u / length, s.v / length, -1 / length, s.w / length}};
}

static double depth_at(const slope *s, uint32_t count, double x, double y)
{
    double depth = INFINITY;
    for (uint32_t k = 0; k < count; k++)
        depth = fmin(depth, s[k].u * x + s[k].v * y + s[k].w);
    return depth;
}

typedef struct front {
    polygon outline;
    slope face[3];
    uint32_t faces;
    double least; /* depth over the outline: that of a corner, since the depth is concave */
} front;

static front random_front(rng *r, int kind)
{
    front g = {.outline = random_polygon(r, kind), .faces = (uint32_t)rng_int(r, 1, 3), .least = INFINITY};
    for (uint32_t k = 0; k < g.faces; k++)
        g.face[k] = (slope){rng_between(r, -1, 1), rng_between(r, -1, 1), rng_between(r, -3, 3)};
    for (uint32_t i = 0; i < g.outline.count; i++)
        g.least = fmin(g.least, depth_at(g.face, g.faces, g.outline.P[i].x, g.outline.P[i].y));
    return g;
}

/* Depth of the nearest front over a point, as covers count it; -infinity if there is none. */
static double nearest_at(const front *g, int count, double x, double y)
{
    double depth = -INFINITY;
    for (int i = 0; i < count; i++)
        if (holds(g[i].outline.P, g[i].outline.count, x, y, 0))
            depth = fmax(depth, depth_at(g[i].face, g[i].faces, x, y));
    return depth;
}

enum { FRONTS = 12 };
#define SLACK 1e-3

static void add_covers(cover *c, scan *s, front *g, rng *r)
{
    for (int i = 0; i < FRONTS; i++) {
        static const int kinds[] = {ROUND, BORDERS, ROUND, WHOLE, NEEDLE, CORNER};
        hide_face face[3];
        g[i] = random_front(r, kinds[rng_int(r, 0, 5)]);
        for (uint32_t k = 0; k < g[i].faces; k++)
            face[k] = face_of(g[i].face[k]);
        bool by_cell = rng_int(r, 0, 1);
        cover_add(c, s, g[i].outline.P,
                  &(cover_front){.corner = g[i].outline.corner,
                                 .count = g[i].outline.count,
                                 .depth = g[i].least,
                                 .face = by_cell ? face : NULL,
                                 .face_count = by_cell ? g[i].faces : 0,
                                 .slack = SLACK,
                                 .by = (uint32_t)i});
    }
}

/* In a cell with a cover, the front that is said to cover it lies over every point, at least `slack` nearer than the
 * cover's depth. */
static void covers_cover(void **state)
{
    rng r = {76};
    size_t covered = 0;
    (void)state;
    for (int i = 0; i < 70; i++) {
        cover c;
        scan scratch;
        front g[FRONTS];
        assert_true(cover_init(&c, frame_of((size_t)i % ALL_FRAMES), 1) && scan_init(&scratch, c.frame.nx));
        add_covers(&c, &scratch, g, &r);
        for (uint32_t cell = 0; cell < scan_cells(&c.frame); cell++) {
            if (c.depth[cell] == -INFINITY)
                continue;
            covered++;
            for (int k = 0; k < 25; k++) { /* corners and borders too */
                double x = in_window_x(scan_left(&c.frame, cell / c.frame.ny + k % 5 / 4.0));
                double y = in_window_y(scan_lower(&c.frame, cell % c.frame.ny + k / 5 / 4.0));
                assert_true(nearest_at(&g[c.by[cell]], 1, x, y) >= (double)c.depth[cell] + SLACK - 1e-12);
            }
        }
        cover_free(&c);
        scan_free(&scratch);
    }
    assert_true(covered > 1000);
}

/* A cell that lies wholly behind a level front has at least that front's depth less the slack (and the rounding to a
 * float): no cover is missed. */
static void covers_are_not_wasted(void **state)
{
    rng r = {77};
    (void)state;
    for (int i = 0; i < 70; i++) {
        cover c;
        scan scratch;
        front g = random_front(&r, ROUND);
        double z = rng_between(&r, -3, 3);
        assert_true(cover_init(&c, frame_of((size_t)i % ALL_FRAMES), 1) && scan_init(&scratch, c.frame.nx));
        cover_add(
            &c, &scratch, g.outline.P,
            &(cover_front){.corner = g.outline.corner, .count = g.outline.count, .depth = z, .slack = SLACK, .by = 7});
        cover_add(&c, &scratch, g.outline.P,
                  &(cover_front){.corner = g.outline.corner,
                                 .count = g.outline.count,
                                 .depth = z - 1,
                                 .slack = SLACK,
                                 .by = 8}); /* farther: changes nothing */
        const borders b = borders_of(&c.frame);
        for (uint32_t cell = 0; cell < scan_cells(&c.frame); cell++) {
            roberts_vec3 q[4];
            bool well = true;
            cell_corners(&b, cell / c.frame.ny, cell % c.frame.ny, 0, q);
            for (int k = 0; k < 4; k++)
                well = well && holds(g.outline.P, g.outline.count, q[k].x, q[k].y, -1e4 * MARGIN);
            assert_true(!well || ((double)c.depth[cell] >= z - SLACK - 1e-6 && c.by[cell] == 7));
            double x = 0.5 * (q[0].x + q[2].x), y = 0.5 * (q[0].y + q[2].y);
            bool covered = c.depth[cell] > -INFINITY;
            assert_int_equal(cover_at(&c, x, y, (float)(z - 2 * SLACK)), covered ? 7 : ROBERTS_NONE);
            assert_int_equal(cover_at(&c, x, y, (float)z), ROBERTS_NONE);
        }
        cover_free(&c);
        scan_free(&scratch);
    }
}

/* Anything that counts as behind covers really is: every point of the box, or of the edge, has a front that much
 * nearer. */
static void what_covers_hide_is_hidden(void **state)
{
    rng r = {78};
    size_t boxes = 0, edges = 0;
    (void)state;
    for (int i = 0; i < 70; i++) {
        cover c;
        scan scratch;
        front g[FRONTS];
        assert_true(cover_init(&c, frame_of((size_t)i % ALL_FRAMES), 1) && scan_init(&scratch, c.frame.nx));
        add_covers(&c, &scratch, g, &r);
        for (int k = 0; k < 200; k++) {
            roberts_vec3 A, B;
            random_line(&r, k % LINES, &A, &B);
            double shorter = rng_between(&r, 0, 1), deeper = rng_between(&r, 0, 12);
            B = (roberts_vec3){A.x + shorter * (B.x - A.x), A.y + shorter * (B.y - A.y), B.z - deeper};
            A.z -= deeper * rng_between(&r, 0.5, 1);
            hide_box box = {hide_float_below(fmin(A.x, B.x)), hide_float_above(fmax(A.x, B.x)),
                            hide_float_below(fmin(A.y, B.y)), hide_float_above(fmax(A.y, B.y)),
                            hide_float_below(fmin(A.z, B.z)), hide_float_above(fmax(A.z, B.z))};
            bool hides = cover_hides(&c, &box), hides_edge = cover_hides_edge(&c, A, B);
            assert_true(hides_edge || !hides || fabs(B.x - A.x) + fabs(B.y - A.y) > 0);
            boxes += hides;
            edges += hides_edge;
            for (int p = 0; p < 100; p++) {
                double s = p % 10 / 9.0, t = p / 10 / 9.0, u = p / 99.0;
                double x = in_window_x((double)box.x0 + s * (double)(box.x1 - box.x0));
                double y = in_window_y((double)box.y0 + t * (double)(box.y1 - box.y0));
                assert_true(!hides || nearest_at(g, FRONTS, x, y) > (double)box.z1 + 0.9 * SLACK);
                x = A.x + u * (B.x - A.x);
                y = A.y + u * (B.y - A.y);
                assert_true(!hides_edge || nearest_at(g, FRONTS, x, y) > A.z + u * (B.z - A.z) + 0.9 * SLACK);
            }
        }
        cover_free(&c);
        scan_free(&scratch);
    }
    assert_true(boxes > 500 && edges > boxes);
}

/* In a frame with warps: an edge is behind covers only if it is in every cell that it touches, and it is if both its
 * ends are deeper than all these cells. */
static void edges_behind_covers_of_warped_cells(void **state)
{
    rng r = {81};
    objet_walk walk = {0};
    objet grid = {.frame = frame_of(ALL_FRAMES - 1)};
    cover c;
    int hidden = 0, seen_somewhere = 0;
    (void)state;
    assert_true(cover_init(&c, frame_of(ALL_FRAMES - 1), 1));
    for (size_t k = 0; k < scan_cells(&c.frame); k++)
        c.depth[k] = rng_int(&r, 0, 40) ? 0.0f : -2.0f;
    for (int i = 0; i < 400 * LINES; i++) {
        roberts_vec3 A, B;
        random_line(&r, i % LINES, &A, &B);
        A.z = rng_between(&r, -3, 0.1);
        B.z = rng_between(&r, -3, 0.1);
        assert_true(objet_cells(&grid, A, B, &walk));
        bool behind = cover_hides_edge(&c, A, B), all = true, deeper = true;
        for (size_t k = 0; k < walk.count; k++) {
            const objet_stretch *s = &walk.item[k];
            double near = fmax(A.z + s->t0 * (B.z - A.z), A.z + s->t1 * (B.z - A.z));
            double depth = (double)c.depth[(size_t)s->column * c.frame.ny + s->row];
            all = all && near < depth;
            deeper = deeper && fmax(A.z, B.z) < depth - 1e-6;
        }
        assert_true((all || !behind) && (behind || !deeper));
        hidden += behind;
        seen_somewhere += !all;
    }
    assert_true(hidden > 50 && seen_somewhere > 50);
    cover_free(&c);
    free(walk.item);
    objet_free(&grid);
}

/* Without cells no cover is kept, and nothing is behind one. */
static void no_covers(void **state)
{
    cover c;
    scan scratch = {0};
    polygon g = rectangle(-1, 2, 7, 6);
    hide_box box = {0, 1, 3, 4, -9, -8};
    (void)state;
    assert_true(cover_init(&c, (scan_frame){0}, 1));
    cover_add(&c, &scratch, g.P,
              &(cover_front){.corner = g.corner, .count = g.count, .depth = 5, .slack = SLACK, .by = 0});
    assert_false(cover_hides(&c, &box));
    assert_false(cover_hides_edge(&c, (roberts_vec3){0, 3, -9}, (roberts_vec3){1, 4, -9}));
    cover_free(&c);
}

/* ---- how many cells -------------------------------------------------------------------------------------------- */

enum { BOXES = 20000 };

/* `huge` boxes over all the window, the others `size` of it (a needle across, upright or level, where tall or wide). */
static void make_boxes(hide_box *box, uint32_t huge, double w, double h, rng *r)
{
    for (uint32_t i = 0; i < BOXES; i++) {
        double bw = i < huge ? 8 : 8 * w, bh = i < huge ? 4 : 4 * h;
        double x = rng_between(r, -1, 7 - bw), y = rng_between(r, 2, 6 - bh);
        box[i] = (hide_box){(float)x, (float)(x + bw), (float)y, (float)(y + bh), 0, 1};
    }
}

static double entries(const scan_frame *f, const hide_box *box)
{
    double sum = 0.0;
    for (uint32_t i = 0; i < BOXES; i++) {
        uint32_t columns = scan_column(f, (double)box[i].x1) - scan_column(f, (double)box[i].x0) + 1;
        uint32_t rows = scan_row(f, (double)box[i].y1) - scan_row(f, (double)box[i].y0) + 1;
        sum += (double)columns * rows;
    }
    return sum;
}

/* Lists and cells stay in proportion to the boxes, whatever their sizes; and where boxes are small there are many
 * cells, so that lists are short. */
static void cells_by_table(void **state)
{
    static const struct {
        const char *name;
        uint32_t huge;
        double w, h;
        double least_cells;
    } table[] = {
        {"all small", 0, 0.007, 0.007, 2000},
        {"a few huge ones among small ones", 20, 0.005, 0.005, 400},
        {"a few huge ones among specks", 20, 1e-6, 1e-6, 400},
        {"many huge ones", 2000, 1e-3, 1e-3, 1},
        {"all huge", BOXES, 1, 1, 1},
        {"specks", 0, 1e-7, 1e-7, 2000},
        {"points", 0, 0, 0, 2000},
        {"upright needles", 0, 1e-4, 0.9, 100},
        {"level needles", 0, 0.9, 1e-4, 100},
    };
    hide_box *box = malloc(BOXES * sizeof *box);
    rng r = {79};
    double depth;
    (void)state;
    assert_non_null(box);
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        make_boxes(box, table[i].huge, table[i].w, table[i].h, &r);
        scan_frame f = cells_for_lists(&(cells_boxes){box, BOXES, window_low, window_high, MARGIN}, 0, &depth);
        scan_frame c = cells_for_covers(&(cells_boxes){box, BOXES, window_low, window_high, MARGIN}, 8 * BOXES, 1);
        double listed = entries(&f, box), cells = (double)scan_cells(&f), covers = (double)scan_cells(&c);
        free(f.warps);
        free(c.warps);
        if (listed > 40.0 * BOXES || cells > 8.0 * BOXES || cells < table[i].least_cells || covers > 64.0 * BOXES)
            fail_msg("%s: %g cells, %g entries, %g cells of covers", table[i].name, cells, listed, covers);
    }
    free(box);
}

/* Moves all boxes but a hundred to a thousandth of the window. */
static void crowd_boxes(hide_box *box)
{
    for (uint32_t i = 100; i < BOXES; i++) {
        float *side = &box[i].x0;
        for (int k = 0; k < 4; k++)
            side[k] = k < 2 ? 1.0f + 0.03f * side[k] : 3.0f + 0.03f * side[k];
    }
}

/* Is a column at x much narrower than the mean one, and is each at least four margins wide? */
static bool is_narrow_at(const scan_frame *f, double x)
{
    const double i = scan_column(f, x), mean = (window_high.x - window_low.x) / f->nx;
    for (uint32_t k = 0; k + 1 < f->nx; k++)
        if (scan_left(f, k + 1.0) - scan_left(f, k) < 4.0 * MARGIN)
            return false;
    return scan_left(f, i + 1.0) - scan_left(f, i) < 0.1 * mean;
}

/* Where nearly all boxes crowd in a thousandth of the window, cells are much smaller there; the lists stay short. Boxes
 * at random, and few boxes, get equal cells, and so does a number of cells that is asked for. Cells of covers follow
 * the same rule. */
static void cells_where_boxes_crowd(void **state)
{
    hide_box *box = malloc(BOXES * sizeof *box);
    rng r = {83};
    double depth;
    (void)state;
    assert_non_null(box);
    make_boxes(box, 0, 1e-4, 1e-4, &r);
    cells_boxes boxes = {box, BOXES, window_low, window_high, MARGIN};
    scan_frame f = cells_for_lists(&boxes, 0, &depth);
    assert_null(f.warps);
    crowd_boxes(box);
    f = cells_for_lists(&boxes, 0, &depth);
    assert_non_null(f.warps);
    assert_true(is_narrow_at(&f, 1.1) && entries(&f, box) < 12.0 * BOXES);
    free(f.warps);
    f = cells_for_covers(&boxes, 8 * boxes.count, 1); /* no depth anywhere */
    assert_int_equal(scan_cells(&f), 0);
    assert_null(f.warps);
    assert_null(cells_for_lists(&boxes, 30, &depth).warps);
    make_boxes(box, 0, 0.03, 0.05, &r);
    f = cells_for_covers(&boxes, 8 * boxes.count, 1);
    assert_true(scan_cells(&f) > BOXES && !f.warps);
    crowd_boxes(box);
    f = cells_for_covers(&boxes, 8 * boxes.count, 1);
    assert_non_null(f.warps);
    assert_true(is_narrow_at(&f, 1.1) && scan_cells(&f) > BOXES && scan_cells(&f) < 64.0 * BOXES);
    free(f.warps);
    boxes.count = 200;
    assert_null(cells_for_lists(&boxes, 0, &depth).warps);
    free(box);
}

static void cells_given_or_few(void **state)
{
    hide_box box[2] = {{-1, 7, 2, 6, 0, 1}, {0, 1, 3, 4, 0, 1}};
    roberts_vec2 upright = {window_low.x, window_high.y};
    double depth;
    (void)state;
    scan_frame f = cells_for_lists(&(cells_boxes){box, 2, window_low, window_high, MARGIN}, 17, &depth);
    assert_true(f.nx == 17 && f.ny == 17);
    f = cells_for_lists(&(cells_boxes){box, 2, window_low, window_high, MARGIN}, ROBERTS_GRID_MOST, &depth);
    assert_true(scan_cells(&f) > 20000 && scan_cells(&f) < 70000); /* not 4096 * 4096, for two boxes */
    f = cells_for_lists(&(cells_boxes){box, 0, window_low, window_high, MARGIN}, 0, &depth);
    assert_true(f.nx == 1 && f.ny == 1);
    f = cells_for_lists(&(cells_boxes){box, 2, window_low, upright, MARGIN}, 0, &depth); /* no width */
    assert_true(f.nx >= 1 && f.ny >= 1 && f.dx > 0 && f.dy > 0);
    f = cells_for_covers(&(cells_boxes){box, 2, window_low, upright, MARGIN}, 16, 1);
    assert_int_equal(scan_cells(&f), 0);
    double area = (window_high.x - window_low.x) * (window_high.y - window_low.y);
    cells_for_lists(&(cells_boxes){box, 2, window_low, window_high, MARGIN}, 0, &depth);
    assert_true(fabs(depth - (8.0 * 4.0 + 1.0 * 1.0) / area) < 1e-12);
}

/* ... the same by any number of threads. */
static void cells_by_threads(void **state)
{
    hide_box *box = malloc(4 * BOXES * sizeof *box);
    rng r = {80};
    (void)state;
    assert_non_null(box);
    for (int i = 0; i < 4; i++)
        make_boxes(box + i * BOXES, 20, 0.03, 0.05, &r);
    scan_frame one = cells_for_covers(&(cells_boxes){box, 4 * BOXES, window_low, window_high, MARGIN}, 32 * BOXES, 1);
    assert_true(one.nx > 100);
    for (int threads = 2; threads < 5; threads++) {
        scan_frame f =
            cells_for_covers(&(cells_boxes){box, 4 * BOXES, window_low, window_high, MARGIN}, 32 * BOXES, threads);
        assert_memory_equal(&f, &one, sizeof f);
    }
    free(box);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scan_is_conservative_and_tight),
        cmocka_unit_test(scan_forgets),
        cmocka_unit_test(windows_without_size),
        cmocka_unit_test(walks_meet_every_cell),
        cmocka_unit_test(sides_tell_boxes_apart),
        cmocka_unit_test(lists_are_complete_and_in_order),
        cmocka_unit_test(lists_by_threads),
        cmocka_unit_test(copies_count_once),
        cmocka_unit_test(covers_cover),
        cmocka_unit_test(covers_are_not_wasted),
        cmocka_unit_test(what_covers_hide_is_hidden),
        cmocka_unit_test(edges_behind_covers_of_warped_cells),
        cmocka_unit_test(no_covers),
        cmocka_unit_test(cells_by_table),
        cmocka_unit_test(cells_where_boxes_crowd),
        cmocka_unit_test(cells_given_or_few),
        cmocka_unit_test(cells_by_threads),
    };
    return cmocka_run_group_tests_name("objet", tests, NULL, NULL);
}
