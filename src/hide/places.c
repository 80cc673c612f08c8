/* places.c - see places.h. */
#include "hide/places.h"

#include <stdlib.h>

#include "base/array.h"
#include "hide/stars.h"

/* Solids this many touching distances apart do not touch. */
#define WELL_APART 4.0

bool places_find_flat(const places *p, uint32_t front)
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

/* A box of at most two columns and two rows stands for its front: all its cells list the front. */
static first_cell first_cell_of(const scan_frame *frame, const hide_box *box, double loose)
{
    double m = frame->margin + loose;
    uint32_t column = scan_column(frame, (double)box->x0 - m), row = scan_row(frame, (double)box->y0 - m);
    bool small = scan_column(frame, (double)box->x1 + m) - column < 2 && scan_row(frame, (double)box->y1 + m) - row < 2;
    return (first_cell){small ? (uint16_t)column : NO_CELL, (uint16_t)row};
}

static void box_solid(const places *p, uint32_t front)
{
    const roberts_scene *scene = p->fronts->scene;
    const scene_solid *s = &scene->solid[p->fronts->front[front].solid];
    hide_bounds own = hide_no_bounds;
    box_add_all(&own.low, &own.high, scene->point + s->vertex, s[1].vertex - s->vertex);
    p->model[front] = (model_box){own, FLAT_UNKNOWN};
}

/* A point touches a face at the touching distance and the face's departure from its plane, or nearer. */
static double touching_distance(const hide_fronts *fronts)
{
    const roberts_scene *scene = fronts->scene;
    float departure = 0.0f;
    for (uint32_t f = 0; scene->face_deviation && f < scene->face_count; f++)
        departure = scene->face_deviation[f] > departure ? scene->face_deviation[f] : departure;
    return WELL_APART * scene->unit * (fronts->space.epsilon + (double)departure);
}

/* If points have low parts, boxes of their high parts say nothing. */
bool places_find(places *p, const hide_fronts *fronts, const objet *grid, int threads)
{
    uint32_t count = fronts->front_count;
    *p = (places){.fronts = fronts};
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

void places_free(places *p)
{
    free(p->first);
    free(p->model);
    free(p->sheet);
    *p = (places){0};
}
