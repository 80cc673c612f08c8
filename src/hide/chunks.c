/* chunks.c - see chunks.h.
 *
 * All operations on what threads share are sequentially consistent, which is what makes it sure that a full chunk is seen
 * by someone: a thread first says that its chunk is found and then looks whether another is at the placing; that one first
 * says that it no longer is, and then looks for chunks that are found. Likewise a thread first says that it copies and then
 * looks whether the drawing moves; and who moves it first says so, and then looks who copies. */
#include "hide/chunks.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"

bool chunks_init(chunks *c, uint32_t total, int threads, roberts_drawing *drawing, roberts_segment_fn *each,
                 void *context)
{
    *c = (chunks){.total = total, .drawing = drawing, .each = each, .context = context, .threads = threads};
    c->queue = alloc_zeroed((size_t)threads, sizeof *c->queue);
    c->found = alloc_array(total, sizeof *c->found);
    if (!c->queue || !c->found)
        return false;
    for (uint32_t k = 0; k < total; k++)
        atomic_init(&c->found[k], NULL);
    for (int i = 0; i < threads; i++)
        for (uint32_t k = 0; k < CHUNKS_WAITING; k++)
            c->queue[i].spare[k] = &c->queue[i].chunk[k];
    return true;
}

void chunks_free(chunks *c)
{
    for (int i = 0; c->queue && i < c->threads; i++)
        for (uint32_t k = 0; k < CHUNKS_WAITING; k++)
            free(c->queue[i].chunk[k].segment);
    free(c->queue);
    free(c->found);
    c->queue = NULL;
    c->found = NULL;
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

/* The chunk whose turn it is, where it is found; else NULL. */
static hide_chunk *in_turn(chunks *c)
{
    uint32_t k = atomic_load(&c->placed);
    return k < c->total && goes_on(c) ? atomic_load(&c->found[k]) : NULL;
}

static void give_away(chunks *c, const hide_chunk *chunk)
{
    for (size_t i = 0; i < chunk->count; i++, c->drawing->count++)
        if (!c->each(c->context, &chunk->segment[i])) {
            chunks_fail(c, ROBERTS_STOPPED);
            return;
        }
}

/* The drawing moves only while nobody writes to it. False: no memory. */
static bool make_room(chunks *c, size_t total)
{
    if (total <= c->room)
        return true;
    atomic_store(&c->moving, true);
    for (unsigned turn = 0; atomic_load(&c->copying); turn++)
        thread_wait(turn);
    bool done = array_reserve(&c->drawing->segment, &c->room, total, sizeof *c->drawing->segment);
    atomic_store(&c->moving, false);
    return done;
}

static void give_place(chunks *c, hide_chunk *chunk)
{
    size_t total = c->drawing->count + chunk->count;
    if (!make_room(c, total)) {
        chunks_fail(c, ROBERTS_NO_MEMORY);
        return;
    }
    chunk->place = c->drawing->count;
    c->drawing->count = total;
}

/* What is found and in turn, unless another thread is at it. */
static void place(chunks *c)
{
    while (in_turn(c) && !atomic_exchange(&c->placing, true)) {
        for (hide_chunk *chunk = in_turn(c); chunk; chunk = in_turn(c)) {
            if (c->each)
                give_away(c, chunk);
            else
                give_place(c, chunk);
            if (goes_on(c))
                atomic_fetch_add(&c->placed, 1);
        }
        atomic_store(&c->placing, false);
    }
}

static void lay_down(chunks *c, const hide_chunk *chunk)
{
    atomic_fetch_add(&c->copying, 1);
    for (unsigned turn = 0; atomic_load(&c->moving); turn++) {
        atomic_fetch_sub(&c->copying, 1);
        thread_wait(turn);
        atomic_fetch_add(&c->copying, 1);
    }
    if (chunk->count)
        memcpy(c->drawing->segment + chunk->place, chunk->segment, chunk->count * sizeof *chunk->segment);
    atomic_fetch_sub(&c->copying, 1);
}

/* The thread's own that have their places, or are given away: they are free again. */
static void settle(chunks *c, chunk_queue *own)
{
    for (; own->count; own->first = (own->first + 1) % CHUNKS_WAITING) {
        hide_chunk *chunk = own->waiting[own->first];
        if (chunk->number >= atomic_load(&c->placed))
            break;
        if (!c->each)
            lay_down(c, chunk);
        own->count--;
        own->spare[CHUNKS_WAITING - 1 - own->count] = chunk;
    }
}

/* Until no more than `most` of the thread's own are waiting. */
static void wait_for_places(chunks *c, chunk_queue *own, uint32_t most)
{
    for (unsigned turn = 0; own->count > most && goes_on(c); turn++) {
        thread_wait(turn);
        place(c);
        settle(c, own);
    }
}

hide_chunk *chunks_take(chunks *c, int self)
{
    chunk_queue *own = &c->queue[self];
    wait_for_places(c, own, CHUNKS_WAITING - 1);
    uint32_t k = atomic_load(&c->taken) < c->total ? atomic_fetch_add(&c->taken, 1) : c->total;
    if (k >= c->total)
        wait_for_places(c, own, 0);
    if (k >= c->total || !goes_on(c))
        return NULL;
    hide_chunk *chunk = own->spare[CHUNKS_WAITING - 1 - own->count];
    chunk->number = k;
    chunk->count = 0;
    return chunk;
}

void chunks_done(chunks *c, int self, hide_chunk *chunk)
{
    chunk_queue *own = &c->queue[self];
    own->waiting[(own->first + own->count++) % CHUNKS_WAITING] = chunk;
    atomic_store(&c->found[chunk->number], chunk);
    place(c);
    settle(c, own);
}
