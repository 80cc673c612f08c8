/* body_edges.c - the edges of bodies that are not convex. See body_edges.h.
 *
 * Sides with the same ends are one edge. An edge with an even number of pieces is complete: nothing divides it, so
 * bodies that only touch keep their own edges. Nearly all edges have two pieces. The other sides (borders, edges with
 * an odd number of pieces, wires) are compared in space: a vertex within the touching distance of such a side divides
 * it, and vertices that near to one another are merged. So T-junctions and loose faces cause no false borders.
 *
 * Each part of an edge has the faces of all sides between its two vertices: if a divided side leaves a part between
 * the ends of a complete edge, both are one edge.
 *
 * When bodies.c knows which pieces are one body, each body's edges are stored in the scene, in the order of their names
 * in the file. */
#include "model/body_edges.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/search.h"
#include "base/sets.h"
#include "base/sort.h"

/* ---- sides with the same ends ------------------------------------------------------------------------------------ */

/* A side, or a part of one, with its ends in ascending order. */
typedef struct part_side {
    uint32_t v[2];  /* v[0] < v[1] */
    uint32_t piece; /* as in surface_side, possibly with SURFACE_CUT */
    bool turned;    /* the piece is on the right of v[0] -> v[1] */
    uint32_t part;  /* index in surface.part, or ROBERTS_NONE */
} part_side;

/* A vertex that divides an odd side. */
typedef struct side_stop {
    double t;
    uint32_t vertex;
} side_stop;

typedef struct finder {
    surface *s;
    double touching;
    uint32_t *end;        /* [vertex_count] where the sides of each smaller vertex end in `half` */
    uint64_t *half;       /* [side_count] larger vertex << 32 | side */
    scene_part *divided;  /* [part_count of s] the parts, sorted by their edges of the file */
    uint32_t *odd;        /* [odd_count] sides of edges that are not complete */
    uint32_t *vertex;     /* [vertex_count] ends of the odd sides */
    uint32_t *parent;     /* [vertex_count of s] sets of coincident vertices, by their smallest */
    uint32_t *group;      /* [vertex_count of s] groups of the ends of odd sides; NULL: all are one group */
    part_side *half_side; /* [half_count] the odd sides after division */
    surface_edge *odd_edge;
    side_stop *stop;
    point_list found;
    size_t odd_count, vertex_count, half_count, odd_edge_count, stop_count;
    size_t odd_room, half_room, odd_edge_room, stop_room;
    bool merged; /* vertices, in this round */
} finder;

static uint32_t lower(const surface_side *side)
{
    return side->v[0] < side->v[1] ? side->v[0] : side->v[1];
}

static uint32_t upper(const surface_side *side)
{
    return side->v[0] < side->v[1] ? side->v[1] : side->v[0];
}

static bool sort_sides(finder *f)
{
    const surface *s = f->s;
    uint32_t start = 0;
    f->end = alloc_zeroed(s->vertex_count, sizeof *f->end);
    f->half = alloc_array(s->side_count, sizeof *f->half);
    if (!f->end || !f->half)
        return false;
    for (size_t i = 0; i < s->side_count; i++)
        f->end[lower(&s->side[i])]++;
    sort_starts(f->end, s->vertex_count);
    for (size_t i = 0; i < s->side_count; i++)
        f->half[f->end[lower(&s->side[i])]++] = (uint64_t)upper(&s->side[i]) << 32 | i;
    for (uint32_t v = 0; v < s->vertex_count; start = f->end[v++])
        sort_short_list(f->half + start, f->end[v] - start);
    return true;
}

static bool is_wire_side(const surface_side *side)
{
    return (side->piece & ~SURFACE_CUT) == SURFACE_WIRE;
}

static uint32_t incidence(uint32_t piece, bool turned)
{
    return (piece & ~SURFACE_CUT) | (turned ? SURFACE_TURNED : 0);
}

/* If a side is a part of an edge of the file, copies this part to surface.part; otherwise *part is ROBERTS_NONE. False:
 * no memory. */
static bool copy_part(surface *s, uint32_t side, uint32_t *part)
{
    size_t at = find_numbered(s->side_part, s->part_count, sizeof *s->side_part, side);
    *part = ROBERTS_NONE;
    if (at == s->part_count || s->side_part[at].edge != side)
        return true;
    if (!array_reserve(&s->part, &s->edge_part_room, s->edge_part_count + 1, sizeof *s->part))
        return false;
    *part = (uint32_t)s->edge_part_count;
    s->part[s->edge_part_count++] = s->side_part[at];
    return true;
}

/* Do two of the sides belong to one planar face? Then its border crosses itself, and the face is on both sides of this
 * stretch. Another face may divide the same stretch differently. */
static bool any_same_face(const surface *s, const uint32_t *side, size_t count)
{
    for (size_t i = 1; i < count; i++)
        for (size_t k = 0; k < i; k++) {
            uint32_t p = s->side[side[i]].piece, q = s->side[side[k]].piece;
            if (!((p | q) & SURFACE_CUT) && s->plane_of[p] == s->plane_of[q])
                return true;
        }
    return false;
}

/* Is the vertex a corner of the side's piece? */
static bool is_corner(const surface *s, const surface_side *side, uint32_t v)
{
    uint32_t p = side->piece & ~SURFACE_CUT, i = s->start[p];
    while (i < s->start[p + 1] && s->corner[i] != v)
        i++;
    return i < s->start[p + 1];
}

static int compare_names(const void *pa, const void *pb)
{
    return compare_pairs(((const scene_part *)pa)->v, ((const scene_part *)pb)->v);
}

/* Is some other side a part of the file's edge that this side covers completely? */
static bool is_divided(const finder *f, const surface_side *side)
{
    scene_part key = {.v = {lower(side), upper(side)}};
    return f->divided && bsearch(&key, f->divided, f->s->part_count, sizeof key, compare_names);
}

/* Adds a piece to an edge. False: no memory. */
static bool add_incidence(surface *s, surface_edge *edge, uint32_t count, uint32_t piece)
{
    if (count < 2) {
        edge->piece[count] = piece;
        return true;
    }
    if (!array_reserve(&s->many, &s->many_room, s->many_count + 3, sizeof *s->many))
        return false;
    if (count == 2) {
        edge->many = (uint32_t)s->many_count;
        s->many[s->many_count++] = edge->piece[0];
        s->many[s->many_count++] = edge->piece[1];
    }
    s->many[s->many_count++] = piece;
    edge->many_end = (uint32_t)s->many_count;
    return true;
}

/* Makes a complete edge. False: no memory. */
static bool add_complete(finder *f, const uint32_t *side, uint32_t count)
{
    surface *s = f->s;
    const surface_side *a = &s->side[side[0]];
    surface_edge edge = {
        .v = {lower(a), upper(a)}, .many = ROBERTS_NONE, .part = ROBERTS_NONE, .cut = a->piece & SURFACE_CUT};
    for (uint32_t i = 0; i < count; i++) {
        const surface_side *own = &s->side[side[i]];
        edge.cut = edge.cut && own->piece & SURFACE_CUT;
        if (!add_incidence(s, &edge, i, incidence(own->piece, own->v[0] > own->v[1])))
            return false;
    }
    edge.odd = s->whole_sides && !(is_corner(s, a, edge.v[0]) && is_corner(s, a, edge.v[1]));
    if (s->part_count > 0 && !copy_part(s, side[0], &edge.part))
        return false;
    if (!array_reserve(&s->edge, &s->edge_room, s->edge_count + 1, sizeof *s->edge))
        return false;
    s->edge[s->edge_count++] = edge;
    return true;
}

/* Makes an edge of sides with the same ends if it is complete; otherwise lists the sides as odd. They are also odd if
 * another face crosses itself on this edge, and so has only parts of it. False: no memory. */
static bool take_group(finder *f, const uint64_t *half, size_t count)
{
    surface *s = f->s;
    uint32_t side[SURFACE_EVEN_MOST];
    size_t real = 0;
    bool shadow = false;
    for (size_t i = 0; i < count; i++)
        if (s->side[(uint32_t)half[i]].piece == SURFACE_SHADOW) {
            shadow = true;
        } else if (!is_wire_side(&s->side[(uint32_t)half[i]])) {
            if (real < SURFACE_EVEN_MOST)
                side[real] = (uint32_t)half[i];
            real++;
        }
    if (real > 0 && real % 2 == 0 && real <= SURFACE_EVEN_MOST && !any_same_face(s, side, real) &&
        !is_divided(f, &s->side[side[0]]))
        return add_complete(f, side, (uint32_t)real);
    if (!array_reserve(&f->odd, &f->odd_room, f->odd_count + count, sizeof *f->odd))
        return false;
    for (size_t i = 0; i < count; i++)
        if (s->side[(uint32_t)half[i]].piece != SURFACE_SHADOW &&
            !(is_wire_side(&s->side[(uint32_t)half[i]]) && (real > 0 || shadow)))
            f->odd[f->odd_count++] = (uint32_t)half[i];
    return true;
}

static bool take_groups(finder *f)
{
    uint32_t start = 0;
    for (uint32_t v = 0; v < f->s->vertex_count; start = f->end[v++])
        for (uint32_t i = start, to; i < f->end[v]; i = to) {
            for (to = i + 1; to < f->end[v] && f->half[to] >> 32 == f->half[i] >> 32; to++)
                continue;
            if (!take_group(f, f->half + i, to - i))
                return false;
        }
    return true;
}

/* ---- sides that are compared in space ---------------------------------------------------------------------------- */

/* Returns the group of end k of a side: that of its face, since an end may be a crossing, which is no vertex of the
 * mesh. A wire may join two groups. */
static uint32_t group_of(const surface *s, const surface_side *side, int k)
{
    return is_wire_side(side) ? s->group[side->v[k]] : surface_group(s, surface_piece(side->piece));
}

/* Lists the ends of odd sides, each once. False: no memory. */
static bool list_vertices(finder *f)
{
    f->vertex = alloc_array(2 * f->odd_count, sizeof *f->vertex);
    f->parent = alloc_array(f->s->vertex_count, sizeof *f->parent);
    if (!f->vertex || !f->parent)
        return false;
    if (f->s->group && !(f->group = alloc_array(f->s->vertex_count, sizeof *f->group)))
        return false;
    for (size_t i = 0; i < f->odd_count; i++) {
        const surface_side *side = &f->s->side[f->odd[i]];
        for (int k = 0; k < 2; k++) {
            f->vertex[2 * i + (size_t)k] = side->v[k];
            if (f->group)
                f->group[side->v[k]] = group_of(f->s, side, k);
        }
    }
    qsort(f->vertex, 2 * f->odd_count, sizeof *f->vertex, compare_u32);
    for (size_t i = 0; i < 2 * f->odd_count; i++)
        if (i == 0 || f->vertex[i] != f->vertex[i - 1])
            f->vertex[f->vertex_count++] = f->vertex[i];
    for (uint32_t v = 0; v < f->s->vertex_count; v++)
        f->parent[v] = v;
    return true;
}

surface_touch surface_touches(roberts_vec3 A, roberts_vec3 B, roberts_vec3 P, double touching, double *t)
{
    roberts_vec3 AB = vec3_sub(B, A), AP = vec3_sub(P, A);
    double squared = vec3_dot(AB, AB);
    *t = squared > 0.0 ? vec3_dot(AP, AB) / squared : 0.0;
    if (vec3_length(AP) <= touching)
        return TOUCHES_START;
    if (vec3_length(vec3_sub(P, B)) <= touching)
        return TOUCHES_END;
    if (!(*t > 0.0 && *t < 1.0 && vec3_length(vec3_sub(AP, vec3_scale(*t, AB))) <= touching))
        return TOUCHES_NOT;
    const double length = sqrt(squared);
    return *t * length <= touching ? TOUCHES_START : (1.0 - *t) * length <= touching ? TOUCHES_END : TOUCHES_BETWEEN;
}

static int compare_stops(const void *pa, const void *pb)
{
    const side_stop *a = pa, *b = pb;
    if (a->t != b->t)
        return a->t < b->t ? -1 : 1;
    return (a->vertex > b->vertex) - (a->vertex < b->vertex);
}

static void merge(finder *f, uint32_t a, uint32_t b)
{
    f->merged = f->merged || sets_root(f->parent, a) != sets_root(f->parent, b);
    sets_join(f->parent, a, b);
}

/* Merges stops whose places along the side, which has this length, are within the touching distance of one another.
 * Otherwise the side would have a part between them, or would end a part at one of them where another side ends at the
 * other. */
static void merge_stops(finder *f, double length)
{
    if (f->stop_count > 1)
        qsort(f->stop, f->stop_count, sizeof *f->stop, compare_stops);
    for (size_t k = 1; k < f->stop_count; k++)
        if ((f->stop[k].t - f->stop[k - 1].t) * length <= f->touching)
            merge(f, f->stop[k - 1].vertex, f->stop[k].vertex);
}

/* Finds the vertices on a side and adds them as stops; merges vertices at its ends with these, and stops in one place.
 * The side runs between the vertices with which its ends are merged, so that all sides between the same ones get the
 * same stops. False: no memory. */
static bool find_stops(finder *f, const point_grid *grid, const surface_side *side)
{
    const roberts_vec3 *point = f->s->point;
    const uint32_t v0 = sets_root(f->parent, side->v[0]), v1 = sets_root(f->parent, side->v[1]);
    const uint32_t a = v0 < v1 ? v0 : v1, b = v0 < v1 ? v1 : v0;
    f->stop_count = f->found.count = 0;
    if (!point_grid_near(grid, point[a], point[b], f->touching, &f->found))
        return false;
    for (size_t i = 0; i < f->found.count; i++) {
        uint32_t v = f->found.item[i];
        if (v == a || v == b || (f->group && f->group[v] != f->group[a]))
            continue;
        double t;
        surface_touch touch = surface_touches(point[a], point[b], point[v], f->touching, &t);
        if (touch == TOUCHES_START) {
            merge(f, a, v);
        } else if (touch == TOUCHES_END) {
            merge(f, b, v);
        } else if (touch == TOUCHES_BETWEEN) {
            if (!array_reserve(&f->stop, &f->stop_room, f->stop_count + 1, sizeof *f->stop))
                return false;
            f->stop[f->stop_count++] = (side_stop){t, v};
        }
    }
    merge_stops(f, vec3_length(vec3_sub(point[b], point[a])));
    return true;
}

/* Where a vertex, the smallest one of its place, lies along an edge of the file. The order of the stops and the rows of
 * tables both follow from it. */
static double place_along(const finder *f, const uint32_t v[2], uint32_t at)
{
    const roberts_vec3 *point = f->s->point;
    for (int i = 0; i < 2; i++)
        if (at == sets_root(f->parent, v[i]))
            return i;
    for (int i = 0; i < 2; i++)
        if (vec3_length(vec3_sub(point[at], point[v[i]])) <= f->touching)
            return i;
    return surface_part_of(f->s, v, at);
}

/* Puts the stops of a side in order along an edge of the file. */
static void place_stops(finder *f, const uint32_t v[2])
{
    for (size_t k = 0; k < f->stop_count; k++) {
        side_stop *stop = &f->stop[k];
        stop->vertex = sets_root(f->parent, stop->vertex);
        stop->t = place_along(f, v, stop->vertex);
    }
    if (f->stop_count > 1)
        qsort(f->stop, f->stop_count, sizeof *f->stop, compare_stops);
}

/* The ends of the edge of the file that a side is a part of, or of the side itself if it is a whole edge. */
static bool is_part(const surface *s, uint32_t side, uint32_t v[2])
{
    size_t at = find_numbered(s->side_part, s->part_count, sizeof *s->side_part, side);
    bool part = at < s->part_count && s->side_part[at].edge == side;
    v[0] = part ? s->side_part[at].v[0] : lower(&s->side[side]);
    v[1] = part ? s->side_part[at].v[1] : upper(&s->side[side]);
    return part;
}

/* A side while it is divided, from one end of its edge of the file to the other. */
typedef struct division {
    uint32_t v[2]; /* the edge of the file */
    uint32_t piece, from;
    double t;    /* of `from` */
    bool turned; /* the side itself runs the other way */
    bool part;   /* the result is a part of an edge of the file */
} division;

/* Makes the part between the last stop and this one, unless it has no length along the edge of the file. */
static bool add_half(finder *f, division *d, uint32_t to, double t)
{
    surface *s = f->s;
    uint32_t part = ROBERTS_NONE;
    if (!(t > d->t))
        return true;
    if (d->part) {
        if (!array_reserve(&s->part, &s->edge_part_room, s->edge_part_count + 1, sizeof *s->part))
            return false;
        part = (uint32_t)s->edge_part_count;
        s->part[s->edge_part_count++] = (scene_part){0, {d->v[0], d->v[1]}, d->t, t};
    }
    if (!array_reserve(&f->half_side, &f->half_room, f->half_count + 1, sizeof *f->half_side))
        return false;
    bool down = d->from > to;
    f->half_side[f->half_count++] =
        (part_side){{down ? to : d->from, down ? d->from : to}, d->piece, down != d->turned, part};
    d->from = to;
    d->t = t;
    return true;
}

/* Divides an odd side at its stops. False: no memory. */
static bool divide(finder *f, uint32_t i)
{
    const surface_side side = f->s->side[i];
    division d = {.piece = side.piece};
    d.part = is_part(f->s, i, d.v);
    uint32_t end[2] = {sets_root(f->parent, side.v[0]), sets_root(f->parent, side.v[1])};
    double t[2] = {place_along(f, d.v, end[0]), place_along(f, d.v, end[1])};
    d.turned = t[0] > t[1];
    d.from = end[d.turned];
    d.t = t[d.turned];
    place_stops(f, d.v);
    bool enough = true;
    for (size_t k = 0; enough && k < f->stop_count; k++)
        if (f->stop[k].t > d.t && f->stop[k].t < t[!d.turned]) {
            d.part = true;
            enough = add_half(f, &d, f->stop[k].vertex, f->stop[k].t);
        }
    return enough && add_half(f, &d, end[!d.turned], t[!d.turned]);
}

/* Rounds of merging vertices: few merge after the second, and no file may take longer. */
enum { MERGE_ROUNDS = 8 };

/* Merges vertices until those that are left are apart, then divides all sides. False: no memory. */
static bool divide_all(finder *f)
{
    point_grid grid;
    const surface *s = f->s;
    bool enough = point_grid_build(&grid, s->point, f->vertex, f->vertex_count);
    f->merged = true;
    for (int round = 0; enough && f->merged && round < MERGE_ROUNDS; round++) {
        f->merged = false;
        for (size_t i = 0; enough && i < f->odd_count; i++)
            enough = find_stops(f, &grid, &s->side[f->odd[i]]);
    }
    for (size_t i = 0; enough && i < f->odd_count; i++)
        enough = find_stops(f, &grid, &s->side[f->odd[i]]) && divide(f, f->odd[i]);
    point_grid_free(&grid);
    return enough;
}

static int compare_halves(const void *pa, const void *pb)
{
    const part_side *a = pa, *b = pb;
    int order = compare_pairs(a->v, b->v);
    if (order != 0)
        return order;
    if ((a->piece & ~SURFACE_CUT) != (b->piece & ~SURFACE_CUT))
        return (a->piece & ~SURFACE_CUT) < (b->piece & ~SURFACE_CUT) ? -1 : 1;
    return (int)a->turned - (int)b->turned;
}

/* Sets the ends of an edge's part to the edge's vertices, so that consecutive parts meet. */
static void place_part(const finder *f, scene_part *part, const surface_edge *edge)
{
    double t[2] = {place_along(f, part->v, edge->v[0]), place_along(f, part->v, edge->v[1])};
    part->t0 = lesser(t[0], t[1]);
    part->t1 = greater(t[0], t[1]);
}

/* Returns how many pieces a complete edge has. */
static uint32_t pieces_of(const surface_edge *e)
{
    return e->many == ROBERTS_NONE ? 2 : e->many_end - e->many;
}

/* Makes one edge of the divided sides first .. end - 1 and an existing edge, if there is one. False: no memory. */
static bool take_odd_group(finder *f, size_t first, size_t end, const surface_edge *there)
{
    surface *s = f->s;
    surface_edge edge = {.v = {f->half_side[first].v[0], f->half_side[first].v[1]},
                         .piece = {ROBERTS_NONE, ROBERTS_NONE},
                         .many = ROBERTS_NONE,
                         .part = ROBERTS_NONE,
                         .cut = true,
                         .odd = true};
    uint32_t count = 0, best = ROBERTS_NONE;
    for (uint32_t n = there ? pieces_of(there) : 0; count < n; count++)
        if (!add_incidence(s, &edge, count,
                           there->many == ROBERTS_NONE ? there->piece[count] : s->many[there->many + count]))
            return false;
    for (size_t i = first; i < end; i++) {
        const part_side *half = &f->half_side[i];
        bool wire = (half->piece & ~SURFACE_CUT) == SURFACE_WIRE;
        if (!wire && !add_incidence(s, &edge, count++, incidence(half->piece, half->turned)))
            return false;
        edge.cut = edge.cut && (half->piece & SURFACE_CUT);
        if (best == ROBERTS_NONE || (f->half_side[best].part != ROBERTS_NONE && half->part == ROBERTS_NONE))
            best = (uint32_t)i;
    }
    edge.part = there ? there->part : f->half_side[best].part;
    if (edge.part != ROBERTS_NONE)
        place_part(f, &s->part[edge.part], &edge);
    edge.cut = edge.cut && (!there || there->cut);
    if (!array_reserve(&f->odd_edge, &f->odd_edge_room, f->odd_edge_count + 1, sizeof *f->odd_edge))
        return false;
    f->odd_edge[f->odd_edge_count++] = edge;
    return true;
}

/* Returns the complete edge with these ends; NULL: none. */
static surface_edge *find_surface_edge(const surface *s, const uint32_t v[2])
{
    size_t low = 0, high = s->edge_count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (compare_pairs(s->edge[middle].v, v) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return low < s->edge_count && compare_pairs(s->edge[low].v, v) == 0 ? &s->edge[low] : NULL;
}

/* Makes edges of the divided sides. Such an edge replaces a complete edge with the same ends. False: no memory. */
static bool take_odd_groups(finder *f)
{
    surface *s = f->s;
    if (f->half_count > 1)
        qsort(f->half_side, f->half_count, sizeof *f->half_side, compare_halves);
    for (size_t i = 0, to; i < f->half_count; i = to) {
        for (to = i + 1; to < f->half_count && f->half_side[to].v[0] == f->half_side[i].v[0] &&
                         f->half_side[to].v[1] == f->half_side[i].v[1];
             to++)
            continue;
        surface_edge *there = find_surface_edge(s, f->half_side[i].v);
        if (!take_odd_group(f, i, to, there))
            return false;
    }
    return true;
}

/* Merges both sorted lists of edges. False: no memory. */
static bool merge_edges(finder *f)
{
    surface *s = f->s;
    size_t all = s->edge_count + f->odd_edge_count, to = 0, i = 0, k = 0;
    surface_edge *edge = alloc_array(all, sizeof *edge);
    if (!edge)
        return false;
    while (i < s->edge_count || k < f->odd_edge_count) {
        int order = i == s->edge_count       ? 1
                    : k == f->odd_edge_count ? -1
                                             : compare_pairs(s->edge[i].v, f->odd_edge[k].v);
        if (order < 0) {
            edge[to++] = s->edge[i++];
        } else {
            edge[to++] = f->odd_edge[k++];
            i += order == 0;
        }
    }
    free(s->edge);
    s->edge = edge;
    s->edge_count = to;
    s->edge_room = all;
    return true;
}

/* Turns the parts so that the numbers of the mesh ascend along the edges of the file, as those of the surface do. Of
 * two copied vertices, the one with the larger number in the mesh may have the smaller one in the surface. */
static void turn_parts(surface *s)
{
    for (size_t i = 0; i < s->edge_part_count; i++) {
        scene_part *part = &s->part[i];
        if (surface_number(s, part->v[0]) > surface_number(s, part->v[1]))
            *part = (scene_part){part->edge, {part->v[1], part->v[0]}, 1.0 - part->t1, 1.0 - part->t0};
    }
}

bool surface_find_edges(surface *s, double touching)
{
    finder f = {.s = s, .touching = touching};
    if (s->part_count > 0) {
        if (!(f.divided = alloc_array(s->part_count, sizeof *f.divided)))
            return false;
        memcpy(f.divided, s->side_part, s->part_count * sizeof *f.divided);
        qsort(f.divided, s->part_count, sizeof *f.divided, compare_names);
    }
    bool enough = sort_sides(&f) && take_groups(&f);
    free(f.half);
    free(f.end);
    if (enough && f.odd_count > 0)
        enough = list_vertices(&f) && divide_all(&f) && take_odd_groups(&f) && merge_edges(&f);
    turn_parts(s);
    free(f.divided);
    free(f.odd);
    free(f.vertex);
    free(f.parent);
    free(f.group);
    free(f.half_side);
    free(f.odd_edge);
    free(f.stop);
    free(f.found.item);
    free(s->side);
    free(s->side_part);
    s->side = NULL;
    s->side_part = NULL;
    return enough && s->edge_count < ROBERTS_NONE;
}

bool surface_is_even(const surface *s, const surface_edge *e)
{
    uint32_t face[SURFACE_EVEN_MOST], count = 0;
    if (e->piece[1] == ROBERTS_NONE)
        return false;
    for (uint32_t k = e->many; e->many != ROBERTS_NONE && k < e->many_end; k++) {
        const uint32_t own = s->face[surface_piece(s->many[k])];
        uint32_t i = 0;
        while (i < count && face[i] != own)
            i++;
        if (i == SURFACE_EVEN_MOST)
            return false;
        face[i] = own;
        count += i == count;
    }
    return count % 2 == 0;
}

/* ---- in the order of the file ------------------------------------------------------------------------------------ */

/* An edge and its name in the file. */
typedef struct edge_key {
    uint32_t v[2];
    double t;
    uint32_t edge; /* of the surface */
} edge_key;

static int compare_keys(const void *pa, const void *pb)
{
    const edge_key *a = pa, *b = pb;
    int order = compare_pairs(a->v, b->v);
    if (order != 0)
        return order;
    if (a->t != b->t)
        return a->t < b->t ? -1 : 1;
    return (a->edge > b->edge) - (a->edge < b->edge);
}

/* The name of an edge: the vertices of the mesh, in ascending order, at the ends of the edge or of the edge of the file
 * of which it is a part. */
static void name_of(const surface *s, const surface_edge *e, uint32_t name[2])
{
    const uint32_t *v = e->part == ROBERTS_NONE ? e->v : s->part[e->part].v;
    const uint32_t a = surface_number(s, v[0]), b = surface_number(s, v[1]);
    name[0] = a < b ? a : b;
    name[1] = a < b ? b : a;
}

/* Sorts the edges of one body by their names. The surface has them sorted by their ends, which differ from the names
 * only for parts and for copies of vertices. False: no memory. */
static bool sort_by_name(const surface *s, uint32_t *order, uint32_t count)
{
    edge_key *key = alloc_array(count, sizeof *key);
    if (!key)
        return false;
    for (uint32_t i = 0; i < count; i++) {
        const surface_edge *e = &s->edge[order[i]];
        key[i] = (edge_key){{0, 0}, e->part == ROBERTS_NONE ? 0.0 : s->part[e->part].t0, order[i]};
        name_of(s, e, key[i].v);
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
        uint32_t odd = s->piece_count;
        for (uint32_t i = 0; i < s->edge_count; i++) {
            uint32_t body = of[s->edge[i].odd ? odd++ : surface_piece(s->edge[i].piece[0])];
            if (pass == 0)
                list->first[body]++;
            else
                list->order[list->first[body]++] = i;
        }
        if (pass == 0)
            sort_starts(list->first, bodies + (size_t)1);
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
    for (uint32_t b = 0; enough && (s->edge_part_count > 0 || s->copies > 0) && b < bodies; b++)
        enough = sort_by_name(s, list->order + list->first[b], body_edges_count(list, b));
    return enough;
}

/* ---- into the scene ---------------------------------------------------------------------------------------------- */

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
        to->many_face[list->many_faces++] = list->face[surface_piece(many[k])] | (turned ? MANY_TURNED : 0);
    }
    return true;
}

static bool store_part(body_edges *list, scene_surface *to, const surface_edge *e, uint32_t edge)
{
    const surface *s = list->surface;
    const scene_part *part = &s->part[e->part];
    if (!array_reserve(&to->part, &list->part_room, to->part_count + (size_t)1, sizeof *to->part))
        return false;
    to->part[to->part_count++] =
        (scene_part){edge, {surface_number(s, part->v[0]), surface_number(s, part->v[1])}, part->t0, part->t1};
    return true;
}

/* Does the edge run opposite to its name, or to the file's edge of which it is a part? */
static bool runs_back(const surface *s, const surface_edge *e)
{
    if (e->part == ROBERTS_NONE)
        return surface_number(s, e->v[0]) > surface_number(s, e->v[1]);
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
        const bool back = runs_back(s, e);
        *stored = (scene_edge){{back ? v1 : v0, back ? v0 : v1}, {ROBERTS_NONE, ROBERTS_NONE}};
        for (int k = 0; k < 2 && e->piece[k] != ROBERTS_NONE; k++) {
            stored->f[k] = list->face[surface_piece(e->piece[k])] - own->face;
            if (((e->piece[k] & SURFACE_TURNED) != 0) != back)
                is |= (uint8_t)(k ? EDGE_TURNED_1 : EDGE_TURNED_0);
        }
        is |= (uint8_t)((e->many != ROBERTS_NONE ? EDGE_MANY : 0) | (e->part != ROBERTS_NONE ? EDGE_PART : 0));
        if ((is & EDGE_MANY && !store_many(list, to, e, edge, back)) ||
            (is & EDGE_PART && !store_part(list, to, e, edge)))
            return false;
        to->edge_is[edge] = is;
        closed = closed && surface_is_even(s, e);
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

/* ---- curved surfaces --------------------------------------------------------------------------------------------- */

/* Bends are squared distances of unit normals: above FLAT_BEND (0.1 degrees) an edge is bent, below LITTLE_BEND (20
 * degrees) only slightly. */
#define FLAT_BEND 3.046e-6
#define LITTLE_BEND 0.1206

void bend_count_add(bend_count *count, double bend)
{
    count->much += bend > FLAT_BEND && !(bend < LITTLE_BEND);
    count->little += bend > FLAT_BEND && bend < LITTLE_BEND;
}

static bool mostly_little(const bend_count *count)
{
    return count->little > 0 && count->little >= count->much;
}

/* Returns the bend at edge e of body b; NAN: it has not two faces. */
static double bend_at(const roberts_scene *scene, uint32_t b, uint32_t e)
{
    const scene_solid *own = &scene->solid[b];
    const scene_edge *edge = scene_edge_stored(scene, b, e);
    const uint8_t is = scene->surface->edge_is[e];
    if (is & (EDGE_MANY | EDGE_CUT) || edge->f[1] == ROBERTS_NONE)
        return NAN;
    return scene_bend(scene_plane(scene, own->face + edge->f[0]), scene_plane(scene, own->face + edge->f[1]), is);
}

static bend_count count_bends(const roberts_scene *scene, uint32_t b)
{
    bend_count count = {0};
    for (uint32_t e = scene->solid[b].edge; e < scene->solid[b + 1].edge; e++)
        bend_count_add(&count, bend_at(scene, b, e));
    return count;
}

/* Is at least half of the facets of body b curved? False: no memory. */
static bool facets_are_curved(const roberts_scene *scene, uint32_t b, bool *curved)
{
    const scene_solid *own = &scene->solid[b];
    const uint32_t faces = own[1].face - own->face;
    uint32_t *parent = alloc_array(faces, sizeof *parent), facets = 0, round = 0;
    bend_count *of = alloc_zeroed(faces, sizeof *of);
    const bool enough = parent && of;
    for (uint32_t f = 0; enough && f < faces; f++)
        parent[f] = f;
    for (uint32_t e = own->edge; enough && e < own[1].edge; e++)
        if (bend_at(scene, b, e) <= FLAT_BEND)
            sets_join(parent, scene_edge_stored(scene, b, e)->f[0], scene_edge_stored(scene, b, e)->f[1]);
    for (uint32_t e = own->edge; enough && e < own[1].edge; e++) {
        const uint32_t *f = scene_edge_stored(scene, b, e)->f;
        const double bend = bend_at(scene, b, e);
        for (int k = 0; k < 2 && f[k] != ROBERTS_NONE; k++)
            bend_count_add(&of[sets_root(parent, f[k])], bend);
    }
    for (uint32_t f = 0; enough && f < faces; f++) {
        facets += parent[f] == f;
        round += parent[f] == f && mostly_little(&of[f]);
    }
    *curved = round >= facets - round;
    free(parent);
    free(of);
    return enough;
}

bool body_find_smooth(const roberts_scene *scene, uint32_t b, const bend_count *counted)
{
    if (scene->solid[b + 1].face - scene->solid[b].face <= ROBERTS_FACETED_MOST)
        return true;
    const bend_count count = counted ? *counted : count_bends(scene, b);
    bool curved = mostly_little(&count);
    const bool enough = curved || count.little == 0 || facets_are_curved(scene, b, &curved);
    scene->surface->smooth[b] = curved;
    return enough;
}

/* ---- wires beside convex solids ---------------------------------------------------------------------------------- */

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
