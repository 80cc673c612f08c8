/* crossed.c - the faces that cross in an intersection. See crossed.h. */
#include "ray/crossed.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/sort.h"

/* Distances beside the line at which rays are cast, in touching distances. An end of the line may have been moved to a
 * corner within that distance, so the first ray is farther away. Near the ends of the line a face may be narrow, so
 * rays are also cast nearer. */
static const double beside[] = {4.0, 0.5, 0.05, 0.005};

/* Departures: how far a line in two faces may lie beside them if their corners depart from their planes. It depends on
 * the angle between the planes. */
#define DEPARTURES 8.0

static int by_number(const void *pa, const void *pb)
{
    const crossed_piece *a = pa, *b = pb;
    if (a->number != b->number)
        return a->number < b->number ? -1 : 1;
    return (a->face > b->face) - (a->face < b->face);
}

/* Puts an edge of `body` with several faces down at these; only counts them if there is no list yet. */
static void add_crossed_edge(crossed *c, uint32_t body, uint32_t e)
{
    const roberts_scene *scene = c->scene;
    uint32_t room[2];
    const uint32_t *face;
    const uint32_t count = scene_faces_at(scene, body, e, room, &face);
    for (uint32_t k = 0; count > 1 && k < count; k++) {
        const uint32_t f = face[k] & ~MANY_TURNED;
        if (c->edge)
            c->edge[--c->edge_start[f]] = e;
        else
            c->edge_start[f]++;
    }
}

/* Lists the edges of all faces, by counting. False: no memory. */
static bool list_edges(crossed *c)
{
    const roberts_scene *scene = c->scene;
    uint32_t total = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (uint32_t body = 0; body < scene->solid_count; body++)
            for (uint32_t e = scene->solid[body].edge; e < scene->solid[body + 1].edge; e++)
                add_crossed_edge(c, body, e);
        for (uint32_t f = 0; pass == 0 && f <= scene->face_count; f++)
            total = c->edge_start[f] += total;
        if (pass == 0 && !(c->edge = alloc_array(total, sizeof *c->edge)))
            return false;
    }
    return true;
}

bool crossed_begin(crossed *c, const roberts_scene *scene, double touching)
{
    *c = (crossed){.scene = scene,
                   .touching = touching,
                   .piece = alloc_array(scene->face_count, sizeof *c->piece),
                   .edge_start = alloc_zeroed((size_t)scene->face_count + 1, sizeof *c->edge_start)};
    if (!c->piece || !c->edge_start || !list_edges(c))
        return false;
    for (uint32_t body = 0; body < scene->solid_count; body++)
        for (uint32_t f = scene->solid[body].face; f < scene->solid[body + 1].face; f++)
            c->piece[f] = (crossed_piece){scene_face_number(scene, f), body, f};
    qsort(c->piece, scene->face_count, sizeof *c->piece, by_number);
    return true;
}

void crossed_end(crossed *c)
{
    free(c->piece);
    free(c->edge_start);
    free(c->edge);
    *c = (crossed){0};
}

/* Returns the first piece of the face with this number; face_count: none. */
static uint32_t first_piece(const crossed *c, uint32_t number)
{
    return (uint32_t)find_numbered(c->piece, c->scene->face_count, sizeof *c->piece, number);
}

static bool is_point_in_plane(const crossed *c, uint32_t face, roberts_vec3 X)
{
    double off = plane_at(scene_plane(c->scene, face), vec3_sub(X, c->scene->centre));
    return fabs(off) <= 2.0 * (c->touching + scene_deviation(c->scene, face));
}

/* Is X, a point of the piece's plane, in the piece, or no farther outside than `loose` plus the corners' departures? */
static bool holds(const crossed *c, uint32_t face, roberts_vec3 X, double loose)
{
    const roberts_scene *scene = c->scene;
    loose += DEPARTURES * scene_deviation(scene, face);
    plane F = scene_plane(scene, face);
    const roberts_vec3 n = {-F.a, -F.b, -F.c};
    uint32_t first = scene->face_start[face], end = scene->face_start[face + 1];
    for (uint32_t k = first; k < end; k++) {
        roberts_vec3 P = scene->point[scene->corner[k]], Q = scene->point[scene->corner[k + 1 < end ? k + 1 : first]];
        roberts_vec3 side = vec3_sub(Q, P);
        double off = vec3_dot(n, vec3_cross(side, vec3_sub(X, P)));
        if (off < -loose * vec3_length(side))
            return false;
    }
    return true;
}

/* Is X in a piece of the face with this number that lies in the plane of `face`? */
static bool face_holds(const crossed *c, const crossed_piece *like, roberts_vec3 X, double loose)
{
    const roberts_scene *scene = c->scene;
    uint32_t key = seen_face_key(scene, like->body, like->face);
    bool convex = scene_is_convex(scene, like->body);
    if (convex)
        return holds(c, like->face, X, loose);
    for (uint32_t k = first_piece(c, like->number); k < scene->face_count && c->piece[k].number == like->number; k++)
        if (seen_face_key(scene, c->piece[k].body, c->piece[k].face) == key && holds(c, c->piece[k].face, X, loose))
            return true;
    return false;
}

static roberts_vec3 point_at(const roberts_crossing *line, double t)
{
    return vec3_add(line->end[0], vec3_scale(t, vec3_sub(line->end[1], line->end[0])));
}

/* Does the line lie in this face? */
static bool lies_in(const crossed *c, const roberts_crossing *line, const crossed_piece *p)
{
    return is_point_in_plane(c, p->face, line->end[0]) && is_point_in_plane(c, p->face, line->end[1]) &&
           face_holds(c, p, point_at(line, 0.5), c->touching);
}

/* Are these two faces, and not twice the same one? */
static bool are_two(const crossed *c, const crossed_piece *p, const crossed_piece *q)
{
    return p->body != q->body || (p->face != q->face && seen_face_key(c->scene, p->body, p->face) !=
                                                            seen_face_key(c->scene, q->body, q->face));
}

/* On how many sides of X is the face met, so far from it? */
static int sides_met(const crossed *c, const crossed_piece *of, roberts_vec3 X, roberts_vec3 d, double far)
{
    plane F = scene_plane(c->scene, of->face);
    roberts_vec3 aside = vec3_cross((roberts_vec3){F.a, F.b, F.c}, d);
    double length = vec3_length(aside);
    if (!(length > 0.0))
        return 2; /* too short to tell */
    aside = vec3_scale(far / length, aside);
    return face_holds(c, of, vec3_add(X, aside), 0.25 * far) + face_holds(c, of, vec3_sub(X, aside), 0.25 * far);
}

/* An edge of the face on which X lies and that another face has, too; ROBERTS_NONE: there is none. */
static uint32_t edge_at(const crossed *c, const crossed_piece *of, roberts_vec3 X)
{
    const roberts_scene *scene = c->scene;
    const uint32_t key = seen_face_key(scene, of->body, of->face);
    double touching = 2.0 * (c->touching + scene_deviation(scene, of->face));
    for (uint32_t k = first_piece(c, of->number); k < scene->face_count && c->piece[k].number == of->number; k++) {
        uint32_t f = c->piece[k].face;
        if (c->piece[k].body != of->body || seen_face_key(scene, of->body, f) != key)
            continue;
        for (uint32_t n = c->edge_start[f]; n < c->edge_start[f + 1]; n++) {
            const scene_edge e = scene_edge_at(scene, of->body, c->edge[n]);
            roberts_vec3 A = scene->point[e.v[0]], AB = vec3_sub(scene->point[e.v[1]], A);
            double t = vec3_dot(AB, vec3_sub(X, A)) / vec3_dot(AB, AB);
            if (t > 0.0 && t < 1.0 && vec3_length(vec3_sub(X, vec3_add(A, vec3_scale(t, AB)))) <= touching)
                return c->edge[n];
        }
    }
    return ROBERTS_NONE;
}

/* Do rays meet both faces on both sides of X, at this distance? If `ends`, a face may also end there along an edge. */
static bool are_met_beside(const crossed *c, crossed_faces *faces, roberts_vec3 X, roberts_vec3 d, double far,
                           bool ends)
{
    for (int i = 0; i < 2; i++) {
        int met = sides_met(c, &faces->of[i], X, d, far);
        faces->edge[i] = ends && met == 1 ? edge_at(c, &faces->of[i], X) : ROBERTS_NONE;
        if (met == 0 || (met == 1 && faces->edge[i] == ROBERTS_NONE))
            return false;
    }
    return true;
}

/* Do both faces continue on both sides of the line, somewhere near its middle? If `ends`, they may also end along an
 * edge there. Sets the edges. */
static bool do_cross(const crossed *c, const roberts_crossing *line, crossed_faces *faces, bool ends)
{
    static const double places[] = {0.5, 0.31, 0.77};
    roberts_vec3 d = vec3_sub(line->end[1], line->end[0]);
    faces->edge[0] = faces->edge[1] = ROBERTS_NONE;
    if (vec3_length(d) <= 2.0 * c->touching)
        return true; /* too short to test: its ends may be off by the touching distance */
    for (int k = 0; k < 3; k++)
        for (size_t n = 0; n < sizeof beside / sizeof *beside; n++)
            if (are_met_beside(c, faces, point_at(line, places[k]), d, beside[n] * c->touching, ends))
                return true;
    return false;
}

static bool find_pair(const crossed *c, const roberts_crossing *line, crossed_faces *out, bool ends)
{
    const crossed_piece *end = c->piece + c->scene->face_count, *p = c->piece + first_piece(c, line->face[0]);
    for (; p < end && p->number == line->face[0]; p++) {
        if (!lies_in(c, line, p))
            continue;
        const crossed_piece *q = c->piece + first_piece(c, line->face[1]);
        for (; q < end && q->number == line->face[1]; q++) {
            *out = (crossed_faces){.of = {*p, *q}};
            if (are_two(c, p, q) && lies_in(c, line, q) && do_cross(c, line, out, ends))
                return true;
        }
    }
    return false;
}

bool crossed_find(const crossed *c, const roberts_crossing *line, crossed_faces *out)
{
    return find_pair(c, line, out, false) || find_pair(c, line, out, true);
}
