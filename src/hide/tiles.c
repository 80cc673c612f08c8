/* tiles.c - see tiles.h. */
#include "hide/tiles.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/sort.h"

/* Side of a tile in cells of covers: at least seven mean boxes, 128 kB of cells. */
#define TILE_CELLS 128
/* How far a solid may reach out of its tile, in cells. What is asked of the covers is within two cells of its box. */
#define TILE_REACH (TILE_CELLS / 2 - 2)
/* Without covers, or of few: */
#define TILE_SOLIDS 512

/* Tiles of one round, those of every other column and row beginning with (i, j). */
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

/* Counts of solids, faces and vertices become places. */
static void set_places(tiles *t)
{
    uint32_t first = 0, face = 0, outline = 0;
    for (uint32_t k = 0; k < t->count; k++) {
        picture_tile *to = &t->tile[k];
        uint32_t solids = to->end, faces = to->face, vertices = to->outline;
        to->first = to->end = to->front = first;
        to->face = face;
        to->outline = outline;
        first += solids;
        face += faces;
        outline += vertices;
    }
}

/* The tile of each solid. */
static void find_tiles(const layout *l, const hide_picture *picture, uint32_t *own, int threads)
{
    uint32_t count = picture->scene->solid_count;
#ifdef _OPENMP
#pragma omp parallel for schedule(static) num_threads(threads)
#else
    (void)threads;
#endif
    for (uint32_t s = 0; s < count; s++)
        own[s] = tile_of(l, &picture->cover.frame, &picture->box[s]);
}

static bool by_place(tiles *t, const hide_picture *picture, int threads)
{
    const roberts_scene *scene = picture->scene;
    layout l = lay_out(t, &picture->cover.frame);
    uint32_t *own = alloc_array(scene->solid_count, sizeof *own);
    t->tile = alloc_zeroed(t->count, sizeof *t->tile);
    t->solid = alloc_array(scene->solid_count, sizeof *t->solid);
    bool done = own && t->tile && t->solid;
    if (done)
        find_tiles(&l, picture, own, threads);
    for (uint32_t s = 0; done && s < scene->solid_count; s++) {
        picture_tile *to = &t->tile[own[s]];
        to->end++;
        to->face += scene->solid[s + 1].face - scene->solid[s].face;
        to->outline += scene->solid[s + 1].vertex - scene->solid[s].vertex;
    }
    if (done)
        set_places(t);
    for (uint32_t s = 0; done && s < scene->solid_count; s++)
        t->solid[t->tile[own[s]].end++] = s;
    free(own);
    return done;
}

static bool by_number(tiles *t, const hide_picture *picture)
{
    const roberts_scene *scene = picture->scene;
    t->count = scene->solid_count / TILE_SOLIDS + 1;
    t->round[1] = t->round[2] = t->round[3] = t->round[4] = t->round[5] = t->count;
    t->tile = alloc_zeroed(t->count, sizeof *t->tile);
    for (uint32_t k = 0; t->tile && k < t->count; k++) {
        uint32_t first = k * TILE_SOLIDS, left = scene->solid_count - first;
        t->tile[k] = (picture_tile){.first = first,
                                    .end = first + (left < TILE_SOLIDS ? left : TILE_SOLIDS),
                                    .front = first,
                                    .face = scene->solid[first].face,
                                    .outline = scene->solid[first].vertex};
    }
    return t->tile != NULL;
}

bool tiles_make(tiles *t, const hide_picture *picture, int threads)
{
    *t = (tiles){0};
    return picture->cover.depth ? by_place(t, picture, threads) : by_number(t, picture);
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

bool tiles_order(tiles *t, const picture_tile *of, const hide_picture *picture)
{
    uint32_t count = of->end - of->first, *solid = t->solid + of->first;
    uint32_t *key = alloc_array(count, 3 * sizeof *key), *order, *sorted;
    if (!key)
        return false;
    order = key + count;
    sorted = order + count;
    for (uint32_t k = 0; k < count; k++)
        key[k] = radix_key_descending(picture->box[solid[k]].z1);
    bool done = radix_order(key, count, order);
    for (uint32_t k = 0; done && k < count; k++)
        sorted[k] = solid[order[k]];
    if (done)
        memcpy(solid, sorted, count * sizeof *solid);
    free(key);
    return done;
}
