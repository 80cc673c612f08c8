/* components.c - which faces belong together: connected components of the face-vertex incidence, by union-find.
 *
 * A face joins all its vertices. The root of a set is its smallest vertex, so parents always come before their
 * children, and one ascending pass turns parents into component numbers in the order that the scene needs. Then
 * vertices and faces are sorted by component by counting sort. Source: R. E. Tarjan, J. van Leeuwen, "Worst-case
 * analysis of set union algorithms", J. ACM 31(2), 1984 (path halving). Linking by index instead of by rank costs at
 * most a factor log n, and next to nothing on real files. */
#include "model/components.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/box.h"
#include "base/sets.h"
#include "model/scene.h"

/* One number for each vertex. It has three meanings, one after the other:
 * 1. its parent: an earlier vertex of its component, or itself; ROBERTS_NONE: no face uses it (join_corners())
 * 2. the number of its component (number_components())
 * 3. its compact number (place_vertices()) */
typedef uint32_t set_node;

enum { FEW_CORNERS = 8 }; /* of a face; up to this many, comparing all pairs is faster than marking vertices */

/* Adds v to the set with this root; returns the root of the joined set. */
static inline uint32_t join_vertex(set_node *node, uint32_t root, uint32_t v)
{
    uint32_t other = node[v];
    if (other == root)
        return root;
    if (other == ROBERTS_NONE) {
        node[v] = v < root ? v : root;
        other = v;
    } else {
        other = sets_root(node, v);
    }
    if (other >= root) {
        node[other] = root;
        return root;
    }
    node[root] = other;
    return other;
}

/* Does a corner repeat an earlier one? For a face of few corners: compares all pairs. */
static inline bool few_repeat(const uint32_t *corner, const uint32_t *end)
{
    bool three = corner[0] == corner[1] || corner[0] == corner[2] || corner[1] == corner[2];
    if (end - corner == 3)
        return three;
    if (end - corner == 4)
        return three || corner[3] == corner[0] || corner[3] == corner[1] || corner[3] == corner[2];
    for (const uint32_t *p = corner + 1; p < end; p++)
        for (const uint32_t *q = corner; q < p; q++)
            if (*p == *q)
                return true;
    return false;
}

/* Does a corner repeat an earlier one? For a face of many corners: stamps each vertex with the face's mark. */
static bool many_repeat(const uint32_t *corner, const uint32_t *end, uint32_t *stamp, uint32_t mark)
{
    bool repeat = false;
    for (; corner < end; corner++) {
        repeat |= stamp[*corner] == mark;
        stamp[*corner] = mark;
    }
    return repeat;
}

static bool some_corner_repeats(const polygons *faces, bool *repeat)
{
    const uint32_t *start = faces->start;
    uint32_t *stamp = NULL; /* 1 + the last large face that has the vertex */
    *repeat = false;
    for (uint32_t f = 0; f < faces->face_count && !*repeat; f++) {
        uint32_t n = start[f + 1] - start[f];
        if (n < 3)
            continue; /* if there are no corners at all, faces->corner may be NULL */
        const uint32_t *corner = faces->corner + start[f];
        if (n <= FEW_CORNERS)
            *repeat = few_repeat(corner, corner + n);
        else if (stamp || (stamp = alloc_zeroed(faces->vertex_count, sizeof *stamp)))
            *repeat = many_repeat(corner, corner + n, stamp, f + 1);
        else
            return false;
    }
    free(stamp);
    return true;
}

/* Joins the vertices of each face; counts faces and corners. */
static void join_corners(roberts_scene *scene, set_node *node, const polygons *faces)
{
    const uint32_t *start = faces->start;
    const uint32_t vertex_count = faces->vertex_count, face_count = faces->face_count;
    size_t corner_count = 0;
    uint32_t counted = 0;
    for (uint32_t v = 0; v < vertex_count; v++)
        node[v] = ROBERTS_NONE;
    for (uint32_t f = 0; f < face_count; f++) {
        uint32_t n = start[f + 1] - start[f], root;
        if (n < 3)
            continue;
        const uint32_t *corner = faces->corner + start[f], *end = corner + n;
        counted++;
        corner_count += n;
        if (node[*corner] == ROBERTS_NONE)
            node[*corner] = *corner;
        root = sets_root(node, *corner);
        while (++corner < end)
            root = join_vertex(node, root, *corner);
    }
    scene->face_count = counted;
    scene->corner_count = corner_count;
}

/* Turns parents into component numbers. A parent comes before its children, so it already has its number. Counts
 * components and vertices, and measures the box. Returns whether the vertices keep their numbers, that is, whether all
 * are used and sorted by component. */
static bool number_components(roberts_scene *scene, set_node *node, const polygons *faces, const roberts_vec3 *point)
{
    roberts_vec3 lo = {INFINITY, INFINITY, INFINITY}, hi = {-INFINITY, -INFINITY, -INFINITY};
    uint32_t solid_count = 0, used = 0, vertex_count = faces->vertex_count, before = 0;
    bool in_order = true;
    for (uint32_t v = 0; v < vertex_count; v++) {
        uint32_t parent = node[v], component;
        if (parent == ROBERTS_NONE)
            continue;
        component = parent == v ? solid_count++ : node[parent];
        node[v] = component;
        in_order &= component >= before;
        before = component;
        used++;
        box_add(&lo, &hi, point[v]);
    }
    scene->solid_count = solid_count;
    scene->vertex_count = used;
    scene_set_box(scene, lo, hi);
    return in_order && used == vertex_count;
}

/* Returns the component of face f, which has corners. */
static inline uint32_t component_of(const set_node *node, const polygons *faces, uint32_t f)
{
    return node[faces->corner[faces->start[f]]];
}

/* Counts the vertices and faces of each component, and sets the first ones of each solid. Returns whether the faces
 * keep their numbers, that is, whether all are used and sorted by component. */
static bool count_members(roberts_scene *scene, const set_node *node, const polygons *faces)
{
    scene_solid sum = {0}, *solid = scene->solid;
    uint32_t vertex_count = faces->vertex_count, face_count = faces->face_count, before = 0;
    bool in_order = face_count > 0 && scene->face_count == face_count; /* a mesh without faces has no starts */
    for (uint32_t v = 0; v < vertex_count; v++)
        if (node[v] != ROBERTS_NONE)
            solid[node[v]].vertex++;
    for (uint32_t f = 0; f < face_count; f++)
        if (polygon_size(faces, f) >= 3) {
            uint32_t component = component_of(node, faces, f);
            solid[component].face++;
            in_order &= component >= before;
            before = component;
        }
    for (uint32_t s = 0; s <= scene->solid_count; s++) {
        scene_solid count = solid[s];
        solid[s] = sum;
        sum.vertex += count.vertex;
        sum.face += count.face;
    }
    return in_order;
}

static void place_faces(roberts_scene *scene, const set_node *node, const polygons *faces)
{
    scene_solid *solid = scene->solid;
    uint32_t *face_number = scene->face_number, face_count = faces->face_count;
    for (uint32_t f = 0; f < face_count; f++)
        if (polygon_size(faces, f) >= 3)
            face_number[solid[component_of(node, faces, f)].face++] = f;
    for (uint32_t s = scene->solid_count; s > 0; s--) /* by now, each first face has moved to the end of its solid */
        solid[s].face = solid[s - 1].face;
    solid[0].face = 0;
}

/* Sorts the vertices by component; replaces component numbers by compact numbers. */
static void place_vertices(roberts_scene *scene, set_node *node, const polygons *faces, const roberts_vec3 *point)
{
    scene_solid *solid = scene->solid;
    uint32_t *number = scene->number, vertex_count = faces->vertex_count;
    for (uint32_t v = 0; v < vertex_count; v++) {
        if (node[v] == ROBERTS_NONE)
            continue;
        uint32_t to = solid[node[v]].vertex++;
        node[v] = to;
        number[to] = v;
        scene->point[to] = point[v];
    }
    for (uint32_t s = scene->solid_count; s > 0; s--)
        solid[s].vertex = solid[s - 1].vertex;
    solid[0].vertex = 0;
}

static void copy_array(void *to, const void *from, size_t count, size_t size)
{
    if (count > 0) /* without vertices, `point` may be NULL */
        memcpy(to, from, count * size);
}

/* Fills the scene's arrays. Items that keep their numbers are copied from the mesh, unless the mesh has lent its
 * array. */
static void place(roberts_scene *scene, set_node *node, const polygons *faces, const roberts_vec3 *point,
                  kept_numbers kept)
{
    if (kept.faces) {
        if (!(scene->lent & LENT_FACE_START))
            copy_array(scene->face_start, faces->start, (size_t)scene->face_count + 1, sizeof *scene->face_start);
        if (!(scene->lent & LENT_CORNER))
            copy_array(scene->corner, faces->corner, scene->corner_count, sizeof *scene->corner);
    } else {
        place_faces(scene, node, faces);
        scene_copy_corners(scene, faces);
    }
    if (kept.vertices) {
        if (!(scene->lent & LENT_POINT))
            copy_array(scene->point, point, scene->vertex_count, sizeof *point);
    } else {
        place_vertices(scene, node, faces, point);
        for (size_t i = 0; i < scene->corner_count; i++)
            scene->corner[i] = node[scene->corner[i]];
    }
}

/* Measures the box of all vertices, all of which are used by faces. */
static void measure_vertices(roberts_scene *scene, const roberts_vec3 *point)
{
    roberts_vec3 lo = {INFINITY, INFINITY, INFINITY}, hi = {-INFINITY, -INFINITY, -INFINITY};
    box_add_all(&lo, &hi, point, scene->vertex_count);
    scene_set_box(scene, lo, hi);
}

/* Finds the components by union-find, and counts them, their vertices and their faces. `node` is needed for place().
 * False: no memory. */
static bool find_components(roberts_scene *scene, polygons *faces, const roberts_vec3 *point, set_node **node,
                            kept_numbers *kept)
{
    bool repeat;
    *node = alloc_array(faces->vertex_count, sizeof **node);
    if (!*node || !some_corner_repeats(faces, &repeat) || (repeat && !polygons_clean(faces, NULL)))
        return false;
    join_corners(scene, *node, faces);
    kept->vertices = number_components(scene, *node, faces, point);
    if (!(scene->solid = alloc_zeroed((size_t)scene->solid_count + 1, sizeof *scene->solid)))
        return false;
    kept->faces = count_members(scene, *node, faces);
    return true;
}

/* Points the scene to those arrays of the mesh that equal its own. */
static void borrow(roberts_scene *scene, const polygons *faces, const roberts_mesh *mesh, kept_numbers kept)
{
    if (kept.vertices && mesh->vertex) {
        scene->point = mesh->vertex;
        scene->lent |= LENT_POINT;
    }
    if (kept.faces && mesh->face_start && faces->start == mesh->face_start) {
        scene->face_start = mesh->face_start;
        scene->lent |= LENT_FACE_START;
    }
    if (kept.vertices && kept.faces && mesh->corner && faces->corner == mesh->corner) {
        scene->corner = mesh->corner;
        scene->lent |= LENT_CORNER;
    }
}

bool components_lay_out(roberts_scene *scene, polygons *faces, const roberts_mesh *mesh, bool lend,
                        repeated_solids *list)
{
    set_node *node = NULL;
    kept_numbers kept = {true, true};
    bool in_a_row, done = components_in_a_row(scene, faces, list, &in_a_row);
    if (done && in_a_row)
        measure_vertices(scene, mesh->vertex);
    else
        done = done && find_components(scene, faces, mesh->vertex, &node, &kept);
    if (done && lend)
        borrow(scene, faces, mesh, kept);
    done = done && scene_alloc_arrays(scene, kept);
    if (done)
        place(scene, node, faces, mesh->vertex, kept);
    free(node);
    return done;
}
