/* blocks.c - components that follow one another in the file, one behind the other.
 *
 * So they do in nearly all large files, and most repeat the one before, or one shortly before: then a comparison of its faces
 * with those is all that it takes. Of any other, faces are taken up until they hang together, use all vertices up to the
 * greatest, and number as on a sphere. That may be too early; but where each of these blocks has vertices of its own, and all
 * are used, the blocks are the components. */
#include "model/blocks.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/sets.h"

enum { BLOCK_MOST = 4096 }; /* vertices of a block that is no repetition; larger components come by union-find */

/* Vertices are counted from the block's first. */
typedef struct block {
    uint32_t parent[BLOCK_MOST]; /* as in sets.h */
    uint32_t face[BLOCK_MOST];   /* 1 + the last face that has the vertex, counted from the block's first; 0: none */
    uint32_t seen;               /* 1 + the greatest vertex */
    uint32_t used, sets;         /* vertices that faces have, and sets of them */
} block;

/* Takes up a face. False: it has a vertex that is no part of a block, or twice the same. */
static bool add_face(block *b, const uint32_t *corner, uint32_t count, uint32_t base, uint32_t number)
{
    for (uint32_t i = 0; i < count; i++) {
        uint32_t v = corner[i] - base, root, other;
        if (v >= BLOCK_MOST) /* or before the first, which wraps round */
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

/* The number of faces from `first` on that make up a block on vertices from `base` on; 0: none. */
static uint32_t find_block(block *b, const polygons *faces, uint32_t first, uint32_t base)
{
    const uint32_t *start = faces->start;
    b->seen = b->used = b->sets = 0;
    for (uint32_t f = first; f < faces->face_count;) {
        uint32_t count = start[f + 1] - start[f];
        if (count < 3 || !add_face(b, faces->corner + start[f], count, base, f - first + 1))
            return 0;
        f++;
        if (is_complete(b, f - first, start[f] - start[first]) &&
            (f == faces->face_count || start[f + 1] == start[f] || faces->corner[start[f]] - base >= b->seen))
            return f - first;
    }
    return 0;
}

/* Takes up the next component as solid s, of the pattern `*number` or one of its own. False: the components do not follow one
 * another. */
static bool next_block(scene_solid *solid, uint32_t s, const polygons *faces, patterns *list, block *b,
                       uint32_t *number)
{
    uint32_t count, used;
    *number = patterns_match(list, solid, s, faces->start, faces->corner, faces->face_count);
    if (*number != ROBERTS_NONE) {
        const scene_solid *first = solid + list->item[*number].solid;
        count = first[1].face - first->face;
        used = first[1].vertex - first->vertex;
    } else {
        count = find_block(b, faces, solid[s].face, solid[s].vertex);
        used = b->used;
    }
    if (count > 0) { /* else there may be no room for another */
        solid[s + 1].face = solid[s].face + count;
        solid[s + 1].vertex = solid[s].vertex + used;
    }
    return count > 0;
}

bool blocks_find(roberts_scene *scene, const polygons *faces, patterns *list, bool *found)
{
    const uint32_t vertices = faces->vertex_count, count = faces->face_count;
    scene_solid *solid = alloc_array((size_t)vertices / 3 + 1, sizeof *solid); /* each has three vertices at least */
    block *b = alloc_array(1, sizeof *b);
    bool enough = solid && b, more = count > 0 && enough;
    uint32_t s = 0, number;
    if (more)
        solid[0] = (scene_solid){0};
    for (; more && solid[s].face < count; s++) {
        more = next_block(solid, s, faces, list, b, &number);
        enough = !more || patterns_join(list, solid, s, number);
        more &= enough;
    }
    free(b);
    *found = more && solid[s].vertex == vertices;
    if (!*found) {
        free(solid);
        patterns_free(list);
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
