/* crossing_filter.c - see crossing_filter.h. */
#include "hide/crossing_filter.h"

#include <stdatomic.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/threads.h"
#include "hide/face_pairs.h"

/* ---- where bodies lie -------------------------------------------------------------------------------------------- */

/* A point touches a face if its distance is at most the touching distance plus the face's departure from its plane. */
static double touching_distance(const hide_fronts *fronts)
{
    const roberts_scene *scene = fronts->scene;
    float departure = 0.0f;
    for (uint32_t f = 0; scene->face_deviation && f < scene->face_count; f++)
        departure = scene->face_deviation[f] > departure ? scene->face_deviation[f] : departure;
    return FILTER_APART * scene->unit * (fronts->space.epsilon + (double)departure);
}

/* ---- stars ------------------------------------------------------------------------------------------------------- */

/* The star of a vertex is the set of all faces at it. Suppose that no edge there is a fold (see layers.h), and that the
 * faces go round the vertex once in the picture. Then no two of them overlap: they share only the vertex or a side. */

/* Returns what was known before. */
static unsigned char mark(const crossing_filter *p, uint32_t vertex, unsigned char what)
{
    atomic_uchar *star = &p->star[vertex];
    if (!p->alone)
        return atomic_fetch_or_explicit(star, what, memory_order_relaxed);
    unsigned char before = atomic_load_explicit(star, memory_order_relaxed);
    atomic_store_explicit(star, (unsigned char)(before | what), memory_order_relaxed);
    return before;
}

/* A triangle goes round one of its corners if it extends from there on both sides of the direction +x. It has at most
 * one such corner. Its corners run counter-clockwise in the picture, or clockwise if the viewer sees its back. */
static void mark_round(const crossing_filter *p, const uint32_t *corner, bool back)
{
    const roberts_vec3 *P = p->fronts->P;
    const uint32_t a = corner[0], b = corner[back ? 2 : 1], c = corner[back ? 1 : 2];
    const double u = P[a].y, v = P[b].y, w = P[c].y;
    uint32_t round = v < u && u <= w ? a : w < v && v <= u ? b : u < w && w <= v ? c : ROBERTS_NONE;
    if (round != ROBERTS_NONE && mark(p, round, STAR_ONCE) & STAR_ONCE)
        mark(p, round, STAR_TWICE);
}

static void mark_face(const crossing_filter *p, uint32_t face)
{
    const roberts_scene *scene = p->fronts->scene;
    uint32_t first = scene->face_start[face], end = scene->face_start[face + 1];
    if (end - first == 3)
        mark_round(p, scene->corner + first, p->fronts->seen->facing[face] == VIEW_BACK);
    else
        for (uint32_t c = first; c < end; c++)
            mark(p, scene->corner[c], STAR_FOLD);
}

/* Leaves late faces to mark_late(). A body that does not cross itself needs no stars. */
static void mark_front(const crossing_filter *p, const hide_front *front)
{
    if (front->kind == HIDE_SURFACE_FACE && !filter_is_simple(p, front->solid) &&
        p->fronts->seen->facing[front->piece] != hide_late_facing(p->fronts, front->solid))
        mark_face(p, front->piece);
}

/* A face that is no front, because it is hidden, still belongs to the stars of its corners. */
static void mark_late(const crossing_filter *p, uint32_t body)
{
    const scene_solid *own = &p->fronts->scene->solid[body];
    const unsigned char late = filter_is_simple(p, body) ? VIEW_UNKNOWN : hide_late_facing(p->fronts, body);
    for (uint32_t face = own->face; late != VIEW_UNKNOWN && face < own[1].face; face++)
        if (p->fronts->seen->facing[face] == late)
            mark_face(p, face);
}

/* ---- where two fronts lie ---------------------------------------------------------------------------------------- */

bool filter_find_flat(const crossing_filter *p, uint32_t front)
{
    const roberts_scene *scene = p->fronts->scene;
    const scene_solid *s = &scene->solid[p->fronts->front[front].solid];
    const scene_edge *edge = scene->edge + s->stored, *end = edge + (s[1].edge - s->edge);
    while (edge < end && !seen_is_flat(scene, s->face, edge, p->fronts->seen->rules.crease_chord))
        edge++;
    unsigned char flat = edge < end ? FLAT_SOMEWHERE : FLAT_NOWHERE;
    atomic_store_explicit(&p->model[front].flat, flat, memory_order_relaxed);
    return edge < end;
}

static bool box_solids(void *context, size_t first, size_t end)
{
    const crossing_filter *p = context;
    for (size_t k = first; k < end; k++)
        p->model[k] = (model_box){face_pairs_body_box(p->fronts->scene, p->fronts->front[k].solid), FLAT_UNKNOWN};
    return true;
}

/* The fronts of a body follow one another: its box is measured once. */
static bool box_bodies(void *context, size_t first, size_t end)
{
    const crossing_filter *p = context;
    const hide_front *front = p->fronts->front;
    for (size_t k = first; k < end; k++) {
        const uint32_t body = p->by_front ? front[k].solid : (uint32_t)k;
        if (p->by_front && k > first && front[k - 1].solid == body)
            p->body[k] = p->body[k - 1];
        else if (!p->fronts->culled[body])
            p->body[k] = face_pairs_body_box(p->fronts->scene, body);
    }
    return true;
}

/* Marks the single faces, which follow the whole fronts. */
static bool mark_fronts(void *context, size_t first, size_t end)
{
    crossing_filter *p = context;
    for (size_t k = first; k < end; k++)
        mark_front(p, &p->fronts->front[p->fronts->whole_count + k]);
    return true;
}

static bool mark_all_late(void *context, size_t first, size_t end)
{
    for (size_t body = first; body < end; body++)
        mark_late(context, (uint32_t)body);
    return true;
}

/* If points have low parts, solids whose boxes of high parts just touch may overlap. */
bool filter_begin(crossing_filter *p, const hide_fronts *fronts, const objet *grid, int threads)
{
    const uint32_t bodies = fronts->scene->solid_count;
    const bool singles = fronts->front_count > fronts->whole_count, boxed = singles && bodies > 1;
    *p = (crossing_filter){.fronts = fronts, .touching = touching_distance(fronts)};
    if (singles && (grid->tree || fronts->seen->rules.hidden) &&
        !flat_patches_find(&p->flat, fronts->scene, fronts->space.epsilon, p->touching / fronts->scene->unit))
        return false;
    if (fronts->seen->rules.hidden)
        return true;
    p->star = grid->star;
    p->alone = threads == 1;
    p->whole = fronts->scene->low ? 0 : fronts->whole_count;
    p->model = alloc_array(p->whole, sizeof *p->model);
    p->by_front = !fronts->rear && fronts->front_count < bodies;
    const uint32_t boxes = p->by_front ? fronts->front_count : bodies;
    p->body = boxed ? alloc_array(boxes, sizeof *p->body) : NULL;
    if (!p->model || (boxed && !p->body))
        return false;
    threads_each(threads, p->whole, 0, box_solids, p);
    if (boxed)
        threads_each(threads, boxes, 0, box_bodies, p);
    if (!p->star)
        return true;
    threads_each(threads, fronts->front_count - fronts->whole_count, 0, mark_fronts, p);
    threads_each(threads, bodies, 16, mark_all_late, p);
    return true;
}

void filter_end(crossing_filter *p)
{
    free(p->model);
    free(p->body);
    flat_patches_free(&p->flat);
    *p = (crossing_filter){0};
}

/* A cell with fronts of more bodies is searched. */
#define FEW_BODIES 8

bool filter_apart_in_cell(const crossing_filter *p, const objet_entry *list, uint32_t count)
{
    uint32_t found[FEW_BODIES], bodies = 0;
    for (uint32_t k = 0; k < count; k++) {
        const uint32_t body = p->fronts->front[list[k].front].solid;
        uint32_t i = bodies;
        while (i > 0 && found[i - 1] != body)
            i--;
        if (i > 0)
            continue;
        if (bodies == FEW_BODIES || !filter_is_simple(p, body))
            return false;
        for (i = 0; i < bodies; i++)
            if (!(filter_gap(&p->body[found[i]], &p->body[body]) > p->touching))
                return false;
        found[bodies++] = body;
    }
    return true;
}

bool filter_single_boxes_apart(const crossing_filter *p, uint32_t a, uint32_t b)
{
    const hide_front *f = &p->fronts->front[a], *g = &p->fronts->front[b];
    if (p->body && filter_gap(&p->body[p->by_front ? a : f->solid], &p->body[p->by_front ? b : g->solid]) > p->touching)
        return true;
    if (!p->fronts->seen->view.perspective || !hide_is_face(f) || !hide_is_face(g))
        return false;
    const box3 F = face_pairs_box(p->fronts->scene, f->piece, f->piece + 1),
               G = face_pairs_box(p->fronts->scene, g->piece, g->piece + 1);
    return filter_gap(&F, &G) > p->touching;
}

/* ---- sides and planes between two fronts ------------------------------------------------------------------------- */

/* Faces with more corners are not tested. */
#define FEW_CORNERS 8

/* Do all corners of a face lie on the right of the side A -> B in the picture, or beyond it by no more than `most`? */
static bool is_right_of(const roberts_vec3 *P, roberts_vec3 A, roberts_vec3 B, const hide_face *f, double most)
{
    double dx = B.x - A.x, dy = B.y - A.y;
    for (uint32_t k = 0; k < f->count; k++)
        if (!(dx * (P[f->corner[k]].y - A.y) - dy * (P[f->corner[k]].x - A.x) <= most))
            return false;
    return true;
}

/* Does a side of f separate the two faces in the picture? A corner within rounding of the side may be on either side of
 * it. The picture of a face that is nearly edge-on may be turned, or cross itself, as far as its corners are not in one
 * plane. So f itself is tested as well. A side whose ends are one point of the picture separates nothing. */
static bool is_beside_a_side(const hide_fronts *fronts, const hide_face *f, const hide_face *g)
{
    const roberts_vec3 *P = fronts->P;
    double loose = FILTER_BESIDE * fronts->space.across_rounding;
    roberts_vec3 A = P[f->corner[f->count - 1]];
    for (uint32_t i = 0; i < f->count; i++) {
        roberts_vec3 B = P[f->corner[i]];
        double most = loose * (fabs(B.x - A.x) + fabs(B.y - A.y));
        if (most > 0.0 && is_right_of(P, A, B, g, most) && is_right_of(P, B, A, f, most))
            return true;
        A = B;
    }
    return false;
}

/* A side from u to v of one is a side from v to u of the other if both are wound alike, or else from u to v. */
bool filter_share_side(const roberts_scene *scene, uint32_t f, uint32_t g)
{
    const uint32_t *p = scene->corner + scene->face_start[f], *q = scene->corner + scene->face_start[g];
    const uint32_t m = scene->face_start[f + 1] - scene->face_start[f],
                   n = scene->face_start[g + 1] - scene->face_start[g];
    if (m > FEW_CORNERS || n > FEW_CORNERS)
        return false;
    for (uint32_t i = 0; i < m; i++) {
        uint32_t k = 0;
        while (k < n && q[k] != p[i])
            k++;
        const uint32_t next = p[i + 1 < m ? i + 1 : 0];
        if (k < n && (q[k + 1 < n ? k + 1 : 0] == next || q[k > 0 ? k - 1 : n - 1] == next))
            return true;
    }
    return false;
}

/* The corners of a piece. */
typedef struct ring {
    const uint32_t *v; /* [count] */
    uint32_t count;
    roberts_vec3 n; /* a normal of the plane of three corners */
} ring;

static ring ring_of(const roberts_scene *scene, uint32_t f)
{
    const uint32_t *v = scene->corner + scene->face_start[f];
    const roberts_vec3 A = scene->point[v[0]], AB = vec3_sub(scene->point[v[1]], A),
                       AC = vec3_sub(scene->point[v[2]], A);
    return (ring){v, scene->face_start[f + 1] - scene->face_start[f], vec3_cross(AB, AC)};
}

/* A direction in which a piece reaches farthest at some of its corners. */
typedef struct outward {
    roberts_vec3 along;
    const uint32_t *end; /* [ends] */
    uint32_t ends;
} outward;

static bool is_end(const outward *x, uint32_t v)
{
    uint32_t i = 0;
    while (i < x->ends && x->end[i] != v)
        i++;
    return i < x->ends;
}

/* Is g beyond f in that direction, farther than `touching`, except for corners at which f ends? */
static bool is_beyond(const roberts_vec3 *P, const ring *f, const ring *g, const outward *x, double touching)
{
    const roberts_vec3 A = P[x->end[0]];
    const double near = vec3_sum(x->along) * touching;
    double gap = INFINITY, bulge = 0.0; /* how far f extends beyond its ends, by rounding */
    for (uint32_t k = 0; k < g->count && gap > 0.0; k++) {
        const roberts_vec3 d = vec3_sub(P[g->v[k]], A);
        gap = is_end(x, g->v[k]) ? gap : lesser(gap, vec3_dot(x->along, d) - near - vec3_dot_error(x->along, d));
    }
    for (uint32_t k = 0; k < f->count && gap > bulge; k++) {
        const roberts_vec3 d = vec3_sub(P[f->v[k]], A);
        bulge = greater(bulge, vec3_dot(x->along, d) + vec3_dot_error(x->along, d));
    }
    return gap > bulge;
}

/* Is g on one side of the plane of f? If a side of g joins two corners of f, g may end on f there: it is no side of f,
 * since filter_share_side() has found none in common. */
static bool is_beside_plane(const roberts_vec3 *P, const ring *f, const ring *g, double touching)
{
    outward x = {f->n, f->v, f->count};
    uint32_t k = 0;
    for (uint32_t i = 0; i < g->count; i++)
        if (is_end(&x, g->v[i]) && is_end(&x, g->v[i + 1 < g->count ? i + 1 : 0]))
            return false;
    while (is_end(&x, g->v[k])) /* at most every other corner is one */
        k++;
    if (vec3_dot(f->n, vec3_sub(P[g->v[k]], P[f->v[0]])) < 0.0)
        x.along = vec3_scale(-1.0, f->n);
    return is_beyond(P, f, g, &x, touching);
}

/* Does a plane through a side of f, perpendicular to f, separate them? */
static bool is_beside_in_plane(const roberts_vec3 *P, const ring *f, const ring *g, double touching)
{
    for (uint32_t i = 0; i < f->count; i++) {
        const uint32_t end[] = {f->v[i], f->v[i + 1 < f->count ? i + 1 : 0]};
        const outward out = {vec3_cross(vec3_sub(P[end[1]], P[end[0]]), f->n), end, 2};
        if (is_beyond(P, f, g, &out, touching))
            return true;
    }
    return false;
}

bool filter_apart_in_space(const crossing_filter *p, uint32_t f, uint32_t g)
{
    const roberts_scene *scene = p->fronts->scene;
    const uint32_t *start = scene->face_start;
    if (start[f + 1] - start[f] > FEW_CORNERS || start[g + 1] - start[g] > FEW_CORNERS)
        return false;
    const ring F = ring_of(scene, f), G = ring_of(scene, g);
    const roberts_vec3 *P = scene->point;
    const double t = p->touching;
    return is_beside_plane(P, &F, &G, t) || is_beside_plane(P, &G, &F, t) || is_beside_in_plane(P, &F, &G, t) ||
           is_beside_in_plane(P, &G, &F, t);
}

bool filter_apart_in_picture(const hide_fronts *fronts, uint32_t a, uint32_t b)
{
    uint32_t turned[2][SEEN_TURNED] = {{0}};
    hide_face F = hide_outline(fronts, a, turned[0]), G = hide_outline(fronts, b, turned[1]);
    return F.count <= FEW_CORNERS && G.count <= FEW_CORNERS &&
           (is_beside_a_side(fronts, &F, &G) || is_beside_a_side(fronts, &G, &F));
}

/* A direction in the picture, and how far beside it a point may lie to count as on it, times its length. */
typedef struct ray {
    double x, y, loose;
} ray;

static ray ray_of(const hide_fronts *fronts, uint32_t from, uint32_t to)
{
    const roberts_vec3 *P = fronts->P;
    double x = P[to].x - P[from].x, y = P[to].y - P[from].y;
    return (ray){x, y, FILTER_BESIDE * fronts->space.across_rounding * (fabs(x) + fabs(y))};
}

static double turn_of_rays(const ray *a, const ray *b)
{
    return a->x * b->y - a->y * b->x;
}

/* Does a side of triangle f = (a, b), as seen from the common corner, separate it from g = (c, d)? */
bool filter_apart_at_corner(const hide_fronts *fronts, const uint32_t f[3], int i, const uint32_t g[3])
{
    uint32_t v = f[i];
    int k = g[0] == v ? 0 : g[1] == v ? 1 : 2;
    const ray a = ray_of(fronts, v, f[(i + 1) % 3]), b = ray_of(fronts, v, f[(i + 2) % 3]);
    const ray c = ray_of(fronts, v, g[(k + 1) % 3]), d = ray_of(fronts, v, g[(k + 2) % 3]);
    double ac = turn_of_rays(&a, &c), ad = turn_of_rays(&a, &d), bc = turn_of_rays(&b, &c), bd = turn_of_rays(&b, &d);
    double s = turn_of_rays(&a, &b) > 0.0 ? 1.0 : -1.0, t = turn_of_rays(&c, &d) > 0.0 ? 1.0 : -1.0;
    return (s * ac <= a.loose && s * ad <= a.loose) || (-s * bc <= b.loose && -s * bd <= b.loose) ||
           (-t * ac <= c.loose && -t * bc <= c.loose) || (t * ad <= d.loose && t * bd <= d.loose);
}
