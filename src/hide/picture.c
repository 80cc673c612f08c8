/* picture.c - see picture.h. */
#include "hide/picture.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/error.h"
#include "base/bits.h"
#include "base/threads.h"
#include "hide/cells.h"
#include "hide/copies.h"
#include "hide/cull.h"
#include "hide/front.h"
#include "hide/span.h"

/* With fewer solids than this a thread costs more than it does. */
#define SOLIDS_PER_THREAD 2048
/* Solids whose boxes a thread finds in one go. */
#define BOXES_AT_ONCE 1024

/* Solids between asking for a box and needing it. */
#define BOX_AHEAD 8

/* Scratch memory of the building. */
typedef struct build {
    hide_picture *picture;
    tiles tiles;
    front_scratch *scratch; /* [threads] */
    int threads;
    bool looked_up; /* who is seen at a point will be asked */
} build;

enum { POINTS_AT_ONCE = 64 };

/* The box of a solid's view points. */
static span measure_solid(const hide_picture *picture, uint32_t solid)
{
    const roberts_scene *scene = picture->scene;
    const roberts_vec3 *point = scene->point + scene->solid[solid].vertex;
    uint32_t left = scene->solid[solid + 1].vertex - scene->solid[solid].vertex;
    roberts_vec3 P[POINTS_AT_ONCE];
    span own = empty_span;
    for (uint32_t count; left > 0; left -= count, point += count) {
        count = left < POINTS_AT_ONCE ? left : POINTS_AT_ONCE;
        view_points(&picture->view, point, count, P);
        box_add_all(&own.low, &own.high, P, count);
    }
    return own;
}

/* In the picture, by what may be empty. */
static void widen_by(span *all, const span *own)
{
    all->low = (roberts_vec3){lesser(all->low.x, own->low.x), lesser(all->low.y, own->low.y), 0.0};
    all->high = (roberts_vec3){greater(all->high.x, own->high.x), greater(all->high.y, own->high.y), 0.0};
}

/* Boxes of the solids first..end-1; gives what is round them all. One of which the near plane has left nothing is empty. */
static span box_some(hide_picture *picture, uint32_t first, uint32_t end)
{
    span all = empty_span;
    for (uint32_t s = first; s < end; s++) {
        span own = measure_solid(picture, s);
        picture->box[s] = span_box(&own);
        widen_by(&all, &own);
    }
    return all;
}

/* Boxes of all solids, and the window. False: no memory. */
static bool box_solids(hide_picture *picture, int threads)
{
    uint32_t solids = picture->scene->solid_count, count = solids / BOXES_AT_ONCE + 1;
    span *part = alloc_array(count, sizeof *part), all = empty_span;
    if (!part)
        return false;
#ifdef _OPENMP
#pragma omp parallel for schedule(static) num_threads(threads)
#else
    (void)threads;
#endif
    for (uint32_t i = 0; i < count; i++) {
        uint32_t first = i * BOXES_AT_ONCE, left = solids - first;
        part[i] = box_some(picture, first, first + (left < BOXES_AT_ONCE ? left : BOXES_AT_ONCE));
    }
    for (uint32_t i = 0; i < count; i++)
        widen_by(&all, &part[i]);
    picture->low = (roberts_vec2){all.low.x, all.low.y};
    picture->high = (roberts_vec2){all.high.x, all.high.y};
    free(part);
    return true;
}

/* Has the near plane left nothing of it? */
static bool is_empty(const hide_picture *picture, uint32_t s)
{
    return picture->scene->solid[s].vertex == picture->scene->solid[s + 1].vertex;
}

/* Is nothing to be seen of the first of the solids? Asks for what will soon be asked of one that follows it. */
static bool cull_first(hide_picture *picture, picture_tile *tile, const uint32_t *order, uint32_t left)
{
    uint32_t s = order[0];
    if (left > BOX_AHEAD) {
        FETCH_AHEAD(&picture->box[order[BOX_AHEAD]]);
        FETCH_AHEAD(&picture->scene->solid[order[BOX_AHEAD]]);
    }
    bool empty = is_empty(picture, s);
    picture->culled[s] = empty || cull_hides(picture, &picture->box[s], s);
    tile->culled += picture->culled[s] && !empty;
    return picture->culled[s];
}

/* The solid's turn to be mapped will come: asks for what that wants (or, of very many points, for the beginning of it). */
static uint32_t let_wait(hide_picture *picture, uint32_t s)
{
    const roberts_scene *scene = picture->scene;
    const scene_solid *solid = &scene->solid[s];
    FETCH_ARRAY(scene->point + solid->vertex, (size_t)(solid[1].vertex - solid->vertex) * sizeof *scene->point);
    FETCH_AHEAD(scene->face_start + solid->face);
    FETCH_AHEAD(scene->face_deviation + solid->face);
    FETCH_AHEAD(scene->face_width + solid->face);
    hide_picture_fetch(picture, s);
    return s;
}

/* As they are numbered: no covers are kept. */
static bool do_tile_in_order(hide_picture *picture, front_scratch *scratch, picture_tile *tile)
{
    for (uint32_t s = tile->first; s < tile->end; s++) {
        picture->culled[s] = is_empty(picture, s);
        if (!picture->culled[s] && !front_add(picture, scratch, tile, s))
            return false;
    }
    return true;
}

/* Nearest solids first, each culled where those before it cover it. Its turn to be mapped comes when the next one is found
 * that is not culled, and while that one's memory is on its way: it lies anywhere. */
static bool do_tile(build *b, front_scratch *scratch, picture_tile *tile)
{
    hide_picture *picture = b->picture;
    uint32_t waiting = ROBERTS_NONE;
    if (!b->tiles.solid)
        return do_tile_in_order(picture, scratch, tile);
    if (!tiles_order(&b->tiles, tile, picture))
        return false;
    for (uint32_t k = tile->first; k < tile->end; k++) {
        if (cull_first(picture, tile, b->tiles.solid + k, tile->end - k))
            continue;
        uint32_t s = let_wait(picture, b->tiles.solid[k]);
        if (waiting != ROBERTS_NONE && !front_add(picture, scratch, tile, waiting))
            return false;
        waiting = s;
    }
    return waiting == ROBERTS_NONE || front_add(picture, scratch, tile, waiting);
}

/* A solid that was mapped and counted is hidden by those that came later. */
static void cull_late(hide_picture *picture, picture_tile *tile, uint32_t s)
{
    const scene_solid *solid = &picture->scene->solid[s];
    picture->culled[s] = true;
    tile->culled++;
    for (uint32_t face = solid->face; face < solid[1].face; face++) {
        tile->faces -= picture->facing[face] == VIEW_FRONT;
        tile->back -= picture->facing[face] == VIEW_BACK;
        tile->edge_on -= picture->facing[face] == VIEW_EDGE_ON;
    }
}

/* Once more, when every cover is known. */
static void cull_again(hide_picture *picture, picture_tile *tile)
{
    for (uint32_t k = tile->first; k < tile->front; k++) {
        const hide_front *front = &picture->front[k];
        if (cull_hides(picture, &picture->front_box[k], front->solid))
            cull_late(picture, tile, front->solid);
    }
    for (size_t k = 0; k < tile->single_count; k++) {
        uint32_t s = tile->single[k].solid;
        if ((k == 0 || s != tile->single[k - 1].solid) && cull_hides(picture, &picture->box[s], s))
            cull_late(picture, tile, s);
    }
}

/* All solids, round by round. */
static bool do_tiles(build *b)
{
    tiles *t = &b->tiles;
    bool lost = false;
    for (int r = 0; r < TILE_ROUNDS && !lost; r++) {
        uint32_t first = t->round[r], end = t->round[r + 1];
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic, 1) num_threads(b->threads) reduction(|| : lost) if (end - first > 1)
#endif
        for (uint32_t i = first; i < end; i++)
            lost = lost || !do_tile(b, &b->scratch[thread_self()], &t->tile[i]);
    }
    if (lost || !b->picture->cover.depth)
        return !lost;
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic, 1) num_threads(b->threads)
#endif
    for (uint32_t i = 0; i < t->count; i++)
        cull_again(b->picture, &t->tile[i]);
    return true;
}

/* Brings the fronts that are left together, tile after tile. */
static void close_up(hide_picture *picture, const tiles *t)
{
    uint32_t to = 0;
    for (uint32_t i = 0; i < t->count; i++)
        for (uint32_t k = t->tile[i].first; k < t->tile[i].front; k++) {
            if (picture->culled[picture->front[k].solid])
                continue;
            if (k != to) {
                picture->front[to] = picture->front[k];
                picture->front_box[to] = picture->front_box[k];
            }
            to++;
        }
    picture->front_count = to;
}

/* ... and those of single faces behind them. False: no memory. */
static bool add_singles(hide_picture *picture, const tiles *t)
{
    size_t count = picture->front_count, room = picture->scene->solid_count, box_room = room;
    for (uint32_t i = 0; i < t->count; i++)
        count += t->tile[i].single_count;
    if (count > UINT32_MAX || !array_reserve(&picture->front, &room, count, sizeof *picture->front) ||
        !array_reserve(&picture->front_box, &box_room, count, sizeof *picture->front_box))
        return false;
    for (uint32_t i = 0; i < t->count; i++)
        for (size_t k = 0; k < t->tile[i].single_count; k++) {
            if (picture->culled[t->tile[i].single[k].solid])
                continue;
            picture->front[picture->front_count] = t->tile[i].single[k];
            picture->front_box[picture->front_count++] = t->tile[i].single_box[k];
        }
    return true;
}

/* A front's `depth` is below its farthest corner by as much as one must be above a face so as not to touch it. */
static double thickest(const hide_picture *picture)
{
    double most = 0.0;
    for (uint32_t k = 0; k < picture->front_count; k++) {
        const hide_front *front = &picture->front[k];
        double own = front->corners ? (double)picture->front_box[k].z1 - (double)front->depth : INFINITY;
        most = greater(most, own);
    }
    return most;
}

static void add_counts(hide_picture *picture, const tiles *t)
{
    for (uint32_t i = 0; i < t->count; i++) {
        const picture_tile *from = &t->tile[i];
        picture->face_count += from->faces;
        picture->back += from->back;
        picture->edge_on += from->edge_on;
        picture->culled_count += from->culled;
        if (from->most_corners > picture->most_corners)
            picture->most_corners = from->most_corners;
    }
}

static uint32_t most_vertices(const roberts_scene *scene)
{
    uint32_t most = 0;
    for (uint32_t s = 0; s < scene->solid_count; s++)
        if (scene->solid[s + 1].vertex - scene->solid[s].vertex > most)
            most = scene->solid[s + 1].vertex - scene->solid[s].vertex;
    return most;
}

/* Arrays so much longer that they lie apart; and the tables of bundles and runs, where a solid could have them. */
static bool alloc_scratch(build *b)
{
    hide_picture *picture = b->picture;
    const roberts_scene *scene = picture->scene;
    uint32_t most = most_vertices(scene);
    bool asked = scene->solid_count > 1 || b->looked_up; /* a face about an edge, or a point */
    if (most > BUNDLE_FACES / 2 && asked && !bundle_table_init(&picture->bundles, scene->face_count))
        return false; /* a solid has fewer than twice as many faces as vertices */
    if (most > RUNS_CORNERS && asked &&
        (!runs_table_init(&picture->face_runs, scene->corner, scene->face_start[scene->face_count]) ||
         !runs_table_init(&picture->outline_runs, picture->outline, scene->vertex_count)))
        return false;
    b->scratch = alloc_zeroed((size_t)b->threads, sizeof *b->scratch);
    for (int i = 0; b->scratch && i < b->threads; i++) {
        b->scratch[i].next = alloc_array((size_t)most + THREADS_APART, sizeof *b->scratch[i].next);
        if (!b->scratch[i].next || !scan_init(&b->scratch[i].scan, picture->cover.frame.nx))
            return false;
    }
    return b->scratch != NULL;
}

static void free_scratch(build *b)
{
    for (int i = 0; b->scratch && i < b->threads; i++) {
        free(b->scratch[i].next);
        scan_free(&b->scratch[i].scan);
    }
    free(b->scratch);
}

static bool add_solids(build *b)
{
    hide_picture *picture = b->picture;
    bool done = alloc_scratch(b) && tiles_make(&b->tiles, picture, b->threads) && do_tiles(b);
    if (done) {
        close_up(picture, &b->tiles);
        add_counts(picture, &b->tiles);
        done = copies_leave_out(picture) && add_singles(picture, &b->tiles);
        picture->thickest = b->looked_up ? thickest(picture) : INFINITY;
    }
    tiles_free(&b->tiles);
    free_scratch(b);
    return done;
}

/* Of most arrays only a part is ever written, and memory that is not touched is none. */
static bool alloc_picture(hide_picture *picture)
{
    const roberts_scene *scene = picture->scene;
    picture->box = alloc_array(scene->solid_count, sizeof *picture->box);
    picture->culled = alloc_zeroed(scene->solid_count, sizeof *picture->culled);
    picture->P = alloc_array(scene->vertex_count, sizeof *picture->P);
    picture->facing = alloc_zeroed(scene->face_count, sizeof *picture->facing);
    picture->face = alloc_array(scene->face_count, sizeof *picture->face);
    picture->front = alloc_array(scene->solid_count, sizeof *picture->front);
    picture->front_box = alloc_array(scene->solid_count, sizeof *picture->front_box);
    picture->outline = alloc_array(scene->vertex_count, sizeof *picture->outline);
    if (scene->surface)
        picture->turned = alloc_array(scene->face_start[scene->face_count], sizeof *picture->turned);
    return (picture->turned || !scene->surface) && picture->box && picture->culled && picture->P && picture->facing &&
           picture->face && picture->front && picture->front_box && picture->outline;
}

static void set_space(hide_picture *picture)
{
    const view *v = &picture->view;
    picture->space = (hide_space){.P = picture->P,
                                  .epsilon = v->epsilon,
                                  .rounding = v->across_rounding,
                                  .depth_rounding = v->rounding,
                                  .plain = hide_plain(v->across, v->epsilon, v->across_rounding),
                                  .scene = picture->scene,
                                  .view = v};
}

roberts_status hide_picture_build(hide_picture *picture, const roberts_scene *scene, const roberts_camera *camera,
                                  double epsilon, bool cull, uint32_t threads, roberts_error *error)
{
    build b = {.picture = picture,
               .threads = threads_for(threads, 1 + scene->solid_count / SOLIDS_PER_THREAD),
               .looked_up = !cull};
    *picture = (hide_picture){.scene = scene};
    roberts_status status = view_prepare(&picture->view, scene, camera, epsilon, error);
    if (status != ROBERTS_OK)
        return status;
    scan_frame frame = {0};
    bool done = alloc_picture(picture) && box_solids(picture, b.threads);
    if (done) {
        set_space(picture);
        if (cull)
            frame = cells_for_covers(picture->box, scene->solid_count, picture->low, picture->high,
                                     hide_margin(&picture->space), b.threads);
    }
    if (done && cover_init(&picture->cover, frame, b.threads) && add_solids(&b))
        return ROBERTS_OK;
    hide_picture_free(picture);
    return error_no_memory(error);
}

void hide_picture_drop_boxes(hide_picture *picture)
{
    free(picture->box);
    picture->box = NULL;
}

void hide_picture_free(hide_picture *picture)
{
    free(picture->box);
    free(picture->culled);
    free(picture->P);
    free(picture->facing);
    free(picture->face);
    free(picture->front);
    free(picture->front_box);
    free(picture->outline);
    free(picture->turned);
    runs_table_free(&picture->face_runs);
    runs_table_free(&picture->outline_runs);
    bundle_table_free(&picture->bundles);
    cover_free(&picture->cover);
    *picture = (hide_picture){0};
}
