/* hide.c - the scene edge by edge: which are drawn, which parts of them are hidden, and the segments that follow.
 *
 * Solids are taken in chunks that threads work on at the same time; each chunk keeps its segments until those of the
 * chunks before are laid down (see chunks.h). Nothing else is shared, so that the result does not depend on the threads. */
#include <math.h>
#include <stdlib.h>
#include <time.h>

#include "base/array.h"
#include "base/error.h"
#include "base/threads.h"
#include "hide/ahead.h"
#include "hide/cells.h"
#include "hide/chunks.h"
#include "view/clip.h"

#define CHUNK_SOLIDS 64
#define CHUNK_SEGMENTS 1024 /* room to begin with: nine visible edges of each block, and then some */
#define CHUNKS_PER_THREAD 8 /* with less work than this a thread costs more than it does */
#define GRID_MOST 4096

/* Touching distance above which "on" would mean a visible length: a hundredth of the scene. */
#define EPSILON_MOST 0.01

static const double pi = 3.14159265358979323846;

typedef struct hide_job {
    const roberts_scene *scene;  /* as it is mapped: clipped, where that was needed */
    const roberts_scene *source; /* as given */
    view_clip clip;
    roberts_segment_fn *each; /* takes the segments; NULL: the drawing keeps them */
    void *context;
    const roberts_hide_options *options;
    hide_picture picture;
    objet grid;
    ahead ahead;         /* what was found before its turn, if anything */
    double crease_chord; /* distance of two unit normals that meet at the crease angle, squared */
} hide_job;

roberts_hide_options roberts_hide_options_default(void)
{
    return (roberts_hide_options){.crease_degrees = 0.1};
}

/* Flatter than the crease angle; the normals of the model are compared, which perspective does not bend. `edge` is stored
 * with the solid. */
static bool is_flat(const hide_job *job, const roberts_scene *scene, uint32_t solid, const scene_edge *edge)
{
    const plane *of = scene->face_plane + scene->solid[solid].face;
    plane F = of[edge->f[0]], G = of[edge->f[1]];
    double a = F.a - G.a, b = F.b - G.b, c = F.c - G.c;
    return a * a + b * b + c * c < job->crease_chord;
}

/* Where on the edge in space a point of its picture is; view_to_space() without a call where it has nothing to do. */
static inline double to_space(const view *v, const hide_edge *e, double s)
{
    return v->perspective ? view_to_space(v, e->A.z, e->B.z, s) : s;
}

static bool add_segment(const hide_job *job, hide_chunk *out, const roberts_segment *pattern, const hide_edge *e,
                        double s0, double s1)
{
    const view *v = &job->picture.view;
    double unit = v->unit, width = pattern->t1 - pattern->t0; /* of what the near plane leaves of the edge, mostly 1 */
    double t0 = pattern->t0 + width * to_space(v, e, s0);
    double t1 = s1 == 1.0 ? pattern->t1 : pattern->t0 + width * to_space(v, e, s1);
    if (t0 >= t1)
        return true; /* rounding leaves no length in space */
    if (!array_reserve(&out->segment, &out->room, out->count + 1, sizeof *out->segment))
        return false;
    roberts_vec3 R0 = hide_edge_at(e, s0), R1 = hide_edge_at(e, s1);
    roberts_segment *segment = &out->segment[out->count++];
    *segment = *pattern;
    segment->t0 = t0;
    segment->t1 = t1;
    segment->p0 = (roberts_vec2){R0.x * unit, R0.y * unit};
    segment->p1 = (roberts_vec2){R1.x * unit, R1.y * unit};
    segment->z0 = R0.z * unit;
    segment->z1 = R1.z * unit;
    return true;
}

static bool add_hidden(const hide_job *job, hide_worker *w, hide_chunk *out, roberts_segment pattern,
                       const hide_edge *e, double s0, double s1, uint32_t hider)
{
    const view *v = &job->picture.view;
    double t = 0.5 * (view_to_space(v, e->A.z, e->B.z, s0) + view_to_space(v, e->A.z, e->B.z, s1));
    roberts_vec3 middle = hide_edge_at(e, view_from_space(v, e->A.z, e->B.z, t));
    pattern.state = ROBERTS_HIDDEN;
    pattern.by = hide_seen_at(w, middle.x, middle.y);
    if (pattern.by == ROBERTS_NONE)
        pattern.by = hider; /* the point lies on a border and rounding has put it outside */
    return add_segment(job, out, &pattern, e, s0, s1);
}

/* How the faces of a solid look, from its first on. */
static const unsigned char *facing_of(const hide_job *job, uint32_t solid)
{
    return job->picture.facing + job->scene->solid[solid].face;
}

/* How many of the two faces of a stored edge are front. */
static inline int front_count(const unsigned char *facing, const scene_edge *edge)
{
    return (facing[edge->f[0]] == VIEW_FRONT) + (facing[edge->f[1]] == VIEW_FRONT);
}

static bool add_clipped(hide_chunk *out, roberts_segment pattern, double t0, double t1, roberts_vec2 at)
{
    if (!array_reserve(&out->segment, &out->room, out->count + 1, sizeof *out->segment))
        return false;
    pattern.state = ROBERTS_CLIPPED;
    pattern.t0 = t0;
    pattern.t1 = t1;
    pattern.p0 = pattern.p1 = at;
    out->segment[out->count++] = pattern;
    return true;
}

/* Visible segments between the hidden parts, and those too where they are wanted. The pattern's t0..t1 is what the near
 * plane has left of the edge. */
static bool add_line(const hide_job *job, hide_worker *w, hide_chunk *out, const roberts_segment *pattern,
                     const hide_line *line)
{
    double from = 0.0, unit = job->picture.view.unit;
    const hide_edge *e = &line->e;
    bool all = job->options->keep_hidden;
    if (all && pattern->t0 > 0.0 &&
        !add_clipped(out, *pattern, 0.0, pattern->t0, (roberts_vec2){e->A.x * unit, e->A.y * unit}))
        return false;
    for (size_t i = 0; i < line->parts.count; i++) {
        const hide_part *part = &line->parts.item[i].part;
        if (part->t0 > from && !add_segment(job, out, pattern, e, from, part->t0))
            return false;
        if (all && !add_hidden(job, w, out, *pattern, e, part->t0, part->t1, line->parts.item[i].solid))
            return false;
        from = part->t1;
    }
    if (from < 1.0 && !add_segment(job, out, pattern, e, from, 1.0))
        return false;
    return !all || pattern->t1 >= 1.0 ||
           add_clipped(out, *pattern, pattern->t1, 1.0, (roberts_vec2){e->B.x * unit, e->B.y * unit});
}

/* The same of an edge that the near plane leaves whole, where its visible segments are all that is wanted. It has a front
 * face. */
static bool add_visible(const hide_job *job, hide_chunk *out, uint32_t solid, const unsigned char *facing,
                        const hide_line *line)
{
    const view *v = &job->picture.view;
    const hide_edge *e = &line->e;
    const scene_edge *edge = scene_edge_stored(job->scene, solid, line->edge);
    roberts_line kind = front_count(facing, edge) == 2 ? ROBERTS_CREASE : ROBERTS_OUTLINE;
    double from = 0.0, unit = v->unit;
    size_t parts = line->parts.count;
    if (!array_reserve(&out->segment, &out->room, out->count + parts + 1, sizeof *out->segment))
        return false;
    for (size_t i = 0; i <= parts; i++) {
        const hide_part *part = i < parts ? &line->parts.item[i].part : NULL;
        double to = part ? part->t0 : 1.0, t0 = to_space(v, e, from), t1 = to == 1.0 ? 1.0 : to_space(v, e, to);
        if (to > from && t0 < t1) {
            roberts_vec3 R0 = hide_edge_at(e, from), R1 = hide_edge_at(e, to);
            out->segment[out->count++] = (roberts_segment){.solid = solid,
                                                           .v0 = scene_vertex_number(job->scene, e->a),
                                                           .v1 = scene_vertex_number(job->scene, e->b),
                                                           .by = ROBERTS_NONE,
                                                           .t0 = t0,
                                                           .t1 = t1,
                                                           .p0 = {R0.x * unit, R0.y * unit},
                                                           .p1 = {R1.x * unit, R1.y * unit},
                                                           .z0 = R0.z * unit,
                                                           .z1 = R1.z * unit,
                                                           .state = ROBERTS_VISIBLE,
                                                           .line = (uint8_t)kind};
        }
        from = part ? part->t1 : 1.0;
    }
    return true;
}

/* What lies behind the covers is hidden at once; covers are kept only where hidden lines are not wanted. P: view points of
 * the solid. */
static inline bool is_covered(const cover *c, const roberts_vec3 *P, const scene_edge *edge)
{
    return c->depth && cover_hides_edge(c, P[edge->v[0]], P[edge->v[1]]);
}

/* Takes up the edges of a solid that are drawn and not covered. A surviving edge has a front face. An outline (one front
 * face) is always drawn; an edge whose two faces look the same way is not where it is flat, whether they are front or,
 * among hidden lines, back. */
static bool take_edges(const hide_job *job, hide_worker *w, uint32_t solid)
{
    const roberts_scene *scene = job->scene;
    const unsigned char *facing = facing_of(job, solid);
    const scene_edge *edge = scene->edge + scene->solid[solid].stored;
    const roberts_vec3 *P = job->picture.P + scene->solid[solid].vertex;
    const bool *cap = job->clip.clipped ? job->clip.cap : NULL;
    bool keep_hidden = job->options->keep_hidden, all = job->options->all_edges;
    hide_worker_begin(w);
    for (uint32_t i = scene->solid[solid].edge, end = scene->solid[solid + 1].edge; i < end; i++, edge++) {
        int fronts = front_count(facing, edge);
        w->surviving += fronts > 0;
        if ((fronts == 0 && !keep_hidden) || (cap && cap[i]) ||
            (fronts != 1 && !all && is_flat(job, scene, solid, edge)))
            continue;
        w->drawn++;
        if (is_covered(&job->picture.cover, P, edge)) {
            w->tally.covered++;
            continue;
        }
        hide_line *line = hide_worker_add(w, i, edge, scene->solid[solid].vertex);
        if (!line)
            return false;
        if (fronts == 0) {
            line->hidden = true;
            if (!hide_parts_add(&line->parts, solid, &(hide_part){0.0, 1.0, 0.0, 0.0}))
                return false;
        }
    }
    return true;
}

/* One edge of the scene as given: the line that stands for it, NULL where it is not drawn. */
static bool add_edge(const hide_job *job, hide_worker *w, hide_chunk *out, uint32_t solid, uint32_t edge,
                     const hide_line *line)
{
    const scene_edge *source = scene_edge_stored(job->source, solid, edge);
    uint32_t first = job->source->solid[solid].vertex;
    clip_edge left = {edge, 0.0, 1.0};
    if (job->clip.clipped)
        left = job->clip.origin[edge];
    if (left.edge != ROBERTS_NONE && (!line || (line->hidden && !job->options->keep_hidden)))
        return true;
    int fronts = line ? front_count(facing_of(job, solid), scene_edge_stored(job->scene, solid, line->edge)) : 0;
    roberts_segment pattern = {.solid = solid,
                               .v0 = scene_vertex_number(job->source, first + source->v[0]),
                               .v1 = scene_vertex_number(job->source, first + source->v[1]),
                               .by = ROBERTS_NONE,
                               .t0 = left.t0,
                               .t1 = left.t1,
                               .state = ROBERTS_VISIBLE,
                               .line = fronts == 1   ? ROBERTS_OUTLINE
                                       : fronts == 2 ? ROBERTS_CREASE
                                                     : ROBERTS_BACK};
    if (left.edge == ROBERTS_NONE || left.t0 >= left.t1) { /* equal: it ends on the near plane, to rounding */
        bool drawn = job->options->all_edges || !is_flat(job, job->source, solid, source);
        return !job->options->keep_hidden || !drawn || add_clipped(out, pattern, 0.0, 1.0, (roberts_vec2){0.0, 0.0});
    }
    return add_line(job, w, out, &pattern, line);
}

/* The lines come in the order of the edges, of which some are not drawn and some, by the near plane, clipped away. */
static bool do_solid(const hide_job *job, hide_worker *w, hide_chunk *out, uint32_t solid)
{
    if (job->picture.culled[solid] && !(job->clip.clipped && job->options->keep_hidden))
        return true;
    if (job->ahead.order ? !ahead_recall(&job->ahead, solid, w)
                         : !take_edges(job, w, solid) || !hide_worker_run(w, solid))
        return false;
    const hide_line *line = w->line, *end = line + w->line_count;
    const unsigned char *facing = facing_of(job, solid);
    bool visible = !job->clip.clipped && !job->options->keep_hidden;
    for (; visible && line < end; line++)
        if (!line->hidden && !add_visible(job, out, solid, facing, line))
            return false;
    for (; !job->clip.clipped && line < end; line++)
        if (!add_edge(job, w, out, solid, line->edge, line))
            return false;
    for (uint32_t i = job->source->solid[solid].edge; job->clip.clipped && i < job->source->solid[solid + 1].edge;
         i++) {
        bool drawn = line < end && line->edge == job->clip.origin[i].edge;
        if (!add_edge(job, w, out, solid, i, drawn ? line++ : NULL))
            return false;
    }
    return true;
}

static bool do_chunk(const hide_job *job, hide_worker *w, hide_chunk *out, uint32_t index)
{
    uint32_t first = index * CHUNK_SOLIDS, count = job->scene->solid_count;
    uint32_t end = count - first < CHUNK_SOLIDS ? count : first + CHUNK_SOLIDS;
    if (!array_reserve(&out->segment, &out->room, out->count + CHUNK_SEGMENTS, sizeof *out->segment))
        return false;
    for (uint32_t s = first; s < end; s++)
        if (!do_solid(job, w, out, s))
            return false;
    return true;
}

/* The solids of one chunk of the order in which they lie in the picture. */
static bool look_ahead(hide_job *job, hide_worker *w, uint32_t index)
{
    uint32_t first = index * AHEAD_CHUNK, count = job->ahead.count;
    uint32_t end = count - first < AHEAD_CHUNK ? count : first + AHEAD_CHUNK;
    for (uint32_t k = first; k < end; k++) {
        uint32_t s = job->ahead.order[k];
        hide_worker_begin(w);
        if (!job->picture.culled[s] && (!take_edges(job, w, s) || !hide_worker_run(w, s)))
            return false;
        if (!ahead_keep(&job->ahead, k, w))
            return false;
    }
    return true;
}

/* All of them, where the order of the file is not as good. */
static bool look_ahead_at_all(hide_job *job, hide_worker *worker, int threads)
{
    bool lost = false;
    uint32_t count = job->ahead.order ? (job->ahead.count + AHEAD_CHUNK - 1) / AHEAD_CHUNK : 0;
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads) reduction(|| : lost)
#else
    (void)threads;
#endif
    for (uint32_t i = 0; i < count; i++) {
        int self = thread_self();
        lost = lost || !look_ahead(job, &worker[self], i);
    }
    return !lost;
}

static void add_sums(roberts_drawing *drawing, const hide_worker *w)
{
    roberts_tally *to = &drawing->tally;
    const roberts_tally *from = &w->tally;
    drawing->surviving_edges += w->surviving;
    drawing->drawn_edges += w->drawn;
    to->pairs += from->pairs;
    to->test1_visible += from->test1_visible;
    to->test2_visible += from->test2_visible;
    to->test3_visible += from->test3_visible;
    to->test3_invisible += from->test3_invisible;
    to->test4 += from->test4;
    to->covered += from->covered;
    to->refined += w->sides.refined;
}

/* One thread's part. */
static void do_some_chunks(const hide_job *job, hide_worker *w, chunks *all)
{
    uint32_t k;
    for (hide_chunk *out = chunks_take(all, &k); out; out = chunks_take(all, &k)) {
        if (!do_chunk(job, w, out, k)) {
            chunks_fail(all, ROBERTS_NO_MEMORY);
            return;
        }
        chunks_done(all, k);
    }
}

static void do_all_chunks(const hide_job *job, hide_worker *worker, int threads, chunks *all)
{
#ifdef _OPENMP
#pragma omp parallel num_threads(threads)
#else
    (void)threads;
#endif
    {
        int self = thread_self();
        do_some_chunks(job, &worker[self], all);
    }
}

/* The same by one thread, where the drawing keeps what is in order anyway. */
static roberts_status fill_drawing(const hide_job *job, hide_worker *w, uint32_t count, roberts_drawing *drawing)
{
    hide_chunk all = {0};
    bool done = true;
    for (uint32_t k = 0; done && k < count; k++)
        done = do_chunk(job, w, &all, k);
    drawing->segment = all.segment;
    drawing->count = all.count;
    return done ? ROBERTS_OK : ROBERTS_NO_MEMORY;
}

static roberts_status do_chunks(hide_job *job, roberts_drawing *drawing)
{
    uint32_t count = (job->scene->solid_count + CHUNK_SOLIDS - 1) / CHUNK_SOLIDS;
    int threads = threads_for(job->options->threads, 1 + count / CHUNKS_PER_THREAD);
    roberts_status status = ROBERTS_NO_MEMORY;
    hide_worker *worker = alloc_zeroed((size_t)threads, sizeof *worker);
    chunks all = {0};
    if (!worker || !chunks_init(&all, count, threads, drawing, job->each, job->context))
        goto done;
    for (int i = 0; i < threads; i++)
        if (!hide_worker_init(&worker[i], &job->picture, &job->grid))
            goto done;
    if (!look_ahead_at_all(job, worker, threads))
        goto done;
    if (threads == 1 && !job->each) {
        status = fill_drawing(job, &worker[0], count, drawing);
    } else {
        do_all_chunks(job, worker, threads, &all);
        status = (roberts_status)atomic_load(&all.status);
    }
    for (int i = 0; i < threads; i++)
        add_sums(drawing, &worker[i]);
done:
    for (int i = 0; worker && i < threads; i++)
        hide_worker_free(&worker[i]);
    chunks_free(&all);
    free(worker);
    return status;
}

static roberts_time now(void)
{
    struct timespec wall = {0}, cpu = {0};
    clock_gettime(CLOCK_MONOTONIC, &wall);
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &cpu);
    return (roberts_time){(double)cpu.tv_sec + 1e-9 * (double)cpu.tv_nsec,
                          (double)wall.tv_sec + 1e-9 * (double)wall.tv_nsec};
}

/* Time since *last, which becomes the present. */
static roberts_time lap(roberts_time *last)
{
    roberts_time present = now(), passed = {present.cpu - last->cpu, present.wall - last->wall};
    *last = present;
    return passed;
}

static roberts_status check_options(const roberts_hide_options *options, roberts_error *error)
{
    if (!(options->crease_degrees >= 0.0) || !(options->crease_degrees <= 180.0))
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "the crease angle must be between 0 and 180 degrees");
    if (options->grid > GRID_MOST)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "a grid of more than %d cells per side", GRID_MOST);
    if (options->threads > THREADS_MOST)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "more than %d threads", THREADS_MOST);
    return ROBERTS_OK;
}

/* In perspective the picture may be a square about the look-at point. */
static void set_frame(const hide_job *job, const roberts_camera *camera, roberts_drawing *drawing)
{
    double half;
    if (!view_frame(&job->picture.view, camera, job->clip.clipped, &half))
        return;
    drawing->framed = true;
    drawing->window_min = (roberts_vec2){-half, -half};
    drawing->window_max = (roberts_vec2){half, half};
}

/* The window is the box of all vertices: every solid has outlines, and they are always drawn. */
static void describe(const hide_job *job, const roberts_camera *camera, roberts_drawing *drawing)
{
    const hide_picture *picture = &job->picture;
    double unit = picture->view.unit;
    drawing->epsilon = picture->view.epsilon * unit;
    drawing->scene_diameter = picture->view.diameter * unit;
    drawing->grid = job->grid.frame.nx;
    drawing->grid_rows = job->grid.frame.ny;
    drawing->solids = job->source->solid_count;
    drawing->culled_solids = picture->culled_count;
    drawing->edges = job->source->edge_count;
    drawing->front_faces = picture->face_count;
    drawing->back_faces = picture->back;
    drawing->edge_on_faces = picture->edge_on;
    drawing->window_min = (roberts_vec2){picture->low.x * unit, picture->low.y * unit};
    drawing->window_max = (roberts_vec2){picture->high.x * unit, picture->high.y * unit};
    set_frame(job, camera, drawing);
}

/* What is culled does not depend on the grid: where borders coincide in the picture, another solid's border may differ in
 * the last bit. Hidden segments are wanted with whom the viewer sees there: then nothing is culled. */
static roberts_status build(hide_job *job, const roberts_camera *camera, roberts_drawing *drawing, roberts_error *error)
{
    const roberts_hide_options *options = job->options;
    roberts_time clock = now();
    roberts_status status = view_clip_scene(&job->clip, job->source, camera, error);
    if (status != ROBERTS_OK)
        return status;
    job->scene = job->clip.clipped ? &job->clip.scene : job->source;
    status = hide_picture_build(&job->picture, job->scene, camera, options->epsilon, !options->keep_hidden,
                                options->threads, error);
    if (status != ROBERTS_OK)
        return status;
    const view *v = &job->picture.view;
    if (v->epsilon > EPSILON_MOST * v->diameter && options->epsilon > 0.0)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "epsilon %.6g is more than a hundredth of the scene (%.6g)",
                         options->epsilon, v->diameter * v->unit);
    drawing->view_time = lap(&clock);
    const hide_picture *picture = &job->picture;
    /* Hidden segments are looked up in the picture at their own turn anyway. */
    if (!options->keep_hidden && !ahead_init(&job->ahead, picture))
        return ROBERTS_NO_MEMORY;
    hide_picture_drop_boxes(&job->picture);
    scan_frame frame = cells_for_lists(picture->front_box, picture->front_count, picture->low, picture->high,
                                       options->grid, hide_margin(&picture->space));
    status = objet_build(&job->grid, picture, frame);
    drawing->grid_time = lap(&clock);
    return status;
}

static roberts_status hide(hide_job *job, const roberts_camera *camera, roberts_drawing *drawing, roberts_error *error)
{
    roberts_hide_options defaults = roberts_hide_options_default();
    job->options = job->options ? job->options : &defaults;
    *drawing = (roberts_drawing){0};
    roberts_status status = check_options(job->options, error);
    if (status == ROBERTS_OK)
        status = build(job, camera, drawing, error);
    if (status == ROBERTS_OK) {
        roberts_time clock = now();
        job->crease_chord = 2.0 * sin(job->options->crease_degrees * pi / 360.0);
        job->crease_chord *= job->crease_chord;
        describe(job, camera, drawing);
        status = do_chunks(job, drawing);
        drawing->hide_time = lap(&clock);
    }
    ahead_free(&job->ahead);
    objet_free(&job->grid);
    hide_picture_free(&job->picture);
    view_clip_free(&job->clip);
    if (status == ROBERTS_NO_MEMORY)
        error_no_memory(error);
    if (status == ROBERTS_STOPPED)
        error_set(error, ROBERTS_STOPPED, 0, "stopped by the receiver of the segments");
    if (status != ROBERTS_OK)
        roberts_drawing_free(drawing);
    return status;
}

roberts_status roberts_hide(const roberts_scene *scene, const roberts_camera *camera,
                            const roberts_hide_options *options, roberts_drawing *drawing, roberts_error *error)
{
    hide_job job = {.source = scene, .options = options};
    return hide(&job, camera, drawing, error);
}

roberts_status roberts_hide_each(const roberts_scene *scene, const roberts_camera *camera,
                                 const roberts_hide_options *options, roberts_segment_fn *each, void *context,
                                 roberts_drawing *summary, roberts_error *error)
{
    hide_job job = {.source = scene, .options = options, .each = each, .context = context};
    roberts_drawing counted;
    if (!each) {
        if (summary)
            *summary = (roberts_drawing){0};
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "no function to receive the segments");
    }
    return hide(&job, camera, summary ? summary : &counted, error);
}

void roberts_drawing_free(roberts_drawing *drawing)
{
    if (!drawing)
        return;
    free(drawing->segment);
    *drawing = (roberts_drawing){0};
}
