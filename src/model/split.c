/* split.c - separates solids that share edges.
 *
 * A piece is a set of faces that are connected by edges. (Two solids that share only a corner are two pieces.) If each
 * edge of a piece has two faces, the piece is a solid. If some edge has an odd number of faces, the piece is left as it
 * is. Otherwise solids touch: four or six faces meet at an edge. Two methods separate such a piece:
 *
 * 1. By the file. The faces of a solid usually follow one another. Faces are taken in order until each of their edges
 *    has two of them. They form one solid, or several that do not touch. This needs no geometry, and restores what was
 *    written.
 * 2. By the angles between faces, if the first method fails: see below.
 *
 * Both take linear time if faces have few neighbours. */
#include "model/split.h"

#include <stdlib.h>
#include <string.h>

#include "base/angle.h"
#include "base/array.h"
#include "base/sets.h"
#include "base/sort.h"
#include "model/face_plane.h"
#include "model/solid.h"

/* ---- by angles: the walk along the walls ----------------------------------------------------------------------- */

/* The solids are found like rooms, by walking along the walls. The walk starts from one side of a face, which is taken
 * as the inner side. At each edge it continues with the next face met when turning through the inside. Solids are
 * convex, so this is at most a half turn. A walk that closes is a solid.
 *
 * Faces with the same vertices are one wall with two sides, and each side belongs to another solid. The first walk
 * starts from the outermost face, of which only one side can close. The next walks start from the other sides of the
 * walls just taken, since the neighbours are there. A budget limits the time that hostile input can take. */

/* Data of both methods. */
typedef struct splitter {
    const roberts_scene *loose;
    const edge_scratch *edges;
    split_groups *groups;
    uint32_t face_count, corner_count, edge_count;
    uint32_t *edge_of;    /* [corner_count] edge that starts at the corner */
    uint32_t *edge_start; /* [edge_count + 1] into edges->half */
    uint32_t *parent;     /* [face_count] union-find over edges */
    uint32_t *order;      /* [face_count] faces by piece */
    uint32_t *count;      /* [edge_count] number of faces taken at each edge; 0 between uses */
    uint32_t *last;       /* [edge_count] the last face taken at each edge */
} splitter;

/* Returns the face of half-edge i. */
static inline uint32_t splitter_face(const splitter *s, uint32_t i)
{
    return s->edges->face_of[(uint32_t)s->edges->half[i]];
}

/* Adds a group and returns its number. */
static inline uint32_t splitter_group(splitter *s, bool closed)
{
    s->groups->closed[s->groups->count] = closed;
    return s->groups->count++;
}

/* Radians: within this angle, neighbours count as coplanar, or as folded onto one another. It is coarse because it only
 * guides the walk; the result is checked like any other solid. */
static const double ANGLE_SLACK = 0.01;

/* Radians: angles that differ by less are tied. */
static const double ANGLE_TIE = 1e-6;

enum { BUDGET = 40 }; /* angles per corner that the walks may compute on average; blocks of cubes take about 7 */

/* Faces with the same vertices. */
typedef struct wall {
    uint32_t first, size, used; /* members: sorted[first] .. sorted[first + size - 1]; the first `used` are taken */
    uint32_t walk;              /* the walk that contains it */
    int side;                   /* +1: n points to its inside, -1: away from it */
    roberts_vec3 n, middle;
} wall;

typedef struct wall_key {
    uint64_t hash; /* of the vertices, independent of their order */
    uint32_t face;
} wall_key;

typedef struct start_key {
    roberts_vec3 at; /* the least corner */
    double facing;   /* |x| of the normal, greatest first */
    uint32_t wall;
} start_key;

typedef struct step {
    uint32_t wall;
    int side;
} step;

typedef struct walker {
    splitter *s;
    const solid_frame *frame;
    wall *walls;
    uint32_t wall_count, walk;
    wall_key *sorted;  /* [faces of the piece] */
    uint32_t *wall_of; /* [face_count] */
    start_key *start;  /* [wall_count] */
    step *queue;       /* [wall_count] the current walk */
    step *beyond;      /* the other sides of walls taken */
    uint32_t beyond_count;
    size_t beyond_room;
    uint64_t budget;
} walker;

static uint64_t scramble(uint64_t x)
{
    x = (x + 0x9e3779b97f4a7c15u) * 0xbf58476d1ce4e5b9u;
    x = (x ^ x >> 27) * 0x94d049bb133111ebu;
    return x ^ x >> 31;
}

static int compare_wall_keys(const void *a, const void *b)
{
    const wall_key *p = a, *q = b;
    if (p->hash != q->hash)
        return p->hash < q->hash ? -1 : 1;
    return (p->face > q->face) - (p->face < q->face);
}

static int compare_starts(const void *a, const void *b)
{
    const start_key *p = a, *q = b;
    int order = vec3_compare(p->at, q->at);
    if (order)
        return order;
    if (p->facing != q->facing)
        return p->facing > q->facing ? -1 : 1;
    return (p->wall > q->wall) - (p->wall < q->wall);
}

static uint32_t size_of(const splitter *s, uint32_t f)
{
    return s->loose->face_start[f + 1] - s->loose->face_start[f];
}

/* Sorts the piece's faces into walls. Faces may have the same hash by chance (one in 2^64) or by malice. Then the walk
 * does not close, and is rejected like any other. */
static void find_walls(walker *w, uint32_t from, uint32_t to)
{
    splitter *s = w->s;
    for (uint32_t i = from; i < to; i++) {
        uint32_t f = s->order[i];
        uint64_t hash = 0;
        for (uint32_t c = s->loose->face_start[f]; c < s->loose->face_start[f + 1]; c++)
            hash += scramble(s->loose->corner[c]);
        w->sorted[i - from] = (wall_key){hash, f};
    }
    qsort(w->sorted, to - from, sizeof *w->sorted, compare_wall_keys);
    for (uint32_t i = 0; i < to - from; i++) {
        if (i == 0 || w->sorted[i].hash != w->sorted[i - 1].hash ||
            size_of(s, w->sorted[i].face) != size_of(s, w->sorted[i - 1].face))
            w->walls[w->wall_count++] = (wall){.first = i};
        w->walls[w->wall_count - 1].size++;
        w->wall_of[w->sorted[i].face] = w->wall_count - 1;
    }
}

static void measure_walls(walker *w)
{
    for (uint32_t i = 0; i < w->wall_count; i++) {
        wall *it = &w->walls[i];
        uint32_t n = frame_ring(w->frame, w->s->loose, w->sorted[it->first].face);
        roberts_vec3 origin = frame_origin(w->frame, w->s->loose, w->sorted[it->first].face);
        roberts_vec3 least = origin, sum = {0, 0, 0};
        it->n = face_plane_fit(w->frame->ring, n).n;
        for (uint32_t k = 0; k < n; k++) {
            roberts_vec3 p = vec3_add(origin, w->frame->ring[k]);
            sum = vec3_add(sum, p);
            if (p.x < least.x || (p.x == least.x && (p.y < least.y || (p.y == least.y && p.z < least.z))))
                least = p;
        }
        it->middle = vec3_scale(1.0 / n, sum);
        w->start[i] = (start_key){least, fabs(it->n.x), i};
    }
    qsort(w->start, w->wall_count, sizeof *w->start, compare_starts);
}

/* Returns the direction from the edge at P into the face. `along` is the direction of the edge, of length 1. */
static roberts_vec3 into_face(const wall *it, roberts_vec3 P, roberts_vec3 along)
{
    roberts_vec3 d = vec3_sub(it->middle, P);
    d = vec3_sub(d, vec3_scale(vec3_dot(d, along), along));
    return vec3_scale(1.0 / vec3_length(d), d);
}

/* Finds the next wall over edge e when turning from `it` through the inside. False: there is none within a half
 * turn. */
static bool next_wall(walker *w, uint32_t it, int side, uint32_t e, step *next)
{
    const splitter *s = w->s;
    const wall *from = &w->walls[it];
    uint32_t corner = (uint32_t)s->edges->half[s->edge_start[e]], f = s->edges->face_of[corner];
    uint32_t after = corner + 1 < s->loose->face_start[f + 1] ? corner + 1 : s->loose->face_start[f];
    roberts_vec3 P = w->frame->point[s->loose->corner[corner]], Q = w->frame->point[s->loose->corner[after]];
    roberts_vec3 along = vec3_sub(Q, P), u, m = vec3_scale(side, from->n);
    double best = PI + ANGLE_SLACK;
    bool found = false;
    along = vec3_scale(1.0 / vec3_length(along), along);
    u = into_face(from, P, along);
    for (uint32_t i = s->edge_start[e]; i < s->edge_start[e + 1]; i++) {
        uint32_t other = w->wall_of[splitter_face(s, i)];
        const wall *to = &w->walls[other];
        roberts_vec3 v = into_face(to, P, along), back;
        double angle = atan2(vec3_dot(v, m), vec3_dot(v, u));
        bool taken = to->walk == w->walk;
        w->budget -= w->budget > 0;
        if (other == it || (!taken && to->used == to->size) || !(angle > ANGLE_SLACK || angle < -3.0))
            continue;
        angle = angle < 0.0 ? angle + 2.0 * PI : angle;
        /* of coincident walls, prefer the one that is already in the walk */
        if (found && (angle > best + ANGLE_TIE || (angle > best - ANGLE_TIE && !taken)))
            continue;
        if (!found && !(angle <= best))
            continue;
        back = vec3_sub(vec3_scale(sin(angle), u), vec3_scale(cos(angle), m));
        best = angle;
        found = true;
        *next = (step){other, vec3_dot(to->n, back) > 0.0 ? 1 : -1};
    }
    return found;
}

/* Walks from one side of a wall. Returns the number of walls in w->queue; 0: the walk does not close. */
static uint32_t walk_from(walker *w, step begin)
{
    const splitter *s = w->s;
    uint32_t head = 0, tail = 0;
    w->walk++;
    w->walls[begin.wall].walk = w->walk;
    w->walls[begin.wall].side = begin.side;
    w->queue[tail++] = begin;
    while (head < tail) {
        step here = w->queue[head++], next;
        uint32_t f = w->sorted[w->walls[here.wall].first].face;
        for (uint32_t c = s->loose->face_start[f]; c < s->loose->face_start[f + 1]; c++) {
            if (w->budget == 0 || !next_wall(w, here.wall, here.side, s->edge_of[c], &next))
                return 0;
            wall *to = &w->walls[next.wall];
            if (to->walk == w->walk && to->side != next.side)
                return 0;
            if (to->walk == w->walk)
                continue;
            to->walk = w->walk;
            to->side = next.side;
            w->queue[tail++] = next;
        }
    }
    return tail;
}

/* Does each edge of the walk have two of its walls? */
static bool walk_closes(walker *w, uint32_t count)
{
    splitter *s = w->s;
    bool closes = true;
    for (int pass = 0; pass < 3; pass++) /* passes: count, compare, reset */
        for (uint32_t i = 0; i < count; i++) {
            uint32_t f = w->sorted[w->walls[w->queue[i].wall].first].face;
            for (uint32_t c = s->loose->face_start[f]; c < s->loose->face_start[f + 1]; c++) {
                uint32_t *seen = &s->count[s->edge_of[c]];
                closes &= pass != 1 || *seen == 2;
                *seen = pass == 0 ? *seen + 1 : pass == 1 ? *seen : 0;
            }
        }
    return closes;
}

/* Makes a new group of one face from each wall of the walk. Records the other sides of walls that have more faces.
 * False: no memory. */
static bool take_walk(walker *w, uint32_t count)
{
    uint32_t group = splitter_group(w->s, true);
    if (!array_reserve(&w->beyond, &w->beyond_room, (size_t)w->beyond_count + count, sizeof *w->beyond))
        return false;
    for (uint32_t i = 0; i < count; i++) {
        wall *it = &w->walls[w->queue[i].wall];
        w->s->groups->of[w->sorted[it->first + it->used++].face] = group;
        if (it->used < it->size)
            w->beyond[w->beyond_count++] = (step){w->queue[i].wall, -w->queue[i].side};
    }
    return true;
}

static bool try_side(walker *w, step begin, bool *enough)
{
    uint32_t count;
    if (w->walls[begin.wall].used == w->walls[begin.wall].size)
        return false;
    count = walk_from(w, begin);
    if (count == 0 || !walk_closes(w, count))
        return false;
    *enough = take_walk(w, count);
    return true;
}

static bool walk_all(walker *w)
{
    bool enough = true;
    for (uint32_t i = 0; i < w->wall_count && enough; i++) {
        uint32_t it = w->start[i].wall;
        int side = w->walls[it].n.x < 0.0 ? -1 : 1; /* everything left lies toward +x */
        bool more = true;
        while (more && enough) {
            more = try_side(w, (step){it, side}, &enough) || try_side(w, (step){it, -side}, &enough);
            while (enough && w->beyond_count > 0)
                try_side(w, w->beyond[--w->beyond_count], &enough);
        }
    }
    return enough;
}

/* Splits the piece order[from] .. order[to - 1]. `frame` has the points of all pieces. Faces whose walk does not close
 * get no group. False: no memory. */
static bool walls_split(splitter *s, const solid_frame *frame, uint32_t from, uint32_t to)
{
    walker w = {.s = s, .frame = frame};
    size_t faces = to - from;
    bool enough;
    w.walls = alloc_array(faces, sizeof *w.walls);
    w.sorted = alloc_array(faces, sizeof *w.sorted);
    w.wall_of = alloc_array(s->face_count, sizeof *w.wall_of);
    w.start = alloc_array(faces, sizeof *w.start);
    w.queue = alloc_array(faces, sizeof *w.queue);
    enough = w.walls && w.sorted && w.wall_of && w.start && w.queue;
    if (enough) {
        for (uint32_t i = from; i < to; i++)
            w.budget += BUDGET * (uint64_t)size_of(s, s->order[i]);
        find_walls(&w, from, to);
        measure_walls(&w);
        enough = walk_all(&w);
    }
    free(w.walls);
    free(w.sorted);
    free(w.wall_of);
    free(w.start);
    free(w.queue);
    free(w.beyond);
    return enough;
}

/* ---- pieces ---------------------------------------------------------------------------------------------------- */

/* Numbers the edges and joins the faces at each. */
static void number_split_edges(splitter *s)
{
    uint32_t start = 0, vertices = s->loose->vertex_count;
    for (uint32_t f = 0; f < s->face_count; f++)
        s->parent[f] = f;
    for (uint32_t v = 0; v < vertices; start = s->edges->end[v++])
        for (uint32_t i = start; i < s->edges->end[v]; i++) {
            if (i == start || s->edges->half[i] >> 32 != s->edges->half[i - 1] >> 32)
                s->edge_start[s->edge_count++] = i;
            else
                sets_join(s->parent, splitter_face(s, i - 1), splitter_face(s, i));
            s->edge_of[(uint32_t)s->edges->half[i]] = s->edge_count - 1;
        }
    s->edge_start[s->edge_count] = s->corner_count;
}

/* ---- by the file ----------------------------------------------------------------------------------------------- */

/* Makes a group of each connected part of order[from] .. order[to - 1]. Each of their edges has two faces. */
static void group_run(splitter *s, uint32_t *parent, uint32_t from, uint32_t to)
{
    for (uint32_t i = from; i < to; i++) {
        uint32_t f = s->order[i];
        for (uint32_t c = s->loose->face_start[f]; c < s->loose->face_start[f + 1]; c++)
            sets_join(parent, f, s->last[s->edge_of[c]]);
    }
    for (uint32_t i = from; i < to; i++) {
        uint32_t f = s->order[i], root = sets_root(parent, f); /* the root is the smallest and comes first */
        s->groups->of[f] = root == f ? splitter_group(s, true) : s->groups->of[root];
    }
}

/* Splits the piece order[from] .. order[to - 1] into closed runs of faces. False: the last run does not close; then
 * nothing is grouped. */
static bool split_by_file(splitter *s, uint32_t *parent, uint32_t from, uint32_t to)
{
    uint32_t groups = s->groups->count, open = 0, crowded = 0, begin = from;
    for (uint32_t i = from; i < to; i++)
        parent[s->order[i]] = s->order[i];
    for (uint32_t i = from; i < to && !crowded; i++) {
        uint32_t f = s->order[i];
        for (uint32_t c = s->loose->face_start[f]; c < s->loose->face_start[f + 1]; c++) {
            uint32_t e = s->edge_of[c];
            s->last[e] = s->count[e]++ == 0 ? f : s->last[e];
            open += s->count[e] == 1;
            open -= s->count[e] == 2;
            crowded += s->count[e] > 2;
        }
        if (open > 0 || crowded)
            continue;
        group_run(s, parent, begin, i + 1);
        for (; begin <= i; begin++)
            for (uint32_t c = s->loose->face_start[s->order[begin]]; c < s->loose->face_start[s->order[begin] + 1]; c++)
                s->count[s->edge_of[c]] = 0;
    }
    if (!open && !crowded)
        return true;
    for (uint32_t i = from; i < to; i++) {
        s->groups->of[s->order[i]] = ROBERTS_NONE;
        for (uint32_t c = s->loose->face_start[s->order[i]]; c < s->loose->face_start[s->order[i] + 1]; c++)
            s->count[s->edge_of[c]] = 0;
    }
    s->groups->count = groups;
    return false;
}

/* ---- all pieces ------------------------------------------------------------------------------------------------ */

/* Sorts the faces by piece, and within a piece by number. Sets parent[f] to the piece of face f, and end[p] to the end
 * of piece p in s->order. Returns the number of pieces. */
static uint32_t sort_pieces(splitter *s, uint32_t *end)
{
    uint32_t pieces = 0;
    for (uint32_t f = 0; f < s->face_count; f++)
        s->parent[f] = sets_root(s->parent, f);
    for (uint32_t f = 0; f < s->face_count; f++) { /* a root comes before its faces */
        s->parent[f] = s->parent[f] == f ? pieces++ : s->parent[s->parent[f]];
        end[s->parent[f]]++;
    }
    sort_starts(end, pieces);
    for (uint32_t f = 0; f < s->face_count; f++)
        s->order[end[s->parent[f]]++] = f;
    return pieces;
}

/* The numbers of faces at the edges of a piece. */
typedef enum edge_counts {
    TWO_EACH, /* the piece is closed */
    EVEN,     /* an even number: possibly solids that touch */
    ODD,      /* an odd number somewhere: not solids, which take two faces each */
} edge_counts;

static edge_counts count_at_edges(const splitter *s, uint32_t from, uint32_t to)
{
    edge_counts found = TWO_EACH;
    for (uint32_t i = from; i < to; i++)
        for (uint32_t c = s->loose->face_start[s->order[i]]; c < s->loose->face_start[s->order[i] + 1]; c++) {
            uint32_t count = s->edge_start[s->edge_of[c] + 1] - s->edge_start[s->edge_of[c]];
            if (count % 2)
                return ODD;
            found = count == 2 ? found : EVEN;
        }
    return found;
}

/* Groups the faces of the piece order[from] .. order[to - 1]: by solids, or all together. False: no memory. */
static bool split_piece(splitter *s, const solid_frame *frame, uint32_t *scratch, uint32_t from, uint32_t to)
{
    edge_counts counts = count_at_edges(s, from, to);
    bool whole = counts != EVEN;
    if (counts == EVEN && split_by_file(s, scratch, from, to))
        return true;
    if (counts == EVEN && !walls_split(s, frame, from, to))
        return false;
    for (uint32_t i = from; i < to; i++)
        whole |= s->groups->of[s->order[i]] == ROBERTS_NONE;
    if (whole) {
        uint32_t group = splitter_group(s, counts == TWO_EACH);
        for (uint32_t i = from; i < to; i++)
            s->groups->of[s->order[i]] = group;
    }
    return true;
}

bool split_faces(split_groups *groups, const roberts_scene *loose, const edge_scratch *edges)
{
    splitter s = {.loose = loose, .edges = edges, .groups = groups, .face_count = loose->face_count};
    solid_frame frame = {0};
    uint32_t *end = alloc_zeroed(loose->face_count, sizeof *end);
    uint32_t *scratch = alloc_array(loose->face_count, sizeof *scratch);
    bool enough = false;
    s.corner_count = (uint32_t)loose->corner_count;
    s.edge_of = alloc_array(s.corner_count, sizeof *s.edge_of);
    s.edge_start = alloc_array((size_t)s.corner_count + 1, sizeof *s.edge_start);
    s.parent = alloc_array(s.face_count, sizeof *s.parent);
    s.order = alloc_array(s.face_count, sizeof *s.order);
    s.count = alloc_zeroed(s.corner_count, sizeof *s.count);
    s.last = alloc_array(s.corner_count, sizeof *s.last);
    *groups = (split_groups){0};
    groups->of = alloc_array(s.face_count, sizeof *groups->of);
    groups->closed = alloc_zeroed((size_t)s.face_count + 1, sizeof *groups->closed);
    if (!end || !scratch || !s.edge_of || !s.edge_start || !s.parent || !s.order || !s.count || !s.last ||
        !groups->of || !groups->closed || frame_enter(&frame, loose, 0, 0.0) == ROBERTS_NO_MEMORY)
        goto done;
    memset(groups->of, 0xff, s.face_count * sizeof *groups->of);
    number_split_edges(&s);
    uint32_t pieces = sort_pieces(&s, end), from = 0;
    enough = true;
    for (uint32_t p = 0; p < pieces && enough; from = end[p++])
        enough = split_piece(&s, &frame, scratch, from, end[p]);
done:
    frame_free(&frame);
    free(end);
    free(scratch);
    free(s.edge_of);
    free(s.edge_start);
    free(s.parent);
    free(s.order);
    free(s.count);
    free(s.last);
    if (!enough)
        split_groups_free(groups);
    return enough;
}

void split_groups_free(split_groups *groups)
{
    free(groups->of);
    free(groups->closed);
    *groups = (split_groups){0};
}
