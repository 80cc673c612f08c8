/* components.c - which faces belong together: connected components by union-find.
 *
 * Idea: a face joins all its vertices. Each set's root is its smallest vertex, so that parents always come before their
 * children and one ascending pass turns parents into component numbers, already in the order the scene wants.
 * Source: R. E. Tarjan, J. van Leeuwen, "Worst-case analysis of set union algorithms", J. ACM 31(2), 1984 (path
 * halving). Linking by index instead of by rank costs at most a factor log n, and near nothing on files as they are.
 *
 * Degenerate input: a corner that repeats an earlier one of its face is no part of the solid and is left out; a face
 * then left with fewer than three corners is left out too, and so are vertices that no remaining face uses. */
#include "model/components.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/error.h"

enum { FEW_CORNERS = 8 }; /* up to so many, comparing all pairs is cheaper than stamping */

/* Whether corner i of a face repeats one before it. `stamp` is NULL for faces with few corners. */
static bool repeats(const uint32_t *corner, uint32_t i, uint32_t *stamp, uint32_t face)
{
    if (stamp) {
        bool seen = stamp[corner[i]] == face + 1;
        stamp[corner[i]] = face + 1;
        return seen;
    }
    for (uint32_t j = 0; j < i; j++)
        if (corner[j] == corner[i])
            return true;
    return false;
}

/* Counts the corners that repeat one before them in their face, and finds numbers out of range. */
static roberts_status count_repeated(const roberts_mesh *mesh, uint32_t **stamp, size_t *repeated, roberts_error *error)
{
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        const uint32_t *corner = mesh->corner + mesh->face_start[f];
        uint32_t count = mesh->face_start[f + 1] - mesh->face_start[f];
        for (uint32_t i = 0; i < count; i++)
            if (corner[i] >= mesh->vertex_count)
                return error_set(error, ROBERTS_BAD_INDEX, 0, "face %u names vertex %u, but there are %zu", f,
                                 corner[i], mesh->vertex_count);
        if (count > FEW_CORNERS && !*stamp && !(*stamp = alloc_zeroed(mesh->vertex_count, sizeof **stamp)))
            return error_no_memory(error);
        for (uint32_t i = 0; i < count; i++)
            *repeated += repeats(corner, i, count > FEW_CORNERS ? *stamp : NULL, f);
    }
    return ROBERTS_OK;
}

/* Copies the faces without repeated corners. */
static bool copy_clean(polygons *clean, const roberts_mesh *mesh, uint32_t *stamp)
{
    uint32_t to = 0;
    clean->own_start = alloc_array(mesh->face_count + 1, sizeof *clean->own_start);
    clean->own_corner = alloc_array(mesh->corner_count, sizeof *clean->own_corner);
    if (!clean->own_start || !clean->own_corner)
        return false;
    if (stamp)
        memset(stamp, 0, mesh->vertex_count * sizeof *stamp);
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        const uint32_t *corner = mesh->corner + mesh->face_start[f];
        uint32_t count = mesh->face_start[f + 1] - mesh->face_start[f];
        clean->own_start[f] = to;
        for (uint32_t i = 0; i < count; i++)
            if (!repeats(corner, i, count > FEW_CORNERS ? stamp : NULL, f))
                clean->own_corner[to++] = corner[i];
    }
    clean->own_start[mesh->face_count] = to;
    clean->start = clean->own_start;
    clean->corner = clean->own_corner;
    return true;
}

roberts_status polygons_clean(polygons *clean, const roberts_mesh *mesh, roberts_error *error)
{
    roberts_status status;
    uint32_t *stamp = NULL;
    *clean = (polygons){0};
    if (mesh->vertex_count >= ROBERTS_NONE || mesh->face_count >= ROBERTS_NONE || mesh->corner_count >= ROBERTS_NONE)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "more than 4294967294 vertices, faces or corners");
    clean->face_count = (uint32_t)mesh->face_count;
    clean->vertex_count = (uint32_t)mesh->vertex_count;
    clean->start = mesh->face_start;
    clean->corner = mesh->corner;
    status = count_repeated(mesh, &stamp, &clean->repeated, error);
    if (status == ROBERTS_OK && clean->repeated && !copy_clean(clean, mesh, stamp))
        status = error_no_memory(error);
    free(stamp);
    if (status != ROBERTS_OK)
        polygons_free(clean);
    return status;
}

void polygons_free(polygons *clean)
{
    free(clean->own_start);
    free(clean->own_corner);
    *clean = (polygons){0};
}

/* Root of v's set; halves the path on the way. */
static uint32_t find_root(uint32_t *parent, uint32_t v)
{
    while (parent[v] != v) {
        parent[v] = parent[parent[v]];
        v = parent[v];
    }
    return v;
}

/* parent[v]: an earlier vertex of v's component, v itself where there is none, ROBERTS_NONE where no face uses v. */
static void join_corners(uint32_t *parent, const polygons *faces)
{
    memset(parent, 0xff, faces->vertex_count * sizeof *parent);
    for (uint32_t f = 0; f < faces->face_count; f++) {
        uint32_t root = ROBERTS_NONE;
        if (polygon_size(faces, f) < 3)
            continue;
        for (uint32_t i = faces->start[f]; i < faces->start[f + 1]; i++) {
            uint32_t v = faces->corner[i], other;
            if (parent[v] == root && root != ROBERTS_NONE)
                continue;
            if (parent[v] == ROBERTS_NONE)
                parent[v] = v;
            other = find_root(parent, v);
            if (other < root) {
                if (root != ROBERTS_NONE)
                    parent[root] = other;
                root = other;
            } else {
                parent[other] = root;
            }
        }
    }
}

/* Turns parents into component numbers, in place: parents come before their children. */
static void number_components(uint32_t *label, grouping *found, const polygons *faces, const roberts_vec3 *point)
{
    roberts_vec3 lo = {INFINITY, INFINITY, INFINITY}, hi = {-INFINITY, -INFINITY, -INFINITY};
    for (uint32_t v = 0; v < faces->vertex_count; v++) {
        roberts_vec3 p = point[v];
        if (label[v] == ROBERTS_NONE)
            continue;
        label[v] = label[v] == v ? found->solid_count++ : label[label[v]];
        found->vertex_count++;
        lo.x = p.x < lo.x ? p.x : lo.x;
        lo.y = p.y < lo.y ? p.y : lo.y;
        lo.z = p.z < lo.z ? p.z : lo.z;
        hi.x = p.x > hi.x ? p.x : hi.x;
        hi.y = p.y > hi.y ? p.y : hi.y;
        hi.z = p.z > hi.z ? p.z : hi.z;
    }
    found->box_min = lo;
    found->box_max = hi;
}

/* Sorts the faces by component: count, sum up, fill. */
static bool sort_faces(grouping *found, const uint32_t *label, const polygons *faces)
{
    uint32_t total = 0;
    found->start = alloc_zeroed((size_t)found->solid_count + 2, sizeof *found->start);
    if (!found->start)
        return false;
    for (uint32_t f = 0; f < faces->face_count; f++) {
        if (polygon_size(faces, f) < 3)
            continue;
        found->start[label[faces->corner[faces->start[f]]] + 2]++;
        found->corner_count += polygon_size(faces, f);
        total++;
    }
    found->face = alloc_array(total, sizeof *found->face);
    if (!found->face)
        return false;
    for (uint32_t s = 0; s < found->solid_count; s++)
        found->start[s + 2] += found->start[s + 1];
    for (uint32_t f = 0; f < faces->face_count; f++)
        if (polygon_size(faces, f) >= 3)
            found->face[found->start[label[faces->corner[faces->start[f]]] + 1]++] = f;
    return true;
}

roberts_status components_find(grouping *found, const polygons *faces, const roberts_vec3 *point, roberts_error *error)
{
    uint32_t *label = alloc_array(faces->vertex_count, sizeof *label);
    bool done = false;
    *found = (grouping){0};
    if (label) {
        join_corners(label, faces);
        number_components(label, found, faces, point);
        done = sort_faces(found, label, faces);
    }
    free(label);
    if (done)
        return ROBERTS_OK;
    grouping_free(found);
    return error_no_memory(error);
}

void grouping_free(grouping *found)
{
    free(found->start);
    free(found->face);
    *found = (grouping){0};
}
