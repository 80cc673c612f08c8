/* front_test.c - the tests of one edge against the front of one solid. See front_test.h. */
#include "hide/front_test.h"

#include "base/sort.h"
#include "hide/intervals.h"
#include "model/face_pieces.h"

_Static_assert(FAST_CORNERS >= PIECE_CORNERS, "tests_fast.h takes the pieces of faces");

bool hide_within_reach(const hide_fronts *fronts, const hide_whole_front *whole, const hide_edge *e)
{
    roberts_vec3 C = fronts->P[fronts->outline[whole->outline]];
    double a = fabs(e->A.x - C.x) + fabs(e->A.y - C.y) + fabs(e->A.z - C.z);
    double b = fabs(e->B.x - C.x) + fabs(e->B.y - C.y) + fabs(e->B.z - C.z);
    return a <= whole->reach && b <= whole->reach;
}

bool hide_pierce_all(const hide_fronts *fronts, const hide_face *face, uint32_t bits, const hide_edge *e,
                     hide_sides *sides, hide_interval *part)
{
    hide_interval inside = *part;
    for (; bits; bits &= bits - 1)
        if (!hide_pierce(&fronts->space, face + bits_trailing_zeros(bits), e, &inside, sides, part))
            return false;
    if (!hide_is_left(&fronts->space, e, part))
        return false;
    sides->tally.pierced += part->t0 != inside.t0 || part->t1 != inside.t1;
    return true;
}

BITS_RARE bool hide_by_outline_closely(const hide_fronts *fronts, const uint32_t *corner, uint32_t count,
                                       const hide_edge *e, hide_sides *sides, hide_interval *part)
{
    hide_face F = {.corner = corner, .count = count};
    const runs *r = runs_of(&fronts->outline_runs, corner, count);
    if (r)
        return hide_by_runs(&fronts->space, r, &F, e, sides, part);
    if (hide_test2(&fronts->space, &F, e)) {
        sides->tally.test2_visible++;
        return false;
    }
    return hide_by_sides(&fronts->space, &F, e, sides, part);
}

/* Makes tests 2 to 4 with one face, and finds the part of the edge inside it. False: there is none. */
BITS_INLINE bool inside_face(const hide_fronts *fronts, const hide_face *F, double span, const hide_edge *e,
                             hide_sides *sides, hide_interval *part)
{
    const runs *r = runs_of(&fronts->face_runs, F->corner, F->count);
    hide_polygon outline = {F->corner, F->count, span};
    sides->tally.pairs++;
    return r ? hide_by_runs(&fronts->space, r, F, e, sides, part)
             : hide_by_outline(fronts, &outline, e, NULL, sides, part);
}

/* Reduces a part inside a face to what lies behind the face. depth: what test 1 found. False: nothing is left. */
BITS_INLINE bool behind_face(const hide_fronts *fronts, const hide_face *F, hide_verdict depth, const hide_edge *e,
                             hide_sides *sides, hide_interval *part)
{
    return depth == HIDE_INVISIBLE || hide_pierce_all(fronts, F, 1, e, sides, part);
}

/* Makes test 1, and counts it if the edge is visible. */
BITS_INLINE hide_verdict test1(const hide_face *F, const hide_edge *e, hide_sides *sides)
{
    hide_verdict depth = hide_test1(F, e);
    if (depth == HIDE_VISIBLE) {
        sides->tally.pairs++;
        sides->tally.test1_visible++;
    }
    return depth;
}

/* Adds a part to the hull of the hidden parts. If nothing has been `*found`, the part becomes the hull. */
static void join_hidden(hide_interval *hull, bool *found, const hide_interval *part)
{
    *hull = *found ? hide_intervals_joined(hull, part) : *part;
    *found = true;
}

/* The tests of one edge against a bundle. */
typedef struct bundle_search {
    const hide_fronts *fronts;
    const bundle *b;
    const hide_face *face; /* the bundle's first face */
    const hide_edge *e;
    double span;
    hide_sides *sides;
    hide_interval *hull; /* of the hidden parts; valid once `found` */
    bool found;
    bool forward; /* find what hides more beyond the hull's end; otherwise before its beginning */
} bundle_search;

/* Can a node's faces hide more than is known? The farther they may hide in the current direction, the larger is
 * `*reach`. */
static bool may_hide_more(const bundle_search *c, const bundle_node *n, double *reach)
{
    double t0, t1;
    if (!bundle_meets(n, c->e, &t0, &t1))
        return false;
    if (c->found && c->forward)
        t0 = greater(t0, c->hull->t1);
    if (c->found && !c->forward)
        t1 = lesser(t1, c->hull->t0);
    *reach = c->forward ? t1 : -t0;
    return t0 < t1 && (bundle_behind(n, hide_edge_at(c->e, t0)) || bundle_behind(n, hide_edge_at(c->e, t1)));
}

static void test_faces(bundle_search *c, uint32_t item)
{
    for (uint32_t end = list_tree_end(&c->b->tree, 0, item); item < end; item++) {
        hide_interval part;
        const hide_face *F = &c->face[c->b->order[item]];
        hide_verdict depth = test1(F, c->e, c->sides);
        if (depth != HIDE_VISIBLE && inside_face(c->fronts, F, c->span, c->e, c->sides, &part) &&
            behind_face(c->fronts, F, depth, c->e, c->sides, &part))
            join_hidden(c->hull, &c->found, &part);
    }
}

/* A node that may hide more, given by its first item. */
typedef struct reaching {
    double reach;
    uint32_t item;
} reaching;

/* Tests the nodes of a rank that cover item .. end - 1; there are at most eight. Those that reach farthest come first,
 * since they leave the least to the others. */
static void test_nodes(bundle_search *c, int rank, uint32_t item, uint32_t end)
{
    reaching node[1 << LIST_TREE_BITS] = {{0.0, 0}};
    uint32_t count = 0;
    for (; item < end; item = list_tree_end(&c->b->tree, rank, item)) {
        node[count].item = item;
        count += may_hide_more(c, &c->b->node[list_tree_node(&c->b->tree, rank, item)], &node[count].reach);
    }
    SORT_FEW(reaching, node, count, a->reach < b->reach)
    for (uint32_t i = 0; i < count; i++) {
        if (c->found && node[i].reach <= (c->forward ? c->hull->t1 : -c->hull->t0))
            return;
        if (rank == 0)
            test_faces(c, node[i].item);
        else
            test_nodes(c, rank - 1, node[i].item, list_tree_end(&c->b->tree, rank, node[i].item));
    }
}

/* Finds the hull's end, then its beginning. False: nothing is hidden. */
static BITS_RARE bool by_bundle(bundle_search *c)
{
    int highest = (int)c->b->tree.ranks - 1;
    c->forward = true;
    test_nodes(c, highest, 0, c->b->tree.items);
    c->forward = false;
    if (c->found && c->hull->t0 > 0.0)
        test_nodes(c, highest, 0, c->b->tree.items);
    return c->found;
}

bool hide_by_faces(const hide_fronts *fronts, const hide_meeting *m, const hide_edge *e, hide_sides *sides,
                   hide_interval *hull)
{
    bool found = false;
    if (m->tree)
        return by_bundle(&(bundle_search){.fronts = fronts,
                                          .b = m->tree,
                                          .face = m->face,
                                          .e = e,
                                          .span = m->outline.span,
                                          .sides = sides,
                                          .hull = hull});
    /* What a solid hides lies behind the planes of all its faces. A front that is no solid has one face. */
    hide_verdict depth[FACES_OF_ONE_FRONT];
    for (uint32_t k = 0; k < m->face_count; k++) {
        depth[k] = test1(&m->face[k], e, sides);
        if (depth[k] == HIDE_VISIBLE)
            return false;
    }
    for (uint32_t k = 0; k < m->face_count; k++) {
        hide_interval part;
        if (inside_face(fronts, &m->face[k], m->outline.span, e, sides, &part) &&
            behind_face(fronts, &m->face[k], depth[k], e, sides, &part))
            join_hidden(hull, &found, &part);
    }
    return found;
}
