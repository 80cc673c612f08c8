/* bodies.c - builds a scene whose bodies are not all convex.
 *
 * Some components are convex solids, and so are some parts of open components after welding and splitting (weld.c).
 * These stay solids. All other faces are handled together: they are cut into convex pieces (surface.c) and joined at
 * their edges (body_edges.c). Pieces connected by edges form a body. Then the whole scene is laid out again, body by
 * body. */
#include "model/bodies.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/box.h"
#include "base/error.h"
#include "base/sets.h"
#include "base/sort.h"
#include "model/body_edges.h"
#include "model/components.h"
#include "model/convex.h"
#include "model/scene.h"
#include "model/solid.h"
#include "model/surface.h"
#include "model/weld.h"
#include "read/mesh.h"

/* The touching distance: the fraction of the scene's diameter, and the ulps of its largest coordinate. */
#define TOUCHING_OF_DIAMETER 1e-11
#define TOUCHING_ULPS 16.0

typedef struct assembly {
    roberts_scene *scene;
    const roberts_mesh *mesh;
    const roberts_scene_options *options;
    polygons faces;      /* of the mesh, welded and cleaned as for the convex solids */
    uint8_t *listed;     /* [faces] LISTED_... */
    uint32_t *vertex_of; /* [corners of the mesh] see name_corners(); NULL: nothing is welded */
    uint32_t *copied;    /* [copies] the vertex of the mesh that each copy repeats */
    uint32_t copies;
    uint32_t *group; /* [vertices of the surface] see group_closed(); until then those of the mesh, see find_complete();
                        NULL: all are one group */
    surface surface;
    polygons all;       /* pieces, then ends of edges and wires, then faces of convex solids */
    uint32_t *of;       /* [all.face_count] the body of each face */
    uint32_t *number;   /* [all.face_count] the face of the input; ROBERTS_NONE: no face */
    uint32_t convex;    /* the first face of `all` that belongs to a convex solid */
    uint8_t *is_convex; /* [bodies] */
    uint32_t body_count;
    builder work;
} assembly;

/* ---- which components are convex solids ------------------------------------------------------------------------ */

/* Finds which components are convex solids, and which may become closed when welded or split: open[] has their kind of
 * `opening`. */
static roberts_status find_kinds(assembly *a, uint8_t *open, uint8_t *convex, bool *any_open, roberts_error *error)
{
    const solid_rules rules = {a->mesh, a->options->tolerance, false};
    for (uint32_t s = 0; s < a->scene->solid_count; s++) {
        bool crooked = solid_surely_not_convex(a->scene, s, rules.tolerance);
        build_result result =
            crooked ? solid_is_closed(a->scene, &a->work, s, error) : solid_build(a->scene, &a->work, s, &rules, error);
        if (result == BUILD_REFUSED && (error->status == ROBERTS_NO_MEMORY || error->status == ROBERTS_BAD_NUMBER))
            return error->status;
        open[s] = result == BUILD_OPEN && a->work.opening != OPENING_HOLES ? (uint8_t)a->work.opening : OPENING_NONE;
        convex[s] = result == BUILD_OK && !crooked;
        *any_open |= open[s] != OPENING_NONE;
    }
    return ROBERTS_OK;
}

enum { FEWEST_FACES = 4 }; /* of a closed body */

/* Can component s be closed, though some of its edges have an odd number of faces? */
static bool may_be_complete(const roberts_scene *scene, const uint8_t *open, uint32_t s)
{
    const scene_solid *own = &scene->solid[s];
    bool may = open[s] == OPENING_EDGES && own[1].face - own->face >= FEWEST_FACES;
    for (uint32_t v = own->vertex; may && v < own[1].vertex; v++)
        may = mesh_position(scene->point[v]);
    return may;
}

/* Gives each component that may be complete a group of its own, numbered from 1, and lists its faces. Returns whether
 * there is one. */
static bool group_components(const assembly *a, const uint8_t *open, uint8_t *listed)
{
    const roberts_scene *scene = a->scene;
    bool any = false;
    for (uint32_t s = 0; s < scene->solid_count; s++) {
        if (!may_be_complete(scene, open, s))
            continue;
        any = true;
        for (uint32_t v = scene->solid[s].vertex; v < scene->solid[s + 1].vertex; v++)
            a->group[scene_vertex_number(scene, v)] = s + 1;
        for (uint32_t f = scene->solid[s].face; f < scene->solid[s + 1].face; f++)
            listed[scene_face_number(scene, f)] = LISTED;
    }
    return any;
}

/* A closed component looks open if vertices lie on its edges, or slits lead to its holes. It is complete, and needs no
 * welding. Finds the edges of each component as if it were alone. If all have an even number of faces, it is marked as
 * not open. Its vertices are a group of their own, so that its edges are not compared with those of other bodies.
 * *any_open: is any component still open? False: no memory. */
static bool find_complete(assembly *a, uint8_t *open, bool *any_open)
{
    const roberts_scene *scene = a->scene;
    const face_rules rules = bodies_rules(scene, a->mesh, a->options);
    surface s = {.mesh = a->mesh, .vertex_of = a->mesh->corner};
    uint8_t *listed = alloc_zeroed(a->mesh->face_count, 1), *odd = alloc_zeroed(scene->solid_count, 1);
    s.group = a->group = alloc_zeroed(a->mesh->vertex_count, sizeof *a->group);
    bool enough = listed && odd && a->group, any = false;
    if (enough && group_components(a, open, listed)) {
        enough = surface_take_faces(&s, listed, &rules) && surface_find_edges(&s, rules.touching);
        for (size_t i = 0; enough && i < s.edge_count; i++) {
            const uint32_t p = s.edge[i].piece[0];
            if (p != ROBERTS_NONE && !surface_is_even(&s, &s.edge[i]))
                odd[surface_group(&s, surface_piece(p)) - 1] = 1;
        }
        for (uint32_t v = 0; enough && v < a->mesh->vertex_count; v++) {
            uint32_t *own = &a->group[v];
            if (*own > 0 && odd[*own - 1])
                *own = 0;
            if (*own > 0)
                open[*own - 1] = OPENING_NONE;
            any = any || *own > 0;
        }
    }
    if (!any) {
        free(a->group);
        a->group = NULL;
    }
    *any_open = memchr(open, OPENING_EDGES, scene->solid_count) || memchr(open, OPENING_PARTS, scene->solid_count);
    surface_free(&s);
    free(listed);
    free(odd);
    return enough;
}

/* Marks the components that share vertices, if neither is a convex solid. owner: [vertices of the mesh], scratch. */
static void mark_sharers(const roberts_scene *scene, const uint8_t *convex, uint32_t *owner, uint8_t *shares)
{
    for (uint32_t s = 0; s < scene->solid_count; s++)
        for (uint32_t v = scene->solid[s].vertex; v < scene->solid[s + 1].vertex && !convex[s]; v++) {
            uint32_t *first = &owner[scene_vertex_number(scene, v)];
            if (*first == ROBERTS_NONE)
                *first = s;
            else
                shares[s] = shares[*first] = 1;
        }
}

/* Gives component s copies of its vertices, in the same order. copy: [vertices of the mesh], scratch. */
static void copy_vertices(assembly *a, uint32_t s, const uint32_t *name, uint32_t *copy)
{
    const roberts_scene *scene = a->scene;
    const roberts_mesh *mesh = a->mesh;
    for (uint32_t v = scene->solid[s].vertex; v < scene->solid[s + 1].vertex; v++) {
        const uint32_t own = scene_vertex_number(scene, v);
        copy[own] = (uint32_t)mesh->vertex_count + a->copies;
        a->copied[a->copies++] = own;
    }
    for (uint32_t f = scene->solid[s].face; f < scene->solid[s + 1].face; f++) {
        const uint32_t own = scene_face_number(scene, f);
        for (uint32_t i = mesh->face_start[own]; i < mesh->face_start[own + 1]; i++)
            a->vertex_of[i] = copy[name[mesh->corner[i]]];
    }
}

/* Stores the vertex at each corner after welding. A closed component that shares vertices gets its own: it was told
 * apart from bodies that it touches, and its faces must not count as copies of theirs. False: no memory. */
static bool name_corners(assembly *a, const uint32_t *name, const uint8_t *open, const uint8_t *convex)
{
    const roberts_scene *scene = a->scene;
    const roberts_mesh *mesh = a->mesh;
    uint32_t *scratch = alloc_array(mesh->vertex_count, sizeof *scratch);
    uint8_t *shares = alloc_zeroed(scene->solid_count, 1);
    a->vertex_of = alloc_array(mesh->corner_count, sizeof *a->vertex_of);
    a->copied = alloc_array(scene->vertex_count, sizeof *a->copied);
    const bool enough =
        scratch && shares && a->vertex_of && a->copied && mesh->vertex_count + scene->vertex_count < ROBERTS_NONE;
    if (enough) {
        memset(scratch, 0xff, mesh->vertex_count * sizeof *scratch);
        mark_sharers(scene, convex, scratch, shares);
        for (size_t i = 0; i < mesh->corner_count; i++)
            a->vertex_of[i] = name[mesh->corner[i]];
        for (uint32_t s = 0; s < scene->solid_count; s++)
            if (shares[s] && open[s] == OPENING_NONE)
                copy_vertices(a, s, name, scratch);
    }
    free(scratch);
    free(shares);
    return enough;
}

/* Frees what is not needed for components that will be laid out again. */
static void drop_shapes(roberts_scene *scene)
{
    free(scene->point);
    free(scene->corner);
    free(scene->face_plane);
    free(scene->face_deviation);
    free(scene->face_width);
    scene->point = NULL;
    scene->corner = NULL;
    scene->face_plane = NULL;
    scene->face_deviation = scene->face_width = NULL;
}

/* Has each edge of component s an even number of faces, without any vertex that divides it? */
static bool is_closed(const assembly *a, const uint8_t *open, uint32_t s)
{
    const uint32_t vertex = scene_vertex_number(a->scene, a->scene->solid[s].vertex);
    return open[s] == OPENING_NONE && !(a->group && a->group[vertex] > 0);
}

/* Gives each closed component that is not convex a group of its own, where there are others. Its faces may cross or
 * touch themselves, and then their pieces have sides with an odd number of faces: these are not compared with the edges
 * of other bodies. From here on, groups are those of the surface's vertices. False: no memory. */
static bool group_closed(assembly *a, const uint8_t *open, const uint8_t *convex)
{
    const roberts_scene *scene = a->scene;
    const roberts_mesh *mesh = a->mesh;
    const uint32_t *vertex_of = a->vertex_of ? a->vertex_of : mesh->corner;
    const bool several = scene->solid_count > 1;
    if (!several && !a->group)
        return true;
    uint32_t *group = alloc_zeroed(mesh->vertex_count + a->copies, sizeof *group);
    for (uint32_t s = 0; group && s < scene->solid_count; s++) {
        const bool complete = a->group && a->group[scene_vertex_number(scene, scene->solid[s].vertex)] > 0;
        if (convex[s] || !(complete || (several && open[s] == OPENING_NONE)))
            continue;
        for (uint32_t f = scene->solid[s].face; f < scene->solid[s + 1].face; f++) {
            const uint32_t own = scene_face_number(scene, f);
            for (uint32_t i = mesh->face_start[own]; i < mesh->face_start[own + 1]; i++)
                group[vertex_of[i]] = s + 1;
        }
    }
    free(a->group);
    a->group = group;
    return group != NULL;
}

/* Lays out the components, and lists the faces of those that are not convex solids. known: some component is known not
 * to be one. */
static roberts_status sort_components(assembly *a, bool known, roberts_error *error)
{
    repeated_solids list = {0};
    uint8_t *open = NULL, *convex = NULL;
    uint32_t *name = NULL;
    bool any_open = false;
    roberts_status status = polygons_of_mesh(&a->faces, a->mesh, error);
    if (status != ROBERTS_OK)
        return status;
    bool laid = components_lay_out(a->scene, &a->faces, a->mesh, false, &list);
    repeated_free(&list);
    status = ROBERTS_NO_MEMORY;
    if (!laid || !(open = alloc_zeroed(a->scene->solid_count, 1)) || !(convex = alloc_zeroed(a->scene->solid_count, 1)))
        goto done;
    status = known && a->scene->solid_count == 1 ? ROBERTS_OK : find_kinds(a, open, convex, &any_open, error);
    if (status == ROBERTS_OK && any_open && !find_complete(a, open, &any_open))
        status = ROBERTS_NO_MEMORY;
    if (status == ROBERTS_OK && any_open) {
        status = weld_open(a->scene, open, a->mesh, &name)
                     ? weld_regroup(a->scene, open, &a->faces, a->mesh, true, error)
                     : ROBERTS_NO_MEMORY;
        free(open);
        free(convex);
        convex = NULL;
        open = alloc_zeroed(a->scene->solid_count, 1);
        convex = open ? alloc_zeroed(a->scene->solid_count, 1) : NULL;
        if (status == ROBERTS_OK)
            status = convex ? find_kinds(a, open, convex, &any_open, error) : ROBERTS_NO_MEMORY;
        if (status == ROBERTS_OK && !name_corners(a, name, open, convex))
            status = ROBERTS_NO_MEMORY;
    }
    if (status == ROBERTS_OK && !(a->listed = alloc_array(a->mesh->face_count, 1)))
        status = ROBERTS_NO_MEMORY;
    if (status == ROBERTS_OK)
        memset(a->listed, LISTED, a->mesh->face_count);
    for (uint32_t s = 0; status == ROBERTS_OK && s < a->scene->solid_count; s++)
        for (uint32_t f = a->scene->solid[s].face; f < a->scene->solid[s + 1].face; f++)
            a->listed[scene_face_number(a->scene, f)] = convex[s]               ? LISTED_NOT
                                                        : is_closed(a, open, s) ? LISTED_CLOSED
                                                                                : LISTED;
    if (status == ROBERTS_OK && !group_closed(a, open, convex))
        status = ROBERTS_NO_MEMORY;
    drop_shapes(a->scene);
done:
    free(open);
    free(convex);
    free(name);
    return status;
}

/* ---- bodies ---------------------------------------------------------------------------------------------------- */

/* Adds elements of two corners to the box: the scene has no wires yet. */
static void add_wires(const roberts_mesh *mesh, roberts_vec3 *low, roberts_vec3 *high)
{
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        uint32_t first = mesh->face_start[f];
        for (uint32_t i = first; mesh->face_start[f + 1] - first == 2 && i < first + 2; i++)
            box_add(low, high, mesh->vertex[mesh->corner[i]]);
    }
}

face_rules bodies_rules(const roberts_scene *scene, const roberts_mesh *mesh, const roberts_scene_options *options)
{
    roberts_vec3 low = scene->box_min, high = scene->box_max;
    if (scene->face_count < mesh->face_count)
        add_wires(mesh, &low, &high);
    double diameter = vec3_length(vec3_sub(high, low));
    double rounding = TOUCHING_ULPS * DBL_EPSILON * fmax(vec3_largest(low), vec3_largest(high));
    double narrow = fmax(TOUCHING_OF_DIAMETER * diameter, rounding);
    return (face_rules){.tolerance = options->tolerance,
                        .touching = fmax(narrow, scene_step(scene)),
                        .narrow = narrow,
                        .unit = scene->unit,
                        .even_odd = options->even_odd};
}

/* Joins pieces that are connected by edges, and wires that are connected by their ends. parent: [pieces + edges];
 * owner: [vertices], scratch. */
static void join_pieces(const surface *s, uint32_t *parent, uint32_t *owner)
{
    for (size_t i = 0; i < s->piece_count + s->edge_count; i++)
        parent[i] = (uint32_t)i;
    for (uint32_t v = 0; v < s->vertex_count; v++)
        owner[v] = ROBERTS_NONE;
    for (uint32_t p = 1; p < s->piece_count; p++)
        if (s->face[p] == s->face[p - 1])
            sets_join(parent, p - 1, p);
    for (size_t i = 0; i < s->edge_count; i++) {
        const surface_edge *e = &s->edge[i];
        uint32_t own = s->piece_count + (uint32_t)i;
        if (e->piece[0] != ROBERTS_NONE) {
            sets_join(parent, own, surface_piece(e->piece[0]));
            if (e->piece[1] != ROBERTS_NONE)
                sets_join(parent, own, surface_piece(e->piece[1]));
            for (uint32_t k = e->many; e->many != ROBERTS_NONE && k < e->many_end; k++)
                sets_join(parent, own, surface_piece(s->many[k]));
            continue;
        }
        for (int k = 0; k < 2; k++) {
            uint32_t *first = &owner[e->v[k]];
            if (*first == ROBERTS_NONE)
                *first = own;
            sets_join(parent, own, *first);
        }
    }
}

/* Sets of[] and number[] of the pieces. parent: see join_pieces(). */
static void list_pieces(assembly *a, uint32_t *parent)
{
    for (uint32_t p = 0; p < a->surface.piece_count; p++) {
        a->of[p] = sets_root(parent, p);
        a->number[p] = a->surface.face[p];
    }
}

/* Adds an item to `all`, with `count` corners. */
static void add_item(assembly *a, uint32_t set, uint32_t number, const uint32_t *corner, uint32_t count)
{
    polygons *all = &a->all;
    const uint32_t n = all->face_count++;
    a->of[n] = set;
    a->number[n] = number;
    memcpy(all->own_corner + all->own_start[n], corner, count * sizeof *corner);
    all->own_start[n + 1] = all->own_start[n] + count;
}

/* Adds the two ends of each edge whose ends may not be corners of a piece. */
static void list_ends(assembly *a, uint32_t *parent)
{
    const surface *s = &a->surface;
    for (size_t i = 0; i < s->edge_count; i++)
        if (s->edge[i].odd)
            add_item(a, sets_root(parent, s->piece_count + (uint32_t)i), ROBERTS_NONE, s->edge[i].v, 2);
}

/* Adds the faces of convex solids. */
static void list_convex(assembly *a)
{
    const roberts_scene *scene = a->scene;
    const uint32_t sets = (uint32_t)(a->surface.piece_count + a->surface.edge_count);
    for (uint32_t k = 0; k < scene->solid_count; k++)
        for (uint32_t f = scene->solid[k].face; f < scene->solid[k + 1].face; f++) {
            const uint32_t own = scene_face_number(scene, f);
            if (a->listed[own] == LISTED_NOT)
                add_item(a, sets + k, own, a->faces.corner + a->faces.start[own], polygon_size(&a->faces, own));
        }
}

/* Moves the arrays of the pieces to `all`, and makes room for the rest. False: no memory. */
static bool make_item_room(assembly *a)
{
    surface *s = &a->surface;
    const roberts_scene *scene = a->scene;
    size_t odd = 0, convex_faces = 0, corners = s->corner_count;
    for (size_t i = 0; i < s->edge_count; i++)
        odd += s->edge[i].odd;
    for (uint32_t f = 0; f < scene->face_count; f++)
        if (a->listed[scene_face_number(scene, f)] == LISTED_NOT) {
            convex_faces++;
            corners += polygon_size(&a->faces, scene_face_number(scene, f));
        }
    const size_t count = s->piece_count + odd + convex_faces;
    a->of = alloc_array(count, sizeof *a->of);
    a->number = alloc_array(count, sizeof *a->number);
    if (!a->of || !a->number || count >= ROBERTS_NONE || corners + 2 * odd >= ROBERTS_NONE ||
        !array_reserve(&s->start, &s->start_room, count + 1, sizeof *s->start) ||
        !array_reserve(&s->corner, &s->corner_room, corners + 2 * odd, sizeof *s->corner))
        return false;
    s->start[s->piece_count] = (uint32_t)s->corner_count;
    a->all = (polygons){.start = s->start,
                        .corner = s->corner,
                        .own_start = s->start,
                        .own_corner = s->corner,
                        .face_count = s->piece_count,
                        .vertex_count = s->vertex_count};
    s->start = s->corner = NULL;
    return true;
}

/* Lists everything that will be laid out, and sets of[] to the set of each item: the pieces; the two ends of each edge
 * whose ends may not be corners of a piece; the faces of convex solids. False: no memory. */
static bool list_all(assembly *a)
{
    const surface *s = &a->surface;
    uint32_t *parent = alloc_array(s->piece_count + s->edge_count, sizeof *parent);
    uint32_t *owner = alloc_array(s->vertex_count, sizeof *owner);
    const bool enough = parent && owner && make_item_room(a);
    if (enough) {
        join_pieces(s, parent, owner);
        list_pieces(a, parent);
        list_ends(a, parent);
        a->convex = a->all.face_count;
        list_convex(a);
    }
    free(parent);
    free(owner);
    return enough;
}

typedef struct body_key {
    uint32_t vertex, face; /* the smallest of each */
    uint32_t first;        /* the body's number in order of first items */
    bool convex;
} body_key;

static int compare_keys(const void *pa, const void *pb)
{
    const body_key *a = pa, *b = pb;
    if (a->vertex != b->vertex)
        return a->vertex < b->vertex ? -1 : 1;
    if (a->face != b->face)
        return a->face < b->face ? -1 : 1;
    return (a->first > b->first) - (a->first < b->first);
}

/* Numbers the bodies by their smallest vertex, and stores the numbers in of[]. False: no memory. */
static bool number_bodies(assembly *a)
{
    const polygons *all = &a->all;
    size_t sets = a->surface.piece_count + a->surface.edge_count + a->scene->solid_count;
    uint32_t *rank = alloc_array(sets, sizeof *rank), count = 0;
    if (!rank)
        return false;
    memset(rank, 0xff, sets * sizeof *rank);
    for (uint32_t f = 0; f < all->face_count; f++) { /* for now, bodies are numbered in order of their first items */
        if (rank[a->of[f]] == ROBERTS_NONE)
            rank[a->of[f]] = count++;
        a->of[f] = rank[a->of[f]];
    }
    body_key *key = alloc_array(count, sizeof *key);
    a->is_convex = alloc_array(count, 1);
    if (key && a->is_convex) {
        for (uint32_t b = 0; b < count; b++)
            key[b] = (body_key){ROBERTS_NONE, ROBERTS_NONE, b, false};
        for (uint32_t f = 0; f < all->face_count; f++) {
            body_key *k = &key[a->of[f]];
            k->face = a->number[f] < k->face ? a->number[f] : k->face;
            k->convex = f >= a->convex;
            for (uint32_t i = all->start[f]; i < all->start[f + 1]; i++) {
                const uint32_t own = surface_number(&a->surface, all->corner[i]);
                k->vertex = own < k->vertex ? own : k->vertex;
            }
        }
        qsort(key, count, sizeof *key, compare_keys);
        for (uint32_t b = 0; b < count; b++) {
            rank[key[b].first] = b;
            a->is_convex[b] = key[b].convex;
        }
        for (uint32_t f = 0; f < all->face_count; f++)
            a->of[f] = rank[a->of[f]];
        a->body_count = count;
    }
    bool enough = key && a->is_convex;
    free(key);
    free(rank);
    return enough;
}

/* ---- the scene's arrays ---------------------------------------------------------------------------------------- */

/* Lays out everything in place of the components, then removes the items that are not faces. Until renamed, faces have
 * their numbers in `all`, and vertices those of the surface. False: no memory. */
static bool lay_out(assembly *a)
{
    roberts_scene *scene = a->scene;
    uint32_t to = 0, corner = 0, s = 0;
    scene_clear(scene);
    if (!scene_lay_out(scene, &a->all, a->of, a->body_count, a->surface.point))
        return false;
    for (uint32_t f = 0; f < scene->face_count; f++) {
        while (s < scene->solid_count && scene->solid[s].face == f)
            scene->solid[s++].face = to;
        if (a->number[scene->face_number[f]] == ROBERTS_NONE)
            continue;
        uint32_t first = scene->face_start[f], end = scene->face_start[f + 1];
        scene->face_number[to] = scene->face_number[f];
        scene->face_start[to++] = corner;
        for (uint32_t i = first; i < end; i++)
            scene->corner[corner++] = scene->corner[i];
    }
    while (s <= scene->solid_count)
        scene->solid[s++].face = to;
    scene->face_start[to] = corner;
    scene->face_count = to;
    scene->corner_count = corner;
    return true;
}

/* Fits the planes of the faces of one body that is not convex. */
static void fit_planes(assembly *a, uint32_t body)
{
    roberts_scene *scene = a->scene;
    const surface *s = &a->surface;
    for (uint32_t f = scene->solid[body].face; f < scene->solid[body + 1].face; f++) {
        const uint32_t *corner = scene->corner + scene->face_start[f];
        uint32_t count = scene->face_start[f + 1] - scene->face_start[f], first = s->plane_of[scene->face_number[f]];
        roberts_vec3 ring[PIECE_CORNERS], P = scene->point[corner[0]];
        fitted_plane fit = {0};
        size_t at = find_numbered(s->fit, s->fit_count, sizeof *s->fit, first);
        if (at < s->fit_count && s->fit[at].piece == first) {
            const surface_fit *own = &s->fit[at];
            P = s->point[own->vertex];
            fit = (fitted_plane){.n = own->n, .mean = own->mean, .deviation = own->deviation, .width = own->width};
        } else {
            for (uint32_t i = 0; i < count; i++)
                ring[i] = vec3_scale(1.0 / scene->unit, vec3_sub(scene->point[corner[i]], P));
            fit = face_plane_fit(ring, count);
            fit.mean *= scene->unit;
            fit.deviation *= scene->unit;
            fit.width *= scene->unit;
        }
        P = vec3_sub(P, scene->centre);
        scene->face_plane[f] = (plane){-fit.n.x, -fit.n.y, -fit.n.z, vec3_dot(fit.n, P) + fit.mean};
        scene_set_bounds(scene, f, fit.deviation, fit.width);
    }
}

/* Builds a convex solid again in its new place. */
static roberts_status store_convex(assembly *a, uint32_t b, roberts_error *error)
{
    scene_solid *own = &a->scene->solid[b];
    const solid_rules rules = {a->mesh, a->options->tolerance, true};
    if (solid_build(a->scene, &a->work, b, &rules, error) != BUILD_OK)
        return error->status;
    memcpy(a->scene->edge + own->stored, a->work.frame.edge, a->work.frame.edge_count * sizeof *a->scene->edge);
    a->scene->surface->kind[b] = ROBERTS_CONVEX;
    return ROBERTS_OK;
}

/* Numbers the edges of all bodies, and allocates their arrays. */
static bool number_body_edges(assembly *a, const body_edges *list)
{
    roberts_scene *scene = a->scene;
    uint64_t sum = 0;
    for (uint32_t b = 0; b < a->body_count; b++) {
        scene->solid[b].edge = scene->solid[b].stored = (uint32_t)sum;
        sum += a->is_convex[b] ? scene_corners(scene, b) / 2 : body_edges_count(list, b);
        if (sum >= ROBERTS_NONE)
            return false;
    }
    scene->solid[a->body_count].edge = scene->solid[a->body_count].stored = scene->edge_count = (uint32_t)sum;
    scene->edge = alloc_array(scene->edge_count, sizeof *scene->edge);
    scene->surface->kind = alloc_zeroed(a->body_count, 1);
    scene->surface->smooth = alloc_zeroed(a->body_count, 1);
    scene->surface->edge_is = alloc_zeroed(scene->edge_count, 1);
    return scene->edge && scene->surface->kind && scene->surface->smooth && scene->surface->edge_is;
}

/* Copies the winding numbers of pieces, if some are not 1. The faces have the numbers of `all`. False: no memory. */
static bool copy_windings(assembly *a)
{
    roberts_scene *scene = a->scene;
    const surface *s = &a->surface;
    if (s->wound_count == 0)
        return true;
    scene->surface->winding = alloc_array(scene->face_count, sizeof *scene->surface->winding);
    if (!scene->surface->winding)
        return false;
    for (uint32_t f = 0; f < scene->face_count; f++) {
        size_t at = find_numbered(s->wound, s->wound_count, sizeof *s->wound, scene->face_number[f]);
        bool found = at < s->wound_count && s->wound[at].piece == scene->face_number[f];
        scene->surface->winding[f] = found ? s->wound[at].winding : 1;
    }
    return true;
}

/* Replaces the numbers of `all` and of the surface by those of the input. */
static bool rename_all(assembly *a)
{
    roberts_scene *scene = a->scene;
    const surface *s = &a->surface;
    scene->surface->plane_of = alloc_array(scene->face_count, sizeof *scene->surface->plane_of);
    if (s->low)
        scene->low = alloc_array(scene->vertex_count, sizeof *scene->low);
    if (!scene->surface->plane_of || (s->low && !scene->low))
        return false;
    for (uint32_t f = 0; f < scene->face_count; f++) {
        uint32_t own = scene->face_number[f];
        scene->surface->plane_of[f] = own < s->piece_count ? s->plane_of[own] : own;
        scene->face_number[f] = a->number[own];
    }
    for (uint32_t v = 0; v < scene->vertex_count; v++) {
        uint32_t own = scene->number[v];
        if (s->low)
            scene->low[v] = own < a->mesh->vertex_count ? (roberts_vec3){0, 0, 0} : s->low[own];
        scene->number[v] = surface_number(s, own);
    }
    return true;
}

/* Finds the end of the pieces of one face that begin at `first`, and whether they lie in several planes. */
static uint32_t end_of_face(const roberts_scene *scene, uint32_t first, uint32_t limit, bool *bent)
{
    uint32_t end = first + 1;
    *bent = false;
    for (; end < limit && scene->face_number[end] == scene->face_number[first]; end++)
        *bent = *bent || scene->surface->plane_of[end] != scene->surface->plane_of[first];
    return end;
}

/* Fits a plane to all pieces of a face. Each counts by its area. So the normal is that of Newell's method, and does not
 * depend on how the face is cut. */
static plane plane_of_pieces(const roberts_scene *scene, uint32_t first, uint32_t end)
{
    const double scale = 1.0 / scene->unit;
    roberts_vec3 sum = {0, 0, 0}, middle = {0, 0, 0};
    double area = 0.0;
    for (uint32_t f = first; f < end; f++) {
        const uint32_t *corner = scene->corner + scene->face_start[f],
                       count = scene->face_start[f + 1] - scene->face_start[f];
        const roberts_vec3 P = vec3_sub(scene->point[corner[0]], scene->centre);
        const plane F = scene->face_plane[f];
        for (uint32_t i = 2; i < count; i++) {
            const roberts_vec3 Q = vec3_sub(scene->point[corner[i - 1]], scene->centre);
            const roberts_vec3 R = vec3_sub(scene->point[corner[i]], scene->centre);
            const double own =
                vec3_length(vec3_cross(vec3_scale(scale, vec3_sub(Q, P)), vec3_scale(scale, vec3_sub(R, P))));
            sum = vec3_add(sum, vec3_scale(own, (roberts_vec3){F.a, F.b, F.c}));
            middle = vec3_add(middle, vec3_scale(own / 3.0, vec3_add(P, vec3_add(Q, R))));
            area += own;
        }
    }
    const double length = vec3_length(sum);
    if (!(length > 0.0))
        return scene->face_plane[first];
    const roberts_vec3 n = vec3_scale(1.0 / length, sum);
    return (plane){n.x, n.y, n.z, -vec3_dot(n, middle) / area};
}

/* Finds the planes of whole faces, if some face is not planar. False: no memory. */
static bool fit_whole_faces(roberts_scene *scene)
{
    scene_surface *to = scene->surface;
    for (uint32_t b = 0; b < scene->solid_count; b++) {
        const uint32_t limit = scene->solid[b + 1].face;
        bool bent;
        for (uint32_t f = scene->solid[b].face, end; to->kind[b] != ROBERTS_CONVEX && f < limit; f = end) {
            end = end_of_face(scene, f, limit, &bent);
            if (!bent)
                continue;
            if (!to->whole) {
                to->whole = alloc_array(scene->face_count, sizeof *to->whole);
                if (!to->whole)
                    return false;
                memcpy(to->whole, scene->face_plane, scene->face_count * sizeof *to->whole);
            }
            to->whole[f] = plane_of_pieces(scene, f, end);
            for (uint32_t k = f + 1; k < end; k++)
                to->whole[k] = to->whole[f];
        }
    }
    return true;
}

static roberts_status fill_scene(assembly *a, roberts_error *error)
{
    roberts_scene *scene = a->scene;
    body_edges list = {0};
    roberts_status status = ROBERTS_NO_MEMORY;
    scene->surface = alloc_zeroed(1, sizeof *scene->surface);
    if (!scene->surface || !body_edges_list(&list, &a->surface, a->of, a->body_count) || !number_body_edges(a, &list))
        goto done;
    for (uint32_t f = 0; f < scene->face_count; f++)
        if (scene->face_number[f] < a->surface.piece_count)
            list.face[scene->face_number[f]] = f;
    for (uint32_t b = 0; b < a->body_count; b++) {
        if (a->is_convex[b])
            continue;
        fit_planes(a, b);
        if (!body_edges_store(&list, scene, b))
            goto done;
        if (!body_find_smooth(scene, b, NULL))
            goto done;
    }
    if (!copy_windings(a) || !rename_all(a))
        goto done;
    status = ROBERTS_OK;
    for (uint32_t b = 0; status == ROBERTS_OK && b < a->body_count; b++)
        if (a->is_convex[b])
            status = store_convex(a, b, error);
    if (status == ROBERTS_OK && !fit_whole_faces(scene))
        status = ROBERTS_NO_MEMORY;
done:
    body_edges_free(&list);
    return status;
}

/* Counts the corners that are left out. A corner to which its face returns later bounds the face and is not counted. */
static size_t count_repeated(const assembly *a)
{
    const roberts_mesh *mesh = a->mesh;
    size_t repeated = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        uint32_t first = mesh->face_start[f], end = mesh->face_start[f + 1];
        if (a->listed[f] == LISTED_NOT)
            repeated += end - first - polygon_size(&a->faces, f);
        for (uint32_t i = first; a->listed[f] != LISTED_NOT && end - first >= 3 && i < end; i++)
            repeated += mesh->corner[i] == mesh->corner[i + 1 < end ? i + 1 : first];
    }
    return repeated;
}

roberts_status bodies_build(roberts_scene *scene, const roberts_mesh *mesh, const roberts_scene_options *options,
                            bool known, bodies_notes *notes, roberts_error *error)
{
    assembly a = {.scene = scene, .mesh = mesh, .options = options, .surface = {.mesh = mesh}};
    roberts_status status = sort_components(&a, known, error);
    if (status == ROBERTS_OK) {
        a.surface.vertex_of = a.vertex_of ? a.vertex_of : mesh->corner;
        a.surface.copied = a.copied;
        a.surface.copies = a.copies;
        a.surface.group = a.group;
        const face_rules rules = bodies_rules(scene, mesh, options);
        if (!surface_take_faces(&a.surface, a.listed, &rules) || !surface_find_edges(&a.surface, rules.touching) ||
            !list_all(&a) || !number_bodies(&a))
            status = ROBERTS_NO_MEMORY;
        else if (a.body_count == 0)
            status =
                error_set(error, ROBERTS_NOT_CLOSED, 0, "there is nothing to draw: no face has area, no edge length");
        else
            status = lay_out(&a) ? fill_scene(&a, error) : ROBERTS_NO_MEMORY;
        *notes = (bodies_notes){count_repeated(&a), a.surface.bent, a.surface.uncut, a.surface.repeated};
    }
    polygons_free(&a.faces);
    polygons_free(&a.all);
    surface_free(&a.surface);
    builder_free(&a.work);
    free(a.listed);
    free(a.vertex_of);
    free(a.copied);
    free(a.group);
    free(a.of);
    free(a.number);
    free(a.is_convex);
    return status == ROBERTS_NO_MEMORY ? error_no_memory(error) : status;
}
