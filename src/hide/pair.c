/* pair.c - see pair.h. */
#include "hide/pair.h"

#include "hide/many.h"

bool hide_within_reach(const hide_picture *picture, const hide_front *front, const hide_edge *e)
{
    roberts_vec3 C = picture->P[picture->outline[front->outline]];
    double a = fabs(e->A.x - C.x) + fabs(e->A.y - C.y) + fabs(e->A.z - C.z);
    double b = fabs(e->B.x - C.x) + fabs(e->B.y - C.y) + fabs(e->B.z - C.z);
    return a <= front->reach && b <= front->reach;
}

bool hide_pierce_all(const hide_picture *picture, const hide_face *face, uint32_t bits, const hide_edge *e,
                     hide_sides *sides, hide_part *part)
{
    for (; bits; bits &= bits - 1)
        if (!hide_pierce(&picture->space, face + bits_trailing_zeros(bits), e, sides, part))
            return false;
    return true;
}

BITS_RARE bool hide_by_outline_closely(const hide_picture *picture, const uint32_t *corner, uint32_t count,
                                       const hide_edge *e, hide_sides *sides, roberts_tally *tally, hide_part *part)
{
    hide_face F = {.corner = corner, .count = count};
    const runs *r = runs_of(&picture->outline_runs, corner, count);
    if (r)
        return hide_by_runs(&picture->space, r, &F, e, sides, tally, part);
    if (hide_test2(&picture->space, &F, e)) {
        tally->test2_visible++;
        return false;
    }
    return hide_by_sides(&picture->space, &F, e, sides, tally, part);
}

/* Tests 1 to 4 of one face; false where it hides nothing of e. */
static bool by_face(const hide_picture *picture, const hide_face *F, double span, const hide_edge *e, hide_sides *sides,
                    roberts_tally *tally, hide_part *part)
{
    tally->pairs++;
    if (hide_test1(F, e)) {
        tally->test1_visible++;
        return false;
    }
    const runs *r = runs_of(&picture->face_runs, F->corner, F->count);
    bool inside = r ? hide_by_runs(&picture->space, r, F, e, sides, tally, part)
                    : hide_by_outline(picture, F->corner, F->count, span, e, sides, tally, part);
    return inside && hide_pierce(&picture->space, F, e, sides, part);
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

bool hide_by_faces(const hide_picture *picture, const hide_front *front, double span, const hide_edge *e,
                   hide_sides *sides, roberts_tally *tally, hide_part *hull)
{
    bool found = false;
    for (uint32_t k = front->face; k < front->face + front->face_count; k++) {
        hide_part part;
        if (!by_face(picture, &picture->face[k], span, e, sides, tally, &part))
            continue;
        if (found)
            join(hull, &part);
        else
            *hull = part;
        found = true;
    }
    return found;
}
