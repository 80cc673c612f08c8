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
#include "base/box.h"
#include "base/error.h"
#include "base/sets.h"
#include "model/scene_arrays.h"

/* ---- faces with every corner once -------------------------------------------------------------------------------- */

/* The faces of a mesh, every corner once.
 *
 * Rule: a corner that repeats an earlier one of its face is no part of the solid, wherever in the face it stands. A
 * face left with fewer than three corners is none. */

roberts_status polygons_of_mesh(polygons *faces, const roberts_mesh *mesh, roberts_error *error)
{
    *faces = (polygons){0};
    if (mesh->vertex_count >= ROBERTS_NONE || mesh->face_count >= ROBERTS_NONE || mesh->corner_count >= ROBERTS_NONE)
        return error_set(error, ROBERTS_NO_MEMORY, 0, "more than %u vertices, faces or corners",
                         (unsigned)ROBERTS_NONE - 1);
    faces->face_count = (uint32_t)mesh->face_count;
    faces->vertex_count = (uint32_t)mesh->vertex_count;
    faces->start = mesh->face_start;
    faces->corner = mesh->corner;
    return ROBERTS_OK;
}

bool polygons_clean(polygons *faces, const uint32_t *name)
{
    size_t corners = faces->face_count ? faces->start[faces->face_count] : 0;
    uint32_t *start = alloc_array((size_t)faces->face_count + 1, sizeof *start);
    uint32_t *corner = alloc_array(corners, sizeof *corner);
    uint32_t *stamp = alloc_zeroed(faces->vertex_count, sizeof *stamp); /* 1 + the last face that has the vertex */
    bool enough = start && corner && stamp;
    uint32_t to = 0;
    if (enough) {
        for (uint32_t f = 0; f < faces->face_count; f++) {
            start[f] = to;
            for (uint32_t i = faces->start[f]; i < faces->start[f + 1]; i++) {
                uint32_t v = name ? name[faces->corner[i]] : faces->corner[i];
                if (stamp[v] != f + 1)
                    corner[to++] = v;
                stamp[v] = f + 1;
            }
        }
        start[faces->face_count] = to;
        polygons_free(&(polygons){.own_start = faces->own_start, .own_corner = faces->own_corner});
        faces->start = faces->own_start = start;
        faces->corner = faces->own_corner = corner;
        faces->repeated += corners - to;
    } else {
        free(start);
        free(corner);
    }
    free(stamp);
    return enough;
}

void polygons_free(polygons *faces)
{
    free(faces->own_start);
    free(faces->own_corner);
    *faces = (polygons){0};
}

/* ---- components that follow one another in the file -------------------------------------------------------------- */

/* Components that follow one another in the file, one behind the other.
 *
 * So they do in nearly all large files, and most repeat the one before, or one shortly before: then a comparison of its faces
 * with those is all that it takes. Of any other, faces are taken up until they hang together, use all vertices up to the
 * greatest, and number as on a sphere. That may be too early; but where each of these blocks has vertices of its own, and all
 * are used, the blocks are the components. */

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
static bool next_block(scene_solid *solid, uint32_t s, const polygons *faces, repeated_solids *list, block *b,
                       uint32_t *number)
{
    uint32_t count, used;
    *number = repeated_match(list, solid, s, faces->start, faces->corner, faces->face_count);
    if (*number != ROBERTS_NONE) {
        const scene_solid *first = solid + list->item[*number].solid;
        count = first[1].face - first->face;
        used = first[1].vertex - first->vertex;
    } else {
        count = find_block(b, faces, solid[s].face, solid[s].vertex);
        used = b->used;
    }
    if (count > 0) { /* else there may be no room for another */
        solid[s + 1] = (scene_solid){.vertex = solid[s].vertex + used, .face = solid[s].face + count};
    }
    return count > 0;
}

bool components_in_a_row(roberts_scene *scene, const polygons *faces, repeated_solids *list, bool *found)
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
        enough = !more || repeated_join(list, s, number);
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

/* ---- components -------------------------------------------------------------------------------------------------- */

/* For each vertex its parent: an earlier vertex of the component or the vertex itself; ROBERTS_NONE: no face uses it.
 * Later the component's number, then the vertex's compact number. */
typedef uint32_t set_node;

enum { FEW_CORNERS = 8 }; /* of a face; up to so many, comparing all pairs is quicker than marking vertices */

/* Puts v into the set with this root; returns the root of the joined set. */
static inline uint32_t join(set_node *node, uint32_t root, uint32_t v)
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

/* Whether some corner repeats an earlier one: all pairs of a face of a few corners, stamps on the vertices of others. */
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
            continue; /* without corners at all, faces->corner may be NULL */
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

/* Joins the vertices of each face, and counts faces and corners. */
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
            root = join(node, root, *corner);
    }
    scene->face_count = counted;
    scene->corner_count = corner_count;
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

/* The component of face f, which has corners. */
static inline uint32_t component_of(const set_node *node, const polygons *faces, uint32_t f)
{
    return node[faces->corner[faces->start[f]]];
}

/* Counts vertices and faces per component, as the solids' first ones. Returns whether every face is in use and they are
 * in order, as with vertices. */
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
    if (count > 0) /* a mesh without vertices has no array of them */
        memcpy(to, from, count * size);
}

/* Vertices and faces keep their numbers where they are in order: then the mesh's arrays are copied, unless they are lent. */
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

/* The box round all vertices; none is out of use. */
static void measure(roberts_scene *scene, const roberts_vec3 *point)
{
    roberts_vec3 lo = {INFINITY, INFINITY, INFINITY}, hi = {-INFINITY, -INFINITY, -INFINITY};
    box_add_all(&lo, &hi, point, scene->vertex_count);
    scene_set_box(scene, lo, hi);
}

/* The components by union-find: counts them, their vertices and their faces. `node` is left for place(). False: no memory. */
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

/* Takes over from the mesh what would be the same. */
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
    bool blocks, done = components_in_a_row(scene, faces, list, &blocks);
    if (done && blocks)
        measure(scene, mesh->vertex);
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
