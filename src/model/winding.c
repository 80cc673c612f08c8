/* winding.c - orients the faces of a body alike. See winding.h. */
#include "model/winding.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/sets.h"

/* A face at an edge, by one of its pieces, and the sum of windings. */
typedef struct edge_face {
    uint32_t piece;
    int32_t winding;
} edge_face;

/* With more faces at an edge, parity decides. */
enum { EDGE_FACES = 16 };

/* Adds the winding number of a piece to that of its face along an edge, positive if it lies on the left. False: the
 * edge has too many faces. */
static bool add_at_edge(const roberts_scene *scene, uint32_t piece, bool turned, edge_face *at, uint32_t *count)
{
    const int32_t winding = (turned ? -1 : 1) * scene->surface->winding[piece];
    uint32_t k = 0;
    while (k < *count && scene_face_number(scene, at[k].piece) != scene_face_number(scene, piece))
        k++;
    if (k == EDGE_FACES)
        return false;
    if (k == *count)
        at[(*count)++] = (edge_face){piece, 0};
    at[k].winding += winding;
    return true;
}

/* Finds the two faces that an edge joins. False: it does not join two. */
static bool find_joined(const roberts_scene *scene, uint32_t s, uint32_t e, edge_face at[EDGE_FACES])
{
    uint32_t room[2], count = 0, kept = 0;
    const uint32_t *face;
    const uint32_t faces = scene_faces_at(scene, s, e, room, &face);
    for (uint32_t k = 0; k < faces; k++)
        if (!add_at_edge(scene, face[k] & ~MANY_TURNED, face[k] & MANY_TURNED, at, &count))
            return false;
    for (uint32_t k = 0; k < count; k++)
        if (at[k].winding != 0)
            at[kept++] = at[k];
    if (kept == 0)
        at[0].piece = at[1].piece = ROBERTS_NONE; /* the sides of one face alone, which bound nothing */
    return kept == 0 || (kept == 2 && abs(at[0].winding) == abs(at[1].winding));
}

/* Orients the faces of body s alike, if that is possible, and sets their windings. Face f counts twice: as node 2 f, as
 * it is, and as node 2 f + 1, turned over. Nodes of one orientation are joined. False: no memory. */
static bool orient_body(const roberts_scene *scene, uint32_t s, int32_t *winding)
{
    const uint32_t first = scene->solid[s].face, count = scene->solid[s + 1].face - first;
    uint32_t *node = alloc_array(count, sizeof *node), *parent = alloc_array(2 * (size_t)count, sizeof *parent);
    const bool done = node && parent;
    bool alike = true;
    for (uint32_t i = 0; done && i < count; i++) {
        const bool next = i == 0 || scene_face_number(scene, first + i) != scene_face_number(scene, first + i - 1);
        node[i] = i == 0 ? 0 : node[i - 1] + next;
        parent[2 * i] = 2 * i;
        parent[2 * i + 1] = 2 * i + 1;
    }
    for (uint32_t e = scene->solid[s].edge; done && alike && e < scene->solid[s + 1].edge; e++) {
        edge_face at[EDGE_FACES];
        alike = find_joined(scene, s, e, at);
        if (!alike || at[0].piece == ROBERTS_NONE)
            continue;
        const uint32_t a = 2 * node[at[0].piece - first], b = 2 * node[at[1].piece - first];
        const uint32_t turned = at[0].winding == at[1].winding;
        sets_join(parent, a, b + turned);
        sets_join(parent, a + 1, b + 1 - turned);
        alike = sets_root(parent, a) != sets_root(parent, a + 1);
    }
    for (uint32_t i = 0; done && i < count; i++)
        winding[first + i] =
            !alike ? 0 : (sets_root(parent, 2 * node[i]) % 2 ? -1 : 1) * scene->surface->winding[first + i];
    free(node);
    free(parent);
    return done;
}

bool winding_find(const roberts_scene *scene, int32_t **winding)
{
    const int32_t *own = scene->surface ? scene->surface->winding : NULL;
    *winding = NULL;
    if (!own)
        return true;
    *winding = alloc_zeroed(scene->face_count, sizeof **winding);
    for (uint32_t s = 0; *winding && s < scene->solid_count; s++) {
        bool even = false;
        for (uint32_t f = scene->solid[s].face; f < scene->solid[s + 1].face; f++)
            even = even || own[f] % 2 == 0;
        if (even && scene->surface->kind[s] != ROBERTS_OPEN && !orient_body(scene, s, *winding))
            return false;
    }
    return *winding;
}
