/* plain_bodies.c - see plain_bodies.h. First the edges of each body are found, then no vertex may touch a border, then
 * each face gets its plane, or each edge of a mesh its bend, and last the edges move to the scene.
 *
 * In most meshes all faces are wound alike. Then not all sides need to be sorted. Each side that runs from a smaller to
 * a greater vertex makes an edge, in the bucket of its smaller vertex, and only these short buckets are sorted. Each
 * side that runs the other way completes one of these edges, or it is a border. In all other meshes the sides are
 * sorted. */
#include "model/plain_bodies.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/bits.h"
#include "base/search.h"
#include "base/sets.h"
#include "base/sort.h"
#include "model/body_edges.h"
#include "model/face_pieces.h"
#include "model/surface.h"
#include "model/weld.h"

/* ---- edges, if all faces are wound alike ------------------------------------------------------------------------- */

/* The edges of some bodies, body by body, as the scene has them. Zeroed except for `scene`, it is empty. */
typedef struct plain_edges {
    const roberts_scene *scene;
    scene_edge *edge; /* [count] with two faces, or with one and f[1] == ROBERTS_NONE */
    uint8_t *is;      /* [count] EDGE_TURNED_..., EDGE_MANY */
    scene_many *many; /* [many_count] edges with more than two faces, by their places in `edge` */
    uint32_t *many_face;
    size_t count, many_count, many_faces;
    bool paired; /* all edges that were found last have two faces */
    /* scratch */
    uint32_t *start;    /* [vertices of a body] where the edges end of which this is the smaller vertex */
    uint32_t *parent;   /* [faces of a body] sets of faces that edges connect */
    uint64_t *half;     /* [sides of a body] larger vertex << 32 | face << 1 | turned */
    scene_edge *border; /* [border_count] edges with one face, f[1], on their right */
    size_t edge_room, is_room, start_room, parent_room, half_room, border_count, border_room, many_room, many_face_room;
} plain_edges;

static int compare_edges(const void *pa, const void *pb)
{
    const scene_edge *a = pa, *b = pb;
    if (a->v[0] != b->v[0])
        return a->v[0] < b->v[0] ? -1 : 1;
    return (a->v[1] > b->v[1]) - (a->v[1] < b->v[1]);
}

/* Counts the sides that run to a greater vertex; start[v] becomes the place where those from v begin. */
static uint32_t count_upward(const plain_edges *p, uint32_t s)
{
    const roberts_scene *scene = p->scene;
    uint32_t base = scene->solid[s].vertex, vertices = scene->solid[s + 1].vertex - base;
    memset(p->start, 0, vertices * sizeof *p->start);
    for (uint32_t f = scene->solid[s].face; f < scene->solid[s + 1].face; f++) {
        const uint32_t *corner = scene->corner + scene->face_start[f], *end = scene->corner + scene->face_start[f + 1];
        for (uint32_t from = end[-1]; corner < end; from = *corner++)
            p->start[from - base] += from < *corner;
    }
    return sort_starts(p->start, vertices);
}

/* Makes an edge of each side that runs to a greater vertex. False: two of them have the same ends. */
static bool make_edges(const plain_edges *p, uint32_t s, scene_edge *edge)
{
    const roberts_scene *scene = p->scene;
    uint32_t base = scene->solid[s].vertex, vertices = scene->solid[s + 1].vertex - base, first = scene->solid[s].face;
    bool different = true;
    for (uint32_t f = first; f < scene->solid[s + 1].face; f++) {
        const uint32_t *corner = scene->corner + scene->face_start[f], *end = scene->corner + scene->face_start[f + 1];
        for (uint32_t from = end[-1]; corner < end; from = *corner++)
            if (from < *corner)
                edge[p->start[from - base]++] = (scene_edge){{from - base, *corner - base}, {f - first, ROBERTS_NONE}};
    }
    for (uint32_t v = 0, begin = 0; v < vertices && different; begin = p->start[v++]) {
        uint32_t count = p->start[v] - begin;
        SORT_LIST(scene_edge, edge + begin, count, a->v[1] > b->v[1], compare_edges)
        for (uint32_t i = begin + 1; i < begin + count; i++)
            different = different && edge[i].v[1] != edge[i - 1].v[1];
    }
    return different;
}

/* Returns the edge from v0 to v1; NULL: there is none. */
static inline scene_edge *find_plain_edge(const plain_edges *p, scene_edge *edge, uint32_t v0, uint32_t v1)
{
    uint32_t low = v0 > 0 ? p->start[v0 - 1] : 0, end = p->start[v0], high = end;
    while (high - low > SORT_SHORT) {
        uint32_t middle = low + (high - low) / 2;
        if (edge[middle].v[1] < v1)
            low = middle + 1;
        else
            high = middle;
    }
    while (low < end && edge[low].v[1] < v1)
        low++;
    return low < end && edge[low].v[1] == v1 ? &edge[low] : NULL;
}

/* Completes the edges with the sides that run to a smaller vertex. Sides that complete no edge become borders. *sets:
 * number of sets of connected faces. *paired: number of edges with two faces. */
static plain_answer complete_edges(plain_edges *p, uint32_t s, scene_edge *edge, uint32_t *sets, uint32_t *paired)
{
    const roberts_scene *scene = p->scene;
    uint32_t base = scene->solid[s].vertex, first = scene->solid[s].face, faces = scene->solid[s + 1].face - first;
    *sets = faces;
    *paired = 0;
    for (uint32_t f = 0; f < faces; f++)
        p->parent[f] = f;
    for (uint32_t f = first; f < first + faces; f++) {
        const uint32_t *corner = scene->corner + scene->face_start[f], *end = scene->corner + scene->face_start[f + 1];
        for (uint32_t from = end[-1]; corner < end; from = *corner++) {
            if (from < *corner)
                continue;
            scene_edge *e = find_plain_edge(p, edge, *corner - base, from - base);
            if (!e) {
                if (!array_reserve(&p->border, &p->border_room, p->border_count + 1, sizeof *p->border))
                    return PLAIN_NO_MEMORY;
                p->border[p->border_count++] = (scene_edge){{*corner - base, from - base}, {ROBERTS_NONE, f - first}};
                continue;
            }
            if (e->f[1] != ROBERTS_NONE)
                return PLAIN_NO;
            e->f[1] = f - first;
            ++*paired;
            if (p->parent[f - first] == p->parent[e->f[0]])
                continue;
            uint32_t a = sets_root(p->parent, f - first), b = sets_root(p->parent, e->f[0]);
            *sets -= a != b;
            sets_join(p->parent, a, b);
        }
    }
    return PLAIN_YES;
}

/* Merges the borders into the `count` edges. False: two borders have the same ends. */
static bool merge_borders(plain_edges *p, scene_edge *edge, size_t count)
{
    size_t borders = p->border_count;
    if (borders > 1)
        qsort(p->border, borders, sizeof *p->border, compare_edges);
    for (size_t i = 1; i < borders; i++)
        if (compare_edges(&p->border[i - 1], &p->border[i]) == 0)
            return false;
    for (size_t to = count + borders; borders > 0;)
        if (count > 0 && compare_edges(&edge[count - 1], &p->border[borders - 1]) > 0)
            edge[--to] = edge[--count];
        else
            edge[--to] = p->border[--borders];
    return true;
}

/* Records on which side of its edge each face lies. A single face on the right becomes f[0]. */
static void note_sides(scene_edge *edge, uint8_t *is, size_t count, bool any_border)
{
    memset(is, EDGE_TURNED_1, count);
    for (size_t e = 0; any_border && e < count; e++)
        if (edge[e].f[0] == ROBERTS_NONE) {
            edge[e] = (scene_edge){{edge[e].v[0], edge[e].v[1]}, {edge[e].f[1], ROBERTS_NONE}};
            is[e] = EDGE_TURNED_0;
        } else if (edge[e].f[1] == ROBERTS_NONE) {
            is[e] = 0;
        }
}

static bool make_edge_room(plain_edges *p, size_t count)
{
    return array_reserve(&p->edge, &p->edge_room, p->count + count, sizeof *p->edge) &&
           array_reserve(&p->is, &p->is_room, p->count + count, 1) && p->count + count < ROBERTS_NONE;
}

/* Finds the edges of a solid whose faces are wound alike. *alike: whether they are, as far as is known. */
static plain_answer find_alike(plain_edges *p, uint32_t s, bool *alike)
{
    uint32_t sets, paired, upward = count_upward(p, s);
    p->border_count = 0;
    if (!make_edge_room(p, upward))
        return PLAIN_NO_MEMORY;
    *alike = make_edges(p, s, p->edge + p->count);
    plain_answer answer = *alike ? complete_edges(p, s, p->edge + p->count, &sets, &paired) : PLAIN_NO;
    *alike = *alike && answer != PLAIN_NO;
    if (answer != PLAIN_YES || sets > 1)
        return answer == PLAIN_YES ? PLAIN_NO : answer;
    size_t count = upward + p->border_count;
    if (!make_edge_room(p, count))
        return PLAIN_NO_MEMORY;
    *alike = merge_borders(p, p->edge + p->count, upward);
    if (!*alike)
        return PLAIN_NO;
    note_sides(p->edge + p->count, p->is + p->count, count, paired < count);
    p->paired = paired == count;
    p->count += count;
    return PLAIN_YES;
}

/* ---- edges of other faces ---------------------------------------------------------------------------------------- */

/* Lists all sides in p->half, sorted. False: no memory. */
static bool sort_sides(plain_edges *p, uint32_t s)
{
    const roberts_scene *scene = p->scene;
    uint32_t base = scene->solid[s].vertex, vertices = scene->solid[s + 1].vertex - base, first = scene->solid[s].face;
    if (!array_reserve(&p->half, &p->half_room, scene_corners(scene, s), sizeof *p->half))
        return false;
    memset(p->start, 0, vertices * sizeof *p->start);
    for (int pass = 0; pass < 2; pass++) {
        for (uint32_t f = first; f < scene->solid[s + 1].face; f++) {
            const uint32_t *corner = scene->corner + scene->face_start[f],
                           *end = scene->corner + scene->face_start[f + 1];
            for (uint32_t from = end[-1]; corner < end; from = *corner++) {
                bool turned = from > *corner;
                uint32_t lower = (turned ? *corner : from) - base, upper = (turned ? from : *corner) - base;
                if (pass == 0)
                    p->start[lower]++;
                else
                    p->half[p->start[lower]++] = (uint64_t)upper << 32 | (uint64_t)(f - first) << 1 | turned;
            }
        }
        if (pass == 0)
            sort_starts(p->start, vertices);
    }
    for (uint32_t v = 0, begin = 0; v < vertices; begin = p->start[v++])
        sort_short_list(p->half + begin, p->start[v] - begin);
    return true;
}

/* Do both faces have the same corners, in any order? */
static bool same_corners(const roberts_scene *scene, uint32_t f, uint32_t g)
{
    const uint32_t *a = scene->corner + scene->face_start[f], *b = scene->corner + scene->face_start[g];
    uint32_t count = scene->face_start[f + 1] - scene->face_start[f], found = 0;
    if (count != scene->face_start[g + 1] - scene->face_start[g])
        return false;
    for (uint32_t i = 0; i < count; i++)
        for (uint32_t k = 0; k < count; k++)
            found += a[i] == b[k];
    return found == count;
}

enum { MANY_MOST = 16 }; /* faces at an edge; comparing all pairs of more would take long */

/* Records the faces of an edge of more than two, none of which repeats another. */
static plain_answer add_many(plain_edges *p, uint32_t s, const uint64_t *half, uint32_t count)
{
    uint32_t first = p->scene->solid[s].face;
    if (count > MANY_MOST)
        return PLAIN_NO;
    for (uint32_t i = 1; i < count; i++)
        for (uint32_t k = 0; k < i; k++)
            if (same_corners(p->scene, first + ((uint32_t)half[i] >> 1), first + ((uint32_t)half[k] >> 1)))
                return PLAIN_NO;
    if (!array_reserve(&p->many, &p->many_room, p->many_count + 1, sizeof *p->many) ||
        !array_reserve(&p->many_face, &p->many_face_room, p->many_faces + count, sizeof *p->many_face))
        return PLAIN_NO_MEMORY;
    p->many[p->many_count++] =
        (scene_many){(uint32_t)p->count, (uint32_t)p->many_faces, (uint32_t)p->many_faces + count};
    for (uint32_t i = 0; i < count; i++)
        p->many_face[p->many_faces++] = (uint32_t)half[i] >> 1 | (half[i] & 1 ? MANY_TURNED : 0);
    return PLAIN_YES;
}

/* Makes an edge of sides with the same ends. */
static plain_answer add_plain_edge(plain_edges *p, uint32_t s, uint32_t v, const uint64_t *half, uint32_t count)
{
    scene_edge *edge = &p->edge[p->count];
    uint8_t is = half[0] & 1 ? EDGE_TURNED_0 : 0;
    plain_answer answer = count > 2 ? add_many(p, s, half, count) : PLAIN_YES;
    *edge = (scene_edge){{v, (uint32_t)(half[0] >> 32)}, {(uint32_t)half[0] >> 1, ROBERTS_NONE}};
    if (count > 1) {
        edge->f[1] = (uint32_t)half[1] >> 1;
        is |= half[1] & 1 ? EDGE_TURNED_1 : 0;
        answer = edge->f[0] == edge->f[1] ? PLAIN_NO : answer;
    }
    p->is[p->count++] = is | (count > 2 ? EDGE_MANY : 0);
    return answer;
}

static plain_answer find_sorted(plain_edges *p, uint32_t s)
{
    const roberts_scene *scene = p->scene;
    uint32_t vertices = scene->solid[s + 1].vertex - scene->solid[s].vertex;
    uint32_t faces = scene->solid[s + 1].face - scene->solid[s].face, sets = faces;
    bool odd = false, crowded = false;
    if (!sort_sides(p, s) || !make_edge_room(p, scene_corners(scene, s)))
        return PLAIN_NO_MEMORY;
    p->paired = true;
    for (uint32_t f = 0; f < faces; f++)
        p->parent[f] = f;
    for (uint32_t v = 0, i = 0, to; v < vertices; v++)
        for (; i < p->start[v]; i = to) {
            for (to = i + 1; to < p->start[v] && p->half[to] >> 32 == p->half[i] >> 32; to++)
                continue;
            plain_answer answer = add_plain_edge(p, s, v, p->half + i, to - i);
            if (answer != PLAIN_YES)
                return answer;
            p->paired = p->paired && to - i == 2;
            odd = odd || (to - i) % 2;
            crowded = crowded || to - i > 2;
            for (uint32_t k = i + 1; k < to; k++) {
                uint32_t f = sets_root(p->parent, (uint32_t)p->half[k - 1] >> 1);
                uint32_t g = sets_root(p->parent, (uint32_t)p->half[k] >> 1);
                sets -= f != g;
                sets_join(p->parent, f, g);
            }
        }
    return sets > 1 || (crowded && !odd) ? PLAIN_NO : PLAIN_YES;
}

/* Adds the edges of solid s. The answer is PLAIN_NO if edges do not connect all faces, or if a face may repeat another.
 * It is also PLAIN_NO if all edges have an even number of faces, and some more than two: these may be several solids
 * that touch. */
static plain_answer plain_edges_find(plain_edges *p, uint32_t s)
{
    const scene_solid *own = &p->scene->solid[s];
    uint32_t faces = own[1].face - own->face;
    bool alike = true;
    if (!array_reserve(&p->start, &p->start_room, own[1].vertex - own->vertex, sizeof *p->start) ||
        !array_reserve(&p->parent, &p->parent_room, faces, sizeof *p->parent))
        return PLAIN_NO_MEMORY;
    if (faces == 2 || faces >= 1u << 31)
        return PLAIN_NO;
    plain_answer answer = find_alike(p, s, &alike);
    return alike || answer == PLAIN_NO_MEMORY ? answer : find_sorted(p, s);
}

static void plain_edges_free_scratch(plain_edges *p)
{
    free(p->start);
    free(p->parent);
    free(p->half);
    free(p->border);
    p->start = p->parent = NULL;
    p->half = NULL;
    p->border = NULL;
    p->start_room = p->parent_room = p->half_room = p->border_count = p->border_room = 0;
}

static void plain_edges_free(plain_edges *p)
{
    plain_edges_free_scratch(p);
    free(p->edge);
    free(p->is);
    free(p->many);
    free(p->many_face);
    *p = (plain_edges){0};
}

/* ---- faces ------------------------------------------------------------------------------------------------------- */

typedef struct plain_work {
    roberts_scene *scene;
    const uint8_t *mark;
    face_rules rules;
    face_pieces pieces;
    plain_edges edges; /* of the bodies that are built here; those of repeated solids are stored already */
    uint32_t *first;   /* [solids] where each has them */
    uint32_t *count;   /* [solids] how many */
    uint8_t *open;     /* [solids] 1: some edge has not two faces */
    /* meshes only: */
    uint8_t *bend;      /* see scene_surface.bend */
    bend_count *smooth; /* [solids] */
    plane *plane;       /* of the faces of one body */
} plain_work;

/* Stores the plane of a face as bodies.c does: its normal points to the side from which the corners run clockwise. */
static void store_plane(roberts_scene *scene, uint32_t f, const fitted_plane *fit)
{
    roberts_vec3 P = vec3_sub(scene->point[scene->corner[scene->face_start[f]]], scene->centre);
    scene->face_plane[f] = (plane){-fit->n.x, -fit->n.y, -fit->n.z, vec3_dot(fit->n, P) + fit->mean * scene->unit};
    scene_set_bounds(scene, f, fit->deviation * scene->unit, fit->width * scene->unit);
}

/* Stores the plane of a face of four or more corners, if it is convex and planar. */
static plain_answer take_polygon(plain_work *w, uint32_t f)
{
    roberts_scene *scene = w->scene;
    const uint32_t *corner = scene->corner + scene->face_start[f];
    uint32_t count = scene->face_start[f + 1] - scene->face_start[f];
    face_pieces *p = &w->pieces;
    roberts_vec3 ring[PIECE_CORNERS];
    if (count > PIECE_CORNERS)
        return PLAIN_NO;
    if (!face_pieces_cut(p, &w->rules, corner, count))
        return PLAIN_NO_MEMORY;
    if (!p->planar || p->piece_count != 1 || p->piece[0].count != count)
        return PLAIN_NO;
    for (uint32_t i = 0; i < count; i++) {
        if (p->node[p->piece[0].node[i]].vertex != corner[i])
            return PLAIN_NO;
        ring[i] = vec3_scale(1.0 / scene->unit, vec3_sub(scene->point[corner[i]], scene->point[corner[0]]));
    }
    fitted_plane fit = face_plane_fit(ring, count);
    store_plane(scene, f, &fit);
    return PLAIN_YES;
}

/* Corner k of triangles f and g, relative to `origin` and in the scene's units. */
static inline two_vec3 corners_at(const roberts_scene *scene, uint32_t f, uint32_t g, uint32_t k)
{
    return two_vec3_of(&scene->point[scene->corner[scene->face_start[f] + k]],
                       &scene->point[scene->corner[scene->face_start[g] + k]]);
}

static inline two_vec3 scaled(two by, two_vec3 a)
{
    return (two_vec3){two_mul(by, a.x), two_mul(by, a.y), two_mul(by, a.z)};
}

/* The shapes of two triangles. */
typedef struct two_shapes {
    plane F, G;
    float deviation[2], width[2]; /* in the scene's unit */
} two_shapes;

/* Measures triangles f and g, which may be the same. False: one is too narrow to be a face. */
BITS_INLINE bool measure_triangles(const roberts_scene *scene, uint32_t f, uint32_t g, double narrow, two_shapes *to)
{
    two per_unit = two_all(1.0 / scene->unit), unit = two_all(scene->unit), minus = two_all(-1.0);
    two_vec3 origin = corners_at(scene, f, g, 0);
    two_planes fit = two_planes_of_triangles(scaled(per_unit, two_vec3_sub(corners_at(scene, f, g, 1), origin)),
                                             scaled(per_unit, two_vec3_sub(corners_at(scene, f, g, 2), origin)));
    if (fit.empty || two_at_most(two_mul(fit.width, unit), two_all(narrow)))
        return false;
    two_vec3 P = two_vec3_sub(origin, two_vec3_all(scene->centre));
    two_part(&to->F.a, &to->G.a, two_mul(minus, fit.n.x));
    two_part(&to->F.b, &to->G.b, two_mul(minus, fit.n.y));
    two_part(&to->F.c, &to->G.c, two_mul(minus, fit.n.z));
    two_part(&to->F.d, &to->G.d, two_add(two_vec3_dot(fit.n, P), two_mul(fit.mean, unit)));
    two_part_floats(&to->deviation[0], &to->deviation[1], two_mul(fit.deviation, two_all(SCENE_UPWARD)));
    two_part_floats(&to->width[0], &to->width[1], two_mul(fit.width, two_all(SCENE_DOWNWARD)));
    return true;
}

/* A triangle of solid s that is no wider than this is handled elsewhere. */
static inline double narrow_of(const plain_work *w, uint32_t s)
{
    return w->open[s] ? w->rules.touching : w->rules.narrow;
}

/* Stores the planes of triangles f and g, which may be the same. False: one is too narrow to be a face. */
static inline bool take_triangles(const plain_work *w, uint32_t f, uint32_t g, double narrow)
{
    roberts_scene *scene = w->scene;
    two_shapes found;
    if (!measure_triangles(scene, f, g, narrow, &found))
        return false;
    scene->face_plane[f] = found.F;
    scene->face_plane[g] = found.G;
    for (int i = 0; i < 2; i++) {
        scene->face_deviation[i == 0 ? f : g] = found.deviation[i];
        scene->face_width[i == 0 ? f : g] = found.width[i];
    }
    return true;
}

/* The face was wide enough before, so it is wide enough again. */
scene_shape scene_measure(const roberts_scene *scene, uint32_t face)
{
    two_shapes found = {0};
    measure_triangles(scene, face, face, 0.0, &found);
    return (scene_shape){found.F, scene->unit * (double)found.deviation[0], scene->unit * (double)found.width[0]};
}

/* Stores the planes of a solid's faces. */
static plain_answer take_faces(plain_work *w, uint32_t s)
{
    roberts_scene *scene = w->scene;
    const uint32_t *start = scene->face_start, end = scene->solid[s + 1].face;
    for (uint32_t f = scene->solid[s].face; f < end; f++) {
        if (start[f + 1] - start[f] > 3) {
            plain_answer answer = take_polygon(w, f);
            if (answer != PLAIN_YES)
                return answer;
            continue;
        }
        uint32_t g = f + 1 < end && start[f + 2] - start[f + 1] == 3 ? f + 1 : f;
        if (!take_triangles(w, f, g, narrow_of(w, s)))
            return PLAIN_NO;
        f = g;
    }
    return PLAIN_YES;
}

/* ---- open bodies ------------------------------------------------------------------------------------------------- */

/* Is the number of the edge's faces not two? */
static bool is_odd(const plain_edges *edges, uint32_t e)
{
    return edges->edge[e].f[1] == ROBERTS_NONE || edges->is[e] & EDGE_MANY;
}

/* Finds the edges of solid s. They are those of the first solid of its pattern. (But scene_many has the numbers of an
 * edge and of faces, which are not the same.) */
static plain_answer take_edges(plain_work *w, uint32_t s, uint32_t alike)
{
    if (w->count[alike] > 0 && w->edges.many_count == 0) {
        w->first[s] = w->first[alike];
        w->count[s] = w->count[alike];
        w->open[s] = w->open[alike];
        return PLAIN_YES;
    }
    uint32_t first = (uint32_t)w->edges.count;
    plain_answer answer = plain_edges_find(&w->edges, s);
    w->first[s] = first;
    w->count[s] = (uint32_t)w->edges.count - first;
    w->open[s] = !w->edges.paired;
    return answer;
}

/* Does no vertex of the grid touch the edge from a to b, except its ends, and are these apart? */
static plain_answer is_clear(const plain_work *w, const point_grid *grid, uint32_t a, uint32_t b, point_list *found)
{
    const roberts_vec3 *point = w->scene->point;
    found->count = 0;
    if (vec3_compare(point[a], point[b]) == 0)
        return PLAIN_NO;
    if (!point_grid_near(grid, point[a], point[b], w->rules.touching, found))
        return PLAIN_NO_MEMORY;
    for (size_t i = 0; i < found->count; i++) {
        uint32_t v = found->item[i];
        double t;
        if (v != a && v != b && surface_touches(point[a], point[b], point[v], w->rules.touching, &t) != TOUCHES_NOT)
            return PLAIN_NO;
    }
    return PLAIN_YES;
}

/* Is that so for the triangle with the vertices a, a + 1 and a + 2? Their own distances are plain if the least height
 * is. */
static plain_answer is_clear_triangle(const plain_work *w, const point_grid *grid, uint32_t a, point_list *found)
{
    const roberts_vec3 *p = w->scene->point + a;
    const roberts_vec3 AB = vec3_sub(p[1], p[0]), AC = vec3_sub(p[2], p[0]), BC = vec3_sub(p[2], p[1]);
    const double longest = greater(vec3_dot(BC, BC), greater(vec3_dot(AB, AB), vec3_dot(AC, AC)));
    const roberts_vec3 cross = vec3_cross(AB, AC);
    const bool plain = vec3_dot(cross, cross) > 4.0 * w->rules.touching * w->rules.touching * longest;
    found->count = 0;
    if (!point_grid_near_triangle(grid, p[0], p[1], p[2], w->rules.touching, found))
        return PLAIN_NO_MEMORY;
    for (size_t i = 0; i < found->count; i++) {
        const uint32_t v = found->item[i];
        if (plain && v - a < 3)
            continue;
        for (uint32_t k = 0; k < 3; k++) {
            const uint32_t l = (k + 1) % 3;
            double t;
            if (v != a + k && v != a + l &&
                surface_touches(p[k], p[l], w->scene->point[v], w->rules.touching, &t) != TOUCHES_NOT)
                return PLAIN_NO;
        }
    }
    return PLAIN_YES;
}

/* The vertices of open bodies. */
typedef struct open_vertices {
    unsigned char *is; /* [vertex_count] OPEN_... */
    uint32_t *vertex;  /* [count] the ends of odd edges, ascending; or all of them */
    uint32_t *first;   /* [vertex_count + 1] of a vertex that leads: where in plain_edges.edge its edges begin; the next
                          vertex has their end */
    size_t count;
} open_vertices;

enum {
    OPEN_END = 1,   /* of an odd edge */
    OPEN_LEADS = 2, /* the smaller vertex of one */
    OPEN_LOOSE = 4, /* the first vertex of a loose triangle */
};

/* Lists all vertices of open bodies, or only the ends of their odd edges. */
static void list_open(const plain_work *w, open_vertices *o, bool all)
{
    const scene_solid *solid = w->scene->solid;
    o->count = 0;
    for (uint32_t s = 0; s < w->scene->solid_count; s++)
        for (uint32_t v = solid[s].vertex; w->open[s] && v < solid[s + 1].vertex; v++)
            if (all || o->is[v] & OPEN_END)
                o->vertex[o->count++] = v;
}

/* Finds the ends of the odd edges of an open body, and where the edges of each vertex begin. Returns the number of its
 * vertices that are no such ends. */
static size_t find_ends_of(const plain_work *w, open_vertices *o, uint32_t s)
{
    const scene_edge *edge = w->edges.edge;
    const scene_solid *own = &w->scene->solid[s];
    const uint32_t end = w->first[s] + w->count[s];
    size_t others = own[1].vertex - own->vertex;
    for (uint32_t v = own->vertex, e = w->first[s]; v < own[1].vertex; v++) {
        for (o->first[v] = e; e < end && edge[e].v[0] == v - own->vertex; e++)
            if (is_odd(&w->edges, e)) {
                o->is[v] |= OPEN_END | OPEN_LEADS;
                o->is[own->vertex + edge[e].v[1]] |= OPEN_END;
            }
        others -= o->is[v] & OPEN_END;
    }
    return others;
}

/* The same for all of them. Loose triangles are marked instead: their edges are known. */
static size_t find_ends(const plain_work *w, open_vertices *o)
{
    size_t others = 0;
    for (uint32_t s = 0; s < w->scene->solid_count; s++) {
        const scene_solid *own = &w->scene->solid[s];
        if (!w->open[s])
            continue;
        if (own[1].vertex - own->vertex != 3 || own[1].face - own->face != 1) {
            others += find_ends_of(w, o, s);
            continue;
        }
        o->is[own->vertex] = OPEN_LOOSE | OPEN_END;
        o->is[own->vertex + 1] = o->is[own->vertex + 2] = OPEN_END;
    }
    return others;
}

/* Data is prefetched this many edges ahead. */
#define EDGES_AHEAD 8

/* Prefetches what ask_edges() needs of the vertices behind place k. */
static inline void fetch_edges(const plain_work *w, const point_grid *grid, const open_vertices *o, size_t k)
{
    const scene_edge *edge = w->edges.edge;
    const roberts_vec3 *point = w->scene->point;
    const size_t left = o->count - k;
    const grid_point *item = grid->item + k;
    if (left > 4 * EDGES_AHEAD)
        FETCH_AHEAD(&o->is[item[4 * EDGES_AHEAD].number]);
    if (left > 3 * EDGES_AHEAD && o->is[item[3 * EDGES_AHEAD].number] & OPEN_LEADS)
        FETCH_AHEAD(&o->first[item[3 * EDGES_AHEAD].number]);
    if (left > 2 * EDGES_AHEAD) {
        uint32_t u = item[2 * EDGES_AHEAD].number;
        if (o->is[u] & OPEN_LEADS)
            FETCH_AHEAD(&edge[o->first[u]]);
        if (o->is[u] & (OPEN_LEADS | OPEN_LOOSE))
            FETCH_ARRAY(&point[u], 3 * sizeof *point);
    }
    if (left > EDGES_AHEAD && o->is[item[EDGES_AHEAD].number] & OPEN_LEADS) {
        uint32_t u = item[EDGES_AHEAD].number;
        for (uint32_t e = o->first[u]; e < o->first[u + 1]; e++)
            FETCH_AHEAD(&point[u - edge[e].v[0] + edge[e].v[1]]);
    }
}

/* Does no end of an odd edge touch an odd edge that begins at v? */
static plain_answer ask_edges_of(const plain_work *w, const point_grid *grid, const open_vertices *o, uint32_t v,
                                 point_list *found)
{
    const scene_edge *edge = w->edges.edge;
    plain_answer answer = PLAIN_YES;
    for (uint32_t e = o->first[v]; e < o->first[v + 1] && answer == PLAIN_YES; e++)
        if (is_odd(&w->edges, e))
            answer = is_clear(w, grid, v, v - edge[e].v[0] + edge[e].v[1], found);
    return answer;
}

/* Does no end of an odd edge touch another odd edge? Edges are taken cell by cell, so that what one edge has read is
 * still in the cache for the next. */
static plain_answer ask_edges(const plain_work *w, const point_grid *grid, const open_vertices *o)
{
    point_list found = {0};
    plain_answer answer = PLAIN_YES;
    for (size_t k = 0; answer == PLAIN_YES && k < o->count; k++) {
        uint32_t v = grid->item[k].number;
        fetch_edges(w, grid, o, k);
        if (o->is[v] & OPEN_LOOSE)
            answer = is_clear_triangle(w, grid, v, &found);
        else if (o->is[v] & OPEN_LEADS)
            answer = ask_edges_of(w, grid, o, v, &found);
    }
    free(found.item);
    return answer;
}

/* Vertices that are compared before the edges are asked. In a file that gives each face its own vertices, some of these
 * are equal. */
#define FEW_VERTICES 4096

/* Do no two of the first `count` vertices have the same position? Otherwise the bodies have to be welded. */
static plain_answer are_apart(const plain_work *w, const open_vertices *o, size_t count)
{
    bool equal = false;
    if (!weld_any_equal(o->vertex, count, w->scene->point, &equal))
        return PLAIN_NO_MEMORY;
    return equal ? PLAIN_NO : PLAIN_YES;
}

/* Are the vertices of open bodies apart, and does no end of an odd edge touch another odd edge? If all vertices are
 * such ends, the second question answers the first. */
static plain_answer are_clear(const plain_work *w)
{
    const size_t vertices = w->scene->vertex_count;
    open_vertices o = {.is = alloc_zeroed(vertices, 1),
                       .vertex = alloc_array(vertices, sizeof *o.vertex),
                       .first = alloc_array(vertices + 1, sizeof *o.first)};
    point_grid grid = {0};
    plain_answer answer = o.is && o.vertex && o.first ? PLAIN_YES : PLAIN_NO_MEMORY;
    if (answer == PLAIN_YES) {
        bool all = find_ends(w, &o) > 0;
        list_open(w, &o, true);
        answer = are_apart(w, &o, all || o.count < FEW_VERTICES ? o.count : FEW_VERTICES);
        if (all)
            list_open(w, &o, false);
    }
    if (answer == PLAIN_YES && o.count > 0)
        answer =
            point_grid_build(&grid, w->scene->point, o.vertex, o.count) ? ask_edges(w, &grid, &o) : PLAIN_NO_MEMORY;
    point_grid_free(&grid);
    free(o.is);
    free(o.vertex);
    free(o.first);
    return answer;
}

/* ---- the scene --------------------------------------------------------------------------------------------------- */

/* Moves the edges to the scene, behind those that it has already. */
static bool join_edges(plain_work *w)
{
    roberts_scene *scene = w->scene;
    scene_edge *own = w->edges.edge;
    size_t used = scene->shared, count = w->edges.count;
    for (uint32_t s = 0; s < scene->solid_count; s++)
        if (w->count[s] == 0 && scene->solid[s].stored >= scene->shared)
            used = scene->solid[s].stored + (size_t)scene_corners(scene, s) / 2;
    if (count == 0 || used + count >= ROBERTS_NONE)
        return count == 0;
    if (used == 0) {
        free(scene->edge);
        scene->edge = own;
        w->edges.edge = NULL;
    }
    void *edge = realloc(scene->edge, (used + count) * sizeof *scene->edge);
    if (!edge)
        return false;
    scene->edge = edge;
    if (used > 0)
        memcpy(scene->edge + used, own, count * sizeof *own);
    for (uint32_t s = 0; s < scene->solid_count; s++)
        if (w->count[s] > 0)
            scene->solid[s].stored = (uint32_t)used + w->first[s];
    return true;
}

/* Moves the lists of edges with more than two faces to the scene. They come body by body. */
static void join_many(plain_work *w)
{
    const roberts_scene *scene = w->scene;
    plain_edges *from = &w->edges;
    scene_surface *to = scene->surface;
    uint32_t s = 0;
    for (size_t i = 0; i < from->many_count; i++) {
        scene_many *many = &from->many[i];
        while (w->count[s] == 0 || many->edge >= w->first[s] + w->count[s])
            s++;
        many->edge = scene->solid[s].edge + (many->edge - w->first[s]);
        for (uint32_t k = many->first; k < many->end; k++)
            from->many_face[k] += scene->solid[s].face;
    }
    to->many = from->many;
    to->many_face = from->many_face;
    to->many_count = (uint32_t)from->many_count;
    from->many = NULL;
    from->many_face = NULL;
}

/* Planes are stored unless bodies have this many faces, on average. */
#define MESH_FACES 8

/* Are all faces triangles of bodies that are not convex, and the bodies meshes? In a soup of loose faces, nearly every
 * plane that is needed once is needed again. */
static bool is_triangle_mesh(const plain_work *w)
{
    const roberts_scene *scene = w->scene;
    if (scene->face_count / MESH_FACES < scene->solid_count)
        return false;
    for (uint32_t s = 0; s < scene->solid_count; s++)
        if (!w->mark[s])
            return false;
    return scene->corner_count == 3 * (size_t)scene->face_count;
}

/* Frees the planes, which can be computed again. */
static void drop_planes(roberts_scene *scene)
{
    free(scene->face_plane);
    free(scene->face_deviation);
    free(scene->face_width);
    scene->face_plane = NULL;
    scene->face_deviation = scene->face_width = NULL;
}

/* Returns the number of edges of solid s. */
static uint32_t edges_of(const plain_work *w, uint32_t s)
{
    return w->count[s] > 0 ? w->count[s] : scene_corners(w->scene, s) / 2;
}

/* Finds the planes of the faces of solid s. False: one is too narrow. */
static BITS_PER_PROCESSOR bool take_planes(plain_work *w, uint32_t s)
{
    const roberts_scene *scene = w->scene;
    const uint32_t first = scene->solid[s].face, count = scene->solid[s + 1].face - first;
    const double narrow = narrow_of(w, s);
    for (uint32_t f = 0; f < count; f += 2) {
        const uint32_t g = f + 1 < count ? f + 1 : f;
        two_shapes found;
        if (!measure_triangles(scene, first + f, first + g, narrow, &found))
            return false;
        w->plane[f] = found.F;
        w->plane[g] = found.G;
    }
    return true;
}

/* Finds the bends at the edges of solid s, which begin at bend[0]. False: a face is too narrow. */
static BITS_PER_PROCESSOR bool take_bends(plain_work *w, uint32_t s, uint8_t *bend)
{
    const roberts_scene *scene = w->scene;
    bool own = w->count[s] > 0;
    const scene_edge *edge = own ? w->edges.edge + w->first[s] : scene->edge + scene->solid[s].stored;
    if (!take_planes(w, s))
        return false;
    for (uint32_t e = 0, count = edges_of(w, s); e < count; e++) {
        uint8_t is = own ? w->edges.is[w->first[s] + e] : EDGE_TURNED_1;
        bend[e] = 0;
        if (edge[e].f[1] == ROBERTS_NONE || is & EDGE_MANY)
            continue;
        double own_bend = scene_bend(w->plane[edge[e].f[0]], w->plane[edge[e].f[1]], is);
        bend[e] = scene_bend_code(own_bend);
        bend_count_add(&w->smooth[s], own_bend);
    }
    return true;
}

/* Finds the bends at all edges, in place of the planes. */
static plain_answer take_mesh(plain_work *w)
{
    const scene_solid *solid = w->scene->solid;
    size_t count = 0;
    uint32_t faces = 0;
    for (uint32_t s = 0; s < w->scene->solid_count; s++) {
        count += edges_of(w, s);
        faces = solid[s + 1].face - solid[s].face > faces ? solid[s + 1].face - solid[s].face : faces;
    }
    w->bend = alloc_array(count, sizeof *w->bend);
    w->smooth = alloc_zeroed(w->scene->solid_count, sizeof *w->smooth);
    drop_planes(w->scene);
    w->plane = alloc_array(faces, sizeof *w->plane);
    if (!w->bend || !w->smooth || !w->plane)
        return PLAIN_NO_MEMORY;
    count = 0;
    for (uint32_t s = 0; s < w->scene->solid_count; count += edges_of(w, s++))
        if (!take_bends(w, s, w->bend + count))
            return PLAIN_NO;
    return PLAIN_YES;
}

/* Numbers the edges, and fills the arrays that only scenes with such bodies have. */
static bool fill_surface(plain_work *w)
{
    roberts_scene *scene = w->scene;
    scene_surface *to = scene->surface = alloc_zeroed(1, sizeof *to);
    uint64_t sum = 0;
    for (uint32_t s = 0; s < scene->solid_count; s++) {
        scene->solid[s].edge = (uint32_t)sum;
        sum += edges_of(w, s);
        if (sum >= ROBERTS_NONE)
            return false;
    }
    scene->solid[scene->solid_count].edge = scene->edge_count = (uint32_t)sum;
    if (!to || !(to->kind = alloc_zeroed(scene->solid_count, 1)) ||
        !(to->smooth = alloc_zeroed(scene->solid_count, 1)) || !(to->edge_is = alloc_zeroed(scene->edge_count, 1)))
        return false;
    for (uint32_t s = 0; s < scene->solid_count; s++) {
        to->kind[s] = ROBERTS_CONVEX;
        if (!w->mark[s])
            continue;
        to->kind[s] = w->open[s] ? ROBERTS_OPEN : ROBERTS_CLOSED;
        uint8_t *is = to->edge_is + scene->solid[s].edge;
        if (w->count[s] > 0)
            memcpy(is, w->edges.is + w->first[s], w->count[s]);
        else
            memset(is, EDGE_TURNED_1, scene->solid[s + 1].edge - scene->solid[s].edge);
        if (!body_find_smooth(scene, s, w->bend ? &w->smooth[s] : NULL))
            return false;
    }
    join_many(w);
    to->bend = w->bend;
    w->bend = NULL;
    return true;
}

plain_answer plain_bodies_build(roberts_scene *scene, const uint8_t *mark, const repeated_solids *list,
                                const face_rules *rules)
{
    plain_work w = {.scene = scene,
                    .mark = mark,
                    .rules = *rules,
                    .edges = {.scene = scene},
                    .first = alloc_zeroed(scene->solid_count, sizeof *w.first),
                    .count = alloc_zeroed(scene->solid_count, sizeof *w.count),
                    .open = alloc_zeroed(scene->solid_count, 1)};
    plain_answer answer = w.first && w.count && w.open ? PLAIN_YES : PLAIN_NO_MEMORY;
    w.rules.point = scene->point;
    for (uint32_t s = 0; answer == PLAIN_YES && s < scene->solid_count; s++) {
        if (!mark[s])
            continue;
        for (uint32_t f = scene->solid[s].face; f < scene->solid[s + 1].face; f++)
            if (scene->turned[f])
                scene_turn_face(scene, f); /* restore the corners of the file */
        if (scene->solid[s].stored >= scene->shared)
            answer = take_edges(&w, s, list->item[list->of[s]].solid);
    }
    plain_edges_free_scratch(&w.edges);
    if (answer == PLAIN_YES)
        answer = are_clear(&w);
    bool mesh = answer == PLAIN_YES && is_triangle_mesh(&w);
    if (mesh)
        answer = take_mesh(&w);
    for (uint32_t s = 0; answer == PLAIN_YES && !mesh && s < scene->solid_count; s++)
        if (mark[s])
            answer = take_faces(&w, s);
    if (answer == PLAIN_YES && !(join_edges(&w) && fill_surface(&w)))
        answer = PLAIN_NO_MEMORY;
    face_pieces_free(&w.pieces);
    plain_edges_free(&w.edges);
    free(w.first);
    free(w.count);
    free(w.open);
    free(w.bend);
    free(w.smooth);
    free(w.plane);
    return answer;
}
