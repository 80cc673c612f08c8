/* edges.c - the edges of one solid and the two faces of each, sorted.
 *
 * Idea: every side of a face is a half-edge. Each smaller vertex has a short list of its edges, ordered by the larger
 * one; a half-edge takes its place there or meets its partner. Where that does not work out (a vertex with very many
 * edges, an open solid, mixed winding) all half-edges are sorted instead: counted into buckets by their smaller vertex,
 * each bucket sorted by the larger one. Compared with sorting always, the lists save half of the instructions. */
#include "model/edges.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"

enum {
    SHORT_BUCKET = 24, /* half-edges; up to so many, insertion beats the library's sort */
    STEPS = 8,         /* list nodes passed per half-edge, on the average, before the lists are given up */
};

static uint32_t corners_of(const roberts_scene *scene, uint32_t s)
{
    return scene->face_start[scene->solid[s + 1].face] - scene->face_start[scene->solid[s].face];
}

/* Puts all half-edges into the lists. False where they do not make up pairs of opposite ones, or that takes long. */
static bool fill_lists(const roberts_scene *scene, uint32_t s, edge_scratch *scratch)
{
    const scene_solid *first = scene->solid + s;
    uint32_t nodes = 0, most = corners_of(scene, s) / 2;
    uint64_t steps = 0, allowed = STEPS * (uint64_t)corners_of(scene, s);
    memset(scratch->head, 0xff, (first[1].vertex - first->vertex) * sizeof *scratch->head);
    for (uint32_t f = first->face; f < first[1].face; f++) {
        const uint32_t *corner = scene->corner + scene->face_start[f];
        uint32_t n = scene->face_start[f + 1] - scene->face_start[f], from = corner[n - 1] - first->vertex;
        for (uint32_t i = 0; i < n; i++) {
            uint32_t to = corner[i] - first->vertex, larger = from < to ? to : from;
            uint32_t *link = &scratch->head[from < to ? from : to];
            edge_node *node;
            for (; *link != ROBERTS_NONE && scratch->node[*link].to < larger; steps++)
                link = &scratch->node[*link].next;
            if (*link == ROBERTS_NONE || scratch->node[*link].to != larger) {
                if (nodes == most)
                    return false;
                scratch->node[nodes] = (edge_node){larger, *link, {ROBERTS_NONE, ROBERTS_NONE}};
                *link = nodes++;
            }
            node = &scratch->node[*link];
            if (node->f[from > to] != ROBERTS_NONE || steps > allowed)
                return false;
            node->f[from > to] = f;
            from = to;
        }
    }
    return nodes == most; /* and so, by counting, every edge has met both of its faces */
}

static void edges_from_lists(roberts_scene *scene, uint32_t s, const edge_scratch *scratch)
{
    const scene_solid *first = scene->solid + s;
    scene_edge *edge = scene->edge + first->edge;
    for (uint32_t v = 0; v < first[1].vertex - first->vertex; v++)
        for (uint32_t i = scratch->head[v]; i != ROBERTS_NONE; i = scratch->node[i].next) {
            const edge_node *node = &scratch->node[i];
            *edge++ = (scene_edge){{first->vertex + v, first->vertex + node->to}, {node->f[0], node->f[1]}};
        }
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

/* Counts the half-edges of each smaller vertex; end[v] becomes the start of v's bucket. */
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
    uint32_t vertices = first[1].vertex - first->vertex, corners = corners_of(scene, s), start = 0;
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

/* Edges from the sorted half-edges: each must have exactly one partner. */
static edge_pairing edges_from_sorted(roberts_scene *scene, uint32_t s, edge_scratch *scratch)
{
    const scene_solid *first = scene->solid + s;
    uint32_t vertices = first[1].vertex - first->vertex, start = 0, base = scene->face_start[first->face], made = 0;
    scene_edge *edge = scene->edge + first->edge;
    bool mixed = false;
    for (uint32_t v = 0; v < vertices; start = scratch->end[v++])
        for (uint32_t i = start; i < scratch->end[v]; i += 2) {
            uint64_t a = scratch->half[i], b = i + 1 < scratch->end[v] ? scratch->half[i + 1] : 0;
            if (a >> 32 != b >> 32 || (i + 2 < scratch->end[v] && scratch->half[i + 2] >> 32 == a >> 32))
                return EDGES_OPEN;
            bool up_a = scene->corner[base + (uint32_t)a] - first->vertex == v;
            bool up_b = scene->corner[base + (uint32_t)b] - first->vertex == v;
            uint32_t fa = first->face + scratch->face_of[(uint32_t)a];
            uint32_t fb = first->face + scratch->face_of[(uint32_t)b];
            edge[made] = (scene_edge){{first->vertex + v, first->vertex + (uint32_t)(a >> 32)},
                                      {up_a ? fa : fb, up_a ? fb : fa}};
            scratch->alike[made++] = up_a == up_b;
            mixed |= up_a == up_b;
        }
    return mixed ? EDGES_MIXED : EDGES_PAIRED;
}

edge_pairing edges_pair(roberts_scene *scene, uint32_t s, edge_scratch *scratch)
{
    uint32_t vertices = scene->solid[s + 1].vertex - scene->solid[s].vertex, corners = corners_of(scene, s);
    if (corners % 2)
        return EDGES_OPEN;
    if (!array_reserve(&scratch->head, &scratch->head_room, vertices, sizeof *scratch->head) ||
        !array_reserve(&scratch->node, &scratch->node_room, corners / 2, sizeof *scratch->node))
        return EDGES_NO_MEMORY;
    if (fill_lists(scene, s, scratch)) {
        edges_from_lists(scene, s, scratch);
        return EDGES_PAIRED;
    }
    if (!edges_sort(scene, s, scratch) ||
        !array_reserve(&scratch->alike, &scratch->alike_room, corners / 2, sizeof *scratch->alike))
        return EDGES_NO_MEMORY;
    return edges_from_sorted(scene, s, scratch);
}

void edge_scratch_free(edge_scratch *scratch)
{
    free(scratch->head);
    free(scratch->node);
    free(scratch->end);
    free(scratch->half);
    free(scratch->face_of);
    free(scratch->alike);
    *scratch = (edge_scratch){0};
}
