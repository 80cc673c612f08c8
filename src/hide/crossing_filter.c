/* crossing_filter.c - see crossing_filter.h. */
#include "hide/crossing_filter.h"

#include <stdatomic.h>
#include <stdlib.h>

#include "base/array.h"

/* ---- stars ------------------------------------------------------------------------------------------------------- */

/* The star of a vertex is the set of all faces at it. Suppose that each edge there has one face on its left in the
 * picture and one on its right, that the faces go round the vertex once, and that no side of a face runs through it.
 * Then no two of them overlap in the picture: they share only the vertex or a side. */

/* What is known about a star: whether faces go round it once, or more often, or whether it is no sheet. */
enum { ROUND_ONCE = 1, ROUND_TWICE = 2, NO_SHEET = 4 };

typedef struct stars {
    const hide_fronts *fronts;
    atomic_uchar *star; /* [vertices] */
    bool alone;         /* there is one thread */
} stars;

/* Returns what was known before. */
static unsigned char mark(const stars *s, uint32_t vertex, unsigned char what)
{
    atomic_uchar *star = &s->star[vertex];
    if (!s->alone)
        return atomic_fetch_or_explicit(star, what, memory_order_relaxed);
    unsigned char before = atomic_load_explicit(star, memory_order_relaxed);
    atomic_store_explicit(star, (unsigned char)(before | what), memory_order_relaxed);
    return before;
}

/* Marks those ends of an edge that are not corners of both its faces. */
static void mark_divided(const stars *s, const scene_solid *own, const scene_edge *edge)
{
    const roberts_scene *scene = s->fronts->scene;
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2 && edge->f[k] != ROBERTS_NONE; k++) {
            uint32_t f = own->face + edge->f[k], v = own->vertex + edge->v[i], c = scene->face_start[f];
            while (c < scene->face_start[f + 1] && scene->corner[c] != v)
                c++;
            if (c == scene->face_start[f + 1])
                mark(s, v, NO_SHEET);
        }
}

/* If no edge is divided, each side of a face is one side of an edge. Where vertices lie on a side of a face, that side
 * belongs to several edges, and does not end at these vertices. */
static void mark_folds(const stars *s, uint32_t body)
{
    const roberts_scene *scene = s->fronts->scene;
    const scene_solid *own = &scene->solid[body];
    const scene_edge *edge = scene->edge + own->stored;
    const uint8_t *is = scene->surface->edge_is + own->edge;
    uint32_t count = own[1].edge - own->edge, sides = 2 * count;
    bool many = false;
    for (uint32_t e = 0; e < count; e++)
        if (!seen_joins_faces(s->fronts->seen->facing + own->face, &edge[e], is[e])) {
            sides -= (edge[e].f[0] == ROBERTS_NONE) + (edge[e].f[1] == ROBERTS_NONE);
            many = many || is[e] & EDGE_MANY;
            mark(s, own->vertex + edge[e].v[0], NO_SHEET);
            mark(s, own->vertex + edge[e].v[1], NO_SHEET);
        }
    if (many || sides != scene->face_start[own[1].face] - scene->face_start[own->face])
        for (uint32_t e = 0; e < count; e++)
            mark_divided(s, own, &edge[e]);
}

/* A triangle goes round one of its corners if it extends from there on both sides of the direction +x. It has at most
 * one such corner. Its corners run counter-clockwise in the picture, or clockwise if the viewer sees its back. */
static void mark_round(const stars *s, const uint32_t *corner, bool back)
{
    const roberts_vec3 *P = s->fronts->P;
    const uint32_t v[3] = {corner[0], corner[back ? 2 : 1], corner[back ? 1 : 2]};
    const double y[3] = {P[v[0]].y, P[v[1]].y, P[v[2]].y};
    for (int i = 0; i < 3; i++)
        if (y[i < 2 ? i + 1 : 0] < y[i] && y[i] <= y[i > 0 ? i - 1 : 2] && mark(s, v[i], ROUND_ONCE) & ROUND_ONCE)
            mark(s, v[i], ROUND_TWICE);
}

static void mark_front(const stars *s, const hide_front *front)
{
    const roberts_scene *scene = s->fronts->scene;
    if (front->kind != HIDE_SURFACE_FACE)
        return;
    uint32_t first = scene->face_start[front->piece], end = scene->face_start[front->piece + 1];
    if (end - first == 3)
        mark_round(s, scene->corner + first, s->fronts->seen->facing[front->piece] == VIEW_BACK);
    else
        for (uint32_t c = first; c < end; c++)
            mark(s, scene->corner[c], NO_SHEET);
}

/* Finds such vertices of triangles of surfaces. *sheet, [vertices]: 1 for such a vertex, else 0; NULL: none is known.
 * False: no memory. A border made by the near plane is no edge. */
static bool stars_find(const hide_fronts *fronts, int threads, unsigned char **sheet)
{
    const roberts_scene *scene = fronts->scene;
    if (!scene->surface || fronts->seen->clip.clipped)
        return true;
    const stars s = {fronts, alloc_zeroed(scene->vertex_count, sizeof *s.star), threads == 1};
    *sheet = alloc_array(scene->vertex_count, sizeof **sheet);
    if (s.star && *sheet) {
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic, 64) num_threads(threads)
#endif
        for (uint32_t body = 0; body < scene->solid_count; body++)
            if (!scene_is_convex(scene, body) && !fronts->culled[body])
                mark_folds(&s, body);
#ifdef _OPENMP
#pragma omp parallel for schedule(static) num_threads(threads)
#endif
        for (uint32_t k = 0; k < fronts->front_count; k++)
            mark_front(&s, &fronts->front[k]);
        for (uint32_t v = 0; v < scene->vertex_count; v++)
            (*sheet)[v] = atomic_load_explicit(&s.star[v], memory_order_relaxed) == ROUND_ONCE;
    }
    bool found = s.star && *sheet;
    free(s.star);
    return found;
}

/* ---- boxes ------------------------------------------------------------------------------------------------------- */

/* Solids this many touching distances apart do not touch. */
#define WELL_APART 4.0

bool filter_find_flat(const crossing_filter *p, uint32_t front)
{
    const roberts_scene *scene = p->fronts->scene;
    const scene_solid *s = &scene->solid[p->fronts->front[front].solid];
    const scene_edge *edge = scene->edge + s->stored, *end = edge + (s[1].edge - s->edge);
    while (edge < end && !seen_is_flat(scene->face_plane + s->face, edge, p->fronts->seen->rules.crease_chord))
        edge++;
    unsigned char flat = edge < end ? FLAT_SOMEWHERE : FLAT_NOWHERE;
    atomic_store_explicit(&p->model[front].flat, flat, memory_order_relaxed);
    return edge < end;
}

/* A box of at most two columns and two rows stands for its front, since all its cells list the front. */
static first_cell first_cell_of(const scan_frame *frame, const hide_box *box, double loose)
{
    double m = frame->margin + loose;
    uint32_t column = scan_column(frame, (double)box->x0 - m), row = scan_row(frame, (double)box->y0 - m);
    bool small = scan_column(frame, (double)box->x1 + m) - column < 2 && scan_row(frame, (double)box->y1 + m) - row < 2;
    return (first_cell){small ? (uint16_t)column : NO_CELL, (uint16_t)row};
}

static void box_solid(const crossing_filter *p, uint32_t front)
{
    const roberts_scene *scene = p->fronts->scene;
    const scene_solid *s = &scene->solid[p->fronts->front[front].solid];
    hide_bounds own = hide_no_bounds;
    box_add_all(&own.low, &own.high, scene->point + s->vertex, s[1].vertex - s->vertex);
    p->model[front] = (model_box){own, FLAT_UNKNOWN};
}

/* A point touches a face if its distance is at most the touching distance plus the face's departure from its plane. */
static double touching_distance(const hide_fronts *fronts)
{
    const roberts_scene *scene = fronts->scene;
    float departure = 0.0f;
    for (uint32_t f = 0; scene->face_deviation && f < scene->face_count; f++)
        departure = scene->face_deviation[f] > departure ? scene->face_deviation[f] : departure;
    return WELL_APART * scene->unit * (fronts->space.epsilon + (double)departure);
}

/* If points have low parts, boxes of their high parts prove nothing. */
bool filter_begin(crossing_filter *p, const hide_fronts *fronts, const objet *grid, int threads)
{
    uint32_t count = fronts->front_count;
    *p = (crossing_filter){.fronts = fronts};
    while (!fronts->scene->low && p->whole < count && !hide_is_face(&fronts->front[p->whole]))
        p->whole++;
    p->touching = p->whole > 0 ? touching_distance(fronts) : 0.0;
    p->first = alloc_array(count, sizeof *p->first);
    p->model = alloc_array(p->whole, sizeof *p->model);
    if (!p->first || !p->model)
        return false;
#ifdef _OPENMP
#pragma omp parallel for schedule(static) num_threads(threads)
#endif
    for (uint32_t k = 0; k < count; k++) {
        p->first[k] = first_cell_of(&grid->frame, &fronts->front_box[k], hide_loose(fronts, k));
        if (k < p->whole)
            box_solid(p, k);
    }
    return stars_find(fronts, threads, &p->sheet);
}

void filter_end(crossing_filter *p)
{
    free(p->first);
    free(p->model);
    free(p->sheet);
    *p = (crossing_filter){0};
}
