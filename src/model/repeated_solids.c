/* repeated_solids.c - solids that repeat one another, and components that follow one another in the file.
 *
 * The two faces of an edge pass it in opposite directions. So a surface that is connected by its edges can be wound in
 * two ways, each the reverse of the other. The edges of a pattern are stored for both, and a solid uses one of them. */
#include "model/repeated_solids.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/lanes.h"
#include "base/sets.h"

/* Is b[i] - a[i] == shift for all i < count? */
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

/* Removes the entry at `at` from the recent patterns, and puts pattern `number` in front. */
static void make_first(repeated_solids *list, uint32_t at, uint32_t number)
{
    for (; at > 0; at--)
        list->recent[at] = list->recent[at - 1];
    list->recent[0] = number;
}

/* Returns the recent pattern that solid s repeats; ROBERTS_NONE: none. The solid begins at solid[s].face and
 * solid[s].vertex, and has faces below face_count. Corners are in the order of the input. */
static uint32_t match_recent(repeated_solids *list, const scene_solid *solid, uint32_t s, const uint32_t *start,
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

/* Gives solid s the pattern `number`; ROBERTS_NONE: a new one. Solids must come in ascending order. False: no
 * memory. */
static bool join_pattern(repeated_solids *list, uint32_t s, uint32_t number)
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
        uint32_t number = match_recent(list, solid, s, scene->face_start, scene->corner, solid[s + 1].face);
        if (number != ROBERTS_NONE) {
            const scene_solid *first = solid + list->item[number].solid;
            if (first[1].face - first->face != solid[s + 1].face - solid[s].face ||
                first[1].vertex - first->vertex != solid[s + 1].vertex - solid[s].vertex)
                number = ROBERTS_NONE; /* the solid has more faces */
        }
        if (!join_pattern(list, s, number))
            return false;
    }
    return true;
}

typedef enum answer { NO, YES, NO_MEMORY } answer;

/* Are all faces connected by edges? */
static answer is_connected(const scene_edge *edge, uint32_t edges, uint32_t faces)
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

/* Stores the edges of a pattern for both windings, if it is closed and consistently wound. Two faces that close are one
 * face that is given twice. */
static bool store_both(repeated_solid *p, roberts_scene *scene, edge_scratch *scratch)
{
    const scene_solid *first = scene->solid + p->solid;
    uint32_t edges = scene_corners(scene, p->solid) / 2, faces = first[1].face - first->face;
    edge_pairing pairing =
        faces > 2 && edges_euler(scene, p->solid) == 2 ? edges_pair(scene, p->solid, scratch) : EDGES_OPEN;
    answer whole = pairing == EDGES_PAIRED ? is_connected(scratch->edge, edges, faces) : NO;
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
    scene->shared += 2 * edges; /* no more than its two or more solids would need separately */
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

/* ---- components that follow one another in the file ------------------------------------------------------------ */

/* Components that follow one another in the file.
 *
 * In nearly all large files they do, and most repeat a recent one, which comparing the numbers of their faces shows.
 * Otherwise faces are added to a block until they are connected, use all vertices up to the greatest, and satisfy
 * Euler's formula for a sphere. A block may end too early. But if in the end each block has its own vertices and all
 * vertices are used, the blocks are the components. If not, union-find starts from scratch (components.c). */

enum { BLOCK_MOST = 4096 }; /* vertices of a block; larger components are found by union-find */

/* Vertices are counted from the block's first. */
typedef struct block {
    uint32_t parent[BLOCK_MOST]; /* as in sets.h */
    uint32_t face[BLOCK_MOST];   /* 1 + the last face that has the vertex, relative to the block's first; 0: none */
    uint32_t seen;               /* 1 + the greatest vertex */
    uint32_t used, sets;         /* number of vertices used by faces, and of sets of them */
} block;

/* Adds a face to the block. False: a vertex is outside the block, or is repeated. */
static bool add_block_face(block *b, const uint32_t *corner, uint32_t count, uint32_t base, uint32_t number)
{
    for (uint32_t i = 0; i < count; i++) {
        uint32_t v = corner[i] - base, root, other;
        if (v >= BLOCK_MOST) /* also true if v is before the first, by wrap-around */
            return false;
        for (; b->seen <= v; b->seen++)
            b->face[b->seen] = 0;
        if (b->face[v] == number)
            return false;
        if (b->face[v] == 0) {
            b->parent[v] = v;
            b->used++;
            b->sets++;
        }
        b->face[v] = number;
        root = sets_root(b->parent, corner[0] - base);
        other = sets_root(b->parent, v);
        b->sets -= root != other;
        b->parent[root < other ? other : root] = root < other ? root : other;
    }
    return true;
}

static bool is_complete(const block *b, uint32_t faces, uint32_t corners)
{
    return b->sets == 1 && b->used == b->seen && corners % 2 == 0 && b->used + faces == corners / 2 + 2;
}

/* Returns how many faces from `first` on form a block whose vertices begin at `base`; 0: no block. */
static uint32_t find_block(block *b, const polygons *faces, uint32_t first, uint32_t base)
{
    const uint32_t *start = faces->start;
    b->seen = b->used = b->sets = 0;
    for (uint32_t f = first; f < faces->face_count;) {
        uint32_t count = start[f + 1] - start[f];
        if (count < 3 || !add_block_face(b, faces->corner + start[f], count, base, f - first + 1))
            return 0;
        f++;
        if (is_complete(b, f - first, start[f] - start[first]) &&
            (f == faces->face_count || start[f + 1] == start[f] || faces->corner[start[f]] - base >= b->seen))
            return f - first;
    }
    return 0;
}

/* Finds the next component, solid s, and its pattern `*number` (ROBERTS_NONE: a new one). False: the components do not
 * follow one another. */
static bool next_block(scene_solid *solid, uint32_t s, const polygons *faces, repeated_solids *list, block *b,
                       uint32_t *number)
{
    uint32_t count, used;
    *number = match_recent(list, solid, s, faces->start, faces->corner, faces->face_count);
    if (*number != ROBERTS_NONE) {
        const scene_solid *first = solid + list->item[*number].solid;
        count = first[1].face - first->face;
        used = first[1].vertex - first->vertex;
    } else {
        count = find_block(b, faces, solid[s].face, solid[s].vertex);
        used = b->used;
    }
    if (count > 0) { /* otherwise there may be no room for another */
        solid[s + 1] = (scene_solid){.vertex = solid[s].vertex + used, .face = solid[s].face + count};
    }
    return count > 0;
}

bool components_in_a_row(roberts_scene *scene, const polygons *faces, repeated_solids *list, bool *found)
{
    const uint32_t vertices = faces->vertex_count, count = faces->face_count;
    scene_solid *solid = alloc_array((size_t)vertices / 3 + 1, sizeof *solid); /* each has three vertices or more */
    block *b = alloc_array(1, sizeof *b);
    bool enough = solid && b, more = count > 0 && enough;
    uint32_t s = 0, number;
    if (more)
        solid[0] = (scene_solid){0};
    for (; more && solid[s].face < count; s++) {
        more = next_block(solid, s, faces, list, b, &number);
        enough = !more || join_pattern(list, s, number);
        more &= enough;
    }
    free(b);
    *found = more && solid[s].vertex == vertices;
    if (!*found) {
        free(solid);
        repeated_free(list);
        return enough;
    }
    scene->solid = realloc(solid, ((size_t)s + 1) * sizeof *solid);
    scene->solid = scene->solid ? scene->solid : solid;
    scene->solid_count = s;
    scene->vertex_count = vertices;
    scene->face_count = count;
    scene->corner_count = faces->start[count];
    return true;
}
