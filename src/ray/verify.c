/* verify.c - checks a drawing by rays.
 *
 * The rule is applied directly: a point is hidden if a front face of another solid lies on its sight line, nearer to
 * the viewer. An edge without a front face is hidden by its own solid, so that solid counts as well. Faces of bodies
 * that are not convex hide from both sides. They also hide edges of their own body, but not those that lie in their
 * plane. stretch.c decides which points of an edge are checked and what contradicts the drawing.
 *
 * Edges are grouped into runs, and runs are sorted by their position in the picture, so that successive rays meet the
 * same faces. Threads take chunks of runs. Each chunk keeps its findings, which are sorted by edge in the end. */
#include <stdlib.h>

#include "base/array.h"
#include "base/angle.h"
#include "base/error.h"
#include "base/sort.h"
#include "base/threads.h"
#include "ray/crossed.h"
#include "ray/stretch.h"

/* In t: a gap between two rows of an edge that is no wider than this is rounding. */
#define GAP 1e-15
/* Degrees: an angle this near to the crease angle may count as either side of it. */
#define CREASE_MARGIN 1e-6
/* Degrees: flatter edges of smooth bodies are left out. See roberts_hide_options.crease_auto. */
#define SMOOTH_DEGREES 30.0
/* Most edges in a run; all belong to one solid. */
#define RUN_EDGES 32
/* Runs in a chunk: enough to make the cost of distributing them negligible. */
#define CHUNK_RUNS 32
/* Intersections in a chunk. */
#define CHUNK_LINES 1024
/* A thread with fewer chunks than this costs more than it saves. */
#define CHUNKS_PER_THREAD 4

/* Edges of one solid, up to the first edge of the next run. */
typedef struct edge_run {
    uint32_t solid, edge;
} edge_run;

/* The name of an edge of a body that is not convex in the drawing: an edge of the file, or a part of one. */
typedef struct edge_name {
    uint32_t solid, v[2], edge;
    double t0, t1;
} edge_name;

typedef struct verifier {
    const roberts_scene *scene; /* as given: the drawing's numbers and t refer to it */
    seen seen;                  /* of `scene`; seen.scene hides */
    const roberts_drawing *drawing;
    roberts_verify_options options;
    occluders o;
    edge_name *name; /* [name_count] names of all edges of bodies that are not convex, sorted */
    size_t name_count;
    uint32_t *row_start;    /* [edge_count + 1] */
    uint32_t *row;          /* [segments] rows of the drawing, sorted by edge, then by t */
    crossed crossed;        /* the faces of intersections */
    size_t line_row;        /* the first row of an intersection; later rows are in the order of their lines */
    edge_run *run;          /* [run_count + 1] the last entry marks the end */
    uint32_t *order;        /* [run_count] runs sorted by their position in the picture */
    stretch_result *result; /* [chunk_count] */
    uint32_t run_count, edge_chunks, chunk_count; /* chunks of edges, followed by chunks of intersections */
} verifier;

roberts_verify_options roberts_verify_options_default(void)
{
    return (roberts_verify_options){.rays = 3, .crease_degrees = 0.1, .crease_auto = true};
}

/* ---- edges ----------------------------------------------------------------------------------------------------- */

static stretch_edge classify_edge(const verifier *f, const scene_edge *e)
{
    bool unsure = false;
    for (int i = 0; i < 2; i++) {
        int facing = e->f[i] == ROBERTS_NONE ? SIGHT_NOT_FRONT : f->o.s.facing[e->f[i]];
        if (facing == SIGHT_FRONT)
            return STRETCH_FRONT;
        unsure |= facing == SIGHT_UNSURE;
    }
    return unsure ? STRETCH_UNSURE : STRETCH_BACK;
}

/* Returns the angle between two planes, or between one and the reverse of the other; degrees. */
static double angle_between(plane F, plane G, bool turned)
{
    roberts_vec3 m = {F.a, F.b, F.c}, n = {G.a, G.b, G.c};
    return atan2(vec3_length(vec3_cross(m, n)), turned ? -vec3_dot(m, n) : vec3_dot(m, n)) * (180.0 / PI);
}

/* Subtracts what rounding of the coordinates explains from the angle between two faces; degrees. A corner is at most
 * half a step from where it was, so the plane of a narrow face may have turned by that over its width. */
static double less_rounding(const verifier *f, uint32_t p, uint32_t q, double angle)
{
    const roberts_scene *scene = f->seen.scene;
    const double off = 0.5 * scene_step(scene);
    if (!(off > 0.0))
        return angle;
    const double turned = off / scene_width(scene, p) + off / scene_width(scene, q);
    const double chord = 2.0 * sin(angle * (PI / 360.0)) - fmin(turned, SCENE_ROUNDED_BEND);
    return asin(fmax(0.5 * chord, 0.0)) * (360.0 / PI);
}

/* Must the drawing show the edge where nothing hides it? It must if the edge is an outline, or bent by more than the
 * crease angle. */
static bool is_surely_drawn(const verifier *f, const scene_edge *e)
{
    if (classify_edge(f, e) != STRETCH_FRONT)
        return false;
    if (f->options.all_edges || e->f[1] == ROBERTS_NONE || f->o.s.facing[e->f[0]] == SIGHT_NOT_FRONT ||
        f->o.s.facing[e->f[1]] == SIGHT_NOT_FRONT)
        return true;
    const roberts_scene *scene = f->seen.scene;
    const double bent = angle_between(scene_plane(scene, e->f[0]), scene_plane(scene, e->f[1]), false);
    return less_rounding(f, e->f[0], e->f[1], bent) > f->options.crease_degrees + CREASE_MARGIN;
}

/* How the faces of an edge lie around it in the picture. */
typedef struct edge_sides {
    uint32_t left, right, edge_on, unsure;
    double bent; /* greatest angle between the first face and another one, from flat; degrees */
} edge_sides;

/* Adds a face of an edge. `on_right`: the face is on the right of v[0] -> v[1], seen from outside its plane. `first`:
 * the first face of the edge. */
static void add_side_of_face(const verifier *f, uint32_t face, bool on_right, uint32_t first, edge_sides *to)
{
    plane F = scene_plane(f->seen.scene, face), G = scene_plane(f->o.s.scene, face);
    bool back = F.a * G.a + F.b * G.b + F.c * G.c < 0.0; /* it was turned toward the viewer */
    to->unsure += f->o.s.facing[face] == SIGHT_UNSURE;
    if (f->o.s.facing[face] == SIGHT_NOT_FRONT)
        to->edge_on++;
    else if (back != on_right)
        to->right++;
    else
        to->left++;
    double bent = angle_between(scene_plane(f->seen.scene, first), F, false);
    double whole =
        angle_between(scene_whole_plane(f->seen.scene, first), scene_whole_plane(f->seen.scene, face), false);
    bent = fmax(fmin(bent, 180.0 - bent), fmin(whole, 180.0 - whole));
    to->bent = fmax(to->bent, less_rounding(f, first, face, bent));
}

static edge_sides sides_of(const verifier *f, uint32_t solid, uint32_t index)
{
    const roberts_scene *scene = f->seen.scene;
    uint32_t room[2];
    const uint32_t *face;
    const uint32_t count = scene_faces_at(scene, solid, index, room, &face);
    edge_sides found = {0};
    for (uint32_t k = 0; k < count; k++)
        add_side_of_face(f, face[k] & ~MANY_TURNED, face[k] & MANY_TURNED, face[0] & ~MANY_TURNED, &found);
    if (count == 2 && !(scene->surface->edge_is[index] & EDGE_MANY)) {
        const bool alike = !((face[0] ^ face[1]) & MANY_TURNED);
        const uint32_t p = face[0] & ~MANY_TURNED, q = face[1] & ~MANY_TURNED;
        const double bent = angle_between(scene_plane(scene, p), scene_plane(scene, q), alike);
        const double whole = angle_between(scene_whole_plane(scene, p), scene_whole_plane(scene, q), alike);
        found.bent = less_rounding(f, p, q, fmax(bent, whole));
    }
    return found;
}

/* Does the same as is_surely_drawn() for an edge of a body that is not convex. */
static bool is_surely_line(const verifier *f, uint32_t solid, uint32_t index)
{
    const scene_surface *surface = f->seen.scene->surface;
    const scene_edge *e = scene_edge_stored(f->seen.scene, solid, index);
    double crease = f->options.crease_degrees;
    bool cut = (surface->edge_is[index] & (EDGE_CUT | EDGE_MANY)) == EDGE_CUT; /* of one face */
    if (e->f[1] == ROBERTS_NONE)
        return !cut; /* a border or a wire */
    if (surface->smooth[solid] && f->options.crease_auto)
        crease = fmax(crease, SMOOTH_DEGREES);
    edge_sides sides = sides_of(f, solid, index);
    if (sides.unsure)
        return false;
    if ((sides.left == 0) != (sides.right == 0))
        return !cut || sides.edge_on == 0;
    return !cut && (f->options.all_edges || sides.bent > crease + CREASE_MARGIN);
}

static roberts_vec3 vertex_point(const verifier *f, uint32_t vertex)
{
    return sight_point(&f->o.s, f->scene->point[vertex]);
}

/* Returns the part of an edge of the file that this edge covers. */
static edge_name part_of(const verifier *f, uint32_t solid, uint32_t index)
{
    seen_name name = seen_edge_name(f->scene, solid, index);
    return (edge_name){solid, {name.v[0], name.v[1]}, index, name.t0, name.t1};
}

/* Returns the row with t along the part. */
static roberts_segment row_on(const edge_name *part, const roberts_segment *row)
{
    roberts_segment on = *row;
    on.t0 = fmax(0.0, (row->t0 - part->t0) / (part->t1 - part->t0));
    on.t1 = fmin(1.0, (row->t1 - part->t0) / (part->t1 - part->t0));
    return on;
}

/* Checks one row: its ends against what the near plane leaves of the edge, and the stretch between them by rays. gap:
 * differences that are mere rounding. */
static void check_row(stretch_checker *checker, const clip_edge *left, const roberts_segment *row, double gap,
                      stretch *s)
{
    s->t0 = fmax(row->t0, left->t0);
    s->t1 = fmin(row->t1, left->t1);
    s->drawn = (roberts_state)row->state;
    s->named = s->drawn == ROBERTS_HIDDEN;
    s->drawn_by = s->named ? row->by : ROBERTS_NONE;
    if (row->t0 < left->t0 - gap)
        stretch_is_clipped(checker, s, row->t0);
    if (row->t1 > left->t1 + gap)
        stretch_is_clipped(checker, s, row->t1);
    if (s->t0 < s->t1)
        stretch_check(checker, s);
}

/* Checks a gap from t0 to t1 in an edge that must be drawn. The gap means that the edge is hidden there. */
static void check_gap(stretch_checker *checker, double t0, double t1, double gap, stretch *s)
{
    s->t0 = t0;
    s->t1 = t1;
    s->drawn = ROBERTS_HIDDEN;
    s->named = false;
    s->drawn_by = ROBERTS_NONE;
    if (t1 - t0 > gap)
        stretch_check(checker, s);
}

/* Checks the rows of an edge and the gaps between them. Parts that the near plane removes are not gaps, whether they
 * are drawn as clipped or not. */
static void check_edge(const verifier *f, stretch_checker *checker, uint32_t solid, uint32_t index)
{
    clip_edge left = seen_left_of(&f->seen, index);
    if (left.edge == ROBERTS_NONE)
        return;
    const scene_edge edge = scene_edge_at(f->seen.scene, solid, left.edge),
                     whole = scene_edge_at(f->scene, solid, index);
    const edge_name part = part_of(f, solid, index);
    bool convex = scene_is_convex(f->scene, solid);
    bool gaps = !f->options.unite && (convex ? is_surely_drawn(f, &edge) : is_surely_line(f, solid, left.edge));
    double end = left.t0, gap = GAP / (part.t1 - part.t0);
    stretch s = {.A = vertex_point(f, whole.v[0]),
                 .B = vertex_point(f, whole.v[1]),
                 .solid = solid,
                 .edge = index,
                 .faces = convex ? classify_edge(f, &edge) : STRETCH_BETWEEN,
                 .own = seen_owns_one(ROBERTS_NONE)};
    if (!convex)
        s.own = seen_own_of(f->seen.scene, solid, left.edge);
    else if (s.faces != STRETCH_BACK)
        s.own.key[0] = seen_body_key(solid);
    for (uint32_t k = f->row_start[index]; k < f->row_start[index + 1]; k++) {
        const roberts_segment row = row_on(&part, &f->drawing->segment[f->row[k]]);
        if (row.state == ROBERTS_CLIPPED)
            continue;
        if (gaps)
            check_gap(checker, end, fmin(row.t0, left.t1), gap, &s);
        check_row(checker, &left, &row, gap, &s);
        end = fmax(end, row.t1);
    }
    if (gaps)
        check_gap(checker, end, left.t1, gap, &s);
}

/* ---- intersections --------------------------------------------------------------------------------------------- */

/* Records that the faces of line k do not cross. */
static void reject_line(stretch_result *out, uint32_t body, uint32_t edge)
{
    stretch_finding finding = {.what = {.solid = body, .t = 0.5, .by = ROBERTS_NONE, .no_line = true}, .edge = edge};
    if (!array_reserve(&out->found, &out->room, out->count + 1, sizeof *out->found))
        out->lost = true;
    else
        out->found[out->count++] = finding;
}

/* Returns the first row of line k or of a later one. */
static size_t first_row(const verifier *f, size_t k)
{
    size_t low = f->line_row, high = f->drawing->count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (f->drawing->segment[middle].edge < k)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Do faces end along an edge that is drawn itself? Then there is no intersection. A union may leave any edge out. */
static bool is_drawn_edge(const verifier *f, const crossed_faces *faces)
{
    for (int i = 0; i < 2; i++) {
        uint32_t body = faces->of[i].body, edge = faces->edge[i];
        if (edge == ROBERTS_NONE || (f->options.unite && union_takes(f->scene, body)))
            continue;
        const scene_edge e = scene_edge_at(f->seen.scene, body, edge);
        if (scene_is_convex(f->seen.scene, body) ? is_surely_drawn(f, &e) : is_surely_line(f, body, edge))
            return true;
    }
    return false;
}

/* Returns the body that hides the line if the line lies in one of its back faces; otherwise that of the first face. */
static uint32_t body_behind(const verifier *f, const crossed_faces *faces)
{
    for (int i = 0; i < 2; i++)
        if (scene_is_convex(f->seen.scene, faces->of[i].body) && f->o.s.facing[faces->of[i].face] == SIGHT_NOT_FRONT)
            return faces->of[i].body;
    return faces->of[0].body;
}

/* Lists the faces in which the line lies. A back face of a convex body does not excuse its body from hiding. */
static void take_own(const verifier *f, const crossed_faces *faces, seen_own *own)
{
    const roberts_scene *scene = f->seen.scene;
    int count = 0;
    for (int i = 0; i < 2; i++) {
        uint32_t body = faces->of[i].body, face = faces->of[i].face;
        if (scene_is_convex(scene, body)) {
            if (f->o.s.facing[face] != SIGHT_NOT_FRONT)
                own->key[count++] = seen_body_key(body);
            continue;
        }
        own->key[count++] = scene_plane_number(scene, face);
        if (faces->edge[i] == ROBERTS_NONE)
            continue;
        const seen_own edge = seen_own_of(scene, body, faces->edge[i]);
        own->key[count++] = edge.key[edge.key[0] == scene_plane_number(scene, face)];
        own->many = edge.many ? edge.many : own->many;
    }
}

/* Checks an intersection: its faces, its rows, and the gaps between them. */
static void check_line(const verifier *f, stretch_checker *checker, stretch_result *result, size_t k)
{
    const clip_edge whole = {ROBERTS_NONE, 0.0, 1.0};
    const roberts_crossing *line = &f->drawing->crossing[k];
    uint32_t edge = f->scene->edge_count + (uint32_t)k;
    size_t row = first_row(f, k);
    crossed_faces faces;
    if (!crossed_find(&f->crossed, line, &faces) || is_drawn_edge(f, &faces)) {
        reject_line(result, row < f->drawing->count ? f->drawing->segment[row].solid : 0, edge);
        return;
    }
    stretch s = {.A = sight_point(&f->o.s, line->end[0]),
                 .B = sight_point(&f->o.s, line->end[1]),
                 .solid = body_behind(f, &faces),
                 .edge = edge,
                 .faces = STRETCH_BETWEEN,
                 .own = seen_owns_one(ROBERTS_NONE)};
    take_own(f, &faces, &s.own);
    double end = 0.0;
    for (; row < f->drawing->count && f->drawing->segment[row].edge == k; row++) {
        if (!f->options.unite)
            check_gap(checker, end, f->drawing->segment[row].t0, GAP, &s);
        check_row(checker, &whole, &f->drawing->segment[row], GAP, &s);
        end = fmax(end, f->drawing->segment[row].t1);
    }
    if (!f->options.unite)
        check_gap(checker, end, 1.0, GAP, &s);
}

/* Are the rows of intersections in order, each belonging to a line? */
static bool has_lines_in_order(verifier *f)
{
    const roberts_drawing *d = f->drawing;
    f->line_row = d->count;
    while (f->line_row > 0 && scene_crosses(&d->segment[f->line_row - 1]))
        f->line_row--;
    for (size_t i = f->line_row; i < d->count; i++)
        if (d->segment[i].edge >= d->crossing_count || (i > f->line_row && d->segment[i - 1].edge > d->segment[i].edge))
            return false;
    return true;
}

/* ---- rows to edges --------------------------------------------------------------------------------------------- */

static int by_name(const void *a, const void *b)
{
    const edge_name *p = a, *q = b;
    if (p->solid != q->solid)
        return p->solid < q->solid ? -1 : 1;
    const int order = compare_pairs(p->v, q->v);
    return order != 0 ? order : (p->t0 > q->t0) - (p->t0 < q->t0);
}

/* Names all edges of bodies that are not convex, in order. False: no memory. */
static bool name_edges(verifier *f)
{
    const roberts_scene *scene = f->scene;
    size_t count = 0;
    for (uint32_t s = 0; s < scene->solid_count; s++)
        if (!scene_is_convex(scene, s))
            count += scene->solid[s + 1].edge - scene->solid[s].edge;
    if (!(f->name = alloc_array(count, sizeof *f->name)))
        return false;
    for (uint32_t s = 0; s < scene->solid_count; s++)
        for (uint32_t e = scene->solid[s].edge; !scene_is_convex(scene, s) && e < scene->solid[s + 1].edge; e++)
            f->name[f->name_count++] = part_of(f, s, e);
    qsort(f->name, count, sizeof *f->name, by_name);
    return true;
}

/* Returns the edge of `solid` between input vertices v0 and v1; edge_count: none. */
static uint32_t find_scene_edge(const roberts_scene *scene, const roberts_segment *row)
{
    if (row->solid >= scene->solid_count)
        return scene->edge_count;
    uint32_t low = scene->solid[row->solid].edge, high = scene->solid[row->solid + 1].edge;
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        const scene_edge e = scene_edge_at(scene, row->solid, middle);
        uint32_t v0 = scene_vertex_number(scene, e.v[0]), v1 = scene_vertex_number(scene, e.v[1]);
        if (v0 == row->v0 && v1 == row->v1)
            return middle;
        if (v0 < row->v0 || (v0 == row->v0 && v1 < row->v1))
            low = middle + 1;
        else
            high = middle;
    }
    return scene->edge_count;
}

/* Sorts the rows of [first, end) by t0. They are few, and usually nearly sorted. */
static void sort_rows(verifier *f, uint32_t first, uint32_t end)
{
    const roberts_segment *segment = f->drawing->segment;
    SORT_FEW(uint32_t, f->row + first, end - first, segment[*a].t0 > segment[*b].t0)
}

/* The names from which next_edge() continues. */
typedef struct name_range {
    const edge_name *next, *end;
} name_range;

static name_range names_of(const verifier *f, const roberts_segment *row)
{
    const edge_name wanted = {.solid = row->solid, .v = {row->v0, row->v1}, .t0 = -1.0};
    const size_t first = find_first(&wanted, f->name, f->name_count, sizeof *f->name, by_name);
    return (name_range){f->name + first, f->name + f->name_count};
}

/* Returns the next edge of which the row shows a part; edge_count: none. */
static uint32_t next_edge(const verifier *f, name_range *range, const roberts_segment *row)
{
    for (; range->next < range->end; range->next++) {
        const edge_name *name = range->next;
        if (name->solid != row->solid || name->v[0] != row->v0 || name->v[1] != row->v1)
            break;
        if (fmin(name->t1, row->t1) - fmax(name->t0, row->t0) > fmin(GAP, 0.5 * (row->t1 - row->t0)))
            return range->next++->edge;
    }
    return f->scene->edge_count;
}

/* Counts row `index` for the edges of which it shows parts, or stores it there if `put` is set. Returns the number of
 * these edges. */
static uint32_t assign_row(verifier *f, uint32_t index, bool put)
{
    const roberts_segment *row = &f->drawing->segment[index];
    uint32_t none = f->scene->edge_count, count = 0;
    if (index >= f->line_row)
        return 1;
    bool convex = row->solid >= f->scene->solid_count || scene_is_convex(f->scene, row->solid);
    name_range range = {0};
    if (!convex)
        range = names_of(f, row);
    uint32_t edge = convex ? find_scene_edge(f->scene, row) : next_edge(f, &range, row);
    for (; edge != none; edge = convex ? none : next_edge(f, &range, row)) {
        if (put)
            f->row[--f->row_start[edge]] = index;
        else
            f->row_start[edge]++;
        count++;
    }
    return count;
}

/* Sorts rows by edge with a counting sort. row_start[] holds the counts, then the ends, and finally the starts of each
 * edge's rows. */
static roberts_status assign_rows(verifier *f, roberts_error *error)
{
    const roberts_scene *scene = f->scene;
    uint32_t total = 0;
    if (!has_lines_in_order(f))
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "segments of intersections are not in order");
    for (uint32_t i = 0; i < f->drawing->count; i++) {
        const roberts_segment *row = &f->drawing->segment[i];
        if (!scene_crosses(row) && assign_row(f, i, false) == 0)
            return error_set(error, ROBERTS_BAD_ARGUMENT, 0,
                             "segment %u belongs to no edge of the scene (solid %u, %u-%u)", (unsigned)i,
                             (unsigned)row->solid, (unsigned)row->v0, (unsigned)row->v1);
        if (!(0.0 <= row->t0 && row->t0 < row->t1 && row->t1 <= 1.0) || row->state > ROBERTS_CLIPPED)
            return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "segment %u runs from t = %g to %g in state %u",
                             (unsigned)i, row->t0, row->t1, (unsigned)row->state);
    }
    for (uint32_t e = 0; e <= scene->edge_count; e++)
        total = f->row_start[e] += total;
    if (!(f->row = alloc_array(total, sizeof *f->row)))
        return error_no_memory(error);
    for (uint32_t i = (uint32_t)f->line_row; i-- > 0;)
        assign_row(f, i, true);
    for (uint32_t e = 0; e < scene->edge_count; e++)
        sort_rows(f, f->row_start[e], f->row_start[e + 1]);
    return ROBERTS_OK;
}

/* ---- chunks ---------------------------------------------------------------------------------------------------- */

static void check_chunk(verifier *f, uint32_t index)
{
    uint32_t first = index * CHUNK_RUNS, left = f->run_count - first;
    stretch_checker *checker = stretch_checker_new(&f->o, f->options.rays, &f->result[index]);
    if (!checker) {
        f->result[index].lost = true;
        return;
    }
    size_t line = ((size_t)index - f->edge_chunks) * CHUNK_LINES, lines = f->drawing->crossing_count;
    for (size_t k = line; index >= f->edge_chunks && k < lines && k < line + CHUNK_LINES; k++)
        check_line(f, checker, &f->result[index], k);
    for (uint32_t i = 0; index < f->edge_chunks && i < (left < CHUNK_RUNS ? left : CHUNK_RUNS); i++) {
        const edge_run *r = &f->run[f->order[first + i]];
        for (uint32_t edge = r->edge; edge < r[1].edge; edge++)
            check_edge(f, checker, r->solid, edge);
    }
    stretch_checker_finish(checker);
}

static bool check_some(void *context, size_t first, size_t end)
{
    for (size_t i = first; i < end; i++)
        check_chunk(context, (uint32_t)i);
    return true;
}

static void check_chunks(verifier *f)
{
    int threads = threads_for(f->options.threads, 1 + f->chunk_count / CHUNKS_PER_THREAD);
    threads_each(threads, f->chunk_count, 1, check_some, f);
}

/* ---- findings -------------------------------------------------------------------------------------------------- */

static int by_edge(const void *a, const void *b)
{
    const stretch_finding *p = a, *q = b;
    if (p->edge != q->edge)
        return p->edge < q->edge ? -1 : 1;
    if (p->what.t != q->what.t)
        return p->what.t < q->what.t ? -1 : 1;
    return p->what.by < q->what.by ? -1 : p->what.by > q->what.by;
}

/* Sets the edge or intersection of a contradiction. */
static void name_line(const verifier *f, uint32_t edge, roberts_contradiction *what)
{
    what->v0 = what->v1 = what->face[0] = what->face[1] = ROBERTS_NONE;
    if (edge >= f->scene->edge_count) {
        const roberts_crossing *line = &f->drawing->crossing[edge - f->scene->edge_count];
        size_t row = first_row(f, edge - f->scene->edge_count);
        if (row < f->drawing->count && f->drawing->segment[row].edge == edge - f->scene->edge_count)
            what->solid = f->drawing->segment[row].solid;
        what->face[0] = line->face[0];
        what->face[1] = line->face[1];
        return;
    }
    const edge_name name = part_of(f, what->solid, edge);
    what->v0 = name.v[0];
    what->v1 = name.v[1];
    what->t = name.t0 + (name.t1 - name.t0) * what->t;
}

/* Reports the contradictions of all chunks, sorted by edge and then along it. Two rays from one point count once.
 * False: no memory. */
static bool report_contradictions(const verifier *f, size_t count, roberts_verification *result)
{
    stretch_finding *all = alloc_array(count, sizeof *all);
    size_t k = 0;
    if (!all)
        return false;
    for (uint32_t i = 0; i < f->chunk_count; i++)
        for (size_t j = 0; j < f->result[i].count; j++)
            all[k++] = f->result[i].found[j];
    qsort(all, count, sizeof *all, by_edge);
    for (k = 0; k < count; k++) {
        roberts_contradiction *what = &all[k].what;
        if (k > 0 && by_edge(&all[k - 1], &all[k]) == 0)
            continue;
        name_line(f, all[k].edge, what);
        result->contradictions++;
        if (f->options.contradiction)
            f->options.contradiction(f->options.context, what);
    }
    result->first = all[0].what;
    free(all);
    return true;
}

/* Sums up the chunks and reports their contradictions. */
static roberts_status report(const verifier *f, roberts_verification *result, roberts_error *error)
{
    bool lost = false;
    size_t found = 0;
    for (uint32_t i = 0; i < f->chunk_count; i++) {
        lost |= f->result[i].lost;
        found += f->result[i].count;
    }
    if (lost || (found && !report_contradictions(f, found, result)))
        return error_no_memory(error);
    for (uint32_t i = 0; i < f->chunk_count; i++) {
        result->segments += f->result[i].segments;
        result->points += f->result[i].points;
        result->undecided += f->result[i].undecided;
    }
    return ROBERTS_OK;
}

/* ---- preparation ----------------------------------------------------------------------------------------------- */

/* Divides the solids' edges into runs. */
static void find_runs(verifier *f)
{
    const roberts_scene *scene = f->scene;
    f->run_count = 0;
    for (uint32_t s = 0; s < scene->solid_count; s++)
        for (uint32_t edge = scene->solid[s].edge; edge < scene->solid[s + 1].edge; edge += RUN_EDGES)
            f->run[f->run_count++] = (edge_run){s, edge};
    f->run[f->run_count] = (edge_run){scene->solid_count, scene->edge_count};
}

/* Sorts the runs by their position in the picture. False: no memory. */
static bool order_runs(verifier *f)
{
    uint32_t *key = alloc_array(f->run_count, sizeof *key);
    for (uint32_t i = 0; key && i < f->run_count; i++) {
        const scene_edge e = scene_edge_at(f->scene, f->run[i].solid, f->run[i].edge);
        key[i] = occluders_place(&f->o, sight_point(&f->o.s, f->scene->point[e.v[0]]));
    }
    bool done = key && radix_order(key, f->run_count, f->order);
    free(key);
    return done;
}

/* Estimates how many rays will query the faces of each solid: all except those from edges that the solid, if convex,
 * shows itself. */
static void count_rays(const verifier *f, double *rays)
{
    const roberts_drawing *drawing = f->drawing;
    double all = (double)drawing->count + f->scene->edge_count;
    for (uint32_t s = 0; s < f->scene->solid_count; s++)
        rays[s] = scene_is_convex(f->scene, s) ? all - (f->scene->solid[s + 1].edge - f->scene->solid[s].edge) : all;
    for (size_t i = 0; i < drawing->count; i++)
        rays[drawing->segment[i].solid] -=
            drawing->segment[i].line != ROBERTS_BACK && scene_is_convex(f->scene, drawing->segment[i].solid);
    for (uint32_t s = 0; s < f->scene->solid_count; s++)
        rays[s] *= f->options.rays;
}

static bool build_occluders(verifier *f)
{
    double *rays = alloc_array(f->scene->solid_count, sizeof *rays);
    bool built = false;
    if (rays) {
        count_rays(f, rays);
        built = occluders_build(&f->o, f->seen.scene, &f->seen.view, rays);
    }
    free(rays);
    return built;
}

static bool prepare_verifier(verifier *f)
{
    size_t edges = f->scene->edge_count, most = edges / RUN_EDGES + f->scene->solid_count; /* number of runs */
    f->run = alloc_array(most + 1, sizeof *f->run);
    f->order = alloc_array(most, sizeof *f->order);
    f->row_start = alloc_zeroed(edges + 1, sizeof *f->row_start);
    if (!f->run || !f->order || !f->row_start || !name_edges(f))
        return false;
    if (f->drawing->crossing_count > 0 && !crossed_begin(&f->crossed, f->seen.scene, f->drawing->epsilon))
        return false;
    find_runs(f);
    f->edge_chunks = f->run_count / CHUNK_RUNS + (f->run_count % CHUNK_RUNS != 0);
    f->chunk_count = f->edge_chunks + (uint32_t)((f->drawing->crossing_count + CHUNK_LINES - 1) / CHUNK_LINES);
    f->result = alloc_zeroed(f->chunk_count, sizeof *f->result);
    return f->result;
}

static void release(verifier *f)
{
    for (uint32_t i = 0; f->result && i < f->chunk_count; i++)
        free(f->result[i].found);
    free(f->result);
    free(f->run);
    free(f->order);
    free(f->name);
    free(f->row_start);
    free(f->row);
    crossed_end(&f->crossed);
    occluders_free(&f->o);
    seen_end(&f->seen);
}

roberts_status roberts_verify(const roberts_scene *scene, const roberts_camera *camera, const roberts_drawing *drawing,
                              const roberts_verify_options *options, roberts_verification *result, roberts_error *error)
{
    verifier f = {.scene = scene, .drawing = drawing};
    *result = (roberts_verification){0};
    f.options = options ? *options : roberts_verify_options_default();
    if (f.options.rays == 0)
        f.options.rays = roberts_verify_options_default().rays;
    if (drawing->count >= UINT32_MAX)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "too many segments: 2^32 - 2 at most");
    roberts_status status = seen_begin(&f.seen, scene, camera, drawing->epsilon, error);
    if (status != ROBERTS_OK)
        return status;
    status = prepare_verifier(&f) ? assign_rows(&f, error) : error_no_memory(error);
    if (status == ROBERTS_OK && !(build_occluders(&f) && order_runs(&f)))
        status = error_no_memory(error);
    if (status == ROBERTS_OK) {
        check_chunks(&f);
        status = report(&f, result, error);
    }
    release(&f);
    return status;
}
