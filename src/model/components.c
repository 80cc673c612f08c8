/* components.c - which faces belong together: connected components of the face-vertex incidence, by union-find.
 *
 * Idea: a face joins all its vertices. The root of a set is its smallest vertex, so that parents always come before
 * their children and one ascending pass turns parents into component numbers, already in the order the scene wants.
 * Then vertices and faces are sorted by component: count, sum up, fill.
 * Source: R. E. Tarjan, J. van Leeuwen, "Worst-case analysis of set union algorithms", J. ACM 31(2), 1984 (path
 * halving). Linking by index instead of by rank costs at most a factor log n, and near nothing on files as they are. */
#include "model/components.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/error.h"
#include "model/layout.h"

typedef struct set_node {
    uint32_t parent; /* an earlier vertex of the component or the vertex itself; ROBERTS_NONE: no face uses it. Later
                        the component's number, then the vertex's compact number */
    uint32_t stamp;  /* 1 + the last face that has the vertex */
} set_node;

/* Root of v's set; halves the path on the way. */
static uint32_t find_root(set_node *node, uint32_t v)
{
    while (node[v].parent != v) {
        node[v].parent = node[node[v].parent].parent;
        v = node[v].parent;
    }
    return v;
}

static uint32_t unite(set_node *node, uint32_t a, uint32_t b)
{
    uint32_t root = a < b ? a : b;
    node[a].parent = root;
    node[b].parent = root;
    return root;
}

/* Joins the vertices of each face. `bad`: the first face with a vertex that is not there, else ROBERTS_NONE. Returns how
 * many corners repeat an earlier one of their face. */
static size_t join_corners(set_node *node, const polygons *faces, uint32_t *bad)
{
    size_t repeated = 0;
    for (uint32_t v = 0; v < faces->vertex_count; v++)
        node[v] = (set_node){ROBERTS_NONE, 0};
    *bad = ROBERTS_NONE;
    for (uint32_t f = 0; f < faces->face_count; f++) {
        uint32_t root = ROBERTS_NONE;
        bool counts = polygon_size(faces, f) >= 3;
        for (uint32_t i = faces->start[f]; i < faces->start[f + 1]; i++) {
            uint32_t v = faces->corner[i];
            if (v >= faces->vertex_count) {
                *bad = f;
                return 0;
            }
            if (!counts)
                continue;
            repeated += node[v].stamp == f + 1;
            node[v].stamp = f + 1;
            if (node[v].parent == root && root != ROBERTS_NONE)
                continue;
            if (node[v].parent == ROBERTS_NONE)
                node[v].parent = v;
            root = root == ROBERTS_NONE ? find_root(node, v) : unite(node, root, find_root(node, v));
        }
    }
    return repeated;
}

/* Turns parents into component numbers: a parent comes before its children and has been turned already. Counts
 * components and vertices and measures the box. */
static void number_components(roberts_scene *scene, set_node *node, const polygons *faces, const roberts_vec3 *point)
{
    roberts_vec3 lo = {INFINITY, INFINITY, INFINITY}, hi = {-INFINITY, -INFINITY, -INFINITY};
    for (uint32_t v = 0; v < faces->vertex_count; v++) {
        if (node[v].parent == ROBERTS_NONE)
            continue;
        node[v].parent = node[v].parent == v ? scene->solid_count++ : node[node[v].parent].parent;
        scene->vertex_count++;
        box_add(&lo, &hi, point[v]);
    }
    scene->box_min = lo;
    scene->box_max = hi;
}

/* Counts vertices and faces per component, as the solids' first ones. */
static void count_members(roberts_scene *scene, const set_node *node, const polygons *faces)
{
    scene_solid sum = {0, 0, 0};
    for (uint32_t v = 0; v < faces->vertex_count; v++)
        if (node[v].parent != ROBERTS_NONE)
            scene->solid[node[v].parent].vertex++;
    for (uint32_t f = 0; f < faces->face_count; f++)
        if (polygon_size(faces, f) >= 3)
            scene->solid[node[faces->corner[faces->start[f]]].parent].face++;
    for (uint32_t s = 0; s <= scene->solid_count; s++) {
        scene_solid count = scene->solid[s];
        scene->solid[s] = sum;
        sum.vertex += count.vertex;
        sum.face += count.face;
    }
}

/* Sorts faces and vertices by component; each solid's first ones move to its end and back. */
static void place_members(roberts_scene *scene, set_node *node, const polygons *faces, const roberts_vec3 *point)
{
    for (uint32_t f = 0; f < faces->face_count; f++)
        if (polygon_size(faces, f) >= 3)
            scene->face_number[scene->solid[node[faces->corner[faces->start[f]]].parent].face++] = f;
    for (uint32_t v = 0; v < faces->vertex_count; v++) {
        if (node[v].parent == ROBERTS_NONE)
            continue;
        node[v].parent = scene->solid[node[v].parent].vertex++;
        scene->number[node[v].parent] = v;
        scene->point[node[v].parent] = point[v];
    }
    for (uint32_t s = scene->solid_count; s > 0; s--)
        scene->solid[s] = scene->solid[s - 1];
    scene->solid[0] = (scene_solid){0, 0, 0};
}

static void copy_corners(roberts_scene *scene, const set_node *node, const polygons *faces)
{
    uint32_t to = 0;
    for (uint32_t f = 0; f < scene->face_count; f++) {
        uint32_t from = scene->face_number[f];
        scene->face_start[f] = to;
        for (uint32_t i = faces->start[from]; i < faces->start[from + 1]; i++)
            scene->corner[to++] = node[faces->corner[i]].parent;
    }
    scene->face_start[scene->face_count] = to;
}

static void count_faces(roberts_scene *scene, const polygons *faces)
{
    scene->face_count = 0;
    scene->corner_count = 0;
    for (uint32_t f = 0; f < faces->face_count; f++)
        if (polygon_size(faces, f) >= 3) {
            scene->face_count++;
            scene->corner_count += polygon_size(faces, f);
        }
}

roberts_status components_lay_out(roberts_scene *scene, polygons *faces, const roberts_mesh *mesh, roberts_error *error)
{
    set_node *node = alloc_array(faces->vertex_count, sizeof *node);
    roberts_status status = ROBERTS_NO_MEMORY;
    uint32_t bad;
    if (!node)
        goto done;
    if (join_corners(node, faces, &bad) > 0) {
        if (!polygons_clean(faces, NULL))
            goto done;
        join_corners(node, faces, &bad);
    }
    if (bad != ROBERTS_NONE) {
        status = error_set(error, ROBERTS_BAD_INDEX, 0, "face %u names a vertex that is not there", bad);
        goto done;
    }
    number_components(scene, node, faces, mesh->vertex);
    count_faces(scene, faces);
    if (!layout_alloc(scene))
        goto done;
    count_members(scene, node, faces);
    place_members(scene, node, faces, mesh->vertex);
    copy_corners(scene, node, faces);
    status = ROBERTS_OK;
done:
    free(node);
    return status == ROBERTS_NO_MEMORY ? error_no_memory(error) : status;
}
