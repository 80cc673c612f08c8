/* body_edges.c - the edges of bodies that are not convex. See body_edges.h. Also lookups of such edges for later
 * stages, and wires beside convex solids. */
#include "model/body_edges.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/sort.h"

/* A body of more than ROBERTS_FACETED_MOST faces is a curved surface if at least half of its bent edges are bent only
 * slightly. Bends are squared distances of unit normals: above FLAT_BEND (0.1 degrees) an edge is bent, below
 * LITTLE_BEND (20 degrees) only slightly. */
#define FLAT_BEND 3.046e-6
#define LITTLE_BEND 0.1206

static uint32_t piece_of(uint32_t incidence)
{
    return incidence & ~SURFACE_TURNED;
}

/* ---- in order -------------------------------------------------------------------------------------------------- */

/* An edge and its name in the file. */
typedef struct edge_key {
    uint32_t v[2];
    double t;
    uint32_t edge; /* of the surface */
} edge_key;

static int compare_keys(const void *pa, const void *pb)
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

/* Sorts the edges of one body by their names. The surface has them sorted by their ends, which differ from the names
 * only for parts. False: no memory. */
static bool sort_by_name(const surface *s, uint32_t *order, uint32_t count)
{
    edge_key *key = alloc_array(count, sizeof *key);
    if (!key)
        return false;
    for (uint32_t i = 0; i < count; i++) {
        const surface_edge *e = &s->edge[order[i]];
        key[i] = (edge_key){{e->v[0], e->v[1]}, 0.0, order[i]};
        if (e->part != ROBERTS_NONE)
            key[i] = (edge_key){{s->part[e->part].v[0], s->part[e->part].v[1]}, s->part[e->part].t0, order[i]};
    }
    qsort(key, count, sizeof *key, compare_keys);
    for (uint32_t i = 0; i < count; i++)
        order[i] = key[i].edge;
    free(key);
    return true;
}

/* Counts the edges of each body, then lists them. During the listing, first[b] moves to the end of body b. */
static void sort_by_body(body_edges *list, const uint32_t *of, uint32_t bodies)
{
    const surface *s = list->surface;
    for (int pass = 0; pass < 2; pass++) {
        uint32_t odd = s->piece_count, sum = 0;
        for (uint32_t i = 0; i < s->edge_count; i++) {
            uint32_t body = of[s->edge[i].odd ? odd++ : piece_of(s->edge[i].piece[0])];
            if (pass == 0)
                list->first[body]++;
            else
                list->order[list->first[body]++] = i;
        }
        for (uint32_t b = 0; b <= bodies && pass == 0; b++) {
            uint32_t count = list->first[b];
            list->first[b] = sum;
            sum += count;
        }
    }
}

bool body_edges_list(body_edges *list, const surface *s, const uint32_t *of, uint32_t bodies)
{
    *list = (body_edges){.surface = s,
                         .order = alloc_array(s->edge_count, sizeof *list->order),
                         .first = alloc_zeroed(bodies + (size_t)1, sizeof *list->first),
                         .face = alloc_array(s->piece_count, sizeof *list->face),
                         .vertex = alloc_array(s->vertex_count, sizeof *list->vertex)};
    bool enough = list->order && list->first && list->face && list->vertex;
    if (enough) {
        sort_by_body(list, of, bodies);
        for (uint32_t b = bodies; b > 0; b--)
            list->first[b] = list->first[b - 1];
        list->first[0] = 0;
    }
    for (uint32_t b = 0; enough && s->edge_part_count > 0 && b < bodies; b++)
        enough = sort_by_name(s, list->order + list->first[b], body_edges_count(list, b));
    return enough;
}

/* ---- into the scene -------------------------------------------------------------------------------------------- */

/* Stores the faces of an edge with more than two. False: no memory. */
static bool store_many(body_edges *list, scene_surface *to, const surface_edge *e, uint32_t edge, bool back)
{
    const uint32_t *many = list->surface->many;
    uint32_t first = (uint32_t)list->many_faces, count = e->many_end - e->many;
    if (!array_reserve(&to->many, &list->many_room, to->many_count + (size_t)1, sizeof *to->many) ||
        !array_reserve(&to->many_face, &list->many_face_room, first + (size_t)count, sizeof *to->many_face))
        return false;
    to->many[to->many_count++] = (scene_many){edge, first, first + count};
    for (uint32_t k = e->many; k < e->many_end; k++) {
        bool turned = ((many[k] & SURFACE_TURNED) != 0) != back;
        to->many_face[list->many_faces++] = list->face[piece_of(many[k])] | (turned ? MANY_TURNED : 0);
    }
    return true;
}

static bool store_part(body_edges *list, scene_surface *to, const surface_edge *e, uint32_t edge)
{
    if (!array_reserve(&to->part, &list->part_room, to->part_count + (size_t)1, sizeof *to->part))
        return false;
    to->part[to->part_count] = list->surface->part[e->part];
    to->part[to->part_count++].edge = edge;
    return true;
}

enum { EVEN_MOST = 16 }; /* faces at an edge; to count more would take long */

/* Do the edge's pieces belong to an even number of faces? More than EVEN_MOST count as odd. */
static bool is_even(const surface *s, const surface_edge *e)
{
    uint32_t face[EVEN_MOST], count = 0;
    if (e->piece[1] == ROBERTS_NONE)
        return false;
    for (uint32_t k = e->many; e->many != ROBERTS_NONE && k < e->many_end; k++) {
        const uint32_t own = s->face[piece_of(s->many[k])];
        uint32_t i = 0;
        while (i < count && face[i] != own)
            i++;
        if (i == EVEN_MOST)
            return false;
        face[i] = own;
        count += i == count;
    }
    return count % 2 == 0;
}

/* Does the edge run opposite to the file's edge of which it is a part? */
static bool runs_back(const surface *s, const surface_edge *e)
{
    if (e->part == ROBERTS_NONE)
        return false;
    const scene_part *part = &s->part[e->part];
    return vec3_dot(vec3_sub(s->point[e->v[1]], s->point[e->v[0]]),
                    vec3_sub(s->point[part->v[1]], s->point[part->v[0]])) < 0.0;
}

bool body_edges_store(body_edges *list, roberts_scene *scene, uint32_t b)
{
    scene_surface *to = scene->surface;
    const surface *s = list->surface;
    const scene_solid *own = &scene->solid[b];
    uint32_t count = body_edges_count(list, b);
    bool closed = count > 0;
    for (uint32_t v = own->vertex; v < own[1].vertex; v++)
        list->vertex[scene->number[v]] = v - own->vertex;
    for (uint32_t i = 0; i < count; i++) {
        const surface_edge *e = &s->edge[list->order[list->first[b] + i]];
        uint32_t edge = own->edge + i, v0 = list->vertex[e->v[0]], v1 = list->vertex[e->v[1]];
        uint8_t is = e->cut ? EDGE_CUT : 0;
        scene_edge *stored = &scene->edge[own->stored + i];
        bool back = runs_back(s, e); /* a part runs in the same direction as its edge of the file */
        *stored = (scene_edge){{back ? v1 : v0, back ? v0 : v1}, {ROBERTS_NONE, ROBERTS_NONE}};
        for (int k = 0; k < 2 && e->piece[k] != ROBERTS_NONE; k++) {
            stored->f[k] = list->face[piece_of(e->piece[k])] - own->face;
            if (((e->piece[k] & SURFACE_TURNED) != 0) != back)
                is |= (uint8_t)(k ? EDGE_TURNED_1 : EDGE_TURNED_0);
        }
        is |= (uint8_t)((e->many != ROBERTS_NONE ? EDGE_MANY : 0) | (e->part != ROBERTS_NONE ? EDGE_PART : 0));
        if ((is & EDGE_MANY && !store_many(list, to, e, edge, back)) ||
            (is & EDGE_PART && !store_part(list, to, e, edge)))
            return false;
        to->edge_is[edge] = is;
        closed = closed && is_even(s, e);
    }
    to->kind[b] = closed ? ROBERTS_CLOSED : ROBERTS_OPEN;
    return true;
}

void body_edges_free(body_edges *list)
{
    free(list->order);
    free(list->first);
    free(list->face);
    free(list->vertex);
    *list = (body_edges){0};
}

/* ---- curved surfaces ------------------------------------------------------------------------------------------- */

void body_count_bend(bend_count *count, double bend)
{
    count->much += bend > FLAT_BEND && !(bend < LITTLE_BEND);
    count->little += bend > FLAT_BEND && bend < LITTLE_BEND;
}

bool body_is_smooth(const bend_count *count, uint32_t faces)
{
    return faces > ROBERTS_FACETED_MOST && count->little > 0 && count->little >= count->much;
}

/* Counts edges until the rest cannot change the result. */
bool body_smooth(const roberts_scene *scene, uint32_t b)
{
    const scene_solid *own = &scene->solid[b];
    const scene_edge *edge = scene->edge + own->stored;
    uint32_t faces = own[1].face - own->face;
    bend_count count = {0};
    for (uint32_t e = own->edge; e < own[1].edge && faces > ROBERTS_FACETED_MOST; e++, edge++) {
        uint32_t left = own[1].edge - e;
        uint8_t is = scene->surface->edge_is[e];
        if (count.little >= count.much + (uint64_t)left || count.much > count.little + (uint64_t)left)
            break;
        if (!(is & (EDGE_MANY | EDGE_CUT)) && edge->f[1] != ROBERTS_NONE)
            body_count_bend(&count, scene_bend(scene_plane(scene, own->face + edge->f[0]),
                                               scene_plane(scene, own->face + edge->f[1]), is));
    }
    return body_is_smooth(&count, faces);
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

/* Returns the names of all edges of a scene of convex solids, sorted. NULL: no memory. */
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

bool body_edges_wires(const roberts_scene *scene, const roberts_mesh *mesh, bool *found)
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
