/* clip_surface.c - clips bodies that are not convex by the near plane. Each piece of a face is clipped separately. Caps
 * close a closed body; their edges are not drawn. An open body stays open, and its inside can be seen. */
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "model/face_pieces.h"
#include "view/cutter.h"

/* A side of a face, or an edge, that the plane cuts. */
typedef struct cut_side {
    uint32_t v[2];   /* v[0] < v[1] */
    uint32_t vertex; /* of the clipped scene */
} cut_side;

bool cutter_begin_surface(cutter *c)
{
    const roberts_scene *from = c->from;
    scene_surface *to = c->clip->scene.surface = alloc_zeroed(1, sizeof *to);
    if (!to)
        return false;
    to->kind = alloc_array(from->solid_count, 1);
    to->smooth = alloc_array(from->solid_count, 1);
    if (!to->kind || !to->smooth)
        return false;
    memcpy(to->kind, from->surface->kind, from->solid_count);
    memcpy(to->smooth, from->surface->smooth, from->solid_count);
    return true;
}

static int compare_sides(const void *pa, const void *pb)
{
    const cut_side *a = pa, *b = pb;
    if (a->v[0] != b->v[0])
        return a->v[0] < b->v[0] ? -1 : 1;
    return (a->v[1] > b->v[1]) - (a->v[1] < b->v[1]);
}

static bool list_side(cutter *c, uint32_t a, uint32_t b)
{
    if (cutter_keeps(c, a) == cutter_keeps(c, b))
        return true;
    if (!array_reserve(&c->side, &c->side_room, c->side_count + 1, sizeof *c->side))
        return false;
    c->side[c->side_count++] = (cut_side){{a < b ? a : b, a < b ? b : a}, ROBERTS_NONE};
    return true;
}

static uint32_t find_cut(const cutter *c, uint32_t a, uint32_t b)
{
    cut_side key = {{a < b ? a : b, a < b ? b : a}, 0};
    const cut_side *found = bsearch(&key, c->side, c->side_count, sizeof *c->side, compare_sides);
    return found->vertex;
}

/* Returns where the near plane cuts the side from a to b. */
static double cut_at(const cutter *c, uint32_t a, uint32_t b)
{
    return (c->near - c->depth[a]) / (c->depth[b] - c->depth[a]);
}

/* Adds the vertices that are kept, and a new vertex on each side that is cut. False: no memory. */
static bool cut_vertices(cutter *c, uint32_t body)
{
    const roberts_scene *from = c->from;
    const scene_solid *own = &from->solid[body];
    const roberts_vec3 none = {0.0, 0.0, 0.0};
    size_t to = 0;
    c->side_count = 0;
    for (uint32_t v = own->vertex; v < own[1].vertex; v++) {
        c->vertex[v] = cutter_keeps(c, v) ? c->clip->scene.vertex_count : ROBERTS_NONE;
        if (cutter_keeps(c, v) &&
            !cutter_add_vertex(c, from->point[v], from->low ? from->low[v] : none, scene_vertex_number(from, v)))
            return false;
    }
    for (uint32_t f = own->face; f < own[1].face; f++)
        for (uint32_t first = from->face_start[f], end = from->face_start[f + 1], k = first; k < end; k++)
            if (!list_side(c, from->corner[k], from->corner[k + 1 < end ? k + 1 : first]))
                return false;
    for (uint32_t e = own->edge; e < own[1].edge; e++) {
        const scene_edge *edge = scene_edge_stored(from, body, e);
        if (!list_side(c, own->vertex + edge->v[0], own->vertex + edge->v[1]))
            return false;
    }
    if (c->side_count > 1)
        qsort(c->side, c->side_count, sizeof *c->side, compare_sides);
    for (size_t i = 0; i < c->side_count; i++) {
        cut_side side = c->side[i];
        if (to > 0 && compare_sides(&side, &c->side[to - 1]) == 0)
            continue;
        side.vertex = c->clip->scene.vertex_count;
        c->side[to++] = side;
        if (!cutter_add_cut(c, from->point[side.v[0]], from->point[side.v[1]], cut_at(c, side.v[0], side.v[1])))
            return false;
    }
    c->side_count = to;
    return true;
}

static bool add_plane_of(cutter *c, uint32_t plane_of)
{
    scene_surface *to = c->clip->scene.surface;
    uint32_t count = c->clip->scene.face_count;
    if (!array_reserve(&to->plane_of, &c->plane_of_room, count, sizeof *to->plane_of))
        return false;
    to->plane_of[count - 1] = plane_of;
    return true;
}

/* A stretch of the cut, where a clipped face ends in the plane. */
typedef struct cut_line {
    uint32_t from, to;
} cut_line;

typedef struct cut_lines {
    cut_line *item;
    size_t count, room;
} cut_lines;

/* Clips one face. `lines` receives the cut, if there is one. False: no memory. */
static bool cut_face(cutter *c, uint32_t face, uint32_t *to_face, cut_lines *lines)
{
    const roberts_scene *from = c->from;
    uint32_t first = from->face_start[face], end = from->face_start[face + 1];
    uint32_t begin = (uint32_t)c->clip->scene.corner_count;
    cut_line line = {ROBERTS_NONE, ROBERTS_NONE};
    for (uint32_t k = first; k < end; k++) {
        uint32_t a = from->corner[k], b = from->corner[k + 1 < end ? k + 1 : first];
        if (cutter_keeps(c, a) && !cutter_add_corner(c, c->vertex[a]))
            return false;
        if (cutter_keeps(c, a) == cutter_keeps(c, b))
            continue;
        uint32_t cut = find_cut(c, a, b);
        if (cutter_keeps(c, a))
            line.from = cut;
        else
            line.to = cut;
        if (!cutter_add_corner(c, cut))
            return false;
    }
    *to_face = ROBERTS_NONE;
    if (c->clip->scene.corner_count == begin)
        return true;
    if (line.from != ROBERTS_NONE && line.to != ROBERTS_NONE) {
        if (!array_reserve(&lines->item, &lines->room, lines->count + 1, sizeof *lines->item))
            return false;
        lines->item[lines->count++] = line;
    }
    *to_face = c->clip->scene.face_count;
    if (!cutter_add_face(c, scene_plane(from, face), scene_deviation(from, face), scene_width(from, face),
                         scene_face_number(from, face)) ||
        !add_plane_of(c, scene_plane_number(from, face)))
        return false;
    if (c->clip->scene.surface->whole)
        c->clip->scene.surface->whole[*to_face] = scene_whole_plane(from, face);
    return true;
}

/* Adds the remaining faces of an edge with more than two. False: no memory. */
static bool add_many(cutter *c, const scene_many *many, const uint32_t *map, uint32_t edge)
{
    const uint32_t *face = c->from->surface->many_face;
    scene_surface *to = c->clip->scene.surface;
    size_t first = c->many_faces;
    if (!array_reserve(&to->many, &c->many_room, to->many_count + (size_t)1, sizeof *to->many) ||
        !array_reserve(&to->many_face, &c->many_face_room, first + many->end - many->first, sizeof *to->many_face))
        return false;
    for (uint32_t k = many->first; k < many->end; k++)
        if (map[face[k] & ~MANY_TURNED] != ROBERTS_NONE)
            to->many_face[c->many_faces++] = map[face[k] & ~MANY_TURNED] | (face[k] & MANY_TURNED);
    to->many[to->many_count++] = (scene_many){edge, (uint32_t)first, (uint32_t)c->many_faces};
    return true;
}

/* Moves the faces of an edge up if the plane has removed the first one. An edge may end beside a corner of its face, so
 * the edge can remain without the face. */
static void shift_faces(const scene_surface *surface, uint32_t first_face, scene_edge *edge, uint8_t *is)
{
    uint32_t face[2] = {edge->f[1], ROBERTS_NONE};
    bool turned[2] = {(*is & EDGE_TURNED_1) != 0, false};
    if (edge->f[0] != ROBERTS_NONE)
        return;
    if (*is & EDGE_MANY) {
        const scene_many *many = &surface->many[surface->many_count - 1];
        for (uint32_t k = 0; k < 2; k++) {
            bool stays = many->first + k < many->end;
            uint32_t own = stays ? surface->many_face[many->first + k] : 0;
            face[k] = stays ? (own & ~MANY_TURNED) - first_face : ROBERTS_NONE;
            turned[k] = own & MANY_TURNED;
        }
    }
    edge->f[0] = face[0];
    edge->f[1] = face[1];
    *is = (uint8_t)((*is & ~(EDGE_TURNED_0 | EDGE_TURNED_1)) | (turned[0] ? EDGE_TURNED_0 : 0) |
                    (turned[1] ? EDGE_TURNED_1 : 0));
}

/* Adds the remainder of an edge. False: no memory. */
static bool cut_edge(cutter *c, uint32_t body, uint32_t e, const uint32_t *map)
{
    const roberts_scene *from = c->from;
    const scene_solid *own = &from->solid[body];
    const scene_edge *edge = scene_edge_stored(from, body, e);
    scene_surface *to = c->clip->scene.surface;
    clip_edge *origin = &c->clip->origin[e];
    uint32_t a = own->vertex + edge->v[0], b = own->vertex + edge->v[1], number = c->clip->scene.edge_count, f[2];
    *origin = (clip_edge){ROBERTS_NONE, 0.0, 1.0};
    if (!cutter_keeps(c, a) && !cutter_keeps(c, b))
        return true;
    uint32_t v0 = c->vertex[a], v1 = c->vertex[b];
    if (cutter_keeps(c, a) != cutter_keeps(c, b)) {
        double t = a < b ? cut_at(c, a, b) : 1.0 - cut_at(c, b, a);
        *(cutter_keeps(c, a) ? &origin->t1 : &origin->t0) = t;
        *(cutter_keeps(c, a) ? &v1 : &v0) = find_cut(c, a, b);
    }
    origin->edge = number;
    for (int k = 0; k < 2; k++)
        f[k] = edge->f[k] == ROBERTS_NONE ? ROBERTS_NONE : map[own->face + edge->f[k]];
    uint8_t is = from->surface->edge_is[e];
    if (!cutter_add_edge(c, v0, v1, c->first.face, c->first.face, false) ||
        !array_reserve(&to->edge_is, &c->edge_is_room, number + (size_t)1, 1))
        return false;
    for (int k = 0; k < 2; k++)
        c->clip->scene.edge[number].f[k] = f[k] == ROBERTS_NONE ? ROBERTS_NONE : f[k] - c->first.face;
    if (is & EDGE_MANY && !add_many(c, scene_many_at(from, e), map, number))
        return false;
    shift_faces(to, c->first.face, &c->clip->scene.edge[number], &is);
    to->edge_is[number] = is;
    if (is & EDGE_PART) {
        if (!array_reserve(&to->part, &c->part_room, to->part_count + (size_t)1, sizeof *to->part))
            return false;
        to->part[to->part_count] = *scene_part_at(from, e);
        to->part[to->part_count++].edge = number;
    }
    return true;
}

/* ---- caps ------------------------------------------------------------------------------------------------------ */

static int compare_lines(const void *pa, const void *pb)
{
    const cut_line *a = pa, *b = pb;
    if (a->from != b->from)
        return a->from < b->from ? -1 : 1;
    return (a->to > b->to) - (a->to < b->to);
}

/* Returns the first of the sorted lines that begins at a vertex. */
static size_t first_from(const cut_line *both, size_t count, uint32_t vertex)
{
    size_t low = 0, high = count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (both[middle].from < vertex)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Joins all lines into one ring. Each line is followed by one that begins or ends where it ends. Between loops, the
 * ring goes to its first vertex and back: by the odd-even rule, a path that runs both ways bounds nothing. `both` lists
 * each line in both directions; used[] has an entry for each of them. */
static size_t make_ring(const cut_line *both, size_t count, uint8_t *used, uint32_t *ring)
{
    size_t length = 0;
    for (size_t i = 0; i < count; i++) {
        if (used[i])
            continue;
        uint32_t start = both[i].from, at = start;
        ring[length++] = start;
        for (;;) {
            size_t low = first_from(both, count, at);
            while (low < count && both[low].from == at && used[low])
                low++;
            if (low == count || both[low].from != at)
                break;
            cut_line back = {both[low].to, both[low].from};
            used[low] = 1;
            at = both[low].to;
            for (size_t k = first_from(both, count, back.from); k < count && both[k].from == back.from; k++)
                if (both[k].to == back.to && !used[k]) {
                    used[k] = 1;
                    break;
                }
            ring[length++] = at;
        }
        if (at != start)
            ring[length++] = start; /* left open by rounding: closed by a straight line */
        ring[length++] = ring[0];
    }
    return length;
}

/* Adds the cap's pieces as faces without a number. They hide, but have no edges. False: no memory. */
static bool add_cap(cutter *c, const uint32_t *ring, size_t count)
{
    roberts_scene *to = &c->clip->scene;
    face_pieces pieces = {0};
    face_rules rules = {to->point, 1e-9, c->touching, to->unit, true};
    bool enough = face_pieces_cut(&pieces, &rules, ring, (uint32_t)count);
    uint32_t plane_of = ROBERTS_NONE - 1; /* a key that no edge lists */
    for (size_t n = 0; enough && n < pieces.node_count; n++)
        if (pieces.node[n].vertex == ROBERTS_NONE) {
            pieces.node[n].vertex = to->vertex_count;
            enough = cutter_add_vertex(c, pieces.node[n].point, pieces.node[n].low, ROBERTS_NONE);
        }
    for (size_t p = 0; enough && p < pieces.piece_count; p++) {
        const face_piece *piece = &pieces.piece[p];
        roberts_vec3 n = pieces.fit.n;
        double side = vec3_dot(n, c->dir) > 0.0 ? 1.0 : -1.0;
        plane F = {-side * c->dir.x, -side * c->dir.y, -side * c->dir.z, 0.0};
        F.d = side * (vec3_dot(c->dir, vec3_sub(c->eye, c->from->centre)) - c->near);
        for (uint32_t i = 0; enough && i < piece->count; i++)
            enough = cutter_add_corner(c, pieces.node[piece->node[i]].vertex);
        enough =
            enough && cutter_add_face(c, F, c->touching, pieces.fit.width, ROBERTS_NONE) && add_plane_of(c, plane_of);
    }
    face_pieces_free(&pieces);
    return enough;
}

static bool cap_lines(cutter *c, const cut_lines *lines)
{
    size_t count = 0;
    cut_line *both = alloc_array(2 * lines->count, sizeof *both);
    uint8_t *used = alloc_zeroed(2 * lines->count, 1);
    uint32_t *ring = alloc_array(6 * lines->count + 1, sizeof *ring);
    bool enough = both && used && ring;
    for (size_t i = 0; enough && i < lines->count; i++) {
        if (lines->item[i].from == lines->item[i].to)
            continue;
        both[count++] = lines->item[i];
        both[count++] = (cut_line){lines->item[i].to, lines->item[i].from};
    }
    if (enough && count > 0) {
        qsort(both, count, sizeof *both, compare_lines);
        enough = add_cap(c, ring, make_ring(both, count, used, ring));
    }
    free(both);
    free(used);
    free(ring);
    return enough;
}

bool cutter_cut_surface(cutter *c, uint32_t body, uint32_t *map)
{
    const roberts_scene *from = c->from;
    const scene_solid *own = &from->solid[body];
    roberts_scene *to = &c->clip->scene;
    cut_lines lines = {0};
    c->first = (scene_solid){to->vertex_count, to->face_count, to->edge_count, to->edge_count};
    to->solid[body] = c->first;
    c->whole = true;
    for (uint32_t v = own->vertex; v < own[1].vertex; v++)
        c->whole = c->whole && c->depth[v] >= c->near;
    bool enough = cut_vertices(c, body);
    for (uint32_t f = own->face; enough && f < own[1].face; f++)
        enough = cut_face(c, f, &map[f], &lines);
    for (uint32_t e = own->edge; enough && e < own[1].edge; e++)
        enough = cut_edge(c, body, e, map);
    if (enough && lines.count > 0 && from->surface->kind[body] == ROBERTS_CLOSED)
        enough = cap_lines(c, &lines);
    free(lines.item);
    return enough;
}
