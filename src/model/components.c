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
#include <string.h>

#include "base/array.h"
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

/* Puts v into the set with this root; returns the root of the joined set. */
static inline uint32_t join(set_node *node, uint32_t root, uint32_t v)
{
    uint32_t other = node[v].parent;
    if (other == root)
        return root;
    if (other == ROBERTS_NONE) {
        node[v].parent = v < root ? v : root;
        other = v;
    } else {
        other = find_root(node, v);
    }
    if (other >= root) {
        node[other].parent = root;
        return root;
    }
    node[root].parent = other;
    return other;
}

/* Joins the vertices of each face, and counts faces and corners. Returns how many corners repeat an earlier one of their
 * face. */
static size_t join_corners(roberts_scene *scene, set_node *node, const polygons *faces)
{
    const uint32_t *start = faces->start;
    const uint32_t vertex_count = faces->vertex_count, face_count = faces->face_count;
    size_t repeated = 0, corner_count = 0;
    uint32_t counted = 0;
    for (uint32_t v = 0; v < vertex_count; v++)
        node[v] = (set_node){ROBERTS_NONE, 0};
    for (uint32_t f = 0; f < face_count; f++) {
        if (start[f + 1] - start[f] < 3)
            continue; /* without corners at all, faces->corner may be NULL */
        const uint32_t *corner = faces->corner + start[f], *end = faces->corner + start[f + 1];
        uint32_t root;
        counted++;
        corner_count += (size_t)(end - corner);
        if (node[*corner].parent == ROBERTS_NONE)
            node[*corner].parent = *corner;
        root = find_root(node, *corner);
        for (; corner < end; corner++) {
            uint32_t v = *corner;
            repeated += node[v].stamp == f + 1;
            node[v].stamp = f + 1;
            root = join(node, root, v);
        }
    }
    scene->face_count = counted;
    scene->corner_count = corner_count;
    return repeated;
}

/* Turns parents into component numbers: a parent comes before its children and has been turned already. Counts
 * components and vertices and measures the box. Returns whether every vertex is in use and they are in order, component
 * by component, so that they keep their numbers. */
static bool number_components(roberts_scene *scene, set_node *node, const polygons *faces, const roberts_vec3 *point)
{
    roberts_vec3 lo = {INFINITY, INFINITY, INFINITY}, hi = {-INFINITY, -INFINITY, -INFINITY};
    uint32_t solid_count = 0, used = 0, vertex_count = faces->vertex_count, before = 0;
    bool in_order = true;
    for (uint32_t v = 0; v < vertex_count; v++) {
        uint32_t parent = node[v].parent, component;
        if (parent == ROBERTS_NONE)
            continue;
        component = parent == v ? solid_count++ : node[parent].parent;
        node[v].parent = component;
        in_order &= component >= before;
        before = component;
        used++;
        box_add(&lo, &hi, point[v]);
    }
    scene->solid_count = solid_count;
    scene->vertex_count = used;
    scene->box_min = lo;
    scene->box_max = hi;
    return in_order && used == vertex_count;
}

/* The component of face f, which has corners. */
static inline uint32_t component_of(const set_node *node, const polygons *faces, uint32_t f)
{
    return node[faces->corner[faces->start[f]]].parent;
}

/* Counts vertices and faces per component, as the solids' first ones. */
static void count_members(roberts_scene *scene, const set_node *node, const polygons *faces)
{
    scene_solid sum = {0, 0, 0}, *solid = scene->solid;
    uint32_t vertex_count = faces->vertex_count, face_count = faces->face_count;
    for (uint32_t v = 0; v < vertex_count; v++)
        if (node[v].parent != ROBERTS_NONE)
            solid[node[v].parent].vertex++;
    for (uint32_t f = 0; f < face_count; f++)
        if (polygon_size(faces, f) >= 3)
            solid[component_of(node, faces, f)].face++;
    for (uint32_t s = 0; s <= scene->solid_count; s++) {
        scene_solid count = solid[s];
        solid[s] = sum;
        sum.vertex += count.vertex;
        sum.face += count.face;
    }
}

static void place_faces(roberts_scene *scene, const set_node *node, const polygons *faces)
{
    scene_solid *solid = scene->solid;
    uint32_t *face_number = scene->face_number, face_count = faces->face_count;
    for (uint32_t f = 0; f < face_count; f++)
        if (polygon_size(faces, f) >= 3)
            face_number[solid[component_of(node, faces, f)].face++] = f;
    for (uint32_t s = scene->solid_count; s > 0; s--) /* each first one has moved to its end: back */
        solid[s].face = solid[s - 1].face;
    solid[0].face = 0;
}

/* Sorts the vertices by component; parents become compact numbers. */
static void place_vertices(roberts_scene *scene, set_node *node, const polygons *faces, const roberts_vec3 *point)
{
    scene_solid *solid = scene->solid;
    uint32_t *number = scene->number, vertex_count = faces->vertex_count;
    for (uint32_t v = 0; v < vertex_count; v++) {
        if (node[v].parent == ROBERTS_NONE)
            continue;
        uint32_t to = solid[node[v].parent].vertex++;
        node[v].parent = to;
        number[to] = v;
        scene->point[to] = point[v];
    }
    for (uint32_t s = scene->solid_count; s > 0; s--)
        solid[s].vertex = solid[s - 1].vertex;
    solid[0].vertex = 0;
}

/* The same where they are in order. */
static void keep_vertices(roberts_scene *scene, const roberts_vec3 *point)
{
    uint32_t *number = scene->number, vertex_count = scene->vertex_count;
    for (uint32_t v = 0; v < vertex_count; v++)
        number[v] = v;
    if (vertex_count > 0) /* a mesh without vertices has no array of them */
        memcpy(scene->point, point, vertex_count * sizeof *point);
}

/* Copies the corners of all faces, in the mesh's numbers. */
static void copy_corners(roberts_scene *scene, const polygons *faces)
{
    const uint32_t *start = faces->start, *number = scene->face_number;
    uint32_t *to = scene->corner, *face_start = scene->face_start, face_count = scene->face_count;
    for (uint32_t f = 0; f < face_count; f++) {
        const uint32_t *from = faces->corner + start[number[f]], *end = faces->corner + start[number[f] + 1];
        face_start[f] = (uint32_t)(to - scene->corner);
        while (from < end)
            *to++ = *from++;
    }
    face_start[face_count] = (uint32_t)(to - scene->corner);
}

bool components_lay_out(roberts_scene *scene, polygons *faces, const roberts_mesh *mesh)
{
    set_node *node = alloc_array(faces->vertex_count, sizeof *node);
    bool done = false, in_order;
    if (!node)
        return false;
    if (join_corners(scene, node, faces) > 0) {
        if (!polygons_clean(faces, NULL))
            goto done;
        join_corners(scene, node, faces);
    }
    in_order = number_components(scene, node, faces, mesh->vertex);
    if (!layout_alloc(scene))
        goto done;
    count_members(scene, node, faces);
    place_faces(scene, node, faces);
    copy_corners(scene, faces);
    if (in_order) {
        keep_vertices(scene, mesh->vertex);
    } else {
        place_vertices(scene, node, faces, mesh->vertex);
        for (size_t i = 0; i < scene->corner_count; i++)
            scene->corner[i] = node[scene->corner[i]].parent;
    }
    done = true;
done:
    free(node);
    return done;
}
