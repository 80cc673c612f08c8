/* united.c - see united.h. Threads take chunks of bodies; what they find is then laid down in the order of the chunks.
 */
#include "view/united.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/threads.h"

enum { CHUNK_BODIES = 64, CHUNKS_PER_THREAD = 2 };

/* What is found of one chunk. */
typedef struct chunk {
    union_piece *piece;
    union_side *side;
    size_t piece_count, piece_room, side_count, side_room;
    bool lost; /* no memory */
} chunk;

/* Keeps the answer about one edge, unless it is that nothing changes. first: where the edge's pieces begin. */
static bool keep(chunk *to, const union_work *work, uint32_t *first)
{
    *first = ROBERTS_NONE;
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

static bool find_chunk(const united *u, const union_bodies *all, uint32_t index, chunk *to)
{
    const roberts_scene *scene = all->scene;
    uint32_t body = index * CHUNK_BODIES, left = scene->solid_count - body;
    union_work work = {0};
    bool done = true;
    for (uint32_t last = body + (left < CHUNK_BODIES ? left : CHUNK_BODIES); body < last; body++)
        for (uint32_t e = scene->solid[body].edge; e < scene->solid[body + 1].edge && done; e++) {
            uint32_t own[2];
            u->first[e] = ROBERTS_NONE;
            if (!union_takes(scene, body))
                continue;
            union_line line = union_line_of_edge(scene, body, e, own);
            done = union_cut(all, &line, &work) && keep(to, &work, &u->first[e]);
        }
    union_work_free(&work);
    return done;
}

/* Lays the chunks down one after another. */
static bool join_chunks(united *u, const roberts_scene *scene, const chunk *found, uint32_t count)
{
    size_t pieces = 0, sides = 0;
    for (uint32_t i = 0; i < count; i++) {
        if (found[i].lost)
            return false;
        pieces += found[i].piece_count;
        sides += found[i].side_count;
    }
    u->piece = alloc_array(pieces, sizeof *u->piece);
    u->side = alloc_array(sides, sizeof *u->side);
    if (!u->piece || !u->side || pieces >= ROBERTS_NONE || sides >= ROBERTS_NONE)
        return false;
    for (uint32_t i = 0; i < count; i++) {
        uint32_t body = i * CHUNK_BODIES, left = scene->solid_count - body;
        uint32_t last = body + (left < CHUNK_BODIES ? left : CHUNK_BODIES);
        for (uint32_t e = scene->solid[body].edge; e < scene->solid[last].edge; e++)
            if (u->first[e] != ROBERTS_NONE)
                u->first[e] += (uint32_t)u->piece_count;
        for (size_t k = 0; k < found[i].piece_count; k++) {
            union_piece piece = found[i].piece[k];
            piece.first += (uint32_t)u->side_count;
            u->piece[u->piece_count++] = piece;
        }
        for (size_t k = 0; k < found[i].side_count; k++)
            u->side[u->side_count++] = found[i].side[k];
    }
    return true;
}

static size_t count_seams(const united *u, uint32_t edges)
{
    size_t seams = 0;
    for (uint32_t e = 0; e < edges; e++) {
        const union_piece *p = united_pieces(u, e);
        bool seam = false;
        for (; p; p = p->t1 < 1.0 ? p + 1 : NULL)
            seam = seam || p->state == UNION_SEAM || p->state == UNION_INSIDE;
        seams += seam;
    }
    return seams;
}

static bool find_all(united *u, const union_bodies *all, chunk *found, uint32_t count, int threads)
{
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
#else
    (void)threads;
#endif
    for (uint32_t i = 0; i < count; i++)
        found[i].lost = !find_chunk(u, all, i, &found[i]);
    return join_chunks(u, all->scene, found, count);
}

bool united_find(united *u, const roberts_scene *scene, double touch, uint32_t threads)
{
    uint32_t count = (scene->solid_count + CHUNK_BODIES - 1) / CHUNK_BODIES;
    union_bodies all = {0};
    chunk *found = alloc_zeroed(count, sizeof *found);
    *u = (united){.first = alloc_array(scene->edge_count, sizeof *u->first)};
    bool done = found && u->first && union_prepare(&all, scene, touch);
    done = done && find_all(u, &all, found, count, threads_for(threads, 1 + count / CHUNKS_PER_THREAD));
    for (uint32_t i = 0; found && i < count; i++) {
        free(found[i].piece);
        free(found[i].side);
    }
    free(found);
    union_free(&all);
    if (done)
        u->seams = count_seams(u, scene->edge_count);
    else
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
