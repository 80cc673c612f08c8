/* bare_faces.c - see bare_faces.h. */
#include "hide/bare_faces.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/threads.h"
#include "hide/tolerance.h"

enum { FACES_AT_ONCE = 4096, FACES_PER_THREAD = 16384 };

typedef struct bare_work {
    const hide_fronts *fronts;
    const objet *grid;
    double apart, slack; /* slack: what is this much deeper than a face does not touch it */
    uint8_t *sight;      /* [face_count] seen_sight */
    atomic_uchar *rough; /* [vertex_count] 1: of the faces with a corner there, one is not plain */
} bare_work;

/* Is the picture of a triangle farther from a cell than `apart`? A side is between them then. */
static bool misses_cell(const bare_work *w, const uint32_t corner[3], uint32_t i, uint32_t j)
{
    const scan_frame *frame = &w->grid->frame;
    const double m = w->apart + frame->margin;
    const box3 cell = {{scan_left(frame, i) - m, scan_lower(frame, j) - m, 0.0},
                       {scan_left(frame, i + 1.0) + m, scan_lower(frame, j + 1.0) + m, 0.0}};
    for (uint32_t k = 0; k < 3; k++) {
        const roberts_vec3 P = w->fronts->P[corner[k]], Q = w->fronts->P[corner[k < 2 ? k + 1 : 0]];
        const double dx = Q.x - P.x, dy = Q.y - P.y; /* the inner side is on the left */
        const double x = (dy < 0.0 ? cell.hi.x : cell.lo.x) - P.x, y = (dx > 0.0 ? cell.hi.y : cell.lo.y) - P.y;
        if (dx * y - dy * x < 0.0)
            return true;
    }
    return false;
}

/* Does a triangle lie in the sheets of all cells that it touches, or is near? Everything else there is deeper, and does
 * not touch it: see layers.h. */
static bool is_in_sheets(const bare_work *w, const hide_box *box, const uint32_t corner[3])
{
    const scan_frame *frame = &w->grid->frame;
    const double deepest = (double)box->z0 - w->slack;
    const objet_range in = objet_range_of(frame, box, w->apart + frame->margin);
    for (uint32_t i = in.left; i <= in.right; i++)
        for (uint32_t j = in.low; j <= in.high; j++)
            if (!(deepest > (double)w->grid->below[scan_number(frame, i, j)]) && !misses_cell(w, corner, i, j))
                return false;
    return true;
}

/* Is the picture of a triangle wider than `apart` in all directions? */
static bool is_wide(const bare_work *w, const uint32_t corner[3])
{
    const roberts_vec3 *P = w->fronts->P, A = P[corner[0]], B = P[corner[1]], C = P[corner[2]];
    const double x = B.x - A.x, y = B.y - A.y, u = C.x - A.x, v = C.y - A.y, twice = x * v - y * u;
    const double p = x * x + y * y, q = u * u + v * v, r = (u - x) * (u - x) + (v - y) * (v - y);
    return twice * twice > w->apart * w->apart * greater(p, greater(q, r));
}

/* Marks faces that are no fronts since sheets hide them in all cells. */
static bool mark_hidden(void *context, size_t first, size_t end)
{
    const bare_work *w = context;
    const roberts_scene *scene = w->fronts->scene;
    const unsigned char *facing = w->fronts->seen->facing;
    for (uint32_t face = (uint32_t)first, body = scene_body_of_face(scene, face); face < end; body++) {
        const uint32_t last = scene->solid[body + 1].face < end ? scene->solid[body + 1].face : (uint32_t)end;
        const unsigned char late = hide_late_facing(w->fronts, body);
        for (; face < last; face++)
            w->sight[face] = late != VIEW_UNKNOWN && facing[face] == late ? SEEN_NOWHERE : SEEN_SOMEWHERE;
    }
    return true;
}

static void mark_corners(const bare_work *w, uint32_t face)
{
    const roberts_scene *scene = w->fronts->scene;
    for (uint32_t k = scene->face_start[face]; k < scene->face_start[face + 1]; k++)
        atomic_store_explicit(&w->rough[scene->corner[k]], 1, memory_order_relaxed);
}

/* Marks the corners of faces with a side that others divide: it is several edges. */
static void mark_divided(const bare_work *w)
{
    const roberts_scene *scene = w->fronts->scene;
    for (uint32_t k = 0; k < scene->surface->part_count; k++) {
        const uint32_t e = scene->surface->part[k].edge, body = scene_body_of_edge(scene, e);
        const scene_edge *edge = scene_edge_stored(scene, body, e);
        for (int i = 0; i < 2; i++)
            if (edge->f[i] != ROBERTS_NONE)
                mark_corners(w, scene->solid[body].face + edge->f[i]);
    }
}

/* Is it a triangle, and no piece of a larger face? */
static bool is_triangle(const roberts_scene *scene, uint32_t face)
{
    const uint32_t *number = scene->face_number;
    return scene->face_start[face + 1] - scene->face_start[face] == 3 &&
           !(number && face > 0 && number[face - 1] == number[face]) &&
           !(number && face + 1 < scene->face_count && number[face + 1] == number[face]);
}

/* Marks the corners of fronts that are narrow, or no whole triangles, and takes back what mark_hidden() has said of
 * faces that have become fronts. */
static bool mark_rough(void *context, size_t first, size_t end)
{
    const bare_work *w = context;
    const roberts_scene *scene = w->fronts->scene;
    for (size_t k = first; k < end; k++) {
        const hide_front *front = &w->fronts->front[k];
        if (front->kind != HIDE_SURFACE_FACE)
            continue;
        w->sight[front->piece] = SEEN_SOMEWHERE;
        if (!is_triangle(scene, front->piece) || !is_wide(w, scene->corner + scene->face_start[front->piece]))
            mark_corners(w, front->piece);
    }
    return true;
}

static bool mark_bare(void *context, size_t first, size_t end)
{
    const bare_work *w = context;
    uint32_t turned[SEEN_TURNED] = {0}, count;
    for (size_t k = first; k < end; k++) {
        const hide_front *front = &w->fronts->front[k];
        if (front->kind != HIDE_SURFACE_FACE || !front->listed)
            continue;
        bool bare = true;
        const uint32_t *corner = seen_corners(w->fronts->seen, front->piece, &count, turned);
        for (uint32_t i = 0; i < count && bare; i++)
            bare = !atomic_load_explicit(&w->rough[corner[i]], memory_order_relaxed);
        if (bare && is_in_sheets(w, &w->fronts->front_box[k], corner))
            w->sight[front->piece] = SEEN_WHOLE;
    }
    return true;
}

bool bare_faces_find(const hide_fronts *fronts, const objet *grid, double apart, uint32_t threads, uint8_t **sight)
{
    const roberts_scene *scene = fronts->scene;
    *sight = NULL;
    if (!grid->below || fronts->seen->rules.hidden || scene != fronts->seen->source)
        return true;
    bare_work w = {.fronts = fronts, .grid = grid, .apart = apart, .slack = SHEET_SLACK * fronts->space.epsilon};
    w.sight = alloc_array(scene->face_count, sizeof *w.sight);
    w.rough = alloc_zeroed(scene->vertex_count, sizeof *w.rough);
    const int count = threads_for(threads, 1 + scene->face_count / FACES_PER_THREAD);
    bool enough = w.sight && w.rough;
    if (enough)
        mark_divided(&w);
    enough = enough && threads_each(count, scene->face_count, FACES_AT_ONCE, mark_hidden, &w) &&
             threads_each(count, fronts->front_count, FACES_AT_ONCE, mark_rough, &w) &&
             threads_each(count, fronts->front_count, FACES_AT_ONCE, mark_bare, &w);
    free(w.rough);
    if (enough)
        *sight = w.sight;
    else
        free(w.sight);
    return enough;
}
