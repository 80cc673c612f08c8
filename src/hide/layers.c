/* layers.c - see layers.h. */
#include "hide/layers.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/threads.h"
#include "hide/front.h"

/* Edges and faces that a thread takes at a time. With fewer edges than WORTH_A_THREAD for each, another thread does not
 * pay. */
#define EDGES_AT_ONCE 4096
#define WORTH_A_THREAD 8192
/* Where in a cell its sheets are counted, as fractions of its size. Regular meshes have no edges there. */
#define ACROSS_CELL 0.43709
#define UP_CELL 0.56173

/* Returns a number that ascends as z does, and is greater than 0. */
static uint32_t rank_of(float z)
{
    uint32_t bits;
    memcpy(&bits, &z, sizeof bits);
    return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
}

static float of_rank(uint32_t rank)
{
    uint32_t bits = rank & 0x80000000u ? rank & 0x7fffffffu : ~rank;
    float z;
    memcpy(&z, &bits, sizeof z);
    return rank == 0 ? -INFINITY : z;
}

/* Records a fold in the cell that is nowhere nearer than z: sheets must be nearer. */
static void fold_cell(const layers *l, uint32_t column, uint32_t row, float z)
{
    atomic_uint *fold = &l->fold[scan_number(&l->grid->frame, column, row)];
    unsigned rank = rank_of(z), known = atomic_load_explicit(fold, memory_order_relaxed);
    while (known < rank && !atomic_compare_exchange_weak(fold, &known, rank)) {
    }
}

/* Records a fold in all cells of a box. */
static void fold_box(const layers *l, const hide_box *box, double loose)
{
    objet_range in = objet_range_of(&l->grid->frame, box, l->grid->frame.margin + loose);
    for (uint32_t i = in.left; i <= in.right; i++)
        for (uint32_t j = in.low; j <= in.high; j++)
            fold_cell(l, i, j, box->z1);
}

static bool fold_edge(const layers *l, objet_walk *walk, uint32_t v, uint32_t w)
{
    const roberts_vec3 A = l->fronts->P[v], B = l->fronts->P[w];
    if (l->grid->star) {
        atomic_store_explicit(&l->grid->star[v], STAR_FOLD, memory_order_relaxed);
        atomic_store_explicit(&l->grid->star[w], STAR_FOLD, memory_order_relaxed);
    }
    if (!objet_cells(l->grid, A, B, walk))
        return false;
    for (size_t k = 0; k < walk->count; k++) {
        const objet_stretch *in = &walk->item[k];
        double z0 = A.z + in->t0 * (B.z - A.z), z1 = A.z + in->t1 * (B.z - A.z);
        fold_cell(l, in->column, in->row, hide_float_above(greater(z0, z1) + l->grid->frame.margin));
    }
    return true;
}

/* Records the folds among the edges first..end-1 of bodies that are not convex. False: no memory. */
static bool fold_edges(const layers *l, objet_walk *walk, uint32_t first, uint32_t end)
{
    const roberts_scene *scene = l->fronts->scene;
    for (uint32_t body = scene_body_of_edge(scene, first), e = first; e < end; body++) {
        const scene_solid *own = &scene->solid[body];
        uint32_t last = own[1].edge < end ? own[1].edge : end;
        const unsigned char *facing = l->fronts->seen->facing + own->face;
        const scene_edge *edge = scene->edge + own->stored + (e - own->edge);
        bool out = scene_is_convex(scene, body) || l->fronts->culled[body];
        for (; e < last; e++, edge++)
            if (!out && !seen_joins_faces(facing, edge, scene->surface->edge_is[e]) &&
                !fold_edge(l, walk, own->vertex + edge->v[0], own->vertex + edge->v[1]))
                return false;
    }
    return true;
}

/* Records those fronts that are not triangles of a surface, or that covers hide, as folds. */
static bool fold_fronts(void *context, size_t first, size_t end)
{
    const layers *l = context;
    const hide_fronts *fronts = l->fronts;
    const uint32_t *start = fronts->scene->face_start;
    for (uint32_t k = (uint32_t)first; k < end; k++) {
        const hide_front *front = &fronts->front[k];
        bool sheet = front->kind == HIDE_SURFACE_FACE && start[front->piece + 1] - start[front->piece] == 3;
        if (front->kind == HIDE_SURFACE_FACE ? !sheet || !front->listed : front->listed)
            fold_box(l, &fronts->front_box[k], hide_loose(fronts, k));
    }
    return true;
}

static bool fold_some(void *context, size_t first, size_t end)
{
    const layers *l = context;
    return fold_edges(l, &l->walk[thread_self()], (uint32_t)first, (uint32_t)end);
}

/* Records the borders of a face that the near plane has made: no edges, but sides between new vertices. */
static bool fold_cuts_of(const layers *l, objet_walk *walk, size_t face)
{
    const roberts_scene *scene = l->fronts->scene;
    const uint32_t *corner = scene->corner + scene->face_start[face],
                   *last = scene->corner + scene->face_start[face + 1];
    for (uint32_t from = last[-1]; corner < last; from = *corner++)
        if (scene_vertex_number(scene, from) == ROBERTS_NONE && scene_vertex_number(scene, *corner) == ROBERTS_NONE &&
            !fold_edge(l, walk, from, *corner))
            return false;
    return true;
}

/* The same for the bodies first..end-1. Convex and culled bodies have no sheets. False: no memory. */
static bool fold_cuts(void *context, size_t first, size_t end)
{
    const layers *l = context;
    const roberts_scene *scene = l->fronts->scene;
    for (size_t body = first; body < end; body++) {
        if (scene_is_convex(scene, (uint32_t)body) || l->fronts->culled[body])
            continue;
        for (size_t face = scene->solid[body].face; face < scene->solid[body + 1].face; face++)
            if (!fold_cuts_of(l, &l->walk[thread_self()], face))
                return false;
    }
    return true;
}

static bool fold_all(const layers *l)
{
    const roberts_scene *scene = l->fronts->scene;
    return threads_each(l->threads, scene->edge_count, EDGES_AT_ONCE, fold_some, (void *)l) &&
           (!l->fronts->seen->clip.clipped || threads_each(l->threads, scene->solid_count, 0, fold_cuts, (void *)l));
}

/* Is the point (x, y) inside the triangle (1) or outside (0)? -1: it is too near to a side to decide, or this is no
 * triangle. */
static int triangle_holds(const hide_fronts *fronts, uint32_t front, double x, double y)
{
    uint32_t turned[SEEN_TURNED];
    const hide_face outline = hide_outline(fronts, front, turned), *F = &outline;
    if (F->count != 3)
        return -1;
    for (uint32_t i = 0; i < 3; i++) {
        roberts_vec3 P = fronts->P[F->corner[i]], Q = fronts->P[F->corner[i < 2 ? i + 1 : 0]];
        double left = (Q.x - P.x) * (y - P.y) - (Q.y - P.y) * (x - P.x);
        if (left < -fronts->space.plain)
            return 0;
        if (!(left > fronts->space.plain))
            return -1;
    }
    return 1;
}

/* A part of a cell's faces: see layers.h. */
typedef struct cell_part {
    float depth; /* of its farthest corner */
    uint32_t sheets;
} cell_part;

/* Records the nearest sheet of a cell: everything deeper than `depth` lies behind it, and every line nearer than
 * `below` lies in it. */
static void set_sheet(objet *grid, size_t cell, double depth, float below)
{
    grid->sheet.depth[cell] = hide_float_below(depth);
    grid->below[cell] = below;
}

/* Goes through the parts of the cell, nearest first, until one is no sheet. Unless hidden lines are wanted, the first
 * sheet is enough. */
void layers_find(const layers *l, uint32_t column, uint32_t row)
{
    objet *grid = l->grid;
    const hide_fronts *fronts = l->fronts;
    const scan_frame *s = &grid->frame;
    size_t cell = scan_number(s, column, row);
    if (!l->fold)
        return;
    float fold = of_rank(atomic_load_explicit(&l->fold[cell], memory_order_relaxed));
    set_sheet(grid, cell, -INFINITY, INFINITY);
    grid->apart[cell] = 0;
    double x = scan_left(s, column + ACROSS_CELL), y = scan_lower(s, row + UP_CELL);
    box3 point = {{x, y, 0.0}, {x, y, 0.0}};
    hide_box about = hide_box_around(&point);
    uint32_t most = objet_most(objet_cut(objet_place(grid, &about), column, row));
    double slack = SHEET_SLACK * fronts->space.epsilon;
    cell_part at = {INFINITY, 0};
    bool found = false, all = fronts->seen->rules.hidden;
    for (uint32_t k = grid->start[cell], end = grid->start[cell + 1]; k < end && (all || !found); k += 4) {
        unsigned near = objet_near(grid, k, end, most);
        for (uint32_t i = k; i < end && i < k + 4; i++, near >>= 1) {
            const hide_box *box = &fronts->front_box[grid->entry[i].front];
            if (box->z1 < at.depth) { /* a part ends */
                if (at.sheets > 0 && !found) {
                    found = true;
                    set_sheet(grid, cell, (double)at.depth - slack, box->z1 > fold ? box->z1 : fold);
                    if (!all)
                        break;
                }
                at = (cell_part){box->z0, 0};
            }
            at.depth = box->z0 < at.depth ? box->z0 : at.depth;
            if (!(at.depth > fold))
                return;
            int held = near & 1 ? triangle_holds(fronts, grid->entry[i].front, x, y) : 0;
            if (held < 0 || (at.sheets += (uint32_t)held) > 1)
                return;
        }
    }
    grid->apart[cell] = 1;
    if (at.sheets > 0 && !found)
        set_sheet(grid, cell, (double)at.depth - slack, fold);
}

/* ---- faces that wait ------------------------------------------------------------------------------------------- */

/* Of a closed mesh, half of the faces lie behind the others. A sheet hides most of these in all cells that they touch,
 * so they hide nothing that it does not hide, and no line in which they cross another face is seen. They never become
 * fronts. */

/* Is the box, that of a face of the body, hidden neither by the body's own covers nor everywhere by sheets? Where it is
 * hidden, its depth becomes that of a fold: lines are not in the sheet if they are as deep. */
static bool is_before_sheets(const layers *l, uint32_t body, const hide_box *box)
{
    const scan_frame *s = &l->grid->frame;
    const cover *own = hide_own_cover(l->fronts, body);
    const bool covered = own && cover_hides(own, box);
    objet_range in = objet_range_of(s, box, s->margin);
    bool before = false;
    for (uint32_t i = in.left; i <= in.right; i++)
        for (uint32_t j = in.low; j <= in.high; j++)
            if (covered || box->z1 < l->grid->sheet.depth[scan_number(s, i, j)])
                fold_cell(l, i, j, box->z1);
            else
                before = true;
    return before;
}

/* Lists those of the faces first..end-1 that wait and are not hidden. Those surely at the rear of their body are never
 * needed. False: no memory. */
static bool list_late(const layers *l, late_faces *to, uint32_t first, uint32_t end)
{
    const roberts_scene *scene = l->fronts->scene;
    const unsigned char *facing = l->fronts->seen->facing;
    for (uint32_t face = first, body = scene_body_of_face(scene, first); face < end; body++) {
        uint32_t last = scene->solid[body + 1].face < end ? scene->solid[body + 1].face : end;
        unsigned char late = hide_late_facing(l->fronts, body);
        bool needed = late != VIEW_UNKNOWN && hide_rear_facing(l->fronts, body) == VIEW_UNKNOWN;
        for (; face < last; face++) {
            if (!needed || facing[face] != late)
                continue;
            hide_box box = front_box_of_face(l->fronts, face);
            if (!is_before_sheets(l, body, &box))
                continue;
            if (!array_reserve(&to->item, &to->room, to->count + 1, sizeof *to->item))
                return false;
            to->item[to->count++] = (hide_front){.solid = body, .piece = face};
        }
    }
    return true;
}

static bool list_some_late(void *context, size_t first, size_t end)
{
    const layers *l = context;
    return list_late(l, &l->late[thread_self()], (uint32_t)first, (uint32_t)end);
}

/* Each thread takes faces that follow one another, so that the order does not depend on the threads. */
bool layers_add_late(layers *l, hide_fronts *fronts)
{
    if (!(l->late = alloc_zeroed((size_t)l->threads, sizeof *l->late)))
        return false;
    bool lost = !threads_each(l->threads, fronts->scene->face_count, 0, list_some_late, l);
    for (int i = 0; i < l->threads && !lost; i++)
        for (size_t k = 0; k < l->late[i].count; k++)
            front_set_face(fronts, fronts->front_count++, l->late[i].item[k].solid, l->late[i].item[k].piece);
    return !lost;
}

/* A sheet that was found before is still one. */
void layers_find_again(const layers *l, uint32_t column, uint32_t row)
{
    float *depth = &l->grid->sheet.depth[scan_number(&l->grid->frame, column, row)], before = *depth;
    layers_find(l, column, row);
    *depth = before > *depth ? before : *depth;
}

void layers_end_late(const layers *l)
{
    for (size_t c = 0, cells = scan_cells(&l->grid->frame); c < cells; c++) {
        float fold = of_rank(atomic_load_explicit(&l->fold[c], memory_order_relaxed));
        l->grid->below[c] = fold > l->grid->below[c] ? fold : l->grid->below[c];
    }
}

/* ---- all of it ------------------------------------------------------------------------------------------------- */

/* If each body is one face, a sheet is one face as well: then covers find what it hides, and no sheets are sought. */
bool layers_begin(layers *l, objet *grid, const hide_fronts *fronts, uint32_t threads)
{
    const roberts_scene *scene = fronts->scene;
    size_t cells = scan_cells(&grid->frame);
    *l = (layers){.grid = grid, .fronts = fronts};
    if (!scene || !scene->surface || (scene->solid_count == scene->face_count && fronts->cover.depth))
        return true;
    l->threads = threads_for(threads, 1 + scene->edge_count / WORTH_A_THREAD);
    l->fold = alloc_zeroed(cells, sizeof *l->fold);
    l->walk = alloc_zeroed((size_t)l->threads, sizeof *l->walk);
    grid->apart = alloc_zeroed(cells, sizeof *grid->apart);
    grid->below = alloc_array(cells, sizeof *grid->below);
    grid->sheet.frame = grid->frame;
    grid->sheet.depth = alloc_array(cells, sizeof *grid->sheet.depth);
    bool stars = !fronts->seen->rules.hidden && seen_has_plain_edges(fronts->seen);
    grid->star = stars ? alloc_zeroed(scene->vertex_count, sizeof *grid->star) : NULL;
    if (!l->fold || !l->walk || (stars && !grid->star) || !grid->apart || !grid->below || !grid->sheet.depth ||
        !fold_all(l))
        return false;
    threads_each(l->threads, fronts->front_count, 0, fold_fronts, l);
    return true;
}

void layers_end(layers *l)
{
    for (int i = 0; l->walk && i < l->threads; i++)
        free(l->walk[i].item);
    for (int i = 0; l->late && i < l->threads; i++)
        free(l->late[i].item);
    free(l->late);
    free(l->walk);
    free(l->fold);
    *l = (layers){0};
}
