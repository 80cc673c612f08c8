/* plain_edges.c - see plain_edges.h.
 *
 * In most meshes all faces are wound alike. Then not all sides need to be sorted. Each side that runs from a smaller to
 * a greater vertex makes an edge, in the bucket of its smaller vertex, and only these short buckets are sorted. Each
 * side that runs the other way completes one of these edges, or it is a border. In all other meshes the sides are
 * sorted. */
#include "model/plain_edges.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/sets.h"
#include "base/sort.h"

/* ---- faces that are wound alike -------------------------------------------------------------------------------- */

enum { SHORT_BUCKET = 24 };

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
    uint32_t base = scene->solid[s].vertex, vertices = scene->solid[s + 1].vertex - base, sum = 0;
    memset(p->start, 0, vertices * sizeof *p->start);
    for (uint32_t f = scene->solid[s].face; f < scene->solid[s + 1].face; f++) {
        const uint32_t *corner = scene->corner + scene->face_start[f], *end = scene->corner + scene->face_start[f + 1];
        for (uint32_t from = end[-1]; corner < end; from = *corner++)
            p->start[from - base] += from < *corner;
    }
    for (uint32_t v = 0; v < vertices; v++) {
        uint32_t here = p->start[v];
        p->start[v] = sum;
        sum += here;
    }
    return sum;
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
        if (count > SHORT_BUCKET)
            qsort(edge + begin, count, sizeof *edge, compare_edges);
        else
            SORT_FEW(scene_edge, edge + begin, count, a->v[1] > b->v[1])
        for (uint32_t i = begin + 1; i < begin + count; i++)
            different = different && edge[i].v[1] != edge[i - 1].v[1];
    }
    return different;
}

/* Returns the edge from v0 to v1; NULL: there is none. */
static inline scene_edge *find_plain_edge(const plain_edges *p, scene_edge *edge, uint32_t v0, uint32_t v1)
{
    uint32_t low = v0 > 0 ? p->start[v0 - 1] : 0, end = p->start[v0], high = end;
    while (high - low > SHORT_BUCKET) {
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
            p->parent[a < b ? b : a] = a < b ? a : b;
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

/* ---- other faces ------------------------------------------------------------------------------------------------ */

/* Lists all sides in p->half, sorted. False: no memory. */
static bool sort_sides(plain_edges *p, uint32_t s)
{
    const roberts_scene *scene = p->scene;
    uint32_t base = scene->solid[s].vertex, vertices = scene->solid[s + 1].vertex - base, first = scene->solid[s].face;
    uint32_t sum = 0;
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
        for (uint32_t v = 0; v < vertices && pass == 0; v++) {
            uint32_t here = p->start[v];
            p->start[v] = sum;
            sum += here;
        }
    }
    for (uint32_t v = 0, begin = 0; v < vertices; begin = p->start[v++]) {
        uint32_t count = p->start[v] - begin;
        if (count > SHORT_BUCKET)
            qsort(p->half + begin, count, sizeof *p->half, compare_u64);
        else
            SORT_FEW(uint64_t, p->half + begin, count, *a > *b)
    }
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
                p->parent[f < g ? g : f] = f < g ? f : g;
            }
        }
    return sets > 1 || (crowded && !odd) ? PLAIN_NO : PLAIN_YES;
}

plain_answer plain_edges_find(plain_edges *p, uint32_t s)
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

void plain_edges_free_scratch(plain_edges *p)
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

void plain_edges_free(plain_edges *p)
{
    plain_edges_free_scratch(p);
    free(p->edge);
    free(p->is);
    free(p->many);
    free(p->many_face);
    *p = (plain_edges){0};
}
