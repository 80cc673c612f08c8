/* edge.c - see edge.h. */
#include "hide/edge.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"

bool hide_worker_init(hide_worker *w, const hide_front *front, const objet *grid, uint32_t solid_count)
{
    *w = (hide_worker){.front = front, .grid = grid};
    w->seen = alloc_zeroed(front->count, sizeof *w->seen);
    w->solid_seen = alloc_zeroed(solid_count, sizeof *w->solid_seen);
    w->solid_slot = alloc_array(solid_count, sizeof *w->solid_slot);
    return w->seen && w->solid_seen && w->solid_slot && hide_sides_reserve(&w->sides, front->most_corners);
}

void hide_worker_free(hide_worker *w)
{
    free(w->sides.H);
    free(w->parts.item);
    free(w->walk.item);
    free(w->seen);
    free(w->solid_seen);
    free(w->solid_slot);
    *w = (hide_worker){0};
}

/* The edge against one face, once; false: no memory. */
static bool meet_face(hide_worker *w, const hide_edge *e, uint32_t face)
{
    const hide_face *F = &w->front->face[face];
    hide_part part;
    if (w->seen[face] == w->stamp)
        return true;
    w->seen[face] = w->stamp;
    if (!hide_by_face(&w->front->space, F, e, &w->sides, &w->tally, &part))
        return true;
    bool known = w->solid_seen[F->solid] == w->stamp;
    size_t slot = known ? w->solid_slot[F->solid] : SIZE_MAX;
    if (!hide_parts_add(&w->parts, F->solid, part, &slot))
        return false;
    w->solid_seen[F->solid] = w->stamp;
    w->solid_slot[F->solid] = (uint32_t)slot;
    return true;
}

/* One cell. A stretch that lies behind the cell's cover everywhere is hidden there at once: what else lists in the cell
 * can hide nothing more of it. The cover itself is asked, so that where its own part ends is found the same way in
 * every grid. */
static bool meet_cell(hide_worker *w, const hide_edge *e, uint32_t solid, const objet_stretch *stretch)
{
    const objet *grid = w->grid;
    double za = hide_edge_at(e, stretch->t0).z, zb = hide_edge_at(e, stretch->t1).z;
    double far = fmin(za, zb) - grid->margin, m = grid->margin;
    double x0 = fmin(e->A.x, e->B.x) - m, x1 = fmax(e->A.x, e->B.x) + m;
    double y0 = fmin(e->A.y, e->B.y) - m, y1 = fmax(e->A.y, e->B.y) + m;
    if (fmax(za, zb) + m < grid->cover_depth[stretch->cell]) {
        w->tally.covered++;
        return meet_face(w, e, grid->cover[stretch->cell]);
    }
    for (uint32_t k = grid->start[stretch->cell]; k < grid->start[stretch->cell + 1]; k++) {
        const hide_face *F = &w->front->face[grid->face[k]];
        if ((double)F->z1 < far)
            break; /* and so are all that follow: none of them has a point nearer than the stretch */
        if (F->solid == solid || (double)F->x1 < x0 || (double)F->x0 > x1 || (double)F->y1 < y0 || (double)F->y0 > y1)
            continue;
        if (!meet_face(w, e, grid->face[k]))
            return false;
    }
    return true;
}

/* Does one solid hide the whole edge? */
static bool wholly_hidden(const hide_worker *w)
{
    for (size_t i = 0; i < w->parts.count; i++)
        if (w->parts.item[i].part.t0 == 0.0 && w->parts.item[i].part.t1 == 1.0)
            return true;
    return false;
}

bool hide_edge_parts(hide_worker *w, const hide_edge *e, uint32_t solid)
{
    w->stamp++;
    w->parts.count = 0;
    if (!objet_cells(w->grid, e->A, e->B, &w->walk))
        return false;
    for (size_t i = 0; i < w->walk.count; i++) {
        size_t before = w->parts.count;
        if (!meet_cell(w, e, solid, &w->walk.item[i]))
            return false;
        if (w->parts.count > before && wholly_hidden(w))
            break;
    }
    hide_parts_unite(&w->parts, w->front->space.epsilon, e->length3);
    return true;
}

/* Is (x, y) inside F's picture or on its border? */
static bool holds(const hide_front *front, const hide_face *F, double x, double y)
{
    double m = front->space.epsilon;
    if (x < (double)F->x0 - m || x > (double)F->x1 + m || y < (double)F->y0 - m || y > (double)F->y1 + m)
        return false;
    for (uint32_t i = 0; i < F->count; i++) {
        roberts_vec3 P = front->P[F->corner[i]], Q = front->P[F->corner[i + 1 < F->count ? i + 1 : 0]];
        double dx = Q.x - P.x, dy = Q.y - P.y;
        if (dx * (y - P.y) - dy * (x - P.x) < -m * hypot(dx, dy))
            return false;
    }
    return true;
}

uint32_t hide_seen_at(const hide_worker *w, double x, double y)
{
    uint32_t cell = objet_cell_at(w->grid, x, y), solid = ROBERTS_NONE;
    double best = -INFINITY;
    for (uint32_t k = w->grid->start[cell]; k < w->grid->start[cell + 1]; k++) {
        const hide_face *F = &w->front->face[w->grid->face[k]];
        if ((double)F->z1 < best)
            break;
        if (holds(w->front, F, x, y))
            best = fmax(best, fmin((double)F->z1, (F->F.a * x + F->F.b * y + F->F.d) / -F->F.c));
    }
    for (uint32_t k = w->grid->start[cell]; k < w->grid->start[cell + 1]; k++) {
        const hide_face *F = &w->front->face[w->grid->face[k]];
        double depth = plane_at(F->F, (roberts_vec3){x, y, best});
        if (F->solid < solid && fabs(depth) <= 2.0 * F->touch && holds(w->front, F, x, y))
            solid = F->solid;
    }
    return solid;
}
