/* clip.c - clipping by the near plane. See clip.h. Each face, or convex piece of one, is clipped separately (I. E.
 * Sutherland, G. W. Hodgman, "Reentrant polygon clipping", CACM 17(1), 1974). The cuts of a solid's faces form the
 * outline of its cap. The cap of a closed body that is not convex is cut into convex pieces. The edges of caps are no
 * lines here (see hide/cuts.h). An open body stays open, and its inside can be seen. */
#include "view/clip.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/dd.h"
#include "base/error.h"
#include "base/search.h"
#include "base/sort.h"
#include "model/face_pieces.h"
#include "model/face_plane.h"
#include "model/winding.h"
#include "view/cut_ring.h"
#include "view/view.h"

/* The default distance of the near plane: this fraction of the look-at point's distance, and at least this fraction of
 * the scene's diameter. Nearer things would appear a thousand times as large as at the look-at point. */
#define NEAR_OF_DISTANCE 1e-3
#define NEAR_OF_DIAMETER 1e-5
/* The least distance of the near plane, even if a smaller one is given, as a fraction of the scene's diameter.
 * Coordinates in the picture grow in inverse proportion to it, and so does the touching distance. */
#define NEAR_LEAST 1e-6
/* In ulps of the largest coordinate, the eye's included. A point nearer to the near plane than this lies in it; an eye
 * nearer to a face than this lies on it. */
#define TOUCHING_ULPS 16.0
/* How far corners of a cap may lie beside the near plane, as a part of its size: they do by rounding alone. */
#define CAP_TOLERANCE 1e-9

/* A side of a face, or an edge, that the plane cuts. */
typedef struct cut_side {
    uint32_t v[2];   /* v[0] < v[1] */
    uint32_t vertex; /* of the clipped scene */
} cut_side;

/* A scene that is being clipped. */
typedef struct cutter {
    view_clip *clip;
    const roberts_scene *from;
    double touching; /* model units: a point nearer to the near plane than this lies in it, an eye nearer to a face lies
                        on it */
    scene_solid first; /* first vertex, face and edge of the current solid in the clipped scene */
    bool whole;        /* no vertex of the current solid is in front of the near plane: it is not cut */
    double *depth;     /* [vertex_count of from] see view_clip_depth() */
    int32_t *winding;  /* [face_count of from] see winding_find() */
    uint32_t *vertex;  /* [vertex_count of from] number in the clipped scene, or ROBERTS_NONE */
    uint32_t *cut;     /* [edge_count of from] vertex at which the edge is cut, or ROBERTS_NONE */
    uint32_t *next; /* [edge_count of from] next cut edge round the cap, counter-clockwise; a permutation of a solid's
                       cut edges, since each leads into one of its faces and out of the other */
    roberts_vec3 *ring; /* [corners] scratch: positions of the corners of a clipped face */
    size_t vertex_room, low_room, number_room, start_room, corner_room, plane_room, deviation_room, width_room,
        face_room;
    size_t edge_room, cap_room, ring_room, sheet_room;
    cut_side *side; /* [side_count] cut sides of a body that is not convex, sorted by their ends */
    size_t side_count, side_room, plane_of_room, whole_room, edge_is_room, many_room, many_face_room, part_room,
        many_faces;
} cutter;

/* Is the vertex kept? A vertex in the plane is cut off with those in front of it. So no face degenerates to a line, and
 * no cap lies on a face. */
static inline bool cutter_keeps(const cutter *c, uint32_t v)
{
    return c->depth[v] > c->clip->near || c->whole;
}

/* These functions return false if there is no memory. */
static bool cutter_add_vertex(cutter *c, roberts_vec3 point, roberts_vec3 low, uint32_t number)
{
    roberts_scene *to = &c->clip->scene;
    size_t need = (size_t)to->vertex_count + 1;
    if (!array_reserve(&to->point, &c->vertex_room, need, sizeof *to->point) ||
        !array_reserve(&to->low, &c->low_room, need, sizeof *to->low) ||
        !array_reserve(&to->number, &c->number_room, need, sizeof *to->number))
        return false;
    to->point[to->vertex_count] = point;
    to->low[to->vertex_count] = low;
    to->number[to->vertex_count++] = number;
    return true;
}

static bool cutter_add_corner(cutter *c, uint32_t vertex)
{
    roberts_scene *to = &c->clip->scene;
    if (!array_reserve(&to->corner, &c->corner_room, to->corner_count + 1, sizeof *to->corner))
        return false;
    to->corner[to->corner_count++] = vertex;
    return true;
}

/* Completes the face whose corners have been added. */
static bool cutter_add_face(cutter *c, plane F, double deviation, double width, uint32_t number)
{
    roberts_scene *to = &c->clip->scene;
    size_t f = to->face_count, need = f + 1;
    if (to->corner_count > UINT32_MAX ||
        !array_reserve(&to->face_start, &c->start_room, need + 1, sizeof *to->face_start) ||
        !array_reserve(&to->face_plane, &c->plane_room, need, sizeof *to->face_plane) ||
        !array_reserve(&to->face_deviation, &c->deviation_room, need, sizeof *to->face_deviation) ||
        !array_reserve(&to->face_width, &c->width_room, need, sizeof *to->face_width) ||
        !array_reserve(&to->face_number, &c->face_room, need, sizeof *to->face_number))
        return false;
    if (scene_has_bent_faces(c->from)) {
        if (!array_reserve(&to->surface->whole, &c->whole_room, need, sizeof *to->surface->whole))
            return false;
        to->surface->whole[f] = F;
    }
    to->face_plane[f] = F;
    scene_set_bounds(to, (uint32_t)f, deviation, width);
    to->face_number[f] = number;
    to->face_start[++to->face_count] = (uint32_t)to->corner_count;
    return true;
}

static bool cutter_add_edge(cutter *c, uint32_t v0, uint32_t v1, uint32_t f0, uint32_t f1, bool cap)
{
    roberts_scene *to = &c->clip->scene;
    size_t need = (size_t)to->edge_count + 1;
    if (!array_reserve(&to->edge, &c->edge_room, need, sizeof *to->edge) ||
        !array_reserve(&c->clip->cap, &c->cap_room, need, sizeof *c->clip->cap))
        return false;
    c->clip->cap[to->edge_count] = cap;
    to->edge[to->edge_count++] =
        (scene_edge){{v0 - c->first.vertex, v1 - c->first.vertex}, {f0 - c->first.face, f1 - c->first.face}};
    return true;
}

/* Returns a + t (b - a). The rounding error of a double is a wide angle near the eye; `low` receives that error. */
static double divide(double a, double b, double t, double *low)
{
    dd p = dd_add((dd){a, 0.0}, dd_mul((dd){t, 0.0}, dd_two_diff(b, a)));
    *low = p.lo;
    return p.hi;
}

/* Adds the vertex that divides the edge from A to B at t. */
static bool cutter_add_cut(cutter *c, roberts_vec3 A, roberts_vec3 B, double t)
{
    roberts_vec3 low, point = {divide(A.x, B.x, t, &low.x), divide(A.y, B.y, t, &low.y), divide(A.z, B.z, t, &low.z)};
    return cutter_add_vertex(c, point, low, ROBERTS_NONE);
}

/* ---- convex solids ----------------------------------------------------------------------------------------------- */

/* Returns where the near plane cuts the side from a to b. */
static double cut_at(const cutter *c, uint32_t a, uint32_t b)
{
    return (c->clip->near - c->depth[a]) / (c->depth[b] - c->depth[a]);
}

/* Adds the vertices of a solid that are kept. False: no memory. */
static bool keep_vertices(cutter *c, uint32_t solid)
{
    const roberts_scene *from = c->from;
    const roberts_vec3 none = {0.0, 0.0, 0.0};
    for (uint32_t v = from->solid[solid].vertex; v < from->solid[solid + 1].vertex; v++) {
        c->vertex[v] = cutter_keeps(c, v) ? c->clip->scene.vertex_count : ROBERTS_NONE;
        if (cutter_keeps(c, v) &&
            !cutter_add_vertex(c, from->point[v], from->low ? from->low[v] : none, scene_vertex_number(from, v)))
            return false;
    }
    return true;
}

/* Returns the edge of the solid between two of its vertices. Edges ascend by (v[0], v[1]). */
static uint32_t find_edge_between(const cutter *c, uint32_t solid, uint32_t a, uint32_t b)
{
    uint32_t low = c->from->solid[solid].edge, high = c->from->solid[solid + 1].edge;
    uint32_t v0 = a < b ? a : b, v1 = a < b ? b : a;
    while (high - low > 1) {
        uint32_t middle = low + (high - low) / 2;
        const scene_edge e = scene_edge_at(c->from, solid, middle);
        if (e.v[0] < v0 || (e.v[0] == v0 && e.v[1] <= v1))
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Adds the vertices that are kept, and a new vertex on each edge that the plane cuts. False: no memory. */
static bool cut_vertices(cutter *c, uint32_t solid)
{
    const roberts_scene *from = c->from;
    if (!keep_vertices(c, solid))
        return false;
    for (uint32_t i = from->solid[solid].edge; i < from->solid[solid + 1].edge; i++) {
        const scene_edge edge = scene_edge_at(from, solid, i);
        uint32_t a = edge.v[0], b = edge.v[1];
        clip_edge *origin = &c->clip->origin[i];
        *origin = (clip_edge){ROBERTS_NONE, 0.0, 1.0};
        c->cut[i] = ROBERTS_NONE;
        if (cutter_keeps(c, a) == cutter_keeps(c, b))
            continue;
        double t = cut_at(c, a, b);
        c->cut[i] = c->clip->scene.vertex_count;
        if (cutter_keeps(c, a))
            origin->t1 = t;
        else
            origin->t0 = t;
        if (!cutter_add_cut(c, from->point[a], from->point[b], t))
            return false;
    }
    return true;
}

/* Measures the width of the last face of the clipped scene, whose corners begin at `first`. */
static bool cutter_measure_width(cutter *c, uint32_t first, double *width)
{
    const roberts_scene *to = &c->clip->scene;
    size_t count = to->corner_count - first;
    double scale = 0.0;
    if (!array_reserve(&c->ring, &c->ring_room, count, sizeof *c->ring))
        return false;
    for (size_t k = 0; k < count; k++) {
        c->ring[k] = vec3_sub(to->point[to->corner[first + k]], to->point[to->corner[first]]);
        scale = greater(scale, vec3_largest(c->ring[k]));
    }
    *width = 0.0;
    if (count < 3 || scale == 0.0)
        return true;
    for (size_t k = 0; k < count; k++)
        c->ring[k] = (roberts_vec3){c->ring[k].x / scale, c->ring[k].y / scale, c->ring[k].z / scale};
    *width = face_plane_fit(c->ring, (uint32_t)count).width * scale;
    return true;
}

/* Clips one face. The cap runs along the cut in the opposite direction. If a side is straight only within the
 * tolerance, the border may weave through the plane. Then each entry is joined to the exit before it. False: no
 * memory. */
static bool cut_face(cutter *c, uint32_t solid, uint32_t face, uint32_t *to_face)
{
    const roberts_scene *from = c->from;
    uint32_t first = from->face_start[face], end = from->face_start[face + 1], leave = ROBERTS_NONE;
    uint32_t early = ROBERTS_NONE, begin = (uint32_t)c->clip->scene.corner_count; /* an entry before any exit */
    double width = scene_width(from, face);
    for (uint32_t k = first; k < end; k++) {
        uint32_t a = from->corner[k], b = from->corner[k + 1 < end ? k + 1 : first];
        if (cutter_keeps(c, a) && !cutter_add_corner(c, c->vertex[a]))
            return false;
        if (cutter_keeps(c, a) == cutter_keeps(c, b))
            continue;
        uint32_t edge = find_edge_between(c, solid, a, b);
        if (cutter_keeps(c, a))
            leave = edge;
        else if (leave != ROBERTS_NONE)
            c->next[edge] = leave;
        else
            early = edge;
        if (!cutter_add_corner(c, c->cut[edge]))
            return false;
    }
    *to_face = ROBERTS_NONE;
    if (c->clip->scene.corner_count == begin)
        return true;
    if (early != ROBERTS_NONE)
        c->next[early] = leave;
    if (leave != ROBERTS_NONE && !cutter_measure_width(c, begin, &width))
        return false;
    *to_face = c->clip->scene.face_count;
    return cutter_add_face(c, scene_plane(from, face), scene_deviation(from, face), width,
                           scene_face_number(from, face));
}

static bool cutter_touch(const cutter *c, uint32_t v, uint32_t w)
{
    const roberts_vec3 *P = c->clip->scene.point;
    return vec3_length(vec3_sub(P[v], P[w])) <= c->touching;
}

/* Adds the cap. `start` is one of the cut edges. Of cuts that touch, as those of a face without area, the cap has one:
 * rounding may have put them in the wrong order. If a border weaves through the plane, there are several rings, and the
 * cap has one of them. Then the outline is not a single cycle, and the faces hide one by one (see hide/front.c). False:
 * no memory. */
static bool add_cap(cutter *c, uint32_t start)
{
    roberts_scene *to = &c->clip->scene;
    uint32_t begin = (uint32_t)to->corner_count, e = start;
    double width;
    do {
        const bool again = to->corner_count > begin && cutter_touch(c, c->cut[e], to->corner[to->corner_count - 1]);
        if (!again && !cutter_add_corner(c, c->cut[e]))
            return false;
        e = c->next[e];
    } while (e != start);
    if (to->corner_count > begin + 1 && cutter_touch(c, to->corner[to->corner_count - 1], to->corner[begin]))
        to->corner_count--;
    return cutter_measure_width(c, begin, &width) &&
           cutter_add_face(c, view_clip_plane(c->clip, c->from->centre), c->touching, width, ROBERTS_NONE);
}

/* Adds the edges that are kept, completely or in part, in order, followed by those of the cap. map: numbers of the
 * faces in the clipped scene. False: no memory. */
static bool cut_edges(cutter *c, uint32_t solid, const uint32_t *map, uint32_t cap)
{
    const roberts_scene *from = c->from;
    uint32_t first = from->solid[solid].edge, end = from->solid[solid + 1].edge;
    for (uint32_t i = first; i < end; i++) {
        const scene_edge edge = scene_edge_at(from, solid, i);
        uint32_t v[2];
        for (int k = 0; k < 2; k++)
            v[k] = cutter_keeps(c, edge.v[k]) ? c->vertex[edge.v[k]] : c->cut[i];
        if (v[0] == ROBERTS_NONE || v[1] == ROBERTS_NONE)
            continue;
        c->clip->origin[i].edge = c->clip->scene.edge_count;
        if (!cutter_add_edge(c, v[0], v[1], map[edge.f[0]], map[edge.f[1]], false))
            return false;
    }
    for (uint32_t i = first; i < end && cap != ROBERTS_NONE; i++) {
        if (c->cut[i] == ROBERTS_NONE)
            continue;
        /* between cut i and the next, the cap meets the face into which edge i leads: v[0] -> v[1] runs round f[0] */
        const scene_edge edge = scene_edge_at(from, solid, i);
        uint32_t face = edge.f[cutter_keeps(c, edge.v[1]) ? 0 : 1];
        if (!cutter_add_edge(c, c->cut[i], c->cut[c->next[i]], cap, map[face], true))
            return false;
    }
    return true;
}

/* Is the eye inside a solid? An eye on a face, within rounding, is outside. The face's departure from its plane does
 * not matter. */
static bool holds_eye(const cutter *c, uint32_t solid)
{
    roberts_vec3 P = vec3_sub(c->clip->from, c->from->centre);
    for (uint32_t f = c->from->solid[solid].face; f < c->from->solid[solid + 1].face; f++)
        if (!(plane_at(scene_plane(c->from, f), P) > c->touching))
            return false;
    return true;
}

/* ---- bodies that are not convex ---------------------------------------------------------------------------------- */

/* Creates the scene_surface of the clipped scene. */
static bool begin_surface(cutter *c)
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
    return compare_pairs(((const cut_side *)pa)->v, ((const cut_side *)pb)->v);
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

/* Adds the vertices that are kept, and a new vertex on each side that is cut. False: no memory. */
static bool cut_body_vertices(cutter *c, uint32_t body)
{
    const roberts_scene *from = c->from;
    const scene_solid *own = &from->solid[body];
    size_t to = 0;
    c->side_count = 0;
    if (!keep_vertices(c, body))
        return false;
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

/* Does the cut of a piece bound a cap? If parity decides, the middle of a pentagram, which counts twice, does not. */
static bool bounds_cap(const cutter *c, uint32_t face)
{
    const int32_t *own = c->from->surface->winding;
    return (c->winding && c->winding[face] != 0) || !own || own[face] % 2 != 0;
}

/* Adds the cut of a piece, whose number in the clipped scene will be `to_face`. False: no memory. */
static bool add_cut(cutter *c, uint32_t face, const cut_line *line, uint32_t to_face, cut_lines *lines)
{
    view_clip *clip = c->clip;
    if (!bounds_cap(c, face)) {
        if (c->from->surface->kind[scene_body_of_face(c->from, face)] != ROBERTS_CLOSED)
            return true; /* it has no cap, and all its cuts are drawn */
        if (!array_reserve(&clip->sheet, &c->sheet_room, clip->sheet_count + 1, sizeof *clip->sheet))
            return false;
        clip->sheet[clip->sheet_count++] = to_face;
        return true;
    }
    if (!array_reserve(&lines->item, &lines->room, lines->count + 1, sizeof *lines->item))
        return false;
    lines->item[lines->count++] = *line;
    return true;
}

/* Clips one face. `lines` receives the cut, if there is one. False: no memory. */
static bool cut_piece(cutter *c, uint32_t face, uint32_t *to_face, cut_lines *lines)
{
    const roberts_scene *from = c->from;
    uint32_t first = from->face_start[face], end = from->face_start[face + 1];
    uint32_t begin = (uint32_t)c->clip->scene.corner_count;
    cut_line line = {ROBERTS_NONE, ROBERTS_NONE, c->winding ? c->winding[face] : 0, 0};
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
    *to_face = c->clip->scene.face_count;
    if (line.from != ROBERTS_NONE && line.to != ROBERTS_NONE && !add_cut(c, face, &line, *to_face, lines))
        return false;
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

/* Does an edge of a closed body lie in the near plane, with two faces or more beyond it? It remains a line: where two
 * faces of one body part from the plane, no cap has a side. map: of each face, what is left of it, or ROBERTS_NONE. */
static bool is_ridge(const cutter *c, uint32_t body, uint32_t e, const uint32_t *map)
{
    const roberts_scene *from = c->from;
    const scene_solid *own = &from->solid[body];
    const scene_edge *edge = scene_edge_stored(from, body, e);
    int left = 0;
    if (from->surface->kind[body] != ROBERTS_CLOSED || c->depth[own->vertex + edge->v[0]] != c->clip->near ||
        c->depth[own->vertex + edge->v[1]] != c->clip->near)
        return false;
    if (from->surface->edge_is[e] & EDGE_MANY) {
        const scene_many *many = scene_many_at(from, e);
        for (uint32_t k = many->first; k < many->end; k++)
            left += map[from->surface->many_face[k] & ~MANY_TURNED] != ROBERTS_NONE;
        return left > 1;
    }
    for (int k = 0; k < 2; k++)
        left += edge->f[k] != ROBERTS_NONE && map[own->face + edge->f[k]] != ROBERTS_NONE;
    return left > 1;
}

/* Adds a vertex that lies in the near plane as it is. ROBERTS_NONE: no memory. */
static uint32_t add_in_plane(cutter *c, uint32_t vertex)
{
    const roberts_scene *from = c->from;
    const roberts_vec3 low = from->low ? from->low[vertex] : (roberts_vec3){0.0, 0.0, 0.0};
    const uint32_t number = c->clip->scene.vertex_count;
    return cutter_add_vertex(c, from->point[vertex], low, scene_vertex_number(from, vertex)) ? number : ROBERTS_NONE;
}

/* Adds the remainder of an edge. False: no memory. */
static bool cut_body_edge(cutter *c, uint32_t body, uint32_t e, const uint32_t *map)
{
    const roberts_scene *from = c->from;
    const scene_solid *own = &from->solid[body];
    const scene_edge *edge = scene_edge_stored(from, body, e);
    scene_surface *to = c->clip->scene.surface;
    clip_edge *origin = &c->clip->origin[e];
    uint32_t a = own->vertex + edge->v[0], b = own->vertex + edge->v[1], number = c->clip->scene.edge_count, f[2];
    *origin = (clip_edge){ROBERTS_NONE, 0.0, 1.0};
    const bool gone = !cutter_keeps(c, a) && !cutter_keeps(c, b);
    if (gone && !is_ridge(c, body, e, map))
        return true;
    uint32_t v0 = gone ? add_in_plane(c, a) : c->vertex[a], v1 = gone ? add_in_plane(c, b) : c->vertex[b];
    if (gone && (v0 == ROBERTS_NONE || v1 == ROBERTS_NONE))
        return false;
    if (cutter_keeps(c, a) != cutter_keeps(c, b)) {
        double t = a < b ? cut_at(c, a, b) : 1.0 - cut_at(c, b, a);
        *(cutter_keeps(c, a) ? &origin->t1 : &origin->t0) = t;
        *(cutter_keeps(c, a) ? &v1 : &v0) = find_cut(c, a, b);
    }
    origin->edge = number;
    for (int k = 0; k < 2; k++)
        f[k] = edge->f[k] == ROBERTS_NONE ? ROBERTS_NONE : map[own->face + edge->f[k]];
    uint8_t is = from->surface->edge_is[e] & (uint8_t)~EDGE_NEEDLE; /* the cut scene lists no needles */
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

/* Adds the cap's pieces as faces without a number. They hide, but have no edges. False: no memory. */
static bool add_cap_pieces(cutter *c, const uint32_t *ring, size_t count, bool even_odd)
{
    roberts_scene *to = &c->clip->scene;
    face_pieces pieces = {0};
    /* Straight corners are kept: hide/cuts.c leaves out what is a side of two pieces, with the same ends. */
    const face_rules rules = {.point = to->point,
                              .tolerance = CAP_TOLERANCE,
                              .touching = c->touching,
                              .narrow = c->touching,
                              .unit = to->unit,
                              .even_odd = even_odd,
                              .keep_straight = true};
    bool enough = face_pieces_cut(&pieces, &rules, ring, (uint32_t)count);
    uint32_t plane_of = ROBERTS_NONE - 1; /* a key that no edge lists */
    plane F = view_clip_plane(c->clip, c->from->centre);
    if (!(vec3_dot(pieces.fit.n, c->clip->dir) > 0.0)) /* as the pieces are wound */
        F = (plane){-F.a, -F.b, -F.c, -F.d};
    for (size_t n = 0; enough && n < pieces.node_count; n++)
        if (pieces.node[n].vertex == ROBERTS_NONE) {
            pieces.node[n].vertex = to->vertex_count;
            enough = cutter_add_vertex(c, pieces.node[n].point, pieces.node[n].low, ROBERTS_NONE);
        }
    for (size_t p = 0; enough && p < pieces.piece_count; p++) {
        const face_piece *piece = &pieces.piece[p];
        for (uint32_t i = 0; enough && i < piece->count; i++)
            enough = cutter_add_corner(c, pieces.node[piece->node[i]].vertex);
        enough =
            enough && cutter_add_face(c, F, c->touching, pieces.fit.width, ROBERTS_NONE) && add_plane_of(c, plane_of);
    }
    face_pieces_free(&pieces);
    return enough;
}

/* Fills the cut of a closed body. False: no memory. */
static bool cap_lines(cutter *c, cut_lines *lines)
{
    const double touching = greater(c->touching, scene_step(c->from));
    uint32_t *ring;
    size_t count;
    bool enough = cut_ring(lines, c->clip->scene.point, touching, &ring, &count);
    if (enough && count > 0)
        enough = add_cap_pieces(c, ring, count, lines->item[0].winding == 0);
    free(ring);
    return enough;
}

/* Clips one body. map: [face_count of from] receives the new numbers of its faces. */
static bool cut_body(cutter *c, uint32_t body, uint32_t *map)
{
    const roberts_scene *from = c->from;
    const scene_solid *own = &from->solid[body];
    cut_lines lines = {0};
    bool enough = cut_body_vertices(c, body);
    for (uint32_t f = own->face; enough && f < own[1].face; f++)
        enough = cut_piece(c, f, &map[f], &lines);
    for (uint32_t e = own->edge; enough && e < own[1].edge; e++)
        enough = cut_body_edge(c, body, e, map);
    if (enough && lines.count > 0 && from->surface->kind[body] == ROBERTS_CLOSED)
        enough = cap_lines(c, &lines);
    free(lines.item);
    return enough;
}

/* ---- a whole scene ----------------------------------------------------------------------------------------------- */

/* Clips one solid. `map` is scratch, [face_count of from]. */
static roberts_status cut_solid(cutter *c, uint32_t solid, uint32_t *map, roberts_error *error)
{
    const roberts_scene *from = c->from;
    roberts_scene *to = &c->clip->scene;
    uint32_t start = ROBERTS_NONE, cap = ROBERTS_NONE;
    c->first = (scene_solid){to->vertex_count, to->face_count, to->edge_count, to->edge_count};
    to->solid[solid] = c->first;
    c->whole = true;
    for (uint32_t v = from->solid[solid].vertex; v < from->solid[solid + 1].vertex; v++)
        c->whole = c->whole && c->depth[v] >= c->clip->near;
    if (!scene_is_convex(from, solid))
        return cut_body(c, solid, map) ? ROBERTS_OK : error_no_memory(error);
    if (!c->clip->section && holds_eye(c, solid))
        return error_set(error, ROBERTS_BAD_VIEW, 0, "the eye is inside solid %u; move it out of all solids",
                         (unsigned)solid);
    if (!cut_vertices(c, solid))
        return error_no_memory(error);
    for (uint32_t f = from->solid[solid].face; f < from->solid[solid + 1].face; f++)
        if (!cut_face(c, solid, f, &map[f]))
            return error_no_memory(error);
    for (uint32_t i = from->solid[solid].edge; i < from->solid[solid + 1].edge && start == ROBERTS_NONE; i++)
        start = c->cut[i] != ROBERTS_NONE ? i : ROBERTS_NONE;
    if (start != ROBERTS_NONE) {
        cap = to->face_count;
        if (!add_cap(c, start))
            return error_no_memory(error);
    }
    return cut_edges(c, solid, map, cap) ? ROBERTS_OK : error_no_memory(error);
}

/* Returns the depth of a point. A point within the touching distance of the near plane counts as on it. */
static double depth_of(const cutter *c, roberts_vec3 P)
{
    double depth = view_clip_depth(c->clip, P);
    return fabs(depth - c->clip->near) <= c->touching ? c->clip->near : depth;
}

/* Measures the depths of all vertices, and returns the least. */
static double measure_depths(cutter *c)
{
    double least = INFINITY;
    for (uint32_t v = 0; v < c->from->vertex_count; v++) {
        c->depth[v] = depth_of(c, c->from->point[v]);
        least = lesser(least, c->depth[v]);
    }
    return least;
}

/* Allocates the arrays that are read even if they stay empty. False: no memory. */
static bool begin_arrays(cutter *c)
{
    roberts_scene *to = &c->clip->scene;
    if (!(to->solid = alloc_array((size_t)c->from->solid_count + 1, sizeof *to->solid)) ||
        !array_reserve(&to->face_start, &c->start_room, 1, sizeof *to->face_start) ||
        !array_reserve(&to->face_plane, &c->plane_room, 1, sizeof *to->face_plane) ||
        !array_reserve(&to->corner, &c->corner_room, 1, sizeof *to->corner) ||
        !array_reserve(&to->edge, &c->edge_room, 1, sizeof *to->edge))
        return false;
    to->face_start[0] = 0;
    return true;
}

static roberts_status cut_solids(cutter *c, roberts_error *error)
{
    const roberts_scene *from = c->from;
    roberts_scene *to = &c->clip->scene;
    roberts_status status = ROBERTS_OK;
    uint32_t *map = alloc_array(from->face_count, sizeof *map);
    to->solid_count = from->solid_count;
    to->box_min = from->box_min;
    to->box_max = from->box_max;
    to->centre = from->centre;
    to->unit = from->unit;
    to->steps = from->steps;
    if (!map || !begin_arrays(c) || (from->surface && !(begin_surface(c) && winding_find(from, &c->winding)))) {
        free(map);
        return error_no_memory(error);
    }
    for (uint32_t s = 0; status == ROBERTS_OK && s < from->solid_count; s++)
        status = cut_solid(c, s, map, error);
    to->solid[to->solid_count] = (scene_solid){to->vertex_count, to->face_count, to->edge_count, to->edge_count};
    if (status == ROBERTS_OK && to->vertex_count == 0)
        status = c->clip->section
                     ? error_set(error, ROBERTS_BAD_VIEW, 0,
                                 "nothing of the scene lies beyond the section; move its point toward the viewer, or "
                                 "the way its direction points")
                     : error_set(error, ROBERTS_BAD_VIEW, 0,
                                 "nothing of the scene lies in front of the eye, beyond the near plane at a "
                                 "distance of %.6g; move the eye, the look-at point or the near plane",
                                 c->clip->near);
    free(map);
    return status;
}

static double diameter_of(const roberts_scene *scene)
{
    return vec3_length(vec3_sub(scene->box_max, scene->box_min));
}

static void set_touching(cutter *c)
{
    const roberts_vec3 corners[] = {c->from->box_min, c->from->box_max, c->clip->from};
    for (size_t i = 0; i < sizeof corners / sizeof corners[0]; i++)
        c->touching = greater(c->touching, vec3_largest(corners[i]));
    c->touching *= TOUCHING_ULPS * DBL_EPSILON;
}

/* Makes the near plane that of a section, at this depth. The point is usually one of the model, of which others lie in
 * the plane only to within the touching distance of the view. */
static void set_section(cutter *c, double depth, double epsilon)
{
    c->clip->section = true;
    c->clip->near = depth;
    if (!(epsilon > 0.0))
        epsilon = greater(EPSILON_OF_DIAMETER * diameter_of(c->from), scene_step(c->from));
    c->touching = greater(c->touching, lesser(epsilon, EPSILON_MOST * diameter_of(c->from)));
}

/* Sets the near plane of a view from an eye. distance: of the look-at point. */
static void set_near_of_eye(cutter *c, const roberts_camera *camera, double distance, double epsilon)
{
    const double diameter = diameter_of(c->from);
    double near = camera->near_distance;
    if (near <= 0.0)
        near = fmax(NEAR_OF_DISTANCE * distance, NEAR_OF_DIAMETER * diameter);
    near = fmax(near, NEAR_LEAST * diameter + c->touching);
    c->clip->near = near;
    if (camera->has_section && view_clip_depth(c->clip, camera->section) > near)
        set_section(c, view_clip_depth(c->clip, camera->section), epsilon);
}

/* Sets the near plane. epsilon: as in view_clip_scene(). False: there is none, or the camera is invalid;
 * view_prepare() will refuse it. */
static bool set_near(cutter *c, const roberts_camera *camera, double epsilon)
{
    const roberts_vec3 centre = c->from->centre;
    const bool eye = camera->projection == ROBERTS_PERSPECTIVE;
    roberts_vec3 back = camera->dir;
    if (!eye && !camera->has_section)
        return false;
    if (eye)
        back = vec3_sub(camera->eye, camera->has_look_at ? camera->look_at : centre);
    else if (vec3_largest(camera->section_normal) > 0.0)
        back = camera->section_normal;
    double largest = vec3_largest(back);
    if (!vec3_is_finite(back) || !(largest > 0.0) || (eye && !isfinite(camera->near_distance)) ||
        (camera->has_section && !vec3_is_finite(camera->section)))
        return false;
    back = (roberts_vec3){back.x / largest, back.y / largest, back.z / largest};
    c->clip->from = eye ? camera->eye : centre;
    c->clip->dir = vec3_scale(1.0 / vec3_length(back), back);
    set_touching(c);
    if (eye)
        set_near_of_eye(c, camera, vec3_length(back) * largest, epsilon);
    else
        set_section(c, view_clip_depth(c->clip, camera->section), epsilon);
    return true;
}

bool view_is_cut(const roberts_scene *scene, const roberts_camera *camera, const roberts_vec3 *P, size_t count)
{
    view_clip clip = {0};
    cutter c = {.clip = &clip, .from = scene};
    bool cut = false;
    if (!set_near(&c, camera, 0.0))
        return false;
    for (size_t i = 0; i < count && !cut; i++)
        cut = depth_of(&c, P[i]) < clip.near;
    return cut;
}

roberts_status view_clip_scene(view_clip *clip, const roberts_scene *scene, const roberts_camera *camera,
                               double epsilon, roberts_error *error)
{
    roberts_status status = ROBERTS_NO_MEMORY;
    cutter c = {.clip = clip, .from = scene};
    *clip = (view_clip){0};
    if (!set_near(&c, camera, epsilon))
        return ROBERTS_OK;
    c.depth = alloc_array(scene->vertex_count, sizeof *c.depth);
    if (!c.depth)
        return error_no_memory(error);
    if (measure_depths(&c) >= clip->near) {
        free(c.depth);
        return ROBERTS_OK;
    }
    clip->clipped = true;
    clip->pieces = scene->surface && scene->surface->plane_of;
    clip->origin = alloc_array(scene->edge_count, sizeof *clip->origin);
    c.vertex = alloc_array(scene->vertex_count, sizeof *c.vertex);
    c.cut = alloc_array(scene->edge_count, sizeof *c.cut);
    c.next = alloc_array(scene->edge_count, sizeof *c.next);
    if (clip->origin && c.vertex && c.cut && c.next)
        status = cut_solids(&c, error);
    else
        error_no_memory(error);
    free(c.depth);
    free(c.vertex);
    free(c.cut);
    free(c.next);
    free(c.winding);
    free(c.ring);
    free(c.side);
    if (status != ROBERTS_OK)
        view_clip_free(clip);
    return status;
}

void view_clip_free(view_clip *clip)
{
    scene_clear(&clip->scene);
    free(clip->origin);
    free(clip->cap);
    free(clip->sheet);
    *clip = (view_clip){0};
}
