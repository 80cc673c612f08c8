/* pair.c - see pair.h. */
#include "hide/pair.h"

/* Test 1 for all faces: HIDE_VISIBLE where one has A and B in front of it or on it, HIDE_INVISIBLE (as far as depth
 * goes) where both are behind all of them. */
static hide_verdict test1_of_all(const hide_face *face, uint32_t count, const hide_edge *e)
{
    bool behind = true;
    for (uint32_t k = 0; k < count; k++) {
        double a = plane_at(face[k].F, e->A), b = plane_at(face[k].F, e->B);
        if (a <= face[k].limit && b <= face[k].limit)
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

bool hide_by_front(const hide_picture *picture, const hide_front *front, const hide_edge *e, hide_sides *sides,
                   roberts_tally *tally, hide_part *part)
{
    const hide_face *face = &picture->face[front->face];
    if (front->corners == 0)
        return hide_by_face(&picture->space, face, e, sides, tally, part);
    tally->pairs++;
    hide_face outline = hide_outline(picture, front);
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
