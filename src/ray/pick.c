/* pick.c - what is seen at a point of the picture, and what lies behind it.
 *
 * Every front face is tested against the sight line through that point. A tree does not pay for a single query. */
#include <stdlib.h>

#include "base/array.h"
#include "base/error.h"
#include "base/sort.h"
#include "ray/sight.h"
#include "view/seen.h"

typedef struct picker {
    sight s;
    seen seen;
    roberts_vec3 Q, toward; /* the sight line through the picture's point, toward the viewer; in s.unit */
    roberts_picked *picked;
    size_t room;
} picker;

/* Returns the depth of a point in s.unit: how far it lies in front of the picture plane, toward the viewer. */
static double depth_of_hit(const picker *p, roberts_vec3 X)
{
    return vec3_dot(vec3_sub(X, p->Q), p->seen.view.dir);
}

static bool append_hit(picker *p, roberts_pick_hit hit)
{
    if (!array_reserve(&p->picked->hit, &p->room, p->picked->count + 1, sizeof hit))
        return false;
    p->picked->hit[p->picked->count++] = hit;
    return true;
}

/* Picks the front faces of one solid on the sight line. Adjacent faces that share the point count once. */
static bool pick_solid(picker *p, uint32_t solid)
{
    const roberts_scene *scene = p->s.scene;
    size_t first = p->picked->count;
    for (uint32_t face = scene->solid[solid].face; face < scene->solid[solid + 1].face; face++) {
        if (p->s.facing[face] != SIGHT_FRONT || sight_through(&p->s, face, p->Q, p->toward, 0.0) != SIGHT_SURELY)
            continue;
        roberts_vec3 X = sight_meet(&p->s, face, p->Q, p->toward);
        double depth = depth_of_hit(p, X);
        bool again = false;
        for (size_t i = first; i < p->picked->count; i++) {
            roberts_pick_hit *hit = &p->picked->hit[i];
            if (fabs(hit->depth / p->s.unit - depth) <= p->s.loose + p->s.rounding) {
                again = true;
                if (scene_face_number(scene, face) < hit->face)
                    hit->face = scene_face_number(scene, face);
            }
        }
        roberts_vec3 point = vec3_add(vec3_scale(p->s.unit, X), scene->centre);
        if (!again &&
            !append_hit(p, (roberts_pick_hit){solid, scene_face_number(scene, face), depth * p->s.unit, point}))
            return false;
    }
    return true;
}

static int nearest_first(const void *a, const void *b)
{
    const roberts_pick_hit *p = a, *q = b;
    if (p->depth != q->depth)
        return p->depth > q->depth ? -1 : 1;
    if (p->solid != q->solid)
        return p->solid < q->solid ? -1 : 1;
    return p->face < q->face ? -1 : p->face > q->face;
}

/* Sorts by depth; within a run of hits where each touches the next in depth, sorts by solid. nearest_first() cannot do
 * this, since touching is not transitive. */
static void order(roberts_picked *picked, double touching)
{
    qsort(picked->hit, picked->count, sizeof *picked->hit, nearest_first);
    SORT_FEW(roberts_pick_hit, picked->hit, picked->count, a->solid > b->solid && a->depth - b->depth <= touching)
}

roberts_status roberts_pick(const roberts_scene *scene, const roberts_camera *camera, double x, double y,
                            roberts_picked *picked, roberts_error *error)
{
    picker p = {.picked = picked};
    *picked = (roberts_picked){0};
    if (!isfinite(x) || !isfinite(y))
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "the point to pick must be finite");
    roberts_status status = seen_begin(&p.seen, scene, camera, 0.0, error);
    if (status != ROBERTS_OK)
        return status;
    if (!sight_prepare(&p.s, p.seen.scene, &p.seen.view)) {
        status = error_no_memory(error);
        goto done;
    }
    roberts_vec2 shift = {x / p.s.unit, y / p.s.unit};
    p.Q = vec3_add(vec3_scale(shift.x, p.seen.view.right), vec3_scale(shift.y, p.seen.view.up));
    p.Q = vec3_add(sight_point(&p.s, p.seen.view.origin), p.Q);
    p.toward = sight_from(&p.s, p.Q);
    for (uint32_t solid = 0; status == ROBERTS_OK && solid < p.seen.scene->solid_count; solid++)
        if (!pick_solid(&p, solid))
            status = error_no_memory(error);
    if (status != ROBERTS_OK)
        roberts_picked_free(picked);
    else if (picked->count)
        order(picked, (p.s.loose + p.s.rounding) * p.s.unit);
done:
    sight_free(&p.s);
    seen_end(&p.seen);
    return status;
}

void roberts_picked_free(roberts_picked *picked)
{
    if (!picked)
        return;
    free(picked->hit);
    *picked = (roberts_picked){0};
}
