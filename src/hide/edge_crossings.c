/* edge_crossings.c - see edge_crossings.h.
 *
 * The search for crossings also finds touches: pairs of faces, one of which has a side in the other's plane. Here the
 * edges of these faces are tested, body by body. A side may be several edges, if vertices of other faces lie on it. */
#include "hide/edge_crossings.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/sort.h"

/* An edge of face[0] of a touch, which may lie in face[1]. */
typedef struct touching_edge {
    crossing_touch of;
    uint32_t edge;
    bool left_out; /* it is flat */
    bool seam;     /* face[1] is one of a sheet, and a union may leave the edge out */
} touching_edge;

typedef struct edge_finder {
    const hide_fronts *fronts;
    const crossing_rules *rules;
    const crossing_touch *touch; /* [touch_count] by face[0], then face[1]; each once */
    size_t touch_count;
    unsigned char *touches; /* [face_count] by the face's first piece: is it face[0] of a touch? */
    touching_edge *found;
    size_t count, room;
    crossing_kept touching, touched; /* the faces of the last touch */
    crossing_list *out;
    bool lost; /* no memory */
} edge_finder;

/* ---- the faces of an edge -------------------------------------------------------------------------------------- */

static bool has_face(const roberts_scene *scene, uint32_t body, uint32_t edge, uint32_t first)
{
    uint32_t room[2];
    const uint32_t *face;
    const uint32_t count = scene_faces_at(scene, body, edge, room, &face);
    for (uint32_t k = 0; k < count; k++)
        if (scene_first_piece(scene, body, face[k] & ~MANY_TURNED) == first)
            return true;
    return false;
}

/* Finds the edge's face of smallest number that does not lie in the plane of g. False: there is none, or the edge's
 * faces do not lie on both sides of that plane, or e->lost. But at a seam, faces of other bodies may continue any face
 * that touches: then it is this one, and *seam becomes true. */
static bool first_across(edge_finder *e, const touching_edge *t, crossing_face *g, crossing_face *out, bool *seam)
{
    const roberts_scene *scene = e->fronts->scene;
    const uint32_t body = t->of.body[0];
    uint32_t room[2], least = ROBERTS_NONE;
    const uint32_t *face;
    const uint32_t count = scene_faces_at(scene, body, t->edge, room, &face);
    bool over = false, under = false, any = false; /* the faces of a hull have no number */
    for (uint32_t k = 0; k < count; k++) {
        const uint32_t f = face[k] & ~MANY_TURNED;
        if (e->fronts->seen->facing[f] == VIEW_EDGE_ON)
            continue;
        crossing_face F = crossing_face_of(e->rules, body, f);
        if (g == &e->touched.face && !crossing_limit(&e->touched, e->rules, &F)) {
            e->lost = true;
            return false;
        }
        crossing_lie lie = crossing_lie_of(e->rules, &F, g);
        over = over || lie.over;
        under = under || lie.under;
        if ((!lie.over && !lie.under) || (any && scene_face_number(scene, f) >= least))
            continue;
        any = true;
        least = scene_face_number(scene, f);
        *out = F;
    }
    bool lone = t->left_out && over && under;
    if (t->seam && any && out->first != t->of.face[0]) {
        lone = false;
        *out = crossing_face_of(e->rules, body, t->of.face[0]);
    }
    *seam = *seam || !lone;
    return lone || (t->seam && any);
}

/* ---- lines ----------------------------------------------------------------------------------------------------- */

/* Records that the segments from `from` on lie on these edges. */
static void name_edges(crossing_list *list, size_t from, uint32_t first, uint32_t second, bool seam)
{
    for (size_t k = from; k < list->count; k++) {
        list->item[k].edge[0] = first;
        list->item[k].edge[1] = second;
        list->item[k].seam = seam;
    }
}

/* Finds the part of an edge inside the face that it touches. False: no memory. */
static bool find_inside(edge_finder *e, const touching_edge *t)
{
    size_t from = e->out->count;
    const scene_edge edge = scene_edge_at(e->fronts->scene, t->of.body[0], t->edge);
    crossing_face F, *G = crossing_keep(&e->touched, e->rules, t->of.body[1], t->of.face[1]);
    bool seam = false;
    if (!first_across(e, t, G, &F, &seam))
        return !e->lost;
    bool enough = crossing_limit(&e->touched, e->rules, &F) && crossing_find_in(e->rules, &F, edge.v, G, e->out);
    name_edges(e->out, from, t->edge, ROBERTS_NONE, seam);
    return enough;
}

/* Finds the overlap of two edges, each of which touches a face of the other. False: no memory. */
static bool find_common(edge_finder *e, const touching_edge *a, const touching_edge *b)
{
    size_t from = e->out->count;
    const scene_edge first = scene_edge_at(e->fronts->scene, a->of.body[0], a->edge);
    const scene_edge second = scene_edge_at(e->fronts->scene, b->of.body[0], b->edge);
    const crossing_face *own = crossing_keep(&e->touching, e->rules, a->of.body[0], a->of.face[0]);
    crossing_face F, H, *G = crossing_keep(&e->touched, e->rules, a->of.body[1], a->of.face[1]);
    bool seam = false;
    if (a->edge == b->edge || !crossing_may_have_common(e->rules, own, first.v, G, second.v) ||
        !first_across(e, a, G, &F, &seam) || !first_across(e, b, &F, &H, &seam))
        return !e->lost;
    bool enough = crossing_find_common(e->rules, &F, first.v, &H, second.v, e->out);
    name_edges(e->out, from, a->edge, b->edge, seam);
    return enough;
}

/* ---- touches --------------------------------------------------------------------------------------------------- */

static int compare_touches(const void *a, const void *b)
{
    return compare_pairs(((const crossing_touch *)a)->face, ((const crossing_touch *)b)->face);
}

static size_t drop_doubles(crossing_touch *touch, size_t count)
{
    size_t to = 0;
    if (count > 1)
        qsort(touch, count, sizeof *touch, compare_touches);
    for (size_t k = 0; k < count; k++)
        if (to == 0 || compare_touches(&touch[to - 1], &touch[k]) != 0)
            touch[to++] = touch[k];
    return to;
}

/* May a union leave out the edge, or a part of it? The near plane gives edges other numbers. */
static bool may_be_seam(const edge_finder *e, uint32_t body, uint32_t edge)
{
    const seen *s = e->fronts->seen;
    if (!s->edges.first || !union_takes(s->source, body))
        return false;
    return s->clip.clipped ? !s->clip.cap[edge] : united_pieces(&s->edges, edge) != NULL;
}

/* Pairs an edge with all faces touched by one of its faces, which is given by its first piece; if it is not left out,
 * but may be a seam, with those of sheets. */
static bool list_touches(edge_finder *e, uint32_t body, uint32_t edge, uint32_t first, bool left_out, bool seam)
{
    const roberts_scene *scene = e->fronts->scene;
    const crossing_touch least = {.face = {first, 0}};
    size_t k = find_first(&least, e->touch, e->touch_count, sizeof *e->touch, compare_touches);
    for (; k < e->touch_count && e->touch[k].face[0] == first; k++) {
        const crossing_touch *t = &e->touch[k];
        const bool of_sheet = seam && !union_takes(e->fronts->seen->source, t->body[1]);
        if ((!left_out && !of_sheet) || (t->body[1] == body && has_face(scene, body, edge, t->face[1])))
            continue;
        if (!array_reserve(&e->found, &e->room, e->count + 1, sizeof *e->found))
            return false;
        e->found[e->count++] = (touching_edge){*t, edge, left_out, of_sheet};
    }
    return true;
}

/* Lists the edges of a body that are left out or may be seams, and whose faces touch other faces. */
static bool list_edges(edge_finder *e, uint32_t body)
{
    const roberts_scene *scene = e->fronts->scene;
    for (uint32_t edge = scene->solid[body].edge; edge < scene->solid[body + 1].edge; edge++) {
        uint32_t room[2];
        const uint32_t *face;
        const uint32_t count = scene_faces_at(scene, body, edge, room, &face);
        bool asked = false, left_out = false, seam = false;
        for (uint32_t k = 0; k < count; k++) {
            const uint32_t first = scene_first_piece(scene, body, face[k] & ~MANY_TURNED);
            if (!e->touches[first])
                continue;
            if (!asked) {
                left_out = seen_is_left_out(e->fronts->seen, body, edge);
                seam = may_be_seam(e, body, edge);
                asked = true;
            }
            if (!left_out && !seam)
                break;
            if (!list_touches(e, body, edge, first, left_out, seam))
                return false;
        }
    }
    return true;
}

/* By pairs of faces, whichever touches the other. */
static int compare_edges(const void *pa, const void *pb)
{
    const touching_edge *a = pa, *b = pb;
    bool back[2] = {a->of.face[0] > a->of.face[1], b->of.face[0] > b->of.face[1]};
    for (int i = 0; i < 2; i++) {
        uint32_t f = a->of.face[back[0] ? 1 - i : i], g = b->of.face[back[1] ? 1 - i : i];
        if (f != g)
            return f < g ? -1 : 1;
    }
    if (back[0] != back[1])
        return back[1] ? -1 : 1;
    return (a->edge > b->edge) - (a->edge < b->edge);
}

/* Do the edges touch one another's faces? */
static bool touch_each_other(const touching_edge *a, const touching_edge *b)
{
    return a->of.face[0] == b->of.face[1] && a->of.face[1] == b->of.face[0];
}

/* Finds the lines of all edges listed. Those that touch the second face of a pair come after those that touch the first
 * one. */
static bool find_lines(edge_finder *e)
{
    bool enough = true;
    if (e->count > 1)
        qsort(e->found, e->count, sizeof *e->found, compare_edges);
    for (size_t i = 0; enough && i < e->count; i++) {
        const touching_edge *t = &e->found[i];
        enough = find_inside(e, t);
        for (size_t k = i + 1; enough && k < e->count; k++) {
            const touching_edge *u = &e->found[k];
            if (touch_each_other(t, u))
                enough = find_common(e, t, u);
            else if (compare_touches(&t->of, &u->of) != 0)
                break;
        }
    }
    return enough;
}

bool edge_crossings_find(const hide_fronts *fronts, const crossing_rules *rules, crossing_list *found)
{
    if (found->touch_count == 0)
        return true;
    edge_finder e = {.fronts = fronts,
                     .rules = rules,
                     .touch = found->touch,
                     .touch_count = drop_doubles(found->touch, found->touch_count),
                     .touches = alloc_zeroed(fronts->scene->face_count, sizeof *e.touches),
                     .out = found};
    bool enough = e.touches;
    for (size_t k = 0; enough && k < e.touch_count; k++)
        e.touches[e.touch[k].face[0]] = 1;
    for (size_t k = 0; enough && k < e.touch_count; k++)
        if (k == 0 || e.touch[k].body[0] != e.touch[k - 1].body[0])
            enough = list_edges(&e, e.touch[k].body[0]);
    enough = enough && find_lines(&e);
    free(e.touches);
    free(e.found);
    crossing_kept_free(&e.touching);
    crossing_kept_free(&e.touched);
    return enough;
}
