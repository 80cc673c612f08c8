/* solid_edges.c - the edges of one solid and the two faces of each, sorted.
 *
 * Every side of a face is a half-edge. For a small solid, a table gives the face that passes from one vertex to
 * another, and the edges are read from it in order. All other half-edges, and those of small solids that are open or
 * inconsistently wound, are sorted: first into buckets by their smaller vertex, then by the larger one. For solids with
 * up to a dozen edges, the table takes a third of the instructions. */
#include "model/solid_edges.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/sort.h"
#include "base/vec.h"

enum { SHORT_BUCKET = 24 }; /* half-edges; up to this many, insertion sort beats qsort() */

/* Fills the table; bit b of row[a] tells whether a face passes from a to b. False if two do. */
static bool fill_table(const roberts_scene *scene, uint32_t s, uint32_t passing[][EDGES_SMALL], uint32_t *row)
{
    const uint32_t *start = scene->face_start + scene->solid[s].face, base = scene->solid[s].vertex;
    const uint32_t count = scene->solid[s + 1].face - scene->solid[s].face;
    for (uint32_t f = 0; f < count; f++) {
        const uint32_t *corner = scene->corner + start[f], *last = scene->corner + start[f + 1] - 1;
        for (uint32_t from = *last - base, to; corner <= last; corner++, from = to) {
            to = *corner - base;
            if (row[from] >> to & 1)
                return false;
            row[from] |= (uint32_t)1 << to;
            passing[from][to] = f;
        }
    }
    return true;
}

/* Pairs the half-edges of a small solid. False if they are not all pairs of opposite ones. */
static bool pair_by_table(const roberts_scene *scene, uint32_t s, edge_scratch *scratch)
{
    uint32_t row[EDGES_SMALL], count = scene->solid[s + 1].vertex - scene->solid[s].vertex;
    uint32_t(*passing)[EDGES_SMALL] = scratch->passing;
    scene_edge *edge = scratch->edge, *end = edge + scene_corners(scene, s) / 2;
    for (uint32_t v = 0; v < count; v++)
        row[v] = 0;
    if (!fill_table(scene, s, passing, row))
        return false;
    for (uint32_t v = 0; v < count; v++) {
        uint32_t w = v + 1;
        for (uint32_t up = row[v] >> v >> 1; up; up >>= 1, w++) {
            if (!(up & 1))
                continue;
            if (edge == end || !(row[w] >> v & 1))
                return false;
            edge->v[0] = v;
            edge->v[1] = w;
            edge->f[0] = passing[v][w];
            edge->f[1] = passing[w][v];
            edge++;
        }
    }
    return edge == end; /* half of the half-edges go upward, each with its opposite: none is left over */
}

static void sort_bucket(uint64_t *half, uint32_t count)
{
    if (count > SHORT_BUCKET) {
        qsort(half, count, sizeof *half, compare_u64);
        return;
    }
    SORT_FEW(uint64_t, half, count, *a > *b)
}

/* Counts the half-edges of each smaller vertex, and sets end[v] to the start of v's bucket. */
static void count_half_edges(const roberts_scene *scene, uint32_t s, uint32_t *end)
{
    const scene_solid *first = scene->solid + s;
    uint32_t count = first[1].vertex - first->vertex, sum = 0;
    memset(end, 0, count * sizeof *end);
    for (uint32_t f = first->face; f < first[1].face; f++) {
        const uint32_t *corner = scene->corner + scene->face_start[f];
        uint32_t n = scene->face_start[f + 1] - scene->face_start[f], from = corner[n - 1];
        for (uint32_t i = 0; i < n; from = corner[i++])
            end[(from < corner[i] ? from : corner[i]) - first->vertex]++;
    }
    for (uint32_t v = 0; v < count; v++) {
        uint32_t here = end[v];
        end[v] = sum;
        sum += here;
    }
}

bool edges_sort(const roberts_scene *scene, uint32_t s, edge_scratch *scratch)
{
    const scene_solid *first = scene->solid + s;
    uint32_t vertices = first[1].vertex - first->vertex, corners = scene_corners(scene, s), start = 0;
    uint32_t base = scene->face_start[first->face];
    if (!array_reserve(&scratch->end, &scratch->end_room, vertices, sizeof *scratch->end) ||
        !array_reserve(&scratch->half, &scratch->half_room, corners, sizeof *scratch->half) ||
        !array_reserve(&scratch->face_of, &scratch->face_of_room, corners, sizeof *scratch->face_of))
        return false;
    count_half_edges(scene, s, scratch->end);
    for (uint32_t f = first->face; f < first[1].face; f++) {
        uint32_t begin = scene->face_start[f], n = scene->face_start[f + 1] - begin;
        for (uint32_t i = 0; i < n; i++) {
            uint32_t a = scene->corner[begin + i] - first->vertex;
            uint32_t b = scene->corner[begin + (i + 1 == n ? 0 : i + 1)] - first->vertex;
            scratch->half[scratch->end[a < b ? a : b]++] = (uint64_t)(a < b ? b : a) << 32 | (begin + i - base);
            scratch->face_of[begin + i - base] = f - first->face;
        }
    }
    for (uint32_t v = 0; v < vertices; start = scratch->end[v++])
        sort_bucket(scratch->half + start, scratch->end[v] - start);
    return true;
}

/* Some edge does not have two faces: does each have an even number of them? */
static edge_pairing count_sorted(const edge_scratch *scratch, uint32_t vertices)
{
    for (uint32_t v = 0, i = 0; v < vertices; v++)
        for (uint32_t first = i; i < scratch->end[v]; first = i) {
            while (i < scratch->end[v] && scratch->half[i] >> 32 == scratch->half[first] >> 32)
                i++;
            if ((i - first) % 2)
                return EDGES_OPEN;
        }
    return EDGES_EVEN;
}

/* Makes edges from the sorted half-edges: each must have exactly one partner. */
static edge_pairing edges_from_sorted(const roberts_scene *scene, uint32_t s, edge_scratch *scratch)
{
    const scene_solid *first = scene->solid + s;
    uint32_t vertices = first[1].vertex - first->vertex, start = 0, base = scene->face_start[first->face], made = 0;
    scene_edge *edge = scratch->edge;
    bool mixed = false;
    for (uint32_t v = 0; v < vertices; start = scratch->end[v++])
        for (uint32_t i = start; i < scratch->end[v]; i += 2) {
            uint64_t a = scratch->half[i], b = i + 1 < scratch->end[v] ? scratch->half[i + 1] : 0;
            if (a >> 32 != b >> 32 || (i + 2 < scratch->end[v] && scratch->half[i + 2] >> 32 == a >> 32))
                return count_sorted(scratch, vertices);
            bool up_a = scene->corner[base + (uint32_t)a] - first->vertex == v;
            bool up_b = scene->corner[base + (uint32_t)b] - first->vertex == v;
            uint32_t fa = scratch->face_of[(uint32_t)a], fb = scratch->face_of[(uint32_t)b];
            edge[made] = (scene_edge){{v, (uint32_t)(a >> 32)}, {up_a ? fa : fb, up_a ? fb : fa}};
            scratch->alike[made++] = up_a == up_b;
            mixed |= up_a == up_b;
        }
    return mixed ? EDGES_MIXED : EDGES_PAIRED;
}

edge_pairing edges_pair(const roberts_scene *scene, uint32_t s, edge_scratch *scratch)
{
    uint32_t vertices = scene->solid[s + 1].vertex - scene->solid[s].vertex, corners = scene_corners(scene, s);
    if (corners % 2)
        return EDGES_OPEN;
    if (!array_reserve(&scratch->edge, &scratch->edge_room, corners / 2, sizeof *scratch->edge))
        return EDGES_NO_MEMORY;
    if (vertices <= EDGES_SMALL && pair_by_table(scene, s, scratch))
        return EDGES_PAIRED;
    if (!edges_sort(scene, s, scratch) ||
        !array_reserve(&scratch->alike, &scratch->alike_room, corners / 2, sizeof *scratch->alike))
        return EDGES_NO_MEMORY;
    return edges_from_sorted(scene, s, scratch);
}

void edge_scratch_free(edge_scratch *scratch)
{
    free(scratch->edge);
    free(scratch->end);
    free(scratch->half);
    free(scratch->face_of);
    free(scratch->alike);
    *scratch = (edge_scratch){0};
}
