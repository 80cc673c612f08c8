/* free_space.c - where there is room on the page.
 *
 * The page is divided into square cells. Each lists the lines that may cross it and the boxes that touch it. A line may
 * cross several cells of the queried box. In each cell only its part within that cell counts, so nothing counts
 * twice. */
#include "draw/free_space.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/box.h"
#include "base/orient.h"
#include "base/vec.h"

enum { CELLS_MOST = 1000 /* a side */ };

/* mm; boxes that overlap by no more touch in a line. */
#define LINE 1e-9

#define NOTHING UINT32_MAX

typedef struct entry {
    uint32_t what, next;
} entry;

typedef struct page_line {
    roberts_vec2 a, b;
    double length;
} page_line;

struct free_space {
    double cell_mm;
    space_box within; /* what text must not leave */
    uint32_t columns, rows;
    uint32_t *first_line, *first_box; /* [columns * rows] entries; NOTHING: none */
    entry *entry;
    page_line *line;
    space_box *box;
    size_t entry_count, line_count, box_count, entry_room, line_room, box_room;
};

/* Columns and rows that a box touches, from low to high. */
typedef struct cells {
    uint32_t low_x, low_y, high_x, high_y;
} cells;

static uint32_t cell_along_page(double mm, double cell_mm, uint32_t count)
{
    const double cell = floor(mm / cell_mm);
    return cell <= 0.0 ? 0 : cell >= count ? count - 1 : (uint32_t)cell;
}

static cells cells_of(const free_space *r, const space_box *box)
{
    return (cells){
        cell_along_page(box->min.x, r->cell_mm, r->columns), cell_along_page(box->min.y, r->cell_mm, r->rows),
        cell_along_page(box->max.x, r->cell_mm, r->columns), cell_along_page(box->max.y, r->cell_mm, r->rows)};
}

free_space *space_new(double width_mm, double height_mm, double cell_mm, const space_box *within)
{
    free_space *r = calloc(1, sizeof *r);
    if (!r)
        return NULL;
    r->cell_mm = fmax(cell_mm, fmax(width_mm, height_mm) / CELLS_MOST);
    r->within = *within;
    r->columns = (uint32_t)ceil(width_mm / r->cell_mm);
    r->rows = (uint32_t)ceil(height_mm / r->cell_mm);
    const size_t count = (size_t)r->columns * r->rows;
    r->first_line = alloc_array(count, sizeof *r->first_line);
    r->first_box = alloc_array(count, sizeof *r->first_box);
    if (!r->first_line || !r->first_box) {
        space_free(r);
        return NULL;
    }
    for (size_t i = 0; i < count; i++)
        r->first_line[i] = r->first_box[i] = NOTHING;
    return r;
}

void space_free(free_space *r)
{
    if (!r)
        return;
    free(r->first_line);
    free(r->first_box);
    free(r->entry);
    free(r->line);
    free(r->box);
    free(r);
}

static bool enter_item(free_space *r, uint32_t *first, uint32_t what)
{
    if (!array_reserve(&r->entry, &r->entry_room, r->entry_count + 1, sizeof *r->entry))
        return false;
    r->entry[r->entry_count] = (entry){what, *first};
    *first = (uint32_t)r->entry_count++;
    return true;
}

/* The part of a..b within a box, from t[0] to t[1]. */
static bool clip(roberts_vec2 a, roberts_vec2 b, const space_box *box, double t[2])
{
    t[0] = 0.0;
    t[1] = 1.0;
    return box_clip(a.x, b.x, box->min.x, box->max.x, &t[0], &t[1]) &&
           box_clip(a.y, b.y, box->min.y, box->max.y, &t[0], &t[1]);
}

static space_box cell_box(const free_space *r, uint32_t x, uint32_t y)
{
    return (space_box){{x * r->cell_mm, y * r->cell_mm}, {(x + 1) * r->cell_mm, (y + 1) * r->cell_mm}};
}

bool space_add_line(free_space *r, roberts_vec2 a, roberts_vec2 b)
{
    const space_box box = space_box_around(a, b);
    const cells in = cells_of(r, &box);
    double t[2];
    if (!array_reserve(&r->line, &r->line_room, r->line_count + 1, sizeof *r->line))
        return false;
    r->line[r->line_count] = (page_line){a, b, vec2_length(b.x - a.x, b.y - a.y)};
    for (uint32_t y = in.low_y; y <= in.high_y; y++)
        for (uint32_t x = in.low_x; x <= in.high_x; x++) {
            const space_box cell = cell_box(r, x, y);
            if (clip(a, b, &cell, t) && !enter_item(r, &r->first_line[y * r->columns + x], (uint32_t)r->line_count))
                return false;
        }
    r->line_count++;
    return true;
}

static roberts_vec2 in_mm(page_point p, double units_per_mm)
{
    return page_in_mm((roberts_vec2){p.x, p.y}, units_per_mm);
}

bool space_add_polyline(free_space *r, const polylines *lines, size_t i, double units_per_mm)
{
    const polyline *line = &lines->item[i];
    const page_point *p = lines->point + line->first;
    for (uint32_t k = 0; k + 1 < line->count + line->closed; k++)
        if (!space_add_line(r, in_mm(p[k], units_per_mm), in_mm(p[(k + 1) % line->count], units_per_mm)))
            return false;
    return true;
}

static bool enter_box(free_space *r, uint32_t number)
{
    const cells in = cells_of(r, &r->box[number]);
    for (uint32_t y = in.low_y; y <= in.high_y; y++)
        for (uint32_t x = in.low_x; x <= in.high_x; x++)
            if (!enter_item(r, &r->first_box[y * r->columns + x], number))
                return false;
    return true;
}

bool space_add_box(free_space *r, const space_box *box, uint32_t *number)
{
    if (!array_reserve(&r->box, &r->box_room, r->box_count + 1, sizeof *r->box))
        return false;
    *number = (uint32_t)r->box_count;
    r->box[r->box_count++] = *box;
    return enter_box(r, *number);
}

bool space_add_boxes(free_space *r, const space_box *box, size_t count, double more)
{
    bool done = true;
    for (size_t i = 0; i < count && done; i++) {
        const space_box wide = {{box[i].min.x - more, box[i].min.y - more}, {box[i].max.x + more, box[i].max.y + more}};
        uint32_t number;
        done = space_add_box(r, &wide, &number);
    }
    return done;
}

/* Removed entries stay in memory, unused. */
void space_drop_box(free_space *r, uint32_t number)
{
    const cells from = cells_of(r, &r->box[number]);
    for (uint32_t y = from.low_y; y <= from.high_y; y++)
        for (uint32_t x = from.low_x; x <= from.high_x; x++) {
            uint32_t *at = &r->first_box[y * r->columns + x];
            while (*at != NOTHING && r->entry[*at].what != number)
                at = &r->entry[*at].next;
            if (*at != NOTHING)
                *at = r->entry[*at].next;
        }
}

bool space_move_box(free_space *r, uint32_t number, const space_box *box)
{
    space_drop_box(r, number);
    r->box[number] = *box;
    return enter_box(r, number);
}

/* The overlap of two boxes; false: there is none. */
static bool share(const space_box *a, const space_box *b, space_box *both)
{
    *both = (space_box){{greater(a->min.x, b->min.x), greater(a->min.y, b->min.y)},
                        {lesser(a->max.x, b->max.x), lesser(a->max.y, b->max.y)}};
    return both->min.x < both->max.x && both->min.y < both->max.y;
}

/* Adds lengths of lines in the part of the box that cell x, y holds. */
static void add_lines(const free_space *r, const space_box *box, uint32_t x, uint32_t y, double enough, double *mm)
{
    const space_box cell = cell_box(r, x, y);
    double taken = 0.0, t[2];
    space_box part;
    if (!share(box, &cell, &part))
        return;
    for (uint32_t i = r->first_line[(size_t)y * r->columns + x]; i != NOTHING && *mm + taken < enough;
         i = r->entry[i].next) {
        const page_line *line = &r->line[r->entry[i].what];
        if (clip(line->a, line->b, &part, t))
            taken += (t[1] - t[0]) * line->length;
    }
    *mm += taken;
}

/* Adds the shorter sides of the overlaps with other boxes. Each overlap counts in the cell of its lower left corner. */
static void add_boxes(const free_space *r, const space_box *box, uint32_t own, uint32_t most, space_load *load)
{
    const cells in = cells_of(r, box);
    space_box part;
    for (uint32_t y = in.low_y; y <= in.high_y; y++)
        for (uint32_t x = in.low_x; x <= in.high_x; x++)
            for (uint32_t i = r->first_box[(size_t)y * r->columns + x]; i != NOTHING; i = r->entry[i].next) {
                if (r->entry[i].what == own || !share(box, &r->box[r->entry[i].what], &part) ||
                    cell_along_page(part.min.x, r->cell_mm, r->columns) != x ||
                    cell_along_page(part.min.y, r->cell_mm, r->rows) != y)
                    continue;
                const double side = lesser(part.max.x - part.min.x, part.max.y - part.min.y);
                load->mm += side;
                load->boxes += side > LINE;
                if (load->boxes > most)
                    return;
            }
}

space_load space_load_of(const free_space *r, const space_box *box, uint32_t own, uint32_t most_boxes, double enough)
{
    const cells in = cells_of(r, box);
    space_load load = {0.0, 0};
    if (box->min.x < r->within.min.x || box->min.y < r->within.min.y || box->max.x > r->within.max.x ||
        box->max.y > r->within.max.y)
        return (space_load){INFINITY, 0};
    add_boxes(r, box, own, most_boxes, &load);
    for (uint32_t y = in.low_y; y <= in.high_y; y++)
        for (uint32_t x = in.low_x; x <= in.high_x && load.boxes <= most_boxes && load.mm < enough; x++)
            add_lines(r, box, x, y, enough, &load.mm);
    return load;
}

double space_to_next_box(const free_space *r, const space_box *box, uint32_t own, double most)
{
    const space_box wide = {{box->min.x - most, box->min.y - most}, {box->max.x + most, box->max.y + most}};
    const cells in = cells_of(r, &wide);
    double least = most;
    for (uint32_t y = in.low_y; y <= in.high_y; y++)
        for (uint32_t x = in.low_x; x <= in.high_x; x++)
            for (uint32_t i = r->first_box[(size_t)y * r->columns + x]; i != NOTHING; i = r->entry[i].next) {
                const space_box *other = &r->box[r->entry[i].what];
                const double dx = greater(other->min.x - box->max.x, box->min.x - other->max.x);
                const double dy = greater(other->min.y - box->max.y, box->min.y - other->max.y);
                if (r->entry[i].what != own)
                    least = lesser(least, vec2_length(greater(dx, 0.0), greater(dy, 0.0)));
            }
    return least;
}

bool space_meets_line(const free_space *r, const space_box *box)
{
    const cells in = cells_of(r, box);
    double mm = 0.0;
    for (uint32_t y = in.low_y; y <= in.high_y; y++)
        for (uint32_t x = in.low_x; x <= in.high_x && mm <= 0.0; x++)
            add_lines(r, box, x, y, DBL_MIN, &mm);
    return mm > 0.0;
}

bool space_lines_cross(roberts_vec2 a, roberts_vec2 b, roberts_vec2 c, roberts_vec2 d)
{
    return orient2d(a, b, c) * orient2d(a, b, d) < 0.0 && orient2d(c, d, a) * orient2d(c, d, b) < 0.0;
}

bool space_line_meets_box(roberts_vec2 a, roberts_vec2 b, const space_box *box)
{
    double t[2];
    return clip(a, b, box, t) && t[0] < t[1];
}

bool space_line_meets_boxes(const free_space *r, roberts_vec2 a, roberts_vec2 b, uint32_t own)
{
    const space_box box = space_box_around(a, b);
    const cells in = cells_of(r, &box);
    for (uint32_t y = in.low_y; y <= in.high_y; y++)
        for (uint32_t x = in.low_x; x <= in.high_x; x++)
            for (uint32_t i = r->first_box[(size_t)y * r->columns + x]; i != NOTHING; i = r->entry[i].next)
                if (r->entry[i].what != own && space_line_meets_box(a, b, &r->box[r->entry[i].what]))
                    return true;
    return false;
}

/* A crossing counts in its own cell. */
size_t space_count_crossings(const free_space *r, roberts_vec2 a, roberts_vec2 b)
{
    const space_box box = space_box_around(a, b);
    const cells in = cells_of(r, &box);
    size_t count = 0;
    for (uint32_t y = in.low_y; y <= in.high_y; y++)
        for (uint32_t x = in.low_x; x <= in.high_x; x++)
            for (uint32_t i = r->first_line[(size_t)y * r->columns + x]; i != NOTHING; i = r->entry[i].next) {
                const page_line *line = &r->line[r->entry[i].what];
                const double from = orient2d(line->a, line->b, a), to = orient2d(line->a, line->b, b);
                const double t = from / (from - to); /* used only if they cross */
                count += space_lines_cross(a, b, line->a, line->b) &&
                         cell_along_page(a.x + t * (b.x - a.x), r->cell_mm, r->columns) == x &&
                         cell_along_page(a.y + t * (b.y - a.y), r->cell_mm, r->rows) == y;
            }
    return count;
}

static int by_start(const void *a, const void *b)
{
    const space_part *p = a, *q = b;
    return (p->from > q->from) - (p->from < q->from);
}

/* Adds the parts in the boxes that a cell lists. */
static bool add_covered(const free_space *r, roberts_vec2 a, roberts_vec2 b, size_t cell, space_parts *out)
{
    double t[2];
    for (uint32_t i = r->first_box[cell]; i != NOTHING; i = r->entry[i].next) {
        if (!clip(a, b, &r->box[r->entry[i].what], t) || t[0] >= t[1])
            continue;
        if (!array_reserve(&out->item, &out->room, out->count + 1, sizeof *out->item))
            return false;
        out->item[out->count++] = (space_part){t[0], t[1]};
    }
    return true;
}

bool space_find_covered(const free_space *r, roberts_vec2 a, roberts_vec2 b, space_parts *out)
{
    const space_box box = space_box_around(a, b);
    const cells in = cells_of(r, &box);
    size_t kept = 0;
    out->count = 0;
    for (uint32_t y = in.low_y; y <= in.high_y; y++)
        for (uint32_t x = in.low_x; x <= in.high_x; x++)
            if (!add_covered(r, a, b, (size_t)y * r->columns + x, out))
                return false;
    if (out->count > 1)
        qsort(out->item, out->count, sizeof *out->item, by_start);
    for (size_t i = 0; i < out->count; i++) { /* a box may be listed in several cells */
        if (kept > 0 && out->item[i].from <= out->item[kept - 1].to)
            out->item[kept - 1].to = greater(out->item[kept - 1].to, out->item[i].to);
        else
            out->item[kept++] = out->item[i];
    }
    out->count = kept;
    return true;
}

/* ---- the middle of a region -------------------------------------------------------------------------------------- */

/* The point of a region that is farthest from some lines, by a grid of points that is refined about the best
 * one. That may miss the best point of a region of very many arms, but never leaves the region. */

enum { GRID = 16, ROUNDS = 5 };

static double segment_distance(roberts_vec2 p, roberts_vec2 a, roberts_vec2 b)
{
    const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
    const double t = square > 0.0 ? fmin(fmax(((p.x - a.x) * x + (p.y - a.y) * y) / square, 0.0), 1.0) : 0.0;
    return vec2_length(a.x + t * x - p.x, a.y + t * y - p.y);
}

/* How far the nearest line is from p: > 0 within the region (by the parity of crossings), < 0 outside. Any number up to
 * `most` stands for what is no more than that. */
static double depth_of(const pole_line *line, size_t count, size_t border, roberts_vec2 p, double most)
{
    double least = INFINITY;
    bool inside = false;
    for (size_t i = 0; i < border; i++)
        inside ^= vec2_ray_crosses(p, line[i].a, line[i].b);
    if (!inside && most >= 0.0)
        return -INFINITY;
    for (size_t i = 0; i < count && !(inside && least <= most); i++)
        least = fmin(least, segment_distance(p, line[i].a, line[i].b));
    return inside ? least : -least;
}

/* Of points that are nearly as far from the border, the one in the middle is the best: in a long strip all are. */
static const double off_middle = 0.2;

static void find_box(const pole_line *line, size_t count, roberts_vec2 *min, roberts_vec2 *max)
{
    *min = (roberts_vec2){INFINITY, INFINITY};
    *max = (roberts_vec2){-INFINITY, -INFINITY};
    for (size_t i = 0; i < 2 * count; i++) {
        const roberts_vec2 p = i % 2 ? line[i / 2].b : line[i / 2].a;
        *min = (roberts_vec2){fmin(min->x, p.x), fmin(min->y, p.y)};
        *max = (roberts_vec2){fmax(max->x, p.x), fmax(max->y, p.y)};
    }
}

/* How far p is within a box; < 0: outside. */
static double depth_in_box(const space_box *box, roberts_vec2 p)
{
    return fmin(fmin(p.x - box->min.x, box->max.x - p.x), fmin(p.y - box->min.y, box->max.y - p.y));
}

pole pole_find(const pole_line *line, size_t count, size_t border, const space_box *within)
{
    roberts_vec2 min, max;
    find_box(line, border, &min, &max);
    if (within) {
        min = (roberts_vec2){fmax(min.x, within->min.x), fmax(min.y, within->min.y)};
        max = (roberts_vec2){fmin(max.x, within->max.x), fmin(max.y, within->max.y)};
    }
    if (!(min.x <= max.x && min.y <= max.y))
        return (pole){min, 0.0};
    pole best = {{min.x / 2.0 + max.x / 2.0, min.y / 2.0 + max.y / 2.0}, -INFINITY};
    const roberts_vec2 middle = best.at;
    roberts_vec2 size = {max.x - min.x, max.y - min.y};
    const double half = vec2_length(size.x, size.y) / 2.0;
    double most = -INFINITY;
    for (int round = 0; round < ROUNDS; round++) {
        const roberts_vec2 from = {best.at.x - size.x / 2.0, best.at.y - size.y / 2.0};
        for (int i = 0; i < GRID * GRID; i++) {
            const roberts_vec2 p = {from.x + (i % GRID + 0.5) / GRID * size.x,
                                    from.y + (i / GRID + 0.5) / GRID * size.y};
            const double deep = depth_of(line, count, border, p, most),
                         depth = within ? fmin(deep, depth_in_box(within, p)) : deep;
            const double off = half > 0.0 ? vec2_length(p.x - middle.x, p.y - middle.y) / half : 0.0;
            const double worth = depth > 0.0 ? depth * (1.0 - off_middle * off) : depth;
            if (worth > most) {
                most = worth;
                best = (pole){p, depth};
            }
        }
        size = (roberts_vec2){size.x / 4.0, size.y / 4.0};
    }
    best.distance = fmax(best.distance, 0.0);
    return best;
}
