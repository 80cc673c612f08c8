/* weld.c - merges vertices at the same position; welds and splits components that are not closed.
 *
 * A hash of its position puts each vertex into one of as many buckets as there are vertices, and each bucket is sorted.
 * Nearly all buckets hold one position, so the time is linear; in the worst case it is n log n. */
#include "model/weld.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/error.h"
#include "base/sets.h"
#include "base/sort.h"
#include "base/vec.h"
#include "model/scene.h"
#include "model/solid.h"
#include "model/split.h"
#include "read/mesh.h"

/* ---- equal positions ------------------------------------------------------------------------------------------- */

typedef struct spot {
    roberts_vec3 at;
    uint32_t vertex;
} spot;

static int compare_spots(const void *a, const void *b)
{
    const spot *p = a, *q = b;
    int order = vec3_compare(p->at, q->at);
    if (order)
        return order;
    return (p->vertex > q->vertex) - (p->vertex < q->vertex);
}

static uint64_t mix(uint64_t hash, double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15u; /* 2^64 divided by the golden ratio: spreads low bits upward */
    return hash ^ hash >> 29;
}

static uint32_t bucket_of(roberts_vec3 p, uint32_t buckets)
{
    return (uint32_t)((mix(mix(mix(0, p.x), p.y), p.z) >> 32) * buckets >> 32);
}

/* Puts the vertices into buckets; end[b] becomes the end of bucket b. */
static void fill_buckets(spot *sorted, uint32_t *end, const uint32_t *listed, uint32_t count, const roberts_vec3 *point)
{
    for (uint32_t i = 0; i < count; i++) {
        roberts_vec3 p = point[listed[i]];
        end[bucket_of((roberts_vec3){p.x + 0.0, p.y + 0.0, p.z + 0.0}, count)]++;
    }
    sort_starts(end, count);
    for (uint32_t i = 0; i < count; i++) {
        roberts_vec3 p = point[listed[i]], at = {p.x + 0.0, p.y + 0.0, p.z + 0.0}; /* -0 + 0 is +0 */
        uint32_t b = bucket_of(at, count);
        sorted[end[b]++] = (spot){at, listed[i]};
    }
}

/* Sets name[v] of each of the `count` listed vertices (ascending) to the smallest listed vertex at exactly the same
 * position (-0 equals 0). Other names do not change. False: no memory. */
static bool weld_vertices(uint32_t *name, const uint32_t *listed, uint32_t count, const roberts_vec3 *point)
{
    spot *sorted = alloc_array(count, sizeof *sorted);
    uint32_t *end = alloc_zeroed(count, sizeof *end);
    bool enough = sorted && end;
    if (enough) {
        fill_buckets(sorted, end, listed, count, point);
        for (uint32_t k = 0, first = 0; k < count; first = end[k++]) {
            const uint32_t few = end[k] - first;
            SORT_LIST(spot, sorted + first, few, compare_spots(a, b) > 0, compare_spots)
        }
        for (uint32_t i = 0; i < count; i++) {
            const bool same = i > 0 && vec3_same(sorted[i].at, sorted[i - 1].at);
            name[sorted[i].vertex] = same ? name[sorted[i - 1].vertex] : sorted[i].vertex;
        }
    }
    free(sorted);
    free(end);
    return enough;
}

/* Uses a hash table: usually no two vertices are equal, and then nothing needs to be sorted. */
bool weld_any_equal(const uint32_t *listed, size_t count, const roberts_vec3 *point, bool *equal)
{
    size_t size = 16;
    *equal = false;
    while (size < 2 * count)
        size *= 2;
    uint32_t *slot = alloc_array(size, sizeof *slot);
    if (!slot)
        return false;
    memset(slot, 0xff, size * sizeof *slot);
    for (size_t i = 0; i < count && !*equal; i++) {
        roberts_vec3 p = point[listed[i]], at = {p.x + 0.0, p.y + 0.0, p.z + 0.0}; /* -0 + 0 is +0 */
        size_t to = (size_t)(mix(mix(mix(0, at.x), at.y), at.z) >> 20) & (size - 1);
        for (; slot[to] != ROBERTS_NONE && !*equal; to = (to + 1) & (size - 1))
            *equal = vec3_same(point[slot[to]], at);
        slot[to] = listed[i];
    }
    free(slot);
    return true;
}

/* ---- components that are not closed ---------------------------------------------------------------------------- */

/* Components that are not closed are welded and split, and numbered together with the others.
 *
 * Some files give each face its own vertices ("soup"), so that each face is a component. Components with open edges are
 * welded with one another where positions are exactly equal, but never with closed ones: a body that is complete in
 * the file (see find_complete() in bodies.c) stays as it is, even if it touches others. So do closed parts that share a
 * vertex: these are only split. */

/* The faces of open components, merged into one solid and then split. Zeroed = empty. */
typedef struct regrouping {
    roberts_scene loose; /* a single solid: these faces */
    edge_scratch edges;  /* of `loose` */
    split_groups groups; /* of the faces of `loose` */
    uint32_t *of;        /* [faces] the component of each; for split faces, the number of components plus the group */
    bool keep_open;
} regrouping;

typedef struct solid_key {
    uint32_t vertex, face; /* the smallest of each */
    uint32_t id;
} solid_key;

static int compare_keys(const void *a, const void *b)
{
    const solid_key *p = a, *q = b;
    if (p->vertex != q->vertex)
        return p->vertex < q->vertex ? -1 : 1;
    return (p->face > q->face) - (p->face < q->face);
}

bool weld_open(const roberts_scene *scene, const uint8_t *open, const roberts_mesh *mesh, uint32_t **name)
{
    uint32_t *listed = alloc_array(scene->vertex_count, sizeof *listed), count = 0;
    *name = alloc_array(mesh->vertex_count, sizeof **name);
    bool enough = listed && *name;
    for (uint32_t v = 0; enough && v < mesh->vertex_count; v++)
        (*name)[v] = v;
    for (uint32_t s = 0; enough && s < scene->solid_count; s++)
        for (uint32_t v = scene->solid[s].vertex; v < scene->solid[s + 1].vertex && open[s] == OPENING_EDGES; v++)
            listed[count++] = scene_vertex_number(scene, v);
    enough = enough && weld_vertices(*name, listed, count, mesh->vertex);
    free(listed);
    return enough;
}

/* Cleans the faces after welding. Refuses a vertex of an open component whose coordinates are infinite or too large. */
static roberts_status clean_welded(const roberts_scene *scene, const uint8_t *open, polygons *faces,
                                   const roberts_mesh *mesh, roberts_error *error)
{
    uint32_t *name = NULL;
    roberts_status status = ROBERTS_OK;
    for (uint32_t s = 0; s < scene->solid_count; s++)
        for (uint32_t v = scene->solid[s].vertex; v < scene->solid[s + 1].vertex && open[s]; v++)
            if (!mesh_position(scene->point[v]))
                status = error_set(error, ROBERTS_BAD_NUMBER, 0, "vertex %u is not a finite number up to 1e150",
                                   scene_vertex_number(scene, v));
    if (status != ROBERTS_OK)
        return status;
    bool enough = weld_open(scene, open, mesh, &name) && polygons_clean(faces, name);
    free(name);
    return enough ? ROBERTS_OK : error_no_memory(error);
}

/* Sets of[f], and returns the number of faces that need splitting. loose_of[f] is 0 for those and ROBERTS_NONE for
 * others. */
static uint32_t list_open(const roberts_scene *scene, const uint8_t *open, const polygons *faces, uint32_t *of,
                          uint32_t *loose_of)
{
    uint32_t count = 0;
    memset(of, 0xff, faces->face_count * sizeof *of);
    memset(loose_of, 0xff, faces->face_count * sizeof *loose_of);
    for (uint32_t s = 0; s < scene->solid_count; s++)
        for (uint32_t i = scene->solid[s].face; i < scene->solid[s + 1].face; i++) {
            uint32_t f = scene_face_number(scene, i);
            if (!open[s]) {
                of[f] = s;
            } else if (polygon_size(faces, f) >= 3) { /* welding may have left fewer corners */
                loose_of[f] = 0;
                count++;
            }
        }
    return count;
}

/* Replaces the ids in of[] (below id_count, some unused) by solid numbers, and sets the id of each solid. Returns the
 * number of solids; ROBERTS_NONE: no memory. */
static uint32_t number_solids(uint32_t *of, uint32_t id_count, const polygons *faces, uint32_t *id_of)
{
    solid_key *key = alloc_array(id_count, sizeof *key);
    uint32_t *rank = alloc_array(id_count, sizeof *rank), count = 0;
    if (key && rank) {
        for (uint32_t i = 0; i < id_count; i++)
            key[i] = (solid_key){ROBERTS_NONE, ROBERTS_NONE, i};
        for (uint32_t f = 0; f < faces->face_count; f++) {
            if (of[f] == ROBERTS_NONE)
                continue;
            solid_key *k = &key[of[f]];
            k->face = k->face == ROBERTS_NONE ? f : k->face;
            for (uint32_t i = faces->start[f]; i < faces->start[f + 1]; i++)
                k->vertex = faces->corner[i] < k->vertex ? faces->corner[i] : k->vertex;
        }
        qsort(key, id_count, sizeof *key, compare_keys);
        for (; count < id_count && key[count].face != ROBERTS_NONE; count++) {
            rank[key[count].id] = count;
            id_of[count] = key[count].id;
        }
        for (uint32_t f = 0; f < faces->face_count; f++)
            of[f] = of[f] == ROBERTS_NONE ? ROBERTS_NONE : rank[of[f]];
    } else {
        count = ROBERTS_NONE;
    }
    free(key);
    free(rank);
    return count;
}

/* Finds where solid s comes from, given the solid of each face. All vertices and faces of earlier files have smaller
 * numbers. */
static solid_source source_of_group(uint32_t s, const uint32_t *of, const polygons *faces, const roberts_mesh *mesh)
{
    uint32_t v[2] = {ROBERTS_NONE, 0}, f[2] = {ROBERTS_NONE, 0};
    for (uint32_t face = 0; face < faces->face_count; face++)
        for (uint32_t i = faces->start[face]; i < faces->start[face + 1] && of[face] == s; i++) {
            v[0] = faces->corner[i] < v[0] ? faces->corner[i] : v[0];
            v[1] = faces->corner[i] > v[1] ? faces->corner[i] : v[1];
            f[0] = face < f[0] ? face : f[0];
            f[1] = face;
        }
    solid_source at = source_find(mesh, v[0], v[1], f[0], f[1]);
    for (uint32_t face = 0; face < faces->face_count; face++)
        for (uint32_t i = faces->start[face]; i < faces->start[face + 1] && of[face] != ROBERTS_NONE; i++)
            if (faces->corner[i] < at.vertex && of[face] >= at.solid)
                at.solid = of[face] + 1;
    return at;
}

/* Refuses solid s as not closed. It is the group `group` and comes from `at`. The message names its first edge (by
 * vertices) that does not have two faces. */
static roberts_status refuse_open(const regrouping *g, uint32_t s, solid_source at, uint32_t group,
                                  roberts_error *error)
{
    const roberts_scene *loose = &g->loose;
    const edge_scratch *edges = &g->edges;
    uint32_t start = 0, others = 0, v0 = 0, v1 = 0, has = 0;
    for (uint32_t v = 0; v < loose->vertex_count; start = edges->end[v++])
        for (uint32_t i = start, to; i < edges->end[v]; i = to) {
            bool here = false;
            for (to = i; to < edges->end[v] && edges->half[to] >> 32 == edges->half[i] >> 32; to++)
                here |= g->groups.of[edges->face_of[(uint32_t)edges->half[to]]] == group;
            if (to - i == 2)
                continue;
            others++;
            if (has || !here)
                continue;
            v0 = loose->number[v] - at.vertex;
            v1 = loose->number[edges->half[i] >> 32] - at.vertex;
            has = to - i;
        }
    s -= at.solid;
    if (!has)
        error_set(error, ROBERTS_NOT_CLOSED, 0, "solid %u is not closed", s);
    else if (others > 1)
        error_set(error, ROBERTS_NOT_CLOSED, 0,
                  "solid %u is not closed: edge %u-%u belongs to %u face%s instead of 2 (%u such edges in all)", s, v0,
                  v1, has, has == 1 ? "" : "s", others);
    else
        error_set(error, ROBERTS_NOT_CLOSED, 0, "solid %u is not closed: edge %u-%u belongs to %u face%s instead of 2",
                  s, v0, v1, has, has == 1 ? "" : "s");
    return error_in(error, at.file, ROBERTS_NOT_CLOSED);
}

/* Joins open groups that share a vertex. False: no memory. */
static bool join_open(split_groups *groups, const roberts_scene *loose)
{
    uint32_t *parent = alloc_array(groups->count, sizeof *parent);
    uint32_t *owner = alloc_array(loose->vertex_count, sizeof *owner); /* the first open group that has the vertex */
    bool enough = parent && owner;
    for (uint32_t g = 0; enough && g < groups->count; g++)
        parent[g] = g;
    for (uint32_t v = 0; enough && v < loose->vertex_count; v++)
        owner[v] = ROBERTS_NONE;
    for (uint32_t f = 0; enough && f < loose->face_count; f++)
        for (uint32_t i = loose->face_start[f]; i < loose->face_start[f + 1] && !groups->closed[groups->of[f]]; i++) {
            uint32_t *first = &owner[loose->corner[i]];
            if (*first == ROBERTS_NONE)
                *first = groups->of[f];
            parent[sets_root(parent, groups->of[f])] = sets_root(parent, *first);
        }
    for (uint32_t f = 0; enough && f < loose->face_count; f++)
        groups->of[f] = sets_root(parent, groups->of[f]);
    free(parent);
    free(owner);
    return enough;
}

/* Numbers all solids, and lays them out in place of the components. */
static roberts_status lay_out_again(regrouping *g, roberts_scene *scene, const polygons *faces,
                                    const roberts_mesh *mesh, roberts_error *error)
{
    uint32_t components = scene->solid_count, solids;
    uint32_t *id_of = alloc_array((size_t)components + g->groups.count, sizeof *id_of);
    roberts_status status = ROBERTS_OK;
    for (uint32_t f = 0; f < g->loose.face_count; f++)
        g->of[g->loose.face_number[f]] = components + g->groups.of[f];
    solids = id_of ? number_solids(g->of, components + g->groups.count, faces, id_of) : ROBERTS_NONE;
    if (solids == ROBERTS_NONE)
        status = error_no_memory(error);
    for (uint32_t s = 0; status == ROBERTS_OK && s < solids && !g->keep_open; s++)
        if (id_of[s] >= components && !g->groups.closed[id_of[s] - components])
            status = refuse_open(g, s, source_of_group(s, g->of, faces, mesh), id_of[s] - components, error);
    if (status == ROBERTS_OK) {
        scene_clear(scene);
        if (!scene_lay_out(scene, faces, g->of, solids, mesh->vertex))
            status = error_no_memory(error);
    }
    free(id_of);
    return status;
}

roberts_status weld_regroup(roberts_scene *scene, const uint8_t *open, polygons *faces, const roberts_mesh *mesh,
                            bool keep_open, roberts_error *error)
{
    roberts_status status = clean_welded(scene, open, faces, mesh, error);
    regrouping g = {.keep_open = keep_open};
    uint32_t *loose_of;
    if (status != ROBERTS_OK)
        return status;
    g.of = alloc_array(faces->face_count, sizeof *g.of);
    loose_of = alloc_array(faces->face_count, sizeof *loose_of);
    status = ROBERTS_NO_MEMORY;
    if (!g.of || !loose_of)
        goto done;
    if (list_open(scene, open, faces, g.of, loose_of) > 0 &&
        (!scene_lay_out(&g.loose, faces, loose_of, 1, mesh->vertex) || !edges_sort(&g.loose, 0, &g.edges) ||
         !split_faces(&g.groups, &g.loose, &g.edges) || (keep_open && !join_open(&g.groups, &g.loose))))
        goto done;
    status = lay_out_again(&g, scene, faces, mesh, error);
done:
    scene_clear(&g.loose);
    edge_scratch_free(&g.edges);
    split_groups_free(&g.groups);
    free(g.of);
    free(loose_of);
    return status == ROBERTS_NO_MEMORY ? error_no_memory(error) : status;
}
