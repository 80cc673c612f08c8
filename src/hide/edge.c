/* edge.c - see edge.h.
 *
 * The edges of a small solid go through the cells together: each front in them is met once, by all edges. The edges of a
 * solid that spans many cells go one by one, each through the cells that its own picture crosses. */
#include "hide/edge.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"

/* A solid of more columns or rows than this, or more edges, is taken edge by edge. */
#define GROUP_CELLS 3
#define GROUP_EDGES 64

bool hide_worker_init(hide_worker *w, const hide_picture *picture, const objet *grid)
{
    *w = (hide_worker){.picture = picture, .grid = grid};
    w->seen = alloc_zeroed(picture->front_count, sizeof *w->seen);
    return w->seen && hide_sides_reserve(&w->sides, picture->most_corners);
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

static hide_box box_of(roberts_vec3 A, roberts_vec3 B, double margin)
{
    return (hide_box){hide_float_below(lesser(A.x, B.x) - margin), hide_float_above(greater(A.x, B.x) + margin),
                      hide_float_below(lesser(A.y, B.y) - margin), hide_float_above(greater(A.y, B.y) + margin),
                      hide_float_below(lesser(A.z, B.z) - margin), hide_float_above(greater(A.z, B.z) + margin)};
}

hide_line *hide_worker_add(hide_worker *w, uint32_t edge)
{
    const hide_picture *picture = w->picture;
    const scene_edge *from = &picture->scene->edge[edge];
    size_t room = w->line_room;
    if (!array_reserve(&w->line, &w->line_room, w->line_count + 1, sizeof *w->line))
        return NULL;
    memset(w->line + room, 0, (w->line_room - room) * sizeof *w->line);
    hide_line *line = &w->line[w->line_count++];
    hide_edge e = {.A = picture->P[from->v[0]], .B = picture->P[from->v[1]], .a = from->v[0], .b = from->v[1]};
    roberts_vec3 AB = vec3_sub(e.B, e.A);
    e.length = sqrt(AB.x * AB.x + AB.y * AB.y);
    e.length3 = vec3_length(AB);
    line->e = e;
    line->box = box_of(e.A, e.B, hide_margin(&picture->space));
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
static bool meet(hide_worker *w, hide_line *line, const hide_front *front)
{
    hide_part part;
    if (!hide_by_front(w->picture, front, &line->e, &w->sides, &w->tally, &part))
        return true;
    if (front->corners == 0 ? !hide_parts_hull(&line->hulls, front->solid, &part)
                            : !hide_parts_add(&line->parts, front->solid, &part))
        return false;
    if (part.t0 == 0.0 && part.t1 == 1.0) {
        line->hidden = true;
        w->live--;
    }
    return true;
}

/* The lines first..end-1, all within `box` (but for depth, of which `far` is the farthest), against one cell's fronts,
 * as long as one of them is not wholly hidden. */
static bool meet_cell(hide_worker *w, uint32_t solid, size_t first, size_t end, const hide_box *box, uint32_t cell,
                      float far)
{
    const objet *grid = w->grid;
    for (uint32_t k = grid->start[cell], after; w->live && k < grid->start[cell + 1]; k = after) {
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
        for (size_t i = first; i < end; i++)
            if (!w->line[i].hidden && !apart(other, &w->line[i].box) && !meet(w, &w->line[i], front))
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
static bool run_alone(hide_worker *w, uint32_t solid, size_t index)
{
    const hide_edge *e = &w->line[index].e;
    double m = hide_margin(&w->picture->space);
    if (w->line[index].hidden)
        return true;
    w->live = 1;
    next_stamp(w);
    if (!objet_cells(w->grid, e->A, e->B, &w->walk))
        return false;
    for (size_t i = 0; w->live && i < w->walk.count; i++) {
        objet_stretch s = w->walk.item[i];
        float far = hide_float_below(lesser(hide_edge_at(e, s.t0).z, hide_edge_at(e, s.t1).z) - m);
        if (!meet_cell(w, solid, index, index + 1, &w->line[index].box, s.cell, far))
            return false;
    }
    return true;
}

/* All edges through the cells of their common box. */
static bool run_together(hide_worker *w, uint32_t solid, const hide_box *box)
{
    const scan_frame *f = &w->grid->frame;
    uint32_t last = scan_column(f, (double)box->x1), low = scan_row(f, (double)box->y0);
    uint32_t high = scan_row(f, (double)box->y1);
    w->live = 0;
    for (size_t i = 0; i < w->line_count; i++)
        w->live += !w->line[i].hidden;
    next_stamp(w);
    for (uint32_t i = scan_column(f, (double)box->x0); w->live && i <= last; i++)
        for (uint32_t j = low; j <= high; j++)
            if (!meet_cell(w, solid, 0, w->line_count, box, i * f->ny + j, box->z0))
                return false;
    return true;
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

bool hide_worker_run(hide_worker *w, uint32_t solid)
{
    const scan_frame *f = &w->grid->frame;
    if (w->line_count == 0)
        return true;
    hide_box box = w->line[0].box;
    for (size_t i = 1; i < w->line_count; i++)
        join_box(&box, &w->line[i].box);
    /* Nothing else could hide them; and a fan of a million triangles lists all of them in the cell of its tip. */
    bool alone = w->picture->scene->solid_count == 1;
    bool small = w->line_count <= GROUP_EDGES &&
                 scan_column(f, (double)box.x1) - scan_column(f, (double)box.x0) < GROUP_CELLS &&
                 scan_row(f, (double)box.y1) - scan_row(f, (double)box.y0) < GROUP_CELLS;
    if (small && !alone && !run_together(w, solid, &box))
        return false;
    for (size_t i = 0; i < w->line_count; i++) {
        if (!small && !alone && !run_alone(w, solid, i))
            return false;
        for (size_t k = 0; k < w->line[i].hulls.count; k++)
            if (!hide_parts_add(&w->line[i].parts, w->line[i].hulls.item[k].solid, &w->line[i].hulls.item[k].part))
                return false;
        hide_parts_unite(&w->line[i].parts, w->picture->space.epsilon, w->line[i].e.length3);
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
