/* hide.c - hidden-line removal from beginning to end, as in the lecture:
 *
 *   1. Fronts. `view` says what is seen (view/seen.h): each solid is mapped to view space, and its front faces become
 *      fronts (fronts.c, front.c). Solids that covers hide are left out (cover.c).
 *   2. Objet[i][j]. The cells of the picture list the fronts that touch them (cells.c, objet.c).
 *   3. Intersections. Fronts that share a cell may cross, which gives a further line (crossings.c).
 *   4. Lines. The lines of each body are taken (segments.c) through the cells that they cross (edge.c). Tests 1 to 4
 *      find what each front there hides of them (front_test.c, tests.c), and the hidden intervals are united
 *      (intervals.c). The rest of a line becomes segments.
 *
 * Threads take solids in chunks. Each chunk keeps its segments until those of the earlier chunks are written
 * (schedule.c). The threads share nothing else, so the result does not depend on them. */
#include "hide/hide.h"

#include <stdlib.h>
#include <time.h>

#include "base/array.h"
#include "base/bits.h"
#include "base/error.h"
#include "base/threads.h"
#include "hide/bare_faces.h"
#include "hide/cells.h"
#include "hide/cuts.h"
#include "hide/regions.h"
#include "hide/segments.h"

#define SOLIDS_AHEAD 2 /* between the prefetch of one and its use */
#define CHUNK_SOLIDS 64
#define CHUNK_SEGMENTS 1024 /* room at first: nine visible edges for each block, and some more */
#define CHUNK_CROSSINGS 256
#define CHUNKS_PER_THREAD 8 /* with less work than this, a thread costs more than it saves */

roberts_hide_options roberts_hide_options_default(void)
{
    return (roberts_hide_options){.crease_degrees = 0.1, .crease_auto = true, .slopes = true};
}

/* ---- time ---- */

static roberts_time now(void)
{
    struct timespec wall = {0}, cpu = {0};
    clock_gettime(CLOCK_MONOTONIC, &wall);
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &cpu);
    return (roberts_time){(double)cpu.tv_sec + 1e-9 * (double)cpu.tv_nsec,
                          (double)wall.tv_sec + 1e-9 * (double)wall.tv_nsec};
}

/* Returns the time since *last, and sets *last to the present. */
static roberts_time lap(roberts_time *last)
{
    roberts_time present = now(), passed = {present.cpu - last->cpu, present.wall - last->wall};
    *last = present;
    return passed;
}

/* ---- 1. fronts ---- */

/* What is culled does not depend on the grid. If borders coincide in the picture, they may still differ in the last
 * bit. Where hidden segments are wanted, with the solid that the viewer sees there, nothing is culled. */
static roberts_status make_fronts(hide_job *job, const roberts_scene *scene, const roberts_camera *camera,
                                  roberts_error *error)
{
    const roberts_hide_options *options = job->options;
    roberts_status status = seen_begin(&job->seen, scene, camera, options->epsilon, error);
    if (status != ROBERTS_OK)
        return status;
    seen_set_rules(&job->seen, options);
    if (!hide_fronts_build(&job->fronts, &job->seen, options, job->regions != NULL) ||
        (options->unite && !seen_unite(&job->seen, job->fronts.culled, options->threads)))
        return ROBERTS_NO_MEMORY;
    const view *v = &job->seen.view;
    if (v->epsilon > EPSILON_MOST * v->diameter && options->epsilon > 0.0)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0,
                         "the touching distance, %.6g, is more than %.6g, a hundredth of the scene", options->epsilon,
                         EPSILON_MOST * v->diameter * v->unit);
    return ROBERTS_OK;
}

/* ---- 2. Objet[i][j] ---- */

static roberts_status list_fronts(hide_job *job)
{
    hide_fronts *fronts = &job->fronts;
    double depth;
    cells_boxes boxes = {fronts->front_box, fronts->front_count, fronts->low, fronts->high,
                         hide_margin(&fronts->space)};
    scan_frame frame = cells_for_lists(&boxes, job->options->grid, &depth);
    if (!picture_order_init(&job->order, fronts, depth)) {
        free(frame.warps);
        return ROBERTS_NO_MEMORY;
    }
    hide_fronts_drop_boxes(&job->fronts);
    roberts_status status = objet_build(&job->grid, fronts, frame, job->options->threads);
    if (status == ROBERTS_OK && job->order.solid && fronts->front_count > fronts->whole_count &&
        !hide_fronts_keep(fronts, job->options->threads))
        status = ROBERTS_NO_MEMORY;
    return status;
}

/* ---- 3. where faces cross ---- */

/* Moves the data of lines that rows need to the drawing. */
static roberts_status find_crossings(hide_job *job, roberts_drawing *drawing)
{
    crossings *c = &job->crossings;
    if (!crossings_find(c, &job->fronts, &job->grid, job->options->threads) || c->count >= ROBERTS_NONE)
        return ROBERTS_NO_MEMORY;
    drawing->crossing = c->name;
    drawing->crossing_count = c->count;
    drawing->crossing_pairs = c->pairs;
    c->name = NULL;
    return ROBERTS_OK;
}

/* ---- 4. lines, tests and segments ---- */

/* The number of chunks of bodies. Chunks of lines in which faces cross follow them. */
static uint32_t body_chunks(const hide_job *job)
{
    return (job->seen.scene->solid_count + CHUNK_SOLIDS - 1) / CHUNK_SOLIDS;
}

static bool do_crossings(const hide_job *job, hide_worker *w, hide_chunk *out, size_t index)
{
    size_t first = index * CHUNK_CROSSINGS, count = job->crossings.count;
    return segments_cross(job, w, out, first, count - first < CHUNK_CROSSINGS ? count : first + CHUNK_CROSSINGS);
}

static bool do_chunk(const hide_job *job, hide_worker *w, hide_chunk *out, uint32_t index)
{
    uint32_t first = index * CHUNK_SOLIDS, count = job->seen.scene->solid_count, bodies = body_chunks(job);
    if (index >= bodies)
        return do_crossings(job, w, out, index - bodies);
    uint32_t end = count - first < CHUNK_SOLIDS ? count : first + CHUNK_SOLIDS;
    return array_reserve(&out->segment, &out->room, out->count + CHUNK_SEGMENTS, sizeof *out->segment) &&
           segments_find(job, w, out, first, end);
}

/* Hides the solids of one chunk, in the order of the picture. */
static bool look_ahead(hide_job *job, hide_worker *w, uint32_t index)
{
    uint32_t first = index * KEPT_SOLIDS, count = job->order.count;
    uint32_t end = count - first < KEPT_SOLIDS ? count : first + KEPT_SOLIDS;
    for (uint32_t k = first; k < end; k++) {
        uint32_t s = job->order.solid[k];
        if (k + 2 * SOLIDS_AHEAD < count) {
            FETCH_AHEAD(&job->seen.scene->solid[job->order.solid[k + 2 * SOLIDS_AHEAD]]);
            FETCH_AHEAD(&job->fronts.culled[job->order.solid[k + 2 * SOLIDS_AHEAD]]);
        }
        if (k + SOLIDS_AHEAD < count && !job->fronts.culled[job->order.solid[k + SOLIDS_AHEAD]])
            hide_fronts_fetch(&job->fronts, job->order.solid[k + SOLIDS_AHEAD]);
        hide_worker_begin(w, ROBERTS_NONE);
        if (segments_at_once(job, s) && !segments_hide(job, w, s))
            return false;
        if (!picture_order_keep(&job->order, k, w))
            return false;
    }
    return true;
}

typedef struct ahead {
    hide_job *job;
    hide_worker *worker; /* [threads] */
} ahead;

static bool look_ahead_at_some(void *context, size_t first, size_t end)
{
    const ahead *a = context;
    for (size_t i = first; i < end; i++)
        if (!look_ahead(a->job, &a->worker[thread_self()], (uint32_t)i))
            return false;
    return true;
}

/* Hides all solids in the order of the picture, if the order of the file is not as good. */
static bool look_ahead_at_all(hide_job *job, hide_worker *worker, int threads)
{
    return threads_each(threads, job->order.chunks, 1, look_ahead_at_some, &(ahead){job, worker});
}

static void add_sums(roberts_drawing *drawing, const hide_worker *w)
{
    roberts_tally *to = &drawing->tally;
    const roberts_tally *from = &w->sides.tally;
    drawing->surviving_edges += w->surviving;
    drawing->drawn_edges += w->drawn;
    to->pairs += from->pairs;
    to->test1_visible += from->test1_visible;
    to->test2_visible += from->test2_visible;
    to->test3_visible += from->test3_visible;
    to->test3_invisible += from->test3_invisible;
    to->test4 += from->test4;
    to->covered += from->covered;
    to->pierced += from->pierced;
    to->refined += w->sides.refined;
}

typedef struct chunk_work {
    const hide_job *job;
    hide_worker *worker; /* [threads] */
    chunks *all;
} chunk_work;

/* One thread's part: the thread is the item. */
static bool do_some_chunks(void *context, size_t first, size_t end)
{
    const chunk_work *c = context;
    const int self = (int)first;
    chunks *all = c->all;
    (void)end;
    for (hide_chunk *out = chunks_take(all, self); out; out = chunks_take(all, self)) {
        if (!do_chunk(c->job, &c->worker[self], out, out->number)) {
            chunks_fail(all, ROBERTS_NO_MEMORY);
            return false;
        }
        chunks_done(all, self, out);
    }
    return true;
}

static void do_all_chunks(const hide_job *job, hide_worker *worker, int threads, chunks *all)
{
    threads_each(threads, (size_t)threads, 1, do_some_chunks, &(chunk_work){job, worker, all});
}

/* One thread fills all chunks, in order. The drawing keeps the segments as they come, or the receiver gets them. */
static roberts_status fill_drawing(const hide_job *job, hide_worker *w, uint32_t count, roberts_drawing *drawing)
{
    hide_chunk all = {.to = job->to};
    bool done = true;
    for (uint32_t k = 0; done && k < count; k++)
        done = do_chunk(job, w, &all, k) && (!all.to || chunk_give(&all, all.to));
    drawing->count = all.count + all.given;
    if (all.to)
        free(all.segment);
    else
        drawing->segment = all.segment;
    return done ? ROBERTS_OK : all.stopped ? ROBERTS_STOPPED : ROBERTS_NO_MEMORY;
}

static roberts_status do_chunks(hide_job *job, roberts_drawing *drawing)
{
    size_t crossing = (job->crossings.count + CHUNK_CROSSINGS - 1) / CHUNK_CROSSINGS;
    uint32_t count = body_chunks(job) + (uint32_t)crossing;
    int threads = threads_for(job->options->threads, 1 + count / CHUNKS_PER_THREAD);
    roberts_status status = ROBERTS_NO_MEMORY;
    hide_worker *worker = alloc_zeroed((size_t)threads, sizeof *worker);
    chunks all = {0};
    if (!worker || !chunks_init(&all, count, threads, drawing, job->to))
        goto done;
    for (int i = 0; i < threads; i++)
        if (!hide_worker_init(&worker[i], &job->fronts, &job->grid, job->options->keep_hidden,
                              job->options->keep_hidden && !job->options->nameless))
            goto done;
    if (!look_ahead_at_all(job, worker, threads))
        goto done;
    if (threads == 1) {
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

/* ---- visible regions ---- */

/* Hides the lines, and with them what else bounds regions: the edges that the drawing leaves out because they are flat,
 * and the cuts of the near plane. */
static roberts_status hide_for_regions(hide_job *job, const seen_further *cuts, region_lines *lines,
                                       roberts_drawing *drawing)
{
    const roberts_receiver take = {region_lines_take, lines};
    lines->seen = &job->seen;
    lines->near = regions_near(&job->fronts);
    if (!job->options->merge_regions &&
        !bare_faces_find(&job->fronts, &job->grid, REGION_MARGIN * greater(lines->near.joined, lines->near.reach),
                         job->options->threads, &job->seen.sight))
        return ROBERTS_NO_MEMORY;
    job->seen.rules.left_out = true;
    job->seen.further = *cuts;
    job->to = &take;
    roberts_status status = do_chunks(job, drawing);
    job->to = NULL;
    drawing->segment = lines->segment;
    drawing->count = lines->count;
    return status == ROBERTS_STOPPED ? ROBERTS_NO_MEMORY : status;
}

/* ---- all of it ---- */

static roberts_status check_options(const roberts_hide_options *options, roberts_error *error)
{
    if (!(options->crease_degrees >= 0.0) || !(options->crease_degrees <= 180.0))
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "the crease angle must be between 0 and 180 degrees");
    if (options->grid > ROBERTS_GRID_MOST)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "a grid of more than %d cells per side", ROBERTS_GRID_MOST);
    if (options->threads > ROBERTS_THREADS_MOST)
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "more than %d threads", ROBERTS_THREADS_MOST);
    return ROBERTS_OK;
}

/* The window is the field of view, or else the box of all vertices: every solid has outlines, and they are always
 * drawn. */
static void describe_scene(const hide_job *job, const roberts_camera *camera, roberts_drawing *drawing)
{
    const hide_fronts *fronts = &job->fronts;
    const view *v = &job->seen.view;
    double unit = v->unit;
    drawing->epsilon = v->epsilon * unit;
    drawing->epsilon_reason = v->epsilon_reason;
    drawing->scene_diameter = v->diameter * unit;
    drawing->grid = job->grid.frame.nx;
    drawing->grid_rows = job->grid.frame.ny;
    drawing->solids = job->seen.source->solid_count;
    drawing->culled_solids = fronts->culled_count;
    drawing->edges = job->seen.source->edge_count;
    drawing->seams = united_seams(&job->seen.edges, job->seen.source->edge_count);
    drawing->front_faces = fronts->face_count;
    drawing->back_faces = fronts->back;
    drawing->edge_on_faces = fronts->edge_on;
    drawing->window_min = (roberts_vec2){fronts->low.x * unit, fronts->low.y * unit};
    drawing->window_max = (roberts_vec2){fronts->high.x * unit, fronts->high.y * unit};
    drawing->sectioned = job->seen.clip.clipped && job->seen.clip.section;
    drawing->framed = view_frame(v, camera, job->seen.clip.clipped && !job->seen.clip.section, &drawing->window_min,
                                 &drawing->window_max);
}

roberts_status hide_scene(hide_job *job, const roberts_scene *scene, const roberts_camera *camera,
                          roberts_drawing *drawing, roberts_error *error)
{
    roberts_hide_options defaults = roberts_hide_options_default();
    job->options = job->options ? job->options : &defaults;
    *drawing = (roberts_drawing){0};
    seen_further cuts = {0};
    region_lines lines = {0};
    roberts_status status = check_options(job->options, error);
    roberts_time clock = now();
    if (status == ROBERTS_OK) {
        status = make_fronts(job, scene, camera, error);
        drawing->view_time = lap(&clock);
    }
    if (status == ROBERTS_OK) {
        status = list_fronts(job);
        drawing->grid_time = lap(&clock);
    }
    if (status == ROBERTS_OK) {
        describe_scene(job, camera, drawing);
        status = find_crossings(job, drawing);
    }
    const bool cut = status == ROBERTS_OK && job->seen.clip.clipped && !job->to;
    if (cut && !cuts_find(&job->fronts, &cuts))
        status = ROBERTS_NO_MEMORY;
    if (status == ROBERTS_OK) {
        status = job->regions ? hide_for_regions(job, &cuts, &lines, drawing) : do_chunks(job, drawing);
        drawing->hide_time = lap(&clock);
    }
    if (status == ROBERTS_OK && cut && !cuts_draw(&job->fronts, &cuts, job->options->unite, drawing))
        status = ROBERTS_NO_MEMORY;
    if (status == ROBERTS_OK && job->regions) {
        status = regions_find(job, &lines) ? ROBERTS_OK : ROBERTS_NO_MEMORY;
        drawing->region_time = lap(&clock);
    }
    planar_map_free(&lines.map);
    cuts_free(&cuts);
    crossings_free(&job->crossings);
    picture_order_free(&job->order);
    objet_free(&job->grid);
    hide_fronts_free(&job->fronts);
    seen_end(&job->seen);
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
    hide_job job = {.options = options};
    return hide_scene(&job, scene, camera, drawing, error);
}

roberts_status roberts_hide_each(const roberts_scene *scene, const roberts_camera *camera,
                                 const roberts_hide_options *options, const roberts_receiver *each,
                                 roberts_drawing *summary, roberts_error *error)
{
    hide_job job = {.options = options, .to = each};
    roberts_drawing counted;
    if (!each || !each->receive) {
        if (summary)
            *summary = (roberts_drawing){0};
        return error_set(error, ROBERTS_BAD_ARGUMENT, 0, "no function to receive the segments");
    }
    roberts_status status = hide_scene(&job, scene, camera, summary ? summary : &counted, error);
    if (!summary)
        roberts_drawing_free(&counted);
    return status;
}

void roberts_drawing_free(roberts_drawing *drawing)
{
    if (!drawing)
        return;
    free(drawing->segment);
    free(drawing->crossing);
    free(drawing->known_edge);
    *drawing = (roberts_drawing){0};
}
