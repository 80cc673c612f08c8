/* verify.c - a drawing checked by rays.
 *
 * Idea: at some points of each visible and each hidden stretch of an edge the rule is applied directly: a point is
 * hidden where a front face of another solid lies on its sight line, nearer to the viewer. For an edge without front
 * face (which its own solid hides) the own solid counts as well.
 *
 * Every question has three answers: surely, possibly, no. A point surely hidden that is drawn visible, or not even
 * possibly hidden and drawn hidden, is a contradiction; what is only possible is left undecided.
 *
 * Edges are taken in runs, and runs by where they are in the picture, so that rays cast after one another have to do with
 * the same faces. Chunks of runs are for any number of threads; a chunk keeps what it finds, and the findings come in
 * the edges' order. */
#include <stdlib.h>

#include "base/array.h"
#include "base/error.h"
#include "base/radix.h"
#include "base/threads.h"
#include "ray/occluders.h"
#include "view/clip.h"

/* The first and last point of a stretch lie this part of it from its ends: near enough to find an end that is off by a
 * thousandth of the stretch, and farther than epsilon from it for all stretches that a pen can show. */
#define END_MARGIN 0x1p-10
/* A wrong point counts where a neighbour at this part of the stretch is wrong as well. */
#define NEIGHBOUR 0x1p-12
/* Gaps between the rows of an edge that are rounding (t has a size of 1). */
#define GAP 1e-15
/* An angle so near the crease angle may be taken for either side of it; degrees. */
#define CREASE_MARGIN 1e-6
/* Edges of one solid that stay together, at the most. */
#define RUN_EDGES 32
/* Runs in a chunk: enough to forget the cost of sharing them out. */
#define CHUNK_RUNS 32
/* With less work than this a thread costs more than it does. */
#define CHUNKS_PER_THREAD 4

/* Edges of one solid, up to the next run's first. */
typedef struct edge_run {
    uint32_t solid, edge;
} edge_run;

typedef struct finding {
    roberts_contradiction what;
    uint32_t run;
} finding;

/* What a chunk of runs came to. */
typedef struct chunk {
    size_t segments, points, undecided;
    finding *found;
    size_t count, room;
    bool lost; /* no memory */
} chunk;

typedef struct verifier {
    const roberts_scene *scene; /* as given: the drawing's numbers and t go by it */
    const roberts_scene *seen;  /* what hides: the same, or what the near plane leaves of it */
    view_clip clip;
    const roberts_drawing *drawing;
    roberts_verify_options options;
    occluders o;
    uint32_t *row_start; /* [edge_count + 1] */
    uint32_t *row;       /* [segments] rows of the drawing, edge by edge, by t */
    edge_run *run;       /* [run_count + 1] the last one ends them */
    uint32_t *order;     /* [run_count] runs by where they are in the picture */
    chunk *chunk;        /* [chunk_count] */
    uint32_t run_count, chunk_count;
} verifier;

roberts_verify_options roberts_verify_options_default(void)
{
    return (roberts_verify_options){.rays = 3, .crease_degrees = 0.1};
}

/* ---- edges ------------------------------------------------------------------------------------------------------ */

/* What an edge's faces make of it. */
enum { EDGE_FRONT, EDGE_BACK, EDGE_UNSURE };

static int edge_class(const verifier *f, const scene_edge *e)
{
    bool unsure = false;
    for (int i = 0; i < 2; i++) {
        int facing = e->f[i] == ROBERTS_NONE ? SIGHT_NOT_FRONT : f->o.s.facing[e->f[i]];
        if (facing == SIGHT_FRONT)
            return EDGE_FRONT;
        unsure |= facing == SIGHT_UNSURE;
    }
    return unsure ? EDGE_UNSURE : EDGE_BACK;
}

/* Whether the drawing has to show the edge where nothing hides it: an outline, or bent by more than the crease angle. */
static bool surely_drawn(const verifier *f, const scene_edge *e)
{
    const double degrees = 180.0 / 3.14159265358979323846;
    if (edge_class(f, e) != EDGE_FRONT)
        return false;
    if (f->options.all_edges || e->f[1] == ROBERTS_NONE || f->o.s.facing[e->f[0]] == SIGHT_NOT_FRONT ||
        f->o.s.facing[e->f[1]] == SIGHT_NOT_FRONT)
        return true;
    plane F = f->seen->face_plane[e->f[0]], G = f->seen->face_plane[e->f[1]];
    roberts_vec3 m = {F.a, F.b, F.c}, n = {G.a, G.b, G.c};
    double angle = atan2(vec3_length(vec3_cross(m, n)), vec3_dot(m, n)) * degrees;
    return angle > f->options.crease_degrees + CREASE_MARGIN;
}

/* ---- points of a stretch ---------------------------------------------------------------------------------------- */

/* Where point k of n lies within a stretch, 0 < position < 1. */
static double position(uint32_t k, uint32_t n)
{
    if (n == 1)
        return 0.5;
    if (k == 0 || k == n - 1)
        return k == 0 ? END_MARGIN : 1.0 - END_MARGIN;
    return (double)k / (n - 1);
}

/* A stretch of an edge that the drawing shows in one state. */
typedef struct stretch {
    uint32_t solid, edge;
    int class;
    double t0, t1;
    roberts_state drawn;
} stretch;

/* A point of a stretch. */
typedef struct probe {
    double t, step; /* where, and how far its neighbours are */
    uint32_t edge, run;
    roberts_state drawn;
} probe;

/* Points of a chunk's edges, in order, that are asked together. */
typedef struct batch {
    chunk *out;
    uint32_t run, count;
    probe probe[TREE_POINTS];
    sight_question question[TREE_POINTS];
    tree_walk walk;
} batch;

static roberts_vec3 point_of(const verifier *f, uint32_t solid, uint32_t edge, double t)
{
    const scene_edge e = scene_edge_at(f->scene, solid, edge);
    roberts_vec3 A = sight_point(&f->o.s, f->scene->point[e.v[0]]);
    roberts_vec3 AB = vec3_sub(sight_point(&f->o.s, f->scene->point[e.v[1]]), A);
    return vec3_add(A, vec3_scale(t, AB));
}

/* Whether the answer surely contradicts the drawing. */
static bool contradicts(const probe *p, const sight_question *q)
{
    return q->answer == (p->drawn == ROBERTS_HIDDEN ? SIGHT_NO : SIGHT_SURELY);
}

/* Whether the point, asked strictly, still contradicts the drawing, and a neighbour of it as well; or both neighbours where the
 * point itself lies just where the edge crosses a side, as between two faces that hide it. */
static bool contradicts_strictly(const verifier *f, tree_walk *w, const probe *p, const sight_question *q)
{
    sight_question again[3] = {*q, *q, *q};
    const roberts_vec3 ends[2] = {point_of(f, q->solid, p->edge, 0.0), point_of(f, q->solid, p->edge, 1.0)};
    again[1].X = point_of(f, q->solid, p->edge, p->t - p->step);
    again[2].X = point_of(f, q->solid, p->edge, p->t + p->step);
    for (int i = 0; i < 3; i++)
        again[i].ends = ends;
    occluders_cast(&f->o, w, again, 3);
    return contradicts(p, &again[0]) + contradicts(p, &again[1]) + contradicts(p, &again[2]) >= 2;
}

static void contradict(const verifier *f, chunk *out, const probe *p, const sight_question *q)
{
    const scene_edge edge = scene_edge_at(f->scene, q->solid, p->edge);
    roberts_contradiction c = {q->solid,
                               scene_vertex_number(f->scene, edge.v[0]),
                               scene_vertex_number(f->scene, edge.v[1]),
                               p->t,
                               p->drawn,
                               ROBERTS_VISIBLE,
                               ROBERTS_NONE};
    if (p->drawn == ROBERTS_VISIBLE) {
        c.cast = ROBERTS_HIDDEN;
        c.by = f->o.face_solid[q->hider];
    }
    if (array_reserve(&out->found, &out->room, out->count + 1, sizeof *out->found))
        out->found[out->count++] = (finding){c, p->run};
    else
        out->lost = true;
}

/* Casts the rays of the points that wait, and judges them. Where an edge passes behind a mere corner the rule hides one
 * point of it, and the drawing rightly shows nothing of that: only what is contradicted at a neighbouring point too
 * counts. */
static void judge(const verifier *f, batch *b)
{
    occluders_cast(&f->o, &b->walk, b->question, b->count);
    for (uint32_t i = 0; i < b->count; i++) {
        const sight_question *q = &b->question[i];
        if (!contradicts(&b->probe[i], q))
            b->out->undecided += q->answer == SIGHT_POSSIBLY;
        else if (contradicts_strictly(f, &b->walk, &b->probe[i], q))
            contradict(f, b->out, &b->probe[i], q);
        else
            b->out->undecided++;
    }
    b->count = 0;
}

/* The points of a stretch. */
static void check_stretch(const verifier *f, batch *b, const stretch *e)
{
    double length = e->t1 - e->t0;
    b->out->segments++;
    b->out->points += f->options.rays;
    if (e->class == EDGE_UNSURE) {
        b->out->undecided += f->options.rays;
        return;
    }
    for (uint32_t k = 0; k < f->options.rays; k++) {
        double t = e->t0 + length * position(k, f->options.rays);
        if (b->count == TREE_POINTS)
            judge(f, b);
        b->probe[b->count] = (probe){t, NEIGHBOUR * length, e->edge, b->run, e->drawn};
        b->question[b->count++] =
            (sight_question){.X = point_of(f, e->solid, e->edge, t), .solid = e->solid, .own = e->class == EDGE_BACK};
    }
}

/* What the near plane leaves of an edge. */
static clip_edge left_of(const verifier *f, uint32_t index)
{
    return f->clip.clipped ? f->clip.origin[index] : (clip_edge){index, 0.0, 1.0};
}

/* The rows of an edge, and between them, where the edge has to be drawn, the gaps: hidden and left out. */
static void check_edge(const verifier *f, batch *b, uint32_t solid, uint32_t index)
{
    clip_edge left = left_of(f, index);
    if (left.edge == ROBERTS_NONE)
        return;
    const scene_edge edge = scene_edge_at(f->seen, solid, left.edge);
    bool gaps = surely_drawn(f, &edge);
    stretch e = {.solid = solid, .edge = index, .class = edge_class(f, &edge)};
    double end = left.t0;
    for (uint32_t k = f->row_start[index]; k <= f->row_start[index + 1]; k++) {
        const roberts_segment *row = k < f->row_start[index + 1] ? &f->drawing->segment[f->row[k]] : NULL;
        e.t0 = end;
        e.t1 = row ? fmin(row->t0, left.t1) : left.t1;
        e.drawn = ROBERTS_HIDDEN;
        if (gaps && e.t1 - e.t0 > GAP)
            check_stretch(f, b, &e);
        if (!row)
            return;
        e.t0 = row->t0;
        e.t1 = row->t1;
        e.drawn = (roberts_state)row->state;
        if (e.drawn != ROBERTS_CLIPPED)
            check_stretch(f, b, &e);
        end = fmax(end, row->t1);
    }
}

/* ---- rows to edges ---------------------------------------------------------------------------------------------- */

/* The edge of `solid` between input vertices v0 and v1; edge_count where there is none. */
static uint32_t find_edge(const roberts_scene *scene, const roberts_segment *row)
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

/* Puts the rows of [first, end) in order of t0; they are few, and mostly in order already. */
static void sort_rows(verifier *f, uint32_t first, uint32_t end)
{
    for (uint32_t i = first + 1; i < end; i++) {
        uint32_t row = f->row[i], k = i;
        for (; k > first && f->drawing->segment[f->row[k - 1]].t0 > f->drawing->segment[row].t0; k--)
            f->row[k] = f->row[k - 1];
        f->row[k] = row;
    }
}

/* Rows by edge, by counting: row_start first counts, then points behind each edge's rows, then to their first. */
static roberts_status assign_rows(verifier *f, roberts_error *error)
{
    const roberts_scene *scene = f->scene;
    uint32_t total = 0;
    for (uint32_t i = 0; i < f->drawing->count; i++) {
        const roberts_segment *row = &f->drawing->segment[i];
        uint32_t edge = find_edge(scene, row);
        if (edge == scene->edge_count)
            return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "segment %u is of no edge of the scene (solid %u, %u-%u)",
                             (unsigned)i, (unsigned)row->solid, (unsigned)row->v0, (unsigned)row->v1);
        if (!(0.0 <= row->t0 && row->t0 < row->t1 && row->t1 <= 1.0) || row->state > ROBERTS_CLIPPED)
            return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "segment %u runs from t = %g to %g in state %u",
                             (unsigned)i, row->t0, row->t1, (unsigned)row->state);
        f->row_start[edge]++;
    }
    for (uint32_t e = 0; e <= scene->edge_count; e++)
        total = f->row_start[e] += total;
    for (uint32_t i = (uint32_t)f->drawing->count; i-- > 0;)
        f->row[--f->row_start[find_edge(scene, &f->drawing->segment[i])]] = i;
    for (uint32_t e = 0; e < scene->edge_count; e++)
        sort_rows(f, f->row_start[e], f->row_start[e + 1]);
    return ROBERTS_OK;
}

/* ---- the whole -------------------------------------------------------------------------------------------------- */

static void check_chunk(verifier *f, uint32_t index)
{
    uint32_t first = index * CHUNK_RUNS, left = f->run_count - first;
    batch b;
    b.out = &f->chunk[index];
    b.count = 0;
    tree_walk_init(&b.walk, &f->o.t);
    for (uint32_t i = 0; i < (left < CHUNK_RUNS ? left : CHUNK_RUNS); i++) {
        b.run = f->order[first + i];
        const edge_run *r = &f->run[b.run];
        for (uint32_t edge = r->edge; edge < r[1].edge; edge++)
            check_edge(f, &b, r->solid, edge);
    }
    judge(f, &b);
}

static void check_chunks(verifier *f)
{
#ifdef _OPENMP
    int threads = threads_for(f->options.threads, 1 + f->chunk_count / CHUNKS_PER_THREAD);
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
#endif
    for (uint32_t i = 0; i < f->chunk_count; i++)
        check_chunk(f, i);
}

/* Tells the contradictions in the order of the edges: run by run, each of which has its own together, in order. */
static bool tell(const verifier *f, roberts_verification *result)
{
    struct {
        const finding *first;
        size_t count;
    } *of = alloc_zeroed(f->run_count, sizeof *of);
    for (uint32_t i = 0; of && i < f->chunk_count; i++) {
        for (const finding *found = f->chunk[i].found; found < f->chunk[i].found + f->chunk[i].count; found++) {
            if (of[found->run].count++ == 0)
                of[found->run].first = found;
        }
    }
    for (uint32_t run = 0; of && run < f->run_count; run++) {
        for (size_t k = 0; k < of[run].count; k++) {
            if (result->contradictions++ == 0)
                result->first = of[run].first[k].what;
            if (f->options.contradiction)
                f->options.contradiction(f->options.context, &of[run].first[k].what);
        }
    }
    free(of);
    return of != NULL;
}

/* Sums the chunks up, and tells their contradictions. */
static roberts_status report(const verifier *f, roberts_verification *result, roberts_error *error)
{
    bool lost = false, found = false;
    for (uint32_t i = 0; i < f->chunk_count; i++) {
        lost |= f->chunk[i].lost;
        found |= f->chunk[i].count > 0;
    }
    if (lost || (found && !tell(f, result)))
        return error_no_memory(error);
    for (uint32_t i = 0; i < f->chunk_count; i++) {
        result->segments += f->chunk[i].segments;
        result->points += f->chunk[i].points;
        result->undecided += f->chunk[i].undecided;
    }
    return ROBERTS_OK;
}

/* ---- before it -------------------------------------------------------------------------------------------------- */

/* Cuts the solids' edges into runs. */
static void find_runs(verifier *f)
{
    const roberts_scene *scene = f->scene;
    f->run_count = 0;
    for (uint32_t s = 0; s < scene->solid_count; s++)
        for (uint32_t edge = scene->solid[s].edge; edge < scene->solid[s + 1].edge; edge += RUN_EDGES)
            f->run[f->run_count++] = (edge_run){s, edge};
    f->run[f->run_count] = (edge_run){scene->solid_count, scene->edge_count};
}

/* Puts the runs in the order of their places in the picture. */
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

/* About how many rays will ask for the faces of each solid: all but those from edges that the solid itself shows. */
static void count_rays(const verifier *f, double *rays)
{
    const roberts_drawing *drawing = f->drawing;
    double all = (double)drawing->count + f->scene->edge_count;
    for (uint32_t s = 0; s < f->scene->solid_count; s++)
        rays[s] = all - (f->scene->solid[s + 1].edge - f->scene->solid[s].edge);
    for (size_t i = 0; i < drawing->count; i++)
        rays[drawing->segment[i].solid] -= drawing->segment[i].line != ROBERTS_BACK;
    for (uint32_t s = 0; s < f->scene->solid_count; s++)
        rays[s] *= f->options.rays;
}

static bool build_occluders(verifier *f, const view *v)
{
    double *rays = alloc_array(f->scene->solid_count, sizeof *rays);
    bool built = false;
    if (rays) {
        count_rays(f, rays);
        built = occluders_build(&f->o, f->seen, v, rays);
    }
    free(rays);
    return built;
}

static bool prepare(verifier *f)
{
    size_t edges = f->scene->edge_count, most = edges / RUN_EDGES + f->scene->solid_count; /* runs */
    f->run = alloc_array(most + 1, sizeof *f->run);
    f->order = alloc_array(most, sizeof *f->order);
    f->row_start = alloc_zeroed(edges + 1, sizeof *f->row_start);
    f->row = alloc_array(f->drawing->count, sizeof *f->row);
    if (!f->run || !f->order || !f->row_start || !f->row)
        return false;
    find_runs(f);
    f->chunk_count = f->run_count / CHUNK_RUNS + (f->run_count % CHUNK_RUNS != 0);
    f->chunk = alloc_zeroed(f->chunk_count, sizeof *f->chunk);
    return f->chunk;
}

static void release(verifier *f)
{
    for (uint32_t i = 0; f->chunk && i < f->chunk_count; i++)
        free(f->chunk[i].found);
    free(f->chunk);
    free(f->run);
    free(f->order);
    free(f->row_start);
    free(f->row);
    occluders_free(&f->o);
    view_clip_free(&f->clip);
}

roberts_status roberts_verify(const roberts_scene *scene, const roberts_camera *camera, const roberts_drawing *drawing,
                              const roberts_verify_options *options, roberts_verification *result, roberts_error *error)
{
    verifier f = {.scene = scene, .drawing = drawing};
    view v;
    *result = (roberts_verification){0};
    f.options = options ? *options : roberts_verify_options_default();
    if (f.options.rays == 0)
        f.options.rays = roberts_verify_options_default().rays;
    if (drawing->count >= UINT32_MAX)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "more than 2^32 segments");
    if (scene->surface)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0,
                         "drawings of bodies that are not convex cannot be verified yet");
    roberts_status status = view_clip_scene(&f.clip, scene, camera, error);
    if (status != ROBERTS_OK)
        return status;
    f.seen = f.clip.clipped ? &f.clip.scene : scene;
    if ((status = view_prepare(&v, f.seen, camera, drawing->epsilon, error)) != ROBERTS_OK)
        goto done;
    status = prepare(&f) ? assign_rows(&f, error) : error_no_memory(error);
    if (status == ROBERTS_OK && !(build_occluders(&f, &v) && order_runs(&f)))
        status = error_no_memory(error);
    if (status == ROBERTS_OK) {
        check_chunks(&f);
        status = report(&f, result, error);
    }
done:
    release(&f);
    return status;
}
