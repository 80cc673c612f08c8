/* pair.c - see pair.h. */
#include "hide/pair.h"

/* Test 1 for all faces: HIDE_VISIBLE where one has A and B in front of it or on it, HIDE_INVISIBLE (as far as depth
 * goes) where both are behind all of them. */
static hide_verdict test1_of_all(const hide_face *face, uint32_t count, const hide_edge *e)
{
    bool behind = true;
    for (uint32_t k = 0; k < count; k++) {
        double a = plane_at(face[k].F, e->A), b = plane_at(face[k].F, e->B);
        if (a <= face[k].touch && b <= face[k].touch)
            return HIDE_VISIBLE;
        behind = behind && a > face[k].touch && b > face[k].touch;
    }
    return behind ? HIDE_INVISIBLE : HIDE_UNDECIDED;
}

/* Cuts the part where e pierces the planes of the faces; false where nothing of it is left behind them all. */
static bool pierce_all(const hide_picture *picture, const hide_front *front, const hide_edge *e, hide_sides *sides,
                       hide_part *part)
{
    for (uint32_t k = front->face; k < front->face + front->face_count; k++)
        if (!hide_pierce(&picture->space, &picture->face[k], e, sides, part))
            return false;
    return true;
}

static void join(hide_part *hull, const hide_part *part)
{
    if (part->t0 < hull->t0) {
        hull->t0 = part->t0;
        hull->e0 = part->e0;
    }
    if (part->t1 > hull->t1) {
        hull->t1 = part->t1;
        hull->e1 = part->e1;
    }
}

static bool face_by_face(const hide_picture *picture, const hide_front *front, const hide_edge *e, hide_sides *sides,
                         roberts_tally *tally, hide_part *hull)
{
    bool found = false;
    for (uint32_t k = front->face; k < front->face + front->face_count; k++) {
        hide_part part;
        if (!hide_by_face(&picture->space, &picture->face[k], e, sides, tally, &part))
            continue;
        if (found)
            join(hull, &part);
        else
            *hull = part;
        found = true;
    }
    return found;
}

static double distance(roberts_vec3 a, roberts_vec3 b)
{
    return fabs(a.x - b.x) + fabs(a.y - b.y) + fabs(a.z - b.z);
}

static bool within_reach(const hide_picture *picture, const hide_front *front, const hide_face *outline,
                         const hide_edge *e)
{
    roberts_vec3 C = picture->P[outline->corner[0]];
    return front->reach == INFINITY || (distance(e->A, C) <= front->reach && distance(e->B, C) <= front->reach);
}

bool hide_by_front(const hide_picture *picture, const hide_front *front, const hide_edge *e, hide_sides *sides,
                   roberts_tally *tally, hide_part *part)
{
    const hide_face *face = &picture->face[front->face];
    if (front->corners == 0)
        return hide_by_face(&picture->space, face, e, sides, tally, part);
    hide_face outline = hide_outline(picture, front);
    if (!within_reach(picture, front, &outline, e))
        return face_by_face(picture, front, e, sides, tally, part);
    tally->pairs++;
    hide_verdict depth = test1_of_all(face, front->face_count, e);
    if (depth == HIDE_VISIBLE) {
        tally->test1_visible++;
        return false;
    }
    if (hide_test2(&picture->space, &outline, e)) {
        tally->test2_visible++;
        return false;
    }
    return hide_by_sides(&picture->space, &outline, e, sides, tally, part) &&
           (depth == HIDE_INVISIBLE || pierce_all(picture, front, e, sides, part));
}
