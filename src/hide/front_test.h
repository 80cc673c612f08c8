/* front_test.h - what the front of one solid hides of one edge of another: one interval.
 *
 * The volume behind a convex solid is { X : X inside the outline, F(X) > 0 for every front face F }. So for the whole
 * front the four tests become:
 *
 *   1. Some face has A and B in front of it or on it: visible.
 *   2. The outline lies on one side of the sight plane through AB: visible.
 *   3. and 4. as for one face, but with the sides of the outline. If A and B are not both behind all faces, the part
 *      found is cut where AB pierces the plane of any face.
 *
 * These tests use planes far from their faces. Each front has a reach up to which its planes can be trusted: a thousand
 * widths of a face, but nothing for models given to few digits (see set_trust() in front.c). An edge beyond the reach
 * that is not deeper than the whole front is visible if it lies in front of one face or on it. Otherwise it takes tests
 * 2 to 4 with each face, and the front's part is the hull of what they hide. A one-face front is handled likewise; for
 * a bundle, only the faces that its tree leaves. */
#ifndef ROBERTS_HIDE_FRONT_TEST_H
#define ROBERTS_HIDE_FRONT_TEST_H

#include "hide/fronts.h"
#include "hide/tests.h"

/* How edges are tested against a front. */
typedef enum hide_approach {
    HIDE_FACE_BY_FACE, /* a single face, or the faces that a bundle's tree leaves */
    HIDE_WITHIN_REACH, /* all faces at once: the edges are within reach of all planes, or planes are not asked */
    HIDE_ASK_REACH,    /* all faces at once if the edge turns out to be within reach, otherwise face by face */
} hide_approach;

/* An outline or a face, as tested against an edge. */
typedef struct hide_polygon {
    const uint32_t *corner; /* [count] */
    uint32_t count;
    double span; /* bounds the distance |dx| + |dy| of any two points of polygon and edge */
} hide_polygon;

/* A front, and edges within a box. */
typedef struct hide_meeting {
    const hide_whole_front *whole; /* NULL: the front is a single face */
    const bundle *tree;            /* over its faces, or NULL */
    const hide_face *face;         /* [face_count] */
    uint32_t face_count;
    hide_polygon outline;
    hide_approach approach;
    double depth; /* what is deeper is behind all planes: that of the front, or INFINITY */
} hide_meeting;

/* Are all edges in a box so much deeper than the farthest corner of a triangle that they lie behind its plane wherever
 * they touch its picture? Then the plane need not be computed. Asked in scenes that store no planes: the triangles are
 * as exact as their corners. own: the triangle's box. Its normal is no longer than the square of the size. */
BITS_INLINE bool hide_are_deep(const hide_fronts *fronts, const uint32_t corner[3], const hide_box *own,
                               const hide_box *edges)
{
    const hide_space *space = &fronts->space;
    if (!((double)edges->z1 < (double)own->z0 - SHEET_SLACK * space->epsilon) || space->view->perspective)
        return false;
    const roberts_vec3 A = space->P[corner[0]], B = space->P[corner[1]], C = space->P[corner[2]];
    const double area = (B.x - A.x) * (C.y - A.y) - (B.y - A.y) * (C.x - A.x);
    const double size = (double)((own->x1 - own->x0) + (own->y1 - own->y0) + (own->z1 - own->z0));
    return area > size * (NORMAL_DEPTH * size + 8.0 * space->across_rounding);
}

/* The same for a front. If so, its outline is set in place of its plane. */
BITS_INLINE bool hide_meet_deep(const hide_fronts *fronts, uint32_t front, const hide_box *edges, hide_single *single,
                                hide_meeting *m)
{
    const hide_box *own = &fronts->front_box[front];
    if (fronts->scene->face_plane || !(edges->z1 < own->z0))
        return false;
    const hide_face face = hide_outline(fronts, front, single->turned);
    if (face.corner == single->turned)
        single->front = ROBERTS_NONE;
    if (!hide_are_deep(fronts, face.corner, own, edges))
        return false;
    m->outline.corner = face.corner;
    m->outline.count = face.count;
    m->approach = HIDE_WITHIN_REACH;
    m->depth = INFINITY;
    return true;
}

/* Prepares the tests of the edges in a box against a front. The boxes are rounded outward. The factor 1.001 far exceeds
 * the rounding of their common size to float. single: room for the face if the front is a single face. */
BITS_INLINE hide_meeting hide_meet(const hide_fronts *fronts, uint32_t front, const hide_box *edges,
                                   hide_single *single)
{
    const hide_box *own = &fronts->front_box[front];
    float x = (own->x1 > edges->x1 ? own->x1 : edges->x1) - (own->x0 < edges->x0 ? own->x0 : edges->x0);
    float y = (own->y1 > edges->y1 ? own->y1 : edges->y1) - (own->y0 < edges->y0 ? own->y0 : edges->y0);
    float z = (own->z1 > edges->z1 ? own->z1 : edges->z1) - (own->z0 < edges->z0 ? own->z0 : edges->z0);
    hide_meeting m = {.outline.span = 1.001 * (double)(x + y), .approach = HIDE_FACE_BY_FACE};
    const bool is_face = hide_is_face(&fronts->front[front]);
    if (is_face && hide_meet_deep(fronts, front, edges, single, &m))
        return m;
    m.face = hide_faces(fronts, front, &m.face_count, single);
    if (is_face)
        return m;
    m.whole = &fronts->whole[front];
    m.tree = bundle_of(&fronts->bundles, m.whole->face, m.face_count);
    m.outline.corner = fronts->outline + m.whole->outline;
    m.outline.count = m.whole->corners;
    if (fronts->front[front].kind == HIDE_CONVEX_SOLID)
        m.approach = 1.001 * (double)(x + y + z) <= m.whole->reach ? HIDE_WITHIN_REACH : HIDE_ASK_REACH;
    m.depth = (double)m.whole->depth;
    return m;
}

/* Tests the faces one by one, or by the tree of a bundle; without a tree there are at most FACES_OF_ONE_FRONT. Finds
 * the hull of what they hide; false if they hide nothing, or if e lies in front of one face of a solid or on it. */
bool hide_by_faces(const hide_fronts *fronts, const hide_meeting *m, const hide_edge *e, hide_sides *sides,
                   hide_interval *part);

/* Are A and B within reach of the front, so that its planes can be trusted there? Measured as |dx| + |dy| + |dz|. */
bool hide_within_reach(const hide_fronts *fronts, const hide_whole_front *whole, const hide_edge *e);

/* Test 1 for all faces. HIDE_VISIBLE: some face has A and B in front of it or on it. HIDE_INVISIBLE (by depth): both
 * are behind all faces. Bit i of `*near` is set if AB does not clear face i by twice the touching distance. Only these
 * faces can be pierced. */
BITS_INLINE hide_verdict hide_test1_of_all(const hide_face *face, uint32_t count, const hide_edge *e, uint32_t *near)
{
    two x = two_of(e->A.x, e->B.x), y = two_of(e->A.y, e->B.y), z = two_of(e->A.z, e->B.z);
    bool any = false;
    *near = 0;
    for (uint32_t i = 0; i < count; i++, face++) {
        two ab = two_add(two_mul(two_all(face->F.a), x), two_mul(two_all(face->F.b), y));
        two at = two_add(two_add(ab, two_mul(two_all(face->F.c), z)), two_all(face->F.d)), touch = two_all(face->touch);
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

/* Cuts the part where e pierces the planes of the faces given by `bits`, and counts that. False if nothing is left
 * behind them. */
bool hide_pierce_all(const hide_fronts *fronts, const hide_face *face, uint32_t bits, const hide_edge *e,
                     hide_sides *sides, hide_interval *part);

/* Makes tests 2 to 4 one by one, for an outline or for a face without runs. */
bool hide_by_outline_closely(const hide_fronts *fronts, const uint32_t *corner, uint32_t count, const hide_edge *e,
                             hide_sides *sides, hide_interval *part);

/* Makes tests 2 to 4 and counts them. Finds the part of e inside a polygon; false if there is none. If all signs are
 * plain, the tests are made together. Then an edge outside one side is counted under test 3, even if test 2 would also
 * have rejected it. */
BITS_INLINE bool hide_by_outline(const hide_fronts *fronts, const hide_polygon *p, const hide_edge *e,
                                 const hide_interval *hidden, hide_sides *sides, hide_interval *part)
{
    if (p->count > FAST_CORNERS)
        return hide_by_outline_closely(fronts, p->corner, p->count, e, sides, part);
    if (sides->outline.corner != p->corner)
        fast_take(&sides->outline, fronts->P, p->corner, p->count);
    switch (fast_test(&sides->outline, &fronts->space, e, p->span, hidden, part)) {
    case FAST_MISSED:
        sides->tally.test2_visible++;
        return false;
    case FAST_OUTSIDE:
        sides->tally.test3_visible++;
        return false;
    case FAST_INSIDE:
        sides->tally.test3_invisible++;
        return true;
    case FAST_CUT:
        sides->tally.test4++;
        return true;
    case FAST_EMPTY:
        sides->tally.test4++;
        return false;
    default:
        return hide_by_outline_closely(fronts, p->corner, p->count, e, sides, part);
    }
}

/* Finds what the front hides of e. False: it hides nothing, or nothing new. `hidden` is a part of e that is already
 * hidden (NULL: none). What lies within `hidden` is skipped only if e is behind all faces by depth, so that no plane is
 * near. sides: room for fronts->most_corners. */
BITS_INLINE bool hide_by_front(const hide_fronts *fronts, const hide_meeting *m, const hide_edge *e,
                               const hide_interval *hidden, hide_sides *sides, hide_interval *part)
{
    uint32_t near = 0;
    hide_verdict depth = HIDE_INVISIBLE;
    const bool behind = e->A.z < m->depth && e->B.z < m->depth; /* the whole front, so that its planes are not asked */
    if (m->approach != HIDE_WITHIN_REACH &&
        (m->approach == HIDE_FACE_BY_FACE || (!behind && !hide_within_reach(fronts, m->whole, e))))
        return hide_by_faces(fronts, m, e, sides, part);
    sides->tally.pairs++;
    if (!behind)
        depth = hide_test1_of_all(m->face, m->face_count, e, &near);
    if (depth == HIDE_VISIBLE) {
        sides->tally.test1_visible++;
        return false;
    }
    return hide_by_outline(fronts, &m->outline, e, depth == HIDE_INVISIBLE ? hidden : NULL, sides, part) &&
           (depth == HIDE_INVISIBLE || hide_pierce_all(fronts, m->face, near, e, sides, part));
}

#endif
