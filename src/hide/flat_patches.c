/* flat_patches.c - see flat_patches.h. */
#include "hide/flat_patches.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/sets.h"
#include "base/sort.h"

/* Patches of fewer faces are left out: their faces are compared one by one. */
#define FEWEST_FACES 16

/* ---- faces in one plane ------------------------------------------------------------------------------------------ */

/* From corner u to corner v, in the scene's unit. */
static roberts_vec3 between(const roberts_scene *scene, uint32_t u, uint32_t v)
{
    return vec3_scale(1.0 / scene->unit, vec3_sub(scene->point[v], scene->point[u]));
}

/* A normal of the plane of three corners of a face. */
static roberts_vec3 normal_of(const roberts_scene *scene, uint32_t face)
{
    const uint32_t *v = scene->corner + scene->face_start[face];
    return vec3_cross(between(scene, v[0], v[1]), between(scene, v[0], v[2]));
}

/* Are all corners of g that near to the plane of f? */
static bool is_in_plane(const roberts_scene *scene, uint32_t f, uint32_t g, double near)
{
    const roberts_vec3 n = normal_of(scene, f);
    const double most = near * vec3_length(n);
    const uint32_t from = scene->corner[scene->face_start[f]];
    for (uint32_t k = scene->face_start[g]; k < scene->face_start[g + 1]; k++)
        if (!(fabs(vec3_dot(n, between(scene, from, scene->corner[k]))) <= most))
            return false;
    return true;
}

/* Joins the faces at an edge that are in one plane. The plane of a sliver is uncertain beyond its long sides. But of
 * two slivers with a long side in common, one is the wider one, and its plane holds for the other. */
static void join_faces(const flat_patches *p, uint32_t body, uint32_t edge, double near, uint32_t *set)
{
    uint32_t room[2];
    const uint32_t *face;
    const uint32_t count = scene_faces_at(p->scene, body, edge, room, &face);
    for (uint32_t k = 1; k < count; k++) {
        const uint32_t f = face[0] & ~MANY_TURNED, g = face[k] & ~MANY_TURNED;
        if (!scene_is_in_pieces(p->scene, body, f) && !scene_is_in_pieces(p->scene, body, g) &&
            (is_in_plane(p->scene, f, g, near) || is_in_plane(p->scene, g, f, near)))
            sets_join(set, f, g);
    }
}

/* Finds the sets of faces. set: [face_count]. */
static void find_sets(const flat_patches *p, double near, uint32_t *set)
{
    const roberts_scene *scene = p->scene;
    for (uint32_t f = 0; f < scene->face_count; f++)
        set[f] = f;
    for (uint32_t body = 0; body < scene->solid_count; body++)
        for (uint32_t e = scene->solid[body].edge; e < scene->solid[body + 1].edge && !scene_is_convex(scene, body);
             e++)
            join_faces(p, body, e, near, set);
    for (uint32_t f = 0; f < scene->face_count; f++)
        set[f] = sets_root(set, f);
}

/* Numbers the large sets, and fills p->of. The normal of a patch is the sum of those of its faces, turned alike: of
 * each, the larger part the larger the face. False: no memory. */
static bool number_patches(flat_patches *p, const uint32_t *set)
{
    const uint32_t faces = p->scene->face_count;
    uint32_t *size = alloc_zeroed(faces, sizeof *size);
    for (uint32_t f = 0; size && f < faces; f++)
        size[set[f]]++;
    for (uint32_t f = 0; size && f < faces; f++)
        p->count += size[f] >= FEWEST_FACES;
    p->patch = alloc_zeroed(p->count, sizeof *p->patch);
    uint32_t count = 0;
    for (uint32_t f = 0; size && p->patch && f < faces; f++) {
        p->of[f] = size[set[f]] < FEWEST_FACES ? ROBERTS_NONE : set[f] == f ? count++ : p->of[set[f]];
        if (p->of[f] == ROBERTS_NONE)
            continue;
        flat_patch *patch = &p->patch[p->of[f]];
        const roberts_vec3 n = normal_of(p->scene, f);
        patch->n = vec3_add(patch->n, vec3_dot(n, patch->n) < 0.0 ? vec3_scale(-1.0, n) : n);
        patch->at = p->scene->corner[p->scene->face_start[f]];
    }
    free(size);
    return size && p->patch;
}

/* Measures the patches, and leaves out those that are bent: a curved surface of many faces is flat everywhere. */
static void measure_patches(flat_patches *p, double near)
{
    const roberts_scene *scene = p->scene;
    for (uint32_t f = 0; f < scene->face_count; f++) {
        flat_patch *patch = p->of[f] == ROBERTS_NONE ? NULL : &p->patch[p->of[f]];
        for (uint32_t k = scene->face_start[f]; patch && k < scene->face_start[f + 1]; k++) {
            const roberts_vec3 d = between(scene, patch->at, scene->corner[k]);
            const double height = vec3_dot(patch->n, d), error = vec3_dot_error(patch->n, d);
            patch->over = greater(patch->over, height + error);
            patch->under = greater(patch->under, error - height);
        }
    }
    for (uint32_t f = 0; f < scene->face_count; f++) {
        const flat_patch *patch = p->of[f] == ROBERTS_NONE ? NULL : &p->patch[p->of[f]];
        if (patch && !(patch->over + patch->under <= 2.0 * near * vec3_length(patch->n)))
            p->of[f] = ROBERTS_NONE;
    }
}

/* ---- borders ----------------------------------------------------------------------------------------------------- */

static int compare_sides(const void *pa, const void *pb)
{
    const flat_side *a = pa, *b = pb;
    return a->patch != b->patch ? (a->patch > b->patch) - (a->patch < b->patch) : compare_pairs(a->v, b->v);
}

static bool add_side(flat_patches *p, uint32_t patch, const uint32_t v[2])
{
    if (!array_reserve(&p->side, &p->side_room, p->side_count + 2, sizeof *p->side))
        return false;
    p->side[p->side_count++] = (flat_side){patch, {v[0], v[1]}};
    p->side[p->side_count++] = (flat_side){patch, {v[1], v[0]}};
    return true;
}

/* Lists an edge as a side of the patches of its faces, unless all belong to one. False: no memory. */
static bool list_edge(flat_patches *p, uint32_t body, uint32_t edge)
{
    uint32_t room[2];
    const uint32_t *face, count = scene_faces_at(p->scene, body, edge, room, &face);
    uint32_t k = 1;
    while (k < count && p->of[face[k] & ~MANY_TURNED] == p->of[face[0] & ~MANY_TURNED])
        k++;
    if (k == count)
        return true;
    const scene_edge is = scene_edge_at(p->scene, body, edge);
    for (k = 0; k < count; k++) {
        const uint32_t patch = p->of[face[k] & ~MANY_TURNED];
        if (patch != ROBERTS_NONE && !add_side(p, patch, is.v))
            return false;
    }
    return true;
}

static bool list_sides(flat_patches *p)
{
    const roberts_scene *scene = p->scene;
    for (uint32_t body = 0; body < scene->solid_count; body++)
        for (uint32_t e = scene->solid[body].edge; e < scene->solid[body + 1].edge && !scene_is_convex(scene, body);
             e++)
            if (!list_edge(p, body, e))
                return false;
    if (p->side_count > 1)
        qsort(p->side, p->side_count, sizeof *p->side, compare_sides);
    return true;
}

/* Is v on the border of a patch? With w, is the side from v to w? */
static bool is_on_border(const flat_patches *p, uint32_t patch, uint32_t v, uint32_t w)
{
    const flat_side least = {patch, {v, w == ROBERTS_NONE ? 0 : w}};
    const size_t at = find_first(&least, p->side, p->side_count, sizeof *p->side, compare_sides);
    return at < p->side_count && p->side[at].patch == patch && p->side[at].v[0] == v &&
           (w == ROBERTS_NONE || p->side[at].v[1] == w);
}

/* ---- all of it --------------------------------------------------------------------------------------------------- */

bool flat_patches_find(flat_patches *p, const roberts_scene *scene, double near, double touching)
{
    *p = (flat_patches){.scene = scene, .touching = touching};
    uint32_t *set = alloc_array(scene->face_count, sizeof *set);
    p->of = alloc_array(scene->face_count, sizeof *p->of);
    bool enough = set && p->of;
    if (enough) {
        find_sets(p, near, set);
        enough = number_patches(p, set);
    }
    free(set);
    if (!enough || p->count == 0)
        return enough;
    measure_patches(p, near);
    p->tested = alloc_zeroed(scene->face_count, sizeof *p->tested);
    return p->tested && list_sides(p);
}

void flat_patches_free(flat_patches *p)
{
    free(p->of);
    free(p->patch);
    free(p->side);
    free(p->tested);
    *p = (flat_patches){0};
}

/* Does the face lie on one side of a patch? It may end there, in at most two corners on the border of the patch; two
 * are joined by a side of the patch. */
static bool lies_beside(const flat_patches *p, uint32_t face, uint32_t number)
{
    const roberts_scene *scene = p->scene;
    const flat_patch *patch = &p->patch[number];
    uint32_t on[2], ends = 0;
    double over = INFINITY, under = INFINITY;
    for (uint32_t k = scene->face_start[face]; k < scene->face_start[face + 1]; k++) {
        const uint32_t v = scene->corner[k];
        if (is_on_border(p, number, v, ROBERTS_NONE)) {
            if (ends == 2)
                return false;
            on[ends++] = v;
            continue;
        }
        const roberts_vec3 d = between(scene, patch->at, v);
        const double height = vec3_dot(patch->n, d),
                     least = vec3_sum(patch->n) * p->touching + vec3_dot_error(patch->n, d);
        over = lesser(over, height - least);
        under = lesser(under, -height - least);
    }
    return (over > patch->over || under > patch->under) && (ends < 2 || is_on_border(p, number, on[0], on[1]));
}

/* The answers for the last two patches are kept: many of their faces follow. */
bool flat_patches_beside(const flat_patches *p, uint32_t face, uint32_t patch)
{
    if (patch == ROBERTS_NONE || p->of[face] == patch)
        return patch != ROBERTS_NONE;
    const uint64_t known = atomic_load_explicit(&p->tested[face], memory_order_relaxed), one = patch + (uint64_t)1;
    const uint64_t last = known & UINT32_MAX;
    if (last >> 1 == one)
        return last & 1;
    if (known >> 33 == one)
        return known >> 32 & 1;
    const bool beside = lies_beside(p, face, patch);
    atomic_store_explicit(&p->tested[face], last << 32 | one << 1 | beside, memory_order_relaxed);
    return beside;
}
