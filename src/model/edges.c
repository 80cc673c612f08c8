/* edges.c - the edges of one solid and the two faces of each, sorted, in linear time.
 *
 * Idea: every side of a face is a half-edge. They are counted into buckets by their smaller vertex, each bucket is
 * sorted by the larger one, and the two faces of an edge then stand next to each other. */
#include "model/edges.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"

enum { SHORT_BUCKET = 24 }; /* half-edges; up to so many, insertion beats the library's sort */

/* A half-edge is one number, so that sorting is comparing: the larger vertex, the face, and (lowest bit) whether the
 * face passes the edge downward. Vertices and faces count from the solid's first; a face has three corners, so that
 * face numbers stay below 2^31. */
static uint64_t half_edge(uint32_t from, uint32_t to, uint32_t face)
{
    return (uint64_t)(from < to ? to : from) << 32 | (uint64_t)face << 1 | (from > to);
}

static int compare_half(const void *a, const void *b)
{
    uint64_t x, y;
    memcpy(&x, a, sizeof x);
    memcpy(&y, b, sizeof y);
    return (x > y) - (x < y);
}

static void sort_bucket(uint64_t *half, uint32_t count)
{
    if (count > SHORT_BUCKET) {
        qsort(half, count, sizeof *half, compare_half);
        return;
    }
    for (uint32_t i = 1; i < count; i++) {
        uint64_t moving = half[i];
        uint32_t j = i;
        for (; j > 0 && half[j - 1] > moving; j--)
            half[j] = half[j - 1];
        half[j] = moving;
    }
}

/* Fills scratch->half, bucket by bucket; afterwards first[v] is the end of v's bucket. */
static void collect(const roberts_scene *scene, const scene_solid *first, const scene_solid *end, edge_scratch *scratch)
{
    uint32_t count = end->vertex - first->vertex, sum = 0;
    memset(scratch->first, 0, count * sizeof *scratch->first);
    for (uint32_t f = first->face; f < end->face; f++) {
        const uint32_t *corner = scene->corner + scene->face_start[f];
        uint32_t n = scene->face_start[f + 1] - scene->face_start[f], from = corner[n - 1];
        for (uint32_t i = 0; i < n; from = corner[i++])
            scratch->first[(from < corner[i] ? from : corner[i]) - first->vertex]++;
    }
    for (uint32_t v = 0; v < count; v++) {
        uint32_t here = scratch->first[v];
        scratch->first[v] = sum;
        sum += here;
    }
    for (uint32_t f = first->face; f < end->face; f++) {
        const uint32_t *corner = scene->corner + scene->face_start[f];
        uint32_t n = scene->face_start[f + 1] - scene->face_start[f], from = corner[n - 1];
        for (uint32_t i = 0; i < n; from = corner[i++]) {
            uint32_t least = (from < corner[i] ? from : corner[i]) - first->vertex;
            scratch->half[scratch->first[least]++] =
                half_edge(from - first->vertex, corner[i] - first->vertex, f - first->face);
        }
    }
}

/* One bucket: pairs of half-edges to edges. Returns how many, or UINT32_MAX where a half-edge has not one partner. */
static uint32_t pair_bucket(const uint64_t *half, uint32_t count, uint32_t v, const scene_solid *first,
                            scene_edge *edge, bool *mixed)
{
    if (count % 2)
        return UINT32_MAX;
    for (uint32_t i = 0; i < count; i += 2) {
        uint64_t a = half[i], b = half[i + 1];
        if (a >> 32 != b >> 32 || (i + 2 < count && half[i + 2] >> 32 == a >> 32))
            return UINT32_MAX;
        uint32_t fa = first->face + ((uint32_t)a >> 1), fb = first->face + ((uint32_t)b >> 1);
        edge->v[0] = first->vertex + v;
        edge->v[1] = first->vertex + (uint32_t)(a >> 32);
        edge->f[0] = a & 1 ? fb : fa;
        edge->f[1] = a & 1 ? fa : fb;
        *mixed |= (a & 1) == (b & 1);
        edge++;
    }
    return count / 2;
}

edge_pairing edges_pair(roberts_scene *scene, const scene_solid *first, const scene_solid *end, edge_scratch *scratch)
{
    uint32_t vertices = end->vertex - first->vertex, start = 0;
    uint32_t corners = scene->face_start[end->face] - scene->face_start[first->face];
    scene_edge *edge = scene->edge + first->edge;
    bool mixed = false;
    if (!array_reserve(&scratch->first, &scratch->first_room, vertices, sizeof *scratch->first) ||
        !array_reserve(&scratch->half, &scratch->half_room, corners, sizeof *scratch->half))
        return EDGES_NO_MEMORY;
    if (corners % 2)
        return EDGES_OPEN;
    collect(scene, first, end, scratch);
    for (uint32_t v = 0; v < vertices; v++) {
        uint32_t count = scratch->first[v] - start;
        sort_bucket(scratch->half + start, count);
        uint32_t made = pair_bucket(scratch->half + start, count, v, first, edge, &mixed);
        if (made == UINT32_MAX)
            return EDGES_OPEN;
        edge += made;
        start += count;
    }
    return mixed ? EDGES_MIXED : EDGES_PAIRED;
}

void edge_scratch_free(edge_scratch *scratch)
{
    free(scratch->first);
    free(scratch->half);
    *scratch = (edge_scratch){0};
}
