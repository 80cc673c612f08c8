/* united.c - see united.h. Threads work on chunks of lines. Then their results are joined in the order of the lines. */
#include "view/united.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/threads.h"

enum { CHUNK_LINES = 512, CHUNKS_PER_THREAD = 2 };

/* The result of one chunk. */
typedef struct chunk {
    union_piece *piece;
    union_side *side;
    size_t piece_count, piece_room, side_count, side_room;
    bool lost; /* no memory */
} chunk;

typedef struct search {
    const union_bodies *all;
    united_line_fn *line_of;
    const void *context;
    uint32_t count;
    uint32_t *first; /* [count] counts from the pieces of the chunk */
} search;

/* Stores the pieces of one line, unless the union does not change the line. first: where the line's pieces begin. */
static bool keep_united(chunk *to, const union_work *work, uint32_t *first)
{
    if (work->piece_count == 1 && work->piece[0].state == UNION_ALONE)
        return true;
    if (!array_reserve(&to->piece, &to->piece_room, to->piece_count + work->piece_count, sizeof *to->piece) ||
        !array_reserve(&to->side, &to->side_room, to->side_count + work->side_count, sizeof *to->side))
        return false;
    *first = (uint32_t)to->piece_count;
    for (size_t i = 0; i < work->piece_count; i++) {
        union_piece piece = work->piece[i];
        piece.first += (uint32_t)to->side_count;
        to->piece[to->piece_count++] = piece;
    }
    for (size_t i = 0; i < work->side_count; i++)
        to->side[to->side_count++] = work->side[i];
    return true;
}

static uint32_t end_of(const search *s, uint32_t index)
{
    uint32_t begin = index * CHUNK_LINES;
    return s->count - begin < CHUNK_LINES ? s->count : begin + CHUNK_LINES;
}

static bool find_chunk(const search *s, uint32_t index, chunk *to)
{
    union_work work = {0};
    bool done = true;
    for (uint32_t i = index * CHUNK_LINES; i < end_of(s, index) && done; i++) {
        union_line line;
        uint32_t own[2];
        s->first[i] = ROBERTS_NONE;
        if (s->line_of(s->context, i, &line, own))
            done = union_cut(s->all, &line, &work) && keep_united(to, &work, &s->first[i]);
    }
    union_work_free(&work);
    return done;
}

/* Joins the results of the chunks, in order. */
static bool join_chunks(united *u, const search *s, const chunk *found, uint32_t chunks)
{
    size_t pieces = 0, sides = 0;
    for (uint32_t i = 0; i < chunks; i++) {
        if (found[i].lost)
            return false;
        pieces += found[i].piece_count;
        sides += found[i].side_count;
    }
    u->piece = alloc_array(pieces, sizeof *u->piece);
    u->side = alloc_array(sides, sizeof *u->side);
    if (!u->piece || !u->side || pieces >= ROBERTS_NONE || sides >= ROBERTS_NONE)
        return false;
    for (uint32_t i = 0; i < chunks; i++) {
        for (uint32_t k = i * CHUNK_LINES; k < end_of(s, i); k++)
            if (u->first[k] != ROBERTS_NONE)
                u->first[k] += (uint32_t)u->piece_count;
        size_t before = u->side_count;
        for (size_t k = 0; k < found[i].piece_count; k++) {
            u->piece[u->piece_count] = found[i].piece[k];
            u->piece[u->piece_count++].first += (uint32_t)before;
        }
        for (size_t k = 0; k < found[i].side_count; k++)
            u->side[u->side_count++] = found[i].side[k];
    }
    return true;
}

typedef struct chunk_search {
    const search *s;
    chunk *found; /* [chunks] */
} chunk_search;

static bool find_chunks(void *context, size_t first, size_t end)
{
    const chunk_search *c = context;
    for (size_t i = first; i < end; i++)
        c->found[i].lost = !find_chunk(c->s, (uint32_t)i, &c->found[i]);
    return true;
}

bool united_find(united *u, const union_bodies *all, united_line_fn *line_of, const void *context, uint32_t count,
                 uint32_t threads)
{
    uint32_t chunks = (uint32_t)(((size_t)count + CHUNK_LINES - 1) / CHUNK_LINES);
    chunk *found = alloc_zeroed(chunks, sizeof *found);
    *u = (united){.first = alloc_array(count, sizeof *u->first)};
    search s = {all, line_of, context, count, u->first};
    bool done = found && u->first;
    if (done) {
        threads_each(threads_for(threads, 1 + chunks / CHUNKS_PER_THREAD), chunks, 1, find_chunks,
                     &(chunk_search){&s, found});
        done = join_chunks(u, &s, found, chunks);
    }
    for (uint32_t i = 0; found && i < chunks; i++) {
        free(found[i].piece);
        free(found[i].side);
    }
    free(found);
    if (!done)
        united_free(u);
    return done;
}

void united_free(united *u)
{
    free(u->first);
    free(u->piece);
    free(u->side);
    *u = (united){0};
}

typedef struct edges_asked {
    const roberts_scene *scene;
    united_asked_fn *asked;
    const void *context;
} edges_asked;

static bool line_of_edge(const void *context, uint32_t index, union_line *line, uint32_t own[2])
{
    const edges_asked *edges = context;
    const roberts_scene *scene = edges->scene;
    uint32_t body = scene_body_of_edge(scene, index);
    if (!union_takes(scene, body) || !edges->asked(edges->context, body, index))
        return false;
    *line = union_line_of_edge(scene, body, index, own);
    return true;
}

bool united_find_edges(united *u, const union_bodies *all, united_asked_fn *asked, const void *context,
                       uint32_t threads)
{
    const edges_asked edges = {all->scene, asked, context};
    return united_find(u, all, line_of_edge, &edges, all->scene->edge_count, threads);
}

size_t united_seams(const united *u, uint32_t count)
{
    size_t seams = 0;
    for (uint32_t i = 0; u->first && i < count; i++) {
        const union_piece *p = united_pieces(u, i);
        bool seam = false;
        for (; p; p = p->t1 < 1.0 ? p + 1 : NULL)
            seam = seam || p->state == UNION_SEAM || p->state == UNION_INSIDE;
        seams += seam;
    }
    return seams;
}
