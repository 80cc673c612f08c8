/* pair.c - see pair.h. */
#include "hide/pair.h"

#include "base/bits.h"
#include "base/lanes.h"

/* Test 1 for all faces: HIDE_VISIBLE where one has A and B in front of it or on it, HIDE_INVISIBLE (as far as depth
 * goes) where both are behind all of them. A and B go side by side. */
static hide_verdict test1_of_all(const hide_face *face, uint32_t count, const hide_edge *e)
{
    two x = two_of(e->A.x, e->B.x), y = two_of(e->A.y, e->B.y), z = two_of(e->A.z, e->B.z);
    unsigned any = 0;
    for (const hide_face *end = face + count; face < end; face++) {
        two ab = two_add(two_mul(two_all(face->F.a), x), two_mul(two_all(face->F.b), y));
        two at = two_add(two_add(ab, two_mul(two_all(face->F.c), z)), two_all(face->F.d));
        unsigned front = two_at_most(at, two_all(face->touch));
        if (front == 3)
            return HIDE_VISIBLE;
        any |= front;
    }
    return any ? HIDE_UNDECIDED : HIDE_INVISIBLE;
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

/* The same by tests 2 to 4 themselves. */
BITS_RARE static bool by_outline_closely(const hide_picture *picture, const uint32_t *corner, uint32_t count,
                                         const hide_edge *e, hide_sides *sides, roberts_tally *tally, hide_part *part)
{
    hide_face F = {.corner = corner, .count = count};
    if (hide_test2(&picture->space, &F, e)) {
        tally->test2_visible++;
        return false;
    }
    return hide_by_sides(&picture->space, &F, e, sides, tally, part);
}

/* Tests 2 to 4, counted: the part of e inside an outline; false where there is none. Where all signs are plain the tests
 * are asked together: what is outside one side is then counted for test 3 also where test 2 would have said so. */
static bool by_outline(const hide_picture *picture, const uint32_t *corner, uint32_t count, const hide_edge *e,
                       hide_sides *sides, roberts_tally *tally, hide_part *part)
{
    if (count > QUICK_CORNERS)
        return by_outline_closely(picture, corner, count, e, sides, tally, part);
    if (sides->quick.corner != corner)
        quick_take(&sides->quick, picture->P, corner, count);
    switch (quick_test(&sides->quick, &picture->space, e, part)) {
    case QUICK_MISSED:
        tally->test2_visible++;
        return false;
    case QUICK_OUTSIDE:
        tally->test3_visible++;
        return false;
    case QUICK_INSIDE:
        tally->test3_invisible++;
        return true;
    case QUICK_CUT:
        tally->test4++;
        return true;
    case QUICK_EMPTY:
        tally->test4++;
        return false;
    default:
        return by_outline_closely(picture, corner, count, e, sides, tally, part);
    }
}

/* As hide_by_face(). */
static bool by_face(const hide_picture *picture, const hide_face *F, const hide_edge *e, hide_sides *sides,
                    roberts_tally *tally, hide_part *part)
{
    tally->pairs++;
    if (hide_test1(F, e)) {
        tally->test1_visible++;
        return false;
    }
    return by_outline(picture, F->corner, F->count, e, sides, tally, part) &&
           hide_pierce(&picture->space, F, e, sides, part);
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
        if (!by_face(picture, &picture->face[k], e, sides, tally, &part))
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

static bool within_reach(const hide_picture *picture, const hide_front *front, const hide_edge *e)
{
    roberts_vec3 C = picture->P[picture->outline[front->outline]];
    return distance(e->A, C) <= front->reach && distance(e->B, C) <= front->reach;
}

bool hide_by_front(const hide_picture *picture, const hide_front *front, const hide_edge *e, hide_sides *sides,
                   roberts_tally *tally, hide_part *part)
{
    const hide_face *face = &picture->face[front->face];
    if (front->corners == 0)
        return by_face(picture, face, e, sides, tally, part);
    if (front->reach != INFINITY && !within_reach(picture, front, e))
        return face_by_face(picture, front, e, sides, tally, part);
    tally->pairs++;
    hide_verdict depth = HIDE_INVISIBLE;
    if (!(e->A.z < (double)front->depth && e->B.z < (double)front->depth))
        depth = test1_of_all(face, front->face_count, e);
    if (depth == HIDE_VISIBLE) {
        tally->test1_visible++;
        return false;
    }
    return by_outline(picture, picture->outline + front->outline, front->corners, e, sides, tally, part) &&
           (depth == HIDE_INVISIBLE || pierce_all(picture, front, e, sides, part));
}
