/* pair.c - see pair.h. */
#include "hide/pair.h"

#include "base/bits.h"
#include "base/lanes.h"

/* A and B side by side. */
typedef struct ends {
    two x, y, z;
} ends;

static inline ends ends_of(const hide_edge *e)
{
    return (ends){two_of(e->A.x, e->B.x), two_of(e->A.y, e->B.y), two_of(e->A.z, e->B.z)};
}

/* Test 1 for all faces: HIDE_VISIBLE where one has A and B in front of it or on it, HIDE_INVISIBLE (as far as depth
 * goes) where both are behind all of them. `*near`: bit i for face i that AB is not clear of, by twice the distance that
 * counts as touching: only these can be pierced. */
static inline hide_verdict test1_of_all(const hide_face *face, uint32_t count, ends e, uint32_t *near)
{
    bool any = false;
    *near = 0;
    for (uint32_t i = 0; i < count; i++, face++) {
        two ab = two_add(two_mul(two_all(face->F.a), e.x), two_mul(two_all(face->F.b), e.y));
        two at = two_add(two_add(ab, two_mul(two_all(face->F.c), e.z)), two_all(face->F.d)),
            touch = two_all(face->touch);
        if (!two_at_most(at, two_add(touch, touch)))
            continue;
        unsigned front = two_at_most(at, touch);
        if (front == 3)
            return HIDE_VISIBLE;
        any = any || front;
        *near |= 1u << i;
    }
    return any ? HIDE_UNDECIDED : HIDE_INVISIBLE;
}

/* Cuts the part where e pierces the planes of the faces given by bits; false where nothing of it is left behind them. */
static bool pierce_all(const hide_picture *picture, const hide_face *face, uint32_t bits, const hide_edge *e,
                       hide_sides *sides, hide_part *part)
{
    for (; bits; bits &= bits - 1)
        if (!hide_pierce(&picture->space, face + bits_trailing_zeros(bits), e, sides, part))
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
BITS_INLINE bool by_outline(const hide_picture *picture, const uint32_t *corner, uint32_t count, const hide_edge *e,
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

/* Tests 1 to 4 of one face; false where it hides nothing of e. */
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

/* Are A and B within the reach of what the planes can be trusted, along three axes? */
static inline bool within_reach(const hide_picture *picture, const hide_front *front, ends e)
{
    roberts_vec3 C = picture->P[picture->outline[front->outline]];
    two x = two_abs(two_sub(e.x, two_all(C.x))), y = two_abs(two_sub(e.y, two_all(C.y)));
    two z = two_abs(two_sub(e.z, two_all(C.z)));
    return two_at_most(two_add(two_add(x, y), z), two_all(front->reach)) == 3;
}

/* The same for all points of a box. */
static bool box_within_reach(const hide_picture *picture, const hide_front *front, const hide_box *box)
{
    roberts_vec3 C = picture->P[picture->outline[front->outline]];
    double x = greater((double)box->x1 - C.x, C.x - (double)box->x0);
    double y = greater((double)box->y1 - C.y, C.y - (double)box->y0);
    double z = greater((double)box->z1 - C.z, C.z - (double)box->z0);
    return x + y + z <= 0.999 * front->reach; /* the rest is for rounding */
}

hide_approach hide_approach_front(const hide_picture *picture, const hide_front *front, const hide_box *box)
{
    if (front->corners == 0)
        return HIDE_ONE_FACE;
    return front->reach == INFINITY || box_within_reach(picture, front, box) ? HIDE_WITHIN_REACH : HIDE_ASK_REACH;
}

bool hide_by_front(const hide_picture *picture, const hide_front *front, hide_approach approach, const hide_edge *e,
                   hide_sides *sides, roberts_tally *tally, hide_part *part)
{
    const hide_face *face = &picture->face[front->face];
    ends both = ends_of(e);
    uint32_t near = 0;
    if (approach == HIDE_ONE_FACE)
        return by_face(picture, face, e, sides, tally, part);
    if (approach == HIDE_ASK_REACH && !within_reach(picture, front, both))
        return face_by_face(picture, front, e, sides, tally, part);
    tally->pairs++;
    hide_verdict depth = HIDE_INVISIBLE;
    if (two_at_most(two_all((double)front->depth), both.z)) /* else behind all of it */
        depth = test1_of_all(face, front->face_count, both, &near);
    if (depth == HIDE_VISIBLE) {
        tally->test1_visible++;
        return false;
    }
    return by_outline(picture, picture->outline + front->outline, front->corners, e, sides, tally, part) &&
           (depth == HIDE_INVISIBLE || pierce_all(picture, face, near, e, sides, part));
}
