/* sheets.c - see sheets.h. */
#include "hide/sheets.h"

#include <stdlib.h>

#include "base/array.h"

/* Roundings of a picture coordinate: a point no farther from a side than this may lie on either side of it. */
#define SIDE_ROUNDINGS 8.0

/* Sums of these are alike only if their vertices are. */
static uint64_t mixed(uint32_t vertex)
{
    uint64_t h = (vertex + (uint64_t)1) * 0x9e3779b97f4a7c15u;
    h = (h ^ h >> 29) * 0xbf58476d1ce4e5b9u;
    return h ^ h >> 32;
}

/* Counts a face at its corners, which run counter-clockwise. At V the face lies between the ways to the next corner and
 * to the one before. */
static void count_face(sheets *s, const hide_fronts *fronts, const hide_front *front)
{
    const hide_face *f = &fronts->face[front->face];
    uint8_t facing = (uint8_t)(1u << fronts->seen->facing[front->piece]);
    uint32_t before = f->corner[f->count - 1];
    uint64_t mixed_before = mixed(before), first = mixed(f->corner[0]), own = first;
    for (uint32_t i = 0; i < f->count; i++) {
        uint32_t v = f->corner[i], next = f->corner[i + 1 < f->count ? i + 1 : 0];
        uint64_t mixed_next = i + 1 < f->count ? mixed(next) : first;
        sheet_vertex *at = &s->vertex[v];
        double y = fronts->P[v].y;
        at->sides += mixed_next - mixed_before;
        at->turns = (uint8_t)(at->turns + (fronts->P[next].y <= y && fronts->P[before].y > y && at->turns < 255));
        at->facing |= facing;
        before = v;
        mixed_before = own;
        own = mixed_next;
    }
}

bool sheets_find(sheets *s, const hide_fronts *fronts)
{
    *s = (sheets){NULL};
    if (!fronts->scene->surface)
        return true;
    s->vertex = alloc_zeroed(fronts->scene->vertex_count, sizeof *s->vertex);
    for (uint32_t k = 0; s->vertex && k < fronts->front_count; k++)
        if (fronts->front[k].kind == HIDE_SURFACE_FACE)
            count_face(s, fronts, &fronts->front[k]);
    return s->vertex != NULL;
}

void sheets_free(sheets *s)
{
    free(s->vertex);
    *s = (sheets){NULL};
}

static bool is_regular(const sheet_vertex *v)
{
    return v->sides == 0 && v->turns == 1 && (v->facing & (v->facing - 1)) == 0;
}

/* The faces of one body that face alike. */
typedef struct group {
    uint32_t body;
    unsigned char facing;
    unsigned layers; /* over the cell's middle */
    float z0, z1;    /* of the whole faces */
} group;

/* How many layers the face is over X: 0 or 1; 2: it may be either. */
static unsigned layers_over(const hide_fronts *fronts, const hide_face *f, roberts_vec2 X)
{
    double loose = SIDE_ROUNDINGS * fronts->space.rounding;
    roberts_vec3 A = fronts->P[f->corner[f->count - 1]];
    bool doubtful = false;
    for (uint32_t i = 0; i < f->count; i++) {
        roberts_vec3 B = fronts->P[f->corner[i]];
        double dx = B.x - A.x, dy = B.y - A.y, off = dx * (X.y - A.y) - dy * (X.x - A.x);
        double most = loose * (fabs(dx) + fabs(dy));
        if (off < -most)
            return 0;
        doubtful = doubtful || off <= most;
        A = B;
    }
    return doubtful ? 2 : 1;
}

/* The group of a face, which is noted there. SHEET_GROUPS: there are too many. */
static unsigned group_of(group *all, unsigned *count, uint32_t body, unsigned char facing)
{
    unsigned g = 0;
    while (g < *count && !(all[g].body == body && all[g].facing == facing))
        g++;
    if (g == *count && g < SHEET_GROUPS)
        all[(*count)++] = (group){body, facing, 0, INFINITY, -INFINITY};
    return g;
}

static bool are_apart(const group *all, unsigned count)
{
    for (unsigned g = 0; g < count; g++)
        for (unsigned h = 0; h < g; h++)
            if (!(all[g].z1 < all[h].z0 || all[h].z1 < all[g].z0))
                return false;
    return true;
}

void sheets_of_cell(const sheets *s, const hide_fronts *fronts, const objet *grid, size_t cell, sheet_cell *out)
{
    const scan_frame *f = &grid->frame;
    const objet_entry *list = grid->entry + grid->start[cell];
    uint32_t entries = grid->start[cell + 1] - grid->start[cell];
    group all[SHEET_GROUPS];
    unsigned count = 0;
    roberts_vec2 X = {f->x0 + ((double)(cell / f->ny) + 0.4807) * f->dx,
                      f->y0 + ((double)(cell % f->ny) + 0.5193) * f->dy};
    out->single = out->apart = false;
    if (!s->vertex || entries > SHEET_FACES)
        return;
    for (uint32_t k = 0; k < entries; k++) {
        const hide_front *front = &fronts->front[list[k].front];
        const hide_box *box = &fronts->front_box[list[k].front];
        if (front->kind != HIDE_SURFACE_FACE)
            return;
        const hide_face *face = &fronts->face[front->face];
        for (uint32_t i = 0; i < face->count; i++)
            if (!is_regular(&s->vertex[face->corner[i]]))
                return;
        unsigned g = group_of(all, &count, front->solid, fronts->seen->facing[front->piece]);
        if (g == SHEET_GROUPS)
            return;
        if ((double)box->x0 <= X.x && X.x <= (double)box->x1 && (double)box->y0 <= X.y && X.y <= (double)box->y1)
            all[g].layers += layers_over(fronts, face, X);
        all[g].z0 = box->z0 < all[g].z0 ? box->z0 : all[g].z0;
        all[g].z1 = box->z1 > all[g].z1 ? box->z1 : all[g].z1;
        out->group[k] = (uint8_t)g;
    }
    for (unsigned g = 0; g < count; g++)
        if (all[g].layers != 1)
            return;
    out->single = true;
    out->apart = are_apart(all, count);
}
