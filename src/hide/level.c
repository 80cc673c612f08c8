/* level.c - the number of layers in front of a hidden point: Appel's quantitative invisibility ("The notion of
 * quantitative invisibility and the machine rendering of solids", ACM 1967).
 *
 * Appel counts the faces toward the viewer. Winding would tell which these are, but winding is not trusted here. The
 * line of sight comes from outside: it enters a closed body through the first face it meets, leaves through the second,
 * and so on. So every other face is toward the viewer.
 *
 * In the picture, the point may lie on the border of faces, for instance where equal blocks are stacked. Then the point
 * is moved slightly in four directions, so that it lies in exactly one of two faces with a common side. Faces are
 * closed, so for each body the direction with the most layers counts. */
#include "hide/level.h"

#include <stdlib.h>

#include "base/array.h"

enum { WAYS = 4 };

/* Directions along which no side of a usual model runs. */
static const roberts_vec2 way[WAYS] = {{0.842, 0.539}, {-0.539, 0.842}, {-0.842, -0.539}, {0.539, -0.842}};

/* Finds the directions in which X can be moved slightly so that it lies in the face, as bits. */
static unsigned ways_into(const hide_fronts *fronts, const hide_face *F, roberts_vec3 X)
{
    unsigned ways = (1u << WAYS) - 1;
    for (uint32_t i = 0; i < F->count && ways; i++) {
        roberts_vec3 P = fronts->P[F->corner[i]], Q = fronts->P[F->corner[i + 1 < F->count ? i + 1 : 0]];
        double dx = Q.x - P.x, dy = Q.y - P.y, H = dx * (X.y - P.y) - dy * (X.x - P.x);
        double band = fronts->space.epsilon * sqrt(dx * dx + dy * dy);
        if (H > band)
            continue;
        for (int k = 0; k < WAYS; k++)
            if (H < -band || !(dx * way[k].y - dy * way[k].x > 0.0))
                ways &= ~(1u << k);
    }
    return ways;
}

/* Records a face if it lies in front of X. False: no memory. */
static bool take_face(const hide_fronts *fronts, uint32_t body, const hide_face *F, roberts_vec3 X, level_hits *hits)
{
    if (plane_at(F->F, X) <= F->touch || !hide_polygon_holds(fronts, &fronts->face_runs, F->corner, F->count,
                                                             (roberts_vec2){X.x, X.y}, fronts->space.epsilon))
        return true;
    if (!array_reserve(&hits->item, &hits->room, hits->count + 1, sizeof *hits->item))
        return false;
    hits->item[hits->count++] = (level_hit){body, ways_into(fronts, F, X)};
    return true;
}

static bool take_front(const hide_fronts *fronts, uint32_t index, roberts_vec3 X, level_hits *hits)
{
    const hide_front *front = &fronts->front[index];
    uint32_t count;
    hide_single single = {.front = ROBERTS_NONE};
    const hide_face *face = hide_faces(fronts, index, &count, &single);
    const bundle *b = hide_bundle(fronts, index);
    for (uint32_t i = 0; !b && i < count; i++)
        if (!take_face(fronts, front->solid, &face[i], X, hits))
            return false;
    for (uint32_t i = 0, end; b && bundle_next(b, X.x, X.y, &i, &end);)
        for (; i < end; i++)
            if (!take_face(fronts, front->solid, &face[b->order[i]], X, hits))
                return false;
    return true;
}

static bool may_hide(const hide_fronts *fronts, const hide_box *box, roberts_vec3 X)
{
    double m = fronts->space.epsilon;
    return X.x >= (double)box->x0 - m && X.x <= (double)box->x1 + m && X.y >= (double)box->y0 - m &&
           X.y <= (double)box->y1 + m && (double)box->z1 >= X.z;
}

static int by_body(const void *a, const void *b)
{
    const level_hit *p = a, *q = b;
    return (p->body > q->body) - (p->body < q->body);
}

/* Returns the layers of one body. hit[0 .. count - 1] are its faces in front of the point. */
static uint32_t layers(const roberts_scene *scene, const level_hit *hit, size_t count)
{
    uint32_t most = 0;
    for (int k = 0; k < WAYS; k++) {
        uint32_t met = 0;
        for (size_t i = 0; i < count; i++)
            met += hit[i].ways >> k & 1;
        most = met > most ? met : most;
    }
    if (scene_is_convex(scene, hit->body))
        return most > 0;
    return scene->surface->kind[hit->body] == ROBERTS_CLOSED ? (most + 1) / 2 : most;
}

bool hide_level_at(hide_worker *w, const seen_line *line, roberts_vec3 X, uint32_t *level)
{
    const hide_fronts *fronts = w->fronts;
    const scan_frame *frame = &w->grid->frame;
    level_hits *hits = &w->level;
    size_t cell = (size_t)scan_column(frame, X.x) * frame->ny + scan_row(frame, X.y);
    *level = seen_is_back(line->class);
    hits->count = 0;
    for (uint32_t k = w->grid->start[cell]; k < w->grid->start[cell + 1]; k++) {
        const uint32_t index = w->grid->entry[k].front;
        const hide_front *front = &fronts->front[index];
        if (may_hide(fronts, &fronts->front_box[index], X) &&
            !seen_owns(fronts->scene, &line->own, hide_key(fronts, front)) && !take_front(fronts, index, X, hits))
            return false;
    }
    if (hits->count > 1)
        qsort(hits->item, hits->count, sizeof *hits->item, by_body);
    for (size_t i = 0, next; i < hits->count; i = next) {
        for (next = i + 1; next < hits->count && hits->item[next].body == hits->item[i].body;)
            next++;
        *level += layers(fronts->scene, &hits->item[i], next - i);
    }
    *level += *level == 0; /* rounding has put X beside what hides it */
    return true;
}
