/* fronts.c - see fronts.h. */
#include "hide/fronts.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/bits.h"
#include "base/sort.h"
#include "base/threads.h"
#include "hide/cells.h"
#include "hide/front.h"

/* With fewer solids than this, another thread does not pay. */
#define SOLIDS_PER_THREAD 2048
/* A thread finds the boxes of this many solids at a time. */
#define BOXES_AT_ONCE 1024

/* A box is prefetched this many solids before it is needed. */
#define BOX_AHEAD 8

/* Scratch memory of the building. */
typedef struct build {
    hide_fronts *fronts;
    tiles tiles;
    front_scratch *scratch; /* [threads] */
    int threads;
    bool looked_up; /* point_solid() will be called */
    bool cull;      /* what is hidden is left out */
    bool late;      /* hide_fronts.late is wanted */
} build;

enum { POINTS_AT_ONCE = 64 };

/* Returns the box of a solid's view points. */
static box3 measure_solid(const hide_fronts *fronts, uint32_t solid)
{
    const roberts_scene *scene = fronts->scene;
    const roberts_vec3 *point = scene->point + scene->solid[solid].vertex;
    uint32_t left = scene->solid[solid + 1].vertex - scene->solid[solid].vertex;
    roberts_vec3 P[POINTS_AT_ONCE];
    box3 own = box3_none;
    for (uint32_t count; left > 0; left -= count, point += count) {
        count = left < POINTS_AT_ONCE ? left : POINTS_AT_ONCE;
        view_points(&fronts->seen->view, point, count, P);
        box_add_all(&own.lo, &own.hi, P, count);
    }
    return own;
}

/* Widens a box of the picture so that it holds another one, which may be empty. */
static void widen_by(box3 *all, const box3 *own)
{
    all->lo = (roberts_vec3){lesser(all->lo.x, own->lo.x), lesser(all->lo.y, own->lo.y), 0.0};
    all->hi = (roberts_vec3){greater(all->hi.x, own->hi.x), greater(all->hi.y, own->hi.y), 0.0};
}

/* Finds the boxes of the solids first..end-1, and returns the box round all of them. If the near plane has left nothing
 * of a solid, its box is empty. */
static box3 box_some(hide_fronts *fronts, uint32_t first, uint32_t end)
{
    box3 all = box3_none;
    for (uint32_t s = first; s < end; s++) {
        box3 own = measure_solid(fronts, s);
        fronts->box[s] = hide_box_around(&own);
        widen_by(&all, &own);
    }
    return all;
}

typedef struct boxing {
    hide_fronts *fronts;
    box3 *part; /* round each BOXES_AT_ONCE solids */
} boxing;

static bool box_parts(void *context, size_t first, size_t end)
{
    const boxing *b = context;
    for (uint32_t i = (uint32_t)first; i < end; i++) {
        uint32_t from = i * BOXES_AT_ONCE, left = b->fronts->scene->solid_count - from;
        b->part[i] = box_some(b->fronts, from, from + (left < BOXES_AT_ONCE ? left : BOXES_AT_ONCE));
    }
    return true;
}

/* Finds the boxes of all solids, and the box of the picture. False: no memory. */
static bool box_solids(hide_fronts *fronts, int threads)
{
    uint32_t count = fronts->scene->solid_count / BOXES_AT_ONCE + 1;
    box3 *part = alloc_array(count, sizeof *part), all = box3_none;
    if (!part)
        return false;
    threads_each(threads, count, 0, box_parts, &(boxing){fronts, part});
    for (uint32_t i = 0; i < count; i++)
        widen_by(&all, &part[i]);
    fronts->low = (roberts_vec2){all.lo.x, all.lo.y};
    fronts->high = (roberts_vec2){all.hi.x, all.hi.y};
    free(part);
    return true;
}

/* Did the near plane leave nothing of the solid? */
static bool is_empty(const hide_fronts *fronts, uint32_t s)
{
    return fronts->scene->solid[s].vertex == fronts->scene->solid[s + 1].vertex;
}

/* Culls the first of `left` solids if nothing of it can be seen; returns whether it did. Prefetches the box of a later
 * one. */
static bool cull_first(hide_fronts *fronts, front_tile *tile, const uint32_t *order, uint32_t left)
{
    uint32_t s = order[0];
    if (left > BOX_AHEAD) {
        FETCH_AHEAD(&fronts->box[order[BOX_AHEAD]]);
        FETCH_AHEAD(&fronts->scene->solid[order[BOX_AHEAD]]);
    }
    bool empty = is_empty(fronts, s);
    fronts->culled[s] = empty || cover_hides_solid(fronts, &fronts->box[s], s);
    tile->culled += fronts->culled[s] && !empty;
    return fronts->culled[s];
}

/* Prefetches what the mapping of the solid needs, at least the beginning. Returns the solid. */
static uint32_t let_wait(hide_fronts *fronts, uint32_t s)
{
    const roberts_scene *scene = fronts->scene;
    const scene_solid *solid = &scene->solid[s];
    FETCH_ARRAY(scene->point + solid->vertex, (size_t)(solid[1].vertex - solid->vertex) * sizeof *scene->point);
    FETCH_AHEAD(scene->face_start + solid->face);
    if (scene->face_plane) {
        FETCH_AHEAD(scene->face_deviation + solid->face);
        FETCH_AHEAD(scene->face_width + solid->face);
    }
    hide_fronts_fetch(fronts, s);
    return s;
}

/* Adds the fronts of a tile's solids in the order of their numbers, where no covers are kept. False: no memory. */
static bool do_tile_in_order(hide_fronts *fronts, front_scratch *scratch, front_tile *tile)
{
    for (uint32_t s = tile->first; s < tile->end; s++) {
        fronts->culled[s] = is_empty(fronts, s);
        if (!fronts->culled[s] && !front_add(fronts, scratch, tile, s))
            return false;
    }
    return true;
}

/* Adds the fronts of a tile's solids, nearest first. A solid is culled if earlier ones cover it. Each of the others is
 * mapped one turn later, so that its memory can be fetched meanwhile. False: no memory. */
static bool do_tile(build *b, front_scratch *scratch, front_tile *tile)
{
    hide_fronts *fronts = b->fronts;
    uint32_t waiting = ROBERTS_NONE;
    if (!b->tiles.solid)
        return do_tile_in_order(fronts, scratch, tile);
    if (!tiles_order(&b->tiles, tile, fronts))
        return false;
    for (uint32_t k = tile->first; k < tile->end; k++) {
        if (cull_first(fronts, tile, b->tiles.solid + k, tile->end - k))
            continue;
        uint32_t s = let_wait(fronts, b->tiles.solid[k]);
        if (waiting != ROBERTS_NONE && !front_add(fronts, scratch, tile, waiting))
            return false;
        waiting = s;
    }
    return waiting == ROBERTS_NONE || front_add(fronts, scratch, tile, waiting);
}

/* Culls a solid that is mapped and counted already. */
static void cull_late(hide_fronts *fronts, front_tile *tile, uint32_t s)
{
    const scene_solid *solid = &fronts->scene->solid[s];
    fronts->culled[s] = true;
    tile->culled++;
    for (uint32_t face = solid->face; face < solid[1].face; face++) {
        tile->faces -= fronts->seen->facing[face] == VIEW_FRONT;
        tile->back -= fronts->seen->facing[face] == VIEW_BACK;
        tile->edge_on -= fronts->seen->facing[face] == VIEW_EDGE_ON;
    }
}

/* Tests again whether the solids of a tile are hidden, now that all covers are known. */
static void cull_again(hide_fronts *fronts, const tiles *t, front_tile *tile)
{
    for (uint32_t k = tile->first_whole; k < tile->whole; k++) {
        const hide_front *front = &fronts->front[k];
        if (cover_hides_solid(fronts, &fronts->front_box[k], front->solid))
            cull_late(fronts, tile, front->solid);
    }
    for (size_t k = 0; k < tile->single_count; k++) {
        uint32_t s = tile->single[k].solid;
        if ((k == 0 || s != tile->single[k - 1].solid) && cover_hides_solid(fronts, &fronts->box[s], s))
            cull_late(fronts, tile, s);
    }
    for (uint32_t k = tile->first; k < tile->end && tile->surface > tile->first_surface; k++) {
        uint32_t s = t->solid[k];
        if (!scene_is_convex(fronts->scene, s) && !fronts->culled[s] && cover_hides_solid(fronts, &fronts->box[s], s))
            cull_late(fronts, tile, s);
    }
}

/* The tiles of one round. */
typedef struct tile_round {
    build *b;
    front_tile *tile;
} tile_round;

static bool do_some_tiles(void *context, size_t first, size_t end)
{
    const tile_round *r = context;
    for (size_t i = first; i < end; i++)
        if (!do_tile(r->b, &r->b->scratch[thread_self()], &r->tile[i]))
            return false;
    return true;
}

static bool cull_some_again(void *context, size_t first, size_t end)
{
    build *b = context;
    for (size_t i = first; i < end; i++)
        cull_again(b->fronts, &b->tiles, &b->tiles.tile[i]);
    return true;
}

/* Adds the fronts of all solids, round by round. False: no memory. */
static bool do_tiles(build *b)
{
    const tiles *t = &b->tiles;
    for (int r = 0; r < TILE_ROUNDS; r++)
        if (!threads_each(b->threads, t->round[r + 1] - t->round[r], 1, do_some_tiles,
                          &(tile_round){b, t->tile + t->round[r]}))
            return false;
    return !b->fronts->cover.depth || threads_each(b->threads, t->count, 1, cull_some_again, b);
}

/* Moves those of the fronts first..end-1 that are not culled to *to and the places behind it. */
static void close_up(hide_fronts *fronts, uint32_t first, uint32_t end, uint32_t *to)
{
    for (uint32_t k = first; k < end; k++) {
        if (fronts->culled[fronts->front[k].solid])
            continue;
        if (k != *to) {
            fronts->front[*to] = fronts->front[k];
            fronts->front_box[*to] = fronts->front_box[k];
            if (k < fronts->convex_count)
                fronts->whole[*to] = fronts->whole[k];
        }
        ++*to;
    }
}

/* Closes the gaps between the whole fronts of all tiles. */
static void close_up_wholes(hide_fronts *fronts, const tiles *t)
{
    for (uint32_t i = 0; i < t->count; i++)
        close_up(fronts, t->tile[i].first_whole, t->tile[i].whole, &fronts->whole_count);
    fronts->front_count = fronts->whole_count;
}

static size_t count_singles(const hide_fronts *fronts, const tiles *t)
{
    size_t count = 0;
    for (uint32_t i = 0; i < t->count; i++)
        for (size_t k = 0; k < t->tile[i].single_count; k++)
            count += !fronts->culled[t->tile[i].single[k].solid];
    return count;
}

/* Adds the single faces behind the whole fronts: first those of convex solids, then those of other bodies. The latter
 * are in the array already, but may have to move. False: no memory. */
static bool add_singles(hide_fronts *fronts, const tiles *t)
{
    uint32_t first = fronts->convex_count, end = first, to = fronts->whole_count;
    size_t before = to + count_singles(fronts, t), room = fronts->room, box_room = room;
    for (uint32_t i = 0; i < t->count; i++)
        close_up(fronts, t->tile[i].first_surface, t->tile[i].surface, &end);
    size_t surfaces = end - first, count = before + surfaces;
    if (count > UINT32_MAX || !array_reserve(&fronts->front, &room, count, sizeof *fronts->front) ||
        !array_reserve(&fronts->front_box, &box_room, count, sizeof *fronts->front_box))
        return false;
    if (before != first && surfaces > 0) {
        memmove(fronts->front + before, fronts->front + first, surfaces * sizeof *fronts->front);
        memmove(fronts->front_box + before, fronts->front_box + first, surfaces * sizeof *fronts->front_box);
    }
    for (uint32_t i = 0; i < t->count; i++)
        for (size_t k = 0; k < t->tile[i].single_count; k++) {
            if (fronts->culled[t->tile[i].single[k].solid])
                continue;
            fronts->front[to] = t->tile[i].single[k];
            fronts->front_box[to++] = t->tile[i].single_box[k];
        }
    fronts->front_count = (uint32_t)count;
    return true;
}

/* Returns hide_fronts.thickest. A front's `depth` lies below its farthest corner by the distance from a face beyond
 * which points do not touch it. */
static double thickest(const hide_fronts *fronts)
{
    double most = 0.0;
    for (uint32_t k = 0; k < fronts->front_count; k++) {
        const hide_front *front = &fronts->front[k];
        double own = hide_is_face(front) ? INFINITY : (double)fronts->front_box[k].z1 - (double)fronts->whole[k].depth;
        most = greater(most, own);
    }
    return most;
}

static void add_counts(hide_fronts *fronts, const tiles *t)
{
    for (uint32_t i = 0; i < t->count; i++) {
        const front_tile *from = &t->tile[i];
        fronts->face_count += from->faces;
        fronts->back += from->back;
        fronts->edge_on += from->edge_on;
        fronts->culled_count += from->culled;
        fronts->hull_gap = greater(fronts->hull_gap, from->hull_gap);
        if (from->most_corners > fronts->most_corners)
            fronts->most_corners = from->most_corners;
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

/* Allocates the arrays of the threads, with extra room so that they lie apart, and the tables of bundles and runs, if
 * some solid can have any. False: no memory. */
static bool alloc_scratch(build *b)
{
    hide_fronts *fronts = b->fronts;
    const roberts_scene *scene = fronts->scene;
    uint32_t most = most_vertices(scene);
    bool asked = scene->solid_count > 1 || b->looked_up; /* are the faces of a solid tested at all? */
    if (most > BUNDLE_FACES / 2 && asked && !bundle_table_init(&fronts->bundles, scene->face_count))
        return false; /* a solid has less than twice as many faces as vertices */
    if (most > RUNS_CORNERS && asked &&
        (!runs_table_init(&fronts->face_runs, scene->corner, scene->face_start[scene->face_count]) ||
         !runs_table_init(&fronts->outline_runs, fronts->outline, scene->vertex_count)))
        return false;
    b->scratch = alloc_zeroed((size_t)b->threads, sizeof *b->scratch);
    for (int i = 0; b->scratch && i < b->threads; i++) {
        b->scratch[i].next = alloc_array((size_t)most + THREADS_APART, sizeof *b->scratch[i].next);
        if (!b->scratch[i].next || !scan_init(&b->scratch[i].cover.scan, fronts->cover.frame.nx))
            return false;
    }
    return b->scratch != NULL;
}

static void free_scratch(build *b)
{
    for (int i = 0; b->scratch && i < b->threads; i++) {
        free(b->scratch[i].next);
        cover_scratch_free(&b->scratch[i].cover);
    }
    free(b->scratch);
}

/* ---- copies: fronts of solids at the very same place ---- */

/* Do two whole fronts have exactly the same faces? Then they hide the same, and neither hides anything of the other. */
static bool same_front(const hide_fronts *fronts, uint32_t a, uint32_t b)
{
    const hide_whole_front *f = &fronts->whole[a], *g = &fronts->whole[b];
    if (f->face_count != g->face_count || f->corners != g->corners || fronts->front[a].kind != fronts->front[b].kind ||
        memcmp(&fronts->front_box[a], &fronts->front_box[b], sizeof(hide_box)) != 0)
        return false;
    for (uint32_t i = 0; i < f->corners; i++) {
        const uint32_t p = fronts->outline[f->outline + i], q = fronts->outline[g->outline + i];
        if (!vec3_same(fronts->P[p], fronts->P[q]))
            return false;
    }
    for (uint32_t i = 0; i < f->face_count; i++) {
        plane F = fronts->face[f->face + i].F, G = fronts->face[g->face + i].F;
        if (F.a != G.a || F.b != G.b || F.c != G.c || F.d != G.d ||
            fronts->face[f->face + i].touch != fronts->face[g->face + i].touch)
            return false;
    }
    return true;
}

/* Returns a key that is different for most fronts that are not copies. */
static uint32_t place_key(const hide_fronts *fronts, uint32_t front)
{
    return bits_hash(&fronts->front_box[front], sizeof fronts->front_box[front]);
}

/* Leaves a copy out of the lists, and links it to the first front at its place. False: no memory. */
static bool add_copy(hide_fronts *fronts, uint32_t first, uint32_t copy)
{
    if (!fronts->next_copy) {
        fronts->next_copy = alloc_array(fronts->front_count, sizeof *fronts->next_copy);
        for (uint32_t i = 0; fronts->next_copy && i < fronts->front_count; i++)
            fronts->next_copy[i] = ROBERTS_NONE;
    }
    if (!fronts->next_copy)
        return false;
    fronts->front[copy].listed = false;
    fronts->next_copy[copy] = fronts->next_copy[first];
    fronts->next_copy[first] = copy;
    return true;
}

/* Sets `listed` and `next_copy` of the whole fronts. Among copies, only the one with the smallest number is listed: a
 * thousand listed copies would cost a million tests. Sorting the keys in a stable way brings copies together. False: no
 * memory. */
static bool leave_out_copies(hide_fronts *fronts)
{
    const uint32_t count = fronts->front_count;
    uint32_t *key = alloc_array(count, sizeof *key), *order = alloc_array(count, sizeof *order), last = ROBERTS_NONE;
    for (uint32_t i = 0; key && i < count; i++) {
        fronts->front[i].listed = true;
        key[i] = place_key(fronts, i);
    }
    bool done = key && order && radix_order(key, count, order);
    for (uint32_t k = 0; done && k < count; k++) {
        const uint32_t i = order[k];
        if (last != ROBERTS_NONE && key[last] == key[i] && same_front(fronts, last, i))
            done = add_copy(fronts, last, i);
        else
            last = i;
    }
    free(key);
    free(order);
    return done;
}

/* ---- all of it ---- */

static bool add_solids(build *b)
{
    hide_fronts *fronts = b->fronts;
    bool done = alloc_scratch(b) && tiles_make(&b->tiles, fronts, b->threads) && do_tiles(b);
    if (done) {
        close_up_wholes(fronts, &b->tiles);
        add_counts(fronts, &b->tiles);
        done = leave_out_copies(fronts) && add_singles(fronts, &b->tiles);
        fronts->thickest = b->looked_up ? thickest(fronts) : INFINITY;
    }
    tiles_free(&b->tiles);
    free_scratch(b);
    return done;
}

static void count_convex(hide_fronts *fronts, uint32_t *other_faces)
{
    const roberts_scene *scene = fronts->scene;
    fronts->convex_count = scene->surface ? 0 : scene->solid_count;
    *other_faces = 0;
    for (uint32_t s = 0; scene->surface && s < scene->solid_count; s++)
        if (scene_is_convex(scene, s))
            fronts->convex_count++;
        else
            *other_faces += scene->solid[s + 1].face - scene->solid[s].face;
}

/* Only a part of the faces and of the outlines is ever written. The rest costs no memory, because it is never
 * touched. */
static bool alloc_fronts(build *b)
{
    hide_fronts *fronts = b->fronts;
    const roberts_scene *scene = fronts->scene;
    uint32_t other_faces;
    count_convex(fronts, &other_faces);
    fronts->room = (size_t)fronts->convex_count + other_faces;
    fronts->box = alloc_array(scene->solid_count, sizeof *fronts->box);
    fronts->culled = alloc_zeroed(scene->solid_count, sizeof *fronts->culled);
    fronts->face = alloc_sparse(scene->face_count - other_faces, sizeof *fronts->face);
    fronts->whole = alloc_array(fronts->convex_count, sizeof *fronts->whole);
    fronts->front = alloc_array(fronts->room, sizeof *fronts->front);
    fronts->front_box = alloc_array(fronts->room, sizeof *fronts->front_box);
    fronts->outline = alloc_sparse(scene->vertex_count, sizeof *fronts->outline);
    /* NOLINTNEXTLINE(bugprone-sizeof-expression): an array of pointers */
    if (b->cull && scene->surface && !(fronts->own = alloc_zeroed(scene->solid_count, sizeof *fronts->own)))
        return false;
    if (b->late && (!(fronts->late = alloc_zeroed(scene->solid_count, sizeof *fronts->late)) ||
                    !(fronts->rear = alloc_zeroed(scene->solid_count, sizeof *fronts->rear))))
        return false;
    return fronts->box && fronts->culled && fronts->face && fronts->whole && fronts->front && fronts->front_box &&
           fronts->outline;
}

static void set_space(hide_fronts *fronts)
{
    const view *v = &fronts->seen->view;
    fronts->P = fronts->seen->P;
    fronts->space = (hide_space){.P = fronts->P,
                                 .epsilon = v->epsilon,
                                 .across_rounding = v->across_rounding,
                                 .rounding = v->rounding,
                                 .plain = hide_plain(4.0 * v->across, v->epsilon, v->across_rounding),
                                 .scene = fronts->scene,
                                 .view = v};
}

/* Returns the cells of the covers. In a part of a scene they are those of the whole, so that the same bodies are
 * culled: the ends of lines may depend on that in the last digit. */
static scan_frame cover_frame(const hide_fronts *fronts, int threads)
{
    const scene_whole *whole = fronts->scene->whole;
    const double margin = hide_margin(&fronts->space);
    if (whole)
        return cells_of_whole(whole, margin);
    return cells_for_covers(&(cells_boxes){fronts->box, fronts->scene->solid_count, fronts->low, fronts->high, margin},
                            fronts->scene->vertex_count, threads);
}

static bool begin_covers(hide_fronts *fronts, scan_frame frame, int threads)
{
    return fronts->scene->whole ? cover_init_part(&fronts->cover, frame, fronts->low, fronts->high)
                                : cover_init(&fronts->cover, frame, threads);
}

bool hide_fronts_build(hide_fronts *fronts, seen *s, const roberts_hide_options *options, bool looked_up)
{
    const roberts_scene *scene = s->scene;
    bool cull = !options->keep_hidden, mesh = scene->surface && scene->surface->bend && !s->clip.clipped;
    build b = {.fronts = fronts,
               .threads = threads_for(options->threads, 1 + scene->solid_count / SOLIDS_PER_THREAD),
               .looked_up = looked_up || !cull,
               .cull = cull,
               .late = cull && mesh};
    *fronts = (hide_fronts){.seen = s, .scene = scene, .waits = b.late};
    scan_frame frame = {0};
    bool done = seen_begin_points(s) && alloc_fronts(&b) && box_solids(fronts, b.threads);
    if (done) {
        set_space(fronts);
        if (cull)
            frame = cover_frame(fronts, b.threads);
    }
    if (done && begin_covers(fronts, frame, b.threads) && add_solids(&b))
        return true;
    hide_fronts_free(fronts);
    return false;
}

static bool keep_some(void *context, size_t first, size_t end)
{
    const hide_fronts *fronts = context;
    for (size_t k = first; k < end; k++) {
        uint32_t turned[SEEN_TURNED] = {0};
        const hide_face outline = hide_outline(fronts, (uint32_t)k, turned);
        for (uint32_t i = 0; i < 5; i++) {
            const roberts_vec3 *P = &fronts->P[outline.corner[i % 3]];
            fronts->triangle[k].x[i] = outline.count == 3 ? (float)P->x : NAN;
            fronts->triangle[k].y[i] = outline.count == 3 ? (float)P->y : NAN;
        }
    }
    return true;
}

bool hide_fronts_keep(hide_fronts *fronts, uint32_t threads)
{
    fronts->triangle = alloc_array(fronts->front_count, sizeof *fronts->triangle);
    return fronts->triangle && threads_each(threads_for(threads, 1 + fronts->front_count / SOLIDS_PER_THREAD),
                                            fronts->front_count, 0, keep_some, fronts);
}

void hide_fronts_drop_boxes(hide_fronts *fronts)
{
    if (fronts->front_count > fronts->whole_count)
        return;
    free(fronts->box);
    fronts->box = NULL;
}

void hide_fronts_free(hide_fronts *fronts)
{
    free(fronts->box);
    free(fronts->culled);
    free(fronts->late);
    free(fronts->rear);
    free(fronts->face);
    free(fronts->whole);
    free(fronts->front);
    free(fronts->front_box);
    free(fronts->triangle);
    free(fronts->outline);
    free(fronts->next_copy);
    runs_table_free(&fronts->face_runs);
    runs_table_free(&fronts->outline_runs);
    bundle_table_free(&fronts->bundles);
    cover_free(&fronts->cover);
    for (uint32_t s = 0; fronts->own && s < fronts->scene->solid_count; s++)
        if (fronts->own[s]) {
            cover_free(fronts->own[s]);
            free(fronts->own[s]);
        }
    free(fronts->own);
    *fronts = (hide_fronts){0};
}
