/* repeated_solids.c - solids whose faces are the same but for where their numbers begin.
 *
 * The two faces of an edge pass it in opposite directions. In a surface that hangs together by its edges this leaves two ways
 * to wind it, each the other turned round: so edges are stored both ways, and a solid has the one or the other. */
#include "model/repeated_solids.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/lanes.h"
#include "base/sets.h"

/* Whether b[i] - a[i] == shift for all i < count. */
static inline bool same_run(const uint32_t *a, const uint32_t *b, uint32_t count, uint32_t shift)
{
    const uint32_t *end = a + count;
    for (; end - a >= 4; a += 4, b += 4)
        if (!four_shifted(a, b, shift))
            return false;
    for (; a < end; a++, b++)
        if (*b - *a != shift)
            return false;
    return true;
}

/* Moves what is at `at` among the recent ones to the front, where it becomes `number`. */
static void make_first(repeated_solids *list, uint32_t at, uint32_t number)
{
    for (; at > 0; at--)
        list->recent[at] = list->recent[at - 1];
    list->recent[0] = number;
}

uint32_t repeated_match(repeated_solids *list, const scene_solid *solid, uint32_t s, const uint32_t *start,
                        const uint32_t *corner, uint32_t face_count)
{
    const scene_solid *own = solid + s;
    for (uint32_t i = 0; i < list->recent_count; i++) {
        uint32_t number = list->recent[i];
        const scene_solid *first = solid + list->item[number].solid;
        const uint32_t *a = start + first->face, *b = start + own->face, faces = first[1].face - first->face;
        if (faces > face_count - own->face || !same_run(a + 1, b + 1, faces, *b - *a) ||
            !same_run(corner + *a, corner + *b, a[faces] - *a, own->vertex - first->vertex))
            continue;
        make_first(list, i, number);
        return number;
    }
    return ROBERTS_NONE;
}

bool repeated_join(repeated_solids *list, uint32_t s, uint32_t number)
{
    if (!array_reserve(&list->of, &list->of_room, (size_t)s + 1, sizeof *list->of))
        return false;
    if (number == ROBERTS_NONE) {
        if (!array_reserve(&list->item, &list->room, (size_t)list->count + 1, sizeof *list->item))
            return false;
        number = list->count++;
        list->item[number] = (repeated_solid){.solid = s, .stored = ROBERTS_NONE};
        list->recent_count += list->recent_count < REPEATED_RECENT;
        make_first(list, list->recent_count - 1, number);
    }
    list->item[number].members++;
    list->of[s] = number;
    return true;
}

bool repeated_find(repeated_solids *list, roberts_scene *scene)
{
    const scene_solid *solid = scene->solid;
    for (uint32_t s = 0; s < scene->solid_count; s++) {
        uint32_t number = repeated_match(list, solid, s, scene->face_start, scene->corner, solid[s + 1].face);
        if (number != ROBERTS_NONE) {
            const scene_solid *first = solid + list->item[number].solid;
            if (first[1].face - first->face != solid[s + 1].face - solid[s].face ||
                first[1].vertex - first->vertex != solid[s + 1].vertex - solid[s].vertex)
                number = ROBERTS_NONE; /* it has more faces */
        }
        if (!repeated_join(list, s, number))
            return false;
    }
    return true;
}

typedef enum answer { NO, YES, NO_MEMORY } answer;

/* Whether one gets from each face to each other over edges. */
static answer hangs_together(const scene_edge *edge, uint32_t edges, uint32_t faces)
{
    uint32_t *parent = alloc_array(faces, sizeof *parent), sets = faces;
    if (!parent)
        return NO_MEMORY;
    for (uint32_t f = 0; f < faces; f++)
        parent[f] = f;
    for (uint32_t e = 0; e < edges; e++) {
        uint32_t a = sets_root(parent, edge[e].f[0]), b = sets_root(parent, edge[e].f[1]);
        sets -= a != b;
        parent[a] = b;
    }
    free(parent);
    return sets == 1 ? YES : NO;
}

/* Stores the edges of a pattern both ways, if it is closed and its faces agree in winding. */
static bool store_both(repeated_solid *p, roberts_scene *scene, edge_scratch *scratch)
{
    const scene_solid *first = scene->solid + p->solid;
    uint32_t edges = scene_corners(scene, p->solid) / 2, faces = first[1].face - first->face;
    edge_pairing pairing = edges_like_a_sphere(scene, p->solid) ? edges_pair(scene, p->solid, scratch) : EDGES_OPEN;
    answer whole = pairing == EDGES_PAIRED ? hangs_together(scratch->edge, edges, faces) : NO;
    if (pairing == EDGES_NO_MEMORY || whole == NO_MEMORY)
        return false;
    if (whole == NO)
        return true;
    p->stored = scene->shared;
    for (uint32_t e = 0; e < edges; e++) {
        scene_edge edge = scratch->edge[e];
        scene->edge[p->stored + e] = edge;
        scene->edge[p->stored + edges + e] = (scene_edge){{edge.v[0], edge.v[1]}, {edge.f[1], edge.f[0]}};
    }
    scene->shared += 2 * edges; /* no more than its two or more solids would need */
    return true;
}

bool repeated_number_edges(repeated_solids *list, roberts_scene *scene, edge_scratch *scratch)
{
    uint32_t sum = 0, at;
    void *smaller;
    scene->shared = 0;
    scene->edge = alloc_array(scene->corner_count / 2, sizeof *scene->edge);
    if (!scene->edge)
        return false;
    for (uint32_t i = 0; i < list->count; i++)
        if (list->item[i].members > 1 && !store_both(&list->item[i], scene, scratch))
            return false;
    at = scene->shared;
    for (uint32_t s = 0; s < scene->solid_count; s++) {
        uint32_t edges = scene_corners(scene, s) / 2, stored = list->item[list->of[s]].stored;
        scene->solid[s].edge = sum;
        scene->solid[s].stored = stored != ROBERTS_NONE ? stored : at;
        at += stored != ROBERTS_NONE ? 0 : edges;
        sum += edges;
    }
    scene->solid[scene->solid_count].edge = scene->edge_count = sum;
    smaller = realloc(scene->edge, (at + (size_t)1) * sizeof *scene->edge);
    scene->edge = smaller ? smaller : scene->edge;
    return true;
}

void repeated_free(repeated_solids *list)
{
    free(list->item);
    free(list->of);
    *list = (repeated_solids){0};
}
