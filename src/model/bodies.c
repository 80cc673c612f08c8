/* bodies.c - builds a scene whose bodies are not all convex.
 *
 * Components that are convex solids stay what they are, also those that come out when open components are welded and
 * split (weld.c). The faces of all others are handled together: they are cut into convex pieces (surface.c) and joined
 * at their edges (surface_edges.c). Pieces connected by edges are a body. Then everything is laid out anew, body by
 * body. */
#include "model/bodies.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/error.h"
#include "base/sets.h"
#include "base/sort.h"
#include "model/components.h"
#include "model/scene_arrays.h"
#include "model/solid.h"
#include "model/surface.h"
#include "model/weld.h"
#include "read/mesh.h"

/* The touching distance, as in the view: a part of the scene's diameter, or ulps of its largest coordinate; where
 * coordinates are 32-bit floats, at least the step between two of them. */
#define TOUCHING_OF_DIAMETER 1e-11
#define TOUCHING_ULPS 16.0

/* A body of more than SMOOTH_FACES faces is a curved surface if at least half of its bent edges are bent little. Bends
 * are squared distances of unit normals: more than FLAT_BEND (0.1 degrees) is bent, less than LITTLE_BEND (20 degrees)
 * little. */
#define SMOOTH_FACES 500
#define FLAT_BEND 3.046e-6
#define LITTLE_BEND 0.1206

typedef struct assembly {
    roberts_scene *scene;
    const roberts_mesh *mesh;
    const roberts_scene_options *options;
    polygons faces;  /* of the mesh, welded and cleaned as the convex solids have them */
    uint8_t *listed; /* [faces] 1: belongs to a body that is not convex */
    uint32_t *name;  /* [vertices of the mesh] welded name of each, see weld_open(); NULL: nothing is welded */
    surface surface;
    polygons all;       /* pieces, then ends of edges and wires, then faces of convex solids */
    uint32_t *of;       /* [all.face_count] the body of each */
    uint32_t *number;   /* [all.face_count] the input's face; ROBERTS_NONE: no face */
    uint32_t extra;     /* the first of `all` that is no piece */
    uint32_t convex;    /* the first of `all` that is a face of a convex solid */
    uint8_t *is_convex; /* [bodies] */
    uint32_t body_count;
    builder work;
} assembly;

/* ---- which components are convex solids ------------------------------------------------------------------------ */

static roberts_status find_kinds(assembly *a, uint8_t *open, uint8_t *convex, bool *any_open, roberts_error *error)
{
    const solid_rules rules = {a->mesh, a->options->tolerance, false};
    for (uint32_t s = 0; s < a->scene->solid_count; s++) {
        build_result result = solid_build(a->scene, &a->work, s, &rules, error);
        if (result == BUILD_REFUSED && (error->status == ROBERTS_NO_MEMORY || error->status == ROBERTS_BAD_NUMBER))
            return error->status;
        open[s] = result == BUILD_OPEN && !a->work.holes;
        convex[s] = result == BUILD_OK;
        *any_open |= open[s];
    }
    return ROBERTS_OK;
}

/* Names the vertices of open components as regroup() does: the first one at each position. */
static bool weld_open(assembly *a, const uint8_t *open)
{
    const roberts_scene *scene = a->scene;
    uint32_t *listed = alloc_array(scene->vertex_count, sizeof *listed), count = 0;
    a->name = alloc_array(a->mesh->vertex_count, sizeof *a->name);
    bool enough = listed && a->name;
    for (uint32_t v = 0; enough && v < a->mesh->vertex_count; v++)
        a->name[v] = v;
    for (uint32_t s = 0; enough && s < scene->solid_count; s++)
        for (uint32_t v = scene->solid[s].vertex; v < scene->solid[s + 1].vertex && open[s]; v++)
            listed[count++] = scene_vertex_number(scene, v);
    enough = enough && weld_vertices(a->name, listed, count, a->mesh->vertex);
    free(listed);
    return enough;
}

/* Lays out the components, and lists the faces of those that are not convex solids. known: it is certain that some
 * component is not. */
static roberts_status sort_components(assembly *a, bool known, roberts_error *error)
{
    repeated_solids list = {0};
    uint8_t *open = NULL, *convex = NULL;
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
    if (status == ROBERTS_OK && any_open) {
        status = weld_open(a, open) ? regroup(a->scene, open, &a->faces, a->mesh, true, error) : ROBERTS_NO_MEMORY;
        free(open);
        free(convex);
        convex = NULL;
        open = alloc_zeroed(a->scene->solid_count, 1);
        convex = open ? alloc_zeroed(a->scene->solid_count, 1) : NULL;
        if (status == ROBERTS_OK)
            status = convex ? find_kinds(a, open, convex, &any_open, error) : ROBERTS_NO_MEMORY;
    }
    if (status == ROBERTS_OK && !(a->listed = alloc_array(a->mesh->face_count, 1)))
        status = ROBERTS_NO_MEMORY;
    if (status == ROBERTS_OK)
        memset(a->listed, 1, a->mesh->face_count);
    for (uint32_t s = 0; status == ROBERTS_OK && s < a->scene->solid_count; s++)
        for (uint32_t f = a->scene->solid[s].face; f < a->scene->solid[s + 1].face && convex[s]; f++)
            a->listed[scene_face_number(a->scene, f)] = 0;
done:
    free(open);
    free(convex);
    return status;
}

/* ---- bodies ---------------------------------------------------------------------------------------------------- */

static double largest(roberts_vec3 a)
{
    return fmax(fabs(a.x), fmax(fabs(a.y), fabs(a.z)));
}

double bodies_touching(const roberts_scene *scene, const roberts_mesh *mesh)
{
    double diameter = vec3_length(vec3_sub(scene->box_max, scene->box_min));
    double rounding = TOUCHING_ULPS * DBL_EPSILON * fmax(largest(scene->box_min), largest(scene->box_max));
    return fmax(TOUCHING_OF_DIAMETER * diameter, fmax(rounding, mesh_float32_step(mesh)));
}

static uint32_t piece_of(uint32_t incidence)
{
    return incidence & ~SURFACE_TURNED;
}

/* Joins pieces that are connected by edges; wires are connected by their ends. parent: [pieces + edges]; owner:
 * [vertices] scratch. */
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
            sets_join(parent, own, piece_of(e->piece[0]));
            if (e->piece[1] != ROBERTS_NONE)
                sets_join(parent, own, piece_of(e->piece[1]));
            for (uint32_t k = e->many; e->many != ROBERTS_NONE && k < e->many_end; k++)
                sets_join(parent, own, piece_of(s->many[k]));
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

/* Lists all that is laid out, each item with its set in of[]: the pieces, the ends of edges that may not be corners of
 * a piece, and the faces of convex solids. */
static bool list_all(assembly *a)
{
    const surface *s = &a->surface;
    const roberts_scene *scene = a->scene;
    size_t odd = 0, convex_faces = 0, corners = s->corner_count;
    for (size_t i = 0; i < s->edge_count; i++)
        odd += s->edge[i].odd;
    for (uint32_t f = 0; f < scene->face_count; f++)
        if (!a->listed[scene_face_number(scene, f)]) {
            convex_faces++;
            corners += polygon_size(&a->faces, scene_face_number(scene, f));
        }
    size_t count = s->piece_count + odd + convex_faces;
    uint32_t *start = a->all.own_start = alloc_array(count + 1, sizeof *start);
    uint32_t *corner = a->all.own_corner = alloc_array(corners + 2 * odd, sizeof *corner);
    uint32_t *parent = alloc_array(s->piece_count + s->edge_count, sizeof *parent);
    uint32_t *owner = alloc_array(s->vertex_count, sizeof *owner);
    a->of = alloc_array(count, sizeof *a->of);
    a->number = alloc_array(count, sizeof *a->number);
    bool enough = start && corner && parent && owner && a->of && a->number && count < ROBERTS_NONE &&
                  corners + 2 * odd < ROBERTS_NONE;
    if (enough) {
        uint32_t to = (uint32_t)s->corner_count, n = s->piece_count;
        join_pieces(s, parent, owner);
        if (n > 0)
            memcpy(start, s->start, n * sizeof *start);
        if (to > 0)
            memcpy(corner, s->corner, to * sizeof *corner);
        for (uint32_t p = 0; p < n; p++) {
            a->of[p] = sets_root(parent, p);
            a->number[p] = s->face[p];
        }
        a->extra = n;
        for (size_t i = 0; i < s->edge_count; i++) {
            if (!s->edge[i].odd)
                continue;
            a->of[n] = sets_root(parent, s->piece_count + (uint32_t)i);
            a->number[n] = ROBERTS_NONE;
            start[n++] = to;
            corner[to++] = s->edge[i].v[0];
            corner[to++] = s->edge[i].v[1];
        }
        a->convex = n;
        for (uint32_t k = 0; k < scene->solid_count; k++)
            for (uint32_t f = scene->solid[k].face; f < scene->solid[k + 1].face; f++) {
                uint32_t own = scene_face_number(scene, f), size = polygon_size(&a->faces, own);
                if (a->listed[own])
                    continue;
                a->of[n] = (uint32_t)(s->piece_count + s->edge_count) + k;
                a->number[n] = own;
                start[n++] = to;
                memcpy(corner + to, a->faces.corner + a->faces.start[own], size * sizeof *corner);
                to += size;
            }
        start[n] = to;
        a->all.start = start;
        a->all.corner = corner;
        a->all.face_count = n;
        a->all.vertex_count = s->vertex_count;
    }
    free(parent);
    free(owner);
    return enough;
}

typedef struct body_key {
    uint32_t vertex, face, set; /* the smallest of each */
    bool convex;
} body_key;

static int compare_keys(const void *pa, const void *pb)
{
    const body_key *a = pa, *b = pb;
    if (a->vertex != b->vertex)
        return a->vertex < b->vertex ? -1 : 1;
    if (a->face != b->face)
        return a->face < b->face ? -1 : 1;
    return (a->set > b->set) - (a->set < b->set);
}

/* Numbers the bodies by their smallest vertex, and puts these numbers into of[]. */
static bool number_bodies(assembly *a)
{
    const polygons *all = &a->all;
    size_t sets = a->surface.piece_count + a->surface.edge_count + a->scene->solid_count, count = 0;
    body_key *key = alloc_array(sets, sizeof *key);
    uint32_t *rank = alloc_array(sets, sizeof *rank);
    if (key && rank) {
        for (size_t i = 0; i < sets; i++)
            key[i] = (body_key){ROBERTS_NONE, ROBERTS_NONE, (uint32_t)i, false};
        for (uint32_t f = 0; f < all->face_count; f++) {
            body_key *k = &key[a->of[f]];
            k->face = a->number[f] < k->face ? a->number[f] : k->face;
            k->convex = f >= a->convex;
            for (uint32_t i = all->start[f]; i < all->start[f + 1]; i++)
                k->vertex = all->corner[i] < k->vertex ? all->corner[i] : k->vertex;
        }
        for (size_t i = 0; i < sets; i++)
            if (key[i].vertex != ROBERTS_NONE)
                key[count++] = key[i];
        qsort(key, count, sizeof *key, compare_keys);
        for (uint32_t i = 0; i < count; i++)
            rank[key[i].set] = i;
        for (uint32_t f = 0; f < all->face_count; f++)
            a->of[f] = rank[a->of[f]];
        a->body_count = (uint32_t)count;
        a->is_convex = alloc_array(count, 1);
        for (uint32_t i = 0; a->is_convex && i < count; i++)
            a->is_convex[i] = key[i].convex;
    }
    free(key);
    free(rank);
    return a->is_convex != NULL;
}

/* ---- the scene's arrays ---------------------------------------------------------------------------------------- */

/* Lays out everything in place of the components, then removes the items that are not faces. Numbers in the scene still
 * refer to `all` and to the vertices of the surface. */
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
static bool fit_planes(assembly *a, uint32_t body)
{
    roberts_scene *scene = a->scene;
    const surface *s = &a->surface;
    for (uint32_t f = scene->solid[body].face; f < scene->solid[body + 1].face; f++) {
        const uint32_t *corner = scene->corner + scene->face_start[f];
        uint32_t count = scene->face_start[f + 1] - scene->face_start[f], first = s->plane_of[scene->face_number[f]];
        roberts_vec3 ring[PIECE_CORNERS], P = scene->point[corner[0]];
        fitted_plane fit = {0};
        size_t low = 0, high = s->fit_count;
        while (low < high) {
            size_t middle = low + (high - low) / 2;
            if (s->fit[middle].piece < first)
                low = middle + 1;
            else
                high = middle;
        }
        if (low < s->fit_count && s->fit[low].piece == first) {
            const surface_fit *own = &s->fit[low];
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
    return true;
}

/* An edge on its way into the scene. */
typedef struct edge_key {
    uint32_t body, v[2]; /* as in the input */
    double t;
    uint32_t edge; /* of the surface */
} edge_key;

static int compare_edge_keys(const void *pa, const void *pb)
{
    const edge_key *a = pa, *b = pb;
    if (a->v[0] != b->v[0])
        return a->v[0] < b->v[0] ? -1 : 1;
    if (a->v[1] != b->v[1])
        return a->v[1] < b->v[1] ? -1 : 1;
    if (a->t != b->t)
        return a->t < b->t ? -1 : 1;
    return (a->edge > b->edge) - (a->edge < b->edge);
}

/* Lists the edges of bodies that are not convex, body by body, sorted by their names in the file. first: [bodies +
 * 1]. */
static edge_key *list_edges(const assembly *a, uint32_t *first)
{
    const surface *s = &a->surface;
    edge_key *key = alloc_array(s->edge_count, sizeof *key);
    for (uint32_t b = 0; b <= a->body_count; b++)
        first[b] = 0;
    for (int pass = 0; key && pass < 2; pass++) {
        uint32_t odd = a->extra;
        for (size_t i = 0; i < s->edge_count; i++) {
            const surface_edge *e = &s->edge[i];
            uint32_t body = a->of[e->odd ? odd++ : piece_of(e->piece[0])];
            if (pass == 0) {
                first[body]++;
                continue;
            }
            edge_key *to = &key[first[body]++];
            *to = (edge_key){body, {e->v[0], e->v[1]}, 0.0, (uint32_t)i};
            if (e->part != ROBERTS_NONE)
                *to =
                    (edge_key){body, {s->part[e->part].v[0], s->part[e->part].v[1]}, s->part[e->part].t0, (uint32_t)i};
        }
        for (uint32_t b = 0, sum = 0; b <= a->body_count && pass == 0; b++) {
            uint32_t count = first[b];
            first[b] = sum;
            sum += count;
        }
    }
    for (uint32_t b = a->body_count; b > 0; b--)
        first[b] = first[b - 1];
    first[0] = 0;
    for (uint32_t b = 0; key && s->edge_part_count > 0 && b < a->body_count; b++)
        qsort(key + first[b], first[b + 1] - first[b], sizeof *key, compare_edge_keys);
    return key;
}

/* Maps the numbers of one body's pieces and vertices to those of the scene. */
typedef struct body_map {
    uint32_t *face;   /* [pieces] */
    uint32_t *vertex; /* [vertices of the surface] of the body at hand */
} body_map;

/* Stores the faces of an edge of more than two. */
static bool store_many(assembly *a, const surface_edge *e, uint32_t edge, bool back, const body_map *map,
                       size_t room[4])
{
    size_t *faces = &room[2];
    scene_surface *to = a->scene->surface;
    size_t count = e->many_end - e->many;
    if (!array_reserve(&to->many, &room[0], to->many_count + (size_t)1, sizeof *to->many) ||
        !array_reserve(&to->many_face, &room[1], *faces + count, sizeof *to->many_face))
        return false;
    to->many[to->many_count++] = (scene_many){edge, (uint32_t)*faces, (uint32_t)(*faces + count)};
    for (uint32_t k = e->many; k < e->many_end; k++)
        to->many_face[(*faces)++] = map->face[piece_of(a->surface.many[k])] |
                                    (((a->surface.many[k] & SURFACE_TURNED) != 0) != back ? MANY_TURNED : 0);
    return true;
}

/* Do the edge's pieces belong to exactly two faces? */
static bool is_two_faced(const surface *s, const surface_edge *e)
{
    if (e->piece[1] == ROBERTS_NONE)
        return false;
    uint32_t first = s->face[piece_of(e->piece[0])], other = first;
    for (uint32_t k = e->many; e->many != ROBERTS_NONE && k < e->many_end; k++) {
        uint32_t own = s->face[piece_of(s->many[k])];
        if (own != first && other != first && own != other)
            return false;
        other = own != first ? own : other;
    }
    return e->many == ROBERTS_NONE || other != first;
}

/* Does the edge run opposite to the edge of the file that it is a part of? */
static bool runs_back(const surface *s, const surface_edge *e)
{
    if (e->part == ROBERTS_NONE)
        return false;
    const scene_part *part = &s->part[e->part];
    return vec3_dot(vec3_sub(s->point[e->v[1]], s->point[e->v[0]]),
                    vec3_sub(s->point[part->v[1]], s->point[part->v[0]])) < 0.0;
}

/* Stores the edges of body b. */
static bool store_edges(assembly *a, uint32_t b, const edge_key *key, uint32_t count, body_map *map, size_t room[4])
{
    roberts_scene *scene = a->scene;
    scene_surface *to = scene->surface;
    const surface *s = &a->surface;
    const scene_solid *own = &scene->solid[b];
    bool closed = count > 0;
    for (uint32_t v = own->vertex; v < own[1].vertex; v++)
        map->vertex[scene->number[v]] = v - own->vertex;
    for (uint32_t i = 0; i < count; i++) {
        const surface_edge *e = &s->edge[key[i].edge];
        uint32_t edge = own->edge + i, v0 = map->vertex[e->v[0]], v1 = map->vertex[e->v[1]];
        uint8_t is = e->cut ? EDGE_CUT : 0;
        scene_edge *stored = &scene->edge[own->stored + i];
        bool back = runs_back(s, e); /* a part runs in the same direction as the edge of the file */
        *stored = (scene_edge){{back ? v1 : v0, back ? v0 : v1}, {ROBERTS_NONE, ROBERTS_NONE}};
        for (int k = 0; k < 2 && e->piece[k] != ROBERTS_NONE; k++) {
            stored->f[k] = map->face[piece_of(e->piece[k])] - own->face;
            if (((e->piece[k] & SURFACE_TURNED) != 0) != back)
                is |= (uint8_t)(k ? EDGE_TURNED_1 : EDGE_TURNED_0);
        }
        if (e->many != ROBERTS_NONE) {
            is |= EDGE_MANY;
            if (!store_many(a, e, edge, back, map, room))
                return false;
        }
        if (e->part != ROBERTS_NONE) {
            is |= EDGE_PART;
            if (!array_reserve(&to->part, &room[3], to->part_count + (size_t)1, sizeof *to->part))
                return false;
            to->part[to->part_count] = s->part[e->part];
            to->part[to->part_count++].edge = edge;
        }
        to->edge_is[edge] = is;
        closed = closed && is_two_faced(s, e);
    }
    to->kind[b] = closed ? ROBERTS_CLOSED : ROBERTS_OPEN;
    return true;
}

/* The angle between the two faces of an edge, as the square of the distance of their normals. */
static double bend_of(const roberts_scene *scene, const scene_solid *own, uint32_t edge)
{
    const scene_edge *e = &scene->edge[own->stored + (edge - own->edge)];
    uint8_t is = scene->surface->edge_is[edge];
    plane F = scene->face_plane[own->face + e->f[0]], G = scene->face_plane[own->face + e->f[1]];
    double way = ((is & EDGE_TURNED_0) != 0) == ((is & EDGE_TURNED_1) != 0) ? -1.0 : 1.0;
    double a = F.a - way * G.a, b = F.b - way * G.b, c = F.c - way * G.c;
    return a * a + b * b + c * c;
}

/* Counts edges until the rest cannot change the answer. */
bool bodies_smooth(const roberts_scene *scene, uint32_t b)
{
    const scene_solid *own = &scene->solid[b];
    uint32_t much = 0, little = 0;
    if (own[1].face - own->face <= SMOOTH_FACES)
        return false;
    for (uint32_t e = own->edge; e < own[1].edge; e++) {
        uint32_t left = own[1].edge - e;
        if (little >= much + (uint64_t)left || much > little + (uint64_t)left)
            break;
        if (scene->surface->edge_is[e] & (EDGE_MANY | EDGE_CUT) ||
            scene->edge[own->stored + (e - own->edge)].f[1] == ROBERTS_NONE)
            continue;
        double bend = bend_of(scene, own, e);
        much += bend > FLAT_BEND && !(bend < LITTLE_BEND);
        little += bend > FLAT_BEND && bend < LITTLE_BEND;
    }
    return little > 0 && little >= much;
}

/* Builds a convex solid again, in its new place. */
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

/* Numbers the edges of all bodies, and allocates their arrays. first: from list_edges(). */
static bool number_edges(assembly *a, const uint32_t *first)
{
    roberts_scene *scene = a->scene;
    uint64_t sum = 0;
    for (uint32_t b = 0; b < a->body_count; b++) {
        scene->solid[b].edge = scene->solid[b].stored = (uint32_t)sum;
        sum += a->is_convex[b] ? scene_corners(scene, b) / 2 : first[b + 1] - first[b];
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
        scene->number[v] = own < a->mesh->vertex_count ? own : ROBERTS_NONE;
    }
    return true;
}

static roberts_status fill_scene(assembly *a, roberts_error *error)
{
    roberts_scene *scene = a->scene;
    uint32_t *first = alloc_array(a->body_count + (size_t)1, sizeof *first);
    body_map map = {alloc_array(a->surface.piece_count, sizeof *map.face),
                    alloc_array(a->surface.vertex_count, sizeof *map.vertex)};
    edge_key *key = NULL;
    size_t room[4] = {0};
    roberts_status status = ROBERTS_NO_MEMORY;
    scene->surface = alloc_zeroed(1, sizeof *scene->surface);
    if (!first || !map.face || !map.vertex || !scene->surface || !(key = list_edges(a, first)) ||
        !number_edges(a, first))
        goto done;
    for (uint32_t f = 0; f < scene->face_count; f++)
        if (scene->face_number[f] < a->surface.piece_count)
            map.face[scene->face_number[f]] = f;
    for (uint32_t b = 0; b < a->body_count; b++)
        if (!a->is_convex[b] &&
            !(fit_planes(a, b) && store_edges(a, b, key + first[b], first[b + 1] - first[b], &map, room)))
            goto done;
    for (uint32_t b = 0; b < a->body_count; b++)
        scene->surface->smooth[b] = !a->is_convex[b] && bodies_smooth(scene, b);
    if (!rename_all(a))
        goto done;
    status = ROBERTS_OK;
    for (uint32_t b = 0; status == ROBERTS_OK && b < a->body_count; b++)
        if (a->is_convex[b])
            status = store_convex(a, b, error);
done:
    free(first);
    free(map.face);
    free(map.vertex);
    free(key);
    return status;
}

roberts_status bodies_build(roberts_scene *scene, const roberts_mesh *mesh, const roberts_scene_options *options,
                            bool known, roberts_error *error)
{
    assembly a = {.scene = scene, .mesh = mesh, .options = options, .surface = {.mesh = mesh}};
    roberts_status status = sort_components(&a, known, error);
    if (status == ROBERTS_OK) {
        a.surface.name = a.name;
        double touching = bodies_touching(scene, mesh);
        face_rules rules = {mesh->vertex, options->tolerance, touching, scene->unit, options->even_odd};
        if (!surface_take_faces(&a.surface, a.listed, &rules) || !surface_find_edges(&a.surface, touching) ||
            !list_all(&a) || !number_bodies(&a))
            status = ROBERTS_NO_MEMORY;
        else if (a.body_count == 0)
            status =
                error_set(error, ROBERTS_NOT_CLOSED, 0, "there is nothing to draw: no face has area, no edge length");
        else
            status = lay_out(&a) ? fill_scene(&a, error) : ROBERTS_NO_MEMORY;
    }
    polygons_free(&a.faces);
    polygons_free(&a.all);
    surface_free(&a.surface);
    builder_free(&a.work);
    free(a.listed);
    free(a.name);
    free(a.of);
    free(a.number);
    free(a.is_convex);
    return status == ROBERTS_NO_MEMORY ? error_no_memory(error) : status;
}

/* ---- wires beside convex solids -------------------------------------------------------------------------------- */

static uint64_t edge_name(uint32_t a, uint32_t b)
{
    return a < b ? (uint64_t)a << 32 | b : (uint64_t)b << 32 | a;
}

static bool is_wire(const roberts_mesh *mesh, size_t f)
{
    const uint32_t *corner = mesh->corner + mesh->face_start[f];
    return mesh->face_start[f + 1] - mesh->face_start[f] == 2 && corner[0] != corner[1];
}

/* The names of all edges of a scene of convex solids, sorted. */
static uint64_t *list_names(const roberts_scene *scene)
{
    uint64_t *name = alloc_array(scene->edge_count, sizeof *name);
    for (uint32_t s = 0; name && s < scene->solid_count; s++)
        for (uint32_t e = scene->solid[s].edge; e < scene->solid[s + 1].edge; e++) {
            const scene_edge edge = scene_edge_at(scene, s, e);
            name[e] = edge_name(scene_vertex_number(scene, edge.v[0]), scene_vertex_number(scene, edge.v[1]));
        }
    if (name)
        qsort(name, scene->edge_count, sizeof *name, compare_u64);
    return name;
}

bool bodies_wires(const roberts_scene *scene, const roberts_mesh *mesh, bool *found)
{
    size_t f = 0;
    *found = false;
    while (f < mesh->face_count && !is_wire(mesh, f))
        f++;
    if (f == mesh->face_count)
        return true;
    uint64_t *name = list_names(scene);
    for (; name && f < mesh->face_count && !*found; f++) {
        if (!is_wire(mesh, f))
            continue;
        uint64_t own = edge_name(mesh->corner[mesh->face_start[f]], mesh->corner[mesh->face_start[f] + 1]);
        *found = !bsearch(&own, name, scene->edge_count, sizeof *name, compare_u64);
    }
    bool enough = name != NULL;
    free(name);
    return enough;
}

/* ---- the scene's lookups --------------------------------------------------------------------------------------- */

const scene_many *scene_many_at(const roberts_scene *scene, uint32_t edge)
{
    const scene_surface *s = scene->surface;
    uint32_t low = 0, high = s->many_count;
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        if (s->many[middle].edge < edge)
            low = middle + 1;
        else
            high = middle;
    }
    return &s->many[low];
}

const scene_part *scene_part_at(const roberts_scene *scene, uint32_t edge)
{
    const scene_surface *s = scene->surface;
    uint32_t low = 0, high = s->part_count;
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        if (s->part[middle].edge < edge)
            low = middle + 1;
        else
            high = middle;
    }
    return &s->part[low];
}

void scene_surface_free(scene_surface *s)
{
    if (!s)
        return;
    free(s->kind);
    free(s->smooth);
    free(s->edge_is);
    free(s->plane_of);
    free(s->many);
    free(s->many_face);
    free(s->part);
    free(s);
}
