/* schedule.c - see schedule.h. */
#include "hide/schedule.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/bits.h"
#include "base/sort.h"

/* ---- tiles ---- */

/* The side of a tile in cells of covers: at least two mean boxes, mostly seven or more, and 128 kB of cells in all. */
#define TILE_CELLS 128
/* How far a solid may reach out of its tile, in cells. It reads covers within two cells of its box. */
#define TILE_REACH (TILE_CELLS / 2 - 2)
/* Solids of a tile if no covers are kept. */
#define TILE_SOLIDS 512

/* The tiles of each round r: number `first` and those that follow, `up` to a column. */
typedef struct layout {
    uint32_t first[TILE_ROUNDS], up[TILE_ROUNDS];
} layout;

static layout lay_out(tiles *t, const scan_frame *f)
{
    layout l = {{0}, {0}};
    uint32_t across = (f->nx - 1) / TILE_CELLS + 1, up = (f->ny - 1) / TILE_CELLS + 1;
    t->count = 1;
    for (uint32_t r = 1; r < TILE_ROUNDS; r++) {
        uint32_t i = (r - 1) / 2, j = (r - 1) % 2;
        l.first[r] = t->round[r] = t->count;
        l.up[r] = (up + 1 - j) / 2;
        t->count += (across + 1 - i) / 2 * l.up[r];
    }
    t->round[TILE_ROUNDS] = t->count;
    return l;
}

static bool within(uint32_t first, uint32_t last, uint32_t tile)
{
    return first + TILE_REACH >= tile * TILE_CELLS && last < (tile + 1) * TILE_CELLS + TILE_REACH;
}

static uint32_t tile_of(const layout *l, const scan_frame *f, const hide_box *box)
{
    uint32_t i = scan_column(f, 0.5 * ((double)box->x0 + (double)box->x1)) / TILE_CELLS;
    uint32_t j = scan_row(f, 0.5 * ((double)box->y0 + (double)box->y1)) / TILE_CELLS;
    if (!within(scan_column(f, (double)box->x0 - f->margin), scan_column(f, (double)box->x1 + f->margin), i) ||
        !within(scan_row(f, (double)box->y0 - f->margin), scan_row(f, (double)box->y1 + f->margin), j))
        return 0;
    uint32_t r = 1 + i % 2 * 2 + j % 2;
    return l->first[r] + i / 2 * l->up[r] + j / 2;
}

/* Sums over the solids of a tile. faces, vertices: of convex solids; surfaces: faces of other bodies. */
typedef struct tile_sizes {
    uint32_t solids, wholes, faces, vertices, surfaces;
} tile_sizes;

static void add_size(tile_sizes *of, const roberts_scene *scene, uint32_t s)
{
    uint32_t faces = scene->solid[s + 1].face - scene->solid[s].face;
    of->solids++;
    if (!scene_is_convex(scene, s)) {
        of->surfaces += faces;
        return;
    }
    of->wholes++;
    of->faces += faces;
    of->vertices += scene->solid[s + 1].vertex - scene->solid[s].vertex;
}

/* Gives each tile its part of the arrays. */
static void set_places(const tiles *t, const tile_sizes *size, const hide_fronts *fronts)
{
    tile_sizes sum = {.surfaces = fronts->convex_count};
    for (uint32_t k = 0; k < t->count; k++) {
        front_tile *to = &t->tile[k];
        to->first = to->end = sum.solids;
        to->first_whole = to->whole = sum.wholes;
        to->first_surface = to->surface = sum.surfaces;
        to->face = to->expected_face = sum.faces;
        to->end_face = sum.faces + size[k].faces;
        to->outline = sum.vertices;
        sum.solids += size[k].solids;
        sum.wholes += size[k].wholes;
        sum.surfaces += size[k].surfaces;
        sum.faces += size[k].faces;
        sum.vertices += size[k].vertices;
    }
}

typedef struct tile_search {
    const layout *l;
    const hide_fronts *fronts;
    uint32_t *own; /* [solids] */
} tile_search;

/* Finds the tile of each solid. */
static bool find_tiles(void *context, size_t first, size_t end)
{
    const tile_search *t = context;
    for (size_t s = first; s < end; s++)
        t->own[s] = tile_of(t->l, &t->fronts->cover.frame, &t->fronts->box[s]);
    return true;
}

static bool by_place(tiles *t, const hide_fronts *fronts, int threads)
{
    const roberts_scene *scene = fronts->scene;
    layout l = lay_out(t, &fronts->cover.frame);
    uint32_t *own = alloc_array(scene->solid_count, sizeof *own);
    tile_sizes *size = alloc_zeroed(t->count, sizeof *size);
    t->tile = alloc_zeroed(t->count, sizeof *t->tile);
    t->solid = alloc_array(scene->solid_count, sizeof *t->solid);
    bool done = own && size && t->tile && t->solid;
    if (done)
        threads_each(threads, scene->solid_count, 0, find_tiles, &(tile_search){&l, fronts, own});
    for (uint32_t s = 0; done && s < scene->solid_count; s++)
        add_size(&size[own[s]], scene, s);
    if (done)
        set_places(t, size, fronts);
    for (uint32_t s = 0; done && s < scene->solid_count; s++)
        t->solid[t->tile[own[s]].end++] = s;
    free(own);
    free(size);
    return done;
}

static bool by_number(tiles *t, const hide_fronts *fronts)
{
    const roberts_scene *scene = fronts->scene;
    t->count = scene->solid_count / TILE_SOLIDS + 1;
    t->round[1] = t->round[2] = t->round[3] = t->round[4] = t->round[5] = t->count;
    tile_sizes *size = alloc_zeroed(t->count, sizeof *size);
    t->tile = alloc_zeroed(t->count, sizeof *t->tile);
    bool done = size && t->tile;
    for (uint32_t s = 0; done && s < scene->solid_count; s++)
        add_size(&size[s / TILE_SOLIDS], scene, s);
    if (done)
        set_places(t, size, fronts);
    for (uint32_t k = 0; done && k < t->count; k++)
        t->tile[k].end += size[k].solids;
    free(size);
    return done;
}

bool tiles_make(tiles *t, const hide_fronts *fronts, int threads)
{
    *t = (tiles){0};
    return fronts->cover.depth ? by_place(t, fronts, threads) : by_number(t, fronts);
}

void tiles_free(tiles *t)
{
    for (uint32_t k = 0; t->tile && k < t->count; k++) {
        free(t->tile[k].single);
        free(t->tile[k].single_box);
    }
    free(t->tile);
    free(t->solid);
    *t = (tiles){0};
}

bool tiles_order(tiles *t, const front_tile *of, const hide_fronts *fronts)
{
    uint32_t count = of->end - of->first, *solid = t->solid + of->first;
    uint32_t *key = alloc_array(count, 3 * sizeof *key), *order, *sorted;
    if (!key)
        return false;
    order = key + count;
    sorted = order + count;
    for (uint32_t k = 0; k < count; k++)
        key[k] = radix_key_descending(fronts->box[solid[k]].z1);
    bool done = radix_order(key, count, order);
    for (uint32_t k = 0; done && k < count; k++)
        sorted[k] = solid[order[k]];
    if (done)
        memcpy(solid, sorted, count * sizeof *solid);
    free(key);
    return done;
}

/* ---- the order of the picture ---- */

/* Fewer solids than this stay in the cache. */
#define MANY_SOLIDS 32768
/* Columns and rows of the picture, for the order. */
#define SIDE 1024
/* If consecutive solids are farther apart than this on average, the order of the file does not help. Rows, heaps and
 * lattices that were built side by side have less than 30, random scenes more than 600. */
#define FAR_APART 100.0
/* It does not help either if more boxes than this lie over a point of the picture: solids behind one another lie
 * anywhere in the file. In flat scenes the order costs a fifth of hiding, in deep ones it saves a fourth to a half. */
#define DEEP 2.5

/* The kept lines of a solid are prefetched this many solids ahead; their addresses, twice as far ahead. */
#define RECALLS_AHEAD 4

static double apart(uint32_t a, uint32_t b)
{
    return a < b ? b - a : a - b;
}

/* Lists the solids that have lines, and fills `key` with their places on the Z-order curve through the picture. Returns
 * how far apart consecutive solids of the scene are on average. */
static double find_keys(const hide_fronts *fronts, uint32_t *listed, uint32_t *key, uint32_t *listed_count)
{
    uint32_t count = fronts->scene->solid_count, last_i = 0, last_j = 0;
    double way = 0.0;
    *listed_count = 0;
    scan_frame frame = scan_frame_over(fronts->low, fronts->high, SIDE, SIDE, hide_margin(&fronts->space));
    for (uint32_t s = 0; s < count; s++) {
        const hide_box *box = &fronts->box[s];
        uint32_t i = scan_column(&frame, 0.5 * ((double)box->x0 + (double)box->x1));
        uint32_t j = scan_row(&frame, 0.5 * ((double)box->y0 + (double)box->y1));
        way += apart(i, last_i) + apart(j, last_j);
        last_i = i;
        last_j = j;
        if (!hide_has_lines(fronts, s))
            continue;
        key[*listed_count] = bits_spread(i) << 1 | bits_spread(j);
        listed[(*listed_count)++] = s;
    }
    return way / count;
}

bool picture_order_init(picture_order *o, const hide_fronts *fronts, double depth)
{
    const uint32_t solids = fronts->scene->solid_count;
    *o = (picture_order){.solids = solids};
    if (solids < MANY_SOLIDS)
        return true;
    uint32_t *key = alloc_array(solids, sizeof *key), *listed = alloc_array(solids, sizeof *listed);
    bool done = key && listed, far = done && find_keys(fronts, listed, key, &o->count) > FAR_APART;
    if (done && (far || depth > DEEP)) {
        o->solid = alloc_array(o->count, sizeof *o->solid);
        o->place = alloc_array(solids, sizeof *o->place);
        o->chunks = (o->count + KEPT_SOLIDS - 1) / KEPT_SOLIDS;
        o->chunk = alloc_zeroed(o->chunks, sizeof *o->chunk);
        done = o->solid && o->place && o->chunk && radix_order(key, o->count, o->solid);
        for (uint32_t s = 0; done && s < solids; s++)
            o->place[s] = ROBERTS_NONE;
        for (uint32_t k = 0; done && k < o->count; k++) {
            o->solid[k] = listed[o->solid[k]];
            o->place[o->solid[k]] = k;
        }
    }
    free(key);
    free(listed);
    return done;
}

void picture_order_free(picture_order *o)
{
    for (uint32_t c = 0; o->chunk && c < o->chunks; c++) {
        free(o->chunk[c].line);
        free(o->chunk[c].t);
        free(o->chunk[c].by);
    }
    free(o->solid);
    free(o->place);
    free(o->chunk);
    *o = (picture_order){0};
}

static bool wholly_hidden(const hide_line *line)
{
    return line->hidden || (line->intervals.count == 1 && line->intervals.item[0].part.t0 == 0.0 &&
                            line->intervals.item[0].part.t1 == 1.0);
}

static bool keep_line(kept_chunk *c, const hide_line *line, bool all)
{
    size_t parts = line->intervals.count, first = c->part_count, end = first + parts;
    if (!array_reserve(&c->line, &c->line_room, c->line_count + 1, sizeof *c->line) ||
        !array_reserve(&c->t, &c->t_room, 2 * end, sizeof *c->t) ||
        (all && !array_reserve(&c->by, &c->by_room, end, sizeof *c->by)) || parts > UINT32_MAX || end > UINT32_MAX)
        return false;
    c->line[c->line_count++] = (kept_line){line->is.edge, (uint32_t)parts};
    for (size_t i = 0; i < parts; i++) {
        c->t[2 * (first + i)] = line->intervals.item[i].part.t0;
        c->t[2 * (first + i) + 1] = line->intervals.item[i].part.t1;
        if (all)
            c->by[first + i] = line->intervals.item[i].solid;
    }
    c->part_count = end;
    return true;
}

/* Shrinks an array if realloc() can. */
static void *shrunk(void *array, size_t size)
{
    void *smaller = size ? realloc(array, size) : NULL;
    return smaller ? smaller : array;
}

/* Frees the memory that a chunk has not used. */
static void shrink(kept_chunk *c)
{
    c->line = shrunk(c->line, c->line_count * sizeof *c->line);
    c->t = shrunk(c->t, 2 * c->part_count * sizeof *c->t);
    if (c->by)
        c->by = shrunk(c->by, c->part_count * sizeof *c->by);
}

bool picture_order_keep(picture_order *o, uint32_t place, const hide_worker *w)
{
    kept_chunk *c = &o->chunk[place / KEPT_SOLIDS];
    uint32_t k = place % KEPT_SOLIDS;
    for (size_t i = 0; i < w->line_count; i++)
        if ((w->all || !wholly_hidden(&w->line[i])) && !keep_line(c, &w->line[i], w->all))
            return false;
    c->first_line[k + 1] = (uint32_t)c->line_count;
    c->first_part[k + 1] = (uint32_t)c->part_count;
    if (k + 1 == KEPT_SOLIDS || place + 1 == o->count)
        shrink(c);
    return true;
}

void picture_order_fetch(const picture_order *o, uint32_t solid)
{
    if (o->solids - solid <= 2 * RECALLS_AHEAD)
        return;
    uint32_t later = o->place[solid + 2 * RECALLS_AHEAD], sooner = o->place[solid + RECALLS_AHEAD];
    if (later != ROBERTS_NONE) {
        const kept_chunk *far = &o->chunk[later / KEPT_SOLIDS];
        FETCH_AHEAD(far);
        FETCH_AHEAD(&far->first_line[later % KEPT_SOLIDS]);
        FETCH_AHEAD(&far->first_part[later % KEPT_SOLIDS]);
    }
    if (sooner == ROBERTS_NONE)
        return;
    const kept_chunk *c = &o->chunk[sooner / KEPT_SOLIDS];
    uint32_t k = sooner % KEPT_SOLIDS;
    size_t lines = c->first_line[k + 1] - c->first_line[k], parts = c->first_part[k + 1] - c->first_part[k];
    if (lines)
        FETCH_ARRAY(c->line + c->first_line[k], lines * sizeof *c->line);
    if (parts)
        FETCH_ARRAY(c->t + 2 * (size_t)c->first_part[k], 2 * parts * sizeof *c->t);
}

bool picture_order_recall(const picture_order *o, uint32_t solid, hide_worker *w)
{
    const kept_chunk *c = &o->chunk[o->place[solid] / KEPT_SOLIDS];
    seen_walk walk = seen_walk_begin(w->fronts->seen, solid);
    uint32_t k = o->place[solid] % KEPT_SOLIDS, end = c->first_line[k + 1], part = c->first_part[k];
    hide_worker_begin(w, walk.key);
    if (!hide_worker_reserve(w, end - c->first_line[k]))
        return false;
    for (uint32_t i = c->first_line[k]; i < end; i++) {
        hide_line *line = &w->line[w->line_count];
        seen_again(&walk, c->line[i].edge, &line->is);
        if (line->is.taken & SEEN_TAKEN)
            hide_worker_add_taken(w, line);
        else
            hide_worker_add(w, line);
        hide_intervals *intervals = &line->intervals;
        if (!array_reserve(&intervals->item, &intervals->room, c->line[i].parts, sizeof *intervals->item))
            return false;
        for (intervals->count = 0; intervals->count < c->line[i].parts; part++) {
            const double *t = c->t + 2 * (size_t)part;
            intervals->item[intervals->count++] =
                (hide_solid_interval){{t[0], t[1], 0.0, 0.0}, c->by ? c->by[part] : ROBERTS_NONE};
        }
    }
    return true;
}

/* ---- chunks ---- */

/* At the end, threads wait for the last run. So runs should be short: each thread has at least this many. */
#define RUNS_PER_THREAD 16

bool chunk_give(hide_chunk *chunk, const roberts_receiver *to)
{
    for (size_t i = 0; i < chunk->count && !chunk->stopped; i++) {
        chunk->stopped = !to->receive(to->context, &chunk->segment[i]);
        chunk->given += !chunk->stopped;
    }
    chunk->count = 0;
    return !chunk->stopped;
}

bool chunks_init(chunks *c, uint32_t total, int threads, roberts_drawing *drawing, const roberts_receiver *to)
{
    *c = (chunks){.total = total, .drawing = drawing, .to = to, .threads = threads};
    uint32_t fair = total / ((uint32_t)threads * RUNS_PER_THREAD);
    c->run = fair < 1 ? 1 : fair < CHUNKS_RUN ? fair : CHUNKS_RUN;
    c->queue = alloc_zeroed((size_t)threads, sizeof *c->queue);
    for (int i = 0; c->queue && i < threads; i++)
        for (uint32_t k = 0; k < CHUNKS_WAITING; k++)
            c->queue[i].spare[k] = &c->queue[i].chunk[k];
    return c->queue != NULL;
}

void chunks_free(chunks *c)
{
    for (int i = 0; c->queue && i < c->threads; i++)
        for (uint32_t k = 0; k < CHUNKS_WAITING; k++)
            free(c->queue[i].chunk[k].segment);
    free(c->queue);
    c->queue = NULL;
}

void chunks_fail(chunks *c, roberts_status status)
{
    int ok = ROBERTS_OK;
    atomic_compare_exchange_strong(&c->status, &ok, (int)status);
}

static bool goes_on(chunks *c)
{
    return atomic_load(&c->status) == ROBERTS_OK;
}

static void give_away(chunks *c, hide_chunk *chunk)
{
    const bool more = chunk_give(chunk, c->to);
    c->drawing->count += chunk->given;
    if (more)
        atomic_store(&c->turn, chunk->number + 1);
    else
        chunks_fail(c, ROBERTS_STOPPED); /* and no chunk has its turn: another thread may just have seen it go on */
}

/* Copies a chunk into the drawing. The drawing's array moves only while nobody writes to it. The next chunk gets its
 * turn before the copying, because copying mostly waits for the system to supply new memory. */
static void lay_down(chunks *c, const hide_chunk *chunk)
{
    size_t first = c->drawing->count, total = first + chunk->count;
    if (total > c->room) {
        for (unsigned turn = 0; atomic_load(&c->copying); turn++)
            thread_wait(turn);
        if (!array_reserve(&c->drawing->segment, &c->room, total, sizeof *c->drawing->segment)) {
            chunks_fail(c, ROBERTS_NO_MEMORY);
            return;
        }
    }
    roberts_segment *to = c->drawing->segment + first;
    c->drawing->count = total;
    atomic_fetch_add(&c->copying, 1);
    atomic_store(&c->turn, chunk->number + 1);
    if (chunk->count)
        memcpy(to, chunk->segment, chunk->count * sizeof *chunk->segment);
    atomic_fetch_sub(&c->copying, 1);
}

/* Gives away, or copies, the chunks of this thread whose turn has come, and frees them. */
static void settle(chunks *c, chunk_queue *own)
{
    for (; own->count && goes_on(c); own->first = (own->first + 1) % CHUNKS_WAITING) {
        hide_chunk *chunk = own->waiting[own->first];
        if (chunk->number != atomic_load(&c->turn))
            break;
        if (c->to)
            give_away(c, chunk);
        else
            lay_down(c, chunk);
        own->count--;
        own->spare[CHUNKS_WAITING - 1 - own->count] = chunk;
    }
}

/* Waits until no more than `most` of the thread's chunks wait for their turn. */
static void wait_for_turns(chunks *c, chunk_queue *own, uint32_t most)
{
    for (unsigned turn = 0; own->count > most && goes_on(c); turn++) {
        thread_wait(turn);
        settle(c, own);
    }
}

/* Takes the next run for this thread, if there is one. */
static void take_run(chunks *c, chunk_queue *own)
{
    uint32_t run_count = (c->total + c->run - 1) / c->run;
    uint32_t k = atomic_load(&c->taken) < run_count ? atomic_fetch_add(&c->taken, 1) : run_count;
    if (k >= run_count)
        return;
    own->next = k * c->run;
    own->end = c->total - own->next < c->run ? c->total : own->next + c->run;
}

hide_chunk *chunks_take(chunks *c, int self)
{
    chunk_queue *own = &c->queue[self];
    wait_for_turns(c, own, CHUNKS_WAITING - 1);
    if (own->next == own->end)
        take_run(c, own);
    if (own->next == own->end)
        wait_for_turns(c, own, 0);
    if (own->next == own->end || !goes_on(c))
        return NULL;
    hide_chunk *chunk = own->spare[CHUNKS_WAITING - 1 - own->count];
    chunk->number = own->next++;
    chunk->count = chunk->given = 0;
    return chunk;
}

void chunks_done(chunks *c, int self, hide_chunk *chunk)
{
    chunk_queue *own = &c->queue[self];
    own->waiting[(own->first + own->count++) % CHUNKS_WAITING] = chunk;
    settle(c, own);
}
