/* surface.c - collects the pieces of all faces of bodies that are not convex, and their sides. A face with the same
 * corners as an earlier one is left out. */
#include "model/surface.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"

/* Returns a hash of a face's corners that does not depend on start or direction. */
static uint64_t hash_of(const uint32_t *corner, uint32_t count)
{
    uint64_t sum = count;
    for (uint32_t i = 0; i < count; i++) {
        uint64_t h = (corner[i] + 1) * 0x9e3779b97f4a7c15u;
        sum += h ^ h >> 32;
    }
    return (sum ^ sum >> 29) * 0x9e3779b97f4a7c15u;
}

/* Are these the same corners, from any start and in either direction? */
static bool same_round(const uint32_t *a, const uint32_t *b, uint32_t count)
{
    for (uint32_t first = 0; first < count; first++) {
        if (b[first] != a[0])
            continue;
        bool forward = true, backward = true;
        for (uint32_t i = 1; i < count && (forward || backward); i++) {
            forward = forward && a[i] == b[(first + i) % count];
            backward = backward && a[i] == b[(first + count - i) % count];
        }
        if (forward || backward)
            return true;
    }
    return false;
}

/* A hash table of faces. */
typedef struct face_set {
    uint32_t *slot;  /* [size] faces; ROBERTS_NONE: free */
    size_t size;     /* a power of two */
    uint32_t *other; /* scratch: the corners of a face found in the table */
    size_t other_room;
} face_set;

static uint32_t take_corners(const surface *s, uint32_t f, uint32_t *to)
{
    const roberts_mesh *mesh = s->mesh;
    uint32_t n = mesh->face_start[f + 1] - mesh->face_start[f];
    memcpy(to, s->vertex_of + mesh->face_start[f], n * sizeof *to);
    return n;
}

/* Slots tried first: those near other faces with the same least vertex. In most files the next faces are there too. */
enum { NEAR_SLOTS = 8 };

/* Does the face with these corners repeat face g? False: no memory. */
static bool repeats_face(face_set *set, const surface *s, uint32_t g, const uint32_t *corner, uint32_t count,
                         bool *repeats)
{
    *repeats = false;
    if (s->mesh->face_start[g + 1] - s->mesh->face_start[g] != count)
        return true;
    if (!array_reserve(&set->other, &set->other_room, count, sizeof *set->other))
        return false;
    take_corners(s, g, set->other);
    *repeats = same_round(corner, set->other, count);
    return true;
}

/* Enters a face. *repeats: the table already has a face with the same corners. False: no memory. */
static bool enter_face(face_set *set, const surface *s, uint32_t f, const uint32_t *corner, uint32_t count,
                       bool *repeats)
{
    uint32_t least = corner[0];
    for (uint32_t i = 1; i < count; i++)
        least = corner[i] < least ? corner[i] : least;
    size_t at = (size_t)((double)least / (double)s->mesh->vertex_count * (double)set->size) & (set->size - 1);
    *repeats = false;
    for (size_t tries = 0; set->slot[at] != ROBERTS_NONE; tries++) {
        if (!repeats_face(set, s, set->slot[at], corner, count, repeats))
            return false;
        if (*repeats)
            return true;
        at =
            tries == NEAR_SLOTS ? (size_t)(hash_of(corner, count) >> 20) & (set->size - 1) : (at + 1) & (set->size - 1);
    }
    set->slot[at] = f;
    return true;
}

/* Adds a vertex after those of the mesh. ROBERTS_NONE: no memory. */
static uint32_t add_vertex(surface *s, roberts_vec3 point, roberts_vec3 low)
{
    uint32_t before = s->vertex_count;
    if (before == ROBERTS_NONE - 1 ||
        !array_reserve(&s->own_point, &s->point_room, before + (size_t)1, sizeof *s->own_point) ||
        !array_reserve(&s->low, &s->low_room, before + (size_t)1, sizeof *s->low))
        return ROBERTS_NONE;
    if (before == s->mesh->vertex_count) {
        memcpy(s->own_point, s->mesh->vertex, before * sizeof *s->own_point);
        memset(s->low, 0, before * sizeof *s->low);
    }
    s->own_point[before] = point;
    s->low[before] = low;
    s->point = s->own_point;
    return s->vertex_count++;
}

/* Adds the copies of vertices. False: no memory. */
static bool add_copies(surface *s)
{
    for (uint32_t i = 0; i < s->copies; i++)
        if (add_vertex(s, s->mesh->vertex[s->copied[i]], (roberts_vec3){0, 0, 0}) == ROBERTS_NONE)
            return false;
    return true;
}

static bool add_surface_side(surface *s, uint32_t v0, uint32_t v1, uint32_t piece)
{
    if (s->side_count >= ROBERTS_NONE || !array_reserve(&s->side, &s->side_room, s->side_count + 1, sizeof *s->side))
        return false;
    s->side[s->side_count++] = (surface_side){{v0, v1}, piece};
    return true;
}

static bool add_surface_piece(surface *s, const face_pieces *p, const face_piece *piece, uint32_t face,
                              uint32_t plane_of)
{
    size_t n = s->piece_count;
    if (n >= SURFACE_SHADOW || !array_reserve(&s->start, &s->start_room, n + 2, sizeof *s->start) ||
        !array_reserve(&s->corner, &s->corner_room, s->corner_count + piece->count, sizeof *s->corner) ||
        !array_reserve(&s->face, &s->face_room, n + 1, sizeof *s->face) ||
        !array_reserve(&s->plane_of, &s->plane_room, n + 1, sizeof *s->plane_of))
        return false;
    s->start[n] = (uint32_t)s->corner_count;
    for (uint32_t i = 0; i < piece->count; i++)
        s->corner[s->corner_count++] = p->node[piece->node[i]].vertex;
    s->start[n + 1] = (uint32_t)s->corner_count;
    if (piece->winding != 1) {
        if (!array_reserve(&s->wound, &s->wound_room, s->wound_count + 1, sizeof *s->wound))
            return false;
        s->wound[s->wound_count++] = (surface_wound){(uint32_t)n, piece->winding};
    }
    s->face[n] = face;
    s->plane_of[n] = plane_of;
    s->piece_count++;
    return s->corner_count < ROBERTS_NONE;
}

double surface_part_of(const surface *s, const uint32_t v[2], uint32_t at)
{
    const roberts_vec3 none = {0.0, 0.0, 0.0};
    roberts_vec3 A = s->point[v[0]], AB = vec3_sub(s->point[v[1]], A);
    roberts_vec3 AP = vec3_add(vec3_sub(s->point[at], A), s->low ? s->low[at] : none);
    return at == v[0] ? 0.0 : at == v[1] ? 1.0 : greater(0.0, lesser(1.0, vec3_part_along(AP, AB)));
}

/* Records that the last side is a part of the file's side from a to b. False: no memory. */
static bool note_part(surface *s, uint32_t a, uint32_t b)
{
    const surface_side *side = &s->side[s->side_count - 1];
    if ((side->v[0] == a && side->v[1] == b) || (side->v[0] == b && side->v[1] == a))
        return true;
    if (!array_reserve(&s->side_part, &s->part_room, s->part_count + 1, sizeof *s->side_part))
        return false;
    uint32_t from = a < b ? a : b, to = a < b ? b : a;
    double t[2];
    for (int i = 0; i < 2; i++)
        t[i] = surface_part_of(s, (uint32_t[]){from, to}, side->v[i]);
    s->side_part[s->part_count++] =
        (scene_part){(uint32_t)(s->side_count - 1), {from, to}, lesser(t[0], t[1]), greater(t[0], t[1])};
    return true;
}

/* Takes over the pieces of a face, its crossings as vertices, and its sides. False: no memory. */
static bool take_pieces(surface *s, face_pieces *p, uint32_t face, const uint32_t *corner, uint32_t count)
{
    uint32_t first = s->piece_count;
    s->whole_sides = s->whole_sides || p->whole_sides;
    for (size_t n = 0; n < p->node_count && p->piece_count > 0; n++)
        if (p->node[n].vertex == ROBERTS_NONE &&
            (p->node[n].vertex = add_vertex(s, p->node[n].point, p->node[n].low)) == ROBERTS_NONE)
            return false;
    for (size_t k = 0; k < p->piece_count; k++)
        if (!add_surface_piece(s, p, &p->piece[k], face, p->planar ? first : s->piece_count))
            return false;
    if (p->planar && p->piece_count > 1) {
        if (!array_reserve(&s->fit, &s->fit_room, s->fit_count + 1, sizeof *s->fit))
            return false;
        s->fit[s->fit_count++] =
            (surface_fit){first, p->node[p->ring[0]].vertex, p->fit.n, p->fit.mean, p->fit.deviation, p->fit.width};
    }
    for (size_t k = 0; k < p->side_count; k++) {
        const piece_side *side = &p->side[k];
        uint32_t cut = side->side == ROBERTS_NONE ? SURFACE_CUT : 0;
        if (!add_surface_side(s, p->node[side->from].vertex, p->node[side->to].vertex, (first + side->piece) | cut))
            return false;
        if (!cut && !note_part(s, corner[side->side], corner[side->side + 1 < count ? side->side + 1 : 0]))
            return false;
    }
    return true;
}

/* Adds the sides of elements that hide nothing: those with two corners, and faces without area. False: no memory. */
static bool take_wires(surface *s, const uint32_t *corner, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        uint32_t a = corner[i], b = corner[i + 1 < count ? i + 1 : 0];
        if (a != b && !(count == 2 && i == 1) && !add_surface_side(s, a, b, SURFACE_WIRE))
            return false;
    }
    return true;
}

static void note(noted_faces *faces, uint32_t face)
{
    if (faces->count++ == 0)
        faces->first = face;
    faces->last = face;
}

static bool take_face(surface *s, face_pieces *p, const face_rules *rules, uint32_t face, const uint32_t *corner,
                      uint32_t count)
{
    if (count < 3)
        return count < 2 || take_wires(s, corner, count);
    if (!face_pieces_cut(p, rules, corner, count))
        return false;
    if (p->bent)
        note(&s->bent, face);
    if (p->uncut)
        note(&s->uncut, face);
    return p->piece_count > 0 ? take_pieces(s, p, face, corner, count) : take_wires(s, corner, count);
}

/* Adds the sides of faces that are not listed, so that wires along them are left out. False: no memory. */
static bool take_shadows(surface *s, const uint8_t *listed)
{
    const roberts_mesh *mesh = s->mesh;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        uint32_t first = mesh->face_start[f], end = mesh->face_start[f + 1];
        for (uint32_t k = first; k < end && listed[f] == LISTED_NOT; k++) {
            uint32_t a = s->vertex_of[k], b = s->vertex_of[k + 1 < end ? k + 1 : first];
            if (a != b && !add_surface_side(s, a, b, SURFACE_SHADOW))
                return false;
        }
    }
    return true;
}

bool surface_take_faces(surface *s, const uint8_t *listed, const face_rules *rules)
{
    const roberts_mesh *mesh = s->mesh;
    face_pieces pieces = {0};
    face_set set = {0};
    uint32_t *corner = NULL;
    size_t room = 0;
    bool enough = true, wires = false;
    for (set.size = 16; set.size < 2 * mesh->face_count; set.size *= 2)
        continue;
    s->point = mesh->vertex;
    s->vertex_count = (uint32_t)mesh->vertex_count;
    set.slot = alloc_array(set.size, sizeof *set.slot);
    enough = set.slot && array_reserve(&s->start, &s->start_room, 1, sizeof *s->start) && add_copies(s);
    if (enough) {
        memset(set.slot, 0xff, set.size * sizeof *set.slot);
        s->start[0] = 0;
    }
    for (uint32_t f = 0; enough && f < mesh->face_count; f++) {
        uint32_t n = mesh->face_start[f + 1] - mesh->face_start[f];
        bool repeats = false;
        if (listed[f] == LISTED_NOT || n < 2)
            continue;
        enough = array_reserve(&corner, &room, n, sizeof *corner);
        if (!enough)
            break;
        face_rules own = *rules;
        own.point = s->point; /* moves when vertices are added */
        own.narrow = listed[f] == LISTED_CLOSED ? rules->narrow : rules->touching;
        take_corners(s, f, corner);
        enough = enter_face(&set, s, f, corner, n, &repeats);
        if (repeats)
            note(&s->repeated, f);
        enough = enough && (repeats || take_face(s, &pieces, &own, f, corner, n));
        wires = wires || n == 2;
    }
    if (enough && wires)
        enough = take_shadows(s, listed);
    free(corner);
    free(set.slot);
    free(set.other);
    face_pieces_free(&pieces);
    return enough;
}

void surface_free(surface *s)
{
    free(s->own_point);
    free(s->low);
    free(s->start);
    free(s->corner);
    free(s->face);
    free(s->plane_of);
    free(s->fit);
    free(s->wound);
    free(s->side);
    free(s->side_part);
    free(s->edge);
    free(s->many);
    free(s->part);
    *s = (surface){0};
}
