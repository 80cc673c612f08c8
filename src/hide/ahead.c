/* ahead.c - see ahead.h. */
#include "hide/ahead.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/bits.h"
#include "base/sort.h"

/* Fewer solids than this do not leave the cache. */
#define MANY_SOLIDS 32768
/* The picture is counted in so many columns and rows for the order... */
#define SIDE 1024
/* ... and if one solid lies on average farther than this from the last, the file has them as they come. Rows, heaps and
 * lattices that were built one beside the other have less than 30, random ones more than 600. */
#define FAR_APART 100.0
/* ... or if as many boxes as this lie over a point of the picture: what lies behind one another lies anywhere in the file. In
 * flat scenes the order costs a fifth of hiding, in deep ones it saves a fourth to a half. */
#define DEEP 2.5

/* Solids between asking for what is kept of one and needing it; twice as many before, where it is. */
#define RECALLS_AHEAD 4

static double apart(uint32_t a, uint32_t b)
{
    return a < b ? b - a : a - b;
}

/* Fills `key` so that the solids' order follows the Z-order curve through the picture. Gives how far one is from the last, on
 * average. */
static double find_keys(const hide_picture *picture, uint32_t *key)
{
    uint32_t count = picture->scene->solid_count, last_i = 0, last_j = 0;
    double way = 0.0;
    scan_frame frame = scan_frame_over(picture->low, picture->high, SIDE, SIDE, hide_margin(&picture->space));
    for (uint32_t s = 0; s < count; s++) {
        const hide_box *box = &picture->box[s];
        uint32_t i = scan_column(&frame, 0.5 * ((double)box->x0 + (double)box->x1));
        uint32_t j = scan_row(&frame, 0.5 * ((double)box->y0 + (double)box->y1));
        way += apart(i, last_i) + apart(j, last_j);
        key[s] = bits_spread(i) << 1 | bits_spread(j);
        last_i = i;
        last_j = j;
    }
    return way / count;
}

bool ahead_init(ahead *a, const hide_picture *picture, double depth)
{
    *a = (ahead){.count = picture->scene->solid_count};
    if (a->count < MANY_SOLIDS)
        return true;
    uint32_t *key = alloc_array(a->count, sizeof *key);
    if (!key)
        return false;
    bool far = find_keys(picture, key) > FAR_APART, done = true;
    if (far || depth > DEEP) {
        a->order = alloc_array(a->count, sizeof *a->order);
        a->place = alloc_array(a->count, sizeof *a->place);
        a->chunks = (a->count + AHEAD_CHUNK - 1) / AHEAD_CHUNK;
        a->chunk = alloc_zeroed(a->chunks, sizeof *a->chunk);
        done = a->order && a->place && a->chunk && radix_order(key, a->count, a->order);
        for (uint32_t k = 0; done && k < a->count; k++)
            a->place[a->order[k]] = k;
    }
    free(key);
    return done;
}

void ahead_free(ahead *a)
{
    for (uint32_t c = 0; a->chunk && c < a->chunks; c++) {
        free(a->chunk[c].line);
        free(a->chunk[c].t);
        free(a->chunk[c].by);
    }
    free(a->order);
    free(a->place);
    free(a->chunk);
    *a = (ahead){0};
}

static bool wholly_hidden(const hide_line *line)
{
    return line->hidden ||
           (line->parts.count == 1 && line->parts.item[0].part.t0 == 0.0 && line->parts.item[0].part.t1 == 1.0);
}

static bool keep_line(ahead_chunk *c, const hide_line *line, bool all)
{
    size_t parts = line->parts.count, first = c->part_count, end = first + parts;
    if (!array_reserve(&c->line, &c->line_room, c->line_count + 1, sizeof *c->line) ||
        !array_reserve(&c->t, &c->t_room, 2 * end, sizeof *c->t) ||
        (all && !array_reserve(&c->by, &c->by_room, end, sizeof *c->by)) || parts > UINT32_MAX || end > UINT32_MAX)
        return false;
    c->line[c->line_count++] = (ahead_line){line->edge, (uint32_t)parts};
    for (size_t i = 0; i < parts; i++) {
        c->t[2 * (first + i)] = line->parts.item[i].part.t0;
        c->t[2 * (first + i) + 1] = line->parts.item[i].part.t1;
        if (all)
            c->by[first + i] = line->parts.item[i].solid;
    }
    c->part_count = end;
    return true;
}

/* An array that cannot be made smaller stays as it is. */
static void *shrunk(void *array, size_t size)
{
    void *smaller = size ? realloc(array, size) : NULL;
    return smaller ? smaller : array;
}

/* What a chunk has not used. */
static void shrink(ahead_chunk *c)
{
    c->line = shrunk(c->line, c->line_count * sizeof *c->line);
    c->t = shrunk(c->t, 2 * c->part_count * sizeof *c->t);
    if (c->by)
        c->by = shrunk(c->by, c->part_count * sizeof *c->by);
}

bool ahead_keep(ahead *a, uint32_t place, const hide_worker *w)
{
    ahead_chunk *c = &a->chunk[place / AHEAD_CHUNK];
    uint32_t k = place % AHEAD_CHUNK;
    for (size_t i = 0; i < w->line_count; i++)
        if ((w->all || !wholly_hidden(&w->line[i])) && !keep_line(c, &w->line[i], w->all))
            return false;
    c->first_line[k + 1] = (uint32_t)c->line_count;
    c->first_part[k + 1] = (uint32_t)c->part_count;
    if (k + 1 == AHEAD_CHUNK || place + 1 == a->count)
        shrink(c);
    return true;
}

void ahead_fetch(const ahead *a, uint32_t solid)
{
    if (a->count - solid <= 2 * RECALLS_AHEAD)
        return;
    uint32_t later = a->place[solid + 2 * RECALLS_AHEAD], sooner = a->place[solid + RECALLS_AHEAD];
    const ahead_chunk *c = &a->chunk[later / AHEAD_CHUNK];
    FETCH_AHEAD(c);
    FETCH_AHEAD(&c->first_line[later % AHEAD_CHUNK]);
    FETCH_AHEAD(&c->first_part[later % AHEAD_CHUNK]);
    c = &a->chunk[sooner / AHEAD_CHUNK];
    uint32_t k = sooner % AHEAD_CHUNK;
    size_t lines = c->first_line[k + 1] - c->first_line[k], parts = c->first_part[k + 1] - c->first_part[k];
    if (lines)
        FETCH_ARRAY(c->line + c->first_line[k], lines * sizeof *c->line);
    if (parts)
        FETCH_ARRAY(c->t + 2 * (size_t)c->first_part[k], 2 * parts * sizeof *c->t);
}

bool ahead_recall(const ahead *a, uint32_t solid, hide_worker *w)
{
    const roberts_scene *scene = w->picture->scene;
    const ahead_chunk *c = &a->chunk[a->place[solid] / AHEAD_CHUNK];
    uint32_t k = a->place[solid] % AHEAD_CHUNK, end = c->first_line[k + 1], part = c->first_part[k];
    hide_worker_begin(w);
    for (uint32_t i = c->first_line[k]; i < end; i++) {
        uint32_t edge = c->line[i].edge;
        hide_line *line = hide_worker_add(w, edge, scene_edge_stored(scene, solid, edge), scene->solid[solid].vertex);
        if (!line)
            return false;
        hide_parts *parts = &line->parts;
        if (!array_reserve(&parts->item, &parts->room, c->line[i].parts, sizeof *parts->item))
            return false;
        for (parts->count = 0; parts->count < c->line[i].parts; part++) {
            const double *t = c->t + 2 * (size_t)part;
            parts->item[parts->count++] = (hide_solid_part){{t[0], t[1], 0.0, 0.0}, c->by ? c->by[part] : ROBERTS_NONE};
        }
    }
    return true;
}
