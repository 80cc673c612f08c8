/* layers.c - see layers.h. */
#include "hide/layers.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/bits.h"
#include "base/threads.h"

/* Edges that a thread takes at a time; with fewer than this a thread costs more than it does. */
#define EDGES_AT_ONCE 4096
#define WORTH_A_THREAD 8192
/* Where in a cell its sheets are counted, in parts of it: not where regular meshes have their edges. */
#define ACROSS_CELL 0.43709
#define UP_CELL 0.56173
/* Touching distances: what lies this much deeper than a sheet does not touch it, unless the sheet is so steep that it
 * is nearly a line. */
#define SHEET_SLACK 0x1p20

/* The finding of sheets. */
typedef struct finding {
    const objet *grid;
    const hide_fronts *fronts;
    atomic_uint *fold;    /* [cells] rank_of() of the nearest depth of what is no sheet */
    unsigned char *wound; /* [vertices] how often the faces of a surface go round the vertex in the picture: 0, 1, 2 or
                             more */
    objet_walk *walk;     /* [threads] */
    int threads;
} finding;

/* Floats as numbers that ascend as they do; 0 is below all of them. */
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

/* What is nowhere nearer than z in the cell is no sheet. */
static void fold_cell(const finding *f, uint32_t column, uint32_t row, float z)
{
    atomic_uint *fold = &f->fold[(size_t)column * f->grid->frame.ny + row];
    unsigned rank = rank_of(z), known = atomic_load_explicit(fold, memory_order_relaxed);
    while (known < rank && !atomic_compare_exchange_weak(fold, &known, rank)) {
    }
}

/* All cells of a box. */
static void fold_box(const finding *f, const hide_box *box, double loose)
{
    const scan_frame *s = &f->grid->frame;
    double m = s->margin + loose;
    uint32_t right = scan_column(s, (double)box->x1 + m);
    uint32_t low = scan_row(s, (double)box->y0 - m), high = scan_row(s, (double)box->y1 + m);
    for (uint32_t i = scan_column(s, (double)box->x0 - m); i <= right; i++)
        for (uint32_t j = low; j <= high; j++)
            fold_cell(f, i, j, box->z1);
}

static bool fold_edge(const finding *f, objet_walk *walk, roberts_vec3 A, roberts_vec3 B)
{
    if (!objet_cells(f->grid, A, B, walk))
        return false;
    for (size_t k = 0; k < walk->count; k++) {
        const objet_stretch *in = &walk->item[k];
        double z0 = A.z + in->t0 * (B.z - A.z), z1 = A.z + in->t1 * (B.z - A.z);
        fold_cell(f, in->column, in->row, hide_float_above(greater(z0, z1) + f->grid->frame.margin));
    }
    return true;
}

/* Has the edge one face on its left in the picture and one on its right? */
static inline bool joins_faces(const unsigned char *facing, const scene_edge *edge, uint8_t is)
{
    if (edge->f[1] == ROBERTS_NONE || is & (EDGE_MANY | EDGE_PART))
        return false;
    unsigned f = facing[edge->f[0]], g = facing[edge->f[1]];
    bool turned = ((is & EDGE_TURNED_0) != 0) != ((is & EDGE_TURNED_1) != 0);
    return f != VIEW_EDGE_ON && g != VIEW_EDGE_ON && (f == g) == turned;
}

/* The body of an edge of the scene. */
static uint32_t body_of_edge(const roberts_scene *scene, uint32_t edge)
{
    uint32_t low = 0, high = scene->solid_count;
    while (high - low > 1) {
        uint32_t middle = low + (high - low) / 2;
        if (scene->solid[middle].edge <= edge)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Folds of the edges first..end-1, of bodies that are not convex. False: no memory. */
static bool fold_edges(const finding *f, objet_walk *walk, uint32_t first, uint32_t end)
{
    const roberts_scene *scene = f->fronts->scene;
    const roberts_vec3 *P = f->fronts->P;
    for (uint32_t body = body_of_edge(scene, first), e = first; e < end; body++) {
        const scene_solid *own = &scene->solid[body];
        uint32_t last = own[1].edge < end ? own[1].edge : end;
        const unsigned char *facing = f->fronts->seen->facing + own->face;
        const scene_edge *edge = scene->edge + own->stored + (e - own->edge);
        const roberts_vec3 *V = P + own->vertex;
        bool out = scene_is_convex(scene, body) || f->fronts->culled[body];
        for (; e < last; e++, edge++)
            if (!out && !joins_faces(facing, edge, scene->surface->edge_is[e]) &&
                !fold_edge(f, walk, V[edge->v[0]], V[edge->v[1]]))
                return false;
    }
    return true;
}

/* A triangle goes round that corner of it, if any, from which it extends on both sides of the direction +x. */
static void wind(const finding *f, const uint32_t *corner)
{
    const roberts_vec3 *P = f->fronts->P;
    double y[3] = {P[corner[0]].y, P[corner[1]].y, P[corner[2]].y};
    for (int i = 0; i < 3; i++) {
        if (!(y[i < 2 ? i + 1 : 0] < y[i] && y[i] <= y[i > 0 ? i - 1 : 2]))
            continue;
        unsigned char *at = &f->wound[corner[i]];
        if (f->threads == 1) {
            *at = (unsigned char)(*at + (*at < 2));
        } else {
            unsigned char before;
#ifdef _OPENMP
#pragma omp atomic capture
#endif
            {
                before = *at;
                *at |= 1;
            }
            if (before)
#ifdef _OPENMP
#pragma omp atomic write
#endif
                *at = 3;
        }
        return;
    }
}

/* Winds all triangles of surfaces. Where anything else is, there are no sheets. */
static void wind_fronts(const finding *f)
{
    const hide_fronts *fronts = f->fronts;
#ifdef _OPENMP
#pragma omp parallel for schedule(static) num_threads(f->threads)
#endif
    for (uint32_t k = 0; k < fronts->front_count; k++) {
        const hide_front *front = &fronts->front[k];
        const hide_face *face = &fronts->face[front->face];
        if (front->kind == HIDE_SURFACE_FACE && face->count == 3)
            wind(f, face->corner);
        else if (front->listed)
            fold_box(f, &fronts->front_box[k], (double)front->loose);
    }
}

static void fold_wound(const finding *f)
{
    const hide_fronts *fronts = f->fronts;
    uint32_t count = fronts->scene->vertex_count;
#ifdef _OPENMP
#pragma omp parallel for schedule(static) num_threads(f->threads)
#endif
    for (uint32_t v = 0; v < count; v++)
        if (f->wound[v] > 1) {
            hide_box box = hide_box_around(&(hide_bounds){fronts->P[v], fronts->P[v]});
            fold_box(f, &box, 0.0);
        }
}

static bool fold_all(const finding *f)
{
    uint32_t count = f->fronts->scene->edge_count, parts = count / EDGES_AT_ONCE + 1;
    bool lost = false;
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic, 1) num_threads(f->threads) reduction(|| : lost)
#endif
    for (uint32_t p = 0; p < parts; p++) {
        uint32_t first = p * EDGES_AT_ONCE, left = count - first;
        lost = lost ||
               !fold_edges(f, &f->walk[thread_self()], first, first + (left < EDGES_AT_ONCE ? left : EDGES_AT_ONCE));
    }
    return !lost;
}

/* Is the point in the triangle: 1, or outside: 0? -1: too near to a side. */
static int holds(const hide_fronts *fronts, const hide_face *F, double x, double y)
{
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

/* Faces of a cell that no gap in depth parts. */
typedef struct part {
    float depth; /* of the farthest corner */
    uint32_t sheets;
} part;

/* The sheets of a cell, nearest first, as far as nothing else lies that near. */
static void find_in_cell(objet *grid, const hide_fronts *fronts, uint32_t column, uint32_t row, float fold)
{
    const scan_frame *s = &grid->frame;
    size_t cell = (size_t)column * s->ny + row;
    double x = s->x0 + (column + ACROSS_CELL) * s->dx, y = s->y0 + (row + UP_CELL) * s->dy;
    hide_bounds point = {{x, y, 0.0}, {x, y, 0.0}};
    hide_box about = hide_box_around(&point);
    uint32_t most = objet_most(objet_cut(objet_place(grid, &about), column, row));
    part at = {INFINITY, 0};
    bool found = false;
    for (uint32_t k = grid->start[cell], end = grid->start[cell + 1]; k < end; k += 4) {
        unsigned near = objet_near(grid, k, end, most);
        for (uint32_t i = k; i < end && i < k + 4; i++, near >>= 1) {
            const hide_front *front = &fronts->front[grid->entry[i].front];
            const hide_box *box = &fronts->front_box[grid->entry[i].front];
            if (box->z1 < at.depth) { /* a part ends */
                if (at.sheets > 0 && !found) {
                    found = true;
                    grid->sheet.depth[cell] = hide_float_below((double)at.depth - SHEET_SLACK * fronts->space.epsilon);
                    grid->below[cell] = box->z1 > fold ? box->z1 : fold;
                }
                at = (part){box->z0, 0};
            }
            at.depth = box->z0 < at.depth ? box->z0 : at.depth;
            if (!(at.depth > fold))
                return;
            int held = near & 1 ? holds(fronts, &fronts->face[front->face], x, y) : 0;
            if (held < 0 || (at.sheets += (uint32_t)held) > 1)
                return;
        }
    }
    grid->apart[cell] = 1;
    if (at.sheets > 0 && !found) {
        grid->sheet.depth[cell] = hide_float_below((double)at.depth - SHEET_SLACK * fronts->space.epsilon);
        grid->below[cell] = fold;
    }
}

static void find_in_cells(objet *grid, const finding *f)
{
    size_t cells = scan_cells(&grid->frame);
    for (size_t c = 0; c < cells; c++) {
        grid->sheet.depth[c] = -INFINITY;
        grid->below[c] = INFINITY;
    }
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic, 16) num_threads(f->threads)
#endif
    for (uint32_t i = 0; i < grid->frame.nx; i++)
        for (uint32_t j = 0; j < grid->frame.ny; j++)
            find_in_cell(grid, f->fronts, i, j, of_rank(atomic_load(&f->fold[(size_t)i * grid->frame.ny + j])));
}

bool layers_find(objet *grid, const hide_fronts *fronts, uint32_t threads)
{
    const roberts_scene *scene = fronts->scene;
    size_t cells = scan_cells(&grid->frame);
    if (!scene->surface || fronts->seen->clip.clipped)
        return true; /* a border that the near plane has made is no edge */
    finding f = {
        .grid = grid, .fronts = fronts, .threads = threads_for(threads, 1 + scene->edge_count / WORTH_A_THREAD)};
    f.fold = alloc_zeroed(cells, sizeof *f.fold);
    f.wound = alloc_zeroed(scene->vertex_count, sizeof *f.wound);
    f.walk = alloc_zeroed((size_t)f.threads, sizeof *f.walk);
    grid->apart = alloc_zeroed(cells, sizeof *grid->apart);
    grid->below = alloc_array(cells, sizeof *grid->below);
    bool found = f.fold && f.wound && f.walk && grid->apart && grid->below;
    if (found) {
        grid->sheet.frame = grid->frame;
        grid->sheet.depth = alloc_array(cells, sizeof *grid->sheet.depth);
        found = grid->sheet.depth && fold_all(&f);
    }
    if (found) {
        wind_fronts(&f);
        fold_wound(&f);
        find_in_cells(grid, &f);
    }
    for (int i = 0; f.walk && i < f.threads; i++)
        free(f.walk[i].item);
    free(f.walk);
    free(f.wound);
    free(f.fold);
    return found;
}
