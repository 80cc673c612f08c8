/* edge.c - see edge.h.
 *
 * The edges of a small solid go through the cells together: each front in them is met once, by all edges. The edges of a
 * solid that spans many cells go one by one, each through the cells that its own picture crosses. */
#include "hide/edge.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/bits.h"
#include "base/lanes.h"

/* A solid of more columns or rows than this is taken edge by edge. */
#define GROUP_CELLS 3

static bool more_lines(hide_worker *w)
{
    size_t room = w->line_room;
    if (!array_grow(&w->line, &w->line_room, w->line_count + 1, sizeof *w->line))
        return false;
    memset(w->line + room, 0, (w->line_room - room) * sizeof *w->line);
    return true;
}

bool hide_worker_init(hide_worker *w, const hide_picture *picture, const objet *grid)
{
    *w = (hide_worker){.picture = picture, .grid = grid, .margin = hide_margin(&picture->space)};
    w->seen = alloc_zeroed(picture->front_count, sizeof *w->seen);
    return w->seen && hide_sides_reserve(&w->sides, picture->most_corners) &&
           more_lines(w); /* a line at least: where there is none, its array can be pointed into */
}

void hide_worker_free(hide_worker *w)
{
    for (size_t i = 0; i < w->line_room; i++) {
        free(w->line[i].parts.item);
        free(w->line[i].hulls.item);
    }
    free(w->line);
    free(w->sides.H);
    free(w->walk.item);
    free(w->seen);
    *w = (hide_worker){0};
}

BITS_INLINE hide_box box_of(const hide_edge *e, double margin)
{
    hide_box box;
    float low[2], high[2];
    two a = two_of(e->A.x, e->A.y), b = two_of(e->B.x, e->B.y), m = two_all(margin), ulp = two_all(0x1p-23);
    two from = two_sub(two_lesser(a, b), m), to = two_add(two_greater(a, b), m);
    two_store_floats(low, two_sub(from, two_mul(two_abs(from), ulp))); /* as hide_float_below(), hide_float_above() */
    two_store_floats(high, two_add(to, two_mul(two_abs(to), ulp)));
    box = (hide_box){low[0], high[0], low[1], high[1], 0.0f, 0.0f};
    box.z0 = hide_float_below(lesser(e->A.z, e->B.z) - margin);
    box.z1 = hide_float_above(greater(e->A.z, e->B.z) + margin);
    return box;
}

static void join_box(hide_box *all, const hide_box *box)
{
    all->x0 = box->x0 < all->x0 ? box->x0 : all->x0;
    all->x1 = box->x1 > all->x1 ? box->x1 : all->x1;
    all->y0 = box->y0 < all->y0 ? box->y0 : all->y0;
    all->y1 = box->y1 > all->y1 ? box->y1 : all->y1;
    all->z0 = box->z0 < all->z0 ? box->z0 : all->z0;
    all->z1 = box->z1 > all->z1 ? box->z1 : all->z1;
}

hide_line *hide_worker_add(hide_worker *w, uint32_t edge)
{
    const hide_picture *picture = w->picture;
    const scene_edge *from = &picture->scene->edge[edge];
    size_t n = w->line_count;
    if (n == w->line_room && !more_lines(w))
        return NULL;
    hide_line *line = &w->line[w->line_count++];
    hide_edge *e = &line->e;
    e->A = picture->P[from->v[0]];
    e->B = picture->P[from->v[1]];
    e->a = from->v[0];
    e->b = from->v[1];
    roberts_vec3 AB = vec3_sub(e->B, e->A);
    e->length = sqrt(AB.x * AB.x + AB.y * AB.y);
    e->length3 = vec3_length(AB);
    hide_box box = box_of(e, w->margin);
    join_box(&w->box, &box);
    if (n < HIDE_GROUP) {
        w->x0[n] = box.x0;
        w->x1[n] = box.x1;
        w->y0[n] = box.y0;
        w->y1[n] = box.y1;
        w->z0[n] = box.z0;
    }
    line->parts.count = line->hulls.count = 0;
    line->hidden = false;
    line->edge = edge;
    return line;
}

static bool apart(const hide_box *a, const hide_box *b)
{
    return a->x1 < b->x0 || a->x0 > b->x1 || a->y1 < b->y0 || a->y0 > b->y1 || a->z1 < b->z0;
}

/* One edge against one front that may be nearer somewhere. */
static inline bool meet(hide_worker *w, hide_line *line, const hide_front *front, hide_approach approach)
{
    hide_part part;
    if (!hide_by_front(w->picture, front, approach, &line->e, &w->sides, &w->tally, &part))
        return true;
    if (front->corners == 0) {
        if (!hide_parts_hull(&line->hulls, front->solid, &part))
            return false;
    } else if (line->parts.count == 0 && line->parts.room > 0) { /* as hide_parts_add() does, without a call */
        line->parts.item[line->parts.count++] = (hide_solid_part){part, front->solid};
    } else if (!hide_parts_add(&line->parts, front->solid, &part)) {
        return false;
    }
    if (part.t0 == 0.0 && part.t1 == 1.0) {
        line->hidden = true;
        w->live--;
    }
    return true;
}

/* The group's lines against one front, as far as their boxes meet. */
static bool meet_group(hide_worker *w, const hide_front *front, const hide_box *box)
{
    four x0 = four_all(box->x0), x1 = four_all(box->x1), y0 = four_all(box->y0), y1 = four_all(box->y1);
    four z1 = four_all(box->z1);
    hide_approach approach = hide_approach_front(w->picture, front, &w->box);
    for (size_t i = 0; i < w->line_count; i += 4) {
        unsigned apart_xy = four_less(x1, four_load(w->x0 + i)) | four_less(four_load(w->x1 + i), x0) |
                            four_less(y1, four_load(w->y0 + i)) | four_less(four_load(w->y1 + i), y0);
        for (unsigned met = 15u & ~(apart_xy | four_less(z1, four_load(w->z0 + i))); met; met &= met - 1) {
            size_t n = i + (size_t)bits_trailing_zeros(met);
            if (!meet(w, &w->line[n], front, approach))
                return false;
            if (w->line[n].hidden)
                w->x0[n] = INFINITY;
        }
    }
    return true;
}

/* A line, or the group's where it is NULL, within `box` (but for depth, of which `far` is the farthest), against one
 * cell's fronts, as long as one of them is not wholly hidden. */
static bool meet_cell(hide_worker *w, uint32_t solid, hide_line *line, const hide_box *box, uint32_t cell, float far)
{
    const objet *grid = w->grid;
    for (uint32_t k = grid->start[cell], end = grid->start[cell + 1], after; w->live && k < end; k = after) {
        uint32_t index = grid->front[k];
        const hide_box *other = &w->picture->front_box[index];
        after = k + 1;
        if (grid->next && w->picture->front[index].solid == solid) {
            after = grid->next[k];
            continue;
        }
        if (other->z1 < far)
            break; /* and so are all that follow: none of them has a point nearer than the lines here */
        if (apart(other, box) || w->seen[index] == w->stamp)
            continue;
        w->seen[index] = w->stamp;
        const hide_front *front = &w->picture->front[index];
        if (front->solid == solid)
            continue;
        if (line ? !meet(w, line, front, hide_approach_front(w->picture, front, box)) : !meet_group(w, front, other))
            return false;
    }
    return true;
}

/* A new stamp; when they run out, all start again. */
static void next_stamp(hide_worker *w)
{
    if (++w->stamp == 0) {
        memset(w->seen, 0, w->picture->front_count * sizeof *w->seen);
        w->stamp = 1;
    }
}

/* One edge through the cells that it crosses. */
static bool run_alone(hide_worker *w, uint32_t solid, hide_line *line)
{
    const hide_edge *e = &line->e;
    if (line->hidden)
        return true;
    w->live = 1;
    next_stamp(w);
    if (!objet_cells(w->grid, e->A, e->B, &w->walk))
        return false;
    hide_box box = box_of(e, w->margin);
    for (size_t i = 0; w->live && i < w->walk.count; i++) {
        objet_stretch s = w->walk.item[i];
        float far = hide_float_below(lesser(hide_edge_at(e, s.t0).z, hide_edge_at(e, s.t1).z) - w->margin);
        if (!meet_cell(w, solid, line, &box, s.cell, far))
            return false;
    }
    return true;
}

/* All edges through the cells of their common box. */
static bool run_together(hide_worker *w, uint32_t solid, uint32_t left, uint32_t right, uint32_t low, uint32_t high)
{
    w->live = 0;
    for (size_t i = 0; i < w->line_count; i++) {
        w->live += !w->line[i].hidden;
        if (w->line[i].hidden)
            w->x0[i] = INFINITY;
    }
    for (size_t i = w->line_count; i % 4; i++)
        w->x0[i] = INFINITY;
    next_stamp(w);
    for (uint32_t i = left; w->live && i <= right; i++)
        for (uint32_t j = low; j <= high; j++)
            if (!meet_cell(w, solid, NULL, &w->box, i * w->grid->frame.ny + j, w->box.z0))
                return false;
    return true;
}

/* By the way that costs less. */
static bool run_lines(hide_worker *w, uint32_t solid)
{
    const scan_frame *f = &w->grid->frame;
    uint32_t left = scan_column(f, (double)w->box.x0), right = scan_column(f, (double)w->box.x1);
    uint32_t low = scan_row(f, (double)w->box.y0), high = scan_row(f, (double)w->box.y1);
    if (w->line_count <= HIDE_GROUP && right - left < GROUP_CELLS && high - low < GROUP_CELLS)
        return run_together(w, solid, left, right, low, high);
    for (size_t i = 0; i < w->line_count; i++)
        if (!run_alone(w, solid, &w->line[i]))
            return false;
    return true;
}

bool hide_worker_run(hide_worker *w, uint32_t solid)
{
    /* Nothing else could hide them; and a fan of a million triangles lists all of them in the cell of its tip. */
    bool alone = w->picture->scene->solid_count == 1;
    if (w->line_count > 0 && !alone && !run_lines(w, solid))
        return false;
    for (hide_line *line = w->line, *end = line + w->line_count; line < end; line++) {
        for (size_t k = 0; k < line->hulls.count; k++)
            if (!hide_parts_add(&line->parts, line->hulls.item[k].solid, &line->hulls.item[k].part))
                return false;
        if (line->parts.count)
            hide_parts_unite(&line->parts, w->picture->space.epsilon, line->e.length3);
    }
    return true;
}

/* Is (x, y) inside F's picture or on its border? */
static bool holds(const hide_picture *picture, const hide_face *F, double x, double y)
{
    double m = picture->space.epsilon;
    for (uint32_t i = 0; i < F->count; i++) {
        roberts_vec3 P = picture->P[F->corner[i]], Q = picture->P[F->corner[i + 1 < F->count ? i + 1 : 0]];
        double dx = Q.x - P.x, dy = Q.y - P.y;
        if (dx * (y - P.y) - dy * (x - P.x) < -m * sqrt(dx * dx + dy * dy))
            return false;
    }
    return true;
}

static bool box_holds(const hide_picture *picture, const hide_box *box, double x, double y)
{
    double m = picture->space.epsilon;
    return x >= (double)box->x0 - m && x <= (double)box->x1 + m && y >= (double)box->y0 - m && y <= (double)box->y1 + m;
}

uint32_t hide_seen_at(const hide_worker *w, double x, double y)
{
    const objet *grid = w->grid;
    const hide_picture *picture = w->picture;
    uint32_t cell = scan_column(&grid->frame, x) * grid->frame.ny + scan_row(&grid->frame, y), solid = ROBERTS_NONE;
    double best = -INFINITY;
    for (int touching = 0; touching < 2; touching++) /* first the nearest depth, then who is there */
        for (uint32_t k = grid->start[cell]; k < grid->start[cell + 1]; k++) {
            const hide_front *front = &picture->front[grid->front[k]];
            const hide_box *box = &picture->front_box[grid->front[k]];
            if (!touching && (double)box->z1 < best)
                break;
            if (!box_holds(picture, box, x, y) || (touching && front->solid >= solid))
                continue;
            for (uint32_t i = front->face; i < front->face + front->face_count; i++) {
                const hide_face *F = &picture->face[i];
                if (touching && !(fabs(plane_at(F->F, (roberts_vec3){x, y, best})) <= 2.0 * F->touch))
                    continue;
                if (!holds(picture, F, x, y))
                    continue;
                if (touching)
                    solid = front->solid;
                else
                    best = greater(best, lesser((double)box->z1, (F->F.a * x + F->F.b * y + F->F.d) / -F->F.c));
            }
        }
    return solid;
}
